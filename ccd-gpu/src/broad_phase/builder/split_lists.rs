//! LBVH by split lists: neighbours of the sorted Morton codes part at a level each, and every level
//! has a list of where they did [Lauterbach 2009].
//!
//! The lists of [`ccd_core::backend::broad_phase::split_lists`] are one array, sorted by level and
//! then by place, made as on a CPU: every workgroup counts how many entries its places have on each
//! level, one scan a level says where they go (that of the sort), and every thread writes its own.
//! The tree is that of [`super::lbvh`], node by node.
//!
//! Cost: five dispatches; per box 12 bytes, and 4 for each of the two to four entries that it has
//! on the lists. The array grows where boxes have more; until it has, nodes are found as in
//! [`super::lbvh`].

use super::{TreeBuilder, height_of_codes};
use crate::bind::{ScanRows, SplitBranches, SplitCount, SplitEmit, SplitLevels};
use crate::broad_phase::block_bvh::Tree;
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::sort::DIGITS;
use ccd_core::backend::layout::{Building, Dispatch, Frame, Params, SortPass};
use wgpu::BufferUsages as U;

/// Bytes of the words that say which levels occur.
const PRESENT_BYTES: u64 = 16;

/// The lists of all levels.
pub struct SplitLists {
    set: usize,
    n: u32,
    levels: wgpu::Buffer,
    present: wgpu::Buffer,
    /// A row a digit of a sort, of which levels take the first.
    table: wgpu::Buffer,
    entries: wgpu::Buffer,
    list: List,
}

impl SplitLists {
    pub fn new(device: &Device, set: usize, n: u32) -> Result<Self, Error> {
        let words = |what, n: u64| device.buffer(what, 4 * n, U::STORAGE);
        Ok(Self {
            set,
            n,
            levels: words("levels of splits", n as u64)?,
            present: device.buffer("levels", PRESENT_BYTES, U::STORAGE | U::COPY_DST)?,
            table: words("table of splits", (n_tiles(n) as u64 + 1) * DIGITS as u64)?,
            entries: words("entries of splits", n as u64)?,
            list: List::new(device, "lists of splits", 1, n.saturating_mul(4))?,
        })
    }
}

/// Workgroups for the places between `n` boxes.
fn n_tiles(n: u32) -> u32 {
    (n - 1).div_ceil(Id::SplitEmit.threads())
}

impl TreeBuilder for SplitLists {
    fn height(&self) -> u32 {
        height_of_codes(self.n)
    }

    fn clear(&self, recorder: &mut Recorder) {
        recorder.clear(&self.present, PRESENT_BYTES);
    }

    fn build(
        &self,
        recorder: &mut Recorder,
        frame: &Frame,
        sorted: &Tree,
        branches: &wgpu::Buffer,
    ) {
        let Self { set, n, levels, present, table, entries, .. } = self;
        let (keys, list, n_tiles) = (sorted.sorted()[0], self.list.buffer(), n_tiles(*n));
        let dispatch = Dispatch { capacity_out: self.list.capacity(), ..Dispatch::default() };
        let args = Building { set: *set as u32, ..Building::default() };
        let p = Params { frame: *frame, dispatch, args };
        let places = n - 1;
        recorder.each(&SplitLevels { keys, levels, present }, &p, places);
        recorder.each(&SplitCount { levels, present, table }, &p, places);
        let scan = Params { frame: *frame, dispatch, args: SortPass { shift: 0, n_tiles } };
        recorder.dispatch(&ScanRows { table }, &scan, if places > 0 { DIGITS } else { 0 });
        recorder.each(&SplitEmit { levels, present, table, entries, list }, &p, places);
        let kernel = SplitBranches { keys, levels, present, table, entries, list, branches };
        recorder.each(&kernel, &p, places);
    }

    fn list(&self) -> Option<&List> {
        Some(&self.list)
    }

    fn list_mut(&mut self) -> Option<&mut List> {
        Some(&mut self.list)
    }
}
