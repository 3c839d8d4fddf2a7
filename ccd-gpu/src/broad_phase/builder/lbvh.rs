//! LBVH: a binary radix tree over sorted Morton codes, one kernel in which every thread finds a
//! node by itself [Karras 2012].

use super::{TreeBuilder, height_of_codes};
use crate::bind::Branches;
use crate::broad_phase::block_bvh::Tree;
use crate::recorder::Recorder;
use ccd_core::backend::layout::{Blocks, Dispatch, Frame, Params};

/// Over `n` boxes of a set.
pub struct Lbvh {
    pub set: usize,
    pub n: u32,
}

impl TreeBuilder for Lbvh {
    fn height(&self) -> u32 {
        height_of_codes(self.n)
    }

    fn build(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        sorted: &Tree,
        branches: &wgpu::Buffer,
    ) {
        let args = Blocks { kind: self.set as u32, ..sorted.record() };
        let p = Params { frame: *frame, dispatch: Dispatch::default(), args };
        recorder.each(&Branches { keys: sorted.sorted()[0], branches }, &p, self.n);
    }
}
