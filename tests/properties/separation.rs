//! Certificates of staying apart against numbers without rounding: products and differences of
//! `f32` are exact in `f64`, and the oracle is exact altogether.

use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::separating_direction::{axis_separated, beside};
use ccd_testkit::generate::Random;
use ccd_testkit::grazing::exact::{Contact, contact};

type Box3 = [[f32; 3]; 2];
type Points = [[f32; 3]; 4];

/// Twice the unit roundoff of `f32`.
const TWO_UNITS: f64 = 1.0 / 8_388_608.0;

/// A number between -0.4 and 0.4 with all its digits, so that differences are rounded.
fn coordinate(random: &mut Random) -> f32 {
    (random.unit() as f32 - 0.5) * 0.731_058_6
}

fn random_box(random: &mut Random) -> Box3 {
    let low: [f32; 3] = std::array::from_fn(|_| coordinate(random));
    [low, low.map(|c| c + 0.2 * random.unit() as f32)]
}

/// The greatest gap along an axis that is kept at both ends, on the same side.
fn kept_gap([a0, a1, b0, b1]: [&Box3; 4]) -> f64 {
    let gap = |low: &Box3, high: &Box3, k: usize| f64::from(high[0][k]) - f64::from(low[1][k]);
    let sides = |k: usize| [gap(b0, a0, k).min(gap(b1, a1, k)), gap(a0, b0, k).min(gap(a1, b1, k))];
    (0..3).flat_map(sides).fold(f64::NEG_INFINITY, f64::max)
}

/// Whether what is said of four boxes is right, but for the gap of `2 u` that is allowed for.
fn axis_answer_is_right(boxes: [&Box3; 4], needed: f32, separated: bool) -> bool {
    let (gap, needed) = (kept_gap(boxes), f64::from(needed));
    if separated { gap > needed * (1.0 - TWO_UNITS) } else { gap <= needed * (1.0 + TWO_UNITS) }
}

#[test]
fn axis_separation_is_that_of_exact_gaps() {
    let mut random = Random::new(21);
    let (mut n_separated, mut n_wrong) = (0, [0, 0]);
    for i in 0..40_000 {
        let boxes: [Box3; 4] = std::array::from_fn(|_| random_box(&mut random));
        let [a0, a1, b0, b1] = boxes.each_ref();
        let gap = kept_gap([a0, a1, b0, b1]);
        // Far from the gap that there is, or within some units of it.
        let needed = match i % 4 {
            0 => 0.0,
            1 => 0.4 * random.unit() as f32,
            _ => (gap.max(0.0) as f32) * (1.0 + (random.unit() as f32 - 0.5) * 1e-6),
        };
        let separated = axis_separated(a0, a1, b0, b1, needed);
        let right = |needed, answer| axis_answer_is_right([a0, a1, b0, b1], needed, answer);
        assert!(right(needed, separated), "{boxes:?}, {needed}: {separated}, the gap is {gap}");
        n_separated += usize::from(separated);
        // Controls: the other answer, and the answer for a distance that is a millionth less.
        n_wrong[0] += usize::from(!right(needed, !separated));
        n_wrong[1] +=
            usize::from(!right(needed, axis_separated(a0, a1, b0, b1, needed * 0.999_999)));
    }
    assert!(n_separated > 5_000, "{n_separated} separated");
    assert!(n_wrong[0] > 20_000 && n_wrong[1] > 500, "wrong answers that were seen: {n_wrong:?}");
}

#[test]
fn axis_separation_survives_what_is_no_number() {
    let at = |x: f32| [[x, 0.0, 0.0], [x + 1.0, 1.0, 1.0]];
    assert!(axis_separated(&at(0.0), &at(0.0), &at(3.0), &at(3.0), 1.0));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        for (time, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            // One bound of the first box, at one time, along the only axis that separates.
            let mut boxes = [at(0.0), at(0.0)];
            boxes[time][end][0] = bad;
            let [a0, a1] = boxes;
            let separated = axis_separated(&a0, &a1, &at(3.0), &at(3.0), 1.0);
            // The upper bound is what separates; the lower one does not count.
            let want = end == 0 || bad == f32::NEG_INFINITY;
            assert_eq!(separated, want, "{bad} in bound {end} at {time}");
        }
    }
    // Opposite sides at the two ends are no separation; differences that overflow keep their sign.
    assert!(!axis_separated(&at(0.0), &at(6.0), &at(3.0), &at(3.0), 1.0));
    let huge = |x: f32| [[x; 3]; 2];
    assert!(axis_separated(&huge(3e38), &huge(3e38), &huge(-3e38), &huge(-3e38), 1e38));
    let endless = huge(f32::INFINITY);
    assert!(!axis_separated(&endless, &endless, &endless, &endless, 0.0));
}

/// An upper bound of the least distance in the step, by samples of time and of both features.
fn sampled_distance(t0: &Points, t1: &Points, patch: Patch) -> f64 {
    const N: usize = 12;
    let mut least = f64::INFINITY;
    for i in 0..=2 * N {
        let t = i as f64 / (2 * N) as f64;
        let at = |v: usize, k: usize| f64::from(t0[v][k]) * (1.0 - t) + f64::from(t1[v][k]) * t;
        for (s, r) in (0..=N).flat_map(|s| (0..=N).map(move |r| (s, r))) {
            if patch == Patch::Triangle && s + r > N {
                continue;
            }
            let (s, r) = (s as f64 / N as f64, r as f64 / N as f64);
            let difference = |k: usize| match patch {
                Patch::Triangle => {
                    at(0, k) - at(1, k) - s * (at(2, k) - at(1, k)) - r * (at(3, k) - at(1, k))
                }
                Patch::Parallelogram => {
                    at(2, k) + r * (at(3, k) - at(2, k)) - at(0, k) - s * (at(1, k) - at(0, k))
                }
            };
            let square = (0..3).map(|k| difference(k) * difference(k)).sum::<f64>();
            least = least.min(square.sqrt());
        }
    }
    least
}

fn motion(t0: &Points, t1: &Points, patch: Patch) -> Motion<f32> {
    Motion::new(patch, t0, t1, 0.0)
}

#[test]
fn what_passes_beside_is_never_closer() {
    let mut random = Random::new(22);
    let (mut n_beside, mut n_seen) = (0, 0);
    for i in 0..6_000 {
        let patch = if i % 2 == 0 { Patch::Triangle } else { Patch::Parallelogram };
        let mut point = || random.point().map(|c| c as f32);
        let t0: Points = std::array::from_fn(|_| point());
        let t1: Points = t0.map(|p| {
            let by = point();
            std::array::from_fn(|k| p[k] + 0.3 * (by[k] - 0.5))
        });
        let distance = if i % 3 == 0 { 0.0 } else { 0.1 * random.unit() as f32 };
        if !(beside(&motion(&t0, &t1, patch), patch, distance) > 0.0) {
            continue;
        }
        n_beside += 1;
        let least = sampled_distance(&t0, &t1, patch);
        assert!(least >= f64::from(distance), "{t0:?} {t1:?} {patch:?} {distance}: {least}");
        // The control: for a much greater distance the same would be wrong.
        n_seen += usize::from(least < f64::from(distance) + 0.3);
        if distance == 0.0 {
            let [e0, e1] = [&t0, &t1].map(|x| x.map(|p| p.map(f64::from)));
            let answer = contact(patch, &e0, &e1);
            assert!(!matches!(answer, Contact::At(..)), "{t0:?} {t1:?} {patch:?}: {answer:?}");
        }
    }
    assert!(n_beside > 500 && n_seen > 50, "{n_beside} beside, {n_seen} within 0.3 more");
}
