//! Whether features that are in contact at the start of a search come nearer or go apart, and for
//! how long they certainly do not come nearer.
//!
//! Let `K(t)` be the hull of the corners `d_j(t)` of the difference of two features, `D(t)` its
//! distance from the origin, `x` its nearest point at the start and `n = x / D` the direction
//! there. All of `K` is at least `D` along `n` at the start, and whatever is far along `n` is far:
//!
//! ```text
//!       d_1 o-----------o d_2          D(t) >= min_j n . d_j(t)
//!            \         /
//!     x . . . o-------o . . .  n . x = D: corners here are active,
//!     ^      d_0     d_3                 others are idle until they come down to this line
//!     |  n
//!     0
//! ```
//!
//! - If every active corner rises along `n`, the distance grows from the start on:
//!   [`Approach::Separating`]. It stays at least what it was until an idle corner may have come
//!   down to `D`: [`Departure::safe`].
//! - If every active corner falls, the distance shrinks at once, because its derivative is a mean
//!   of those of active corners along `n`: [`Approach::Approaching`].
//! - Else, and wherever rounding leaves it open, [`Approach::Unknown`]. What touches (`D = 0`) has
//!   no side: a vertex in the plane of a face gets away from it whichever way it goes, also through
//!   it. So nothing ever leaves a contact at distance 0.
//!
//! Features that separate may leave their contact: see [`Departure::again`]. A search that lets
//! them promises that at every time before its time of impact, if there is one, the distance is
//! above the minimum or at least what it was at the start. A hit then is the first contact after a
//! time at which they certainly were apart, of which one is sought; where none is found, or before
//! it, a return to the minimum from farther away is no contact while that promise holds.
//!
//! # The bound
//! `n` is not known; `w` is, a direction near it whose components add up to 1, of length `L`. With
//! `U >= D` and `g <= min_j w . d_j`, both certain, `w . x >= g`, so the cosine of the angle
//! between both is at least `g / (L U)`, and `|w / L - n|` is at most
//! `turn = sqrt(2 (1 - g / (L U)))`. For any vector `v`, `n . v L` differs from `w . v` by at most
//! `turn L |v|`.
//!
//! - *`L U`*: two roundings and `12 u` of a length each; `64 u` are added. `2.02` for `2` and
//!   `1.01` hold the roundings of the quotient (`5 u`), of the root and of the products.
//! - *Along `w`*: a separation at a time errs by `1.01 s + 12 u (|g0| + |g1|)`, `s` the error of a
//!   corner, as in `conservative_advancement.rs`; the difference of two ends by at most twice that.
//! - *Sizes*: a vector is no longer than the sum of its components, each of which is off by `s`,
//!   and of a difference of ends by `2 s`; at a time in between a corner is no longer than at the
//!   longer end. `1.01` holds their roundings, if `u` times the size is in `s`, which it is.
//! - *Times*: quotient and products `16 u` of 0.1 % that are taken off.

use crate::math::real::Real;
use crate::math::vec3::{dot, scale, sub, sum_abs};
use crate::narrow_phase::conservative_advancement::{Field, Separation, length_up, nearest};
use crate::narrow_phase::relative_motion::{Motion, Patch};

/// Whether features come nearer at the time of impact.
///
/// ```
/// use ccd::geometry::{Motion, Patch};
/// use ccd_core::narrow_phase::approach::Approach;
/// use ccd_core::narrow_phase::query::search;
/// use ccd_core::narrow_phase::search::Search;
///
/// // A vertex rises from above a triangle, or falls; nearer than 0.2 is contact.
/// let at = |y: f64| [[0.2, y, 0.2], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
/// let to = |y: f64| Motion::vertex_face(&at(0.1), &at(y), 0.0);
/// let approach = |y: f64| search(&to(y), Patch::Triangle, &Search::whole(0.2)).approach;
/// assert_eq!(approach(0.5), Approach::Separating);
/// assert_eq!(approach(-0.5), Approach::Approaching);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
#[repr(u32)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Approach {
    /// Certainly neither, or not certain.
    #[default]
    Unknown,
    /// Certainly nearer: the distance falls to the minimum distance there, or, in a contact that is
    /// there at the start, falls further.
    Approaching,
    /// Certainly apart: the contact is there at the start, and its distance grows from then on for
    /// a while. Says nothing of a later contact.
    Separating,
}

impl Approach {
    /// The word of a record.
    #[inline(always)]
    pub fn word(self) -> u32 {
        match self {
            Approach::Unknown => 0,
            Approach::Approaching => 1,
            Approach::Separating => 2,
        }
    }

    /// From the word of a record.
    pub fn from_word(word: u32) -> Self {
        match word {
            1 => Approach::Approaching,
            2 => Approach::Separating,
            _ => Approach::Unknown,
        }
    }
}

/// How features that are in contact at the start go on.
#[derive(Clone, Copy, Debug)]
pub struct Departure<R> {
    /// Whether they come nearer.
    pub approach: Approach,
    /// Until this time the distance certainly is at least what it is at the start; meaningful if
    /// they are separating.
    pub safe: R,
    /// A time up to `safe` at which the distance certainly exceeds the minimum, from which to look
    /// for the next contact; 2 if none was found.
    pub again: R,
}

/// Least safe time that is reported, in units of roundoff: less is lost in sums with times.
const LEAST_SAFE: f32 = 4096.0;

impl<R: Real> Departure<R> {
    /// Nothing is known.
    #[inline(always)]
    fn unknown(from: R) -> Self {
        Self { approach: Approach::Unknown, safe: from, again: R::splat(2.0) }
    }

    /// Of features that are near at time `from`, until `until`.
    pub fn new(m: &Motion<R>, patch: Patch, from: R, until: R, min_distance: R) -> Self {
        let zero = R::splat(0.0);
        let x = nearest(m, patch, from);
        let size = sum_abs(x);
        let field = Field::new(m, patch, min_distance);
        let slack = field.slack;
        if !(size > slack) || !size.is_finite_number() {
            return Self::unknown(from);
        }
        let w = scale(x, R::splat(1.0) / size);
        let along = field.along(w);
        let length = dot(w, w).sqrt_up();
        // D in units of `w`, from above and from below.
        let most = length_up(m, x) * length * (R::splat(1.0) + R::UNIT * R::splat(64.0));
        let mut least = heights(&along, slack, 0, from).0;
        for j in 1..4 {
            least = least.min(heights(&along, slack, j, from).0);
        }
        if !(least > zero) {
            return Self::unknown(from);
        }
        let turn = ((most - least) / most * R::splat(2.02)).sqrt_up() * length * R::splat(1.01);
        let (mut rising, mut falling, mut safe) = (true, true, R::splat(2.0));
        for j in 0..4 {
            let (p, q) = (field.corners[0][j], field.corners[1][j]);
            let far = (sum_abs(p).max(sum_abs(q)) + slack * R::splat(3.0)) * R::splat(1.01);
            let fast = (sum_abs(sub(q, p)) + slack * R::splat(6.0)) * R::splat(1.01);
            let (height, error) = heights(&along, slack, j, from);
            let slope = along.g1[j] - along.g0[j];
            let unsure = error + error + turn * fast;
            let margin = height - turn * far - most;
            let idle = margin > R::MIN_NORMAL;
            let rises = slope > unsure;
            rising &= rises || idle;
            falling &= slope < -unsure || idle;
            if !rises && idle {
                safe = safe.min(margin / (unsure - slope).max(R::MIN_NORMAL));
            }
        }
        let safe = safe.min(R::splat(2.0)) * R::splat(0.999);
        if falling && !rising {
            return Self { approach: Approach::Approaching, ..Self::unknown(from) };
        }
        if !rising {
            return Self::unknown(from);
        }
        let lasts = safe > R::UNIT * R::splat(LEAST_SAFE);
        let safe = if lasts { (from + safe).min(until) } else { from };
        Self { approach: Approach::Separating, safe, again: along.clear_between(from, safe) }
    }
}

/// How far corner `j` certainly is along a direction at time `t`, and the error that is left out
/// of it.
#[inline(always)]
fn heights<R: Real>(along: &Separation<R>, slack: R, j: usize, t: R) -> (R, R) {
    let (g0, g1) = (along.g0[j], along.g1[j]);
    let error = slack * R::splat(1.01) + (g0.abs() + g1.abs()) * (R::UNIT * R::splat(12.0));
    ((g0 + (g1 - g0) * t) - error, error)
}

impl<R: Real> Separation<R> {
    /// A time in `(from, until]` at which the direction certainly separates, as far inside of all
    /// such times as can be; 2 if none is found.
    fn clear_between(&self, from: R, until: R) -> R {
        // Each corner is far enough after a time, if it rises, or before one.
        let (mut lo, mut hi) = (from, until);
        for j in 0..4 {
            let (here, slope) = (self.excess(j, from), self.g1[j] - self.g0[j]);
            if slope > R::splat(0.0) {
                lo = lo.max(from - here / slope);
            } else if here > R::splat(0.0) && slope < R::splat(0.0) {
                // One that neither rises nor falls, as where both vertices stand still, stays
                // where it is: it ends nothing.
                hi = hi.min(from - here / slope);
            }
        }
        let middle = lo + (hi - lo) * R::splat(0.5);
        if middle > from && middle <= until && self.clear_at(middle) {
            middle
        } else {
            R::splat(2.0)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::narrow_phase::conservative_advancement::greatest_distance;

    /// A corner rises from a height of 1, which is the distance, and one from 1.5 comes down as
    /// fast. Vectors are known up to a thousandth, so that roundings count for nothing: it is safe
    /// until the second one may be down, along a direction that is off by all that it may be.
    fn check<R: Real>() {
        let v = |x: [f32; 3]| x.map(R::splat);
        let m = Motion {
            a: [v([0.0, 1.0, 0.0]), v([0.0, 2.0, 0.0])],
            b: [v([0.0, -0.5, 0.0]), v([0.0, 1.5, 0.0])],
            c: [v([1.0, -1.0, 0.0]); 2],
            error: R::splat(1e-3),
        };
        let (zero, one) = (R::splat(0.0), R::splat(1.0));
        let found = Departure::new(&m, Patch::Triangle, zero, one, zero);
        assert_eq!(found.approach, Approach::Separating, "{found:?}");
        let error = m.corner_error().to_f64();
        let along = Field::new(&m, Patch::Triangle, zero).along(v([0.0, 1.0, 0.0]));
        let least = (0..4).map(|j| along.excess(j, zero).to_f64()).fold(f64::INFINITY, f64::min);
        let most = greatest_distance(&m, Patch::Triangle, zero).to_f64();
        let turn = (2.0 * (1.0 - least / most)).sqrt();
        let until = (1.5 - error - turn * 1.5 - most) / (1.0 + 2.0 * error + turn);
        let safe = found.safe.to_f64();
        assert!(safe <= until && safe > 0.94 * until, "{safe} of {until}: {found:?}");
    }

    #[test]
    fn a_departure_is_safe_for_no_longer_than_derived() {
        check::<f64>();
        check::<f32>();
    }
}
