//! Boxes of the block tree: a workgroup fits eight nodes, 32 children each.

use crate::entry::kernel;
use crate::records::{BoxWords, PathWords, box_at, leaf_at, leaf_words, put_ends};
use crate::workgroup::{barrier, get, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{marked, set_of, slot, united};
use ccd_core::backend::broad_phase::swept_box;
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
    /// Thread `i` makes leaf `i` of all sets, in sorted order.
    place_leaves[256](t; params: Blocks;; order: [u32], elements: [u32], mut leaves: [UVec4]) {
        let i = t.i;
        if i < params.args.slots[0][3] {
            let (frame, set) = (&params.frame, set_of(&params.args.slots[0], i));
            let k = i - params.args.slots[0][set];
            let mut leaf = Leaf { vertices: [0; 3], id: Leaf::NONE };
            if k < frame.count[set] {
                let at_box = at(order, (frame.start[set] + k) as usize);
                leaf.id = at_box - frame.start[set];
                leaf.vertices = [leaf.id; 3];
                if set > 0 {
                    let element = at_box - frame.start[1];
                    leaf.vertices = elements::vertices(element, frame.count[1], elements);
                }
            }
            put(leaves, i as usize, leaf_words(&leaf));
        }
    }
}

kernel! {
    /// Boxes of leaves, with `FLAG_ENDS` also those at both ends of the step, and of the nodes
    /// above. Thread `i` owns leaf `i` of all sets; the first thread of 32 their node. A leaf is
    /// the box of its vertices, with `FLAG_SWEPT` of their paths.
    fit_leaves[256](t; params: Blocks; shared: [Aabb; 256]; boxes: [BoxWords], leaves: [UVec4],
        paths: [PathWords], bodies: [u32], mut nodes: [BoxWords], mut ends: [Vec4]) {
        let i = t.group * 256 + t.lane;
        let active = i < params.args.slots[0][3];
        let set = set_of(&params.args.slots[0], i);
        let mut aabb = Aabb::EMPTY;
        let mut leaf = Leaf { vertices: [0; 3], id: Leaf::NONE };
        if active {
            leaf = leaf_at(leaves, i as usize);
        }
        if leaf.id != Leaf::NONE {
            let of_paths = params.frame.has(Frame::FLAG_SWEPT);
            if of_paths || params.frame.has(Frame::FLAG_ENDS) {
                let (start, end) = cascade::boxes_at_ends(leaf.vertices, paths);
                aabb = swept_box::of_ends(&start, &end, params.frame.margin);
                if params.frame.has(Frame::FLAG_ENDS) {
                    put_ends(ends, i as usize, &start, &end);
                }
            }
            if !of_paths {
                let [a, b, c] = leaf.vertices;
                aabb = box_at(boxes, a as usize);
                if set > 0 {
                    aabb =
                        aabb.union(&box_at(boxes, b as usize)).union(&box_at(boxes, c as usize));
                }
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
            if t.lane % 32 == 0 {
                let k = i - params.args.slots[0][set];
                put(nodes, slot(&params.args, 1, set, k / 32), BoxWords::of(&node));
            }
        }
    }
}

kernel! {
    /// Boxes of leaves that are boxes and nothing else, in sorted order, and of the nodes above.
    /// Thread `i` owns leaf `i` of all sets; the first thread of 32 their node.
    fit_boxes[256](t; params: Blocks; shared: [Aabb; 256]; boxes: [BoxWords], order: [u32],
        mut nodes: [BoxWords]) {
        let first = params.args.slots[0];
        let i = t.group * 256 + t.lane;
        let (active, set) = (i < first[3], set_of(&first, i));
        let k = i - first[set];
        let mut aabb = Aabb::EMPTY;
        if active && k < params.frame.count[set] {
            aabb = box_at(boxes, at(order, (params.frame.start[set] + k) as usize) as usize);
        }
        let node = unite(t.lane, aabb, false, shared);
        if active {
            put(nodes, i as usize, BoxWords::of(&aabb));
            if t.lane % 32 == 0 {
                put(nodes, slot(&params.args, 1, set, k / 32), BoxWords::of(&node));
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
