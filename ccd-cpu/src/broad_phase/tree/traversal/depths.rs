//! How far below the nodes where descents begin every node is: what says from which pair of nodes
//! another one came, where both nodes of a pair are split.
//!
//! ```text
//!   (0, 0)               both nodes are split for as long as both have children, so that
//!   (1, 4)  (1, 7) ..    in a pair the less deep one, if there is one, is a leaf: above
//!   (2, 5)  (2, 6)       (2, 9) there is (2, 6), where 2 was a leaf already, and above
//!           (2, 9) ..    (2, 6) there is (1, 4)
//! ```

use super::Trees;
use crate::broad_phase::tree::binary_tree::BinaryTree;
use ccd_core::broad_phase::pair_descent::NodePair;

/// Depths of the nodes of two trees, or of one.
#[derive(Debug, Default)]
pub struct Depths {
    of: [Vec<u32>; 2],
    stack: Vec<u32>,
}

impl Depths {
    /// Of these trees, below nodes such that every leaf is below one of them. Of one tree those of
    /// the second side count.
    pub fn fill(&mut self, trees: Trees, from: [&[u32]; 2]) {
        let [of_a, of_b] = &mut self.of;
        if let Some(a) = trees.a.filter(|a| !std::ptr::eq(*a, trees.b)) {
            fill(a, from[0], of_a, &mut self.stack);
        }
        fill(trees.b, from[1], of_b, &mut self.stack);
    }

    /// The pair of nodes above this one, and whether this is its first child; `None` of a pair at
    /// which descents begin.
    #[inline(always)]
    pub fn parent(
        &self,
        within: bool,
        [a, b]: [&BinaryTree; 2],
        [i, j]: NodePair,
    ) -> Option<(NodePair, bool)> {
        let depth_i = self.of[within as usize][i as usize];
        let depth_j = self.of[1][j as usize];
        if depth_i.max(depth_j) == 0 {
            return None;
        }
        let up = |tree: &BinaryTree, node: u32, goes: bool| {
            if goes {
                let parent = tree.parent(node);
                (parent, tree.branches[parent as usize].left == node)
            } else {
                (node, true)
            }
        };
        let (p, first_i) = up(a, i, depth_i >= depth_j);
        let (q, first_j) = up(b, j, depth_j >= depth_i);
        Some(([p, q], first_i && first_j))
    }
}

fn fill(tree: &BinaryTree, from: &[u32], depths: &mut Vec<u32>, stack: &mut Vec<u32>) {
    depths.clear();
    depths.resize(tree.nodes().len(), 0);
    stack.clear();
    stack.extend_from_slice(from);
    while let Some(node) = stack.pop() {
        if let Some(branch) = tree.branches.get(node as usize) {
            for child in [branch.left, branch.right] {
                depths[child as usize] = depths[node as usize] + 1;
                stack.push(child);
            }
        }
    }
}
