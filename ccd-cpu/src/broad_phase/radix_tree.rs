//! The binary radix tree on threads: the kernel bodies of `ccd-core` that a GPU runs too, over
//! rayon.

use crate::broad_phase::morton_order::MortonOrder;
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::broad_phase::{morton_key, radix_tree, refit};
use ccd_core::kernel::Words;
use ccd_core::layout::{Branch, Node, Pair};
use std::sync::atomic::{AtomicU32, Ordering};

/// A tree over boxes and what its construction needs; buffers are kept.
#[derive(Debug, Default)]
pub struct RadixTree {
    order: Vec<u32>,
    codes: Vec<[u32; 2]>,
    branches: Vec<Branch>,
    parents: Vec<AtomicU32>,
    visits: Vec<AtomicU32>,
    boxes: Vec<AtomicU32>,
    nodes: Vec<Node>,
    morton: MortonOrder,
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

/// Queries a task.
const CHUNK: usize = 512;

impl RadixTree {
    /// Builds the tree. Fewer than two boxes give a tree without internal nodes.
    pub fn build(&mut self, threads: &Threads, boxes: &[Aabb<f32>]) {
        let n = boxes.len();
        let n_internal = n.saturating_sub(1);
        let grid = self.morton.sort(threads, boxes, None, &mut self.order);
        self.codes.resize(n, [0; 2]);
        threads.fill(&mut self.codes, |i| morton_key::morton(self.order[i] as usize, boxes, &grid));
        self.branches.resize(n_internal, Branch { left: 0, right: 0, first: 0, last: 0 });
        threads.fill(&mut self.branches, |i| radix_tree::branch(i as u32, n as u32, &self.codes));
        for (words, len) in [(&mut self.parents, 2 * n), (&mut self.visits, n_internal), (&mut self.boxes, 2 * n * refit::STRIDE)] {
            words.clear();
            words.resize_with(len, AtomicU32::default);
        }
        let (parents, visits, words) = (Shared(&self.parents), Shared(&self.visits), Shared(&self.boxes));
        let mut done = vec![(); n];
        threads.fill(&mut done[..n_internal], |i| radix_tree::link(i, &self.branches[i], &parents));
        threads.fill(&mut done, |i| refit::refit(i, &boxes[self.order[i] as usize], &self.branches, &parents, &visits, &words));
        self.nodes.resize(n + n_internal, Node { min: [0.0; 3], left: 0, max: [0.0; 3], right: 0 });
        threads.fill(&mut self.nodes, |i| {
            let b = refit::load_box(&words, i);
            let (left, right) = match self.branches.get(i) {
                Some(branch) => (branch.left, branch.right),
                None => (self.order[i - n_internal], Node::LEAF),
            };
            Node { min: b.min, left, max: b.max, right }
        });
    }

    /// Pairs within one set, lesser id first.
    pub fn self_pairs(&mut self, threads: &Threads, boxes: &[Aabb<f32>], out: &mut Vec<Pair>) {
        self.build(threads, boxes);
        let n = if boxes.len() < 2 { 0 } else { boxes.len() };
        self.collect(threads, n, out, |i, pairs| {
            let leaf = self.nodes[self.branches.len() + i];
            self.visit(&leaf.aabb(), i as u32, |other| pairs.push(Pair::ordered(leaf.left, other)));
        });
    }

    /// Pairs of a loose box of `a` with a box of the tree over `b` [Tian and Wan] (section 1.2).
    pub fn pairs(&mut self, threads: &Threads, a: &[Aabb<f32>], b: &[Aabb<f32>], out: &mut Vec<Pair>) {
        self.build(threads, b);
        self.collect(threads, a.len(), out, |i, pairs| match b {
            [] => {}
            [only] => pairs.extend(only.overlaps(&a[i]).then_some(Pair { a: i as u32, b: 0 })),
            _ => self.visit(&a[i], NONE, |other| pairs.push(Pair { a: i as u32, b: other })),
        });
    }

    /// All leaves after leaf `after` that overlap `query`.
    fn visit(&self, query: &Aabb<f32>, after: u32, mut found: impl FnMut(u32)) {
        let mut walk = Walk::new();
        while walk.goes_on {
            let ids = walk.step(query, &self.nodes, &self.branches, self.branches.len() as u32, after);
            ids.into_iter().filter(|&id| id != NONE).for_each(&mut found);
        }
    }

    /// Runs queries `0 .. n` in chunks and joins their pairs in the order of chunks.
    fn collect(&self, threads: &Threads, n: usize, out: &mut Vec<Pair>, query: impl Fn(usize, &mut Vec<Pair>) + Sync) {
        let mut chunks: Vec<Vec<Pair>> = vec![Vec::new(); n.div_ceil(CHUNK)];
        threads.each(&mut chunks, &|k, pairs| {
            for i in k * CHUNK..((k + 1) * CHUNK).min(n) {
                query(i, pairs);
            }
        });
        out.clear();
        chunks.iter().for_each(|chunk| out.extend_from_slice(chunk));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ccd_core::broad_phase::radix_tree::MAX_DEPTH;

    /// Children split the range of their parent, boxes are exactly those of the leaves below, every
    /// box is one leaf, no path is too long.
    fn check_well_formed(tree: &RadixTree, boxes: &[Aabb<f32>]) {
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
            let leaves = (first..=last).map(|leaf| &boxes[tree.order[leaf as usize] as usize]);
            let want = leaves.fold(Aabb::EMPTY, |all, b| all.union(b));
            assert_eq!(tree.nodes[node as usize].aabb(), want, "box of node {node}");
            match tree.branches.get(node as usize) {
                Some(branch) => {
                    let (left, right) = (range(branch.left), range(branch.right));
                    assert_eq!((left.0, left.1 + 1, right.1), (first, right.0, last), "children of node {node}");
                    stack.extend([(branch.left, depth + 1), (branch.right, depth + 1)]);
                }
                None => {
                    assert!(tree.nodes[node as usize].is_leaf());
                    let id = tree.nodes[node as usize].left as usize;
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
            let powers: Vec<_> = (0..n).map(|i| Aabb::of_point([0.5f32.powi(i as i32 % 21), 0.0, 0.0])).collect();
            let equal = vec![Aabb::of_point([1.0; 3]); n];
            for boxes in [random, powers, equal] {
                for threads in [1, 2] {
                    let mut tree = RadixTree::default();
                    let threads = Threads::new(threads).unwrap();
                    threads.enter(|| tree.build(&threads, &boxes));
                    check_well_formed(&tree, &boxes);
                }
            }
        }
    }
}
