//! Uniform grid: boxes sorted by the cell of their centre, each compared with those in the cells
//! around its own [Karras 2012a]; for boxes of unequal sizes several grids over each other.
//!
//! Twin: on a GPU `key_intervals.rs`, by the keys of this method.
//!
//! The rule, its proof, a drawing and the cost are beside it in the core
//! ([`ccd_core::backend::broad_phase::uniform_grid`], and for several grids
//! [`ccd_core::backend::broad_phase::grid_levels`]). Here there is no table of cells, neither by
//! number nor by hash: cells are visited in the order of the sort, and so are the rows of cells
//! around them, so that where each row begins and ends in the sorted boxes only moves on. Rows of
//! another grid are found by bisection. Boxes of a cell are compared with a row eight at a time.

use crate::broad_phase::leaf_boxes::{LeafBoxes, Order, Set, Sides};
use crate::broad_phase::marks::Marks;
use crate::broad_phase::rows::{RowSource, Rows, Scratch};
use crate::simd::{Block, RowSimd, WIDTH, Work};
use crate::sort::RadixSort;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::grid_levels::{BITS, Grids, LEVELS};
use ccd_core::backend::broad_phase::uniform_grid::{self as cells, OWN_ROW, ROWS, Sizes};
use ccd_core::{Aabb, Error};
use std::ops::Range;

/// Leaves a task.
const TASK: usize = 512;
/// Leaves a row of cells up to which all of a level are compared, rather than each row found.
const LEAVES_A_ROW: usize = 64;
/// Bits of a cell's number; above them a key has the level.
const CELL_BITS: u32 = 3 * BITS;
/// A sort takes keys of 63 bits from above.
const UNUSED_BITS: u32 = 63 - CELL_BITS - (usize::BITS - LEVELS.leading_zeros());

/// A grid of cells.
type Cells = cells::UniformGrid<BITS>;

/// The grids, and the cell of every leaf.
#[derive(Debug, Default)]
pub struct UniformGrid {
    levels: Grids,
    sets: Vec<Keys>,
    sizes: Vec<Sizes>,
    radix: RadixSort,
}

/// Levels and cells of the leaves of a set.
#[derive(Debug, Default)]
struct Keys {
    /// Ascending.
    keys: Vec<u64>,
    /// Leaves before each level.
    before: [usize; LEVELS + 1],
}

impl Keys {
    fn of_level(&self, level: usize) -> Range<usize> {
        self.before[level]..self.before[level + 1]
    }

    /// The leaves of a range with keys from `first` to `last`.
    fn between(&self, leaves: &Range<usize>, first: u64, last: u64) -> Range<usize> {
        let keys = &self.keys[leaves.clone()];
        let start = keys.partition_point(|&key| key < first);
        let len = keys[start..].partition_point(|&key| key <= last);
        leaves.start + start..leaves.start + start + len
    }

    /// Runs of leaves of a level that hold all with cells from `from` to `to`, and no leaf twice.
    fn runs(&self, level: usize, [from, to]: [[u32; 3]; 2], mut run: impl FnMut(Range<usize>)) {
        let all = self.of_level(level);
        let n_rows = |k: usize| (to[k] - from[k] + 1) as usize;
        if all.len() <= LEAVES_A_ROW * n_rows(1) * n_rows(2) {
            return run(all);
        }
        for z in from[2]..=to[2] {
            let layer =
                [[0, 0, z], [Cells::CELLS - 1, Cells::CELLS - 1, z]].map(|cell| key(level, cell));
            let layer = self.between(&all, layer[0], layer[1]);
            if layer.len() <= LEAVES_A_ROW * n_rows(1) {
                run(layer);
                continue;
            }
            for y in from[1]..=to[1] {
                run(self.between(&layer, key(level, [from[0], y, z]), key(level, [to[0], y, z])));
            }
        }
    }
}

/// The number of a level and a cell, by which boxes are sorted.
#[inline(always)]
fn key(level: usize, cell: [u32; 3]) -> u64 {
    (level as u64) << CELL_BITS | Cells::key(cell) as u64
}

impl UniformGrid {
    #[inline(always)]
    fn key(&self, b: &Aabb<f32>) -> u64 {
        let (level, cell) = self.levels.cell(b);
        key(level, cell)
    }
}

impl Order for UniformGrid {
    /// Cells of the coarsest grid as large as the largest box of all sets.
    fn survey(&mut self, threads: &Threads, sets: &[&[Aabb<f32>]]) -> Result<(), Error> {
        let part = |boxes: &[Aabb<f32>]| {
            boxes.iter().fold(Sizes::NONE, |all, b| all.merged(&Sizes::of(b)))
        };
        let sizes = threads.fold(sets, Sizes::NONE, &mut self.sizes, &part, &Sizes::merged);
        self.levels = Grids::new(&sizes);
        Ok(())
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
        let Self { levels, radix, .. } = self;
        let key = |i: usize| {
            let (level, cell) = levels.cell(&boxes[i]);
            key(level, cell) << UNUSED_BITS
        };
        radix.sort(threads, boxes.len(), key, order);
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        let set = leaves.set().index;
        if self.sets.len() <= set {
            self.sets.resize_with(set + 1, Keys::default);
        }
        let mut of_set = std::mem::take(&mut self.sets[set]);
        of_set.keys.resize(leaves.len(), 0);
        threads.fill(&mut of_set.keys, |leaf| self.key(&leaves.get(leaf)));
        let keys = &of_set.keys;
        of_set.before = std::array::from_fn(|level| {
            keys.partition_point(|&key| (key >> CELL_BITS) < level as u64)
        });
        self.sets[set] = of_set;
        1.0
    }
}

impl RowSource for UniformGrid {
    fn begin(&mut self, _threads: &Threads, (a, _): Sides) -> usize {
        a.len().div_ceil(TASK)
    }

    fn task(&self, k: usize, (a, b): Sides, _scratch: &mut Scratch, rows: &mut Rows) {
        let (own, other) = (&self.sets[a.set().index].keys, b.unwrap_or(a));
        let of_other = &self.sets[other.set().index];
        let keys = &of_other.keys;
        let end = ((k + 1) * TASK).min(a.len());
        let forward = b.is_none();
        let first_row = if forward { OWN_ROW } else { 0 };
        let mut cursors: [Option<Range<usize>>; ROWS as usize] = Default::default();
        let mut leaf = k * TASK;
        while leaf < end {
            let cell = own[leaf];
            let n = own[leaf..end].iter().take_while(|&&key| key == cell).count();
            let level = cell >> CELL_BITS;
            for row in first_row..ROWS {
                let own_cell = (cell & ((1 << CELL_BITS) - 1)) as u32;
                let around = Cells::row(Cells::cell_of(own_cell), row, forward);
                let [first, last] = around.map(|cell| level << CELL_BITS | cell as u64);
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
            let level = level as usize;
            let first_level = if forward { level + 1 } else { 0 };
            let is_other = |l: &usize| *l != level && !of_other.of_level(*l).is_empty();
            for other_level in (first_level..self.levels.len()).filter(is_other) {
                for query in leaf..leaf + n {
                    let reach = self.levels.reach(other_level, &a.get(query));
                    of_other.runs(other_level, reach, |run| {
                        let (blocks, others, queries) =
                            (a.blocks(), other.blocks(), query..query + 1);
                        let compare = Compare { blocks, queries, others, run, after: false, rows };
                        crate::simd::run_rows!(compare);
                    });
                }
            }
            leaf += n;
        }
    }
}

/// Moves a run on to the leaves with the cells `first ..= last`; both only go up.
#[inline(always)]
fn advance(run: &mut Range<usize>, keys: &[u64], first: u64, last: u64) {
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
