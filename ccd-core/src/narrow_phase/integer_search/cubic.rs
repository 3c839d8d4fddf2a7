//! The cubic of coplanarity in fixed point: its control values over parts of the step, and what
//! their signs say of its zeros.
//!
//! # Bounds
//! Components are up to 1/4, and off by `2 u` (two operands, cut); a product is off by less than
//! `5 u`, so with those of its factors by `6 u` where both are vectors.
//!
//! | value | at most | error |
//! |---|---|---|
//! | component of a cross product | 1/8 | `2 x 6 u` |
//! | the same of mixed ends, a sum of two | 1/4 | `24 u` |
//! | `3 f(0)`, `3 f(1)` | 9/32 | `3 x 3 (12 / 4 + 2 / 8 + 5) u < 75 u` |
//! | three times the others | 9/32 | `3 (8.25 + 24 / 4 + 2 / 4 + 5) u < 60 u` |
//!
//! A halving adds `1.5 u` (three means, each up to `u / 2` too low), 31 of them `46.5 u`, and the
//! values of another interval, or at a time, `3 u` (three interpolations): below `128 u` together
//! (`BAND`).

use crate::math::q62::Q62;

/// What a control value may be off by, in units of [`Q62`].
pub const BAND: u32 = 128;
/// Halvings of the step, after which an interval is a unit of time.
pub const DEPTH: u32 = 31;

/// A point or a vector at the start and the end of the step.
pub type Ends = [[Q62; 3]; 2];
/// Three vectors.
pub type Vectors = [Ends; 3];

/// `p - q`
#[inline(always)]
pub fn minus(p: [Q62; 3], q: [Q62; 3]) -> [Q62; 3] {
    [p[0].minus(q[0]), p[1].minus(q[1]), p[2].minus(q[2])]
}

#[inline(always)]
fn cross2(p: [Q62; 3], q: [Q62; 3], i: usize, j: usize) -> Q62 {
    p[i].times(q[j]).minus(p[j].times(q[i]))
}

/// `p x q`
#[inline(always)]
pub fn cross(p: [Q62; 3], q: [Q62; 3]) -> [Q62; 3] {
    [cross2(p, q, 1, 2), cross2(p, q, 2, 0), cross2(p, q, 0, 1)]
}

#[inline(always)]
fn dot(p: [Q62; 3], q: [Q62; 3]) -> Q62 {
    p[0].times(q[0]).plus(p[1].times(q[1])).plus(p[2].times(q[2]))
}

#[inline(always)]
fn plus(p: [Q62; 3], q: [Q62; 3]) -> [Q62; 3] {
    [p[0].plus(q[0]), p[1].plus(q[1]), p[2].plus(q[2])]
}

/// Three times the Bernstein control values of the cubic of coplanarity.
#[inline(always)]
pub fn coplanarity([a, b, c]: &Vectors) -> [Q62; 4] {
    let (n00, n11) = (cross(b[0], c[0]), cross(b[1], c[1]));
    let n01 = plus(cross(b[0], c[1]), cross(b[1], c[0]));
    let thrice = |x: Q62| x.plus(x).plus(x);
    [
        thrice(dot(a[0], n00)),
        dot(a[1], n00).plus(dot(a[0], n01)),
        dot(a[0], n11).plus(dot(a[1], n01)),
        thrice(dot(a[1], n11)),
    ]
}

/// 1: certainly above 0, 2: certainly below, 0: neither.
#[inline(always)]
pub fn sign(x: Q62) -> u32 {
    let band = Q62::of_units(BAND);
    if !x.abs().is_above(band) {
        0
    } else if x.is_negative() {
        2
    } else {
        1
    }
}

/// Whether all control values certainly have one sign.
#[inline(always)]
pub fn has_no_zero(c: [Q62; 4]) -> bool {
    sign(c[0]) & sign(c[1]) & sign(c[2]) & sign(c[3]) != 0
}

/// The control values of a cubic over `[from, until]`, of those over the step: value `i` is the
/// blossom at `from`, 3 - i times, and `until`, i times.
#[inline(always)]
pub fn over(c: [Q62; 4], from: u32, until: u32) -> [Q62; 4] {
    let two = |c: [Q62; 3], t| [c[0].towards(c[1], t), c[1].towards(c[2], t)];
    let three = |t| [c[0].towards(c[1], t), c[1].towards(c[2], t), c[2].towards(c[3], t)];
    let (early, late) = (three(from), three(until));
    let (p, q, r) = (two(early, from), two(early, until), two(late, until));
    [
        p[0].towards(p[1], from),
        p[0].towards(p[1], until),
        q[0].towards(q[1], until),
        r[0].towards(r[1], until),
    ]
}

/// The value of a cubic at a time, of its control values over the step.
#[inline(always)]
pub fn value(c: [Q62; 4], t: u32) -> Q62 {
    let (p, q, r) = (c[0].towards(c[1], t), c[1].towards(c[2], t), c[2].towards(c[3], t));
    p.towards(q, t).towards(q.towards(r, t), t)
}

/// Whether a cubic certainly has one zero between the ends: the signs of its control values are
/// certain and change once, those at the ends being two different ones.
#[inline(always)]
pub fn has_one_zero(c: [Q62; 4]) -> bool {
    let (p, q, r, s) = (sign(c[0]), sign(c[1]), sign(c[2]), sign(c[3]));
    p | s == 3 && (q == p && r != 0 || r == s && q != 0)
}

/// A part of the step.
#[derive(Clone, Copy)]
pub struct Part {
    /// Its first time.
    pub begin: u32,
    /// Its last time.
    pub end: u32,
    /// It is no longer than 2^-`depth` of the step.
    pub depth: u32,
}

/// About how far into an interval the zero of a cubic that has one there is: by Newton's method in
/// `f32`, which devices round differently. A step that would leave what signs say of the zero goes
/// to the middle of that.
#[inline(always)]
pub fn guess(c: [Q62; 4]) -> f32 {
    let c = [c[0].approximate(), c[1].approximate(), c[2].approximate(), c[3].approximate()];
    let between = |a: f32, b: f32, t: f32| a + (b - a) * t;
    let (mut low, mut high) = (0.0, 1.0);
    let mut t = c[0] / (c[0] - c[3]);
    for _ in 0..6 {
        let (p, q, r) = (between(c[0], c[1], t), between(c[1], c[2], t), between(c[2], c[3], t));
        let (p, q) = (between(p, q, t), between(q, r, t));
        let value = between(p, q, t);
        if (value < 0.0) == (c[0] < 0.0) {
            low = t;
        } else {
            high = t;
        }
        // Of NaN, the middle.
        let next = t - value / (3.0 * (q - p));
        t = if next >= low && next <= high { next } else { 0.5 * (low + high) };
    }
    t
}

/// A short part of an interval around where its only zero seems to be, `guess` of the interval
/// after its begin; and whether signs certainly differ at its ends, so that it is in between.
#[inline(always)]
pub fn around_zero(whole: [Q62; 4], of: Part, guess: f32, depth: u32) -> (Part, bool) {
    let (step, length) = (1 << (DEPTH - depth), of.end - of.begin);
    // Whatever the guess is, this is in the interval.
    let way = ((guess * length as f32) as u32).min(length);
    let begin = of.begin + way - (step / 2).min(way);
    let end = (begin + step).min(of.end);
    let differ = sign(value(whole, begin)) | sign(value(whole, end)) == 3;
    (Part { begin, end, depth }, differ)
}
