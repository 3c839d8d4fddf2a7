//! A binary tree over boxes: nodes in the numbering of Karras, which every builder gives, so that
//! one refit, one check and every traversal serve them all.
//!
//! Of `n` leaves, in the order in which a walk from left to right meets them, the nodes
//! `0 .. n - 1` are internal, 0 is the root, and leaf `i` is node `n - 1 + i`. An internal node that is a left
//! child has the number of its last leaf, one that is a right child that of its first: no two have
//! the same, whatever the shape of the tree. A leaf's node carries its place in the order, not the
//! id of its box.

use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::broad_phase::{radix_tree, refit};
use ccd_core::kernel::Words;
use ccd_core::layout::{Branch, Node};
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering};

/// A tree over boxes and what its refit needs; fewer than two boxes give a tree without internal
/// nodes.
#[derive(Debug, Default)]
pub struct BinaryTree {
    /// What its builder fills: children and ranges of the internal nodes.
    pub branches: Vec<Branch>,
    parents: Vec<AtomicU32>,
    visits: Vec<AtomicU32>,
    boxes: Vec<AtomicU32>,
    nodes: Vec<Node>,
    extents: Vec<f64>,
    looseness_at_build: Option<f64>,
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

impl BinaryTree {
    /// All nodes, with the boxes of the last fit.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The leaves below a node.
    #[inline]
    pub fn range(&self, node: u32) -> Range<u32> {
        match self.branches.get(node as usize) {
            Some(branch) => branch.first..branch.last + 1,
            None => {
                let leaf = node - self.branches.len() as u32;
                leaf..leaf + 1
            }
        }
    }

    /// Takes the branches over `n` leaves that a builder has filled.
    pub fn link(&mut self, threads: &Threads, n: usize) {
        let n_internal = n.saturating_sub(1);
        assert_eq!(self.branches.len(), n_internal, "branches over {n} leaves");
        self.looseness_at_build = None;
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
    /// become since the first time after [`BinaryTree::link`].
    pub fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
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

    /// Appends all leaves after leaf `after` ([`NONE`]: all leaves) that overlap `query`: in an
    /// order that depends on the tree alone. Returns the number of internal nodes visited.
    pub fn query(&self, query: &Aabb<f32>, after: u32, out: &mut Vec<u32>) -> u64 {
        if self.branches.is_empty() {
            out.extend((after == NONE && self.nodes[0].aabb().overlaps(query)).then_some(0));
            return 0;
        }
        let (mut walk, mut visits) = (Walk::new(), 0);
        while walk.goes_on {
            visits += 1;
            let found =
                walk.step(query, &self.nodes, &self.branches, self.branches.len() as u32, after);
            out.extend(found.into_iter().filter(|&leaf| leaf != NONE));
        }
        visits
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::leaf_boxes::Set;
    use crate::broad_phase::tree::TreeSource;
    use ccd_core::broad_phase::radix_tree::MAX_DEPTH;
    use ccd_core::model::method::TreeOptions;

    /// Children split the range of their parent and have the numbers that traversals rely on, boxes
    /// are exactly those of the leaves below, every box is one leaf, no path is too long.
    fn check_well_formed(tree: &BinaryTree, order: &[u32], boxes: &[Aabb<f32>]) {
        let n_internal = boxes.len() as u32 - 1;
        let mut seen = vec![false; boxes.len()];
        let range = |node: u32| (tree.range(node).start, tree.range(node).end - 1);
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
                    let number = |child, leaf| {
                        child == if child < n_internal { leaf } else { n_internal + leaf }
                    };
                    assert!(
                        number(branch.left, left.1) && number(branch.right, right.0),
                        "numbers of the children of node {node}"
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
                    let mut source = TreeSource::new(TreeOptions::default()).unwrap();
                    let mut leaves = LeafBoxes::new(Set { index: 0, searched: true });
                    let threads = Threads::new(threads).unwrap();
                    threads.enter(|| leaves.build(&threads, &mut source, &boxes, None));
                    check_well_formed(source.tree(0), leaves.order(), &boxes);
                    boxes.iter_mut().for_each(|b| b.max[1] += unit());
                    threads.enter(|| leaves.refit(&threads, &mut source, &boxes));
                    check_well_formed(source.tree(0), leaves.order(), &boxes);
                }
            }
        }
    }
}
