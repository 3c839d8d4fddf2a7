//! Blocks as a source that lists pairs: sort, fit, descent, and the boxes of each pair of blocks.

use super::block_bvh::{Pass, Tree};
use super::pair_source::{PairSource, Search};
use super::scheduled::Scheduled;
use super::worker_counts::Counted;
use crate::bind::ListCandidates;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{Header, List};
use crate::recorder::Recorder;
use ccd_core::backend::layout::Frame;
use ccd_core::model::report::FrontCounts;
use ccd_core::model::scheduling::Scheduling;
use std::ops::Range;
use wgpu::BufferUsages as U;

/// Lists the pairs that block trees find.
pub struct BlockSource {
    tree: Tree,
    none: wgpu::Buffer,
}

impl BlockSource {
    pub fn new(device: &Device, scheduling: Scheduling, count: [u32; 3]) -> Result<Self, Error> {
        let none = device.buffer("nothing", 0, U::STORAGE)?;
        Ok(Self { tree: Tree::new(device, scheduling, count)?, none })
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
            recorder.dispatch(&kernel, p, tree.groups.min(input.capacity()));
        });
    }
}

impl PairSource for BlockSource {
    fn boxes(&self) -> &wgpu::Buffer {
        &self.tree.boxes
    }

    fn clear(&self, recorder: &mut Recorder) {
        self.tree.clear_bounds(recorder);
        self.tree.clear(recorder);
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
        tree.descend(recorder, frame, search.kinds, search.keeps_order);
        recorder.stage("pairs");
        for &kind in search.kinds {
            self.list(recorder, frame, kind, search.pairs[kind as usize]);
        }
    }

    fn work(&self, headers: &[Header]) -> Option<u64> {
        Some(self.tree.work(headers))
    }

    fn lists(&self) -> Vec<&List> {
        self.tree.lists()
    }

    fn lists_mut(&mut self) -> Vec<&mut List> {
        self.tree.lists_mut()
    }

    fn counters(&self) -> Vec<(&wgpu::Buffer, Range<u64>)> {
        self.tree.scheduled().map(Scheduled::counters).unwrap_or_default()
    }

    fn settle(
        &mut self,
        device: &Device,
        counted: &[Vec<u32>],
        complete: bool,
    ) -> Result<bool, Error> {
        match self.tree.scheduled_mut() {
            Some(scheduled) => scheduled.settle(device, counted, complete),
            None => Ok(false),
        }
    }

    fn front(&self) -> Option<FrontCounts> {
        self.tree.scheduled().and_then(Scheduled::front)
    }

    fn worker_counts(&self) -> Vec<Counted<'_>> {
        self.tree.scheduled().map(Scheduled::worker_counts).unwrap_or_default()
    }
}
