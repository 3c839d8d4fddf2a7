//! The Bernstein non-penetration filter with a rounding bound that any GPU or CPU keeps.
//!
//! `f(t) = a(t) . (b(t) x c(t))` is a cubic whose zeros are the only times at which the four points are coplanar, hence
//! the only times of contact. In Bernstein form its control values enclose it: all of one sign means no contact (Tang,
//! Manocha and Tong 2010; dissertation 2.3.2). Changed here: the triple products are summed per Bernstein index, so that
//! nothing is divided, and one bound covers every control value.
//!
//! # The bound
//! Let `A B C` bound the components of `a b c` over both times, `u` the unit roundoff, `e` the input error of a difference.
//! Three times each Bernstein value is a sum of at most 18 products of three components (`6 x 3`). A product passes at
//! most 2 multiplications and 17 additions in whatever order a compiler picks, contracted or not, and its factors carry
//! an error of `2 u` times their bound each (one rounding for a difference, another where a step was halved) and the absolute error `e`:
//!
//! `error <= 18 (20 u + 6 u) A B C + 18 e (A B + B C + C A)`, up to terms of second order, which the constants below absorb
//! (`490` for `468`, `19` for `18`). A result that underflows and is flushed loses at most the smallest normal number times
//! the factors still to come, which `256 MIN_NORMAL (1 + A)(1 + B)(1 + C)` covers. If anything overflows, so does `64 A B C`, which is
//! part of the bound, and the filter answers "unknown".

use crate::math::real::Num;
use crate::math::vec3::{add, cross, dot, sum_abs};
use crate::narrow_phase::relative_motion::Motion;

/// The cubic of coplanarity, `c[0] s^3 + c[1] s^2 t + c[2] s t^2 + c[3] t^3` with `s = 1 - t`.
///
/// `3 c[0], c[1], c[2], 3 c[3]` are three times its Bernstein control values.
#[derive(Clone, Copy, Debug)]
pub struct Coplanarity<N> {
    /// Coefficients in the scaled Bernstein basis above.
    pub c: [N; 4],
    /// Bound of the error of `3 c[0]`, `c[1]`, `c[2]`, `3 c[3]`, hence of `3 f(t)` at every `t`.
    pub bound: N,
    /// Upper bound of `|b(t) x c(t)|` over the step: turns `f` into a distance to the plane (or between the lines).
    pub normal: N,
}

impl<N: Num> Coplanarity<N> {
    /// The cubic of a motion: 4 vector products, 6 scalar ones.
    #[inline(always)]
    pub fn new(m: &Motion<N>) -> Self {
        let n00 = cross(m.b[0], m.c[0]);
        let n11 = cross(m.b[1], m.c[1]);
        let n01 = add(cross(m.b[0], m.c[1]), cross(m.b[1], m.c[0]));
        let c = [dot(m.a[0], n00), dot(m.a[1], n00) + dot(m.a[0], n01), dot(m.a[0], n11) + dot(m.a[1], n01), dot(m.a[1], n11)];
        let [ma, mb, mc] = m.magnitudes();
        let (one, eight) = (N::splat(1.0), N::splat(8.0));
        let bc = (mb * eight) * mc;
        let abc = (ma * eight) * bc;
        let rounding = abc * (N::UNIT * N::splat(490.0 / 64.0));
        let input = m.error * N::splat(19.0) * (ma * (mb + mc) + mb * mc);
        let flushed = (N::MIN_NORMAL * N::splat(256.0)) * ((one + ma) * ((one + mb) * (one + mc)));
        let half = N::splat(0.5);
        let normal = sum_abs(n00).max(sum_abs(n11)).max(sum_abs(n01) * half)
            + bc * (N::UNIT * N::splat(4.0))
            + m.error * N::splat(6.0) * (mb + mc)
            + (N::MIN_NORMAL * N::splat(256.0)) * ((one + mb) * (one + mc));
        Self { c, bound: rounding + input + flushed, normal }
    }

    /// Positive only if the features certainly stay further than `min_distance >= 0` apart for all of `[0, 1]`; the size means
    /// nothing. NaN where a computation overflowed: so compare with `> 0`.
    #[inline(always)]
    pub fn clearance(&self, min_distance: N) -> N {
        let three = N::splat(3.0);
        let [c0, c1, c2, c3] = [self.c[0] * three, self.c[1], self.c[2], self.c[3] * three];
        let low = c0.min(c3).min(c1.min(c2));
        let high = c0.max(c3).max(c1.max(c2));
        // 1.0001: rounding of the product and of the sums.
        let needed = self.bound + min_distance * self.normal * N::splat(3.0 * 1.0001);
        low.max(-high) - needed
    }
}

/// Whether a vertex and a face certainly do not come within `min_distance` during the step; `false` says nothing.
///
/// `t0`, `t1`: `v f0 f1 f2` at the start and the end.
#[inline]
pub fn vertex_face_filter<R: crate::math::real::Real>(t0: &[[R; 3]; 4], t1: &[[R; 3]; 4], min_distance: R) -> bool {
    let m = Motion::vertex_face(t0, t1, R::splat(0.0));
    Coplanarity::new(&m).clearance(min_distance) > R::splat(0.0)
}

/// Whether two edges certainly do not come within `min_distance` during the step; `false` says nothing.
///
/// `t0`, `t1`: `ea0 ea1 eb0 eb1` at the start and the end.
#[inline]
pub fn edge_edge_filter<R: crate::math::real::Real>(t0: &[[R; 3]; 4], t1: &[[R; 3]; 4], min_distance: R) -> bool {
    let m = Motion::edge_edge(t0, t1, R::splat(0.0));
    Coplanarity::new(&m).clearance(min_distance) > R::splat(0.0)
}
