//! For tests and benches: one kernel by itself, on buffers of the caller's; a device that fails.

use crate::bind::Bind;
use crate::device::Device;
use crate::error::Error;
use crate::readback::{Part, Plan, Readback};
use crate::recorder::{Bench, submit};
use ccd_core::layout::Params;
use wgpu::BufferUsages as U;

/// What goes wrong on a device from now on, in all its sessions.
#[derive(Clone, Debug, Default)]
pub struct Faults {
    /// Calls of the driver that succeed before: buffers, kernels, frames, results.
    pub skip: u32,
    /// Calls after them that fail.
    pub n: u32,
    /// How they fail; `None`: they do not.
    pub error: Option<Error>,
    /// Of sessions that are made from now on, a search begins with two workers that take one turn
    /// in one round, so that pairs are left.
    pub short_rounds: bool,
}

impl Faults {
    /// The fault of the next call, if it has one.
    pub(crate) fn next(&mut self) -> Option<Error> {
        let error = self.error.clone()?;
        if self.skip > 0 {
            self.skip -= 1;
            return None;
        }
        let fails = self.n > 0;
        self.n -= fails as u32;
        fails.then_some(error)
    }
}

/// Lets a device fail; returns what is left of the faults that it had.
pub fn set_faults(device: &Device, faults: Faults) -> Faults {
    std::mem::replace(&mut *device.faults(), faults)
}

/// Runs a kernel with `groups` workgroups and replaces the buffers' contents by what the device has
/// afterwards.
///
/// Lengths are multiples of 4. `fold`: workgroups of a row of the grid, at most; a larger number of
/// workgroups is folded into rows, as it is for more than 65,535. A native kernel is refused on a
/// device that is used through WGSL.
///
/// # Errors
/// [`Error::Unavailable`] for a native kernel through WGSL; what the device refuses.
pub fn run<K: Bind<Vec<u8>>>(
    device: &Device,
    kernel: &mut K,
    params: &Params<K::Own>,
    groups: u32,
    fold: u32,
) -> Result<(), Error> {
    if K::ID.native() {
        device.check_native()?;
    }
    let mut bench = Bench::new(device)?;
    bench.fold = fold;
    let usage = U::STORAGE | U::COPY_SRC | U::COPY_DST;
    let mut on_device = Vec::new();
    for bytes in kernel.buffers() {
        let size = (bytes.len() as u64).max(16);
        let label = Some(K::ID.row().name);
        let descriptor = wgpu::BufferDescriptor { label, size, usage, mapped_at_creation: false };
        let buffer = device
            .guarded("a buffer of a test", size, || device.wgpu().create_buffer(&descriptor))?;
        device.write("a buffer of a test", &buffer, 0, bytes)?;
        on_device.push(buffer);
    }
    let mut plan = Plan::default();
    let parts: Vec<Part> = kernel.buffers().iter().map(|b| plan.part(b.len() as u64)).collect();
    let reading = Readback::default().prepare(device, plan)?;
    submit(device, &mut bench, |recorder| {
        recorder.run(K::ID, params.parts(), &on_device.iter().collect::<Vec<_>>(), groups);
        for (part, buffer) in parts.iter().zip(&on_device) {
            recorder.read(&reading, *part, buffer, 0);
        }
    })?;
    reading.with(device, |bytes| {
        for (to, part) in kernel.buffers_mut().into_iter().zip(&parts) {
            to.copy_from_slice(part.of(bytes));
        }
    })
}
