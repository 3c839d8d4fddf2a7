//! Cubics and queries that nearly touch, in `f32` and `f64`, against exact arithmetic: no zero and
//! no contact is missed.

use crate::common::exact::Contact;
use crate::common::random::Random;
use crate::common::tangential::{Query, cubic, intervals, query};
use crate::common::{Points, exact, widen};
use ccd_core::narrow_phase::query::solve;
use ccd_core::narrow_phase::relative_motion::Patch;
use ccd_core::{Real, TOI_TOLERANCE, Verdict};

/// Every zero of any cubic within the error is in an interval. Returns how many zeros there were.
fn check_cubic<R: Real>(c: [R; 4], error: R) -> usize {
    let got = intervals(c, error);
    let (wide, e) = (c.map(|c| c.to_f64()), error.to_f64());
    let shifts = if e == 0.0 { &[0.0][..] } else { &[0.0, 1.0, -1.0][..] };
    let zeros: Vec<_> = shifts.iter().flat_map(|s| exact::zeros(wide, s * e)).collect();
    for [lo, hi] in &zeros {
        let held = got.iter().any(|i| i[0] <= *hi && *lo <= i[1]);
        assert!(held, "a zero in [{lo}, {hi}] of {c:?} within {error:?} is in none of {got:?}");
    }
    zeros.len()
}

/// No contact is missed and none is answered too late. Returns whether there is one for certain.
fn check_query<R: Real>(q: &Query<R>) -> bool {
    let verdict = solve(&q.motion(), q.patch, R::splat(0.0));
    let (t0, t1) = (widen(&q.t0), widen(&q.t1));
    let toi = verdict.toi().map(|t| t.to_f64());
    match exact::contact(q.patch, &t0, &t1) {
        Contact::At([lo, hi], first) => {
            let exact = first && matches!(verdict, Verdict::Hit { .. });
            let least = if exact { lo - TOI_TOLERANCE } else { 0.0 };
            let early = toi.is_some_and(|t| t <= hi && t >= least);
            assert!(early, "contact in [{lo}, {hi}], but {verdict:?}: {:?} {t0:?} {t1:?}", q.patch);
            true
        }
        Contact::Free => {
            let hit = matches!(verdict, Verdict::Hit { .. });
            assert!(!hit, "no contact, but {verdict:?}: {:?} {t0:?} {t1:?}", q.patch);
            false
        }
        Contact::Degenerate => false,
    }
}

/// The vertex passes a point of a face that turns, so that the cubic is a parabola that just
/// reaches zero.
const GRAZING: [Points<f64>; 2] = [
    [
        [-0.5406958777051462, 0.22532161286897426, 0.027710373284185068],
        [0.0; 3],
        [1.0, 0.0, -0.6464761151854638],
        [0.0, 1.0, 0.0],
    ],
    [
        [0.37682135579077886, 0.22532161286897426, -0.019311892065309713],
        [0.0; 3],
        [1.0, 0.0, 0.36357560701938263],
        [0.0, 1.0, 0.0],
    ],
];

#[test]
fn a_grazing_vertex_is_seen() {
    let [t0, t1] = GRAZING;
    let narrow = |x: Points<f64>| x.map(|p| p.map(|c| c as f32));
    check_query(&Query { patch: Patch::Triangle, t0: narrow(t0), t1: narrow(t1) });
    assert!(check_query(&Query { patch: Patch::Triangle, t0, t1 }), "a contact for certain");
}

fn check_cubics<R: Real>(n: usize, seed: u64) {
    let mut random = Random::new(seed);
    let mut check = || {
        let (c, error) = cubic::<R>(&mut random);
        check_cubic(c, error)
    };
    let n_zeros: usize = (0..n).map(|_| check()).sum();
    assert!(n_zeros > n, "{n_zeros} zeros of {n} cubics show little");
}

fn check_queries<R: Real>(n: usize, seed: u64) {
    let mut random = Random::new(seed);
    let n_contacts = (0..n).filter(|_| check_query(&query::<R>(&mut random))).count();
    assert!(n_contacts > n / 4, "{n_contacts} contacts of {n} queries show little");
}

#[test]
fn zeros_of_cubics_that_nearly_touch_are_held() {
    check_cubics::<f64>(2_500, 1);
    check_cubics::<f32>(2_500, 2);
}

#[test]
fn contacts_of_queries_that_nearly_graze_are_seen() {
    check_queries::<f64>(12_000, 3);
    check_queries::<f32>(12_000, 4);
}

#[test]
fn a_wrong_interval_and_a_late_verdict_are_noticed() {
    let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let at = |y: f64| [[0.25, y, 0.25], face[0], face[1], face[2]];
    let narrow = |x: Points<f64>| x.map(|p| p.map(|c| c as f32));
    let Contact::At([lo, hi], true) = exact::contact(Patch::Triangle, &at(1.0), &at(-1.0)) else {
        panic!("no contact")
    };
    assert!(lo <= 0.5 && hi >= 0.5 && hi - lo < 1e-15);
    assert_eq!(exact::contact(Patch::Triangle, &at(1.0), &at(0.5)), Contact::Free);
    let (t0, t1) = (narrow(at(1.0)), narrow(at(-1.0)));
    assert!(check_query(&Query { patch: Patch::Triangle, t0, t1 }));
}
