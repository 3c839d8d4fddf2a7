//! Contacts in their canonical order, sorted where they were found, by counting; see
//! `ccd_core::backend::kernel::contact_order`.

use crate::bind::{CountContacts, OrderContacts, PlaceContacts, ScanRows};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use ccd_core::backend::kernel::contact_order::{ROWS, row, unordered};
use ccd_core::backend::layout::{Dispatch, Frame, PackedTouch, Params, Plain, SortPass};
use wgpu::BufferUsages as U;

/// From this many contacts on, sorting them on the device takes less time than on a thread of the
/// host.
pub const FEWEST: u32 = 4096;

/// Buffers for the order of contacts.
#[derive(Clone)]
pub struct ContactOrder {
    /// How many contacts each bucket has, and whether all buckets are in order.
    pub table: wgpu::Buffer,
    ranks: wgpu::Buffer,
    slots: wgpu::Buffer,
    /// Contacts in order, packed, without a header.
    pub ordered: wgpu::Buffer,
    capacity: u32,
    /// Bytes of these buffers, if there is a limit of memory.
    pub bytes: u64,
}

impl ContactOrder {
    /// For so many contacts at most of a mesh with the vertices and edges of `frame`.
    pub fn new(device: &Device, frame: &Frame, capacity: u32) -> Result<Self, Error> {
        let words = |what, n: u64, usage| device.buffer(what, 4 * n, U::STORAGE | usage);
        let n = capacity as u64;
        let make = || {
            let read = U::COPY_DST | U::COPY_SRC;
            Ok((
                words("counts of contacts", unordered(frame) as u64 + 1, read)?,
                words("ranks of contacts", n, U::empty())?,
                words("slots of contacts", n * size_of::<PackedTouch>() as u64 / 4, U::empty())?,
                words("ordered contacts", n * size_of::<PackedTouch>() as u64 / 4, U::COPY_SRC)?,
            ))
        };
        let ((table, ranks, slots, ordered), bytes) = device.counting(make)?;
        Ok(Self { table, ranks, slots, ordered, capacity, bytes })
    }

    /// Whether so many contacts fit, of such a mesh.
    pub fn fits(&self, frame: &Frame, n: u32) -> bool {
        self.capacity >= n && self.table.size() >= 4 * (unordered(frame) as u64 + 1)
    }

    /// The byte of the table from which on a word says whether the order is incomplete.
    pub fn incomplete_at(frame: &Frame) -> u64 {
        4 * unordered(frame) as u64
    }

    /// Prepares for [`ContactOrder::run`].
    pub fn clear(&self, recorder: &mut Recorder, frame: &Frame) {
        recorder.clear(&self.table, 4 * (unordered(frame) as u64 + 1));
    }

    /// Puts the contacts of a list in order if there are at most `n`.
    pub fn run(&self, recorder: &mut Recorder, frame: &Frame, contacts: &List, n: u32) {
        let Self { table, ranks, slots, ordered, .. } = self;
        let dispatch = Dispatch { n, capacity_in: contacts.capacity(), ..Dispatch::default() };
        let contacts = contacts.buffer();
        let p = &Params { frame: *frame, dispatch, args: Plain::default() };
        recorder.each(&CountContacts { contacts, table, ranks }, p, n);
        let args = SortPass { shift: 0, n_tiles: row(frame) };
        recorder.dispatch(&ScanRows { table }, &Params { frame: *frame, dispatch, args }, ROWS);
        recorder.each(&PlaceContacts { contacts, table, ranks, slots }, p, n);
        recorder.each(&OrderContacts { contacts, slots, ordered, table }, p, n);
    }
}
