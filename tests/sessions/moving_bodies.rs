//! Steps that are told only which bodies move find, to the last bit, what plain steps find of the
//! same positions, whatever stands still, changes in between, or is refused.

use ccd::scenes::{Random, triangle_soup};
use ccd::{Bodies, BodyMotion, Coordinate, Hit, Mesh, Report};
use ccd_core::model::session::{Engine, Session};
use std::fmt::Debug;

/// Triangles, and bodies of some of them, spread over the ids.
const N_TRIANGLES: usize = 120;
const N_BODIES: u32 = 12;

/// A mesh, its bodies, of which the first four stand still, and where they are.
pub fn scene() -> (Mesh, Bodies, Vec<[f64; 3]>) {
    let step = triangle_soup(N_TRIANGLES, 0.25, 11);
    let body: Vec<u32> = (0..3 * N_TRIANGLES as u32).map(|v| v / 6 * 5 % N_BODIES + 100).collect();
    let mut bodies = Bodies::new(&body);
    for name in 100..104 {
        bodies = bodies.with_fixed(name, true);
    }
    let x = step.x0.iter().map(|p| p.map(|c| c as f32 as f64)).collect();
    (step.mesh, bodies, x)
}

/// Compares two sessions of one mesh and one choice of options over many steps. `early`: by how
/// much earliest times may differ where they are searched in two places.
pub fn check<E: Engine, P, T: Coordinate>(
    what: &str,
    early: f64,
    (told, plain): (&mut Session<E, P>, &mut Session<E, P>),
    at_rest: &[[T; 3]],
) where
    E::Error: Debug,
{
    let mut random = Random::new(7);
    let bodies = told.options().bodies.clone().expect("bodies");
    let vertices = |name: u32| -> Vec<usize> {
        let of = bodies.body_of_vertex();
        (0..of.len()).filter(|&v| of[v] == name).collect()
    };
    let mut x = at_rest.to_vec();
    told.set_positions(&x).expect("positions");
    let (mut n_contacts, mut n_free, mut asleep) = (0, 0, false);
    for k in 0..60 {
        // Of some steps all bodies that may move, of others none.
        let chance = [0.3, 1.0, 0.1, 0.0][k % 4];
        let names: Vec<u32> = (104..100 + N_BODIES).filter(|_| random.unit() < chance).collect();
        let (mut from, mut to) = (x.clone(), x.clone());
        let mut moves = Vec::new();
        for &name in &names {
            // Not always from where it was.
            let jump = if random.unit() < 0.3 { 0.2 } else { 0.0 };
            let [start, way] =
                [jump, 0.4].map(|s| random.point().map(|c| T::from_f64(s * (c - 0.5))));
            let ends: [Vec<[T; 3]>; 2] = vertices(name)
                .into_iter()
                .map(|v| {
                    from[v] = std::array::from_fn(|i| x[v][i] + start[i]);
                    to[v] = std::array::from_fn(|i| from[v][i] + way[i]);
                    (from[v], to[v])
                })
                .unzip::<_, _, Vec<_>, Vec<_>>()
                .into();
            moves.push((name, ends));
        }
        let motions: Vec<BodyMotion> =
            moves.iter().map(|(name, [x0, x1])| BodyMotion::new(*name, x0, x1)).collect();
        match k % 9 {
            3 => check_refused(told, &motions, &moves, vertices(100)),
            // What else is asked of the session in between; a body that sleeps may be refused.
            5 => _ = told.step(&to, &from),
            6 => _ = told.earliest_toi(&x, &to),
            7 => {
                let distance = told.options().min_distance;
                let other = if distance > 0.0 { 0.0 } else { 0.01 };
                told.set_min_distance(other).expect("a distance");
                plain.set_min_distance(other).expect("a distance");
            }
            8 => {
                let now = told.options().bodies.clone().expect("bodies");
                asleep = !asleep;
                let now = now.with_sleeping(110, asleep);
                told.set_bodies(now.clone()).expect("bodies");
                plain.set_bodies(now).expect("bodies");
            }
            _ => {}
        }
        if asleep && names.contains(&110) {
            let error = told.step_bodies(&motions).expect_err("a body that sleeps");
            assert!(format!("{error:?}").contains("FixedMoves"), "{what}, step {k}: {error:?}");
            continue;
        }
        let toi = told.earliest_toi_of_bodies(&motions).expect("a step");
        let want = plain.earliest_toi(&from, &to).expect("a step");
        assert_eq!(toi.is_some(), want.is_some(), "{what}, step {k}");
        let apart = toi.zip(want).map_or(0.0, |(toi, want)| (toi - want).abs());
        assert!(apart <= early, "{what}, step {k}: {toi:?}, {want:?}");
        // Bodies that have arrived are sent from where they were.
        let hit = told.first_contact_of_bodies(&motions).expect("a step");
        let first = plain.first_contact(&from, &to).expect("a step");
        let report = told.step_bodies(&motions).expect("a step");
        let want = plain.step(&from, &to).expect("a step");
        assert!(report.contacts == want.contacts, "{what}, step {k}: other contacts");
        assert_eq!(report.candidates, want.candidates, "{what}, step {k}");
        assert_eq!(report.toi, want.toi, "{what}, step {k}");
        for hit in [&first, &hit] {
            check_first(&format!("{what}, step {k}"), hit.as_ref(), report, &bodies, [&from, &to]);
        }
        assert_eq!(hit.map(|hit| hit.toi), report.toi, "{what}, step {k}");
        n_contacts += report.contacts.len();
        n_free += toi.is_none() as usize;
        x = to;
    }
    assert!(n_contacts > 200, "{what}: {n_contacts} contacts, {n_free} free");
}

/// The first contact is the first of all contacts.
fn check_first<T: Coordinate>(
    what: &str,
    hit: Option<&Hit>,
    all: &Report,
    bodies: &Bodies,
    [x0, x1]: [&[[T; 3]]; 2],
) {
    assert_eq!(hit.map(|_| true), all.toi.map(|_| true), "{what}");
    let (Some(hit), Some(toi)) = (hit, all.toi) else { return };
    assert!((hit.toi - toi).abs() <= 2.5e-6, "{what}: {} for {toi}", hit.toi);
    let [a, b] = hit.features;
    let contact = all.contacts.iter().find(|c| (c.kind, c.a, c.b) == (hit.kind, a, b));
    let mut contact = *contact.unwrap_or_else(|| panic!("{what}: {hit:?} is none of all"));
    // Of the same pair a shorter step may know the time better.
    assert!((contact.toi - toi).abs() <= 2.5e-6, "{what}: {contact:?} for {toi}");
    contact.toi = hit.toi;
    let at = contact.geometry(all.mesh(), x0, x1);
    assert_eq!((hit.point, hit.normal, hit.weights), (at.point, at.normal, at.weights), "{what}");
    let of = bodies.body_of_vertex();
    assert_eq!(hit.bodies, [hit.vertices[0], hit.vertices[3]].map(|v| of[v as usize]), "{what}");
    let [first, second] = hit.bodies.map(|body| hit.normal_towards(body));
    assert_eq!(first, at.normal, "{what}");
    let turned = if hit.bodies[0] == hit.bodies[1] { at.normal } else { at.normal.map(|c| -c) };
    assert_eq!(second, turned, "{what}");
}

/// Calls that are refused leave everything where it was.
fn check_refused<E: Engine, P, T: Coordinate>(
    session: &mut Session<E, P>,
    motions: &[BodyMotion],
    moves: &[(u32, [Vec<[T; 3]>; 2])],
    fixed: Vec<usize>,
) where
    E::Error: Debug,
{
    let mut refused = |more: BodyMotion, want: &str| {
        let is_other = |of: &&BodyMotion| want == "RepeatedBody" || of.body != more.body;
        let others = motions.iter().filter(is_other).copied();
        let all: Vec<BodyMotion> = others.chain([more]).collect();
        let error = session.step_bodies(&all).expect_err("refused");
        assert!(format!("{error:?}").contains(want), "{error:?} for {want}");
        assert!(session.report().contacts.is_empty());
    };
    let none: [[T; 3]; 0] = [];
    refused(BodyMotion::new(99, &none, &none), "NoBody");
    refused(BodyMotion::new(105, &none, &none), "BodyPositions");
    if let Some(&again) = motions.first() {
        refused(again, "RepeatedBody");
    }
    let still = vec![[T::from_f64(0.5); 3]; fixed.len()];
    let moved = vec![[T::from_f64(0.25); 3]; fixed.len()];
    refused(BodyMotion::new(100, &still, &moved), "FixedMoves");
    if let Some((name, [x0, x1])) = moves.first() {
        let mut bad = x1.clone();
        bad[0][1] = T::from_f64(f64::NAN);
        refused(BodyMotion::new(*name, x0, &bad), "Coordinate");
    }
}

#[test]
fn steps_of_bodies_are_plain_steps() {
    let (mesh, bodies, x) = scene();
    let narrow: Vec<[f32; 3]> = x.iter().map(|p| p.map(|c| c as f32)).collect();
    // Far away, so that boxes and tables are rounded.
    let far: Vec<[f64; 3]> = x.iter().map(|p| p.map(|c| c + 1e5 + 0.1)).collect();
    let plain = ccd::Options::default().with_bodies(bodies);
    for (what, options) in [
        ("one thread", plain.clone().with_threads(1)),
        ("two threads", plain.clone().with_threads(2)),
        ("a distance", plain.clone().with_min_distance(0.02)),
        ("triangles", plain.clone().with_pipeline(ccd::method::Pipeline::TRIANGLES)),
        ("a sweep", plain.clone().with_broad_phase(ccd::method::BroadPhaseMethod::SweepAndPrune)),
        ("a tree", plain.with_broad_phase(ccd::method::BroadPhaseMethod::Tree(Default::default()))),
    ] {
        // Of two threads, a step in which little happens has one as well.
        let told = || ccd::Session::new(&mesh, options.clone()).unwrap();
        let plain = || ccd::Session::new(&mesh, options.clone().with_threads(1)).unwrap();
        check(what, 0.0, (&mut told(), &mut plain()), &narrow);
        check(what, 0.0, (&mut told(), &mut plain()), &far);
    }
}

#[test]
fn bodies_move_in_the_precision_of_the_mesh() {
    let bodies = Bodies::new(&[0, 0, 0, 1]).with_fixed(0, true).with_self_contacts(false);
    let options = ccd::Options::default().with_bodies(bodies);
    let mut session = ccd::Session::new(Mesh::new(4, &[[0, 1, 2]]).unwrap(), options).unwrap();
    let x = [[0.0f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2]];
    let (from, to) = ([x[3]], [[0.2f32, -1.0, 0.2]]);
    let motion = BodyMotion::new(1, &from, &to);
    assert_eq!(session.step_bodies(&[motion]).err(), Some(ccd::Error::NoPositions));
    session.set_positions(&x).unwrap();
    assert_eq!(session.earliest_toi_of_bodies(&[]), Ok(None));
    assert_eq!(session.step_bodies(&[motion]).unwrap().contacts.len(), 1);
    let wide = to.map(|p| p.map(f64::from));
    let mixed = session.step_bodies(&[BodyMotion::new(1, &wide, &wide)]).err();
    assert_eq!(mixed, Some(ccd::Error::MixedPrecision { body: 1 }));
    // By a pose; an `f32` is an `f64`, not the other way round.
    let mut pose = [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| (i == k) as u8 as f32));
    pose[3][1] = -2.0;
    let posed = ccd::Posed::one(&from, &pose);
    session.set_positions(&x.map(|p| p.map(f64::from))).unwrap();
    let report = session.step_bodies(&[BodyMotion::new(1, &from, &posed)]).unwrap();
    assert_eq!(report.contacts.len(), 1);
    // It stands where it went, and another mesh has no positions yet.
    assert_eq!(session.earliest_toi_of_bodies(&[]), Ok(None));
    session.set_mesh(Mesh::new(4, &[[0, 2, 1]]).unwrap()).unwrap();
    assert_eq!(session.step_bodies(&[]).err(), Some(ccd::Error::NoPositions));
}

/// A session of either backend lends its session on the CPU: both know of each other's calls.
#[test]
fn two_sessions_over_one_engine_know_of_each_other() {
    let bodies = Bodies::new(&[0, 0, 0, 1]).with_fixed(0, true).with_self_contacts(false);
    let options = ccd::Options::default().with_bodies(bodies);
    let (choice, mesh) =
        (ccd::any::Backend::Cpu.choose(0).unwrap(), Mesh::new(4, &[[0, 1, 2]]).unwrap());
    let mut session = ccd::any::Session::new(&choice, mesh, options).unwrap();
    let at = |floor: f64, y: f64| {
        [[0.0, floor, 0.0], [1.0, floor, 0.0], [0.0, floor, 1.0], [0.2, y, 0.2]]
    };
    let ways = [[[0.2, 5.0, 0.2]], [[0.2, 4.0, 0.2]], [[0.2, -1.0, 0.2]], [[0.2, -3.0, 0.2]]];
    let [high, lower, below, far_below] = &ways;
    session.set_positions(&at(0.0, 5.0)).unwrap();
    assert_eq!(session.step_bodies(&[BodyMotion::new(1, high, lower)]).unwrap().toi, None);
    let inner = session.cpu().unwrap();
    inner.set_positions(&at(-2.0, -1.0)).unwrap();
    let falls = [BodyMotion::new(1, below, far_below)];
    assert_eq!(inner.step_bodies(&falls).unwrap().contacts.len(), 1);
    // Which is where they are for both; and bodies are those that either was given last.
    assert_eq!(session.step_bodies(&falls).unwrap().contacts.len(), 1);
    let renamed = Bodies::new(&[1, 1, 1, 0]).with_fixed(1, true).with_self_contacts(false);
    session.cpu().unwrap().set_bodies(renamed).unwrap();
    let falls = [BodyMotion::new(0, below, far_below)];
    assert_eq!(session.step_bodies(&falls).unwrap().contacts.len(), 1);
    session.cpu().unwrap().set_mesh(Mesh::new(4, &[[0, 2, 1]]).unwrap()).unwrap();
    let error = session.step_bodies(&falls).err();
    assert!(matches!(error, Some(ccd::any::Error::Input(ccd::Error::NoPositions))));
}
