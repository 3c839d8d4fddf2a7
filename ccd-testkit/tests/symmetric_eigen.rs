//! Eigenvalues and eigenvectors of symmetric 3x3 matrices, to the accuracy that
//! `ccd_core::math::symmetric_eigen` states.

use ccd_core::Real;
use ccd_core::math::symmetric_eigen::{Eigen, ORTHONORMAL, symmetric_eigen};
use ccd_testkit::generate::Random;

/// A random number in [-1, 1).
fn number(random: &mut Random) -> f64 {
    2.0 * random.unit() - 1.0
}

fn vector(random: &mut Random) -> [f64; 3] {
    [(); 3].map(|()| number(random))
}

type Matrix = [[f64; 3]; 3];

/// `sum value v v^T`, symmetric to the last bit.
fn compose(terms: &[(f64, [f64; 3])]) -> Matrix {
    let entry = |i: usize, j: usize| terms.iter().map(|(x, v)| x * (v[i] * v[j])).sum::<f64>();
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i.min(j), i.max(j))))
}

/// Orthonormal up to rounding.
fn frame(random: &mut Random) -> Matrix {
    let unit = |v: [f64; 3]| {
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    };
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let a = unit(vector(random));
    let b = unit(cross(a, vector(random)));
    [a, b, cross(a, b)]
}

/// What was found of one matrix: how far `M v` is from `value v` in units of roundoff of its norm,
/// all vectors together, and scalar products from those of a basis.
///
/// Eigenvalues of `M` are no further from those found: with an orthonormal basis `V` they are those
/// of `M - R V^T`, where `R` has the columns `M v - value v`, and no eigenvalue of a symmetric
/// matrix moves by more than the norm of what is added (Weyl).
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    residual: f64,
    basis: f64,
}

fn errors<T: Real>(m: &Matrix, out: &Eigen<T>) -> Errors {
    // By a power of two, so that nothing overflows or vanishes here.
    let greatest = m.iter().flatten().fold(0f64, |a, x| a.max(x.abs()));
    let scale = if greatest > 0.0 { Real::to_unit(greatest) } else { 1.0 };
    let m = m.map(|row| row.map(|x| x * scale));
    let values = out.values.map(|x| x.to_f64() * scale);
    let norm = values.iter().fold(0f64, |a, x| a.max(x.abs()));
    let v = out.vectors.map(|v| v.map(|x| x.to_f64()));
    let unit = T::UNIT.to_f64();
    let mut errors = Errors::default();
    for i in 0..3 {
        let off = |k: usize| (0..3).map(|j| m[k][j] * v[i][j]).sum::<f64>() - values[i] * v[i][k];
        errors.residual += (0..3).map(|k| off(k) * off(k)).sum::<f64>();
        for j in 0..3 {
            let dot = (0..3).map(|k| v[i][k] * v[j][k]).sum::<f64>();
            errors.basis = errors.basis.max((dot - (i == j) as u8 as f64).abs() / unit);
        }
    }
    let in_units = |x: f64| if x == 0.0 { 0.0 } else { x / (unit * norm) };
    Errors { residual: in_units(errors.residual.sqrt()), ..errors }
}

/// Matrices of a kind, brought to a scale; the greatest errors.
fn check<T: Real>(name: &str, scale: f64, mut matrix: impl FnMut(&mut Random) -> Matrix) {
    let mut random = Random::new(1);
    let mut worst = Errors::default();
    for _ in 0..500 {
        // As the type holds it, which is what both are asked about.
        let m = matrix(&mut random).map(|row| row.map(|x| T::from_f64(x * scale)));
        let exact = m.map(|row| row.map(|x| x.to_f64()));
        let out = symmetric_eigen(&m);
        let e = errors(&exact, &out);
        let bound = ORTHONORMAL as f64 + 0.01;
        let holds = e.residual <= 32.0 && e.basis <= bound;
        assert!(holds, "{name} at {scale:e}: {e:?} of {exact:?}: {out:?}");
        worst.residual = worst.residual.max(e.residual);
        worst.basis = worst.basis.max(e.basis);
    }
    println!("{name} at {scale:e}: {worst:?}");
}

fn check_all<T: Real>(scales: &[f64]) {
    for &scale in scales {
        check::<T>("random", scale, |r| {
            let (a, b, c) = (vector(r), vector(r), vector(r));
            compose(&[(number(r), a), (number(r), b), (number(r), c)])
        });
        check::<T>("zero", scale, |_| [[0.0; 3]; 3]);
        check::<T>("rank 1", scale, |r| compose(&[(number(r), vector(r))]));
        check::<T>("rank 2", scale, |r| {
            let (a, b) = (vector(r), vector(r));
            compose(&[(number(r), a), (number(r), b)])
        });
        check::<T>("two equal", scale, |r| {
            let ([a, b, c], x, y) = (frame(r), number(r), number(r));
            compose(&[(x, a), (x, b), (y, c)])
        });
        check::<T>("three equal", scale, |r| {
            let ([a, b, c], x) = (frame(r), number(r));
            compose(&[(x, a), (x, b), (x, c)])
        });
        check::<T>("graded", scale, |r| {
            let [a, b, c] = frame(r);
            compose(&[(1.0, a), (1e-5 * number(r), b), (1e-10 * number(r), c)])
        });
        check::<T>("nearly diagonal", scale, |r| {
            let v = vector(r);
            let mut m = compose(&[(1e-8, vector(r))]);
            (0..3).for_each(|i| m[i][i] += v[i]);
            m
        });
        check::<T>("few entries", scale, |r| {
            // Of -1, 0 and 1: zeros and equal entries in every place.
            let mut entry = || (number(r) * 1.5).round();
            let [a, b, c, f, g, h] = std::array::from_fn(|_| entry());
            [[a, b, c], [b, f, g], [c, g, h]]
        });
    }
}

#[test]
fn values_and_vectors_are_those_of_the_matrix() {
    check_all::<f64>(&[1.0, 1e150, 1e-150, 1e300, 1e-300]);
    check_all::<f32>(&[1.0, 1e18, 1e-18, 1e37, 1e-33]);
}

#[test]
fn a_wrong_vector_is_noticed() {
    let m = compose(&[(1.0, [1.0, 2.0, 3.0]), (-2.0, [0.0, 1.0, -1.0])]);
    let mut out = symmetric_eigen(&m);
    assert!(errors(&m, &out).residual < 32.0);
    out.values[2] += 1e-12;
    assert!(errors(&m, &out).residual > 100.0);
    out.vectors.swap(0, 1);
    assert!(errors(&m, &out).residual > 1e6);
}
