//! The binary radix tree on a device: built from the sorted keys and the boxes of a block tree, traversed by one thread a query.

use crate::device::Device;
use crate::error::Error;
use crate::list::List;
use crate::recorder::Recorder;
use crate::tree::Tree;
use ccd_core::kernel::Id;
use ccd_core::layout::{Branch, Node, Params};
use wgpu::BufferUsages as U;

/// Queries of one dispatch: some milliseconds of a small device, so that no driver thinks that it hangs.
const DISPATCH_LIMIT: u32 = 1 << 22;

/// A tree over at least two boxes, which are set 1 of a block tree.
pub struct RadixTree {
    branches: wgpu::Buffer,
    nodes: wgpu::Buffer,
    n: u32,
}

impl RadixTree {
    /// Room for a tree over `n` boxes.
    pub fn new(device: &Device, n: u32) -> Result<Self, Error> {
        let buffer = |what, bytes: u64| device.buffer(what, bytes, U::STORAGE);
        Ok(Self {
            branches: buffer("branches of the tree", n as u64 * size_of::<Branch>() as u64)?,
            nodes: buffer("nodes of the binary tree", 2 * n as u64 * size_of::<Node>() as u64)?,
            n,
        })
    }

    /// Builds the tree over the boxes of a block tree that is sorted and fitted.
    pub fn build(&self, recorder: &mut Recorder, params: &Params, blocks: &Tree) {
        recorder.stage("branches");
        recorder.each(Id::Branches, params, &[blocks.sorted()[0], &self.branches], self.n);
        recorder.stage("boxes of branches");
        let p = Params { level: blocks.levels.top(), ..*params };
        recorder.each(Id::BranchBoxes, &p, &[&self.branches, &blocks.nodes, &blocks.leaves, &self.nodes], self.n);
    }

    /// Lists all pairs of boxes that overlap.
    pub fn self_pairs(&self, recorder: &mut Recorder, params: &Params, pairs: &List) {
        self.queries(params, self.n, pairs, |p| {
            recorder.each(Id::TraverseHalf, p, &[&self.nodes, &self.branches, pairs.buffer()], p.n);
        });
    }

    /// Lists all pairs of one of `n` loose boxes with a box of the tree.
    pub fn pairs_with(&self, recorder: &mut Recorder, params: &Params, boxes: &wgpu::Buffer, n: u32, pairs: &List) {
        self.queries(params, n, pairs, |p| {
            recorder.each(Id::TraverseAgainst, p, &[boxes, &self.nodes, &self.branches, pairs.buffer()], p.n);
        });
    }

    fn queries(&self, params: &Params, n: u32, pairs: &List, mut run: impl FnMut(&Params)) {
        for first in (0..n).step_by(DISPATCH_LIMIT as usize) {
            let part = (n - first).min(DISPATCH_LIMIT);
            run(&Params { first, n: part, room_out: pairs.room(), ..*params });
        }
    }
}
