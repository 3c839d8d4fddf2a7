//! A source of pairs: what every way to find overlapping boxes has in common.
//!
//! It says in which order boxes are leaves, and emits pairs of leaves, not of ids: what belongs to
//! a leaf is laid out in that order, so that whatever takes the pairs serves every source.

use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
use crate::simd::RowSimd;
use crate::threads::Threads;
use ccd_core::Aabb;

/// Whether box `i` stands still; pairs of two such boxes need not be emitted.
pub type Fixed<'a> = &'a (dyn Fn(usize) -> bool + Sync);

/// Finds overlapping boxes of a few sets, whose boxes and leaf order are in [`LeafBoxes`]; keeps
/// its own buffers between calls.
pub trait PairSource {
    /// Fills `order`, from leaf to id, for boxes that are new, and forgets those of the set before.
    fn sort(&mut self, threads: &Threads, set: Set, boxes: &[Aabb<f32>], fixed: Option<Fixed>, order: &mut Vec<u32>);

    /// Takes the boxes of a set, the first time after [`PairSource::sort`] and whenever they moved.
    /// Returns how much looser its volumes around several boxes are, relative to these, than the
    /// first time.
    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64;

    /// Hands the sink all pairs of leaves whose boxes overlap: of `a` against `b`, or within `a`
    /// (each unordered pair once, none with itself) if `b` is `None`. `part`: only every so
    /// many-th task (1: all).
    ///
    /// Which tasks there are, and what order pairs have within a task, depends on the boxes alone.
    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        sides: (&LeafBoxes, Option<&LeafBoxes>),
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    );
}

/// Takes overlapping pairs of leaves, one against up to eight.
pub trait PairSink: Sync {
    /// What each thread has of its own.
    type Worker: Send;
    /// Lane `lane` of block `a` overlaps the lanes `mask` of block `b`; `mask` is not 0. Must be
    /// `#[inline(always)]`, or the instruction set is not enabled inside.
    fn row<S: RowSimd>(&self, worker: &mut Self::Worker, simd: S, a: usize, lane: usize, b: usize, mask: u32);
    /// A task begins.
    fn begin(&self, _worker: &mut Self::Worker, _task: usize) {}
    /// No further task comes.
    fn end(&self, _worker: &mut Self::Worker) {}
}
