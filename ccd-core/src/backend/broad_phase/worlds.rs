//! Worlds: many independent scenes that one sort and one descent serve.
//!
//! ```text
//!   key:   set | world | Hilbert code within the bounds of the world
//!   leaves of a set:   0 0 0 0 0 1 1 1 1 2 2 2 2 2 2
//!   nodes:            [  0..0  |   0..1  |  1..2 |  2..2  ]
//! ```
//!
//! Boxes are sorted by their world first, so the leaves below a node are of a range of worlds,
//! which its first and its last leaf say. Two nodes whose ranges have no world in common are no
//! pair: a fourth axis, beside the three of boxes. However many worlds lie in one place, a descent
//! meets pairs of nodes of one world, and of neighbours where a node has leaves of two.

use super::block_bvh::WIDTH;
use super::morton_key::{Curve, code30, from_order_key};
use crate::kernel::memory::{Stored, at};
use crate::layout::Blocks;
use crate::math::aabb::Aabb;
use crate::math::morton::MortonGrid;

/// Words of the bounds of a world, as of [`morton_key::shared_word`](super::morton_key).
pub const BOUND_WORDS: usize = 6;

/// Bits that worlds below `n` need.
pub const fn bits(n: u32) -> u32 {
    if n > 1 { (n - 1).ilog2() + 1 } else { 0 }
}

/// The bounds of a world, from the words of all.
#[inline(always)]
pub fn bounds(words: &[u32], world: u32) -> Aabb<f32> {
    let first = BOUND_WORDS * world as usize;
    let mut out = Aabb::EMPTY;
    for k in 0..3 {
        out.min[k] = from_order_key(!at(words, first + k));
        out.max[k] = from_order_key(at(words, first + 3 + k));
    }
    out
}

/// Key by which a device sorts box `i`: its set, its world, then as much of its Hilbert code in
/// that world as fits beside `bits` bits of worlds.
#[inline(always)]
pub fn sort_key<B: Stored<Aabb<f32>>>(
    i: usize,
    set: usize,
    world: u32,
    bits: u32,
    boxes: &[B],
    grid: &MortonGrid,
) -> u32 {
    let code = code30(&B::load(boxes, i), grid, Curve::Hilbert);
    (set as u32) << 30 | world << (30 - bits) | code >> bits
}

/// The first and the last world below node `i` of a level, as the upper and the lower half of a
/// word; `n`: boxes of the set, not 0; `of_leaf`: by leaf of level 0. A node past the last has the
/// worlds of that.
#[inline(always)]
pub fn range(tree: &Blocks, level: u32, set: usize, i: u32, n: u32, of_leaf: &[u32]) -> u32 {
    let mut leaves = 1;
    for _ in 0..level {
        leaves *= WIDTH;
    }
    let first = i.min((n - 1) / leaves) * leaves;
    let last = (first + (leaves - 1)).min(n - 1);
    let slot = tree.slots[0][set];
    at(of_leaf, (slot + first) as usize) << 16 | at(of_leaf, (slot + last) as usize)
}

/// Whether two ranges of worlds have one in common.
#[inline(always)]
pub fn meet(a: u32, b: u32) -> bool {
    a >> 16 <= b & 0xffff && b >> 16 <= a & 0xffff
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::layout::MAX_LEVELS;

    #[test]
    fn ranges_are_those_of_leaves() {
        let n = 3000u32;
        let of_leaf: [u32; 3000] = core::array::from_fn(|k| k as u32 / 77);
        let tree = Blocks { slots: [[0; 4]; MAX_LEVELS], ..Blocks::default() };
        for (level, leaves) in [(0, 1), (1, 32), (2, 1024)] {
            for i in 0..n.div_ceil(leaves) {
                let (first, last) = (i * leaves, ((i + 1) * leaves - 1).min(n - 1));
                let [low, high] = [first / 77, last / 77];
                let want = low << 16 | high;
                assert_eq!(range(&tree, level, 1, i, n, &of_leaf), want, "{level} {i}");
            }
            let past = range(&tree, level, 1, n, n, &of_leaf);
            assert_eq!(past, range(&tree, level, 1, (n - 1) / leaves, n, &of_leaf));
        }
        let of = |first: u32, last: u32| first << 16 | last;
        assert!(meet(of(1, 3), of(3, 9)) && meet(of(3, 9), of(1, 3)) && meet(of(0, 65_535), 0));
        assert!(!meet(of(1, 3), of(4, 4)) && !meet(of(4, 4), of(1, 3)));
        assert_eq!([1, 2, 3, 512, 513, 65_536].map(bits), [0, 1, 2, 9, 10, 16]);
    }
}
