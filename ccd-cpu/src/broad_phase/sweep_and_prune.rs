//! Sweep and prune: boxes sorted by where they begin along the axis of largest variance, each
//! compared with those that begin before it ends [Cohen 1995], [Karras 2012a].
//!
//! Twin: on a GPU `key_intervals.rs`, by the keys of this method.
//!
//! The rule, a drawing and the cost are beside it in the core
//! ([`ccd_core::backend::broad_phase::sweep_and_prune`]). Here a task is a run of leaves, eight of
//! which go forward together, eight boxes of the other side a step, until all eight are past. Along
//! the second axis all eight rows are tested before any branch: of boxes that fill a cube few are
//! left, and only those are tested whole.

use crate::broad_phase::leaf_boxes::{LeafBoxes, Order, Set, Sides};
use crate::broad_phase::marks::Marks;
use crate::broad_phase::rows::{RowSource, Rows, Scratch};
use crate::simd::{Block, Mask, RowSimd, WIDTH, Work};
use crate::sort::RadixSort;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::sweep_and_prune::{Moments, begin_key, finds, is_past};
use ccd_core::{Aabb, Error, Num};

/// Blocks of leaves a task.
pub(super) const TASK: usize = 16;

/// The axes, and buffers of the sort.
#[derive(Debug, Default)]
pub struct SweepAndPrune {
    /// By falling variance; boxes are sorted along the first.
    axes: [usize; 3],
    chunks: Vec<Moments<f64>>,
    radix: RadixSort,
}

impl Order for SweepAndPrune {
    fn survey(&mut self, threads: &Threads, sets: &[&[Aabb<f32>]]) -> Result<(), Error> {
        let all = moments(threads, sets, &mut self.chunks);
        self.axes = all.axes();
        Ok(())
    }

    /// Moved boxes begin elsewhere.
    fn outlasts_motion(&self) -> bool {
        false
    }

    fn sort(
        &mut self,
        threads: &Threads,
        _set: Set,
        boxes: &[Aabb<f32>],
        _marks: &Marks,
        order: &mut Vec<u32>,
    ) {
        let axis = self.axes[0];
        // In the upper bits, which the sort takes digit by digit.
        let key = |i: usize| (begin_key(&boxes[i], axis) as u64) << 31;
        self.radix.sort(threads, boxes.len(), key, order);
    }
}

impl RowSource for SweepAndPrune {
    /// A task is a run of leaves of one set; of two sets, those of the first come first.
    fn begin(&mut self, _threads: &Threads, (a, b): Sides) -> usize {
        n_tasks(a) + b.map_or(0, n_tasks)
    }

    fn task(&self, k: usize, (a, b): Sides, _scratch: &mut Scratch, rows: &mut Rows) {
        for sweep in self.sweeps(k, (a, b)) {
            crate::simd::run_rows!(Forward { sweep, rows });
        }
    }
}

impl SweepAndPrune {
    /// The sweeps of a task, one for each of its blocks.
    pub(super) fn sweeps<'a>(
        &self,
        k: usize,
        (a, b): Sides<'a>,
    ) -> impl Iterator<Item = Sweep<'a>> {
        let axes = self.axes;
        let (role, leaves, others, first) = match b {
            None => (Role::Only, a, a, k),
            Some(b) if k < n_tasks(a) => (Role::First, a, b, k),
            Some(b) => (Role::Second, b, a, k - n_tasks(a)),
        };
        let blocks = first * TASK..((first + 1) * TASK).min(leaves.blocks().len());
        blocks.map(move |block| Sweep { axes, role, leaves, others: others.blocks(), block })
    }
}

/// Moments of the boxes of all sets.
pub fn moments(
    threads: &Threads,
    sets: &[&[Aabb<f32>]],
    chunks: &mut Vec<Moments<f64>>,
) -> Moments<f64> {
    let part = |boxes: &[Aabb<f32>]| Moments::of(0, boxes.len(), boxes);
    threads.fold(sets, Moments::none(), chunks, &part, &Moments::merged)
}

fn n_tasks(leaves: &LeafBoxes) -> usize {
    leaves.blocks().len().div_ceil(TASK)
}

/// Which set a leaf that looks for others belongs to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// The only one.
    Only,
    /// The first of two.
    First,
    /// The second.
    Second,
}

/// A block of leaves, and those that it is compared with.
#[derive(Clone, Copy)]
pub(super) struct Sweep<'a> {
    pub axes: [usize; 3],
    pub role: Role,
    pub leaves: &'a LeafBoxes,
    pub others: &'a [Block],
    pub block: usize,
}

impl Sweep<'_> {
    /// Lanes of the block that are leaves.
    #[inline(always)]
    pub fn lanes(&self) -> usize {
        (self.leaves.len() - self.block * WIDTH).min(WIDTH)
    }

    /// Whether a leaf of the block ends before any of block `b` begins.
    #[inline(always)]
    pub fn is_past(&self, lane: usize, b: usize) -> bool {
        let axis = self.axes[0];
        let end = self.leaves.blocks()[self.block].max[axis].0[lane];
        is_past(end, self.others[b].min[axis].0[0])
    }

    /// The first block of the others in which one may begin inside these leaves.
    pub fn start(&self) -> usize {
        if self.role == Role::Only {
            return self.block;
        }
        let axis = self.axes[0];
        let begin = self.leaves.blocks()[self.block].min[axis].0[0];
        // Lanes past the last begin at infinity.
        self.others.partition_point(|other| other.min[axis].0[WIDTH - 1] < begin)
    }

    /// Which lanes of block `b` leaf `lane` finds, of those that it overlaps.
    #[inline(always)]
    pub fn finds<S: RowSimd>(&self, simd: S, lane: usize, b: usize) -> u32 {
        let axis = self.axes[0];
        if self.role == Role::Only {
            // In one order leaves that begin at one place come one after the other.
            return if b == self.block { !0 << (lane + 1) } else { !0 };
        }
        let begin = S::Lanes::splat(self.leaves.blocks()[self.block].min[axis].0[lane]);
        let other = simd.load(&self.others[b].min[axis]);
        finds(begin, other, self.role == Role::First)
    }
}

/// Eight leaves on their way forward.
struct Forward<'a, 'b> {
    sweep: Sweep<'a>,
    rows: &'a mut Rows<'b>,
}

impl<S: RowSimd> Work<S> for Forward<'_, '_> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let Self { sweep, rows } = self;
        let [x, y, _] = sweep.axes;
        let block = &sweep.leaves.blocks()[sweep.block];
        let ends = simd.load(&block.max[x]);
        let lanes = (1u32 << sweep.lanes()) - 1;
        let mut b = sweep.start();
        while b < sweep.others.len() {
            let other = &sweep.others[b];
            let active = lanes & !is_past(ends, S::Lanes::splat(other.min[x].0[0])).bits();
            if active == 0 {
                break;
            }
            let mut near = near(simd, block, other, y, active);
            while near != 0 {
                let lane = near.trailing_zeros() as usize / 8;
                near &= !(0xff << (8 * lane));
                let mask = simd.overlaps(block, lane, other) & sweep.finds(simd, lane, b);
                emit(sweep.role, sweep.block, lane, b, mask, rows);
            }
            b += 1;
        }
    }
}

/// Byte `i`, bit `j`: whether box `i` of `a`, one of the `rows`, overlaps box `j` of `b` along an
/// axis.
#[inline(always)]
fn near<S: RowSimd>(simd: S, a: &Block, b: &Block, axis: usize, rows: u32) -> u64 {
    let (min, max) = (simd.load(&b.min[axis]), simd.load(&b.max[axis]));
    let mut out = 0;
    if rows == 0xff {
        for i in 0..WIDTH {
            let begin = S::Lanes::splat(a.min[axis].0[i]);
            let end = S::Lanes::splat(a.max[axis].0[i]);
            let apart = (begin.gt(max) | min.gt(end)).bits();
            out |= ((!apart & 0xff) as u64) << (8 * i);
        }
    } else {
        let mut rest = rows;
        while rest != 0 {
            let i = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            let begin = S::Lanes::splat(a.min[axis].0[i]);
            let end = S::Lanes::splat(a.max[axis].0[i]);
            let apart = (begin.gt(max) | min.gt(end)).bits();
            out |= ((!apart & 0xff) as u64) << (8 * i);
        }
    }
    out
}

/// Adds what lane `lane` of block `a` found in block `b`: a row of its own if it is of the first
/// set, else one for each of the leaves found.
#[inline(always)]
pub fn emit(role: Role, a: usize, lane: usize, b: usize, mut mask: u32, rows: &mut Rows) {
    if role != Role::Second {
        rows.push(a * WIDTH + lane, b, mask);
        return;
    }
    while mask != 0 {
        let j = mask.trailing_zeros() as usize;
        mask &= mask - 1;
        rows.push(b * WIDTH + j, a, 1 << lane);
    }
}
