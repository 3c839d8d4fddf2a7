//! Uniform grid: boxes sorted by the cell that their centre is in, a cell as large as the largest
//! box, each box compared with those in the 3 x 3 x 3 cells around it [Karras 2012a].
//!
//! ```text
//!   +-----+-----+-----+     cells are numbered along x, then y, then z, so that three of them in a
//!   |  >  |  >  |  >  |     row are one run of the sorted boxes: `o` looks at two cells of its own
//!   +-----+-----+-----+     row and, of nine rows, at the four that come after it (`>`), and at
//!   |     |  o  |  >  |     what is in its own cell and after it in the order
//!   +-----+-----+-----+
//!   |     |     |     |     (one layer; of the layer above all three rows, of that below none)
//!   +-----+-----+-----+
//! ```
//!
//! **No pair is missed.** Centres of boxes that overlap are at most half the sum of their sides
//! apart along each axis, which is at most one cell. Cells are by [`MARGIN`] larger than the
//! largest box, which is more than rounding can move two centres apart: a centre's place, counted
//! in cells, is a sum of two differences that are not negative, times a factor that all boxes
//! share; the three roundings change it by less than `2^-22` of itself, and with at most `2^10`
//! cells along an axis by less than `2^-12` cells. Kernels of a device, which may round a quotient
//! by 2.5 units in the last place, may differ in the factor by `2^-20` of itself, and so in places
//! by `2^-10` cells. So places differ by less than
//! `(1 + 2^-20) / (1 + 2^-8) + 2^-11 + 2^-10 < 1`, and cells by at most one.
//!
//! **Each pair is found once.** Within one set a box looks only at boxes that come after it in the
//! order of cells (and of two in one cell, in the order of the sort): of any two boxes exactly one
//! comes after the other, and if their cells are neighbours, it is in a row that the other looks
//! at. Of two sets each box of the first looks at all nine rows of the second, which have no cell
//! in common.
//!
//! Cost: a sort, and for every box the boxes of its neighbourhood: constant for boxes of about one
//! size, but `n` where one box is as large as the scene, as many tests as brute force makes. So
//! there are several grids, each with cells half as large as those of the next
//! ([`super::grid_levels`]). The sizes along the three axes count apart, and are at least a
//! `2^BITS`-th of the scene. Choose it for many boxes of few sizes that overlap few others.

use crate::math::aabb::Aabb;
use crate::math::real::Num;

/// By how much a cell is larger than the largest box: 2^-8 of it, against rounding.
pub const MARGIN: f32 = 0.003_906_25;
/// Half of the least side of a cell, beside which numbers that a device flushes to zero vanish:
/// 2^-97.
pub(super) const LEAST_HALF: f32 = 6.310_887e-30;
/// The greatest that is divided by, 2^122: beyond, the inverse nears what a device flushes, and all
/// boxes are in one cell.
pub(super) const GREATEST_HALF: f32 = 5.316_912e36;
/// Rows of three cells around a cell, its own being the middle one.
pub const ROWS: u32 = 9;
/// The row that a cell is in itself.
pub const OWN_ROW: u32 = 4;

/// Bounds of boxes, and how large they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// What holds all of them.
    pub scene: Aabb<f32>,
    /// Half of the largest side along each axis; halves, because sides may not be finite in `f32`.
    pub half: [f32; 3],
}

impl Sizes {
    /// Of no boxes.
    pub const NONE: Self = Self { scene: Aabb::EMPTY, half: [0.0; 3] };

    /// Of one box.
    #[inline(always)]
    pub fn of(b: &Aabb<f32>) -> Self {
        let half = |k: usize| b.max[k] * 0.5 - b.min[k] * 0.5;
        Self { scene: *b, half: [half(0), half(1), half(2)] }
    }

    /// Of the boxes of both.
    #[inline(always)]
    pub fn merged(&self, other: &Self) -> Self {
        let mut out = Self { scene: self.scene.union(&other.scene), half: self.half };
        for k in 0..3 {
            out.half[k] = if other.half[k] > out.half[k] { other.half[k] } else { out.half[k] };
        }
        out
    }
}

/// Cells of a grid, as large as the largest box; `BITS`: of the number of a cell along an axis, at
/// most 10.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UniformGrid<const BITS: u32> {
    /// A quarter of the scene's least corner.
    quarter_origin: [f32; 3],
    /// One over half of a cell's sides.
    pub(super) inverse: [f32; 3],
}

impl<const BITS: u32> UniformGrid<BITS> {
    /// Cells along an axis.
    pub const CELLS: u32 = 1 << BITS;

    /// The grid over boxes of these sizes.
    #[inline(always)]
    pub fn new(sizes: &Sizes) -> Self {
        let mut out = Self { quarter_origin: [0.0; 3], inverse: [0.0; 3] };
        for k in 0..3 {
            let (min, max) = (sizes.scene.min[k], sizes.scene.max[k]);
            let extent = max * 0.5 - min * 0.5;
            let of_scene = extent * (1.0 / Self::CELLS as f32);
            let mut half = sizes.half[k] + sizes.half[k] * MARGIN;
            half = if of_scene > half { of_scene } else { half };
            half = if LEAST_HALF > half { LEAST_HALF } else { half };
            out.quarter_origin[k] = min * 0.25;
            out.inverse[k] = if half > GREATEST_HALF { 0.0 } else { 1.0 / half };
        }
        out
    }

    /// The cell of a box's centre.
    #[inline(always)]
    pub fn cell(&self, b: &Aabb<f32>) -> [u32; 3] {
        let mut out = [0; 3];
        for k in 0..3 {
            out[k] = Self::cell_at(self.place(b, k));
        }
        out
    }

    /// Where a box's centre is along an axis, in cells.
    #[inline(always)]
    pub(super) fn place(&self, b: &Aabb<f32>, k: usize) -> f32 {
        let origin = self.quarter_origin[k];
        // Half of the way from the origin to the centre. Quarters, because the sum of halves may
        // not be finite. None is below 0 where the box is in the scene; the maximum keeps a
        // compiler that may reorder sums from adding coordinates first, whose rounding would be too
        // large.
        let from_origin = |x: f32| Num::max(x * 0.25 - origin, 0.0);
        (from_origin(b.min[k]) + from_origin(b.max[k])) * self.inverse[k]
    }

    /// The cell of a place along an axis; NaN is in cell 0.
    #[inline(always)]
    pub(super) fn cell_at(place: f32) -> u32 {
        if place >= (Self::CELLS - 1) as f32 {
            Self::CELLS - 1
        } else if place > 0.0 {
            place as u32
        } else {
            0
        }
    }

    /// The number of a cell, by which boxes are sorted.
    #[inline(always)]
    pub fn key(cell: [u32; 3]) -> u32 {
        cell[2] << (2 * BITS) | cell[1] << BITS | cell[0]
    }

    /// The cell of a number.
    #[inline(always)]
    pub fn cell_of(key: u32) -> [u32; 3] {
        [key & (Self::CELLS - 1), key >> BITS & (Self::CELLS - 1), key >> (2 * BITS)]
    }

    /// The first and the last number of the cells in a row around a cell, rows numbered as cells
    /// are; a first that is greater than the last where the row is outside of the grid. `forward`:
    /// of the cell's own row only what comes from itself on.
    ///
    /// As cells go up, so do both ends of a row that is in the grid.
    #[inline(always)]
    pub fn row(cell: [u32; 3], row: u32, forward: bool) -> [u32; 2] {
        // One more than the row's place, so that it is not negative.
        let (y, z) = (cell[1] + row % 3, cell[2] + row / 3);
        if y < 1 || z < 1 || y > Self::CELLS || z > Self::CELLS {
            return [1, 0];
        }
        let before =
            if cell[0] > 0 && !(forward && row == OWN_ROW) { cell[0] - 1 } else { cell[0] };
        let after = if cell[0] + 1 < Self::CELLS { cell[0] + 1 } else { cell[0] };
        [Self::key([before, y - 1, z - 1]), Self::key([after, y - 1, z - 1])]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::aabb::GREATEST;
    use crate::random::Random;
    use alloc::vec::Vec;

    /// The finest of all grids.
    type Grid = UniformGrid<10>;

    fn grid(boxes: &[Aabb<f32>]) -> Grid {
        Grid::new(&boxes.iter().fold(Sizes::NONE, |all, b| all.merged(&Sizes::of(b))))
    }

    /// Whether `from` looks at the cell `to`.
    fn looks(from: [u32; 3], to: [u32; 3], forward: bool) -> usize {
        let rows = if forward { OWN_ROW..ROWS } else { 0..ROWS };
        let within = |r: u32| {
            let [first, last] = Grid::row(from, r, forward);
            first <= Grid::key(to) && Grid::key(to) <= last
        };
        rows.filter(|&r| within(r)).count()
    }

    /// Boxes that overlap are in cells around each other, by one rule each once.
    fn check_neighbours(boxes: &[Aabb<f32>]) -> usize {
        let grid = grid(boxes);
        let mut n = 0;
        for (i, a) in boxes.iter().enumerate() {
            for b in boxes[..i].iter().filter(|b| a.overlaps(b)) {
                let (p, q) = (grid.cell(a), grid.cell(b));
                assert!((0..3).all(|k| p[k].abs_diff(q[k]) <= 1), "{a:?} {b:?}: {p:?} {q:?}");
                assert_eq!((looks(p, q, false), looks(q, p, false)), (1, 1), "{p:?} {q:?}");
                let once = looks(p, q, true) + looks(q, p, true);
                // In one cell both rows hold it, and the order within the cell decides.
                assert_eq!(once, if p == q { 2 } else { 1 }, "{p:?} {q:?}");
                n += 1;
            }
        }
        n
    }

    #[test]
    fn boxes_that_overlap_are_in_neighbouring_cells() {
        let mut random = Random::new(3);
        let scales =
            [(0.0f32, 1e-38f32), (0.0, 1e-30), (0.0, 1.0), (1e6, 1.0), (-1e6, 0.25), (0.0, 1e35)];
        for (offset, unit) in scales {
            for cells in [2, 7, 600, 1 << 12] {
                // Boxes of one size on a lattice of half a size, so that many touch exactly.
                let mut boxes = Vec::new();
                for _ in 0..300 {
                    let min: [f32; 3] = core::array::from_fn(|k| {
                        let n = if k == 0 { cells } else { 5 };
                        offset + random.below(n) as f32 * 0.5 * unit
                    });
                    boxes.push(Aabb { min, max: min.map(|c| c + unit) });
                    let p = core::array::from_fn(|k| min[k] + 0.5 * unit);
                    boxes.push(Aabb::of_point(p));
                }
                let n = check_neighbours(&boxes);
                assert!(n > 10, "{n} pairs of {unit:e} at {offset:e}, {cells} cells");
            }
        }
    }

    #[test]
    fn rounding_moves_no_centre_by_more_than_the_margin() {
        // Two boxes of one size that touch, anywhere in scenes of hundreds of their sizes.
        let mut random = Random::new(5);
        let mut unit = || random.unit() as f32;
        for _ in 0..3000 {
            let (width, origin) = (0.5 + unit(), 100.0 * unit() - 50.0);
            let scene = Aabb { min: [origin; 3], max: [origin + 900.0 * width; 3] };
            for _ in 0..100 {
                let at = origin + (1.0 + 898.0 * unit()) * width;
                let a = Aabb { min: [at - width; 3], max: [at; 3] };
                let b = Aabb { min: [at; 3], max: [at + width; 3] };
                let sizes = Sizes::of(&a).merged(&Sizes::of(&b));
                let grid = Grid::new(&Sizes { scene, ..sizes });
                // As another kernel may round the factor.
                let mut other = grid;
                other.inverse[0] *= 1.0 + 1.0 / (1 << 20) as f32;
                for (x, y) in [(&grid, &grid), (&grid, &other), (&other, &grid)] {
                    let (p, q) = (x.cell(&a)[0], y.cell(&b)[0]);
                    assert!(p.abs_diff(q) <= 1, "{a:?} {b:?}: {p} {q}");
                }
            }
        }
    }

    #[test]
    fn touching_neighbours_far_from_the_origin() {
        // Sides of one and two spacings of `f32`, a chain along an axis from end to end.
        let spacing = 1.0 / 16.0;
        let boxes: Vec<_> = (0..1500)
            .map(|i| {
                let at = 1e6 + i as f32 * spacing;
                Aabb { min: [at, 0.0, 0.0], max: [at + spacing, 1.0, 1.0] }
            })
            .collect();
        assert!(check_neighbours(&boxes) >= 1499);
    }

    #[test]
    fn cells_of_any_boxes_are_in_the_grid() {
        let places = [-GREATEST, -1e30, -1.0, -1e-40, 0.0, 1e-45, 1.0, 1e30, GREATEST];
        let mut random = Random::new(9);
        for n in [1, 2, 5, 40] {
            for _ in 0..200 {
                let mut place = || {
                    let (i, j) = (random.below(9) as usize, random.below(9) as usize);
                    (places[i.min(j)], places[i.max(j)])
                };
                let mut one = || {
                    let sides: [_; 3] = core::array::from_fn(|_| place());
                    Aabb { min: sides.map(|s| s.0), max: sides.map(|s| s.1) }
                };
                let boxes: Vec<_> = (0..n).map(|_| one()).collect();
                let grid = grid(&boxes);
                for b in &boxes {
                    let cell = grid.cell(b);
                    assert!(cell.iter().all(|&c| c < Grid::CELLS), "{b:?}: {cell:?}");
                    assert_eq!(Grid::cell_of(Grid::key(cell)), cell);
                }
                check_neighbours(&boxes);
            }
        }
        let nan = Aabb { min: [f32::NAN; 3], max: [f32::NAN; 3] };
        assert_eq!(Grid::new(&Sizes::of(&nan)).cell(&nan), [0; 3]);
        assert_eq!(grid(&[]).cell(&Aabb::of_point([5.0; 3])), grid(&[]).cell(&Aabb::EMPTY));
    }

    #[test]
    fn a_smaller_cell_would_miss_pairs() {
        // The control of the checks above: two boxes that touch, in a grid that knows the smaller.
        let long = Aabb { min: [0.0; 3], max: [4.0, 1.0, 1.0] };
        let next = Aabb { min: [4.0, 0.0, 0.0], max: [8.0, 1.0, 1.0] };
        let far = Aabb { min: [40.0, 0.0, 0.0], max: [41.0, 1.0, 1.0] };
        let mut sizes = [long, next, far].iter().fold(Sizes::NONE, |s, b| s.merged(&Sizes::of(b)));
        let apart = |sizes: &Sizes| {
            let grid = Grid::new(sizes);
            grid.cell(&long)[0].abs_diff(grid.cell(&next)[0])
        };
        assert!(apart(&sizes) <= 1);
        sizes.half[0] = 0.5;
        assert!(apart(&sizes) > 1);
    }
}
