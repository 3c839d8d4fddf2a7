//! Map: the binary radix tree over sorted Morton codes, every internal node independently [Karras
//! 2012].
//!
//! Changed here: codes are one or two 32-bit words, and the tie-break of equal codes by their index
//! is part of the same comparison.

use crate::broad_phase::node_numbering::branch_over;
use crate::kernel::Words;
use crate::kernel::memory::at;
use crate::layout::Branch;

/// Levels that a tree can have: 63 bits of code and 32 of index, each deciding at most once on a
/// path, and a leaf.
pub const MAX_DEPTH: usize = 96;

/// What boxes are sorted by, as far as a tree needs it.
pub trait Code: Copy {
    /// Bits of a code.
    const BITS: u32;
    /// Leading bits that two codes have in common.
    fn common(self, other: Self) -> u32;
}

impl Code for u32 {
    const BITS: u32 = 32;
    #[inline(always)]
    fn common(self, other: Self) -> u32 {
        (self ^ other).leading_zeros()
    }
}

/// Low word first.
impl Code for [u32; 2] {
    const BITS: u32 = 64;
    #[inline(always)]
    fn common(self, other: Self) -> u32 {
        let high = (self[1] ^ other[1]).leading_zeros();
        if high < 32 { high } else { 32 + (self[0] ^ other[0]).leading_zeros() }
    }
}

/// Bits that key `i` (code, then index) has in common with the one `distance` ahead of it or behind
/// it, plus one; 0 if there is none.
#[inline(always)]
fn prefix<C: Code>(codes: &[C], from: u32, n: u32, i: u32, ahead: bool, distance: u32) -> u32 {
    let inside = if ahead { distance < n - i } else { distance <= i };
    if !inside {
        return 0;
    }
    let j = if ahead { i + distance } else { i - distance };
    let common = at(codes, (from + i) as usize).common(at(codes, (from + j) as usize));
    1 + if common < C::BITS { common } else { C::BITS + (i ^ j).leading_zeros() }
}

/// Internal node `i` of the tree over the first `n` of `codes`; see [`branch_from`].
#[inline(always)]
pub fn branch<C: Code>(i: u32, n: u32, codes: &[C]) -> Branch {
    branch_from(i, 0, n, codes)
}

/// Internal node `i` of the tree over `n` of `codes` from number `from` on, which are sorted
/// ascending; `i < n - 1`, `n < 2^31`. Leaves are counted from `from`.
///
/// Every loop halves or doubles a length of less than `2^31`, so runs at most 32 times.
#[inline(always)]
pub fn branch_from<C: Code>(i: u32, from: u32, n: u32, codes: &[C]) -> Branch {
    // The direction of the node's range, and the prefix that all of the range exceeds.
    let (next, last) = (prefix(codes, from, n, i, true, 1), prefix(codes, from, n, i, false, 1));
    let ahead = next > last;
    let outside = if ahead { last } else { next };
    let mut reach = 2;
    while reach < n && prefix(codes, from, n, i, ahead, reach) > outside {
        reach *= 2;
    }
    // The other end by binary search.
    let mut length = 0;
    let mut part = reach / 2;
    while part > 0 {
        if prefix(codes, from, n, i, ahead, length + part) > outside {
            length += part;
        }
        part /= 2;
    }
    // The split: the last key that shares more than the node's prefix with the first.
    let node = prefix(codes, from, n, i, ahead, length);
    let mut split = 0;
    let mut part = length;
    while part > 1 {
        part = part.div_ceil(2);
        if prefix(codes, from, n, i, ahead, split + part) > node {
            split += part;
        }
    }
    let (first, last) = if ahead { (i, i + length) } else { (i - length, i) };
    let middle = if ahead { i + split + 1 } else { i - split };
    branch_over(first, middle, last + 1, n - 1)
}

/// Last leaf below the left child: an internal left child has the number of its last leaf.
#[inline(always)]
pub fn last_of_left(branch: &Branch, n_internal: u32) -> u32 {
    if branch.left >= n_internal { branch.left - n_internal } else { branch.left }
}

/// Writes `i` as the parent of its children. Every node but the root has one parent, so no word is
/// written twice.
#[inline]
pub fn link(i: usize, branch: &Branch, parents: &impl Words) {
    parents.store(branch.left as usize, i as u32);
    parents.store(branch.right as usize, i as u32);
}
