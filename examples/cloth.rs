//! A cloth in a loop: it falls on a sphere, and no step is taken that is not certified free.
//!
//! A step is first taken freely; vertices of its contacts then move only to a part of their time of
//! impact, and this is repeated until the step is free. Standing still is free, because the step
//! before was, so this ends.
//!
//! `cargo run --release --example cloth`

use ccd::geometry::vec3::{add, dot, lerp, scale, sub};
use ccd::scenes::{grid, sphere};
use ccd::{Bodies, Mesh, Options, Pair, Session};

type Points = Vec<[f64; 3]>;

/// Vertices along a side of the cloth, and around the sphere.
const N: usize = 24;
const N_SPHERE: usize = 32;
const RADIUS: f64 = 0.4;
/// What cloth and sphere keep between them; metres, as all lengths.
const DISTANCE: f64 = 0.002;
/// Seconds of a step.
const DT: f64 = 1.0 / 120.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (mesh, mut x) = scene()?;
    let n_cloth = N * N;
    // The sphere is a body of its own that does not move: it is boxed once, and not looked at
    // against itself.
    let body: Vec<u32> = (0..x.len()).map(|v| (v >= n_cloth) as u32).collect();
    let bodies = Bodies::new(&body, &[false, true], true);
    let options = Options::default().with_min_distance(DISTANCE).with_bodies(bodies);
    let mut session = Session::new(mesh, options)?;

    let springs = springs(session.mesh(), &x[..n_cloth]);
    let mut v = vec![[0.0; 3]; n_cloth];
    let (mut n_contacts, mut n_held) = (0, 0);
    for _ in 0..90 {
        let mut next = x.clone();
        for i in 0..n_cloth {
            v[i] = scale(add(v[i], [0.0, -9.81 * DT, 0.0]), 0.99);
            next[i] = add(x[i], scale(v[i], DT));
        }
        shorten(&springs, &mut next);
        let found = hold_back(&mut session, &x, &mut next)?;
        (n_contacts, n_held) = (n_contacts + found, n_held + (found > 0) as usize);
        for i in 0..n_cloth {
            v[i] = scale(sub(next[i], x[i]), 1.0 / DT);
        }
        x = next;
    }
    println!("{n_contacts} contacts in {n_held} of 90 steps");

    // What the session promised, looked at without it: no vertex of the cloth is in the sphere.
    // Its triangles are inside of it by less than a hundredth of the radius.
    let nearest = x[..n_cloth].iter().map(|&p| dot(p, p).sqrt()).fold(f64::MAX, f64::min);
    println!("the cloth is {:.4} from the middle of a sphere of radius {RADIUS}", nearest);
    assert!(nearest > 0.98 * RADIUS && nearest < 1.05 * RADIUS);
    assert!(n_held > 20);
    Ok(())
}

/// Moves vertices of contacts only as far as is free. Returns how many contacts there were at
/// first.
fn hold_back(
    session: &mut Session,
    x0: &[[f64; 3]],
    x1: &mut [[f64; 3]],
) -> Result<usize, ccd::Error> {
    let mut first = None;
    for round in 0..200 {
        let report = session.step(x0, &*x1)?;
        let first = *first.get_or_insert(report.contacts.len());
        if report.contacts.is_empty() {
            return Ok(first);
        }
        for c in &report.contacts {
            for v in report.mesh().vertices_of(c.kind, Pair { a: c.a, b: c.b }) {
                // Undecided pairs are held back as all others. What is near stays where it is, so
                // that it never comes so near that rounding cannot tell; after some rounds, all do.
                let part = if round < 6 && c.toi > 0.1 { 0.5 * c.toi } else { 0.0 };
                x1[v as usize] = lerp(x0[v as usize], x1[v as usize], part);
            }
        }
    }
    panic!("no free step in 200 rounds")
}

/// The cloth above the sphere, its vertices first.
fn scene() -> Result<(Mesh, Points), ccd::Error> {
    let at = |k: usize| k as f64 / (N - 1) as f64 - 0.5;
    // Slightly uneven, so that nothing is exactly in a plane.
    let of = |i: usize| [at(i % N), 0.45 + 1e-4 * (i * 7919 % 13) as f64, at(i / N)];
    let mut x: Points = (0..N * N).map(of).collect();
    let mut faces = Vec::new();
    grid(&mut faces, N, 0);
    grid(&mut faces, N_SPHERE, x.len() as u32);
    x.extend(sphere(N_SPHERE).into_iter().map(|p| scale(p, RADIUS)));
    Ok((Mesh::new(x.len(), &faces)?, x))
}

/// Edges of the cloth, with their lengths at rest.
fn springs(mesh: &Mesh, x: &[[f64; 3]]) -> Vec<(usize, usize, f64)> {
    let edges = mesh.edges().iter().map(|&[a, b]| (a as usize, b as usize));
    let length = |(a, b): (usize, usize)| sub(x[b], x[a]);
    let of = |e: (usize, usize)| (e.0, e.1, dot(length(e), length(e)).sqrt());
    edges.filter(|&(_, b)| b < x.len()).map(of).collect()
}

/// Brings springs that are too long to their length.
fn shorten(springs: &[(usize, usize, f64)], x: &mut [[f64; 3]]) {
    for _ in 0..10 {
        for &(a, b, rest) in springs {
            let d = sub(x[b], x[a]);
            let length = dot(d, d).sqrt();
            if length > rest {
                let half = scale(d, 0.5 * (1.0 - rest / length));
                (x[a], x[b]) = (add(x[a], half), sub(x[b], half));
            }
        }
    }
}
