//! A binary tree over boxes: nodes in the numbering of Karras, which every builder gives, so that
//! one refit, one check and every traversal serve them all.
//!
//! Of `n` leaves, in the order in which a walk from left to right meets them, the nodes
//! `0 .. n - 1` are internal, 0 is the root, and leaf `i` is node `n - 1 + i`. An internal node
//! that is a left child has the number of its last leaf, one that is a right child that of its
//! first: no two have the same, whatever the shape of the tree. A leaf's node carries its place in
//! the order, not the id of its box.
//!
//! Every node has a box along the axes. By [`Volume::Obb`] an internal node has an oriented box
//! around the same leaves as well, and what does not reach into it is not looked for below: a
//! second test, of those that the first lets through.

use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::broad_phase::tree::shared_words::Shared;
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::backend::broad_phase::{oriented_nodes, oriented_refit, radix_tree, refit};
use ccd_core::backend::layout::{Branch, Node};
use ccd_core::math::obb::Obb;
use ccd_core::model::method::Volume;
use std::ops::Range;
use std::sync::atomic::AtomicU32;

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
    volume: Volume,
    oriented_words: Vec<AtomicU32>,
    oriented: Vec<Obb>,
    extents: Vec<f64>,
    looseness_at_build: Option<f64>,
    build: u64,
}

impl BinaryTree {
    /// No tree yet; what will bound its nodes.
    pub fn new(volume: Volume) -> Self {
        Self { volume, ..Self::default() }
    }

    /// Whether nodes have oriented boxes, which only the catalogue has.
    fn is_oriented(&self) -> bool {
        cfg!(feature = "catalogue") && self.volume == Volume::Obb
    }

    /// The number of the build; each build has its own.
    pub fn build(&self) -> u64 {
        self.build
    }

    /// All nodes, with the boxes of the last fit.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// Oriented boxes of all internal nodes, by [`Volume::Obb`].
    #[cfg(test)]
    pub fn oriented(&self) -> &[Obb] {
        &self.oriented
    }

    /// Whether leaves below an internal node, whose box along the axes overlaps the query, may do
    /// so, as far as its oriented box tells.
    #[inline]
    pub fn reaches(&self, node: u32, query: &Aabb<f32>) -> bool {
        match self.oriented.get(node as usize) {
            Some(b) => oriented_nodes::reaches(b, query),
            None => true,
        }
    }

    /// The same of the leaves below a node and those below a node of another tree.
    #[inline]
    pub fn reach(&self, node: u32, other: &Self, node_of_other: u32) -> bool {
        !self.is_oriented()
            || oriented_nodes::reach(
                false,
                [node, node_of_other],
                [self.branches.len() as u32, other.branches.len() as u32],
                [0; 2],
                &self.nodes,
                &other.nodes,
                &self.oriented,
                &other.oriented,
            )
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
        self.build += 1;
        for (words, len) in [
            (&mut self.parents, 2 * n),
            (&mut self.visits, n_internal),
            (&mut self.boxes, 2 * n * refit::STRIDE),
        ] {
            words.resize_with(len, AtomicU32::default);
        }
        if self.is_oriented() {
            let len = n_internal * oriented_refit::STRIDE;
            self.oriented_words.resize_with(len, AtomicU32::default);
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
        if self.is_oriented() {
            self.orient(threads, n);
        }
        let looseness = self.looseness(threads);
        let before = *self.looseness_at_build.get_or_insert(looseness);
        if before > 0.0 { looseness / before } else { 1.0 }
    }

    /// Oriented boxes of all internal nodes, from the boxes of the leaves.
    fn orient(&mut self, threads: &Threads, n: usize) {
        self.visits.iter_mut().for_each(|visit| *visit.get_mut() = 0);
        let (parents, visits, words) =
            (Shared(&self.parents), Shared(&self.visits), Shared(&self.oriented_words));
        threads.fill(&mut vec![(); n], |i| {
            oriented_refit::refit(i, &self.nodes, &self.branches, &parents, &visits, &words)
        });
        self.oriented.resize(self.branches.len(), Obb::everything());
        threads.fill(&mut self.oriented, |i| oriented_refit::load(&words, i));
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
            if !self.reaches(walk.node(), query) {
                walk.skip();
                continue;
            }
            visits += 1;
            let found =
                walk.step(query, &self.nodes, &self.branches, self.branches.len() as u32, after);
            out.extend(found.into_iter().filter(|&leaf| leaf != NONE));
        }
        visits
    }
}
