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
use ccd_core::backend::layout::{Branch, LIST_HEADER, Node, WideNode};
use spirv_std::glam::{UVec2, UVec4};

/// Records that workgroup memory holds at a time, and words of two of each.
const HALF: u32 = TILE / 2;
const NODE_WORDS: u32 = 8;
/// In place of its flags: a record that is not written.
const SKIPPED: u32 = u32::MAX;

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
    near_nodes[256](t; params: Blocks; words: [UVec2; 1024], counters: [u32; 2];
        branches: [UVec4], block_nodes: [BoxWords], mut nodes: [UVec2], mut far: [u32]) {
        let tile = t.group * TILE;
        let i = tile + t.lane;
        let tree = params.args.kind as usize;
        let n_leaves = params.frame.count[tree];
        let mut aabb = Aabb::EMPTY;
        if i < n_leaves {
            aabb = box_at(block_nodes, block_bvh::slot(&params.args, 0, tree, i));
        }
        put_box(words, t.lane, &aabb);
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
            // Box `i` is that of `reach` leaves from `i` on.
            let reach = 1 << k;
            if left_length >> k == 1 {
                left = box_of(words, left_from)
                    .union(&box_of(words, left_from + left_length - reach));
            }
            if right_length >> k == 1 {
                right = box_of(words, right_from)
                    .union(&box_of(words, right_from + right_length - reach));
            }
            aabb = aabb.union(&box_of(words, (t.lane + reach).min(TILE - 1)));
            barrier();
            put_box(words, t.lane, &aabb);
            barrier();
        }
        // Records go through workgroup memory, half of them at a time, so that threads side by side
        // write what lies side by side.
        let node = wide::wide_node(&branch, split, n_leaves - 1, &left, &right);
        let end = if active && is_near { node.flags } else { SKIPPED };
        for half in 0..2 {
            if t.lane / HALF == half {
                put_node(words, t.lane % HALF, &node, end);
            }
            barrier();
            for k in 0..NODE_WORDS / 2 {
                let word = k * TILE + t.lane;
                if get(words, place(word / NODE_WORDS, NODE_WORDS - 1)).y != SKIPPED {
                    let to = (tile + half * HALF) * NODE_WORDS + word;
                    let from = place(word / NODE_WORDS, word % NODE_WORDS);
                    put(nodes, to as usize, get(words, from));
                }
            }
            barrier();
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

/// Puts box `i` into workgroup memory.
#[inline(always)]
fn put_box(words: &mut [UVec2; 1024], i: u32, b: &Aabb) {
    let [x, y, z, u, v, w] = [b.min[0], b.min[1], b.min[2], b.max[0], b.max[1], b.max[2]];
    set(words, 3 * i, bits(x, y.to_bits()));
    set(words, 3 * i + 1, bits(z, u.to_bits()));
    set(words, 3 * i + 2, bits(v, w.to_bits()));
}

/// Box `i` of workgroup memory.
#[inline(always)]
fn box_of(words: &[UVec2; 1024], i: u32) -> Aabb {
    let [a, b, c] = [get(words, 3 * i), get(words, 3 * i + 1), get(words, 3 * i + 2)];
    let [x, y, z] = [f32::from_bits(a.x), f32::from_bits(a.y), f32::from_bits(b.x)];
    let [u, v, w] = [f32::from_bits(b.y), f32::from_bits(c.x), f32::from_bits(c.y)];
    Aabb { min: [x, y, z], max: [u, v, w] }
}

/// Puts a record there, whose last word is `end`.
#[inline(always)]
fn put_node(words: &mut [UVec2; 1024], i: u32, node: &WideNode, end: u32) {
    let ([a, b, c], [d, e, f]) = (node.left_min, node.left_max);
    let ([g, h, k], [l, m, n]) = (node.right_min, node.right_max);
    set(words, place(i, 0), bits(a, b.to_bits()));
    set(words, place(i, 1), bits(c, node.unused));
    set(words, place(i, 2), bits(d, e.to_bits()));
    set(words, place(i, 3), bits(f, node.unused_too));
    set(words, place(i, 4), bits(g, h.to_bits()));
    set(words, place(i, 5), bits(k, node.split));
    set(words, place(i, 6), bits(l, m.to_bits()));
    set(words, place(i, 7), bits(n, end));
}

/// Where word `k` of record `i` is: in another column for each of eight records, so that threads
/// that put the same word of different ones do not wait for each other.
#[inline(always)]
fn place(i: u32, k: u32) -> u32 {
    NODE_WORDS * i + (k ^ (i % NODE_WORDS))
}

#[inline(always)]
fn bits(first: f32, second: u32) -> UVec2 {
    UVec2::new(first.to_bits(), second)
}
