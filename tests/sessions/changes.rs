//! Changes between steps: after each, a session finds what a new one would, by every method.

use ccd::scenes::{Step, crumpled_sheet, triangle_soup};
use ccd::{
    Bodies, BroadPhaseMethod, Error, Front, Mesh, Options, Pipeline, Report, Scheduler, Scheduling,
    Session, Traversal, TreeOptions, TriangleOptions,
};
use ccd_testkit::methods::is_near_default;

/// Both ways through a step: contacts, earliest times, candidates.
fn answers(session: &mut Session, step: &Step) -> Vec<(Report, Option<f64>, [usize; 2])> {
    [[&step.x0, &step.x1], [&step.x1, &step.x0]]
        .map(|[x0, x1]| {
            let listed = session.candidates(x0, x1).expect("candidates");
            let listed = [listed.vf.len(), listed.ee.len()];
            let earliest = session.earliest_toi(x0, x1).expect("a step");
            (session.step(x0, x1).expect("a step").clone(), earliest, listed)
        })
        .into()
}

/// What a session finds is what a new one with its mesh and its options does. Returns how many
/// contacts that were.
fn check(what: &str, session: &mut Session, step: &Step) -> usize {
    let options = session.options().clone();
    let mut fresh = Session::new(session.mesh().clone(), options).expect("a session");
    let (found, want) = (answers(session, step), answers(&mut fresh, step));
    let mut n = 0;
    for ((found, earliest, listed), (want, first, n_listed)) in found.iter().zip(&want) {
        assert!(found.contacts == want.contacts, "{what}: other contacts");
        assert!(*found.mesh() == *want.mesh() && *found.mesh() == step.mesh, "{what}");
        let numbers = |r: &Report| (r.toi, r.candidates, r.filtered, r.undecided, r.triangles);
        assert_eq!(numbers(found), numbers(want), "{what}");
        assert_eq!((earliest, listed), (first, n_listed), "{what}");
        n += found.contacts.len();
    }
    n
}

fn pipelines() -> [Pipeline; 3] {
    let cones = TriangleOptions::default().cones(true);
    [Pipeline::Features, Pipeline::TRIANGLES, Pipeline::Triangles(cones)]
}

fn methods() -> impl Iterator<Item = (BroadPhaseMethod, Scheduling)> {
    let alone = ccd::every("cpu").filter(|&method| is_near_default(method));
    let cut = BroadPhaseMethod::Tree(TreeOptions::default().traversal(Traversal::CUT));
    let front = Scheduling::default().scheduler(Scheduler::LazyStealing).front(Front::ON);
    let kept = [BroadPhaseMethod::Blocks, cut].map(|method| (method, front));
    alone.map(|method| (method, Scheduling::default())).chain(kept)
}

/// All of one session, one change after the other.
fn check_changes(threads: usize) {
    let (small, large) = (crumpled_sheet(8, 1), crumpled_sheet(16, 2));
    let soup = triangle_soup(60, 0.3, 5);
    let none =
        Step { mesh: Mesh::new(2, &[]).unwrap(), x0: vec![[0.0; 3]; 2], x1: vec![[1.0; 3]; 2] };
    for (method, scheduling) in methods() {
        for pipeline in pipelines() {
            let what = format!("{method}, {pipeline:?}, {scheduling}");
            let options = Options::default()
                .with_threads(threads)
                .with_broad_phase(method)
                .with_pipeline(pipeline)
                .with_scheduling(scheduling);
            let mut session = Session::new(&small.mesh, options).unwrap();
            let mut counts = vec![check(&what, &mut session, &small)];
            for (step, distance) in
                [(&large, 0.0), (&small, 0.01), (&soup, 0.0), (&none, 0.0), (&large, 0.02)]
            {
                session.set_mesh(&step.mesh).unwrap();
                session.set_min_distance(distance).unwrap();
                counts.push(check(&what, &mut session, step));
                session.set_min_distance(0.0).unwrap();
                counts.push(check(&what, &mut session, step));
                session.set_min_distance(0.005).unwrap();
                counts.push(check(&what, &mut session, step));
            }
            // The control: each of these has another answer.
            let others = counts.windows(2).filter(|two| two[0] != two[1]).count();
            assert!(others > 10, "{what}: {counts:?}");
            assert!(counts.iter().filter(|&&n| n > 0).count() > 11, "{what}: {counts:?}");
        }
    }
}

#[test]
fn meshes_and_distances_on_one_thread() {
    check_changes(1);
}

#[test]
fn meshes_and_distances_on_two_threads() {
    check_changes(2);
}

/// From every method, pipeline and scheduling to the next, in one session.
#[test]
fn options_change() {
    let step = crumpled_sheet(12, 4);
    let half = step.mesh.n_vertices() as u32 / 2;
    let soup = triangle_soup(60, 0.3, 5);
    let of: Vec<u32> = (0..180).map(|v| v / 3 % 5).collect();
    let bodies = [
        None,
        Some(Bodies::new(&of, &[], true)),
        Some(Bodies::new(&of, &[true, false, true], false).with_fixed_motion(true)),
    ];
    let mut session = Session::new(&soup.mesh, Options::default()).unwrap();
    let mut counts = Vec::new();
    for (k, (method, scheduling)) in methods().chain(methods()).enumerate() {
        let options = Options::default()
            .with_threads(1 + k / 3 % 2)
            .with_broad_phase(method)
            .with_pipeline(pipelines()[k / 2 % 3])
            .with_scheduling(scheduling)
            .with_bodies(bodies[k % 3].clone())
            .with_min_distance(0.001 * (k % 2) as f64);
        session.set_options(options.clone()).unwrap();
        assert_eq!(*session.options(), options);
        counts.push(check(&format!("{options:?}"), &mut session, &soup));
    }
    assert!(counts.windows(2).filter(|two| two[0] != two[1]).count() > 10, "{counts:?}");

    let options = Options::default().with_threads(1).with_bodies(bodies[1].clone());
    session.set_options(options).unwrap();
    // A mesh with bodies: both at once, and none of either if they do not fit.
    let why = session.set_mesh(&step.mesh).unwrap_err();
    assert!(matches!(why, Error::BodyCount { found: 180, .. }), "{why}");
    let halves: Vec<u32> = (0..2 * half).map(|v| v / half).collect();
    let mixed = Bodies::new(&halves, &[], false);
    let n = halves.len();
    let why = session.set_mesh_and_bodies(&step.mesh, mixed).unwrap_err();
    assert!(matches!(why, Error::MixedBodies { .. } | Error::BodyCount { .. }), "{why} ({n})");
    assert!(session.set_min_distance(f64::NAN).is_err() && session.set_min_distance(-1.0).is_err());
    let bad = Options::default().with_threads(Options::MAX_THREADS + 1);
    assert!(matches!(session.set_options(bad), Err(Error::Threads { .. })));
    assert!(check("refused", &mut session, &soup) > 0);
    session.set_mesh_and_bodies(&step.mesh, None).unwrap();
    assert!(check("without bodies", &mut session, &step) > 0);
    let all = Bodies::new(&vec![3; step.mesh.n_vertices()], &[], true);
    session.set_mesh_and_bodies(&soup.mesh, bodies[1].clone()).unwrap();
    assert!(check("with bodies", &mut session, &soup) > 0);
    session.set_mesh_and_bodies(&step.mesh, all).unwrap();
    assert!(check("with one body", &mut session, &step) > 0);
}
