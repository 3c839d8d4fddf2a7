//! Emit: overlapping pairs by independent traversal with an explicit stack [Karras 2012b], one node
//! a step.
//!
//! Within one set, queries go in leaf order and each looks only at leaves after its own, so that
//! every pair is found once.

use crate::kernel::memory::at;
use crate::layout::{Branch, Node};
use crate::math::aabb::Aabb;

/// Nodes that a stack has room for. Of two children a traversal goes on with the one that has fewer
/// leaves, so that with `h` nodes on the stack it is in a subtree of at most `n / 2^h` leaves; there
/// are fewer than `2^31`, and a node that waits has at least two. This holds for any tree, however
/// deep.
pub const MAX_HEIGHT: usize = 31;

/// A traversal between two of its steps.
#[derive(Clone, Copy, Debug)]
pub struct Walk {
    stack: [u32; MAX_HEIGHT],
    height: u32,
    node: u32,
    /// Whether nodes are left.
    pub goes_on: bool,
}

/// Leaves that a step found: what their nodes hold in `left`, [`NONE`] where there is none.
pub type Found = [u32; 2];

/// In [`Found`]: no leaf.
pub const NONE: u32 = u32::MAX;

impl Walk {
    /// At the root of a tree of at least two leaves.
    #[inline(always)]
    pub fn new() -> Self {
        Self { stack: [0; MAX_HEIGHT], height: 0, node: 0, goes_on: true }
    }

    /// Visits one internal node and returns those of its children that are leaves and overlap
    /// `query`. `nodes` as in [`Node`], of which the first `n_internal` are internal.
    ///
    /// `after`: leaves up to and including this number are left out; [`NONE`]: none are. Every node
    /// is visited at most once, so there are at most `n_internal` steps; for the stack see
    /// [`MAX_HEIGHT`].
    #[inline(always)]
    pub fn step(
        &mut self,
        query: &Aabb<f32>,
        nodes: &[Node],
        branches: &[Branch],
        n_internal: u32,
        after: u32,
    ) -> Found {
        let branch = at(branches, self.node as usize);
        // The last leaf below the left child, which Karras' numbering tells: an internal left child
        // has the number of its last leaf.
        let last_of_left =
            if branch.left >= n_internal { branch.left - n_internal } else { branch.left };
        let (left, right) = (at(nodes, branch.left as usize), at(nodes, branch.right as usize));
        let to_left = (after == NONE || last_of_left > after) && left.aabb().overlaps(query);
        let to_right = (after == NONE || branch.last > after) && right.aabb().overlaps(query);
        let found = [
            if to_left && left.is_leaf() { left.left } else { NONE },
            if to_right && right.is_leaf() { right.left } else { NONE },
        ];
        let (down_left, down_right) = (to_left && !left.is_leaf(), to_right && !right.is_leaf());
        if down_left && down_right {
            let left_is_smaller = last_of_left - branch.first < branch.last - last_of_left;
            self.stack[self.height as usize] =
                if left_is_smaller { branch.right } else { branch.left };
            self.height += 1;
            self.node = if left_is_smaller { branch.left } else { branch.right };
        } else if down_left {
            self.node = branch.left;
        } else if down_right {
            self.node = branch.right;
        } else if self.height > 0 {
            self.height -= 1;
            self.node = self.stack[self.height as usize];
        } else {
            self.goes_on = false;
        }
        found
    }
}

impl Default for Walk {
    fn default() -> Self {
        Self::new()
    }
}
