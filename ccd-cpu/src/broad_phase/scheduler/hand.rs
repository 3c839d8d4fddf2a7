//! What a worker expands pairs with.

use ccd_core::backend::broad_phase::pair_descent::NodePair;

/// Expands pairs that meet: hands on rows of leaves, and appends the children that meet and are no
/// leaves.
pub type Expand<'e> = &'e mut dyn FnMut(&[NodePair], &mut Vec<NodePair>);

/// A worker's hand on a tree of pairs.
pub struct Hand<'h> {
    worker: usize,
    expand: Expand<'h>,
}

impl<'h> Hand<'h> {
    /// Of the worker with this number.
    pub fn new(worker: usize, expand: Expand<'h>) -> Self {
        Self { worker, expand }
    }

    /// Its number, which no other has.
    pub fn worker(&self) -> usize {
        self.worker
    }

    /// Expands pairs, as [`Expand`] says.
    pub fn expand(&mut self, pairs: &[NodePair], out: &mut Vec<NodePair>) {
        (self.expand)(pairs, out);
    }
}
