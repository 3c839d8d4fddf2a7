//! Sessions over sequences by every scheduler, with a front and without one: on every frame the
//! candidates are those of the CPU's default.

use crate::emulated::is_thin;
use crate::support::not_run;
use ccd::gpu::{Device, Path, Session, Timing};
use ccd::method::{
    BroadPhaseMethod, Descent, Front, FrontOptions, Scheduler, Scheduling, Traversal, TreeOptions,
    Volume, WorkerOptions,
};
use ccd::scenes::{Sequence, funnel, interpenetrating};
use ccd::{Digest, Options};

pub const TESTS: crate::Tests = &[
    ("schedulers_over_sequences", check_sequences),
    ("stealing_sessions", check_refused),
    ("fronts_that_are_given_up", check_given_up),
    ("rounds_that_are_too_few", check_rounds),
    ("stages_of_schedulers", check_stages),
    ("options_of_workers", check_options),
];

fn tree(volume: Volume) -> BroadPhaseMethod {
    // A cut that is small for these scenes, so that there is something below it.
    let cut = Traversal::Cut { nodes: 24, descent: Descent::Larger };
    BroadPhaseMethod::Tree(TreeOptions::default().traversal(cut).volume(volume))
}

fn session(
    device: &Device,
    scene: &Sequence,
    broad_phase: BroadPhaseMethod,
    scheduling: Scheduling,
) -> Session {
    let options = Options::default().with_broad_phase(broad_phase).with_scheduling(scheduling);
    Session::new(device, scene.mesh.clone(), options).expect("a session")
}

/// Frames of a scene, with the candidates of each step, of which more than `least` must differ from
/// those of the step before.
fn steps(scene: &Sequence, n: usize, least: usize) -> (Vec<Vec<[f64; 3]>>, Vec<[Digest; 2]>) {
    let frames: Vec<_> = (0..=n).map(|i| scene.frame(i)).collect();
    let mut cpu = ccd::Session::new(scene.mesh.clone(), Options::default()).expect("a session");
    let mut want = Vec::new();
    for x in frames.windows(2) {
        let found = cpu.candidates(&x[0], &x[1]).expect("candidates");
        want.push([Digest::of(0, found.vf.iter()), Digest::of(1, found.ee.iter())]);
    }
    let n_changed = want.windows(2).filter(|two| two[0] != two[1]).count();
    assert!(n_changed > least, "{n_changed} of {n} steps differ from the one before");
    (frames, want)
}

/// All steps; with how many pairs of a front each began.
fn run(
    what: &str,
    session: &mut Session,
    frames: &[Vec<[f64; 3]>],
    want: &[[Digest; 2]],
) -> Vec<u64> {
    let mut begun = Vec::new();
    for (i, (x, want)) in frames.windows(2).zip(want).enumerate() {
        let found = session.candidates(&x[0], &x[1]).expect("candidates");
        let found = [Digest::of(0, found.vf.into_iter()), Digest::of(1, found.ee.into_iter())];
        assert!(found == *want, "{what}, step {i}: {found:?}, right is {want:?}");
        begun.push(session.report().front.map_or(0, |front| front.begun));
    }
    begun
}

fn steals(scheduling: Scheduling) -> bool {
    matches!(scheduling.scheduler, Some(Scheduler::Stealing | Scheduler::LazyStealing))
}

/// Where no workgroup passes data to another, a session that steals is refused.
fn check_refused(device: &Device) {
    let mesh = interpenetrating(64).mesh;
    let mut n_refused = 0;
    for broad_phase in [tree(Volume::Aabb), BroadPhaseMethod::Blocks] {
        for scheduling in Scheduling::every("gpu") {
            let options = Options::default().with_broad_phase(broad_phase);
            let options = options.with_scheduling(scheduling);
            let refused = Session::new(device, mesh.clone(), options).err().map(|e| e.to_string());
            let want = steals(scheduling) && device.info().path == Path::Wgsl;
            assert_eq!(refused.is_some(), want, "{scheduling}: {refused:?}");
            if let Some(why) = refused {
                assert!(why.contains("WGSL") && why.contains("between workgroups"), "{why}");
                assert!(!why.starts_with("no GPU"), "{why}");
                n_refused += 1;
            }
        }
    }
    assert_eq!(n_refused, if device.info().path == Path::Wgsl { 8 } else { 0 });
}

fn check_sequences(device: &Device) {
    // Meshes of which every step has pairs that meet and pairs that separate.
    let mut scenes = vec![("interpenetrating", interpenetrating(64), 5)];
    if !is_thin(device) {
        // So much work that many workgroups take from each other.
        scenes
            .extend([("interpenetrating", interpenetrating(4096), 5), ("funnel", funnel(87), 24)]);
    }
    for (name, scene, n) in scenes {
        let least = if name == "interpenetrating" { n / 3 } else { 0 };
        let all = [tree(Volume::Aabb), tree(Volume::Obb), BroadPhaseMethod::Blocks];
        check_sequence(device, name, &scene, n, least, &all);
    }
    if is_thin(device) && device.info().wide {
        // The smallest with pairs of blocks to expand; without f64 the kernels are the same.
        check_sequence(device, "funnel", &funnel(48), 5, 0, &[BroadPhaseMethod::Blocks]);
    }
}

fn check_sequence(
    device: &Device,
    name: &str,
    scene: &Sequence,
    n: usize,
    least: usize,
    methods: &[BroadPhaseMethod],
) {
    let native = device.check_native().is_ok();
    let (frames, want) = steps(scene, n, least);
    for &method in methods {
        let mut n_busy = 0;
        for scheduling in Scheduling::every("gpu").filter(|&s| native || !steals(s)) {
            let what = format!("{name}, {method}, {scheduling}");
            let mut session = session(device, scene, method, scheduling);
            let begun = run(&what, &mut session, &frames, &want);
            let n_resumed = begun.iter().filter(|&&n| n > 0).count();
            let has_front = scheduling.front != Front::Off;
            assert_eq!(session.report().front.is_some(), has_front, "{what}");
            assert!((n_resumed > 1) == has_front, "{what}: {begun:?}");
            let counts = session.worker_counts().expect("counts of workers");
            let busy = counts.iter().filter(|count| count.expanded > 0).count();
            let by_level = scheduling.scheduler == Some(Scheduler::Frontier) && !has_front;
            // With a front there may be nothing to expand, nor of blocks that are few.
            let is_small = method == BroadPhaseMethod::Blocks && name == "interpenetrating";
            let fine = if by_level { busy == 0 } else { has_front || is_small || busy > 0 };
            assert!(fine, "{what}: {busy} workers had work");
            n_busy += busy;
            let all = |c: &ccd::gpu::WorkerCounts| c.expanded <= c.turns * c.width;
            assert!(counts.iter().all(all), "{what}: {counts:?}");
        }
        println!("{name}, {method}: {n_busy} workers had work in the last steps");
    }
}

/// Fronts that may hardly grow, that must change, or that have no memory; lists that are made short
/// in the middle.
fn check_given_up(device: &Device) {
    let scene = interpenetrating(64);
    let (frames, want) = steps(&scene, 8, 2);
    for method in [tree(Volume::Aabb), BroadPhaseMethod::Blocks] {
        check_given_up_of(device, &scene, method, &frames, &want);
    }
}

fn check_given_up_of(
    device: &Device,
    scene: &Sequence,
    method: BroadPhaseMethod,
    frames: &[Vec<[f64; 3]>],
    want: &[[Digest; 2]],
) {
    let on = FrontOptions::default();
    let kept = |options: FrontOptions, short: bool| {
        let scheduling = Scheduling::default().scheduler(Scheduler::SelfScheduling);
        let scheduling = scheduling.front(Front::On(options));
        let mut session = session(device, scene, method, scheduling);
        let what = format!("{method}, {options:?}, {short}");
        let mut begun = run(&what, &mut session, &frames[..4], &want[..3]);
        if short {
            session.reserve(3).expect("short lists");
        }
        begun.extend(run(&what, &mut session, &frames[3..], &want[3..]));
        let front = session.report().front.expect("fronts are counted");
        assert!(front.bytes <= (options.memory as u64) << 20, "{front:?}");
        assert!(!short || session.grown() > 0);
        begun
    };
    let n_resumed = |begun: Vec<u64>| begun.iter().filter(|&&n| n > 0).count();
    assert_eq!(n_resumed(kept(on.growth(u32::MAX), false)), 7);
    // What did not become a thousand times as long is given up at once.
    let unchanged = kept(on.growth(u32::MAX).rebuild(1, 100_000), false);
    assert_eq!(n_resumed(unchanged), 4);
    // A list that is too short is sorted for anew.
    let short = n_resumed(kept(on.growth(u32::MAX), true));
    assert!((4..7).contains(&short), "{short}");
}

/// Where there are more levels than rounds, the search runs again with more.
fn check_rounds(device: &Device) {
    let scene = interpenetrating(64);
    let (frames, want) = steps(&scene, 3, 1);
    let from_roots = Traversal::Cut { nodes: 1, descent: Descent::Larger };
    let grown = |scheduler: Scheduler| {
        let scheduling = Scheduling::default().scheduler(scheduler).front(Front::ON);
        let tree = BroadPhaseMethod::Tree(TreeOptions::default().traversal(from_roots));
        let mut session = session(device, &scene, tree, scheduling);
        run("from the roots", &mut session, &frames, &want);
        session.grown()
    };
    let [levels, others] = [Scheduler::Frontier, Scheduler::SelfScheduling].map(grown);
    assert!(levels > others, "{levels} more runs by levels, {others} by workers with stacks");
}

/// The test of a front is a stage of its own, as are the rounds after the first of workers with
/// stacks.
fn check_stages(device: &Device) {
    if !device.info().timestamps {
        return not_run("no timestamps");
    }
    let scene = interpenetrating(64);
    let frames: Vec<_> = (0..4).map(|i| scene.frame(i)).collect();
    for broad_phase in [tree(Volume::Aabb), BroadPhaseMethod::Blocks] {
        for (scheduler, front) in [
            (Scheduler::Frontier, true),
            (Scheduler::Static, true),
            (Scheduler::Static, false),
            (Scheduler::Frontier, false),
        ] {
            let what = format!("{broad_phase}, {scheduler:?}, front {front}");
            let choice = if front { Front::On(FrontOptions::default()) } else { Front::Off };
            let scheduling = Scheduling::default().scheduler(scheduler).front(choice);
            let mut session = session(device, &scene, broad_phase, scheduling);
            session.set_timing(Timing::Stages).expect("timing");
            let mut n_begun = 0;
            for x in frames.windows(2) {
                let begun = session.step(&x[0], &x[1]).expect("a step").front;
                let begun = begun.is_some_and(|front| front.begun > 0);
                let names: Vec<&str> = session.stages().iter().map(|stage| stage.0).collect();
                let has = |part: &str| names.iter().any(|name| name.starts_with(part));
                assert_eq!(has("front "), begun, "{what}: {names:?}");
                assert_eq!(has("balancing "), scheduler == Scheduler::Static, "{what}: {names:?}");
                // Blocks of so few boxes have no level to expand, and a stage without kernels is
                // not listed.
                let by_levels =
                    broad_phase == BroadPhaseMethod::Blocks && scheduler == Scheduler::Frontier;
                assert!(has("pairs ") || by_levels && !front, "{what}: {names:?}");
                assert!(!names.contains(&"block pairs"), "{what}: {names:?}");
                n_begun += begun as u32;
            }
            assert_eq!(n_begun > 0, front, "{what}");
        }
    }
}

/// What was chosen of workers reaches the device: there are as many as were asked for, or the
/// choice is refused; pairs are those of the default with the smallest stacks and batches.
fn check_options(device: &Device) {
    let scene = interpenetrating(64);
    let (frames, want) = steps(&scene, 2, 0);
    let any = WorkerOptions::default();
    for broad_phase in [tree(Volume::Aabb), BroadPhaseMethod::Blocks] {
        let of = |scheduler: Scheduler, workers| {
            Scheduling::default().scheduler(scheduler).workers(workers)
        };
        let mut choices = vec![
            (of(Scheduler::Static, any.workers(32)), 32),
            (of(Scheduler::Static, any.workers(100).stack(1)), 128),
            (of(Scheduler::SelfScheduling, any.workers(16).stack(3)), 16),
        ];
        if device.check_native().is_ok() {
            let least = any.workers(16).batch(1).threshold(1);
            choices.push((of(Scheduler::Stealing, least), 16));
            choices.push((of(Scheduler::LazyStealing, least.batch(64).threshold(1024)), 16));
        }
        for (scheduling, n_workers) in choices {
            let what = format!("{broad_phase}, {scheduling:?}");
            let mut session = session(device, &scene, broad_phase, scheduling);
            run(&what, &mut session, &frames, &want);
            let counts = session.worker_counts().expect("counts");
            assert_eq!(counts.len() % n_workers, 0, "{what}: {}", counts.len());
            assert!((1..=2).contains(&(counts.len() / n_workers)), "{what}: {}", counts.len());
        }
        let options = Options::default().with_broad_phase(broad_phase);
        for (scheduler, workers) in [
            (Scheduler::Static, any.workers(15)),
            (Scheduler::Static, any.batch(4)),
            (Scheduler::Frontier, any.workers(64)),
            (Scheduler::Frontier, any.stack(64)),
        ] {
            let options = options.clone().with_scheduling(of(scheduler, workers));
            let refused = Session::new(device, scene.mesh.clone(), options).err();
            assert!(refused.is_some(), "{scheduler:?}, {workers:?}");
        }
    }
}
