//! A binary tree as a source of pairs: the boxes of a block tree, binary trees over those, and
//! queries with a stack, a thread each.

use super::block_bvh::Tree;
use super::pair_source::{PairSource, Search, kinds_of};
use super::radix_tree::RadixTree;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::layout::Frame;
use ccd_core::model::method::{Traversal, TreeOptions};
use wgpu::BufferUsages as U;

/// Binary trees over the second set of each kind of pairs.
pub struct TreeSource {
    blocks: Tree,
    trees: [Option<RadixTree>; 2],
    traversal: Traversal,
    none: wgpu::Buffer,
}

impl TreeSource {
    pub fn new(device: &Device, options: TreeOptions, count: [u32; 3]) -> Result<Self, Error> {
        let mut trees = [None, None];
        for kind in kinds_of(count) {
            trees[kind as usize] = Some(RadixTree::new(device, kind, count)?);
        }
        Ok(Self {
            blocks: Tree::sorted_only(device, count)?,
            trees,
            traversal: options.traversal,
            none: device.buffer("nothing", 0, U::STORAGE)?,
        })
    }
}

impl PairSource for TreeSource {
    fn boxes(&self) -> &wgpu::Buffer {
        &self.blocks.boxes
    }

    fn clear(&self, recorder: &mut Recorder) {
        self.blocks.clear_bounds(recorder);
    }

    fn find(&self, recorder: &mut Recorder, search: &Search) {
        let Self { blocks, trees, traversal, none } = self;
        let frame = &Frame { flags: 0, ..*search.frame };
        recorder.stage("codes");
        blocks.sort(recorder, frame, search.n_bounding);
        recorder.stage("build");
        blocks.fit(recorder, frame, none, none);
        let wanted = || search.kinds.iter().filter_map(|&kind| trees[kind as usize].as_ref());
        recorder.stage("branches");
        wanted().for_each(|tree| tree.branch(recorder, frame, blocks));
        recorder.stage("boxes of branches");
        wanted().for_each(|tree| tree.fit(recorder, frame, blocks));
        recorder.stage("pairs");
        for tree in wanted() {
            let pairs = search.pairs[tree.kind() as usize];
            match traversal {
                Traversal::Half if tree.kind() == 1 => tree.traverse_half(recorder, frame, pairs),
                Traversal::Iterative => {
                    tree.traverse_full(recorder, frame, blocks, false, pairs);
                }
                _ => tree.traverse_full(recorder, frame, blocks, true, pairs),
            }
        }
    }

    fn lists(&self) -> Vec<&List> {
        Vec::new()
    }
}
