//! The binary radix tree: its branches, its boxes, and traversal with a stack. The boxes are set 1 of a block tree and the only set.

use crate::share::{count, group};
use ccd_core::Aabb;
use ccd_core::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::broad_phase::{block_bvh, radix_tree};
use ccd_core::layout::{Branch, LIST_HEADER, Leaf, Node, Pair, Params};
use ccd_core::kernel::memory::{at, put};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = 256;
/// Threads of a traversal's workgroup: fewer, because one that is done waits for the others.
const WALKERS: u32 = 128;
const SET: usize = 1;

/// Thread `i` finds children and range of internal node `i`.
#[spirv(compute(threads(256)))]
pub fn branches(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] keys: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] out: &mut [Branch],
) {
    let i = group(id, n) * THREADS + lane;
    if i + 1 < params.count[SET] {
        put(out, i as usize, radix_tree::branch(i, params.count[SET], keys));
    }
}

/// Thread `i` boxes internal node `i`, and writes leaf `i`.
#[spirv(compute(threads(256)))]
pub fn branch_boxes(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] branches: &[Branch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] block_nodes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] leaves: &[Leaf],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] out: &mut [Node],
) {
    let i = group(id, n) * THREADS + lane;
    let n_leaves = params.count[SET];
    if i + 1 < n_leaves {
        let branch = at(branches, i as usize);
        let b = block_bvh::range_box(params, SET, branch.first, branch.last, block_nodes);
        put(out, i as usize, Node { min: b.min, left: branch.left, max: b.max, right: branch.right });
    }
    if i < n_leaves {
        let slot = block_bvh::slot(params, 0, SET, i);
        let b = at(block_nodes, slot);
        put(out, (n_leaves - 1 + i) as usize, Node { min: b.min, left: at(leaves, slot).id, max: b.max, right: Node::LEAF });
    }
}

/// Appends a pair; one for which there is no room is only counted.
#[inline(always)]
fn append(list: &mut [u32], room: u32, pair: Pair) {
    let i = count(list, 0, 1);
    if i < room {
        put(list, LIST_HEADER + 2 * i as usize, pair.a);
        put(list, LIST_HEADER + 2 * i as usize + 1, pair.b);
    }
}

/// Thread `i` finds the leaves after leaf `params.first + i` that overlap it.
#[spirv(compute(threads(128)))]
pub fn traverse_half(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] branches: &[Branch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] out: &mut [u32],
) {
    let i = group(id, n) * WALKERS + lane;
    if i < params.n {
        let n_internal = params.count[SET] - 1;
        let leaf_idx = params.first + i;
        let leaf = at(nodes, (n_internal + leaf_idx) as usize);
        let query = leaf.aabb();
        let mut walk = Walk::new();
        for _ in 0..n_internal {
            if !walk.goes_on {
                break;
            }
            let found = walk.step(&query, nodes, branches, n_internal, leaf_idx);
            if found[0] != NONE {
                append(out, params.room_out, Pair::ordered(leaf.left, found[0]));
            }
            if found[1] != NONE {
                append(out, params.room_out, Pair::ordered(leaf.left, found[1]));
            }
        }
    }
}

/// Thread `i` finds the leaves that overlap loose box `params.first + i`.
#[spirv(compute(threads(128)))]
pub fn traverse_against(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] branches: &[Branch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] out: &mut [u32],
) {
    let i = group(id, n) * WALKERS + lane;
    if i < params.n {
        let n_internal = params.count[SET] - 1;
        let a = params.first + i;
        let query = at(boxes, a as usize);
        let mut walk = Walk::new();
        for _ in 0..n_internal {
            if !walk.goes_on {
                break;
            }
            let found = walk.step(&query, nodes, branches, n_internal, NONE);
            if found[0] != NONE {
                append(out, params.room_out, Pair { a, b: found[0] });
            }
            if found[1] != NONE {
                append(out, params.room_out, Pair { a, b: found[1] });
            }
        }
    }
}
