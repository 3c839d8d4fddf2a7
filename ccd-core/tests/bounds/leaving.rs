//! Features that are in contact at the start: what is said of how they approach each other, and
//! what a search that lets them leave promises, against exact distances.

use crate::common::adversary::{Adversarial, under};
use crate::common::exact_distance::{exact, square};
use crate::common::random::Random;
use crate::common::{Points, widen};
use ccd_core::narrow_phase::approach::{Approach, Departure};
use ccd_core::narrow_phase::query::search;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::search::Search;
use ccd_core::{Real, Verdict};
use num_rational::BigRational;
use num_traits::One;

/// Features close to each other that move anyhow, and a distance at which they are in contact or
/// nearly.
#[derive(Debug)]
pub struct Near<R> {
    pub patch: Patch,
    pub t0: Points<R>,
    pub t1: Points<R>,
    pub d: R,
}

/// A vertex above a face or an edge above another, at a gap from large to small, over their middle
/// or a side; all in any position, most of them moving along the gap and turning a little, some
/// hardly moving along it, some hardly moving at all, by less than what products are rounded by.
fn near<R: Real>(random: &mut Random) -> Near<R> {
    let patch = if random.below(2) == 0 { Patch::Triangle } else { Patch::Parallelogram };
    let hardly = random.below(4) == 0;
    // Where the direction is known best, rounding counts most.
    let gap = if hardly { random.between(0.5, 1.0) } else { random.power(-12.0, 0.0) };
    let (mut s, mut r) = (random.unit(), random.unit());
    if random.below(4) == 0 {
        (s, r) = ([0.0, 1.0][random.below(2)], -0.2 * random.unit());
    } else if matches!(patch, Patch::Triangle) && s + r > 1.0 {
        (s, r) = (1.0 - s, 1.0 - r);
    }
    let tilt = if random.below(3) == 0 { random.power(-20.0, -2.0) } else { 0.0 };
    let mut point = |x: f64, y: f64, z: f64| [x, y, z + tilt * random.between(-1.0, 1.0)];
    let t0 = match patch {
        Patch::Triangle => {
            [point(s, r, gap), point(0.0, 0.0, 0.0), point(1.0, 0.0, 0.0), point(0.0, 1.0, 0.0)]
        }
        Patch::Parallelogram => [
            point(-s, 0.0, 0.0),
            point(1.0 - s, 0.0, 0.0),
            point(0.0, -r, gap),
            point(0.0, 1.0 - r, gap),
        ],
    };
    let along = gap * random.power(-8.0, 6.0) * random.sign();
    let turn = random.power(-30.0, 1.0) * along.abs();
    let side = random.power(-30.0, 0.0);
    let (along, turn, side) = if hardly {
        (random.power(-27.0, -21.0) * random.sign(), 0.0, random.power(-30.0, -22.0))
    } else {
        (along, turn, side)
    };
    let moved: Points<f64> = std::array::from_fn(|i| {
        let first = if matches!(patch, Patch::Triangle) { i == 0 } else { i >= 2 };
        let by = random.vector();
        let z = turn * by[2] + if first { along } else { 0.0 };
        [t0[i][0] + side * by[0], t0[i][1] + side * by[1], t0[i][2] + z]
    });
    // Any axes.
    let axes = [random.vector(), random.vector(), random.vector()];
    let place = |p: [f64; 3]| -> [R; 3] {
        std::array::from_fn(|k| {
            R::from_f64((p[0] * axes[0][k] + p[1] * axes[1][k] + p[2] * axes[2][k]) as f32 as f64)
        })
    };
    let (t0, t1) = (t0.map(place), moved.map(place));
    let now = approximate(patch, &widen(&t0));
    let d = R::from_f64(now * [1.0 + random.power(-24.0, 2.0), 1.0, 1.25][random.below(3)]);
    Near { patch, t0, t1, d }
}

/// The corner of a face and a vertex, or the end of an edge and an edge across, that go apart while
/// the other side of the face, or the other end, overtakes what goes.
fn returning<R: Real>(random: &mut Random) -> Near<R> {
    let patch = if random.below(2) == 0 { Patch::Triangle } else { Patch::Parallelogram };
    let (gap, way) = (random.power(-8.0, -3.0), random.between(0.5, 1.5));
    let at = |goes: f64, comes: f64| match patch {
        Patch::Triangle => [[goes, 0.0, 0.0], [0.0; 3], [comes, 0.5, 0.0], [comes, -0.5, 0.0]],
        Patch::Parallelogram => [[0.0; 3], [comes, 0.0, 0.0], [goes, -1.0, 0.0], [goes, 1.0, 0.0]],
    };
    let size = random.power(-10.0, -4.0) * gap;
    let mut shake = |x: Points<f64>| {
        x.map(|p| p.map(|c| R::from_f64((c + size * random.between(-1.0, 1.0)) as f32 as f64)))
    };
    let (t0, t1) = (shake(at(-gap, 4.0)), shake(at(-gap - way, -8.0)));
    Near { patch, t0, t1, d: R::from_f64(2.0 * gap) }
}

fn approximate(patch: Patch, x: &Points<f64>) -> f64 {
    use crate::common::distance::{point_triangle, segment_segment};
    match patch {
        Patch::Triangle => point_triangle(*x),
        Patch::Parallelogram => segment_segment(*x),
    }
}

impl<R: Real> Near<R> {
    pub fn motion(&self) -> Motion<R> {
        Motion::new(self.patch, &self.t0, &self.t1, R::splat(0.0))
    }

    pub fn square(&self, t: &BigRational) -> BigRational {
        square(self.patch, &widen(&self.t0), &widen(&self.t1), t)
    }
}

/// What is said at time `from` is exactly true.
pub fn check_departure<R: Real>(q: &Near<R>, found: &Departure<R>, from: f64) {
    let tell = || format!("{q:?} from {from}: {found:?}");
    let now = q.square(&exact(from));
    // So short that only the derivative counts.
    let soon = exact(from) + BigRational::one() / exact(2f64.powi(100));
    let then = q.square(&soon);
    match found.approach {
        Approach::Separating => assert!(then > now, "{}", tell()),
        Approach::Approaching => assert!(then < now, "{}", tell()),
        _ => return,
    }
    if found.approach != Approach::Separating {
        return;
    }
    let safe = found.safe.to_f64();
    for i in 1..=2 {
        let t = from + (safe - from) * i as f64 / 2.0;
        assert!(q.square(&exact(t.min(safe))) >= now, "nearer at {t}: {}", tell());
    }
    let again = found.again.to_f64();
    if again <= 1.0 {
        let d = exact(q.d.to_f64());
        assert!(again <= safe && q.square(&exact(again)) > &d * &d, "{}", tell());
    }
}

fn check_approach<R: Real>(n: usize, seed: u64, ways: fn(&mut Random) -> Vec<i8>) {
    let mut random = Random::new(seed);
    let mut count = [0; 4];
    for _ in 0..n {
        let q = near::<R>(&mut random);
        let from = [0.0, 0.0, 0.125, 0.5][random.below(4)];
        let (flush, ways) = (random.below(2) == 0, ways(&mut random));
        let (found, _) = under(&ways, flush, || {
            Departure::new(&q.motion(), q.patch, R::from_f64(from), R::splat(1.0), q.d)
        });
        check_departure(&q, &found, from);
        count[found.approach.word() as usize] += 1;
        count[3] += (found.again.to_f64() <= 1.0) as usize;
    }
    println!("unknown, approaching, separating, free again of {n}: {count:?}");
    assert!(count.iter().all(|k| *k > n / 60), "{count:?} of {n} show little");
}

#[test]
fn signs_of_derivatives_are_certain() {
    check_approach::<f64>(300, 1, |_| Vec::new());
    check_approach::<f32>(300, 2, |_| Vec::new());
}

#[test]
fn signs_of_derivatives_are_certain_under_an_adversary() {
    check_approach::<Adversarial>(600, 3, |random| {
        let kind = random.below(3);
        (0..600).map(|_| if kind == 0 { 1 } else { random.below(3) as i8 - 1 }).collect()
    });
}

/// The promise of a search that lets contacts be left, at times up to its time of impact.
pub fn check_left<R: Real>(q: &Near<R>, from: f64, verdict: Verdict<R>) {
    let (until, d) = (verdict.toi().map_or(1.0, |t| t.to_f64()), exact(q.d.to_f64()));
    let (start, d) = (q.square(&exact(from)), &d * &d);
    // Evenly, and near the start.
    let parts = (0..8).map(|i| i as f64 / 8.0);
    let mut times: Vec<f64> =
        parts.flat_map(|x| [x, x.powi(5)]).map(|x| from + (until - from) * x).collect();
    times.sort_by(f64::total_cmp);
    for t in times.into_iter().filter(|t| verdict.toi().is_none() || *t < until) {
        let now = q.square(&exact(t));
        assert!(now > d || now >= start, "{t} before {verdict:?}: {q:?}");
    }
    if let Verdict::Hit { toi } = verdict {
        let toi = toi.to_f64();
        let near = |t: f64| q.square(&exact(t.min(1.0))) <= &d * exact(1.0 + 1e-5);
        // They were apart in between.
        if toi > from && start <= d {
            assert!(q.square(&exact(toi - (toi - from) * 1e-6)) > d, "not left: {verdict:?}");
        }
        let witnessed = [0.0, 0.5, 1.0].into_iter().any(|part| near(toi + 1e-6 * part));
        assert!(witnessed, "no contact at {toi}: {q:?}");
    }
}

fn check_leaving<R: Real>(n: usize, seed: u64) {
    let mut random = Random::new(seed);
    // Left for all of the step, contacts after one that was left, contacts that were not left.
    let mut count = [0; 3];
    for _ in 0..n {
        let back = random.below(2) == 0;
        let q = if back { returning::<R>(&mut random) } else { near::<R>(&mut random) };
        let from = [0.0, 0.25][random.below(2)];
        let (at, tolerance) = (R::from_f64(from), R::splat(1e-6));
        let wanted = Search { from: at, leaves: true, tolerance, ..Search::whole(q.d) };
        let answer = search(&q.motion(), q.patch, &wanted);
        check_left(&q, from, answer.verdict);
        let stays = search(&q.motion(), q.patch, &Search { leaves: false, ..wanted });
        let starts = stays.verdict.toi().is_some_and(|t| t.to_f64() <= from);
        match answer.verdict.toi() {
            None => count[0] += starts as usize,
            Some(t) if t.to_f64() > from => count[1] += starts as usize,
            Some(_) => count[2] += 1,
        }
        assert!(starts || answer == stays, "{answer:?}, but {stays:?}");
    }
    println!("left, again in contact, not left of {n}: {count:?}");
    assert!(count.iter().all(|k| *k > n / 40), "{count:?} of {n} show little");
}

#[test]
fn contacts_that_are_left_keep_the_promise() {
    check_leaving::<f64>(120, 4);
    check_leaving::<f32>(120, 5);
}

/// A vertex that leaves a corner of a face and is met by the side across, which overtakes it.
#[test]
fn a_second_contact_is_found() {
    let with = |v: [f64; 3], x: f64| [v, [0.0; 3], [x, 0.5, 0.0], [x, -0.5, 0.0]];
    let t0 = with([-0.0625, 0.0, 0.0], 4.0);
    let (moves, stays) = (with([-1.0625, 0.0, 0.0], -8.0), with([-1.0625, 0.0, 0.0], 4.0));
    let wanted = Search { leaves: true, ..Search::whole(0.125) };
    let of = |t1: &Points<f64>, wanted: &Search<f64>| {
        search(&Motion::vertex_face(&t0, t1, 0.0), Patch::Triangle, wanted)
    };
    let without = of(&moves, &Search { leaves: false, ..wanted });
    assert_eq!(without.verdict, Verdict::Hit { toi: 0.0 });
    assert_eq!(without.approach, Approach::Separating);
    // 4.0625 - 11 t is the way left to the vertex.
    let then = of(&moves, &wanted);
    let Verdict::Hit { toi } = then.verdict else { panic!("no second contact: {then:?}") };
    assert!(toi <= 3.9375 / 11.0 && toi >= 3.9375 / 11.0 - 1e-6, "{toi}");
    assert_eq!(then.approach, Approach::Approaching);
    assert_eq!(of(&stays, &wanted).verdict, Verdict::Miss);
    // It does not leave if it does not go, and what touches has no side.
    let rests = of(&t0, &wanted);
    assert_eq!((rests.verdict, rests.approach), (Verdict::Hit { toi: 0.0 }, Approach::Unknown));
    let on = with([1.0, 0.0, 0.0], 4.0);
    let off = with([1.0, 0.0, 1.0], 4.0);
    let m = Motion::vertex_face(&on, &off, 0.0);
    let touching = search(&m, Patch::Triangle, &Search { min_distance: 0.0, ..wanted });
    assert_eq!(touching.verdict.toi(), Some(0.0));
    assert_eq!(touching.approach, Approach::Unknown);
}

/// The same where another corner of the face does not move along the gap at all, nor does the
/// vertex: what stands still ends no search.
#[test]
fn a_second_contact_is_found_past_what_stands_still() {
    let with = |corner: f64, overtakes: f64| {
        [[0.0; 3], [corner, 0.0, 0.0], [-4.0, 0.5, 0.0], [overtakes, -0.5, 0.0]]
    };
    let (t0, t1) = (with(-0.0625, -4.0), with(-1.0625, 8.0));
    let wanted = Search { leaves: true, ..Search::whole(0.125) };
    let m = Motion::<f64>::vertex_face(&t0, &t1, 0.0);
    let departure = Departure::new(&m, Patch::Triangle, 0.0, 1.0, 0.125);
    assert_eq!(departure.approach, Approach::Separating);
    assert!(departure.again < departure.safe && departure.safe < 1.0, "{departure:?}");
    let then = search(&m, Patch::Triangle, &wanted);
    assert!(matches!(then.verdict, Verdict::Hit { toi } if toi > 0.25 && toi < 0.5), "{then:?}");
    let near = Near { patch: Patch::Triangle, t0, t1, d: 0.125 };
    check_left(&near, 0.0, then.verdict);
}
