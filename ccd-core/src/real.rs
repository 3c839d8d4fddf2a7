//! Number types that one body of geometry is written over: `f32`, `f64`, and SIMD lanes of them.

use core::ops::{Add, Mul, Neg, Sub};

/// A number, or several side by side, with the operations that a branch-free filter needs.
///
/// Every operation rounds as IEEE 754 says or no worse than one unit roundoff per operation; a result that underflows
/// may be flushed to zero. Nothing is assumed about NaN except that comparisons with it are false.
pub trait Num: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self> {
    /// Unit roundoff: half the distance from 1 to the next number (2^-24 or 2^-53).
    const UNIT: f64;
    /// Smallest positive normal number; flushing a result to zero loses less than this.
    const MIN_NORMAL: f64;
    /// The number nearest to `x`, in every lane.
    fn splat(x: f64) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The greater of two numbers; either one if one of them is NaN.
    fn max(self, other: Self) -> Self;
    /// The smaller of two numbers; either one if one of them is NaN.
    fn min(self, other: Self) -> Self;
}

/// A single number that can be compared and divided: `f32` or `f64`.
pub trait Real: Num + PartialOrd + core::ops::Div<Output = Self> + core::fmt::Debug + Into<f64> {
    /// Exact for `f32` and `f64`.
    fn to_f64(self) -> f64;
    /// An upper bound of the square root, at most a few units in the last place above it; 0 for `x <= 0`.
    fn sqrt_up(self) -> Self;
    /// The next number towards positive infinity; infinity stays.
    fn next_up(self) -> Self;
    /// The next number towards negative infinity; negative infinity stays.
    fn next_down(self) -> Self;
    /// Whether the number is neither infinite nor NaN, by its bits (some devices fold `x != x` away).
    fn is_finite_number(self) -> bool;
}

macro_rules! real {
    ($t:ty, $unit:expr, $guess:expr) => {
        impl Num for $t {
            const UNIT: f64 = $unit;
            const MIN_NORMAL: f64 = <$t>::MIN_POSITIVE as f64;
            #[inline(always)]
            fn splat(x: f64) -> Self {
                x as $t
            }
            #[inline(always)]
            fn abs(self) -> Self {
                if self < 0.0 { -self } else { self }
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                if self > other { self } else { other }
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                if self < other { self } else { other }
            }
        }

        impl Real for $t {
            #[inline(always)]
            fn to_f64(self) -> f64 {
                self as f64
            }
            fn sqrt_up(self) -> Self {
                // Heron's iteration: every iterate after the first is at or above the root, up to rounding.
                if self <= Self::MIN_POSITIVE {
                    return if self > 0.0 { $guess(Self::MIN_POSITIVE) * 2.0 } else { 0.0 };
                }
                let mut y: Self = $guess(self);
                for _ in 0..5 {
                    y = 0.5 * (y + self / y);
                }
                y * (1.0 + 4.0 * Self::UNIT as Self)
            }
            #[inline]
            fn next_up(self) -> Self {
                <$t>::next_up(self)
            }
            #[inline]
            fn next_down(self) -> Self {
                <$t>::next_down(self)
            }
            #[inline]
            fn is_finite_number(self) -> bool {
                <$t>::is_finite(self)
            }
        }
    };
}

/// Halves the exponent of `x` by its bits: within a factor 1.1 of the square root of a normal number.
#[inline]
fn sqrt_guess_f32(x: f32) -> f32 {
    f32::from_bits((x.to_bits() >> 1) + 0x1fbb_4f2e)
}

/// Halves the exponent of `x` by its bits: within a factor 1.1 of the square root of a normal number.
#[inline]
fn sqrt_guess_f64(x: f64) -> f64 {
    f64::from_bits((x.to_bits() >> 1) + 0x1ff7_69e5_c000_0000)
}

real!(f32, 5.960_464_477_539_063e-8, sqrt_guess_f32);
real!(f64, 1.110_223_024_625_156_5e-16, sqrt_guess_f64);

#[cfg(test)]
mod tests {
    use super::*;

    fn check_sqrt<R: Real>(x: R, slack: f64) {
        let (got, want) = (x.sqrt_up().to_f64(), x.to_f64().sqrt());
        assert!(got >= want && got <= want * (1.0 + slack), "sqrt_up({x:?}) = {got}, root {want}");
    }

    #[test]
    fn sqrt_is_a_tight_upper_bound() {
        for e in -120..120 {
            for m in [1.0f32, 1.1, 1.9, 2.0, 3.7] {
                check_sqrt(m * 2f32.powi(e), 1e-6);
                check_sqrt(m as f64 * 2f64.powi(4 * e), 2e-15);
            }
        }
        assert_eq!(0f64.sqrt_up(), 0.0);
        assert_eq!((-1f32).sqrt_up(), 0.0);
    }
}
