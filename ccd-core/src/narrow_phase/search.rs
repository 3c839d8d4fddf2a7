//! What a query looks for besides a contact of two features: the distance that counts, the times,
//! how exact a time of impact must be, and whether a contact at the start may be left; and what it
//! finds.

use crate::math::real::Real;
use crate::narrow_phase::approach::Approach;

/// How early a certain time of impact may be, in units of the step, unless a search says another
/// tolerance.
pub const TOI_TOLERANCE: f64 = 1e-6;
/// The least tolerance that a search may ask for.
pub const LEAST_TOLERANCE: f64 = 1e-12;

/// What a query looks for.
///
/// ```
/// use ccd::geometry::{Motion, Patch};
/// use ccd_core::narrow_phase::query::search;
/// use ccd_core::narrow_phase::search::Search;
///
/// // A vertex falls through a triangle at 0.5: not in the first quarter of the step.
/// let at = |y: f64| [[0.2, y, 0.2], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
/// let motion = Motion::vertex_face(&at(1.0), &at(-1.0), 0.0);
/// let toi = |of: &Search<f64>| search(&motion, Patch::Triangle, of).verdict.toi();
/// let whole = Search::whole(0.0);
/// assert!(toi(&whole).is_some());
/// assert_eq!(toi(&Search { until: 0.25, ..whole }), None);
/// ```
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
    /// A contact of a later time of impact may be missed: one that is as early is known of another
    /// pair. What is found up to then is the same, to the last bit.
    pub latest: R,
    /// Whether features that are in contact at `from` may leave it, see
    /// [`approach`](crate::narrow_phase::approach).
    pub leaves: bool,
}

impl<R: Real> Search<R> {
    /// For the first contact of a whole step, up to [`TOI_TOLERANCE`].
    pub fn whole(min_distance: R) -> Self {
        let (from, until) = (R::splat(0.0), R::splat(1.0));
        let tolerance = R::from_f64(TOI_TOLERANCE);
        Self { min_distance, tolerance, from, until, latest: until, leaves: false }
    }
}

/// The answer of a query.
///
/// ```
/// use ccd::Verdict;
///
/// // What a conservative caller may advance to.
/// assert_eq!(Verdict::Undecided { toi: 0.25 }.toi(), Some(0.25));
/// assert_eq!(Verdict::<f64>::Miss.toi(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(u32)]
pub enum Verdict<R> {
    /// Certainly no contact during the step.
    Miss,
    /// Certainly contact; `toi` is not later than the first contact and at most the tolerance
    /// earlier: [`TOI_TOLERANCE`] by default.
    Hit {
        /// Time of impact in `[0, 1]`.
        toi: R,
    },
    /// Neither could be certified in this arithmetic: to be treated as a contact. There is no
    /// contact before `toi`.
    Undecided {
        /// The time until which the step is certainly free, in `[0, 1]`.
        toi: R,
    },
}

impl<R: Real> Verdict<R> {
    /// The time that a conservative caller may advance to: `None` for a miss.
    #[inline]
    pub fn toi(&self) -> Option<R> {
        match *self {
            Verdict::Miss => None,
            Verdict::Hit { toi } | Verdict::Undecided { toi } => Some(toi),
        }
    }
}

/// What a query found.
///
/// ```
/// use ccd::Verdict;
/// use ccd_core::narrow_phase::approach::Approach;
/// use ccd_core::narrow_phase::search::Answer;
///
/// let answer = Answer::from(Verdict::Hit { toi: 0.5 });
/// assert_eq!(answer.approach, Approach::Unknown);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer<R> {
    /// Whether there is a contact, and when.
    pub verdict: Verdict<R>,
    /// Whether the features approach each other at the time of impact; unknown for a miss.
    pub approach: Approach,
}

impl<R> Answer<R> {
    /// Whether neither contact nor none was certified.
    #[inline]
    pub fn is_open(&self) -> bool {
        matches!(self.verdict, Verdict::Undecided { .. })
    }
}

/// A miss, or a verdict of which nothing more is known.
impl<R> From<Verdict<R>> for Answer<R> {
    #[inline(always)]
    fn from(verdict: Verdict<R>) -> Self {
        Self { verdict, approach: Approach::Unknown }
    }
}
