//! Motions in adversarial arithmetic, beside the true ones of the same points.

use super::adversary::Adversarial;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};

pub type V = [f64; 3];

pub fn minus(a: V, b: V) -> V {
    std::array::from_fn(|k| a[k] - b[k])
}

pub fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn scalar(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn at(x: &[V; 2], t: f64) -> V {
    std::array::from_fn(|k| x[0][k] * (1.0 - t) + x[1][k] * t)
}

pub fn wrap(x: V) -> [Adversarial; 3] {
    x.map(Adversarial)
}

/// Points from 24 inputs; true ones, off by up to `error`, from 24 more. The motion in adversarial
/// arithmetic, and the true `a b c`.
pub fn motion(
    x: &[f64],
    patch: Patch,
    size: f64,
    error: f64,
) -> (Motion<Adversarial>, [[V; 2]; 3]) {
    let point = |t: usize, i: usize| -> V { std::array::from_fn(|k| size * x[12 * t + 3 * i + k]) };
    let off = |t: usize, i: usize| -> V {
        std::array::from_fn(|k| {
            point(t, i)[k] + error * x.get(24 + 12 * t + 3 * i + k).unwrap_or(&0.0)
        })
    };
    let given = |t: usize| std::array::from_fn(|i| wrap(point(t, i)));
    let (t0, t1) = (given(0), given(1));
    let e = Adversarial(error);
    let difference =
        |i: usize, j: usize| [minus(off(0, i), off(0, j)), minus(off(1, i), off(1, j))];
    match patch {
        Patch::Triangle => (
            Motion::vertex_face(&t0, &t1, e),
            [difference(0, 1), difference(2, 1), difference(3, 1)],
        ),
        Patch::Parallelogram => {
            (Motion::edge_edge(&t0, &t1, e), [difference(2, 0), difference(1, 0), difference(2, 3)])
        }
    }
}
