//! Simultaneous traversal: pairs of nodes, from the root with itself on, by one thread [Karras
//! 2012b], [da Silva 2013], algorithm 2.1.
//!
//! ```text
//!   (0, 0)           boxes overlap: the pairs of their children, see pair_descent.rs
//!   (1, 1) (1, 4) (4, 4)
//!          (2, 4) (3, 4)      apart: nothing below has a pair
//! ```
//!
//! Boxes that are near each other descend together for as long as they can, so that there are far
//! fewer steps than by a query per box. Of two sets (inter-collision) both have trees, and pairs
//! are sought from both roots on; within one (intra-collision), a node with itself has the pairs
//! within each child and between the two. Pairs that wait are in a list that grows.
//!
//! Cost: one step a pair of nodes that overlap. Choose it where one thread is all there is; with
//! more, [`super::cut`].

use super::binary_pairs::{BinaryPairs, ROOTS};
use super::{Traverse, Trees};
use crate::broad_phase::descend::Descend;
use crate::broad_phase::leaf_boxes::Sides;
use crate::broad_phase::rows::{Gathered, Rows, Scratch};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::model::method::Descent;

/// From the roots, in one task.
#[derive(Debug)]
pub struct Simultaneous {
    descent: Descent,
}

impl Simultaneous {
    /// By this rule of expansion.
    pub fn new(descent: Descent) -> Self {
        Self { descent }
    }
}

impl Traverse for Simultaneous {
    fn descends_both(&self) -> bool {
        true
    }

    fn begin(&mut self, _threads: &Threads, _trees: Trees, _sides: Sides) -> usize {
        1
    }

    fn task(&self, _k: usize, trees: Trees, (_, b): Sides, scratch: &mut Scratch, rows: &mut Rows) {
        let pairs = BinaryPairs::new(trees, b.is_none(), self.descent);
        if pairs.is_wanted(ROOTS) {
            let mut rows = Gathered::new(rows);
            pairs.descend(ROOTS, scratch, &mut rows);
            rows.finish();
        }
    }

    fn descend(
        &mut self,
        trees: Trees,
        (_, b): Sides,
        run: &mut dyn FnMut(&dyn Descend, &[NodePair]),
    ) {
        run(&BinaryPairs::new(trees, b.is_none(), self.descent), &[ROOTS]);
    }

    fn max_threads(&self) -> usize {
        1
    }
}
