//! Particles and rods against exact distances: what meets in a known point at a known time, at any
//! scale and place, in any window; and what keeps a distance.

use super::{VertexEdge, VertexVertex, search_vertex_edge, search_vertex_vertex};
use crate::narrow_phase::approach::Approach;
use crate::narrow_phase::query::Verdict;
use crate::narrow_phase::search::{Answer, Search};
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};
use random::Random;
use std::{format, println};

#[allow(dead_code, reason = "other tests need all of it")]
#[path = "../../../tests/bounds/common/random.rs"]
mod random;

fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("a finite number")
}

fn dot(a: &[BigRational; 3], b: &[BigRational; 3]) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// A vertex and an edge, or two vertices: the second of the edge is missing then.
#[derive(Clone, Debug)]
struct Thin {
    t0: [[f64; 3]; 3],
    t1: [[f64; 3]; 3],
    vertices: bool,
}

impl Thin {
    fn answer(&self, search: &Search<f64>) -> Answer<f64> {
        let Self { t0, t1, vertices } = self;
        if *vertices {
            let [t0, t1] = [t0, t1].map(|x| [x[0], x[1]]);
            search_vertex_vertex(&VertexVertex { t0, t1 }, search)
        } else {
            search_vertex_edge(&VertexEdge { t0: *t0, t1: *t1 }, search)
        }
    }

    /// The square of the distance, exactly.
    fn square(&self, t: f64) -> BigRational {
        let last = if self.vertices { 1 } else { 2 };
        let at = |i: usize| -> [BigRational; 3] {
            std::array::from_fn(|k| {
                let (p, q) = (exact(self.t0[i][k]), exact(self.t1[i][k]));
                &p + (q - &p) * exact(t)
            })
        };
        let [v, p, q] = [at(0), at(1), at(last)];
        let of =
            |x: &[BigRational; 3]| -> [BigRational; 3] { std::array::from_fn(|k| &x[k] - &p[k]) };
        let (a, b) = (of(&v), of(&q));
        let (along, length) = (dot(&a, &b), dot(&b, &b));
        let none = length.is_zero() || along.is_negative();
        let s = if none { BigRational::zero() } else { (along / length).min(BigRational::one()) };
        let r: [BigRational; 3] = std::array::from_fn(|k| &a[k] - &s * &b[k]);
        dot(&r, &r)
    }

    fn scaled(&self, unit: f64, offset: f64) -> Self {
        let of = |x: [[f64; 3]; 3]| x.map(|p| p.map(|c| (c + offset) * unit));
        Self { t0: of(self.t0), t1: of(self.t1), ..*self }
    }
}

/// Numbers of a coarse lattice, so that nearly everything is degenerate: the vertex is on the edge
/// or on the other vertex at `k / 8`, at one of its ends or at a quarter, by a way that is exact.
fn meeting(random: &mut Random, k: u32) -> Thin {
    let mut point = |n: usize| -> [f64; 3] {
        std::array::from_fn(|_| random.below(2 * n + 1) as f64 - n as f64)
    };
    let (mut e, moves) = ([point(2), point(2)], [point(1), point(1)]);
    let way = point(2);
    let (kind, s) = (random.below(4), random.below(5) as f64 / 4.0);
    if kind == 1 {
        // No length at all, or at the start only.
        e[1] = e[0];
    }
    let (moves, way) = match kind {
        2 => ([moves[0]; 2], moves[0]),
        _ => (moves, way),
    };
    let t = k as f64 / 8.0;
    let at = |x: [f64; 3], by: [f64; 3], t: f64| std::array::from_fn(|i| x[i] + by[i] * 8.0 * t);
    let now: [[f64; 3]; 2] = [at(e[0], moves[0], t), at(e[1], moves[1], t)];
    let s = if kind == 3 { s.round() } else { s };
    let met: [f64; 3] = std::array::from_fn(|i| now[0][i] + (now[1][i] - now[0][i]) * s);
    let vertices = random.below(3) == 0;
    let met = if vertices { now[0] } else { met };
    let t0 = [at(met, way, -t), e[0], e[1]];
    let t1 = [at(met, way, 1.0 - t), at(e[0], moves[0], 1.0), at(e[1], moves[1], 1.0)];
    Thin { t0, t1, vertices }
}

#[test]
fn what_meets_exactly_is_never_missed_nor_late() {
    let mut random = Random::new(1);
    let scales = [(1.0, 0.0), (2f64.powi(-100), 0.0), (2f64.powi(100), 3.0), (1.0, 2f64.powi(27))];
    let beyond =
        [(2f64.powi(-525) * 2f64.powi(-525), 0.0), (2f64.powi(320), 0.0), (2f64.powi(-250), 1.0)];
    let (mut n, mut certain, mut n_start) = (0, 0, 0);
    for round in 0..4_000 {
        let k = random.below(9) as u32;
        let t = k as f64 / 8.0;
        let of = meeting(&mut random, k);
        let far = round % 8 == 7;
        let (unit, offset) = if far { beyond[round / 8 % 3] } else { scales[random.below(4)] };
        let of = of.scaled(unit, offset);
        // Windows that hold the time, begin there, end there, or are that moment.
        let before = random.below(k as usize + 1) as f64 / 8.0;
        let after = (k as usize + random.below(9 - k as usize)) as f64 / 8.0;
        let tolerance = [1e-12, 1e-6, 1e-2, 1.0][random.below(4)];
        for [from, until] in [[0.0, 1.0], [before, after], [t, after], [before, t], [t, t]] {
            let search = Search { from, until, tolerance, ..Search::whole(0.0) };
            let answer = of.answer(&search);
            let tell = || format!("{answer:?} at {t} of {search:?}: {of:?}");
            let toi = answer.verdict.toi().unwrap_or_else(|| panic!("missed: {}", tell()));
            assert!(toi >= from && toi <= t, "{}", tell());
            assert!(of.square(t).is_zero());
            if let Verdict::Hit { toi } = answer.verdict {
                certain += (!far) as u32;
                n_start += (toi == from) as u32;
                // They do meet soon after it: at that time, or at one that is as simple.
                let grid = [0, 3, 8, 16, 30, 50].map(|q| 2f64.powi(q));
                let at = grid.map(|g| ((toi * g).ceil() / g).min(until));
                let ends = [toi, t, until, toi + 0.5 * tolerance, toi + 0.9 * tolerance];
                let soon = |x: &f64| *x >= toi && *x - toi <= tolerance;
                let meets = at.into_iter().chain(ends).filter(soon).any(|x| of.square(x).is_zero());
                assert!(meets, "where? {}", tell());
                if answer.approach == Approach::Approaching {
                    assert!(toi > from && !of.square(toi - (toi - from) * 1e-3).is_zero());
                }
            }
            n += (!far) as u32;
        }
    }
    println!("{certain} of {n} are certain, {n_start} at the start of a window");
    assert!(certain * 10 > n * 8 && n_start * 10 > n, "{certain} of {n}, {n_start}");
}

/// What nearly meets is not missed where it does, and is no certain contact where it does not.
#[test]
fn what_passes_by_is_no_certain_contact() {
    let mut random = Random::new(2);
    let (mut n_miss, mut n_open) = (0, 0);
    for _ in 0..1_200 {
        let k = random.below(9) as u32;
        let mut of = meeting(&mut random, k);
        let by = random.power(-52.0, -2.0);
        let i = random.below(3);
        of.t0[0][i] += by;
        of.t1[0][i] += by;
        let answer = of.answer(&Search::whole(0.0));
        let met = |t: f64| of.square(t).is_zero();
        match answer.verdict {
            Verdict::Hit { toi } => {
                // Another meeting: along the edge, or at a simple time.
                let grid = [0, 3, 4, 6, 8, 16, 30, 50, 52].map(|q| 2f64.powi(q));
                let soon = |x: &f64| *x >= toi && *x - toi <= 1e-6;
                let at = grid.map(|g| ((toi * g).ceil() / g).min(1.0));
                let found = at.into_iter().chain([toi, 1.0]).filter(soon).any(met);
                assert!(found || of.square(toi) <= exact(1e-10), "{answer:?} {of:?}");
            }
            Verdict::Undecided { .. } => n_open += 1,
            Verdict::Miss => {
                n_miss += 1;
                assert!((0..=64).all(|j| !met(j as f64 / 64.0)), "missed: {of:?}");
            }
        }
    }
    println!("{n_miss} misses, {n_open} open");
    assert!(n_miss > 600, "{n_miss}");
}

/// With a minimum distance: first times, and what may be left, against exact squares.
#[test]
fn distances_of_thin_features_are_kept_and_left() {
    let mut random = Random::new(3);
    let mut count = [0; 5];
    for _ in 0..600 {
        let (vertices, slow) = (random.below(3) == 0, random.power(-8.0, 2.0));
        let unit = 2f64.powi([0, -100, 90, -1000][random.below(4)]);
        let t0: [[f64; 3]; 3] = std::array::from_fn(|_| random.vector());
        let t1 = t0.map(|p| std::array::from_fn(|k| p[k] + slow * random.between(-1.0, 1.0)));
        let of = Thin { t0, t1, vertices }.scaled(unit, 0.0);
        let near = |t: f64| of.scaled(1.0 / unit, 0.0).square(t);
        let start = near(0.0);
        let now = start.to_f64().expect("a number").sqrt();
        let d = now * [1.0 + random.power(-30.0, 1.0), 0.6, 1.0][random.below(3)];
        let limit = exact(d) * exact(d);
        let from = [0.0, 0.25, 0.75][random.below(3)];
        let leaves = random.below(2) == 0;
        let search = Search { from, leaves, ..Search::whole(d * unit) };
        let answer = of.answer(&search);
        let start = near(from);
        let until = answer.verdict.toi().unwrap_or(1.0);
        let tell = || format!("{answer:?} {search:?} {of:?}");
        for i in 0..=24 {
            let t = from + (until - from) * (i as f64 / 24.0).powi(1 + i % 3);
            if answer.verdict.toi().is_some() && t >= until {
                continue;
            }
            let square = near(t);
            let fine = square > limit || leaves && square >= start;
            assert!(fine, "{t} before {}", tell());
        }
        if let Verdict::Hit { toi } = answer.verdict {
            let found =
                [0.0, 0.01, 0.5, 1.0].iter().any(|x| near((toi + 1e-6 * x).min(1.0)) <= limit);
            assert!(found, "no contact: {}", tell());
            count[3] += (leaves && start <= limit && toi > from) as usize;
        }
        if answer.approach == Approach::Separating {
            assert!(near(from + 2f64.powi(-40)) > start, "{}", tell());
        }
        count[match answer.verdict {
            Verdict::Miss => 0,
            Verdict::Hit { .. } => 1,
            Verdict::Undecided { .. } => 2,
        }] += 1;
        count[4] += (leaves && start <= limit && answer.verdict == Verdict::Miss) as usize;
    }
    println!("misses, hits, open, met again, left: {count:?}");
    assert!(count[0] > 100 && count[1] > 100 && count[4] > 10, "{count:?}");
}
