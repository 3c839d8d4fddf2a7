//! Traversals of binary trees: which nodes are visited, in which order, by whom.
//!
//! | a query per box | of pairs of nodes |
//! |---|---|
//! | [`recursive`]: in the order of input, by recursion | [`simultaneous`]: by one thread |
//! | [`iterative`]: with a stack | [`cut`]: in parallel |
//! | [`leaf_order`]: in the order of leaves | |
//! | [`half`]: of leaves after its own | |
//!
//! Left is what [`queries`] has, right what [`binary_pairs`] has; down the table each changes one
//! thing in the one above it.

mod binary_pairs;
mod cut;
mod half;
mod iterative;
mod leaf_order;
mod queries;
mod recursive;
mod simultaneous;

use super::binary_tree::BinaryTree;
use crate::broad_phase::descend::Descend;
use crate::broad_phase::pair_source::{Rows, Scratch, Sides};
use crate::threads::Threads;
use ccd_core::Error;
use ccd_core::broad_phase::pair_descent::NodePair;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::Traversal;
use cut::Cut;
use half::Half;
use iterative::Iterative;
use leaf_order::LeafOrder;
use queries::Queries;
use recursive::Recursive;
use simultaneous::Simultaneous;
use std::fmt::Debug;

/// The trees of both sides; the same if pairs are sought within one.
#[derive(Clone, Copy, Debug)]
pub struct Trees<'a> {
    /// Over the first, where the traversal wants one.
    pub a: Option<&'a BinaryTree>,
    /// Over the second, or the only one.
    pub b: &'a BinaryTree,
}

/// Finds pairs in trees, task by task; see [`crate::broad_phase::pair_source::RowSource`].
pub trait Traverse: Debug + Send + Sync {
    /// Whether the first of two sets needs a tree, too.
    fn descends_both(&self) -> bool {
        false
    }

    /// Prepares; returns the number of tasks.
    fn begin(&mut self, threads: &Threads, trees: Trees, sides: Sides) -> usize;

    /// Does one task.
    fn task(&self, k: usize, trees: Trees, sides: Sides, scratch: &mut Scratch, rows: &mut Rows);

    /// Calls `run` with the pairs of nodes of these trees, and with those at which a descent
    /// begins, if it descends pairs; after [`Traverse::begin`].
    fn descend(
        &mut self,
        _trees: Trees,
        _sides: Sides,
        _run: &mut dyn FnMut(&dyn Descend, &[NodePair]),
    ) {
    }

    /// Most threads that take tasks.
    fn max_threads(&self) -> usize {
        usize::MAX
    }
}

/// The traversal of a choice, if there is one here.
pub fn new(choice: Traversal) -> Result<Box<dyn Traverse>, Error> {
    Ok(match choice {
        Traversal::Recursive => Box::new(Queries::<Recursive>::new()),
        Traversal::Iterative => Box::new(Queries::<Iterative>::new()),
        Traversal::LeafOrder => Box::new(Queries::<LeafOrder>::new()),
        Traversal::Half => Box::new(Queries::<Half>::new()),
        Traversal::Simultaneous(descent) => Box::new(Simultaneous::new(descent)),
        Traversal::Cut { nodes, descent } => Box::new(Cut::new(nodes as usize, descent)),
        other => return Err(Error::Method { name: other.row().name, backend: "cpu" }),
    })
}
