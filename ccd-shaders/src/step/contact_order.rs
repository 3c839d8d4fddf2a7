//! Contacts into their canonical order; the sorts between are those of `sort.rs`.

use crate::workgroup::{group, length};
use ccd_core::kernel::memory::{at, put};
use ccd_core::kernel::{Id, contact_order};
use ccd_core::layout::{ContactSort, LIST_HEADER, Params, TOUCH_WORDS};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::ContactKeys.threads();

/// Thread `i` writes the key of the contact that is `i`-th so far; in the first of two sorts that
/// is the one of number `i`.
#[spirv(compute(threads(256)))]
pub fn contact_keys(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<ContactSort>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] contacts: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] keys: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] order: &mut [u32],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.dispatch.n {
        let mut contact = i;
        if params.own.pass == 0 {
            put(order, i as usize, i);
        } else {
            contact = at(order, i as usize);
        }
        put(keys, i as usize, contact_order::key(contact, contacts, params));
    }
}

/// Thread `i` copies the contact that is `i`-th in order; `ordered` has no header.
#[spirv(compute(threads(256)))]
pub fn order_contacts(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] contacts: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] order: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] ordered: &mut [u32],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.dispatch.n.min(length(contacts, params.dispatch.room_in)) {
        let from = LIST_HEADER + TOUCH_WORDS * at(order, i as usize) as usize;
        for k in 0..TOUCH_WORDS {
            put(ordered, TOUCH_WORDS * i as usize + k, at(contacts, from + k));
        }
    }
}
