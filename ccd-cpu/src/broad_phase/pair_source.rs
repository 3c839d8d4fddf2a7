//! A source of pairs and the sink that takes them: what every way to find overlapping boxes has in
//! common.
//!
//! A source says in which order boxes are leaves ([`Order`]), and emits pairs of leaves, not of
//! ids: what belongs to a leaf is laid out in that order, so that every sink serves every source.
//!
//! Sources come in two shapes. A [`PairSource`] hands rows to the sink at once, and is compiled for
//! every sink: for the default method. A [`super::rows::RowSource`] lists rows, some thousand at a
//! time, and is compiled once: for all others.

use crate::broad_phase::leaf_boxes::{Order, Sides};
use crate::simd::{Block, RowSimd, WIDTH};
use crate::threads::Threads;

/// Finds overlapping boxes, and hands rows of them to a sink.
pub trait PairSource {
    /// Its order of leaves.
    fn order(&mut self) -> &mut dyn Order;

    /// Hands the sink all pairs of leaves whose boxes overlap: of `a` against `b`, or within `a`
    /// (each unordered pair once, none with itself) if `b` is `None`. `part`: only every so
    /// many-th task (1: all).
    ///
    /// Which tasks there are, and what order pairs have within a task, depends on the boxes alone.
    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        sides: Sides,
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    );
}

/// Lane `lane` of block `a`, which overlaps the lanes `mask` of block `b`.
#[derive(Clone, Copy)]
pub struct Overlaps {
    pub a: usize,
    pub lane: usize,
    pub b: usize,
    /// Not 0.
    pub mask: u32,
}

/// Takes overlapping pairs of leaves, one against up to eight.
pub trait PairSink: Sync {
    /// The state of a thread.
    type Worker: Send;
    /// Whether the result depends on the order of rows, which then must not depend on threads.
    const ORDERED: bool = false;
    /// Takes a row. Must be `#[inline(always)]`, or the instruction set is not enabled inside.
    fn row<S: RowSimd>(&self, worker: &mut Self::Worker, simd: S, row: Overlaps);
    /// Takes lane `i` of block `a` and lane `j` of block `b`, which overlap, for each bit `j` of
    /// byte `i` of `masks`, not 0: as rows, one after the other, or as if they were. `boxes`: those
    /// of both blocks.
    #[inline(always)]
    fn blocks<S: RowSimd>(
        &self,
        worker: &mut Self::Worker,
        simd: S,
        blocks: (usize, usize),
        _boxes: [&Block; 2],
        masks: u64,
    ) {
        self.row_by_row(worker, simd, blocks, masks);
    }
    /// Takes lane `i` of `a` and lane `j` of `b` for each bit `j` of byte `i` of `masks`, as rows.
    #[inline(always)]
    fn row_by_row<S: RowSimd>(
        &self,
        worker: &mut Self::Worker,
        simd: S,
        (a, b): (usize, usize),
        mut masks: u64,
    ) {
        while masks != 0 {
            let lane = masks.trailing_zeros() as usize / WIDTH;
            let mask = (masks >> (WIDTH * lane)) as u32 & 0xff;
            masks &= !(0xff << (WIDTH * lane));
            self.row(worker, simd, Overlaps { a, lane, b, mask });
        }
    }
    /// A task begins; rows that come in no order belong to none.
    fn begin(&self, _worker: &mut Self::Worker, _task: usize) {}
    /// No further task comes.
    fn end(&self, _worker: &mut Self::Worker) {}
}

/// Byte `i`, bit `j`: whether box `i` of one block overlaps box `j` of another. All rows first,
/// without a branch between them.
#[inline(always)]
pub fn overlaps<S: RowSimd>(simd: S, [a, b]: [&Block; 2]) -> u64 {
    let mut masks = 0;
    for i in 0..WIDTH {
        masks |= (simd.overlaps(a, i, b) as u64) << (8 * i);
    }
    masks
}

/// Of overlaps of boxes that were rounded those by more than `slack`, and those that `confirmed`
/// says, which is asked for lane `i` of one block and lane `j` of the other.
#[inline(always)]
pub fn confirmed_overlaps<S: RowSimd>(
    simd: S,
    boxes: [&Block; 2],
    mut masks: u64,
    slack: f32,
    confirmed: impl Fn(usize, usize) -> bool,
) -> u64 {
    let (mut rest, mut unsure) = (masks, masks);
    while rest != 0 {
        let first = rest.trailing_zeros() as usize & !7;
        rest &= !(0xff << first);
        let sure = simd.overlaps_surely(boxes[0], first / WIDTH % WIDTH, boxes[1], slack);
        unsure &= !((sure as u64) << first);
    }
    while unsure != 0 {
        let bit = unsure.trailing_zeros() as usize;
        unsure &= unsure - 1;
        if !confirmed(bit / WIDTH, bit % WIDTH) {
            masks &= !(1 << bit);
        }
    }
    masks
}
