//! Map and emit: a tree from sorted Morton codes by lists of splits, one a level [Lauterbach 2009].
//!
//! Between two neighbours of the sorted codes the leaves part at a *level*: the number of leading
//! bits that both have in common. From that level down they stay apart. So the list of level `l`
//! has all places where neighbours parted at `l` or above, in order, and between two places that
//! follow each other there is a node:
//!
//! ```text
//! codes     00   01   10   10   11         `|`: a place on the list of that level
//! level 0           |                      left and right of it: two nodes
//! level 1      |    |         |            two of those three are new: each splits a node
//! level 2+                |                equal codes part by the bits of their index
//! ```
//!
//! Every place makes one node, on the level where it appears first: the node that it splits,
//! between its two neighbours on that list. Changed here: a node that a level does not split has
//! but one child there, and the paper removes such chains afterwards; here a place that has one
//! leaf to either side leaves the lists, because nothing asks for it any more, and the others make
//! a node on their own level only. With that the lists are together two to four times as long as
//! there are leaves, rather than as many times as a code has bits.

use crate::broad_phase::node_numbering::branch_over;
use crate::broad_phase::radix_tree::Code;
use crate::kernel::memory::at;
use crate::layout::Branch;

/// Levels that there may be: bits of a code of two words, and of an index.
pub const MAX_LEVELS: usize = 96;

/// The level at which leaf `i` and the next part, whose codes are from number `from` on; `i < n -
/// 1`. Equal codes part by their indices, as in [`radix_tree`](super::radix_tree).
#[inline(always)]
pub fn level<C: Code>(i: usize, from: usize, codes: &[C]) -> u32 {
    let common = at(codes, from + i).common(at(codes, from + i + 1));
    if common < C::BITS { common } else { C::BITS + (i as u32 ^ (i as u32 + 1)).leading_zeros() }
}

/// The last level on whose list place `i` is, from the levels of all places, which are one for each
/// of `n_internal` nodes: after that there is one leaf to either side of it.
#[inline(always)]
pub fn last_level(i: usize, n_internal: usize, levels: &[u32]) -> u32 {
    let mut last = at(levels, i);
    if i > 0 {
        last = last.max(at(levels, i - 1));
    }
    if i + 1 < n_internal {
        last = last.max(at(levels, i + 1));
    }
    last
}

/// Words in which every level has a bit.
pub const PRESENT: usize = MAX_LEVELS / 32;

/// The number of a level among those that occur, which have a bit each.
#[inline(always)]
pub fn rank(level: u32, present: [u32; PRESENT]) -> u32 {
    let mut rank = 0;
    for k in 0..PRESENT as u32 {
        let from = 32 * k;
        let below = if level >= from + 32 {
            u32::MAX
        } else if level > from {
            (1 << (level - from)) - 1
        } else {
            0
        };
        rank += (present[k as usize] & below).count_ones();
    }
    rank
}

/// The node that entry `k` of the list of a level makes, with its number; the number of an entry
/// that makes none there is [`NONE`].
///
/// `list`: places in order, of which those from `begin_end[0]` to before `begin_end[1]` are on the
/// level; `levels`: of all places.
#[inline(always)]
pub fn branch(
    k: usize,
    level: u32,
    begin_end: [usize; 2],
    n_internal: u32,
    list: &[u32],
    levels: &[u32],
) -> (u32, Branch) {
    let [begin, end] = begin_end;
    let place = at(list, k);
    let first = if k > begin { at(list, k - 1) + 1 } else { 0 };
    let last = if k + 1 < end { at(list, k + 1) } else { n_internal };
    // A node is a child of where it was cut off last.
    let (is_first, is_last) = (first == 0, last == n_internal);
    let left_child = if is_first {
        true
    } else if is_last {
        false
    } else {
        at(levels, last as usize) > at(levels, first as usize - 1)
    };
    let number = if at(levels, place as usize) != level {
        NONE
    } else if is_first && is_last {
        0
    } else if left_child {
        last
    } else {
        first
    };
    (number, branch_over(first, place + 1, last + 1, n_internal))
}

/// In place of a number: no node.
pub const NONE: u32 = u32::MAX;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_that_occur_have_numbers_without_gaps() {
        let levels = [0u32, 3, 31, 32, 33, 63, 64, 95];
        let mut present = [0; PRESENT];
        levels.iter().for_each(|&l| present[l as usize / 32] |= 1 << (l % 32));
        let ranks = levels.map(|level| rank(level, present));
        assert_eq!(ranks, [0, 1, 2, 3, 4, 5, 6, 7]);
        assert_eq!((rank(2, present), rank(95, [0; PRESENT])), (1, 0));
    }
}
