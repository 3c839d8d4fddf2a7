//! Uniform grid: boxes sorted by the cell of their centre, each compared with those in the cells
//! around its own [Karras 2012a].
//!
//! Twin: on a GPU `key_intervals.rs`, by the keys of this method.
//!
//! The rule, its proof, a drawing and the cost are beside it in the core
//! ([`ccd_core::backend::broad_phase::uniform_grid`]). Here there is no table of cells, neither by
//! number nor by hash: cells are visited in the order of the sort, and so are the rows of cells
//! around them, so that where each row begins and ends in the sorted boxes only moves on. The boxes
//! of a cell are compared with a row eight at a time.

use crate::broad_phase::leaf_boxes::{LeafBoxes, Marks, Order, Set, Sides};
use crate::broad_phase::rows::{RowSource, Rows, Scratch};
use crate::simd::{Block, RowSimd, WIDTH, Work};
use crate::sort::RadixSort;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::uniform_grid::{
    self as cells, OWN_ROW, ROWS, Sizes, TESTS_A_BOX,
};
use ccd_core::{Aabb, Error};
use std::ops::Range;

/// Leaves a task.
const TASK: usize = 512;
/// Boxes of a set whose cells are counted to estimate how full cells are.
const SAMPLE: usize = 1 << 13;

/// The grid, and the cell of every leaf.
#[derive(Debug, Default)]
pub struct UniformGrid {
    grid: cells::UniformGrid,
    /// Of each set: the number of the cell of each leaf, ascending.
    keys: Vec<Vec<u32>>,
    /// Sizes of boxes, and the sum of the largest side of each.
    chunks: Vec<(Sizes, f64)>,
    sample: Vec<u32>,
    radix: RadixSort,
}

impl UniformGrid {
    /// Sizes of the boxes of all sets, and the sum of the largest side of each.
    fn measure(&mut self, threads: &Threads, sets: &[&[Aabb<f32>]]) -> (Sizes, f64) {
        let none = (Sizes::NONE, 0.0);
        let merged =
            |all: &(Sizes, f64), part: &(Sizes, f64)| (all.0.merged(&part.0), all.1 + part.1);
        let part = |boxes: &[Aabb<f32>]| {
            boxes.iter().fold(none, |all, b| {
                let sizes = Sizes::of(b);
                merged(&all, &(sizes, largest_side(&sizes)))
            })
        };
        threads.fold(sets, none, &mut self.chunks, &part, &merged)
    }

    /// About how many boxes of a set are in the cells around each in the mean, and about how many
    /// in the fullest cell: exactly up to [`SAMPLE`] boxes, from as many of them if there are more.
    fn fullness(&mut self, boxes: &[Aabb<f32>]) -> (f64, u64) {
        let Self { grid, sample, .. } = self;
        let (n, m) = (boxes.len() as u64, boxes.len().min(SAMPLE) as u64);
        sample.clear();
        // One of each of so many parts of the list; which one follows no pattern of the input.
        let pick = |j: u64| {
            let offset = ((j as u32).wrapping_mul(0x9e37_79b9) as u64 * n) >> 32;
            if n == m { j } else { (j * n + offset) / m }
        };
        sample.extend((0..m).map(|j| cells::key(grid.cell(&boxes[pick(j) as usize]))));
        sample.sort_unstable();
        let mut runs = [const { 0..0 }; ROWS as usize];
        let (mut pairs, mut fullest) = (0, 0);
        for cell in sample.chunk_by(|a, b| a == b) {
            let mut around = 0;
            for (row, run) in (0..ROWS).zip(&mut runs) {
                let [first, last] = cells::row(cells::cell_of(cell[0]), row, false);
                if first <= last {
                    advance(run, sample, first, last);
                    around += run.len() as u64;
                }
            }
            pairs += cell.len() as u64 * (around - 1);
            fullest = fullest.max(cell.len() as u64);
        }
        // A box of the sample has this part of the others around it.
        let part = m.saturating_sub(1) as f64 / n.saturating_sub(1).max(1) as f64;
        let tests = if part > 0.0 { pairs as f64 / m as f64 / part } else { 0.0 };
        (tests, fullest * n / m.max(1))
    }
}

/// The largest side of a box.
fn largest_side(sizes: &Sizes) -> f64 {
    2.0 * sizes.half.iter().fold(0.0, |m: f64, &half| m.max(half as f64))
}

impl Order for UniformGrid {
    /// Cells as large as the largest box of all sets; refuses if that makes them too full.
    fn survey(&mut self, threads: &Threads, sets: &[&[Aabb<f32>]]) -> Result<(), Error> {
        let (sizes, sum) = self.measure(threads, sets);
        self.grid = cells::UniformGrid::new(&sizes);
        let (mut tests, mut fullest) = (0.0, 0);
        // Fewer boxes than that cannot take as many tests.
        for boxes in sets.iter().filter(|boxes| boxes.len() as u64 > TESTS_A_BOX) {
            let (of_set, cell) = self.fullness(boxes);
            if of_set > tests {
                (tests, fullest) = (of_set, cell);
            }
        }
        if tests <= TESTS_A_BOX as f64 {
            return Ok(());
        }
        let n: usize = sets.iter().map(|boxes| boxes.len()).sum();
        Err(Error::CrowdedCells {
            largest: largest_side(&sizes),
            mean: sum / n as f64,
            fullest,
            tests: tests as u64,
            limit: TESTS_A_BOX,
        })
    }

    /// Moved boxes are in other cells.
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
        let grid = &self.grid;
        // In the upper bits, which the sort takes digit by digit.
        let key = |i: usize| (cells::key(grid.cell(&boxes[i])) as u64) << 33;
        self.radix.sort(threads, boxes.len(), key, order);
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        let set = leaves.set().index;
        if self.keys.len() <= set {
            self.keys.resize_with(set + 1, Vec::new);
        }
        let (grid, keys) = (&self.grid, &mut self.keys[set]);
        keys.resize(leaves.len(), 0);
        threads.fill(keys, |leaf| cells::key(grid.cell(&leaves.get(leaf))));
        1.0
    }
}

impl RowSource for UniformGrid {
    fn begin(&mut self, _threads: &Threads, (a, _): Sides) -> usize {
        a.len().div_ceil(TASK)
    }

    fn task(&self, k: usize, (a, b): Sides, _scratch: &mut Scratch, rows: &mut Rows) {
        let (own, other) = (&self.keys[a.set().index], b.unwrap_or(a));
        let keys = &self.keys[other.set().index];
        let end = ((k + 1) * TASK).min(a.len());
        let forward = b.is_none();
        let first_row = if forward { OWN_ROW } else { 0 };
        let mut cursors: [Option<Range<usize>>; ROWS as usize] = Default::default();
        let mut leaf = k * TASK;
        while leaf < end {
            let cell = own[leaf];
            let n = own[leaf..end].iter().take_while(|&&key| key == cell).count();
            for row in first_row..ROWS {
                let [first, last] = cells::row(cells::cell_of(cell), row, forward);
                if first > last {
                    continue;
                }
                let cursor = &mut cursors[row as usize];
                let mut run = cursor.take().unwrap_or_else(|| {
                    let start = keys.partition_point(|&key| key < first);
                    start..start
                });
                advance(&mut run, keys, first, last);
                // Leaves of the cell itself look at those after themselves.
                let after = forward && row == OWN_ROW;
                if run.end > if after { leaf + 1 } else { run.start } {
                    let (queries, blocks, others) = (leaf..leaf + n, a.blocks(), other.blocks());
                    let compare =
                        Compare { blocks, queries, others, run: run.clone(), after, rows };
                    crate::simd::run_rows!(compare);
                }
                *cursor = Some(run);
            }
            leaf += n;
        }
    }
}

/// Moves a run on to the leaves with the cells `first ..= last`; both only go up.
#[inline(always)]
fn advance(run: &mut Range<usize>, keys: &[u32], first: u32, last: u32) {
    while run.start < keys.len() && keys[run.start] < first {
        run.start += 1;
    }
    run.end = run.end.max(run.start);
    while run.end < keys.len() && keys[run.end] <= last {
        run.end += 1;
    }
}

/// The leaves `queries` against the leaves `run` of the other side, or those `after` themselves.
struct Compare<'a, 'b> {
    blocks: &'a [Block],
    queries: Range<usize>,
    others: &'a [Block],
    run: Range<usize>,
    after: bool,
    rows: &'a mut Rows<'b>,
}

impl<S: RowSimd> Work<S> for Compare<'_, '_> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let Self { blocks, queries, others, run, after, rows } = self;
        let mut leaf = queries.start;
        while leaf < queries.end {
            let start = if after { leaf + 1 } else { run.start };
            let block = &blocks[leaf / WIDTH];
            let mut b = start / WIDTH;
            while b * WIDTH < run.end {
                let mask = simd.overlaps(block, leaf % WIDTH, &others[b]);
                rows.push(leaf, b, mask & lanes(start, run.end, b));
                b += 1;
            }
            leaf += 1;
        }
    }
}

/// Which lanes of block `b` are leaves from `start` to before `end`.
#[inline(always)]
pub fn lanes(start: usize, end: usize, b: usize) -> u32 {
    let before = start.saturating_sub(b * WIDTH).min(WIDTH);
    let until = end.saturating_sub(b * WIDTH).min(WIDTH);
    (0xff << before) & ((1 << until) - 1)
}
