//! Double recursion: one tree is descended to each of its leaves, and that leaf through the other
//! tree, by two functions that call themselves, on one thread: the baseline of [Tian and Wan].
//!
//! ```text
//!   outer(node of a):  unless it is apart from all of b
//!                          a leaf:   inner(root of b) with the box of the leaf
//!                          else:     outer(each child)
//! ```
//!
//! The inner function is [`super::recursive`]; the outer one calls itself for the smaller child as
//! that one does, so that no tree is too deep. Within one set both trees are the same, and pairs
//! are found from both sides and kept once.
//!
//! Cost: that of a query per box, without those whose subtrees are apart from all of the other
//! side. It is here for comparison.

use super::{Traverse, Trees, recursive};
use crate::broad_phase::leaf_boxes::Sides;
use crate::broad_phase::rows::{Rows, Scratch};
use crate::broad_phase::tree::binary_tree::BinaryTree;
use crate::threads::Threads;
use ccd_core::backend::layout::Branch;

/// Two trees, one task.
#[derive(Debug)]
pub struct DoubleRecursion;

impl Traverse for DoubleRecursion {
    fn descends_both(&self) -> bool {
        true
    }

    fn begin(&mut self, _threads: &Threads, _trees: Trees, _sides: Sides) -> usize {
        1
    }

    fn task(&self, _k: usize, trees: Trees, (_, b): Sides, scratch: &mut Scratch, rows: &mut Rows) {
        let (a, within) = (trees.a.unwrap_or(trees.b), b.is_none());
        Outer { a, b: trees.b, within, scratch, rows }.visit(0);
    }
}

struct Outer<'a, 'b> {
    a: &'a BinaryTree,
    b: &'a BinaryTree,
    within: bool,
    scratch: &'a mut Scratch,
    rows: &'a mut Rows<'b>,
}

impl Outer<'_, '_> {
    /// All pairs of the leaves below a node.
    fn visit(&mut self, mut node: u32) {
        loop {
            let (a, all_of_b) = (&self.a.nodes()[node as usize], &self.b.nodes()[0]);
            if !(a.aabb().overlaps(&all_of_b.aabb()) && self.a.reach(node, self.b, 0)) {
                return;
            }
            let Some(&Branch { left, right, .. }) = self.a.branches.get(node as usize) else {
                return self.query(a.left);
            };
            self.scratch.visits += 1;
            let n_leaves = |child| self.a.range(child).len();
            let left_is_smaller = n_leaves(left) < n_leaves(right);
            let (fewer, more) = if left_is_smaller { (left, right) } else { (right, left) };
            self.visit(fewer);
            node = more;
        }
    }

    /// A leaf through the other tree.
    fn query(&mut self, leaf: u32) {
        let node = self.a.branches.len() + leaf as usize;
        let query = self.a.nodes()[node].aabb();
        let Scratch { hits, visits, .. } = &mut *self.scratch;
        hits.clear();
        *visits += recursive::find(self.b, &query, hits);
        if self.within {
            hits.retain(|&hit| hit > leaf);
        }
        self.rows.push_leaves(leaf as usize, hits);
    }
}
