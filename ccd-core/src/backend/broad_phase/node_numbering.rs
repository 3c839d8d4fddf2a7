//! Meet: the numbers that all builders give the nodes of a binary tree, whatever order they made
//! the nodes in.
//!
//! Of `n` leaves, counted from left to right, leaf `i` is node `n - 1 + i`; internal nodes have the
//! numbers below `n - 1`, of which 0 is the root. An internal node that is a left child has the
//! number of its last leaf, one that is a right child that of its first [Karras 2012]:
//!
//! ```text
//!            0
//!          /   \           The node over leaves 0 to 1 is a left child: its number is 1. That
//!        1       2         over leaves 2 to 4 is a right child: 2. That over 3 to 4: 3.
//!       / \     / \
//!      a   b   c   3
//!                 / \
//!                d   e
//! leaf 0   1   2  3   4
//! ```
//!
//! So a node's number, its range of leaves and both of its children follow from three counts of
//! leaves: of those before it, those below its left child, and those below it. A builder from
//! sorted codes knows them; one that joins nodes bottom up knows the two latter when it joins. Then
//! a thread a leaf finds its place by itself, on its way up to the root, where it adds what lies
//! below the left siblings of the nodes that it passes. As long as it comes from a left child, its
//! place is also the first leaf of the node above, and it writes the branch of that. The cost is
//! the depth of each leaf; there is no order between threads.

use crate::kernel::{ReadWords, Words};
use crate::layout::Branch;

/// In place of a parent: of the root.
pub const NO_PARENT: u32 = u32::MAX;

/// Words per node of the joins: its parent; how many leaves are below its left sibling (0 if it is
/// a left child); and, of an internal node, how many are below its left child, and below it.
pub const JOIN: usize = 4;

/// The words that change, with where they are, when `parent`, of any number below `n - 1`, becomes
/// the parent of two nodes with so many leaves below each; leaves are numbered from `n - 1` on in
/// any order.
///
/// Thread of `parent`: no other writes these words.
#[inline(always)]
pub fn join_words(parent: u32, children: [u32; 2], leaves: [u32; 2]) -> [(usize, u32); 6] {
    let at = parent as usize * JOIN;
    let (left, right) = (children[0] as usize * JOIN, children[1] as usize * JOIN);
    [
        (left, parent),
        (left + 1, 0),
        (right, parent),
        (right + 1, leaves[0]),
        (at + 2, leaves[0]),
        (at + 3, leaves[0] + leaves[1]),
    ]
}

/// Likewise, when `node` becomes the root.
#[inline(always)]
pub fn root_words(node: u32) -> [(usize, u32); 2] {
    let at = node as usize * JOIN;
    [(at, NO_PARENT), (at + 1, 0)]
}

/// Stores words where they are to be.
#[inline(always)]
pub fn store_words<const N: usize>(words: [(usize, u32); N], joins: &impl Words) {
    for (at, word) in words {
        joins.store(at, word);
    }
}

/// Of leaf `i`, in the builder's order: its place. A thread each.
///
/// The way up passes every internal node at most once, so `n_internal` bounds the loop.
#[inline(always)]
pub fn place<W: ReadWords + ?Sized>(i: u32, n_internal: u32, joins: &W) -> u32 {
    let (mut node, mut place) = ((n_internal + i) as usize, 0);
    for _ in 0..n_internal {
        let parent = joins.word(node * JOIN);
        if parent == NO_PARENT {
            break;
        }
        place += joins.word(node * JOIN + 1);
        node = parent as usize;
    }
    place
}

/// An internal node of which a leaf is the first.
#[derive(Clone, Copy, Debug)]
pub struct Above {
    /// Whether there is one; if not, nothing else counts.
    pub exists: bool,
    /// As its builder numbers it.
    pub node: u32,
    /// Its number.
    pub number: u32,
    /// What it is.
    pub branch: Branch,
}

/// The node above `node`, if that is a left child; `place`: the place of the first leaf of both.
///
/// The thread of a leaf goes on with this from the leaf itself to the first node that is no left
/// child, and writes the branches: no other does. All these ways together are as long as there are
/// nodes.
#[inline(always)]
pub fn above<W: ReadWords + ?Sized>(node: u32, place: u32, n_internal: u32, joins: &W) -> Above {
    let from = node as usize * JOIN;
    let parent = joins.word(from);
    let exists = parent != NO_PARENT && joins.word(from + 1) == 0;
    // Without a parent it looks at itself, whose words are there.
    let node = if exists { parent } else { node };
    let at = node as usize * JOIN;
    let is_root = joins.word(at) == NO_PARENT;
    let is_left = joins.word(at + 1) == 0;
    let (left, all) = (joins.word(at + 2), joins.word(at + 3));
    let number = if is_root {
        0
    } else if is_left {
        place + all - 1
    } else {
        place
    };
    Above {
        exists,
        node,
        number: if exists { number } else { 0 },
        branch: branch_over(place, place + left, place + all, n_internal),
    }
}

/// Thread of leaf `i`, in the builder's order: returns its place, and writes the branches of the
/// nodes of which it is the first leaf.
#[inline(always)]
pub fn number(i: u32, n_internal: u32, joins: &impl Words, branches: &impl Words) -> u32 {
    let place = place(i, n_internal, joins);
    let mut node = n_internal + i;
    for _ in 0..n_internal {
        let above = above(node, place, n_internal, joins);
        if !above.exists {
            break;
        }
        store_branch(above.number, &above.branch, branches);
        node = above.node;
    }
    place
}

/// The node over leaves `first .. end`, of which those from `middle` on are below its right child.
#[inline(always)]
pub fn branch_over(first: u32, middle: u32, end: u32, n_internal: u32) -> Branch {
    let (last_of_left, last) = (middle - 1, end - 1);
    Branch {
        left: if first == last_of_left { n_internal + first } else { last_of_left },
        right: if middle == last { n_internal + middle } else { middle },
        first,
        last,
    }
}

/// Words per branch.
pub const BRANCH: usize = 4;

/// Writes a branch to its place among words.
#[inline(always)]
pub fn store_branch(number: u32, branch: &Branch, branches: &impl Words) {
    let at = number as usize * BRANCH;
    branches.store(at, branch.left);
    branches.store(at + 1, branch.right);
    branches.store(at + 2, branch.first);
    branches.store(at + 3, branch.last);
}
