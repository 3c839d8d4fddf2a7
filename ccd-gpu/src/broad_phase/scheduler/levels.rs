//! A level of pairs of nodes a dispatch: the portable default.
//!
//! ```text
//!   tasks, level 0 -> level 1 -> level 2 -> ... -> nothing left
//!         |              |
//!      pairs of leaves: found
//! ```
//!
//! How many levels there are is known on the device alone, so there are as many dispatches as there
//! can be levels; those after the last do nothing. Two lists are used in turn. A level's work is
//! shared evenly and no thread keeps a stack, but every pair of nodes is written and read once, and
//! so many dispatches take their time.

use super::Schedule;
use crate::bind::ExpandPairs;
use crate::broad_phase::descended::{BinaryTrees, Descended, Trees, Written};
use crate::broad_phase::worker_counts::Counted;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::broad_phase::pair_workers::ROUNDS;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::NodeDescent;
use wgpu::BufferUsages as U;

/// Pairs of nodes of two levels.
pub struct Levels {
    /// Pairs of each level.
    counters: wgpu::Buffer,
    even: List,
    odd: List,
    groups: u32,
}

/// Bytes of the counters: words for more levels than there can be, twice those of a tree of 2^31
/// boxes, by any builder.
const BYTES: u64 = 4 * ROUNDS as u64;

impl Levels {
    /// For `n` pairs of nodes a level.
    pub fn new(device: &Device, n: u32) -> Result<Self, Error> {
        let usage = U::STORAGE | U::COPY_DST;
        let list = || List::new(device, "pairs of nodes", 2, n);
        Ok(Self {
            counters: device.buffer("pairs of nodes of each level", BYTES, usage)?,
            even: list()?,
            odd: list()?,
            groups: device.groups(),
        })
    }
}

impl Schedule for Levels {
    fn tasks(&self) -> (&wgpu::Buffer, &List) {
        (&self.counters, &self.even)
    }

    fn clear(&self, recorder: &mut Recorder) {
        recorder.clear(&self.counters, BYTES);
    }

    fn run(&self, recorder: &mut Recorder, descent: &Descended, _: Written) {
        let Trees::Binary(trees) = descent.trees else { return };
        let BinaryTrees { a_nodes, b_nodes, oriented, n_levels, .. } = trees;
        let (levels, pairs) = (&self.counters, descent.pairs.buffer());
        for level in 0..n_levels {
            let lists = [&self.even, &self.odd];
            let [input, output] = [lists[level as usize % 2], lists[1 - level as usize % 2]];
            let args = NodeDescent { capacity_nodes: output.capacity(), ..NodeDescent::default() };
            let mut p = descent.params(args, level, 0);
            p.dispatch.capacity_in = input.capacity();
            let n_groups = self.groups.min(input.capacity().div_ceil(Id::ExpandPairs.threads()));
            let (input, output) = (input.buffer(), output.buffer());
            let kernel = ExpandPairs { a_nodes, b_nodes, input, levels, output, pairs };
            recorder.dispatch_variant(&kernel, (oriented, false), &p, n_groups);
        }
    }

    fn lists(&self) -> Vec<&List> {
        vec![&self.even, &self.odd]
    }

    fn lists_mut(&mut self) -> Vec<&mut List> {
        vec![&mut self.even, &mut self.odd]
    }

    fn settle(&mut self, _: bool) {}

    fn counts(&self) -> Option<Counted<'_>> {
        None
    }
}
