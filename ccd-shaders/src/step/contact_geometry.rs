//! Geometry of contacts that are listed: every workgroup takes its share of the list, entry `i`
//! goes to record `i`.

use crate::workgroup::{group, part};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::put;
use ccd_core::layout::{Params, Path, Placing, TouchGeometry};
use ccd_core::narrow_phase::{decide, touch_geometry};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::ContactGeometry.threads();

/// Thread `i` writes the geometry of contact `dispatch.first + i`, from paths.
#[spirv(compute(threads(64)))]
pub fn contact_geometry(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Placing>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] edges: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] faces: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] contacts: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] geometry: &mut [TouchGeometry],
) {
    let (own, groups) = (group(id, n), n.x * n.y);
    let there = part(contacts, &params.dispatch);
    for round in 0..decide::rounds(there, own, groups, THREADS) {
        let i = (own + round * groups) * THREADS + lane;
        if i < there {
            let i = params.dispatch.first + i;
            let record = touch_geometry::narrow(i, params, paths, edges, faces, contacts);
            put(geometry, i as usize, record);
        }
    }
}

/// Thread `i` writes the geometry of contact `dispatch.first + i`, from positions as they were
/// given.
#[spirv(compute(threads(64)))]
pub fn contact_geometry_wide(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] positions: &[[f64; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] edges: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] faces: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] contacts: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] geometry: &mut [TouchGeometry],
) {
    let (own, groups) = (group(id, n), n.x * n.y);
    let there = part(contacts, &params.dispatch);
    for round in 0..decide::rounds(there, own, groups, THREADS) {
        let i = (own + round * groups) * THREADS + lane;
        if i < there {
            let i = params.dispatch.first + i;
            let record = touch_geometry::wide(i, params, paths, positions, edges, faces, contacts);
            put(geometry, i as usize, record);
        }
    }
}
