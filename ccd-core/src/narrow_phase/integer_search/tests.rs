//! Verdicts by integers beside exact ones: at any scale and place, in any window, on a lattice
//! where nearly everything is degenerate.

use super::cubic::BAND;
use super::*;
use crate::backend::quantization::Scan;
use crate::narrow_phase::exact::{self, Exact};
use crate::narrow_phase::query::{EdgeEdge, VertexFace};
use crate::random::Random;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use std::{println, vec::Vec};

type Query = [[[f64; 3]; 4]; 2];

fn exact(patch: Patch, [t0, t1]: Query, window: [f64; 2]) -> Exact {
    let found = match patch {
        Patch::Triangle => exact::vertex_face(&VertexFace { t0, t1 }, window),
        Patch::Parallelogram => exact::edge_edge(&EdgeEdge { t0, t1 }, window),
    };
    found.expect("coordinates that fit")
}

fn of(x: f64, unit: i32) -> Q62 {
    Q62::of([x.to_bits() as u32, (x.to_bits() >> 32) as u32], unit)
}

fn by_integers(patch: Patch, query: Query, window: &Window) -> Found {
    let [t0, t1] = query.map(|x| x.map(|p| p.map(|c| c as f32)));
    let greatest = query.as_flattened().as_flattened().iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    let unit = unit(&Motion::new(patch, &t0, &t1, (greatest * 1e-7) as f32));
    assert!(unit != NO_UNIT);
    let point = |i: usize| query.map(|x| x[i].map(|c| of(c, unit)));
    search(patch, &[point(0), point(1), point(2), point(3)], window)
}

/// How many queries were missed, hit and open.
#[derive(Default)]
struct Count([u32; 3]);

impl Count {
    fn check(&mut self, patch: Patch, query: Query, wanted: &Search<f64>) {
        let window = Window::of(wanted).expect("a window for integers");
        let found = by_integers(patch, query, &window);
        match found {
            Found::Open | Found::Tie => {}
            Found::Miss => {
                let want = exact(patch, query, [wanted.from, wanted.until]);
                assert_eq!(want, Exact::Miss, "{patch:?} {wanted:?} {query:?}");
            }
            Found::Hit(toi) => {
                let toi = toi as f64 / (1u64 << DEPTH) as f64;
                let want = exact(patch, query, [wanted.from, wanted.until]);
                let Exact::Contact([lo, hi]) = want else {
                    panic!("a miss: {patch:?} {wanted:?} {query:?}")
                };
                let within = toi <= lo && hi - toi <= wanted.tolerance + f64::EPSILON;
                assert!(within && toi >= wanted.from, "{toi} {want:?}: {patch:?} {query:?}");
            }
        }
        let place = if is_hit(found) { 1 } else { 2 };
        self.0[if found == Found::Miss { 0 } else { place }] += 1;
    }
}

const PATCHES: [Patch; 2] = [Patch::Triangle, Patch::Parallelogram];

#[test]
fn verdicts_are_those_of_exact_arithmetic() {
    let mut random = Random::new(5);
    let mut count = Count::default();
    for i in 0..60_000 {
        let scale = 2f64.powi(random.below(100) as i32 - 50);
        let place = [0.0, 1.0, 1000.0][i % 3] * scale;
        // A ninth as flat as 2^-20 along an axis.
        let flat = if i % 9 == 0 { 2f64.powi(-(random.below(21) as i32)) } else { 1.0 };
        let mut query = [(); 2].map(|()| {
            [(); 4].map(|()| {
                let p = random.point();
                let p = [p[0] * scale + place, p[1] * flat * scale + place, p[2] * scale];
                if i % 5 == 0 { p } else { p.map(|x| x as f32 as f64) }
            })
        });
        if i % 2 == 0 {
            // A short way.
            let reach = 2f64.powi(-(random.below(20) as i32));
            for j in 0..4 {
                for k in 0..3 {
                    let way = (query[1][j][k] - query[0][j][k]) * reach;
                    let end = query[0][j][k] + way;
                    query[1][j][k] = if i % 5 == 0 { end } else { end as f32 as f64 };
                }
            }
        }
        let whole = Search::whole(0.0);
        let (a, b) = (random.unit(), random.unit());
        let part = Search { from: a.min(b), until: a.max(b), ..whole };
        let coarse = Search { tolerance: 1e-4, ..whole };
        let fine = Search { tolerance: 1e-9, ..whole };
        count.check(PATCHES[i / 2 % 2], query, [&whole, &part, &coarse, &fine][i / 4 % 4]);
    }
    println!("misses, hits, open: {:?}", count.0);
    let [misses, hits, open] = count.0;
    assert!(misses > 30_000 && hits > 3_000, "{:?}", count.0);
    assert!(open < 600, "{:?}", count.0);
}

/// As a device without `f64` asks: the unit comes of a table in `f32`, in whose unit it stands.
fn of_table(patch: Patch, query: Query, window: &Window) -> Found {
    let mut scan = Scan::NONE;
    scan.take_all(&query[0], &query[1]);
    let table = scan.table(true);
    let [t0, t1] = query.map(|x| x.map(|p| table.place(p)));
    let unit = unit(&Motion::new(patch, &t0, &t1, table.error));
    assert!(unit != NO_UNIT);
    let unit = unit - ((table.scale.to_bits() >> 52) as i32 - 1023);
    search(patch, &[0, 1, 2, 3].map(|i| query.map(|x| x[i].map(|c| of(c, unit)))), window)
}

/// Among the least numbers what `f64` calls subnormal counts: taken as 0, the plane of this face is
/// so far below the vertex that it never gets there.
#[test]
fn subnormal_coordinates_are_not_zero() {
    let window = Window::of(&Search::whole(0.0)).expect("a window");
    let (r, h) = (2f64.powi(-1000), f64::MIN_POSITIVE);
    let face = [[0.0, 0.9 * h, 0.0], [r, 1.2 * h, 0.0], [0.0, 1.2 * h, r]];
    let at = |y: f64| [[r / 4.0, y * h, r / 4.0], face[0], face[1], face[2]];
    // Just below the face, and just above it.
    for (end, is_contact) in [(1.01, true), (1.06, false)] {
        let query = [at(1.5), at(end)];
        let want = exact(Patch::Triangle, query, [0.0, 1.0]);
        assert_eq!(want != Exact::Miss, is_contact, "{end}");
        let found = of_table(Patch::Triangle, query, &window);
        assert_eq!(found != Found::Miss, is_contact, "{end}: {found:?}");
        assert_eq!(is_hit(found), is_contact, "{end}: {found:?}");
    }
}

fn is_hit(found: Found) -> bool {
    matches!(found, Found::Hit(_))
}

/// Contacts at halves and quarters of the step are no ties.
#[test]
fn times_may_be_where_the_step_is_halved() {
    for k in 1..8 {
        let y = k as f64 / 8.0;
        let t0 = [[0.25, y, 0.25], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        let mut t1 = t0;
        t1[0][1] = y - 1.0;
        let window = Window::of(&Search::whole(0.0)).expect("a window");
        let found = by_integers(Patch::Triangle, [t0, t1], &window);
        let want = (k as u32) << 28;
        assert!(matches!(found, Found::Hit(at) if at <= want && want - at < 2000), "{found:?}");
        // The window ends or begins just before that time, at it, or just after it.
        let near = 2f64.powi(-40);
        for end in [y - near, y, y + near] {
            let of = |from: f64, until: f64| {
                let window = Search { from, until, ..Search::whole(0.0) };
                let window = Window::of(&window).expect("a window");
                by_integers(Patch::Triangle, [t0, t1], &window)
            };
            let (before, after) = (of(0.0, end), of(end, 1.0));
            assert!(if end < y { !is_hit(before) } else { before != Found::Miss }, "{end}");
            assert!(if end > y { !is_hit(after) } else { after != Found::Miss }, "{end}");
            let begin = end * (1u64 << DEPTH) as f64;
            assert!(!matches!(after, Found::Hit(at) if (at as f64) < begin), "{end}: {after:?}");
        }
    }
}

/// Components are below the unit, also where their bound was rounded down past a power of two.
#[test]
fn a_unit_is_above_all_components() {
    let motion = |greatest: f32| {
        let x = [[0.0; 3], [greatest, 0.0, 0.0], [0.0; 3], [0.0; 3]];
        Motion::edge_edge(&x, &x, 0.0)
    };
    for (greatest, want) in [(0.75, 0), (1.0, 1), (1.5, 1), (0.5f32.next_up(), 0)] {
        assert_eq!(unit(&motion(greatest)), want, "{greatest}");
    }
    // Less than 4 units in the last place below 1, which it may be in truth.
    assert_eq!(unit(&motion(1.0f32.next_down().next_down())), 1);
    for greatest in [0.0, 1e-20, 1e20, f32::INFINITY, f32::NAN] {
        assert_eq!(unit(&motion(greatest)), NO_UNIT, "{greatest}");
    }
}

#[test]
fn degenerate_queries_are_never_wrong() {
    let mut random = Random::new(6);
    let mut count = Count::default();
    for i in 0..40_000usize {
        let n = 2 + i % 4;
        let query = [(); 2].map(|()| {
            [(); 4].map(|()| [(); 3].map(|()| random.below(n as _) as f64 - (n / 2) as f64))
        });
        let whole = Search::whole(0.0);
        let half = Search { until: 0.5, ..whole };
        count.check(PATCHES[i / 4 % 2], query, [&whole, &half][i / 8 % 2]);
    }
    println!("misses, hits, open: {:?}", count.0);
    assert!(count.0.iter().all(|&n| n > 1000), "{:?}", count.0);
}

/// A vertex passes a triangle at its rim, fast or so slowly that no sign is certain for long.
#[test]
fn contacts_near_a_rim_are_never_wrong() {
    let mut random = Random::new(9);
    let mut count = Count::default();
    for i in 0..60_000 {
        let mut power = |least: u64| 2f64.powi(-(random.below(least as _) as i32));
        let (beside, speed, way, when) = (power(64), power(50), power(20), power(8));
        let beside = if i % 2 == 0 { beside } else { -beside };
        let at = |t: f64| {
            let vertex = [way * (t - when) + beside, speed * (when - t), 0.25];
            [vertex, [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        };
        let whole = Search::whole(0.0);
        let fine = Search { tolerance: 2f64.powi(-30), ..whole };
        let part = Search { from: 2f64.powi(-20), ..fine };
        count.check(Patch::Triangle, [at(0.0), at(1.0)], &[whole, fine, part][i / 2 % 3]);
    }
    assert!(count.0.iter().all(|&n| n > 3000), "{:?}", count.0);
}

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).expect("a finite number")
}

/// Control values of the cubic, over the step and over parts of it, as far from those of rational
/// arithmetic as the head of the file says, and no further.
#[test]
fn control_values_are_within_their_bound() {
    let mut random = Random::new(7);
    let (mut first, mut later) = (0.0f64, 0.0f64);
    for i in 0..400 {
        // As great as may be, and with all their digits.
        let mut coordinate = |i: usize| {
            let x = random.unit() + random.unit() / (1u64 << 24) as f64;
            let x = x - random.unit() / (1u64 << 48) as f64;
            (if i.is_multiple_of(2) { x } else { 0.9999999 - x * 1e-8 })
                * if random.below(2) == 0 { -0.5 } else { 0.5 }
        };
        let query: Query = [(); 2].map(|()| [(); 4].map(|()| [(); 3].map(|()| coordinate(i))));
        let [at_first, at_last] = errors(PATCHES[i % 2], &query, random.bits() >> 1);
        (first, later) = (first.max(at_first), later.max(at_last));
    }
    println!("control values: off by {first} u at first, {later} u after halvings");
    assert!(first > 4.0 && first < 75.0 && later > 10.0 && later < BAND as f64);
}

/// The points and the part of the step at which control values are furthest off that a climb over
/// digits, and then over ways of a search, has found: by more than half of the band.
#[test]
fn the_band_is_needed() {
    // Multiples of 2^-54, and the number of the part.
    let points = [
        [
            [8_977_976_834_129_455, 9_007_199_254_739_180, -8_703_402_196_768_804],
            [-9_007_199_254_740_929, 9_007_190_664_806_355, -8_973_747_012_763_647],
        ],
        [
            [-8_997_094_136_217_600, -7_299_648_569_999_359, 8_998_938_618_757_120],
            [-9_007_199_248_474_954, -8_870_709_421_932_544, 9_007_199_254_740_991],
        ],
        [
            [-8_992_520_667_136_000, 8_994_556_750_069_759, -8_982_532_412_452_539],
            [6_755_399_441_055_739, 9_007_198_779_804_762, 8_989_775_109_292_023],
        ],
        [
            [3_142_037_012_479_999, 8_974_198_582_015_912, 8_992_398_493_351_936],
            [8_946_270_656_072_882, -7_146_228_278_652_929, -9_004_929_892_792_448],
        ],
    ];
    let coordinate = |x: i64| x as f64 / (1u64 << 54) as f64;
    let query: Query = [0, 1].map(|t| points.map(|p| p[t].map(coordinate)));
    let [first, later] = errors(Patch::Triangle, &query, 0x4c_2656);
    assert!(first > 51.0 && first < 75.0 && later > 64.0 && later < BAND as f64);
    // At first, 31 halvings of three means, and another interval.
    let derived = 75.0 + 31.0 * 1.5 + 3.0;
    assert!(f64::from(BAND) >= derived, "{BAND} u, but {derived} are needed");
}

/// How far control values over the step, and over part `k` of 2^31 by the way of a search and at
/// once, are from those of rational arithmetic, in `u`.
fn errors(patch: Patch, query: &Query, k: u32) -> [f64; 2] {
    let point = |i: usize| query.map(|x| x[i].map(|c| of(c, 0)));
    let found = coplanarity(&vectors(patch, &[point(0), point(1), point(2), point(3)]));
    let want = control_values(patch, query);
    let mut c = found;
    for depth in 1..=DEPTH {
        let (p, q, r) = (c[0].mean(c[1]), c[1].mean(c[2]), c[2].mean(c[3]));
        let (s, t) = (p.mean(q), q.mean(r));
        let middle = s.mean(t);
        let is_second = (k >> (DEPTH - depth)) & 1 == 1;
        c = if is_second { [middle, t, r, c[3]] } else { [c[0], p, s, middle] };
    }
    let time = |k: u32| rational(k as f64 / (1u64 << DEPTH) as f64);
    let over_part: Vec<BigRational> =
        (0..4).map(|i| blossom(&want, [0, 1, 2].map(|j| time(k + (i + j >= 3) as u32)))).collect();
    let off = |found: &[Q62], want: &[BigRational]| {
        let error = |(x, want): (&Q62, &BigRational)| {
            (BigRational::from_integer(x.units().into()) - want).abs().to_f64().expect("a number")
        };
        found.iter().zip(want).map(error).fold(0.0, f64::max)
    };
    let later = off(&c, &over_part).max(off(&over(found, k, k + 1), &over_part));
    let at_begin = [value(found, k)];
    [off(&found, &want), later.max(off(&at_begin, &over_part[..1]))]
}

/// Whatever is guessed, a zero that is located is there, and is the only one of its interval.
#[test]
fn no_guess_is_trusted() {
    let mut random = Random::new(8);
    let (mut located, mut elsewhere) = (0, 0);
    for i in 0..4000 {
        let mut coordinate = || (random.unit() + random.unit() / (1u64 << 24) as f64 - 0.5) * 0.9;
        let query: Query = [(); 2].map(|()| [(); 4].map(|()| [(); 3].map(|()| coordinate())));
        let patch = PATCHES[i % 2];
        let point = |i: usize| query.map(|x| x[i].map(|c| of(c, 0)));
        let whole = coplanarity(&vectors(patch, &[point(0), point(1), point(2), point(3)]));
        let want = control_values(patch, &query);
        let depth = random.below(6);
        let begin = (random.below(1 << depth)) << (DEPTH - depth);
        let end = begin + (1 << (DEPTH - depth));
        let c = over(whole, begin, end);
        if !Signs::of(c).have_one_zero() {
            continue;
        }
        let time = |k: u32| rational(k as f64 / (1u64 << DEPTH) as f64);
        let control =
            |i: usize| blossom(&want, [0, 1, 2].map(|j| time([begin, end][(i + j >= 3) as usize])));
        let signs: Vec<bool> = (0..4).map(|i| control(i).is_positive()).collect();
        assert_eq!(signs.windows(2).filter(|two| two[0] != two[1]).count(), 1);
        let part = Part { begin, end, depth };
        for guess in [guess(c), random.unit() as f32, 0.0, 1.0, 2.0, -1.0, f32::NAN, f32::INFINITY]
        {
            let finest = depth + random.below(DEPTH - depth + 1);
            let near = around_zero(part, guess, finest);
            let differ = sign(value(whole, near.begin)) | sign(value(whole, near.end)) == 3;
            assert!(near.begin >= begin && near.end <= end && near.depth == finest);
            assert!(near.end - near.begin <= 1 << (DEPTH - finest));
            let is_positive = |k: u32| blossom(&want, [0; 3].map(|_| time(k))).is_positive();
            assert!(!differ || is_positive(near.begin) != is_positive(near.end));
            located += differ as u32;
            elsewhere += !differ as u32;
        }
    }
    assert!(located > 500 && elsewhere > 1000, "{located} {elsewhere}");
}

/// What stands still has components that are exact here, so of a determinant all of the error is
/// that of its bound: `17 u` for products and factors, and `4 u` for what travels may be off by.
#[test]
fn a_determinant_is_uncertain_within_its_bound() {
    let still = |x: [f64; 3]| [x.map(|c| of(c, -2)); 2];
    let (b, c) = (still([0.25, 0.0, 0.0]), still([0.0, 0.25, 0.0]));
    // A quarter of this component is so many `u`.
    let outside_by = |units: i32| {
        let a = still([-(4 * units) as f64 * 2f64.powi(-62), 0.125, 0.0]);
        place(&[a, b, c], Patch::Triangle, 0, DEPTH)
    };
    assert!(outside_by(16 + 4) == Place::Unknown && outside_by(100) == Place::Outside);
}

/// Three times the control values in multiples of `u`, in a unit of 4.
fn control_values(patch: Patch, query: &Query) -> Vec<BigRational> {
    let [t0, t1] = query.map(|x| x.map(|p| p.map(|c| rational(c / 4.0))));
    let less =
        |x: &[[BigRational; 3]; 4], i: usize, j: usize| [0, 1, 2].map(|k| &x[i][k] - &x[j][k]);
    let of = |x: &[[BigRational; 3]; 4]| match patch {
        Patch::Triangle => [less(x, 0, 1), less(x, 2, 1), less(x, 3, 1)],
        Patch::Parallelogram => [less(x, 2, 0), less(x, 1, 0), less(x, 2, 3)],
    };
    let ends = [of(&t0), of(&t1)];
    let det = |a: usize, b: usize, c: usize| {
        let [a, b, c] = [&ends[a][0], &ends[b][1], &ends[c][2]];
        let cross = |i: usize, j: usize| &b[i] * &c[j] - &b[j] * &c[i];
        &a[0] * cross(1, 2) + &a[1] * cross(2, 0) + &a[2] * cross(0, 1)
    };
    let unit = rational((1u64 << 62) as f64);
    let three = rational(3.0) * &unit;
    Vec::from([
        det(0, 0, 0) * &three,
        (det(1, 0, 0) + det(0, 1, 0) + det(0, 0, 1)) * &unit,
        (det(0, 1, 1) + det(1, 0, 1) + det(1, 1, 0)) * &unit,
        det(1, 1, 1) * &three,
    ])
}

/// The value that is symmetric in three times, linear in each, and the cubic where they are one.
fn blossom(c: &[BigRational], times: [BigRational; 3]) -> BigRational {
    let mut x = c.to_vec();
    for t in &times {
        x = x.windows(2).map(|pair| &pair[0] + (&pair[1] - &pair[0]) * t).collect();
    }
    x.swap_remove(0)
}
