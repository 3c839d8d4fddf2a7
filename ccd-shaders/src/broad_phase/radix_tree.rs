//! The binary radix tree: its branches, its boxes, and traversal with a stack. The boxes are set 1
//! of a block tree and the only set.

use crate::workgroup::{append, group};
use ccd_core::Aabb;
use ccd_core::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::broad_phase::{block_bvh, radix_tree};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{Blocks, Branch, Leaf, Node, Pair, Params};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::Branches.threads();
/// Threads of a traversal's workgroup: fewer, because one that is done waits for the others.
const WALKERS: u32 = Id::TraverseHalf.threads();
const SET: usize = 1;

/// Thread `i` finds children and range of internal node `i`.
#[spirv(compute(threads(256)))]
pub fn branches(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] keys: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] branches: &mut [Branch],
) {
    let i = group(id, n) * THREADS + lane;
    if i + 1 < params.frame.count[SET] {
        put(branches, i as usize, radix_tree::branch(i, params.frame.count[SET], keys));
    }
}

/// Thread `i` boxes internal node `i`, and writes leaf `i`.
#[spirv(compute(threads(256)))]
pub fn branch_boxes(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] branches: &[Branch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] block_nodes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] leaves: &[Leaf],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] nodes: &mut [Node],
) {
    let i = group(id, n) * THREADS + lane;
    let n_leaves = params.frame.count[SET];
    if i + 1 < n_leaves {
        let branch = at(branches, i as usize);
        let b = block_bvh::range_box(&params.own, SET, branch.first, branch.last, block_nodes);
        put(
            nodes,
            i as usize,
            Node { min: b.min, left: branch.left, max: b.max, right: branch.right },
        );
    }
    if i < n_leaves {
        let slot = block_bvh::slot(&params.own, 0, SET, i);
        let b = at(block_nodes, slot);
        put(
            nodes,
            (n_leaves - 1 + i) as usize,
            Node { min: b.min, left: at(leaves, slot).id, max: b.max, right: Node::LEAF },
        );
    }
}

/// Thread `i` finds the leaves after leaf `dispatch.first + i` that overlap it.
#[spirv(compute(threads(128)))]
pub fn traverse_half(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] branches: &[Branch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] pairs: &mut [u32],
) {
    let i = group(id, n) * WALKERS + lane;
    if i < params.dispatch.n {
        let leaf_idx = params.dispatch.first + i;
        let leaf = at(nodes, (params.frame.count[SET] - 1 + leaf_idx) as usize);
        traverse(params, leaf.left, true, leaf_idx, &leaf.aabb(), nodes, branches, pairs);
    }
}

/// Thread `i` finds the leaves that overlap loose box `dispatch.first + i`.
#[spirv(compute(threads(128)))]
pub fn traverse_against(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] branches: &[Branch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] pairs: &mut [u32],
) {
    let i = group(id, n) * WALKERS + lane;
    if i < params.dispatch.n {
        let a = params.dispatch.first + i;
        traverse(params, a, false, NONE, &at(boxes, a as usize), nodes, branches, pairs);
    }
}

/// Appends the pairs of box `a` with the leaves after leaf `after` that overlap `query`; `one_set`:
/// the lesser id first.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
fn traverse(
    params: &Params,
    a: u32,
    one_set: bool,
    after: u32,
    query: &Aabb,
    nodes: &[Node],
    branches: &[Branch],
    pairs: &mut [u32],
) {
    let n_internal = params.frame.count[SET] - 1;
    let mut walk = Walk::new();
    for _ in 0..n_internal {
        if !walk.goes_on {
            break;
        }
        let found = walk.step(query, nodes, branches, n_internal, after);
        append_found(pairs, params.dispatch.room_out, one_set, a, found[0]);
        append_found(pairs, params.dispatch.room_out, one_set, a, found[1]);
    }
}

#[inline(always)]
fn append_found(pairs: &mut [u32], room: u32, one_set: bool, a: u32, found: u32) {
    if found != NONE {
        append(pairs, room, if one_set { Pair::ordered(a, found) } else { Pair { a, b: found } });
    }
}
