//! Whether two features touch at one moment: signs of integers, at first of 128 bits.

use super::features::Features;
use super::integer::{Integer, parts};
use super::vector::{Number, Vector};
use super::words::{Longest, Words};
use crate::math::real::Num;
use crate::narrow_phase::relative_motion::Patch;

/// Whether features at these places touch; `None` of what is not finite, and without a heap of what
/// is so unlike that 96 words do not hold what comes of it.
pub fn touch(patch: Patch, x: &[[f64; 3]; 4]) -> Option<bool> {
    if !x.iter().flatten().all(|x| x.is_finite()) {
        return None;
    }
    let units = super::units(x.iter());
    short(x, units)
        .and_then(|x| of_numbers(patch, &x, Short::sign))
        .or_else(|| by_integers::<[u64; 6]>(patch, x, units))
        .or_else(|| by_integers::<[u64; 24]>(patch, x, units))
        .or_else(|| by_integers::<Longest>(patch, x, units))
}

/// Whether a vertex is at a corner of the face, or an end of an edge at one of the other: meshes
/// that were cut apart, or placed corner to corner, have equal vertices.
#[inline]
pub fn shares_a_point<P: PartialEq>(patch: Patch, [p, q, r, s]: [&P; 4]) -> bool {
    match patch {
        Patch::Triangle => p == q || p == r || p == s,
        Patch::Parallelogram => p == r || p == s || q == r || q == s,
    }
}

fn by_integers<W: Words>(patch: Patch, x: &[[f64; 3]; 4], units: [i32; 3]) -> Option<bool> {
    let x = x.map(|p| [0, 1, 2].map(|k| Integer::<W>::of(p[k], units[k])));
    of_numbers(patch, &x, |x| x.is_exact().then(|| x.sign()))
}

fn of_numbers<T: Number>(
    patch: Patch,
    x: &[Vector<T>; 4],
    mut sign: impl FnMut(&T) -> Option<i32>,
) -> Option<bool> {
    let features = Features::new(patch, x);
    if sign(&features.coplanarity())? != 0 {
        return Some(false);
    }
    features.touch(&mut sign)
}

/// Coordinates in the units of their axes, if they are of less than 62 bits.
fn short(x: &[[f64; 3]; 4], units: [i32; 3]) -> Option<[Vector<Short>; 4]> {
    let mut out = [[Short::Whole(0); 3]; 4];
    for (p, out) in x.iter().zip(&mut out) {
        for ((&x, out), unit) in p.iter().zip(out).zip(units) {
            let (mantissa, exponent) = parts(x);
            if mantissa != 0 {
                let shift = (exponent - unit) as u32;
                if shift >= mantissa.unsigned_abs().leading_zeros().saturating_sub(2) {
                    return None;
                }
                *out = Short::Whole((mantissa << shift) as i128);
            }
        }
    }
    Some(out)
}

/// An integer as long as it is of 127 bits; then about what it is, and by how much it may be off.
///
/// Nothing here is beyond 2^300, and what is rounded stands for at least 2^126 or comes from such a
/// number, so that its error bound is far above what underflow could add.
#[derive(Clone, Copy, Debug)]
enum Short {
    Whole(i128),
    About(f64, f64),
}

impl Short {
    fn sign(&self) -> Option<i32> {
        match *self {
            Short::Whole(x) => Some(x.signum() as i32),
            Short::About(x, error) if x > error => Some(1),
            Short::About(x, error) if -x > error => Some(-1),
            Short::About(..) => None,
        }
    }

    fn is_zero(&self) -> bool {
        matches!(self, Short::Whole(0))
    }

    fn about(&self) -> (f64, f64) {
        match *self {
            Short::Whole(x) => (x as f64, (x as f64).abs() * f64::EPSILON),
            Short::About(x, error) => (x, error),
        }
    }

    /// A result `x` that was rounded once; `error` is what its operands contribute. The factor
    /// covers the roundings of the bound itself.
    fn rounded(x: f64, error: f64) -> Self {
        Short::About(x, (error + x.abs() * f64::EPSILON) * (1.0 + 8.0 * f64::EPSILON))
    }
}

/// The least `b` with `-2^b <= x < 2^b`.
fn bits(x: i128) -> u32 {
    128 - (x ^ (x >> 127)).leading_zeros()
}

impl Number for Short {
    #[inline(always)]
    fn plus(&self, other: &Self) -> Self {
        if let (Short::Whole(x), Short::Whole(y)) = (self, other)
            && let Some(sum) = x.checked_add(*y)
        {
            return Short::Whole(sum);
        }
        let ((x, x_error), (y, y_error)) = (self.about(), other.about());
        Self::rounded(x + y, x_error + y_error)
    }

    #[inline(always)]
    fn minus(&self, other: &Self) -> Self {
        if let (Short::Whole(x), Short::Whole(y)) = (self, other)
            && let Some(difference) = x.checked_sub(*y)
        {
            return Short::Whole(difference);
        }
        let ((x, x_error), (y, y_error)) = (self.about(), other.about());
        Self::rounded(x - y, x_error + y_error)
    }

    #[inline(always)]
    fn times(&self, other: &Self) -> Self {
        if let (&Short::Whole(x), &Short::Whole(y)) = (self, other)
            && bits(x) + bits(y) < 127
        {
            return Short::Whole(x.wrapping_mul(y));
        }
        self.times_about(other)
    }
}

impl Short {
    #[inline(never)]
    fn times_about(&self, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Short::Whole(0);
        }
        let ((x, x_error), (y, y_error)) = (self.about(), other.about());
        let error = Num::abs(x) * y_error + (Num::abs(y) + y_error) * x_error;
        Self::rounded(x * y, error)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Numbers that have become too long are never further off than they say, and signs that they
    /// show are those of integers.
    #[test]
    fn short_numbers_hold_the_integers() {
        let mut random = Random::new(3);
        fn value<T: Number>(x: [T; 8]) -> T {
            let pair = |i: usize, j: usize| x[i].times(&x[j]);
            let (one, other) = (pair(0, 1).times(&pair(2, 3)), pair(0, 3).times(&pair(2, 1)));
            // It cancels, but for what the last ones add.
            one.minus(&other).plus(&pair(4, 5).times(&x[6]).times(&x[7]))
        }
        let [mut shown, mut hidden, mut whole] = [0; 3];
        for i in 0..20_000 {
            let mut one = || {
                let bits = (random.bits() as i64) << 32 | random.bits() as i64;
                bits >> (2 + random.below(if i % 2 == 0 { 61 } else { 20 }))
            };
            let x = [(); 8].map(|()| one());
            let of_integers = value(x.map(|x| Integer::<[u64; 8]>::new(x, 0)));
            let found = value(x.map(|x| Short::Whole(x as i128)));
            whole += matches!(found, Short::Whole(_)) as usize;
            match found.sign() {
                Some(sign) => {
                    assert_eq!(sign, of_integers.sign(), "{x:?}");
                    shown += 1;
                }
                None => hidden += 1,
            }
        }
        assert!(shown > 10_000 && hidden > 500 && whole > 1000, "{shown} {hidden} {whole}");
    }

    #[test]
    fn bits_are_enough() {
        for x in [0, 1, -1, 2, i64::MAX as i128, i64::MIN as i128, i128::MAX, i128::MIN] {
            let most = if bits(x) == 127 { i128::MAX } else { (1 << bits(x)) - 1 };
            assert!(-most - 1 <= x && x <= most, "{x}");
        }
    }
}
