//! Scans and tables of positions.

use super::*;
use crate::random::Random;
use alloc::vec::Vec;

/// Corners of a cube of half side `reach` around `centre`, and points near its middle.
fn check_table(centre: f64, reach: f64) {
    let mut scan = Scan::NONE;
    let points: [[f64; 3]; 3] =
        [[centre - reach; 3], [centre + reach; 3], [centre + 0.123_456_789 * reach; 3]];
    points.iter().for_each(|p| scan.take(*p));
    let table = scan.table(true);
    for p in points {
        let placed = table.place(p)[0];
        assert!(placed.is_finite_number(), "{centre:e} {reach:e}: {placed}");
        // Exact up to the rounding of f64, of numbers no greater than the coordinates.
        let want = (p[0] - table.origin[0]) * table.scale;
        let slack = scan.greatest() * 4.0 * f64::UNIT * table.scale;
        assert!(
            (placed as f64 - want).abs() <= table.error as f64 + slack,
            "{centre:e} {reach:e}: {placed} for {want}"
        );
        let largest = placed.abs() as f64;
        assert!(
            largest <= 2.0 * EXACT_LIMIT,
            "{centre:e} {reach:e}: {placed} overflows in a filter"
        );
    }
    if reach > 0.0 {
        assert!(
            (table.error as f64) < 1e-6 * (reach + centre.abs() * 1e-8) * table.scale + 3e-38,
            "{centre:e} {reach:e}: {table:?}"
        );
    }
}

#[test]
fn many_positions_at_once_are_as_one_by_one() {
    fn check<T: Real>(x: &[[T; 3]]) -> Scan {
        let (mut one_by_one, mut at_once) = (Scan::NONE, Scan::NONE);
        x.iter().for_each(|p| one_by_one.take(*p));
        at_once.take_all(&x[..x.len() / 2], &x[x.len() / 2..]);
        assert_eq!(one_by_one.finite, at_once.finite, "{x:?}");
        // Errors name the coordinate; nothing else is read of what is not finite.
        assert!(!at_once.finite || one_by_one == at_once, "{x:?}");
        at_once
    }
    let mut random = Random::new(7);
    for n in 0..40 {
        let narrow: Vec<[f32; 3]> = (0..n).map(|_| random.point().map(|c| c as f32)).collect();
        let wide: Vec<[f64; 3]> = narrow.iter().map(|p| p.map(f64::from)).collect();
        assert!(check(&narrow).exact && check(&wide).exact);
        for at in 0..n {
            for (special, is_fine) in [
                (f64::NAN, false),
                (f64::INFINITY, false),
                (f64::NEG_INFINITY, false),
                (1.1e100, false),
                (-1e100, true),
                (0.1, true),
                (1e-310, true),
                (1e39, true),
            ] {
                let mut wide = wide.clone();
                wide[at][n % 3] = special;
                let scan = check(&wide);
                assert!(
                    scan.finite == is_fine && !(is_fine && scan.exact),
                    "{special} at {at} of {n}"
                );
                let mut narrow = narrow.clone();
                narrow[at][n % 3] = special as f32;
                let scan = check(&narrow);
                assert_eq!(scan.finite, (special as f32).is_finite(), "{special} at {at} of {n}");
            }
        }
    }
}

#[test]
fn tables_are_finite_and_close_in_every_unit() {
    for e in -100..=99 {
        let unit = 10f64.powi(e);
        for centre in [0.0, unit, -3.0 * unit] {
            check_table(centre, unit);
            check_table(centre, 0.3 * unit);
        }
    }
    check_table(1e100, 0.0);
    check_table(0.0, 0.0);
}

#[test]
fn places_between_exact_positions_are_near_and_what_is_exact_stays() {
    let table = |low: f32, high: f32| {
        let mut scan = Scan::NONE;
        [low, high].into_iter().for_each(|x| scan.take([x; 3]));
        scan.table(false)
    };
    for (low, high) in [(-1.0, 3.0), (1.5, 3.0), (1e-9, 2e-9), (-1e8, 1e8)] {
        let table = table(low, high);
        assert_eq!(table.place([low.into(), high.into(), 0.0]), [low, high, 0.0]);
        let greatest = f64::from(high.max(-low));
        for i in 0..1000 {
            let x = f64::from(low) + f64::from(high - low) * f64::from(i) / 1000.0;
            let off = f64::from(table.place([x; 3])[0]) - x;
            assert!(off.abs() <= table.error.into(), "{off:e} at {x:e}: {table:?}");
        }
        assert!(f64::from(table.error) < 1.1 * f64::from(f32::UNIT) * greatest);
    }
    // Far from the origin places are finer around the middle.
    let far = table(1000.0, 1001.0);
    assert_eq!((far.origin, far.scale), ([1000.5; 3], 1.0));
    assert!(f64::from(far.error) < 0.6 * f64::from(f32::UNIT));
}

#[test]
fn exact_positions_are_kept_where_filters_neither_overflow_nor_flush() {
    let scan = |x: f64| {
        let mut scan = Scan::NONE;
        scan.take([x; 3]);
        scan.take([-x; 3]);
        scan
    };
    assert_eq!(scan(1.5).table(true), Table::AS_GIVEN);
    assert_eq!(scan(EXACT_LIMIT).table(true), Table::AS_GIVEN);
    assert_eq!(scan(LEAST_EXACT).table(true), Table::AS_GIVEN);
    assert_eq!(scan(0.0).table(true), Table::AS_GIVEN);
    assert!(scan(2.0 * EXACT_LIMIT).table(true).scale < 1.0 && scan(1e38).table(true).error > 0.0);
    // Differences are far from being flushed; the unit is no denormal if it need not be.
    for e in 75..=149 {
        let table = scan(0.5f64.powi(e)).table(true);
        let size = table.scale * 0.5f64.powi(e);
        assert!((0.5f64.powi(16)..65_537.0).contains(&size), "2^-{e}: {table:?}");
        assert_eq!((1.0 / table.scale) as f32 >= f32::MIN_POSITIVE, e <= 142, "2^-{e}");
    }
}

/// A place may be off by as much as it says in each of three coordinates: along a diagonal.
#[test]
fn contacts_reach_along_a_diagonal() {
    // Half of the extent just above a power of two: rounding is worst there.
    let half = 1.0 + 0.999 * f64::from(f32::UNIT);
    let mut scan = Scan::NONE;
    [[-half; 3], [half; 3]].into_iter().for_each(|p| scan.take(p));
    let table = scan.table(true);
    let off = table.place([half; 3]).map(|x| f64::from(x) - half);
    let off = off.iter().map(|x| x * x).sum::<f64>().sqrt();
    let reach = f64::from(table.contact_reach(0.0));
    assert!(reach >= off && reach < 1.02 * off, "{reach:e}, but {off:e}");
    assert!(reach >= 3f64.sqrt() * f64::from(table.error), "{reach:e}: {table:?}");
}

#[test]
fn a_guess_covers_what_is_near_and_of_the_same_kind() {
    let scan = |x: &[[f64; 3]]| {
        let mut scan = Scan::NONE;
        scan.take_all(x, x);
        scan
    };
    let last = scan(&[[-1.0, 0.5, 3.0], [0.0, 0.0, 1.0]]);
    let guess = last.guess([0.0; 3], 1.0 / 64.0);
    assert!(last.covers(&last) && guess.covers(&last) && !last.covers(&guess));
    let of = |x: f64| scan(&[[-1.0, 0.5, x], [0.0, 0.0, 1.0]]);
    // The longest side is 2.
    assert!(guess.covers(&of(3.03125)) && !guess.covers(&of(3.0625)));
    assert!(
        last.guess([0.0, 0.0, 0.5], 0.0).covers(&scan(&[[-0.5, 0.25, 3.5], [-0.5, 0.25, 2.0]]))
    );
    for k in 0..3 {
        for far in [-1.0625, 3.0625, f64::NAN, f64::INFINITY] {
            let mut p = [0.0; 3];
            p[k] = far;
            assert!(!guess.covers(&scan(&[p])), "{p:?}");
        }
    }
    // Exact or not, and as they are or in another unit.
    assert!(!guess.covers(&of(2.0 + 1e-12)) && !of(2.0 + 1e-12).covers(&last));
    assert!(!guess.covers(&scan(&[[1e-30; 3]])));
    // Far from the origin places are rounded by hardly more than without a guess.
    let far = scan(&[[1e8 + 0.1, 0.0, 1e8], [1e8 + 1.0, 1.0, 1e8 + 1.1]]);
    let [before, after] = [far, far.guess([0.0; 3], 1.0 / 64.0)].map(|of| of.table(true).error);
    assert!(before < after && after < 32.0 * before, "{before:e}, {after:e}");
}
