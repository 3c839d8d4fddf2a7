//! Bounds of advancement, of its witness, and of containment's time and sums, each alone against
//! the adversary.
//!
//! Ratios are those of docs/ERROR-BOUNDS.md: error over bound, above 1 where a bound does not hold.

use crate::common::adversary::{Adversarial, UNIT};
use crate::common::ascent::Ascent;
use crate::common::distance::{point_triangle, segment_segment};
use crate::common::motion::{V, at, minus, motion, scalar, wrap};
use ccd_core::narrow_phase::conservative_advancement::{Field, Separation, greatest_distance};
use ccd_core::narrow_phase::containment::{around, conditions};
use ccd_core::narrow_phase::relative_motion::Patch;

const ZERO: Adversarial = Adversarial(0.0);

/// How far corners are that are known exactly, all the same, and how far they must be.
fn separation([start, end]: [f64; 2], w: V, min_distance: f64) -> Separation<Adversarial> {
    let corner = |x: f64| [wrap([x, 0.0, 0.0]); 4];
    let min_distance = Adversarial(min_distance);
    Field { corners: [corner(start), corner(end)], slack: ZERO, min_distance }.along(wrap(w))
}

/// The separation at a time, from those at both ends, and the sum of their sizes.
fn line(s: &Separation<Adversarial>, t: f64) -> [f64; 2] {
    let (g0, g1) = (s.g0[0].0, s.g1[0].0);
    [g0 + (g1 - g0) * t, g0.abs() + g1.abs()]
}

#[test]
fn separations_at_a_time() {
    let times = |x: &[f64]| [0.5 + 0.5 * x[4], 0.5 + 0.5 * x[5]];
    let both = |x: &[f64]| [0, 2].map(|i| separation([x[i], x[i + 1]], [1.0, 0.0, 0.0], 0.0));
    let alone = |x: &[f64]| {
        let ([s, _], [t, _]) = (both(x), times(x));
        let [exact, size] = line(&s, t);
        1.0 + (s.excess(0, Adversarial(t)).0 - exact) / (12.0 * UNIT * size)
    };
    Ascent { n_inputs: 6, flush: false, ratio: alone }.check("separation", 1, [2, 200], 0.33);
    // Between two directions: each at the time of the other.
    let turning = |x: &[f64]| {
        let ([s, v], [t, end]) = (both(x), times(x));
        let ([p, p_size], [q, q_size]) = (line(&s, end), line(&v, t));
        let sum = s.excess(0, Adversarial(end)) + v.excess(0, Adversarial(t));
        1.0 + (sum.0 - (p + q)) / (12.0 * UNIT * (p_size + q_size))
    };
    Ascent { n_inputs: 6, flush: false, ratio: turning }.check("turning", 2, [2, 300], 0.41);
}

#[test]
fn lengths_of_directions() {
    let ratio = |x: &[f64]| {
        let (w, d) = ([x[0], x[1], x[2]], 1.0 + 0.5 * x[3]);
        let exact = d * scalar(w, w).sqrt();
        1.0 + (exact - separation([0.0; 2], w, d).needed[0].0) / (12.0 * UNIT * exact)
    };
    Ascent { n_inputs: 4, flush: false, ratio }.check("length", 3, [2, 200], 0.54);
}

#[test]
fn times_that_a_direction_reaches() {
    let ratio = |x: &[f64]| {
        let (g0, g1, needed) = (1.5 + 0.5 * x[0], -0.5 + 0.5 * x[1], 0.5 + 0.5 * x[2]);
        let all = |g: f64| [Adversarial(g); 4];
        let s = Separation { g0: all(g0), g1: all(g1), needed: all(needed) };
        let exact = (g0 - needed) / (g0 - g1);
        1.0 + (s.reach_of(0, ZERO).0 - exact) / (16.0 * UNIT * exact)
    };
    Ascent { n_inputs: 3, flush: false, ratio }.check("reach", 4, [2, 100], 0.56);
}

#[test]
fn witnesses_are_no_nearer_than_the_features() {
    for (patch, distance, error, documented) in [
        (Patch::Triangle, point_triangle as fn([V; 4]) -> f64, 0.0, 0.099),
        (Patch::Parallelogram, segment_segment, 0.0, 0.11),
        (Patch::Parallelogram, segment_segment, 0.01, 0.097),
    ] {
        let ratio = |x: &[f64]| {
            let t = 0.5 + 0.5 * x[48];
            let (m, [a, b, c]) = motion(x, patch, 1.0, error);
            let [a, b, c] = [at(&a, t), at(&b, t), at(&c, t)];
            let exact = distance(match patch {
                Patch::Triangle => [a, [0.0; 3], b, c],
                Patch::Parallelogram => [[0.0; 3], b, a, minus(a, c)],
            });
            let bound = 4.0 * m.corner_error().0 + 8.0 * UNIT * exact;
            1.0 + (exact - greatest_distance(&m, patch, Adversarial(t)).0) / bound
        };
        let name = format!("witness, {patch:?} {error}");
        Ascent { n_inputs: 49, flush: false, ratio }.check(&name, 5, [2, 100], documented);
    }
}

#[test]
fn intervals_are_held_by_their_middle_and_width() {
    for (name, end, documented) in [("start", false, 0.25), ("end", true, 0.5)] {
        let ratio = |x: &[f64]| {
            let (p, q) = (0.5 + 0.5 * x[0], 0.5 + 0.5 * x[1]);
            let (lo, hi) = (p.min(q), p.max(q));
            let (middle, half) = around(Adversarial(lo), Adversarial(hi));
            let (middle, half) = (middle.0, half.0);
            let beyond = if end { hi - (middle + half) } else { (middle - half) - lo };
            1.0 + beyond / (4.0 * UNIT)
        };
        Ascent { n_inputs: 2, flush: false, ratio }.check(name, 6, [2, 200], documented);
    }
}

#[test]
fn sums_of_products() {
    for (patch, documented) in [(Patch::Triangle, 0.5), (Patch::Parallelogram, 0.25)] {
        let ratio = |x: &[f64]| {
            let [d, s, r] = [x[0], x[1], x[2]].map(|v| (Adversarial(v), ZERO));
            let (value, error) = conditions(patch, d, s, r)[2];
            let exact = match patch {
                Patch::Triangle => x[0] - x[1] - x[2],
                Patch::Parallelogram => x[0] - x[1],
            };
            (value.0 - exact) / error.0
        };
        let name = format!("sum, {patch:?}");
        Ascent { n_inputs: 3, flush: false, ratio }.check(&name, 7, [2, 100], documented);
    }
}
