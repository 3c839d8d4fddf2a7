//! One kernel by itself, on buffers of the caller's: for parity tests and benches.

use crate::device::Device;
use crate::error::Error;
use crate::readback::Readback;
use crate::recorder::{Bench, submit};
use ccd_core::kernel::Id;
use ccd_core::layout::Params;
use wgpu::BufferUsages as U;

/// Runs a kernel with `groups` workgroups and replaces the buffers' contents by what the device has afterwards.
///
/// `buffers`: those after the parameters, in the order of the kernel table; lengths are multiples of 4. `fold`: workgroups of a row of the grid, at most; a
/// larger number of workgroups is folded into rows, as it is for more than 65,535.
pub fn run(device: &Device, id: Id, params: &Params, buffers: &mut [Vec<u8>], groups: u32, fold: u32) -> Result<(), Error> {
    let mut bench = Bench::new(device)?;
    bench.fold = fold;
    let usage = U::STORAGE | U::COPY_SRC | U::COPY_DST;
    let mut on_device = Vec::new();
    for bytes in buffers.iter() {
        let size = (bytes.len() as u64).max(16);
        let descriptor = wgpu::BufferDescriptor { label: Some(id.row().name), size, usage, mapped_at_creation: false };
        let buffer = device.guarded("a buffer of a test", size, || device.wgpu().create_buffer(&descriptor))?;
        device.queue().write_buffer(&buffer, 0, bytes);
        on_device.push(buffer);
    }
    let mut readback = Readback::new();
    let parts = readback.plan(device, &buffers.iter().map(|b| b.len() as u64).collect::<Vec<_>>())?;
    submit(device, &mut bench, |recorder| {
        recorder.dispatch(id, params, &on_device.iter().collect::<Vec<_>>(), groups);
        for (part, buffer) in parts.iter().zip(&on_device) {
            readback.copy(recorder, *part, buffer, 0);
        }
    })?;
    for (to, from) in buffers.iter_mut().zip(readback.read(device, &parts)?) {
        *to = from;
    }
    Ok(())
}
