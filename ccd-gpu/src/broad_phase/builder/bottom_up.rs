//! Joins of nodes by builders that work from the leaves up, and from them the numbers of all nodes
//! and the order of the leaves.

use crate::bind::NumberLeaves;
use crate::broad_phase::block_bvh::Tree;
use crate::device::Device;
use crate::error::Error;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::node_numbering::JOIN;
use ccd_core::backend::layout::{Building, Frame, Params};
use wgpu::BufferUsages as U;

/// The tree that is being built over some boxes of a set, at least one.
pub struct Joins {
    pub set: usize,
    pub n: u32,
    pub words: wgpu::Buffer,
}

impl Joins {
    pub fn new(device: &Device, set: usize, n: u32) -> Result<Self, Error> {
        let bytes = (2 * n as u64 - 1) * 4 * JOIN as u64;
        Ok(Self { set, n, words: device.buffer("joins of nodes", bytes, U::STORAGE)? })
    }

    /// Numbers all nodes and puts the leaves in order. `sorted`: whether the builder's leaves are
    /// in the order of codes; else they are in that of input.
    pub fn finish(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        blocks: &Tree,
        sorted: bool,
        branches: &wgpu::Buffer,
    ) {
        let (order, ordered) = (blocks.sorted()[1], blocks.spare_order());
        let args = Building { set: self.set as u32, sorted: sorted as u32, ..Building::default() };
        let p = Params { frame: *frame, args, ..Params::default() };
        let kernel = NumberLeaves { joins: &self.words, order, ordered, branches };
        recorder.each(&kernel, &p, self.n);
        let first = 4 * frame.start[self.set] as u64;
        recorder.copy(ordered, first, order, first, 4 * self.n as u64);
    }
}
