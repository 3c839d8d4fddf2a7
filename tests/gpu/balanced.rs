//! What workers leave is dealt out again by kernels as by a loop: every pair once, in order.

use crate::search::{Buffers, balance};
use crate::support::{bytes, read};
use ccd::gpu::{BroadPhase, Device, Timing};
use ccd::method::{BroadPhaseMethod, Scheduler, Scheduling, Traversal, TreeOptions};
use ccd_core::backend::broad_phase::balanced::{first, left, part, saved, words};
use ccd_core::backend::broad_phase::pair_workers::{LEFT, STACK, listed};
use ccd_core::backend::layout::{Dispatch, Frame, LIST_HEADER, NodeDescent, Params};
use ccd_testkit::generate::{Random, uniform_boxes};

pub const TESTS: crate::Tests =
    &[("balancing", check_balancing), ("stages_of_balancing", check_stages)];

/// What workers have after a round, and where it belongs.
struct Left {
    control: Vec<u32>,
    nodes: Vec<u32>,
    /// The next tasks.
    want: Vec<[u32; 2]>,
}

/// Workers with up to `most` pairs on each stack after round `round` of so many tasks, while there
/// are `spilled` pairs among the next ones already.
fn some(p: &Params<NodeDescent>, tasks: u32, spilled: u32, most: u32) -> Left {
    let (round, workers, capacity) =
        (p.dispatch.first, p.args.workers, p.args.capacity_nodes as usize);
    let mut random = Random::new(tasks + most);
    let mut control = vec![0xabcd; words(workers)];
    control[LEFT] = 0;
    (control[listed(round)], control[listed(round + 1)]) = (tasks, spilled);
    let mut nodes = vec![0; LIST_HEADER + 4 * capacity];
    for (i, word) in nodes[LIST_HEADER..].iter_mut().enumerate() {
        *word = 0x1000_0000 + i as u32;
    }
    let half = |odd: u32| LIST_HEADER + 2 * capacity * odd as usize;
    let (input, output) = (half(round % 2), half(1 - round % 2));
    let entry = |nodes: &[u32], first: usize, i: u32| {
        let word = first + 2 * i as usize;
        [nodes[word], nodes[word + 1]]
    };
    let mut want: Vec<_> = (0..spilled).map(|i| entry(&nodes, output, i)).collect();
    for me in 0..1 << workers {
        // Some have nothing, some all, and one a full stack.
        let n = if me == 2 { most } else { random.below(3) * random.below(most + 1) / 2 };
        let [from, of_part] = part(tasks, me, workers);
        let rest = if me == 3 { of_part } else { random.below(of_part + 1) };
        let word = left(workers, me);
        (control[word], control[word + 1]) = (n, rest);
        for i in 0..n {
            let word = saved(workers, me) + 2 * i as usize;
            (control[word], control[word + 1]) = (me, i);
            want.push([me, i]);
        }
        let not_taken = from + of_part - rest..from + of_part;
        want.extend(not_taken.map(|i| entry(&nodes, input, i)));
    }
    Left { control, nodes, want }
}

fn check_balancing(device: &Device) {
    let capacity = 9000;
    for (workers, round) in [(2, 0), (3, 1), (4, 6), (9, 3), (11, 0)] {
        for (tasks, spilled, most) in [(0, 0, 0), (1, 0, 1), (700, 40, 30), (5000, 3, 5)] {
            let most = if workers < 4 { most.max(STACK / 2) } else { most };
            let args = NodeDescent {
                tasks: NodeDescent::TASKS_BALANCED,
                workers,
                capacity_nodes: capacity,
                ..NodeDescent::default()
            };
            let dispatch = Dispatch { first: round, ..Dispatch::default() };
            for last in [0, 1] {
                let args = NodeDescent { last, ..args };
                let p = Params { frame: Frame::default(), dispatch, args };
                check(device, &p, &some(&p, tasks, spilled, most));
            }
        }
    }
}

fn check(device: &Device, p: &Params<NodeDescent>, given: &Left) {
    let (round, capacity) = (p.dispatch.first, p.args.capacity_nodes);
    let [control, nodes] = [&given.control, &given.nodes].map(|words| bytes(words));
    let mut buffers = Buffers { control, nodes, pairs: Vec::new(), front: Vec::new() };
    balance(device, p, &mut buffers);
    let (control, nodes): (Vec<u32>, Vec<u32>) = (read(&buffers.control), read(&buffers.nodes));
    let what = format!("{} workers after round {round}", 1 << p.args.workers);
    let n = given.want.len() as u32;
    assert_eq!(control[listed(round + 1)], n, "{what}");
    let begin = given.control[listed(round + 1)];
    assert_eq!(control[first(p.args.workers, 0)], begin, "{what}");
    let some = n > begin;
    assert_eq!(control[LEFT], if some && p.args.last == 1 { u32::MAX } else { 0 }, "{what}");
    assert_eq!(nodes[0], if some { n } else { 0 }, "{what}: what the list wants");
    // Beyond the capacity pairs are counted alone.
    let mut want = given.nodes.clone();
    want[0] = nodes[0];
    let from = LIST_HEADER + 2 * (capacity * (1 - round % 2)) as usize;
    for (i, pair) in given.want.iter().take(capacity as usize).enumerate() {
        want[from + 2 * i..from + 2 * i + 2].copy_from_slice(pair);
    }
    let wrong = (0..want.len()).find(|&i| want[i] != nodes[i]);
    assert_eq!(wrong, None, "{what}: a word of the list of {n} pairs");
}

/// Balancing is a stage of its own, after each round of the one in which workers descend.
fn check_stages(device: &Device) {
    let method = BroadPhaseMethod::Tree(TreeOptions::default().traversal(Traversal::CUT));
    let scheduling = Scheduling::default().scheduler(Scheduler::BALANCED);
    let mut broad = BroadPhase::scheduled(device, method, scheduling).unwrap();
    broad.set_timing(Timing::Stages).unwrap();
    let boxes: Vec<_> = uniform_boxes(500).iter().map(|b| b.inflated(0.05)).collect();
    let n = broad.self_pairs(&boxes).unwrap().len();
    assert_eq!(n, ccd_testkit::brute::self_pairs(&boxes).len());
    if !device.info().timestamps {
        return crate::support::not_run("no timestamps");
    }
    let stages = broad.stages();
    assert!(stages.iter().all(|(_, ms)| (0.0..60_000.0).contains(ms)), "{stages:?}");
    let names: Vec<&str> = stages.iter().map(|(name, _)| *name).collect();
    let balancing: Vec<usize> =
        (0..names.len()).filter(|&i| names[i].starts_with("balancing")).collect();
    assert_eq!(balancing.len(), 16, "{names:?}");
    assert!(balancing.iter().all(|&i| names[i - 1].contains("pairs")), "{names:?}");
}
