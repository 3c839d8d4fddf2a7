//! Morton codes: the bits of three coordinates interleaved, so that near codes are mostly near in
//! space.

use crate::math::aabb::Aabb;

/// Spreads the low 10 bits of `v` to every third bit.
#[inline]
fn spread10(v: u32) -> u32 {
    let v = (v | (v << 16)) & 0x0300_00ff;
    let v = (v | (v << 8)) & 0x0300_f00f;
    let v = (v | (v << 4)) & 0x030c_30c3;
    (v | (v << 2)) & 0x0924_9249
}

/// Interleaves three 10-bit cell numbers to 30 bits; `x` is the highest bit of each triple. Higher
/// bits are ignored.
#[inline]
pub fn morton30(cell: [u32; 3]) -> u32 {
    (spread10(cell[0] & 0x3ff) << 2) | (spread10(cell[1] & 0x3ff) << 1) | spread10(cell[2] & 0x3ff)
}

/// Interleaves three 21-bit cell numbers to 63 bits, `x` the highest of each triple, as two words
/// `[low, high]` (32 bits each): no 64-bit integer is needed. Bits of a cell number above the 21st
/// are ignored.
#[inline]
pub fn morton63(cell: [u32; 3]) -> [u32; 2] {
    // The low 10 bits of each cell fill bits 0..30, the next 11 fill bits 30..63.
    let low = morton30(cell);
    let mid = morton30([cell[0] >> 10, cell[1] >> 10, cell[2] >> 10]);
    let top = ((cell[0] >> 20 & 1) << 2) | ((cell[1] >> 20 & 1) << 1) | (cell[2] >> 20 & 1);
    [low | (mid << 30), (mid >> 2) | (top << 28)]
}

/// Interleaves three 11-bit cell numbers to 33 bits: the upper bits of [`morton63`] of cells of
/// `2^10` as many a side. Bits of a cell number above the 11th are ignored.
#[inline]
pub fn morton33(cell: [u32; 3]) -> u64 {
    let top = ((cell[0] >> 10 & 1) << 2) | ((cell[1] >> 10 & 1) << 1) | (cell[2] >> 10 & 1);
    (top as u64) << 30 | morton30(cell) as u64
}

/// Maps centres of boxes inside `scene` to cell numbers of a cubic grid with `2^bits` cells a side.
///
/// Cells are a means of ordering: rounding may put a point into a neighbouring cell, never outside
/// of the grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MortonGrid {
    origin: [f32; 3],
    scale: f32,
    last: f32,
}

impl MortonGrid {
    /// A grid over `scene` with `2^bits` cells along its longest side, `bits <= 21`.
    #[inline]
    pub fn new(scene: &Aabb<f32>, bits: u32) -> Self {
        let mut side = 0.0f32;
        for k in 0..3 {
            // Halves, because the side of a box of huge coordinates is not a finite f32.
            let half = scene.max[k] * 0.5 - scene.min[k] * 0.5;
            if half > side {
                side = half;
            }
        }
        let cells = (1u32 << bits) as f32;
        // A side so small that the scale overflows is one cell, like no side at all.
        let scale = if side > 1e-30 { 0.5 * cells / side } else { 0.0 };
        Self { origin: scene.min, scale, last: cells - 1.0 }
    }

    /// The box in units of two cells from the origin of the grid: what heuristics measure where
    /// squares of the coordinates themselves would overflow or vanish. The grid must be over a
    /// scene that holds `b`; 0 if that has no size.
    #[inline(always)]
    pub fn in_cells(&self, b: &Aabb<f32>) -> Aabb<f32> {
        let mut out = Aabb::EMPTY;
        for k in 0..3 {
            let origin = self.origin[k] * 0.5;
            out.min[k] = (b.min[k] * 0.5 - origin) * self.scale;
            out.max[k] = (b.max[k] * 0.5 - origin) * self.scale;
        }
        out
    }

    /// The cell of the centre of `b`.
    #[inline]
    pub fn cell(&self, b: &Aabb<f32>) -> [u32; 3] {
        let mut out = [0; 3];
        for k in 0..3 {
            let centre = b.min[k] * 0.5 + b.max[k] * 0.5;
            let x = (centre - self.origin[k]) * self.scale;
            // Written so that NaN gives cell 0.
            out[k] = if x >= self.last {
                self.last as u32
            } else if x > 0.0 {
                x as u32
            } else {
                0
            };
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn interleave(cell: [u32; 3], bits: u32) -> u64 {
        (0..bits).fold(0, |code, i| {
            let triple = (cell[0] >> i & 1) << 2 | (cell[1] >> i & 1) << 1 | (cell[2] >> i & 1);
            code | (triple as u64) << (3 * i)
        })
    }

    #[test]
    fn codes_equal_bit_by_bit_interleaving() {
        let mut random = Random::new(1);
        for _ in 0..1000 {
            let cell = [(); 3].map(|()| random.bits() >> 11);
            assert_eq!(morton30(cell) as u64, interleave(cell, 10), "{cell:?}");
            let [low, high] = morton63(cell);
            assert_eq!((high as u64) << 32 | low as u64, interleave(cell, 21), "{cell:?}");
            assert_eq!(morton33(cell), interleave(cell, 11), "{cell:?}");
        }
    }

    #[test]
    fn cells_stay_in_the_grid() {
        for side in [0.0, 1e-38, 1e-30, 1.0, 1e30, 3e38] {
            let scene = Aabb { min: [-side; 3], max: [side; 3] };
            let grid = MortonGrid::new(&scene, 21);
            for p in [-side, 0.0, side, f32::INFINITY, f32::NAN] {
                let cell = grid.cell(&Aabb::of_point([p; 3]));
                assert!(cell.iter().all(|&c| c < 1 << 21), "side {side}, point {p}: {cell:?}");
            }
        }
    }
}
