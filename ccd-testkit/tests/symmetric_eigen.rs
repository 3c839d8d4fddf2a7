//! Eigenvalues and eigenvectors of symmetric 3x3 matrices, to the accuracy that
//! `ccd_core::math::symmetric_eigen` states: in exact integers it is counted how many eigenvalues
//! are above a number.

use ccd_core::Real;
use ccd_core::math::symmetric_eigen::{Eigen, ORTHONORMAL, symmetric_eigen};
use num_bigint::BigInt;
use num_traits::Signed;

/// Random numbers in [-1, 1), the same on every machine.
struct Random(u32);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let x = ((self.0 >> ((self.0 >> 28) + 4)) ^ self.0).wrapping_mul(277_803_737);
        ((x >> 22) ^ x) as f64 / 2_147_483_648.0 - 1.0
    }

    fn vector(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.number())
    }
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
    let a = unit(random.vector());
    let b = unit(cross(a, random.vector()));
    [a, b, cross(a, b)]
}

/// A number times two to the 1074: an integer.
fn integer(x: f64) -> BigInt {
    let (exponent, fraction) = ((x.to_bits() >> 52) & 0x7ff, x.to_bits() & ((1 << 52) - 1));
    let leading = if exponent > 0 { 1u64 << 52 } else { 0 };
    BigInt::from(fraction | leading) * (x.signum() as i64) << exponent.saturating_sub(1)
}

/// How many eigenvalues are greater than a number. Those of `m - x` are the roots of
/// `t^3 - e1 t^2 + e2 t - e3`, all of them real, so that as many are positive as coefficients
/// change their signs (Descartes).
fn n_above(m: &Matrix, x: f64) -> usize {
    let a: [[BigInt; 3]; 3] = std::array::from_fn(|i| {
        std::array::from_fn(|j| integer(m[i][j]) - if i == j { integer(x) } else { 0.into() })
    });
    let minor = |i: usize, j: usize, k: usize| &a[i][i] * &a[j][k] - &a[i][j] * &a[i][k];
    let e1 = &a[0][0] + &a[1][1] + &a[2][2];
    let e2 = minor(0, 1, 1) + minor(0, 2, 2) + minor(1, 2, 2);
    let cofactor = |j: usize, k: usize| &a[1][j] * &a[2][k] - &a[1][k] * &a[2][j];
    let e3 = &a[0][0] * cofactor(1, 2) - &a[0][1] * cofactor(0, 2) + &a[0][2] * cofactor(0, 1);
    let mut signs = vec![1.into(), -e1.signum(), e2.signum(), -e3.signum()];
    signs.retain(|sign: &BigInt| *sign != 0.into());
    signs.windows(2).filter(|two| two[0] != two[1]).count()
}

/// The least power of two, as far as it matters, by which units of roundoff no value is wrong.
fn value_error(m: &Matrix, values: [f64; 3], unit: f64) -> f64 {
    let is_within = |error: f64| {
        (0..3).all(|i| {
            let (low, high) = (values[i] - error, values[i] + error);
            // Sorted: two are below the greatest.
            n_above(m, low.next_down()) >= 3 - i && n_above(m, high) <= 2 - i
        })
    };
    let powers = (0..40).map(|k| 2f64.powi(k));
    if is_within(0.0) { 0.0 } else { powers.into_iter().find(|p| is_within(p * unit)).unwrap() }
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
    let mut got = out.values.map(|x| x.to_f64() * scale);
    let norm = got.iter().fold(0f64, |a, x| a.max(x.abs()));
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
    errors.value = value_error(&m, got, unit * norm);
    errors
}

/// Matrices of a kind, brought to a scale; the greatest errors.
fn check<T: Real>(name: &str, scale: f64, mut matrix: impl FnMut(&mut Random) -> Matrix) {
    let mut random = Random(1);
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
            let (a, b, c) = (r.vector(), r.vector(), r.vector());
            compose(&[(r.number(), a), (r.number(), b), (r.number(), c)])
        });
        check::<T>("zero", scale, |_| [[0.0; 3]; 3]);
        check::<T>("rank 1", scale, |r| compose(&[(r.number(), r.vector())]));
        check::<T>("rank 2", scale, |r| {
            let (a, b) = (r.vector(), r.vector());
            compose(&[(r.number(), a), (r.number(), b)])
        });
        check::<T>("two equal", scale, |r| {
            let ([a, b, c], x, y) = (frame(r), r.number(), r.number());
            compose(&[(x, a), (x, b), (y, c)])
        });
        check::<T>("three equal", scale, |r| {
            let ([a, b, c], x) = (frame(r), r.number());
            compose(&[(x, a), (x, b), (x, c)])
        });
        check::<T>("graded", scale, |r| {
            let [a, b, c] = frame(r);
            compose(&[(1.0, a), (1e-5 * r.number(), b), (1e-10 * r.number(), c)])
        });
        check::<T>("nearly diagonal", scale, |r| {
            let v = r.vector();
            let mut m = compose(&[(1e-8, r.vector())]);
            (0..3).for_each(|i| m[i][i] += v[i]);
            m
        });
        check::<T>("few entries", scale, |r| {
            // Of -1, 0 and 1: zeros and equal entries in every place.
            let mut entry = || (r.number() * 1.5).round();
            let [a, b, c, f, g, h] = std::array::from_fn(|_| entry());
            [[a, b, c], [b, f, g], [c, g, h]]
        });
    }
}

#[test]
fn values_and_vectors_are_as_accurate_as_stated() {
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
    assert_eq!(
        [-7.0, -1.0, 3.0, 14.0].map(|x| n_above(&compose(&[(1.0, [1.0, 2.0, 3.0])]), x)),
        [3, 3, 1, 0]
    );
}
