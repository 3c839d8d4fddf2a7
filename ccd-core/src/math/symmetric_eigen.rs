//! Eigenvalues and eigenvectors of a symmetric 3x3 matrix: a Householder reflection makes it
//! tridiagonal, implicit QL steps make it diagonal [Press 2007].
//!
//! ```text
//!   a b c   reflect   d e .   a step: a rotation   d e .          d . .
//!   b f g  -------->  e d e  ------------------->  e d .  -----> . d .
//!   c g h   y and z   . e d  below, one that       . . d          . . d
//!                            moves what it spoils
//!                            off the matrix
//! ```
//!
//! Of three rows one reflection is enough. A step is one of QL with Wilkinson's shift, never
//! formed: its first rotation, of the last two axes, is that of the shifted matrix, and the second,
//! of the first two, takes away the entry that the first has put into the corner. It brings the
//! entry nearest the top to zero, with the third power of its size; where an entry vanishes, a
//! rotation of the other two axes is left.
//!
//! Cost: about 60 operations a step, mostly three to five steps. For the axes of oriented boxes,
//! where a basis must come out whatever goes in. Changed from the source: entries are negligible
//! beside the whole matrix, not beside their neighbours, so that a scaled matrix needs no other
//! care; and the basis is made orthonormal once more at the end, checked, and replaced by the axes
//! of the coordinates if it is not.
//!
//! # Accuracy
//! With `u` the unit roundoff and `|m|` the greatest absolute eigenvalue: every value is within
//! `32 u |m|` of one of the matrix, `m v - value v` is no longer than `32 u |m|`, and scalar
//! products of vectors are within [`ORTHONORMAL`] of 1 and 0. The last holds for any input
//! whatever, because it is checked; the others are measured
//! (`ccd-testkit/tests/symmetric_eigen.rs`), where the matrix is finite and its largest entry is
//! normal.

use crate::math::real::{Num, Real};
use crate::math::vec3::{add, dot, max_abs, scale, sub};

/// Most steps; random matrices take up to six. Fewer than a matrix needs leave a basis that is
/// orthonormal and not of its eigenvectors.
pub const MAX_STEPS: u32 = 16;

/// Units of roundoff by which scalar products of the vectors may differ from 1 and 0, in exact
/// arithmetic: 10 as computed, of which 3 roundings may be wrong, each of numbers that sum to at
/// most 1, and one of each vector, should a compiler check it before it is rounded.
pub const ORTHONORMAL: f32 = 16.0;

/// The axes of the coordinates.
#[inline(always)]
pub fn identity<T: Num>() -> [[T; 3]; 3] {
    let (zero, one) = (T::splat(0.0), T::splat(1.0));
    [[one, zero, zero], [zero, one, zero], [zero, zero, one]]
}

/// What [`symmetric_eigen`] finds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eigen<T> {
    /// The eigenvalues, in no particular order.
    pub values: [T; 3],
    /// A unit vector for each; right-handed or left-handed. No component is smaller than the square
    /// of the unit roundoff, except zeros.
    pub vectors: [[T; 3]; 3],
}

/// Eigenvalues and eigenvectors of a matrix, of which only the upper triangle is read.
#[inline]
pub fn symmetric_eigen<T: Real>(m: &[[T; 3]; 3]) -> Eigen<T> {
    let greatest = max_abs(m[0]).max(max_abs([m[1][1], m[1][2], m[2][2]]));
    if !(greatest > T::MIN_NORMAL && greatest.is_finite_number()) {
        return Eigen { values: [m[0][0], m[1][1], m[2][2]], vectors: identity() };
    }
    let unit = greatest.to_unit();
    let mut t =
        Tridiagonal::new(scale(m[0], unit), [m[1][1] * unit, m[1][2] * unit, m[2][2] * unit]);
    for _ in 0..MAX_STEPS {
        if !t.step() {
            break;
        }
    }
    Eigen { values: scale(t.diagonal, unit.to_unit()), vectors: orthonormal(t.basis) }
}

/// A matrix whose corner is zero, of entries of about 1, and the basis in which it is that.
struct Tridiagonal<T> {
    diagonal: [T; 3],
    beside: [T; 2],
    basis: [[T; 3]; 3],
}

impl<T: Real> Tridiagonal<T> {
    /// From the first row and the rest of the upper triangle.
    #[inline(always)]
    fn new([a, b, c]: [T; 3], [f, g, h]: [T; 3]) -> Self {
        // The reflection of (y, z) that brings (b, c) to y: symmetric, so its rows are its columns.
        let (y, z) = direction(b, c);
        let zero = T::splat(0.0);
        let mixed = y * z * g * T::splat(2.0);
        Self {
            diagonal: [a, y * y * f + mixed + z * z * h, z * z * f - mixed + y * y * h],
            beside: [y * b + z * c, y * z * (f - h) + (z * z - y * y) * g],
            basis: [[T::splat(1.0), zero, zero], [zero, y, z], [zero, z, -y]],
        }
    }

    /// One step; whether there was anything left to do.
    #[inline(always)]
    fn step(&mut self) -> bool {
        let negligible = T::UNIT * T::splat(0.5);
        let ([d0, d1, d2], [e0, e1]) = (self.diagonal, self.beside);
        let (upper, lower) = (e0.abs() > negligible, e1.abs() > negligible);
        if upper && lower {
            let (c, s) = direction(d2 - shift(d0, d1, e0), e1);
            self.turn_lower(c, s);
            self.beside[0] = c * e0;
            // Of the corner, which was zero, and the entry below it.
            let corner = s * e0;
            let (c, s) = direction(self.beside[1], corner);
            self.beside[1] = s * corner + c * self.beside[1];
            self.turn_upper(c, s);
        } else if upper {
            let (c, s) = direction(d1 - shift(d0, d1, e0), e0);
            self.turn_upper(c, s);
        } else if lower {
            let (c, s) = direction(d2 - shift(d1, d2, e1), e1);
            self.turn_lower(c, s);
        }
        upper || lower
    }

    /// Turns the first two axes, as far as the corner is not concerned.
    #[inline(always)]
    fn turn_upper(&mut self, c: T, s: T) {
        let ([d0, d1, d2], [v0, v1, v2]) = (self.diagonal, self.basis);
        let (p, q, e) = turned(d0, d1, self.beside[0], c, s);
        self.diagonal = [p, q, d2];
        self.beside[0] = e;
        self.basis = [sub(scale(v0, c), scale(v1, s)), add(scale(v0, s), scale(v1, c)), v2];
    }

    /// Turns the last two axes, as far as the corner is not concerned.
    #[inline(always)]
    fn turn_lower(&mut self, c: T, s: T) {
        let ([d0, d1, d2], [v0, v1, v2]) = (self.diagonal, self.basis);
        let (p, q, e) = turned(d1, d2, self.beside[1], c, s);
        self.diagonal = [d0, p, q];
        self.beside[1] = e;
        self.basis = [v0, sub(scale(v1, c), scale(v2, s)), add(scale(v1, s), scale(v2, c))];
    }
}

/// The entries `p e, e q` after their axes are turned, in the same order `p q e`.
#[inline(always)]
fn turned<T: Real>(p: T, q: T, e: T, c: T, s: T) -> (T, T, T) {
    let x = (p - q) * s + c * e * T::splat(2.0);
    (p - s * x, q + s * x, c * x - e)
}

/// Wilkinson's shift: the eigenvalue of `p e, e q` that is nearer to `p`; `e` is not negligible.
#[inline(always)]
fn shift<T: Real>(p: T, q: T, e: T) -> T {
    let g = (q - p) / (e * T::splat(2.0));
    let h = (g * g + T::splat(1.0)).sqrt_up();
    p - e / (if g > T::splat(0.0) { g + h } else { g - h })
}

/// The unit vector along `(x, y)`; `(1, 0)` where both are far below the roundoff of 1.
#[inline(always)]
fn direction<T: Real>(x: T, y: T) -> (T, T) {
    let squared = x * x + y * y;
    if !(squared > (T::UNIT * T::UNIT) * (T::UNIT * T::UNIT)) {
        return (T::splat(1.0), T::splat(0.0));
    }
    let length = squared.sqrt_up();
    let (c, s) = (x / length, y / length);
    // Quotients and roots are off by some units: one step towards length 1.
    let k = T::splat(1.5) - (c * c + s * s) * T::splat(0.5);
    (c * k, s * k)
}

/// A basis that nearly is orthonormal made so, by one step of Newton and Schulz towards the nearest
/// one: `v - (v v^T - 1) v / 2`; the axes of the coordinates if that has failed.
#[inline(always)]
fn orthonormal<T: Real>(v: [[T; 3]; 3]) -> [[T; 3]; 3] {
    let g = excess(&v);
    let out = [
        tidy(sub(v[0], half_of(&v, [g[0], g[3], g[4]]))),
        tidy(sub(v[1], half_of(&v, [g[3], g[1], g[5]]))),
        tidy(sub(v[2], half_of(&v, [g[4], g[5], g[2]]))),
    ];
    let g = excess(&out);
    let worst = max_abs([g[0], g[1], g[2]]).max(max_abs([g[3], g[4], g[5]]));
    // No component is NaN any more.
    if worst <= T::UNIT * T::splat(ORTHONORMAL - 6.0) { out } else { identity() }
}

/// Half of what so much of each of three vectors adds up to.
#[inline(always)]
fn half_of<T: Real>(v: &[[T; 3]; 3], part: [T; 3]) -> [T; 3] {
    let whole = add(add(scale(v[0], part[0]), scale(v[1], part[1])), scale(v[2], part[2]));
    scale(whole, T::splat(0.5))
}

/// By how much the scalar products `00 11 22 01 02 12` are more than they should be.
#[inline(always)]
fn excess<T: Real>(v: &[[T; 3]; 3]) -> [T; 6] {
    let one = T::splat(1.0);
    [
        dot(v[0], v[0]) - one,
        dot(v[1], v[1]) - one,
        dot(v[2], v[2]) - one,
        dot(v[0], v[1]),
        dot(v[0], v[2]),
        dot(v[1], v[2]),
    ]
}

/// Tiny components, and those that are NaN, become zero.
#[inline(always)]
fn tidy<T: Real>(v: [T; 3]) -> [T; 3] {
    [unless_tiny(v[0]), unless_tiny(v[1]), unless_tiny(v[2])]
}

#[inline(always)]
fn unless_tiny<T: Real>(x: T) -> T {
    if x.abs() > T::UNIT * T::UNIT { x } else { T::splat(0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Scalar products are as promised.
    fn check_basis<T: Real>(m: &[[T; 3]; 3]) -> Eigen<T> {
        let out = symmetric_eigen(m);
        let g = excess(&out.vectors.map(|v| v.map(|x| x.to_f64())));
        let bound = ORTHONORMAL as f64 * T::UNIT.to_f64() + 1e-15;
        assert!(g.iter().all(|x| x.abs() <= bound), "{m:?}: {out:?}");
        out
    }

    #[test]
    fn a_matrix_that_is_diagonal_keeps_its_axes() {
        let out = check_basis(&[[2.0f32, 0.0, 0.0], [0.0, -3.0, 0.0], [0.0, 0.0, 0.5]]);
        assert_eq!(out.values, [2.0, -3.0, 0.5]);
        assert!(out.vectors.iter().flatten().all(|x| [0.0, 1.0].contains(&x.abs())));
    }

    #[test]
    fn whatever_goes_in_a_basis_comes_out() {
        let strange = [f32::NAN, f32::INFINITY, f32::MAX, -f32::MAX, 1e-45, 1e-38, 0.0, 1.0, -2.0];
        let mut random = Random::new(7);
        for _ in 0..20_000 {
            let mut row = || [(); 3].map(|()| strange[random.below(9) as usize]);
            check_basis(&[row(), row(), row()]);
        }
    }

    #[test]
    fn few_steps_are_enough_and_fewer_leave_a_basis() {
        let mut random = Random::new(3);
        let mut most = 0;
        for i in 0..20_000 {
            let mut next = || {
                let entry = 2.0 * random.unit() as f32 - 1.0;
                // Every other matrix with many zeros and entries that are equal.
                if i % 2 == 0 { entry } else { (entry * 1.5) as i32 as f32 }
            };
            let mut t = Tridiagonal::new([next(), next(), next()], [next(), next(), next()]);
            let mut steps = 0;
            loop {
                // However many steps there were.
                let left = orthonormal(t.basis);
                let g = excess(&left);
                assert!(g.iter().all(|x| x.abs() <= f32::UNIT * ORTHONORMAL), "{left:?}");
                if !t.step() {
                    break;
                }
                steps += 1;
            }
            most = most.max(steps);
        }
        assert!((3..=MAX_STEPS / 2).contains(&most), "{most} steps");
    }

    #[test]
    fn what_is_not_nearly_orthonormal_is_replaced() {
        let bent = [[1.0f64, 0.0, 0.0], [0.1, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!(orthonormal(bent), identity());
        assert_eq!(orthonormal([[f32::NAN; 3]; 3]), identity());
        // Whatever is kept is as orthonormal as promised, with axes that a compiler may have
        // checked before they were rounded; up to where it is not kept any more.
        let (mut n_kept, mut worst) = (0, 0f64);
        for i in 0..4000 {
            let off = i as f32 * 1e-6;
            let out = orthonormal([[1.0, off, 0.0], [0.0, 1.0, 0.5 * off], [off, 0.0, 1.0]]);
            let g = excess(&out.map(|v| v.map(f64::from)));
            worst = g.iter().fold(worst, |worst, x| worst.max(x.abs()));
            n_kept += (out != identity()) as usize;
        }
        let worst = worst / f32::UNIT as f64;
        assert!(worst > 9.0 && worst <= ORTHONORMAL as f64 - 2.0, "{worst} u");
        assert!((500..3500).contains(&n_kept), "{n_kept} kept");
        // A little is mended.
        let off = [[1.0f64, 1e-8, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_ne!(orthonormal(off), identity());
    }
}
