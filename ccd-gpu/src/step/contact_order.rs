//! Contacts in their canonical order, sorted where they were found: by `b`, then by kind and `a`.

use crate::bind::{ContactKeys, OrderContacts};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::List;
use crate::recorder::Recorder;
use crate::sort::Sort;
use ccd_core::backend::layout::{ContactSort, Dispatch, Frame, Params, Plain, Touch};
use wgpu::BufferUsages as U;

/// From this many contacts on, sorting them on the device takes less time than on a thread of the
/// host.
pub const FEWEST: u32 = 4096;

/// Buffers for the sort of contacts.
#[derive(Clone)]
pub struct ContactOrder {
    sort: Sort,
    /// Contacts in order, without a header.
    pub ordered: wgpu::Buffer,
    /// Bytes of these buffers, if there is a limit of memory.
    pub bytes: u64,
}

impl ContactOrder {
    /// For so many contacts at most.
    pub fn new(device: &Device, capacity: u32) -> Result<Self, Error> {
        let bytes = capacity as u64 * size_of::<Touch>() as u64;
        let make = || {
            let sort = Sort::new(device, capacity, None)?;
            Ok((sort, device.buffer("ordered contacts", bytes, U::STORAGE | U::COPY_SRC)?))
        };
        let ((sort, ordered), bytes) = device.counting(make)?;
        Ok(Self { sort, ordered, bytes })
    }

    /// Contacts that fit.
    pub fn capacity(&self) -> u32 {
        self.sort.capacity()
    }

    /// Puts the contacts of a list in order if there are at most `n`.
    pub fn run(&self, recorder: &mut Recorder, frame: &Frame, contacts: &List, n: u32) {
        let bits = |greatest: u32| 32 - greatest.leading_zeros();
        let [vertices, edges, faces] = frame.count;
        let dispatch = Dispatch { n, capacity_in: contacts.capacity(), ..Dispatch::default() };
        let contacts = contacts.buffer();
        let mut half = 0;
        for (pass, bits) in [(0, bits(edges.max(faces))), (1, bits(vertices + edges))] {
            let p = Params { frame: *frame, dispatch, args: ContactSort { pass } };
            let [keys, order] = self.sort.half(half);
            recorder.each(&ContactKeys { contacts, keys, order }, &p, n);
            half = self.sort.run(recorder, n, bits, half);
        }
        let p = Params { frame: *frame, dispatch, args: Plain::default() };
        let [_, order] = self.sort.half(half);
        recorder.each(&OrderContacts { contacts, order, ordered: &self.ordered }, &p, n);
    }
}
