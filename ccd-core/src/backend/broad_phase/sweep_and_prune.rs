//! Sweep and prune: boxes sorted by where they begin along one axis, each compared with those that
//! begin before it ends [Cohen 1995], one query a box [Karras 2012a].
//!
//! ```text
//!   a |-------|                 a looks at b and c, and stops at d, which begins after a ends
//!   b    |-------|              b looks at c and d
//!   c       |--|                c looks at nothing: d begins after c ends
//!   d             |---|
//!   ---------------------> axis of largest variance
//! ```
//!
//! Boxes whose intervals overlap on the axis are found by going forward alone, because of two
//! intervals that overlap one begins inside the other. The axis along which the centres vary most
//! is the one on which the fewest intervals are expected to overlap. Of two sets, each in its own
//! order, a box of `a` looks at the boxes of `b` that begin inside it, and a box of `b` at the
//! boxes of `a` that begin inside it; where both begin at one place, only the first finds the pair
//! ([`finds`]). So every pair is found once, and both sets must share the axis.
//!
//! Cost: a sort, then for every box as many tests as boxes begin inside its interval: of `n` boxes
//! with sides `s` in a scene of length `l` that is `n s / l`, so twice as many boxes take four
//! times as long. Nothing but the order is built, so it is the least work for up to some ten
//! thousand boxes that are small beside the scene, and for scenes that are long in one direction.
//! From frame to frame a sequential sort of nearly sorted boxes is cheap [Cohen 1995]; here the
//! order is made anew, in parallel.

use crate::broad_phase::morton_key::order_key;
use crate::kernel::memory::at;
use crate::math::aabb::Aabb;
use crate::math::real::{Mask, Num, Real};

/// Number, mean and sum of squared deviations of the centres of boxes, along each axis.
///
/// Kept relative to the mean rather than as sums of squares, so that nothing cancels far from the
/// origin [Chan 1983]. In `f64` nothing overflows for any boxes in `f32`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments<T> {
    /// Number of centres.
    pub count: T,
    /// Their mean, in the unit of length.
    pub mean: [T; 3],
    /// Sum of their squared distances from the mean, along each axis.
    pub squares: [T; 3],
}

impl<T: Real> Moments<T> {
    /// Of no boxes.
    #[inline(always)]
    pub fn none() -> Self {
        let zero = T::splat(0.0);
        Self { count: zero, mean: [zero; 3], squares: [zero; 3] }
    }

    /// Of `n` boxes, at least one, from `first` on: first their mean, then what they are off it.
    #[inline(always)]
    pub fn of(first: usize, n: usize, boxes: &[Aabb<f32>]) -> Self {
        let mut out = Self { count: T::splat(n as f32), ..Self::none() };
        for i in first..first + n {
            let b = at(boxes, i);
            for k in 0..3 {
                out.mean[k] = out.mean[k] + centre::<T>(&b, k);
            }
        }
        for k in 0..3 {
            out.mean[k] = out.mean[k] / out.count;
        }
        for i in first..first + n {
            let b = at(boxes, i);
            for k in 0..3 {
                let off = centre::<T>(&b, k) - out.mean[k];
                out.squares[k] = out.squares[k] + off * off;
            }
        }
        out
    }

    /// Of the boxes of both, by the formula for two groups [Chan 1983].
    #[inline(always)]
    pub fn merged(&self, other: &Self) -> Self {
        let count = self.count + other.count;
        if !(count > T::splat(0.0)) {
            return *self;
        }
        let mut out = Self { count, ..*self };
        let weight = other.count / count;
        for k in 0..3 {
            let apart = other.mean[k] - self.mean[k];
            out.mean[k] = self.mean[k] + apart * weight;
            out.squares[k] =
                self.squares[k] + other.squares[k] + apart * apart * (self.count * weight);
        }
        out
    }

    /// The axes, that of the largest variance first; of equal ones the first. A variance that is
    /// NaN counts as none: any axis is right, some are slow.
    #[inline(always)]
    pub fn axes(&self) -> [usize; 3] {
        let [x, y, z] = self.squares;
        let first = if y > x {
            if z > y { 2 } else { 1 }
        } else if z > x {
            2
        } else {
            0
        };
        let (p, q) = if first == 0 {
            (1, 2)
        } else if first == 1 {
            (0, 2)
        } else {
            (0, 1)
        };
        if self.squares[q] > self.squares[p] { [first, q, p] } else { [first, p, q] }
    }
}

/// The centre of a box along an axis.
#[inline(always)]
fn centre<T: Real>(b: &Aabb<f32>, axis: usize) -> T {
    // Halves before the sum, which is then finite in `f32`, too.
    T::splat(b.min[axis]) * T::splat(0.5) + T::splat(b.max[axis]) * T::splat(0.5)
}

/// Where a box begins along the axis, as an integer of the same order.
#[inline(always)]
pub fn begin_key(b: &Aabb<f32>, axis: usize) -> u32 {
    axis_key(b.min[axis])
}

/// A place on the axis as an integer of the same order; zeros of both signs are one place. By bits,
/// because a compiler may think that adding zero does nothing.
#[inline(always)]
pub fn axis_key(x: f32) -> u32 {
    let bits = x.to_bits();
    order_key(f32::from_bits(if bits == 1 << 31 { 0 } else { bits }))
}

/// Whether boxes that end at `end` are past all that begin at `begin` or later: they touch those
/// that begin where they end.
#[inline(always)]
pub fn is_past<N: Num>(end: N, begin: N) -> N::Mask {
    begin.gt(end)
}

/// Whether a box that begins at `begin` is the one of two that finds another that begins at
/// `other`, if their intervals overlap; a bit a lane. `first`: whether it is of the first of two
/// sets.
///
/// `other` is not less than `begin` in the one case and greater in the other, so for any two
/// numbers exactly one of `finds(x, y, true)` and `finds(y, x, false)` holds: the pair is found
/// once.
#[inline(always)]
pub fn finds<N: Num>(begin: N, other: N, first: bool) -> u32 {
    if first { !begin.gt(other).bits() & N::Mask::ALL } else { other.gt(begin).bits() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::aabb::GREATEST;
    use crate::random::Random;
    use alloc::vec::Vec;

    fn moments<T: Real>(boxes: &[Aabb<f32>]) -> Moments<T> {
        (0..boxes.len()).step_by(7).fold(Moments::none(), |all, first| {
            all.merged(&Moments::of(first, (boxes.len() - first).min(7), boxes))
        })
    }

    fn points(n: u32, at: [f32; 3], spread: [f32; 3]) -> Vec<Aabb<f32>> {
        let mut random = Random::new(5);
        let mut place = |k: usize| at[k] + spread[k] * random.unit() as f32;
        (0..n).map(|_| Aabb::of_point([0, 1, 2].map(&mut place))).collect()
    }

    #[test]
    fn axes_are_in_the_order_of_variance() {
        let check = |at: f32, spread: [f32; 3], want: [usize; 3]| {
            let boxes = points(500, [at; 3], spread);
            assert_eq!(moments::<f64>(&boxes).axes(), want, "{spread:?} at {at}");
        };
        for at in [0.0, 1.0, -1e6, 1e8] {
            let unit = if at == 1e8 { 100.0 } else { 1.0 };
            check(at, [9.0 * unit, 3.0 * unit, unit], [0, 1, 2]);
            check(at, [unit, 3.0 * unit, 9.0 * unit], [2, 1, 0]);
            check(at, [3.0 * unit, 9.0 * unit, unit], [1, 0, 2]);
            check(at, [3.0 * unit, unit, 9.0 * unit], [2, 0, 1]);
        }
        check(0.0, [0.0; 3], [0, 1, 2]);
        check(-GREATEST, [0.0, 0.0, GREATEST], [2, 0, 1]);
        // In `f32` squares of such numbers are infinite, and differences of those NaN.
        let huge = points(100, [-GREATEST; 3], [GREATEST; 3]);
        let mut axes = moments::<f32>(&huge).axes();
        axes.sort_unstable();
        assert_eq!(axes, [0, 1, 2]);
    }

    #[test]
    fn parts_merge_to_the_two_pass_variance() {
        let boxes = points(1000, [3000.0, -2.0, 0.0], [1.0, 70.0, 1e-3]);
        let mean = |k: usize| boxes.iter().map(|b| b.min[k] as f64).sum::<f64>() / 1000.0;
        let (left, right) = boxes.split_at(123);
        let all = moments::<f64>(left).merged(&moments(right)).merged(&Moments::none());
        for k in 0..3 {
            let want: f64 = boxes.iter().map(|b| (b.min[k] as f64 - mean(k)).powi(2)).sum();
            let off = (all.squares[k] - want).abs();
            assert!(off <= 1e-9 * want, "axis {k}: {} is not {want}", all.squares[k]);
        }
        assert_eq!(all.count, 1000.0);
    }

    #[test]
    fn exactly_one_of_two_finds_a_pair() {
        let places = [-GREATEST, -1.0, -1e-45, -0.0, 0.0, 1e-45, 1.0, GREATEST];
        for x in places {
            for y in places {
                assert_ne!(finds(x, y, true), finds(y, x, false), "{x:e}, {y:e}");
                let key = |x: f32| begin_key(&Aabb::of_point([x; 3]), 1);
                assert_eq!(key(x) < key(y), x < y, "{x:e}, {y:e}");
                assert_eq!(is_past(x, y), y > x);
            }
        }
    }
}
