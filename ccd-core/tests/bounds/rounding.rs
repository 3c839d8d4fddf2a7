//! Every bound against an adversary: each operation off by one unit of roundoff either way, ascent
//! on error over bound.
//!
//! A ratio above 1 is a bound that does not hold; each test also reaches the ratio that
//! docs/ERROR-BOUNDS.md states.

use crate::common::adversary::{Adversarial, MIN_NORMAL, UNIT, under, undisturbed};
use crate::common::ascent::Ascent;
use crate::common::motion::{V, at, cross, minus, motion, scalar, wrap};
use ccd_core::math::vec3::{dot, sum_abs};
use ccd_core::narrow_phase::containment::{Ball, cross2};
use ccd_core::narrow_phase::coplanarity::Coplanarity;
use ccd_core::narrow_phase::cubic_roots::Cubic;
use ccd_core::narrow_phase::relative_motion::Patch;
use ccd_core::narrow_phase::separating_direction::beside;

/// Three times a Bernstein value of the cubic.
fn control([a, b, c]: &[[V; 2]; 3], k: usize) -> f64 {
    let triple = |i: usize, j: usize, l: usize| scalar(a[i], cross(b[j], c[l]));
    match k {
        0 => 3.0 * triple(0, 0, 0),
        1 => triple(1, 0, 0) + triple(0, 1, 0) + triple(0, 0, 1),
        2 => triple(0, 1, 1) + triple(1, 0, 1) + triple(1, 1, 0),
        _ => 3.0 * triple(1, 1, 1),
    }
}

/// The error of a control value over its bound.
fn check_control(name: &str, k: usize, size: f64, error: f64, documented: f64) {
    let ratio = |x: &[f64]| {
        let (m, exact) = motion(x, Patch::Triangle, size, error);
        let plane = Coplanarity::new(&m);
        let c = plane.c[k].0 * if k == 0 || k == 3 { 3.0 } else { 1.0 };
        (c - control(&exact, k)) / plane.bound.0
    };
    let ascent = Ascent { n_inputs: 48, flush: size < 1e-6, ratio };
    ascent.check(name, 1 + k as u64, [2, 200], documented);
}

#[test]
fn control_values() {
    check_control("control value 0", 0, 1.0, 0.0, 0.11);
    check_control("control value 1", 1, 1.0, 0.0, 0.11);
    check_control("control value 1, input", 1, 1.0, 0.01, 0.17);
    check_control("control value 1, flushed", 1, 2e-13, 0.0, 0.016);
}

#[test]
fn parts_of_steps() {
    for (name, size, error, documented) in [
        ("part of a step", 1.0, 0.0, 0.5),
        ("part of a step, input", 1.0, 1e-6, 0.5),
        ("part of a step, flushed", 1e-37, 0.0, 0.12),
    ] {
        let ratio = |x: &[f64]| {
            let (m, exact) = motion(x, Patch::Triangle, size, error);
            let times = [x[48], x[49]].map(|t| 0.5 + 0.5 * t);
            let part = m.part(Adversarial(times[0]), Adversarial(times[1]));
            (part.a[1][0].0 - at(&exact[0], times[1])[0]) / part.error.0
        };
        Ascent { n_inputs: 50, flush: size < 1e-6, ratio }.check(name, 5, [2, 600], documented);
    }
}

#[test]
fn clipped_times() {
    // Inputs: three times the control values, and what they must exceed. How much later than when
    // the steepest line from the first of them is as low, without the part that is taken off; the
    // roundings of values that are multiplied by three are in the bound of the cubic.
    let ratio = |x: &[f64]| {
        let needed = 0.5 + 0.49 * x[4];
        let c = [x[0] / 3.0, x[1], x[2], x[3] / 3.0].map(Adversarial);
        let plane = Coplanarity { c, bound: Adversarial(needed), normal: Adversarial(1.0) };
        let control = [3.0 * c[0].0, c[1].0, c[2].0, 3.0 * c[3].0];
        let sign = control[0].signum();
        let fall = |k: usize, by: f64| sign * (control[0] - control[k]) * by;
        let steepest = fall(1, 3.0).max(fall(2, 1.5)).max(fall(3, 1.0));
        let first = (control[0].abs() - needed) / steepest;
        if !(0.01..1.0).contains(&first) {
            return f64::NEG_INFINITY;
        }
        let got = plane.clip(Adversarial(0.0))[0].0;
        let greatest = control.iter().fold(0.0f64, |m, c| m.max(c.abs()));
        let allowed = 32.0 * UNIT * first + 2.0 * UNIT * greatest / steepest;
        (got - first * (1.0 - 32.0 * UNIT)) / allowed
    };
    Ascent { n_inputs: 5, flush: false, ratio }.check("clipped time", 6, [4, 200], 0.2);
}

#[test]
fn greatest_normal() {
    for (name, size, error, documented) in [
        ("normal", 1.0, 0.0, 0.27),
        ("normal, input", 1.0, 0.01, 0.22),
        ("normal, flushed", 1e-19, 0.0, 0.0099),
    ] {
        let ratio = |x: &[f64]| {
            let (m, [_, b, c]) = motion(x, Patch::Triangle, size, error);
            let (p, q) = (cross(b[0], c[1]), cross(b[1], c[0]));
            let middle = std::array::from_fn(|k| 0.5 * (p[k] + q[k]));
            let normals = [cross(b[0], c[0]), middle, cross(b[1], c[1])];
            let greatest = normals.map(|n| scalar(n, n).sqrt()).into_iter().fold(0.0, f64::max);
            let [_, b, c] = undisturbed(|| m.magnitudes()).map(|x| x.0);
            // What is added to the rounded sums of components.
            let added = 64.0 * UNIT * b * c
                + 6.0 * m.error.0 * (b + c)
                + 256.0 * MIN_NORMAL * (1.0 + b) * (1.0 + c);
            1.0 + (greatest - Coplanarity::new(&m).normal.0) / added
        };
        let n_inputs = if error > 0.0 { 48 } else { 24 };
        let ascent = Ascent { n_inputs, flush: size < 1e-6, ratio };
        ascent.check(name, 7, [4, 400], documented);
    }
}

#[test]
fn corners_along_a_direction() {
    for (patch, size, error, documented) in [
        (Patch::Triangle, 1.0, 0.0, 0.22),
        (Patch::Parallelogram, 1.0, 0.0, 0.25),
        (Patch::Parallelogram, 1.0, 0.01, 0.33),
        (Patch::Parallelogram, 1e-37, 0.0, 0.05),
    ] {
        let ratio = |x: &[f64]| {
            let (m, [a, b, c]) = motion(x, patch, size, error);
            let w = [x[48], x[49], x[50]];
            let (corner, exact) = match patch {
                Patch::Triangle => (1, minus(a[1], b[1])),
                Patch::Parallelogram => (3, minus(minus(a[1], b[1]), c[1])),
            };
            let got = dot(wrap(w), m.corners(patch, 1)[corner]).0;
            (got - scalar(w, exact)) / (m.corner_error().0 * sum_abs(w))
        };
        let name = format!("corner, {patch:?} {size} {error}");
        Ascent { n_inputs: 51, flush: size < 1e-6, ratio }.check(&name, 9, [2, 200], documented);
    }
}

#[test]
fn separations_beside() {
    for (patch, documented) in [(Patch::Triangle, 0.017), (Patch::Parallelogram, 0.016)] {
        // Points that touch at both ends in the same corner or along the same side: the true
        // separation is nowhere positive.
        let ratio = |x: &[f64]| {
            let mut x = x.to_vec();
            let (s, r) = match (x[24] > 0.0, patch) {
                (true, _) => (0.5 * x[25] + 0.5, 0.0),
                (false, Patch::Triangle) => (0.5 * x[25] + 0.5, 0.5 - 0.5 * x[25]),
                (false, Patch::Parallelogram) => (1.0, 0.5 * x[25] + 0.5),
            };
            for t in [0, 12] {
                for k in 0..3 {
                    let p = |i: usize| x[t + 3 * i + k];
                    match patch {
                        Patch::Triangle => x[t + k] = p(1) + s * (p(2) - p(1)) + r * (p(3) - p(1)),
                        // eb0 = ea0 + s b + r (eb0 - eb1): moves both ends of the edge b.
                        Patch::Parallelogram => {
                            let c = p(2) - p(3);
                            let eb0 = p(0) + s * (p(1) - p(0)) + r * c;
                            (x[t + 6 + k], x[t + 9 + k]) = (eb0, eb0 - c);
                        }
                    }
                }
            }
            x.resize(48, 0.0);
            let separation = || beside(&motion(&x, patch, 1.0, 0.0).0, patch, Adversarial(0.0)).0;
            // Without errors of rounding nearly the bound alone is left.
            let bound = -undisturbed(separation);
            1.0 + separation() / bound
        };
        let ascent = Ascent { n_inputs: 26, flush: false, ratio };
        ascent.check(&format!("beside, {patch:?}"), 11, [2, 200], documented);
    }
}

#[test]
fn values_of_cubics() {
    // Inputs: four coefficients and a time.
    let largest = |x: &[f64]| x[..4].iter().fold(0.0f64, |m, c| m.max(c.abs()));
    let exact = |x: &[f64], t: f64| {
        let s = 1.0 - t;
        x[0] * s * s * s + x[1] * s * s * t + x[2] * s * t * t + x[3] * t * t * t
    };
    let cubic = |x: &[f64]| Cubic::new([x[0], x[1], x[2], x[3]].map(Adversarial), Adversarial(0.0));
    let value = |x: &[f64]| {
        let t = 0.5 + 0.5 * x[4];
        (cubic(x).value(Adversarial(t)).0 - exact(x, t)) / (12.0 * UNIT * largest(x))
    };
    let ascent = Ascent { n_inputs: 5, flush: false, ratio: value };
    ascent.check("value of a cubic", 13, [2, 600], 0.66);
    // The value at a critical point as found, against the true extreme value.
    let turning = |x: &[f64]| {
        let (ends, n) = cubic(x).pieces();
        let q = [x[1] - 3.0 * x[0], x[2] - x[1], 3.0 * x[3] - x[2]];
        let d = q[1] * q[1] - q[0] * q[2];
        if n < 2 || d <= 0.0 {
            return f64::NEG_INFINITY;
        }
        let i = if x[4] > 0.0 { 1 } else { n - 1 };
        let z = -(q[1] + if q[1] < 0.0 { -d.sqrt() } else { d.sqrt() });
        let near = |t: f64| (t - ends[i].0).abs();
        let (t, u) = (z / (z + q[2]), q[0] / (q[0] + z));
        let t = if near(t) < near(u) { t } else { u };
        if !(near(t) < 0.01) {
            return f64::NEG_INFINITY;
        }
        let got = cubic(x).value(ends[i]).0;
        let sign = if x[5] > 0.0 { 1.0 } else { -1.0 };
        sign * (got - exact(x, t)) / (256.0 * UNIT * largest(x))
    };
    let ascent = Ascent { n_inputs: 6, flush: false, ratio: turning };
    ascent.check("value at a critical point", 15, [3, 700], 0.0126);
}

#[test]
fn balls_and_products_over_an_interval() {
    // Widths of the interval: none (rounding alone), and all of the step.
    for (width, error, documented) in [
        (0.0, 0.0, [0.43, 0.41]),
        (1.0, 0.0, [0.99, 0.71]),
        (0.0, 0.01, [0.99, 0.88]),
        (1e-3, 1e-4, [0.99, 0.93]),
    ] {
        let vector = |x: &[f64], from: usize| -> ([[Adversarial; 3]; 2], [V; 2]) {
            let given = [0, 3].map(|i| -> V { std::array::from_fn(|k| x[from + i + k]) });
            let true_ones = [0, 3].map(|i| -> V {
                std::array::from_fn(|k| x[from + i + k] + error * x[from + 6 + i + k])
            });
            (given.map(wrap), true_ones)
        };
        let times = |x: &[f64]| {
            let lo = (0.5 + 0.5 * x[24]) * (1.0 - width);
            (lo, width, if x[25] > 0.0 { lo } else { lo + width })
        };
        let ball = |x: &[f64], v: &[[Adversarial; 3]; 2]| {
            let (lo, width, _) = times(x);
            let half = Adversarial(width) * Adversarial(0.5);
            let middle = Adversarial(lo) + half;
            Ball::new(v, middle, half + Adversarial(4.0 * UNIT), Adversarial(error))
        };
        let radius = |x: &[f64]| {
            let (v, exact) = vector(x, 0);
            let b = ball(x, &v);
            (b.centre[0].0 - at(&exact, times(x).2)[0]) / b.radius.0
        };
        let name = format!("ball, width {width}, input error {error}");
        let ascent = Ascent { n_inputs: 26, flush: false, ratio: radius };
        ascent.check(&name, 17, [2, 250], documented[0]);
        let product = |x: &[f64]| {
            let ((p, p_true), (q, q_true)) = (vector(x, 0), vector(x, 12));
            let (value, bound) = cross2(&ball(x, &p), &ball(x, &q));
            let t = times(x).2;
            (value.0 - cross(at(&p_true, t), at(&q_true, t))[2]) / bound.0
        };
        let name = format!("product, width {width}, input error {error}");
        let ascent = Ascent { n_inputs: 26, flush: false, ratio: product };
        ascent.check(&name, 19, [2, 250], documented[1]);
    }
}

#[test]
fn flushed_products_of_balls() {
    // One vector of any size, the other of about the smallest normal number.
    let ratio = |x: &[f64]| {
        let vector = |from: usize, size: f64| -> [V; 2] {
            [0, 3].map(|i| std::array::from_fn(|k| size * x[from + i + k]))
        };
        let (p, q) = (vector(0, 1.0), vector(6, 2.0 * MIN_NORMAL));
        let t = 0.5 + 0.5 * x[12];
        let ball =
            |v: [V; 2]| Ball::new(&v.map(wrap), Adversarial(t), Adversarial(0.0), Adversarial(0.0));
        let (value, bound) = cross2(&ball(p), &ball(q));
        (value.0 - cross(at(&p, t), at(&q, t))[2]) / bound.0
    };
    Ascent { n_inputs: 13, flush: true, ratio }.check("product, flushed", 21, [2, 200], 0.004);
}

#[test]
fn the_search_finds_a_bound_that_is_too_small() {
    let ratio = |x: &[f64]| {
        let (m, exact) = motion(x, Patch::Triangle, 1.0, 0.0);
        let time = 0.5 + 0.5 * x[24];
        let part = m.part(Adversarial(time), Adversarial(1.0));
        (part.a[0][0].0 - at(&exact[0], time)[0]) / (0.4 * part.error.0)
    };
    assert!(Ascent { n_inputs: 25, flush: false, ratio }.climb(5, 2, 600).ratio > 1.0);
    // And each choice of the adversary counts.
    let sum = |choices: &[i8]| under(choices, false, || (Adversarial(1.0) + Adversarial(1.0)).0).0;
    assert_eq!([sum(&[-1]), sum(&[]), sum(&[1])], [2.0 - 2.0 * UNIT, 2.0, 2.0 + 2.0 * UNIT]);
}
