//! Figures of a tree, from a walk of all queries.
//!
//! Twin: none; figures are taken on a CPU.

use super::binary_tree::BinaryTree;
use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::backend::layout::Node;
use ccd_core::model::tree_statistics::TreeStatistics;

/// Figures of a tree with the boxes of its last fit. Takes a walk of all queries.
pub fn statistics(tree: &BinaryTree, threads: &Threads, leaves: &LeafBoxes) -> TreeStatistics {
    let n = leaves.len();
    let mut visited = vec![0u64; n];
    threads.enter(|| threads.fill(&mut visited, |i| visits(tree, leaves, i)));
    TreeStatistics {
        nodes: tree.nodes().len(),
        depth: depth(tree),
        sah_cost: sah_cost(tree.nodes()),
        visited_per_query: visited.iter().sum::<u64>() as f64 / n.max(1) as f64,
    }
}

/// Internal nodes that the query with the box of a leaf visits.
fn visits(tree: &BinaryTree, leaves: &LeafBoxes, leaf: usize) -> u64 {
    let (query, n_internal) = (leaves.get(leaf), tree.branches.len() as u32);
    let mut walk = Walk::new();
    let mut visited = 0;
    while n_internal > 0 && walk.goes_on {
        walk.step(&query, tree.nodes(), &tree.branches, n_internal, NONE);
        visited += 1;
    }
    visited
}

/// The longest way down, found with a list of nodes to visit, because a tree may be as deep as it
/// has leaves.
fn depth(tree: &BinaryTree) -> usize {
    let mut deepest = 0;
    let mut open: Vec<(u32, usize)> = Vec::new();
    open.extend((!tree.nodes().is_empty()).then_some((0, 1)));
    while let Some((node, depth)) = open.pop() {
        deepest = deepest.max(depth);
        if let Some(branch) = tree.branches.get(node as usize) {
            open.extend([(branch.left, depth + 1), (branch.right, depth + 1)]);
        }
    }
    deepest
}

fn sah_cost(nodes: &[Node]) -> f64 {
    let surface = |node: &Node| {
        let side = |k: usize| node.max[k] as f64 - node.min[k] as f64;
        side(0) * side(1) + side(1) * side(2) + side(2) * side(0)
    };
    let Some(root) = nodes.first().map(surface) else { return 0.0 };
    if root > 0.0 { nodes.iter().map(surface).sum::<f64>() / root } else { nodes.len() as f64 }
}
