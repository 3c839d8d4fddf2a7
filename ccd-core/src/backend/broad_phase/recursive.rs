//! Emit: overlapping pairs by recursion, the first rung of the ladder [Karras 2012b], where there
//! are no calls: the stack has the places to which calls return.
//!
//! ```text
//!   visit(child):   its box overlaps the query?   no: return
//!                   a leaf: found, return
//!                   visit(the child with fewer leaves)     <- the stack has this node
//!                   visit(the other one)                   a call at the end needs no place
//! ```
//!
//! A step is a call: one box is tested, and then the thread calls, or returns, or calls at the end.
//! So an internal node takes two steps and three ways through the loop, between which threads side
//! by side diverge, where [`super::wide_nodes`] takes one step and one way; its record is read
//! twice. This is what the source's loop gains over its recursion. It is here for comparison.
//!
//! Changed here: the child with fewer leaves comes first. A call that must return is for at most
//! half of the leaves of its caller, so that [`MAX_HEIGHT`] places do for any tree, however deep.
//!
//! Twin: on a CPU `tree/traversal/recursive.rs`, a function that calls itself.

use super::stack_traversal::{MAX_HEIGHT, NONE};
use crate::kernel::stack::Stack;
use crate::layout::WideNode;
use crate::math::aabb::Aabb;

/// A recursion between two of its calls.
#[derive(Clone, Copy, Debug)]
pub struct Calls {
    callers: Stack<MAX_HEIGHT>,
    /// The node that calls.
    pub node: u32,
    /// Whether it has called for its first child.
    second: bool,
    /// Whether calls are left.
    pub goes_on: bool,
}

impl Calls {
    /// In the call for the root of a tree of at least two leaves.
    #[inline(always)]
    pub fn new() -> Self {
        Self { callers: Stack::new(), node: 0, second: false, goes_on: true }
    }

    /// Whether the node is looked at for the first time.
    #[inline(always)]
    pub fn enters(&self) -> bool {
        !self.second
    }

    /// Calls for a child of `node`, which is the record of [`Calls::node`]. Returns the number of
    /// the leaf that it is, if it overlaps the query; else [`NONE`]. Of `n` internal nodes there
    /// are at most `2 n` calls.
    #[inline(always)]
    pub fn step(&mut self, node: &WideNode, query: &Aabb<f32>) -> u32 {
        let is_left = node.has(WideNode::LEFT_IS_SMALLER) != self.second;
        let (child, overlaps, is_leaf) = if is_left {
            (node.split, node.left_box().overlaps(query), node.has(WideNode::LEFT_IS_LEAF))
        } else {
            (node.split + 1, node.right_box().overlaps(query), node.has(WideNode::RIGHT_IS_LEAF))
        };
        if overlaps && !is_leaf {
            if !self.second {
                self.callers.push(self.node);
            }
            self.node = child;
            self.second = false;
        } else if self.second {
            self.leave();
        } else {
            self.second = true;
        }
        if overlaps && is_leaf { child } else { NONE }
    }

    /// Returns from the node to the one that called for it.
    #[inline(always)]
    pub fn leave(&mut self) {
        if self.callers.height() > 0 {
            self.node = self.callers.pop();
            self.second = true;
        } else {
            self.goes_on = false;
        }
    }
}

impl Default for Calls {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::radix_tree::last_of_left;
    use crate::broad_phase::test_trees::{Tree, boxes, splits};
    use crate::broad_phase::wide_nodes::{WideWalk, wide_node};
    use crate::layout::Branch;
    use std::vec::Vec;

    /// Records of the internal nodes.
    fn wide(tree: &Tree) -> Vec<WideNode> {
        let n_internal = tree.branches.len() as u32;
        let record = |branch: &Branch| {
            let split = last_of_left(branch, n_internal);
            let [left, right] =
                [branch.left, branch.right].map(|child| tree.nodes[child as usize].aabb());
            wide_node(branch, split, n_internal, &left, &right)
        };
        tree.branches.iter().map(record).collect()
    }

    #[test]
    fn calls_find_what_a_loop_finds_in_twice_as_many_steps() {
        let all = boxes(3000, 3);
        for (name, split) in splits() {
            let nodes = wide(&Tree::new(&all, split));
            let everything = Aabb { min: [-1.0; 3], max: [2.0; 3] };
            let nothing = Aabb { min: [9.0; 3], max: [9.0; 3] };
            for query in all[..40].iter().chain([&everything, &nothing]) {
                let (mut found, mut n_calls, mut highest) = (Vec::new(), 0, 0);
                let mut calls = Calls::new();
                while calls.goes_on {
                    found.push(calls.step(&nodes[calls.node as usize], query));
                    (n_calls, highest) = (n_calls + 1, calls.callers.height().max(highest));
                }
                let (mut want, mut n_steps) = (Vec::new(), 0);
                let mut walk = WideWalk::new();
                while walk.goes_on {
                    want.extend(walk.step(&nodes[walk.node as usize], query));
                    n_steps += 1;
                }
                for leaves in [&mut found, &mut want] {
                    leaves.retain(|&leaf| leaf != NONE);
                    leaves.sort_unstable();
                }
                assert_eq!(found, want, "{name}");
                assert_eq!(n_calls, 2 * n_steps, "{name}");
                assert!(highest < all.len().ilog2(), "{name}: {highest} calls wait");
            }
        }
    }
}
