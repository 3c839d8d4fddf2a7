//! Block bvhs as a source of pairs: two of them, or one with itself, are descended at once, block
//! against block, eight boxes a test.

use crate::broad_phase::block_bvh::BlockBvh;
use crate::broad_phase::leaf_boxes::{LeafBoxes, Set};
use crate::broad_phase::morton_order::MortonOrder;
use crate::broad_phase::pair_source::{Fixed, Order, PairSink, PairSource, Sides};
use crate::broad_phase::pair_tree::PairTree;
use crate::broad_phase::scheduler::Scheduler;
use crate::simd::{Block, RowSimd, WIDTH};
use crate::threads::Threads;
use ccd_core::Aabb;

/// A block bvh per set.
#[derive(Debug, Default)]
pub struct BlockSource {
    trees: Vec<BlockBvh>,
    morton: MortonOrder,
    scheduler: Scheduler<BlockPair>,
}

/// Two blocks of the same level whose boxes are to be tested against each other; level 0 holds the
/// leaves.
#[derive(Clone, Copy, Debug, Default)]
pub struct BlockPair {
    level: u32,
    a: u32,
    b: u32,
}

#[cfg(test)]
impl BlockSource {
    /// The tree over a set.
    pub fn tree(&self, set: usize) -> &BlockBvh {
        &self.trees[set]
    }
}

impl Order for BlockSource {
    fn sort(
        &mut self,
        threads: &Threads,
        set: Set,
        boxes: &[Aabb<f32>],
        fixed: Option<Fixed>,
        order: &mut Vec<u32>,
    ) {
        if self.trees.len() <= set.index {
            self.trees.resize_with(set.index + 1, BlockBvh::default);
        }
        // What is fixed comes last, so that whole blocks are.
        self.morton.sort(threads, boxes, fixed, order);
        self.trees[set.index].begin(order, fixed);
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        self.trees[leaves.set().index].fit(threads, leaves.blocks())
    }
}

impl PairSource for BlockSource {
    fn order(&mut self) -> &mut dyn Order {
        self
    }

    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        (a, b): Sides,
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    ) {
        if a.is_empty() || b.is_some_and(LeafBoxes::is_empty) {
            return;
        }
        let Self { trees, scheduler, .. } = self;
        if let Some(b) = b {
            let height = trees[a.set().index].height().max(trees[b.set().index].height());
            trees[a.set().index].raise(height, a.blocks());
            trees[b.set().index].raise(height, b.blocks());
        }
        let side = |of: &'_ LeafBoxes| &trees[of.set().index];
        let (tree_a, tree_b) = (side(a), side(b.unwrap_or(a)));
        let leaves = (a.blocks(), b.unwrap_or(a).blocks());
        let pairs = BlockPairs {
            a: tree_a,
            b: tree_b,
            leaves_a: leaves.0,
            leaves_b: leaves.1,
            within: b.is_none(),
        };
        scheduler.run(threads, pairs, part, sink, workers);
    }
}

/// The trees that are descended, equal if pairs are sought `within` one.
#[derive(Clone, Copy)]
struct BlockPairs<'a> {
    a: &'a BlockBvh,
    b: &'a BlockBvh,
    leaves_a: &'a [Block],
    leaves_b: &'a [Block],
    within: bool,
}

impl PairTree for BlockPairs<'_> {
    type Pair = BlockPair;

    fn roots(self, out: &mut Vec<BlockPair>) {
        assert_eq!(self.a.height(), self.b.height(), "trees of different height");
        out.push(BlockPair { level: self.a.height() as u32 - 1, a: 0, b: 0 });
    }

    #[inline(always)]
    fn is_leaf(self, pair: BlockPair) -> bool {
        pair.level == 0
    }

    #[inline(always)]
    fn expand<S: RowSimd>(self, simd: S, pair: BlockPair, out: &mut Vec<BlockPair>) {
        let level = pair.level as usize;
        let (a, b) = (&self.a.level(level)[pair.a as usize], &self.b.level(level)[pair.b as usize]);
        let mut masks = overlaps(simd, a, b) & !self.both_fixed(pair);
        if self.within && pair.a == pair.b {
            masks &= UPPER_OR_DIAGONAL;
        }
        while masks != 0 {
            let bit = masks.trailing_zeros();
            masks &= masks - 1;
            let (a, b) = (pair.a * WIDTH as u32 + bit / 8, pair.b * WIDTH as u32 + bit % 8);
            out.push(BlockPair { level: pair.level - 1, a, b });
        }
    }

    #[inline(always)]
    fn rows<S: RowSimd, K: PairSink>(
        self,
        simd: S,
        pair: BlockPair,
        sink: &K,
        worker: &mut K::Worker,
    ) {
        let (a, b) = (pair.a as usize, pair.b as usize);
        let mut masks =
            overlaps(simd, &self.leaves_a[a], &self.leaves_b[b]) & !self.both_fixed(pair);
        if self.within && a == b {
            masks &= UPPER;
        }
        while masks != 0 {
            let i = masks.trailing_zeros() as usize / 8;
            let mask = (masks >> (8 * i)) as u32 & 0xff;
            masks &= !(0xff << (8 * i));
            sink.row(worker, simd, a, i, b, mask);
        }
    }
}

impl BlockPairs<'_> {
    /// Byte `i`, bit `j`: whether everything in box `i` of one block and box `j` of the other is
    /// fixed.
    #[inline(always)]
    fn both_fixed(self, pair: BlockPair) -> u64 {
        if !self.a.any_fixed() {
            return 0;
        }
        let rows = self.a.fixed(pair.level as usize, pair.a as usize);
        let row = self.b.fixed(pair.level as usize, pair.b as usize) as u64;
        (0..WIDTH)
            .fold(0, |masks, i| if rows >> i & 1 == 1 { masks | row << (8 * i) } else { masks })
    }
}

/// Byte `i`, bit `j`: whether box `i` of `a` overlaps box `j` of `b`. All rows first, without a
/// branch between them.
#[inline(always)]
fn overlaps<S: RowSimd>(simd: S, a: &Block, b: &Block) -> u64 {
    let mut masks = 0;
    for i in 0..WIDTH {
        masks |= (simd.overlaps(a, i, b) as u64) << (8 * i);
    }
    masks
}

/// Byte `i` has the bits `j >= i`.
const UPPER_OR_DIAGONAL: u64 = 0x80c0_e0f0_f8fc_feff;
/// Byte `i` has the bits `j > i`.
const UPPER: u64 = 0x0080_c0e0_f0f8_fcfe;
