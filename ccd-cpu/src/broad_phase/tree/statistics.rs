//! Figures of a tree by which builders are compared.

use super::binary_tree::BinaryTree;
use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::threads::Threads;
use ccd_core::broad_phase::stack_traversal::{NONE, Walk};
use ccd_core::layout::Node;

/// How good a binary tree is: less is better, of every figure.
///
/// ```
/// use ccd_core::Aabb;
/// use ccd_core::model::method::BroadPhaseMethod;
/// use ccd_cpu::BroadPhase;
///
/// let mut broad_phase = BroadPhase::new(1, BroadPhaseMethod::TREE)?;
/// let at = |i: u8| Aabb { min: [f32::from(i); 3], max: [f32::from(i) + 0.5; 3] };
/// broad_phase.self_pairs(&[at(0), at(1), at(2), at(3)])?;
/// let tree = broad_phase.tree_statistics().expect("it is a tree");
/// assert_eq!((tree.nodes, tree.depth), (7, 3));
/// # Ok::<(), ccd_core::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TreeStatistics {
    /// Nodes, leaves included.
    pub nodes: usize,
    /// Nodes on the longest way from the root to a leaf, both included; 0 of no tree.
    pub depth: usize,
    /// The sum of the surfaces of the boxes of all nodes, over that of the root's box: how many
    /// nodes a random line through the root's box hits on average, if a visit costs the same
    /// whether it is an internal node or a leaf (both constants of the heuristic are 1)
    /// [Goldsmith 1987]. If the root's box has no surface, every node counts as one.
    pub sah_cost: f64,
    /// Internal nodes that a query visits, with a box test of each of their children: the mean over
    /// queries for the leaves' own boxes, each in the whole tree. So the half traversal visits
    /// about half of them.
    pub visited_per_query: f64,
}

impl TreeStatistics {
    /// Of a tree with the boxes of its last fit. Takes a walk of all queries.
    pub fn of(tree: &BinaryTree, threads: &Threads, leaves: &LeafBoxes) -> Self {
        let n = leaves.len();
        let mut visited = vec![0u64; n];
        threads.enter(|| threads.fill(&mut visited, |i| visits(tree, leaves, i)));
        Self {
            nodes: tree.nodes().len(),
            depth: depth(tree),
            sah_cost: sah_cost(tree.nodes()),
            visited_per_query: visited.iter().sum::<u64>() as f64 / n.max(1) as f64,
        }
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
