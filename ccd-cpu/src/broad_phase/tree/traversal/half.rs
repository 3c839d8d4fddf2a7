//! A query per box in the order of leaves, with a stack, each looking only at leaves after its own
//! [Karras 2012b]: every pair is found once, and half of the tree is never visited.

use super::{Traverse, Trees};
use crate::broad_phase::pair_source::{Rows, Scratch, Sides};
use crate::threads::Threads;
use ccd_core::broad_phase::stack_traversal::NONE;

/// Queries a task: some thousand tasks where there are many.
const CHUNK: usize = 128;

/// Half of the tree a query; of two sets, all of the second's tree for every box of the first.
#[derive(Debug)]
pub struct Half;

impl Traverse for Half {
    fn begin(&mut self, _threads: &Threads, _trees: Trees, (a, _): Sides) -> usize {
        a.len().div_ceil(CHUNK)
    }

    fn task(
        &self,
        k: usize,
        trees: Trees,
        (a, b): Sides,
        Scratch { hits, .. }: &mut Scratch,
        rows: &mut Rows,
    ) {
        for leaf in k * CHUNK..((k + 1) * CHUNK).min(a.len()) {
            hits.clear();
            let after = if b.is_none() { leaf as u32 } else { NONE };
            trees.b.query(&a.get(leaf), after, hits);
            rows.push_leaves(leaf, hits);
        }
    }
}
