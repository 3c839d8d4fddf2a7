//! The bounds of oriented boxes against an adversary, with axes as skew as they may be, and against
//! counts of operations.

use crate::common::adversary::{Adversarial, MIN_NORMAL, UNIT};
use crate::common::ascent::Ascent;
use ccd_core::Real;
use ccd_core::math::obb::Obb;
use ccd_core::math::symmetric_eigen::{ORTHONORMAL, identity};
use ccd_core::math::vec3::{add, cross, dot, scale, sub, sum_abs};

type V = [f64; 3];

/// Inputs of a frame.
const FRAME: usize = 13;
/// Inputs of a box: its frame and its half lengths.
const BOX: usize = FRAME + 3;

fn wrap(x: V) -> [Adversarial; 3] {
    x.map(Adversarial)
}

fn wrap_box(b: &Obb<f64>) -> Obb<Adversarial> {
    Obb { centre: wrap(b.centre), axes: b.axes.map(wrap), half: wrap(b.half) }
}

/// The greatest difference of a scalar product from that of orthonormal axes.
fn skew(m: &[V; 3]) -> f64 {
    let off = |i: usize, j: usize| (dot(m[i], m[j]) - (i == j) as u8 as f64).abs();
    (0..9).map(|k| off(k / 3, k % 3)).fold(0.0, f64::max)
}

/// Axes from 13 inputs: a rotation, from four of them, and a deviation that is as large as is
/// allowed.
fn frame(x: &[f64]) -> [V; 3] {
    let length = x[..4].iter().map(|x| x * x).sum::<f64>().sqrt();
    let [r, i, j, k] = if length > 1e-3 {
        [x[0], x[1], x[2], x[3]].map(|x| x / length)
    } else {
        [1.0, 0.0, 0.0, 0.0]
    };
    let turned = [
        [1.0 - 2.0 * (j * j + k * k), 2.0 * (i * j - k * r), 2.0 * (i * k + j * r)],
        [2.0 * (i * j + k * r), 1.0 - 2.0 * (i * i + k * k), 2.0 * (j * k - i * r)],
        [2.0 * (i * k - j * r), 2.0 * (j * k + i * r), 1.0 - 2.0 * (i * i + j * j)],
    ];
    let off = |size: f64| -> [V; 3] {
        std::array::from_fn(|a| std::array::from_fn(|b| turned[a][b] + size * x[4 + 3 * a + b]))
    };
    let allowed = ORTHONORMAL as f64 * UNIT;
    let size = allowed * 0.999 * (1e-6 / skew(&off(1e-6)).max(1e-9)).min(4.0);
    let out = off(size);
    assert!(skew(&out) <= allowed, "{} {allowed}", skew(&out));
    out
}

fn half(x: &[f64], size: f64) -> V {
    std::array::from_fn(|k| {
        let part = 0.5 + 0.5 * x[k];
        size * part * part * part + 64.0 * MIN_NORMAL
    })
}

fn oriented(x: &[f64], size: f64) -> Obb<f64> {
    Obb { centre: [0.0; 3], axes: frame(x), half: half(&x[FRAME..], size) }
}

/// Corners, relative to the centre.
fn corners(b: &Obb<f64>) -> [V; 8] {
    let [p, q, r] = b.axes;
    let edges = [cross(q, r), cross(r, p), cross(p, q)];
    let determinant = dot(p, edges[0]);
    std::array::from_fn(|corner| {
        let way = |i: usize| {
            let sign = if corner >> i & 1 == 0 { 1.0 } else { -1.0 };
            scale(edges[i], sign * b.half[i] / determinant)
        };
        add(add(way(0), way(1)), way(2))
    })
}

/// The corner that is farthest along `w`.
fn farthest(b: &Obb<f64>, w: V) -> V {
    corners(b).into_iter().max_by(|p, q| dot(*p, w).total_cmp(&dot(*q, w))).unwrap()
}

/// What the products of an axis with a vector sum to without signs.
fn size_along(axis: V, d: V) -> f64 {
    (0..3).map(|k| (axis[k] * d[k]).abs()).sum()
}

#[test]
fn points_in_a_box() {
    for (name, size, documented) in [("points", 1.0, 0.8), ("points, flushed", 1e-38, 0.04)] {
        let ratio = |x: &[f64]| {
            let axes = frame(x);
            let at = |i: usize| -> V { std::array::from_fn(|k| size * x[FRAME + 3 * i + k]) };
            let (p, c) = (at(0), at(1));
            let b = Obb::reaching(wrap(c), axes.map(wrap), &[wrap(p)]);
            let worst = |k: usize| {
                let d = sub(p, c);
                let bound = 6.0 * UNIT * size_along(axes[k], d) + 64.0 * MIN_NORMAL;
                1.0 + (dot(axes[k], d).abs() - b.half[k].0) / bound
            };
            (0..3).map(worst).fold(f64::NEG_INFINITY, f64::max)
        };
        let ascent = Ascent { n_inputs: FRAME + 6, flush: size < 1e-6, ratio };
        ascent.check(name, 31, [2, 300], documented);
    }
}

#[test]
fn boxes_in_a_box() {
    for (name, size, documented) in [("box", 1.0, 0.7), ("box, flushed", 1e-37, 0.03)] {
        let ratio = |x: &[f64]| {
            let (a, axes) = (oriented(x, size), frame(&x[BOX..]));
            let centre: V = std::array::from_fn(|k| size * x[BOX + FRAME + k]);
            let wrapped = wrap_box(&a);
            let b = Obb::reaching_two(wrap(centre), axes.map(wrap), &wrapped, &wrapped);
            let d = sub(a.centre, centre);
            let worst = |k: usize| {
                let bound = 8.0 * UNIT * size_along(axes[k], d)
                    + 64.0 * UNIT * sum_abs(a.half)
                    + 64.0 * MIN_NORMAL;
                let sign = if dot(axes[k], d) < 0.0 { -1.0 } else { 1.0 };
                let far = add(d, farthest(&a, scale(axes[k], sign)));
                // What is there for centres that are two numbers is left out.
                let half = b.half[k].0 - 16.0 * UNIT * sum_abs(d);
                1.0 + (dot(axes[k], far).abs() - half) / bound
            };
            (0..3).map(worst).fold(f64::NEG_INFINITY, f64::max)
        };
        let ascent = Ascent { n_inputs: BOX + FRAME + 3, flush: size < 1e-6, ratio };
        ascent.check(name, 33, [2, 300], documented);
    }
}

/// A sum of terms in the order that `by` sorts them in.
fn summed(mut terms: Vec<(f64, Adversarial)>) -> Adversarial {
    terms.sort_by(|x, y| x.0.total_cmp(&y.0));
    terms.into_iter().map(|(_, term)| term).reduce(|sum, term| sum + term).unwrap()
}

/// A centre that is kept as one sum and gone on with as another.
#[test]
fn boxes_in_a_box_around_two_centres() {
    for (name, far, near, documented) in
        [("centres", 1.0, 0.0, 0.9), ("near centres", 0.0, 1.0, 0.55), ("both", 1.0, 0.1, 0.8)]
    {
        let ratio = |x: &[f64]| {
            let (axes, x) = (frame(x), &x[FRAME..]);
            let at = |i: usize| -> V { std::array::from_fn(|k| far * x[3 * i + k]) };
            let (a, b, steps) = (at(0), at(1), [0, 1, 2].map(|i| near * x[6 + i]));
            let part = |i: usize, k: usize| Adversarial(axes[i][k]) * Adversarial(steps[i]);
            let terms = |k: usize, from: usize, other: Option<f64>| {
                let mut terms: Vec<_> = (0..3).map(|i| (x[from + i], part(i, k))).collect();
                terms.push((x[from + 3], Adversarial(a[k])));
                terms.extend(other.map(|b| (x[from + 4], -Adversarial(b))));
                terms
            };
            let kept: V = std::array::from_fn(|k| summed(terms(k, 9, None)).0);
            // Such that the differences from the centre are those sums.
            let small = |centre| Obb { centre, axes: identity(), half: [64.0 * MIN_NORMAL; 3] };
            let (first, second) = (wrap_box(&small(a)), wrap_box(&small(b)));
            let went_on: [V; 2] = [(a, 13), (b, 18)].map(|(other, from)| {
                std::array::from_fn(|k| other[k] + summed(terms(k, from, Some(other[k]))).0)
            });
            let pick = (x[23] > 0.0) as usize;
            let outer = Obb::reaching_two(wrap(went_on[pick]), axes.map(wrap), &first, &second);
            let inner = [a, b][pick];
            let worst = |k: usize| {
                let d = sub(inner, kept);
                let greatest = std::array::from_fn(|k| a[k].abs().max(b[k].abs()));
                let bound = 12.0 * UNIT * size_along(axes[k], greatest)
                    + 16.0 * UNIT * sum_abs(sub(a, kept))
                    + 8.0 * UNIT * size_along(axes[k], d)
                    + 64.0 * MIN_NORMAL;
                1.0 + (dot(axes[k], d).abs() - outer.half[k].0) / bound
            };
            (0..3).map(worst).fold(f64::NEG_INFINITY, f64::max)
        };
        Ascent { n_inputs: FRAME + 24, flush: false, ratio }.check(name, 37, [3, 300], documented);
    }
}

#[test]
fn boxes_that_touch() {
    for (name, size, turned, documented) in [
        ("gap", 1.0, 1.0, 0.09),
        ("gap of parallel boxes", 1.0, 0.0, 0.11),
        // Products of half lengths with sines that are not normal.
        ("gap, flushed", 1e-37, 0.005, 0.028),
    ] {
        // Two boxes that share a corner: the one farthest along an axis of one of them, a product
        // of two, or any direction.
        let ratio = |x: &[f64]| {
            let mut x = x.to_vec();
            for i in [0, BOX] {
                x[i] = if turned < 1.0 { 1.0 } else { x[i] };
                x[i + 1..i + 4].iter_mut().for_each(|x| *x *= turned);
            }
            let (a, mut b) = (oriented(&x, size), oriented(&x[BOX..], size));
            let rest = &x[2 * BOX..];
            let pick = |x: f64| ((0.5 + 0.49 * x) * 3.0) as usize;
            let (i, j) = (pick(rest[0]), pick(rest[1]));
            let w = match ((0.5 + 0.49 * rest[2]) * 4.0) as usize {
                0 => a.axes[i],
                1 => b.axes[j],
                2 => cross(a.axes[i], b.axes[j]),
                _ => [rest[3], rest[4], rest[5]],
            };
            b.centre = sub(farthest(&a, w), farthest(&b, scale(w, -1.0)));
            let sizes = sum_abs(b.centre) + sum_abs(a.half) + sum_abs(b.half);
            let bound = 256.0 * UNIT * sizes + 128.0 * MIN_NORMAL;
            1.0 + wrap_box(&a).gap(&wrap_box(&b)).0 / bound
        };
        let ascent = Ascent { n_inputs: 2 * BOX + 6, flush: size < 1e-6, ratio };
        ascent.check(name, 35, [2, 300], documented);
    }
}

/// Counts of operations, written down anew from the head of `math/obb/mod.rs`.
fn check_counts<R: Real>() {
    let u = R::UNIT.to_f64();
    let number = |x: f64| R::from_f64(x);
    let nearly = 1.0 - 1e-5;
    // Along the coordinates, so that nothing but the bound is rounded.
    let axes = identity::<R>();
    let p = [3.0, -5.0, 0.25];
    let b = Obb::reaching([number(0.0); 3], axes, &[p.map(number)]);
    for k in 0..3 {
        let (h, x) = (b.half[k].to_f64(), p[k].abs());
        assert!(h - x >= 5.0 * u * x * nearly, "{h:e} around {x}");
    }
    let inner = Obb { centre: p.map(number), axes, half: [1.0, 0.5, 2.0].map(number) };
    let outer = Obb::reaching_two([number(0.0); 3], axes, &inner, &inner);
    for k in 0..3 {
        let (h, x) = (outer.half[k].to_f64(), p[k].abs());
        let needed = 60.0 * u * 3.5 + 7.0 * u * x + 11.0 * u * x + 15.6 * u * 8.25;
        let h = h - x - inner.half[k].to_f64();
        // The sum that this is in the end of is rounded.
        assert!(h >= needed * nearly - 2.0 * u * x, "{h:e}, but {needed:e}");
    }
    // Boxes that share a face: the greatest separation is zero, and the bound is left.
    let a = Obb { centre: [number(0.0); 3], ..inner };
    for (k, t) in [(0, 2.0), (1, 1.0), (2, 4.0)] {
        let mut centre = [number(0.0); 3];
        centre[k] = number(t);
        let bound = -a.gap(&Obb { centre, ..a }).to_f64();
        let needed = 199.0 * u * 7.0 + 9.0 * u * t;
        assert!(bound >= needed, "{bound:e}, but {needed:e}");
    }
}

#[test]
fn bounds_are_at_least_as_counted() {
    check_counts::<f32>();
    check_counts::<f64>();
}
