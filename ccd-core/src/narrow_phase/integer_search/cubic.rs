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

/// The determinant of two vectors of a plane.
#[inline(always)]
pub fn det(p: [Q62; 2], q: [Q62; 2]) -> Q62 {
    p[0].times(q[1]).minus(p[1].times(q[0]))
}

/// The first component of `p x q`.
#[inline(always)]
fn cross_x(p: [Q62; 3], q: [Q62; 3]) -> Q62 {
    det([p[1], p[2]], [q[1], q[2]])
}

/// The vector with its second component first.
#[inline(always)]
fn turned([x, y, z]: [Q62; 3]) -> [Q62; 3] {
    [y, z, x]
}

/// Three times the Bernstein control values of the cubic of coplanarity. An axis after the other,
/// because a kernel takes as long to compile as it has products.
#[inline(always)]
pub fn coplanarity(vectors: &Vectors) -> [Q62; 4] {
    let [mut a, mut b, mut c] = *vectors;
    let mut sums = [Q62::ZERO; 4];
    for _ in 0..3 {
        let (n00, n11) = (cross_x(b[0], c[0]), cross_x(b[1], c[1]));
        let n01 = cross_x(b[0], c[1]).plus(cross_x(b[1], c[0]));
        let (a0, a1) = (a[0][0], a[1][0]);
        sums[0] = sums[0].plus(a0.times(n00));
        sums[1] = sums[1].plus(a1.times(n00)).plus(a0.times(n01));
        sums[2] = sums[2].plus(a0.times(n11)).plus(a1.times(n01));
        sums[3] = sums[3].plus(a1.times(n11));
        a = [turned(a[0]), turned(a[1])];
        b = [turned(b[0]), turned(b[1])];
        c = [turned(c[0]), turned(c[1])];
    }
    let thrice = |x: Q62| x.plus(x).plus(x);
    [thrice(sums[0]), sums[1], sums[2], thrice(sums[3])]
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

/// The signs of four control values, of which the first has the lowest bits.
#[derive(Clone, Copy)]
pub struct Signs(u32);

impl Signs {
    /// The [`sign`] of each.
    #[inline(always)]
    pub fn of(c: [Q62; 4]) -> Self {
        Self(sign(c[0]) | sign(c[1]) << 2 | sign(c[2]) << 4 | sign(c[3]) << 6)
    }

    /// That of the first value.
    #[inline(always)]
    pub fn first(self) -> u32 {
        self.0 & 3
    }

    /// That of the last value.
    #[inline(always)]
    pub fn last(self) -> u32 {
        self.0 >> 6
    }

    /// Whether none is certain.
    #[inline(always)]
    pub fn are_unknown(self) -> bool {
        self.0 == 0
    }

    /// Whether all control values certainly have one sign.
    #[inline(always)]
    pub fn have_no_zero(self) -> bool {
        self.0 == 0x55 || self.0 == 0xaa
    }

    /// Whether a cubic certainly has one zero between the ends: the signs of its control values are
    /// certain and change once, those at the ends being two different ones.
    #[inline(always)]
    pub fn have_one_zero(self) -> bool {
        // As if the first were above 0; an uncertain one becomes 3.
        let turned = if self.first() == 1 { self.0 } else { self.0 ^ 0xff };
        turned == 0x95 || turned == 0xa5 || turned == 0xa9
    }
}

/// The control values of a cubic over `[from, until]`, of those over the step: value `i` is the
/// blossom at `from`, 3 - i times, and `until`, i times.
#[inline(always)]
pub fn over(c: [Q62; 4], from: u32, until: u32) -> [Q62; 4] {
    let mut values = [Q62::ZERO; 4];
    let mut times = [from; 3];
    for _ in 0..4 {
        values = [values[1], values[2], values[3], blossom(c, times)];
        times = [times[1], times[2], until];
    }
    values
}

#[inline(always)]
fn blossom(c: [Q62; 4], [r, s, t]: [u32; 3]) -> Q62 {
    let (p, q, o) = (c[0].towards(c[1], r), c[1].towards(c[2], r), c[2].towards(c[3], r));
    p.towards(q, s).towards(q.towards(o, s), t)
}

/// The value of a cubic at a time, of its control values over the step.
#[inline(always)]
pub fn value(c: [Q62; 4], t: u32) -> Q62 {
    blossom(c, [t; 3])
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
/// after its begin.
#[inline(always)]
pub fn around_zero(of: Part, guess: f32, depth: u32) -> Part {
    let (step, length) = (1 << (DEPTH - depth), of.end - of.begin);
    // Whatever the guess is, this is in the interval. By its bits, because a compiler may take it
    // for a number, and what becomes of NaN as an integer is for each device to say.
    let guess = if guess.to_bits() <= 1f32.to_bits() { guess } else { 0.5 };
    let way = ((guess * length as f32) as u32).min(length);
    let begin = of.begin + way - (step / 2).min(way);
    let end = (begin + step).min(of.end);
    Part { begin, end, depth }
}
