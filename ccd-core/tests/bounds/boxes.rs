//! Boxes, margins, tables and separating axes: what must hold for every number, checked in a wider
//! arithmetic.

use crate::common::adversary::{Adversarial, undisturbed};
use crate::common::ascent::Ascent;
use crate::common::motion::wrap;
use crate::common::random::Random;
use ccd_core::backend::broad_phase::swept_box::{end, end_error, swept};
use ccd_core::backend::quantization::{Scan, margin, slack_at};
use ccd_core::math::vec3::sub;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::separating_direction::{axis_separated, beside};
use ccd_core::{Aabb, Num, Real};

fn number(random: &mut Random) -> f64 {
    random.sign() * random.power(-20.0, 20.0)
}

/// Boxes of two points along one axis, a gap apart, grown for a minimum distance.
fn grown<R: Real>(x: f64, min_distance: f64) -> Aabb<f32> {
    let p = [R::from_f64(x); 3];
    swept(p, p).inflated(margin(min_distance)).round_out()
}

fn check_margin<R: Real>(x: f64, gap: f64, min_distance: f64) {
    let (x, y) = (R::from_f64(x).to_f64(), R::from_f64(x + gap).to_f64());
    if (y - x).abs() <= min_distance {
        let (a, b) = (grown::<R>(x, min_distance), grown::<R>(y, min_distance));
        assert!(a.overlaps(&b), "{x:e} and {y:e} within {min_distance:e}: {a:?} {b:?}");
    }
}

#[test]
fn grown_boxes_of_features_within_the_distance_overlap() {
    let mut random = Random::new(1);
    for _ in 0..200_000 {
        let (x, d) = (number(&mut random), random.power(-20.0, 4.0));
        let gap = random.sign() * d * [1.0, random.between(0.5, 1.0)][random.below(2)];
        check_margin::<f64>(x, gap, d);
        check_margin::<f32>(x, gap, d);
        check_margin::<f32>(x * 1e-42, gap * 1e-42, d * 1e-42);
        assert!(margin::<f32>(d) as f64 >= 0.5 * d && margin::<f64>(d) >= 0.5 * d, "{d:e}");
    }
    // Further apart they need not, and mostly do not.
    assert!(!grown::<f64>(0.0, 0.1).overlaps(&grown::<f64>(0.101, 0.1)));
}

#[test]
fn boxes_hold_what_they_are_of() {
    let mut random = Random::new(2);
    for _ in 0..100_000 {
        let mut point = || std::array::from_fn(|_| number(&mut random));
        let (p, q): ([f64; 3], [f64; 3]) = (point(), point());
        let exact = swept(p, q);
        let rounded = exact.round_out();
        let narrow = swept(p.map(|c| c as f32), q.map(|c| c as f32));
        let grow = random.power(-30.0, 10.0) as f32;
        let grown = narrow.inflated(grow);
        for k in 0..3 {
            for c in [p[k], q[k]] {
                assert!(exact.min[k] <= c && c <= exact.max[k], "{c:e} in {exact:?}");
                let (low, high) = (rounded.min[k] as f64, rounded.max[k] as f64);
                assert!(low <= c && c <= high, "{c:e} in {rounded:?}");
            }
            // Sums of two numbers of f32 this near are exact in f64.
            let by = grow as f64;
            let (low, high) = (narrow.min[k] as f64 - by, narrow.max[k] as f64 + by);
            let holds = grown.min[k] as f64 <= low && grown.max[k] as f64 >= high;
            assert!(holds, "{narrow:?} grown by {grow:e}");
        }
    }
}

#[test]
fn rounded_boxes_overlap_by_no_more_than_the_slack_unless_they_do_in_truth() {
    let mut random = Random::new(3);
    let mut n = 0;
    for _ in 0..200_000 {
        let x = number(&mut random);
        let y = x * (1.0 + random.power(-30.0, -22.0));
        let (a, b) = ([x.min(y); 3], [x.max(y); 3]);
        let (a, b) =
            (Aabb { min: a.map(|c| c - 1.0), max: a }, Aabb { min: b, max: b.map(|c| c + 1.0) });
        let depth = a.round_out().max[0] - b.round_out().min[0];
        n += (depth > 0.0) as usize;
        let slack = slack_at(x.abs().max(y.abs()).round_up());
        assert!(a.overlaps(&b) || depth <= slack, "{x:e} {y:e}: {depth:e}, more than {slack:e}");
        // And it is no more than it must be, up to a factor of 4 and rounding.
        let least = 2.0 * f32::UNIT * x.abs().max(y.abs()) as f32 + f32::MIN_POSITIVE;
        assert!(slack <= 4.001 * least, "{slack:e}");
    }
    assert!(n > 10_000, "{n} overlaps that rounding made");
}

/// Places what lies between two numbers of `f32` as far as possible; returns the greatest error as
/// a multiple of the bound.
fn check_table(low: f64, high: f64) -> f64 {
    let mut scan = Scan::NONE;
    scan.take([low; 3]);
    scan.take([high; 3]);
    let table = scan.table(true);
    let mut worst = 0f64;
    // Near the ends, where numbers of f32 are furthest apart.
    for i in 0..2000 {
        let off = i as f64 * 1e-12 * (high - low);
        let p = if i % 2 == 0 { low + off } else { high - off };
        let want = (p - table.origin[0]) * table.scale;
        worst = worst.max((table.place([p; 3])[0] as f64 - want).abs() / table.error as f64);
    }
    assert!(worst <= 1.0, "{low:e} .. {high:e}: {worst} of the bound");
    worst
}

#[test]
fn positions_in_a_table_are_as_near_as_it_says() {
    // Half of the extent just above a power of two: rounding is worst there.
    let half = 1.0 + 0.999 * f32::UNIT as f64;
    assert!(check_table(-half, half) > 0.97);
    assert!(check_table(7.0 - half, 7.0 + half) > 0.97);
    let mut random = Random::new(4);
    for _ in 0..200 {
        let (x, y) = (number(&mut random), number(&mut random));
        check_table(x.min(y), x.max(y) + 1e-9);
    }
}

/// Of positions so far from the origin that a few numbers of `f64` lie between them, at the end of
/// a shortened step: the error beyond that of rounding to `f32`, as a part of the term for
/// recentring.
fn recentred(x: &[f64]) -> f64 {
    let part = |x: f64| 0.5 + 0.5 * x;
    // Places are whole spacings of f64 above `low`, 2^-52 each; sums of them are exact.
    let ulp = f64::EPSILON;
    let low = 1.0 + ((1u64 << 20) as f64 * 0.999 * part(x[0])).floor() / (1u64 << 20) as f64;
    let width = 2f64.powi((1.0 + 29.0 * part(x[1])).floor() as i32);
    let place = |x: f64| (width * part(x)).round();
    let until = ((1 << 16) as f64 * part(x[4])).round() / (1 << 16) as f64;
    let (p, q) = (place(x[2]), place(x[3]));
    let mut scan = Scan::NONE;
    scan.take([low; 3]);
    scan.take([low + width * ulp; 3]);
    let table = scan.table(false);
    let at = end([low + p * ulp; 3], [low + q * ulp; 3], until);
    let want = ((p + (q - p) * until) * ulp - (table.origin[0] - low)) * table.scale;
    let error = (table.place(at)[0] as f64 - want).abs();
    assert!(error <= table.error as f64, "{error:e}, but {table:?} at {x:?}");
    let reach = 0.5 * width * ulp;
    let rounded = 1.01 * f32::UNIT as f64 * reach * table.scale;
    (error - rounded) / (16.0 * f64::UNIT * scan.greatest() * table.scale)
}

#[test]
fn ends_of_shortened_steps() {
    let ratio = |x: &[f64]| {
        let until = 0.5 + 0.5 * x[2];
        let found = end(wrap([x[0], 0.0, 0.0]), wrap([x[1], 0.0, 0.0]), Adversarial(until))[0].0;
        let bound = undisturbed(|| end_error(Adversarial(1.0)).0);
        (found - (x[0] + (x[1] - x[0]) * until)) / bound
    };
    Ascent { n_inputs: 3, flush: false, ratio }.check("end of a step", 43, [2, 200], 0.31);
}

#[test]
fn ends_of_shortened_steps_in_a_table() {
    let ascent = Ascent { n_inputs: 5, flush: false, ratio: recentred };
    ascent.check("recentred", 41, [20, 1000], 0.062);
}

#[test]
fn an_axis_separates_at_both_ends_or_not_at_all() {
    let at = |x: f32| [[x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]];
    let check = |a0: f32, a1: f32, b0: f32, b1: f32, needed: f32, want: bool| {
        for turn in 0..3 {
            let turned =
                |b: [[f32; 3]; 2]| b.map(|p| [p[turn], p[(turn + 1) % 3], p[(turn + 2) % 3]]);
            let [p, q, r, s] = [a0, a1, b0, b1].map(|x| turned(at(x)));
            let both = [[&p, &q, &r, &s], [&r, &s, &p, &q]];
            let found = both.map(|[p, q, r, s]| axis_separated(p, q, r, s, needed));
            assert_eq!(found, [want; 2], "{a0} {a1} {b0} {b1} {needed} {turn}");
        }
    };
    check(0.0, 0.0, 2.0, 2.0, 0.0, true);
    check(0.0, 0.0, 2.0, 2.0, 0.999, true);
    // A gap of exactly what is needed, touching, apart at one end only, on different sides.
    check(0.0, 0.0, 2.0, 2.0, 1.0, false);
    check(0.0, 0.0, 1.0, 1.0, 0.0, false);
    check(0.0, 0.0, 2.0, 0.5, 0.0, false);
    check(0.0, 0.0, 2.0, -2.0, 0.0, false);
    // Enough at one end, too little at the other.
    check(0.0, 0.0, 1.5, 3.0, 1.0, false);
    check(0.0, 0.0, 3.0, 1.5, 1.0, false);
    check(f32::NAN, 0.0, 2.0, 2.0, 0.0, false);
    check(0.0, 0.0, 2.0, f32::NAN, 0.0, false);
}

#[test]
fn parts_are_where_the_motion_is() {
    let mut random = Random::new(5);
    for patch in [Patch::Triangle, Patch::Parallelogram] {
        let mut four = || std::array::from_fn(|_| random.vector());
        let (t0, t1): ([[f64; 3]; 4], [[f64; 3]; 4]) = (four(), four());
        let m = Motion::new(patch, &t0, &t1, 0.125);
        let part = m.part(0.25, 0.75);
        assert!(part.error > m.error && part.error < m.error + 1e-12);
        for (whole, part) in [(m.a, part.a), (m.b, part.b), (m.c, part.c)] {
            for (i, t) in [0.25, 0.75].into_iter().enumerate() {
                for k in 0..3 {
                    let want = whole[0][k] * (1.0 - t) + whole[1][k] * t;
                    assert!((part[i][k] - want).abs() < 1e-15);
                }
            }
        }
        // The hull of the corners holds the origin where the features meet: corners are differences
        // of points.
        let corners = m.corners(patch, 1);
        let want = match patch {
            Patch::Triangle => [(0, 1), (0, 2), (0, 3), (0, 1)],
            Patch::Parallelogram => [(2, 0), (2, 1), (3, 0), (3, 1)],
        };
        for (corner, (i, j)) in corners.into_iter().zip(want) {
            let apart = sub(corner, sub(t1[i], t1[j]));
            assert!(apart.iter().all(|c| c.abs() < 1e-14), "{patch:?} {i} {j}: {apart:?}");
        }
    }
}

#[test]
fn features_beside_each_other_keep_their_distance() {
    // A point beside a triangle, and an edge beside an edge, all in one plane, with a gap of 1/4.
    let triangle = [[0.25, -0.25, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    let edges = [[1.25, 0.25, 0.0], [2.0, 0.25, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]];
    for (patch, x) in [(Patch::Triangle, triangle), (Patch::Parallelogram, edges)] {
        let m = Motion::new(patch, &x, &x, 0.0);
        for (d, want) in
            [(0.0, true), (0.1, true), (0.249, true), (0.25, false), (0.251, false), (1.0, false)]
        {
            assert_eq!(beside(&m, patch, d) > 0.0, want, "{patch:?} at {d}");
        }
        // Apart at one end of the step only, on either side.
        let mirrored = x.map(|p| p.map(|c| -c));
        let mut onto = x;
        let first = if matches!(patch, Patch::Triangle) { 0..1 } else { 0..2 };
        first.for_each(|i| onto[i] = [onto[i][0] - 0.5, onto[i][1] + 0.5, 0.0]);
        for (t0, t1, want) in [(x, onto, false), (onto, x, false), (mirrored, mirrored, true)] {
            let backwards = [t0, t1].map(|x| x.map(|p| p.map(|c: f64| -c)));
            for [t0, t1] in [[t0, t1], backwards] {
                let m = Motion::new(patch, &t0, &t1, 0.0);
                assert_eq!(beside(&m, patch, 0.0) > 0.0, want, "{patch:?} {t0:?} {t1:?}");
            }
        }
        // Of points that are known up to an error, the gap may be less by twice that.
        for (error, want) in [(0.01, true), (0.126, false)] {
            let m = Motion { error: 2.0 * error, ..m };
            assert_eq!(beside(&m, patch, 0.0) > 0.0, want, "{patch:?} with errors of {error}");
        }
    }
}
