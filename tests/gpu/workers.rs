//! The kernels of workers and of fronts, each by itself, over binary trees and over blocks: tasks
//! shared out in every way, stacks, lists and turns of which there are hardly any, fronts of boxes
//! that move.

use crate::scenes::check_pairs;
use crate::search::{CAPACITY, Descends, Search, rules};
use crate::search_blocks::SearchBlocks;
use crate::search_trees::SearchTrees;
use crate::support::{entries, read};
use ccd::Aabb;
use ccd::gpu::{Device, Path};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::broad_phase::pair_workers::{FRONT, LEFT, STACK, listed};
use ccd_core::backend::layout::{LIST_HEADER, NodeDescent};
use ccd_testkit::generate::{Random, uniform_boxes};
use std::time::{Duration, Instant};

pub const TESTS: crate::Tests = &[
    ("workers", check_tree_workers),
    ("workers_of_blocks", check_block_workers),
    ("workers_without_room", check_capacity),
    ("fronts", check_fronts),
];

fn boxes(n: usize, by: f32) -> Vec<Aabb> {
    uniform_boxes(n).iter().map(|b| b.inflated(by)).collect()
}

/// A kind of pairs between boxes: of both sets, or within the second.
fn of_kind<'a>(kind: u32, a: &'a [Aabb], b: &'a [Aabb]) -> [&'a [Aabb]; 3] {
    if kind == 0 { [a, &[], b] } else { [&[], b, &[]] }
}

fn check_tree_workers(device: &Device) {
    let some = boxes(350, 0.04);
    let crowd = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 40];
    let mut batches = [0; 3];
    for all in [&some[..], &some[..2], &some[..1], &crowd] {
        for kind in [0, 1] {
            let trees = SearchTrees::new(device, kind, of_kind(kind, &some[..150], all), false);
            check_workers(device, &trees, &rules(device, trees.width()), &mut batches);
        }
    }
    let again = SearchTrees::new(device, 1, [&[], &some, &[]], false);
    check_batches(device, &again, batches);
}

fn check_block_workers(device: &Device) {
    let some = boxes(6000, 0.02);
    // All of one place: every child meets every other.
    let crowd = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 33 * 32];
    let mut batches = [0; 3];
    for all in [&some[..], &some[..1100], &some[..33], &some[..1], &crowd] {
        for (kind, top) in [(0, 2), (1, 2), (0, 1), (1, 3), (1, 4)] {
            let trees = SearchBlocks::new(kind, of_kind(kind, &some[..5000], all), top);
            check_workers(device, &trees, &rules(device, trees.width()), &mut batches);
        }
    }
    // So many pairs below one task that a deque is full.
    let many = boxes(12_000, 0.002);
    let again = SearchBlocks::new(1, [&[], &many, &[]], 3);
    check_workers(device, &again, &rules(device, again.width()), &mut batches);
    check_batches(device, &again, batches);
}

/// Batches were popped and stolen, and found no room, where workers steal. Whether an owner or a
/// thief comes first is up to the device: a search is repeated until both did.
fn check_batches(device: &Device, again: &dyn Descends, mut batches: [u64; 3]) {
    let native = device.check_native().is_ok();
    // An emulated device whose host is busy may run one workgroup after the other for long.
    let begun = Instant::now();
    while native && batches.contains(&0) && begun.elapsed() < Duration::from_secs(60) {
        check_workers(device, again, &rules(device, again.width()), &mut batches);
    }
    assert!(batches.iter().all(|&n| (n > 0) == native), "popped, stolen, no room: {batches:?}");
}

/// These ways to share out tasks find the pairs of brute force, and expand each pair of nodes once.
/// Adds the batches that workers popped, and stole, and pushes without room.
pub fn check_workers(
    device: &Device,
    trees: &dyn Descends,
    rules: &[(&str, NodeDescent)],
    batches: &mut [u64; 3],
) {
    let (want, width) = (trees.want(), trees.width());
    for &(name, args) in rules {
        let larger = (name.len() % 2) as u32;
        let args = NodeDescent { larger, nodes: 5, ..args };
        let mut search = Search::new(device, trees, args);
        let mut tasks = search.buffers.nodes.clone();
        tasks[..4].copy_from_slice(&search.word(0).to_le_bytes());
        let tasks: Vec<NodePair> = entries(&tasks).iter().map(|p| [p.a, p.b]).collect();
        let n_tasks = tasks.len() as u64;
        let n = trees.below(args, tasks);
        let n_rounds = search.run(args);
        assert!(
            read::<u32>(&search.buffers.nodes)[0] <= CAPACITY,
            "{name}: more tasks than capacity"
        );
        check_pairs(name, want.clone(), entries(&search.buffers.pairs));
        assert_eq!(search.expanded(), n, "{name}: pairs expanded");
        if args.batches > 0 {
            *batches = std::array::from_fn(|i| batches[i] + search.batches()[i] as u64);
        }
        let short = args.turns == 1 && n > (width as u64) << args.workers;
        // So much for each worker that a stack of nine pairs is too small.
        let much = n > 256 << args.workers;
        let spills = args.stack == 0 && n > n_tasks || args.stack == 9 && much;
        assert!(!(short || spills) || n_rounds > 1, "{name}: {n_rounds} rounds");
        if args.idle == 0 && args.stack == STACK && args.turns > 9 {
            assert!(n_rounds <= 1, "{name}: {n_rounds} rounds, and all have room");
        }
    }
}

/// Lists that are too short count what they lack, and nothing is written beyond their ends; what is
/// left after the last round is said.
fn check_capacity(device: &Device) {
    let all = boxes(500, 0.05);
    let trees = SearchTrees::new(device, 1, [&[], &all, &[]], false);
    check_room_of(device, &trees, 30);
    let all = boxes(9000, 0.02);
    check_room_of(device, &SearchBlocks::new(1, [&[], &all, &[]], 2), 10);
    let all = boxes(9000, 0.02);
    check_last(device, &SearchBlocks::new(1, [&[], &all, &[]], 3));
    check_last(device, &trees);
}

fn check_room_of(device: &Device, trees: &dyn Descends, capacity: u32) {
    for (name, args) in rules(device, trees.width()) {
        let short =
            NodeDescent { nodes: 20, capacity_nodes: capacity, stack: args.stack.min(40), ..args };
        let mut search = Search::new(device, trees, short);
        // Words behind both halves of the list.
        let n_words = LIST_HEADER + 4 * capacity as usize;
        search.buffers.nodes.truncate(4 * n_words);
        search.buffers.nodes.extend([0xab; 64]);
        let wanted = search.word(0);
        assert!(wanted > capacity, "{name}: {wanted} tasks");
        assert_eq!(read::<u32>(&search.buffers.nodes)[0], wanted);
        for round in 0..3 {
            search.round(short, round);
        }
        let nodes = &search.buffers.nodes;
        assert_eq!(nodes[4 * n_words..], [0xab; 64], "{name}: written beyond the capacity");
        assert!(read::<u32>(nodes)[0] >= wanted);
    }
}

/// One round, which is the last.
fn check_last(device: &Device, trees: &dyn Descends) {
    for (name, args) in rules(device, trees.width()) {
        let last = NodeDescent { nodes: 20, turns: 1, last: 1, ..args };
        let mut search = Search::new(device, trees, last);
        search.round(last, 0);
        assert!(search.word(listed(1)) > 0, "{name}: nothing is left after a turn");
        assert_eq!(search.word(LEFT), u32::MAX, "{name}");
    }
}

/// Boxes that move further every frame, and back: on each the pairs are those of brute force, and
/// the front has every pair of leaves below it once.
fn check_fronts(device: &Device) {
    let (first, second) = (boxes(260, 0.03), boxes(200, 0.06));
    let (many, others) = (boxes(4000, 0.01), boxes(2600, 0.01));
    let native = device.info().path == Path::Passthrough;
    let n_rules = rules(device, 1).len();
    for k in 0..n_rules {
        let (kind, larger) = ((k / 2 % 2) as u32, (k % 2) as u32);
        let of = |oriented| {
            let of = of_kind(kind, if kind == 0 { &first } else { &[] }, &second);
            SearchTrees::new(device, kind, of, oriented)
        };
        let of_blocks = |top| SearchBlocks::new(kind, of_kind(kind, &many, &others), top);
        let mut all: Vec<Box<dyn Descends>> = vec![Box::new(of(false))];
        if native && k % 3 == 0 {
            all.push(Box::new(of(true)));
        }
        all.push(Box::new(of_blocks(2 + (k % 3) as u32)));
        for trees in all {
            let (name, args) = rules(device, trees.width())[k];
            let args = NodeDescent { nodes: 9, larger, capacity_front: 60_000, ..args };
            check_front(device, name, &*trees, args);
        }
    }
}

fn check_front(device: &Device, name: &str, trees: &dyn Descends, args: NodeDescent) {
    let mut random = Random::new(name.len() as u32);
    let moved = [0.02, 0.3, 0.05].map(|by| trees.moved(&mut random, by));
    let mut search = Search::new(device, trees, args);
    search.run(args);
    let (mut found, mut n_begun) = (vec![0], 0);
    let all = std::iter::once(trees).chain(moved.iter().map(|trees| &**trees));
    for (i, of) in all.enumerate() {
        let args = NodeDescent { written: i as u32 % 2, ..args };
        if i > 0 {
            n_begun += search.word(FRONT);
            search = search.resumed(of, args);
            search.run(args);
        }
        let pairs = entries(&search.buffers.pairs);
        check_pairs(name, of.want(), pairs.clone());
        of.check_covers(&search.written(args));
        found.push(pairs.len());
    }
    // The control: frames have other pairs, so that a front that stayed as it was is seen.
    found.dedup();
    assert!(found.len() > 2 && n_begun > 500, "{name}: {found:?}, {n_begun}");
}
