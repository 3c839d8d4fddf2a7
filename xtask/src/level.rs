//! `cargo xtask report --level`: an octahedron and a ball of 1,024 vertices that fall on a level of
//! a million, beside the shape cast of parry3d, in one run; and many balls that pass each other, by
//! positions and by poses.
//!
//! Ours is told the positions of the body alone and finds its first contact, or all contacts of the
//! step; theirs casts a convex polyhedron, or a `TriMesh`, against a `TriMesh` built before. All
//! say when they touch, and the times must agree.

use crate::markdown::{Table, digits};
use crate::measure::{Place, by_turns, median_of};
use ccd::any::Session;
use ccd::scenes::{grid, sphere};
use ccd::{Bodies, BodyMotion, Mesh, Options, Posed};
use parry3d::math::{Pose, Vector};
use parry3d::query::{ShapeCastOptions, cast_shapes};
use parry3d::shape::{ConvexPolyhedron, Shape, TriMesh};
use std::cell::RefCell;
use std::sync::Arc;

/// Vertices along a side of the level.
const N: usize = 1000;
/// Vertices along a side of the grid that the ball is.
const BALL: usize = 32;
/// Fall of the body within the step.
const FALL: f32 = 2.0;
/// Every row is the median of so many rounds of so many steps: machines have others' work on them.
const ROUNDS: usize = 5;
const RUNS: usize = 200;
/// Balls that pass each other, vertices along a side of the grid that each is, and how far apart
/// they are in units of their radius.
const MANY: usize = 100;
const OF_MANY: usize = 100;
const SPACING: f64 = 2.5;
/// Those rows are medians of so many steps.
const RUNS_OF_MANY: usize = 20;
/// The times of impact may differ by so much: single precision over a fall of [`FALL`].
const TOLERANCE: f64 = 1e-4;

const OCTAHEDRON: [[u32; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];

/// Measures and prints a table for each body.
pub fn run() -> Result<(), String> {
    let at = |k: usize| k as f32 * 0.1;
    let height = |x: f32, z: f32| 0.3 * (0.7 * x).sin() * (0.9 * z).cos();
    let level: Vec<[f32; 3]> =
        (0..N * N).map(|i| (at(i % N), at(i / N))).map(|(x, z)| [x, height(x, z), z]).collect();
    let mut faces = Vec::new();
    grid(&mut faces, N, 0);
    let middle = [49.73, 1.5, 50.31];
    let octahedron = (0..6).map(|i| {
        let mut p = [0.0; 3];
        p[i / 2] = [1.0, -1.0][i % 2];
        p
    });
    let mut of_ball = Vec::new();
    grid(&mut of_ball, BALL, 0);
    let ball = sphere(BALL).into_iter().map(|p| p.map(|c| c as f32));
    let placed = |p: [f32; 3]| [0, 1, 2].map(|k| middle[k] + 0.5 * p[k]);
    falls(
        "an octahedron",
        (&level, &faces),
        &octahedron.map(placed).collect::<Vec<_>>(),
        &OCTAHEDRON,
    )?;
    falls(
        "a ball of 1,024 vertices",
        (&level, &faces),
        &ball.map(placed).collect::<Vec<_>>(),
        &of_ball,
    )?;
    pass()
}

/// Many balls that pass each other: steps that are told positions, and steps that are told poses.
fn pass() -> Result<(), String> {
    let side = MANY.isqrt();
    let (mut rest, mut faces, mut names) = (Vec::new(), Vec::new(), Vec::new());
    let of_ball = sphere(OF_MANY);
    for ball in 0..MANY {
        grid(&mut faces, OF_MANY, rest.len() as u32);
        let middle = [ball % side, 0, ball / side].map(|k| SPACING * k as f64);
        let placed = |p: &[f64; 3]| [0, 1, 2].map(|k| (middle[k] + p[k]) as f32);
        rest.extend(of_ball.iter().map(placed));
        names.resize(rest.len(), ball as u32);
    }
    let mesh = Arc::new(Mesh::new(rest.len(), &faces).map_err(|e| e.to_string())?);
    let bodies = Bodies::new(&names).with_self_contacts(false);
    // Every other row moves, by less than the room between its balls.
    let pose = |ball: usize, t: f32| {
        let mut pose = [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| (i == k) as u8 as f32));
        pose[3][0] = if (ball / side).is_multiple_of(2) { 0.4 * t } else { 0.0 };
        pose
    };
    let mut table = Table::new([
        format!("{MANY} balls of {} vertices, none near another", of_ball.len()),
        "by positions, ms".into(),
        "by poses, ms".into(),
    ]);
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get()).min(2);
    for place in [1, threads].map(|threads| Place::Cpu { threads }) {
        let options = Options::default().with_bodies(bodies.clone()).with_threads(place.threads());
        let poses: Vec<[_; 2]> = (0..MANY).map(|ball| [pose(ball, 0.0), pose(ball, 1.0)]).collect();
        let of = |ball: usize| &rest[ball * of_ball.len()..(ball + 1) * of_ball.len()];
        let at = |t: usize| (0..MANY).map(move |ball| (ball, t));
        let posed = |(ball, t): (usize, usize)| Posed::one(of(ball), &poses[ball][t]);
        let ends: [Vec<Posed<f32>>; 2] = [0, 1].map(|t| at(t).map(posed).collect());
        let by_positions =
            |ball: usize| BodyMotion::new(ball as u32, &ends[0][ball], &ends[1][ball]);
        let by_poses =
            |ball: usize| BodyMotion::posed(ball as u32, &poses[ball][0], &poses[ball][1]);
        let motions: [Vec<BodyMotion>; 2] =
            [(0..MANY).map(by_positions).collect(), (0..MANY).map(by_poses).collect()];
        let (mut row, mut found) = (vec![place.name()], Vec::new());
        for motions in &motions {
            let mut session =
                ccd::Session::new(mesh.clone(), options.clone()).map_err(|e| e.to_string())?;
            session.set_positions(&rest).map_err(|e| e.to_string())?;
            let (ms, counts) = median_of(RUNS_OF_MANY, || {
                let report = session.step_bodies(motions).map_err(|e| e.to_string())?;
                Ok::<_, String>((report.contacts.len(), report.candidates.total()))
            })?;
            row.push(digits(ms));
            found.push(counts);
        }
        if found[0] != found[1] {
            return Err(format!("{}: {found:?} contacts and candidates", place.name()));
        }
        let row: [String; 3] = row.try_into().map_err(|_| "a row of three")?;
        table.row(row);
    }
    println!("{table}");
    Ok(())
}

/// A row of [`falls`]: its name, and a call that returns the time of the first contact, if that is
/// asked for, and the number of contacts, if all are.
type Row<'a> = (String, Box<dyn FnMut() -> Result<(Option<f64>, usize), String> + 'a>);

/// One body, by its vertices and faces, that falls on the level.
fn falls(
    name: &str,
    (level, faces): (&[[f32; 3]], &[[u32; 3]]),
    body: &[[f32; 3]],
    of_body: &[[u32; 3]],
) -> Result<(), String> {
    let fallen: Vec<[f32; 3]> = body.iter().map(|&[x, y, z]| [x, y - FALL, z]).collect();
    let points: Vec<Vector> = body.iter().map(|p| Vector::from(*p)).collect();
    let hull = ConvexPolyhedron::from_convex_hull(&points).ok_or("no hull")?;
    let mesh = TriMesh::new(points, of_body.to_vec()).map_err(|e| e.to_string())?;
    let target = TriMesh::new(level.iter().map(|p| Vector::from(*p)).collect(), faces.to_vec());
    let target = target.map_err(|e| e.to_string())?;
    let shapes: [(&str, &dyn Shape); 2] = [("a convex polyhedron", &hull), ("a `TriMesh`", &mesh)];
    let all_faces: Vec<[u32; 3]> = faces
        .iter()
        .copied()
        .chain(of_body.iter().map(|face| face.map(|v| v + level.len() as u32)))
        .collect();
    let rest = [level, body].concat();
    let mesh = Arc::new(Mesh::new(rest.len(), &all_faces).map_err(|e| e.to_string())?);
    let bodies: Vec<u32> = (0..rest.len()).map(|v| (v >= level.len()) as u32).collect();
    let bodies = Bodies::new(&bodies).with_fixed(0, true).with_self_contacts(false);
    let threads = std::thread::available_parallelism().map_or(1, |n| n.get()).min(2);
    let places = [1, threads].map(|threads| Place::Cpu { threads });
    let mut sessions = Vec::new();
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
        sessions.push((name, RefCell::new(session)));
    }
    let motion = [BodyMotion::new(1, body, &fallen)];
    let mut rows: Vec<Row> = Vec::new();
    for (shape, body) in &shapes {
        let name = format!("first contact, parry3d `cast_shapes` of {shape}, 1 thread");
        rows.push((name, Box::new(|| Ok((Some(cast(&target, *body)?), 0)))));
    }
    for (name, session) in &sessions {
        let first = || {
            let hit = session.borrow_mut().first_contact_of_bodies(&motion);
            Ok((hit.map_err(|e| e.to_string())?.map(|hit| hit.toi), 0))
        };
        rows.push((format!("first contact, {name}"), Box::new(first)));
        let all = || {
            let mut session = session.borrow_mut();
            let report = session.step_bodies(&motion).map_err(|e| e.to_string())?;
            Ok((None, report.contacts.len()))
        };
        rows.push((format!("all contacts, {name}"), Box::new(all)));
    }
    let measured = by_turns(ROUNDS, RUNS, &mut rows)?;
    let mut table = Table::new([
        format!("{name} on a level of 1,000,000 vertices"),
        "ms".into(),
        "found".into(),
    ]);
    let (expected, _) = measured[0].1;
    for ((name, _), (ms, (toi, n))) in rows.iter().zip(measured) {
        let agrees = |(toi, theirs): (f64, f64)| (toi - theirs).abs() <= TOLERANCE;
        if !toi.map_or(n > 0, |toi| expected.is_some_and(|theirs| agrees((toi, theirs)))) {
            return Err(format!("{name}: {toi:?}, {n} contacts, parry3d finds {expected:?}"));
        }
        let found = toi.map_or(format!("{n} contacts"), |toi| format!("at {toi:.7}"));
        table.row([name.clone(), digits(ms), found]);
    }
    println!("{table}");
    Ok(())
}

/// The time of a cast.
fn cast(level: &TriMesh, body: &dyn Shape) -> Result<f64, String> {
    let fall = Vector::new(0.0, -FALL, 0.0);
    let options = ShapeCastOptions::with_max_time_of_impact(1.0);
    let (here, rest) = (Pose::IDENTITY, Vector::ZERO);
    let hit = cast_shapes(&here, rest, level, &here, fall, body, options);
    let hit = hit.map_err(|e| e.to_string())?;
    Ok(hit.ok_or("parry3d finds no contact")?.time_of_impact.into())
}
