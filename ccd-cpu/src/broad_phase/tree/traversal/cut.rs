//! Simultaneous traversal: pairs of nodes that overlap are expanded to pairs of their children
//! [Karras 2012b], [da Silva 2013], algorithm 2.1; by one thread from the roots on, or in parallel
//! from all pairs of the nodes of a cut through the tree.
//!
//! ```text
//!   (0, 0)                     boxes overlap: the pairs of their children, see pair_descent.rs
//!   (1, 1) (1, 4) (4, 4)
//!          (2, 4) (3, 4)       apart: nothing below has a pair
//! ```
//!
//! Boxes that are near each other descend together for as long as they can, so there are far fewer
//! steps than with a query per box. Of two sets (inter-collision) both have trees; within one
//! (intra-collision), a node with itself has the pairs within each child and between the two. Pairs
//! that wait are in a list that grows.
//!
//! ```text
//!              0              a cut of 3 nodes, in brackets: every leaf is below exactly one
//!          /       \          6 pairs: 1 with 1, 4, 7; 4 with 4, 7; 7 with 7
//!        [1]        3
//!       /   \     /   \
//!      ..   ..  [4]   [7]
//! ```
//!
//! The cut begins with the root, and the node with most leaves is split until there are as many as
//! are wanted: 256 by default (1 is the traversal from the roots), which have 32,896 pairs, a node
//! with itself being one. Of two sets every node of one cut is paired with every node of the other.
//! A task is one node of the first cut with all of its pairs.
//!
//! Cost: a step for every pair of nodes that overlap, less those above the cut, and a test of boxes
//! for every pair of the cut. Choose it where boxes are many and pairs few, on a CPU with several
//! threads: there it takes a third of the time of the half traversal; where each box overlaps
//! dozens, as much. On a GPU neighbouring threads have nothing in common.

use super::binary_pairs::BinaryPairs;
use super::{Traverse, Trees};
use crate::broad_phase::descend::Descend;
use crate::broad_phase::leaf_boxes::Sides;
use crate::broad_phase::rows::{Gathered, Rows, Scratch};
use crate::broad_phase::tree::binary_tree::BinaryTree;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::model::method::Descent;
use std::collections::BinaryHeap;

/// From the pairs of a cut, a task a node.
#[derive(Debug, Default)]
pub struct Cut {
    n_nodes: usize,
    descent: Descent,
    /// Nodes of the cuts of both sides in the order of leaves; within one set the second alone.
    cuts: [Vec<u32>; 2],
    /// Nodes that may be split further, with the numbers of their leaves.
    heap: BinaryHeap<(usize, u32)>,
    /// All pairs of the cuts, for a scheduler.
    pairs: Vec<NodePair>,
}

impl Cut {
    /// By this rule of expansion, from a cut of so many nodes on, if there are so many leaves.
    pub fn new(n_nodes: usize, descent: Descent) -> Self {
        Self { n_nodes, descent, ..Self::default() }
    }

    /// Fills one of the cuts.
    fn fill(&mut self, side: usize, tree: &BinaryTree) {
        let (heap, cut) = (&mut self.heap, &mut self.cuts[side]);
        heap.clear();
        heap.push((tree.range(0).len(), 0));
        while let Some(&(n_leaves, node)) = heap.peek() {
            if n_leaves == 1 || heap.len() >= self.n_nodes {
                break;
            }
            heap.pop();
            let branch = &tree.branches[node as usize];
            heap.extend([branch.left, branch.right].map(|child| (tree.range(child).len(), child)));
        }
        cut.clear();
        cut.extend(heap.iter().map(|&(_, node)| node));
        cut.sort_unstable_by_key(|&node| tree.range(node).start);
    }
}

impl Traverse for Cut {
    fn descends_both(&self) -> bool {
        true
    }

    fn begin(&mut self, _threads: &Threads, trees: Trees, (_, b): Sides) -> usize {
        self.fill(1, trees.b);
        match (b, trees.a) {
            (Some(_), Some(a)) => {
                self.fill(0, a);
                self.cuts[0].len()
            }
            _ => self.cuts[1].len(),
        }
    }

    fn descend(
        &mut self,
        trees: Trees,
        (_, b): Sides,
        run: &mut dyn FnMut(&dyn Descend, &[NodePair]),
    ) {
        let Self { cuts: [first, second], pairs, .. } = self;
        pairs.clear();
        match b {
            Some(_) => {
                pairs.extend(first.iter().flat_map(|&i| second.iter().map(move |&j| [i, j])))
            }
            None => {
                let from = |(k, &i): (usize, &u32)| second[k..].iter().map(move |&j| [i, j]);
                pairs.extend(second.iter().enumerate().flat_map(from));
            }
        }
        run(&BinaryPairs::new(trees, b.is_none(), self.descent), pairs);
    }

    fn task(&self, k: usize, trees: Trees, (_, b): Sides, scratch: &mut Scratch, rows: &mut Rows) {
        let within = b.is_none();
        let pairs = BinaryPairs::new(trees, within, self.descent);
        let [first, second] = &self.cuts;
        let (i, against) = if within { (second[k], &second[k..]) } else { (first[k], &second[..]) };
        let mut rows = Gathered::new(rows);
        for &j in against {
            scratch.visits += 1;
            if pairs.is_wanted([i, j]) {
                pairs.descend([i, j], scratch, &mut rows);
            }
        }
        rows.finish();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
    use crate::broad_phase::marks::Marks;
    use crate::broad_phase::tree::TreeSource;
    use ccd_core::Aabb;
    use ccd_core::model::method::TreeOptions;

    #[test]
    fn every_leaf_is_below_one_node_of_the_cut() {
        let threads = Threads::new(1).unwrap();
        for n in [1usize, 2, 3, 100, 1000] {
            let boxes: Vec<_> = (0..n).map(|i| Aabb::of_point([(i * i) as f32; 3])).collect();
            let mut source = TreeSource::new(TreeOptions::default()).unwrap();
            let mut leaves = LeafBoxes::new(Set { index: 0, searched: true });
            leaves.build(&threads, &mut source, &boxes, Marks::default());
            let tree = source.tree(0);
            for n_nodes in [1, 2, 7, 256, 1024] {
                let mut cut = Cut::new(n_nodes, Descent::Larger);
                let n_tasks = cut.begin(&threads, Trees { a: None, b: tree }, (&leaves, None));
                assert_eq!(n_tasks, n_nodes.min(n), "{n} leaves");
                let below = cut.cuts[1].iter().flat_map(|&node| tree.range(node));
                assert!(below.eq(0..n as u32), "{n_nodes} nodes over {n} leaves: {:?}", cut.cuts);
                // None is larger than what was split for the smallest.
                let sizes = || cut.cuts[1].iter().map(|&node| tree.range(node).len());
                let parent = |node: u32| {
                    let is_child = |b: &_| -> bool {
                        let ccd_core::backend::layout::Branch { left, right, .. } = *b;
                        left == node || right == node
                    };
                    tree.branches
                        .iter()
                        .position(is_child)
                        .map_or(n, |p| tree.range(p as u32).len())
                };
                let least_split = cut.cuts[1].iter().map(|&node| parent(node)).min();
                assert!(sizes().max() <= least_split, "{n_nodes} nodes over {n} leaves");
            }
        }
    }
}
