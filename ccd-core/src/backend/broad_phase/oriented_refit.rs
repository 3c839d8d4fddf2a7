//! Meet: oriented boxes of internal nodes from the leaves up, each around those of its children;
//! the second child to arrive at a node computes it [Gottschalk 1996], [Karras 2012].
//!
//! ```text
//!          around 3 and 4 (second to arrive)
//!           /          \
//!      around 1 and 2   4       leaves are boxes along the coordinates
//!       /      \
//!      1        2
//! ```
//!
//! Changed here: a box is fitted around the corners of its children's boxes and not around all
//! below it, so that a fit takes a constant time a node and a tree can be refitted; it is looser,
//! and holds all of the boxes below. Passing boxes between threads is as in [`super::refit`].
//!
//! Cost: an eigenproblem an internal node, some hundred times the union of two boxes. When to
//! choose it: see [`crate::math::obb`].

use crate::kernel::Words;
use crate::kernel::memory::at;
use crate::layout::{Branch, Node};
use crate::math::obb::Obb;

/// Words per internal node: centre, axes, half lengths, as bits of `f32`.
pub const STRIDE: usize = 15;

/// Reads the box of an internal node.
#[inline]
pub fn load(words: &impl Words, node: usize) -> Obb {
    let mut out = Obb { centre: [0.0; 3], axes: [[0.0; 3]; 3], half: [0.0; 3] };
    for k in 0..3 {
        let word = |i: usize| f32::from_bits(words.load(node * STRIDE + i + k));
        out.centre[k] = word(0);
        out.axes[0][k] = word(3);
        out.axes[1][k] = word(6);
        out.axes[2][k] = word(9);
        out.half[k] = word(12);
    }
    out
}

/// Writes the box of an internal node.
#[inline]
pub fn store(words: &impl Words, node: usize, b: &Obb) {
    for k in 0..3 {
        let put = |i: usize, x: f32| words.store(node * STRIDE + i + k, x.to_bits());
        put(0, b.centre[k]);
        put(3, b.axes[0][k]);
        put(6, b.axes[1][k]);
        put(9, b.axes[2][k]);
        put(12, b.half[k]);
    }
}

/// Walks up from leaf `i` and computes every node that it is the second to reach.
///
/// Before: `visits` is zero (one word per internal node); `parents` has one word per node; `nodes`
/// have their boxes. Each box is written by exactly one thread, after those of both children. The
/// walk is no longer than the tree is deep.
pub fn refit(
    i: usize,
    nodes: &[Node],
    branches: &[Branch],
    parents: &impl Words,
    visits: &impl Words,
    words: &impl Words,
) {
    let n_internal = branches.len();
    let mut node = n_internal + i;
    for _ in 0..n_internal + 1 {
        if node == 0 {
            return;
        }
        let parent = parents.load(node) as usize;
        if visits.add_acquire_release(parent, 1) == 0 {
            return;
        }
        let branch = at(branches, parent);
        let left = of_child(branch.left as usize, n_internal, nodes, words);
        let right = of_child(branch.right as usize, n_internal, nodes, words);
        store(words, parent, &Obb::around_two(&left, &right));
        node = parent;
    }
}

#[inline]
fn of_child(child: usize, n_internal: usize, nodes: &[Node], words: &impl Words) -> Obb {
    if child < n_internal { load(words, child) } else { Obb::of_box(&at(nodes, child).aabb()) }
}
