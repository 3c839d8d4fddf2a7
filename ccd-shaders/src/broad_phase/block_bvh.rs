//! Boxes of the block tree: a workgroup fits eight nodes, 32 children each.

use crate::records::{BoxWords, box_at, leaf_words};
use crate::workgroup::{barrier, get, group, set};
use ccd_core::Aabb;
use ccd_core::broad_phase::block_bvh::{set_of, slot};
use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{Blocks, Frame, Leaf, Params};
use spirv_std::glam::{UVec3, UVec4};
use spirv_std::spirv;

/// Unites the boxes of 32 threads each; thread 0 of each 32 gets the result.
#[inline(always)]
fn unite(lane: u32, own: Aabb, shared: &mut [Aabb; 256]) -> Aabb {
    let mut merged = own;
    set(shared, lane, merged);
    let mut half = 16;
    for _ in 0..5 {
        barrier();
        if lane % 32 < half {
            merged = merged.union(&get(shared, lane + half));
            set(shared, lane, merged);
        }
        half /= 2;
    }
    merged
}

/// Leaves in sorted order, and the nodes above them. Thread `i` owns leaf `i` of all sets; the
/// first thread of 32 their node.
#[spirv(compute(threads(256)))]
pub fn fit_leaves(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] shared: &mut [Aabb; 256],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] order: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] edges: &[[u32; 2]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] faces: &[[u32; 3]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] nodes: &mut [BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] leaves: &mut [UVec4],
) {
    let i = group(id, n) * 256 + lane;
    let set = set_of(&params.own.slots[0], i);
    let k = i - params.own.slots[0][set];
    let there = i < params.own.slots[0][3];
    let mut own = Aabb::EMPTY;
    let mut leaf = Leaf { vertices: [0; 3], id: Leaf::NONE };
    if there && k < params.frame.count[set] {
        let at_box = at(order, (params.frame.start[set] + k) as usize);
        own = box_at(boxes, at_box as usize);
        let feature = at_box - params.frame.start[set];
        leaf.id = feature;
        leaf.vertices = [feature; 3];
        if params.frame.has(Frame::FLAG_TOPOLOGY) {
            if set == 1 {
                let e = at(edges, feature as usize);
                leaf.vertices = [e[0], e[1], e[1]];
            } else if set == 2 {
                leaf.vertices = at(faces, feature as usize);
            }
        }
    }
    let node = unite(lane, own, shared);
    if there {
        put(nodes, i as usize, BoxWords::of(&own));
        put(leaves, i as usize, leaf_words(&leaf));
        if lane % 32 == 0 {
            put(nodes, slot(&params.own, 1, set, k / 32), BoxWords::of(&node));
        }
    }
}

/// Nodes of level `own.level + 1` from those of level `own.level`. Thread `i` reads node `i` of all
/// sets.
#[spirv(compute(threads(256)))]
pub fn fit_level(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] shared: &mut [Aabb; 256],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &mut [BoxWords],
) {
    let first = params.own.slots[params.own.level as usize];
    let i = first[0] + group(id, n) * 256 + lane;
    let set = set_of(&first, i);
    let there = i < first[3];
    let mut own = Aabb::EMPTY;
    if there {
        own = box_at(nodes, i as usize);
    }
    let node = unite(lane, own, shared);
    if there && lane % 32 == 0 {
        let to = slot(&params.own, params.own.level + 1, set, (i - first[set]) / 32);
        put(nodes, to, BoxWords::of(&node));
    }
}
