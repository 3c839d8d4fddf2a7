//! Many copies of a cloth in one place, a world each: what they cost beside one. On the CPU, and on
//! a GPU where there is one; `cargo run --release --example worlds [copies] [side of a cloth]`.
#![deny(unsafe_code)]

use ccd::any::{Backend, Session};
use ccd::scenes::{Step, copies, crumpled_sheet};
use ccd::{Bodies, Options};
use std::time::Instant;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut numbers = std::env::args().skip(1).map(|n| n.parse::<usize>());
    let n = numbers.next().unwrap_or(Ok(512))?;
    let side = numbers.next().unwrap_or(Ok(32))?;
    let sheet = crumpled_sheet(side, 5);
    let (all, bodies) = copies(&sheet, n);
    println!("a cloth of {} edges, {n} worlds", sheet.mesh.edges().len());
    for backend in [Backend::Cpu, Backend::Gpu] {
        let of_one = best(backend, &sheet, None, 200);
        let of_all = best(backend, &all, Some(bodies.clone()), 7);
        match (of_one, of_all) {
            (Ok((one, n_one, place)), Ok((all, n_all, _))) => println!(
                "{place}: one {one:.3} ms, all {all:.3} ms, ratio {:.1}; contacts {n_one}, {n_all}",
                all / one
            ),
            (Err(why), _) | (_, Err(why)) => println!("{why}"),
        }
    }
    Ok(())
}

/// The least milliseconds of a step, contacts, and where it ran.
fn best(
    backend: Backend,
    step: &Step,
    bodies: Option<Bodies>,
    steps: usize,
) -> Result<(f64, usize, String), ccd::any::Error> {
    let choice = backend.choose(step.mesh.edges().len())?;
    let options = Options::default().with_bodies(bodies);
    let mut session = Session::new(&choice, step.mesh.clone(), options)?;
    let (mut least, mut n_contacts) = (f64::INFINITY, 0);
    for _ in 0..steps {
        let start = Instant::now();
        n_contacts = session.step(&step.x0, &step.x1)?.contacts.len();
        least = least.min(start.elapsed().as_secs_f64() * 1e3);
    }
    Ok((least, n_contacts, session.place().to_string()))
}
