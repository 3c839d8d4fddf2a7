//! The binary radix tree over one set: its nodes, and traversal with a stack.

use crate::records::{BoxWords, NodeWords, box_at, branch_at, branch_words, node_at};
use crate::workgroup::{add, add_shared, append, barrier, get, group, set};
use ccd_core::Aabb;
use ccd_core::broad_phase::block_bvh::{self, sets};
use ccd_core::broad_phase::radix_tree;
use ccd_core::broad_phase::stack_traversal::NONE;
use ccd_core::broad_phase::wide_nodes::{self as wide, TILE, WideWalk};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::{at, put};
use ccd_core::layout::{Blocks, Branch, LIST_HEADER, Leaf, Node, Pair, Params, Queries};
use spirv_std::glam::{UVec3, UVec4};
use spirv_std::spirv;

/// Threads of a workgroup of the branches, and of the far nodes.
const BUILDERS: u32 = Id::Branches.threads();
const FAR: u32 = Id::FarNodes.threads();
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
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] branches: &mut [UVec4],
) {
    let i = group(id, n) * BUILDERS + lane;
    let set = params.own.kind as usize;
    let n_leaves = params.frame.count[set];
    if i + 1 < n_leaves {
        let branch = radix_tree::branch_from(i, params.frame.start[set], n_leaves, keys);
        put(branches, i as usize, branch_words(&branch));
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
    let i = group(id, n) * BUILDERS + lane;
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

/// Thread `i` boxes the children of internal node `i`; see `ccd_core::broad_phase::wide_nodes`.
#[spirv(compute(threads(256)))]
pub fn near_nodes(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] boxes: &mut [Aabb; 512],
    #[spirv(workgroup)] counters: &mut [u32; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] branches: &[UVec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] block_nodes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] nodes: &mut [NodeWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] far: &mut [u32],
) {
    let tile = group(id, n) * TILE;
    let i = tile + lane;
    let of = params.own.kind as usize;
    let n_leaves = params.frame.count[of];
    let mut own = Aabb::EMPTY;
    if i < n_leaves {
        own = box_at(block_nodes, block_bvh::slot(&params.own, 0, of, i));
    }
    set(boxes, lane, own);
    if lane == 0 {
        set(counters, 0, 0);
    }
    let there = i + 1 < n_leaves;
    let mut branch = Branch { left: 0, right: 0, first: tile, last: tile };
    if there {
        branch = branch_at(branches, i as usize);
    }
    let is_near = wide::is_within(tile, &branch);
    let split = radix_tree::last_of_left(&branch, n_leaves - 1);
    // Where both children begin in the tile, and their lengths.
    let (mut left_from, mut left_length, mut right_from, mut right_length) = (0, 0, 0, 0);
    if there && is_near {
        left_from = branch.first - tile;
        left_length = split + 1 - branch.first;
        right_from = split + 1 - tile;
        right_length = branch.last - split;
    }
    let (mut left, mut right) = (Aabb::EMPTY, Aabb::EMPTY);
    barrier();
    for k in 0..wide::POWERS {
        // Box `i` of this half of `boxes` is that of `reach` leaves from `i` on.
        let (half, reach) = ((k & 1) * TILE, 1 << k);
        if left_length >> k == 1 {
            let from = half + left_from;
            left = get(boxes, from).union(&get(boxes, from + left_length - reach));
        }
        if right_length >> k == 1 {
            let from = half + right_from;
            right = get(boxes, from).union(&get(boxes, from + right_length - reach));
        }
        own = own.union(&get(boxes, half + (lane + reach).min(TILE - 1)));
        set(boxes, TILE - half + lane, own);
        barrier();
    }
    if there && is_near {
        let node = wide::wide_node(&branch, split, n_leaves - 1, &left, &right);
        put(nodes, i as usize, NodeWords::of(&node));
    }
    let mut to = 0;
    if there && !is_near {
        to = add_shared(counters, 0, 1);
    }
    barrier();
    if lane == 0 {
        let n_far = get(counters, 0);
        if n_far > 0 {
            set(counters, 1, add(far, 0, n_far));
        }
    }
    barrier();
    if there && !is_near {
        put(far, LIST_HEADER + (get(counters, 1) + to) as usize, i);
    }
}

/// The threads box the children of the nodes that are listed in `far`.
#[spirv(compute(threads(128)))]
pub fn far_nodes(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] branches: &[UVec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] block_nodes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] far: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] nodes: &mut [NodeWords],
) {
    let of = params.own.kind as usize;
    let (n_far, n_internal) = (at(far, 0), params.frame.count[of] - 1);
    let threads = n.x * n.y * FAR;
    for round in 0..n_far.div_ceil(threads) {
        let k = round * threads + group(id, n) * FAR + lane;
        if k >= n_far {
            break;
        }
        let i = at(far, LIST_HEADER + k as usize);
        let branch = branch_at(branches, i as usize);
        let split = radix_tree::last_of_left(&branch, n_internal);
        let left = block_bvh::range_box(&params.own, of, branch.first, split, block_nodes);
        let right = block_bvh::range_box(&params.own, of, split + 1, branch.last, block_nodes);
        let node = wide::wide_node(&branch, split, n_internal, &left, &right);
        put(nodes, i as usize, NodeWords::of(&node));
    }
}

/// Thread `i` finds the leaves after leaf `dispatch.first + i` that overlap it.
#[spirv(compute(threads(128)))]
pub fn traverse_half(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] leaves: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] order: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] nodes: &[NodeWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] pairs: &mut [u32],
) {
    let i = group(id, n) * WALKERS + lane;
    if i < params.dispatch.n {
        let leaf_idx = params.dispatch.first + i;
        let query = box_at(leaves, block_bvh::slot(&params.own, 0, SET, leaf_idx));
        let (first, n_leaves) = (params.frame.start[SET], params.frame.count[SET]);
        let a = at(order, (first + leaf_idx) as usize) - first;
        let mut walk = WideWalk::new();
        for _ in 0..n_leaves - 1 {
            if !walk.goes_on {
                break;
            }
            let node = node_at(nodes, walk.node as usize);
            let found = walk.step(&node, &query, leaf_idx);
            keep_ordered(params, a, order, found[0], pairs);
            keep_ordered(params, a, order, found[1], pairs);
        }
    }
}

/// Appends the pair with a leaf that was found.
#[inline(always)]
pub(super) fn keep_ordered(
    params: &Params<Blocks>,
    a: u32,
    order: &[u32],
    found: u32,
    pairs: &mut [u32],
) {
    if found != NONE {
        let first = params.frame.start[SET];
        let b = at(order, (first + found) as usize) - first;
        append(pairs, params.dispatch.room_out, Pair::ordered(a, b));
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
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] order: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] nodes: &[NodeWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] pairs: &mut [u32],
) {
    let i = group(id, n) * WALKERS + lane;
    if i < params.dispatch.n {
        let [queries, tree] = sets(params.own.kind);
        let mut a = params.frame.start[queries] + params.dispatch.first + i;
        if params.own.sorted != 0 {
            a = at(order, a as usize);
        }
        let query = box_at(boxes, a as usize);
        let a = a - params.frame.start[queries];
        let n_internal = params.frame.count[tree] - 1;
        // A tree of one leaf has no internal node.
        if n_internal == 0 {
            let leaf = box_at(boxes, at(order, params.frame.start[tree] as usize) as usize);
            if leaf.overlaps(&query) {
                keep(params, a, order, 0, pairs);
            }
        }
        let mut walk = WideWalk::new();
        for _ in 0..n_internal {
            if !walk.goes_on {
                break;
            }
            let node = node_at(nodes, walk.node as usize);
            let found = walk.step(&node, &query, NONE);
            keep(params, a, order, found[0], pairs);
            keep(params, a, order, found[1], pairs);
        }
    }
}

/// Appends the pair with a leaf that was found, once.
#[inline(always)]
pub(super) fn keep(params: &Params<Queries>, a: u32, order: &[u32], found: u32, pairs: &mut [u32]) {
    if found != NONE {
        let first = params.frame.start[sets(params.own.kind)[1]];
        let b = at(order, (first + found) as usize) - first;
        if params.own.kind == 0 || b > a {
            append(pairs, params.dispatch.room_out, Pair { a, b });
        }
    }
}
