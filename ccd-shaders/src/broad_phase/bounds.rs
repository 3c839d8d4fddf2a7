//! Bounds of all boxes, and the keys by which boxes are sorted.

use crate::records::BoxWords;
use crate::workgroup::{barrier, get, group, raise, set};
use ccd_core::Aabb;
use ccd_core::broad_phase::{block_bvh, morton_key};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::put;
use ccd_core::layout::Params;
use ccd_core::math::morton::MortonGrid;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::SceneBounds.threads();

/// A workgroup merges `THREADS * CHUNK` of the first `dispatch.n` boxes, and its first thread
/// merges that into the six words of `words`, zero before.
#[spirv(compute(threads(256)))]
pub fn scene_bounds(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] shared: &mut [Aabb; 256],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: &mut [u32],
) {
    let first = (group(id, n) * THREADS * morton_key::CHUNK as u32 + lane) as usize;
    let mut merged =
        morton_key::scene_bounds(first, THREADS as usize, boxes, params.dispatch.n as usize);
    set(shared, lane, merged);
    let mut half = THREADS / 2;
    for _ in 0..8 {
        barrier();
        if lane < half {
            merged = merged.union(&get(shared, lane + half));
            set(shared, lane, merged);
        }
        half /= 2;
    }
    if lane == 0 {
        for k in 0..6 {
            raise(words, k, morton_key::shared_word(&merged, k));
        }
    }
}

/// Thread `i` writes the sort key of box `i`, and `i`.
#[spirv(compute(threads(256)))]
pub fn morton(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] keys: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] order: &mut [u32],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.frame.start[3] {
        let set = block_bvh::set_of(&params.frame.start, i);
        let grid = MortonGrid::new(&morton_key::merged(words), 10);
        put(keys, i as usize, morton_key::sort_key(i as usize, set, boxes, &grid));
        put(order, i as usize, i);
    }
}
