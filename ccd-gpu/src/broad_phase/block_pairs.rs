//! Blocks as a source that lists pairs: sort, fit, descent, and the boxes of each pair of blocks.

use super::block_bvh::{Pass, Tree};
use super::pair_source::{PairSource, Search};
use crate::bind::ListCandidates;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{Header, List};
use crate::recorder::Recorder;
use ccd_core::layout::Frame;
use wgpu::BufferUsages as U;

/// Lists the pairs that block trees find.
pub struct BlockSource {
    tree: Tree,
    none: wgpu::Buffer,
}

impl BlockSource {
    pub fn new(device: &Device, count: [u32; 3]) -> Result<Self, Error> {
        let none = device.buffer("nothing", 0, U::STORAGE)?;
        Ok(Self { tree: Tree::new(device, count)?, none })
    }

    fn list(&self, recorder: &mut Recorder, frame: &Frame, kind: u32, output: &List) {
        let Self { tree, none } = self;
        let input = tree.block_pairs(kind as usize);
        let kernel = ListCandidates {
            nodes: &tree.nodes,
            leaves: &tree.leaves,
            bodies: none,
            keys: none,
            input: input.buffer(),
            output: output.buffer(),
        };
        tree.each_part(frame, Pass { kind, level: 1, step: 1 }, input, output, |p| {
            recorder.dispatch(&kernel, p, tree.groups.min(input.room()));
        });
    }
}

impl PairSource for BlockSource {
    fn boxes(&self) -> &wgpu::Buffer {
        &self.tree.boxes
    }

    fn clear(&self, recorder: &mut Recorder) {
        self.tree.clear_bounds(recorder);
    }

    fn find(&self, recorder: &mut Recorder, search: &Search) {
        let Self { tree, none } = self;
        // Boxes alone: no topology, no bodies.
        let frame = &Frame { flags: 0, ..*search.frame };
        if !search.keeps_order {
            recorder.stage("codes");
            tree.sort(recorder, frame, search.n_bounding);
        }
        recorder.stage("build");
        tree.fit(recorder, frame, none, none);
        recorder.stage("block pairs");
        tree.descend(recorder, frame, search.kinds);
        recorder.stage("pairs");
        for &kind in search.kinds {
            self.list(recorder, frame, kind, search.pairs[kind as usize]);
        }
    }

    fn work(&self, headers: &[Header]) -> Option<u64> {
        Some(self.tree.work(headers))
    }

    fn lists(&self) -> Vec<&List> {
        self.tree.lists().collect()
    }

    fn lists_mut(&mut self) -> Vec<&mut List> {
        self.tree.pairs.iter_mut().flatten().collect()
    }
}
