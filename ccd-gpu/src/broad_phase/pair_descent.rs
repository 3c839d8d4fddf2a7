//! Simultaneous traversal of binary trees from a cut on: lists of pairs of nodes that follow each
//! other, one level a dispatch.
//!
//! ```text
//!   cut a  cut b          pairs of level 0 -> level 1 -> ... -> nothing left
//!     all pairs   ------>      |                |
//!   that overlap           pairs of leaves: found
//! ```
//!
//! How many levels there are is known on the device alone, so there are as many dispatches as there
//! can be levels; those after the last do nothing. Two lists are used in turn. A level's work is
//! shared evenly and no thread keeps a stack, but every pair of nodes is written and read once, and
//! so many dispatches take their time: choose it to see what it costs.

use super::binary_tree::BinaryTree;
use super::block_bvh::groups;
use super::pair_source::kinds_of;
use crate::bind::{CutNodes, CutPairs, CutPairsOriented, ExpandPairs, ExpandPairsOriented};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::kernel::Id;
use ccd_core::layout::{Dispatch, Frame, LIST_HEADER, NodeDescent, Params};
use ccd_core::model::method::{Descent, Traversal};
use wgpu::BufferUsages as U;

/// Words that count the pairs of each level: more than levels there can be, twice those of a tree
/// of 2^31 boxes, by any builder.
const MAX_LEVELS: u64 = 512;

/// The cuts, and the pairs of nodes of two levels.
pub struct PairDescent {
    nodes: u32,
    rule: Descent,
    cuts: [wgpu::Buffer; 2],
    /// By kind: pairs of each level.
    levels: [wgpu::Buffer; 2],
    /// By kind, two that are used in turn; none of a kind that there is not.
    pub lists: [Vec<List>; 2],
    groups: u32,
}

impl PairDescent {
    /// From cuts of so many nodes on, between sets of so many boxes.
    pub fn new(device: &Device, nodes: u32, rule: Descent, count: [u32; 3]) -> Result<Self, Error> {
        let words = LIST_HEADER as u64 + Traversal::MAX_CUT as u64;
        let cut = || device.buffer("nodes of a cut", 4 * words, U::STORAGE);
        let levels = || {
            let usage = U::STORAGE | U::COPY_DST;
            device.buffer("pairs of nodes of each level", 4 * MAX_LEVELS, usage)
        };
        let mut lists = [Vec::new(), Vec::new()];
        for kind in kinds_of(count) {
            // About as many as pairs that overlap; a list that is too short grows.
            let n = count[sets(kind)[1]].saturating_mul(4).max(4096);
            let list = || List::new(device, "pairs of nodes", 2, n);
            lists[kind as usize] = vec![list()?, list()?];
        }
        let (cuts, levels) = ([cut()?, cut()?], [levels()?, levels()?]);
        Ok(Self { nodes, rule, cuts, levels, lists, groups: groups(device) })
    }

    pub fn clear(&self, recorder: &mut Recorder) {
        self.levels.iter().for_each(|levels| recorder.clear(levels, 4 * MAX_LEVELS));
    }

    /// Lists all pairs of leaves of two trees, or of one given twice; by their oriented boxes, too,
    /// if there are.
    pub fn run(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        kind: u32,
        trees: [&BinaryTree; 2],
        oriented: Option<&wgpu::Buffer>,
        pairs: &List,
    ) {
        let [even, odd] = &self.lists[kind as usize][..] else { return };
        let [a, b] = trees;
        let (a_nodes, b_nodes) = (&a.nodes, &b.nodes);
        let levels = &self.levels[kind as usize];
        let larger = (self.rule == Descent::Larger) as u32;
        let params = |kind: u32, first: u32, input: &List, output: &List| {
            let own = NodeDescent { kind, larger, nodes: self.nodes, room_nodes: output.room() };
            let (room_in, room_out) = (input.room(), pairs.room());
            let dispatch = Dispatch { n: 0, first, room_in, room_out };
            Params { frame: *frame, dispatch, own }
        };
        // The order of a cut is that of the threads that were first: another cut through the same
        // tree has another one, so that pairs within a tree need one cut for both sides.
        let [a_cut, b_cut] = if kind == 1 { [&self.cuts[0]; 2] } else { self.cuts.each_ref() };
        let sides = trees.into_iter().zip(sets(kind)).zip([a_cut, b_cut]);
        for ((tree, set), cut) in sides.take(if kind == 1 { 1 } else { 2 }) {
            let kernel = CutNodes { branches: &tree.branches, cut };
            recorder.dispatch(&kernel, &params(set as u32, 0, odd, even), 1);
        }
        let output = even.buffer();
        let (p, n) = (params(kind, 0, odd, even), self.nodes * self.nodes);
        match oriented {
            None => {
                let kernel = CutPairs { a_nodes, b_nodes, a_cut, b_cut, levels, output };
                recorder.each(&kernel, &p, n);
            }
            Some(oriented) => {
                let kernel =
                    CutPairsOriented { a_nodes, b_nodes, a_cut, b_cut, oriented, levels, output };
                recorder.each(&kernel, &p, n);
            }
        }
        for level in 0..self.n_levels(trees) {
            let [input, output] = if level % 2 == 0 { [even, odd] } else { [odd, even] };
            let p = params(kind, level, input, output);
            let n_groups = self.groups.min(input.room().div_ceil(Id::ExpandPairs.threads()));
            let (input, output, pairs) = (input.buffer(), output.buffer(), pairs.buffer());
            match oriented {
                None => {
                    let kernel = ExpandPairs { a_nodes, b_nodes, input, levels, output, pairs };
                    recorder.dispatch(&kernel, &p, n_groups);
                }
                Some(oriented) => {
                    let kernel = ExpandPairsOriented {
                        a_nodes,
                        b_nodes,
                        oriented,
                        input,
                        levels,
                        output,
                        pairs,
                    };
                    recorder.dispatch(&kernel, &p, n_groups);
                }
            }
        }
    }

    /// Levels that there can be: with every step either both sides go down, or the larger one.
    fn n_levels(&self, trees: [&BinaryTree; 2]) -> u32 {
        let [a, b] = trees.map(BinaryTree::height);
        1 + if self.rule == Descent::Larger { a + b } else { a.max(b) }
    }
}
