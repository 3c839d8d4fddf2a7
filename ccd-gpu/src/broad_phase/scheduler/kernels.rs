//! The kernels of workers and fronts, by what they descend.

use super::{BinaryTrees, BlockTrees, Descended, Trees};
use crate::bind::{
    BlockWorkers, PairWorkers, PairWorkersOriented, ResumeBlockFront, ResumeFront,
    ResumeFrontOriented, StealBlockPairs, StealPairs, StealPairsOriented,
};
use crate::recorder::Recorder;
use ccd_core::layout::{NodeDescent, Params};

/// What all of them write: counters of workers, tasks, and the front.
#[derive(Clone, Copy)]
pub struct Buffers<'a> {
    pub control: &'a wgpu::Buffer,
    pub nodes: &'a wgpu::Buffer,
    pub front: &'a wgpu::Buffer,
}

/// Records a round of so many workers, which may steal from each other.
pub fn round(
    recorder: &mut Recorder,
    of: &Descended,
    buffers: Buffers,
    p: &Params<NodeDescent>,
    n: u32,
) {
    let Buffers { control, nodes, front } = buffers;
    let (pairs, steals) = (of.pairs.buffer(), p.own.batches > 0);
    match of.trees {
        Trees::Blocks(trees) => {
            let (boxes, p) = (trees.boxes, trees.params(p));
            if steals {
                let kernel = StealBlockPairs { boxes, control, nodes, pairs, front };
                recorder.dispatch(&kernel, &p, n);
            } else {
                let kernel = BlockWorkers { boxes, control, nodes, pairs, front };
                recorder.dispatch(&kernel, &p, n);
            }
        }
        Trees::Binary(BinaryTrees { a_nodes, b_nodes, oriented: None, .. }) => {
            if steals {
                let kernel = StealPairs { a_nodes, b_nodes, control, nodes, pairs, front };
                recorder.dispatch(&kernel, p, n);
            } else {
                let kernel = PairWorkers { a_nodes, b_nodes, control, nodes, pairs, front };
                recorder.dispatch(&kernel, p, n);
            }
        }
        Trees::Binary(BinaryTrees { a_nodes, b_nodes, oriented: Some(oriented), .. }) => {
            if steals {
                let kernel =
                    StealPairsOriented { a_nodes, b_nodes, oriented, control, nodes, pairs, front };
                recorder.dispatch(&kernel, p, n);
            } else {
                let kernel = PairWorkersOriented {
                    a_nodes,
                    b_nodes,
                    oriented,
                    control,
                    nodes,
                    pairs,
                    front,
                };
                recorder.dispatch(&kernel, p, n);
            }
        }
    }
}

/// Records that `p.dispatch.n` pairs of a front become tasks, or stay.
pub fn resume(recorder: &mut Recorder, of: &Descended, buffers: Buffers, p: &Params<NodeDescent>) {
    let Buffers { control, nodes, front } = buffers;
    let (pairs, n) = (of.pairs.buffer(), p.dispatch.n);
    match of.trees {
        Trees::Blocks(trees) => {
            let BlockTrees { boxes, .. } = trees;
            let kernel = ResumeBlockFront { boxes, control, nodes, pairs, front };
            recorder.each(&kernel, &trees.params(p), n);
        }
        Trees::Binary(BinaryTrees { a_nodes, b_nodes, oriented: None, .. }) => {
            let kernel = ResumeFront { a_nodes, b_nodes, control, nodes, pairs, front };
            recorder.each(&kernel, p, n);
        }
        Trees::Binary(BinaryTrees { a_nodes, b_nodes, oriented: Some(oriented), .. }) => {
            let kernel =
                ResumeFrontOriented { a_nodes, b_nodes, oriented, control, nodes, pairs, front };
            recorder.each(&kernel, p, n);
        }
    }
}
