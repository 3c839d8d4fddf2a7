//! Headers of many lists: set to zero, and gathered where they are read together, by kernels that
//! take some lists each. A transfer for each list would cost the device as much as a small kernel,
//! and a barrier before and after it.

use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{HEADER_BYTES, List};
use crate::recorder::Recorder;
use ccd_core::kernel::Id;
use ccd_core::layout::{Dispatch, LIST_HEADER, Params, Plain};
use wgpu::BufferUsages as U;

/// Lists whose headers one kernel clears.
const CLEARED: usize = 8;
/// Lists whose headers one kernel gathers.
const GATHERED: usize = 6;

/// What the kernels need besides the lists.
pub struct ListHeaders {
    gathered: wgpu::Buffer,
    /// Bound in the place of lists that are cleared, where there are fewer.
    spare: Vec<wgpu::Buffer>,
}

impl ListHeaders {
    /// For at most so many lists.
    pub fn new(device: &Device, n_lists: usize) -> Result<Self, Error> {
        let bytes = HEADER_BYTES * n_lists.next_multiple_of(GATHERED) as u64;
        let spare = |_| device.buffer("no list", HEADER_BYTES, U::STORAGE);
        Ok(Self {
            gathered: device.buffer("headers of lists", bytes, U::STORAGE | U::COPY_SRC)?,
            spare: (1..CLEARED).map(spare).collect::<Result<_, _>>()?,
        })
    }

    /// Sets the headers of lists to zero.
    pub fn clear(&self, recorder: &mut Recorder, lists: &[&List]) {
        for lists in lists.chunks(CLEARED) {
            let all = lists.iter().map(|list| list.buffer()).chain(&self.spare);
            let bound: Vec<&wgpu::Buffer> = all.take(CLEARED).collect();
            recorder.run(Id::ClearHeaders, Params::<Plain>::default().parts(), &bound, 1);
        }
    }

    /// Copies the headers of lists to [`ListHeaders::gathered`], in their order.
    pub fn gather(&self, recorder: &mut Recorder, lists: &[&List]) {
        for (part, lists) in lists.chunks(GATHERED).enumerate() {
            let first = (part * GATHERED * LIST_HEADER) as u32;
            let params = Params::<Plain> {
                dispatch: Dispatch { first, ..Dispatch::default() },
                ..Params::default()
            };
            // Places that are left have the last list again.
            let mut bound: Vec<&wgpu::Buffer> = lists.iter().map(|list| list.buffer()).collect();
            bound.resize(GATHERED, bound[lists.len() - 1]);
            bound.push(&self.gathered);
            recorder.run(Id::GatherHeaders, params.parts(), &bound, 1);
        }
    }

    /// Headers that were gathered, one after the other.
    pub fn gathered(&self) -> &wgpu::Buffer {
        &self.gathered
    }
}
