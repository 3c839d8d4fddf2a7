//! Integers of a fixed number of words on the stack, as sign and magnitude.
//!
//! What does not fit is not wrong: it is marked, and so is all that comes of it
//! ([`Fixed::is_exact`]), so that a caller takes more words.

use core::cmp::Ordering;
use core::ops::{Add, Mul, Neg, Sub};

/// A finite number as an odd integer times a power of two; 0 has the greatest power.
pub fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    let mantissa = if exponent > 0 { fraction | 1 << 52 } else { fraction };
    if mantissa == 0 {
        return (0, i32::MAX);
    }
    let zeros = mantissa.trailing_zeros();
    let magnitude = (mantissa >> zeros) as i64;
    let exponent = exponent.max(1) - 1075 + zeros as i32;
    (if x < 0.0 { -magnitude } else { magnitude }, exponent)
}

/// An integer of at most `64 N` bits.
#[derive(Clone, Copy, Debug)]
pub struct Fixed<const N: usize> {
    /// The lowest first; those from `len` on are 0.
    words: [u64; N],
    /// Words in use: the last of them is not 0.
    len: usize,
    negative: bool,
    lost: bool,
}

impl<const N: usize> Fixed<N> {
    /// Nothing.
    pub const ZERO: Self = Self { words: [0; N], len: 0, negative: false, lost: false };
    /// A number that did not fit.
    const LOST: Self = Self { lost: true, ..Self::ZERO };

    /// `x * 2^shift`.
    pub fn new(x: i64, shift: u32) -> Self {
        let mut out = Self::ZERO;
        (out.words[0], out.len, out.negative) = (x.unsigned_abs(), (x != 0) as usize, x < 0);
        out.shifted(shift)
    }

    /// An `f64` in units of `2^unit`, of which it is a multiple.
    pub fn of(x: f64, unit: i32) -> Self {
        let (mantissa, exponent) = parts(x);
        Self::new(mantissa, if mantissa == 0 { 0 } else { (exponent - unit) as u32 })
    }

    /// Whether nothing was lost: else the number means nothing.
    pub fn is_exact(&self) -> bool {
        !self.lost
    }

    /// -1, 0 or 1.
    pub fn sign(&self) -> i32 {
        match (self.len, self.negative) {
            (0, _) => 0,
            (_, true) => -1,
            (_, false) => 1,
        }
    }

    /// Bits of the magnitude.
    pub fn bits(&self) -> u32 {
        self.words[..self.len].last().map_or(0, |w| self.len as u32 * 64 - w.leading_zeros())
    }

    /// The highest 53 bits of the magnitude, whether there are others that are not 0, and the power
    /// of two of the last of the 53.
    pub fn leading(&self) -> (u64, bool, u32) {
        let below = self.bits().saturating_sub(53);
        let (whole, part) = ((below / 64) as usize, below % 64);
        let word = |i: usize| if i < self.len { self.words[i] } else { 0 };
        let high = if part > 0 { word(whole + 1) << (64 - part) } else { 0 };
        let rest = self.words[..whole.min(self.len)].iter().any(|&w| w != 0);
        let rest = rest || word(whole) & ((1 << part) - 1) != 0;
        (word(whole) >> part | high, rest, below)
    }

    /// The magnitude as the sum of two numbers, the second below 1 and off by at most `2^-53` of
    /// itself, times a power of two, given as its exponent.
    pub fn in_two(&self) -> ([f64; 2], i32) {
        let (mantissa, _, unit) = self.leading();
        let whole = Self { negative: self.negative, ..Self::new(mantissa as i64, unit) };
        let (low, _, low_unit) = (*self - whole).leading();
        let below = unit - low_unit.min(unit);
        let low = if below > 1022 { 0.0 } else { low as f64 * power_of_two(-(below as i32)) };
        ([mantissa as f64, low], unit as i32)
    }

    /// The number in units of `2^bits`, which no bit of it reaches, rounded; what is tiny is 0.
    pub fn rounded(&self, bits: u32) -> f64 {
        let (mantissa, _, exponent) = self.leading();
        let below = bits - exponent;
        if mantissa == 0 || below > 1022 {
            return 0.0;
        }
        let value = mantissa as f64 * f64::from_bits(((1023 - below) as u64) << 52);
        if self.negative { -value } else { value }
    }

    /// `self * 2^k`.
    pub fn shifted(&self, k: u32) -> Self {
        if self.len == 0 || k == 0 {
            return *self;
        }
        if self.lost || self.bits() as u64 + k as u64 > 64 * N as u64 {
            return Self::LOST;
        }
        let (whole, part) = ((k / 64) as usize, k % 64);
        let mut out = Self { negative: self.negative, ..Self::ZERO };
        for i in 0..self.len {
            out.words[i + whole] |= self.words[i] << part;
            if part > 0 && i + whole + 1 < N {
                out.words[i + whole + 1] |= self.words[i] >> (64 - part);
            }
        }
        out.trimmed((self.len + whole + 1).min(N))
    }

    /// With the last of `len` words not 0.
    fn trimmed(mut self, len: usize) -> Self {
        self.len = len;
        while self.len > 0 && self.words[self.len - 1] == 0 {
            self.len -= 1;
        }
        self
    }

    /// Of magnitudes.
    fn compared(&self, other: &Self) -> Ordering {
        self.len.cmp(&other.len).then_with(|| {
            let pairs = self.words[..self.len].iter().zip(&other.words[..other.len]).rev();
            pairs.map(|(a, b)| a.cmp(b)).find(|o| o.is_ne()).unwrap_or(Ordering::Equal)
        })
    }

    /// The sum of two magnitudes, with the sign of the first.
    fn sum(&self, other: &Self) -> Self {
        let (a, b) = if self.len < other.len { (other, self) } else { (self, other) };
        let mut out = Self { negative: self.negative, ..*a };
        let mut carry = false;
        for i in 0..a.len {
            if i >= b.len && !carry {
                break;
            }
            let (word, over) = a.words[i].overflowing_add(if i < b.len { b.words[i] } else { 0 });
            let (word, more) = word.overflowing_add(carry as u64);
            (out.words[i], carry) = (word, over || more);
        }
        if carry {
            if a.len == N {
                return Self::LOST;
            }
            out.words[a.len] = 1;
            out.len = a.len + 1;
        }
        out
    }

    /// The greater magnitude minus the lesser, with the sign of the greater.
    fn difference(&self, lesser: &Self) -> Self {
        let mut out = *self;
        let mut borrow = false;
        for i in 0..self.len {
            if i >= lesser.len && !borrow {
                break;
            }
            let b = if i < lesser.len { lesser.words[i] } else { 0 };
            let (word, under) = self.words[i].overflowing_sub(b);
            let (word, more) = word.overflowing_sub(borrow as u64);
            (out.words[i], borrow) = (word, under || more);
        }
        out.trimmed(self.len)
    }

    /// Quotient and remainder of magnitudes; `by` is not 0.
    fn divided(&self, by: &Self) -> (Self, Self) {
        let [mut rest, by] = [self, by].map(|x| Self { negative: false, ..*x });
        let mut quotient = Self::ZERO;
        while rest.compared(&by).is_ge() {
            let k = rest.bits() - by.bits();
            let fits = by.shifted(k).compared(&rest).is_le();
            let k = if fits { k } else { k - 1 };
            rest = rest.difference(&by.shifted(k));
            quotient = quotient.sum(&Self::new(1, k));
        }
        (quotient, rest)
    }

    /// Two numbers, not both 0, without their greatest common divisor.
    pub fn coprime([a, b]: [Self; 2]) -> [Self; 2] {
        if a.lost || b.lost {
            return [a, b];
        }
        let (mut divisor, mut rest) = (a, b);
        while rest.len > 0 {
            (divisor, rest) = (rest, divisor.divided(&rest).1);
        }
        [a, b].map(|x| Self { negative: x.negative, ..x.divided(&divisor).0 })
    }
}

impl<const N: usize> Neg for Fixed<N> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { negative: !self.negative, ..self }
    }
}

impl<const N: usize> Add for Fixed<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        if self.lost || other.lost {
            return Self::LOST;
        }
        if self.len == 0 {
            return other;
        }
        if self.negative == other.negative || other.len == 0 {
            return self.sum(&other);
        }
        match self.compared(&other) {
            Ordering::Equal => Self::ZERO,
            Ordering::Less => other.difference(&self),
            Ordering::Greater => self.difference(&other),
        }
    }
}

impl<const N: usize> Sub for Fixed<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<const N: usize> Mul for Fixed<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self.lost || other.lost {
            return Self::LOST;
        }
        if self.len == 0 || other.len == 0 {
            return Self::ZERO;
        }
        let len = self.len + other.len;
        if len > N + 1 {
            return Self::LOST;
        }
        let mut out = Self { negative: self.negative != other.negative, ..Self::ZERO };
        for i in 0..self.len {
            let mut carry = 0u128;
            for j in 0..other.len {
                let word = if i + j < N { out.words[i + j] } else { 0 };
                carry += self.words[i] as u128 * other.words[j] as u128 + word as u128;
                if i + j < N {
                    out.words[i + j] = carry as u64;
                } else if carry as u64 != 0 {
                    return Self::LOST;
                }
                carry >>= 64;
            }
            match i + other.len {
                at if at < N => out.words[at] = carry as u64,
                _ if carry != 0 => return Self::LOST,
                _ => (),
            }
        }
        out.trimmed(len.min(N))
    }
}

/// `2^e`, a normal number.
pub fn power_of_two(e: i32) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    fn value<const N: usize>(x: &Fixed<N>) -> i128 {
        let magnitude = x.words[0] as i128 | (if N > 1 { x.words[1] as i128 } else { 0 }) << 64;
        if x.negative { -magnitude } else { magnitude }
    }

    #[test]
    fn it_computes_as_machine_integers_do() {
        let mut random = Random::new(5);
        for _ in 0..20_000 {
            let mut one = || (random.bits() as i64) >> random.below(64);
            let (a, b) = (one(), one());
            let [x, y] = [a, b].map(|x| Fixed::<2>::new(x, 0));
            assert_eq!(value(&(x + y)), a as i128 + b as i128);
            assert_eq!(value(&(x - y)), a as i128 - b as i128);
            let product = x * y;
            assert!(product.is_exact());
            assert_eq!(value(&product), a as i128 * b as i128);
            assert_eq!(product.sign(), (a as i128 * b as i128).signum() as i32);
            assert_eq!((product - product).sign(), 0);
            let shift = random.below(64);
            assert_eq!(value(&x.shifted(shift)), (a as i128) << shift);
            // Through sums and differences of many words.
            let [p, q, r] = [product, x, y].map(|x| widened::<2, 6>(&x));
            let t = (p + q.shifted(70)) * (r + p);
            let u = p * r + p * p + q.shifted(70) * r + q.shifted(70) * p;
            assert_eq!((t - u).sign(), 0);
            assert!(t.is_exact() && u.is_exact());
        }
    }

    fn widened<const N: usize, const M: usize>(x: &Fixed<N>) -> Fixed<M> {
        let mut out = Fixed { negative: x.negative, ..Fixed::<M>::ZERO };
        out.words[..x.len].copy_from_slice(&x.words[..x.len]);
        out.trimmed(x.len)
    }

    #[test]
    fn what_does_not_fit_is_marked() {
        let most = Fixed::<1>::new(i64::MIN, 0);
        let one = Fixed::<1>::new(1, 0);
        assert!((most + -one).is_exact() && !(most + most).is_exact());
        assert!(!(most * most).is_exact() && !most.shifted(1).is_exact());
        assert!((most * one).is_exact());
        assert!(!((most + most) - (most + most)).is_exact());
        assert!(!(Fixed::<1>::new(1, 32) * Fixed::<1>::new(1, 32)).is_exact());
        assert!((Fixed::<1>::new(1, 32) * Fixed::<1>::new(1, 31)).is_exact());
    }

    #[test]
    fn numbers_are_divided() {
        let mut random = Random::new(6);
        for _ in 0..2000 {
            let mut one = || (random.bits() as i64 | 1) >> random.below(63);
            let [a, b, c, d] = [one(), one(), one(), one()].map(|x| Fixed::<6>::new(x, 0));
            let of = a * b * c;
            let (by, more) = (c * d, b * d);
            if by.sign() == 0 || of.sign() == 0 {
                continue;
            }
            let (quotient, rest) = of.divided(&by);
            let magnitude = Fixed { negative: false, ..of };
            let by_magnitude = Fixed { negative: false, ..by };
            assert_eq!((quotient * by_magnitude + rest - magnitude).sign(), 0);
            assert!(rest.compared(&by).is_lt());
            // The same quotient, by numbers with no common divisor.
            let [p, q] = Fixed::coprime([of, more]);
            assert_eq!((p * more - q * of).sign(), 0);
            let [r, s] = Fixed::coprime([p, q]);
            assert!((r - p).sign() == 0 && (s - q).sign() == 0);
            assert!(p.bits() + b.bits() <= of.bits() + 2 && p.sign() == of.sign());
        }
    }

    #[test]
    fn leading_bits_are_those_of_the_number() {
        let x = Fixed::<4>::new((1 << 53) - 1, 100);
        assert_eq!(x.leading(), ((1 << 53) - 1, false, 100));
        assert_eq!((x + Fixed::new(1, 0)).leading(), ((1 << 53) - 1, true, 100));
        assert_eq!(Fixed::<4>::new(5, 0).leading(), (5, false, 0));
        assert_eq!(Fixed::<4>::ZERO.leading(), (0, false, 0));
    }
}
