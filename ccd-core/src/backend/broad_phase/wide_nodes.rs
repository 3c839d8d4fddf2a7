//! Binary trees as a device reads them: a record holds the boxes of both children, so that a step
//! of a traversal is one read of 64 bytes in one place [Aila 2009].
//!
//! ```text
//!        node        first        split  split + 1        last
//!       /    \         |-- left box --|  |-- right box --|
//!    left   right     leaves, in the order of the Morton curve
//! ```
//!
//! A leaf has no record: its box is read among the sorted boxes. Numbers of children follow from
//! where the range is split ([`super::node_numbering`]). The boxes of a node's children are
//! those of two ranges of leaves, so that nothing passes between workgroups; for this the leaves
//! below any node must follow one another, as in every tree whose leaves are numbered from the
//! left. A workgroup makes the records of [`TILE`] nodes that follow one another. Where one end of
//! a node's range is the leaf of its own number, as in [Karras 2012], most ranges lie among the
//! leaves of those numbers: there a box comes from two that overlap, each of a power of two of
//! leaves, which the workgroup makes for one power after the other. Of other nodes, which are few,
//! it makes a list; their boxes come from whole blocks of a block tree ([`range_box`]).
//!
//! [`range_box`]: super::block_bvh::range_box
//!
//! Cost: 64 bytes a box; a step is two box tests. Choose it where one thread takes one query.

use super::stack_traversal::{MAX_HEIGHT, NONE};
use crate::kernel::stack::Stack;
use crate::layout::{Branch, WideNode};
use crate::math::aabb::Aabb;

/// The record of an internal node, whose left child ends at leaf `split`, from the boxes of its
/// children. `n_internal`: internal nodes of the tree; a child of that number or more is a leaf.
#[inline(always)]
pub fn wide_node(
    branch: &Branch,
    split: u32,
    n_internal: u32,
    left: &Aabb<f32>,
    right: &Aabb<f32>,
) -> WideNode {
    let flag = |is_set: bool, flag: u32| if is_set { flag } else { 0 };
    WideNode {
        left_min: left.min,
        unused: 0,
        left_max: left.max,
        unused_too: 0,
        right_min: right.min,
        split,
        right_max: right.max,
        flags: flag(branch.left >= n_internal, WideNode::LEFT_IS_LEAF)
            | flag(branch.right >= n_internal, WideNode::RIGHT_IS_LEAF)
            | flag(split - branch.first < branch.last - split, WideNode::LEFT_IS_SMALLER),
    }
}

/// Nodes that a workgroup makes together.
pub const TILE: u32 = 256;

/// Powers of two of leaves up to a whole tile.
pub const POWERS: u32 = TILE.trailing_zeros() + 1;

/// Whether all leaves below a node are in the tile that begins at leaf `tile`.
#[inline(always)]
pub fn is_within(tile: u32, branch: &Branch) -> bool {
    branch.first >= tile && branch.last < tile + TILE
}

/// Nodes beside the way down to a query's own leaf that wait at a time. Before more are found,
/// these are taken.
const BESIDE: usize = 16;

/// A traversal between two of its steps.
#[derive(Clone, Copy, Debug)]
pub struct WideWalk {
    /// [`BESIDE`] at most when a traversal begins, and [`MAX_HEIGHT`] that it puts above them.
    waiting: Stack<{ MAX_HEIGHT + BESIDE }>,
    /// The node of the next step.
    pub node: u32,
    /// Whether nodes are left.
    pub goes_on: bool,
}

impl WideWalk {
    /// At the root of a tree of at least two leaves.
    #[inline(always)]
    pub fn new() -> Self {
        Self { waiting: Stack::new(), node: 0, goes_on: true }
    }

    /// Visits `node`, which is the record of [`WideWalk::node`], and returns the numbers of its
    /// children that are leaves and overlap `query`, [`NONE`] for the others.
    ///
    /// Every node is visited at most once; for the stack see [`MAX_HEIGHT`].
    #[inline(always)]
    pub fn step(&mut self, node: &WideNode, query: &Aabb<f32>) -> [u32; 2] {
        let to_left = node.left_box().overlaps(query);
        let to_right = node.right_box().overlaps(query);
        let left_is_leaf = node.has(WideNode::LEFT_IS_LEAF);
        let right_is_leaf = node.has(WideNode::RIGHT_IS_LEAF);
        let (left, right) = (node.split, node.split + 1);
        let found = [
            if to_left && left_is_leaf { left } else { NONE },
            if to_right && right_is_leaf { right } else { NONE },
        ];
        let (down_left, down_right) = (to_left && !left_is_leaf, to_right && !right_is_leaf);
        if down_left && down_right {
            let left_is_smaller = node.has(WideNode::LEFT_IS_SMALLER);
            self.waiting.push(if left_is_smaller { right } else { left });
            self.node = if left_is_smaller { left } else { right };
        } else if down_left {
            self.node = left;
        } else if down_right {
            self.node = right;
        } else {
            self.take();
        }
        found
    }

    /// Goes on with a node that waits, if there is one.
    #[inline(always)]
    pub fn take(&mut self) {
        self.goes_on = self.waiting.height() > 0;
        if self.goes_on {
            self.node = self.waiting.pop();
        }
    }
}

impl Default for WideWalk {
    fn default() -> Self {
        Self::new()
    }
}

/// The way from the root down to a query's own leaf. Every pair is found once if each query looks
/// for leaves after its own alone: they are below the right children of nodes on that way, which
/// are kept for a traversal if they overlap the query. Nothing is asked of the nodes of the way
/// themselves, and of their records the second half is read.
#[derive(Clone, Copy, Debug)]
pub struct LeafDescent {
    /// The number of the query's own leaf.
    leaf: u32,
    /// The next node on the way.
    pub node: u32,
    /// Whether the leaf is reached.
    pub is_done: bool,
}

impl LeafDescent {
    /// At the root of a tree of at least two leaves.
    #[inline(always)]
    pub fn to(leaf: u32) -> Self {
        Self { leaf, node: 0, is_done: false }
    }

    /// Whether nodes of the way are left, and `walk` has a place for what is found beside it. Else
    /// those that wait are taken first.
    #[inline(always)]
    pub fn goes_on(&self, walk: &WideWalk) -> bool {
        !self.is_done && walk.waiting.height() < BESIDE as u32
    }

    /// Visits `node`, which is the record of [`LeafDescent::node`]. Where the query's own leaf is
    /// below its left child, all leaves below the right one come after it: a right child that
    /// overlaps `query` waits in `walk`, or is returned if it is a leaf. Else returns [`NONE`].
    #[inline(always)]
    pub fn step(&mut self, node: &WideNode, query: &Aabb<f32>, walk: &mut WideWalk) -> u32 {
        let (left, right) = (node.split, node.split + 1);
        if self.leaf > left {
            self.node = right;
            self.is_done = node.has(WideNode::RIGHT_IS_LEAF);
            return NONE;
        }
        self.node = left;
        self.is_done = node.has(WideNode::LEFT_IS_LEAF);
        let (overlaps, is_leaf) =
            (node.right_box().overlaps(query), node.has(WideNode::RIGHT_IS_LEAF));
        if overlaps && !is_leaf {
            walk.waiting.push(right);
        }
        if overlaps && is_leaf { right } else { NONE }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::radix_tree::last_of_left;
    use crate::broad_phase::test_trees::{Tree, boxes, splits};
    use std::vec::Vec;

    /// Leaves after the query's own that overlap it, and whether the way was left before its end.
    fn after(nodes: &[WideNode], query: &Aabb, leaf: u32) -> (Vec<u32>, bool) {
        let (mut descent, mut walk) = (LeafDescent::to(leaf), WideWalk::new());
        let (mut found, mut waited) = (Vec::new(), false);
        while !descent.is_done {
            while descent.goes_on(&walk) {
                found.push(descent.step(&nodes[descent.node as usize], query, &mut walk));
            }
            waited |= !descent.is_done;
            walk.take();
            while walk.goes_on {
                found.extend(walk.step(&nodes[walk.node as usize], query));
            }
        }
        found.retain(|&leaf| leaf != NONE);
        found.sort_unstable();
        (found, waited)
    }

    #[test]
    fn a_leaf_finds_those_after_it_however_deep_the_tree_is() {
        let everywhere = Vec::from_iter((0..300).map(|_| Aabb { min: [0.0; 3], max: [1.0; 3] }));
        let mut waited = false;
        for all in [boxes(300, 7), everywhere, boxes(2, 1)] {
            for (name, split) in splits() {
                let tree = Tree::new(&all, split);
                let n_internal = tree.branches.len() as u32;
                let record = |branch: &Branch| {
                    let split = last_of_left(branch, n_internal);
                    let [left, right] =
                        [branch.left, branch.right].map(|child| tree.nodes[child as usize].aabb());
                    wide_node(branch, split, n_internal, &left, &right)
                };
                let nodes = Vec::from_iter(tree.branches.iter().map(record));
                for (leaf, query) in (0..).zip(&all) {
                    let (found, early) = after(&nodes, query, leaf);
                    let overlaps = |other: &u32| all[*other as usize].overlaps(query);
                    let want = Vec::from_iter((leaf + 1..all.len() as u32).filter(overlaps));
                    assert_eq!(found, want, "{name}, leaf {leaf}");
                    waited |= early;
                }
            }
        }
        assert!(waited, "more waited beside a way than there are places");
    }
}
