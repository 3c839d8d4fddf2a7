//! The Bernstein non-penetration filter with a rounding bound that any GPU or CPU keeps.
//!
//! `f(t) = a(t) . (b(t) x c(t))` is a cubic whose zeros are the only times at which the four points
//! are coplanar, hence the only times of contact. In Bernstein form its control values enclose it:
//! all of one sign means no contact [Tang 2010], [da Silva 2013]. Changed
//! here: the triple products are summed per Bernstein index, so that nothing is divided, and one
//! bound covers every control value.
//!
//! # The bound
//! Let `A B C` bound the components of `a b c` at both ends, `u` the unit roundoff, `e` the input
//! error of a difference. Three times each Bernstein value is a sum of at most 18 products of three
//! components (`6 x 3`).
//!
//! - *Operations.* A product passes at most 2 multiplications and 17 additions, in whatever order
//!   they are summed, contracted or not, and one multiplication by three: `20 u`.
//! - *Factors.* A difference is rounded once: `u`, and `3 u` for three factors. (Parts of a step
//!   have errors of their own, see [`Motion::part`].)
//! - *Input.* Each factor is off by `e`: `e (A B + B C + C A)` a product.
//!
//! `error <= 18 (20 u + 3 u) A B C + 18 e (A B + B C + C A)`: `524` for `414` and `19` for `18`
//! hold terms of second order and the roundings of the bound itself (a part in 10^5 where `u` is
//! 2^-24).
//!
//! - *Flushing.* A component is off by at most 3 times the smallest normal number (two operands and
//!   their difference); 5 are counted, so 18 products lose `90 (A B + B C + C A)` times that,
//!   products of two factors `18 A`, sums inside of vector products `12 A`, and products of three
//!   and the other sums `36`: `30 A + 36` besides, and all of it below `256 MIN_NORMAL (1 + A)(1 +
//!   B)(1 + C)`.
//! - *Overflow.* No intermediate result is above `18 A B C`, or `8 B C` before it is multiplied by
//!   `a`. Where one overflows so does `8 B C` or `64 A B C` (or the latter is NaN), which is part
//!   of the bound, and the filter answers "unknown".
//!
//! The greatest normal is a sum of absolute components, each of them at most four products of two
//! factors: `(2 u + u + 3 u) 4 B C / 2 = 12 u B C` (`8 u` at the ends), for three `36 u B C`: `8 u
//! 8 B C` covers it. Input: `2 e (B + C)` a component. What is relative to the sum itself is in the
//! factor `1.0001` of [`Coplanarity::clearance`].

use crate::math::real::Num;
use crate::math::vec3::{add, cross, dot, sum_abs};
use crate::narrow_phase::relative_motion::Motion;

/// The cubic of coplanarity, `c[0] s^3 + c[1] s^2 t + c[2] s t^2 + c[3] t^3` with `s = 1 - t`.
///
/// `3 c[0], c[1], c[2], 3 c[3]` are three times its Bernstein control values.
#[derive(Clone, Copy, Debug)]
pub struct Coplanarity<N> {
    /// Coefficients in the scaled Bernstein basis above.
    pub c: [N; 4],
    /// Bound of the error of `3 c[0]`, `c[1]`, `c[2]`, `3 c[3]`, hence of `3 f(t)` at every `t`.
    pub bound: N,
    /// Upper bound of `|b(t) x c(t)|` over the step: turns `f` into a distance to the plane (or
    /// between the lines).
    pub normal: N,
}

impl<N: Num> Coplanarity<N> {
    /// The cubic of a motion: 4 vector products, 6 scalar ones.
    #[inline(always)]
    pub fn new(m: &Motion<N>) -> Self {
        let n00 = cross(m.b[0], m.c[0]);
        let n11 = cross(m.b[1], m.c[1]);
        let n01 = add(cross(m.b[0], m.c[1]), cross(m.b[1], m.c[0]));
        let c = [
            dot(m.a[0], n00),
            dot(m.a[1], n00) + dot(m.a[0], n01),
            dot(m.a[0], n11) + dot(m.a[1], n01),
            dot(m.a[1], n11),
        ];
        let [ma, mb, mc] = m.magnitudes();
        let (one, eight) = (N::splat(1.0), N::splat(8.0));
        let bc = (mb * eight) * mc;
        let abc = (ma * eight) * bc;
        let rounding = abc * (N::UNIT * N::splat(524.0 / 64.0));
        let input = m.error * N::splat(19.0) * (ma * (mb + mc) + mb * mc);
        let flushed = (N::MIN_NORMAL * N::splat(256.0)) * ((one + ma) * ((one + mb) * (one + mc)));
        let half = N::splat(0.5);
        let normal = sum_abs(n00).max(sum_abs(n11)).max(sum_abs(n01) * half)
            + bc * (N::UNIT * N::splat(8.0))
            + m.error * N::splat(6.0) * (mb + mc)
            + (N::MIN_NORMAL * N::splat(256.0)) * ((one + mb) * (one + mc));
        Self { c, bound: rounding + input + flushed, normal }
    }

    /// Positive only if the features certainly stay further than `min_distance >= 0` apart for all
    /// of `[0, 1]`; the size means nothing. NaN where a computation overflowed: so compare with
    /// `> 0`.
    #[inline(always)]
    pub fn clearance(&self, min_distance: N) -> N {
        self.beyond() - self.needed(min_distance)
    }

    /// How far three times the control values are beyond 0, all on one side; below 0 if they are
    /// not.
    #[inline(always)]
    fn beyond(&self) -> N {
        let [c0, c1, c2, c3] = self.control();
        let low = c0.min(c3).min(c1.min(c2));
        let high = c0.max(c3).max(c1.max(c2));
        low.max(-high)
    }

    /// Whether the cubic certainly vanishes nowhere in `[0, 1]`: [`Coplanarity::clearance`] without
    /// a distance, hence without the normal.
    #[inline(always)]
    pub fn is_nonzero(&self) -> N::Mask {
        self.beyond().gt(self.bound)
    }

    /// The first and the last time at which the features may be as near as `min_distance >= 0`: one
    /// step of Bezier clipping [Sederberg 1990] from either end. NaN where a computation
    /// overflowed.
    #[inline(always)]
    pub fn clip(&self, min_distance: N) -> [N; 2] {
        let ([c0, c1, c2, c3], one) = (self.control(), N::splat(1.0));
        let needed = self.needed(min_distance);
        let from_start = clear_for([c0, c1, c2, c3], needed);
        let from_end = clear_for([c3, c2, c1, c0], needed);
        // The difference is rounded once, and the sum.
        [from_start, (one - from_end + N::UNIT * N::splat(4.0)).min(one)]
    }

    /// Three times the control values.
    #[inline(always)]
    fn control(&self) -> [N; 4] {
        let three = N::splat(3.0);
        [self.c[0] * three, self.c[1], self.c[2], self.c[3] * three]
    }

    /// What three times the cubic is above where the features are further apart than this.
    #[inline(always)]
    fn needed(&self, min_distance: N) -> N {
        // 1.0001: rounding of the product and of the sums.
        self.bound + min_distance * self.normal * N::splat(3.0 * 1.0001)
    }
}

/// For how long, from its start on and at most 1, a cubic with these control values is certainly
/// above `needed` or below `-needed`.
///
/// A cubic stays within the convex hull of its control values, hence above the steepest line from
/// the first of them to another. The time at which that line comes down to `needed` is a quotient
/// that is too great by at most `10 u`: `u` from the numerator's difference, `3 u` from the
/// denominator's difference, product and sum, `5 u` from the division (2.5 units in the last
/// place), `u` from the last product, which takes `32 u` off. Flushing: the denominator lacks less
/// than `7 MIN_NORMAL`, three times an operand and a result, and the product; `8` are added. The
/// numerator lacks nothing, because `needed` is normal.
#[inline(always)]
fn clear_for<N: Num>([c0, c1, c2, c3]: [N; 4], needed: N) -> N {
    let (zero, one) = (N::splat(0.0), N::splat(1.0));
    let steps = [(c1 - c0) * N::splat(3.0), (c2 - c0) * N::splat(1.5), c3 - c0];
    let fall = (-(steps[0].min(steps[1]).min(steps[2]))).max(zero);
    let rise = steps[0].max(steps[1]).max(steps[2]).max(zero);
    let flushed = N::MIN_NORMAL * N::splat(8.0);
    let time = ((c0 - needed) / (fall + flushed)).max((-c0 - needed) / (rise + flushed));
    (time * (one - N::UNIT * N::splat(32.0))).max(zero).min(one)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Outside of the times that are left a cubic is above what is needed, or below its negative.
    #[test]
    fn clipped_times_hold_all_small_values() {
        let mut random = Random::new(1);
        let (mut n_small, mut n_clipped) = (0, 0);
        for _ in 0..20_000 {
            let mut number = || (2.0 * random.unit() - 1.0) as f32;
            let c = [number() / 3.0, number(), number(), number() / 3.0];
            let bound = number().abs() * number().abs() + 1e-6;
            let plane = Coplanarity { c, bound, normal: 0.0 };
            let [lo, hi] = plane.clip(0.0).map(f64::from);
            n_clipped += (lo > 0.0 || hi < 1.0) as u32;
            // Of values that are rounded once, as the bound of a motion allows for.
            let control = plane.control().map(f64::from);
            for i in 0..=64 {
                let t = i as f64 / 64.0;
                let s = 1.0 - t;
                let [c0, c1, c2, c3] = control;
                let inner = 3.0 * s * t * (c1 * s + c2 * t);
                let value = c0 * s * s * s + inner + c3 * t * t * t;
                let is_small = value.abs() <= bound as f64;
                n_small += is_small as u32;
                assert!(!is_small || lo <= t && t <= hi, "{value} at {t}, {lo} to {hi}: {plane:?}");
            }
        }
        assert!(n_small > 100_000 && n_clipped > 10_000, "{n_small} {n_clipped} show nothing");
    }

    #[test]
    fn a_line_is_clipped_to_where_it_crosses() {
        for zero in [0.0f32, 0.25, 0.5, 1.0] {
            // -zero at the start, 1 - zero at the end.
            let at = |t: f32| t - zero;
            let c = [at(0.0), 3.0 * at(1.0 / 3.0), 3.0 * at(2.0 / 3.0), at(1.0)];
            let clip = Coplanarity { c, bound: 1e-6, normal: 0.0 }.clip(0.0);
            assert!(clip[0] <= zero && zero <= clip[1], "{clip:?} {zero}");
            assert!(clip[1] - clip[0] < 1e-5, "{clip:?}");
        }
        let nothing = Coplanarity { c: [f32::NAN; 4], bound: f32::NAN, normal: 0.0 }.clip(0.0);
        assert!(!(nothing[0] > 0.0) && !(nothing[1] < 1.0), "{nothing:?}");
    }
}
