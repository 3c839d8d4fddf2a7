//! Times of impact as text in few digits: a time that is printed is never later than the true one.

/// As a part of the step, for people: `after 0.000749 %`; `just before 50 %`, if the number nearest
/// to it in as many digits is later by no more than a time may be early.
pub fn when(toi: f64) -> String {
    let nearest: f64 = format!("{toi:.2e}").parse().unwrap_or(toi);
    let is_near = nearest > toi && nearest - toi <= f64::min(2e-6, 2e-4 * nearest);
    let (word, time) = if is_near { ("just before", nearest) } else { ("after", toi) };
    let percent = down(time, 3, 2);
    if percent != 0.0 && percent < 1e-6 {
        format!("{word} {percent:e} %")
    } else {
        format!("{word} {percent} %")
    }
}

/// In a picture: `0.500`, and `7.49e-6` where that would say little.
pub fn plain(toi: f64) -> String {
    match toi {
        0.0 => "0.000".into(),
        ..0.01 => short(toi, 3),
        ..0.1 => format!("{:.3}", down(toi, 2, 0)),
        _ => format!("{:.3}", down(toi, 3, 0)),
    }
}

/// In a table: `7.492e-6` in four digits.
pub fn short(toi: f64, digits: usize) -> String {
    if toi == 0.0 { "0".into() } else { format!("{:.*e}", digits - 1, down(toi, digits, 0)) }
}

/// A time in `[0, 1]` times a power of ten, cut after so many digits, at most 15.
///
/// Cut are the digits by which the number is known everywhere else (`{:?}`, JSON, CSV), so that a
/// time which has few of them stays what it is.
fn down(toi: f64, digits: usize, power: i32) -> f64 {
    let text = format!("{toi:e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    // One place more for the point, which is there if there is more than one digit.
    let kept = &mantissa[..mantissa.len().min(digits + 1)];
    let exponent = exponent.parse::<i32>().unwrap_or_default() + power;
    format!("{kept}e{exponent}").parse().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ccd::scenes::Random;

    #[test]
    fn parts_of_a_step_have_three_digits_that_matter() {
        for (toi, want) in [
            (0.0, "after 0 %"),
            (7.492069018333316e-6, "after 0.000749 %"),
            (0.5, "after 50 %"),
            (0.5f64.next_down(), "just before 50 %"),
            (0.499_999, "just before 50 %"),
            (0.499_99, "after 49.9 %"),
            (0.07, "after 7 %"),
            (1.0, "after 100 %"),
            (1f64.next_down(), "just before 100 %"),
            (0.0123, "after 1.23 %"),
            (0.009_999, "just before 1 %"),
            (0.009_99, "after 0.999 %"),
            (1.99e-9, "after 1.99e-7 %"),
            (1e-300, "after 1e-298 %"),
            (f64::from_bits(1), "after 5e-322 %"),
        ] {
            assert_eq!(when(toi), want);
        }
    }

    #[test]
    fn times_in_few_digits() {
        let tois = [0.0, 0.5, 0.3, 1.0, 1f64.next_down(), 7.492069018333316e-6, 4.99999e-1];
        let want = ["0", "5.00e-1", "3.00e-1", "1.00e0", "9.99e-1", "7.49e-6", "4.99e-1"];
        assert_eq!(tois.map(|toi| short(toi, 3)), want);
        let want = ["0.000", "0.500", "0.300", "1.000", "0.999", "7.49e-6", "0.499"];
        assert_eq!(tois.map(plain), want);
        assert_eq!([0.0999, 0.01, 0.00999].map(plain), ["0.099", "0.010", "9.99e-3"]);
        assert_eq!(short(1.587_933_107_694_209_8e-3, 7), "1.587933e-3");
    }

    #[test]
    fn no_time_becomes_later() {
        let (mut random, mut n_later) = (Random::new(1), 0);
        for i in 0..20_000 {
            let unit = random.unit() + random.unit() / (1 << 24) as f64;
            let toi = unit * 0.5f64.powi(i % 1070);
            for digits in [3, 5, 7] {
                let printed: f64 = short(toi, digits).parse().unwrap();
                let least = toi * (1.0 - 1.01 * 10f64.powi(1 - digits as i32));
                assert!(printed <= toi && printed >= least, "{printed:e} for {toi:e}");
                let rounded: f64 = format!("{toi:.*e}", digits - 1).parse().unwrap();
                n_later += (rounded > toi) as usize;
            }
            let text = when(toi);
            let is_before = text.starts_with("just before");
            let number = text.trim_start_matches("just before ").trim_start_matches("after ");
            let number = number.trim_end_matches(" %");
            let (mantissa, exponent) = match number.split_once('e') {
                Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().unwrap()),
                None => (number, 0),
            };
            let part: f64 = format!("{mantissa}e{}", exponent - 2).parse().unwrap();
            let fits = match is_before {
                true => part > toi && part - toi <= 2e-6 && part <= toi * 1.000_201,
                false => part <= toi && part >= toi * 0.989,
            };
            assert!(fits, "{text} for {toi:e}");
        }
        assert!(n_later > 10_000, "{n_later} numbers that round up show nothing");
    }
}
