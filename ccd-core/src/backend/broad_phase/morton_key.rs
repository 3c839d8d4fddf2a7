//! Map: the bounds of many boxes, and their codes along a curve.

use crate::kernel::memory::{Stored, at};
use crate::math::aabb::Aabb;
use crate::math::hilbert::hilbert_cell_of_10;
use crate::math::morton::{MortonGrid, morton30, morton63};

/// A curve through the cells of a grid.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Curve {
    /// The bits of the axes in turn: what builders of binary trees ask for.
    Morton,
    /// From neighbour to neighbour: what blocks of boxes take.
    #[default]
    Hilbert,
}

impl Curve {
    /// The cell whose Morton code is that of `cell` along this curve, on a grid with `2^10` cells a
    /// side.
    #[inline(always)]
    pub fn place(self, cell: [u32; 3]) -> [u32; 3] {
        if self == Self::Hilbert { hilbert_cell_of_10(cell) } else { cell }
    }
}

/// Boxes that one thread merges.
pub const CHUNK: usize = 8;

/// Union of `CHUNK` boxes from `first` on, `stride` apart; those past the end are left out.
#[inline(always)]
pub fn scene_bounds<B: Stored<Aabb<f32>>>(
    first: usize,
    stride: usize,
    boxes: &[B],
    n: usize,
) -> Aabb<f32> {
    let mut out = Aabb::EMPTY;
    for k in 0..CHUNK {
        let i = first + k * stride;
        if i < n {
            out = out.union(&B::load(boxes, i));
        }
    }
    out
}

/// The number as an integer of the same order; 0 is below all of them.
#[inline(always)]
pub fn order_key(x: f32) -> u32 {
    let bits = x.to_bits();
    if bits >> 31 == 1 { !bits } else { bits | 1 << 31 }
}

/// The number of [`order_key`].
#[inline(always)]
pub fn from_order_key(key: u32) -> f32 {
    f32::from_bits(if key >> 31 == 1 { key & 0x7fff_ffff } else { !key })
}

/// Word `k` of bounds that threads share: a maximum of integers that starts at 0, for lower bounds
/// of their complements.
#[inline(always)]
pub fn shared_word(b: &Aabb<f32>, k: usize) -> u32 {
    if k < 3 { !order_key(b.min[k]) } else { order_key(b.max[k - 3]) }
}

/// The bounds in six shared words.
#[inline(always)]
pub fn merged(words: &[u32]) -> Aabb<f32> {
    let mut out = Aabb::EMPTY;
    for k in 0..3 {
        out.min[k] = from_order_key(!at(words, k));
        out.max[k] = from_order_key(at(words, 3 + k));
    }
    out
}

/// Morton code, 63 bits as `[low, high]`, of the centre of box `i`.
#[inline]
pub fn morton(i: usize, boxes: &[Aabb<f32>], grid: &MortonGrid) -> [u32; 2] {
    morton63(grid.cell(&boxes[i]))
}

/// Code along a curve, in 30 bits, of the centre of a box.
#[inline(always)]
pub fn code30(aabb: &Aabb<f32>, grid: &MortonGrid, curve: Curve) -> u32 {
    morton30(curve.place(grid.cell(aabb)))
}

/// Key by which a device sorts box `i`: its set, then 30 bits of code on a grid of 2^10 cells a
/// side.
#[inline(always)]
pub fn sort_key<B: Stored<Aabb<f32>>>(
    i: usize,
    set: usize,
    boxes: &[B],
    grid: &MortonGrid,
    curve: Curve,
) -> u32 {
    (set as u32) << 30 | code30(&B::load(boxes, i), grid, curve)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_keep_order_and_value() {
        let x = [-3.0e38f32, -1.0, -1e-38, -0.0, 0.0, 1e-38, 1.0, 3.0e38];
        for pair in x.windows(2) {
            assert!(order_key(pair[0]) < order_key(pair[1]), "{pair:?}");
        }
        for x in x {
            assert_eq!(from_order_key(order_key(x)).to_bits(), x.to_bits());
            assert!(order_key(x) > 0 && !order_key(x) > 0);
        }
    }
}
