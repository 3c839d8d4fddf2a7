//! Map: the binary radix tree over sorted Morton codes, every internal node independently (Karras 2012, section 4).
//!
//! Changed here: codes are two 32-bit words, and the tie-break of equal codes by their index is part of the same comparison.

use super::Words;
use crate::layout::Branch;

/// Levels that a tree can have: 63 bits of code and 32 of index, each deciding at most once on a path, and a leaf.
/// Stacks of traversals are this large, so they cannot overflow.
pub const MAX_DEPTH: usize = 96;

/// Length of the common prefix of sorted keys `i` and `j` (code, then index): -1 if `j` is out of range.
#[inline]
fn prefix(codes: &[[u32; 2]], i: usize, j: i64) -> i32 {
    if j < 0 || j >= codes.len() as i64 {
        return -1;
    }
    let (a, b) = (codes[i], codes[j as usize]);
    let high = a[1] ^ b[1];
    if high != 0 {
        return high.leading_zeros() as i32;
    }
    let low = a[0] ^ b[0];
    if low != 0 {
        return 32 + low.leading_zeros() as i32;
    }
    64 + ((i as u32) ^ (j as u32)).leading_zeros() as i32
}

/// Internal node `i` of the tree over `codes`, which are sorted ascending; `i < codes.len() - 1`.
///
/// Every loop halves or doubles a length of at most `2^32`, so runs at most 33 times.
pub fn branch(i: usize, codes: &[[u32; 2]]) -> Branch {
    let n_internal = codes.len() as u32 - 1;
    let at = i as i64;
    // The direction of the node's range, and the prefix that all of the range exceeds.
    let forward = prefix(codes, i, at + 1) > prefix(codes, i, at - 1);
    let step: i64 = if forward { 1 } else { -1 };
    let outside = prefix(codes, i, at - step);
    let mut reach: i64 = 2;
    for _ in 0..33 {
        if prefix(codes, i, at + reach * step) <= outside {
            break;
        }
        reach *= 2;
    }
    // The other end by binary search.
    let mut length: i64 = 0;
    let mut part = reach / 2;
    for _ in 0..33 {
        if part < 1 {
            break;
        }
        if prefix(codes, i, at + (length + part) * step) > outside {
            length += part;
        }
        part /= 2;
    }
    let end = at + length * step;
    // The split: the last key that shares more than the node's prefix with the first.
    let node_prefix = prefix(codes, i, end);
    let mut split: i64 = 0;
    let mut part = length;
    for _ in 0..33 {
        part = (part + 1) / 2;
        if prefix(codes, i, at + (split + part) * step) > node_prefix {
            split += part;
        }
        if part <= 1 {
            break;
        }
    }
    let gamma = (at + split * step + if forward { 0 } else { -1 }) as u32;
    let (first, last) = if forward { (at as u32, end as u32) } else { (end as u32, at as u32) };
    Branch {
        left: if first == gamma { n_internal + gamma } else { gamma },
        right: if last == gamma + 1 { n_internal + gamma + 1 } else { gamma + 1 },
        first,
        last,
    }
}

/// Writes `i` as the parent of its children. Every node but the root has one parent, so no word is written twice.
#[inline]
pub fn link(i: usize, branch: &Branch, parents: &impl Words) {
    parents.store(branch.left as usize, i as u32);
    parents.store(branch.right as usize, i as u32);
}
