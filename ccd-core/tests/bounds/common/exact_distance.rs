//! The square of the distance of two features at any time, in rational numbers: nothing is rounded.

use super::Points;
use super::distance::{point_triangle_squared, segment_segment_squared};
use ccd_core::narrow_phase::relative_motion::Patch;
use num_rational::BigRational;
use num_traits::Signed;

pub fn exact(x: f64) -> BigRational {
    BigRational::from_float(x).expect("a finite number")
}

/// Of `v f0 f1 f2` or `ea0 ea1 eb0 eb1` at time `t` of a step.
pub fn square(patch: Patch, t0: &Points<f64>, t1: &Points<f64>, t: &BigRational) -> BigRational {
    let x: [[BigRational; 3]; 4] = std::array::from_fn(|i| {
        std::array::from_fn(|k| {
            let (p, q) = (exact(t0[i][k]), exact(t1[i][k]));
            let moved = (q - &p) * t;
            p + moved
        })
    });
    let apart = |det: &BigRational, _: &BigRational, _: &BigRational| det.is_positive();
    match patch {
        Patch::Triangle => point_triangle_squared(&x, apart),
        Patch::Parallelogram => segment_segment_squared(&x, apart),
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
