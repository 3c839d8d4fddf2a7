//! Sweep and tiniest queue: the sweep of [`super::sweep_and_prune`] in rounds, with a queue of
//! boxes whose intervals last [Belgrod 2023].
//!
//! Twin: none; on a GPU, for which it was made, tiles of `key_intervals.rs` go forward together.
//!
//! ```text
//!   round 1    a|b   b|c   c|d   d|e       each box with the next one in the order
//!   round 2    a|c   b|d         d|f       c ended before d began: its place is free
//!   round 3          b|e                   until the queue is empty
//! ```
//!
//! So whoever works on the queue has a test at every step, however long a box is; along one axis a
//! box whose interval is long keeps the threads beside it waiting. Here an item is a box and the
//! block of eight that is its next. On a CPU, where nobody waits, the queue is what it costs: it is
//! here for comparison.

use crate::broad_phase::leaf_boxes::{Order, Set, Sides};
use crate::broad_phase::marks::Marks;
use crate::broad_phase::rows::{RowSource, Rows, Scratch};
use crate::broad_phase::sweep_and_prune::{Sweep, SweepAndPrune, TASK, emit};
use crate::simd::{RowSimd, WIDTH, Work};
use crate::threads::Threads;
use ccd_core::{Aabb, Error};

/// The order of the sweep.
#[derive(Debug, Default)]
pub struct SweepAndTiniestQueue(SweepAndPrune);

impl Order for SweepAndTiniestQueue {
    fn survey(&mut self, threads: &Threads, sets: &[&[Aabb<f32>]]) -> Result<(), Error> {
        self.0.survey(threads, sets)
    }

    fn outlasts_motion(&self) -> bool {
        self.0.outlasts_motion()
    }

    fn sort(
        &mut self,
        threads: &Threads,
        set: Set,
        boxes: &[Aabb<f32>],
        marks: &Marks,
        order: &mut Vec<u32>,
    ) {
        self.0.sort(threads, set, boxes, marks, order);
    }
}

impl RowSource for SweepAndTiniestQueue {
    fn begin(&mut self, threads: &Threads, sides: Sides) -> usize {
        self.0.begin(threads, sides)
    }

    fn task(&self, k: usize, sides: Sides, scratch: &mut Scratch, rows: &mut Rows) {
        let queue = &mut scratch.pairs;
        queue.clear();
        queue.reserve(WIDTH * TASK);
        let mut all = None;
        for sweep in self.0.sweeps(k, sides) {
            let start = sweep.start() as u32;
            queue.extend((0..sweep.lanes()).map(|j| [(sweep.block * WIDTH + j) as u32, start]));
            all = Some(sweep);
        }
        if let Some(sweep) = all {
            crate::simd::run_rows!(Rounds { sweep, queue, rows });
        }
    }
}

/// The rounds of a task; a sweep of one of its blocks.
struct Rounds<'a, 'b> {
    sweep: Sweep<'a>,
    /// Leaves, each with its next block.
    queue: &'a mut Vec<[u32; 2]>,
    rows: &'a mut Rows<'b>,
}

impl<S: RowSimd> Work<S> for Rounds<'_, '_> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let Self { sweep, queue, rows } = self;
        while !queue.is_empty() {
            queue.retain_mut(|[leaf, next]| {
                let (block, lane, b) =
                    (*leaf as usize / WIDTH, *leaf as usize % WIDTH, *next as usize);
                let sweep = Sweep { block, ..sweep };
                if b == sweep.others.len() || sweep.is_past(lane, b) {
                    return false;
                }
                let leaves = &sweep.leaves.blocks()[block];
                let found = simd.overlaps(leaves, lane, &sweep.others[b]);
                emit(sweep.role, block, lane, b, found & sweep.finds(simd, lane, b), rows);
                *next += 1;
                true
            });
        }
    }
}
