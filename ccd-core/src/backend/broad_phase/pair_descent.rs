//! Emit: overlapping pairs by simultaneous traversal of two trees, or of one with itself: a pair of
//! nodes is expanded into the overlapping pairs of their children [da Silva 2013], algorithm 2.1.
//!
//! ```text
//!      a           b            Larger, a being it:  (a0, b)  (a1, b)
//!     / \         / \           Both:                (a0, b0) (a0, b1) (a1, b0) (a1, b1)
//!   a0   a1     b0   b1         a with itself:       (a0, a0) (a0, a1) (a1, a1)
//! ```
//!
//! What a group of near boxes has in common is descended once for all of them, so that there are
//! fewer steps than by a query a box; but pairs have nothing in common with the pairs after them,
//! so that threads side by side diverge [Karras 2012b].
//!
//! Changed here: a pair is tested before it is emitted rather than when it is visited; the two
//! sides are never exchanged, so that of a pair within one tree the first comes first in the order
//! of leaves.

use crate::broad_phase::stack_traversal::NONE;
use crate::kernel::memory::at;
use crate::layout::Node;
use crate::math::aabb::Aabb;
use crate::model::method::Descent;

/// A node of the first tree and one of the second, or two of one tree, of which the first is left
/// of the second or the same.
pub type NodePair = [u32; 2];

/// No pair.
pub const NO_PAIR: NodePair = [NONE; 2];

/// The children of a pair.
#[derive(Clone, Copy)]
pub struct Children {
    /// All of them: what a front needs, which has a pair for each that is apart.
    pub all: [NodePair; 4],
    /// Those that overlap, at the same places; [`NO_PAIR`] for the others.
    pub met: [NodePair; 4],
}

impl Children {
    const NONE: Self = Self { all: [NO_PAIR; 4], met: [NO_PAIR; 4] };
}

/// Children of the pair `(i, j)`, which overlaps, and is no pair of leaves: two by
/// [`Descent::Larger`], four by [`Descent::Both`], three of a node with itself; [`NO_PAIR`] in what
/// is left. A pair of leaves has none.
///
/// `a`, `b`: nodes of the two trees; if pairs are sought `within` one, the same. A leaf makes no
/// pair with itself. Each pair of leaves is below exactly one of the children, so that every
/// overlapping one is met once, from the pair of roots on. Which node is the larger decides nothing
/// but the number of steps: volumes that are not finite do no harm. But it is decided once for all
/// children, met or apart: a compiler may round two copies of a comparison differently.
#[inline(always)]
pub fn expand(rule: Descent, within: bool, a: &[Node], b: &[Node], [i, j]: NodePair) -> Children {
    let (x, y) = (at(a, i as usize), at(b, j as usize));
    if within && i == j {
        return of_one(a, &x);
    }
    let (mut splits_x, mut splits_y) = (!x.is_leaf(), !y.is_leaf());
    let mut out = Children::NONE;
    if !splits_x && !splits_y {
        return out;
    }
    if splits_x && splits_y && matches!(rule, Descent::Larger) {
        splits_y = volume(&y.aabb()) > volume(&x.aabb());
        splits_x = !splits_y;
    }
    if splits_x && splits_y {
        let (x0, x1) = (at(a, x.left as usize).aabb(), at(a, x.right as usize).aabb());
        let (y0, y1) = (at(b, y.left as usize).aabb(), at(b, y.right as usize).aabb());
        out.all = [[x.left, y.left], [x.left, y.right], [x.right, y.left], [x.right, y.right]];
        out.met[0] = pair_if(x0.overlaps(&y0), out.all[0]);
        out.met[1] = pair_if(x0.overlaps(&y1), out.all[1]);
        out.met[2] = pair_if(x1.overlaps(&y0), out.all[2]);
        out.met[3] = pair_if(x1.overlaps(&y1), out.all[3]);
    } else if splits_x {
        let (x0, x1) = (at(a, x.left as usize).aabb(), at(a, x.right as usize).aabb());
        out.all = [[x.left, j], [x.right, j], NO_PAIR, NO_PAIR];
        out.met[0] = pair_if(x0.overlaps(&y.aabb()), out.all[0]);
        out.met[1] = pair_if(x1.overlaps(&y.aabb()), out.all[1]);
    } else {
        let (y0, y1) = (at(b, y.left as usize).aabb(), at(b, y.right as usize).aabb());
        out.all = [[i, y.left], [i, y.right], NO_PAIR, NO_PAIR];
        out.met[0] = pair_if(x.aabb().overlaps(&y0), out.all[0]);
        out.met[1] = pair_if(x.aabb().overlaps(&y1), out.all[1]);
    }
    out
}

/// The pairs of a node with itself.
#[inline(always)]
fn of_one(nodes: &[Node], node: &Node) -> Children {
    let mut out = Children::NONE;
    if !node.is_leaf() {
        let (left, right) = (at(nodes, node.left as usize), at(nodes, node.right as usize));
        out.all[0] = pair_if(!left.is_leaf(), [node.left; 2]);
        out.all[1] = [node.left, node.right];
        out.all[2] = pair_if(!right.is_leaf(), [node.right; 2]);
        out.met = out.all;
        out.met[1] = pair_if(left.aabb().overlaps(&right.aabb()), out.all[1]);
    }
    out
}

#[inline(always)]
fn pair_if(emitted: bool, pair: NodePair) -> NodePair {
    if emitted { pair } else { NO_PAIR }
}

/// What says which of two nodes is the larger.
#[inline(always)]
fn volume(b: &Aabb<f32>) -> f32 {
    (b.max[0] - b.min[0]) * (b.max[1] - b.min[1]) * (b.max[2] - b.min[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::test_trees::Tree;

    #[test]
    fn the_larger_is_split_and_a_leaf_never() {
        let [unit, huge] = [1.0, 3.0e38].map(|x| Aabb { min: [-x; 3], max: [x; 3] });
        let tree = |b: &Aabb| Tree::new(&[*b; 2], |first, _| first);
        let (small, large) = (tree(&unit), tree(&huge));
        let of = |a: &Tree, b: &Tree, pair| {
            expand(Descent::Larger, false, &a.nodes, &b.nodes, pair)
                .met
                .map(|pair| pair.map(|i| if i == NONE { 9 } else { i }))
        };
        let none = [9, 9];
        assert_eq!(of(&small, &large, [0, 0]), [[0, 1], [0, 2], none, none]);
        assert_eq!(of(&large, &small, [0, 0]), [[1, 0], [2, 0], none, none]);
        assert_eq!(of(&small, &large, [0, 2]), [[1, 2], [2, 2], none, none]);
        assert_eq!(of(&small, &large, [1, 0]), [[1, 1], [1, 2], none, none]);
        // Volumes that are both infinite.
        assert_eq!(of(&large, &large, [0, 0]), [[1, 0], [2, 0], none, none]);
    }
}
