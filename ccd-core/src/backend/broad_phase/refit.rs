//! Meet: boxes of internal nodes from the leaves up; the second child to arrive at a node computes
//! it [Karras 2012].
//!
//! Boxes pass between threads inside one dispatch, so they live in shared words, six a node, and
//! the visit counter carries acquire and release. Where a device has no such order across
//! workgroups, a host runs the levels one after the other instead.

use crate::kernel::Words;
use crate::layout::Branch;
use crate::math::aabb::Aabb;

/// Words per node: `min` and `max`, as bits of `f32`.
pub const STRIDE: usize = 6;

/// Reads the box of `node`.
#[inline]
pub fn load_box(boxes: &impl Words, node: usize) -> Aabb<f32> {
    let mut out = Aabb::EMPTY;
    for k in 0..3 {
        out.min[k] = f32::from_bits(boxes.load(node * STRIDE + k));
        out.max[k] = f32::from_bits(boxes.load(node * STRIDE + 3 + k));
    }
    out
}

/// Writes the box of `node`.
#[inline]
pub fn store_box(boxes: &impl Words, node: usize, aabb: &Aabb<f32>) {
    for k in 0..3 {
        boxes.store(node * STRIDE + k, aabb.min[k].to_bits());
        boxes.store(node * STRIDE + 3 + k, aabb.max[k].to_bits());
    }
}

/// Walks up from leaf `i` of `n_leaves` and computes every node that it is the second to reach.
///
/// Before: `visits` is zero (one word per internal node); `parents` has one word per node. Each
/// internal node's box is written by exactly one thread, after both of its children. The walk is no
/// longer than the tree is deep.
pub fn refit(
    i: usize,
    leaf: &Aabb<f32>,
    branches: &[Branch],
    parents: &impl Words,
    visits: &impl Words,
    boxes: &impl Words,
) {
    let n_internal = branches.len();
    let mut node = n_internal + i;
    store_box(boxes, node, leaf);
    for _ in 0..n_internal + 1 {
        if node == 0 {
            return;
        }
        let parent = parents.load(node) as usize;
        if visits.add_acquire_release(parent, 1) == 0 {
            return;
        }
        let branch = &branches[parent];
        let both =
            load_box(boxes, branch.left as usize).union(&load_box(boxes, branch.right as usize));
        store_box(boxes, parent, &both);
        node = parent;
    }
}
