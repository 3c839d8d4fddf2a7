//! Numbers in double-double with a bound of how far off they are.

use super::vector::{Number, Vector};
use crate::math::expansion;
use crate::math::real::Num;
use core::ops::{Add, Mul, Sub};

/// An unevaluated sum of a number and what rounding took away from it.
#[derive(Clone, Copy, Debug)]
struct Double {
    high: f64,
    low: f64,
}

impl Double {
    /// From a sum or product of [`expansion`] and its rest.
    fn of((high, low): (f64, f64)) -> Self {
        Self { high, low }
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

/// A number and a bound of its error.
///
/// Sums of pairs are off by `3 u^2` of themselves and products by `7 u^2`, `u = 2^-53`
/// [Joldes 2017], but for what underflows, which is far less than [`UNDERFLOW`] a product. Nothing
/// here may overflow.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    value: Double,
    error: f64,
}

/// What underflow may add to the error of a product.
const UNDERFLOW: f64 = 1e-300;

impl Ball {
    /// `a + b`, exactly.
    pub fn sum(a: f64, b: f64) -> Self {
        Self { value: Double::of(expansion::sum(a, b)), error: 0.0 }
    }

    /// The same, off by at most `error` more.
    pub fn off_by(self, error: f64) -> Self {
        Self { error: self.error + error, ..self }
    }

    /// Rounded to the nearest, nearly.
    pub fn rounded(&self) -> f64 {
        self.value.high
    }

    /// Bound of the magnitude of the value, the error left out.
    fn size(&self) -> f64 {
        Num::abs(self.value.high) * (1.0 + f64::EPSILON)
    }

    /// The sign, if it is certain that it is this and not 0.
    pub fn sign(&self) -> Option<i32> {
        let sign = if self.value.high < 0.0 { -1 } else { 1 };
        (Num::abs(self.value.high) * (1.0 - f64::EPSILON) > self.error).then_some(sign)
    }

    /// Whether it is off by at most `2^-62` of `size`.
    pub fn is_tight(&self, size: f64) -> bool {
        self.error <= size * TIGHT
    }

    /// The quotient of two positive numbers that are tight, of each itself: to 0.51 units in the
    /// last place.
    pub fn quotient(&self, by: &Self) -> Option<f64> {
        let positive = |x: &Self| x.sign() == Some(1) && x.is_tight(x.value.high);
        if !(positive(self) && positive(by)) {
            return None;
        }
        let (p, q) = (self.value, by.value);
        let first = p.high / q.high;
        let (product, below) = expansion::product(first, q.high);
        let rest = (p.high - product) - below + (p.low - first * q.low);
        Some(first + rest / q.high)
    }

    /// Of a result that was rounded by `units u^2` of itself.
    fn result(value: Double, error: f64, units: f64) -> Self {
        let rounding = Num::abs(value.high) * (units * f64::UNIT * f64::UNIT);
        Self { value, error: (error + rounding) * (1.0 + 8.0 * f64::EPSILON) }
    }
}

/// `2^-62`.
const TIGHT: f64 = 2.168_404_344_971_009e-19;

impl Number for Ball {
    fn plus(&self, other: &Self) -> Self {
        Self::result(self.value + other.value, self.error + other.error, 4.0)
    }
    fn minus(&self, other: &Self) -> Self {
        Self::result(self.value - other.value, self.error + other.error, 4.0)
    }
    fn times(&self, other: &Self) -> Self {
        let error = self.size() * other.error + (other.size() + other.error) * self.error;
        Self::result(self.value * other.value, error + UNDERFLOW, 8.0)
    }
}

/// A point that moves from one place to another, at a time.
pub fn at(t0: &[f64; 3], t1: &[f64; 3], time: &Ball) -> Vector<Ball> {
    [0, 1, 2].map(|k| Ball::sum(t0[k], 0.0).plus(&Ball::sum(t1[k], -t0[k]).times(time)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_rational::BigRational;
    use num_traits::{Signed, ToPrimitive};

    fn exact(x: Double) -> BigRational {
        let of = |x: f64| BigRational::from_float(x).expect("a finite number");
        of(x.high) + of(x.low)
    }

    /// A pair, the second of which is a multiple of a power of two.
    fn pair(high: f64, low: f64, places: i32) -> Ball {
        Ball::sum(high, low * 2f64.powi(-places))
    }

    /// Operands whose sum is off by 2.25 u^2 of itself, and whose product is off by 4.99 u^2: the
    /// greatest errors known [Joldes 2017].
    #[test]
    fn the_greatest_errors_known_are_within_their_bounds() {
        let check = |got: Ball, want: BigRational, known: f64| {
            let unit = got.rounded().abs() * f64::UNIT * f64::UNIT;
            let off = (exact(got.value) - want).abs().to_f64().expect("a number");
            let (off, bound) = (off / unit, got.error / unit);
            assert!(off > known && off <= bound, "off by {off} u^2, bound {bound} u^2");
        };
        let x = pair(9_007_199_254_740_991.0, -9_007_199_254_740_991.0, 54);
        let y = pair(-4_503_599_627_370_493.5, -9_007_199_254_740_991.0, 56);
        check(x.plus(&y), exact(x.value) + exact(y.value), 2.24);
        let minus_y = Ball { value: Double::of((-y.value.high, -y.value.low)), error: 0.0 };
        check(x.minus(&minus_y), exact(x.value) + exact(y.value), 2.24);
        let x = pair(4_508_231_565_242_345.0, -9_007_199_254_524_053.0, 54);
        let y = pair(4_504_969_740_576_150.0, -4_503_599_627_273_753.0, 53);
        check(x.times(&y), exact(x.value) * exact(y.value), 4.98);
    }
}
