//! The binary radix tree over one set: its branches, its boxes, and traversal with a stack.

use crate::workgroup::{append, group};
use ccd_core::Aabb;
use ccd_core::broad_phase::block_bvh::{self, sets};
use ccd_core::broad_phase::radix_tree;
use ccd_core::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{Blocks, Branch, Leaf, Node, Pair, Params, Queries};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

const THREADS: u32 = Id::Branches.threads();
/// Threads of a traversal's workgroup: fewer, because one that is done waits for the others.
const WALKERS: u32 = Id::TraverseHalf.threads();
/// The set within which pairs are looked for.
const SET: usize = 1;

/// Thread `i` finds children and range of internal node `i` of the tree over set `own.kind`.
#[spirv(compute(threads(256)))]
pub fn branches(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] keys: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] branches: &mut [Branch],
) {
    let i = group(id, n) * THREADS + lane;
    let set = params.own.kind as usize;
    let n_leaves = params.frame.count[set];
    if i + 1 < n_leaves {
        let branch = radix_tree::branch_from(i, params.frame.start[set], n_leaves, keys);
        put(branches, i as usize, branch);
    }
}

/// Thread `i` boxes internal node `i` of the tree over set `own.kind`, and writes leaf `i`.
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
    let set = params.own.kind as usize;
    let n_leaves = params.frame.count[set];
    if i + 1 < n_leaves {
        let branch = at(branches, i as usize);
        let b = block_bvh::range_box(&params.own, set, branch.first, branch.last, block_nodes);
        put(
            nodes,
            i as usize,
            Node { min: b.min, left: branch.left, max: b.max, right: branch.right },
        );
    }
    if i < n_leaves {
        let slot = block_bvh::slot(&params.own, 0, set, i);
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
        let n_internal = params.frame.count[SET] - 1;
        let mut walk = Walk::new();
        for _ in 0..n_internal {
            if !walk.goes_on {
                break;
            }
            let found = walk.step(&leaf.aabb(), nodes, branches, n_internal, leaf_idx);
            keep_ordered(params, leaf.left, found[0], pairs);
            keep_ordered(params, leaf.left, found[1], pairs);
        }
    }
}

/// Appends a pair that was found.
#[inline(always)]
fn keep_ordered(params: &Params, a: u32, found: u32, pairs: &mut [u32]) {
    if found != NONE {
        append(pairs, params.dispatch.room_out, Pair::ordered(a, found));
    }
}

/// Thread `i` finds the leaves that overlap query `dispatch.first + i`; of the first set, which may
/// be that of the leaves: then it keeps those of a greater id than its own.
#[spirv(compute(threads(128)))]
pub fn traverse_full(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Queries>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] order: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] nodes: &[Node],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] branches: &[Branch],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] pairs: &mut [u32],
) {
    let i = group(id, n) * WALKERS + lane;
    if i < params.dispatch.n {
        let [queries, tree] = sets(params.own.kind);
        let mut a = params.frame.start[queries] + params.dispatch.first + i;
        if params.own.sorted != 0 {
            a = at(order, a as usize);
        }
        let query = at(boxes, a as usize);
        let a = a - params.frame.start[queries];
        let n_internal = params.frame.count[tree] - 1;
        // A tree of one leaf has no internal node.
        if n_internal == 0 {
            let leaf = at(nodes, 0);
            if leaf.aabb().overlaps(&query) {
                keep(params, a, leaf.left, pairs);
            }
        }
        let mut walk = Walk::new();
        for _ in 0..n_internal {
            if !walk.goes_on {
                break;
            }
            let found = walk.step(&query, nodes, branches, n_internal, NONE);
            keep(params, a, found[0], pairs);
            keep(params, a, found[1], pairs);
        }
    }
}

/// Appends a pair that was found, once.
#[inline(always)]
fn keep(params: &Params<Queries>, a: u32, found: u32, pairs: &mut [u32]) {
    if found != NONE && (params.own.kind == 0 || found > a) {
        append(pairs, params.dispatch.room_out, Pair { a, b: found });
    }
}
