//! What the search for pairs does with blocks of eight boxes: rows, one box against eight, and
//! eight pairs at once, of whichever rows.

use super::{Block, F32x8, Simd, WIDTH};
use ccd_core::backend::broad_phase::candidate::overlap_surely;
use ccd_core::backend::layout::Pair;
use ccd_core::math::real::Mask;
use ccd_core::narrow_phase::separating_direction::axis_separated;
use ccd_core::{Aabb, Num};

/// Pairs that [`RowSimd::append_rows`] may write: all of two blocks.
pub const ROOM: usize = WIDTH * WIDTH;

/// An instruction set for rows of eight boxes.
pub trait RowSimd: Simd {
    /// Eight numbers.
    fn load(self, x: &F32x8) -> Self::Lanes;
    /// The same as an array.
    fn store(self, x: Self::Lanes) -> F32x8;
    /// Lanes in which `x` is one of the two.
    fn equals(self, lanes: &[u32; WIDTH], x: [u32; 2]) -> u32;
    /// Appends `(a, b[j])` for every lane `j` in `mask`, ascending; lesser id first if `ORDERED`.
    #[cfg_attr(not(test), inline(always))]
    fn append<const ORDERED: bool>(
        self,
        out: &mut Vec<Pair>,
        a: u32,
        b: &[u32; WIDTH],
        mut mask: u32,
    ) {
        while mask != 0 {
            let b = b[mask.trailing_zeros() as usize];
            out.push(if ORDERED { Pair::ordered(a, b) } else { Pair { a, b } });
            mask &= mask - 1;
        }
    }

    /// Eight of these boxes.
    #[inline(always)]
    fn gather_boxes(self, boxes: &[Aabb<f32>], ids: &[u32; WIDTH]) -> Aabb<Self::Lanes> {
        let all = ids.map(|id| boxes[id as usize]);
        let min = |k: usize| self.load(&F32x8(all.map(|aabb| aabb.min[k])));
        let max = |k: usize| self.load(&F32x8(all.map(|aabb| aabb.max[k])));
        Aabb { min: [min(0), min(1), min(2)], max: [max(0), max(1), max(2)] }
    }

    /// The least number of list `k` in lane `k`.
    #[inline(always)]
    fn least_of_each(self, lists: [&F32x8; WIDTH]) -> Self::Lanes {
        self.load(&F32x8(lists.map(|list| list.0.into_iter().fold(f32::INFINITY, Num::min))))
    }
    /// The greatest.
    #[inline(always)]
    fn greatest_of_each(self, lists: [&F32x8; WIDTH]) -> Self::Lanes {
        self.load(&F32x8(lists.map(|list| list.0.into_iter().fold(f32::NEG_INFINITY, Num::max))))
    }

    /// Whether the functions that pick lanes take a few instructions; else they are not used.
    const PICKS: bool = false;
    /// Eight bytes, each the place `8 i + j` of a bit: all `i`; all `j`, perhaps with multiples of
    /// eight.
    #[inline(always)]
    fn places(self, bytes: u64) -> [[u32; WIDTH]; 2] {
        let byte = |k: usize| bytes.to_le_bytes()[k] as u32;
        [std::array::from_fn(|k| byte(k) / WIDTH as u32), std::array::from_fn(byte)]
    }
    /// Lane `at[k] % 8` of `ids` in lane `k`.
    #[inline(always)]
    fn pick_ids(self, ids: &[u32; WIDTH], at: &[u32; WIDTH]) -> [u32; WIDTH] {
        at.map(|lane| ids[lane as usize % WIDTH])
    }
    /// The same of numbers.
    #[inline(always)]
    fn pick(self, x: &F32x8, at: &[u32; WIDTH]) -> Self::Lanes {
        self.load(&F32x8(at.map(|lane| x.0[lane as usize % WIDTH])))
    }
    /// Lanes in which `a` is one of the two.
    #[inline(always)]
    fn equals_each(self, a: &[u32; WIDTH], b: [&[u32; WIDTH]; 2]) -> u32 {
        (0..WIDTH).fold(0, |mask, k| mask | ((a[k] == b[0][k] || a[k] == b[1][k]) as u32) << k)
    }
    /// As [`RowSimd::append`], of `(a[j], b[j])`.
    #[inline(always)]
    fn append_each<const ORDERED: bool>(
        self,
        out: &mut Vec<Pair>,
        a: &[u32; WIDTH],
        b: &[u32; WIDTH],
        mask: u32,
    ) {
        for j in (0..WIDTH).filter(|j| mask >> j & 1 == 1) {
            out.push(if ORDERED { Pair::ordered(a[j], b[j]) } else { Pair { a: a[j], b: b[j] } });
        }
    }

    /// Appends `(a[i], b[j])` for every bit `j` of byte `i` of `masks`, ascending, lesser id first
    /// if `ORDERED`, but for pairs that have a number in common: of lane `i` of one of the first
    /// lists and lane `j` of one of the second. There must be [`ROOM`]. Returns how many.
    #[inline(always)]
    fn append_rows<const ORDERED: bool, const N: usize, const M: usize>(
        self,
        out: &mut Vec<Pair>,
        [a, b]: [&[u32; WIDTH]; 2],
        of_a: [&[u32; WIDTH]; N],
        of_b: [&[u32; WIDTH]; M],
        mut masks: u64,
    ) -> usize {
        let before = out.len();
        while masks != 0 {
            let lane = masks.trailing_zeros() as usize / WIDTH;
            let mut mask = (masks >> (WIDTH * lane)) as u32 & 0xff;
            masks &= !(0xff << (WIDTH * lane));
            for ids in of_b {
                for of in of_a {
                    mask &= !self.equals(ids, [of[lane]; 2]);
                }
            }
            self.append::<ORDERED>(out, a[lane], b, mask);
        }
        out.len() - before
    }

    /// Takes the first eight bits from the masks of two blocks, see
    /// [`PairSink::blocks`](crate::broad_phase::pair_source::PairSink::blocks): the lanes in both,
    /// and a mask of those that are there, if there are fewer.
    #[inline(always)]
    fn eight(self, masks: &mut u64) -> ([[u32; WIDTH]; 2], u32) {
        let n = masks.count_ones().min(WIDTH as u32);
        let mut bytes = 0;
        for k in 0..WIDTH {
            bytes |= (masks.trailing_zeros() as u64) << (8 * k);
            *masks &= masks.wrapping_sub(1);
        }
        (self.places(bytes), (1 << n) - 1)
    }

    /// Boxes `at[k]` of a block in lane `k`.
    #[inline(always)]
    fn picked(self, block: &Block, at: &[u32; WIDTH]) -> Aabb<Self::Lanes> {
        let (min, max) = (&block.min, &block.max);
        Aabb {
            min: [self.pick(&min[0], at), self.pick(&min[1], at), self.pick(&min[2], at)],
            max: [self.pick(&max[0], at), self.pick(&max[1], at), self.pick(&max[2], at)],
        }
    }

    /// Lanes in which an axis keeps a box further than `needed` from another at all times, of
    /// `[at the first time, at the last]`.
    #[inline(always)]
    fn separated_each(
        self,
        [a0, a1]: [Aabb<Self::Lanes>; 2],
        [b0, b1]: [Aabb<Self::Lanes>; 2],
        needed: f32,
    ) -> u32 {
        let (a0, a1, b0, b1) = (bounds(a0), bounds(a1), bounds(b0), bounds(b1));
        axis_separated(&a0, &a1, &b0, &b1, Self::Lanes::splat(needed)).bits() & 0xff
    }

    /// Eight boxes.
    #[inline(always)]
    fn boxes(self, block: &Block) -> Aabb<Self::Lanes> {
        let (min, max) = (&block.min, &block.max);
        Aabb {
            min: [self.load(&min[0]), self.load(&min[1]), self.load(&min[2])],
            max: [self.load(&max[0]), self.load(&max[1]), self.load(&max[2])],
        }
    }

    /// Box `i` in all lanes.
    #[inline(always)]
    fn one(self, block: &Block, i: usize) -> Aabb<Self::Lanes> {
        let (min, max) = (&block.min, &block.max);
        let all = Self::Lanes::splat;
        Aabb {
            min: [all(min[0].0[i]), all(min[1].0[i]), all(min[2].0[i])],
            max: [all(max[0].0[i]), all(max[1].0[i]), all(max[2].0[i])],
        }
    }

    /// Lanes of `b` whose closed boxes overlap that of lane `i` of `a`.
    #[inline(always)]
    fn overlaps(self, a: &Block, i: usize, b: &Block) -> u32 {
        !self.one(a, i).separated(&self.boxes(b)).bits() & 0xff
    }

    /// Lanes of `b` that an axis keeps further than `needed` from lane `i` of `a` at all times, of
    /// boxes at the first and at the last one: see [`axis_separated`].
    #[inline(always)]
    fn axis_separated(self, a: &[Block; 2], i: usize, b: &[Block; 2], needed: f32) -> u32 {
        let a = [self.one(&a[0], i), self.one(&a[1], i)];
        self.separated_each(a, [self.boxes(&b[0]), self.boxes(&b[1])], needed)
    }

    /// Lanes of `b` whose boxes overlap that of lane `i` of `a` by more than `slack`.
    #[inline(always)]
    fn overlaps_surely(self, a: &Block, i: usize, b: &Block, slack: f32) -> u32 {
        let slack = Self::Lanes::splat(slack);
        overlap_surely(&self.one(a, i), &self.boxes(b), slack).bits()
    }
}

/// `[min, max]`.
#[inline(always)]
fn bounds<N>(aabb: Aabb<N>) -> [[N; 3]; 2] {
    [aabb.min, aabb.max]
}
