//! Queries with a minimum distance against the first time at which an independent distance is as
//! small.

use crate::common::distance::{First, first_within, point_triangle, segment_segment};
use crate::common::random::Random;
use crate::common::{Points, widen};
use ccd_core::narrow_phase::query::solve;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::{Real, TOI_TOLERANCE, Verdict};

type Distance = fn([[f64; 3]; 4]) -> f64;

/// A query, its minimum distance, and what measures its distance: a function, and the points of the
/// first feature.
struct Query<R> {
    patch: Patch,
    t0: Points<R>,
    t1: Points<R>,
    d: f64,
    distance: Distance,
    n_first: usize,
}

/// The least distance during the step, nearly.
fn least(distance: Distance, t0: &Points<f64>, t1: &Points<f64>) -> f64 {
    let at = |t: f64| {
        distance(std::array::from_fn(|i| {
            std::array::from_fn(|k| t0[i][k] + t * (t1[i][k] - t0[i][k]))
        }))
    };
    let start =
        (0..=64).map(|i| i as f64 / 64.0).min_by(|a, b| at(*a).total_cmp(&at(*b))).unwrap_or(0.0);
    let (mut lo, mut hi) = ((start - 1.0 / 64.0).max(0.0), (start + 1.0 / 64.0).min(1.0));
    for _ in 0..60 {
        let (p, q) = (lo + (hi - lo) * 0.4, lo + (hi - lo) * 0.6);
        if at(p) < at(q) { hi = q } else { lo = p }
    }
    at(0.5 * (lo + hi))
}

/// Points that move anyhow, fast or slowly; the distance is anything or nearly the least that they
/// reach.
fn query<R: Real>(random: &mut Random) -> Query<R> {
    let slow = random.power(-10.0, 1.0);
    let t0: Points<f64> = std::array::from_fn(|_| random.vector());
    let t1 = t0.map(|p| std::array::from_fn(|k| p[k] + slow * random.between(-1.0, 1.0)));
    let narrow = |x: Points<f64>| x.map(|p| p.map(R::from_f64));
    let (t0, t1) = (narrow(t0), narrow(t1));
    let (patch, distance, n_first): (_, Distance, _) = match random.below(2) {
        0 => (Patch::Triangle, point_triangle, 1),
        _ => (Patch::Parallelogram, segment_segment, 2),
    };
    let d = match random.below(4) {
        0 => random.power(-12.0, 0.0),
        _ => least(distance, &widen(&t0), &widen(&t1)) * (1.0 + random.power(-36.0, 0.0)),
    };
    Query { patch, t0, t1, d: R::from_f64(d).to_f64(), distance, n_first }
}

fn check<R: Real>(random: &mut Random, late: f64) -> [usize; 3] {
    let Query { patch, t0, t1, d, distance, n_first } = query::<R>(random);
    let zero = R::splat(0.0);
    let m = Motion::new(patch, &t0, &t1, zero);
    let verdict = solve(&m, patch, R::from_f64(d));
    let toi = verdict.toi().map(|t| t.to_f64());
    let first = first_within(distance, n_first, &widen(&t0), &widen(&t1), d);
    let hit = matches!(verdict, Verdict::Hit { .. });
    let fine = match first {
        First::At(t) => {
            toi.is_some_and(|toi| toi <= t + late && (!hit || toi >= t - TOI_TOLERANCE - late))
        }
        First::Never => !hit,
        First::Unclear => true,
    };
    assert!(fine, "{verdict:?}, but {first:?}: {patch:?} {t0:?} {t1:?} {d:?}");
    [hit as usize, matches!(first, First::At(_)) as usize, toi.is_none() as usize]
}

fn check_many<R: Real>(n: usize, seed: u64, late: f64) {
    let mut random = Random::new(seed);
    let mut sum = [0; 3];
    for _ in 0..n {
        let one = check::<R>(&mut random, late);
        (0..3).for_each(|k| sum[k] += one[k]);
    }
    println!("hits, first times, misses of {n}: {sum:?}");
    assert!(sum.iter().all(|k| *k > n / 20), "{sum:?} of {n} show little");
}

#[test]
fn hits_at_a_distance_are_as_early_as_promised() {
    check_many::<f64>(10_000, 1, 2e-9);
    check_many::<f32>(10_000, 2, 1e-8);
}
