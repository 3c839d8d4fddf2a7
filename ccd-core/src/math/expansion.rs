//! Exact sums and products of `f64`: what decides where rounding could not, at the cost of
//! microseconds.
//!
//! A number is a sum of `f64` that do not overlap, least first [Shewchuk 1997]. Sums and products
//! are exact as long as nothing overflows or vanishes: [`is_safe`] says of which numbers products
//! of up to four are.

use alloc::vec::Vec;
use core::cmp::Ordering;

/// Greatest exponent of what is calculated with: products of four differences stay below
/// 2^(4 x 201), and the last bits of their factors are at least 2^(-200 - 53).
const MAX_EXPONENT: f64 = 1.606_938_044_258_990_3e60;

/// Whether products of up to four differences of such numbers are exact: zero, or between 2^-200
/// and 2^200.
pub fn is_safe(x: f64) -> bool {
    x == 0.0 || x.abs() <= MAX_EXPONENT && x.abs() >= 1.0 / MAX_EXPONENT
}

/// A sum of `f64` that is not rounded.
#[derive(Clone, Debug, Default)]
pub struct Expansion(Vec<f64>);

impl Expansion {
    /// One number.
    pub fn of(x: f64) -> Self {
        Self(if x == 0.0 { Vec::new() } else { [x].to_vec() })
    }

    /// `a - b`
    pub fn difference(a: f64, b: f64) -> Self {
        Self::of(a).plus(&Self::of(-b))
    }

    /// The sum of both.
    pub fn plus(mut self, other: &Self) -> Self {
        other.0.iter().for_each(|&x| self.add(x));
        self
    }

    /// What is left when the other is taken away.
    pub fn minus(mut self, other: &Self) -> Self {
        other.0.iter().for_each(|&x| self.add(-x));
        self
    }

    /// The product of both.
    pub fn times(&self, other: &Self) -> Self {
        let mut out = Self::default();
        for &a in &self.0 {
            for &b in &other.0 {
                let (high, low) = product(a, b);
                out.add(low);
                out.add(high);
            }
        }
        out
    }

    /// How it compares with zero: the sign of its greatest part.
    pub fn sign(&self) -> Ordering {
        self.0
            .last()
            .map_or(Ordering::Equal, |x| if *x > 0.0 { Ordering::Greater } else { Ordering::Less })
    }

    /// The number itself, off by at most 4 units of roundoff: of parts that rounding to the nearest
    /// leaves, each exceeds twice the sum of those below it.
    pub fn value(&self) -> f64 {
        self.0.iter().sum()
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds one number: Grow-Expansion, without the parts that become zero.
    fn add(&mut self, x: f64) {
        let mut carry = x;
        let mut kept = 0;
        for i in 0..self.0.len() {
            let (sum, rest) = sum(carry, self.0[i]);
            carry = sum;
            if rest != 0.0 {
                self.0[kept] = rest;
                kept += 1;
            }
        }
        self.0.truncate(kept);
        if carry != 0.0 {
            self.0.push(carry);
        }
    }
}

/// The rounded sum and what rounding took away.
pub fn sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// The rounded product and what rounding took away.
pub fn product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let ([a, a_low], [b, b_low]) = (halves(a), halves(b));
    (product, a_low * b_low - (product - a * b - a_low * b - a * b_low))
}

/// Two numbers of 26 bits each that make up `x`.
fn halves(x: f64) -> [f64; 2] {
    let far = x * 134_217_729.0;
    let high = far - (far - x);
    [high, x - high]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::real::Num;
    use crate::random::Random;
    use num_rational::BigRational;
    use num_traits::{FromPrimitive, Signed, Zero};
    use std::vec::Vec;

    fn exact(x: &Expansion) -> BigRational {
        let parts = x.0.iter().map(|&x| BigRational::from_f64(x).expect("finite"));
        parts.fold(BigRational::zero(), |sum, x| sum + x)
    }

    /// Sums of products of numbers of very different sizes, which cancel, against rationals.
    #[test]
    fn sums_and_products_are_not_rounded() {
        let mut random = Random::new(9);
        let mut next = || {
            let exponent = random.below(260) as i32 - 130;
            (random.unit() + random.unit() / (1 << 24) as f64 - 0.5) * 2f64.powi(exponent)
        };
        let mut cancelled = 0;
        for _ in 0..500 {
            let x: Vec<f64> = (0..8).map(|_| next()).collect();
            assert!(x.iter().all(|&x| is_safe(x)));
            let d = |i: usize, j: usize| Expansion::difference(x[i], x[j]);
            let [a, b, c, e] = [d(0, 1), d(2, 3), d(4, 5), d(6, 7)];
            let all = a.times(&b).times(&c.clone().minus(&e)).times(&a);
            let rational = |i: usize, j: usize| {
                let of = |x: f64| BigRational::from_f64(x).expect("finite");
                of(x[i]) - of(x[j])
            };
            let [p, q, r, s] = [rational(0, 1), rational(2, 3), rational(4, 5), rational(6, 7)];
            let want = &p * &q * (r - s) * &p;
            assert_eq!(exact(&all), want);
            assert_eq!(all.sign(), want.cmp(&BigRational::zero()));
            let off = (exact(&Expansion::of(all.value())) - &want).abs();
            assert!(off <= want.abs() * exact(&Expansion::of(4.0 * f64::UNIT)));
            cancelled += all.clone().minus(&all).is_zero() as usize;
            // A product that rounding would take for another.
            let (one, tiny) = (Expansion::of(1.0), Expansion::of(f64::EPSILON / 8.0));
            assert_eq!(one.clone().plus(&tiny).minus(&one).sign(), Ordering::Greater);
        }
        assert_eq!(cancelled, 500);
        assert!(is_safe(0.0) && !is_safe(1e-61) && !is_safe(1e61) && !is_safe(f64::NAN));
    }
}
