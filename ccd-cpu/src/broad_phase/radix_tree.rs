//! Binary radix trees as a source of pairs: one query per leaf, in leaf order, with a stack. Kernel
//! bodies of `ccd-core`, which a GPU runs too, over rayon.
//!
//! Leaves of the nodes carry their place in the order, not the id of their box.

use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
use crate::broad_phase::morton_order::MortonOrder;
use crate::broad_phase::pair_source::{Fixed, PairSink, PairSource};
use crate::broad_phase::scheduler::share;
use crate::simd::{RowSimd, WIDTH, Work};
use crate::threads::{Own, Threads};
use ccd_core::Aabb;
use ccd_core::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::broad_phase::{morton_key, radix_tree, refit};
use ccd_core::kernel::Words;
use ccd_core::layout::{Branch, Node};
use std::sync::atomic::{AtomicU32, Ordering};

/// A tree per set that is searched, and the hits of each worker's query.
#[derive(Debug, Default)]
pub struct RadixSource {
    trees: Vec<RadixTree>,
    morton: MortonOrder,
    hits: Vec<Own<Vec<u32>>>,
}

/// A tree over boxes and what its construction needs; fewer than two boxes give a tree without
/// internal nodes.
#[derive(Debug, Default)]
struct RadixTree {
    codes: Vec<[u32; 2]>,
    branches: Vec<Branch>,
    parents: Vec<AtomicU32>,
    visits: Vec<AtomicU32>,
    boxes: Vec<AtomicU32>,
    nodes: Vec<Node>,
    extents: Vec<f64>,
    looseness_at_build: Option<f64>,
}

/// Queries a task: some thousand tasks where there are many.
const CHUNK: usize = 128;

impl PairSource for RadixSource {
    /// Fixed boxes are not told apart: the tree needs codes in order, so that no subtrees of them
    /// arise that could be left out; the sink's rule takes their pairs away.
    fn sort(
        &mut self,
        threads: &Threads,
        set: Set,
        boxes: &[Aabb<f32>],
        _fixed: Option<Fixed>,
        order: &mut Vec<u32>,
    ) {
        if self.trees.len() <= set.index {
            self.trees.resize_with(set.index + 1, RadixTree::default);
        }
        let grid = self.morton.sort(threads, boxes, None, order);
        if set.searched {
            let code = |i: usize| morton_key::morton(order[i] as usize, boxes, &grid);
            self.trees[set.index].link(threads, boxes.len(), code);
        }
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        let set = leaves.set();
        if set.searched { self.trees[set.index].fit(threads, leaves) } else { 1.0 }
    }

    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        (a, b): (&LeafBoxes, Option<&LeafBoxes>),
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    ) {
        let (within, searched) = (b.is_none(), b.unwrap_or(a));
        if a.is_empty() || searched.is_empty() {
            return;
        }
        assert!(searched.set().searched, "there is no tree over this set");
        let tree = &self.trees[searched.set().index];
        self.hits.resize_with(workers.len(), || Own(Vec::with_capacity(1024)));
        let after = |leaf: usize| if within { leaf as u32 } else { NONE };
        let queries = |k: usize, worker: &mut K::Worker, Own(hits): &mut Own<Vec<u32>>| {
            for leaf in k * CHUNK..((k + 1) * CHUNK).min(a.len()) {
                hits.clear();
                tree.query(&a.get(leaf), after(leaf), hits);
                crate::simd::run_rows!(Rows { leaf, hits, sink, worker });
            }
        };
        let n_tasks = a.len().div_ceil(CHUNK);
        share(threads, n_tasks, part, sink, workers, &mut self.hits, &queries);
    }
}

/// The hits of one query as rows: those in one block that follow each other together. (Sorting them
/// first would make fewer rows, and takes longer than the rows that it saves.)
struct Rows<'a, K: PairSink> {
    leaf: usize,
    hits: &'a [u32],
    sink: &'a K,
    worker: &'a mut K::Worker,
}

impl<S: RowSimd, K: PairSink> Work<S> for Rows<'_, K> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let (a, lane) = (self.leaf / WIDTH, self.leaf % WIDTH);
        let mut i = 0;
        while i < self.hits.len() {
            let b = self.hits[i] as usize / WIDTH;
            let mut mask = 0;
            while i < self.hits.len() && self.hits[i] as usize / WIDTH == b {
                mask |= 1 << (self.hits[i] as usize % WIDTH);
                i += 1;
            }
            self.sink.row(self.worker, simd, a, lane, b, mask);
        }
    }
}

/// Atomic words as kernels see them.
#[derive(Clone, Copy)]
struct Shared<'a>(&'a [AtomicU32]);

impl Words for Shared<'_> {
    fn load(&self, i: usize) -> u32 {
        self.0[i].load(Ordering::Relaxed)
    }
    fn store(&self, i: usize, value: u32) {
        self.0[i].store(value, Ordering::Relaxed);
    }
    fn add_acquire_release(&self, i: usize, value: u32) -> u32 {
        self.0[i].fetch_add(value, Ordering::AcqRel)
    }
}

impl RadixTree {
    /// Builds the nodes over `n` leaves of these codes, without boxes.
    fn link(&mut self, threads: &Threads, n: usize, code: impl Fn(usize) -> [u32; 2] + Sync) {
        let n_internal = n.saturating_sub(1);
        self.looseness_at_build = None;
        self.codes.resize(n, [0; 2]);
        threads.fill(&mut self.codes, code);
        self.branches.resize(n_internal, Branch { left: 0, right: 0, first: 0, last: 0 });
        threads.fill(&mut self.branches, |i| radix_tree::branch(i as u32, n as u32, &self.codes));
        for (words, len) in [
            (&mut self.parents, 2 * n),
            (&mut self.visits, n_internal),
            (&mut self.boxes, 2 * n * refit::STRIDE),
        ] {
            words.resize_with(len, AtomicU32::default);
        }
        let parents = Shared(&self.parents);
        threads
            .fill(&mut vec![(); n_internal], |i| radix_tree::link(i, &self.branches[i], &parents));
    }

    /// Boxes of all nodes, from those of the leaves. Returns how much looser inner nodes have
    /// become since the first time after [`RadixTree::link`].
    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        let (n, n_internal) = (leaves.len(), self.branches.len());
        self.visits.iter_mut().for_each(|visit| *visit.get_mut() = 0);
        let (parents, visits, words) =
            (Shared(&self.parents), Shared(&self.visits), Shared(&self.boxes));
        threads.fill(&mut vec![(); n], |i| {
            refit::refit(i, &leaves.get(i), &self.branches, &parents, &visits, &words)
        });
        self.nodes.resize(n + n_internal, Node { min: [0.0; 3], left: 0, max: [0.0; 3], right: 0 });
        threads.fill(&mut self.nodes, |i| {
            let b = refit::load_box(&words, i);
            let (left, right) = match self.branches.get(i) {
                Some(branch) => (branch.left, branch.right),
                None => ((i - n_internal) as u32, Node::LEAF),
            };
            Node { min: b.min, left, max: b.max, right }
        });
        let looseness = self.looseness(threads);
        let before = *self.looseness_at_build.get_or_insert(looseness);
        if before > 0.0 { looseness / before } else { 1.0 }
    }

    /// Sum of the side lengths of all inner nodes, relative to that of the leaves; the order of
    /// additions does not depend on threads.
    fn looseness(&mut self, threads: &Threads) -> f64 {
        let Self { nodes, extents, branches, .. } = self;
        extents.resize(nodes.len(), 0.0);
        threads.fill(extents, |i| {
            (0..3).map(|k| nodes[i].max[k] as f64 - nodes[i].min[k] as f64).sum()
        });
        let (inner, leaves) = extents.split_at(branches.len());
        let (inner, leaves) = (inner.iter().sum::<f64>(), leaves.iter().sum::<f64>());
        if leaves > 0.0 { inner / leaves } else { 1.0 }
    }

    /// Appends all leaves after leaf `after` ([`NONE`]: all leaves) that overlap `query`: from left
    /// to right, but that a right child which is a leaf comes before what is below its sibling.
    fn query(&self, query: &Aabb<f32>, after: u32, out: &mut Vec<u32>) {
        if self.branches.is_empty() {
            out.extend((after == NONE && self.nodes[0].aabb().overlaps(query)).then_some(0));
            return;
        }
        let mut walk = Walk::new();
        while walk.goes_on {
            let found =
                walk.step(query, &self.nodes, &self.branches, self.branches.len() as u32, after);
            out.extend(found.into_iter().filter(|&leaf| leaf != NONE));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ccd_core::broad_phase::radix_tree::MAX_DEPTH;

    /// Children split the range of their parent, boxes are exactly those of the leaves below, every
    /// box is one leaf, no path is too long.
    fn check_well_formed(tree: &RadixTree, order: &[u32], boxes: &[Aabb<f32>]) {
        let n_internal = boxes.len() - 1;
        let mut seen = vec![false; boxes.len()];
        let range = |node: u32| match tree.branches.get(node as usize) {
            Some(branch) => (branch.first, branch.last),
            None => (node - n_internal as u32, node - n_internal as u32),
        };
        let mut stack = vec![(0u32, 1usize)];
        while let Some((node, depth)) = stack.pop() {
            assert!(depth <= MAX_DEPTH, "a path of {depth} nodes");
            let (first, last) = range(node);
            let leaves = (first..=last).map(|leaf| &boxes[order[leaf as usize] as usize]);
            let want = leaves.fold(Aabb::EMPTY, |all, b| all.union(b));
            assert_eq!(tree.nodes[node as usize].aabb(), want, "box of node {node}");
            match tree.branches.get(node as usize) {
                Some(branch) => {
                    let (left, right) = (range(branch.left), range(branch.right));
                    assert_eq!(
                        (left.0, left.1 + 1, right.1),
                        (first, right.0, last),
                        "children of node {node}"
                    );
                    stack.extend([(branch.left, depth + 1), (branch.right, depth + 1)]);
                }
                None => {
                    assert!(tree.nodes[node as usize].is_leaf());
                    assert_eq!(tree.nodes[node as usize].left, first, "place of a leaf");
                    let id = order[first as usize] as usize;
                    assert!(!std::mem::replace(&mut seen[id], true), "box {id} is two leaves");
                }
            }
        }
        assert!(seen.iter().all(|&s| s), "a box is no leaf");
    }

    #[test]
    fn trees_are_well_formed() {
        let mut x = 5u32;
        let mut unit = || {
            x = x.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (x >> 8) as f32 / 16_777_216.0
        };
        for n in [2usize, 3, 10, 1000, 5000] {
            let random: Vec<_> = (0..n).map(|_| Aabb::of_point([unit(), unit(), unit()])).collect();
            // Codes that differ in one bit each, and codes that do not differ at all: the deepest
            // trees.
            let powers: Vec<_> =
                (0..n).map(|i| Aabb::of_point([0.5f32.powi(i as i32 % 21), 0.0, 0.0])).collect();
            let equal = vec![Aabb::of_point([1.0; 3]); n];
            for mut boxes in [random, powers, equal] {
                for threads in [1, 2] {
                    let mut source = RadixSource::default();
                    let mut leaves = LeafBoxes::new(Set { index: 0, searched: true });
                    let threads = Threads::new(threads).unwrap();
                    threads.enter(|| leaves.build(&threads, &mut source, &boxes, None));
                    check_well_formed(&source.trees[0], leaves.order(), &boxes);
                    boxes.iter_mut().for_each(|b| b.max[1] += unit());
                    threads.enter(|| leaves.refit(&threads, &mut source, &boxes));
                    check_well_formed(&source.trees[0], leaves.order(), &boxes);
                }
            }
        }
    }
}
