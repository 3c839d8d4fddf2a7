//! The elemental queries: one vertex against one face, one edge against one edge, over one step.
//!
//! Coordinates are in any unit of length, time runs from 0 to 1, vertices move on straight lines.
//! Contact is closed: touching counts, also at `t = 0` and `t = 1`. With a minimum distance
//! `d > 0`, contact means a distance of at most `d`.

pub use crate::narrow_phase::search::{LEAST_TOLERANCE, TOI_TOLERANCE, Verdict};

use crate::math::real::{Mask, Real};
use crate::narrow_phase::approach::{Approach, Departure};
use crate::narrow_phase::conservative_advancement::{Advance, SHORTLY, advance, within};
use crate::narrow_phase::containment::{Inside, inside};
use crate::narrow_phase::coplanarity::Coplanarity;
use crate::narrow_phase::cubic_roots::{Cubic, Interval};
use crate::narrow_phase::relative_motion::{Motion, Patch, in_unit};
use crate::narrow_phase::search::{Answer, Search};

/// A vertex-face query: `v f0 f1 f2` at both ends of the step.
///
/// ```
/// use ccd::{VertexFace, vertex_face};
///
/// let t0 = [[0.2, 1.0, 0.2], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0f32]];
/// let mut t1 = t0;
/// t1[0][1] = 0.5;
/// let query = VertexFace { t0, t1 };
/// assert_eq!(vertex_face(&query, 0.0).toi(), None);
/// // The same in f64.
/// assert_eq!(query.widen().t1[0][1], 0.5f64);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexFace<T> {
    /// `v f0 f1 f2` at `t = 0`.
    pub t0: [[T; 3]; 4],
    /// `v f0 f1 f2` at `t = 1`.
    pub t1: [[T; 3]; 4],
}

/// An edge-edge query: `ea0 ea1 eb0 eb1` at both ends of the step.
///
/// ```
/// use ccd::{EdgeEdge, edge_edge};
///
/// // An edge falls onto another one.
/// let at = |y: f64| [[-1.0, y, 0.0], [1.0, y, 0.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0]];
/// let toi = edge_edge(&EdgeEdge { t0: at(1.0), t1: at(-1.0) }, 0.0).toi();
/// assert!(toi.is_some_and(|t| t <= 0.5 && t > 0.5 - 1e-6));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgeEdge<T> {
    /// `ea0 ea1 eb0 eb1` at `t = 0`.
    pub t0: [[T; 3]; 4],
    /// `ea0 ea1 eb0 eb1` at `t = 1`.
    pub t1: [[T; 3]; 4],
}

macro_rules! widen {
    ($name:ident) => {
        impl $name<f32> {
            /// The same query in `f64`; exact. What `f32` leaves undecided, this mostly decides.
            pub fn widen(&self) -> $name<f64> {
                let f = |x: &[[f32; 3]; 4]| x.map(|p| p.map(f64::from));
                $name { t0: f(&self.t0), t1: f(&self.t1) }
            }
        }
    };
}
widen!(VertexFace);
widen!(EdgeEdge);

/// Decides a vertex-face query in the arithmetic of `R`.
///
/// `min_distance >= 0`. Coordinates must be finite and at most 1e100 (`f64`); what overflows or
/// underflows in `R` is undecided, not wrong.
///
/// ```
/// use ccd::{Verdict, VertexFace, vertex_face};
///
/// // A vertex falls through a triangle: half of the way down.
/// let t0 = [[0.2, 1.0, 0.2], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0f64]];
/// let mut t1 = t0;
/// t1[0][1] = -1.0;
/// let Verdict::Hit { toi } = vertex_face(&VertexFace { t0, t1 }, 0.0) else { panic!() };
/// assert!(toi <= 0.5 && toi > 0.5 - 1e-6);
/// // A distance of 0.5 is reached earlier.
/// let near = vertex_face(&VertexFace { t0, t1 }, 0.5).toi();
/// assert!(near.is_some_and(|toi| toi <= 0.25 && toi > 0.25 - 1e-6));
/// ```
pub fn vertex_face<R: Real>(q: &VertexFace<R>, min_distance: R) -> Verdict<R> {
    solve(&Motion::vertex_face(&q.t0, &q.t1, R::splat(0.0)), Patch::Triangle, min_distance)
}

/// Decides an edge-edge query in the arithmetic of `R`. See [`vertex_face`] for what is accepted.
///
/// ```
/// use ccd::{EdgeEdge, Verdict, edge_edge};
///
/// let t0 = [[-1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0f64]];
/// let t1 = [[-1.0, 0.5, 0.0], [1.0, 0.5, 0.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1.0f64]];
/// assert_eq!(edge_edge(&EdgeEdge { t0, t1 }, 0.0), Verdict::Miss);
/// ```
pub fn edge_edge<R: Real>(q: &EdgeEdge<R>, min_distance: R) -> Verdict<R> {
    solve(&Motion::edge_edge(&q.t0, &q.t1, R::splat(0.0)), Patch::Parallelogram, min_distance)
}

/// Decides a query that is already in relative form, over the whole step and up to
/// [`TOI_TOLERANCE`]; input errors of `m` are part of every bound.
pub fn solve<R: Real>(m: &Motion<R>, patch: Patch, min_distance: R) -> Verdict<R> {
    search(m, patch, &Search::whole(min_distance)).verdict
}

/// Decides a query that is already in relative form; input errors of `m` are part of every bound.
///
/// The verdict is about times from [`Search::from`] to [`Search::until`]: a time of impact is the
/// first of a contact among these. Where it would be later than [`Search::latest`], the verdict may
/// be a miss.
pub fn search<R: Real>(m: &Motion<R>, patch: Patch, search: &Search<R>) -> Answer<R> {
    if search.min_distance > R::splat(0.0) {
        return near(m, patch, search);
    }
    // The plane rejects most single queries, in whatever unit they are, and nearly all others are
    // in a unit that will do, so that nothing is copied.
    let plane = Coplanarity::new(m);
    if plane.is_nonzero().all() {
        return Answer::from(Verdict::Miss);
    }
    if m.has_fine_unit() {
        return answer(touching::<true, R>(m, &plane, patch, search), search);
    }
    contact(m, patch, search)
}

/// [`search`] without a minimum distance, whatever the search says.
#[inline(always)]
pub(super) fn contact<R: Real>(m: &Motion<R>, patch: Patch, search: &Search<R>) -> Answer<R> {
    by_zeros::<true, R>(m, patch, search)
}

/// What zeros of the cubic tell of a contact. `ADVANCES`: and, where they do not, advancing time;
/// else that is undecided. Of pairs that filters leave, hardly any needs it, but features that rest
/// on each other or stay in one plane do; and it is half of a kernel, which then runs slower.
#[inline(always)]
pub(super) fn by_zeros<const ADVANCES: bool, R: Real>(
    m: &Motion<R>,
    patch: Patch,
    search: &Search<R>,
) -> Answer<R> {
    let (m, _) = in_unit(m, R::splat(0.0));
    answer(touching::<ADVANCES, R>(&m, &Coplanarity::new(&m), patch, search), search)
}

/// A verdict of [`touching`], and what it says of the approach.
#[inline(always)]
fn answer<R: Real>(verdict: Verdict<R>, search: &Search<R>) -> Answer<R> {
    // It certainly is apart until the time of impact, and certainly touches after it.
    let nears = matches!(verdict, Verdict::Hit { toi } if toi > search.from);
    let approach = if nears { Approach::Approaching } else { Approach::Unknown };
    Answer { verdict, approach }
}

/// [`search`] with a minimum distance.
#[inline(always)]
pub(super) fn near<R: Real>(m: &Motion<R>, patch: Patch, search: &Search<R>) -> Answer<R> {
    let (m, min_distance) = in_unit(m, search.min_distance);
    at_distance(&m, patch, &Search { min_distance, ..*search })
}

/// Contact as coplanarity and containment: `min_distance = 0`. `plane`: of the motion. `ADVANCES`:
/// see [`by_zeros`].
fn touching<const ADVANCES: bool, R: Real>(
    m: &Motion<R>,
    plane: &Coplanarity<R>,
    patch: Patch,
    search: &Search<R>,
) -> Verdict<R> {
    let zero = R::splat(0.0);
    if plane.is_nonzero().all() {
        return Verdict::Miss;
    }
    // The bound is of 3 f; 0.34 is a third, rounded up.
    let cubic = Cubic::new(plane.c, plane.bound * R::splat(0.34)).refined(search.tolerance);
    let (ends, n_pieces) = cubic.pieces();
    let early = search.tolerance * R::splat(0.99);
    // The start comes first, as a piece of its own, where features may rest on each other: no
    // interval that may hold a zero starts later, and nothing would certify that they do not touch
    // there. In one loop, because kernels have a copy of `advance` for each call.
    let first = if cubic.may_vanish_at(search.from) { 0 } else { 1 };
    for i in first..n_pieces + 1 {
        let mut at = Interval { lo: search.from, hi: search.from, crosses: false };
        let mut touches = false;
        if i > 0 {
            let (from, to) = (ends[i - 1].max(search.from), ends[i].min(search.until));
            if !(from <= to) {
                continue;
            }
            if cubic.is_nonzero_until(search.latest, from, to) {
                return Verdict::Miss;
            }
            at = cubic.zero_in_piece(from, to);
            if at.is_empty() {
                continue;
            }
            // Nothing below is earlier.
            if at.lo > search.latest {
                return Verdict::Miss;
            }
            let place = inside(m, patch, at.lo, at.hi);
            if matches!(place, Inside::Outside) {
                continue;
            }
            touches = matches!(place, Inside::Inside) && at.crosses;
            if touches && at.hi - at.lo <= early {
                return Verdict::Hit { toi: at.lo };
            }
        }
        if !ADVANCES {
            return Verdict::Undecided { toi: at.lo };
        }
        if let Advance::Stuck(toi) = advance(m, patch, at.lo, at.hi, zero, search.tolerance) {
            // What touches in the interval does after this time.
            if touches && at.hi - toi <= early {
                return Verdict::Hit { toi };
            }
            return Verdict::Undecided { toi };
        }
    }
    Verdict::Miss
}

/// Contact as a distance of at most `min_distance > 0`.
pub(super) fn at_distance<R: Real>(m: &Motion<R>, patch: Patch, search: &Search<R>) -> Answer<R> {
    let Search { min_distance, tolerance, until, .. } = *search;
    let mut from = search.from;
    let near = within(m, patch, from, min_distance);
    if !near && Coplanarity::new(m).clearance(min_distance) > R::splat(0.0) {
        return Answer::from(Verdict::Miss);
    }
    let mut toi = from;
    let mut approach = Approach::Unknown;
    // From the start, and once more after a contact there was left.
    for round in 0..2 {
        if round > 0 || !near {
            match advance(m, patch, from, until, min_distance, tolerance) {
                Advance::Clear => return Answer::from(Verdict::Miss),
                Advance::Stuck(t) => toi = t,
            }
        }
        if toi > search.from {
            break;
        }
        let departure = Departure::new(m, patch, from, until, min_distance);
        approach = departure.approach;
        if !search.leaves || !matches!(approach, Approach::Separating) {
            break;
        }
        if departure.again <= until {
            (from, toi) = (departure.again, departure.again);
        } else if departure.safe >= until {
            return Answer::from(Verdict::Miss);
        } else {
            // Nothing is known after that; at the start itself, if it is not safe at all.
            if departure.safe > search.from {
                approach = Approach::Unknown;
            }
            return Answer { verdict: Verdict::Undecided { toi: departure.safe }, approach };
        }
    }
    conclude(m, patch, search, toi, approach)
}

/// A contact that is not excluded from `toi` on. A hit needs a witness: a time shortly after it at
/// which the distance certainly is small enough.
#[inline(always)]
fn conclude<R: Real>(
    m: &Motion<R>,
    patch: Patch,
    search: &Search<R>,
    toi: R,
    at_start: Approach,
) -> Answer<R> {
    let later = [SHORTLY, 0.0, 0.8];
    // Where rounding may make it later by an eighth of the tolerance, that time alone.
    let lasts = search.tolerance >= R::UNIT * R::splat(8.0);
    let reach = if lasts { search.tolerance } else { R::splat(0.0) };
    for i in 0..3 {
        let t = (toi + reach * R::splat(later[i])).min(search.until);
        if within(m, patch, t, search.min_distance) {
            let nears = toi > search.from;
            let approach = if nears { Approach::Approaching } else { at_start };
            return Answer { verdict: Verdict::Hit { toi }, approach };
        }
    }
    let approach = if toi > search.from { Approach::Unknown } else { at_start };
    Answer { verdict: Verdict::Undecided { toi }, approach }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    const PATCHES: [Patch; 2] = [Patch::Triangle, Patch::Parallelogram];

    /// Random queries at many scales: what is certainly a contact at scale 1 is none that may be
    /// missed at another.
    fn check_scales<R: Real>(exponents: &[i32]) {
        let mut random = Random::new(7);
        let mut coordinate = || (random.bits() >> 16) as f64 / 65_536.0 - 0.5;
        let mut n_hits = 0;
        for _ in 0..20_000 {
            let mut four = || [(); 4].map(|()| [(); 3].map(|()| coordinate()));
            let (t0, t1) = (four(), four());
            let at = |scale: f64, x: &[[f64; 3]; 4]| x.map(|p| p.map(|c| R::from_f64(c * scale)));
            let verdicts = |scale| {
                let (t0, t1) = (at(scale, &t0), at(scale, &t1));
                let zero = R::splat(0.0);
                [vertex_face(&VertexFace { t0, t1 }, zero), edge_edge(&EdgeEdge { t0, t1 }, zero)]
            };
            let base =
                [vertex_face(&VertexFace { t0, t1 }, 0.0), edge_edge(&EdgeEdge { t0, t1 }, 0.0)];
            for k in 0..2 {
                if matches!(base[k], Verdict::Hit { .. }) {
                    n_hits += 1;
                    for &e in exponents {
                        assert!(
                            verdicts(2f64.powi(e))[k] != Verdict::Miss,
                            "missed at scale 2^{e}: {t0:?} {t1:?}"
                        );
                    }
                }
            }
        }
        assert!(n_hits > 1000, "{n_hits} hits show nothing");
    }

    #[test]
    fn what_is_found_up_to_a_time_is_the_same() {
        let mut random = Random::new(31);
        let (mut same, mut missed) = (0, 0);
        for i in 0..40_000 {
            let mut at = || core::array::from_fn(|_| random.point().map(|c| c - 0.5));
            let (mut t0, t1): ([[f64; 3]; 4], _) = (at(), at());
            if i % 8 < 2 {
                // In contact at the start.
                t0[2] = t0[0];
            }
            let patch = PATCHES[i % 2];
            let (m, whole) = (Motion::new(patch, &t0, &t1, 0.0), Search::whole(0.0));
            let found = search(&m, patch, &whole);
            let Some(toi) = found.verdict.toi() else { continue };
            for latest in [toi, toi.next_down(), toi - 1e-13, toi - 1e-7, 0.5 * toi, random.unit()]
            {
                let answer = search(&m, patch, &Search { latest, ..whole });
                let is_missed = toi > latest && answer.verdict == Verdict::Miss;
                assert!(
                    is_missed || answer == found,
                    "{toi} by {latest}: {answer:?}, {t0:?} {t1:?}"
                );
                same += (toi <= latest) as u32;
                missed += is_missed as u32;
            }
        }
        assert!(same > 5_000 && missed > 10_000, "{same} {missed}");
    }

    /// Points of a lattice: most queries are degenerate.
    #[test]
    fn zeros_leave_open_what_they_do_not_tell() {
        let (mut random, mut n_open) = (Random::new(3), 0);
        for i in 0..20_000 {
            let mut at = || [(); 4].map(|()| [(); 3].map(|()| random.below(4) as f64));
            let (patch, whole) = (PATCHES[i % 2], Search::whole(0.0));
            let m = Motion::new(patch, &at(), &at(), 0.0);
            let (all, told) = (contact(&m, patch, &whole), by_zeros::<false, _>(&m, patch, &whole));
            let is_open = matches!(told.verdict, Verdict::Undecided { .. });
            let later = all.verdict.toi().is_none_or(|t| Some(t) >= told.verdict.toi());
            assert!(told == all || is_open && later, "{m:?}");
            n_open += is_open as u32;
        }
        assert!((1000..19_000).contains(&n_open), "{n_open}");
    }

    #[test]
    fn scale_makes_no_miss() {
        check_scales::<f64>(&[0, 166, -166, 200, -200, 265, -265, 329, -329]);
        check_scales::<f32>(&[0, 16, -16, 20, -20, 24, -24, 30, -30, 40, -40, 45]);
    }
}
