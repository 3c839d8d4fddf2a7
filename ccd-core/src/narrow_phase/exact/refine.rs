//! The time of a certain contact to the last bit, by one evaluation in double-double.
//!
//! Over `[lo, hi]`, in which a contact is certain, `f = a . (b x c)` has one zero if its derivative
//! has none, and the contact is there. From `t` in the interval, by the mean value theorem, it is
//! at `t - f(t) / f'(x)` with some `x` between them. With `f(t)` almost exact and `f'` in bounds
//! that is an interval far narrower than a unit in the last place. Nearly always both of its ends
//! round down to the same `f64`; if not, the answer is `None`, and integers decide.
//!
//! # The bounds
//! Let `u = 2^-53`, and `A B C` bound the components of `a b c` at both ends, hence at all times.
//!
//! *`f(t)`.* Differences of coordinates are exact as pairs. By [Joldes 2017] a sum of pairs is off
//! by `3 u^2` (and terms of higher order) of itself, a product by `7 u^2`. A component at `t`:
//! `3 u^2 2 A` from the travel, `7 u^2 2 A` from its product with `t`, `3 u^2 A` from the sum:
//! `23 u^2 A`. A product of three is off by `(3 x 23 + 2 x 7) u^2`, six of them by `498 u^2 A B C`;
//! three differences of two by `3 x 6 u^2`, two sums of these by `(12 + 18) u^2`: `546 u^2`, where
//! the code has `1024 u^2`. With `A`, `B` and `C` from `2^-100` to `2^100`, what underflows is less
//! than `2^-860`, and the bound at least `2^-396`.
//!
//! *`f'(t)`* is a sum of 18 products of at most `2 A B C`, of factors off by `u` each: `36 x 5 u`
//! and at most 17 roundings of sums of at most `36 A B C`: `792 u`, where the code has `1024 u`. It
//! changes by at most `|f''| <= 6 x 6 x 2 x 2 A B C = 144 A B C` a step.

use crate::math::expansion;
use crate::math::real::{Num, Real};
use crate::math::vec3::{add, cross, dot, max_abs, scale};
use core::ops::{Add, Mul, Sub};

/// An unevaluated sum of a number and what rounding took away from it.
#[derive(Clone, Copy, Debug)]
pub struct Double {
    /// The sum, rounded.
    pub high: f64,
    /// The rest.
    pub low: f64,
}

impl Double {
    /// From a sum or product of [`expansion`] and its rest.
    pub fn of((high, low): (f64, f64)) -> Self {
        Self { high, low }
    }

    /// The greatest `f64` that is not above.
    fn rounded_down(self) -> f64 {
        if self.low < 0.0 { Real::next_down(self.high) } else { self.high }
    }
}

impl Add for Double {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, below) = expansion::sum(self.high, other.high);
        let (low, lowest) = expansion::sum(self.low, other.low);
        let (high, below) = expansion::sum(high, below + low);
        Self::of(expansion::sum(high, below + lowest))
    }
}

impl Sub for Double {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + Self { high: -other.high, low: -other.low }
    }
}

impl Mul for Double {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (high, below) = expansion::product(self.high, other.high);
        let across = self.high * other.low + self.low * other.high;
        Self::of(expansion::sum(high, below + across))
    }
}

type Pair3 = [Double; 3];

/// A vector of the step: at its start, and what it travels.
struct Path {
    start: Pair3,
    travel: Pair3,
    /// Bound of its components.
    size: f64,
}

impl Path {
    fn new(p: [[f64; 3]; 2], q: [[f64; 3]; 2]) -> Self {
        let at = |time: usize| three(|k| Double::of(expansion::sum(p[time][k], -q[time][k])));
        let (start, end) = (at(0), at(1));
        let travel = three(|k| end[k] - start[k]);
        let size = max_abs(high(start)).max(max_abs(high(end))) * (1.0 + 2.0 * f64::EPSILON);
        Self { start, travel, size }
    }

    fn at(&self, t: f64) -> Pair3 {
        let t = Double { high: t, low: 0.0 };
        three(|k| self.start[k] + self.travel[k] * t)
    }
}

fn high(x: Pair3) -> [f64; 3] {
    three(|k| x[k].high)
}

/// The same of `0`, `1` and `2`, written out: `map` of an array is not inlined everywhere.
#[inline(always)]
fn three<T>(of: impl Fn(usize) -> T) -> [T; 3] {
    [of(0), of(1), of(2)]
}

fn triple(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    dot(a, cross(b, c))
}

/// `f` at a time, almost exactly.
fn value([a, b, c]: &[Pair3; 3]) -> f64 {
    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    (a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1)).high
}

/// The only zero of `f` in an interval that has one: at `t + correction`, off by at most `off`.
pub struct Zero {
    /// A time of the interval.
    pub t: f64,
    /// From there to the zero.
    pub correction: f64,
    /// Bound of the error.
    pub off: f64,
}

/// The time of the only contact in `[lo, hi]`, in which there is one, rounded down; `None` if this
/// arithmetic does not tell. `vectors`: `p` and `q` at both ends of the step, whose differences are
/// `a b c`.
pub fn rounded_down(vectors: [[[[f64; 3]; 2]; 2]; 3], [lo, hi]: [f64; 2]) -> Option<f64> {
    let Zero { t, correction, off } = zero(vectors, [lo, hi])?;
    let from_t = |x: f64| Double::of(expansion::sum(t, x)).rounded_down();
    let found = from_t(Real::next_down(correction - off));
    let same = found == from_t(Real::next_up(correction + off));
    (same && found >= lo).then_some(found)
}

/// The same, not rounded.
pub fn zero(vectors: [[[[f64; 3]; 2]; 2]; 3], [lo, hi]: [f64; 2]) -> Option<Zero> {
    let paths = three(|i| Path::new(vectors[i][0], vectors[i][1]));
    let all = paths[0].size * paths[1].size * paths[2].size;
    let fine = |x: f64| (1.0 / LARGE..=LARGE).contains(&x);
    if !paths.iter().all(|path| fine(path.size)) {
        return None;
    }
    let travel = three(|i| high(paths[i].travel));
    let slope = |[a, b, c]: [[f64; 3]; 3]| {
        let [da, db, dc] = travel;
        triple(da, b, c) + triple(a, db, c) + triple(a, b, dc)
    };
    let slope_error = |width: f64| all * (144.0 * width + 1024.0 * f64::UNIT) * 1.001;

    // Two Newton steps bring `t` so near the zero that an inexact slope hardly matters.
    let mut t = lo;
    for _ in 0..2 {
        let x = three(|i| add(high(paths[i].start), scale(travel[i], t)));
        let next = t - triple(x[0], x[1], x[2]) / slope(x);
        if !(lo <= next && next <= hi) {
            break;
        }
        t = next;
    }
    let x = three(|i| paths[i].at(t));
    let (f, slope) = (value(&x), slope(three(|i| high(x[i]))));
    let f_error = all * (1024.0 * f64::UNIT * f64::UNIT);
    let least = slope.abs() - slope_error(hi - lo);
    if !(least > 0.0) {
        return None;
    }
    let width = (f.abs() + f_error) / least * 1.001;
    let near = slope_error(width);
    // The better of two lower bounds of the slope: over the whole interval, and near `t`.
    let least = (slope.abs() - near).max(least);
    let correction = -f / slope;
    let off = (correction.abs() * (near / least + 16.0 * f64::UNIT) + f_error / least) * 1.001;
    Some(Zero { t, correction, off })
}

/// Sizes of vectors are between this, 2^100, and its inverse.
const LARGE: f64 = 1.267_650_600_228_229_4e30;

#[cfg(test)]
mod tests {
    use super::*;

    /// Of `f = a . (b x c)` with `A = B = C = 1`, which goes straight from `-way / 2` to `way / 2`:
    /// what is found of its zero at 1/2 by a contact in `[1/2, 1/2 + width]`.
    fn zero_of(way: f64, width: f64) -> Option<Zero> {
        let still = |x: [f64; 3]| [[x; 2], [[0.0; 3]; 2]];
        let a = [[[1.0, 0.0, -0.5 * way], [1.0, 0.0, 0.5 * way]], [[0.0; 3]; 2]];
        zero([a, still([1.0, 0.0, 0.0]), still([0.0, 1.0, 0.0])], [0.5, 0.5 + width])
    }

    /// Every bound is at least what its derivation needs.
    #[test]
    fn bounds_are_at_least_as_derived() {
        let u = f64::UNIT;
        // A derivative off by 792 u may be 0.
        assert!(zero_of(792.0 * u, 0.0).is_none() && zero_of(1100.0 * u, 0.0).is_some());
        // One of 2 may be 0 within 2 / 144.
        assert!(zero_of(2.0, 1.0 / 72.0).is_none() && zero_of(2.0, 1.0 / 80.0).is_some());
        let found = zero_of(2.0, 0.0).expect("a derivative of 2");
        assert_eq!((found.t, found.correction), (0.5, 0.0));
        let least = 546.0 * u * u / 2.0;
        assert!(found.off >= least && found.off < 2.0 * least, "{:e}, {least:e}", found.off);
    }
}
