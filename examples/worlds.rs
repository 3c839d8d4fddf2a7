//! Many copies of a cloth in one place, a world each: one call for all beside a call for each, of
//! sessions of its own. On the CPU, and on a GPU where there is one;
//! `cargo run --release --example worlds [copies] [side of a cloth]`.
#![deny(unsafe_code)]

use ccd::any::{Backend, Error, Session};
use ccd::scenes::{Step, copies, crumpled_sheet};
use ccd::{Bodies, Options};
use std::time::Instant;

/// Rounds of all calls in turn; the first two do not count.
const ROUNDS: usize = 15;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut numbers = std::env::args().skip(1).map(|n| n.parse::<usize>());
    let n = numbers.next().unwrap_or(Ok(256))?;
    let side = numbers.next().unwrap_or(Ok(12))?;
    let sheet = crumpled_sheet(side, 5);
    let (all, bodies) = copies(&sheet, n);
    println!("{n} worlds, each a cloth of {} edges", sheet.mesh.edges().len());
    for backend in [Backend::Cpu, Backend::Gpu] {
        if let Err(why) = compare(backend, &sheet, &all, bodies.clone()) {
            println!("{why}");
        }
    }
    Ok(())
}

/// Prints the medians of one call for all worlds and of a call for each, by sessions of the
/// backend's default number of threads.
fn compare(backend: Backend, one: &Step, all: &Step, bodies: Bodies) -> Result<(), Error> {
    let choice = backend.choose(one.mesh.edges().len())?;
    let of_all = Options::default().with_bodies(bodies);
    let mut together = Session::new(&choice, all.mesh.clone(), of_all)?;
    let mesh = std::sync::Arc::new(one.mesh.clone());
    let n = mesh.n_vertices();
    let open = |_| Session::new(&choice, mesh.clone(), Options::default());
    let mut apart = (0..all.x0.len() / n).map(open).collect::<Result<Vec<_>, _>>()?;
    println!("{}", together.place());
    // Milliseconds by call (step, earliest time), each all at once and one after the other.
    let mut times = [(); 4].map(|()| Vec::new());
    let mut contacts = [0; 2];
    for _ in 0..ROUNDS {
        let mut start = Instant::now();
        let mut lap = |k: usize| {
            times[k].push(start.elapsed().as_secs_f64() * 1e3);
            start = Instant::now();
        };
        contacts = [together.step(&all.x0, &all.x1)?.contacts.len(), 0];
        lap(0);
        for (session, (x0, x1)) in apart.iter_mut().zip(all.x0.chunks(n).zip(all.x1.chunks(n))) {
            contacts[1] += session.step(x0, x1)?.contacts.len();
        }
        lap(1);
        together.earliest_toi(&all.x0, &all.x1)?;
        lap(2);
        for (session, (x0, x1)) in apart.iter_mut().zip(all.x0.chunks(n).zip(all.x1.chunks(n))) {
            session.earliest_toi(x0, x1)?;
        }
        lap(3);
    }
    let [a, b, c, d] = times.map(|mut ms| {
        ms.drain(..2);
        ms.sort_by(f64::total_cmp);
        ms[ms.len() / 2]
    });
    assert_eq!(contacts[0], contacts[1]);
    println!("  all contacts: at once {a:.2} ms, one by one {b:.2} ms, ratio {:.2}", a / b);
    println!("  earliest time: at once {c:.2} ms, one by one {d:.2} ms, ratio {:.2}", c / d);
    Ok(())
}
