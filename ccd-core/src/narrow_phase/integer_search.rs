//! A verdict by integers of 32 bits, for devices without `f64`: where the cubic of coplanarity
//! changes its sign, and whether the features certainly meet there.
//!
//! The vectors of a query are numbers in fixed point ([`Q62`]) of a unit in which the greatest is
//! about 1/8 or 1/4, so that every bound is a number of units `u` of 2^-62. The control
//! values of the cubic [Tang 2010] are halved by de Casteljau's algorithm, the first half first,
//! until their signs show that there is one zero. `f32` guesses where it is, signs on both sides of
//! the guess prove it, and the patch is looked at there, once more and closer if that is not
//! certain. Where signs prove nothing, an interval is halved further, down to 2^-31 of the step.
//!
//! Where features rest on each other, no sign is certain at the begin of an interval, nor would it
//! be after any halving. So the patch is looked at there first: what is not apart is open at once.
//!
//! The unit, the guess and the axis along which the patch is looked at come of `f32`, so a device
//! that rounds in another way may leave other pairs open and find other times within the tolerance;
//! what it certifies is true all the same.
//!
//! What is not certain is open: double zeros, edges that are parallel, contacts within some 2^-31
//! of the boundary of the patch, resting contact.

mod cubic;

use crate::math::q62::Q62;
use crate::math::vec3;
use crate::narrow_phase::relative_motion::{Motion, Patch};
#[cfg(any(feature = "alloc", test))]
use crate::narrow_phase::search::Search;
pub use cubic::Ends;
use cubic::{
    DEPTH, Part, Signs, Vectors, around_zero, coplanarity, det, guess, minus, over, sign, value,
};

/// What is looked for. Times are in 2^-31 of the step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Window {
    /// First time, rounded up.
    pub from: u32,
    /// Last time, rounded down.
    pub until: u32,
    /// How early a time of impact may be, rounded down: from 1 to 2^30.
    pub tolerance: u32,
}

impl Window {
    /// Of a search; `None` if that wants more than integers of 32 bits give.
    #[cfg(any(feature = "alloc", test))]
    pub fn of(search: &Search<f64>) -> Option<Self> {
        let units = |time: f64| time * (1u64 << DEPTH) as f64;
        let Search { min_distance, tolerance, from, until, leaves, .. } = *search;
        let tolerance = units(tolerance.min(0.5)) as u32;
        let fits = min_distance == 0.0 && !leaves && tolerance > 0;
        // Casts cut; so the first time is one after the cut, unless there was nothing to cut.
        let cut = units(from) as u32;
        let from = if cut as f64 == units(from) { cut } else { cut + 1 };
        fits.then_some(Self { from, until: units(until) as u32, tolerance })
    }
}

/// What was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Found {
    /// Certainly no contact in the window.
    Miss,
    /// Certainly a contact: none before this time, and one within the tolerance after it.
    Hit(u32),
    /// Neither is certain.
    Open,
    /// The same, and fewer digits tell no more: at some time the features are in one plane, as far
    /// as these digits tell, and certainly in each other's patch.
    Tie,
}

/// Rounds of a search: halvings, and intervals that are left. Most take fewer than ten; who needs
/// more than this has the cubic near 0 for long, and is open.
const MAX_ROUNDS: u32 = 64;
/// Depth of the longest interval around a zero that was guessed: longer ones would be more often on
/// the boundary of the patch, and `f32` guesses better.
const NEAR: u32 = 18;
/// Depths at which a pair is left whose features are apart around the whole interval.
const EARLY: [u32; 3] = [3, 8, 14];

/// log2 of a unit in which all components of the vectors of a query are below 1; [`NO_UNIT`] where
/// they may be above 2^64 or below 2^-63, since then something may have overflowed or been flushed.
/// `rounded`: the query in `f32`, with what coordinates are off by.
#[inline(always)]
pub fn unit(rounded: &Motion<f32>) -> i32 {
    let [a, b, c] = rounded.magnitudes();
    // Two roundings make the greatest too small, by less than 4 units in the last place.
    let biased = ((a.max(b).max(c).to_bits() + 4) >> 23) as i32;
    if biased >= 64 && biased <= 190 { biased - 126 } else { NO_UNIT }
}

/// No unit, see [`unit()`].
pub const NO_UNIT: i32 = i32::MAX;

/// The vectors of a query, of its points at both times.
#[inline(always)]
fn vectors(patch: Patch, [p, q, r, s]: &[Ends; 4]) -> Vectors {
    let less = |p: &Ends, q: &Ends| [minus(p[0], q[0]), minus(p[1], q[1])];
    match patch {
        Patch::Triangle => [less(p, q), less(r, q), less(s, q)],
        Patch::Parallelogram => [less(r, p), less(q, p), less(r, s)],
    }
}

/// Where the vector is over an interval.
#[derive(Clone, Copy, PartialEq, Eq)]
#[repr(u32)]
enum Place {
    Inside,
    Outside,
    Unknown,
}

/// Where `a` is in the patch of `b` and `c` all over `[from, from + 2^-depth]`.
///
/// As `containment.rs`: two-dimensional determinants along the axis in which the normal is
/// greatest, about. A component at `from` is off by `3 u`, and changes in the interval by at most
/// the `travel` of its vector; a determinant of two vectors of components up to 1/4, with products
/// off by `5 u` each, by half of both travels and `17 u`.
#[inline(always)]
fn place(vectors: &Vectors, patch: Patch, from: u32, depth: u32) -> Place {
    let along = axis_of_normal(vectors, from);
    // No index that is computed: arrays of a shader would be in memory then.
    let pick = |v: [Q62; 3]| {
        if along == 0 {
            [v[1], v[2]]
        } else if along == 1 {
            [v[2], v[0]]
        } else {
            [v[0], v[1]]
        }
    };
    let at = |[x0, x1]: [[Q62; 2]; 2]| [x0[0].towards(x1[0], from), x0[1].towards(x1[1], from)];
    // The difference is off by 4 u, a component by 3 u; and the shift rounds down.
    let travel = |[x0, x1]: [[Q62; 2]; 2]| {
        let greatest = x1[0].minus(x0[0]).abs().max(x1[1].minus(x0[1]).abs());
        greatest.plus(Q62::of_units(4)).shifted_down(depth).plus(Q62::of_units(4))
    };
    let [a, b, c] = *vectors;
    let (a, b, c) = ([pick(a[0]), pick(a[1])], [pick(b[0]), pick(b[1])], [pick(c[0]), pick(c[1])]);
    let [of_a, of_b, of_c] = [travel(a), travel(b), travel(c)];
    let (a, b, c) = (at(a), at(b), at(c));
    let error = |p: Q62, q: Q62| p.plus(q).shifted_down(1).plus(Q62::of_units(17));
    let (d_error, s_error, r_error) = (error(of_b, of_c), error(of_a, of_c), error(of_a, of_b));
    let d = det(b, c);
    if !d.abs().is_above(d_error) {
        return Place::Unknown;
    }
    let negative = d.is_negative();
    let d = d.negated_if(negative);
    let (s, r) = (det(a, c).negated_if(negative), det(b, a).negated_if(negative));
    let (third, third_error, fourth, fourth_error) = match patch {
        Patch::Triangle => {
            let rest = d.minus(s).minus(r);
            let error = d_error.plus(s_error).plus(r_error);
            (rest, error, rest, error)
        }
        Patch::Parallelogram => {
            (d.minus(s), d_error.plus(s_error), d.minus(r), d_error.plus(r_error))
        }
    };
    let is_outside = s.negated().is_above(s_error)
        || r.negated().is_above(r_error)
        || third.negated().is_above(third_error)
        || fourth.negated().is_above(fourth_error);
    let is_inside = s.is_above(s_error)
        && r.is_above(r_error)
        && third.is_above(third_error)
        && fourth.is_above(fourth_error);
    if is_outside {
        Place::Outside
    } else if is_inside {
        Place::Inside
    } else {
        Place::Unknown
    }
}

/// The axis along which the normal of `b` and `c` is greatest at `from`, by `f32`: another one does
/// as well, if its determinant is certain.
#[inline(always)]
fn axis_of_normal([_, b, c]: &Vectors, from: u32) -> u32 {
    let t = from as f32 / (1u32 << DEPTH) as f32;
    let at = |[x0, x1]: &Ends| {
        let at = |x: Q62, y: Q62| {
            let (x, y) = (x.approximate(), y.approximate());
            x + (y - x) * t
        };
        [at(x0[0], x1[0]), at(x0[1], x1[1]), at(x0[2], x1[2])]
    };
    let [x, y, z] = vec3::cross(at(b), at(c));
    let (x, y, z) = (x.abs(), y.abs(), z.abs());
    if x > y && x > z {
        0
    } else if y > z {
        1
    } else {
        2
    }
}

/// Decides a query: contact as coplanarity and containment.
///
/// `points`: `v f0 f1 f2` or `ea0 ea1 eb0 eb1`, in the unit of [`unit()`].
#[inline(always)]
pub fn search(patch: Patch, points: &[Ends; 4], window: &Window) -> Found {
    let vectors = vectors(patch, points);
    let whole = coplanarity(&vectors);
    let finest = window.tolerance.leading_zeros().max(NEAR);
    // The interval [k, k + 1] 2^-depth, its ends, and the control values over it.
    let (mut k, mut depth, mut c) = (0, 0, whole);
    let mut signs = Signs::of(c);
    let (mut from, mut until) = (0, 0);
    // Whether the patch was looked at over it, and at its begin, if no sign is certain there;
    // whether a zero was guessed in it, or in an interval that it is a half of.
    let (mut looked, mut begun, mut guessed) = (false, false, false);
    // Whether signs have proved the guess; then the zero is in `zero`, and `c` is over that.
    let (mut located, mut zero) = (false, Part { begin: 0, end: 0, depth: 0 });
    let mut rounds = 0;
    while rounds < MAX_ROUNDS {
        // Threads of a device halve together, and then look together.
        let (mut is_over, mut once, mut begins, mut looks) = (false, false, false, located);
        while rounds < MAX_ROUNDS && !is_over && !looks {
            rounds += 1;
            let unit = DEPTH - depth;
            (from, until) = (k << unit, (k + 1) << unit);
            is_over = from > window.until || until < window.from || signs.have_no_zero();
            once = signs.have_one_zero();
            // Its first halves begin as it does, and are no surer.
            let is_unsure = signs.first() == 0 && from >= window.from;
            let is_early = depth == EARLY[0] || depth == EARLY[1] || depth == EARLY[2];
            begins = is_unsure && !begun;
            let may_look = depth == DEPTH || is_early || is_unsure || once && !guessed;
            looks = begins || may_look && !looked;
            if !is_over && !looks {
                // De Casteljau's triangle: halves share its last value.
                let (p, q, r) = (c[0].mean(c[1]), c[1].mean(c[2]), c[2].mean(c[3]));
                let (s, t) = (p.mean(q), q.mean(r));
                let middle = s.mean(t);
                (k, depth, looked) = (2 * k, depth + 1, false);
                let last = c[3];
                c = [c[0], p, s, middle];
                signs = Signs::of(c);
                if signs.have_no_zero() {
                    (k, begun) = (k + 1, false);
                    c = [middle, t, r, last];
                    signs = Signs::of(c);
                }
            }
        }
        if looks && !is_over {
            // The first interval that may have a zero begins where there certainly is none.
            let is_last = located || depth == DEPTH || signs.are_unknown();
            let mut part = Part { begin: from, end: until, depth };
            let mut crosses = signs.first() | signs.last() == 3;
            let guesses = !begins && (located || once && depth < finest);
            let reaches = !begins && !guesses && depth == DEPTH && !crosses && signs.first() != 0;
            (looked, begun) = (!begins, true);
            if begins {
                part = Part { begin: from, end: from + 1, depth: DEPTH };
            } else if guesses {
                let (of, to) = if located { (zero, DEPTH) } else { (part, finest) };
                zero = around_zero(of, guess(c), to);
                guessed = true;
            } else if reaches {
                // Where the sign after the zero is not certain, it may be within the tolerance.
                part.depth = window.tolerance.leading_zeros();
                part.end = from + (1 << (DEPTH - part.depth));
            }
            if guesses || reaches && part.end <= 1 << DEPTH {
                let (mut t, end, mut both) = if guesses {
                    (zero.begin, zero.end, 0)
                } else {
                    (part.end, part.end, signs.first())
                };
                for _ in 0..2 {
                    both |= sign(value(whole, t));
                    t = end;
                }
                crosses = both == 3;
            }
            if guesses {
                located = crosses;
                if located {
                    part = zero;
                }
            }
            let place = place(&vectors, patch, part.begin, part.depth);
            let (is_outside, is_inside) = (place == Place::Outside, place == Place::Inside);
            let is_beside = part.end < window.from || part.begin > window.until;
            let is_wanted = part.begin >= window.from && part.end <= window.until;
            let is_fine = part.end - part.begin <= window.tolerance;
            if begins {
                if !is_outside {
                    return if is_inside { Found::Tie } else { Found::Open };
                }
            } else if is_inside && crosses && is_wanted && is_fine {
                return Found::Hit(part.begin);
            } else {
                is_over = is_outside || located && is_beside;
                if is_last && !is_over {
                    return Found::Open;
                }
            }
        }
        let (mut first, mut last) = (zero.begin, zero.end);
        if is_over {
            // The next interval, as large as may be.
            (looked, begun, guessed, located) = (false, false, false, false);
            k += 1;
            let trailing_zeros = 31 - (k & k.wrapping_neg()).leading_zeros();
            let up = trailing_zeros.min(depth);
            (k, depth) = (k >> up, depth - up);
            if from > window.until || k == 1 && depth == 0 {
                return Found::Miss;
            }
            let unit = DEPTH - depth;
            (first, last) = (k << unit, (k + 1) << unit);
        }
        if is_over || located {
            c = over(whole, first, last);
            signs = Signs::of(c);
        }
    }
    Found::Open
}

#[cfg(test)]
mod tests;
