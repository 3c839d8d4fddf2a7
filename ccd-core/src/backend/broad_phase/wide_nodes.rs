//! Binary trees as a device reads them: a record holds the boxes of both children, so that a step
//! of a traversal is one read of 64 bytes in one place [Aila 2009].
//!
//! ```text
//!        node        first        split  split + 1        last
//!       /    \         |-- left box --|  |-- right box --|
//!    left   right     leaves, in the order of the Morton curve
//! ```
//!
//! A leaf has no record: its box is read among the sorted boxes. The boxes of a node's children are
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
    let left_is_smaller = split - branch.first < branch.last - split;
    WideNode {
        left_min: left.min,
        left: child(branch.left, n_internal),
        left_max: left.max,
        right: child(branch.right, n_internal),
        right_min: right.min,
        split,
        right_max: right.max,
        last: branch.last | if left_is_smaller { WideNode::MARK } else { 0 },
    }
}

#[inline(always)]
fn child(node: u32, n_internal: u32) -> u32 {
    if node >= n_internal { (node - n_internal) | WideNode::MARK } else { node }
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

/// A traversal between two of its steps.
#[derive(Clone, Copy, Debug)]
pub struct WideWalk {
    stack: [u32; MAX_HEIGHT],
    height: u32,
    /// The node of the next step.
    pub node: u32,
    /// Whether nodes are left.
    pub goes_on: bool,
}

impl WideWalk {
    /// At the root of a tree of at least two leaves.
    #[inline(always)]
    pub fn new() -> Self {
        Self { stack: [0; MAX_HEIGHT], height: 0, node: 0, goes_on: true }
    }

    /// Visits `node`, which is the record of [`WideWalk::node`], and returns the numbers of its
    /// children that are leaves and overlap `query`, [`NONE`] for the others.
    ///
    /// `after`: leaves up to and including this number are left out; [`NONE`]: none are. Every node
    /// is visited at most once; for the stack see [`MAX_HEIGHT`].
    #[inline(always)]
    pub fn step(&mut self, node: &WideNode, query: &Aabb<f32>, after: u32) -> [u32; 2] {
        let (all, last) = (after == NONE, node.last & !WideNode::MARK);
        let to_left = (all || node.split > after) && node.left_box().overlaps(query);
        let to_right = (all || last > after) && node.right_box().overlaps(query);
        let left_is_leaf = node.left & WideNode::MARK != 0;
        let right_is_leaf = node.right & WideNode::MARK != 0;
        let found = [
            if to_left && left_is_leaf { node.left & !WideNode::MARK } else { NONE },
            if to_right && right_is_leaf { node.right & !WideNode::MARK } else { NONE },
        ];
        let (down_left, down_right) = (to_left && !left_is_leaf, to_right && !right_is_leaf);
        if down_left && down_right {
            let left_is_smaller = node.last & WideNode::MARK != 0;
            self.stack[self.height as usize] = if left_is_smaller { node.right } else { node.left };
            self.height += 1;
            self.node = if left_is_smaller { node.left } else { node.right };
        } else if down_left {
            self.node = node.left;
        } else if down_right {
            self.node = node.right;
        } else {
            self.skip();
        }
        found
    }

    /// Leaves the node of the next step and all below it out.
    #[inline(always)]
    pub fn skip(&mut self) {
        if self.height > 0 {
            self.height -= 1;
            self.node = self.stack[self.height as usize];
        } else {
            self.goes_on = false;
        }
    }
}

impl Default for WideWalk {
    fn default() -> Self {
        Self::new()
    }
}
