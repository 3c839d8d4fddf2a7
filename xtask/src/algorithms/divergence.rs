//! How far threads side by side diverge: the steps of every thread of a method on a GPU, by the
//! bodies of its kernels, which run here on the CPU.
//!
//! *Active lanes* are the sum of the steps of all threads, over 32 times the sum over groups of 32
//! threads of the steps of the longest: what of such a group is at work in the mean of its steps.
//! *Lanes a box* are that denominator over the number of boxes: what a device spends, idle or not.

use super::scenes::Case;
use crate::markdown::{Table, digits};
use ccd::Aabb;
use ccd::method::{Descent, Traversal};
use ccd_core::backend::broad_phase::grid_rows::{CELL_BITS, LEVELS};
use ccd_core::backend::broad_phase::key_intervals::{
    self, CHUNK, FOUND, GROUP, SURVEY_WORDS, SWEEP_AND_PRUNE, UNIFORM_GRID, asked_cell,
    asked_level, interval, lower_bound, rows, rows_a_step, rows_taken, step_of,
};
use ccd_core::backend::broad_phase::morton_key::{Curve, order_key, shared_word, sort_key};
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair, expand};
use ccd_core::backend::broad_phase::pair_stacks::{CAPACITY, PairStack};
use ccd_core::backend::broad_phase::radix_tree::{branch, last_of_left};
use ccd_core::backend::broad_phase::recursive::Calls;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::broad_phase::sweep_and_prune::Moments;
use ccd_core::backend::broad_phase::sweep_by_end_points as end_points;
use ccd_core::backend::broad_phase::uniform_grid::Sizes;
use ccd_core::backend::broad_phase::wide_nodes::{LeafDescent, WideWalk, wide_node};
use ccd_core::backend::layout::{Branch, EDGE_EDGE, Node, WideNode};
use ccd_core::math::morton::MortonGrid;
use std::fmt::Write;

/// Threads that a device runs in step.
const LANES: usize = 32;
/// The set that all boxes are of.
const SET: usize = 1;

/// Steps of all threads, and steps of groups of 32 times 32.
#[derive(Clone, Copy, Default)]
struct Steps {
    active: u64,
    taken: u64,
    pairs: u64,
}

impl Steps {
    /// By the steps of each thread, in their order.
    fn of(threads: &[u64], pairs: u64) -> Self {
        let longest = threads.chunks(LANES).map(|group| group.iter().max().copied().unwrap_or(0));
        Self { active: threads.iter().sum(), taken: LANES as u64 * longest.sum::<u64>(), pairs }
    }
}

/// A table for each case of boxes among themselves; every method must find its pairs.
pub fn tables(cases: &[Case]) -> Result<String, String> {
    let mut text = String::new();
    for case in cases.iter().filter(|case| case.against.is_none()) {
        let columns = ["method: a thread each", "steps a box", "active lanes", "lanes a box"];
        let mut table = Table::new(columns);
        let mut row = |name: &str, steps: Steps| -> Result<(), String> {
            let Steps { active, taken, pairs } = steps;
            if pairs != case.n_pairs as u64 {
                let (scene, right) = (&case.name, case.n_pairs);
                return Err(format!("{scene}: {pairs} pairs by {name}, right are {right}"));
            }
            let n = case.boxes.len() as f64;
            let [of_box, lanes] = [active, taken].map(|sum| digits(sum as f64 / n));
            let share = 100.0 * active as f64 / taken as f64;
            let places = (share < 10.0) as usize;
            table.row([name.into(), of_box, format!("{share:.places$} %"), lanes]);
            Ok(())
        };
        row("sweep-by-end-points: end point", by_end_points(&case.boxes))?;
        let [alone, tiles] = by_keys(SWEEP_AND_PRUNE, &case.boxes);
        row("sweep by starts: box", alone)?;
        row("sweep-and-prune: box, in tiles", tiles)?;
        let [alone, tiles] = by_keys(UNIFORM_GRID, &case.boxes);
        row("grid: box", alone)?;
        row("uniform-grid: box, in tiles", tiles)?;
        let tree = Tree::new(&case.boxes);
        row("recursive: box", tree.recursive())?;
        row("iterative: box", tree.queries(Traversal::Iterative))?;
        row("leaf-order: leaf", tree.queries(Traversal::LeafOrder))?;
        row("half: leaf", tree.queries(Traversal::Half))?;
        row("cut-stacks: pair of the cut", tree.stacks())?;
        row("cut: pair of a level", tree.levels())?;
        let _ = writeln!(text, "{}\n\n{table}", case.title());
    }
    Ok(text)
}

/// The sweep with a thread an end point.
fn by_end_points(boxes: &[Aabb<f32>]) -> Steps {
    let axis = Moments::<f64>::of(0, boxes.len(), boxes).axes()[0] as u32;
    let of_box = |i: u32| {
        let keys = end_points::keys(SET as u32, &boxes[i as usize], axis);
        keys.into_iter().zip(end_points::points(i))
    };
    let mut all: Vec<(u32, u32)> = (0..boxes.len() as u32).flat_map(of_box).collect();
    all.sort_by_key(|&(key, _)| key);
    let points: Vec<u32> = all.into_iter().map(|(_, point)| point).collect();
    let (mut threads, mut pairs) = (Vec::with_capacity(points.len()), 0);
    for k in 0..points.len() as u32 {
        let (mut walk, mut n) = (end_points::Walk::new(&points, k), 0);
        let query = &boxes[walk.box_idx() as usize];
        while walk.goes_on {
            let other = walk.step(&points);
            n += 1;
            pairs += (other != NONE && query.overlaps(&boxes[other as usize])) as u64;
        }
        threads.push(n);
    }
    Steps::of(&threads, pairs)
}

/// A method by keys: with a thread a box, which goes through the boxes in its intervals one after
/// the other, and as it is, in tiles, where a lane is active if the box is in its interval.
fn by_keys(method: u32, boxes: &[Aabb<f32>]) -> [Steps; 2] {
    let bounds = boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
    let sizes = boxes.iter().fold(Sizes::NONE, |all, b| all.merged(&Sizes::of(b)));
    let mut survey = [0; SURVEY_WORDS];
    (0..6).for_each(|k| survey[k] = shared_word(&bounds, k));
    match method {
        SWEEP_AND_PRUNE => {
            survey[FOUND] = Moments::<f64>::of(0, boxes.len(), boxes).axes()[0] as u32;
        }
        _ => (0..3).for_each(|k| survey[FOUND + k] = order_key(sizes.half[k])),
    }
    let key = |b: &Aabb<f32>| key_intervals::key(method, SET as u32, b, &survey);
    let mut order: Vec<(u32, Aabb<f32>)> = boxes.iter().map(|b| (key(b), *b)).collect();
    order.sort_by_key(|&(key, _)| key);
    let keys: Vec<u32> = order.iter().map(|&(key, _)| key).collect();
    let n = keys.len() as u32;
    let range = |row: u32, i: u32| -> [u32; 2] {
        let (key, b) = &order[i as usize];
        let (set, step) = (SET as u32, step_of(method, row));
        let level = asked_level(method, row, step, *key);
        let cell = asked_cell(method, step, *key, b, &survey);
        let [from, to] = interval(method, EDGE_EDGE, row, set, *key, b, &survey, level, cell);
        if from > to {
            return [0, 0];
        }
        let first = lower_bound(&keys, n, from).max(i + 1);
        [first, lower_bound(&keys, n, to + 1).max(first)]
    };
    let n_rows = rows(method, EDGE_EDGE);
    // Rows that a box takes of all, by how many boxes the level has that it asks.
    let n_boxes: Vec<u32> = (0..=LEVELS)
        .map(|level| {
            let first = (SET as u32) << key_intervals::BITS;
            let [first, end] = [level, level + 1].map(|l| first + (l << CELL_BITS));
            lower_bound(&keys, n, end) - lower_bound(&keys, n, first)
        })
        .collect();
    let range = |row: u32, i: u32| {
        let (step, r) = (row / rows_a_step(method), row % rows_a_step(method));
        let level = asked_level(method, row, step, keys[i as usize]);
        let n_boxes = if level < LEVELS { n_boxes[level as usize] } else { 0 };
        let [first, end] = rows_taken(method, n_boxes);
        if first <= r && r < end { range(row, i) } else { [0, 0] }
    };
    let of_box = |i: u32| (0..n_rows).map(|row| range(row, i)).map(|[a, b]| (b - a) as u64).sum();
    let threads: Vec<u64> = (0..n).map(of_box).collect();
    let tests: u64 = threads.iter().sum();
    let (mut pairs, mut taken) = (0, 0);
    for row in 0..n_rows {
        for first in (0..n).step_by(GROUP as usize) {
            let group = first..(first + GROUP).min(n);
            let ranges: Vec<[u32; 2]> = group.map(|i| range(row, i)).collect();
            for (i, [a, b]) in (first..).zip(&ranges) {
                let query = &order[i as usize].1;
                let others = order[*a as usize..*b as usize].iter();
                pairs += others.filter(|(_, b)| query.overlaps(b)).count() as u64;
            }
            let some = || ranges.iter().filter(|[a, b]| a < b);
            let begin = some().map(|r| r[0]).min().unwrap_or(0);
            let end = some().map(|r| r[1]).max().unwrap_or(0);
            let chunks = (begin..end).step_by(CHUNK as usize);
            let tiles = chunks.map(|c| (end - c).min(CHUNK).div_ceil(GROUP)).sum::<u32>();
            // Each tile is compared with all threads of the group.
            taken += tiles as u64 * (GROUP * GROUP) as u64;
        }
    }
    [Steps::of(&threads, pairs), Steps { active: tests, taken, pairs }]
}

/// A tree as a device has it: from codes of 30 bits, with the boxes of both children in a record.
struct Tree<'a> {
    boxes: &'a [Aabb<f32>],
    order: Vec<u32>,
    branches: Vec<Branch>,
    nodes: Vec<Node>,
    wide: Vec<WideNode>,
}

impl<'a> Tree<'a> {
    fn new(boxes: &'a [Aabb<f32>]) -> Self {
        let (n, bounds) = (boxes.len(), boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b)));
        let grid = MortonGrid::new(&bounds, 10);
        let key = |i: u32| sort_key(i as usize, SET, boxes, &grid, Curve::Morton);
        let mut order: Vec<u32> = (0..n as u32).collect();
        order.sort_by_key(|&i| key(i));
        let codes: Vec<u32> = order.iter().map(|&i| key(i)).collect();
        let branches: Vec<Branch> =
            (0..n as u32 - 1).map(|i| branch(i, n as u32, &codes)).collect();
        let empty = Node { min: [0.0; 3], left: 0, max: [0.0; 3], right: 0 };
        let mut nodes = vec![empty; 2 * n - 1];
        for (k, &i) in order.iter().enumerate() {
            let b = &boxes[i as usize];
            nodes[n - 1 + k] = Node { min: b.min, left: i, max: b.max, right: Node::LEAF };
        }
        // A node has more leaves than its children.
        let mut up: Vec<usize> = (0..n - 1).collect();
        up.sort_by_key(|&i| branches[i].last - branches[i].first);
        for i in up {
            let Branch { left, right, .. } = branches[i];
            let both = nodes[left as usize].aabb().union(&nodes[right as usize].aabb());
            nodes[i] = Node { min: both.min, left, max: both.max, right };
        }
        let record = |b: &Branch| {
            let [left, right] = [b.left, b.right].map(|child| nodes[child as usize].aabb());
            wide_node(b, last_of_left(b, n as u32 - 1), n as u32 - 1, &left, &right)
        };
        let wide = branches.iter().map(record).collect();
        Self { boxes, order, branches, nodes, wide }
    }

    /// Of pairs that are found from both sides, and boxes from themselves, those of a greater id.
    fn is_kept(&self, i: u32, leaf: u32) -> bool {
        leaf != NONE && self.order[leaf as usize] > i
    }

    fn recursive(&self) -> Steps {
        let (mut threads, mut pairs) = (Vec::new(), 0);
        for (i, query) in (0..).zip(self.boxes) {
            let (mut calls, mut n) = (Calls::new(), 0);
            while calls.goes_on {
                let leaf = calls.step(&self.wide[calls.node as usize], query);
                n += 1;
                pairs += self.is_kept(i, leaf) as u64;
            }
            threads.push(n);
        }
        Steps::of(&threads, pairs)
    }

    fn queries(&self, traversal: Traversal) -> Steps {
        let (mut threads, mut pairs) = (Vec::new(), 0);
        let half = traversal == Traversal::Half;
        for k in 0..self.boxes.len() as u32 {
            let by_input = traversal == Traversal::Iterative;
            let i = if by_input { k } else { self.order[k as usize] };
            let query = &self.boxes[i as usize];
            let (mut walk, mut n) = (WideWalk::new(), 0);
            let mut descent = LeafDescent::to(k);
            loop {
                while half && descent.goes_on(&walk) {
                    let node = &self.wide[descent.node as usize];
                    pairs += (descent.step(node, query, &mut walk) != NONE) as u64;
                    n += 1;
                }
                if half {
                    walk.take();
                }
                while walk.goes_on {
                    let found = walk.step(&self.wide[walk.node as usize], query);
                    let kept = |leaf: &u32| *leaf != NONE && (half || self.is_kept(i, *leaf));
                    pairs += found.iter().filter(|&leaf| kept(leaf)).count() as u64;
                    n += 1;
                }
                if !half || descent.is_done {
                    break;
                }
            }
            threads.push(n);
        }
        Steps::of(&threads, pairs)
    }

    /// Pairs of nodes that the pair is expanded into, and how many pairs of leaves; a pair of the
    /// cut may be one of leaves already.
    fn expanded(&self, pair: NodePair) -> (impl Iterator<Item = NodePair>, u64) {
        let n_internal = self.branches.len() as u32;
        let is_leaf = move |pair: &NodePair| pair[0] >= n_internal && pair[1] >= n_internal;
        let all = expand(Descent::Both, true, &self.nodes, &self.nodes, pair).met;
        let some = all.into_iter().filter(|&pair| pair != NO_PAIR);
        let n_leaves = some.clone().filter(is_leaf).count() as u64 + is_leaf(&pair) as u64;
        (some.filter(move |pair| !is_leaf(pair)), n_leaves)
    }

    /// A cut of 256 nodes, as a kernel makes it.
    fn cut(&self) -> Vec<u32> {
        let (most, mut cut) = (256, vec![0]);
        let share = self.boxes.len() / most;
        for _ in 0..32 {
            for k in 0..cut.len() {
                let Some(branch) = self.branches.get(cut[k] as usize) else { continue };
                if (branch.last - branch.first) as usize >= share && cut.len() < most {
                    cut[k] = branch.left;
                    cut.push(branch.right);
                }
            }
        }
        cut
    }

    /// Pairs of a cut that meet, by the number of their thread.
    fn of_cut(&self) -> impl Iterator<Item = Option<NodePair>> {
        let cut = self.cut();
        (0..cut.len() * cut.len()).map(move |k| {
            let (i, j) = (k / cut.len(), k % cut.len());
            let [x, y] = [cut[i], cut[j]].map(|node| &self.nodes[node as usize]);
            let meets = i < j || i == j && !x.is_leaf();
            (meets && x.aabb().overlaps(&y.aabb())).then_some([cut[i], cut[j]])
        })
    }

    fn stacks(&self) -> Steps {
        let (mut threads, mut pairs) = (Vec::new(), 0);
        for first in self.of_cut() {
            let (mut stack, mut n) = (PairStack::new(), 0);
            first.iter().for_each(|&pair| assert!(stack.push(pair, CAPACITY as u32)));
            loop {
                let pair = stack.pop();
                if pair == NO_PAIR {
                    break;
                }
                n += 1;
                let (inner, n_leaves) = self.expanded(pair);
                pairs += n_leaves;
                inner.for_each(|pair| assert!(stack.push(pair, CAPACITY as u32), "a full stack"));
            }
            threads.push(n);
        }
        Steps::of(&threads, pairs)
    }

    fn levels(&self) -> Steps {
        let (mut all, mut level) = (Steps::default(), self.of_cut().flatten().collect::<Vec<_>>());
        while !level.is_empty() {
            all.active += level.len() as u64;
            all.taken += level.len().next_multiple_of(LANES) as u64;
            let mut next = Vec::new();
            for pair in level {
                let (inner, n_leaves) = self.expanded(pair);
                all.pairs += n_leaves;
                next.extend(inner);
            }
            level = next;
        }
        all
    }
}
