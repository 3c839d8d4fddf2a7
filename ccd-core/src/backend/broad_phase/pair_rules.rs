//! Rules beyond those that the words of two bodies say by themselves: classes of bodies, worlds,
//! excluded pairs of features, looked up in one table of words that both backends read.
//!
//! ```text
//!   0  bodies n          4  per body: class, world                      (2 n words)
//!   1  words of a row    .  per class: a bit for each class that it meets
//!   2  excluded pairs    .  excluded pairs of features, in order: kind, a, b
//!   3  where those begin
//! ```
//!
//! Bodies that are alike to all others (equal groups, the same excluded partners) are one class, so
//! that many bodies of few sorts need a small matrix. On a device the table stands behind the words
//! of vertices, or behind the regions of triangles.

use crate::kernel::memory::at;
use crate::layout::EDGE_EDGE;

/// Words before the first body.
pub const HEADER: usize = 4;

/// Whether features of two bodies may be looked at, by classes and worlds; bodies as words of
/// [`Rules`](crate::backend::rules::Rules), the table from word `first` on.
#[inline(always)]
pub fn classes_meet(a: u32, b: u32, table: &[u32], first: usize) -> bool {
    let n = at(table, first) as usize;
    let row = at(table, first + 1) as usize;
    let (p, q) = (first + HEADER + 2 * (a >> 2) as usize, first + HEADER + 2 * (b >> 2) as usize);
    let (i, j) = (at(table, p) as usize, at(table, q));
    let word = at(table, first + HEADER + 2 * n + i * row + (j / 32) as usize);
    let one_world = at(table, p + 1) == at(table, q + 1);
    // Groups are about two bodies.
    one_world && (word >> (j % 32) & 1 == 1 || a >> 2 == b >> 2)
}

/// Whether a pair of features is excluded by itself; `kind` 0: a vertex and a face, 1: two edges,
/// in any order.
///
/// A binary search that finds the number of lesser entries bit by bit. It carries one number from
/// step to step, so that on a device it takes few registers from the kernel around it.
#[inline(always)]
pub fn is_excluded(kind: u32, a: u32, b: u32, table: &[u32], first: usize) -> bool {
    let n = at(table, first + 2);
    let from = at(table, first + 3) as usize + first;
    let (mut x, mut y) = (a, b);
    if kind == EDGE_EDGE && b < a {
        x = b;
        y = a;
    }
    let mut low = 0;
    for step in 0..32 {
        let next = low | 1 << (31 - step);
        if next <= n {
            let entry = from + 3 * (next - 1) as usize;
            let (k, p, q) = (at(table, entry), at(table, entry + 1), at(table, entry + 2));
            if k < kind || (k == kind && (p < x || (p == x && q < y))) {
                low = next;
            }
        }
    }
    let mut is_there = false;
    if low < n {
        let entry = from + 3 * low as usize;
        is_there =
            at(table, entry) == kind && at(table, entry + 1) == x && at(table, entry + 2) == y;
    }
    is_there
}
