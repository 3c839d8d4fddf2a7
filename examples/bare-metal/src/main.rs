//! A cube falls on a square: one step on a microcontroller without an operating system.
//!
//! `cargo run --release` in this folder runs it in qemu (Debian: `qemu-system-arm`), after
//! `rustup target add thumbv7em-none-eabihf`.
#![no_std]
#![no_main]

extern crate alloc;

use alloc::sync::Arc;
use alloc::vec::Vec;
use ccd_core::Error;
use ccd_core::model::{contact::State, mesh::Mesh, options::Options};
use ccd_core::reference;
use core::mem::MaybeUninit;
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use embedded_alloc::LlffHeap as Heap;
use panic_semihosting as _;

#[global_allocator]
static HEAP: Heap = Heap::empty();

const HEAP_BYTES: usize = 256 * 1024;

#[entry]
fn main() -> ! {
    static mut MEMORY: [MaybeUninit<u8>; HEAP_BYTES] = [MaybeUninit::uninit(); HEAP_BYTES];
    // SAFETY: called once, before the first allocation; nothing else has the address.
    unsafe { HEAP.init(MEMORY.as_mut_ptr() as usize, HEAP_BYTES) };
    let status = match step() {
        Ok(()) => debug::EXIT_SUCCESS,
        Err(error) => {
            hprintln!("error: {}", error);
            debug::EXIT_FAILURE
        }
    };
    debug::exit(status);
    loop {}
}

fn step() -> Result<(), Error> {
    let square: [[f32; 3]; 4] =
        [[-2.0, 0.0, -2.0], [2.0, 0.0, -2.0], [2.0, 0.0, 2.0], [-2.0, 0.0, 2.0]];
    // Corners of a cube of side 1, its bottom at a height of 0.5.
    let cube = |i: u32| [0, 1, 2].map(|k| (i >> k & 1) as f32 + if k == 1 { 0.5 } else { -0.5 });
    let sides =
        [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    let mut faces: Vec<[u32; 3]> = [[0, 2, 1], [0, 3, 2]].into();
    for [a, b, c, d] in sides.map(|side| side.map(|v: u32| v + 4)) {
        faces.extend([[a, b, c], [a, c, d]]);
    }
    let x0: Vec<[f32; 3]> = square.into_iter().chain((0..8).map(cube)).collect();
    let mut x1 = x0.clone();
    for p in &mut x1[4..] {
        p[1] -= 1.0;
    }

    let mesh = Arc::new(Mesh::new(x0.len(), &faces)?);
    let report = reference::step(&mesh, &x0, &x1, &Options::default())?;
    let undecided = report.contacts.iter().filter(|c| c.state == State::Undecided).count();
    hprintln!(
        "{} candidates, {} contacts, {} of them undecided",
        report.candidates.total(),
        report.contacts.len(),
        undecided
    );
    let toi = report.toi.expect("the cube falls through the square");
    hprintln!("first contact at t = {}", toi);
    // The bottom is half of the way above the square.
    assert!(toi <= 0.5 && toi > 0.5 - 1e-6);
    Ok(())
}
