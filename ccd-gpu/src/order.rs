//! Contacts in their canonical order, sorted where they were found: by `b`, then by kind and `a`.

use crate::device::Device;
use crate::error::Error;
use crate::list::List;
use crate::recorder::Recorder;
use crate::sort::Sort;
use ccd_core::kernel::Id;
use ccd_core::layout::{Params, Touch};
use wgpu::BufferUsages as U;

/// From this many contacts on, sorting them on the device takes less time than on a thread of the host.
pub const FEWEST: u32 = 4096;

/// What the sort of contacts needs.
pub struct Order {
    sort: Sort,
    /// Contacts in order, without a header.
    pub ordered: wgpu::Buffer,
}

impl Order {
    /// For so many contacts at most.
    pub fn new(device: &Device, room: u32) -> Result<Self, Error> {
        let bytes = room as u64 * size_of::<Touch>() as u64;
        Ok(Self { sort: Sort::new(device, room)?, ordered: device.buffer("ordered contacts", bytes, U::STORAGE | U::COPY_SRC)? })
    }

    /// Contacts for which there is room.
    pub fn room(&self) -> u32 {
        self.sort.room()
    }

    /// Puts the contacts of a list in order if there are at most `n`. `params`: of the frame.
    pub fn run(&self, recorder: &mut Recorder, params: &Params, contacts: &List, n: u32) {
        let bits = |greatest: u32| 32 - greatest.leading_zeros();
        let [vertices, edges, faces] = params.count;
        let mut half = 0;
        for (level, bits) in [bits(edges.max(faces)), bits(vertices + edges)].into_iter().enumerate() {
            let p = Params { level: level as u32, n, room_in: contacts.room(), ..*params };
            let [keys, order] = self.sort.half(half);
            recorder.each(Id::ContactKeys, &p, &[contacts.buffer(), keys, order], n);
            half = self.sort.run(recorder, n, bits, half);
        }
        let p = Params { n, room_in: contacts.room(), ..*params };
        recorder.each(Id::OrderContacts, &p, &[contacts.buffer(), self.sort.half(half)[1], &self.ordered], n);
    }
}
