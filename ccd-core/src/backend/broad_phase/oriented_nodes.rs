//! Oriented boxes of a binary tree as a device makes and reads them: a tile of leaves a workgroup,
//! then the few nodes above the tiles, one level a dispatch.
//!
//! ```text
//!   round 4              x                nodes across tiles: a dispatch a round
//!   round 3          x       \
//!              . . . . . . . . . . .
//!                x     x       x          nodes within a tile: workgroup memory
//!               / \   / \     / \
//!              leaves, in tiles of 256
//! ```
//!
//! A node's box is fitted around those of its children, as in [`oriented_refit`], which needs them
//! first; and on a device nothing may pass between workgroups inside a dispatch. But a range of
//! leaves that follow one another lies within a tile for all but about one node in a hundred: those
//! a workgroup fits from the leaves up, in rounds with a barrier between. The others are listed,
//! and in each of the dispatches that follow those are fitted both of whose children were fitted in
//! an earlier one, which a stamp a node says. The rule, the order of the children, and so every bit
//! of the result are those of the CPU.
//!
//! How many rounds a tree needs is known on the device alone; there are as many as trees of its
//! builder can be high, and those after the last do nothing. What has not been fitted yet has the
//! box of everything, which tells nothing apart: too few rounds would cost visits, never a pair.
//!
//! Cost: 64 bytes a box, an eigenproblem a node, and a dispatch a round, of which most are short. A
//! visit reads 64 bytes more and takes a test of 15 axes: to choose as on a CPU, see
//! [`crate::math::obb`], and more rarely, because a device has room for many cheap tests at once.
//!
//! [`oriented_refit`]: super::oriented_refit

use super::stack_traversal::NONE;
use super::wide_nodes::TILE;
use crate::kernel::memory::{Stored, at};
use crate::layout::Node;
use crate::math::aabb::Aabb;
use crate::math::obb::Obb;

/// Words of a node's record: those of [`Obb`] in their order, and one that is not used.
pub const WORDS: usize = 16;

/// Bits of a Morton code.
const CODE_BITS: u32 = 30;

/// Rounds within a tile: on a path every node decides a bit of the code, or one of the place of its
/// leaves, of which 8 differ within a tile.
pub const TILE_ROUNDS: u32 = CODE_BITS + TILE.trailing_zeros();

/// The number of the first dispatch after the one that makes the tiles, which is round 1.
pub const FIRST_ROUND: u32 = 2;

/// Dispatches over the listed nodes of a tree over `n` leaves that is at most so many levels of
/// nodes high: a level a dispatch; of a single tile only the levels that its rounds leave.
pub fn n_rounds(n: u32, height: u32) -> u32 {
    if n <= TILE { height.saturating_sub(TILE_ROUNDS) } else { height }
}

/// Whether a child whose node has this stamp was fitted before this round; 0: it was not.
#[inline(always)]
pub fn is_ready(stamp: u32, round: u32) -> bool {
    stamp != 0 && stamp < round
}

/// Whether there may be a box that overlaps `query` below a node with this box.
#[inline(always)]
pub fn reaches(node: &Obb, query: &Aabb<f32>) -> bool {
    !node.separated_from_box(query)
}

/// Whether there may be leaves that overlap below a pair of nodes, whose boxes along the axes do.
///
/// `a`, `b`: nodes of the two trees, the first `internal` of each of which are internal and have
/// their oriented boxes in `a_oriented` and `b_oriented` from number `first` on. A node with itself
/// and two leaves are not tested.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "shader languages have no structures of views")]
pub fn reach<O: Stored<Obb>>(
    within: bool,
    [i, j]: [u32; 2],
    internal: [u32; 2],
    first: [u32; 2],
    a: &[Node],
    b: &[Node],
    a_oriented: &[O],
    b_oriented: &[O],
) -> bool {
    let same = within && i == j;
    if same || (i >= internal[0] && j >= internal[1]) {
        return true;
    }
    let of_a = oriented(i, internal[0], first[0], a, a_oriented);
    !of_a.separated(&oriented(j, internal[1], first[1], b, b_oriented))
}

/// The oriented box of a node; of a leaf, the one along the axes.
#[inline(always)]
fn oriented<O: Stored<Obb>>(
    node: u32,
    internal: u32,
    first: u32,
    nodes: &[Node],
    oriented: &[O],
) -> Obb {
    if node < internal {
        O::load(oriented, (first + node) as usize)
    } else {
        Obb::of_box(&at(nodes, node as usize).aabb())
    }
}

/// Of the children of a pair, those that reach; [`NONE`] in the place of the others.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "as above")]
pub fn only_reaching<O: Stored<Obb>>(
    within: bool,
    pairs: [[u32; 2]; 4],
    internal: [u32; 2],
    first: [u32; 2],
    a: &[Node],
    b: &[Node],
    a_oriented: &[O],
    b_oriented: &[O],
) -> [[u32; 2]; 4] {
    let mut out = pairs;
    for k in 0..4 {
        let pair = out[k];
        let some = pair[0] != NONE;
        if some && !reach(within, pair, internal, first, a, b, a_oriented, b_oriented) {
            out[k] = [NONE; 2];
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounds_are_as_many_as_levels_that_tiles_leave() {
        assert_eq!(TILE_ROUNDS, 38);
        let of = [(1, 0), (256, 30), (256, 39), (257, 39), (1 << 20, 51)];
        assert_eq!(of.map(|(n, height)| n_rounds(n, height)), [0, 0, 1, 39, 51]);
    }

    #[test]
    fn a_child_of_the_same_round_is_not_ready() {
        assert_eq!([0, 1, 2, 3].map(|stamp| is_ready(stamp, 2)), [false, true, false, false]);
    }
}
