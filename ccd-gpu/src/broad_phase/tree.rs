//! A binary tree as a source of pairs: sorted boxes, binary trees over those by any builder, a
//! block tree over their leaves, from which they have their boxes, and a traversal: queries with a
//! stack, a thread each, or pairs of nodes from a cut on, by any scheduler.
//!
//! Recursion does not exist on a device: a stack has the places to which calls return. One thread
//! of a device is slow, so that `simultaneous` is a CPU's.

use super::binary_tree::BinaryTree;
use super::block_bvh::Tree;
use super::builder;
use super::oriented::OrientedBoxes;
use super::pair_descent::PairDescent;
use super::pair_source::{PairSource, Search};
use super::pair_stacks::PairStacks;
use super::scheduled::{Scheduled, kinds_of};
use super::stages::PAIRS;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{Header, List};
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::block_bvh::sets;
use ccd_core::backend::broad_phase::morton_key::Curve;
use ccd_core::backend::layout::{EDGE_EDGE, Frame, Queries};
use ccd_core::model::method::{Traversal, TreeOptions, Volume};
use ccd_core::model::scheduling::Scheduling;

/// Binary trees over those sets that a traversal descends.
pub struct TreeSource {
    blocks: Tree,
    trees: [Option<BinaryTree>; 3],
    traversal: Traversal,
    descent: Option<PairDescent>,
    stacks: Option<PairStacks>,
    oriented: Option<OrientedBoxes>,
}

impl TreeSource {
    pub fn new(
        device: &Device,
        options: TreeOptions,
        scheduling: Scheduling,
        count: [u32; 3],
    ) -> Result<Self, Error> {
        let traversal = options.traversal;
        let descent = match traversal {
            Traversal::Cut { nodes, descent } => {
                Some(PairDescent::new(device, nodes, descent, scheduling, count)?)
            }
            _ => None,
        };
        let stacks = match traversal {
            Traversal::CutStacks { nodes, descent } => {
                Some(PairStacks::new(device, nodes, descent)?)
            }
            _ => None,
        };
        let for_pairs = descent.is_some() || stacks.is_some();
        for n in count {
            builder::check(options.builder, n)?;
        }
        let mut trees = [None, None, None];
        for kind in kinds_of(count) {
            for set in descended(kind, for_pairs) {
                let (n, builder) = (count[set], options.builder);
                trees[set] = Some(BinaryTree::new(device, builder, set, n, for_pairs)?);
            }
        }
        let has_tree = trees.each_ref().map(Option::is_some);
        let oriented = match options.volume {
            Volume::Obb => Some(OrientedBoxes::new(device, count, has_tree)?),
            _ => None,
        };
        Ok(Self {
            blocks: Tree::sorted_only(device, Curve::Morton, count, false, None)?,
            trees,
            traversal,
            descent,
            stacks,
            oriented,
        })
    }

    fn traverse(&self, recorder: &mut Recorder, frame: &Frame, kind: u32, search: &Search) {
        let pairs = search.pairs[kind as usize];
        let [a, b] = sets(kind).map(|set| self.trees[set].as_ref());
        let Some(b) = b else { return };
        let blocks = &self.blocks;
        let oriented = self.oriented.as_ref().map(|oriented| &oriented.boxes);
        match self.traversal {
            Traversal::Cut { .. } => {
                if let Some((descent, a)) = self.descent.as_ref().zip(a) {
                    let what = (frame, kind, search.keeps_order);
                    descent.run(recorder, what, [a, b], oriented, pairs);
                }
            }
            Traversal::CutStacks { .. } => {
                if let Some((stacks, a)) = self.stacks.as_ref().zip(a) {
                    stacks.run(recorder, (frame, kind), [a, b], oriented, pairs);
                }
            }
            Traversal::Half if kind == EDGE_EDGE => {
                b.traverse_half(recorder, frame, blocks, oriented, pairs);
            }
            other => {
                let recursive = other == Traversal::Recursive;
                let sorted = !recursive && other != Traversal::Iterative;
                let args = Queries { kind, sorted: sorted as u32 };
                b.traverse_full(recorder, frame, blocks, (args, oriented, recursive), pairs);
            }
        }
    }
}

/// Sets over which there are trees for a kind of pairs.
fn descended(kind: u32, both: bool) -> impl Iterator<Item = usize> {
    let [a, b] = sets(kind);
    [b, a].into_iter().take(if both && a != b { 2 } else { 1 })
}

impl PairSource for TreeSource {
    fn boxes(&self) -> &wgpu::Buffer {
        &self.blocks.boxes
    }

    fn clear(&self, recorder: &mut Recorder) {
        self.blocks.clear_bounds(recorder);
        self.trees.iter().flatten().for_each(|tree| tree.clear(recorder));
        if let Some(descent) = &self.descent {
            descent.scheduled.clear(recorder);
        }
        if let Some(stacks) = &self.stacks {
            stacks.clear(recorder);
        }
        if let Some(oriented) = &self.oriented {
            oriented.clear(recorder);
        }
    }

    fn find(&self, recorder: &mut Recorder, search: &Search) {
        let Self { blocks, trees, .. } = self;
        let frame = &Frame { flags: 0, ..*search.frame };
        if !search.keeps_order {
            recorder.stage("codes");
            blocks.sort(recorder, frame, search.n_bounding);
            recorder.stage("branches");
            trees.iter().flatten().for_each(|tree| tree.branch(recorder, frame, blocks));
        }
        recorder.stage("build");
        blocks.fit_boxes(recorder, frame);
        recorder.stage("nodes");
        trees.iter().flatten().for_each(|tree| tree.fit(recorder, frame, blocks));
        if let Some(oriented) = &self.oriented {
            recorder.stage("oriented");
            trees.iter().flatten().for_each(|tree| oriented.fit(recorder, frame, blocks, tree));
        }
        for &kind in search.kinds {
            recorder.stage(search.stage("pairs", PAIRS, kind));
            self.traverse(recorder, frame, kind, search);
        }
    }

    /// Not counted: an order is kept for as long as it may be.
    fn work(&self, _headers: &[Header]) -> Option<u64> {
        Some(0)
    }

    fn lists(&self) -> Vec<&List> {
        let of_descent = self.descent.iter().flat_map(|descent| descent.scheduled.lists());
        let of_stacks = self.stacks.iter().flat_map(PairStacks::lists);
        let of_trees = self.trees.iter().flatten().filter_map(BinaryTree::list);
        of_trees.chain(of_descent).chain(of_stacks).collect()
    }

    fn lists_mut(&mut self) -> Vec<&mut List> {
        let Self { trees, descent, stacks, .. } = self;
        let of_descent = descent.iter_mut().flat_map(|descent| descent.scheduled.lists_mut());
        let of_stacks = stacks.iter_mut().flat_map(PairStacks::lists_mut);
        let of_trees = trees.iter_mut().flatten().filter_map(BinaryTree::list_mut);
        of_trees.chain(of_descent).chain(of_stacks).collect()
    }

    fn settle(
        &mut self,
        device: &Device,
        counted: &[Vec<u32>],
        complete: bool,
    ) -> Result<bool, Error> {
        if let Some(stacks) = &mut self.stacks {
            stacks.settle();
        }
        match &mut self.descent {
            Some(descent) => descent.scheduled.settle(device, counted, complete),
            None => Ok(false),
        }
    }

    fn scheduled(&self) -> Option<&Scheduled> {
        self.descent.as_ref().map(|descent| &descent.scheduled)
    }
}
