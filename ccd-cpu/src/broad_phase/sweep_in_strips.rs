//! Sweep and prune in strips: boxes sorted by strip, and within a strip by where they begin along
//! the axis of largest variance, each in every strip that it touches [Liu 2010].
//!
//! Twin: none; a GPU has no sweep in strips.
//!
//! The rule, a drawing and the cost are beside it in the core
//! ([`ccd_core::backend::broad_phase::sweep_in_strips`]). A box has as many leaves as strips; a
//! task is a run of leaves, those of one block and one strip go forward together. Which leaves
//! begin in their strip is a bit a leaf, eight side by side as boxes are, so that the rule is two
//! operations on the mask of a row.

use crate::broad_phase::leaf_boxes::{LeafBoxes, Order, Set, Sides};
use crate::broad_phase::marks::Marks;
use crate::broad_phase::rows::{RowSource, Rows, Scratch};
use crate::broad_phase::sweep_and_prune::{Role, emit, moments};
use crate::broad_phase::uniform_grid::lanes;
use crate::simd::{Block, Mask, RowSimd, WIDTH, Work};
use crate::sort::RadixSort;
use crate::threads::Threads;
use ccd_core::backend::broad_phase::sweep_and_prune::{Moments, begin_key, finds, is_past};
use ccd_core::backend::broad_phase::sweep_in_strips::{self as strips, MOST, Strips};
use ccd_core::{Aabb, Error, Num};
use std::ops::Range;
use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Leaves a task.
const TASK: usize = 512;
/// Boxes that one thread takes together.
const CHUNK: usize = 4096;
/// Width of a strip in mean sides: narrower ones hold fewer boxes, but more of them twice.
const WIDTH_IN_SIDES: f64 = 4.0;
/// Least boxes a strip, in the mean.
const LEAST_BOXES: f64 = 128.0;
/// Most leaves a box, in the mean.
const MOST_LEAVES: f64 = 1.5;

/// The strips, and buffers of the sort.
#[derive(Debug, Default)]
pub struct SweepInStrips {
    axis: usize,
    strips: Strips,
    /// Numbers of strips are less than this.
    n_numbers: u32,
    /// Per set.
    kept: Vec<Kept>,
    moments: Vec<Moments<f64>>,
    sizes: Vec<Sizes>,
    /// Leaves of the boxes before each chunk.
    offsets: Vec<u64>,
    /// Id and strip of every leaf before the sort. Atomic, because threads write disjoint places
    /// that no slice could express.
    ids: Vec<AtomicU32>,
    numbers: Vec<AtomicU32>,
    sorted: Vec<u32>,
    radix: RadixSort,
}

/// What a set has besides its leaves.
#[derive(Debug, Default)]
struct Kept {
    /// The first leaf of each strip, and the number of leaves.
    starts: Vec<u32>,
    /// Per block and axis: the leaves that begin in their strip.
    begins: Vec<[u8; 2]>,
}

/// Bounds of boxes, and the sum of their sides along each axis.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    scene: Aabb<f32>,
    sides: [f64; 3],
}

impl Sizes {
    const NONE: Self = Self { scene: Aabb::EMPTY, sides: [0.0; 3] };

    fn merged(&self, other: &Self) -> Self {
        let sides = std::array::from_fn(|k| self.sides[k] + other.sides[k]);
        Self { scene: self.scene.union(&other.scene), sides }
    }

    fn of(boxes: &[Aabb<f32>]) -> Self {
        let mut out = Self::NONE;
        for b in boxes {
            out.scene = out.scene.union(b);
            for k in 0..3 {
                out.sides[k] += b.max[k] as f64 - b.min[k] as f64;
            }
        }
        out
    }
}

impl SweepInStrips {
    /// How many leaves these boxes have; fills in how many come before each chunk.
    fn count(&mut self, threads: &Threads, boxes: &[Aabb<f32>]) -> u64 {
        let grid = &self.strips;
        // From the strip of its lower to that of its upper corner.
        let n = |b: &Aabb<f32>| {
            let [first, last] = [b.min, b.max].map(|corner| grid.cell(corner));
            ((last[0] - first[0] + 1) * (last[1] - first[1] + 1)) as u64
        };
        self.offsets.resize(boxes.len().div_ceil(CHUNK), 0);
        threads.each(&mut self.offsets, &|i, offset| {
            *offset = chunk(boxes, i).iter().map(n).sum();
        });
        let mut sum = 0;
        for offset in &mut self.offsets {
            let here = std::mem::replace(offset, sum);
            sum += here;
        }
        sum
    }

    /// Lists id and strip of every leaf, box by box; returns how many there are.
    fn list(&mut self, threads: &Threads, boxes: &[Aabb<f32>]) -> usize {
        let n = self.count(threads, boxes) as usize;
        self.ids.resize_with(n, AtomicU32::default);
        self.numbers.resize_with(n, AtomicU32::default);
        let Self { strips: grid, offsets, ids, numbers, .. } = self;
        threads.each(offsets, &|i, offset| {
            let mut at = *offset as usize;
            for (id, b) in chunk(boxes, i).iter().enumerate() {
                let (first, last) = (grid.cell(b.min), grid.cell(b.max));
                for y in first[1]..=last[1] {
                    for x in first[0]..=last[0] {
                        ids[at].store((i * CHUNK + id) as u32, Relaxed);
                        numbers[at].store(strips::key([x, y]), Relaxed);
                        at += 1;
                    }
                }
            }
        });
        n
    }
}

/// Part `i` of the boxes.
fn chunk(boxes: &[Aabb<f32>], i: usize) -> &[Aabb<f32>] {
    &boxes[i * CHUNK..((i + 1) * CHUNK).min(boxes.len())]
}

impl Order for SweepInStrips {
    fn survey(&mut self, threads: &Threads, sets: &[&[Aabb<f32>]]) -> Result<(), Error> {
        let n: usize = sets.iter().map(|boxes| boxes.len()).sum();
        let Sizes { scene, sides } =
            threads.fold(sets, Sizes::NONE, &mut self.sizes, &Sizes::of, &Sizes::merged);
        let [axis, across @ ..] = moments(threads, sets, &mut self.moments).axes();
        self.axis = axis;
        let most = (n as f64 / LEAST_BOXES).sqrt().clamp(1.0, MOST as f64);
        let mut wanted = across.map(|k| {
            let extent = scene.max[k] as f64 - scene.min[k] as f64;
            let width = WIDTH_IN_SIDES * sides[k] / n as f64;
            // Boxes in a plane are in one strip; the width of points is 0.
            if extent > 0.0 { (extent / width).clamp(1.0, most) as u32 } else { 1 }
        });
        loop {
            self.strips = Strips::new(&scene, across, wanted);
            let leaves: u64 = sets.iter().map(|boxes| self.count(threads, boxes)).sum();
            // One strip has a leaf a box.
            if leaves as f64 <= MOST_LEAVES * n as f64 {
                self.n_numbers = wanted[1] << strips::BITS;
                return Ok(());
            }
            wanted = wanted.map(|strips| (strips * 3 / 4).max(1));
        }
    }

    /// Moved boxes are in other strips.
    fn outlasts_motion(&self) -> bool {
        false
    }

    fn sort(
        &mut self,
        threads: &Threads,
        set: Set,
        boxes: &[Aabb<f32>],
        _marks: &Marks,
        order: &mut Vec<u32>,
    ) {
        let n = self.list(threads, boxes);
        if self.kept.len() <= set.index {
            self.kept.resize_with(set.index + 1, Kept::default);
        }
        let Self { axis, n_numbers, kept, ids, numbers, sorted, radix, .. } = self;
        let number = |leaf: u32| numbers[leaf as usize].load(Relaxed);
        let id = |leaf: u32| ids[leaf as usize].load(Relaxed);
        // In the upper bits, which the sort takes digit by digit: 12 for the strip, 21 of the
        // place; by the other 11, boxes that are equal so far are compared.
        let key = |leaf: usize| {
            let begin = begin_key(&boxes[id(leaf as u32) as usize], *axis);
            (number(leaf as u32) as u64) << 51 | (begin as u64) << 19
        };
        radix.sort(threads, n, key, sorted);
        let starts = &mut kept[set.index].starts;
        starts.resize(*n_numbers as usize + 1, 0);
        threads.fill(starts, |strip| {
            sorted.partition_point(|&leaf| number(leaf) < strip as u32) as u32
        });
        order.resize(n, 0);
        threads.fill(order, |i| id(sorted[i]));
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        let Kept { starts, begins } = &mut self.kept[leaves.set().index];
        let grid = &self.strips;
        begins.resize(leaves.blocks().len(), [0; 2]);
        threads.fill(begins, |i| {
            let mut out = [0; 2];
            let mut strip = strip_of(starts, i * WIDTH);
            for leaf in i * WIDTH..((i + 1) * WIDTH).min(leaves.len()) {
                while starts[strip + 1] as usize <= leaf {
                    strip += 1;
                }
                let first = grid.cell(leaves.get(leaf).min);
                let bits = strips::begins(first, strips::cell_of(strip as u32));
                out[0] |= ((bits & 1) as u8) << (leaf % WIDTH);
                out[1] |= ((bits >> 1) as u8) << (leaf % WIDTH);
            }
            out
        });
        1.0
    }
}

/// The strip of a leaf.
fn strip_of(starts: &[u32], leaf: usize) -> usize {
    starts.partition_point(|&start| start as usize <= leaf) - 1
}

impl RowSource for SweepInStrips {
    /// A task is a run of leaves of one set; of two sets, those of the first come first.
    fn begin(&mut self, _threads: &Threads, (a, b): Sides) -> usize {
        a.len().div_ceil(TASK) + b.map_or(0, |b| b.len().div_ceil(TASK))
    }

    fn task(&self, k: usize, (a, b): Sides, _scratch: &mut Scratch, rows: &mut Rows) {
        let n_first = a.len().div_ceil(TASK);
        let (role, leaves, others, k) = match b {
            None => (Role::Only, a, a, k),
            Some(b) if k < n_first => (Role::First, a, b, k),
            Some(b) => (Role::Second, b, a, k - n_first),
        };
        let (kept, theirs) = (&self.kept[leaves.set().index], &self.kept[others.set().index]);
        let end = ((k + 1) * TASK).min(leaves.len());
        let mut strip = strip_of(&kept.starts, k * TASK);
        let mut leaf = k * TASK;
        while leaf < end {
            while kept.starts[strip + 1] as usize <= leaf {
                strip += 1;
            }
            let until =
                (leaf / WIDTH * WIDTH + WIDTH).min(kept.starts[strip + 1] as usize).min(end);
            let run = theirs.starts[strip] as usize..theirs.starts[strip + 1] as usize;
            if !run.is_empty() {
                let queries = leaf..until;
                let axis = self.axis;
                let sweep = Sweep { axis, role, leaves, kept, queries, others, theirs, run };
                crate::simd::run_rows!(Forward { sweep, rows });
            }
            leaf = until;
        }
    }
}

/// Leaves of one block and one strip, and those of the same strip that they are compared with.
struct Sweep<'a> {
    axis: usize,
    role: Role,
    leaves: &'a LeafBoxes,
    kept: &'a Kept,
    queries: Range<usize>,
    others: &'a LeafBoxes,
    theirs: &'a Kept,
    run: Range<usize>,
}

impl Sweep<'_> {
    /// The first leaf of the others that may begin inside these.
    fn start(&self) -> usize {
        let Self { axis, queries, others, run, .. } = self;
        if self.role == Role::Only {
            return queries.start;
        }
        let begin = |leaves: &LeafBoxes, leaf| {
            let block: &Block = &leaves.blocks()[leaf / WIDTH];
            block.min[*axis].0[leaf % WIDTH]
        };
        let first = begin(self.leaves, queries.start);
        let (mut start, mut n) = (run.start, run.len());
        while n > 0 {
            let half = n / 2;
            if begin(others, start + half) < first {
                start += half + 1;
                n -= half + 1;
            } else {
                n = half;
            }
        }
        start
    }
}

/// They go forward together, eight others a step, until all are past.
struct Forward<'a, 'b> {
    sweep: Sweep<'a>,
    rows: &'a mut Rows<'b>,
}

impl<S: RowSimd> Work<S> for Forward<'_, '_> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let Self { sweep, rows } = self;
        let (axis, role, a) = (sweep.axis, sweep.role, sweep.queries.start / WIDTH);
        let (block, kept) = (&sweep.leaves.blocks()[a], sweep.kept.begins[a]);
        let (ends, begins) = (simd.load(&block.max[axis]), &block.min[axis].0);
        let queries = lanes(sweep.queries.start, sweep.queries.end, a);
        let start = sweep.start();
        let mut b = start / WIDTH;
        while b * WIDTH < sweep.run.end {
            let other = &sweep.others.blocks()[b];
            let mut active = queries;
            // In the first block there may be leaves of another strip before.
            if b * WIDTH >= start {
                active &= !is_past(ends, S::Lanes::splat(other.min[axis].0[0])).bits();
                if active == 0 {
                    break;
                }
            }
            let here = lanes(start, sweep.run.end, b);
            let theirs = sweep.theirs.begins[b];
            while active != 0 {
                let lane = active.trailing_zeros() as usize;
                active &= active - 1;
                let mut mask = simd.overlaps(block, lane, other) & here;
                if mask == 0 {
                    continue;
                }
                if role != Role::Only {
                    let (begin, other) =
                        (S::Lanes::splat(begins[lane]), simd.load(&other.min[axis]));
                    mask &= finds(begin, other, role == Role::First);
                } else if b == a {
                    mask &= !0 << (lane + 1);
                }
                // Along each axis across, one of both begins in this strip.
                mask &= if kept[0] >> lane & 1 == 1 { 0xff } else { theirs[0] as u32 };
                mask &= if kept[1] >> lane & 1 == 1 { 0xff } else { theirs[1] as u32 };
                emit(role, a, lane, b, mask, rows);
            }
            b += 1;
        }
    }
}
