//! Integers as sign and magnitude, of a fixed number of words on the stack, or of any on the heap.
//!
//! What does not fit is not wrong: it is marked, and so is all that comes of it
//! ([`Integer::is_exact`]), so that a caller takes more words.

use super::words::Words;
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

/// An integer.
#[derive(Clone, Debug)]
pub struct Integer<W> {
    /// The lowest first; those from `len` on are 0.
    words: W,
    /// Words in use: the last of them is not 0.
    len: usize,
    negative: bool,
    lost: bool,
}

impl<W: Words> Integer<W> {
    /// Nothing.
    pub const ZERO: Self = Self { words: W::NONE, len: 0, negative: false, lost: false };
    /// A number that did not fit.
    pub const LOST: Self = Self { words: W::NONE, len: 0, negative: false, lost: true };

    /// 0, with room for `len` words or as many as there may be.
    fn with_room(len: usize, negative: bool) -> Self {
        let mut out = Self { negative, ..Self::ZERO };
        out.words.grow(len.min(W::MOST));
        out
    }

    /// `x * 2^shift`.
    pub fn new(x: i64, shift: u32) -> Self {
        if x == 0 {
            return Self::ZERO;
        }
        let mut out = Self::with_room(1, x < 0);
        (out.words.as_mut()[0], out.len) = (x.unsigned_abs(), 1);
        if shift == 0 { out } else { out.shifted(shift) }
    }

    /// An `f64` in units of `2^unit`, of which it is a multiple.
    pub fn of(x: f64, unit: i32) -> Self {
        let (mantissa, exponent) = parts(x);
        Self::new(mantissa, if mantissa == 0 { 0 } else { (exponent - unit) as u32 })
    }

    /// The words in use.
    fn words(&self) -> &[u64] {
        &self.words.as_ref()[..self.len]
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
        self.words().last().map_or(0, |w| self.len as u32 * 64 - w.leading_zeros())
    }

    /// The highest 53 bits of the magnitude, whether there are others that are not 0, and the power
    /// of two of the last of the 53.
    pub fn leading(&self) -> (u64, bool, u32) {
        let below = self.bits().saturating_sub(53);
        let (whole, part) = ((below / 64) as usize, below % 64);
        let words = self.words();
        let word = |i: usize| words.get(i).copied().unwrap_or(0);
        let high = if part > 0 { word(whole + 1) << (64 - part) } else { 0 };
        let rest = words[..whole.min(self.len)].iter().any(|&w| w != 0);
        let rest = rest || word(whole) & ((1 << part) - 1) != 0;
        (word(whole) >> part | high, rest, below)
    }

    /// The magnitude as the sum of two numbers, the second below 1 and off by at most `2^-53` of
    /// itself, times a power of two, given as its exponent.
    pub fn in_two(&self) -> ([f64; 2], i32) {
        let (mantissa, _, unit) = self.leading();
        let whole = Self { negative: self.negative, ..Self::new(mantissa as i64, unit) };
        let (low, _, low_unit) = (self - whole).leading();
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
            return self.clone();
        }
        let len = (self.bits() as u64 + k as u64).div_ceil(64) as usize;
        if self.lost || len > W::MOST {
            return Self::LOST;
        }
        let (whole, part) = ((k / 64) as usize, k % 64);
        let mut out = Self::with_room(len, self.negative);
        let words = out.words.as_mut();
        for (i, word) in self.words().iter().enumerate() {
            words[i + whole] |= word << part;
            if part > 0 && i + whole + 1 < len {
                words[i + whole + 1] = word >> (64 - part);
            }
        }
        out.trim(len);
        out
    }

    /// Counts the words in use, of which there are at most `len`.
    fn trim(&mut self, len: usize) {
        let words = &self.words.as_ref()[..len];
        self.len = words.iter().rposition(|&word| word != 0).map_or(0, |last| last + 1);
    }

    /// Of magnitudes.
    fn compared(&self, other: &Self) -> Ordering {
        let by_words = || self.words().iter().rev().cmp(other.words().iter().rev());
        self.len.cmp(&other.len).then_with(by_words)
    }

    /// Adds another's magnitude to this one's.
    fn add_magnitude(&mut self, other: &Self) {
        self.len = self.len.max(other.len);
        self.words.grow(self.len);
        if by_words(&mut self.words.as_mut()[..self.len], other.words(), u64::overflowing_add) {
            if self.len == W::MOST {
                *self = Self::LOST;
                return;
            }
            self.words.grow(self.len + 1);
            self.words.as_mut()[self.len] = 1;
            self.len += 1;
        }
    }

    /// Subtracts another's magnitude from this one's; the sign changes if that is greater.
    fn subtract_magnitude(&mut self, other: &Self) {
        let len = self.len.max(other.len);
        self.words.grow(len);
        let words = &mut self.words.as_mut()[..len];
        if by_words(words, other.words(), u64::overflowing_sub) {
            negate(words);
            self.negative = !self.negative;
        }
        self.trim(len);
    }

    /// The sum with another, or its negative.
    fn sum(&self, other: &Self, negated: bool) -> Self {
        let mut out = self.clone();
        out.accumulate(other, negated);
        out
    }

    /// Adds another, or its negative.
    pub fn accumulate(&mut self, other: &Self, negated: bool) {
        if self.lost || other.lost {
            *self = Self::LOST;
            return;
        }
        let negative = other.negative != negated;
        if self.len == 0 {
            self.negative = negative;
        }
        if self.negative == negative {
            self.add_magnitude(other);
        } else {
            self.subtract_magnitude(other);
        }
    }

    /// Adds the product of two numbers, or its negative.
    pub fn add_product(&mut self, a: &Self, b: &Self, negated: bool) {
        // One word more than either, for a carry or a sign.
        let len = self.len.max(a.len + b.len) + 1;
        if self.lost || a.lost || b.lost || len > W::MOST {
            return self.accumulate(&a.product(b), negated);
        }
        if a.len == 0 || b.len == 0 {
            return;
        }
        let negative = (a.negative != b.negative) != negated;
        if self.len == 0 {
            self.negative = negative;
        }
        self.words.grow(len);
        let words = &mut self.words.as_mut()[..len];
        if self.negative == negative {
            add_product(words, a.words(), b.words());
        } else {
            // The product less this number.
            negate(words);
            add_product(words, a.words(), b.words());
            match words[len - 1] >> 63 {
                1 => negate(words),
                _ => self.negative = negative,
            }
        }
        self.trim(len);
    }

    fn product(&self, other: &Self) -> Self {
        if self.lost || other.lost {
            return Self::LOST;
        }
        if self.len == 0 || other.len == 0 {
            return Self::ZERO;
        }
        let len = self.len + other.len;
        let room = len.min(W::MOST);
        if len > room + 1 {
            return Self::LOST;
        }
        let mut out = Self::with_room(len, self.negative != other.negative);
        let words = &mut out.words.as_mut()[..room];
        if add_product(words, self.words(), other.words()) {
            return Self::LOST;
        }
        out.trim(room);
        out
    }

    /// Quotient and remainder of magnitudes; `by` is not 0.
    fn divided(&self, by: &Self) -> [Self; 2] {
        let (mut quotient, mut rest) = (Self::ZERO, Self { negative: false, ..self.clone() });
        while rest.compared(by).is_ge() {
            let k = rest.bits() - by.bits();
            let fits = by.shifted(k).compared(&rest).is_le();
            let k = if fits { k } else { k - 1 };
            rest.subtract_magnitude(&by.shifted(k));
            quotient.add_magnitude(&Self::new(1, k));
        }
        [quotient, rest]
    }

    /// Two numbers, not both 0, without their greatest common divisor.
    pub fn coprime([a, b]: [Self; 2]) -> [Self; 2] {
        if a.lost || b.lost {
            return [a, b];
        }
        let (mut divisor, mut rest) = (a.clone(), b.clone());
        while rest.len > 0 {
            let [_, next] = divisor.divided(&rest);
            (divisor, rest) = (rest, next);
        }
        [a, b].map(|x| {
            let [quotient, _] = x.divided(&divisor);
            Self { negative: x.negative, ..quotient }
        })
    }
}

/// The negative of a number in words, whose highest bit is a sign.
#[inline(always)]
fn negate(words: &mut [u64]) {
    let mut carry = true;
    for word in words {
        (*word, carry) = (!*word).overflowing_add(carry as u64);
    }
}

/// Adds a product to words, of which there are as many as both numbers have, or more, or one less;
/// whether the last one carries.
#[inline(always)]
fn add_product(words: &mut [u64], a: &[u64], b: &[u64]) -> bool {
    let mut carries = false;
    for (i, &x) in a.iter().enumerate() {
        let (low, high) = words[i..].split_at_mut(b.len());
        let mut carry = 0u128;
        for (word, &y) in low.iter_mut().zip(b) {
            carry += x as u128 * y as u128 + *word as u128;
            *word = carry as u64;
            carry >>= 64;
        }
        carries |= match high {
            [] => carry != 0,
            _ => by_words(high, &[carry as u64], u64::overflowing_add),
        };
    }
    carries
}

/// Changes words by those of another number, of which there are no more, the lowest first; whether
/// the last one carries.
#[inline(always)]
fn by_words(words: &mut [u64], by: &[u64], op: impl Fn(u64, u64) -> (u64, bool)) -> bool {
    let mut carry = false;
    let (low, high) = words.split_at_mut(by.len());
    for (word, &by) in low.iter_mut().zip(by) {
        let (result, over) = op(*word, by);
        let (result, more) = op(result, carry as u64);
        (*word, carry) = (result, over || more);
    }
    for word in high {
        if !carry {
            break;
        }
        (*word, carry) = op(*word, 1);
    }
    carry
}

impl<W: Words> Neg for Integer<W> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { negative: !self.negative, ..self }
    }
}

/// An operator for integers and references to them.
macro_rules! operator {
    ($name:ident, $method:ident, |$a:ident, $b:ident| $result:expr) => {
        impl<W: Words> $name for &Integer<W> {
            type Output = Integer<W>;

            fn $method(self, other: Self) -> Integer<W> {
                let ($a, $b) = (self, other);
                $result
            }
        }
        impl<W: Words> $name for Integer<W> {
            type Output = Integer<W>;

            fn $method(self, other: Self) -> Integer<W> {
                (&self).$method(&other)
            }
        }
        impl<W: Words> $name<&Integer<W>> for Integer<W> {
            type Output = Integer<W>;

            fn $method(self, other: &Self) -> Integer<W> {
                (&self).$method(other)
            }
        }
        impl<W: Words> $name<Integer<W>> for &Integer<W> {
            type Output = Integer<W>;

            fn $method(self, other: Integer<W>) -> Integer<W> {
                self.$method(&other)
            }
        }
    };
}

operator!(Add, add, |a, b| a.sum(b, false));
operator!(Sub, sub, |a, b| a.sum(b, true));
operator!(Mul, mul, |a, b| a.product(b));

/// `2^e`, a normal number.
pub fn power_of_two(e: i32) -> f64 {
    f64::from_bits(((e + 1023) as u64) << 52)
}

#[cfg(test)]
mod tests;
