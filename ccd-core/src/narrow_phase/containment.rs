//! Whether the features meet inside their extents while they are coplanar, decided for a whole
//! interval of time at once.
//!
//! Contact is `a = s b + r c`. Projected along the axis in which the patch's normal is greatest
//! this is a 2x2 system, and `s = S / D`, `r = R / D` with `D = b x c`, `S = a x c`, `R = b x a`
//! (2D cross products). Signs of `S`, `R`, `D - S - R` (triangle) or `D - S`, `D - R`
//! (parallelogram) relative to `D` that hold over the interval decide; a value within its error
//! decides nothing.
//!
//! # The bounds
//! Let `M` bound the components of a vector at both ends of the step, `u` be the unit roundoff, `e`
//! the input error of a difference.
//!
//! *Time.* Half the width is rounded by `u / 2` at most (the interval is in `[0, 1]`), the middle
//! by `u`, and the sum with what covers this by `u / 2`: `2 u`, where the code adds `4 u`.
//!
//! *Ball.* The ends of the vector carry `u M + e`. The centre is `x0 + (x1 - x0) t`: `2 u M` for
//! the difference, `2 u M` for the product, `u M` for the sum. Together `6 u M + e`, where the code
//! adds `8 u M + e`. Over the interval it travels half the width times the difference; `1.01`
//! covers the roundings of these products. The size is at least every component of every vector in
//! the ball.
//!
//! *Products.* With radii `p r` and sizes `P R`, a product of components varies by at most
//! `p R + P r` over the balls, two of them by twice that: `2.01` with its roundings. A
//! multiplication and the subtraction of two products round by `4 u P R`, where the code adds
//! `8 u`. Flushing moves a component by at most 6 times the smallest normal number: two products
//! lose `12 (P + R) + 3`, below `256 (1 + P)(1 + R)`. A value is at most `2 P R`; where it
//! overflows, so does `4 P R`, which is part of the error.
//!
//! *Sums.* `D - S - R` adds the three errors, and two roundings of at most `u (|D| + |S| + |R|)`
//! each, where the code adds `4 u`.

use crate::math::real::Real;
use crate::math::vec3::{cross, lerp, max_abs, sub};
use crate::narrow_phase::relative_motion::{Motion, Patch};

/// What is certain about an interval of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Inside {
    /// At no time in the interval does the projected `a` lie in the projected patch: no contact
    /// there.
    Outside,
    /// At every time in the interval at which the features are coplanar, they touch.
    Inside,
    /// Neither could be certified.
    Unknown,
}

/// Where a vector is over an interval of time.
#[derive(Clone, Copy, Debug)]
pub struct Ball<R> {
    /// The vector at the middle of the interval, rounded.
    pub centre: [R; 3],
    /// How far a component of the true vector is from that of the centre, anywhere in the interval.
    pub radius: R,
    /// Bound of the absolute components of all of the ball.
    pub size: R,
}

impl<R: Real> Ball<R> {
    /// Of a vector that is `x` at the ends of the step, over `[middle - half, middle + half]`.
    pub fn new(x: &[[R; 3]; 2], middle: R, half: R, error: R) -> Self {
        let magnitude = max_abs(x[0]).max(max_abs(x[1])) + error;
        let centre = lerp(x[0], x[1], middle);
        let travel = max_abs(sub(x[1], x[0]));
        let radius = half * travel * R::splat(1.01) + magnitude * (R::UNIT * R::splat(8.0)) + error;
        Self { centre, radius, size: max_abs(centre) + radius }
    }
}

/// `p x q` in the plane of the first two axes, with a bound of its error over both balls (see
/// above; `2 x 2 x 2 u` is `8 u`).
#[inline]
pub fn cross2<R: Real>(p: &Ball<R>, q: &Ball<R>) -> (R, R) {
    let value = p.centre[0] * q.centre[1] - p.centre[1] * q.centre[0];
    let (one, two) = (R::splat(1.0), R::splat(2.0));
    let error = (p.radius * q.size + p.size * q.radius) * R::splat(2.01)
        + (p.size * two) * (q.size * two) * (R::UNIT * two)
        + (R::MIN_NORMAL * R::splat(256.0)) * ((one + p.size) * (one + q.size));
    (value, error)
}

/// The middle of an interval inside `[0, 1]` and half of its width, so much wider that all of it is
/// in between although both are rounded.
#[inline(always)]
pub fn around<R: Real>(lo: R, hi: R) -> (R, R) {
    let half = (hi - lo) * R::splat(0.5);
    (lo + half, half + (R::UNIT * R::splat(4.0)))
}

/// What is positive inside the patch and negative outside, each with a bound of its error, from
/// `D`, `S`, `R` with theirs, of a sign that makes `D` positive.
#[inline(always)]
pub fn conditions<R: Real>(
    patch: Patch,
    (d, d_error): (R, R),
    (s, s_error): (R, R),
    (r, r_error): (R, R),
) -> [(R, R); 4] {
    let rounding = (d.abs() + s.abs() + r.abs()) * (R::UNIT * R::splat(4.0));
    match patch {
        Patch::Triangle => {
            let rest = (d - s - r, d_error + s_error + r_error + rounding);
            [(s, s_error), (r, r_error), rest, rest]
        }
        Patch::Parallelogram => [
            (s, s_error),
            (r, r_error),
            (d - s, d_error + s_error + rounding),
            (d - r, d_error + r_error + rounding),
        ],
    }
}

/// Classifies the interval `[lo, hi]` inside `[0, 1]`.
pub fn inside<R: Real>(m: &Motion<R>, patch: Patch, lo: R, hi: R) -> Inside {
    let (middle, half) = around(lo, hi);
    let a = Ball::new(&m.a, middle, half, m.error);
    let b = Ball::new(&m.b, middle, half, m.error);
    let c = Ball::new(&m.c, middle, half, m.error);
    let n = cross(b.centre, c.centre);
    let by_x = n[0].abs() > n[1].abs() && n[0].abs() > n[2].abs();
    let by_y = !(n[0].abs() > n[1].abs()) && n[1].abs() > n[2].abs();
    // The axes of the plane come first; the third component is not read. No index that is computed:
    // arrays of a shader would be in memory then.
    let turned = |ball: Ball<R>| {
        let [x, y, z] = ball.centre;
        let (first, second) = if by_x { (y, z) } else { (x, y) };
        let (first, second) = if by_y { (z, x) } else { (first, second) };
        Ball { centre: [first, second, z], ..ball }
    };
    let (a, b, c) = (turned(a), turned(b), turned(c));
    let (d, d_error) = cross2(&b, &c);
    if !(d.abs() > d_error) {
        return Inside::Unknown;
    }
    let sign = if d < R::splat(0.0) { R::splat(-1.0) } else { R::splat(1.0) };
    let (s, s_error) = cross2(&a, &c);
    let (r, r_error) = cross2(&b, &a);
    let (d, s, r) = (d * sign, s * sign, r * sign);
    let conditions = conditions(patch, (d, d_error), (s, s_error), (r, r_error));
    let mut all_inside = true;
    for k in 0..4 {
        let (value, error) = conditions[k];
        if value < -error {
            return Inside::Outside;
        }
        all_inside &= value > error;
    }
    if all_inside { Inside::Inside } else { Inside::Unknown }
}
