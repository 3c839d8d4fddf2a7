//! Features in contact of which something stands still, or nearly so: a slope of about what
//! differences are rounded by may be seen with the other sign, and tells nothing; and what stays
//! within the distance has not been left.

use crate::common::Points;
use crate::common::exact_distance::exact;
use crate::common::random::Random;
use crate::leaving::{Near, check_departure, check_left};
use ccd_core::narrow_phase::approach::{Approach, Departure};
use ccd_core::narrow_phase::conservative_advancement::{Field, nearest};
use ccd_core::narrow_phase::query::search;
use ccd_core::narrow_phase::relative_motion::Patch;
use ccd_core::narrow_phase::search::Search;
use ccd_core::{Real, Verdict};
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// A vertex nearest to a corner of a face, or two edges nearest in their ends, all else beyond:
/// what that corner of their difference does is all that counts. Both have all digits, so that the
/// difference is rounded at either end of the step by itself; they move by about its last digit, or
/// by some hundreds of it.
fn resting<R: Real>(random: &mut Random) -> Near<R> {
    let patch = if random.below(2) == 0 { Patch::Triangle } else { Patch::Parallelogram };
    let gap: [f64; 3] = std::array::from_fn(|_| random.between(0.5, 1.0) * random.sign());
    let place: [f64; 3] = std::array::from_fn(|_| random.between(-0.25, 0.25));
    let beyond = |random: &mut Random, from: [f64; 3], sign: f64| -> [f64; 3] {
        let (part, beside) = (sign * random.between(0.125, 0.25), random.vector());
        std::array::from_fn(|k| from[k] + part * gap[k] + 0.0625 * beside[k])
    };
    let across = std::array::from_fn(|k| place[k] + gap[k]);
    let t0: Points<f64> = match patch {
        Patch::Triangle => {
            [across, place, beyond(random, place, -1.0), beyond(random, place, -1.0)]
        }
        Patch::Parallelogram => {
            [place, beyond(random, place, -1.0), across, beyond(random, across, 1.0)]
        }
    };
    let units = if random.below(8) > 0 { random.power(-1.0, 1.0) } else { random.power(8.0, 10.0) };
    let size = R::UNIT.to_f64() * units;
    let t0 = t0.map(|p| p.map(R::from_f64));
    let t1 = t0.map(|p| {
        let by = random.vector();
        std::array::from_fn(|k| R::from_f64(p[k].to_f64() + size * by[k]))
    });
    let d = gap.iter().map(|c| c * c).sum::<f64>().sqrt();
    Near { patch, t0, t1, d: R::from_f64(d * random.between(1.0, 1.25)) }
}

/// Which way the nearest corner goes along the direction in which it is, as computed, and in truth.
fn slopes<R: Real>(q: &Near<R>) -> [f64; 2] {
    let m = q.motion();
    let x = nearest(&m, q.patch, R::splat(0.0)).map(|c| c.to_f64());
    let sum: f64 = x.iter().map(|c| c.abs()).sum();
    let along = Field::new(&m, q.patch, R::splat(0.0)).along(x.map(|c| R::from_f64(c / sum)));
    let second = if matches!(q.patch, Patch::Triangle) { [0, 1] } else { [2, 0] };
    let a = [&q.t0, &q.t1].map(|x| -> [BigRational; 3] {
        let [p, q] = second.map(|i| x[i].map(|c| exact(c.to_f64())));
        std::array::from_fn(|k| &p[k] - &q[k])
    });
    let slope: BigRational = (0..3).map(|k| &a[0][k] * (&a[1][k] - &a[0][k])).sum();
    [(along.g1[0] - along.g0[0]).to_f64(), slope.to_f64().unwrap_or(0.0)]
}

fn check_resting<R: Real>(n: usize, seed: u64) {
    let mut random = Random::new(seed);
    // Unknown, approaching, separating; slopes that are seen with the other sign.
    let mut count = [0; 4];
    for _ in 0..n {
        let q = resting::<R>(&mut random);
        let zero = R::splat(0.0);
        let found = Departure::new(&q.motion(), q.patch, zero, R::splat(1.0), q.d);
        check_departure(&q, &found, 0.0);
        count[found.approach.word() as usize] += 1;
        let [seen, slope] = slopes(&q);
        count[3] += (seen * slope.signum() < 0.0) as usize;
    }
    println!("unknown, approaching, separating, seen the other way of {n}: {count:?}");
    assert!(count.iter().all(|k| *k > n / 60), "{count:?} of {n} show little");
}

#[test]
fn a_slope_of_rounding_alone_tells_nothing() {
    check_resting::<f64>(600, 1);
    check_resting::<f32>(600, 2);
}

/// The corner of a face that is nearest to a vertex goes away, and a second one, within the
/// distance as well, stays where it is or comes a little nearer: it is left by none of them, also
/// where a third one overtakes the vertex later.
#[test]
fn what_stays_within_the_distance_is_not_left() {
    for (comes, overtakes) in [(0.0, -4.0), (0.0, 8.0), (0.0078125, 8.0)] {
        let with = |x0: f64, x1: f64, x2: f64| {
            [[0.0; 3], [x0, 0.0, 0.0], [x1, 0.03125, 0.0], [x2, -0.5, 0.0]]
        };
        let (t0, t1) = (with(-0.0625, -0.09375, -4.0), with(-1.0625, -0.09375 + comes, overtakes));
        let q = Near { patch: Patch::Triangle, t0, t1, d: 0.125 };
        let departure = Departure::new(&q.motion(), q.patch, 0.0, 1.0, q.d);
        check_departure(&q, &departure, 0.0);
        assert_eq!((departure.approach, departure.again), (Approach::Separating, 2.0));
        let wanted = Search { leaves: true, ..Search::whole(q.d) };
        let answer = search(&q.motion(), q.patch, &wanted);
        check_left(&q, 0.0, answer.verdict);
        assert!(!matches!(answer.verdict, Verdict::Hit { .. }), "{answer:?}");
    }
}
