//! Simultaneous traversal of binary trees from a cut on: pairs of nodes, which a scheduler shares
//! out among workgroups.
//!
//! ```text
//!   cut a  cut b          pairs of nodes: tasks of the scheduler
//!     all pairs   ------>      |
//!   that overlap           pairs of leaves: found
//! ```
//!
//! A cut is there because one pair of roots is no work for a thousand workgroups. With a front it
//! is made only where none is kept.

use super::binary_tree::BinaryTree;
use super::descended::{BinaryTrees, Descended, Trees, Written};
use super::scheduled::Scheduled;
use crate::bind::{CutNodes, CutPairs};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::block_bvh::sets;
use ccd_core::backend::broad_phase::pair_workers::THREADS;
use ccd_core::backend::layout::{EDGE_EDGE, Frame, LIST_HEADER, NodeDescent};
use ccd_core::model::method::{Descent, Traversal};
use ccd_core::model::scheduling::Scheduling;
use wgpu::BufferUsages as U;

/// The cuts, and what expands pairs of nodes.
pub struct PairDescent {
    nodes: u32,
    rule: Descent,
    cuts: wgpu::Buffer,
    pub scheduled: Scheduled,
}

impl PairDescent {
    /// From cuts of so many nodes on, between sets of so many boxes.
    pub fn new(
        device: &Device,
        nodes: u32,
        rule: Descent,
        scheduling: Scheduling,
        count: [u32; 3],
    ) -> Result<Self, Error> {
        // About as many as pairs that overlap; a list that is too short grows.
        let capacity = |n: u32| n.saturating_mul(4).max(4096);
        Ok(Self {
            nodes,
            rule,
            cuts: cut_buffer(device)?,
            scheduled: Scheduled::new(device, scheduling, THREADS, count, capacity, nodes * nodes)?,
        })
    }

    /// Lists all pairs of leaves of two trees, or of one given twice; by their oriented boxes, too,
    /// if there are. `keeps_order`: the trees are those of the search before, refitted.
    pub fn run(
        &self,
        recorder: &mut Recorder,
        (frame, kind, keeps_order): (&Frame, u32, bool),
        trees: [&BinaryTree; 2],
        oriented: Option<&wgpu::Buffer>,
        pairs: &List,
    ) {
        let [a_nodes, b_nodes] = trees.map(|tree| &tree.nodes);
        let n_levels = n_levels(self.rule, trees);
        let larger = (self.rule == Descent::Larger) as u32;
        let both = BinaryTrees { a_nodes, b_nodes, oriented, n_levels, larger };
        let descent = Descended { frame, kind, trees: Trees::Binary(both), pairs };
        self.scheduled.run(recorder, &descent, keeps_order, |recorder, written, tasks| {
            self.cut(recorder, &descent, both, trees, written, tasks);
        });
    }

    /// Makes tasks of the pairs of two cuts that meet.
    fn cut(
        &self,
        recorder: &mut Recorder,
        descent: &Descended,
        both: BinaryTrees,
        trees: [&BinaryTree; 2],
        written: Written,
        (control, tasks): (&wgpu::Buffer, &List),
    ) {
        let (a_nodes, b_nodes, front) = (both.a_nodes, both.b_nodes, written.front);
        let (cuts, capacity_nodes) = (&self.cuts, tasks.capacity());
        let args = NodeDescent { nodes: self.nodes, capacity_nodes, ..written.args };
        cut_nodes(recorder, descent, args, trees, cuts);
        let (output, p, n) = (tasks.buffer(), descent.params(args, 0, 0), self.nodes * self.nodes);
        let kernel = CutPairs { a_nodes, b_nodes, cuts, control, output, front };
        recorder.each_variant(&kernel, both.oriented, &p, n);
    }
}

/// A buffer for the nodes of two cuts.
pub fn cut_buffer(device: &Device) -> Result<wgpu::Buffer, Error> {
    let words = 2 * (LIST_HEADER as u64 + Traversal::MAX_CUT as u64);
    device.buffer("nodes of cuts", 4 * words, U::STORAGE)
}

/// Records the cuts through two trees, of `args.nodes` nodes each; within one tree one cut.
pub fn cut_nodes(
    recorder: &mut Recorder,
    descent: &Descended,
    args: NodeDescent,
    trees: [&BinaryTree; 2],
    cuts: &wgpu::Buffer,
) {
    // The order of a cut is that of the threads that were first: another cut through the same tree
    // has another one, so that pairs within a tree need one cut for both sides.
    let sides = (0..).zip(trees.into_iter().zip(sets(descent.kind)));
    for (side, (tree, set)) in sides.take(if descent.kind == EDGE_EDGE { 1 } else { 2 }) {
        let mut p = descent.params(args, side, 0);
        p.args.kind = set as u32;
        recorder.dispatch(&CutNodes { branches: &tree.branches, cuts }, &p, 1);
    }
}

/// Levels of pairs of nodes that there can be: with every step either both sides go down, or the
/// larger one.
pub fn n_levels(rule: Descent, trees: [&BinaryTree; 2]) -> u32 {
    let [a, b] = trees.map(BinaryTree::height);
    1 + if rule == Descent::Larger { a + b } else { a.max(b) }
}
