//! Pairs of blocks as workers of a device descend them: what a pair is, and which of its children
//! meet [da Silva 2013].
//!
//! ```text
//!   pair (level 3, a, b)        32 threads, one a child of a       columns of thread i
//!        a: 32 children          row i  ->  reaches into b?    ->   children of b that reach into
//!        b: 32 children                                             a, each a bit: met, or apart
//!                   children (level 2, 32 a + i, 32 b + j): expanded, later
//!   of level 2:     children (level 1, ..), pairs of blocks of 32 boxes: there a descent ends
//! ```
//!
//! A pair has the level of both of its nodes, because a worker has pairs of several on its stack.
//! It is packed into the first word, above the number of the node: a set has fewer than 2^32 boxes
//! and pairs are of level 1 or above, so that a node has a number below 2^27, and 5 bits are left.
//!
//! Cost: 1024 tests a pair at most, but a thread whose child does not reach into the other node
//! makes none, and the others make one for each column that reaches into the first. A level a
//! dispatch ([`block_bvh`](super::block_bvh)), the default, has the same tests and writes each pair
//! once more; workers are for scenes where a few pairs have nearly all the others below them.

use crate::broad_phase::block_bvh::WIDTH;
use crate::broad_phase::pair_descent::NodePair;
use crate::kernel::memory::Stored;
use crate::layout::MAX_LEVELS;
use crate::math::aabb::Aabb;

/// Bits of the number of a node of level 1 or above; the level stands above them.
const NUMBER_BITS: u32 = 27;
const NUMBER: u32 = (1 << NUMBER_BITS) - 1;

/// Of the children of a node, the power of two.
const SHIFT: u32 = WIDTH.trailing_zeros();

/// The largest number of a node of level 1: of the last of 2^32 - 1 boxes.
const LAST_NODE: u32 = (u32::MAX - 1) / WIDTH;

const _: () = assert!(LAST_NODE <= NUMBER);
// No pair packs to two words of ones, which is none.
const _: () = assert!((MAX_LEVELS as u32) < u32::MAX >> NUMBER_BITS);

/// Nodes `a` and `b` of a level, 1 or above.
#[inline(always)]
pub fn packed(level: u32, a: u32, b: u32) -> NodePair {
    [level << NUMBER_BITS | a, b]
}

/// The parts of a pair: level, `a`, `b`.
#[inline(always)]
pub fn unpacked([a, b]: NodePair) -> [u32; 3] {
    [a >> NUMBER_BITS, a & NUMBER, b]
}

/// Nodes of a level over so many boxes.
#[inline(always)]
pub fn nodes_on(count: u32, level: u32) -> u32 {
    let shift = SHIFT * level;
    if count > 0 && shift < u32::BITS { ((count - 1) >> shift) + 1 } else { (count > 0) as u32 }
}

/// Which children of node `parent` there are, as bits, if there are `n` nodes on their level.
#[inline(always)]
pub fn children_there(n: u32, parent: u32) -> u32 {
    let first = parent * WIDTH;
    let n_left = n.max(first) - first;
    if n_left >= WIDTH { u32::MAX } else { (1 << n_left) - 1 }
}

/// Which children of the second node child `i` of the first is tested against: within one node
/// each pair comes once, and a child, whose boxes are pairs, with itself.
#[inline(always)]
pub fn partners(same: bool, i: u32) -> u32 {
    if same { u32::MAX << i } else { u32::MAX }
}

/// Of those `columns` of the nodes from `first` on, given as bits, those that meet a box.
///
/// At most 32 tests.
#[inline(always)]
pub fn meeting<N: Stored<Aabb<f32>>>(
    row: &Aabb<f32>,
    columns: u32,
    first: usize,
    nodes: &[N],
) -> u32 {
    let (mut left, mut met) = (columns, 0);
    for _ in 0..WIDTH {
        if left == 0 {
            break;
        }
        let j = left.trailing_zeros();
        left &= left - 1;
        if row.overlaps(&N::load(nodes, first + j as usize)) {
            met |= 1 << j;
        }
    }
    met
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::pair_descent::NO_PAIR;

    #[test]
    fn pairs_pack() {
        let top = MAX_LEVELS as u32 - 1;
        for parts in [[1, 0, 0], [1, LAST_NODE, LAST_NODE], [top, 7, 0], [top, NUMBER, u32::MAX]] {
            let [level, a, b] = parts;
            assert_eq!(unpacked(packed(level, a, b)), parts);
            assert_ne!(packed(level, a, b), NO_PAIR);
        }
    }

    #[test]
    fn nodes_are_what_thirty_twos_need() {
        for count in [0u32, 1, 31, 32, 33, 1024, 1025, 40_000, u32::MAX] {
            let mut want = count;
            for level in 0..MAX_LEVELS as u32 {
                assert_eq!(nodes_on(count, level), want, "{count} boxes, level {level}");
                want = want.div_ceil(WIDTH);
            }
        }
        assert_eq!(nodes_on(u32::MAX, 1) - 1, LAST_NODE);
    }

    #[test]
    fn children_are_those_below() {
        let of = [(0, 0), (1, 0), (31, 0), (32, 0), (33, 0), (33, 1), (64, 1), (40, 2)];
        let present = of.map(|(n, parent)| children_there(n, parent));
        assert_eq!(present, [0, 1, u32::MAX >> 1, u32::MAX, u32::MAX, 1, u32::MAX, 0]);
    }

    #[test]
    fn each_pair_within_a_node_comes_once() {
        for i in 0..WIDTH {
            for j in 0..WIDTH {
                let [of_one, of_two] = [true, false].map(|same| partners(same, i) >> j & 1 == 1);
                assert!(of_two && of_one == (i <= j), "{i}, {j}");
            }
        }
    }

    #[test]
    fn columns_that_meet_are_found() {
        let at = |x: f32| Aabb { min: [x; 3], max: [x + 1.5; 3] };
        let mut nodes: std::vec::Vec<Aabb> = (0..40).map(|i| at(i as f32)).collect();
        nodes[20] = Aabb::EMPTY;
        let of = |row: &Aabb, columns| meeting(row, columns, 3, &nodes);
        assert_eq!(of(&at(5.0), u32::MAX), 0b1110);
        assert_eq!(of(&at(5.0), 0b0100), 0b0100);
        assert_eq!(of(&at(20.0), u32::MAX), 0b101 << 16);
        assert_eq!(of(&at(34.0), u32::MAX), 0b11 << 30);
        assert_eq!(of(&Aabb::EMPTY, u32::MAX), 0);
    }
}
