//! Kernels for tests alone: where a device sees the fields of records, and what it makes of scalar operations.

use crate::share::group;
use ccd_core::kernel::probe;
use ccd_core::layout::{Leaf, Pair, Params, Path, Touch};
use ccd_core::kernel::memory::{at, put};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

/// Writes what each field of one record of every type holds, in the order of the fields.
#[spirv(compute(threads(64)))]
pub fn probe_layout(
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] leaves: &[Leaf],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] touches: &[Touch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] pairs: &[Pair],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] out: &mut [u32],
) {
    if lane == 0 {
        // The second record of each, so that the stride counts.
        probe::params(params, out);
        probe::records(&at(paths, 1), &at(leaves, 1), &at(touches, 1), &at(pairs, 1), out);
    }
}

/// Thread `i` applies every scalar operation that kernels use to the `i`-th two inputs.
#[spirv(compute(threads(64)))]
pub fn probe_scalars(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] inputs: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: &mut [[u32; 24]],
) {
    let i = (group(id, n) * 64 + lane) as usize;
    if i < inputs.len() {
        put(out, i, probe::scalars(at(inputs, i)));
    }
}

/// As `probe_scalars`, for `f64` and 64-bit integers; an input is two words.
#[spirv(compute(threads(64)))]
pub fn probe_wide(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] inputs: &[[u32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] out: &mut [[u32; 24]],
) {
    let i = (group(id, n) * 64 + lane) as usize;
    if i < inputs.len() {
        put(out, i, probe::wide(at(inputs, i)));
    }
}
