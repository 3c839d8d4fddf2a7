//! Growth of a time with a size: by what power of the size it grows.

/// The slope of `log y` over `log x` by least squares; `None` of fewer than two points, or of
/// points that are not all above 0.
pub fn exponent(points: &[[f64; 2]]) -> Option<f64> {
    if points.len() < 2 || points.iter().flatten().any(|&v| v.is_nan() || v <= 0.0) {
        return None;
    }
    let logs: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::ln)).collect();
    let mean = |k: usize| logs.iter().map(|p| p[k]).sum::<f64>() / logs.len() as f64;
    let [x, y] = [0, 1].map(mean);
    let sum = |of: fn(f64, f64) -> f64| logs.iter().map(|p| of(p[0] - x, p[1] - y)).sum::<f64>();
    let spread = sum(|x, _| x * x);
    (spread > 0.0).then(|| sum(|x, y| x * y) / spread)
}

/// A size in a few characters: 10 K, 31.6 K, 1 M.
pub fn size(n: usize) -> String {
    let short = |unit: usize, name: &str| {
        let x = format!("{:.1}", n as f64 / unit as f64);
        format!("{} {name}", x.trim_end_matches(".0"))
    };
    match n {
        1_000_000.. => short(1_000_000, "M"),
        1_000.. => short(1_000, "K"),
        _ => n.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_found() {
        let check = |power: f64, want: f64| {
            let points: Vec<_> =
                [1e4, 1e5, 1e6, 1e7].map(|n: f64| [n, 3e-6 * n.powf(power)]).into();
            let found = exponent(&points).unwrap();
            assert!((found - want).abs() < 1e-9, "{power}: {found}");
        };
        for power in [0.0, 1.0, 1.5, 2.0] {
            check(power, power);
        }
        // A time that stays, then grows, is between.
        let bent = exponent(&[[1e4, 1.0], [1e5, 1.0], [1e6, 10.0]]).unwrap();
        assert!((bent - 0.5).abs() < 1e-9, "{bent}");
        for none in [&[][..], &[[1.0, 1.0]], &[[1.0, 1.0], [1.0, 2.0]], &[[1.0, 0.0], [2.0, 1.0]]] {
            assert_eq!(exponent(none), None, "{none:?}");
        }
    }

    #[test]
    fn sizes_are_short() {
        let all = [999, 10_000, 31_623, 999_698, 1_000_000, 9_999_392, 100_000_000].map(size);
        assert_eq!(all, ["999", "10 K", "31.6 K", "999.7 K", "1 M", "10 M", "100 M"]);
    }
}
