//! Emit: pairs of blocks and of boxes, from a tree of blocks of 32 boxes that is descended one
//! level a pass.
//!
//! Boxes in the order of a curve are taken 32 at a time; so are the blocks, up to the top. A
//! workgroup takes a pair of nodes, keeps the children of the second that reach into the first, and
//! tests all children of the first against those. No stack, no order between workgroups, and reads
//! of whole blocks; the levels above the boxes hold a thirty-second of the nodes each (see
//! docs/GPU-STEP.md).

use crate::kernel::memory::Stored;
use crate::layout::VERTEX_FACE;
use crate::layout::{Blocks, MAX_LEVELS};
use crate::math::aabb::Aabb;

/// Children of a node.
pub const WIDTH: u32 = 32;
/// Pairs of nodes that a workgroup takes at once, each with as many threads as a node has children.
pub const TEAMS: u32 = 4;
/// Threads of a workgroup.
pub const THREADS: u32 = TEAMS * WIDTH;
/// Nodes of a set on a level are padded to a multiple of this, so that a workgroup that fits eight
/// blocks has one set.
pub const PADDING: u32 = 8 * WIDTH;
/// Hits that a workgroup works on at once; where `TEAMS` pairs of nodes give more, the pool is
/// filled again. A device runs as many workgroups at a time as their memory allows: on an NVIDIA
/// H200 real scenes take as long with 512, and longer with 256; boxes with few pairs take less time
/// with a smaller one.
pub const POOL: u32 = 384;

/// The sets that a kind of pairs is between.
#[inline(always)]
pub fn sets(kind: u32) -> [usize; 2] {
    if kind == VERTEX_FACE { [0, 2] } else { [1, 1] }
}

/// Number of node `i` of `set` on `level` among all nodes.
#[inline(always)]
pub fn slot(tree: &Blocks, level: u32, set: usize, i: u32) -> usize {
    (tree.slots[level as usize][set] + i) as usize
}

/// Words of the boxes of a leaf at both ends of a step: three times four.
pub const END_WORDS: usize = 3;

/// Where the `k`-th four words of leaf `i` are among those of all leaves: the first of the 32
/// leaves of a block, the second of them, the third, so that threads with leaves of one block read
/// what is side by side.
#[inline(always)]
pub fn end_slot(i: usize, k: usize) -> usize {
    let width = WIDTH as usize;
    END_WORDS * i - (END_WORDS - 1) * (i % width) + k * width
}

/// A box, not of leaves but of nodes above them, that says whether all below it stands still: by
/// the lowest bit of its greatest x, which is raised to a number with that bit.
///
/// Two boxes that say so are no candidates ([`bodies_meet`]). A device that stores such a bound as
/// zero loses the bit, and the box is taken for one of what moves, which is safe.
///
/// [`bodies_meet`]: super::candidate::bodies_meet
#[inline(always)]
pub fn marked(b: &Aabb<f32>, still: bool) -> Aabb<f32> {
    let mut out = *b;
    if b.min[0] <= b.max[0] && has_mark(b) != still {
        out.max[0] = f32::from_bits(next_up(b.max[0].to_bits()));
    }
    out
}

/// The bits of a number above a finite one of these bits, in which the lowest is another; of
/// numbers that a device may flush the least normal one above zero. By integers: a device that
/// compares a denormal as zero, and keeps its bits, would find one above it with the same lowest
/// bit.
#[inline(always)]
fn next_up(bits: u32) -> u32 {
    let (is_negative, size) = (bits >> 31 == 1, bits & 0x7fff_ffff);
    if size < LEAST_NORMAL || (is_negative && size == LEAST_NORMAL) {
        LEAST_NORMAL | (bits & 1 ^ 1)
    } else if is_negative {
        bits - 1
    } else {
        bits + 1
    }
}

/// The bits of the smallest normal number.
const LEAST_NORMAL: u32 = 0x0080_0000;

/// Whether a marked box says so; one of nothing does.
#[inline(always)]
pub fn is_still(b: &Aabb<f32>) -> bool {
    has_mark(b) || !(b.min[0] <= b.max[0])
}

/// Of two marked boxes: still if both are.
#[inline(always)]
pub fn united(a: &Aabb<f32>, b: &Aabb<f32>) -> Aabb<f32> {
    marked(&a.union(b), is_still(a) && is_still(b))
}

#[inline(always)]
fn has_mark(b: &Aabb<f32>) -> bool {
    b.max[0].to_bits() & 1 == 1
}

/// The set of node `i` of a level, from the first nodes of its sets.
#[inline(always)]
pub fn set_of(first: &[u32; 4], i: u32) -> usize {
    if i >= first[2] {
        2
    } else if i >= first[1] {
        1
    } else {
        0
    }
}

/// The box of leaves `first ..= last` of a set: of those at either end one by one, between them by
/// whole blocks, and so on up to `tree.level`.
///
/// At most 62 nodes a level, and all of that level's.
#[inline(always)]
pub fn range_box<N: Stored<Aabb<f32>>>(
    tree: &Blocks,
    set: usize,
    first: u32,
    last: u32,
    nodes: &[N],
) -> Aabb<f32> {
    let mut out = Aabb::EMPTY;
    let (mut from, mut to) = (first, last + 1);
    for level in 0..MAX_LEVELS as u32 {
        let (up, down) = (from.next_multiple_of(WIDTH), to / WIDTH * WIDTH);
        let goes_on = up < down && level < tree.level;
        let (end, begin) = if goes_on { (up, down) } else { (to, to) };
        for four in 0..(end - from).div_ceil(4) {
            out = out.union(&four_boxes(
                slot(tree, level, set, from + 4 * four),
                slot(tree, level, set, end),
                nodes,
            ));
        }
        for four in 0..(to - begin).div_ceil(4) {
            out = out.union(&four_boxes(
                slot(tree, level, set, begin + 4 * four),
                slot(tree, level, set, to),
                nodes,
            ));
        }
        from = if goes_on { up / WIDTH } else { 0 };
        to = if goes_on { down / WIDTH } else { 0 };
    }
    out
}

/// Union of four nodes from `i` on, or of those before `end`: read together, so that none waits for
/// another.
#[inline(always)]
fn four_boxes<N: Stored<Aabb<f32>>>(i: usize, end: usize, nodes: &[N]) -> Aabb<f32> {
    let last = end - 1;
    let (a, b) = (N::load(nodes, i), N::load(nodes, (i + 1).min(last)));
    let (c, d) = (N::load(nodes, (i + 2).min(last)), N::load(nodes, (i + 3).min(last)));
    a.union(&b).union(&c.union(&d))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_say_whether_all_below_stands_still() {
        let of = |x: f32| Aabb { min: [-4e30; 3], max: [x, 1.0, 2.0] };
        // The next number, or a normal one near zero.
        let above = |x: f32| x.next_up().max(f32::MIN_POSITIVE.next_up());
        let least = f32::MIN_POSITIVE;
        for x in [-3e30, -1.5, -least, -1e-45, -0.0, 0.0, 1e-45, least, 1.5, 2.9e38] {
            for (a, b) in [(false, false), (false, true), (true, false), (true, true)] {
                let one = marked(&of(x), a);
                assert!(is_still(&one) == a && marked(&one, a) == one, "{x:e}");
                assert!(one.max[0] >= x && one.max[0] <= above(x), "{x:e}");
                // What a device may take as zero and still keep the bits of.
                assert!(one.max[0] == x || one.max[0].is_normal(), "{x:e}");
                for y in [x, x.next_down(), -2e30] {
                    let both = united(&one, &marked(&of(y), b));
                    assert!(is_still(&both) == (a && b) && both.max[0] >= x.max(y));
                    assert!(both.max[0] <= above(above(x.max(y))), "{x:e} {y:e}");
                }
                // Nothing changes no mark.
                assert_eq!(united(&one, &Aabb::EMPTY), one);
                assert_eq!(united(&Aabb::EMPTY, &one), one);
            }
        }
        assert_eq!(marked(&Aabb::EMPTY, true), Aabb::EMPTY);
    }
}
