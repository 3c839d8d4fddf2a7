//! Block bvhs as a source of pairs: two of them, or one with itself, are descended at once, block
//! against block, eight boxes a test.

use crate::broad_phase::block_bvh::BlockBvh;
use crate::broad_phase::curve_order::CurveOrder;
use crate::broad_phase::leaf_boxes::{LeafBoxes, Order, Sides};
use crate::broad_phase::pair_source::{PairSink, PairSource, overlaps};
use crate::broad_phase::pair_tree::PairTree;
use crate::broad_phase::tasks::{Search, Tasks};
use crate::simd::{Block, RowSimd, WIDTH};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::pair_descent::NodePair;

/// A block bvh per set.
#[derive(Debug, Default)]
pub struct BlockSource {
    pub trees: Vec<BlockBvh>,
    /// What sorts each set.
    pub curves: Vec<CurveOrder>,
    tasks: Tasks,
    /// The sets of the last search, whose tasks there are, until a tree changes.
    pub cut: Option<[Option<Sets>; 2]>,
}

/// The numbers of the sets of a search.
type Sets = (usize, Option<usize>);

/// Two blocks of the same level whose boxes are to be tested against each other; level 0 holds the
/// leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockPair {
    pub level: u32,
    pub a: u32,
    pub b: u32,
}

/// Bits of the number of a block: of 2^31 leaves there are 2^28 blocks of eight, on 11 levels.
const BITS: u32 = 28;

impl BlockPair {
    #[inline(always)]
    pub fn packed(self) -> NodePair {
        [self.level << BITS | self.a, self.b]
    }

    #[inline(always)]
    pub fn unpacked([a, b]: NodePair) -> Self {
        Self { level: a >> BITS, a: a & ((1 << BITS) - 1), b }
    }
}

impl PairSource for BlockSource {
    fn order(&mut self) -> &mut dyn Order {
        self
    }

    fn find<K: PairSink>(
        &mut self,
        threads: &Threads,
        sides: Sides,
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    ) {
        let cut = self.begin([Some(sides), None]);
        let Self { trees, tasks, .. } = self;
        raise(trees, sides);
        let search = BlockPairs::of(trees, sides).map(|pairs| pairs.search(sink));
        tasks.run(threads, search, None::<Search<BlockPairs, K>>, (part, cut), workers);
    }
}

impl BlockSource {
    /// As [`PairSource::find`], of two pairs of sides without a common one, in one search.
    pub fn find_two<K: PairSink, L: PairSink<Worker = K::Worker>>(
        &mut self,
        threads: &Threads,
        (first, first_sink): (Sides, &K),
        (second, second_sink): (Sides, &L),
        part: usize,
        workers: &mut [K::Worker],
    ) {
        let cut = self.begin([Some(first), Some(second)]);
        let Self { trees, tasks, .. } = self;
        [first, second].into_iter().for_each(|sides| raise(trees, sides));
        let first = BlockPairs::of(trees, first).map(|pairs| pairs.search(first_sink));
        let second = BlockPairs::of(trees, second).map(|pairs| pairs.search(second_sink));
        tasks.run(threads, first, second, (part, cut), workers);
    }

    /// Begins a search of these sets. Returns whether the tasks of the last one are its own, too.
    fn begin(&mut self, searches: [Option<Sides>; 2]) -> bool {
        let sets = |(a, b): Sides| (a.set().index, b.map(|b| b.set().index));
        let searches = searches.map(|sides| sides.map(sets));
        self.cut.replace(searches) == Some(searches)
    }
}

/// Makes trees equally high that are to be descended at once.
pub fn raise(trees: &mut [BlockBvh], (a, b): Sides) {
    let Some(b) = b.filter(|b| !a.is_empty() && !b.is_empty()) else { return };
    let height = trees[a.set().index].height().max(trees[b.set().index].height());
    [a, b].into_iter().for_each(|side| trees[side.set().index].raise(height, side.blocks()));
}

/// The trees that are descended, equal if pairs are sought `within` one.
#[derive(Clone, Copy)]
pub struct BlockPairs<'a> {
    pub a: &'a BlockBvh,
    pub b: &'a BlockBvh,
    leaves_a: &'a [Block],
    leaves_b: &'a [Block],
    within: bool,
    /// See [`BlockBvh::gap`].
    gap: Option<f32>,
}

impl PairTree for BlockPairs<'_> {
    #[inline(always)]
    fn is_leaf(self, pair: NodePair) -> bool {
        BlockPair::unpacked(pair).level == 0
    }

    #[inline(always)]
    fn expand<S: RowSimd>(self, simd: S, pair: NodePair, out: &mut Vec<NodePair>) {
        let pair = BlockPair::unpacked(pair);
        let mut masks = self.overlaps(simd, pair) & self.wanted(pair);
        if self.a.marks.any_fixed() {
            masks &= !self.apart_from_fixed(simd, pair);
        }
        if self.a.marks.worlds().are_known() && masks != 0 {
            masks &= self.in_one_world(pair);
        }
        if let Some(gap) = self.gap {
            masks &= !self.apart_at_ends(simd, pair, masks, gap);
        }
        let any_alone = self.a.marks.any_alone();
        while masks != 0 {
            let bit = masks.trailing_zeros();
            masks &= masks - 1;
            let child = child(pair, bit);
            let [level, i, j] = [child.level, child.a, child.b].map(|n| n as usize);
            if !(any_alone && self.a.marks.within_one_body(level, i, &self.b.marks, j)) {
                out.push(child.packed());
            }
        }
    }

    #[inline(always)]
    fn rows<S: RowSimd, K: PairSink>(
        self,
        simd: S,
        pair: NodePair,
        sink: &K,
        worker: &mut K::Worker,
    ) {
        let pair = BlockPair::unpacked(pair);
        let (a, b) = (pair.a as usize, pair.b as usize);
        let mut wanted = !self.both_fixed(pair);
        if self.a.marks.worlds().are_known() && wanted != 0 {
            wanted &= self.in_one_world(pair);
        }
        if self.within && a == b {
            wanted &= UPPER;
        }
        let boxes = [&self.leaves_a[a], &self.leaves_b[b]];
        let masks = overlaps(simd, boxes) & wanted;
        if masks != 0 {
            sink.blocks(worker, simd, (a, b), boxes, masks);
        }
    }
}

/// The pair of children that a bit stands for.
#[inline(always)]
pub fn child(pair: BlockPair, bit: u32) -> BlockPair {
    let (a, b) = (pair.a * WIDTH as u32 + bit / 8, pair.b * WIDTH as u32 + bit % 8);
    BlockPair { level: pair.level - 1, a, b }
}

impl<'a> BlockPairs<'a> {
    /// The trees of both sides, made equally high by [`raise`]; `None`: a side is empty.
    pub fn of(trees: &'a [BlockBvh], (a, b): Sides<'a>) -> Option<Self> {
        if a.is_empty() || b.is_some_and(LeafBoxes::is_empty) {
            return None;
        }
        let second = b.unwrap_or(a);
        let [of_a, of_b] = [a, second].map(|leaves| &trees[leaves.set().index]);
        Some(Self {
            a: of_a,
            b: of_b,
            leaves_a: a.blocks(),
            leaves_b: second.blocks(),
            within: b.is_none(),
            gap: of_a.gap().zip(of_b.gap()).map(|(a, b)| a.max(b)),
        })
    }

    /// The search for its pairs from the root.
    fn search<K>(self, sink: &K) -> Search<'_, Self, K> {
        (self, self.root().packed(), sink)
    }

    pub fn root(self) -> BlockPair {
        assert_eq!(self.a.height(), self.b.height(), "trees of different height");
        BlockPair { level: self.a.height() as u32 - 1, a: 0, b: 0 }
    }

    /// Of a pair above the leaves, byte `i`, bit `j`: whether box `i` overlaps box `j`.
    #[inline(always)]
    pub fn overlaps<S: RowSimd>(self, simd: S, BlockPair { level, a, b }: BlockPair) -> u64 {
        let level = level as usize;
        overlaps(simd, [&self.a.level(level)[a as usize], &self.b.level(level)[b as usize]])
    }

    /// Of a pair above the leaves, byte `i`, bit `j`: whether there may be a pair of leaves below
    /// child `i` and child `j`, whatever their boxes and worlds are.
    #[inline(always)]
    pub fn wanted(self, pair: BlockPair) -> u64 {
        let once = if self.within && pair.a == pair.b { UPPER_OR_DIAGONAL } else { u64::MAX };
        once & !self.both_fixed(pair)
    }

    /// Byte `i`, bit `j`: whether there may be a pair of one world below child `i` and child `j`.
    #[inline(always)]
    pub fn in_one_world(self, BlockPair { level, a, b }: BlockPair) -> u64 {
        self.a.marks.worlds().meet(a as usize, self.b.marks.worlds(), b as usize, level as usize)
    }

    /// Byte `i`, bit `j`: whether everything in box `i` of one block and box `j` of the other is
    /// fixed.
    #[inline(always)]
    fn both_fixed(self, BlockPair { level, a, b }: BlockPair) -> u64 {
        self.a.marks.both_fixed(level as usize, a as usize, &self.b.marks, b as usize)
    }

    /// Of a pair above the leaves, byte `i`, bit `j`: whether one of child `i` and child `j` is
    /// fixed, and what moves in the other is apart from it.
    #[inline(always)]
    fn apart_from_fixed<S: RowSimd>(self, simd: S, BlockPair { level, a, b }: BlockPair) -> u64 {
        let (level, a, b) = (level as usize, a as usize, b as usize);
        let mut apart = 0;
        if let Some((lane, moving)) = self.a.mixed(level, a) {
            let met = simd.overlaps(moving, lane, &self.b.level(level)[b]);
            apart |= ((self.b.marks.fixed(level, b) as u32 & !met) as u64) << (8 * lane);
        }
        if let Some((lane, moving)) = self.b.mixed(level, b) {
            let met = simd.overlaps(moving, lane, &self.a.level(level)[a]);
            let rows = self.a.marks.fixed(level, a) as u32 & !met;
            apart |=
                (0..WIDTH).fold(0, |bits, i| bits | ((rows >> i & 1) as u64) << (8 * i + lane));
        }
        apart
    }

    /// Of a pair above the leaves, byte `i`, bit `j`, of those in `masks`: whether an axis keeps
    /// child `i` and child `j` further than `gap` apart at both ends.
    #[inline(always)]
    fn apart_at_ends<S: RowSimd>(self, simd: S, pair: BlockPair, masks: u64, gap: f32) -> u64 {
        let level = pair.level as usize;
        let (Some(a), Some(b)) =
            (self.a.ends(level, pair.a as usize), self.b.ends(level, pair.b as usize))
        else {
            return 0;
        };
        let mut apart = 0;
        for i in 0..WIDTH {
            if masks >> (8 * i) & 0xff != 0 {
                apart |= (simd.axis_separated(a, i, b, gap) as u64) << (8 * i);
            }
        }
        apart
    }
}

/// Byte `i` has the bits `j >= i`.
const UPPER_OR_DIAGONAL: u64 = 0x80c0_e0f0_f8fc_feff;
/// Byte `i` has the bits `j > i`.
const UPPER: u64 = 0x0080_c0e0_f0f8_fcfe;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::leaf_boxes::Set;
    use crate::broad_phase::marks::Marks;
    use crate::broad_phase::pair_source::Overlaps;
    use crate::broad_phase::tests::random;
    use crate::simd::block_of;
    use ccd_core::Aabb;
    use std::collections::BTreeSet;
    use std::ops::Range;

    /// Gathers pairs of ids.
    struct Gather<'a>(&'a LeafBoxes);

    impl PairSink for Gather<'_> {
        type Worker = BTreeSet<[u32; 2]>;

        #[inline(always)]
        fn row<S: RowSimd>(&self, worker: &mut Self::Worker, _: S, row: Overlaps) {
            let Overlaps { a, lane, b, mask } = row;
            for j in (0..WIDTH).filter(|j| mask >> j & 1 == 1) {
                let mut pair = [self.0.ids(a)[lane], self.0.ids(b)[j]];
                pair.sort_unstable();
                worker.insert(pair);
            }
        }
    }

    /// Boxes that fall past each other: those that an axis keeps apart at both ends may be left
    /// out, no others are, and many of them are.
    #[test]
    fn what_is_left_out_is_apart_at_both_ends() {
        const GAP: f32 = 0.002;
        let (threads, mut unit) = (Threads::new(1).unwrap(), random(3));
        let mut source = BlockSource::default();
        let mut leaves = LeafBoxes::new(Set { index: 0, searched: true });
        for n in [5usize, 40, 700, 3000] {
            let ends: Vec<[Aabb<f32>; 2]> = (0..n)
                .map(|i| {
                    let [x, y, z] = [unit(), 0.3 * unit(), unit()];
                    let side = 0.5 / (n as f32).cbrt();
                    let fall = if i % 3 == 0 { 0.0 } else { 4.0 };
                    [y, y + fall]
                        .map(|y| Aabb { min: [x, y, z], max: [x + side, y + 0.1 * side, z + side] })
                })
                .collect();
            let swept: Vec<_> = ends.iter().map(|[start, end]| start.union(end)).collect();
            leaves.build(&threads, &mut source, &swept, Marks::default());
            let find = |source: &mut BlockSource, leaves: &LeafBoxes| {
                let mut found = [BTreeSet::new()];
                source.find(&threads, (leaves, None), 1, &Gather(leaves), &mut found);
                let [found] = found;
                found
            };
            let all = find(&mut source, &leaves);
            let block = |ids: &[u32]| {
                [0, 1].map(|end| block_of(ids.iter().map(|&id| ends[id as usize][end])))
            };
            let blocks: Vec<_> = leaves.order().chunks(WIDTH).map(block).collect();
            let whole = [Range { start: 0, end: blocks.len() }];
            assert!(source.take_ends(&threads, &leaves, &blocks, &whole, GAP), "{n}");
            let near = find(&mut source, &leaves);
            let apart = |[a, b]: [u32; 2]| {
                let [a, b] = [a, b].map(|id| &ends[id as usize]);
                (0..3).any(|k| {
                    [(a, b), (b, a)].into_iter().any(|(low, high)| {
                        (0..2).all(|end| high[end].min[k] - low[end].max[k] > GAP)
                    })
                })
            };
            assert!(near.is_subset(&all), "{n}");
            let left_out: Vec<_> = all.difference(&near).copied().collect();
            assert!(left_out.iter().all(|&pair| apart(pair)), "{n}: a pair is lost");
            let n_apart = all.iter().filter(|&&pair| apart(pair)).count();
            assert!(
                n < 100 || 4 * left_out.len() > n_apart,
                "{n}: {} of {n_apart}",
                left_out.len()
            );
            // The next boxes bring all pairs back.
            leaves.refit(&threads, &mut source, &swept);
            assert_eq!(find(&mut source, &leaves), all, "{n}");
        }
    }
}
