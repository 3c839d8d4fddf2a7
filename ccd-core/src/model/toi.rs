//! Times of impact as an application uses them: in `f32`, and scaled, never later than they were.

use crate::math::real::Real;

/// The greatest `f32` that is not above a time of impact.
///
/// A cast rounds to the nearest, which may be later than the contact.
///
/// ```
/// use ccd::toi_to_f32;
///
/// let toi = 0.1f64.next_down();
/// assert!(toi as f32 as f64 > toi);
/// assert!(toi_to_f32(toi) as f64 <= toi);
/// ```
pub fn toi_to_f32(toi: f64) -> f32 {
    toi.round_down()
}

/// A time of impact times a `factor` in `[0, 1]`, rounded down: how far a step may go that keeps
/// some of the distance that is left, as conservative rescaling does in incremental potential
/// contact [Li 2020].
///
/// A factor that is not in `[0, 1]`, or NaN, gives 0 or the time itself, whichever is nearer, and 0
/// for NaN: never a later time.
pub fn scaled_toi(toi: f64, factor: f64) -> f64 {
    if factor >= 1.0 {
        toi
    } else if factor > 0.0 && toi > 0.0 {
        (toi * factor).next_down().max(0.0)
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use num_bigint::BigInt;
    use num_rational::BigRational;

    fn exact(x: f64) -> BigRational {
        BigRational::from_float(x).expect("a finite number")
    }

    #[test]
    fn nothing_becomes_later() {
        let mut random = Random::new(1);
        let mut unit = || random.unit() + random.unit() / (1 << 24) as f64;
        let mut n_later = 0;
        for i in 0..20_000 {
            let (toi, factor) = (unit() * 0.5f64.powi(i % 1100), unit());
            let narrow = toi_to_f32(toi);
            assert!(narrow as f64 <= toi && narrow.next_up() as f64 > toi, "{toi:e}");
            n_later += (toi as f32 as f64 > toi) as usize;
            let (got, want) = (exact(scaled_toi(toi, factor)), exact(toi) * exact(factor));
            assert!(got <= want && got >= BigRational::from(BigInt::from(0)), "{toi:e} {factor:e}");
        }
        assert!(n_later > 1_000, "{n_later} casts that round up show nothing");
        for factor in [0.0, -1.0, f64::NAN, f64::NEG_INFINITY] {
            assert_eq!(scaled_toi(0.5, factor), 0.0, "{factor}");
        }
        assert_eq!([1.0, 2.0, f64::INFINITY].map(|f| scaled_toi(0.5, f)), [0.5; 3]);
        assert_eq!((scaled_toi(1.0, 0.9), scaled_toi(0.0, 0.9)), (0.9f64.next_down(), 0.0));
    }
}
