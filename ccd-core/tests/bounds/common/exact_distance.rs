//! The square of the distance of two features at any time, in rational numbers: nothing is rounded.

use super::Points;
use ccd_core::narrow_phase::relative_motion::Patch;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

type Vector = [BigRational; 3];

pub fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("a finite number")
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|k| &a[k] - &b[k])
}

fn dot(a: &Vector, b: &Vector) -> BigRational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

/// `a + s b`.
fn ahead(a: &Vector, s: &BigRational, b: &Vector) -> Vector {
    std::array::from_fn(|k| &a[k] + s * &b[k])
}

fn point_segment(p: &Vector, a: &Vector, b: &Vector) -> BigRational {
    let (d, w) = (minus(b, a), minus(p, a));
    let (along, square) = (dot(&w, &d), dot(&d, &d));
    let zero = BigRational::zero();
    let s = if square.is_zero() || along.is_negative() { zero } else { along / square };
    let w =
        minus(&w, &ahead(&std::array::from_fn(|_| BigRational::zero()), &s.min(One::one()), &d));
    dot(&w, &w)
}

fn point_triangle([p, a, b, c]: &[Vector; 4]) -> BigRational {
    let sides = point_segment(p, a, b).min(point_segment(p, b, c)).min(point_segment(p, c, a));
    let (u, v, w) = (minus(b, a), minus(c, a), minus(p, a));
    let (uu, uv, vv, wu, wv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v), dot(&w, &u), dot(&w, &v));
    let det = &uu * &vv - &uv * &uv;
    let (s, r) = (&wu * &vv - &wv * &uv, &wv * &uu - &wu * &uv);
    if det.is_positive() && !s.is_negative() && !r.is_negative() && &s + &r <= det {
        let from = ahead(&ahead(a, &(s / &det), &u), &(r / &det), &v);
        let x = minus(p, &from);
        return dot(&x, &x);
    }
    sides
}

fn segment_segment([a, b, c, d]: &[Vector; 4]) -> BigRational {
    let first = point_segment(a, c, d).min(point_segment(b, c, d));
    let ends = first.min(point_segment(c, a, b)).min(point_segment(d, a, b));
    let (u, v, w) = (minus(b, a), minus(d, c), minus(c, a));
    let (uu, uv, vv, wu, wv) = (dot(&u, &u), dot(&u, &v), dot(&v, &v), dot(&w, &u), dot(&w, &v));
    let det = &uu * &vv - &uv * &uv;
    let (s, r) = (&wu * &vv - &wv * &uv, &wu * &uv - &wv * &uu);
    let inside = |x: &BigRational| !x.is_negative() && *x <= det;
    if det.is_positive() && inside(&s) && inside(&r) {
        let x = minus(&ahead(a, &(s / &det), &u), &ahead(c, &(r / &det), &v));
        return dot(&x, &x);
    }
    ends
}

/// Of `v f0 f1 f2` or `ea0 ea1 eb0 eb1` at time `t` of a step.
pub fn square(patch: Patch, t0: &Points<f64>, t1: &Points<f64>, t: &BigRational) -> BigRational {
    let x: [Vector; 4] = std::array::from_fn(|i| {
        std::array::from_fn(|k| {
            let (p, q) = (exact(t0[i][k]), exact(t1[i][k]));
            let moved = (q - &p) * t;
            p + moved
        })
    });
    match patch {
        Patch::Triangle => point_triangle(&x),
        Patch::Parallelogram => segment_segment(&x),
    }
}

#[test]
fn known_squares() {
    let face = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    for (p, want) in [
        ([0.25, 0.25, 0.5], 0.25),
        ([-1.0, -1.0, 1.0], 3.0),
        ([0.5, -2.0, 0.0], 4.0),
        ([1.0, 1.0, 0.0], 0.5),
    ] {
        let x = [p, face[0], face[1], face[2]];
        let got = square(Patch::Triangle, &x, &x, &exact(0.5));
        assert_eq!(got, exact(want), "{p:?}");
    }
    let edges = |z: f64, x: f64| [[0.0; 3], [1.0, 0.0, 0.0], [x, -1.0, z], [x, 1.0, z]];
    for (z, x, want) in [(0.5, 0.5, 0.25), (1.0, 2.0, 2.0), (0.0, -0.5, 0.25)] {
        let x = edges(z, x);
        let got = square(Patch::Parallelogram, &x, &x, &exact(0.5));
        assert_eq!(got, exact(want), "{x:?}");
    }
}
