//! Figures by which builders of binary trees are compared.

/// How good a binary tree is: less is better, of every figure.
///
/// ```
/// use ccd::method::TreeStatistics;
///
/// // A root over two boxes of half its surface each.
/// let tree = TreeStatistics { nodes: 3, depth: 2, sah_cost: 2.0, visited_per_query: 1.0 };
/// assert_eq!(tree.nodes, 2 * 2 - 1);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
