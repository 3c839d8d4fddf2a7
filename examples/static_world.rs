//! A small body that falls onto a large one: what a step costs if the large one is fixed, so that
//! its boxes are made and sorted once, and if it is only without self-contact.
//! `cargo run --release --example static_world [side of the large one]`.
#![deny(unsafe_code)]

use ccd::scenes::{Step, crumpled_sheet};
use ccd::{Bodies, Error, Mesh, Options, Session};
use std::time::Instant;

const STEPS: usize = 60;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let side = std::env::args().nth(1).map_or(Ok(500), |n| n.parse::<usize>())?;
    let (large, small) = (crumpled_sheet(side, 1), crumpled_sheet(24, 2));
    let n_large = large.mesh.n_vertices();
    let lifted = small.mesh.faces().iter().map(|f| f.map(|v| v + n_large as u32));
    let faces: Vec<[u32; 3]> = large.mesh.faces().iter().copied().chain(lifted).collect();
    let n = n_large + small.mesh.n_vertices();
    let mesh = Mesh::new(n, &faces)?;
    let body: Vec<u32> = (0..n).map(|v| (v >= n_large) as u32).collect();
    let bodies =
        |fixed: bool| Bodies::new(&body).with_fixed(0, fixed).with_excluded_bodies(&[[0, 0]]);
    println!("{} edges, {} of them moving", mesh.edges().len(), small.mesh.edges().len());
    let mut found = Vec::new();
    for (name, bodies) in [("without self-contact", bodies(false)), ("fixed", bodies(true))] {
        let options = Options::default().with_threads(1).with_bodies(bodies);
        let mut session = Session::new(mesh.clone(), options)?;
        let (ms, contacts) = run(&mut session, &large, &small)?;
        println!("{name}: {ms:.3} ms a step, {contacts} contacts");
        found.push(contacts);
    }
    assert!(found[0] == found[1], "the same contacts");
    Ok(())
}

/// Milliseconds of a step in the mean, but for the first, and contacts of all.
fn run(session: &mut Session, large: &Step, small: &Step) -> Result<(f64, usize), Error> {
    let frame = |k: usize| -> Vec<[f32; 3]> {
        let fall = 0.6 - 0.5 * k as f32 / STEPS as f32;
        let at = |p: &[f64; 3]| p.map(|c| c as f32);
        let falling = |p: &[f64; 3]| [0.4 + 0.2 * p[0] as f32, fall, 0.4 + 0.2 * p[2] as f32];
        large.x0.iter().map(at).chain(small.x0.iter().map(falling)).collect()
    };
    let (mut total, mut contacts, mut before) = (0.0, 0, frame(0));
    for k in 1..=STEPS {
        let after = frame(k);
        let start = Instant::now();
        contacts += session.step(&before, &after)?.contacts.len();
        if k > 1 {
            total += start.elapsed().as_secs_f64() * 1e3;
        }
        before = after;
    }
    Ok((total / (STEPS - 1) as f64, contacts))
}
