//! A binary tree over one set, by any builder: boxes of its nodes.

use crate::entry::kernel;
use crate::records::{BoxWords, NodeWords, box_at, branch_at};
use crate::workgroup::{add, add_shared, barrier, get, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh;
use ccd_core::backend::broad_phase::radix_tree;
use ccd_core::backend::broad_phase::wide_nodes::{self as wide, TILE};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{Branch, LIST_HEADER, Node};
use spirv_std::glam::UVec4;

/// Threads of a workgroup of the far nodes.
const FAR: u32 = Id::FarNodes.threads();

kernel! {
    /// Thread `i` boxes internal node `i` of the tree over set `args.kind`, and writes leaf `i`.
    branch_boxes[256](t; params: Blocks;; branches: [Branch], block_nodes: [Aabb], order: [u32],
        mut nodes: [Node]) {
        let i = t.i;
        let set = params.args.kind as usize;
        let n_leaves = params.frame.count[set];
        if i + 1 < n_leaves {
            let branch = at(branches, i as usize);
            let b = block_bvh::range_box(&params.args, set, branch.first, branch.last, block_nodes);
            put(
                nodes,
                i as usize,
                Node { min: b.min, left: branch.left, max: b.max, right: branch.right },
            );
        }
        if i < n_leaves {
            let slot = block_bvh::slot(&params.args, 0, set, i);
            let b = at(block_nodes, slot);
            let first = params.frame.start[set];
            let id = at(order, (first + i) as usize) - first;
            put(
                nodes,
                (n_leaves - 1 + i) as usize,
                Node { min: b.min, left: id, max: b.max, right: Node::LEAF },
            );
        }
    }
}

kernel! {
    /// Thread `i` boxes the children of internal node `i`; see
    /// `ccd_core::backend::broad_phase::wide_nodes`.
    near_nodes[256](t; params: Blocks; boxes: [Aabb; 512], counters: [u32; 2]; branches: [UVec4],
        block_nodes: [BoxWords], mut nodes: [NodeWords], mut far: [u32]) {
        let tile = t.group * TILE;
        let i = tile + t.lane;
        let tree = params.args.kind as usize;
        let n_leaves = params.frame.count[tree];
        let mut aabb = Aabb::EMPTY;
        if i < n_leaves {
            aabb = box_at(block_nodes, block_bvh::slot(&params.args, 0, tree, i));
        }
        set(boxes, t.lane, aabb);
        if t.lane == 0 {
            set(counters, 0, 0);
        }
        let active = i + 1 < n_leaves;
        let mut branch = Branch { left: 0, right: 0, first: tile, last: tile };
        if active {
            branch = branch_at(branches, i as usize);
        }
        let is_near = wide::is_within(tile, &branch);
        let split = radix_tree::last_of_left(&branch, n_leaves - 1);
        // Where both children begin in the tile, and their lengths.
        let (mut left_from, mut left_length, mut right_from, mut right_length) = (0, 0, 0, 0);
        if active && is_near {
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
            aabb = aabb.union(&get(boxes, half + (t.lane + reach).min(TILE - 1)));
            set(boxes, TILE - half + t.lane, aabb);
            barrier();
        }
        if active && is_near {
            let node = wide::wide_node(&branch, split, n_leaves - 1, &left, &right);
            put(nodes, i as usize, NodeWords::of(&node));
        }
        let mut to = 0;
        if active && !is_near {
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
        if active && !is_near {
            put(far, LIST_HEADER + (get(counters, 1) + to) as usize, i);
        }
    }
}

kernel! {
    /// The threads box the children of the nodes that are listed in `far`.
    far_nodes[128](t; params: Blocks;; branches: [UVec4], block_nodes: [BoxWords], far: [u32],
        mut nodes: [NodeWords]) {
        let tree = params.args.kind as usize;
        let (n_far, n_internal) = (at(far, 0), params.frame.count[tree] - 1);
        let threads = t.groups * FAR;
        for round in 0..n_far.div_ceil(threads) {
            let k = round * threads + t.i;
            if k >= n_far {
                break;
            }
            let i = at(far, LIST_HEADER + k as usize);
            let branch = branch_at(branches, i as usize);
            let split = radix_tree::last_of_left(&branch, n_internal);
            let left = block_bvh::range_box(&params.args, tree, branch.first, split, block_nodes);
            let right =
                block_bvh::range_box(&params.args, tree, split + 1, branch.last, block_nodes);
            let node = wide::wide_node(&branch, split, n_internal, &left, &right);
            put(nodes, i as usize, NodeWords::of(&node));
        }
    }
}
