//! An `f64` as two words of 32 bits: what kernels do where conversions are not to be trusted.

/// 2^32. Products and quotients, because a shader language counts the bits of a shift in 32 bits
/// and translators forget that.
const TWO_32: u64 = 1 << 32;

/// An `f64` from its bits, low word first.
#[inline(always)]
pub fn join(words: [u32; 2]) -> f64 {
    f64::from_bits(words[1] as u64 * TWO_32 + words[0] as u64)
}

/// The bits of an `f64`, low word first.
#[inline(always)]
pub fn split(x: f64) -> [u32; 2] {
    let bits = x.to_bits();
    [bits as u32, (bits / TWO_32) as u32]
}

/// The greatest `f32` that is not above `x` and the smallest that is not below, without a
/// conversion.
///
/// Some drivers (Mesa 25.0) take a number that was narrowed to `f32` and widened again for the
/// number itself, so that no comparison tells them apart; and how a conversion rounds is left to
/// the device.
#[inline(always)]
pub fn enclosure(x: f64) -> (f32, f32) {
    let [low, high] = split(x);
    let sign = high & 0x8000_0000;
    // Biased by 1023, where that of an f32 is biased by 127.
    let exponent = (high >> 20) & 0x7ff;
    let fraction = (high & 0xf_ffff) << 3 | low >> 29;
    let below = low & 0x1fff_ffff;
    // Towards zero, and whether anything is cut off.
    let (size, cut) = if exponent == 0x7ff {
        (0x7f80_0000 | fraction, false)
    } else if exponent > 1023 + 127 {
        (0x7f7f_ffff, true)
    } else if exponent > 1023 - 127 {
        ((exponent - (1023 - 127)) << 23 | fraction, below != 0)
    } else if exponent >= 1023 - 127 - 23 {
        let (all, places) = (0x80_0000 | fraction, 1023 - 126 - exponent);
        (all >> places, (all & ((1 << places) - 1)) | below != 0)
    } else {
        (0, (high & 0x7fff_ffff) | low != 0)
    };
    // The bits of a larger size are the greater ones.
    let towards = f32::from_bits(sign | size);
    let away = f32::from_bits((sign | size) + cut as u32);
    if sign == 0 { (towards, away) } else { (away, towards) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::real::Real;
    use crate::random::Random;

    #[test]
    fn enclosures_by_bits_are_those_of_comparisons() {
        let mut random = Random::new(2);
        let check = |x: f64| {
            let (got, want) = (enclosure(x), (x.round_down(), x.round_up()));
            assert_eq!(
                (got.0.to_bits(), got.1.to_bits()),
                (want.0.to_bits(), want.1.to_bits()),
                "{x:e}"
            );
        };
        // Every exponent of an f64; fractions that f32 has, that lie between two, and next to both.
        for exponent in 0..0x7ffu64 {
            for fraction in [0, 1, 1 << 28, 1 << 29, (1 << 29) - 1, (1 << 52) - 1, 1 << 51] {
                let any = (random.bits() as u64) << 20 | random.bits() as u64 & 0xf_ffff;
                for fraction in [fraction, any, any & !0x1fff_ffff, any | fraction] {
                    check(f64::from_bits(exponent << 52 | fraction));
                    check(-f64::from_bits(exponent << 52 | fraction));
                }
            }
        }
        // Every denormal f32 that is a power of two, and what is between it and the next.
        for x in (0..24).map(|i| f32::from_bits(1 << i) as f64) {
            for x in [x, x * 1.5, x * (1.0 + f64::EPSILON), x * (1.0 - f64::EPSILON / 2.0)] {
                check(x);
                check(-x);
            }
        }
        for x in [f32::MAX as f64, f64::MAX, f64::INFINITY, 0.0, f64::from_bits(1)] {
            check(x);
            check(-x);
        }
        assert!(!enclosure(f64::NAN).0.is_finite());
    }
}
