//! Emit: overlapping pairs by independent traversal with an explicit stack [Karras 2012b], one node
//! a step.
//!
//! Within one set, queries go in leaf order and each looks only at leaves after its own, so that
//! every pair is found once.

use crate::kernel::memory::at;
use crate::kernel::stack::Stack;
use crate::layout::{Branch, Node};
use crate::math::aabb::Aabb;

/// Capacity of a stack, in nodes. Of two children a traversal goes on with the one that has fewer
/// leaves, at most half of those of both, so that with `h` nodes on the stack it is in a subtree of
/// at most `n / 2^h` leaves: a node is taken from the stack at the height at which it was put
/// there. The node that it is at is internal and has at least two leaves, hence `2^(h + 1) <= n <
/// 2^31`, and `h` is 29 at most, for any tree, however deep.
pub const MAX_HEIGHT: usize = 31;

/// A traversal between two of its steps.
#[derive(Clone, Copy, Debug)]
pub struct Walk {
    waiting: Stack<MAX_HEIGHT>,
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
        Self { waiting: Stack::new(), node: 0, goes_on: true }
    }

    /// The internal node that the next step visits.
    #[inline(always)]
    pub fn node(&self) -> u32 {
        self.node
    }

    /// Leaves that node and all below it out.
    #[inline(always)]
    pub fn skip(&mut self) {
        self.goes_on = self.waiting.height() > 0;
        if self.goes_on {
            self.node = self.waiting.pop();
        }
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
            self.waiting.push(if left_is_smaller { branch.right } else { branch.left });
            self.node = if left_is_smaller { branch.left } else { branch.right };
        } else if down_left {
            self.node = branch.left;
        } else if down_right {
            self.node = branch.right;
        } else {
            self.skip();
        }
        found
    }
}

impl Default for Walk {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::test_trees::{Tree, boxes, splits};
    use std::vec::Vec;

    /// All that overlaps the query, in the order in which it is found; the greatest height of the
    /// stack; the steps.
    fn query(tree: &Tree, query: &Aabb<f32>, after: u32) -> (Vec<u32>, u32, usize) {
        let (mut walk, mut found, mut greatest, mut steps) = (Walk::new(), Vec::new(), 0, 0);
        while walk.goes_on {
            let n_internal = tree.branches.len() as u32;
            let step = walk.step(query, &tree.nodes, &tree.branches, n_internal, after);
            found.extend(step.into_iter().filter(|&leaf| leaf != NONE));
            greatest = greatest.max(walk.waiting.height());
            steps += 1;
        }
        (found, greatest, steps)
    }

    /// Greatest number of nodes that wait if the left child is always visited first.
    fn height_left_first(tree: &Tree) -> usize {
        let (mut stack, mut greatest) = (Vec::from([0u32]), 0);
        while let Some(node) = stack.pop() {
            let branch = &tree.branches[node as usize];
            let internal = [branch.right, branch.left];
            stack.extend(internal.into_iter().filter(|&c| (c as usize) < tree.branches.len()));
            greatest = greatest.max(stack.len().saturating_sub(1));
        }
        greatest
    }

    #[test]
    fn stacks_are_no_higher_than_the_logarithm() {
        let everything = Aabb { min: [-1.0; 3], max: [2.0; 3] };
        // Trees of fewest levels are the ones whose stacks are highest: exactly the bound.
        for levels in 1..18 {
            let n = 1usize << levels;
            let tree = Tree::new(&boxes(n, 3), |first, last| first + (last - first) / 2);
            let (found, height, steps) = query(&tree, &everything, NONE);
            assert_eq!((found.len(), height, steps), (n, levels - 1, n - 1));
        }
        // The deepest trees: chains of leaves and of pairs. Left first is what would overflow.
        let n = 5000;
        let mut deepest = 0;
        for (name, split) in splits() {
            let tree = Tree::new(&boxes(n, 3), split);
            for after in [NONE, 0, 17, n as u32 / 2] {
                let (found, height, _) = query(&tree, &everything, after);
                let left_out = if after == NONE { 0 } else { after as usize + 1 };
                assert_eq!(found.len(), n - left_out, "{name}, after {after}");
                assert!(height < n.ilog2(), "{name}: {height} nodes wait");
            }
            deepest = deepest.max(height_left_first(&tree));
        }
        assert!(deepest > 1000, "left first: {deepest} nodes wait");
    }
}
