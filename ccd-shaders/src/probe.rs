//! Kernels for tests, and to say what a device flushes: where it sees the fields of records, and
//! what it makes of scalar operations.

use crate::entry::kernel;
use crate::workgroup::group;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::kernel::{Id, probe};
use ccd_core::backend::layout::{Leaf, Pair, Path, Touch};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::ProbeScalars.threads();

kernel! {
    /// Writes what each field of one record of every type holds, in the order of the fields.
    probe_layout[64](t; params: Blocks;; paths: [Path], leaves: [Leaf], touches: [Touch],
        pairs: [Pair], mut words: [u32]) {
        if t.lane == 0 {
            // The second record of each, so that the stride counts.
            probe::params(params, words);
            probe::records(&at(paths, 1), &at(leaves, 1), &at(touches, 1), &at(pairs, 1), words);
        }
    }
}

/// Thread `i` applies every scalar operation that kernels use to the `i`-th two inputs.
#[spirv(compute(threads(64)))]
pub fn probe_scalars(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] inputs: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] results: &mut [[u32; 24]],
) {
    let i = (group(id, n) * THREADS + lane) as usize;
    if i < inputs.len() {
        put(results, i, probe::scalars(at(inputs, i)));
    }
}

/// As `probe_scalars`, for `f64` and 64-bit integers; an input is two words.
#[spirv(compute(threads(64)))]
pub fn probe_wide(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] inputs: &[[u32; 4]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] results: &mut [[u32; 28]],
) {
    let i = (group(id, n) * THREADS + lane) as usize;
    if i < inputs.len() {
        put(results, i, probe::wide(at(inputs, i)));
    }
}
