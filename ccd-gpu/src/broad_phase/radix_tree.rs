//! The binary radix tree on a device: built from the sorted keys and the boxes of a block tree,
//! traversed by one thread a query.

use super::block_bvh::Tree;
use crate::bind::{Branches, FarNodes, NearNodes, TraverseAgainst, TraverseHalf};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, List};
use crate::recorder::Recorder;
use ccd_core::kernel::Id;
use ccd_core::layout::{Blocks, Branch, Dispatch, Frame, Params, Plain, WideNode};
use wgpu::BufferUsages as U;

/// Queries of one dispatch: some milliseconds of a small device, so that no driver thinks that it
/// hangs.
const DISPATCH_LIMIT: u32 = 1 << 22;

/// A tree over at least two boxes, which are set 1 of a block tree.
pub struct RadixTree {
    branches: wgpu::Buffer,
    nodes: wgpu::Buffer,
    /// Nodes whose leaves are far from one another: the head of a list, then room for all.
    far: wgpu::Buffer,
    n: u32,
}

impl RadixTree {
    /// Room for a tree over `n` boxes.
    pub fn new(device: &Device, n: u32) -> Result<Self, Error> {
        let buffer = |what, bytes: usize, usage| {
            device.buffer(what, n as u64 * bytes as u64 + HEADER_BYTES, usage)
        };
        Ok(Self {
            branches: buffer("branches of the tree", size_of::<Branch>(), U::STORAGE)?,
            nodes: buffer("nodes of the binary tree", size_of::<WideNode>(), U::STORAGE)?,
            far: buffer("far nodes of the tree", 4, U::STORAGE | U::COPY_DST)?,
            n,
        })
    }

    /// What must be zero before [`RadixTree::build`].
    pub fn clear(&self, recorder: &mut Recorder) {
        recorder.clear(&self.far, HEADER_BYTES);
    }

    /// Builds the tree over the boxes of a block tree that is sorted and fitted.
    pub fn build(&self, recorder: &mut Recorder, frame: &Frame, blocks: &Tree) {
        let Self { branches, nodes, far, n } = self;
        let (block_nodes, [keys, _]) = (&blocks.nodes, blocks.sorted());
        recorder.stage("branches");
        let p = Params { frame: *frame, ..Params::default() };
        recorder.each(&Branches { keys, branches }, &p, *n);
        recorder.stage("nodes");
        let own = Blocks { level: blocks.levels.top(), ..blocks.record() };
        let p = Params { frame: *frame, dispatch: Dispatch::default(), own };
        recorder.each(&NearNodes { branches, block_nodes, nodes, far }, &p, *n);
        recorder.stage("far nodes");
        let groups = blocks.groups.min(n.div_ceil(Id::FarNodes.threads()));
        recorder.dispatch(&FarNodes { branches, block_nodes, far, nodes }, &p, groups);
    }

    /// Lists all pairs of boxes that overlap.
    pub fn self_pairs(&self, recorder: &mut Recorder, frame: &Frame, blocks: &Tree, pairs: &List) {
        let Self { nodes, n, .. } = self;
        let [_, order] = blocks.sorted();
        queries(frame, blocks.record(), *n, pairs, |p| {
            let kernel =
                TraverseHalf { leaves: &blocks.nodes, order, nodes, pairs: pairs.buffer() };
            recorder.each(&kernel, p, p.dispatch.n);
        });
    }

    /// Lists all pairs of one of `n` loose boxes with a box of the tree.
    pub fn pairs_with(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        blocks: &Tree,
        (boxes, n): (&wgpu::Buffer, u32),
        pairs: &List,
    ) {
        let Self { nodes, .. } = self;
        let [_, order] = blocks.sorted();
        queries(frame, Plain::default(), n, pairs, |p| {
            let kernel = TraverseAgainst { boxes, order, nodes, pairs: pairs.buffer() };
            recorder.each(&kernel, p, p.dispatch.n);
        });
    }
}

/// Calls `run` with the parameters of each dispatch over `n` queries.
fn queries<A: Copy>(frame: &Frame, own: A, n: u32, pairs: &List, mut run: impl FnMut(&Params<A>)) {
    for first in (0..n).step_by(DISPATCH_LIMIT as usize) {
        let dispatch = Dispatch {
            n: (n - first).min(DISPATCH_LIMIT),
            first,
            room_in: 0,
            room_out: pairs.room(),
        };
        run(&Params { frame: *frame, dispatch, own });
    }
}
