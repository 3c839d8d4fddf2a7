//! Grids over each other, for boxes of any sizes: each has cells half as large as those of the
//! next, and every box is in the finest whose cells hold it [Ericson 2005], 7.2.1.
//!
//! ```text
//!   level 0     | | | | | | | | | | | | |     small boxes, sorted first
//!   level 1     |   |   |   |   |   |   |
//!   level 2     |       |       |       |     the largest box decides how large these are
//! ```
//!
//! A box asks the boxes of its own level in the cells around its own, and those of every coarser
//! level. A device asks there, too, in the 3 x 3 x 3 cells around its own; a CPU in those that it
//! reaches ([`Grids::reach`]), and also in finer levels.
//!
//! **No pair is missed.** Cells of a level hold the boxes of that level and of all finer ones, so
//! that the proof of one grid ([`super::uniform_grid`]) is that of a box that asks a coarser level.
//! A size that a device flushes to zero may be in a level too fine, whose cells are larger by far.
//! The range of cells of a CPU's reach: along an axis centres are at most half of both sides apart,
//! the box's own and at most half a cell. Places are off by less than `2^-12` cells each; half of
//! the box's own side, at most 512 cells, and the two ends of the range by less than `2^-13` each.
//! That is less than `2^-10` in all, and what a cell is larger than its boxes gives almost `2^-9`.
//!
//! **Each pair is found once.** Every box is in one cell of one level. Within one set it asks for
//! what comes after it: in its own level as in one grid, and at all around it in coarser ones. Of
//! two sets, the first asks its own level and coarser ones of the second, and on a device the
//! second asks coarser levels of the first; on a CPU the first asks finer levels as well.

use crate::broad_phase::uniform_grid::{LEAST_HALF, Sizes, UniformGrid};
use crate::math::aabb::Aabb;

/// Levels of a CPU at most: where the coarsest has one cell, the finest has all that an axis can
/// have.
pub const LEVELS: usize = BITS as usize + 1;
/// Bits of a cell along an axis, on a CPU.
pub const BITS: u32 = 10;

/// How many levels there are, from the finest to the coarsest, and how large their boxes are; grids
/// are made when asked for. `BITS`: of a cell along an axis; `MOST`: levels at most.
#[derive(Clone, Copy, Debug)]
pub struct Levels<const BITS: u32, const MOST: u32> {
    sizes: Sizes,
    /// How often the largest sides are halved for the finest level.
    halvings: u32,
}

impl<const BITS: u32, const MOST: u32> Levels<BITS, MOST> {
    /// Levels of boxes of these sizes: as many as have different cells along some axis. If these
    /// are more than `MOST`, the largest boxes are in one level, whose cells are few.
    #[inline(always)]
    pub fn new(sizes: &Sizes) -> Self {
        let mut out = Self { sizes: *sizes, halvings: 0 };
        let extent = Sizes::of(&sizes.scene).half;
        for n in 0..BITS {
            let mut finest = true;
            for k in 0..3 {
                let of_scene = extent[k] * (1.0 / (1 << BITS) as f32);
                // Such that flushing to zero decides nothing.
                let least = if of_scene > LEAST_HALF { of_scene } else { LEAST_HALF };
                if sizes.half[k] * power(n) > least {
                    finest = false;
                }
            }
            if finest {
                break;
            }
            out.halvings = n + 1;
        }
        out
    }

    /// How many there are.
    #[inline(always)]
    pub fn n_levels(&self) -> u32 {
        if self.halvings < MOST { self.halvings + 1 } else { MOST }
    }

    /// Half of the sides that boxes of a level have at most.
    #[inline(always)]
    pub fn half(&self, level: u32) -> [f32; 3] {
        let coarsest = level + 1 >= self.n_levels();
        let scale = power(if coarsest { 0 } else { self.halvings - level });
        let half = &self.sizes.half;
        [half[0] * scale, half[1] * scale, half[2] * scale]
    }

    /// The grid of a level.
    #[inline(always)]
    pub fn grid(&self, level: u32) -> UniformGrid<BITS> {
        UniformGrid::new(&Sizes { scene: self.sizes.scene, half: self.half(level) })
    }

    /// The finest level whose cells are as large as a box.
    #[inline(always)]
    pub fn level(&self, b: &Aabb<f32>) -> u32 {
        let half = Sizes::of(b).half;
        let mut level = 0;
        for _ in 1..MOST {
            if level + 1 >= self.n_levels() || fits(&half, &self.half(level)) {
                break;
            }
            level += 1;
        }
        level
    }
}

/// `2^-n`, `n` at most 126.
#[inline(always)]
fn power(n: u32) -> f32 {
    f32::from_bits((127 - n) << 23)
}

/// Whether a box is not larger than those of a level.
#[inline(always)]
fn fits(half: &[f32; 3], of_level: &[f32; 3]) -> bool {
    half[0] <= of_level[0] && half[1] <= of_level[1] && half[2] <= of_level[2]
}

/// The grids of a CPU, all of them made beforehand.
#[derive(Clone, Copy, Debug, Default)]
pub struct Grids {
    grids: [UniformGrid<BITS>; LEVELS],
    /// Half of the sides that boxes of a level have at most.
    halves: [[f32; 3]; LEVELS],
    len: usize,
}

impl Grids {
    /// Grids over boxes of these sizes.
    pub fn new(sizes: &Sizes) -> Self {
        let levels = Levels::<BITS, { LEVELS as u32 }>::new(sizes);
        let mut out = Self { len: levels.n_levels() as usize, ..Self::default() };
        for level in 0..out.len {
            out.halves[level] = levels.half(level as u32);
            out.grids[level] = levels.grid(level as u32);
        }
        out
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there is none: of no sizes yet.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The finest level whose cells are as large as a box, and the cell of its centre there.
    #[inline]
    pub fn cell(&self, b: &Aabb<f32>) -> (usize, [u32; 3]) {
        let half = Sizes::of(b).half;
        let holds = |level: &usize| fits(&half, &self.halves[*level]);
        let level = (0..self.len).find(holds).unwrap_or(self.len.saturating_sub(1));
        (level, self.grids[level].cell(b))
    }

    /// The first and the last cell, along each axis, in which boxes of a level have their centres
    /// that overlap this one.
    #[inline]
    pub fn reach(&self, level: usize, b: &Aabb<f32>) -> [[u32; 3]; 2] {
        let (grid, half) = (&self.grids[level], Sizes::of(b).half);
        let mut out = [[0; 3]; 2];
        for k in 0..3 {
            let (place, reach) = (grid.place(b, k), half[k] * 0.5 * grid.inverse[k] + 0.5);
            (out[0][k], out[1][k]) = (cell_at(place - reach), cell_at(place + reach));
        }
        out
    }
}

fn cell_at(place: f32) -> u32 {
    UniformGrid::<BITS>::cell_at(place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use alloc::vec::Vec;

    fn sizes(boxes: &[Aabb<f32>]) -> Sizes {
        boxes.iter().fold(Sizes::NONE, |all, b| all.merged(&Sizes::of(b)))
    }

    fn levels(boxes: &[Aabb<f32>]) -> Grids {
        Grids::new(&sizes(boxes))
    }

    /// Boxes of sizes from `2^-span` to 1 units whose bounds are on a lattice, so that many touch.
    fn boxes(random: &mut Random, n: usize, span: u64, unit: f32, origin: f32) -> Vec<Aabb<f32>> {
        let mut one = || {
            let min = core::array::from_fn(|_| origin + random.below(64) as f32 * unit * 0.25);
            let side: [f32; 3] =
                core::array::from_fn(|_| unit / (1u64 << random.below(span as u32 + 1)) as f32);
            Aabb { min, max: core::array::from_fn(|k| min[k] + side[k]) }
        };
        (0..n).map(|_| one()).collect()
    }

    /// Every overlap is in reach, from either side; returns how many overlaps there are.
    fn check(boxes: &[Aabb<f32>]) -> usize {
        let levels = levels(boxes);
        let mut n = 0;
        for (i, a) in boxes.iter().enumerate() {
            for b in boxes[..i].iter().filter(|b| a.overlaps(b)) {
                for (a, b) in [(a, b), (b, a)] {
                    let (level, cell) = levels.cell(b);
                    let [from, to] = levels.reach(level, a);
                    let within = (0..3).all(|k| from[k] <= cell[k] && cell[k] <= to[k]);
                    assert!(within, "{a:?} {b:?}: {cell:?} of level {level}, {from:?} to {to:?}");
                }
                n += 1;
            }
        }
        n
    }

    #[test]
    fn boxes_that_overlap_are_in_reach() {
        let mut random = Random::new(7);
        for (unit, origin) in [(1.0, 0.0), (1.0, 1e6), (1e-38, 0.0), (1e36, -1e38), (0.25, -4e6)] {
            for span in [0, 2, 9, 20] {
                let mut some = boxes(&mut random, 300, span, unit, origin);
                // One as large as the scene, and one that is long along an axis.
                let scene = some.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
                let mut long = some[0];
                (long.min[1], long.max[1]) = (scene.min[1], scene.max[1]);
                some.extend([long, scene]);
                assert!(check(&some) > 300, "{unit:e} at {origin:e}, 2^-{span}");
            }
        }
    }

    #[test]
    fn small_boxes_are_in_finer_levels() {
        let mut all: Vec<_> =
            (0..10).map(|k| Aabb { min: [0.0; 3], max: [1.0 / (1 << k) as f32; 3] }).collect();
        all.push(Aabb::of_point([1.0; 3]));
        let levels = levels(&all);
        assert_eq!(levels.len(), LEVELS);
        for (k, b) in all.iter().enumerate() {
            assert_eq!(levels.cell(b).0, LEVELS - 1 - k, "{b:?}");
        }
        // Fewer where the largest box is small beside the scene.
        let of_side = |side: f32| [0.0, 1024.0 - side].map(|at| [at, at + side]);
        let of_side = |side| of_side(side).map(|[a, b]| Aabb { min: [a; 3], max: [b; 3] });
        let n = [1.0, 2.0, 16.0, 512.0].map(|side| self::levels(&of_side(side)).len());
        assert_eq!(n, [1, 2, 5, 10]);
    }

    /// A box is in the finest level that holds it, also where levels are few.
    #[test]
    fn few_levels_leave_out_large_ones() {
        let boxes: Vec<_> =
            (0..13).map(|k| Aabb { min: [0.0; 3], max: [1.0 / (1 << k) as f32; 3] }).collect();
        let few = Levels::<9, 4>::new(&sizes(&boxes));
        assert_eq!(few.n_levels(), 4);
        let found: Vec<_> = boxes.iter().map(|b| few.level(b)).collect();
        assert_eq!(found, [3, 3, 3, 3, 3, 3, 3, 2, 1, 0, 0, 0, 0]);
        for (b, level) in boxes.iter().zip(found) {
            let fits = |level: u32| fits(&Sizes::of(b).half, &few.half(level));
            assert!(fits(level) && (level == 0 || !fits(level - 1)), "{b:?} in {level}");
        }
    }

    /// The control: half a cell less, and pairs are missed.
    #[test]
    fn a_smaller_reach_would_miss_pairs() {
        let mut random = Random::new(11);
        let some = boxes(&mut random, 400, 6, 1.0, 0.0);
        let levels = levels(&some);
        let mut missed = 0;
        for a in &some {
            for b in some.iter().filter(|b| a.overlaps(b)) {
                let (level, cell) = levels.cell(b);
                let (grid, half) = (&levels.grids[level], Sizes::of(a).half);
                let reach = |k: usize| half[k] * 0.5 * grid.inverse[k];
                let [from, to] = [-1.0, 1.0].map(|sign| {
                    core::array::from_fn::<_, 3, _>(|k| cell_at(grid.place(a, k) + sign * reach(k)))
                });
                missed += !(0..3).all(|k| from[k] <= cell[k] && cell[k] <= to[k]) as usize;
            }
        }
        assert!(missed > 0);
    }
}
