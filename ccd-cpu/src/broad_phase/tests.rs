//! Pairs by every method are those of brute force.

use super::*;
use ccd_core::layout::Pair;
use ccd_core::model::catalogue::{Catalogued, every};

/// Bounds at and beyond the greatest that a rounded box has, and ordinary ones.
const BOUNDS: [f32; 13] = [
    f32::NEG_INFINITY,
    f32::MIN,
    -3.2e38,
    -2.95e38,
    -2.9e38,
    -1.0,
    0.0,
    1.0,
    2.9e38,
    2.95e38,
    3.2e38,
    f32::MAX,
    f32::INFINITY,
];

/// The methods that the table says are here.
fn methods() -> impl Iterator<Item = BroadPhaseMethod> {
    every("cpu")
}

#[test]
fn the_table_says_which_methods_are_here() {
    for row in BroadPhaseMethod::ROWS {
        let here = row.backends.contains(&"cpu");
        assert_eq!(BroadPhase::new(1, row.value).is_ok(), here, "{}", row.name);
    }
    for method in methods() {
        assert!(BroadPhase::new(1, method).is_ok(), "{method}");
    }
    assert!(methods().count() >= 2);
}

/// Pairs by all methods are those of brute force, in the precision of the boxes.
fn check_pairs<T: Coordinate>(a: &[Aabb<T>], b: &[Aabb<T>]) {
    let all = |n: usize, m: usize| (0..n).flat_map(move |i| (0..m).map(move |j| (i, j)));
    let pair = |(i, j): (usize, usize)| Pair { a: i as u32, b: j as u32 };
    let n = a.len();
    let within: Vec<Pair> =
        all(n, n).filter(|&(i, j)| i < j && a[i].overlaps(&a[j])).map(pair).collect();
    let between: Vec<Pair> =
        all(n, b.len()).filter(|&(i, j)| a[i].overlaps(&b[j])).map(pair).collect();
    assert!(!within.is_empty() && within.len() < n * (n - 1) / 2, "all or none overlap");
    let sorted = |pairs: Pairs| {
        let mut pairs = pairs.to_vec();
        pairs.sort_unstable_by_key(|p| (p.a, p.b));
        pairs
    };
    for method in methods() {
        let mut broad = BroadPhase::new(1, method).unwrap();
        let got = sorted(broad.self_pairs(a).unwrap());
        assert_eq!(got, within, "{method:?}, within {a:?}");
        let got = sorted(broad.pairs(a, b).unwrap());
        assert_eq!(got, between, "{method:?}, {a:?} against {b:?}");
    }
}

#[test]
fn huge_and_infinite_bounds_are_compared_as_they_are() {
    let apart = [(2.95e38f32, 3.0e38), (3.2e38, 3.3e38), (0.0, 3.1e38)]
        .map(|(min, max)| Aabb { min: [min, 0.0, 0.0], max: [max, 1.0, 1.0] });
    check_pairs(&apart, &apart);
    let mut x = 11u32;
    let mut bound = || {
        x = x.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (x >> 16) as usize % BOUNDS.len()
    };
    for n in [3usize, 8, 40] {
        for _ in 0..20 {
            let mut side = || (bound(), bound());
            let mut one = || {
                let sides: [_; 3] = std::array::from_fn(|_| side());
                Aabb {
                    min: sides.map(|(p, q)| BOUNDS[p.min(q)]),
                    max: sides.map(|(p, q)| BOUNDS[p.max(q)]),
                }
            };
            // The first two are apart, the third and the fourth overlap.
            let mut boxes = vec![apart[0], apart[1], apart[2], apart[2]];
            boxes.extend((0..n).map(|_| one()));
            let others: Vec<_> = (0..n).map(|_| one()).collect();
            check_pairs(&boxes, &others);
            let wide =
                |b: &Aabb<f32>| Aabb { min: b.min.map(f64::from), max: b.max.map(f64::from) };
            let far = |b: &Aabb<f32>| {
                let wide = wide(b);
                Aabb { min: wide.min.map(|x| x * 1e60), max: wide.max.map(|x| x * 1e60) }
            };
            for to_f64 in [&wide as &dyn Fn(&Aabb<f32>) -> Aabb<f64>, &far] {
                let all = |boxes: &[Aabb<f32>]| boxes.iter().map(to_f64).collect::<Vec<_>>();
                check_pairs(&all(&boxes), &all(&others));
            }
        }
    }
}
