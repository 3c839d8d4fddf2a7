//! One form for both elemental tests: a vector `a` against the patch spanned by `b` and `c`, all
//! moving linearly.
//!
//! | test | `a` | `b` | `c` | patch |
//! |---|---|---|---|---|
//! | vertex-face | `v - f0` | `f1 - f0` | `f2 - f0` | triangle: `s, r >= 0`, `s + r <= 1` |
//! | edge-edge | `eb0 - ea0` | `ea1 - ea0` | `eb0 - eb1` | parallelogram: `0 <= s, r <= 1` |
//!
//! There is contact at time `t` exactly when `a(t) = s b(t) + r c(t)` with `(s, r)` in the patch
//! [Provot 1997]. Taking differences first recentres the query: each difference has relative error
//! of one unit roundoff, however far from the origin the query is.

use crate::math::real::{Num, Real};
use crate::math::vec3::{lerp, max_abs, scale, sub};

/// The region of `(s, r)` in which the patch exists.
///
/// ```
/// use ccd::geometry::{Patch, closest};
///
/// // The point (1, 1) is a corner of the parallelogram and beside the triangle.
/// let (a, b, c) = ([1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0f64]);
/// assert_eq!(closest(a, b, c, Patch::Parallelogram), [0.0; 3]);
/// assert_eq!(closest(a, b, c, Patch::Triangle), [0.5, 0.5, 0.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Patch {
    /// Vertex-face: `s >= 0`, `r >= 0`, `s + r <= 1`.
    Triangle,
    /// Edge-edge: `0 <= s <= 1`, `0 <= r <= 1`.
    Parallelogram,
}

/// A query after recentring; index 0 is `t = 0`, index 1 is `t = 1`.
///
/// ```
/// use ccd::geometry::Motion;
///
/// // `v f0 f1 f2`, far from the origin: differences are small.
/// let t0 = [[9.0, 1.0, 0.0], [9.0, 0.0, 0.0], [10.0, 0.0, 0.0], [9.0, 0.0, 1.0f64]];
/// let motion = Motion::vertex_face(&t0, &t0, 0.0);
/// assert_eq!((motion.a[0], motion.b[0]), ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0]));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Motion<N> {
    /// The vector that must reach the patch.
    pub a: [[N; 3]; 2],
    /// First side of the patch.
    pub b: [[N; 3]; 2],
    /// Second side of the patch.
    pub c: [[N; 3]; 2],
    /// Absolute error of each difference that comes with the input (0 where coordinates are exact),
    /// and with a change of the unit.
    pub error: N,
}

impl<N: Num> Motion<N> {
    /// From the four points of a query over `patch`, at both times. `coordinate_error`: how far
    /// each coordinate may be from the true one.
    #[inline(always)]
    pub fn new(patch: Patch, t0: &[[N; 3]; 4], t1: &[[N; 3]; 4], coordinate_error: N) -> Self {
        match patch {
            Patch::Triangle => Self::vertex_face(t0, t1, coordinate_error),
            Patch::Parallelogram => Self::edge_edge(t0, t1, coordinate_error),
        }
    }

    /// From `v f0 f1 f2` at both times. `coordinate_error`: how far each coordinate may be from the
    /// true one.
    #[inline(always)]
    pub fn vertex_face(t0: &[[N; 3]; 4], t1: &[[N; 3]; 4], coordinate_error: N) -> Self {
        Self {
            a: [sub(t0[0], t0[1]), sub(t1[0], t1[1])],
            b: [sub(t0[2], t0[1]), sub(t1[2], t1[1])],
            c: [sub(t0[3], t0[1]), sub(t1[3], t1[1])],
            error: coordinate_error + coordinate_error,
        }
    }

    /// From `ea0 ea1 eb0 eb1` at both times. `coordinate_error`: how far each coordinate may be
    /// from the true one.
    #[inline(always)]
    pub fn edge_edge(t0: &[[N; 3]; 4], t1: &[[N; 3]; 4], coordinate_error: N) -> Self {
        Self {
            a: [sub(t0[2], t0[0]), sub(t1[2], t1[0])],
            b: [sub(t0[1], t0[0]), sub(t1[1], t1[0])],
            c: [sub(t0[2], t0[3]), sub(t1[2], t1[3])],
            error: coordinate_error + coordinate_error,
        }
    }

    /// The motion from time `lo` to time `hi`, as a step of its own.
    ///
    /// Of the greatest component `M` of all vectors at both ends: a vector at a time in between is
    /// off by `2 u M` each from a difference and from a product with it that is rounded, `u M` from
    /// a sum, and `u M` from the differences of points: `6 u M`, where the code has `8 u M`.
    /// Flushing: at most 8 times the smallest normal number, for operands and results.
    #[inline(always)]
    pub fn part(&self, lo: N, hi: N) -> Self {
        let [a, b, c] = self.magnitudes();
        let rounding = a.max(b).max(c) * (N::UNIT * N::splat(8.0));
        Self {
            a: [lerp(self.a[0], self.a[1], lo), lerp(self.a[0], self.a[1], hi)],
            b: [lerp(self.b[0], self.b[1], lo), lerp(self.b[0], self.b[1], hi)],
            c: [lerp(self.c[0], self.c[1], lo), lerp(self.c[0], self.c[1], hi)],
            error: self.error + rounding + N::MIN_NORMAL * N::splat(8.0),
        }
    }

    /// The error of a difference in the unit of the input: that of the input, and what a device
    /// flushes, less than the smallest normal number for either operand and for the result.
    ///
    /// Bounds have terms for what is flushed in the unit in which they stand; whoever takes
    /// differences to another unit takes this along.
    #[inline(always)]
    pub fn difference_error(&self) -> N {
        self.error + N::MIN_NORMAL * N::splat(8.0)
    }

    /// The same in another unit of length; exact for a power of two, unless a component vanishes.
    #[inline(always)]
    pub fn scaled(&self, unit: N) -> Self {
        let both = |x: &[[N; 3]; 2]| [scale(x[0], unit), scale(x[1], unit)];
        let error = self.difference_error() * unit;
        Self { a: both(&self.a), b: both(&self.b), c: both(&self.c), error }
    }

    /// Bounds of the absolute components of `a`, `b`, `c` over the whole step, input error
    /// included.
    #[inline(always)]
    pub fn magnitudes(&self) -> [N; 3] {
        [
            max_abs(self.a[0]).max(max_abs(self.a[1])) + self.error,
            max_abs(self.b[0]).max(max_abs(self.b[1])) + self.error,
            max_abs(self.c[0]).max(max_abs(self.c[1])) + self.error,
        ]
    }
}

impl<N: Num> Motion<N> {
    /// The corners of the patch seen from the origin of `a`: `a`, `a - b`, `a - c` and, for a
    /// parallelogram, `a - b - c` (for a triangle `a` again). The features touch exactly when the
    /// hull of these points contains the origin.
    #[inline(always)]
    pub fn corners(&self, patch: Patch, time: usize) -> [[N; 3]; 4] {
        let (a, b, c) = (self.a[time], self.b[time], self.c[time]);
        let ab = sub(a, b);
        let last = if matches!(patch, Patch::Triangle) { a } else { sub(ab, c) };
        [a, ab, sub(a, c), last]
    }

    /// Bound of the error of a component of any corner, and of its scalar product with a vector per
    /// unit of that vector's components (their absolute sum).
    ///
    /// Of `S = A + B + C`: at most `u S` from the differences, `2 u S` from two subtractions, `3 u
    /// S` from a multiplication and two additions: `6 u S`, where the code has `16 u S`. `3 e` from
    /// the input. Flushing: 5 times the smallest normal number a difference, 2 for the
    /// subtractions, 5 for products and sums with a vector whose components add up to 1: below
    /// `256`.
    #[inline(always)]
    pub fn corner_error(&self) -> N {
        let [a, b, c] = self.magnitudes();
        (a + b + c) * (N::UNIT * N::splat(16.0))
            + self.error * N::splat(3.0)
            + (N::MIN_NORMAL * N::splat(256.0))
    }
}

/// Vectors whose greatest component is within this factor of 1, 2^16, need no other unit: fourth
/// powers and their inverses stay inside `f32`.
const UNIT_RANGE: f32 = 65_536.0;

impl<R: Real> Motion<R> {
    /// Whether the vectors need no other unit of length: see [`in_unit`].
    #[inline(always)]
    pub fn has_fine_unit(&self) -> bool {
        let size = self.greatest();
        size <= R::splat(UNIT_RANGE) && size >= R::splat(1.0 / UNIT_RANGE)
    }

    #[inline(always)]
    fn greatest(&self) -> R {
        let [a, b, c] = self.magnitudes();
        a.max(b).max(c)
    }
}

/// A query in a unit of length in which its vectors are neither huge nor tiny: times do not depend
/// on the unit, products do.
///
/// Scaling by a power of two is exact, but for components so much smaller than the greatest that
/// they vanish, which is what every bound allows for where results are flushed to zero. What was
/// flushed before, in the unit of the input, becomes an error of the input ([`Motion::scaled`]). A
/// distance that vanishes becomes the smallest normal number; that is more, and too little for a
/// certain contact.
#[inline(always)]
pub fn in_unit<R: Real>(m: &Motion<R>, min_distance: R) -> (Motion<R>, R) {
    let size = m.greatest();
    if m.has_fine_unit() || !(size >= R::MIN_NORMAL) || !size.is_finite_number() {
        return (*m, min_distance);
    }
    let unit = size.to_unit();
    let scaled = min_distance * unit;
    let distance = if min_distance > R::splat(0.0) { scaled.max(R::MIN_NORMAL) } else { scaled };
    (m.scaled(unit), distance)
}
