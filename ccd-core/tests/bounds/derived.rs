//! Every bound is at least what its derivation needs: counts of operations, written down anew from
//! docs/ERROR-BOUNDS.md.

use crate::common::Points;
use crate::common::random::Random;
use ccd_core::backend::broad_phase::swept_box::end_error;
use ccd_core::math::obb::Obb;
use ccd_core::narrow_phase::containment::{Ball, cross2};
use ccd_core::narrow_phase::coplanarity::Coplanarity;
use ccd_core::narrow_phase::cubic_roots::Cubic;
use ccd_core::narrow_phase::query::solve;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::separating_direction::beside;
use ccd_core::{Aabb, Real, TOI_TOLERANCE, Verdict};

/// Rounding of the bounds themselves and of what is computed here.
const NEARLY: f64 = 1.0 - 1e-5;

fn check<R: Real>(random: &mut Random, coordinate_error: f64) {
    let u = R::UNIT.to_f64();
    let mut points = || -> Points<R> { std::array::from_fn(|_| random.vector().map(R::from_f64)) };
    let (t0, t1) = (points(), points());
    let m = Motion::vertex_face(&t0, &t1, R::from_f64(coordinate_error));
    let e = m.error.to_f64();
    let [a, b, c] = [m.a, m.b, m.c]
        .map(|v| v.as_flattened().iter().fold(0.0f64, |m, x| m.max(x.to_f64().abs())) + e);
    let plane = Coplanarity::new(&m);
    let least = 18.0 * 23.0 * u * a * b * c + 18.0 * e * (a * b + b * c + c * a);
    assert!(plane.bound.to_f64() >= least * NEARLY, "{:?}, but {least:e}: {m:?}", plane.bound);
    let sums = |i: usize, j: usize| {
        let (p, q) = (m.b[i].map(|x| x.to_f64()), m.c[j].map(|x| x.to_f64()));
        [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
    };
    let (p, q) = (sums(0, 1), sums(1, 0));
    let middle = (0..3).map(|k| (0.5 * (p[k] + q[k])).abs()).sum::<f64>();
    let ends = [sums(0, 0), sums(1, 1)].map(|n| n.iter().map(|x| x.abs()).sum::<f64>());
    let least = middle.max(ends[0]).max(ends[1]) * (1.0 - 12.0 * u)
        + 36.0 * u * b * c
        + 6.0 * e * (b + c) * NEARLY;
    assert!(plane.normal.to_f64() >= least - 1e-3 * u, "{:?}, but {least:e}: {m:?}", plane.normal);
    let least = 6.0 * u * (a + b + c) + 3.0 * e;
    assert!(m.corner_error().to_f64() >= least, "{:?}, but {least:e}: {m:?}", m.corner_error());
    // A vector of a part of the step.
    let (part, least) = (m.part(R::from_f64(0.3), R::from_f64(0.8)), e + 6.0 * u * a.max(b).max(c));
    assert!(part.error.to_f64() >= least * NEARLY, "{:?}, but {least:e}: {m:?}", part.error);
    // A distance costs three times the distance times the normal.
    let d = random.power(-10.0, 2.0);
    let (near, far) =
        (plane.clearance(R::splat(0.0)).to_f64(), plane.clearance(R::from_f64(d)).to_f64());
    let least = 3.0 * d * plane.normal.to_f64();
    assert!(near - far >= least, "{near:e} - {far:e}, but {least:e}: {m:?} {d:e}");
    // Balls over an interval, and products of their vectors.
    let (middle, half) = (random.between(0.25, 0.75), random.power(-20.0, -2.0));
    let ball = |x: &[[R; 3]; 2]| Ball::new(x, R::from_f64(middle), R::from_f64(half), m.error);
    let travel =
        (0..3).map(|k| (m.a[1][k].to_f64() - m.a[0][k].to_f64()).abs()).fold(0.0, f64::max);
    let least = half * travel * (1.0 + 4.0 * u) + 6.0 * u * a + e;
    let (p, q) = (ball(&m.a), ball(&m.b));
    assert!(p.radius.to_f64() >= least, "{:?}, but {least:e}: {m:?}", p.radius);
    let [pr, ps, qr, qs] = [p.radius, p.size, q.radius, q.size].map(|x| x.to_f64());
    let least = 2.0 * (pr * qs + ps * qr) + 4.0 * u * ps * qs;
    let error = cross2(&p, &q).1.to_f64();
    assert!(error >= least, "{error:e}, but {least:e}: {m:?}");
}

/// A parabola above zero by less than its band may vanish; one far above does not.
fn check_band<R: Real>(error: f64) {
    let u = R::UNIT.to_f64();
    for (part, want) in [(0.0, true), (0.9, true), (2.2, false)] {
        // (s - t)^2 (s + t), raised.
        let depth = part * (240.0 * u + error);
        let c = [1.0 + depth, 3.0 * depth - 1.0, 3.0 * depth - 1.0, 1.0 + depth].map(R::from_f64);
        let n = Cubic::new(c, R::from_f64(error)).zero_intervals().1;
        assert_eq!(n > 0, want, "{part} of the band, input error {error:e}, {c:?}");
    }
}

/// What has no size is not known better than flushed operands and results allow.
fn check_flushed<R: Real>() {
    let points: Points<R> = [[R::splat(0.0); 3]; 4];
    let m = Motion::vertex_face(&points, &points, R::splat(0.0));
    let (plane, zero) = (Coplanarity::new(&m), R::splat(0.0));
    let ball = Ball::new(&m.a, zero, zero, zero);
    let nothing = Aabb { min: [zero; 3], max: [zero; 3] };
    let bounds = [
        (plane.bound, 90.0),
        (plane.normal, 60.0),
        (m.corner_error(), 22.0),
        (-beside(&m, Patch::Triangle, zero), 9.0),
        (cross2(&ball, &ball).1, 15.0),
        (Obb::of_box(&nothing).half[0], 4.0),
        (end_error(zero), 5.0),
    ];
    for (bound, least) in bounds {
        let least = least * R::MIN_NORMAL.to_f64();
        assert!(bound.to_f64() >= least, "{bound:?}, but {least:e}");
    }
}

/// A vertex that falls through a face, of points that are known up to an error, is told as soon as
/// it may touch.
#[test]
fn errors_of_the_input_make_a_hit_earlier() {
    let at = |y: f64| [[0.25, y, 0.25], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    for coordinate_error in [1e-10, 1e-9, 3e-9] {
        let m = Motion::vertex_face(&at(1.0), &at(-1.0), coordinate_error);
        let verdict = solve(&m, Patch::Triangle, 0.0);
        // The cubic is 1 - 2 t, and the components of all vectors are at most 1: 3 f is off by 18 e
        // 3.
        let latest = 0.5 - 0.5 * 18.0 * m.error * NEARLY;
        let Verdict::Hit { toi } = verdict else { panic!("{verdict:?}") };
        let early = toi <= latest && toi >= 0.5 - TOI_TOLERANCE;
        assert!(early, "{toi}, {latest} at the latest with errors of {coordinate_error:e}");
    }
}

#[test]
fn bounds_are_at_least_as_derived() {
    let mut random = Random::new(1);
    for i in 0..20_000 {
        let error = if i % 2 == 0 { 0.0 } else { random.power(-30.0, -2.0) };
        check::<f64>(&mut random, error);
        check::<f32>(&mut random, error);
    }
    check_flushed::<f64>();
    check_flushed::<f32>();
    check_band::<f64>(0.0);
    check_band::<f32>(0.0);
    check_band::<f64>(1e-3);
    check_band::<f32>(1e-3);
}
