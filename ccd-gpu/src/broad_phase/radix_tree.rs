//! The binary radix tree on a device: built from the sorted keys and the boxes of a block tree,
//! traversed by one thread a query.

use super::block_bvh::Tree;
use crate::bind::{BranchBoxes, Branches, TraverseAgainst, TraverseHalf};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::layout::{Blocks, Branch, Dispatch, Frame, Node, Params, Plain};
use wgpu::BufferUsages as U;

/// Queries of one dispatch: some milliseconds of a small device, so that no driver thinks that it
/// hangs.
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
    pub fn build(&self, recorder: &mut Recorder, frame: &Frame, blocks: &Tree) {
        let Self { branches, nodes, n } = self;
        recorder.stage("branches");
        let p = Params { frame: *frame, ..Params::default() };
        recorder.each(&Branches { keys: blocks.sorted()[0], branches }, &p, *n);
        recorder.stage("boxes of branches");
        let own = Blocks { level: blocks.levels.top(), ..blocks.record() };
        let p = Params { frame: *frame, dispatch: Dispatch::default(), own };
        let kernel =
            BranchBoxes { branches, block_nodes: &blocks.nodes, leaves: &blocks.leaves, nodes };
        recorder.each(&kernel, &p, *n);
    }

    /// Lists all pairs of boxes that overlap.
    pub fn self_pairs(&self, recorder: &mut Recorder, frame: &Frame, pairs: &List) {
        let Self { branches, nodes, n } = self;
        queries(frame, *n, pairs, |p| {
            recorder.each(
                &TraverseHalf { nodes, branches, pairs: pairs.buffer() },
                p,
                p.dispatch.n,
            );
        });
    }

    /// Lists all pairs of one of `n` loose boxes with a box of the tree.
    pub fn pairs_with(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        boxes: &wgpu::Buffer,
        n: u32,
        pairs: &List,
    ) {
        let Self { branches, nodes, .. } = self;
        queries(frame, n, pairs, |p| {
            recorder.each(
                &TraverseAgainst { boxes, nodes, branches, pairs: pairs.buffer() },
                p,
                p.dispatch.n,
            );
        });
    }
}

/// Calls `run` with the parameters of each dispatch over `n` queries.
fn queries(frame: &Frame, n: u32, pairs: &List, mut run: impl FnMut(&Params)) {
    for first in (0..n).step_by(DISPATCH_LIMIT as usize) {
        let dispatch = Dispatch {
            n: (n - first).min(DISPATCH_LIMIT),
            first,
            room_in: 0,
            room_out: pairs.room(),
        };
        run(&Params { frame: *frame, dispatch, own: Plain::default() });
    }
}
