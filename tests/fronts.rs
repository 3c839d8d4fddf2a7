//! Fronts over sequences: on every frame the candidates of a session that begins where the step
//! before ended are those of one that begins at the roots.

use ccd::scenes::{Sequence, cloth_on_ball, funnel, interpenetrating, n_body};
use ccd::{
    BroadPhaseMethod, Digest, Front, FrontOptions, Mesh, Options, Scheduler, Scheduling, Session,
    Traversal, TreeOptions, Volume,
};
use ccd_testkit::data;
use libtest_mimic::{Arguments, Completion, Trial};
use std::path::Path;

/// Blocks, and binary trees of either volume.
fn methods() -> [BroadPhaseMethod; 3] {
    let tree = TreeOptions::default().traversal(Traversal::SIMULTANEOUS);
    let obb = tree.volume(Volume::Obb);
    [BroadPhaseMethod::Blocks, BroadPhaseMethod::Tree(tree), BroadPhaseMethod::Tree(obb)]
}

/// Candidates of a step, of both kinds.
fn candidates(session: &mut Session, x: [&[[f64; 3]]; 2]) -> [Digest; 2] {
    let found = session.candidates(x[0], x[1]).expect("candidates");
    [Digest::of(0, found.vf.iter()), Digest::of(1, found.ee.iter())]
}

/// Every frame by every method; many of the steps begin at a front.
fn check(name: &str, mesh: &Mesh, n_frames: usize, frame: impl Fn(usize) -> Vec<[f64; 3]>) {
    let options = |broad_phase, scheduling| {
        Options::default().with_threads(2).with_broad_phase(broad_phase).with_scheduling(scheduling)
    };
    let session = |options| Session::new(mesh.clone(), options).expect("a session");
    // Given up in every other step, or now and then, for either reason.
    let fronts = [
        FrontOptions::default().rebuild(2, u32::MAX),
        FrontOptions::default().growth(102).rebuild(4, 101),
        FrontOptions::default().rebuild(4, 101),
    ];
    let schedulers = [Scheduler::LazyStealing, Scheduler::Frontier, Scheduler::SelfScheduling];
    let of = |k: usize| {
        let scheduling = Scheduling::default().scheduler(schedulers[k]).front(Front::On(fronts[k]));
        session(options(methods()[k], scheduling))
    };
    let mut with_front = [0, 1, 2].map(of);
    let mut fresh = session(options(BroadPhaseMethod::Blocks, Scheduling::default()));
    let (mut begun, mut n_changed, mut before, mut last) = ([0; 3], 0, frame(0), None);
    for i in 1..n_frames {
        let after = frame(i);
        let x = [&before[..], &after[..]];
        let want = candidates(&mut fresh, x);
        for (k, session) in with_front.iter_mut().enumerate() {
            let found = candidates(session, x);
            assert!(found == want, "{name}, frame {i}, {}: other pairs", methods()[k]);
            let report = session.step(x[0], x[1]).expect("a step");
            let front = report.front.expect("fronts are counted");
            begun[k] += (front.begun > 0) as usize;
            assert!(front.bytes <= 512 << 20, "{front:?}");
        }
        n_changed += last.is_some_and(|last| last != want) as usize;
        last = Some(want);
        before = after;
    }
    // The control: frames have other pairs than those before, and the comparison sees it.
    assert!(n_changed > 2, "{name}: {n_changed} frames differ");
    assert!(begun.iter().all(|&n| n > n_frames / 3), "{name}: {begun:?} of {n_frames} steps");
}

fn check_sequence(name: &str, scene: &Sequence, n_frames: usize) {
    check(name, &scene.mesh, n_frames, |i| scene.frame(i));
}

fn interpenetrating_meshes() {
    for n in [64, 1024] {
        check_sequence(&format!("interpenetrating {n}"), &interpenetrating(n), 12);
    }
}

/// Debris that falls against a wall: sixty frames.
fn check_debris(data: &Path) {
    let frame = |i: usize| {
        let path = data.join(format!("scenes/debris-wall/frames/{:03}.ply", 40 + i));
        ccd::io::read_frame(&path).expect("a frame")
    };
    let mesh = frame(0).mesh().expect("a mesh");
    check("debris-wall", &mesh, 60, |i| frame(i).positions);
}

fn main() {
    type Row = (&'static str, fn());
    let rows: [Row; 4] = [
        ("interpenetrating_meshes", interpenetrating_meshes),
        ("funnel", || check_sequence("funnel", &funnel(32), 20)),
        ("cloth_on_ball", || check_sequence("cloth on ball", &cloth_on_ball(30), 20)),
        ("bodies_that_bounce", || check_sequence("n-body", &n_body(40, 9), 20)),
    ];
    let done = |run: fn()| {
        move || {
            run();
            Ok(())
        }
    };
    let mut trials: Vec<Trial> =
        rows.into_iter().map(|(name, run)| Trial::test(name, done(run))).collect();
    trials.push(Trial::ignorable_test("debris_wall", || match data::data_dir() {
        Ok(data) => {
            check_debris(&data);
            Ok(Completion::Completed)
        }
        Err(why) => Ok(Completion::ignored_with(why)),
    }));
    libtest_mimic::run(&Arguments::from_args(), trials).exit();
}
