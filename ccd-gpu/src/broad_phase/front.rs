//! Fronts on a device: the pairs of nodes where a descent ended, from which the next one begins, if
//! order and shape of the trees are those of the search before.
//!
//! ```text
//!   the front that is kept  [. . . . . . . . .]
//!                            | | |     |     apart: stays
//!                            | | |     leaves: stays, and is a pair if their boxes overlap
//!                            | | meets: a task, as pairs of two cuts are otherwise
//!   the front that is written [. . . .  . . . . . .]  and all pairs at which workers end
//! ```
//!
//! Both are halves of one buffer, and the rule when one is kept is that of every backend,
//! [`ccd_core::backend::scheduling::front`]. A front that is too short for its list is dropped, the
//! list grows, and the next search begins at the cuts: no pair of boxes depends on it.
//!
//! Cost: a test a pair of the front, all at once; what it saves is the descent to them. A search
//! that begins at cuts begins a front with nearly all pairs of their nodes, some ten thousand. Of
//! blocks it reaches down to pairs of blocks of 32 boxes: each pair above them that meets leaves
//! 1024 pairs, met or apart, which are then tested one by one rather than by rows and columns.
//!
//! A search that was recorded and whose results the host has not seen may have been anything: after
//! one, nothing is kept.

use super::descended::Written;
use crate::device::Device;
use crate::error::Error;
use ccd_core::backend::broad_phase::pair_workers::FRONT;
use ccd_core::backend::layout::NodeDescent;
use ccd_core::backend::scheduling::front::{Fate, FrontState};
use ccd_core::model::report::FrontCounts;
use ccd_core::model::scheduling::FrontOptions;
use std::sync::{Mutex, MutexGuard, PoisonError};
use wgpu::BufferUsages as U;

/// Bytes of an entry in both halves.
const ENTRY: u64 = 2 * 8;
/// Bytes of the counters that the host looks at: pairs of the front, and how often that ran over.
pub const COUNTERS: std::ops::Range<u64> = 4 * FRONT as u64..4 * FRONT as u64 + 8;

/// The front of one kind of pairs.
pub struct Front {
    options: FrontOptions,
    search: Mutex<Search>,
    /// Two lists, used in turn, of so many entries.
    slots: wgpu::Buffer,
    capacity: u32,
    /// Which of them is written next.
    written: u32,
}

/// The last search that was recorded.
#[derive(Debug, Default)]
struct Search {
    state: FrontState,
    /// The host has not seen its results.
    is_open: bool,
}

impl Front {
    /// For `n` pairs, or as many as fit in half of its memory.
    pub fn new(device: &Device, options: FrontOptions, n: u32) -> Result<Self, Error> {
        let capacity = (n as u64).min(most(device, &options, 0) / 2) as u32;
        let slots = slots(device, capacity)?;
        Ok(Self { options, search: Mutex::default(), slots, capacity, written: 0 })
    }

    /// A search is recorded. `keeps_order`: its trees are those of the search before. Returns with
    /// how many pairs it begins, 0: at the cuts; and what it writes.
    pub fn begin(&self, keeps_order: bool) -> (u32, Written<'_>) {
        let mut search = lock(&self.search);
        let seen = !std::mem::replace(&mut search.is_open, true);
        search.state.begin(keeps_order && seen);
        let capacity = if search.state.is_written() { self.capacity } else { 0 };
        let args = NodeDescent {
            capacity_front: capacity,
            written: self.written,
            ..NodeDescent::default()
        };
        (search.state.begun() as u32, Written { front: &self.slots, args })
    }

    /// The last search was seen, and what it counted at [`COUNTERS`]; if it is not `complete`, it
    /// runs again. `used`: bytes of other fronts. Returns whether its buffer is another one now.
    pub fn settle(
        &mut self,
        device: &Device,
        counted: [u32; 2],
        complete: bool,
        used: u64,
    ) -> Result<bool, Error> {
        let Search { state, is_open } =
            self.search.get_mut().unwrap_or_else(PoisonError::into_inner);
        *is_open = false;
        if !complete {
            return Ok(false);
        }
        let n = (counted[1] as u64) << 32 | counted[0] as u64;
        let most = most(device, &self.options, used);
        match state.end(&self.options, n, n, self.capacity as u64, most) {
            Fate::Kept => self.written = 1 - self.written,
            Fate::Dropped => {}
            Fate::Grows(capacity) => match slots(device, capacity as u32) {
                Ok(slots) => {
                    device.give_back(self.slots.size());
                    (self.slots, self.capacity) = (slots, capacity as u32);
                    return Ok(true);
                }
                Err(e) if e.is_of_memory() => state.give_up(),
                Err(e) => return Err(e),
            },
        }
        Ok(false)
    }

    /// Memory that it takes.
    pub fn bytes(&self) -> u64 {
        self.capacity as u64 * ENTRY
    }

    /// What the last search began with, and what it left.
    pub fn counts(&self) -> FrontCounts {
        let Search { state, .. } = &*lock(&self.search);
        FrontCounts::new(state.kept(), state.begun(), self.bytes())
    }
}

fn lock(search: &Mutex<Search>) -> MutexGuard<'_, Search> {
    search.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Entries that there may be if other fronts take so many bytes.
fn most(device: &Device, options: &FrontOptions, used: u64) -> u64 {
    let limits = &device.info().limits;
    let bytes = ((options.memory as u64) << 20).saturating_sub(used);
    bytes.min(limits.max_storage_buffer_binding_size).min(limits.max_buffer_size) / ENTRY
}

fn slots(device: &Device, capacity: u32) -> Result<wgpu::Buffer, Error> {
    device.buffer("fronts", capacity as u64 * ENTRY, U::STORAGE)
}
