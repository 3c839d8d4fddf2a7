//! Whether the features meet inside their extents while they are coplanar, decided for a whole interval of time at once.
//!
//! Contact is `a = s b + r c`. Projected along the axis in which the patch's normal is greatest this is a 2x2 system, and
//! `s = S / D`, `r = R / D` with `D = b x c`, `S = a x c`, `R = b x a` (2D cross products). Signs of `S`, `R`, `D - S - R` (triangle) or
//! `D - S`, `D - R` (parallelogram) relative to `D` that hold over the interval decide; a value within its error decides nothing.

use crate::math::real::Real;
use crate::math::vec3::{cross, lerp, max_abs, sub};
use crate::narrow_phase::relative_motion::{Motion, Patch};

/// What is certain about an interval of time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum Inside {
    /// At no time in the interval does the projected `a` lie in the projected patch: no contact there.
    Outside,
    /// At every time in the interval at which the features are coplanar, they touch.
    Inside,
    /// Neither could be certified.
    Unknown,
}

/// A vector at the middle of the interval and the radius that holds it over the whole interval.
struct Ball<R> {
    centre: [R; 3],
    radius: R,
    size: R,
}

impl<R: Real> Ball<R> {
    fn new(x: &[[R; 3]; 2], middle: R, half: R, error: R) -> Self {
        let magnitude = max_abs(x[0]).max(max_abs(x[1])) + error;
        let centre = lerp(x[0], x[1], middle);
        let travel = max_abs(sub(x[1], x[0]));
        let radius = half * travel * R::splat(1.01) + magnitude * (R::UNIT * R::splat(8.0)) + error;
        Self { centre, radius, size: max_abs(centre) + radius }
    }
}

/// `p x q` in the plane of axes `i`, `j`, with a bound of its error over both balls.
#[inline]
fn cross2<R: Real>(p: &Ball<R>, q: &Ball<R>, i: usize, j: usize) -> (R, R) {
    let value = p.centre[i] * q.centre[j] - p.centre[j] * q.centre[i];
    let one = R::splat(1.0);
    let error = (p.radius * q.size + p.size * q.radius) * R::splat(2.01)
        + p.size * q.size * (R::UNIT * R::splat(8.0))
        + (R::MIN_NORMAL * R::splat(256.0)) * ((one + p.size) * (one + q.size));
    (value, error)
}

/// Classifies the interval `[lo, hi]` inside `[0, 1]`.
pub fn inside<R: Real>(m: &Motion<R>, patch: Patch, lo: R, hi: R) -> Inside {
    let half = (hi - lo) * R::splat(0.5);
    let middle = lo + half;
    // The middle is rounded: let the ball reach a little further.
    let half = half + (R::UNIT * R::splat(4.0));
    let a = Ball::new(&m.a, middle, half, m.error);
    let b = Ball::new(&m.b, middle, half, m.error);
    let c = Ball::new(&m.c, middle, half, m.error);
    let n = cross(b.centre, c.centre);
    let (i, j) = if n[0].abs() > n[1].abs() {
        if n[0].abs() > n[2].abs() { (1, 2) } else { (0, 1) }
    } else if n[1].abs() > n[2].abs() {
        (2, 0)
    } else {
        (0, 1)
    };
    let (d, d_error) = cross2(&b, &c, i, j);
    if !(d.abs() > d_error) {
        return Inside::Unknown;
    }
    let sign = if d < R::splat(0.0) { R::splat(-1.0) } else { R::splat(1.0) };
    let (s, s_error) = cross2(&a, &c, i, j);
    let (r, r_error) = cross2(&b, &a, i, j);
    let (d, s, r) = (d * sign, s * sign, r * sign);
    let rounding = (d.abs() + s.abs() + r.abs()) * (R::UNIT * R::splat(4.0));
    let conditions = match patch {
        Patch::Triangle => {
            let rest = (d - s - r, d_error + s_error + r_error + rounding);
            [(s, s_error), (r, r_error), rest, rest]
        }
        Patch::Parallelogram => [(s, s_error), (r, r_error), (d - s, d_error + s_error + rounding), (d - r, d_error + r_error + rounding)],
    };
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
