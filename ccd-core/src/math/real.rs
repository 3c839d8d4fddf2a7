//! Number types that one body of geometry is written over: `f32`, `f64`, and SIMD lanes of them.

use super::f64_bits;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// The answer of a comparison: one Boolean, or one a lane.
pub trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> {
    /// [`Mask::bits`] if it is true in every lane.
    const ALL: u32;
    /// Bit `i`: the answer in lane `i`.
    fn bits(self) -> u32;
    /// Whether it is true in every lane.
    #[inline(always)]
    fn all(self) -> bool {
        self.bits() == Self::ALL
    }
    /// Whether it is true in some lane.
    #[inline(always)]
    fn any(self) -> bool {
        self.bits() != 0
    }
}

impl Mask for bool {
    const ALL: u32 = 1;
    #[inline(always)]
    fn bits(self) -> u32 {
        self as u32
    }
    #[inline(always)]
    fn all(self) -> bool {
        self
    }
    #[inline(always)]
    fn any(self) -> bool {
        self
    }
}

/// A bit a lane.
impl Mask for u16 {
    const ALL: u32 = 0xffff;
    #[inline(always)]
    fn bits(self) -> u32 {
        self as u32
    }
}

/// A number, or several side by side, with the operations that a branch-free filter needs.
///
/// Every operation rounds as IEEE 754 says or no worse than one unit roundoff per operation; a
/// result that underflows may be flushed to zero. Nothing is assumed about NaN except that
/// comparisons with it are false.
///
/// ```
/// use ccd_core::Num;
///
/// /// One number, or as many as there are lanes.
/// fn square<N: Num>(x: N) -> N {
///     x * x
/// }
/// assert_eq!((square(3.0f32), square(3.0f64)), (9.0, 9.0));
/// ```
pub trait Num:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Unit roundoff: half the distance from 1 to the next number (2^-24 or 2^-53).
    const UNIT: Self;
    /// Smallest positive normal number; flushing a result to zero loses less than this.
    const MIN_NORMAL: Self;
    /// The answer of a comparison.
    type Mask: Mask;
    /// Whether the number is greater than the other; false if either is NaN. Every rejection ends
    /// in this.
    fn gt(self, other: Self) -> Self::Mask;
    /// `x` in every lane; exact. The constants of the geometry are `f32`, because a shader without
    /// `f64` cannot even name one.
    fn splat(x: f32) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The greater of two numbers; either one if one of them is NaN.
    fn max(self, other: Self) -> Self;
    /// The smaller of two numbers; either one if one of them is NaN.
    fn min(self, other: Self) -> Self;
}

/// A single number that can be compared and divided: `f32` or `f64`.
///
/// ```
/// use ccd::Real;
///
/// // A cast rounds to the nearest `f32`, these to either side.
/// let x = 0.1f64;
/// assert!(x.round_down() < x.round_up());
/// assert!((x.round_down() as f64) < x && (x.round_up() as f64) > x);
/// ```
pub trait Real:
    Num + PartialOrd + core::fmt::Debug + Into<f64> + bytemuck::Pod + Send + Sync
{
    /// Exact for `f32` and `f64`.
    fn to_f64(self) -> f64;
    /// The number nearest to `x`.
    fn from_f64(x: f64) -> Self;
    /// The greatest `f32` that is not above the number.
    fn round_down(self) -> f32;
    /// The smallest `f32` that is not below the number.
    fn round_up(self) -> f32;
    /// An upper bound of the square root, at most a few units in the last place above it; 0 for
    /// `x <= 0`.
    fn sqrt_up(self) -> Self;
    /// The next number towards positive infinity; infinity stays.
    fn next_up(self) -> Self;
    /// The next number towards negative infinity; negative infinity stays.
    fn next_down(self) -> Self;
    /// Whether the number is neither infinite nor NaN, by its bits (some devices fold `x != x`
    /// away).
    fn is_finite_number(self) -> bool;
    /// The power of two that brings a positive normal number to `[1, 2)`; to `[2, 4)` the greatest,
    /// whose inverse is tiny.
    fn to_unit(self) -> Self;
}

/// Bits of a number as a signed integer of the same order, and the way back.
macro_rules! ordered {
    ($int:ty, $bits:expr) => {{
        let bits = $bits as $int;
        bits ^ (bits >> (<$int>::BITS - 1)) & <$int>::MAX
    }};
}

macro_rules! real {
    ($t:ty, $int:ty, $unit:expr, $guess:expr, $exponent:expr, $enclosure:expr) => {
        impl Num for $t {
            const UNIT: Self = $unit;
            const MIN_NORMAL: Self = <$t>::MIN_POSITIVE;
            type Mask = bool;
            #[inline(always)]
            fn gt(self, other: Self) -> bool {
                self > other
            }
            #[inline(always)]
            fn splat(x: f32) -> Self {
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
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                x as $t
            }
            #[inline(always)]
            fn round_down(self) -> f32 {
                $enclosure(self).0
            }
            #[inline(always)]
            fn round_up(self) -> f32 {
                $enclosure(self).1
            }
            fn sqrt_up(self) -> Self {
                // Heron's iteration: every iterate after the first is at or above the root, up to
                // rounding.
                if self <= Self::MIN_POSITIVE {
                    return if self > 0.0 { $guess(Self::MIN_POSITIVE) * 2.0 } else { 0.0 };
                }
                let mut y: Self = $guess(self);
                for _ in 0..5 {
                    y = 0.5 * (y + self / y);
                }
                // A quotient may be off by 2.5 units in the last place, five of roundoff, and half
                // of that is in the mean.
                y * (1.0 + 8.0 * Self::UNIT)
            }
            #[inline]
            fn next_up(self) -> Self {
                // By bits, because devices have no such instruction: bits of numbers of one sign
                // are in the order of the numbers.
                if !cfg!(target_arch = "spirv") {
                    // Without branches, so that compilers make vectors of it, and arithmetic, which
                    // may flush. Beyond a negative zero is what is beyond a positive one.
                    let key = ordered!($int, self.to_bits());
                    let key = key + 1 + (key == -1) as $int;
                    let next = <$t>::from_bits(ordered!($int, key) as _);
                    return if self < <$t>::INFINITY { next } else { self };
                }
                let bits = self.to_bits();
                if bits & $exponent == $exponent && !(self < 0.0) {
                    self
                } else if self > 0.0 {
                    <$t>::from_bits(bits + 1)
                } else if self < 0.0 {
                    <$t>::from_bits(bits - 1)
                } else {
                    <$t>::from_bits(1)
                }
            }
            #[inline]
            fn next_down(self) -> Self {
                -Real::next_up(-self)
            }
            #[inline]
            fn is_finite_number(self) -> bool {
                self.to_bits() & $exponent != $exponent
            }
            #[inline]
            fn to_unit(self) -> Self {
                // From 2^e to 2^-e: exponents are stored with that of 1 added.
                let (one, least) = ((1.0 as $t).to_bits(), <$t>::MIN_POSITIVE.to_bits());
                let inverse = one + one - (self.to_bits() & $exponent);
                <$t>::from_bits(if inverse > least { inverse } else { least })
            }
        }
    };
}

/// Halves the exponent of `x` by its bits: within a factor 1.1 of the square root of a normal
/// number.
#[inline]
fn sqrt_guess_f32(x: f32) -> f32 {
    f32::from_bits((x.to_bits() >> 1) + 0x1fbb_4f2e)
}

/// Halves the exponent of `x` by its bits: within a factor 1.1 of the square root of a normal
/// number.
#[inline]
fn sqrt_guess_f64(x: f64) -> f64 {
    // Not shifted, because translators to WGSL get shifts of 64 bits wrong.
    f64::from_bits(x.to_bits() / 2 + 0x1ff7_69e5_c000_0000)
}

/// The greatest `f32` that is not above `x` and the smallest that is not below.
#[inline(always)]
fn enclosure(x: f64) -> (f32, f32) {
    if cfg!(target_arch = "spirv") {
        return f64_bits::enclosure(x);
    }
    // Without branches, of which a processor would foresee every other one. A zero has the sign of
    // `x`, so the next number beyond it is on the same side.
    let y = x as f32;
    let key = ordered!(i32, y.to_bits());
    let [down, up] = [(y as f64) > x, (y as f64) < x].map(i32::from);
    let number = |key: i32| f32::from_bits(ordered!(i32, key) as u32);
    (number(key - down), number(key + up))
}

real!(f32, i32, 5.960_464_5e-8, sqrt_guess_f32, 0x7f80_0000, |x| (x, x));
real!(f64, i64, 1.110_223_024_625_156_5e-16, sqrt_guess_f64, 0x7ff0_0000_0000_0000, enclosure);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn check_sqrt<R: Real>(x: R, slack: f64) {
        let (got, want) = (x.sqrt_up().to_f64(), x.to_f64().sqrt());
        assert!(got >= want && got <= want * (1.0 + slack), "sqrt_up({x:?}) = {got}, root {want}");
    }

    /// Of squares the iteration ends in the root, so that what is added to it is seen. It must be
    /// `2.5 u` for a quotient that is off by `5 u`, and `u` each for a sum and a product.
    fn check_added<R: Real>() {
        for root in [0.5, 1.0, 2.0, 4.0f32] {
            let got = R::splat(root * root).sqrt_up().to_f64();
            let least = f64::from(root) * (1.0 + 4.5 * R::UNIT.to_f64());
            assert!(got >= least, "{got} for {root}");
        }
    }

    #[test]
    fn neighbours_are_those_of_the_standard_library() {
        let mut random = Random::new(1);
        for i in 0..20_000u64 {
            let x = random.bits();
            let narrow = f32::from_bits(x);
            let wide = f64::from_bits((x as u64) << 32 | i);
            if !narrow.is_finite() || !wide.is_finite() {
                continue;
            }
            assert_eq!(Real::next_up(narrow), f32::next_up(narrow), "{narrow:e}");
            assert_eq!(Real::next_down(narrow), f32::next_down(narrow), "{narrow:e}");
            assert_eq!(Real::next_up(wide), f64::next_up(wide), "{wide:e}");
            assert_eq!(Real::next_down(wide), f64::next_down(wide), "{wide:e}");
        }
        for x in [0.0, -0.0, f32::MAX, f32::MIN, f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!(
                (Real::next_up(x), Real::next_down(x)),
                (f32::next_up(x), f32::next_down(x)),
                "{x:e}"
            );
        }
        assert!(Real::next_up(f64::NAN).is_nan());
        assert!(
            ![f32::NAN, f32::INFINITY, f32::NEG_INFINITY].into_iter().any(Real::is_finite_number)
                && f32::MAX.is_finite_number()
        );
    }

    #[test]
    fn units_are_powers_of_two() {
        for e in -126..=126 {
            for m in [1.0, 1.3, f32::from_bits(0x3fff_ffff)] {
                let x = m * 2f32.powi(e);
                assert_eq!(x.to_unit(), 2f32.powi(-e), "{x:e}");
                assert_eq!((x as f64 * 2f64.powi(7 * e)).to_unit(), 2f64.powi(-8 * e), "{x:e}");
            }
        }
        assert_eq!(
            (f32::MAX.to_unit(), f64::MAX.to_unit()),
            (f32::MIN_POSITIVE, f64::MIN_POSITIVE)
        );
    }

    #[test]
    fn sqrt_is_a_tight_upper_bound() {
        for e in -120..120 {
            for m in [1.0f32, 1.1, 1.9, 2.0, 3.7] {
                check_sqrt(m * 2f32.powi(e), 1e-6);
                check_sqrt(m as f64 * 2f64.powi(4 * e), 2e-15);
            }
        }
        check_added::<f32>();
        check_added::<f64>();
        assert_eq!(0f64.sqrt_up(), 0.0);
        assert_eq!((-1f32).sqrt_up(), 0.0);
    }
}
