//! Axis-aligned boxes, closed overlap, and the one place where numbers are rounded outward.

use crate::math::real::{Num, Real};
use bytemuck::{Pod, Zeroable};

/// A closed axis-aligned box; `min > max` in any axis means empty.
///
/// | field | bytes (f32) | unit |
/// |---|---|---|
/// | `min` | 0..12 | length |
/// | `max` | 12..24 | length |
///
/// ```
/// use ccd::Aabb;
///
/// let unit = Aabb { min: [0.0f32; 3], max: [1.0; 3] };
/// // Boxes are closed: these touch.
/// assert!(!unit.separated(&Aabb { min: [1.0; 3], max: [2.0; 3] }));
/// assert!(unit.separated(&Aabb { min: [1.1; 3], max: [2.0; 3] }));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Aabb<T = f32> {
    /// Smallest corner.
    pub min: [T; 3],
    /// Greatest corner.
    pub max: [T; 3],
}

#[allow(unsafe_code, reason = "bytemuck derives `Pod` for no `repr(C)` type with a parameter")]
const _: () = {
    // SAFETY: six numbers of one type, `repr(C)`: no padding, every bit pattern valid.
    unsafe impl Zeroable for Aabb<f32> {}
    // SAFETY: as above.
    unsafe impl Pod for Aabb<f32> {}
    // SAFETY: as above.
    unsafe impl Zeroable for Aabb<f64> {}
    // SAFETY: as above.
    unsafe impl Pod for Aabb<f64> {}
};

const _: () = assert!(size_of::<Aabb<f32>>() == 24 && size_of::<Aabb<f64>>() == 48);

impl<N: Num> Aabb<N> {
    /// Where an axis separates the closed boxes: the contrary of an overlap. A bound that is NaN
    /// separates nothing.
    #[inline(always)]
    pub fn separated(&self, other: &Self) -> N::Mask {
        let x = self.min[0].gt(other.max[0]) | other.min[0].gt(self.max[0]);
        let y = self.min[1].gt(other.max[1]) | other.min[1].gt(self.max[1]);
        let z = self.min[2].gt(other.max[2]) | other.min[2].gt(self.max[2]);
        x | y | z
    }
}

impl<T: Real> Aabb<T> {
    /// The box of one point.
    #[inline]
    pub fn of_point(p: [T; 3]) -> Self {
        Self { min: p, max: p }
    }

    /// Smallest box that holds both.
    #[inline(always)]
    pub fn union(&self, other: &Self) -> Self {
        let (a, b) = (self, other);
        Self {
            min: [a.min[0].min(b.min[0]), a.min[1].min(b.min[1]), a.min[2].min(b.min[2])],
            max: [a.max[0].max(b.max[0]), a.max[1].max(b.max[1]), a.max[2].max(b.max[2])],
        }
    }

    /// Whether the closed boxes share a point: touching counts. False if a bound is NaN.
    #[inline(always)]
    pub fn overlaps(&self, other: &Self) -> bool {
        (self.min[0] <= other.max[0])
            & (other.min[0] <= self.max[0])
            & (self.min[1] <= other.max[1])
            & (other.min[1] <= self.max[1])
            & (self.min[2] <= other.max[2])
            & (other.min[2] <= self.max[2])
    }

    /// The same box, or a slightly larger one, in `f32`. Bounds beyond [`GREATEST`] become that, on
    /// both sides of a comparison alike, so boxes that overlap still do; only the empty box has
    /// greater bounds.
    #[inline]
    pub fn round_out(&self) -> Aabb<f32> {
        let mut out = Aabb::EMPTY;
        for k in 0..3 {
            out.min[k] = Num::min(Num::max(self.min[k].round_down(), -GREATEST), GREATEST);
            out.max[k] = Num::min(Num::max(self.max[k].round_up(), -GREATEST), GREATEST);
        }
        out
    }

    /// The box grown by `margin >= 0` on every side, rounded outward.
    #[inline]
    pub fn inflated(&self, margin: T) -> Self {
        if margin > T::splat(0.0) {
            let mut out = *self;
            for k in 0..3 {
                out.min[k] = (out.min[k] - margin).next_down();
                out.max[k] = (out.max[k] + margin).next_up();
            }
            out
        } else {
            *self
        }
    }
}

impl Aabb<f32> {
    /// The empty box: the neutral element of [`Aabb::union`] among boxes that were rounded out;
    /// overlaps none of them. Its bounds are finite because shader languages cannot write others.
    pub const EMPTY: Self = Self { min: [3.0e38; 3], max: [-3.0e38; 3] };
}

/// Greatest bound of a box in `f32` that is not empty.
pub const GREATEST: f32 = 2.9e38;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_encloses_and_keeps_exact_values() {
        for x in [0.0, -0.0, 0.1, -0.1, 1.0 / 3.0, 1e-50, -1e-50, 0.5, 3.0e38, -3.5e38] {
            let (lo, hi) = (Real::round_down(x), Real::round_up(x));
            assert!(lo as f64 <= x && x <= hi as f64, "{x} not in [{lo}, {hi}]");
            assert!(lo == hi || f32::next_up(lo) == hi, "{x} in [{lo}, {hi}] is not tight");
        }
        assert_eq!(Real::round_down(0.25f64), 0.25);
    }

    #[test]
    fn boxes_beyond_f32_still_overlap_and_the_empty_box_does_not() {
        let far = Aabb { min: [-1e60f64; 3], max: [1e60; 3] };
        let farther = Aabb { min: [1e60f64; 3], max: [1e70; 3] };
        assert!(far.overlaps(&farther) && far.round_out().overlaps(&farther.round_out()));
        assert!(!far.round_out().overlaps(&Aabb::EMPTY));
    }

    #[test]
    fn overlap_is_closed() {
        let a = Aabb { min: [0.0; 3], max: [1.0f32; 3] };
        let mut b = Aabb { min: [1.0; 3], max: [2.0; 3] };
        assert!(a.overlaps(&b) && b.overlaps(&a));
        b.min[1] = f32::next_up(1.0);
        assert!(!a.overlaps(&b) && !b.overlaps(&a));
        assert!(!a.overlaps(&Aabb::EMPTY) && !Aabb::EMPTY.overlaps(&Aabb::EMPTY));
    }
}
