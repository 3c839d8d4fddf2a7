//! Pairs of nodes of two trees, as schedulers and fronts descend them, whichever trees they are:
//! kernels and their parameters.
//!
//! Twin: on a CPU `descend.rs`, and for blocks `block_workers.rs`.

use crate::bind::{BlockWorkers, PairWorkers, ResumeBlockFront, ResumeFront};
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::layout::{BlockDescent, Dispatch, Frame, MAX_LEVELS, NodeDescent, Params};

/// Two trees, or one twice, and where the pairs of their leaves go.
#[derive(Clone, Copy)]
pub struct Descended<'a> {
    pub frame: &'a Frame,
    pub kind: u32,
    pub trees: Trees<'a>,
    pub pairs: &'a List,
}

/// Trees of which pairs are descended.
#[derive(Clone, Copy)]
pub enum Trees<'a> {
    Binary(BinaryTrees<'a>),
    Blocks(BlockTrees<'a>),
}

/// Two binary trees.
#[derive(Clone, Copy)]
pub struct BinaryTrees<'a> {
    pub a_nodes: &'a wgpu::Buffer,
    pub b_nodes: &'a wgpu::Buffer,
    /// Oriented boxes of the nodes of all trees.
    pub oriented: Option<&'a wgpu::Buffer>,
    /// Levels of pairs of nodes that there can be.
    pub n_levels: u32,
    /// 1: of two nodes the larger is split, 0: both.
    pub larger: u32,
}

/// Block trees over two sets.
#[derive(Clone, Copy)]
pub struct BlockTrees<'a> {
    /// Boxes of the nodes of all sets.
    pub boxes: &'a wgpu::Buffer,
    /// First node of either on each level.
    pub slots: [[u32; 2]; MAX_LEVELS],
}

impl Descended<'_> {
    /// The parameters of a dispatch; `first` and `n` as its kernel has them.
    pub fn params(&self, args: NodeDescent, first: u32, n: u32) -> Params<NodeDescent> {
        let larger = match self.trees {
            Trees::Binary(trees) => trees.larger,
            Trees::Blocks(_) => 0,
        };
        let dispatch = Dispatch {
            n,
            first,
            capacity_in: args.capacity_nodes,
            capacity_out: self.pairs.capacity(),
        };
        let args = NodeDescent { kind: self.kind, larger, ..args };
        Params { frame: *self.frame, dispatch, args }
    }
}

impl BlockTrees<'_> {
    /// The same for a kernel of blocks.
    pub fn params(&self, p: &Params<NodeDescent>) -> Params<BlockDescent> {
        let args = BlockDescent { of_pairs: p.args, slots: self.slots };
        Params { frame: p.frame, dispatch: p.dispatch, args }
    }
}

/// A front as kernels write it.
#[derive(Clone, Copy)]
pub struct Written<'a> {
    pub front: &'a wgpu::Buffer,
    /// Its capacity and which half is written; 0 if none is kept.
    pub args: NodeDescent,
}

/// What workers and fronts write: counters of workers, tasks, and the front.
#[derive(Clone, Copy)]
pub struct Buffers<'a> {
    pub control: &'a wgpu::Buffer,
    pub nodes: &'a wgpu::Buffer,
    pub front: &'a wgpu::Buffer,
}

/// Records a round of so many workers, which may steal from each other.
pub fn round(
    recorder: &mut Recorder,
    descent: &Descended,
    buffers: Buffers,
    p: &Params<NodeDescent>,
    n: u32,
) {
    let Buffers { control, nodes, front } = buffers;
    let (pairs, steals) = (descent.pairs.buffer(), p.args.batches > 0);
    match descent.trees {
        Trees::Blocks(trees) => {
            let kernel = BlockWorkers { boxes: trees.boxes, control, nodes, pairs, front };
            recorder.dispatch_variant(&kernel, (None, steals), &trees.params(p), n);
        }
        Trees::Binary(BinaryTrees { a_nodes, b_nodes, oriented, .. }) => {
            let kernel = PairWorkers { a_nodes, b_nodes, control, nodes, pairs, front };
            recorder.dispatch_variant(&kernel, (oriented, steals), p, n);
        }
    }
}

/// Records that `p.dispatch.n` pairs of a front become tasks, or stay.
pub fn resume(
    recorder: &mut Recorder,
    descent: &Descended,
    buffers: Buffers,
    p: &Params<NodeDescent>,
) {
    let Buffers { control, nodes, front } = buffers;
    let (pairs, n) = (descent.pairs.buffer(), p.dispatch.n);
    match descent.trees {
        Trees::Blocks(trees) => {
            let BlockTrees { boxes, .. } = trees;
            let kernel = ResumeBlockFront { boxes, control, nodes, pairs, front };
            recorder.each(&kernel, &trees.params(p), n);
        }
        Trees::Binary(BinaryTrees { a_nodes, b_nodes, oriented, .. }) => {
            let kernel = ResumeFront { a_nodes, b_nodes, control, nodes, pairs, front };
            recorder.each_variant(&kernel, oriented, p, n);
        }
    }
}
