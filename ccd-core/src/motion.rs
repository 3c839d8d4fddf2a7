//! One form for both elemental tests: a vector `a` against the patch spanned by `b` and `c`, all moving linearly.
//!
//! | test | `a` | `b` | `c` | patch |
//! |---|---|---|---|---|
//! | vertex-face | `v - f0` | `f1 - f0` | `f2 - f0` | triangle: `s, r >= 0`, `s + r <= 1` |
//! | edge-edge | `eb0 - ea0` | `ea1 - ea0` | `eb0 - eb1` | parallelogram: `0 <= s, r <= 1` |
//!
//! There is contact at time `t` exactly when `a(t) = s b(t) + r c(t)` with `(s, r)` in the patch (Provot 1997). Taking
//! differences first recentres the query: each difference has relative error of one unit roundoff, however far from the
//! origin the query is.

use crate::real::{Num, Real};
use crate::vec3::{max_abs, sub};

/// The region of `(s, r)` in which the patch exists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Patch {
    /// Vertex-face: `s >= 0`, `r >= 0`, `s + r <= 1`.
    Triangle,
    /// Edge-edge: `0 <= s <= 1`, `0 <= r <= 1`.
    Parallelogram,
}

/// A query after recentring; index 0 is `t = 0`, index 1 is `t = 1`.
#[derive(Clone, Copy, Debug)]
pub struct Motion<N> {
    /// The vector that must reach the patch.
    pub a: [[N; 3]; 2],
    /// First side of the patch.
    pub b: [[N; 3]; 2],
    /// Second side of the patch.
    pub c: [[N; 3]; 2],
    /// Absolute error of each difference that comes with the input (0 where coordinates are exact).
    pub error: N,
}

impl<N: Num> Motion<N> {
    /// From `v f0 f1 f2` at both times. `coordinate_error`: how far each coordinate may be from the true one.
    #[inline(always)]
    pub fn vertex_face(t0: &[[N; 3]; 4], t1: &[[N; 3]; 4], coordinate_error: N) -> Self {
        let of = |x: &[[N; 3]; 4]| [sub(x[0], x[1]), sub(x[2], x[1]), sub(x[3], x[1])];
        Self::from_differences(of(t0), of(t1), coordinate_error)
    }

    /// From `ea0 ea1 eb0 eb1` at both times. `coordinate_error`: how far each coordinate may be from the true one.
    #[inline(always)]
    pub fn edge_edge(t0: &[[N; 3]; 4], t1: &[[N; 3]; 4], coordinate_error: N) -> Self {
        let of = |x: &[[N; 3]; 4]| [sub(x[2], x[0]), sub(x[1], x[0]), sub(x[2], x[3])];
        Self::from_differences(of(t0), of(t1), coordinate_error)
    }

    #[inline(always)]
    fn from_differences(d0: [[N; 3]; 3], d1: [[N; 3]; 3], coordinate_error: N) -> Self {
        let error = coordinate_error + coordinate_error;
        Self { a: [d0[0], d1[0]], b: [d0[1], d1[1]], c: [d0[2], d1[2]], error }
    }

    /// Bounds of the absolute components of `a`, `b`, `c` over the whole step, input error included.
    #[inline(always)]
    pub fn magnitudes(&self) -> [N; 3] {
        let of = |x: &[[N; 3]; 2]| max_abs(x[0]).max(max_abs(x[1])) + self.error;
        [of(&self.a), of(&self.b), of(&self.c)]
    }
}

impl<R: Real> Motion<R> {
    /// The corners of the patch seen from the origin of `a`: `a`, `a - b`, `a - c` and, for a parallelogram,
    /// `a - b - c`. The features touch exactly when the hull of these points contains the origin.
    #[inline]
    pub fn corners(&self, patch: Patch, time: usize) -> ([[R; 3]; 4], usize) {
        let (a, b, c) = (self.a[time], self.b[time], self.c[time]);
        let ab = sub(a, b);
        let n = if matches!(patch, Patch::Triangle) { 3 } else { 4 };
        ([a, ab, sub(a, c), sub(ab, c)], n)
    }
}
