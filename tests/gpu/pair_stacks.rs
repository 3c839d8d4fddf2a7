//! The kernels of simultaneous traversal with a stack a thread, by themselves: rounds from the
//! pairs of two cuts on, with stacks and turns that are too few, too.

use crate::descent::Trees;
use crate::oriented::{Oriented, slanted};
use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, entries, read, run};
use ccd::gpu::Device;
use ccd::gpu::bind::{DescendStacks, DescendStacksOriented};
use ccd::method::{BroadPhaseMethod, Descent, Traversal, TreeOptions};
use ccd::{Aabb, Options, Pair};
use ccd_core::backend::broad_phase::pair_stacks::CAPACITY;
use ccd_core::backend::layout::{Dispatch, LIST_HEADER, NodeDescent, Params};
use ccd_testkit::brute;
use ccd_testkit::generate::{crumpled_sheet, uniform_boxes};

pub const TESTS: crate::Tests =
    &[("stacks", check_stacks), ("stacks_and_settings", check_settings)];

/// Entries of the lists of a test.
const LONG: u32 = 60_000;
const ROUNDS: usize = 250;

/// One round: the words that count pairs, the list of those that are left, and the pairs found.
struct Round {
    rounds: Vec<u8>,
    output: Vec<u8>,
    pairs: Vec<u8>,
}

/// Runs round `first` of a descent, whose `input` are cuts or a list.
fn round(
    device: &Device,
    trees: &Trees,
    oriented: Option<&[u8]>,
    p: &Params<NodeDescent>,
    input: Vec<u8>,
    Round { rounds, output, pairs }: Round,
) -> Round {
    let [a_nodes, b_nodes] = trees.nodes.clone();
    let n = match p.dispatch.first {
        0 => p.args.nodes * p.args.nodes,
        first => read::<u32>(&rounds)[first as usize],
    };
    match oriented {
        None => {
            let kernel = DescendStacks { a_nodes, b_nodes, input, rounds, output, pairs };
            let DescendStacks { rounds, output, pairs, .. } =
                run(device, kernel, p, n.div_ceil(128));
            Round { rounds, output, pairs }
        }
        Some(boxes) => {
            let oriented = boxes.to_vec();
            let kernel =
                DescendStacksOriented { a_nodes, b_nodes, oriented, input, rounds, output, pairs };
            let DescendStacksOriented { rounds, output, pairs, .. } =
                run(device, kernel, p, n.div_ceil(128));
            Round { rounds, output, pairs }
        }
    }
}

/// All pairs of leaves, and in how many rounds they were found.
fn descend(
    device: &Device,
    trees: &Trees,
    oriented: Option<&[u8]>,
    args: NodeDescent,
) -> (Vec<Pair>, u32) {
    let args = NodeDescent { capacity_nodes: LONG, ..args };
    let mut input = trees.cuts(device, args.nodes);
    let mut last =
        Round { rounds: bytes(&[0u32; ROUNDS + 1]), output: capacity(LONG), pairs: capacity(LONG) };
    for first in 0..ROUNDS as u32 {
        let dispatch = Dispatch { n: 0, first, capacity_in: LONG, capacity_out: LONG };
        let p = trees.params(trees.kind, args, dispatch);
        let before = Round { rounds: last.rounds.clone(), output: capacity(LONG), ..last };
        let done = round(device, trees, oriented, &p, input.clone(), before);
        let n_left = read::<u32>(&done.rounds)[first as usize + 1];
        assert_eq!(read::<u32>(&done.output)[0], n_left, "pairs counted in round {first}");
        if first == 0 {
            // Lists without a place: everything is counted, and nothing is written beyond them.
            let args = NodeDescent { capacity_nodes: 0, ..args };
            let p = trees.params(trees.kind, args, Dispatch { capacity_out: 0, ..dispatch });
            let none = || bytes(&[0u32; LIST_HEADER + 2]);
            let rounds = bytes(&[0u32; ROUNDS + 1]);
            let short = Round { rounds, output: none(), pairs: none() };
            let short = round(device, trees, oriented, &p, input, short);
            let n_found = read::<u32>(&done.pairs)[0];
            assert_eq!(read::<u32>(&short.output), [n_left, 0, 0, 0, 0, 0]);
            assert_eq!(read::<u32>(&short.pairs), [n_found, 0, 0, 0, 0, 0]);
        }
        if n_left == 0 {
            return (entries(&done.pairs), first + 1);
        }
        input = done.output.clone();
        last = done;
    }
    panic!("pairs are left after {ROUNDS} rounds");
}

/// Every pair once, in one round if stacks are high, and in several if they are not.
fn check_stacks(device: &Device) {
    let some: Vec<Aabb> = uniform_boxes(500).iter().map(|b| b.inflated(0.05)).collect();
    let crowd = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 60];
    let whole = NodeDescent { stack: CAPACITY as u32, turns: 1 << 16, ..NodeDescent::default() };
    let low = NodeDescent { stack: 2, ..whole };
    let slow = NodeDescent { turns: 5, ..whole };
    let mut rounds = [0; 3];
    for all in [&some[..], &some[..2], &some[..1], &crowd] {
        let (a, b) = (&some[..300], all);
        let want = [brute::pairs(a, b), brute::self_pairs(all)];
        for (kind, of) in [(0, [a, &[], b]), (1, [&[], all, &[]])] {
            let trees = Trees::new(device, kind, of);
            let choices = [(0, whole, 1), (1, low, 20), (2, slow, 9), (0, whole, 300)];
            for (k, (which, args, nodes)) in choices.into_iter().enumerate() {
                let args = NodeDescent { larger: (k % 2) as u32, nodes, ..args };
                let (found, n_rounds) = descend(device, &trees, None, args);
                rounds[which] = n_rounds.max(rounds[which]);
                check_pairs("by stacks", want[kind as usize].clone(), found);
            }
        }
    }
    assert!(rounds[0] == 1 && rounds[1] > 2 && rounds[2] > 2, "{rounds:?} rounds");
    let boxes = slanted(400, 0.0);
    let trees = Trees::new(device, 1, [&[], &boxes, &[]]);
    let oriented = Oriented::over(device, &boxes).boxes;
    for args in [whole, low] {
        let args = NodeDescent { nodes: 7, ..args };
        let (found, _) = descend(device, &trees, Some(&oriented), args);
        check_pairs("oriented", brute::self_pairs(&boxes), found);
    }
}

/// Steps from cuts of other sizes, by both rules.
fn check_settings(device: &Device) {
    let step = crumpled_sheet(14, 5);
    for (nodes, descent) in [(1, Descent::Larger), (24, Descent::Both), (1024, Descent::Larger)] {
        let traversal = Traversal::CutStacks { nodes, descent };
        let tree = TreeOptions::default().traversal(traversal);
        let options = Options::default().with_broad_phase(BroadPhaseMethod::Tree(tree));
        crate::scenes::check_step(device, &step, options);
    }
}
