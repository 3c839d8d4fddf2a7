//! The time of a certain contact to the last bit, by one evaluation in twice the digits of `f64`.
//!
//! Over `[lo, hi]`, in which a contact is certain, `f = a . (b x c)` has one zero if its derivative
//! has none, and the contact is there. From `t` in the interval, by the mean value theorem, it is
//! at `t - f(t) / f'(x)` with some `x` between them. With `f(t)` almost exact and `f'` in bounds
//! that is an interval far narrower than a unit in the last place. Nearly always both of its ends
//! round down to the same `f64`; if not, the answer is `None`, and integers decide.
//!
//! # The bounds
//! Let `u = 2^-53`, and `A B C` bound the components of `a b c` at both ends, hence at all times.
//! Everything is a number and what rounding took away from it, its rest; terms of higher order than
//! `u^2` are left out.
//!
//! *A component at `t`.* Differences of coordinates are exact. The rest of what it travels is off
//! by `6 u^2 A` and at most `4 u A`. At `t`, four roundings of the rest are off by `20 u^2 A` more:
//! in all `26 u^2 A`. Six products of three such numbers: `6 x 3 x 26 u^2 = 468 u^2 A B C`.
//!
//! *`f(t)`.* A component of `b x c`: its two products and their difference are exact but for a rest
//! off by `6 u^2 B C`; products with a rest add `12 u^2`, their sum `8 u^2`, and products of two
//! rests, left out, `2 u^2`: `28 u^2`, with a rest of at most `8 u B C`. Its product with a
//! component of `a`: `8 u^2` and `2 u^2` of products with a rest, `10 u^2` and `12 u^2` of their
//! sums, `8 u^2` of the product of two rests, left out. Three of these: `3 x (28 + 40) u^2 = 204
//! u^2 A B C`. Four sums of rests, of at most `24 u`, `36 u`, `40 u` and `46 u`: `146 u^2`. With
//! the components `818 u^2 A B C`, where the code has `1024 u^2`. With `A`, `B` and `C` from
//! `2^-100` to `2^100`, what underflows is less than `2^-860`, and the bound at least `2^-396`.
//!
//! *`f'(t)`* is a sum of 18 products of at most `2 A B C`, of factors off by `u` each, what travels
//! by `2 u`, because its rest is left out: `36 x 6 u` and at most 17 roundings of sums of at most
//! `36 A B C`: `828 u`, where the code has `1024 u`. It changes by at most `|f''| <= 6 x 6 x 2 x 2
//! A B C = 144 A B C` a step.

use crate::math::expansion::{product, sum};
use crate::math::real::{Num, Real};
use crate::math::vec3::{add, cross, dot, max_abs, scale};

/// Three numbers, and what rounding took away from them.
#[derive(Clone, Copy)]
struct Vector {
    high: [f64; 3],
    rest: [f64; 3],
}

impl Vector {
    /// Of components with their rests.
    #[inline(always)]
    fn of([x, y, z]: [(f64, f64); 3]) -> Self {
        Self { high: [x.0, y.0, z.0], rest: [x.1, y.1, z.1] }
    }
}

/// A vector of the step: at its start, and what it travels.
struct Path {
    start: Vector,
    travel: Vector,
    /// Bound of its components.
    size: f64,
}

impl Path {
    /// Of `p - q`, both at both ends.
    #[inline(always)]
    fn new(p: [[f64; 3]; 2], q: [[f64; 3]; 2]) -> Self {
        let at = |time: usize| Vector::of(three(|k| sum(p[time][k], -q[time][k])));
        let (start, end) = (at(0), at(1));
        let travel = Vector::of(three(|k| {
            let (high, rest) = sum(end.high[k], -start.high[k]);
            (high, rest + (end.rest[k] - start.rest[k]))
        }));
        let size = max_abs(start.high).max(max_abs(end.high)) * (1.0 + 2.0 * f64::EPSILON);
        Self { start, travel, size }
    }

    #[inline(always)]
    fn at(&self, t: f64) -> Vector {
        let Self { start, travel, .. } = self;
        Vector::of(three(|k| {
            let (way, below) = product(travel.high[k], t);
            let (high, rest) = sum(start.high[k], way);
            sum(high, (rest + below) + (start.rest[k] + travel.rest[k] * t))
        }))
    }
}

/// The same of `0`, `1` and `2`, written out: `map` of an array is not inlined everywhere.
#[inline(always)]
fn three<T>(of: impl Fn(usize) -> T) -> [T; 3] {
    [of(0), of(1), of(2)]
}

/// `f` at a time, almost exactly.
#[inline(always)]
fn value([a, b, c]: &[Vector; 3]) -> f64 {
    let term = |k: usize, i: usize, j: usize| {
        let (p, p_rest) = product(b.high[i], c.high[j]);
        let (q, q_rest) = product(b.high[j], c.high[i]);
        let (minor, rest) = sum(p, -q);
        let across = (b.high[i] * c.rest[j] + b.rest[i] * c.high[j])
            - (b.high[j] * c.rest[i] + b.rest[j] * c.high[i]);
        let minor_rest = (rest + (p_rest - q_rest)) + across;
        let (term, rest) = product(a.high[k], minor);
        (term, (a.high[k] * minor_rest + a.rest[k] * minor) + rest)
    };
    let [x, y, z] = [term(0, 1, 2), term(1, 2, 0), term(2, 0, 1)];
    let (xy, first) = sum(x.0, y.0);
    let (all, second) = sum(xy, z.0);
    all + (((x.1 + y.1 + z.1) + first) + second)
}

/// Where the zero of `f` in an interval is, if there is one: at `t + correction`, off by at most
/// `off`. There are no two.
pub struct Zero {
    /// A time of the interval.
    pub t: f64,
    /// From there to the zero.
    pub correction: f64,
    /// Bound of the error.
    pub off: f64,
    /// Whether `f` rises over the interval; else it falls.
    pub rises: bool,
}

impl Zero {
    /// Whether the interval, of neighbours, has it; `None` if that is not certain.
    pub fn is_between(&self, [lo, hi]: [f64; 2]) -> Option<bool> {
        let [from, to] = [lo - self.t, hi - self.t];
        let first = Real::next_down(self.correction - self.off);
        let last = Real::next_up(self.correction + self.off);
        match (from <= first && last <= to, last < from || to < first) {
            (true, _) => Some(true),
            (_, true) => Some(false),
            _ => None,
        }
    }
}

/// The time of the only contact in `[lo, hi]`, in which there is one, rounded down; `None` if this
/// arithmetic does not tell. `vectors`: `p` and `q` at both ends of the step, whose differences are
/// `a b c`.
pub fn rounded_down(vectors: [[[[f64; 3]; 2]; 2]; 3], [lo, hi]: [f64; 2]) -> Option<f64> {
    let Zero { t, correction, off, .. } = zero(vectors, [lo, hi])?;
    let from_t = |x: f64| {
        let (time, rest) = sum(t, x);
        if rest < 0.0 { Real::next_down(time) } else { time }
    };
    let found = from_t(Real::next_down(correction - off));
    let same = found == from_t(Real::next_up(correction + off));
    (same && lo <= found && found <= hi).then_some(found)
}

/// The same, not rounded.
pub fn zero(vectors: [[[[f64; 3]; 2]; 2]; 3], [lo, hi]: [f64; 2]) -> Option<Zero> {
    let paths = three(|i| Path::new(vectors[i][0], vectors[i][1]));
    let all = paths[0].size * paths[1].size * paths[2].size;
    let fine = |x: f64| 1.0 / LARGE <= x && x <= LARGE;
    if !(fine(paths[0].size) && fine(paths[1].size) && fine(paths[2].size)) {
        return None;
    }
    let [da, db, dc] = three(|i| paths[i].travel.high);
    let slope = |[a, b, c]: [[f64; 3]; 3], b_c: [f64; 3]| {
        dot(da, b_c) + dot(db, cross(c, a)) + dot(dc, cross(a, b))
    };
    let slope_error = |width: f64| all * (144.0 * width + 1024.0 * f64::UNIT) * 1.001;

    // Two Newton steps bring `t` so near the zero that an inexact slope hardly matters.
    let mut t = lo;
    for _ in 0..2 {
        let x = three(|i| add(paths[i].start.high, scale(paths[i].travel.high, t)));
        let b_c = cross(x[1], x[2]);
        let next = t - dot(x[0], b_c) / slope(x, b_c);
        if !(lo <= next && next <= hi) {
            break;
        }
        t = next;
    }
    let x = three(|i| paths[i].at(t));
    let [a, b, c] = three(|i| x[i].high);
    let (f, slope) = (value(&x), slope([a, b, c], cross(b, c)));
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
    Some(Zero { t, correction, off, rises: slope > 0.0 })
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
        // A derivative off by 828 u may be 0.
        assert!(zero_of(828.0 * u, 0.0).is_none() && zero_of(1100.0 * u, 0.0).is_some());
        // One of 2 may be 0 within 2 / 144.
        assert!(zero_of(2.0, 1.0 / 72.0).is_none() && zero_of(2.0, 1.0 / 80.0).is_some());
        let found = zero_of(2.0, 0.0).expect("a derivative of 2");
        assert_eq!((found.t, found.correction), (0.5, 0.0));
        let least = 818.0 * u * u / 2.0;
        assert!(found.off >= least && found.off < 2.0 * least, "{:e}, {least:e}", found.off);
    }
}
