//! For tests and benches: one kernel by itself, on buffers of the caller's; a device that fails;
//! devices whose kernels check their indices.

pub use crate::error::Faults;

use crate::adapter::DeviceOptions;
use crate::bind::Bind;
use crate::device::Device;
use crate::error::Error;
use crate::pipeline::Checked;
use crate::readback::{Part, Plan, Readback, word};
use crate::recorder::{Bench, submit};
use ccd_core::backend::kernel::{Id, TABLE};
use ccd_core::backend::layout::Params;
use std::path::Path;
use wgpu::BufferUsages as U;

/// Lets a device fail; returns what is left of the faults that it had.
pub fn set_faults(device: &Device, faults: Faults) -> Faults {
    std::mem::replace(&mut *device.faults(), faults)
}

/// Runs a kernel with `groups` workgroups and replaces the buffers' contents by what the device has
/// afterwards.
///
/// Lengths are multiples of 4. `fold`: workgroups of a row of the grid, at most; a larger number of
/// workgroups is folded into rows, as it is for more than 65,535. A native kernel is refused on a
/// device that is used through WGSL, one by subgroups where these are smaller or larger.
///
/// # Errors
/// [`Error::Unavailable`] for a kernel that the device cannot run; what the device refuses.
pub fn run<K: Bind<Vec<u8>>>(
    device: &Device,
    kernel: &mut K,
    params: &Params<K::Args>,
    groups: u32,
    fold: u32,
) -> Result<(), Error> {
    repeat(device, kernel, params, groups, fold, 1)
}

/// The same so many times in one recording.
///
/// # Errors
/// Those of [`run`].
pub fn repeat<K: Bind<Vec<u8>>>(
    device: &Device,
    kernel: &mut K,
    params: &Params<K::Args>,
    groups: u32,
    fold: u32,
    times: u32,
) -> Result<(), Error> {
    run_on(device, K::ID, params.parts(), kernel.buffers_mut(), [groups, fold, times])
}

/// The same of any kernel: compiled once for all of them.
fn run_on(
    device: &Device,
    id: Id,
    params: [&[u8]; 3],
    buffers: Vec<&mut Vec<u8>>,
    [groups, fold, times]: [u32; 3],
) -> Result<(), Error> {
    if id.native() {
        device.check_native()?;
    }
    if id.by_subgroups() && !device.info().subgroups {
        let why = format!("{} has no subgroups of 32 threads", device.info().adapter.name);
        return Err(Error::Unavailable { why });
    }
    let mut bench = Bench::new(device)?;
    bench.fold = fold;
    let usage = U::STORAGE | U::COPY_SRC | U::COPY_DST;
    let mut on_device = Vec::new();
    for bytes in &buffers {
        let size = (bytes.len() as u64).max(16);
        let label = Some(id.row().name);
        let descriptor = wgpu::BufferDescriptor { label, size, usage, mapped_at_creation: false };
        let buffer = device
            .guarded("a buffer of a test", size, || device.wgpu().create_buffer(&descriptor))?;
        device.write("a buffer of a test", &buffer, 0, bytes)?;
        on_device.push(buffer);
    }
    let mut plan = Plan::default();
    let parts: Vec<Part> = buffers.iter().map(|b| plan.part(b.len() as u64)).collect();
    let reading = Readback::default().prepare(device, plan)?;
    submit(device, &mut bench, |recorder| {
        let bound: Vec<_> = on_device.iter().collect();
        recorder.repeat(times, |r| r.run(id, params, &bound, groups));
        for (part, buffer) in parts.iter().zip(&on_device) {
            recorder.read(&reading, *part, buffer, 0);
        }
    })?;
    reading.wait_with(device, |bytes| {
        for (to, part) in buffers.into_iter().zip(&parts) {
            to.copy_from_slice(part.of(bytes));
        }
    })
}

/// Opens a device whose kernels are those that `cargo xtask shaders --checked` has written to a
/// folder: every index is compared with the length, and [`failures`] says how often one was past
/// the end. For tests alone.
///
/// # Errors
/// As [`Device::open`]; [`Error::Unavailable`] where a module cannot be read, or through WGSL,
/// which has checks of its own.
///
/// # Safety
/// The folder holds what that command wrote from the modules of this version: they are handed to
/// the driver as they are.
#[allow(unsafe_code, reason = "wgpu does not check SPIR-V that it passes through")]
pub unsafe fn open_checked(options: &DeviceOptions, folder: &Path) -> Result<Device, Error> {
    let mut device = Device::open(options)?;
    device.check_native()?;
    let module = |name: &str| {
        let path = folder.join(name).with_extension("spv");
        let why = |e| Error::Unavailable { why: format!("{}: {e}", path.display()) };
        std::fs::read(&path).map_err(why)
    };
    let modules = TABLE.iter().map(|row| module(row.name)).collect::<Result<_, _>>()?;
    let bytes = Checked::STRIDE * TABLE.len() as u64;
    let status = device.buffer("a status", bytes, U::STORAGE | U::COPY_SRC | U::COPY_DST)?;
    device.set_checked(Checked { modules, status });
    Ok(device)
}

/// Kernels that used an index past the end since the last call, and how often; `None` if the device
/// is none of [`open_checked`].
///
/// # Errors
/// What the device refuses.
pub fn failures(device: &Device) -> Result<Option<Vec<(&'static str, u32)>>, Error> {
    let Some(Checked { status, .. }) = device.checked() else { return Ok(None) };
    let mut plan = Plan::default();
    let part = plan.part(status.size());
    let reading = Readback::default().prepare(device, plan)?;
    submit(device, &mut Bench::new(device)?, |recorder| {
        recorder.read(&reading, part, status, 0);
        recorder.clear(status, status.size());
    })?;
    reading.wait_with(device, |bytes| {
        let counts = TABLE.iter().zip(bytes.chunks_exact(Checked::STRIDE as usize));
        Some(
            counts.map(|(row, bytes)| (row.name, word(bytes, 0))).filter(|(_, n)| *n > 0).collect(),
        )
    })
}
