//! What builders that join nodes from the leaves up have in common: who was joined with whom, and
//! from that the numbers of all nodes.

use crate::broad_phase::tree::shared_words::{Shared, copy, copy_branches};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::node_numbering::{
    BRANCH, JOIN, join_words, number, root_words, store_words,
};
use ccd_core::backend::kernel::Words;
use ccd_core::backend::layout::Branch;
use std::sync::atomic::AtomicU32;

/// A node and how many leaves it has.
#[derive(Clone, Copy, Debug, Default)]
pub struct Subtree {
    /// Its number in the tree that is being built: of `n - 1` internal nodes in any order, then of
    /// the leaves.
    pub node: u32,
    /// Its leaves.
    pub leaves: u32,
}

/// The tree that is being built; buffers are kept.
#[derive(Debug, Default)]
pub struct Joins {
    joins: Vec<AtomicU32>,
    places: Vec<AtomicU32>,
    branches: Vec<AtomicU32>,
    n_internal: u32,
}

impl Joins {
    /// Begins a tree over `n` leaves.
    pub fn begin(&mut self, n: usize) {
        let n_internal = n.saturating_sub(1);
        self.n_internal = n_internal as u32;
        for (words, len) in [
            (&mut self.joins, (n + n_internal) * JOIN),
            (&mut self.places, n),
            (&mut self.branches, n_internal * BRANCH),
        ] {
            words.resize_with(len, AtomicU32::default);
        }
    }

    /// Leaf `i`, in an order of the builder's own.
    pub fn leaf(&self, i: usize) -> Subtree {
        Subtree { node: self.n_internal + i as u32, leaves: 1 }
    }

    /// Makes internal node `node` the parent of two nodes; every node is made once.
    pub fn join(&self, node: u32, left: Subtree, right: Subtree) -> Subtree {
        let leaves = [left.leaves, right.leaves];
        store_words(join_words(node, [left.node, right.node], leaves), &Shared(&self.joins));
        Subtree { node, leaves: leaves[0] + leaves[1] }
    }

    /// Numbers all nodes, of which `root` has no parent; `id`: what leaf `i` of the builder's order
    /// is to be in `order`.
    pub fn finish(
        &self,
        threads: &Threads,
        root: u32,
        id: impl Fn(usize) -> u32 + Sync,
        order: &mut Vec<u32>,
        branches: &mut Vec<Branch>,
    ) {
        let (joins, places, n_internal) =
            (Shared(&self.joins), Shared(&self.places), self.n_internal);
        store_words(root_words(root), &joins);
        let branch_words = Shared(&self.branches);
        threads.fill(&mut vec![(); self.places.len()], |i| {
            let place = number(i as u32, n_internal, &joins, &branch_words);
            places.store(place as usize, id(i));
        });
        copy(threads, &self.places, order);
        copy_branches(threads, &self.branches, branches);
    }
}
