//! What a search may ask for besides a distance: a tolerance, and a window of time.

use crate::common::Points;
use crate::common::distance::{First, first_within, point_triangle, segment_segment};
use crate::common::exact::{self, Contact};
use crate::common::exact_distance::{exact, square};
use crate::common::random::Random;
use ccd_core::narrow_phase::query::{search, solve};
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::search::Search;
use ccd_core::{Real, Verdict};

/// The distance of the features of four points.
type Measure = fn([[f64; 3]; 4]) -> f64;

/// Points that move anyhow, of which numbers are `f32`.
fn points(random: &mut Random) -> (Patch, Points<f64>, Points<f64>) {
    let patch = if random.below(2) == 0 { Patch::Triangle } else { Patch::Parallelogram };
    let narrow = |p: [f64; 3]| p.map(|c| c as f32 as f64);
    let t0: Points<f64> = std::array::from_fn(|_| narrow(random.vector()));
    let t1: Points<f64> = std::array::from_fn(|_| narrow(random.vector()));
    (patch, t0, t1)
}

fn motion<R: Real>(patch: Patch, t0: &Points<f64>, t1: &Points<f64>) -> Motion<R> {
    let of = |x: &Points<f64>| x.map(|p| p.map(R::from_f64));
    Motion::new(patch, &of(t0), &of(t1), R::splat(0.0))
}

/// Hits of touching features are within the tolerance, and exact ones are hits. Returns how many
/// of so many contacts are.
fn check_touching<R: Real>(n: usize, seed: u64, tolerance: f64) -> [usize; 2] {
    let mut random = Random::new(seed);
    let mut count = [0; 2];
    for _ in 0..n {
        let (patch, t0, t1) = points(&mut random);
        let wanted = Search { tolerance: R::from_f64(tolerance), ..Search::whole(R::splat(0.0)) };
        let verdict = search(&motion::<R>(patch, &t0, &t1), patch, &wanted).verdict;
        let answer = exact::contact(patch, &t0, &t1);
        let toi = verdict.toi().map(|t| t.to_f64());
        let hit = matches!(verdict, Verdict::Hit { .. });
        let fine = match answer {
            Contact::Free => !hit,
            // Contact for certain, and none before it where that is certain.
            Contact::At([lo, hi], first) => {
                toi.is_some_and(|toi| toi <= hi && (!hit || !first || toi >= lo - tolerance))
            }
            Contact::Degenerate => true,
        };
        assert!(fine, "{verdict:?} {answer:?} {tolerance:e}: {patch:?} {t0:?} {t1:?}");
        if let Contact::At(_, true) = answer {
            count[0] += 1;
            count[1] += hit as usize;
        }
    }
    count
}

#[test]
fn touching_features_are_told_up_to_the_tolerance() {
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        let [all, hits] = check_touching::<f64>(2_000, 1, tolerance);
        println!("f64, {tolerance:e}: {hits} of {all}");
        // At the least tolerance the error of the cubic is more than it for one in ten.
        let least = if tolerance > 1e-10 { 97 } else { 85 };
        assert!(all > 100 && hits * 100 >= all * least, "{hits} of {all} at {tolerance:e}");
    }
    // What f32 cannot tell is undecided.
    let [all, hits] = check_touching::<f32>(2_000, 2, 1e-9);
    println!("f32, 1e-9: {hits} of {all}");
    assert!(hits * 10 < all, "{hits} of {all}");
    let [all, hits] = check_touching::<f32>(2_000, 2, 1e-2);
    assert!(hits * 10 > all * 5, "{hits} of {all}");
}

/// A hit at a distance has a contact within the tolerance, exactly, and none before it.
fn check_distance<R: Real>(n: usize, seed: u64, tolerance: f64) -> [usize; 2] {
    let mut random = Random::new(seed);
    let mut count = [0; 2];
    for _ in 0..n {
        let (patch, t0, t1) = points(&mut random);
        let d = R::from_f64(random.power(-8.0, -1.0));
        let wanted = Search { tolerance: R::from_f64(tolerance), ..Search::whole(d) };
        let verdict = search(&motion::<R>(patch, &t0, &t1), patch, &wanted).verdict;
        let limit = exact(d.to_f64()) * exact(d.to_f64());
        let at = |t: f64| square(patch, &t0, &t1, &exact(t));
        let Some(toi) = verdict.toi().map(|t| t.to_f64()) else { continue };
        count[0] += 1;
        // Just before there certainly is none, at once or within the tolerance there is one.
        assert!(toi == 0.0 || at(toi * (1.0 - 1e-14)) >= limit, "late {toi}: {t0:?} {t1:?} {d:?}");
        if let Verdict::Hit { .. } = verdict {
            count[1] += 1;
            let found = (0..=8).any(|i| at((toi + tolerance * i as f64 / 8.0).min(1.0)) <= limit);
            assert!(found, "{toi} is early by more than {tolerance:e}: {t0:?} {t1:?} {d:?}");
        }
    }
    count
}

#[test]
fn near_features_are_told_up_to_the_tolerance() {
    for tolerance in [1e-3, 1e-6, 1e-9, 1e-12] {
        let [all, hits] = check_distance::<f64>(300, 3, tolerance);
        println!("f64 at a distance, {tolerance:e}: {hits} of {all}");
        assert!(all > 40 && hits * 100 >= all * 97, "{hits} of {all} at {tolerance:e}");
    }
    for tolerance in [1e-5, 1e-7, 1e-9] {
        let [all, hits] = check_distance::<f32>(300, 4, tolerance);
        println!("f32 at a distance, {tolerance:e}: {hits} of {all}");
        assert!(all > 40, "{all}");
    }
}

/// In a window the answer is that of the motion of that window alone, and that of the whole step
/// where the first contact lies in it.
fn check_window<R: Real>(n: usize, seed: u64, d: f64) {
    let mut random = Random::new(seed);
    let (mut before, mut inside, mut after, mut starts) = (0, 0, 0, 0);
    for _ in 0..n {
        let (patch, t0, t1) = points(&mut random);
        let (p, q) = (random.below(65), random.below(65));
        let (from, until) = (p.min(q) as f64 / 64.0, p.max(q) as f64 / 64.0);
        let m = motion::<R>(patch, &t0, &t1);
        let wanted = Search {
            from: R::from_f64(from),
            until: R::from_f64(until),
            ..Search::whole(R::from_f64(d))
        };
        let tell = || format!("[{from}, {until}] {d}: {patch:?} {t0:?} {t1:?}");
        let verdict = search(&m, patch, &wanted).verdict;
        let toi = verdict.toi().map(|t| t.to_f64());
        assert!(toi.is_none_or(|t| t >= from && t <= until), "{verdict:?} {}", tell());
        // The step of the window, in f64: its ends are rounded, so not to the last digit.
        let at = |t: f64| -> Points<f64> {
            std::array::from_fn(|i| std::array::from_fn(|k| t0[i][k] + t * (t1[i][k] - t0[i][k])))
        };
        let (x0, x1) = (at(from), at(until));
        let width = until - from;
        let late = if R::UNIT.to_f64() > 1e-10 { 1e-5 } else { 1e-8 };
        let (distance, first): (Measure, usize) = match patch {
            Patch::Triangle => (point_triangle, 1),
            Patch::Parallelogram => (segment_segment, 2),
        };
        let want = if d > 0.0 {
            first_within(distance, first, &x0, &x1, d)
        } else {
            match exact::contact(patch, &x0, &x1) {
                Contact::Free => First::Never,
                Contact::At([lo, _], true) => First::At(lo),
                _ => First::Unclear,
            }
        };
        match want {
            First::At(t) => {
                let t = from + width * t;
                let least = if matches!(verdict, Verdict::Hit { .. }) { t - late } else { from };
                let fine = toi.is_some_and(|toi| toi <= t + late && toi >= least);
                assert!(fine, "{verdict:?}, but {t} {}", tell());
                starts += (t == from) as usize;
            }
            First::Never => assert!(!matches!(verdict, Verdict::Hit { .. }), "{}", tell()),
            First::Unclear => {}
        }
        match solve(&m, patch, R::from_f64(d)).toi().map(|t| t.to_f64()) {
            Some(t) if t > until => {
                after += 1;
                assert!(toi.is_none(), "{verdict:?}, but {t} {}", tell());
            }
            Some(t) if t > from => {
                inside += 1;
                assert!(toi.is_some_and(|toi| (toi - t).abs() <= 2.0 * late), "{t} {}", tell());
            }
            Some(_) => before += 1,
            None => assert!(toi.is_none(), "{verdict:?} {}", tell()),
        }
    }
    println!("before, inside, after a window at {d}: {before} {inside} {after}; {starts} start it");
    assert!(before > n / 100 && inside > n / 100 && after > n / 100, "these show little");
    assert!(d == 0.0 || starts > n / 100, "{starts} contacts at the start show little");
}

#[test]
fn a_window_has_its_contacts_alone() {
    check_window::<f64>(3_000, 5, 0.0);
    check_window::<f64>(3_000, 6, 0.05);
    check_window::<f32>(3_000, 7, 0.0);
    check_window::<f32>(3_000, 8, 0.05);
}
