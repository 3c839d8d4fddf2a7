//! The default tree: boxes in Hilbert order, in blocks of eight, in blocks of eight blocks, and so
//! on.
//!
//! Every node is one [`Block`], eight boxes side by side; node `i` of a level has the nodes `8 i ..
//! 8 i + 8` of the level below as children, so there are no pointers, and refitting is one pass
//! over the levels. Level 0, the leaves, is kept elsewhere: every method has it.

use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::broad_phase::marks::{BlockMarks, Marks};
use crate::broad_phase::runs::join;
use crate::simd::{Block, EMPTY, RowSimd, WIDTH, Work, block_of, get_lane, set_lane};
use crate::threads::Threads;
use ccd_core::Aabb;
use std::ops::Range;

/// The levels above the leaves.
#[derive(Debug, Default)]
pub struct BlockBvh {
    /// `upper[0]` is level 1, `upper[height - 2]` one block; those above are kept for their memory.
    upper: Vec<Vec<Block>>,
    height: usize,
    /// What blocks have in common besides their bounds.
    pub marks: BlockMarks,
    /// Per level above the leaves.
    mixed: Vec<Mixed>,
    /// Per level above the leaves: boxes at the first and at the last time that matters.
    ends: Vec<Vec<[Block; 2]>>,
    /// So many levels have them; those above are kept for their memory.
    n_ends: usize,
    /// See [`BlockBvh::gap`].
    gap: Option<f32>,
    looseness_at_build: Option<f64>,
    /// Per block of level 1: side lengths of the boxes in the leaves below it that move and are not
    /// posed, and of its own around them.
    lengths: Vec<[f64; 2]>,
    /// Their sums.
    length: [f64; 2],
    /// Runs of blocks of a level that change, and those behind what moves and is not posed.
    runs: Vec<Range<usize>>,
    rest: Vec<Range<usize>>,
    build: u64,
}

/// The one lane of a level below which boxes that move are followed by fixed ones. Its box may be
/// much larger than what moves below it, and two fixed boxes are no pair: against a lane of fixed
/// boxes what moves counts alone.
#[derive(Clone, Copy, Debug)]
struct Mixed {
    /// The number of the node: its block, then its lane.
    node: usize,
    /// What moves below it, in its lane.
    moving: Block,
}

impl BlockBvh {
    /// The number of the build; each build has its own.
    pub fn build(&self) -> u64 {
        self.build
    }

    /// Number of levels, the leaves included.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Blocks of a level from 1 on. A level above the last is one block with one lane used.
    #[inline(always)]
    pub fn level(&self, level: usize) -> &[Block] {
        &self.upper[level - 1]
    }

    /// If lane and block `i` of a level are those where boxes that move and fixed ones meet: that
    /// lane, and in it what moves.
    #[inline(always)]
    pub fn mixed(&self, level: usize, i: usize) -> Option<(usize, &Block)> {
        let mixed = self.mixed.get(level.wrapping_sub(1))?;
        (mixed.node / WIDTH == i).then_some((mixed.node % WIDTH, &mixed.moving))
    }

    /// How far apart boxes at both ends must be on an axis for what is in them to be apart at all
    /// times that matter; `None`: such boxes are not there.
    pub fn gap(&self) -> Option<f32> {
        self.gap
    }

    /// Boxes at both ends in block `i` of a level from 1 on, but for those that
    /// [`BlockBvh::raise`] adds.
    #[inline(always)]
    pub fn ends(&self, level: usize, i: usize) -> Option<&[Block; 2]> {
        if level <= self.n_ends { Some(&self.ends[level - 1][i]) } else { None }
    }

    /// Forgets the boxes of before; marks those of the new order.
    pub fn begin(&mut self, order: &[u32], marks: &Marks) {
        (self.looseness_at_build, self.length) = (None, [0.0; 2]);
        self.build += 1;
        self.marks.fill(order, marks);
    }

    /// Computes all levels above these leaves, as far as these have changed. Returns how much
    /// looser blocks of boxes that move, and are not posed, have become since the first time after
    /// [`BlockBvh::begin`].
    pub fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        self.gap = None;
        let looseness =
            self.fit_blocks(threads, leaves.blocks(), (leaves.changed(), leaves.n_free()));
        self.mix(leaves.blocks(), leaves.len() - leaves.n_still());
        looseness
    }

    /// Takes boxes of leaves at both ends, of which the blocks `changed` are new. A block that is
    /// not is as it was taken, or has become empty, which leaves the boxes above it larger than
    /// they need to be.
    pub fn take_ends(
        &mut self,
        threads: &Threads,
        leaves: &[[Block; 2]],
        changed: &[Range<usize>],
        gap: f32,
    ) {
        let n_levels = self.height - 1;
        if self.ends.len() < n_levels {
            self.ends.resize_with(n_levels, Vec::new);
        }
        let (mut below, runs) = (leaves, &mut self.runs);
        runs.clear();
        runs.extend_from_slice(changed);
        for here in &mut self.ends[..n_levels] {
            raise_runs(runs);
            here.resize(below.len().div_ceil(WIDTH), [EMPTY; 2]);
            threads.fill_in(here, runs, |i| {
                union_of_ends(&below[i * WIDTH..((i + 1) * WIDTH).min(below.len())])
            });
            below = here;
        }
        (self.gap, self.n_ends) = (Some(gap), n_levels);
    }

    /// Finds the lanes where the first `moving` leaves end.
    fn mix(&mut self, leaves: &[Block], moving: usize) {
        self.mixed.clear();
        if !self.marks.any_fixed() {
            return;
        }
        let (mut node, mut below) = (moving, Aabb::EMPTY);
        for level in 1..self.height {
            let blocks = if level == 1 { leaves } else { &self.upper[level - 2] };
            // Children before the one that is mixed itself.
            let first = node / WIDTH * WIDTH;
            let union =
                |all: Aabb<f32>, child| all.union(&get_lane(&blocks[child / WIDTH], child % WIDTH));
            below = (first..node).fold(below, union);
            node /= WIDTH;
            let mut moving = EMPTY;
            set_lane(&mut moving, node % WIDTH, &below);
            self.mixed.push(Mixed { node, moving });
        }
    }

    /// The same for blocks of which these runs have changed, and looseness counts of the first
    /// `free`.
    fn fit_blocks(
        &mut self,
        threads: &Threads,
        leaves: &[Block],
        (changed, free): (&[Range<usize>], usize),
    ) -> f64 {
        self.height = 1;
        self.runs.clear();
        self.runs.extend_from_slice(changed);
        let mut n_below = leaves.len();
        while n_below > 1 {
            let level = self.height - 1;
            if self.upper.len() == level {
                self.upper.push(Vec::new());
            }
            let (below, here) = self.upper.split_at_mut(level);
            let below = below.last().map_or(leaves, Vec::as_slice);
            n_below = n_below.div_ceil(WIDTH);
            here[0].resize(n_below, EMPTY);
            raise_runs(&mut self.runs);
            let here = &mut here[0][..];
            let children = |i: usize| i * WIDTH..((i + 1) * WIDTH).min(below.len());
            let block = |i: usize| unions(&below[children(i)]);
            if level == 0 {
                self.lengths.resize(n_below, [0.0; 2]);
                // Boxes that move and are not posed come first.
                let n_free = free.div_ceil(WIDTH);
                let runs = self.runs.iter().filter(|run| run.start < n_free);
                let (mut before, mut now, mut n) = ([0.0; 2], [0.0; 2], 0);
                for run in runs.map(|run| run.start..run.end.min(n_free)) {
                    let (here, lengths) = (&mut here[run.clone()], &mut self.lengths[run.clone()]);
                    before = plus(before, sum(lengths));
                    threads.fill_both(here, lengths, |i| {
                        let children = children(run.start + i);
                        let free = free.clamp(children.start, children.end);
                        let of_boxes = below[children.start..free].iter();
                        let of_boxes = of_boxes.map(|boxes| extent(boxes, WIDTH)).sum();
                        let block = block(run.start + i);
                        (block, [of_boxes, extent(&block, free - children.start)])
                    });
                    now = plus(now, sum(lengths));
                    n += run.len();
                }
                let others = plus(self.length, before.map(|length| -length));
                // Of little that is left beside much, rounding has taken the digits.
                let fine = (0..2).all(|k| before[k] <= 1e6 * others[k]);
                let few = n < n_free && fine;
                self.length = if few { plus(others, now) } else { sum(&self.lengths[..n_free]) };
                self.rest.clear();
                let rest = self.runs.iter().map(|run| run.start.max(n_free)..run.end);
                self.rest.extend(rest.filter(|run| !run.is_empty()));
                threads.fill_in(here, &self.rest, block);
            } else {
                threads.fill_in(here, &self.runs, block);
            }
            self.height += 1;
        }
        let looseness = self.looseness();
        let before = *self.looseness_at_build.get_or_insert(looseness);
        if before > 0.0 { looseness / before } else { 1.0 }
    }

    /// Adds levels of one used lane until the tree over these leaves, at least one, is `height`
    /// high, so that two trees can be descended in step.
    pub fn raise(&mut self, height: usize, leaves: &[Block]) {
        while self.height < height {
            let level = self.height - 1;
            let top = if level == 0 { &leaves[0] } else { &self.upper[level - 1][0] };
            let block = block_of([union_of_lanes(top)].into_iter());
            if self.upper.len() == level {
                self.upper.push(Vec::new());
            }
            self.upper[level].clear();
            self.upper[level].push(block);
            self.height += 1;
        }
    }

    /// Sum of the side lengths of all blocks of eight, relative to that of the boxes in them: what
    /// a block costs its tests. Of those that move and are not posed.
    fn looseness(&self) -> f64 {
        let [boxes, blocks] = self.length;
        if self.height >= 2 && boxes > 0.0 { blocks / boxes } else { 1.0 }
    }
}

/// Turns runs of blocks into those of the blocks above them.
fn raise_runs(runs: &mut Vec<Range<usize>>) {
    runs.iter_mut().for_each(|run| *run = run.start / WIDTH..run.end.div_ceil(WIDTH));
    join(runs);
}

fn sum(lengths: &[[f64; 2]]) -> [f64; 2] {
    lengths.iter().fold([0.0; 2], |all, of| plus(all, *of))
}

fn plus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// Sum of the side lengths of the first `n` boxes of a block.
pub fn extent(block: &Block, n: usize) -> f64 {
    // Of an empty box less than 0.
    let side = |k: usize, j: usize| {
        let side = block.max[k].0[j] as f64 - block.min[k].0[j] as f64;
        if side > 0.0 { side } else { 0.0 }
    };
    (0..n).map(|j| side(0, j) + side(1, j) + side(2, j)).sum()
}

/// The boxes of up to eight blocks at both ends, each block one lane.
pub fn union_of_ends(children: &[[Block; 2]]) -> [Block; 2] {
    [0, 1].map(|end| block_of(children.iter().map(|ends| union_of_lanes(&ends[end]))))
}

/// The boxes of up to eight blocks, each block one lane.
fn unions(children: &[Block]) -> Block {
    match children.try_into() {
        Ok(children) => crate::simd::run_rows!(Unions { children }),
        Err(_) => block_of(children.iter().map(union_of_lanes)),
    }
}

/// The boxes of eight blocks.
struct Unions<'a> {
    children: &'a [Block; WIDTH],
}

impl<S: RowSimd> Work<S> for Unions<'_> {
    type Out = Block;

    #[inline(always)]
    fn call(self, simd: S) -> Block {
        let boxes = self.children;
        let min = |k: usize| simd.store(simd.least_of_each(boxes.each_ref().map(|b| &b.min[k])));
        let max = |k: usize| simd.store(simd.greatest_of_each(boxes.each_ref().map(|b| &b.max[k])));
        Block { min: [min(0), min(1), min(2)], max: [max(0), max(1), max(2)] }
    }
}

fn union_of_lanes(block: &Block) -> Aabb<f32> {
    let mut out = Aabb::EMPTY;
    for k in 0..3 {
        for j in 0..WIDTH {
            out.min[k] = out.min[k].min(block.min[k].0[j]);
            out.max[k] = out.max[k].max(block.max[k].0[j]);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::block_pairs::BlockSource;
    use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
    use crate::broad_phase::tests::random;

    fn check_well_formed(bvh: &BlockBvh, leaves: &LeafBoxes, boxes: &[Aabb<f32>]) {
        let mut seen: Vec<u32> = leaves.order().to_vec();
        seen.sort_unstable();
        assert!(seen.iter().copied().eq(0..boxes.len() as u32), "order is no permutation");
        for (leaf, &id) in leaves.order().iter().enumerate() {
            let b = &boxes[id as usize];
            assert_eq!(leaves.get(leaf), *b, "leaf {leaf}");
            let mut at = leaf;
            for level in 0..bvh.height {
                let blocks = if level == 0 { leaves.blocks() } else { bvh.level(level) };
                let (block, j) = (&blocks[at / WIDTH], at % WIDTH);
                for k in 0..3 {
                    assert!(
                        block.min[k].0[j] <= b.min[k] && block.max[k].0[j] >= b.max[k],
                        "leaf {leaf}, axis {k}"
                    );
                }
                at /= WIDTH;
            }
            assert_eq!(at, 0);
        }
    }

    #[test]
    fn every_ancestor_holds_every_box() {
        let threads = Threads::new(1).unwrap();
        let mut source = BlockSource::default();
        let mut leaves = LeafBoxes::new(Set { index: 0, searched: true });
        for n in [0usize, 1, 7, 8, 9, 64, 65, 1000, 20_000] {
            let mut unit = random(n as u32);
            let mut boxes: Vec<_> =
                (0..n).map(|_| Aabb::of_point([unit(), unit(), unit()])).collect();
            leaves.build(&threads, &mut source, &boxes, Marks::default());
            check_well_formed(&source.trees[0], &leaves, &boxes);
            for b in &mut boxes {
                b.max[1] += unit();
            }
            let looseness = leaves.refit(&threads, &mut source, &boxes);
            assert!(looseness.is_finite() && looseness > 0.0, "{looseness}");
            check_well_formed(&source.trees[0], &leaves, &boxes);
        }
    }

    #[test]
    fn fixed_lanes_are_those_of_the_last_build() {
        let threads = Threads::new(1).unwrap();
        let order: Vec<u32> = (0..4096).collect();
        let blocks = vec![EMPTY; order.len() / WIDTH];
        let (all, none) = (|_: usize| true, |_: usize| false);
        let of = |fixed| Marks { fixed: Some(fixed), ..Marks::default() };
        let mut bvh = BlockBvh::default();
        bvh.begin(&order, &of(&all));
        let first = |n: usize| [Range { start: 0, end: n }];
        bvh.fit_blocks(&threads, &blocks, (&first(blocks.len()), blocks.len()));
        let height = bvh.height();
        let any = |bvh: &BlockBvh| (0..height).any(|level| bvh.marks.fixed(level, 0) != 0);
        assert!((0..height).all(|level| bvh.marks.fixed(level, 0) == 0xff), "all boxes are fixed");
        // Fewer boxes and fewer levels, then as many levels as before.
        bvh.begin(&order[..WIDTH], &of(&none));
        bvh.fit_blocks(&threads, &blocks[..1], (&first(1), 1));
        bvh.raise(height, &blocks[..1]);
        assert_eq!(bvh.height(), height);
        assert!(!any(&bvh), "lanes of an earlier build");
        bvh.begin(&order, &of(&all));
        bvh.begin(&order, &Marks::default());
        assert!(!any(&bvh), "lanes of an earlier build that had fixed boxes");
    }
}
