//! Oriented boxes of a binary tree, and traversal with a stack that looks at them; see
//! `ccd_core::broad_phase::oriented_nodes`.

use super::radix_tree::{keep, keep_ordered};
use crate::records::{BoxWords, NodeWords, ObbWords, box_at, branch_at, node_at};
use crate::workgroup::{add, add_shared, barrier, get, group, load, or_shared, raise, set};
use ccd_core::Aabb;
use ccd_core::broad_phase::block_bvh::{self, sets};
use ccd_core::broad_phase::oriented_nodes::{TILE_ROUNDS, is_ready, reaches};
use ccd_core::broad_phase::stack_traversal::NONE;
use ccd_core::broad_phase::wide_nodes::{TILE, WideWalk, is_within};
use ccd_core::kernel::Id;
use ccd_core::kernel::memory::{Stored, at, put};
use ccd_core::layout::{Blocks, Branch, LIST_HEADER, Params, Queries};
use ccd_core::math::obb::Obb;
use spirv_std::glam::{UVec3, UVec4};
use spirv_std::spirv;

const FAR: u32 = Id::OrientFar.threads();
const WALKERS: u32 = Id::TraverseHalfOriented.threads();
/// The set within which pairs are looked for.
const SET: usize = 1;

/// What a thread of [`orient_near`] does with its node.
const NOTHING: u32 = 0;
const OPEN: u32 = 1;
const FITTED: u32 = 2;
const LISTED: u32 = 3;

/// Thread `i` fits internal node `i` of the tree over set `own.kind` once both children are, if all
/// of its leaves are in the tile of the workgroup; it lists all others, which have the box of
/// everything until then.
#[spirv(compute(threads(256)))]
pub fn orient_near(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] boxes: &mut [Obb; 256],
    #[spirv(workgroup)] done: &mut [u32; 8],
    #[spirv(workgroup)] counters: &mut [u32; 2],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] branches: &[UVec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] block_nodes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] oriented: &mut [ObbWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] stamps: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] far: &mut [u32],
) {
    let tile = group(id, n) * TILE;
    let i = tile + lane;
    let of = params.own.kind as usize;
    let n_leaves = params.frame.count[of];
    if lane < 8 {
        set(done, lane, 0);
    }
    if lane < 2 {
        set(counters, lane, 0);
    }
    let mut branch = Branch { left: 0, right: 0, first: tile, last: tile };
    let mut state = NOTHING;
    if i + 1 < n_leaves {
        branch = branch_at(branches, i as usize);
        state = if is_within(tile, &branch) { OPEN } else { LISTED };
    }
    barrier();
    for _ in 0..TILE_ROUNDS {
        let mut ready = 0;
        if state == OPEN {
            ready = is_done(branch.left, tile, n_leaves, done)
                & is_done(branch.right, tile, n_leaves, done);
        }
        barrier();
        if ready != 0 {
            let left = in_tile(params, branch.left, tile, block_nodes, boxes);
            let right = in_tile(params, branch.right, tile, block_nodes, boxes);
            set(boxes, lane, Obb::around_two(&left, &right));
            or_shared(done, lane / 32, 1 << (lane % 32));
            state = FITTED;
        }
        barrier();
    }
    let mut to = 0;
    if state == OPEN || state == LISTED {
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
    let own = (params.frame.start[of] + i) as usize;
    if state == FITTED {
        put(oriented, own, ObbWords::of(&get(boxes, lane)));
        put(stamps, own, 1);
    } else if state != NOTHING {
        put(oriented, own, ObbWords::of(&Obb::everything()));
        put(stamps, own, 0);
        put(far, LIST_HEADER + (get(counters, 1) + to) as usize, i);
    }
}

/// Whether a child of a node in the tile has its box: 1 or 0.
#[inline(always)]
fn is_done(child: u32, tile: u32, n_leaves: u32, done: &[u32; 8]) -> u32 {
    if child + 1 >= n_leaves {
        return 1;
    }
    let lane = child - tile;
    get(done, lane / 32) >> (lane % 32) & 1
}

/// The box of a child of a node in the tile.
#[inline(always)]
fn in_tile(
    params: &Params<Blocks>,
    child: u32,
    tile: u32,
    block_nodes: &[BoxWords],
    boxes: &[Obb; 256],
) -> Obb {
    if child + 1 >= params.frame.count[params.own.kind as usize] {
        of_leaf(params, child, block_nodes)
    } else {
        get(boxes, child - tile)
    }
}

/// The box of a child that is a leaf.
#[inline(always)]
fn of_leaf(params: &Params<Blocks>, child: u32, block_nodes: &[BoxWords]) -> Obb {
    let of = params.own.kind as usize;
    let leaf = child - (params.frame.count[of] - 1);
    let b: Aabb = box_at(block_nodes, block_bvh::slot(&params.own, 0, of, leaf));
    Obb::of_box(&b)
}

/// The threads fit those nodes of a list of which both children were fitted in a dispatch before
/// this one, which is round `dispatch.first`.
#[spirv(compute(threads(128)))]
pub fn orient_far(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] branches: &[UVec4],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] block_nodes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] far: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] oriented: &mut [ObbWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] stamps: &mut [u32],
) {
    let n_far = at(far, 0);
    let first = params.frame.start[params.own.kind as usize];
    let round = params.dispatch.first;
    let threads = n.x * n.y * FAR;
    for part in 0..n_far.div_ceil(threads) {
        let k = part * threads + group(id, n) * FAR + lane;
        if k >= n_far {
            break;
        }
        let i = at(far, LIST_HEADER + k as usize);
        let own = (first + i) as usize;
        if load(stamps, own) == 0 {
            let branch = branch_at(branches, i as usize);
            if was_fitted(params, branch.left, stamps) && was_fitted(params, branch.right, stamps) {
                let left = fitted(params, branch.left, block_nodes, oriented);
                let right = fitted(params, branch.right, block_nodes, oriented);
                put(oriented, own, ObbWords::of(&Obb::around_two(&left, &right)));
                raise(stamps, own, round);
            }
        }
    }
}

/// Whether a child has its box since before this round.
#[inline(always)]
fn was_fitted(params: &Params<Blocks>, child: u32, stamps: &[u32]) -> bool {
    let of = params.own.kind as usize;
    if child + 1 >= params.frame.count[of] {
        return true;
    }
    is_ready(load(stamps, (params.frame.start[of] + child) as usize), params.dispatch.first)
}

/// The box of a child that has one.
#[inline(always)]
fn fitted(
    params: &Params<Blocks>,
    child: u32,
    block_nodes: &[BoxWords],
    oriented: &[ObbWords],
) -> Obb {
    let of = params.own.kind as usize;
    if child + 1 >= params.frame.count[of] {
        of_leaf(params, child, block_nodes)
    } else {
        ObbWords::load(oriented, (params.frame.start[of] + child) as usize)
    }
}

/// As `traverse_half`, and leaves out what an oriented box tells apart.
#[spirv(compute(threads(128)))]
pub fn traverse_half_oriented(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] leaves: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] order: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] nodes: &[NodeWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] oriented: &[ObbWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] pairs: &mut [u32],
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
            if reaches(&ObbWords::load(oriented, (first + walk.node) as usize), &query) {
                let node = node_at(nodes, walk.node as usize);
                let found = walk.step(&node, &query, leaf_idx);
                keep_ordered(params, a, order, found[0], pairs);
                keep_ordered(params, a, order, found[1], pairs);
            } else {
                walk.skip();
            }
        }
    }
}

/// As `traverse_full`, and leaves out what an oriented box tells apart.
#[spirv(compute(threads(128)))]
pub fn traverse_full_oriented(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Queries>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] order: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] nodes: &[NodeWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] oriented: &[ObbWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] pairs: &mut [u32],
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
        let (first, n_internal) = (params.frame.start[tree], params.frame.count[tree] - 1);
        // A tree of one leaf has no internal node.
        if n_internal == 0 {
            let leaf = box_at(boxes, at(order, first as usize) as usize);
            if leaf.overlaps(&query) {
                keep(params, a, order, 0, pairs);
            }
        }
        let mut walk = WideWalk::new();
        for _ in 0..n_internal {
            if !walk.goes_on {
                break;
            }
            if reaches(&ObbWords::load(oriented, (first + walk.node) as usize), &query) {
                let node = node_at(nodes, walk.node as usize);
                let found = walk.step(&node, &query, NONE);
                keep(params, a, order, found[0], pairs);
                keep(params, a, order, found[1], pairs);
            } else {
                walk.skip();
            }
        }
    }
}
