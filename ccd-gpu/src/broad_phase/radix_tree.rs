//! The binary radix tree on a device: built from the sorted keys and the boxes of a block tree,
//! traversed by one thread a query.

use super::block_bvh::Tree;
use crate::bind::{BranchBoxes, Branches, TraverseFull, TraverseHalf};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::layout::{Blocks, Branch, Dispatch, Frame, Node, Params, Plain, Queries};
use wgpu::BufferUsages as U;

/// Queries of one dispatch: some milliseconds of a small device, so that no driver thinks that it
/// hangs.
const DISPATCH_LIMIT: u32 = 1 << 22;

/// A tree over one set.
pub struct RadixTree {
    set: usize,
    pub branches: wgpu::Buffer,
    pub nodes: wgpu::Buffer,
    /// Leaves.
    n: u32,
}

impl RadixTree {
    /// Room for a tree over `n` boxes of a set, at least one.
    pub fn new(device: &Device, set: usize, n: u32) -> Result<Self, Error> {
        let buffer = |what, bytes: u64| device.buffer(what, bytes, U::STORAGE);
        Ok(Self {
            set,
            branches: buffer("branches of the tree", n as u64 * size_of::<Branch>() as u64)?,
            nodes: buffer("nodes of the binary tree", 2 * n as u64 * size_of::<Node>() as u64)?,
            n,
        })
    }

    /// Children and ranges of all nodes, from the keys of a block tree that is sorted.
    pub fn branch(&self, recorder: &mut Recorder, frame: &Frame, blocks: &Tree) {
        let (keys, branches) = (blocks.sorted()[0], &self.branches);
        recorder.each(&Branches { keys, branches }, &self.params(frame, blocks), self.n);
    }

    /// Boxes of all nodes, from those of a block tree that is fitted.
    pub fn fit(&self, recorder: &mut Recorder, frame: &Frame, blocks: &Tree) {
        let Self { branches, nodes, n, .. } = self;
        let (block_nodes, leaves) = (&blocks.nodes, &blocks.leaves);
        let kernel = BranchBoxes { branches, block_nodes, leaves, nodes };
        recorder.each(&kernel, &self.params(frame, blocks), *n);
    }

    fn params(&self, frame: &Frame, blocks: &Tree) -> Params<Blocks> {
        let own = Blocks { kind: self.set as u32, level: blocks.levels.top(), ..blocks.record() };
        Params { frame: *frame, dispatch: Dispatch::default(), own }
    }

    /// Lists all pairs within the tree, each query looking only at leaves after its own.
    pub fn traverse_half(&self, recorder: &mut Recorder, frame: &Frame, pairs: &List) {
        let Self { branches, nodes, n, .. } = self;
        for dispatch in parts(*n, pairs) {
            let p = Params { frame: *frame, dispatch, own: Plain::default() };
            let kernel = TraverseHalf { nodes, branches, pairs: pairs.buffer() };
            recorder.each(&kernel, &p, dispatch.n);
        }
    }

    /// Lists all pairs of a kind, whose second set is that of the tree, one query a box of the
    /// first.
    pub fn traverse_full(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        blocks: &Tree,
        own: Queries,
        pairs: &List,
    ) {
        let Self { branches, nodes, .. } = self;
        let (boxes, [_, order]) = (&blocks.boxes, blocks.sorted());
        for dispatch in parts(frame.count[sets(own.kind)[0]], pairs) {
            let kernel = TraverseFull { boxes, order, nodes, branches, pairs: pairs.buffer() };
            recorder.each(&kernel, &Params { frame: *frame, dispatch, own }, dispatch.n);
        }
    }
}

/// The dispatches over `n` queries.
fn parts(n: u32, pairs: &List) -> impl Iterator<Item = Dispatch> {
    let room_out = pairs.room();
    (0..n).step_by(DISPATCH_LIMIT as usize).map(move |first| Dispatch {
        n: (n - first).min(DISPATCH_LIMIT),
        first,
        room_in: 0,
        room_out,
    })
}
