//! `cargo xtask report --level`: an octahedron that falls on a level of a million vertices, beside
//! the shape cast of parry3d, in one run.
//!
//! Ours is told the positions of the octahedron alone and finds its first contact, or all contacts
//! of the step; theirs casts a convex polyhedron against a `TriMesh` built before. Both say when
//! they touch, and the two times must agree.

use crate::markdown::{Table, digits};
use crate::measure::{Place, median_of};
use ccd::any::Session;
use ccd::scenes::grid;
use ccd::{Bodies, BodyMotion, Mesh, Options};
use parry3d::math::{Pose, Vector};
use parry3d::query::{ShapeCastOptions, cast_shapes};
use parry3d::shape::{ConvexPolyhedron, TriMesh};
use std::sync::Arc;

/// Vertices along a side of the level.
const N: usize = 1000;
/// Fall of the octahedron within the step.
const FALL: f32 = 2.0;
/// Every row is the median of so many steps.
const RUNS: usize = 200;
/// The times of impact may differ by so much: single precision over a fall of [`FALL`].
const TOLERANCE: f64 = 1e-4;

const OCTAHEDRON: [[u32; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];

/// Measures and prints the table.
pub fn run() -> Result<(), String> {
    let at = |k: usize| k as f32 * 0.1;
    let height = |x: f32, z: f32| 0.3 * (0.7 * x).sin() * (0.9 * z).cos();
    let level: Vec<[f32; 3]> =
        (0..N * N).map(|i| (at(i % N), at(i / N))).map(|(x, z)| [x, height(x, z), z]).collect();
    let mut faces = Vec::new();
    grid(&mut faces, N, 0);
    let middle = [49.73, 1.5, 50.31];
    let corner = |i: usize| {
        let mut p = middle;
        p[i / 2] += [0.5, -0.5][i % 2];
        p
    };
    let body: Vec<[f32; 3]> = (0..6).map(corner).collect();
    let fallen: Vec<[f32; 3]> = body.iter().map(|&[x, y, z]| [x, y - FALL, z]).collect();

    let mut table = Table::new(["a level of 1,000,000 vertices", "ms", "time of impact"]);
    let (theirs, toi) = parry(&level, &faces, &body)?;
    let name = "first contact, parry3d `cast_shapes`, 1 thread";
    table.row([name, &digits(theirs), &toi.to_string()]);
    let shifted = OCTAHEDRON.map(|face| face.map(|v| v + level.len() as u32));
    faces.extend(shifted);
    let rest = [&level[..], &body].concat();
    let mesh = Arc::new(Mesh::new(rest.len(), &faces).map_err(|e| e.to_string())?);
    let bodies: Vec<u32> = (0..rest.len()).map(|v| (v >= level.len()) as u32).collect();
    let bodies = Bodies::new(&bodies).with_fixed(0, true).with_self_contacts(false);
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get()).min(2);
    let places = [1, threads].map(|threads| Place::Cpu { threads });
    for place in places.into_iter().chain(Place::gpu()) {
        let name = place.name();
        let options = Options::default().with_bodies(bodies.clone()).with_threads(place.threads());
        let mut session = match Session::new(&place.choice(), mesh.clone(), options) {
            Err(why) if place.threads() == 0 => {
                println!("{name} is left out: {why}");
                continue;
            }
            session => session.map_err(|e| e.to_string())?,
        };
        session.set_positions(&rest).map_err(|e| e.to_string())?;
        let motion = [BodyMotion::new(1, &body, &fallen)];
        let failed = |e: ccd::any::Error| format!("{name}: {e}");
        let (first, hit) =
            median_of(RUNS, || session.first_contact_of_bodies(&motion)).map_err(failed)?;
        let (all, n) =
            median_of(RUNS, || session.step_bodies(&motion).map(|report| report.contacts.len()))
                .map_err(failed)?;
        let found = hit.map_or(f64::NAN, |hit| hit.toi);
        let differs = (found - f64::from(toi)).abs();
        if differs.is_nan() || differs > TOLERANCE || n == 0 {
            return Err(format!("{name}: {found}, {n} contacts, parry3d finds {toi}"));
        }
        table.row([format!("first contact, {name}"), digits(first), found.to_string()]);
        table.row([format!("all {n} contacts, {name}"), digits(all), String::new()]);
    }
    println!("{table}");
    Ok(())
}

/// Milliseconds of a cast, and its time.
fn parry(level: &[[f32; 3]], faces: &[[u32; 3]], body: &[[f32; 3]]) -> Result<(f64, f32), String> {
    let vector = |p: &[f32; 3]| Vector::from(*p);
    let mesh = TriMesh::new(level.iter().map(vector).collect(), faces.to_vec());
    let mesh = mesh.map_err(|e| e.to_string())?;
    let points: Vec<Vector> = body.iter().map(vector).collect();
    let body = ConvexPolyhedron::from_convex_hull(&points).ok_or("no hull")?;
    let fall = Vector::new(0.0, -FALL, 0.0);
    let options = ShapeCastOptions::with_max_time_of_impact(1.0);
    let (here, rest) = (Pose::IDENTITY, Vector::ZERO);
    let (ms, hit) = median_of(RUNS, || {
        cast_shapes(&here, rest, &mesh, &here, fall, &body, options).map_err(|e| e.to_string())
    })?;
    Ok((ms, hit.ok_or("parry3d finds no contact")?.time_of_impact))
}
