//! Eigenvalues and eigenvectors of symmetric 3x3 matrices against those of faer, to the accuracy
//! that `ccd_core::math::symmetric_eigen` states.

use ccd_core::Real;
use ccd_core::math::symmetric_eigen::{Eigen, ORTHONORMAL, symmetric_eigen};
use ccd_testkit::generate::Random;
use faer::{Mat, Side};

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

/// What was found of one matrix, in units of roundoff of its norm.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    value: f64,
    vector: f64,
    basis: f64,
}

fn errors<T: Real>(m: &Matrix, out: &Eigen<T>) -> Errors {
    // By a power of two, so that nothing overflows or vanishes here.
    let greatest = m.iter().flatten().fold(0f64, |a, x| a.max(x.abs()));
    let scale = if greatest > 0.0 { Real::to_unit(greatest) } else { 1.0 };
    let m = m.map(|row| row.map(|x| x * scale));
    let reference = Mat::from_fn(3, 3, |i, j| m[i][j]).self_adjoint_eigen(Side::Lower).unwrap();
    let mut want: [f64; 3] = std::array::from_fn(|i| reference.S()[i]);
    let norm = want.iter().fold(0f64, |a, x| a.max(x.abs()));
    let mut got = out.values.map(|x| x.to_f64() * scale);
    let v = out.vectors.map(|v| v.map(|x| x.to_f64()));
    let unit = T::UNIT.to_f64();
    let in_units = |x: f64| if x == 0.0 { 0.0 } else { x / (unit * norm) };
    let mut errors = Errors::default();
    for i in 0..3 {
        let residual = |k: usize| (0..3).map(|j| m[k][j] * v[i][j]).sum::<f64>() - got[i] * v[i][k];
        let length = (0..3).map(|k| residual(k) * residual(k)).sum::<f64>().sqrt();
        errors.vector = errors.vector.max(in_units(length));
        for j in 0..3 {
            let dot = (0..3).map(|k| v[i][k] * v[j][k]).sum::<f64>();
            errors.basis = errors.basis.max((dot - (i == j) as u8 as f64).abs() / unit);
        }
    }
    got.sort_unstable_by(f64::total_cmp);
    want.sort_unstable_by(f64::total_cmp);
    for (got, want) in got.iter().zip(want) {
        errors.value = errors.value.max(in_units((got - want).abs()));
    }
    errors
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
        let holds = e.value <= 32.0 && e.vector <= 32.0 && e.basis <= bound;
        assert!(holds, "{name} at {scale:e}: {e:?} of {exact:?}: {out:?}");
        worst.value = worst.value.max(e.value);
        worst.vector = worst.vector.max(e.vector);
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
fn values_and_vectors_are_those_of_faer() {
    check_all::<f64>(&[1.0, 1e150, 1e-150, 1e300, 1e-300]);
    check_all::<f32>(&[1.0, 1e18, 1e-18, 1e37, 1e-33]);
}

#[test]
fn a_wrong_vector_is_noticed() {
    let m = compose(&[(1.0, [1.0, 2.0, 3.0]), (-2.0, [0.0, 1.0, -1.0])]);
    let mut out = symmetric_eigen(&m);
    assert!(errors(&m, &out).vector < 32.0);
    out.vectors.swap(0, 1);
    assert!(errors(&m, &out).vector > 1e6);
    out.values[2] += 1e-12;
    assert!(errors(&m, &out).value > 100.0);
}
