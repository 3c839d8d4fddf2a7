//! Conservative advancement along separating directions: certifies time intervals as free of
//! contact, whatever the geometry.
//!
//! For a direction `w` the separation of the two features is `min_j w . d_j(t)` over the corners
//! `d_j` of their difference (3 for vertex-face, 4 for edge-edge), each linear in `t`. Two
//! certificates come from that:
//! - one direction: the time until which a fixed `w` separates them is known in closed form. Taking
//!   `w` towards the nearest point at the current time and advancing to that time is the
//!   conservative advancement of [Mirtich 1996] (chapter 2.3) with the motion bound replaced by the
//!   true motion along `w`;
//! - two directions, `w` at the start and `v` at the end of an interval `[t, e]`: along
//!   `w + x (v - w)`, which turns with the features, the separation is a quadratic in `x` with the
//!   Bernstein values `w . d_j(t)`, `(w . d_j(e) + v . d_j(t)) / 2` and `v . d_j(e)`. All of them
//!   large enough, it is in all of the interval. What a turning feature costs is then of second
//!   order in the length of the interval, so that slow and grazing approaches end after some tens
//!   of directions.
//!
//! Where features are so near that the direction between them is little but noise, the axes are
//! tried: what is exact needs no accuracy. Neither certificate needs coplanarity, so degenerate and
//! planar motions are not special. An inexact direction costs progress, never certainty.
//!
//! # The bound
//! Components of a direction add up to 1, so a scalar product with a corner errs by at most
//! [`Motion::corner_error`] `s`. A separation at time `t` is `g0 + (g1 - g0) t`: three operations,
//! at most `4 u (|g0| + |g1|)`. It must exceed `min_distance |w|`, for which `|w|` is a square root
//! from above, `1.01 s`, and `12 u (|g0| + |g1|)`: the other `8 u` cover the roundings of these
//! sums and of the sum of two such differences, `12 u` of `min_distance |w|` those of its own.
//! `|w + x (v - w)|` is at most `(1 - x) |w| + x |v|`, which raised to the same degree has the
//! values `|w|`, `(|w| + |v|) / 2`, `|v|`.

use crate::math::real::Real;
use crate::math::vec3::{dot, lerp, scale, sum_abs};
use crate::narrow_phase::closest_point::closest;
use crate::narrow_phase::relative_motion::{Motion, Patch};

/// The outcome of [`advance`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(u32)]
pub enum Advance<R> {
    /// The distance certainly stays above the minimum in all of the interval.
    Clear,
    /// It certainly does before this time; nothing is known from here on.
    Stuck(R),
}

/// Directions tried before giving up with [`Advance::Stuck`].
const MAX_DIRECTIONS: usize = 96;
/// Steps in time below which advancing ends: 2^-8 of the tolerance of a time of impact.
const MIN_STEP: f32 = 0.003_906_25;
/// How long after a certified time, as a part of the tolerance, a contact ends the search.
pub const SHORTLY: f32 = 0.01;

/// Advances from `from` towards `until` while the features certainly stay further than
/// `min_distance >= 0` apart, by steps that suit the `tolerance` of a time of impact.
pub fn advance<R: Real>(
    m: &Motion<R>,
    patch: Patch,
    from: R,
    until: R,
    min_distance: R,
    tolerance: R,
) -> Advance<R> {
    let field = Field::new(m, patch, min_distance);
    let min_step = tolerance * R::splat(MIN_STEP);
    // Free of contact up to `reach >= t`; `now` separates at `t`.
    let (mut t, mut reach, mut goal) = (from, from, from);
    let mut now = Separation::nothing();
    // How many axes were tried instead of the direction at the time that is certified.
    let mut axes = 0;
    let mut started = false;
    // By how much the last direction reached beyond its time.
    let mut gain = until - from;
    for _ in 0..MAX_DIRECTIONS {
        let w = nearest(m, patch, goal);
        let then = field.towards(if axes == 0 { w } else { along_axis(w, axes) });
        let step = goal - t;
        let first = !started;
        let next;
        if then.clear_at(goal) && (goal <= reach || now.clear_with(&then, t, goal)) {
            if started && goal >= until {
                return Advance::Clear;
            }
            t = goal;
            now = then;
            axes = 0;
            reach = now.reach(t);
            if reach > until {
                return Advance::Clear;
            }
            let gained = reach - t;
            let stops = gained <= min_step;
            let shortly = (reach + tolerance * R::splat(SHORTLY)).min(until);
            if stops && min_distance > R::splat(0.0) && within(m, patch, shortly, min_distance) {
                break;
            }
            next = if !started {
                until - t
            } else if !stops && gained <= gain * R::splat(0.25) {
                // Near a contact each direction reaches close to where the next one ends.
                R::splat(0.0)
            } else {
                step + step
            };
            gain = gained;
            started = true;
        } else if goal <= reach {
            // Certified until here, and no direction here. That of features that are very near is
            // little but noise; an axis has none.
            axes += 1;
            if axes > 3 {
                return Advance::Stuck(goal);
            }
            continue;
        } else {
            next = step * shorter(now.least_at(t), then.least_at(goal));
        }
        goal = (t + next).max(reach).min(until);
        if !first && !(goal - t > min_step) {
            break;
        }
    }
    Advance::Stuck(reach)
}

/// What separates two features, but for the direction.
#[derive(Clone, Copy, Debug)]
pub struct Field<R> {
    /// Corners of their difference at `t = 0` and `t = 1`.
    pub corners: [[[R; 3]; 4]; 2],
    /// Error of a product of a corner and a direction.
    pub slack: R,
    /// How far apart they must stay.
    pub min_distance: R,
}

/// How far each corner is along one direction at `t = 0` and `t = 1`, and how far it must be.
#[derive(Clone, Copy, Debug)]
pub struct Separation<R> {
    /// Each corner at `t = 0`.
    pub g0: [R; 4],
    /// Each corner at `t = 1`.
    pub g1: [R; 4],
    /// What each must exceed, errors included.
    pub needed: [R; 4],
}

impl<R: Real> Field<R> {
    /// Of a motion over `patch`.
    #[inline(always)]
    pub fn new(m: &Motion<R>, patch: Patch, min_distance: R) -> Self {
        let corners = [m.corners(patch, 0), m.corners(patch, 1)];
        Self { corners, slack: m.corner_error(), min_distance }
    }

    /// Along `w`, of any length.
    #[inline(always)]
    fn towards(&self, w: [R; 3]) -> Separation<R> {
        // Components that add up to 1: products neither overflow nor vanish, and a direction needs
        // no unit length.
        let w_sum = sum_abs(w);
        if !(w_sum > R::splat(0.0)) || !w_sum.is_finite_number() {
            return Separation::nothing();
        }
        self.along(scale(w, R::splat(1.0) / w_sum))
    }

    /// Along `w`, whose components add up to 1, nearly.
    #[inline(always)]
    pub fn along(&self, w: [R; 3]) -> Separation<R> {
        let length = dot(w, w).sqrt_up();
        let twelve = R::UNIT * R::splat(12.0);
        let common =
            self.slack * R::splat(1.01) + self.min_distance * length * (R::splat(1.0) + twelve);
        let [p, q] = &self.corners;
        let g0 = [dot(w, p[0]), dot(w, p[1]), dot(w, p[2]), dot(w, p[3])];
        let g1 = [dot(w, q[0]), dot(w, q[1]), dot(w, q[2]), dot(w, q[3])];
        let needed = [
            common + (g0[0].abs() + g1[0].abs()) * twelve,
            common + (g0[1].abs() + g1[1].abs()) * twelve,
            common + (g0[2].abs() + g1[2].abs()) * twelve,
            common + (g0[3].abs() + g1[3].abs()) * twelve,
        ];
        Separation { g0, g1, needed }
    }
}

impl<R: Real> Separation<R> {
    /// Separates at no time.
    #[inline(always)]
    fn nothing() -> Self {
        let (zero, one) = (R::splat(0.0), R::splat(1.0));
        Self { g0: [zero; 4], g1: [zero; 4], needed: [one; 4] }
    }

    /// By how much corner `j` is further along than it must be at time `t`.
    #[inline(always)]
    pub fn excess(&self, j: usize, t: R) -> R {
        (self.g0[j] + (self.g1[j] - self.g0[j]) * t) - self.needed[j]
    }

    /// Whether the direction separates at time `t`.
    #[inline(always)]
    pub fn clear_at(&self, t: R) -> bool {
        let zero = R::splat(0.0);
        self.excess(0, t) > zero
            && self.excess(1, t) > zero
            && self.excess(2, t) > zero
            && self.excess(3, t) > zero
    }

    /// Whether the direction that turns from this one at `t`, where it separates, to `then` at
    /// `end`, where that does, separates in between.
    #[inline(always)]
    fn clear_with(&self, then: &Self, t: R, end: R) -> bool {
        let zero = R::splat(0.0);
        self.excess(0, end) + then.excess(0, t) > zero
            && self.excess(1, end) + then.excess(1, t) > zero
            && self.excess(2, end) + then.excess(2, t) > zero
            && self.excess(3, end) + then.excess(3, t) > zero
    }

    /// The least excess of all corners, to guess by.
    #[inline(always)]
    pub(super) fn least_at(&self, t: R) -> R {
        (self.excess(0, t).min(self.excess(1, t))).min(self.excess(2, t).min(self.excess(3, t)))
    }

    /// The time until which the direction certainly separates if it does at `t`; 2 if it always
    /// does from then on.
    #[inline(always)]
    fn reach(&self, t: R) -> R {
        let (first, second) = (
            self.reach_of(0, t).min(self.reach_of(1, t)),
            self.reach_of(2, t).min(self.reach_of(3, t)),
        );
        first.min(second).max(t)
    }

    /// The same for corner `j`. Two differences, their quotient, and what is taken away with its
    /// product: `1 + 1 + 5 + 1 + 1` of the `16 u` that are taken away.
    #[inline(always)]
    pub fn reach_of(&self, j: usize, t: R) -> R {
        let (g0, g1, needed) = (self.g0[j], self.g1[j], self.needed[j]);
        if g0 > needed && g1 > needed || g1 >= g0 {
            return R::splat(2.0);
        }
        // Devices divide by greater numbers as they like.
        if !(g0 - g1 <= R::splat(0.25) / R::MIN_NORMAL) {
            return t;
        }
        (g0 - needed) / (g0 - g1) * (R::splat(1.0) - R::UNIT * R::splat(16.0))
    }
}

/// Whether the features certainly are within `min_distance` of each other at time `t`.
pub fn within<R: Real>(m: &Motion<R>, patch: Patch, t: R, min_distance: R) -> bool {
    greatest_distance(m, patch, t) <= min_distance
}

/// An upper bound of the distance of the features at time `t`.
#[inline(always)]
pub fn greatest_distance<R: Real>(m: &Motion<R>, patch: Patch, t: R) -> R {
    length_up(m, nearest(m, patch, t))
}

/// An upper bound of the distance of the features at the time at which `x` is what [`nearest`]
/// gives.
#[inline(always)]
pub fn length_up<R: Real>(m: &Motion<R>, x: [R; 3]) -> R {
    // Twice for the interpolation besides the differences, twice for the length of an error in
    // three components.
    dot(x, x).sqrt_up() * (R::splat(1.0) + R::UNIT * R::splat(8.0))
        + m.corner_error() * R::splat(4.0)
}

/// The vector from the second feature to the first at time `t`, up to rounding.
#[inline(always)]
pub fn nearest<R: Real>(m: &Motion<R>, patch: Patch, t: R) -> [R; 3] {
    closest(lerp(m.a[0], m.a[1], t), lerp(m.b[0], m.b[1], t), lerp(m.c[0], m.c[1], t), patch)
}

/// The part of `w` along the first, second or third axis.
#[inline(always)]
fn along_axis<R: Real>(w: [R; 3], axis: u32) -> [R; 3] {
    let zero = R::splat(0.0);
    [
        if axis == 1 { w[0] } else { zero },
        if axis == 2 { w[1] } else { zero },
        if axis == 3 { w[2] } else { zero },
    ]
}

/// The part of a step to try after it failed, from how far separations exceed what is needed at its
/// start and at its end: almost as far as the line between both says, or half as far where the
/// features only turned too much.
#[inline(always)]
fn shorter<R: Real>(gap: R, gap_ahead: R) -> R {
    let (least, half, most) = (R::splat(0.0625), R::splat(0.5), R::splat(0.9));
    if gap_ahead > R::splat(0.0) {
        return half;
    }
    let part = R::splat(0.95) * (gap / (gap - gap_ahead));
    if part > least { part.min(most) } else { least }
}
