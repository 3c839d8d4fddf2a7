//! A cloth in a loop: springs, a sphere to fall on, and steps that never pass through anything.
//!
//! A step of the solver is a step of position based dynamics and one question about it:
//!
//! 1. predict where velocities and gravity take every vertex;
//! 2. a few rounds: pull springs towards their length, push apart what comes nearer than
//!    `THICKNESS`, by the geometry of each contact;
//! 3. go as far towards the result as is certified free, and let as much time pass.
//!
//! Two distances keep it going. Features are pushed from `THICKNESS` on, and the certificate is for
//! `LEAST`, so what rests on something, or slides, is free to move. With one distance for both, all
//! that was pushed to it would be in contact at the start of the next step, and no step be free.
//! By `with_leave_contact` a pair that is nearer and separates by itself is not pushed.
//!
//! `cargo run --release --example cloth`

use ccd::geometry::vec3::{add, dot, lerp, scale, sub};
use ccd::scenes::{grid, sphere};
use ccd::{Bodies, Contact, Mesh, Options, Session, intersections, scaled_toi};
use std::sync::Arc;

type Points = Vec<[f64; 3]>;

/// Vertices along a side of the cloth, whose side is 1 metre, and along one of the sphere's grid.
const N: usize = 30;
const N_SPHERE: usize = 24;
const RADIUS: f64 = 0.3;
/// Metres: what is nearer is pushed apart, and what is kept whatever happens.
const THICKNESS: f64 = 0.008;
const LEAST: f64 = 0.001;
/// Seconds, and metres per second squared.
const DT: f64 = 1.0 / 80.0;
const GRAVITY: f64 = -9.81;
/// Part of the velocity that is left after a step, and part of a slide that a push takes away.
const DAMPING: f64 = 0.995;
const FRICTION: f64 = 0.3;
const ROUNDS: usize = 2;
const STEPS: usize = 120;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // One mesh: the cloth above, then the sphere, which is fixed.
    let (mut faces, mut x) = (Vec::new(), Points::new());
    grid(&mut faces, N, 0);
    let at = |i: usize| i as f64 / (N - 1) as f64 - 0.5;
    x.extend((0..N * N).map(|i| [at(i % N), RADIUS + 0.2, at(i / N)]));
    grid(&mut faces, N_SPHERE, x.len() as u32);
    x.extend(sphere(N_SPHERE).into_iter().map(|p| scale(p, RADIUS)));
    let mesh = Arc::new(Mesh::new(x.len(), &faces)?);
    let body: Vec<u32> = (0..x.len()).map(|v| (v >= N * N) as u32).collect();
    let options = Options::default()
        .with_bodies(Bodies::new(&body).with_fixed(1, true))
        .with_leave_contact(true);

    // The same mesh asked two questions: what is near, and how far one may go.
    let mut near = Session::new(mesh.clone(), options.clone().with_min_distance(THICKNESS))?;
    let mut free = Session::new(mesh.clone(), options.clone().with_min_distance(LEAST))?;

    let springs = springs(&x);
    let mut v = vec![[0.0; 3]; N * N];
    let (mut seconds, mut n_short, mut n_stuck) = (0.0, 0, 0);
    let start = mean_height(&x);
    for step in 1..=STEPS {
        let mut x1 = x.clone();
        for i in 0..N * N {
            v[i] = scale(add(v[i], [0.0, GRAVITY * DT, 0.0]), DAMPING);
            x1[i] = add(x[i], scale(v[i], DT));
        }
        let mut n_contacts = 0;
        for _ in 0..ROUNDS {
            pull(&springs, &mut x1);
            let contacts = &near.step(&x, &x1)?.contacts;
            n_contacts = n_contacts.max(contacts.len());
            for contact in contacts {
                push_apart(contact, &mesh, &x, &mut x1);
            }
        }
        // Short of the time itself, so that some distance is left for the next step.
        let toi = free.earliest_toi(&x, &x1)?;
        let part = toi.map_or(1.0, |toi| scaled_toi(toi, 0.9));
        for i in 0..N * N {
            v[i] = scale(sub(x1[i], x[i]), 1.0 / DT);
            x[i] = lerp(x[i], x1[i], part);
        }
        seconds += part * DT;
        n_short += (part < 1.0) as usize;
        n_stuck = if part < 1e-3 { n_stuck + 1 } else { 0 };
        assert!(n_stuck < 4, "no free step from {seconds} s on");
        if step % 15 == 0 {
            let height = mean_height(&x);
            println!("{seconds:.3} s: {n_contacts:5} contacts, mean height {height:+.3} m");
        }
    }
    println!("{n_short} of {STEPS} steps were shortened");

    // Looked at without the sessions: the cloth hangs down around the sphere, and, exactly, no edge
    // goes through any face; which would be seen if one vertex of the cloth were in the sphere.
    assert!(mean_height(&x) < start - 0.2, "the cloth did not fall");
    assert!(x[..N * N].iter().all(|p| dot(*p, *p) > (0.95 * RADIUS).powi(2)));
    let through = intersections(&mesh, &x, &options)?;
    assert!(through.is_empty(), "{} intersections", through.len());
    x[N * N / 2] = [0.0; 3];
    assert!(!intersections(&mesh, &x, &options)?.is_empty());
    Ok(())
}

/// Pairs of vertices and their distance at rest: sides and diagonals of cells, and every second
/// vertex against bending.
fn springs(x: &Points) -> Vec<(usize, usize, f64)> {
    let mut all = Vec::new();
    for i in 0..N * N {
        for (right, down) in [(1, 0), (0, 1), (1, 1), (2, 0), (0, 2)] {
            if i % N + right < N && i / N + down < N {
                let j = i + right + down * N;
                let d = sub(x[i], x[j]);
                all.push((i, j, dot(d, d).sqrt()));
            }
        }
    }
    all
}

/// Moves the ends of each spring towards its length, equally.
fn pull(springs: &[(usize, usize, f64)], x: &mut Points) {
    for &(i, j, rest) in springs {
        let d = sub(x[j], x[i]);
        let length = dot(d, d).sqrt();
        let step = scale(d, 0.5 * (length - rest) / length.max(1e-9));
        x[i] = add(x[i], step);
        x[j] = sub(x[j], step);
    }
}

/// Moves the vertices of a contact, each by its weight, so that at the end of the step the points
/// that meet are apart by `THICKNESS` along the normal; the sphere stays.
fn push_apart(contact: &Contact, mesh: &Mesh, x0: &Points, x1: &mut Points) {
    let at = contact.geometry(mesh, x0, x1);
    let ids = contact.vertices(mesh).map(|v| v as usize);
    // A point is a sum of its vertices; of the second feature it counts against the first.
    let sign = |k: usize| if k < contact.kind.n_first() { 1.0 } else { -1.0 };
    let is_free = |k: usize| ids[k] < N * N;
    let gap: f64 = (0..4).map(|k| sign(k) * at.weights[k] * dot(at.normal, x1[ids[k]])).sum();
    let freedom: f64 = (0..4).filter(|&k| is_free(k)).map(|k| at.weights[k].powi(2)).sum();
    let lacking = THICKNESS - gap;
    if lacking <= 0.0 || freedom == 0.0 {
        return;
    }
    for k in (0..4).filter(|&k| is_free(k)) {
        let moved = sub(x1[ids[k]], x0[ids[k]]);
        let slide = sub(moved, scale(at.normal, dot(at.normal, moved)));
        let push = scale(at.normal, sign(k) * at.weights[k] * lacking / freedom);
        let drag = scale(slide, FRICTION * at.weights[k]);
        x1[ids[k]] = sub(add(x1[ids[k]], push), drag);
    }
}

/// Of the cloth.
fn mean_height(x: &Points) -> f64 {
    x[..N * N].iter().map(|p| p[1]).sum::<f64>() / (N * N) as f64
}

#[test]
fn the_cloth_falls_and_stays_outside() -> Result<(), Box<dyn std::error::Error>> {
    main()
}
