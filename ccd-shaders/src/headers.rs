//! Headers of several lists at once, by one workgroup: set to zero before a step, and gathered
//! after it to be read together.

use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{LIST_HEADER, Params};
use spirv_std::spirv;

/// Thread `i` sets word `i` of each header to zero.
#[spirv(compute(threads(64)))]
pub fn clear_headers(
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] list_0: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] list_1: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] list_2: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] list_3: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] list_4: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] list_5: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] list_6: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] list_7: &mut [u32],
) {
    let i = lane as usize;
    if i < LIST_HEADER {
        put(list_0, i, 0);
        put(list_1, i, 0);
        put(list_2, i, 0);
        put(list_3, i, 0);
        put(list_4, i, 0);
        put(list_5, i, 0);
        put(list_6, i, 0);
        put(list_7, i, 0);
    }
}

/// Thread `i` copies word `i` of each header.
#[spirv(compute(threads(64)))]
pub fn gather_headers(
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] list_0: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] list_1: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] list_2: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] list_3: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] list_4: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] list_5: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] headers: &mut [u32],
) {
    let i = lane as usize;
    if i < LIST_HEADER {
        let to = params.dispatch.first as usize + i;
        put(headers, to, at(list_0, i));
        put(headers, to + LIST_HEADER, at(list_1, i));
        put(headers, to + 2 * LIST_HEADER, at(list_2, i));
        put(headers, to + 3 * LIST_HEADER, at(list_3, i));
        put(headers, to + 4 * LIST_HEADER, at(list_4, i));
        put(headers, to + 5 * LIST_HEADER, at(list_5, i));
    }
}
