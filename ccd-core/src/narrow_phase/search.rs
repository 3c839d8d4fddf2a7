//! What a query looks for besides a contact of two features: the distance that counts, the times,
//! how exact a time of impact must be, and whether a contact at the start may be left.

use crate::math::real::Real;
use crate::narrow_phase::approach::Approach;
use crate::narrow_phase::query::{TOI_TOLERANCE, Verdict};

/// What a query looks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search<R> {
    /// Contact means a distance of at most this, in the unit of the coordinates.
    pub min_distance: R,
    /// How early a certain time of impact may be, in units of the step.
    pub tolerance: R,
    /// First time that is looked at, in `[0, 1]`.
    pub from: R,
    /// Last time that is looked at, in `[from, 1]`.
    pub until: R,
    /// Whether features that are in contact at `from` may leave it, see
    /// [`approach`](crate::narrow_phase::approach).
    pub leaves: bool,
}

impl<R: Real> Search<R> {
    /// For the first contact of a whole step, up to [`TOI_TOLERANCE`].
    pub fn whole(min_distance: R) -> Self {
        let (from, until) = (R::splat(0.0), R::splat(1.0));
        let tolerance = R::from_f64(TOI_TOLERANCE);
        Self { min_distance, tolerance, from, until, leaves: false }
    }
}

/// What a query found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer<R> {
    /// Whether there is a contact, and when.
    pub verdict: Verdict<R>,
    /// Whether the features approach each other at the time of impact; unknown for a miss.
    pub approach: Approach,
}

/// A verdict of which nothing more is known.
impl<R> From<Verdict<R>> for Answer<R> {
    fn from(verdict: Verdict<R>) -> Self {
        Self::of(verdict)
    }
}

impl<R> Answer<R> {
    /// A miss, or a verdict of which nothing more is known.
    #[inline(always)]
    pub fn of(verdict: Verdict<R>) -> Self {
        Self { verdict, approach: Approach::Unknown }
    }
}
