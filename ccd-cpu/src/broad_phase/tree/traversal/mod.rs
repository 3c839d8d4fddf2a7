//! Traversals of binary trees: which nodes are visited, in which order, by whom.
//!
//! Twin: none; on a GPU `tree.rs` has queries, and the scheduler has pairs of nodes.
//!
//! | a query per box: [`queries`] | pairs of nodes: [`cut`] |
//! |---|---|
//! | recursive: in the order of input, by recursion | simultaneous: from the roots, by one thread |
//! | iterative: with a stack | cut: in parallel |
//! | leaf order: in the order of leaves | |
//! | half: leaves after its own | |
//!
//! Down the table each changes one thing in the one above it. In [`double_recursion`] a descent of
//! one tree makes the queries of the other.

#[cfg(feature = "catalogue")]
mod binary_pairs;
#[cfg(feature = "catalogue")]
pub mod cut;
#[cfg(feature = "catalogue")]
pub mod double_recursion;
pub mod queries;
#[cfg(feature = "catalogue")]
mod recursive;

use super::binary_tree::BinaryTree;
#[cfg(feature = "catalogue")]
use crate::broad_phase::descend::Descend;
use crate::broad_phase::leaf_boxes::Sides;
use crate::broad_phase::rows::{Rows, Scratch};
use crate::threads::Threads;
#[cfg(feature = "catalogue")]
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use std::fmt::Debug;

/// The trees of both sides; the same if pairs are sought within one.
#[derive(Clone, Copy, Debug)]
pub struct Trees<'a> {
    /// Over the first, where the traversal wants one.
    pub a: Option<&'a BinaryTree>,
    /// Over the second, or the only one.
    pub b: &'a BinaryTree,
}

/// Finds pairs in trees, task by task; see [`crate::broad_phase::rows::RowSource`].
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
    #[cfg(feature = "catalogue")]
    fn descend(
        &mut self,
        _trees: Trees,
        _sides: Sides,
        _run: &mut dyn FnMut(&dyn Descend, &[NodePair]),
    ) {
    }
}
