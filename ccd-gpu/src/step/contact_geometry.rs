//! Point, normal and weights of the contacts on a device, written where they are.

use super::buffers::Buffers;
use super::passes::DISPATCH_LIMIT;
use crate::bind::{ContactGeometry, ContactGeometryWide};
use crate::device::Device;
use crate::error::Error;
use crate::growable_list::{List, parts};
use crate::recorder::{Bench, Recorder};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::layout::{Frame, Params, Plain, TouchGeometry};
use ccd_core::model::options::Options;
use wgpu::BufferUsages as U;

/// A record for each contact that the list can hold.
#[derive(Default)]
pub struct Geometry {
    /// Whether the list of contacts on the device is that of the last call.
    pub listed: bool,
    /// Made when first asked for.
    made: Option<Made>,
    /// What it takes, under a limit of memory.
    bytes: u64,
}

struct Made {
    buffer: wgpu::Buffer,
    capacity: u32,
    /// Parameters and bind groups of its own, because the frame in the same encoder is not
    /// submitted yet.
    bench: Bench,
}

impl Made {
    fn new(device: &Device, contacts: &List) -> Result<Self, Error> {
        let capacity = contacts.capacity();
        let n_parts = capacity.div_ceil(DISPATCH_LIMIT) as u64;
        let bytes = capacity as u64 * size_of::<TouchGeometry>() as u64;
        let usage = U::STORAGE | U::COPY_SRC;
        let buffer = device.buffer("geometry of contacts", bytes, usage)?;
        Ok(Self { buffer, capacity, bench: Bench::of(device, n_parts.max(1))? })
    }
}

impl Geometry {
    /// Records what fills the buffer from the contacts that the last call listed, into an encoder
    /// after it.
    pub fn record(
        &mut self,
        device: &Device,
        buffers: &Buffers,
        options: &Options,
        encoder: &mut wgpu::CommandEncoder,
    ) -> Result<&wgpu::Buffer, Error> {
        if !self.listed {
            return Err(Error::NoContacts);
        }
        let capacity = buffers.contacts.capacity();
        if self.made.as_ref().is_none_or(|made| made.capacity < capacity) {
            let (made, bytes) = device.counting(|| Made::new(device, &buffers.contacts))?;
            device.give_back(std::mem::replace(&mut self.bytes, bytes));
            self.made = Some(made);
        }
        let Some(Made { buffer, bench, .. }) = &mut self.made else {
            return Err(Error::NoContacts);
        };
        // Buffers of the frame may be others than the last time.
        bench.forget();
        let frame = buffers.describe(options, super::WHOLE);
        device.guarded("geometry of contacts", 0, || -> Result<(), Error> {
            let mut recorder = bench.record();
            dispatch(&mut recorder, buffers, &frame, buffer, device.info().wide);
            recorder.finish(encoder).map(|_| ())
        })??;
        Ok(buffer)
    }
}

fn dispatch(
    recorder: &mut Recorder,
    buffers: &Buffers,
    frame: &Frame,
    geometry: &wgpu::Buffer,
    wide: bool,
) {
    let frame = Frame { path_error: buffers.positions.path_error(), ..*frame };
    let (paths, positions) = (buffers.positions.paths(), &buffers.positions.wide);
    let (elements, contacts) = (&buffers.elements, buffers.contacts.buffer());
    for dispatch in parts(buffers.contacts.capacity(), DISPATCH_LIMIT, 0) {
        let groups = buffers.groups.min(dispatch.n.div_ceil(Id::ContactGeometry.threads()));
        if wide {
            let p = Params { frame, dispatch, args: Plain::default() };
            let kernel = ContactGeometryWide { paths, positions, elements, contacts, geometry };
            recorder.dispatch(&kernel, &p, groups);
        } else {
            let p = Params { frame, dispatch, args: buffers.positions.placing() };
            let kernel = ContactGeometry { paths, elements, contacts, geometry };
            recorder.dispatch(&kernel, &p, groups);
        }
    }
}
