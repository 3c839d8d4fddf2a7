//! Changes between steps on a device: after each, a session finds what a new one would, in the
//! buffers that it has where they are large enough.

use crate::emulated::is_thin;
use crate::moving_bodies;
use crate::support::read_back;
use ccd::gpu::{Device, Error, Session, wgpu};
use ccd::method::{
    BroadPhaseMethod, Front, Pipeline, Scheduler, Scheduling, Traversal, TreeOptions,
    TriangleOptions,
};
use ccd::scenes::{Step, crumpled_sheet, triangle_soup};
use ccd::{Bodies, BodyMotion, Coordinate, Digest, Mesh, Options};
use ccd_core::backend::layout::Path;

pub const TESTS: crate::Tests = &[
    ("changes_between_steps", check_changes),
    ("changes_that_are_refused", check_refused),
    ("positions_on_their_way", check_on_their_way),
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

/// Positions of many vertices are sent before anybody has looked at them, in the form that those of
/// the step before had. Each step has its own all the same, and what is refused does not arrive.
fn check_on_their_way(device: &Device) {
    let step = triangle_soup(3000, 0.03, 5);
    let of: Vec<u32> = (0..9000).map(|v| v / 180).collect();
    let options = Options::default().with_bodies(Bodies::new(&of));
    let mut both = Both {
        device: Session::new(device, &step.mesh, options.clone()).expect("a session"),
        cpu: ccd::Session::new(step.mesh.clone(), options).expect("a session"),
        seen: Vec::new(),
    };
    let given = [&step.x0, &step.x1];
    let wide = given.map(|x| sheared(x, |[x, y, z]| [x, y + 0.3 * x, z]));
    let larger = given.map(|x| sheared(x, |[x, y, z]| [900.0 * x + 7.7, 900.0 * (y - x), z]));
    let narrow = step.rounded();
    let leaning = narrow.each_ref().map(|x| sheared(x, |[x, y, z]| [x, y, 0.5 * (z + y)]));
    both.check("f32", &narrow);
    both.check("f32 again", &leaning);
    both.check("f64 after f32", &wide);
    both.check("f64 again, with other bounds", &larger);
    let mut bad = larger.clone();
    bad[1][8000][2] = f64::NAN;
    both.refuse(&bad);
    let last = narrow.each_ref().map(|x| sheared(x, |[x, y, z]| [x + 0.4 * y, y, z]));
    both.check("f32 after f64", &last);

    // What a caller records reads the paths of the last step that was not refused.
    let n = both.recorded(device);
    both.device.step(&last[0], &last[1]).expect("a step");
    let mut bad = narrow.clone();
    bad[1][8000][2] = f32::NAN;
    both.refuse(&bad);
    assert_eq!(both.recorded(device), n);
    both.check(
        "f32 after what was refused",
        &leaning.map(|x| sheared(&x, |[x, y, z]| [x, y, z - x])),
    );

    // Bodies move, after a step of all positions. Coordinates are exact in `f32`, then those of
    // most bodies at rest are not, and some differ by less than it resolves.
    let exact: Vec<[f64; 3]> = narrow[0].iter().map(|p| p.map(f64::from)).collect();
    let lattice = |p: &[f64; 3], v: usize| match (v, v / 3 % 2) {
        (..2048, _) => p.map(|c| 0.125 * (60.0 * c).round()),
        (_, 0) => p.map(|c| 0.1 * (60.0 * c).round()),
        _ => p.map(|c| (60.0 * c).round() / 10.0),
    };
    let inexact: Vec<[f64; 3]> = step.x0.iter().zip(0..).map(|(p, v)| lattice(p, v)).collect();
    for x in [&exact, &inexact] {
        both.device.set_positions(x).expect("positions");
        both.cpu.set_positions(x).expect("positions");
        for name in [3, 4, 3] {
            let from = &x[180 * name..180 * (name + 1)];
            let by = if name == 4 { 2.0 } else { 0.25 };
            let to = sheared(from, |[x, y, z]| [x + by, y, z]);
            let motion = [BodyMotion::new(name as u32, from, &to)];
            let report = both.cpu.step_bodies(&motion).expect("a step");
            let want = (report.candidates, report.contacts.len());
            assert!(want.1 > 10, "{name}: {want:?}");
            let report = both.device.step_bodies(&motion).expect("a step");
            assert_eq!((report.candidates, report.contacts.len()), want, "{name}");
        }
    }
}

/// Other boxes overlap then; scaled along axes, the same would.
fn sheared<T: Coordinate>(x: &[[T; 3]], f: impl Fn([T; 3]) -> [T; 3]) -> Vec<[T; 3]> {
    x.iter().map(|&p| f(p)).collect()
}

/// A session on a device and one on a CPU that have the same steps.
struct Both {
    device: Session,
    cpu: ccd::Session,
    seen: Vec<[Digest; 2]>,
}

impl Both {
    /// Both find the same candidates, and others than ever before.
    fn check<T: Coordinate>(&mut self, what: &str, [x0, x1]: &[Vec<[T; 3]>; 2]) {
        let found = self.device.candidates(x0, x1).expect("candidates");
        let found = [Digest::of(0, found.vf.into_iter()), Digest::of(1, found.ee.into_iter())];
        let want = self.cpu.candidates(x0, x1).expect("candidates");
        let want = [Digest::of(0, want.vf.iter()), Digest::of(1, want.ee.iter())];
        assert_eq!(found, want, "{what}");
        assert!(!self.seen.contains(&want), "{what}: the candidates of another step");
        self.seen.push(want);
    }

    fn refuse<T: Coordinate>(&mut self, [x0, x1]: &[Vec<[T; 3]>; 2]) {
        let found = self.device.step(x0, x1).map(|report| report.contacts.len());
        let is_refused = matches!(
            found,
            Err(Error::Input(ccd::Error::Coordinate { time: 1, vertex: 8000, axis: 2, .. }))
        );
        assert!(is_refused, "{found:?}");
    }

    /// How many contacts a frame lists that is recorded from the paths that are there.
    fn recorded(&mut self, device: &Device) -> u32 {
        let mut encoder = device.wgpu().create_command_encoder(&Default::default());
        let found = self.device.record(&mut encoder).expect("recorded");
        read_back(device, encoder, &[(found.contacts.buffer(), 4)])[0][0]
    }
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
