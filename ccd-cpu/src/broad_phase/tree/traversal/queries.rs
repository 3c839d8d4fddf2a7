//! A query per box: four traversals of one tree [Karras 2012b], each of which changes one thing in
//! the one before.
//!
//! Queries know nothing of each other, so any number of threads can make them; each begins at the
//! root, and neighbours visit almost the same nodes again.
//!
//! **Recursive** ([`recursive`]): in the order of input, by a function that calls itself.
//!
//! **Iterative**: with a stack instead.
//!
//! ```text
//!   node    stack           both children overlap: go on with one, put the other on the stack
//!    0                      one does: go on with it
//!    1      4               none does: take one from the stack
//!    2      4 3
//! ```
//!
//! The stack is [`ccd_core::backend::broad_phase::stack_traversal::Walk`], which a GPU uses too:
//! there it makes neighbouring threads run the same loop, whatever each decides. On a CPU it saves
//! calls. Cost: per query, the nodes whose boxes overlap it; each pair is found twice within one
//! set and kept once. Both are here for comparison.
//!
//! **Leaf order**: boxes that are near each other are queried one after the other, and visit the
//! same nodes while these are still in the cache. Neighbours in the input need not be neighbours in
//! the tree. Of two sets, only the boxes of the first are put in this order, and a tree over them
//! is not needed. Cost: the same nodes in less time each.
//!
//! **Half**: in the order of leaves, each query looking only at leaves after its own. Every pair is
//! found once, and half of the tree is never visited.
//!
//! ```text
//!            0 .. 7             the query of leaf 2: nothing in 0 .. 1 comes after it,
//!         /          \          so that node is skipped without a look at its box
//!      0 .. 3      4 .. 7
//!      /    \
//!   0 .. 1  2 .. 3
//! ```
//!
//! The last leaf below a node says whether anything below it comes later. It is the number of an
//! internal left child, so nothing needs to be read for it. Of two sets there is no such order, and
//! this is leaf order. Cost: about half of the nodes and half of the tests of leaf order. Choose it
//! for boxes of which few overlap: it is the fastest of the queries.

#[cfg(feature = "catalogue")]
use super::recursive;
use super::{Traverse, Trees};
use crate::broad_phase::leaf_boxes::Sides;
use crate::broad_phase::rows::{Rows, Scratch};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::model::method::Traversal;
use std::sync::atomic::{AtomicU32, Ordering};

/// Queries a task: some thousand tasks where there are many.
const CHUNK: usize = 128;

/// A query per box, of two sets per box of the first.
#[derive(Debug)]
pub struct Queries {
    traversal: Traversal,
    /// From id to leaf, where queries go in the order of input.
    leaf_of: Vec<AtomicU32>,
}

impl Queries {
    /// By one of the four traversals.
    pub fn new(traversal: Traversal) -> Self {
        Self { traversal, leaf_of: Vec::new() }
    }

    fn in_input_order(&self) -> bool {
        matches!(self.traversal, Traversal::Recursive | Traversal::Iterative)
    }
}

impl Traverse for Queries {
    fn begin(&mut self, threads: &Threads, _trees: Trees, (a, _): Sides) -> usize {
        if self.in_input_order() {
            self.leaf_of.resize_with(a.len(), AtomicU32::default);
            let (order, leaf_of) = (a.order(), &self.leaf_of);
            let place =
                |leaf: usize| leaf_of[order[leaf] as usize].store(leaf as u32, Ordering::Relaxed);
            threads.fill(&mut vec![(); order.len()], place);
        }
        a.len().div_ceil(CHUNK)
    }

    fn task(
        &self,
        k: usize,
        trees: Trees,
        (a, b): Sides,
        Scratch { hits, visits, .. }: &mut Scratch,
        rows: &mut Rows,
    ) {
        let (within, half) = (b.is_none(), self.traversal == Traversal::Half);
        for i in k * CHUNK..((k + 1) * CHUNK).min(a.len()) {
            let leaf = match self.in_input_order() {
                true => self.leaf_of[i].load(Ordering::Relaxed),
                false => i as u32,
            };
            hits.clear();
            let after = if half && within { leaf } else { NONE };
            let query = &a.get(leaf as usize);
            *visits += match self.traversal {
                #[cfg(feature = "catalogue")]
                Traversal::Recursive => recursive::find(trees.b, query, hits),
                _ => trees.b.query(query, after, hits),
            };
            if within && !half {
                hits.retain(|&hit| hit > leaf);
            }
            rows.push_leaves(leaf as usize, hits);
        }
    }
}
