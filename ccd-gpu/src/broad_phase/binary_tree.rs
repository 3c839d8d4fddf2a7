//! A binary tree on a device: branches by any builder, boxes from those of a block tree over its
//! leaves, traversed by one thread a query.

use super::block_bvh::Tree;
use super::builder::{self, TreeBuilder};
use crate::bind::{
    BranchBoxes, FarNodes, NearNodes, TraverseFull, TraverseHalf, TraverseRecursive,
};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, List, parts};
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::block_bvh::sets;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Blocks, Branch, Dispatch, Frame, Node, Params, Queries, WideNode};
use ccd_core::model::method::Builder;
use wgpu::BufferUsages as U;

/// Queries of one dispatch: some milliseconds of a small device, so that no driver thinks that it
/// hangs.
const DISPATCH_LIMIT: u32 = 1 << 22;

/// A tree over one set.
pub struct BinaryTree {
    pub set: usize,
    builder: Box<dyn TreeBuilder>,
    pub branches: wgpu::Buffer,
    /// Internal nodes and leaves with a box each, for pairs of nodes; or, for queries, internal
    /// nodes with the boxes of both children.
    pub nodes: wgpu::Buffer,
    /// For queries: a list of the nodes whose leaves are far from one another, of which it holds
    /// all.
    far: Option<wgpu::Buffer>,
    /// Leaves.
    pub n: u32,
}

impl BinaryTree {
    /// A tree over `n` boxes of a set, at least one: for queries, or for pairs of nodes.
    pub fn new(
        device: &Device,
        choice: Builder,
        set: usize,
        n: u32,
        for_pairs: bool,
    ) -> Result<Self, Error> {
        let (storage, n_boxes) = (U::STORAGE, n as u64);
        let buffer = |what, bytes: usize| device.buffer(what, n_boxes * bytes as u64, storage);
        let far = || {
            let bytes = HEADER_BYTES + 4 * n_boxes;
            device.buffer("far nodes of the tree", bytes, storage | U::COPY_DST)
        };
        let node = if for_pairs { 2 * size_of::<Node>() } else { size_of::<WideNode>() };
        Ok(Self {
            set,
            builder: builder::new(device, choice, set, n)?,
            branches: buffer("branches of the tree", size_of::<Branch>())?,
            nodes: buffer("nodes of the binary tree", node)?,
            far: if for_pairs { None } else { Some(far()?) },
            n,
        })
    }

    /// Levels of internal nodes that there may be.
    pub fn height(&self) -> u32 {
        self.builder.height()
    }

    /// A list of the builder.
    pub fn list(&self) -> Option<&List> {
        self.builder.list()
    }

    /// The same, to be replaced by a larger one.
    pub fn list_mut(&mut self) -> Option<&mut List> {
        self.builder.list_mut()
    }

    /// What must be zero before [`BinaryTree::branch`].
    pub fn clear(&self, recorder: &mut Recorder) {
        self.builder.clear(recorder);
        if let Some(far) = &self.far {
            recorder.clear(far, HEADER_BYTES);
        }
    }

    /// Children and ranges of all nodes, from a block tree that is sorted and not fitted yet,
    /// because leaves may change places.
    pub fn branch(&self, recorder: &mut Recorder, frame: &Frame, blocks: &Tree) {
        self.builder.build(recorder, frame, blocks, &self.branches);
    }

    /// Boxes of all nodes, from those of a block tree that is fitted.
    pub fn fit(&self, recorder: &mut Recorder, frame: &Frame, blocks: &Tree) {
        let Self { branches, nodes, far, n, .. } = self;
        let (block_nodes, [_, order]) = (&blocks.nodes, blocks.sorted());
        let p = self.params(frame, blocks);
        match far {
            None => recorder.each(&BranchBoxes { branches, block_nodes, order, nodes }, &p, *n),
            Some(far) => {
                recorder.each(&NearNodes { branches, block_nodes, nodes, far }, &p, *n);
                let groups = blocks.groups.min(n.div_ceil(Id::FarNodes.threads()));
                recorder.dispatch(&FarNodes { branches, block_nodes, far, nodes }, &p, groups);
            }
        }
    }

    /// The parameters of kernels over the nodes of the tree.
    pub fn params(&self, frame: &Frame, blocks: &Tree) -> Params<Blocks> {
        let args = Blocks { kind: self.set as u32, level: blocks.levels.top(), ..blocks.record() };
        Params { frame: *frame, dispatch: Dispatch::default(), args }
    }

    /// Lists all pairs within the tree, each query looking only at leaves after its own.
    /// `oriented`: the oriented boxes of all trees, where these tell pairs apart.
    pub fn traverse_half(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        blocks: &Tree,
        oriented: Option<&wgpu::Buffer>,
        pairs: &List,
    ) {
        let (leaves, [_, order], nodes) = (&blocks.nodes, blocks.sorted(), &self.nodes);
        for dispatch in parts(self.n, DISPATCH_LIMIT, pairs.capacity()) {
            let p = Params { dispatch, ..self.params(frame, blocks) };
            let kernel = TraverseHalf { leaves, order, nodes, pairs: pairs.buffer() };
            recorder.each_variant(&kernel, oriented, &p, dispatch.n);
        }
    }

    /// Lists all pairs of a kind, whose second set is that of the tree, one query a box of the
    /// first. `oriented`: as above; `recursive`: by recursion.
    pub fn traverse_full(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        blocks: &Tree,
        (args, oriented, recursive): (Queries, Option<&wgpu::Buffer>, bool),
        pairs: &List,
    ) {
        let (boxes, [_, order], nodes) = (&blocks.boxes, blocks.sorted(), &self.nodes);
        let n = frame.count[sets(args.kind)[0]];
        for dispatch in parts(n, DISPATCH_LIMIT, pairs.capacity()) {
            let (pairs, n) = (pairs.buffer(), dispatch.n);
            let p = Params { frame: *frame, dispatch, args };
            if recursive {
                let kernel = TraverseRecursive { boxes, order, nodes, pairs };
                recorder.each_variant(&kernel, oriented, &p, n);
            } else {
                let kernel = TraverseFull { boxes, order, nodes, pairs };
                recorder.each_variant(&kernel, oriented, &p, n);
            }
        }
    }
}
