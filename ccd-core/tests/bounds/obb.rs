//! Oriented boxes against exact arithmetic: they hold what they were fitted around, and only boxes
//! without a common point are told apart.

use crate::common::oriented::{disjoint, holds, holds_box, skew, widen};
use crate::common::random::Random;
use ccd_core::math::obb::Obb;
use ccd_core::math::symmetric_eigen::{ORTHONORMAL, identity};
use ccd_core::math::vec3::{cross, dot};
use ccd_core::{Aabb, Real};

type Points<T> = [[T; 3]; 6];

/// Clouds of all kinds: of any size, degenerate, far away, flat, with points that coincide.
fn cloud<T: Real>(random: &mut Random, scale: f64) -> Points<T> {
    let (a, b, c) = (random.vector(), random.vector(), random.vector());
    let kind = random.below(8);
    let offset = match random.below(3) {
        0 => [0.0; 3],
        1 => random.vector(),
        _ => random.vector().map(|x| 1e4 * x),
    };
    let mut corner = 0;
    std::array::from_fn(|_| {
        corner += 1;
        let (x, y, z) = match kind {
            0 => (0.0, 0.0, 0.0),
            1 => (random.between(-1.0, 1.0), 0.0, 0.0),
            2 => (random.between(-1.0, 1.0), random.between(-1.0, 1.0), 0.0),
            3 => (random.between(-1.0, 1.0), random.between(-1.0, 1.0) * 1e-6, 0.0),
            // Six corners of an octahedron: equal eigenvalues.
            4 => {
                let sign = if corner % 2 == 0 { 1.0 } else { -1.0 };
                let on = |k: usize| if corner % 3 == k { sign } else { 0.0 };
                return [on(0), on(1), on(2)].map(|x| T::from_f64(x * scale));
            }
            _ => {
                let v = random.vector();
                (v[0], v[1], v[2])
            }
        };
        std::array::from_fn(|k| T::from_f64((x * a[k] + y * b[k] + z * c[k] + offset[k]) * scale))
    })
}

fn check_fit<T: Real>(points: &Points<T>) -> Obb<T> {
    let b = Obb::around(points);
    check_around(&b, points);
    // The same points as corners of what moves.
    let [p, q, r, s, t, u] = *points;
    assert_eq!(Obb::of_moving_triangle(&[p, q, r], &[s, t, u]), b);
    b
}

/// Axes are as promised, and all points are in the box.
fn check_around<T: Real>(b: &Obb<T>, points: &[[T; 3]]) {
    let off = skew(b);
    assert!(off <= ORTHONORMAL as f64, "axes off by {off} u: {b:?} around {points:?}");
    assert!(b.half.iter().all(|h| h.is_finite_number()), "{b:?}");
    for p in points {
        let told = || format!("{p:?} is not in {b:?}");
        assert!(*b == Obb::everything() || holds(&widen(b), p.map(|x| x.to_f64())), "{}", told());
    }
}

fn check_fits<T: Real>(scales: &[f64]) {
    let mut random = Random::new(21);
    for &scale in scales {
        for _ in 0..150 {
            let (a, b) = (cloud::<T>(&mut random, scale), cloud(&mut random, scale));
            let (a, b) = (check_fit(&a), check_fit(&b));
            let both = Obb::around_two(&a, &b);
            assert!(skew(&both) <= ORTHONORMAL as f64, "{both:?}");
            for x in [&a, &b] {
                assert!(holds_box(&widen(&both), &widen(x)), "{x:?} is not in {both:?}");
            }
        }
    }
}

#[test]
fn boxes_hold_what_they_are_around() {
    check_fits::<f64>(&[1.0, 1e-3, 1e95, 1e-150, 1e-310]);
    check_fits::<f32>(&[1.0, 1e-3, 1e30, 1e-30, 1e-40]);
}

/// A grown box reaches at least the distance further, exactly, and holds what is so near to a point
/// of it along its own axes, which are `8 u` longer than 1 at most.
fn check_grown<T: Real>() {
    let mut random = Random::new(23);
    for _ in 0..300 {
        let (points, size) = (cloud::<T>(&mut random, 1.0), random.power(-9.0, 3.0));
        let (b, distance) = (Obb::around(&points), T::from_f64(size));
        let (box_of, grown) = (widen(&b), widen(&b.grown(distance)));
        for k in 0..3 {
            let needed = two_sum(box_of.half[k], distance.to_f64());
            assert!(two_sum(grown.half[k], 0.0) >= needed, "{b:?}, {size:e}");
            for (p, sign) in points.iter().zip([1.0, -1.0].into_iter().cycle()) {
                let far = sign * distance.to_f64() * (1.0 - 24.0 * T::UNIT.to_f64());
                let q = std::array::from_fn(|i| p[i].to_f64() + far * box_of.axes[k][i]);
                assert!(T::UNIT.to_f64() < 1e-10 || holds(&grown, q), "{q:?} is not in {grown:?}");
            }
        }
    }
}

/// The sum of two numbers and what its rounding left, which compare as the sum does.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

#[test]
fn grown_boxes_hold_what_is_near() {
    check_grown::<f32>();
    check_grown::<f64>();
}

#[test]
fn what_overflows_is_in_a_box_of_everything() {
    let far = |x: f32| [[x; 3], [-x; 3], [x, -x, x], [x, 0.0, 0.0], [0.0; 3], [-x, x, x]];
    for x in [2.9e38, f32::MAX, f32::INFINITY, f32::NAN] {
        let b = Obb::around(&far(x));
        if x.is_finite() {
            far(x).iter().for_each(|p| assert!(holds(&widen(&b), p.map(f64::from)), "{x:e} {b:?}"));
        } else {
            assert_eq!(b, Obb::everything(), "{x:e}");
        }
        assert_eq!(Obb::<f32>::everything().half, [f32::MAX; 3]);
        let near = Obb::around(&far(1.0));
        assert_eq!(Obb::around_two(&near, &Obb::everything()), Obb::everything());
        let wide = Aabb { min: [-2.9e38f32; 3], max: [2.9e38; 3] };
        for other in [b, near, Obb::everything(), Obb::of_box(&wide)] {
            assert!(!(Obb::everything().gap(&other) > 0.0 || other.gap(&Obb::everything()) > 0.0));
            assert!(!Obb::everything().separated(&other) && !other.separated_from_box(&wide));
        }
    }
    // A number that is none is nowhere apart.
    let nowhere = Obb { centre: [f32::NAN, 0.0, 0.0], axes: identity(), half: [1.0; 3] };
    let somewhere = Obb { centre: [9.0; 3], ..nowhere };
    assert!(!nowhere.separated(&somewhere) && !(nowhere.gap(&somewhere) > 0.0));
    assert!(Obb { centre: [0.0; 3], ..nowhere }.separated(&somewhere));
}

/// What is told apart is; what is apart by a thousandth of the sizes is told.
fn check_pair<T: Real>(a: &Obb<T>, b: &Obb<T>) -> bool {
    let told = a.gap(b) > T::splat(0.0);
    assert_eq!(told, a.separated(b), "{a:?} {b:?}");
    let (wide_a, wide_b) = (widen(a), widen(b));
    if told {
        assert!(disjoint(&wide_a, &wide_b), "told apart: {a:?} {b:?}");
    } else {
        let size: f64 = wide_a.half.iter().chain(&wide_b.half).sum();
        let grown = Obb { half: wide_a.half.map(|h| h + 1e-3 * size), ..wide_a };
        assert!(!disjoint(&grown, &wide_b), "not told apart: {a:?} {b:?}");
    }
    told
}

/// A box of any shape; with axes along the coordinates, nearly along them, or turned.
fn oriented<T: Real>(random: &mut Random) -> Obb<T> {
    let turn = [0.0, 1e-7, 1e-3, 1.0][random.below(4)];
    let mut m = identity::<f64>();
    m.as_flattened_mut().iter_mut().for_each(|x| *x += turn * random.between(-1.0, 1.0));
    // Axes by a fit to a cloud that lies along these.
    let half: [f64; 3] = std::array::from_fn(|_| random.power(-8.0, 0.0));
    let points: Points<T> = std::array::from_fn(|i| {
        let sign = if i % 2 == 0 { 1.0 } else { -1.0 };
        m[i / 2].map(|x| T::from_f64(x * sign * half[i / 2]))
    });
    Obb::around(&points)
}

/// Pairs that touch in corners, edges and faces, up to some units of roundoff to either side.
fn check_touching<T: Real>() {
    let mut random = Random::new(22);
    let (mut n_told, mut n_apart) = (0, 0);
    for _ in 0..400 {
        let (a, mut b) = (oriented::<T>(&mut random), oriented::<T>(&mut random));
        let [m, n] = [&a, &b].map(|x| widen(x).axes);
        let (i, j) = (random.below(3), random.below(3));
        let w = match random.below(4) {
            0 => m[i],
            1 => n[j],
            2 => cross(m[i], n[j]),
            _ => random.vector(),
        };
        let (p, q) = (farthest(&mut random, &a, w), farthest(&mut random, &b, w.map(|x| -x)));
        let size = sum(&a.half) + sum(&b.half);
        let off = T::UNIT.to_f64() * [0.0, 1.0, -1.0, 300.0, 3000.0, 1e5][random.below(6)];
        let length = dot(w, w).sqrt().max(f64::MIN_POSITIVE);
        b.centre = std::array::from_fn(|k| {
            let x = a.centre[k].to_f64() + p[k] - q[k];
            T::from_f64(x + size * off * w[k] / length)
        });
        n_told += check_pair(&a, &b) as usize;
        n_apart += disjoint(&widen(&a), &widen(&b)) as usize;
        let aabb = Aabb {
            min: std::array::from_fn(|k| b.centre[k] - b.half[0].max(b.half[k])),
            max: std::array::from_fn(|k| b.centre[k] + b.half[1].max(b.half[k])),
        };
        let boxed = Obb::of_box(&aabb);
        for c in 0..8 {
            let corner = std::array::from_fn(|k| [aabb.min[k], aabb.max[k]][c >> k & 1].to_f64());
            assert!(holds(&widen(&boxed), corner), "{corner:?} is not in {boxed:?}");
        }
        let told = a.separated_from_box(&aabb);
        assert!(!told || disjoint(&widen(&a), &widen(&boxed)), "told apart: {a:?} {aabb:?}");
        assert_eq!(told, check_pair(&boxed, &a), "{a:?} {aabb:?}");
    }
    assert!(n_told > 50 && n_apart > n_told && n_apart < 350, "{n_told} of {n_apart} told apart");
}

/// A point of a box, relative to its centre, that is farthest along `w`: a corner, or one of the
/// edge or face that is.
fn farthest<T: Real>(random: &mut Random, b: &Obb<T>, w: [f64; 3]) -> [f64; 3] {
    let Obb { axes, half, .. } = widen(b);
    let at: [f64; 3] = std::array::from_fn(|i| match dot(axes[i], w) {
        x if x.abs() < 1e-6 => random.between(-1.0, 1.0),
        x => x.signum(),
    });
    std::array::from_fn(|k| (0..3).map(|i| at[i] * half[i] * axes[i][k]).sum())
}

fn sum<T: Real>(x: &[T; 3]) -> f64 {
    x.iter().map(|x| x.to_f64()).sum()
}

#[test]
fn what_is_told_apart_has_no_point_in_common() {
    check_touching::<f32>();
    check_touching::<f64>();
}

#[test]
fn edges_tell_what_faces_do_not() {
    // Two long boxes that cross at a right angle, each turned about its own length by an eighth.
    let s = 0.5f64.sqrt();
    let a = Obb {
        centre: [0.0; 3],
        axes: [[1.0, 0.0, 0.0], [0.0, s, s], [0.0, -s, s]],
        half: [10.0, 1.0, 1.0],
    };
    let at = |z: f64| Obb {
        centre: [0.0, 0.0, z],
        axes: [[0.0, 1.0, 0.0], [s, 0.0, s], [-s, 0.0, s]],
        half: [10.0, 1.0, 1.0],
    };
    // Along z, the product of both lengths, each reaches the square root of 2.
    assert!(a.separated(&at(2.83)) && at(2.83).separated(&a) && !a.separated(&at(2.82)));
    // Parallel boxes, whose products are zero, are told apart by faces alone.
    let beside = |y: f64| Obb { centre: [0.0, s * y, s * y], ..a };
    assert!(a.separated(&beside(2.001)) && !a.separated(&beside(1.999)));
}

#[test]
fn a_box_follows_a_slanted_triangle() {
    // It moves within its own plane, so the box is flat; one along the coordinates is not.
    let t0 = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let t1 = t0.map(|[x, y, z]: [f64; 3]| [x + 0.5, y + 0.5, z]);
    let b = Obb::of_moving_triangle(&t0, &t1);
    let thin = b.half.into_iter().fold(f64::INFINITY, f64::min);
    assert!(thin < 1e-14, "{b:?}");
    for t in [0.0, 0.25, 0.5, 1.0] {
        for (p, q) in t0.iter().zip(&t1) {
            let p: [f64; 3] = std::array::from_fn(|k| p[k] + (q[k] - p[k]) * t);
            assert!(holds(&widen(&b), p), "{p:?} at {t} is not in {b:?}");
        }
    }
    // Boxes end to end along a slanted line are joined without getting thicker.
    let next = Obb { centre: b.centre.map(|x| x + 0.01), ..b };
    let both = Obb::around_two(&b, &next);
    assert!(both.half.into_iter().fold(f64::INFINITY, f64::min) < 0.02, "{both:?}");
}
