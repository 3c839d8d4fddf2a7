//! What the traversals that make a query per box have in common; [`super::recursive`],
//! [`super::iterative`], [`super::leaf_order`] and [`super::half`] say in what they differ.
//!
//! Queries know nothing of each other, so any number of threads can make them; each begins at the
//! root, and neighbours visit almost the same nodes again.

use super::{Traverse, Trees};
use crate::broad_phase::leaf_boxes::{LeafBoxes, Sides};
use crate::broad_phase::rows::{Rows, Scratch};
use crate::broad_phase::tree::binary_tree::BinaryTree;
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use std::fmt::Debug;
use std::marker::PhantomData;
use std::sync::atomic::{AtomicU32, Ordering};

/// Queries a task: some thousand tasks where there are many.
const CHUNK: usize = 128;

/// A way to make queries.
pub trait Query: Debug + Send + Sync + 'static {
    /// Whether queries go in the order of input; else in that of leaves.
    const INPUT_ORDER: bool = false;

    /// Whether a query within one set looks only at leaves after its own. If not, it finds itself,
    /// and every pair is found by both of its boxes and kept once.
    const HALF: bool = false;

    /// Appends all leaves after leaf `after` that overlap `query`; [`NONE`], always so unless
    /// [`Query::HALF`]: all leaves. Returns the number of internal nodes that it visited.
    fn find(tree: &BinaryTree, query: &Aabb<f32>, after: u32, hits: &mut Vec<u32>) -> u64 {
        tree.query(query, after, hits)
    }
}

/// A query per box, of two sets per box of the first.
#[derive(Debug)]
pub struct Queries<Q> {
    /// From id to leaf, where queries go in the order of input.
    leaf_of: Vec<AtomicU32>,
    way: PhantomData<Q>,
}

impl<Q: Query> Queries<Q> {
    /// Queries of this kind.
    pub fn new() -> Self {
        Self { leaf_of: Vec::new(), way: PhantomData }
    }

    /// Inverts the order of leaves.
    fn number(&mut self, threads: &Threads, of: &LeafBoxes) {
        self.leaf_of.resize_with(of.len(), AtomicU32::default);
        let (order, leaf_of) = (of.order(), &self.leaf_of);
        let place =
            |leaf: usize| leaf_of[order[leaf] as usize].store(leaf as u32, Ordering::Relaxed);
        threads.fill(&mut vec![(); order.len()], place);
    }
}

impl<Q: Query> Traverse for Queries<Q> {
    fn begin(&mut self, threads: &Threads, _trees: Trees, (a, _): Sides) -> usize {
        if Q::INPUT_ORDER {
            self.number(threads, a);
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
        let within = b.is_none();
        for i in k * CHUNK..((k + 1) * CHUNK).min(a.len()) {
            let leaf =
                if Q::INPUT_ORDER { self.leaf_of[i].load(Ordering::Relaxed) } else { i as u32 };
            hits.clear();
            let after = if Q::HALF && within { leaf } else { NONE };
            *visits += Q::find(trees.b, &a.get(leaf as usize), after, hits);
            if within && !Q::HALF {
                hits.retain(|&hit| hit > leaf);
            }
            rows.push_leaves(leaf as usize, hits);
        }
    }
}
