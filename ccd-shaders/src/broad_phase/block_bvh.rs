//! Boxes of the block tree: a workgroup fits eight nodes, 32 children each.

use crate::entry::kernel;
use crate::records::{BoxWords, PathWords, box_at, leaf_at, leaf_words, put_ends};
use crate::workgroup::{barrier, get, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{marked, set_of, slot, united};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{Frame, Leaf, elements};
use ccd_core::narrow_phase::cascade;
use spirv_std::glam::{UVec4, Vec4};

/// Unites the boxes of 32 threads each, which are marked if `marks`; thread 0 of each 32 gets the
/// result.
#[inline(always)]
fn unite(lane: u32, aabb: Aabb, marks: bool, shared: &mut [Aabb; 256]) -> Aabb {
    let mut merged = aabb;
    set(shared, lane, merged);
    let mut half = 16;
    for _ in 0..5 {
        barrier();
        if lane % 32 < half {
            let other = get(shared, lane + half);
            merged = if marks { united(&merged, &other) } else { merged.union(&other) };
            set(shared, lane, merged);
        }
        half /= 2;
    }
    merged
}

kernel! {
    /// Leaves in sorted order, and the nodes above them. Thread `i` owns leaf `i` of all sets; the
    /// first thread of 32 their node.
    fit_leaves[256](t; params: Blocks; shared: [Aabb; 256]; boxes: [BoxWords], order: [u32],
        elements: [u32], bodies: [u32], mut nodes: [BoxWords], mut leaves: [UVec4]) {
        let i = t.group * 256 + t.lane;
        let set = set_of(&params.args.slots[0], i);
        let k = i - params.args.slots[0][set];
        let active = i < params.args.slots[0][3];
        let mut aabb = Aabb::EMPTY;
        let mut leaf = Leaf { vertices: [0; 3], id: Leaf::NONE };
        if active && k < params.frame.count[set] {
            let at_box = at(order, (params.frame.start[set] + k) as usize);
            aabb = box_at(boxes, at_box as usize);
            let feature = at_box - params.frame.start[set];
            leaf.id = feature;
            leaf.vertices = [feature; 3];
            if params.frame.has(Frame::FLAG_TOPOLOGY) && set > 0 {
                let n_edges = params.frame.count[1];
                let element = at_box - params.frame.start[1];
                leaf.vertices = elements::vertices(element, n_edges, elements);
            }
        }
        let marks = params.frame.has(Frame::FLAG_STILL);
        let mut of_node = aabb;
        if marks {
            // A feature is of the body of its first vertex.
            of_node = marked(&aabb, at(bodies, leaf.vertices[0] as usize) & 1 == 1);
        }
        let node = unite(t.lane, of_node, marks, shared);
        if active {
            put(nodes, i as usize, BoxWords::of(&aabb));
            put(leaves, i as usize, leaf_words(&leaf));
            if t.lane % 32 == 0 {
                put(nodes, slot(&params.args, 1, set, k / 32), BoxWords::of(&node));
            }
        }
    }
}

kernel! {
    /// Thread `i` makes the boxes of leaf `i` of all sets at both ends of the step.
    fit_ends[256](t; params: Blocks;; leaves: [UVec4], paths: [PathWords], mut ends: [Vec4]) {
        let i = t.i as usize;
        if t.i < params.args.slots[0][3] {
            let leaf = leaf_at(leaves, i);
            if leaf.id != Leaf::NONE {
                let (start, end) = cascade::boxes_at_ends(leaf.vertices, paths);
                put_ends(ends, i, &start, &end);
            }
        }
    }
}

kernel! {
    /// Nodes of level `args.level + 1` from those of level `args.level`. Thread `i` reads node `i`
    /// of all sets.
    fit_level[256](t; params: Blocks; shared: [Aabb; 256]; mut nodes: [BoxWords]) {
        let first = params.args.slots[params.args.level as usize];
        let i = first[0] + t.group * 256 + t.lane;
        let set = set_of(&first, i);
        let active = i < first[3];
        let mut aabb = Aabb::EMPTY;
        if active {
            aabb = box_at(nodes, i as usize);
        }
        let node = unite(t.lane, aabb, params.frame.has(Frame::FLAG_STILL), shared);
        if active && t.lane % 32 == 0 {
            let to = slot(&params.args, params.args.level + 1, set, (i - first[set]) / 32);
            put(nodes, to, BoxWords::of(&node));
        }
    }
}
