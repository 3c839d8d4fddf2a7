//! Boxes of leaves at the start and at the end: where features are then, which may be apart though
//! the boxes of all that is between overlap.
//!
//! They are made when a search is to look at them, of the leaves that changed since they were made
//! last; and only where features move far for their size, since else boxes at both ends are apart
//! where those of the step are.

use crate::broad_phase::block_bvh::{extent, union_of_ends};
use crate::broad_phase::leaf_boxes::{LeafBoxes, Order};
use crate::broad_phase::runs::add_runs;
use crate::simd::{Block, EMPTY, RowSimd, WIDTH, Work, block_of, get_lane};
use crate::threads::Threads;
use ccd_core::Num;
use std::ops::Range;
use std::slice;

/// The boxes at both ends of one set, in blocks, of the positions in the table.
#[derive(Debug, Default)]
pub struct LeafEnds {
    blocks: Vec<[Block; 2]>,
    /// Whether they were made, but for those of runs of blocks that changed since.
    made: bool,
    stale: Vec<Range<usize>>,
    /// Whether the method has taken them, but for those of such runs.
    taken: bool,
    untaken: Vec<Range<usize>>,
    /// What a call makes.
    parts: Vec<Range<usize>>,
}

impl LeafEnds {
    /// Those of block `i`.
    #[inline(always)]
    pub fn of(&self, i: usize) -> &[Block; 2] {
        &self.blocks[i]
    }

    /// None of them hold.
    pub fn forget(&mut self) {
        (self.made, self.taken) = (false, false);
        self.stale.clear();
        self.untaken.clear();
    }

    /// Leaves have changed: those of `boxes`, or, unless the others hold, all.
    pub fn change(&mut self, boxes: &LeafBoxes, holds: bool) {
        if !holds {
            return self.forget();
        }
        if self.made {
            add_runs(&mut self.stale, boxes.changed());
        }
        if self.taken {
            add_runs(&mut self.untaken, boxes.changed());
        }
    }

    /// Makes them, from the table of positions and the vertices of the features, of which there is
    /// a block for each of boxes. Of what is posed those are made that have boxes.
    pub fn make<const N: usize>(
        &mut self,
        threads: &Threads,
        boxes: &LeafBoxes,
        vertices: &[[[u32; WIDTH]; N]],
        table: &[[f32; WIDTH]],
    ) {
        let Self { blocks, made, stale, parts, .. } = self;
        threads.resize(blocks, vertices.len(), || [EMPTY; 2]);
        let all = 0..vertices.len();
        let runs = if *made { &stale[..] } else { slice::from_ref(&all) };
        let (free, moving) = (boxes.n_free(), boxes.n_moving());
        let cut = |to: Range<usize>| {
            let runs = runs.iter().map(move |run| run.start.max(to.start)..run.end.min(to.end));
            runs.filter(|run| !run.is_empty())
        };
        cut(free..moving).for_each(|run| blocks[run].fill([EMPTY; 2]));
        parts.clear();
        parts.extend(cut(0..free).chain(cut(moving..all.end)));
        parts.extend(boxes.filled().iter().flat_map(|run| cut(run.clone())));
        parts.sort_unstable_by_key(|run| run.start);
        threads.chunks_in(blocks, parts, &|first, out| {
            place(table, &vertices[first..first + out.len()], out);
        });
        *made = true;
        stale.clear();
    }

    /// Has the method leave out pairs that an axis keeps further than `gap` apart at both ends.
    pub fn hand_on(
        &mut self,
        threads: &Threads,
        order: &mut dyn Order,
        boxes: &LeafBoxes,
        gap: f32,
    ) {
        let Self { blocks, taken, untaken, .. } = self;
        let all = 0..blocks.len();
        let changed = if *taken { &untaken[..] } else { slice::from_ref(&all) };
        if order.take_ends(threads, boxes, blocks, changed, gap) {
            *taken = true;
            untaken.clear();
        }
    }
}

/// Lengths of boxes around both ends, and of those at the start, of a sample of what changed and
/// may move: of boxes around blocks of eight.
pub fn lengths<const N: usize>(
    boxes: &LeafBoxes,
    vertices: &[[[u32; WIDTH]; N]],
    table: &[[f32; WIDTH]],
) -> [f64; 2] {
    let moving = boxes.n_moving();
    let runs = boxes.changed().iter().filter(|run| run.start < moving);
    let runs = runs.map(|run| run.start..run.end.min(moving));
    let n: usize = runs.clone().map(|run| run.len()).sum();
    let parts = runs.flat_map(|run| vertices[run].chunks(WIDTH));
    let mut lengths = [0.0; 2];
    for part in parts.step_by((n / WIDTH / SAMPLES).max(1)) {
        let mut ends_of_part = [[EMPTY; 2]; WIDTH];
        place(table, part, &mut ends_of_part[..part.len()]);
        let [start, end] = union_of_ends(&ends_of_part[..part.len()]);
        let both = |j: usize| get_lane(&start, j).union(&get_lane(&end, j));
        lengths[0] += extent(&block_of((0..WIDTH).map(both)), WIDTH);
        lengths[1] += extent(&start, WIDTH);
    }
    lengths
}

/// About so many blocks of eight blocks are measured, by one thread.
const SAMPLES: usize = 16;

/// The boxes of eight features at both ends, from the table of positions.
pub fn ends<const N: usize>(table: &[[f32; WIDTH]], vertices: &[[u32; WIDTH]; N]) -> [Block; 2] {
    let mut out = [[EMPTY; 2]];
    place(table, slice::from_ref(vertices), &mut out);
    out[0]
}

fn place<const N: usize>(
    table: &[[f32; WIDTH]],
    vertices: &[[[u32; WIDTH]; N]],
    out: &mut [[Block; 2]],
) {
    crate::simd::run_rows!(Place { table, vertices, out })
}

/// The boxes of eight features at both ends, block by block, written where they belong.
struct Place<'a, const N: usize> {
    table: &'a [[f32; WIDTH]],
    vertices: &'a [[[u32; WIDTH]; N]],
    out: &'a mut [[Block; 2]],
}

impl<S: RowSimd, const N: usize> Work<S> for Place<'_, N> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        for (vertices, out) in self.vertices.iter().zip(self.out) {
            *out = ends_of(simd, self.table, vertices);
        }
    }
}

#[inline(always)]
fn ends_of<S: RowSimd, const N: usize>(
    simd: S,
    table: &[[f32; WIDTH]],
    vertices: &[[u32; WIDTH]; N],
) -> [Block; 2] {
    let first = simd.gather(table, &vertices[0]);
    let (mut min, mut max) = (first, first);
    for ids in &vertices[1..] {
        let next = simd.gather(table, ids);
        for k in 0..WIDTH {
            min[k] = min[k].min(next[k]);
            max[k] = max[k].max(next[k]);
        }
    }
    [block(simd, &min, &max, 0), block(simd, &min, &max, 4)]
}

/// The boxes whose bounds begin at component `k`.
#[inline(always)]
fn block<S: RowSimd>(simd: S, min: &[S::Lanes; WIDTH], max: &[S::Lanes; WIDTH], k: usize) -> Block {
    Block {
        min: [simd.store(min[k]), simd.store(min[k + 1]), simd.store(min[k + 2])],
        max: [simd.store(max[k]), simd.store(max[k + 1]), simd.store(max[k + 2])],
    }
}
