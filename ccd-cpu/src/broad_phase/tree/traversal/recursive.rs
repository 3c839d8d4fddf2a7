//! A query per box in the order of input, by a function that calls itself: how one would first
//! write it [Karras 2012b].
//!
//! ```text
//!   visit(node):  for each child whose box overlaps that of the query
//!                     a leaf:   found
//!                     else:     visit(child)
//! ```
//!
//! Changed here: where both children are visited, the function calls itself for the one with fewer
//! leaves and goes on with the other in a loop. Each call then has at most half of the leaves of
//! its caller's node, and at least two, so that of fewer than `2^31` leaves no more than 30 calls
//! are within each other, in any tree, however deep.
//!
//! Cost: the nodes that a loop with a stack visits ([`super::queries`]), with a call for many of
//! them. A GPU has no calls, and keeps a stack in their place. It is here for comparison.

use crate::broad_phase::tree::binary_tree::BinaryTree;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::layout::Branch;

/// Appends all leaves that overlap `query`. Returns the number of internal nodes that it visited.
pub fn find(tree: &BinaryTree, query: &Aabb<f32>, hits: &mut Vec<u32>) -> u64 {
    match tree.branches.is_empty() {
        true => tree.query(query, NONE, hits),
        false => visit(tree, query, 0, hits),
    }
}

/// Appends the leaves below an internal node that overlap the query; returns how many internal
/// nodes it visited.
fn visit(tree: &BinaryTree, query: &Aabb<f32>, mut node: u32, hits: &mut Vec<u32>) -> u64 {
    let mut visits = 0;
    loop {
        if !tree.reaches(node, query) {
            return visits;
        }
        visits += 1;
        let Branch { left, right, .. } = tree.branches[node as usize];
        let mut goes_down = |child: u32| {
            let child = &tree.nodes()[child as usize];
            let overlaps = child.aabb().overlaps(query);
            hits.extend((overlaps && child.is_leaf()).then_some(child.left));
            overlaps && !child.is_leaf()
        };
        match (goes_down(left), goes_down(right)) {
            (true, true) => {
                let n_leaves = |child| tree.range(child).len();
                let left_is_smaller = n_leaves(left) < n_leaves(right);
                let (fewer, more) = if left_is_smaller { (left, right) } else { (right, left) };
                visits += visit(tree, query, fewer, hits);
                node = more;
            }
            (true, false) => node = left,
            (false, true) => node = right,
            (false, false) => return visits,
        }
    }
}
