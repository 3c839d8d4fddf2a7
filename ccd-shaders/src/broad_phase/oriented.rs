//! Oriented boxes of a binary tree; see
//! `ccd_core::backend::broad_phase::oriented_nodes`.

use crate::entry::kernel;
use crate::records::{BoxWords, ObbWords, box_at, branch_at};
use crate::workgroup::{add, add_shared, barrier, get, load, or_shared, raise, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{self};
use ccd_core::backend::broad_phase::oriented_nodes::{TILE_ROUNDS, is_ready};
use ccd_core::backend::broad_phase::wide_nodes::{TILE, is_within};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{Stored, at, put};
use ccd_core::backend::layout::{Blocks, Branch, LIST_HEADER, Params};
use ccd_core::math::obb::Obb;
use spirv_std::glam::UVec4;

const FAR: u32 = Id::OrientFar.threads();

/// What a thread of [`orient_near`] does with its node.
const NOTHING: u32 = 0;
const OPEN: u32 = 1;
const FITTED: u32 = 2;
const LISTED: u32 = 3;

kernel! {
    /// Thread `i` fits internal node `i` of the tree over set `args.kind` once both children are,
    /// if all of its leaves are in the tile of the workgroup; it lists all others, which have the
    /// box of everything until then.
    orient_near[256](t; params: Blocks; boxes: [Obb; 256], done: [u32; 8], counters: [u32; 2];
        branches: [UVec4], block_nodes: [BoxWords], mut oriented: [ObbWords], mut stamps: [u32],
        mut far: [u32]) {
        let tile = t.group * TILE;
        let i = tile + t.lane;
        let tree = params.args.kind as usize;
        let n_leaves = params.frame.count[tree];
        if t.lane < 8 {
            set(done, t.lane, 0);
        }
        if t.lane < 2 {
            set(counters, t.lane, 0);
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
                set(boxes, t.lane, Obb::around_two(&left, &right));
                or_shared(done, t.lane / 32, 1 << (t.lane % 32));
                state = FITTED;
            }
            barrier();
        }
        let mut to = 0;
        if state == OPEN || state == LISTED {
            to = add_shared(counters, 0, 1);
        }
        barrier();
        if t.lane == 0 {
            let n_far = get(counters, 0);
            if n_far > 0 {
                set(counters, 1, add(far, 0, n_far));
            }
        }
        barrier();
        let node = (params.frame.start[tree] + i) as usize;
        if state == FITTED {
            put(oriented, node, ObbWords::of(&get(boxes, t.lane)));
            put(stamps, node, 1);
        } else if state != NOTHING {
            put(oriented, node, ObbWords::of(&Obb::everything()));
            put(stamps, node, 0);
            put(far, LIST_HEADER + (get(counters, 1) + to) as usize, i);
        }
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
    if child + 1 >= params.frame.count[params.args.kind as usize] {
        of_leaf(params, child, block_nodes)
    } else {
        get(boxes, child - tile)
    }
}

/// The box of a child that is a leaf.
#[inline(always)]
fn of_leaf(params: &Params<Blocks>, child: u32, block_nodes: &[BoxWords]) -> Obb {
    let tree = params.args.kind as usize;
    let leaf = child - (params.frame.count[tree] - 1);
    let b: Aabb = box_at(block_nodes, block_bvh::slot(&params.args, 0, tree, leaf));
    Obb::of_box(&b)
}

kernel! {
    /// The threads fit those nodes of a list of which both children were fitted in a dispatch
    /// before this one, which is round `dispatch.first`.
    orient_far[128](t; params: Blocks;; branches: [UVec4], block_nodes: [BoxWords], far: [u32],
        mut oriented: [ObbWords], mut stamps: [u32]) {
        let n_far = at(far, 0);
        let first = params.frame.start[params.args.kind as usize];
        let round = params.dispatch.first;
        let threads = t.groups * FAR;
        for part in 0..n_far.div_ceil(threads) {
            let k = part * threads + t.i;
            if k >= n_far {
                break;
            }
            let i = at(far, LIST_HEADER + k as usize);
            let node = (first + i) as usize;
            if load(stamps, node) == 0 {
                let branch = branch_at(branches, i as usize);
                if was_fitted(params, branch.left, stamps)
                    && was_fitted(params, branch.right, stamps)
                {
                    let left = fitted(params, branch.left, block_nodes, oriented);
                    let right = fitted(params, branch.right, block_nodes, oriented);
                    put(oriented, node, ObbWords::of(&Obb::around_two(&left, &right)));
                    raise(stamps, node, round);
                }
            }
        }
    }
}

/// Whether a child has its box since before this round.
#[inline(always)]
fn was_fitted(params: &Params<Blocks>, child: u32, stamps: &[u32]) -> bool {
    let tree = params.args.kind as usize;
    if child + 1 >= params.frame.count[tree] {
        return true;
    }
    is_ready(load(stamps, (params.frame.start[tree] + child) as usize), params.dispatch.first)
}

/// The box of a child that has one.
#[inline(always)]
fn fitted(
    params: &Params<Blocks>,
    child: u32,
    block_nodes: &[BoxWords],
    oriented: &[ObbWords],
) -> Obb {
    let tree = params.args.kind as usize;
    if child + 1 >= params.frame.count[tree] {
        of_leaf(params, child, block_nodes)
    } else {
        ObbWords::load(oriented, (params.frame.start[tree] + child) as usize)
    }
}
