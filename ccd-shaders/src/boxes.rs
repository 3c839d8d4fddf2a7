//! Swept boxes, bounds of the scene, sort keys.

use crate::share::{barrier, get, group, raise, set};
use ccd_core::Aabb;
use ccd_core::broad_phase::{morton_key, placement, swept_box};
use ccd_core::narrow_phase::decide;
use ccd_core::layout::{Params, Path};
use ccd_core::math::morton::MortonGrid;
use ccd_core::kernel::memory::{at, put};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = 256;

/// Thread `i` makes path and box of vertex `i`, and the keys of its exact box.
#[spirv(compute(threads(256)))]
pub fn place_vertices(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] positions: &[[f64; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] paths: &mut [Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] keys: &mut [[[u32; 2]; 6]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] boxes: &mut [Aabb],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.count[0] {
        let (p, q) = placement::given(i, params, positions);
        let exact = placement::exact_box(p, q, params);
        put(paths, i as usize, placement::path(p, q, params));
        put(keys, i as usize, placement::keys(&exact));
        put(boxes, i as usize, placement::rounded(&exact));
    }
}

/// Thread `i` sweeps vertex `i`.
#[spirv(compute(threads(256)))]
pub fn sweep_vertices(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] boxes: &mut [Aabb],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.count[0] {
        put(boxes, i as usize, swept_box::path(&at(paths, i as usize), params.margin));
    }
}

/// Thread `i` unites the boxes of the vertices of edge `i`.
#[spirv(compute(threads(256)))]
pub fn sweep_edges(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] edges: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] boxes: &mut [Aabb],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.count[1] {
        let swept = swept_box::edge(i as usize, edges, boxes);
        put(boxes, (params.start[1] + i) as usize, swept);
    }
}

/// Thread `i` unites the boxes of the vertices of face `i`.
#[spirv(compute(threads(256)))]
pub fn sweep_faces(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] faces: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] boxes: &mut [Aabb],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.count[2] {
        let swept = swept_box::face(i as usize, faces, boxes);
        put(boxes, (params.start[2] + i) as usize, swept);
    }
}

/// Thread `i` cuts path `i` at the earliest time of impact so far; `of_vf` and `of_ee` hold the bits of those of each kind, or a greater number if there is none.
#[spirv(compute(threads(256)))]
pub fn shorten(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] of_vf: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] of_ee: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] out: &mut [Path],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.count[0] {
        put(out, i as usize, swept_box::shorten(&at(paths, i as usize), decide::until(at(of_vf, 0).min(at(of_ee, 0)))));
    }
}

/// A workgroup merges `THREADS * CHUNK` of the first `params.n` boxes, and its first thread merges that into the six words of `words`, zero before.
#[spirv(compute(threads(256)))]
pub fn scene_bounds(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] shared: &mut [Aabb; 256],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: &mut [u32],
) {
    let first = (group(id, n) * THREADS * morton_key::CHUNK as u32 + lane) as usize;
    let mut merged = morton_key::scene_bounds(first, THREADS as usize, boxes, params.n as usize);
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
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] words: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] keys: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] order: &mut [u32],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.start[3] {
        let set = ccd_core::broad_phase::block_bvh::set_of(&params.start, i);
        let grid = MortonGrid::new(&morton_key::merged(words), 10);
        put(keys, i as usize, morton_key::sort_key(i as usize, set, boxes, &grid));
        put(order, i as usize, i);
    }
}
