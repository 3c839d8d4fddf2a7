//! Numbers in fixed point by 32-bit integers alone: what a device without `f64` computes with where
//! `f32` is too coarse.
//!
//! Integers are the same on every device. Pairs of `f32` are not: where a compiler may reassociate
//! sums (Metal does), what the second holds is 0.

/// A number of `[-2, 2)` as a multiple of 2^-62, two's complement in two words.
///
/// Sums wrap around; products are rounded down. `u` below is 2^-62.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Q62 {
    hi: u32,
    lo: u32,
}

impl Q62 {
    /// 0.
    pub const ZERO: Self = Self { hi: 0, lo: 0 };

    /// `n u`.
    pub const fn of_units(n: u32) -> Self {
        Self { hi: 0, lo: n }
    }

    /// The `f64` of these bits, low word first, in a unit of 2^`exponent` times 4, that is
    /// `x / 2^exponent / 4`, cut towards 0 to a multiple of `u`; modulo 4, so that differences
    /// below 2 are right however far from 0 their operands are. `x`: finite; a subnormal one counts
    /// in full, for units can be as small as `f64` has them.
    #[inline(never)]
    pub fn of([lo, hi]: [u32; 2], exponent: i32) -> Self {
        let biased = (hi >> 20) & 0x7ff;
        // x = m 2^(biased - 1075), in units of 2^(exponent - 60). A subnormal number has no
        // leading one, and the power of the least normal ones.
        let leading = if biased == 0 { 0 } else { 0x10_0000 };
        let m = Self { hi: (hi & 0xf_ffff) | leading, lo };
        let shift = biased.max(1) as i32 - 1015 - exponent;
        let up = shift as u32 % 32;
        let magnitude = if shift >= 64 || shift <= -53 {
            Self::ZERO
        } else if shift >= 32 {
            Self { hi: m.lo << up, lo: 0 }
        } else if shift >= 0 {
            Self { hi: m.hi << up | (m.lo >> 1) >> (31 - up), lo: m.lo << up }
        } else if shift > -32 {
            m.shifted_down(-shift as u32)
        } else {
            Self { hi: 0, lo: m.hi >> (-shift as u32 - 32) }
        };
        magnitude.negated_if(hi >> 31 != 0)
    }

    /// The number in units of `u`.
    #[cfg(test)]
    pub fn units(self) -> i64 {
        ((self.hi as u64) << 32 | self.lo as u64) as i64
    }

    /// The number in units of `u`, rounded.
    #[inline(always)]
    pub fn approximate(self) -> f32 {
        self.hi as i32 as f32 * 4_294_967_296.0 + self.lo as f32
    }

    /// Whether the number is below 0.
    #[inline(always)]
    pub fn is_negative(self) -> bool {
        self.hi >> 31 != 0
    }

    /// The sum.
    #[inline(always)]
    pub fn plus(self, other: Self) -> Self {
        let lo = self.lo.wrapping_add(other.lo);
        let carry = if lo < self.lo { 1 } else { 0 };
        Self { hi: self.hi.wrapping_add(other.hi).wrapping_add(carry), lo }
    }

    /// The number with the other sign.
    #[inline(always)]
    pub fn negated(self) -> Self {
        let carry = if self.lo == 0 { 1 } else { 0 };
        Self { hi: (!self.hi).wrapping_add(carry), lo: (!self.lo).wrapping_add(1) }
    }

    /// The difference.
    #[inline(always)]
    pub fn minus(self, other: Self) -> Self {
        let borrow = if self.lo < other.lo { 1 } else { 0 };
        let hi = self.hi.wrapping_sub(other.hi).wrapping_sub(borrow);
        Self { hi, lo: self.lo.wrapping_sub(other.lo) }
    }

    /// The absolute value.
    #[inline(always)]
    pub fn abs(self) -> Self {
        if self.is_negative() { self.negated() } else { self }
    }

    /// The number, or the other sign of it.
    #[inline(always)]
    pub fn negated_if(self, negative: bool) -> Self {
        if negative { self.negated() } else { self }
    }

    /// Whether the number is greater; for numbers that differ by less than 2.
    #[inline(always)]
    pub fn is_above(self, other: Self) -> bool {
        other.minus(self).is_negative()
    }

    /// The greater of two numbers that differ by less than 2.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        if self.is_above(other) { self } else { other }
    }

    /// The number times 2^-`n`, `n < 32`, rounded down: less than `u` below.
    #[inline(always)]
    pub fn shifted_down(self, n: u32) -> Self {
        // Two shifts, because one by 32 is none.
        let carried = (self.hi << (31 - n)) << 1;
        Self { hi: ((self.hi as i32) >> n) as u32, lo: (self.lo >> n) | carried }
    }

    /// The mean of two numbers whose sum is in `[-2, 2)`, rounded down: at most `u / 2` below.
    #[inline(always)]
    pub fn mean(self, other: Self) -> Self {
        self.plus(other).shifted_down(1)
    }

    /// The product of two numbers, if it is in `(-2, 2)`: less than `5 u` below.
    #[inline(never)]
    pub fn times(self, other: Self) -> Self {
        let (a, b, of_a, of_b) = (self, other, self.ones_if_negative(), other.ones_if_negative());
        // Without the product of the low words, which is below 4 u. The bits of a negative word are
        // those of a number that is 2^32 greater.
        let [high, middle] = wide_product(a.hi, b.hi);
        let [c, low] = wide_product(a.hi, b.lo);
        let [d, other_low] = wide_product(a.lo, b.hi);
        let high = high.wrapping_sub(of_a & b.hi).wrapping_sub(of_b & a.hi);
        let (c, d) = (c.wrapping_sub(of_a & b.lo), d.wrapping_sub(of_b & a.lo));
        let low = low.wrapping_add(other_low);
        let carry = if low < other_low { 1 } else { 0 };
        let sum = Self { hi: high, lo: middle }.plus(Self::of_word(c)).plus(Self::of_word(d));
        let sum = sum.plus(Self::of_units(carry));
        let lo = (sum.lo << 2) | (low >> 30);
        Self { hi: (sum.hi << 2) | (sum.lo >> 30), lo }
    }

    /// The number times `n` 2^-31, for `n <= 2^31`: less than `u` below.
    #[inline(never)]
    pub fn times_fraction(self, n: u32) -> Self {
        let [high, middle] = wide_product(self.hi, n);
        let [c, low] = wide_product(self.lo, n);
        let high = high.wrapping_sub(self.ones_if_negative() & n);
        let sum = Self { hi: high, lo: middle }.plus(Self::of_units(c));
        Self { hi: (sum.hi << 1) | (sum.lo >> 31), lo: (sum.lo << 1) | (low >> 31) }
    }

    #[inline(always)]
    fn ones_if_negative(self) -> u32 {
        ((self.hi as i32) >> 31) as u32
    }

    /// A word with a sign, in units of `u`.
    #[inline(always)]
    fn of_word(word: u32) -> Self {
        Self { hi: ((word as i32) >> 31) as u32, lo: word }
    }

    /// From this number at 0 to another at 1, at `n` 2^-31: less than `u` below. For numbers that
    /// differ by less than 2.
    #[inline(always)]
    pub fn towards(self, other: Self, n: u32) -> Self {
        self.plus(other.minus(self).times_fraction(n))
    }
}

/// The high and the low word of a product. By halves: WGSL has no product of two words in two.
#[inline(always)]
fn wide_product(a: u32, b: u32) -> [u32; 2] {
    let [a1, a0, b1, b0] = [a >> 16, a & 0xffff, b >> 16, b & 0xffff];
    let middle = a1 * b0 + ((a0 * b0) >> 16);
    let rest = a0 * b1 + (middle & 0xffff);
    [a1 * b1 + (middle >> 16) + (rest >> 16), a.wrapping_mul(b)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn of(x: i64) -> Q62 {
        Q62 { hi: (x >> 32) as u32, lo: x as u32 }
    }

    /// Of any number of digits, and such that words are all zeros and ones.
    fn some(random: &mut Random) -> i64 {
        let bits = (random.bits() as u64) << 32 | random.bits() as u64 & 0xffff_ffff;
        let x = (bits as i64) >> (1 + random.bits() as u64 % 63);
        match random.bits() as u64 % 8 {
            0 => x & !0xffff_ffff,
            1 => x | 0xffff_ffff,
            _ => x,
        }
    }

    #[test]
    fn arithmetic_is_that_of_wide_integers() {
        let mut random = Random::new(1);
        for _ in 0..200_000 {
            let (x, y) = (some(&mut random), some(&mut random));
            let (a, b) = (of(x), of(y));
            assert_eq!(a.plus(b).units(), x.wrapping_add(y), "{x} {y}");
            assert_eq!(a.minus(b).units(), x.wrapping_sub(y), "{x} {y}");
            assert_eq!(a.negated().units(), x.wrapping_neg(), "{x}");
            assert_eq!(a.abs().units(), x.wrapping_abs(), "{x}");
            for n in [0, 1, 7, 31] {
                assert_eq!(a.shifted_down(n).units(), x >> n, "{x} {n}");
            }
            let (p, q) = (x / 2, y / 2);
            assert_eq!(of(p).mean(of(q)).units(), (p + q) >> 1, "{p} {q}");
            assert_eq!(of(p).is_above(of(q)), p > q, "{p} {q}");
            // The product rounded down, or less by what its low words have.
            let exact = x as i128 * y as i128;
            let product = a.times(b).units() as i128;
            let below = (exact >> 62) - product;
            let wide = exact.abs() >> 125 == 0;
            assert!(!wide || (0..5).contains(&below), "{x} {y}: {below}");
            for n in [0, 1, 1 << 31, 0x7fff_ffff, random.bits() >> 1] {
                let exact = x as i128 * n as i128;
                assert_eq!(a.times_fraction(n).units() as i128, exact >> 31, "{x} {n}");
            }
        }
    }

    #[test]
    fn coordinates_are_cut_to_units() {
        let mut random = Random::new(2);
        let check = |x: f64, exponent: i32| {
            let bits = x.to_bits();
            let found = Q62::of([bits as u32, (bits >> 32) as u32], exponent).units();
            // Two steps: a power of two may be none in `f64`, and the first makes x normal.
            let half = (60 - exponent) / 2;
            let units = x * 2f64.powi(half) * 2f64.powi(60 - exponent - half);
            // Modulo 2^64: casts cut what is below 2^127; what is above 2^117 is a multiple.
            let want = if units.abs() < 2f64.powi(126) { units as i128 as i64 } else { 0 };
            assert_eq!(found, want, "{x:e} {exponent}");
        };
        for _ in 0..100_000 {
            let scale = 2f64.powi((random.unit() * 160.0) as i32 - 80);
            let x = (random.unit() + random.unit() / (1 << 24) as f64 - 0.5) * scale;
            for exponent in [-80, -20, -8, 0, 3, 50, 80] {
                check(x, exponent);
                check(x as f32 as f64, exponent);
            }
        }
        for x in [0.0, -0.0, 1e-320, f64::MIN_POSITIVE, 1.0, -1.0, 1e20, 1e100, -1e300] {
            check(x, 0);
            check(x, 300);
        }
        // Of the least numbers too, of all their lengths.
        let mut n_subnormal = 0;
        for exponent in (-1086..=-890).step_by(2) {
            for _ in 0..200 {
                let fraction = ((random.bits() as u64) << 32 | random.bits() as u64) << 12 >> 12;
                let bits = ((random.bits() as u64 % 160) << 52 | fraction) >> (random.bits() % 53);
                let x = f64::from_bits(bits);
                n_subnormal += x.is_subnormal() as u32;
                check(x, exponent);
                check(-x, exponent);
            }
            check(f64::from_bits(1), exponent);
            check(f64::MIN_POSITIVE.next_down(), exponent);
            check(f64::MIN_POSITIVE, exponent);
        }
        assert!(n_subnormal > 5000, "{n_subnormal}");
    }
}
