//! A static world with a moving body: a box spins down on hills and stops where it would touch
//! them.
//!
//! The world is a fixed body whose positions are handed over once. A step is told the two poses of
//! the box, costs what the box costs, and answers with the first contact: where it is, and along
//! which normal the box parts. Vertices move on straight lines between two poses, so a pose in the
//! middle of a step is not what was tested: a step that is not free is tried again with half of its
//! time, from pose to pose.
//!
//! `cargo run --release --example moving_body`

use ccd::any::{Backend, Session};
use ccd::scenes::grid;
use ccd::{Bodies, BodyMotion, Hit, Mesh, Options};
use glam::{Mat4, Quat, Vec3};
use std::sync::Arc;

/// Vertices along a side of the world, and the length of a cell.
const N: usize = 48;
const CELL: f32 = 0.25;
/// The body of the box; that of the hills is 0.
const BOX_BODY: u32 = 1;
/// What box and hills keep between them.
const DISTANCE: f64 = 0.005;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let height = |x: f32, z: f32| 0.5 * (0.7 * x).sin() * (0.9 * z).cos();
    let at = |k: usize| CELL * (k as f32 - 0.5 * (N - 1) as f32);
    let vertex = |i: usize| Vec3::new(at(i % N), height(at(i % N), at(i / N)), at(i / N));
    let mut rest: Vec<Vec3> = (0..N * N).map(vertex).collect();
    let mut faces = Vec::new();
    grid(&mut faces, N, 0);
    let first = rest.len() as u32;
    rest.extend((0..8).map(|i| Vec3::new(side(i), 0.6 * side(i / 2), side(i / 4))));
    faces.extend(BOX.map(|face| face.map(|v| v + first)));

    let mesh = Arc::new(Mesh::new(rest.len(), &faces)?);
    let body: Vec<u32> = (0..mesh.n_vertices() as u32).map(|v| (v >= first) as u32).collect();
    // The world does not move, and neither body is looked at against itself.
    let bodies = Bodies::new(&body).with_fixed(0, true).with_self_contacts(false);
    let options = Options::default().with_min_distance(DISTANCE).with_bodies(bodies);
    let choice = Backend::Auto.choose(mesh.edges().len())?;
    let mut session = Session::new(&choice, mesh.clone(), options)?;

    // Poses move these positions; until a step does, the box is here.
    session.set_positions(&rest)?;
    let box_at_rest = rest.split_off(first as usize);

    let pose = |t: f32| {
        let turn = Quat::from_euler(glam::EulerRot::XYZ, 1.3 * t, 0.4 * t, 0.7 * t);
        let place = Vec3::new(-1.0 + 0.5 * t, 3.0 - 0.8 * t, 0.3 * t);
        Mat4::from_rotation_translation(turn, place)
    };
    let first_contact = |session: &mut Session, t: f32, step: f32| {
        let motion = BodyMotion::posed(BOX_BODY, &pose(t), &pose(t + step));
        session.first_contact_of_bodies(&[motion])
    };
    // Seconds, and the step: 2 degrees of a turn, between which a body shrinks by 0.02 %.
    let (mut t, mut step, mut n_steps) = (0.0f32, 1.0 / 40.0, 0);
    let mut last: Option<Hit> = None;
    while step > 1e-4 {
        match first_contact(&mut session, t, step)? {
            None => t += step,
            Some(hit) => (step, last) = (step / 2.0, Some(hit)),
        }
        n_steps += 1;
        assert!(t < 10.0, "the box fell through the world");
    }
    let hit = last.expect("it came to rest by a contact");
    let (point, normal) = (hit.point, hit.normal_towards(BOX_BODY));
    println!("{mesh:?} on {}: at rest after {t:.4} s, {n_steps} steps", session.place());
    println!("on {point:.3?}, along {normal:.3?}");

    // Looked at without the session: every corner is above the lowest point of the cell below it,
    // and the hills hold the box from below.
    let last = pose(t);
    let index = |c: f32| ((c / CELL + 0.5 * (N - 1) as f32) as usize).min(N - 2);
    for &corner in &box_at_rest {
        let p = last.transform_point3(corner);
        let (i, j) = (index(p.x), index(p.z));
        let corners = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)];
        let low = corners.map(|(i, j)| rest[j * N + i].y).into_iter().fold(f32::MAX, f32::min);
        assert!(p.y > low, "a corner at {p} is under the hills");
    }
    assert!(normal[1] > 0.5, "the box is held along {normal:?}");
    // A step as large as the last one that was refused ends in a contact. Without the distance that
    // they keep, it is free.
    assert!(first_contact(&mut session, t, 1e-3)?.is_some());
    session.set_min_distance(0.0)?;
    assert_eq!(first_contact(&mut session, t, 1e-3)?, None);
    Ok(())
}

/// Bit 0 as a side of the box.
fn side(bit: usize) -> f32 {
    if bit & 1 == 0 { -0.5 } else { 0.5 }
}

/// Triangles of a box whose corner `i` has the sides that the bits of `i` say.
const BOX: [[u32; 3]; 12] = [
    [0, 1, 3],
    [0, 3, 2],
    [4, 6, 7],
    [4, 7, 5],
    [0, 4, 5],
    [0, 5, 1],
    [2, 3, 7],
    [2, 7, 6],
    [0, 2, 6],
    [0, 6, 4],
    [1, 5, 7],
    [1, 7, 3],
];

#[test]
fn the_box_comes_to_rest_on_the_hills() -> Result<(), Box<dyn std::error::Error>> {
    main()
}
