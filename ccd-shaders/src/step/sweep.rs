//! Paths of vertices and swept boxes: thread `i` makes what is of item `i`.

use crate::workgroup::group;
use ccd_core::Aabb;
use ccd_core::broad_phase::{placement, swept_box};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{Params, Path};
use ccd_core::narrow_phase::decide;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::SweepVertices.threads();

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
    if i < params.frame.count[0] {
        let (p, q) = placement::given(i, &params.frame, positions);
        let exact = placement::exact_box(p, q, &params.frame);
        put(paths, i as usize, placement::path(p, q, &params.frame));
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
    if i < params.frame.count[0] {
        put(boxes, i as usize, swept_box::path(&at(paths, i as usize), params.frame.margin));
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
    if i < params.frame.count[1] {
        let swept = swept_box::edge(i as usize, edges, boxes);
        put(boxes, (params.frame.start[1] + i) as usize, swept);
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
    if i < params.frame.count[2] {
        let swept = swept_box::face(i as usize, faces, boxes);
        put(boxes, (params.frame.start[2] + i) as usize, swept);
    }
}

/// Thread `i` cuts path `i` to the times that matter, which end at the earliest time of impact so
/// far; `of_vf` and `of_ee` hold the bits of those of each kind, or a greater number if there is
/// none.
#[spirv(compute(threads(256)))]
pub fn shorten(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] paths: &[Path],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] of_vf: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] of_ee: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] shortened: &mut [Path],
) {
    let i = group(id, n) * THREADS + lane;
    if i < params.frame.count[0] {
        let until = decide::until(at(of_vf, 0).min(at(of_ee, 0)));
        let until = if until < params.frame.until { until } else { params.frame.until };
        let path = swept_box::shorten(&at(paths, i as usize), params.frame.from, until);
        put(shortened, i as usize, path);
    }
}
