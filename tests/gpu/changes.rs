//! Changes between steps on a device: after each, a session finds what a new one would, in the
//! buffers that it has where they are large enough.

use crate::emulated::is_thin;
use crate::moving_bodies;
use ccd::gpu::{Device, Error, Session, wgpu};
use ccd::method::{
    BroadPhaseMethod, Front, Pipeline, Scheduler, Scheduling, Traversal, TreeOptions,
    TriangleOptions,
};
use ccd::scenes::{Step, crumpled_sheet, triangle_soup};
use ccd::{Bodies, BodyMotion, Digest, Mesh, Options};
use ccd_core::backend::layout::Path;

pub const TESTS: crate::Tests = &[
    ("changes_between_steps", check_changes),
    ("changes_that_are_refused", check_refused),
    ("paths_that_were_written", check_written),
    ("paths_written_in_flight", check_written_in_flight),
];

/// Contacts and candidates of a session are those of a new one; returns how many contacts.
fn check(what: &str, device: &Device, session: &mut Session, step: &Step) -> usize {
    let options = session.options().clone();
    let mut fresh = Session::new(device, session.mesh().clone(), options).expect("a session");
    // The other way round, at once after: with the order that is kept.
    for [x0, x1] in [[&step.x0, &step.x1], [&step.x1, &step.x0]] {
        let digests = |session: &mut Session| {
            let found = session.candidates(x0, x1).expect("candidates");
            [Digest::of(0, found.vf.into_iter()), Digest::of(1, found.ee.into_iter())]
        };
        assert_eq!(digests(session), digests(&mut fresh), "{what}: candidates");
        let report = session.step(x0, x1).expect("a step");
        let want = fresh.step(x0, x1).expect("a step");
        assert!(report.contacts == want.contacts, "{what}: other contacts");
        assert_eq!(report.mesh(), &step.mesh, "{what}");
        let (toi, first) = (report.toi, session.earliest_toi(x0, x1).expect("a step"));
        let near = |a: f64, b: f64| a <= b && a > b - 2e-6;
        assert!(toi.zip(first).is_none_or(|(toi, first)| near(first, toi)), "{what}: {first:?}");
        assert_eq!(toi.is_some(), first.is_some(), "{what}");
    }
    session.report().candidates.total() as usize
}

fn check_changes(device: &Device) {
    let (small, large) = (crumpled_sheet(7, 1), crumpled_sheet(14, 2));
    let soup = triangle_soup(40, 0.3, 5);
    let tree = TreeOptions::default();
    let cut = BroadPhaseMethod::Tree(tree.traversal(Traversal::CUT));
    let front = Scheduling::default().scheduler(Scheduler::SelfScheduling).front(Front::ON);
    let free_regions = Pipeline::Triangles(TriangleOptions::default().free_regions(true));
    let plain = Scheduling::default();
    let all = [
        (BroadPhaseMethod::Blocks, Pipeline::Features, plain),
        (BroadPhaseMethod::Blocks, free_regions, plain),
        (BroadPhaseMethod::Tree(tree), Pipeline::Features, plain),
        (cut, Pipeline::Features, front),
        (BroadPhaseMethod::SweepAndPrune, Pipeline::Features, plain),
    ];
    let body: Vec<u32> = (0..120).map(|v| v / 3 % 5).collect();
    let bodies = Bodies::new(&body)
        .with_fixed_mask(&[true, false, true])
        .with_self_contacts(false)
        .with_fixed_motion(true);
    let mut last = Session::new(device, &small.mesh, Options::default()).expect("a session");
    // On an emulated GPU the second, the fourth and the fifth.
    let chosen = |k: &usize| !is_thin(device) || [1, 3, 4].contains(k);
    for (method, pipeline, scheduling) in (0..all.len()).filter(chosen).map(|k| all[k]) {
        let what = format!("{method}, {pipeline:?}, {scheduling}");
        let options = Options::default()
            .with_broad_phase(method)
            .with_pipeline(pipeline)
            .with_scheduling(scheduling);
        let mut session = Session::new(device, &small.mesh, options.clone()).expect("a session");
        let mut n = vec![check(&what, device, &mut session, &small)];
        for (step, distance) in [(&large, 0.0), (&soup, 0.01), (&small, 0.0), (&large, 0.01)] {
            let before = session.paths().clone();
            session.set_mesh(&step.mesh).expect("another mesh");
            let kept = *session.paths() == before;
            assert_eq!(kept, step.mesh.n_vertices() * 32 <= before.size() as usize, "{what}");
            session.set_min_distance(distance).expect("a distance");
            n.push(check(&what, device, &mut session, step));
        }
        session.set_min_distance(0.0).expect("a distance");
        n.push(check(&what, device, &mut session, &large));
        // The control: each of these has other candidates.
        assert!(n.windows(2).all(|two| two[0] != two[1]), "{what}: {n:?}");
        session.set_mesh_and_bodies(&soup.mesh, bodies.clone()).expect("with bodies");
        check(&what, device, &mut session, &soup);

        // From method to method in one session.
        last.set_options(options.with_min_distance(0.003)).expect("other options");
        check(&format!("changed to {what}"), device, &mut last, &small);
    }
}

/// What is refused leaves the session as it was.
fn check_refused(device: &Device) {
    let (small, large) = (crumpled_sheet(7, 1), crumpled_sheet(9, 2));
    let bodies = Bodies::new(&vec![1; small.mesh.n_vertices()]);
    let options = Options::default().with_bodies(bodies);
    let mut session = Session::new(device, &small.mesh, options.clone()).expect("a session");
    let before = session.options().clone();
    let n = check("before", device, &mut session, &small);
    let why = session.set_mesh(&large.mesh).expect_err("bodies that do not fit");
    assert!(matches!(why, Error::Input(ccd::Error::BodyCount { .. })), "{why}");
    assert!(session.set_min_distance(-1.0).is_err());
    let lacking = options.clone().with_broad_phase(BroadPhaseMethod::SweepInStrips);
    let why = session.set_options(lacking).expect_err("a method of the CPU");
    assert!(matches!(why, Error::Input(ccd::Error::Method { .. })), "{why}");
    assert_eq!((session.options(), &**session.mesh()), (&before, &small.mesh));
    assert_eq!(check("after", device, &mut session, &small), n);
}

/// Whoever has the buffer of paths may write it at any time, and record no frame: the next step has
/// its positions all the same, of what stands still too.
fn check_written(device: &Device) {
    let (mesh, bodies, x) = moving_bodies::scene();
    let mut x: Vec<[f32; 3]> = x.iter().map(|p| p.map(|c| c as f32)).collect();
    let far = |i: usize| [100.0 * i as f32, 0.0, 0.0, 0.0];
    let elsewhere: Vec<Path> = (0..x.len()).map(|i| Path { t0: far(i), t1: far(i) }).collect();
    let write = |paths: &wgpu::Buffer| {
        device.queue().write_buffer(paths, 0, bytemuck::cast_slice(&elsewhere));
    };
    let options = Options::default().with_bodies(bodies.clone());
    let session = || Session::new(device, &mesh, options.clone()).expect("a session");
    let (mut told, mut plain, mut early) = (session(), session(), session());
    let kept = early.paths().clone();
    told.set_positions(&x).expect("positions");
    early.set_positions(&x).expect("positions");
    let mut n_contacts = 0;
    for (k, name) in (104..110).enumerate() {
        if k == 3 {
            // Another mesh in the same buffer.
            let copy: Mesh = mesh.clone();
            early.set_mesh(copy).expect("the same mesh");
            assert!(*early.paths() == kept);
            early.set_positions(&x).expect("positions");
        }
        let of = bodies.body_of_vertex();
        let vertices: Vec<usize> = (0..x.len()).filter(|&v| of[v] == name).collect();
        let before = x.clone();
        vertices.iter().for_each(|&v| x[v][1] += 0.2);
        let ends = [&before, &x].map(|x| vertices.iter().map(|&v| x[v]).collect::<Vec<_>>());
        let motion = BodyMotion::new(name, &ends[0], &ends[1]);
        let want = &plain.step(&before, &x).expect("a step").contacts;
        for session in [&mut told, &mut early] {
            let found = session.step_bodies(&[motion]).expect("a step");
            assert!(found.contacts == *want, "{name}: other contacts");
        }
        n_contacts += want.len();
        write(told.paths());
        write(&kept);
    }
    assert!(n_contacts > 100, "{n_contacts}");
}

/// Also while a step is in flight, which may be submitted again because lists were too short.
fn check_written_in_flight(device: &Device) {
    let step = triangle_soup(600, 0.3, 5);
    let [x0, x1] = step.rounded();
    let session = || Session::new(device, &step.mesh, Options::default()).expect("a session");
    let want = session().step(&x0, &x1).expect("a step").contacts.clone();
    assert!(want.len() > 1000, "{}", want.len());
    let (mut session, still) = (session(), vec![Path::default(); x0.len()]);
    let paths = session.paths().clone();
    session.submit(&x0, &x1).expect("submitted");
    device.queue().write_buffer(&paths, 0, bytemuck::cast_slice(&still));
    device.queue().submit([]);
    let found = loop {
        match session.poll().expect("a step") {
            Some(report) => break report,
            None => std::thread::yield_now(),
        }
    };
    assert!(found.contacts == want, "{} contacts of {}", found.contacts.len(), want.len());
    assert!(*session.paths() == paths, "another buffer");
}
