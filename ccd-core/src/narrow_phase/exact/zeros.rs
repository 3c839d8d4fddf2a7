//! Zeros of forms: each is a dyadic time, or the only one of a form without double zeros between
//! two dyadic times; and the signs of other forms there.
//!
//! ```text
//!   0 ------- x ------- 1/2 -- x -- x -- 1    as often as there are zeros in a part, or more by
//!        one change          two changes      an even number, coefficients over it change sign;
//!                        halved again         a part with several changes is halved
//! ```
//!
//! Isolation is by Descartes' rule of signs on halves [Collins 1976]; of a form without double
//! zeros changes fall to one or none. A sign at a zero between dyadic times is that of the
//! coefficients over the interval, once they agree; whether they never do is decided by a common
//! divisor of both forms.

use super::form::Form;
use super::integer::{Integer, parts, power_of_two};
use super::words::Words;

/// A cubic has no more, counted once each.
const MAX_ZEROS: usize = 3;

/// After this many looks without a sign it is tested whether a number is exactly 0.
const PATIENCE: u32 = 2;
/// A guess keeps two of `2^STEPS` equal parts of an interval.
const STEPS: u32 = 30;

/// `u` and `v` of a dyadic time; their sum is a power of two.
pub type Dyadic<W> = [Integer<W>; 2];

/// A time.
#[derive(Clone, Debug)]
pub enum Time<W> {
    /// A dyadic one.
    At(Dyadic<W>),
    /// The only zero of a form without double zeros within a part of the step.
    Between(Form<W>, Part<W>),
}

/// A part of the step between two dyadic times, whose sums of `u` and `v` are the same.
#[derive(Clone, Debug)]
pub struct Part<W> {
    ends: [Dyadic<W>; 2],
    /// The form whose zeros are looked for, over it; nothing of it is lost.
    local: Form<W>,
}

impl<W: Words> Part<W> {
    /// Another form over it.
    pub fn part(&self, form: &Form<W>) -> Form<W> {
        let [from, to] = &self.ends;
        form.over(from, to)
    }

    /// Half of the way.
    fn middle(&self) -> Dyadic<W> {
        let [from, to] = &self.ends;
        [&from[0] + &to[0], &from[1] + &to[1]]
    }

    /// From one of `2^bits` equal steps to another.
    fn within(&self, steps: [u64; 2], bits: u32) -> Option<Self> {
        let at = |k: u64| [(1 << bits) - k, k].map(|k| Integer::new(k as i64, 0));
        let [from, to] = &self.ends;
        let ends = steps.map(at);
        let local = self.local.over(&ends[0], &ends[1]).checked()?;
        let ends = ends.map(|[u, v]| [0, 1].map(|k| &from[k] * &u + &to[k] * &v));
        Some(Self { ends, local })
    }

    /// Both halves.
    fn halves(&self) -> Option<[Self; 2]> {
        Some([self.within([0, 1], 1)?, self.within([1, 2], 1)?])
    }
}

/// The sign of the difference of two times.
fn order<W: Words>(p: &Dyadic<W>, q: &Dyadic<W>) -> Option<i32> {
    let difference = &p[1] * &q[0] - &q[1] * &p[0];
    difference.is_exact().then(|| difference.sign())
}

/// Some zeros, in no order.
pub type Zeros<W> = [Option<Time<W>>; MAX_ZEROS];

fn push<W>(zeros: &mut Zeros<W>, time: Time<W>) {
    if let Some(next) = zeros.iter_mut().find(|zero| zero.is_none()) {
        *next = Some(time);
    }
}

/// The zeros in a window of a form of degree 1 to 3 that does not vanish; `None` if a number does
/// not fit.
pub fn zeros<W: Words>(form: &Form<W>, window: &Window<W>) -> Option<Zeros<W>> {
    let [begin, end] = &window.ends;
    let mut out = [const { None }; MAX_ZEROS];
    let part = window.part(form)?;
    let c = part.coefficients();
    if c[0].sign() == 0 {
        push(&mut out, Time::At(begin.clone()));
    }
    if c[part.degree()].sign() == 0 && !window.is_moment() {
        push(&mut out, Time::At(end.clone()));
    }
    if part.variations() == 0 {
        return Some(out);
    }
    let (inner, _) = form.without_ends();
    for factor in simple_factors(&inner.reduced())?.into_iter().flatten() {
        isolate(&factor, window, &mut out)?;
    }
    Some(out)
}

/// Bits from which on a common divisor costs less than it saves.
const LONG: u32 = 768;

/// Forms without double zeros that have the zeros of a form of degree 1 to 3, whose first and last
/// coefficients are not 0.
fn simple_factors<W: Words>(form: &Form<W>) -> Option<[Option<Form<W>>; 2]> {
    let k = |x: i64| Integer::<W>::new(x, 0);
    let linear = |c0: Integer<W>, c1: Integer<W>| Form::linear([c0, c1]).checked();
    match form.coefficients() {
        [c0, c1, c2] => {
            let discriminant = c1 * c1 - k(4) * c0 * c2;
            match discriminant.is_exact().then(|| discriminant.sign())? {
                0 => Some([linear(c1.clone(), k(2) * c2), None]),
                _ => Some([Some(form.clone()), None]),
            }
        }
        [d, c, b, a] => {
            // The zeros of a cubic with a double one are quotients of its coefficients.
            let discriminant = b * b * c * c + k(18) * a * b * c * d
                - k(4) * (a * c * c * c + b * b * b * d)
                - k(27) * a * a * d * d;
            let apart = b * b - k(3) * a * c;
            if !(discriminant.is_exact() && apart.is_exact()) {
                return None;
            }
            match (discriminant.sign(), apart.sign()) {
                (0, 0) => Some([linear(b.clone(), k(3) * a), None]),
                (0, _) => {
                    let twice = linear(b * c - k(9) * a * d, k(2) * &apart)?;
                    // A factor of the cubic has no more bits than the cubic, but these have three
                    // times as many, and more may not fit where another form is asked at the zero.
                    let once = [b * b * b + k(9) * a * a * d - k(4) * a * b * c, a * apart];
                    let is_long = once.iter().any(|c| c.bits() > LONG);
                    let [c0, c1] = if is_long { Integer::coprime(once) } else { once };
                    let once = linear(c0, c1)?;
                    Some([Some(twice), Some(once)])
                }
                _ => Some([Some(form.clone()), None]),
            }
        }
        _ => Some([Some(form.clone()), None]),
    }
}

/// Adds the zeros between the ends of a window of a form without double zeros.
fn isolate<W: Words>(form: &Form<W>, window: &Window<W>, out: &mut Zeros<W>) -> Option<()> {
    // Variations of both halves are at most those of the whole, three: one half has several.
    let mut open = Some(Part { ends: window.ends.clone(), local: window.part(form)? });
    while let Some(part) = open.take() {
        match part.local.variations() {
            0 => (),
            1 => push(out, Time::Between(form.clone(), part)),
            _ => {
                if part.local.sign_halfway()? == 0 {
                    push(out, Time::At(part.middle()));
                }
                let [first, second] = part.halves()?;
                let (few, many) = match second.local.variations() {
                    0 | 1 => (second, first),
                    _ => (first, second),
                };
                if few.local.variations() == 1 {
                    push(out, Time::Between(form.clone(), few));
                }
                open = Some(many);
            }
        }
    }
    Some(())
}

impl<W: Words> Time<W> {
    /// Halves the interval.
    fn halve(&mut self) -> Option<()> {
        if let Time::Between(_, part) = self {
            match part.local.sign_halfway()? {
                0 => *self = Time::At(part.middle()),
                s if s == part.local.first_sign() => *part = part.within([1, 2], 1)?,
                _ => *part = part.within([0, 1], 1)?,
            }
        }
        Some(())
    }

    /// Makes the interval shorter: two of `2^`[`STEPS`] parts, where exact signs confirm what
    /// rounded arithmetic guesses; else a half.
    pub fn narrow(&mut self) -> Option<()> {
        if let Time::Between(_, part) = self {
            let (steps, sign) = (1 << STEPS, part.local.first_sign());
            let step = (part.local.guess() * steps as f64 + 0.5) as u64;
            let around = part.within([step.saturating_sub(1), (step + 1).min(steps)], STEPS)?;
            // A time of few halves of the interval is found as it is.
            if 0 < step && step < steps && around.local.sign_halfway()? == 0 {
                *self = Time::At(around.middle());
                return Some(());
            }
            let c = around.local.coefficients();
            if [c[0].sign(), c[around.local.degree()].sign()] == [sign, -sign] {
                *part = around;
                return Some(());
            }
        }
        self.halve()
    }

    /// The dyadic times that it is between, or it itself twice.
    fn ends(&self) -> [&Dyadic<W>; 2] {
        match self {
            Time::At(time) => [time; 2],
            Time::Between(_, Part { ends: [from, to], .. }) => [from, to],
        }
    }

    /// Whether it is before another time; not if both are one.
    pub fn is_before(&mut self, other: &mut Self) -> Option<bool> {
        // One time is a zero of the form of the other; then only one of them is narrowed, to be
        // found in the interval of which the other is the only zero, or beside it.
        let shared = match (&mut *self, &mut *other) {
            (this, Time::Between(form, ..)) => this.sign(form)? == 0,
            (Time::Between(form, ..), time) => time.sign(form)? == 0,
            _ => false,
        };
        loop {
            let ([a, b], [c, d]) = (self.ends(), other.ends());
            let (before, after) = (order(b, c)?, order(d, a)?);
            if let (Time::At(_), Time::At(_)) = (&*self, &*other) {
                return Some(before < 0);
            }
            if before <= 0 {
                return Some(true);
            }
            let is_within = order(c, a)? <= 0 && order(b, d)? <= 0;
            let has_within = order(a, c)? <= 0 && order(d, b)? <= 0;
            let other_is_dyadic = matches!(other, Time::At(_));
            if after <= 0 || shared && (is_within || other_is_dyadic && has_within) {
                return Some(false);
            }
            self.narrow()?;
            if !shared {
                other.narrow()?;
            }
        }
    }

    /// The sign of a form at this time.
    pub fn sign(&mut self, of: &Form<W>) -> Option<i32> {
        if !of.is_exact() {
            return None;
        }
        let of = of.reduced();
        let mut turns = 0;
        loop {
            match self {
                Time::At(time) => {
                    let value = of.at(time);
                    return value.is_exact().then_some(value.sign());
                }
                Time::Between(form, part) => {
                    if let Some(sign) = part.part(&of).checked()?.sign() {
                        return Some(sign);
                    }
                    // It is 0 if the common divisor has a zero there, and that has one or none.
                    turns += 1;
                    if turns == PATIENCE {
                        let common = form.common(&of)?;
                        let local = part.part(&common).checked()?;
                        if local.variations() % 2 == 1 {
                            return Some(0);
                        }
                    }
                }
            }
            self.narrow()?;
        }
    }

    /// The time, rounded down and up.
    pub fn enclosure(&mut self) -> Option<[f64; 2]> {
        loop {
            let (form, Part { ends: [from, to], local }) = match self {
                Time::At(time) => return Window::rounded(time),
                Time::Between(form, part) => (form, part),
            };
            let [lo, hi] = [Window::rounded(from)?[0], Window::rounded(to)?[1]];
            let between = lo.next_up();
            if between >= hi {
                return Some([lo, hi]);
            }
            if between.next_up() >= hi {
                // One number in between: the zero is there, or on one side of it.
                let value = form.at(&Window::new([between; 2])?.begin());
                let sign = value.is_exact().then(|| value.sign())?;
                return Some(match sign {
                    0 => [between; 2],
                    _ if sign == local.first_sign() => [between, hi],
                    _ => [lo, between],
                });
            }
            self.narrow()?;
        }
    }
}

/// A window of time.
#[derive(Clone, Debug)]
pub struct Window<W> {
    ends: [Dyadic<W>; 2],
}

impl<W: Words> Window<W> {
    /// From one time of `[0, 1]` to another; `None` if a number does not fit, for signs of the ends
    /// are read below.
    pub fn new(times: [f64; 2]) -> Option<Self> {
        // The greatest power of two of which both are whole multiples.
        let unit = times.iter().map(|&t| parts(t).1).fold(0, i32::min);
        let one = Integer::new(1, unit.unsigned_abs());
        let ends = times.map(|t| Integer::of(t, unit)).map(|t| [&one - &t, t]);
        ends.as_flattened().iter().all(Integer::is_exact).then_some(Self { ends })
    }

    /// The first time.
    pub fn begin(&self) -> Dyadic<W> {
        self.ends[0].clone()
    }

    /// Whether it is one time alone.
    fn is_moment(&self) -> bool {
        let [begin, end] = &self.ends;
        (&begin[1] - &end[1]).sign() == 0
    }

    /// A form over the window alone; `None` if a number does not fit.
    pub fn part(&self, form: &Form<W>) -> Option<Form<W>> {
        let [begin, end] = &self.ends;
        let is_step = begin[1].sign() == 0 && end[0].sign() == 0;
        if is_step { form.clone().checked() } else { form.over(begin, end).checked() }
    }

    /// A time, rounded down and up.
    fn rounded([u, v]: &Dyadic<W>) -> Option<[f64; 2]> {
        let one = u + v;
        if !(one.is_exact() && v.is_exact()) {
            return None;
        }
        if v.sign() == 0 {
            return Some([0.0; 2]);
        }
        let (mantissa, more, exponent) = v.leading();
        let exponent = exponent as i32 - (one.bits() - 1) as i32;
        // Of a denormal, fewer bits.
        let dropped = (LEAST - exponent).clamp(0, 63) as u32;
        let (kept, more) = (mantissa >> dropped, more || mantissa & ((1 << dropped) - 1) != 0);
        let value = if dropped > 0 {
            f64::from_bits(kept)
        } else {
            // Two steps, of which each is exact.
            let half = exponent / 2;
            kept as f64 * power_of_two(half) * power_of_two(exponent - half)
        };
        Some([value, if more { value.next_up() } else { value }])
    }
}

/// The power of two of the last bit of a denormal.
const LEAST: i32 = -1074;
