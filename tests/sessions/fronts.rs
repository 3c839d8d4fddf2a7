//! Fronts are given up by their rules and for memory, and belong to the trees that they were found
//! in. That nothing is lost by it is in the conformance table: rows of schedulers, and `frames/`.

use ccd::method::{
    BroadPhaseMethod, Builder, Front, FrontOptions, Scheduler, Scheduling, Traversal, TreeOptions,
    Volume,
};
use ccd::{Mesh, Options, Session};

type Frame = Vec<[f32; 3]>;

/// Triangles up to `size` that drift, each in its own direction, `speed` a frame; frame by frame.
fn drifting(n: u32, size: f32, speed: f32, n_frames: usize) -> (Mesh, Vec<Frame>) {
    let hash = |i: u32| {
        let x = i.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let x = (x >> ((x >> 28) + 4) ^ x).wrapping_mul(277_803_737);
        ((x >> 22 ^ x) >> 8) as f32 / 16_777_216.0
    };
    let at = |i: u32, frame: usize| -> [f32; 3] {
        std::array::from_fn(|k| {
            let k = k as u32;
            let (from, to) = (hash(8 * (i / 3) + k), hash(8 * (i / 3) + 4 + k) - 0.5);
            from + size * hash(1_000_000 + 3 * i + k) + speed * frame as f32 * to
        })
    };
    let frames = (0..n_frames).map(|f| (0..3 * n).map(|i| at(i, f)).collect()).collect();
    let faces: Vec<_> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    (Mesh::new(3 * n as usize, &faces).expect("triangles"), frames)
}

fn methods() -> Vec<BroadPhaseMethod> {
    let tree = |builder, traversal, volume| {
        let tree = TreeOptions::default().builder(builder).traversal(traversal).volume(volume);
        BroadPhaseMethod::Tree(tree)
    };
    vec![
        BroadPhaseMethod::Blocks,
        tree(Builder::Lbvh, Traversal::SIMULTANEOUS, Volume::Aabb),
        tree(Builder::Lbvh, Traversal::CUT, Volume::Obb),
        tree(Builder::PLOC, Traversal::CUT, Volume::Aabb),
    ]
}

#[test]
fn rules_and_memory_give_fronts_up() {
    let scene = drifting(90, 0.4, 0.01, 8);
    let tree = TreeOptions::default().traversal(Traversal::SIMULTANEOUS);
    let options = |front: FrontOptions, n_threads| {
        let scheduling = Scheduling::default().scheduler(Scheduler::LazyStealing);
        Options::default()
            .with_threads(n_threads)
            .with_broad_phase(BroadPhaseMethod::Tree(tree))
            .with_scheduling(scheduling.front(Front::On(front)))
    };
    let kept = FrontOptions::default().growth(u32::MAX).rebuild(1, 0);
    // Given up whenever it grew at all, and whenever it did not grow tenfold in a search.
    let (grown, unchanged) = (kept.growth(100), kept.rebuild(1, 1000));
    // How long a front is depends on which of two threads comes first, so one counts: the steps of
    // seven that began with a front. The first never does; what it wrote may have had no room.
    let begun = |front| {
        let mut session = Session::new(scene.0.clone(), options(front, 1)).expect("a session");
        let steps = scene.1.windows(2).map(|x| {
            let report = session.step(&x[0], &x[1]).expect("a step");
            report.front.is_some_and(|front| front.begun > 0)
        });
        steps.collect::<Vec<_>>()
    };
    let [all, grown, unchanged] = [kept, grown, unchanged].map(begun);
    assert!(!all[0] && all[2..].iter().all(|begun| *begun), "{all:?}");
    let n = |begun: &[bool]| begun.iter().filter(|begun| **begun).count();
    assert!((1..n(&all)).contains(&n(&grown)), "{grown:?}");
    assert!(n(&unchanged) > 0, "{unchanged:?}");
    assert!(unchanged.windows(2).all(|begun| !(begun[0] && begun[1])), "{unchanged:?}");
    // Fronts of 1500 triangles take more than a MiB: dropped, and not once begun with.
    let (mesh, frames) = drifting(1500, 0.15, 0.002, 4);
    let mut sessions = [1, 64].map(|memory| {
        let options = options(FrontOptions::default().memory(memory), 2);
        Session::new(mesh.clone(), options).expect("a session")
    });
    for x in frames.windows(2) {
        let [little, enough] = sessions.each_mut().map(|session| {
            let report = session.step(&x[0], &x[1]).expect("a step");
            (report.candidates, report.front.expect("fronts are counted"))
        });
        assert!(little.0 == enough.0 && little.0.total() > 1000);
        assert!(little.1.bytes <= 1 << 20 && little.1.bytes < enough.1.bytes, "{little:?}");
        assert!(enough.1.bytes <= 64 << 20);
    }
    let [little, enough] = sessions.map(|session| session.report().front.unwrap_or_default());
    assert!(enough.begun > 1 << 16 && little.begun < enough.begun, "{little:?} {enough:?}");
}

/// The control: a front that is begun with after trees were built anew would be another tree's.
#[test]
fn fronts_are_those_of_their_trees() {
    let (mesh, mut frames) = drifting(90, 0.1, 0.01, 6);
    // In the middle triangles have changed places: trees are built anew, and nothing of before is
    // begun with.
    let other = |i: usize| frames[0][(i / 3 * 37 % 90) * 3 + i % 3];
    let far: Frame = (0..270).map(other).collect();
    frames.splice(3..3, [far.clone(), far.clone(), far]);
    let scheduling = Scheduling::default().front(Front::ON);
    for broad_phase in methods() {
        let options = Options::default()
            .with_threads(1)
            .with_broad_phase(broad_phase)
            .with_scheduling(scheduling);
        let mut session = Session::new(mesh.clone(), options).expect("a session");
        let mut seen = Vec::new();
        for x in frames.windows(2) {
            let report = session.step(&x[0], &x[1]).expect("a step");
            let begun = report.front.expect("fronts are counted").begun > 0;
            assert!(!(report.rebuilt && begun), "{broad_phase}: begun at another tree's front");
            seen.push((report.rebuilt, begun));
        }
        assert!(seen.contains(&(false, true)) && seen[1..].contains(&(true, false)), "{seen:?}");
    }
}
