//! Conservative advancement along separating directions: certifies time intervals as free of contact, whatever the geometry.
//!
//! For a fixed direction `w` the separation of the two features is `min_j w . d_j(t)` over the corners `d_j` of their difference
//! (3 for vertex-face, 4 for edge-edge), and each term is linear in `t`: so the exact time until which `w` separates them is
//! known in closed form. Taking `w` towards the nearest point at the current time and advancing to that time is the
//! conservative advancement of Mirtich (1996, chapter 2.3) with the motion bound replaced by the true motion along `w`; it converges
//! faster than linearly and needs no coplanarity, so degenerate and planar motions are not special. An inexact `w` costs
//! progress, never certainty.

use crate::closest::closest;
use crate::motion::{Motion, Patch};
use crate::real::Real;
use crate::vec3::{dot, lerp, scale, sum_abs};

/// The outcome of [`advance`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(u32)]
pub enum Advance<R> {
    /// The distance certainly stays above the minimum in all of the interval.
    Clear,
    /// It certainly does before this time; nothing is known from here on.
    Stuck(R),
}

/// Directions tried before giving up: grazing motions creep, and a caller is told [`Advance::Stuck`].
const MAX_DIRECTIONS: usize = 48;
/// Progress in time below which creeping ends: 2^-32.
const MIN_PROGRESS: f32 = 2.328_306_4e-10;

/// Advances from `from` towards `until` while the features certainly stay further than `min_distance >= 0` apart.
pub fn advance<R: Real>(m: &Motion<R>, patch: Patch, from: R, until: R, min_distance: R) -> Advance<R> {
    let (corners0, corners1) = (m.corners(patch, 0), m.corners(patch, 1));
    let slack = m.corner_error();
    let zero = R::splat(0.0);
    let mut t = from;
    for _ in 0..MAX_DIRECTIONS {
        let w = closest(lerp(m.a[0], m.a[1], t), lerp(m.b[0], m.b[1], t), lerp(m.c[0], m.c[1], t), patch);
        // Components of `w` that add up to 1: its products neither overflow nor vanish, and a direction needs no unit length.
        let w_sum = sum_abs(w);
        if !(w_sum > zero) || !w_sum.is_finite_number() {
            return Advance::Stuck(t);
        }
        let w = scale(w, R::splat(1.0) / w_sum);
        let length = dot(w, w).sqrt_up();
        let needed = slack * R::splat(1.01) + min_distance * length * (R::splat(1.0) + R::UNIT * R::splat(8.0));
        let mut next = R::splat(2.0);
        for j in 0..4 {
            let (g0, g1) = (dot(w, corners0[j]), dot(w, corners1[j]));
            let needed = needed + (g0.abs() + g1.abs()) * (R::UNIT * R::splat(8.0));
            if g0 > needed && g1 > needed {
                continue;
            }
            if !(g0 + (g1 - g0) * t > needed) {
                return Advance::Stuck(t);
            }
            if g1 < g0 {
                // Devices divide by greater numbers as they like.
                if !(g0 - g1 <= R::splat(0.25) / R::MIN_NORMAL) {
                    return Advance::Stuck(t);
                }
                let reach = (g0 - needed) / (g0 - g1) * (R::splat(1.0) - R::UNIT * R::splat(16.0));
                next = next.min(reach);
            }
        }
        if next > until {
            return Advance::Clear;
        }
        if !(next > t) {
            return Advance::Stuck(t);
        }
        let progress = next - t;
        t = next;
        if progress < R::splat(MIN_PROGRESS) {
            break;
        }
    }
    Advance::Stuck(t)
}

/// Whether the features certainly are within `min_distance` of each other at time `t`.
pub fn within<R: Real>(m: &Motion<R>, patch: Patch, t: R, min_distance: R) -> bool {
    let x = closest(lerp(m.a[0], m.a[1], t), lerp(m.b[0], m.b[1], t), lerp(m.c[0], m.c[1], t), patch);
    // Twice for the interpolation besides the differences, twice for the length of an error in three components.
    let length = dot(x, x).sqrt_up() * (R::splat(1.0) + R::UNIT * R::splat(8.0)) + m.corner_error() * R::splat(4.0);
    length <= min_distance
}
