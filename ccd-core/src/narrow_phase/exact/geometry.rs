//! How features meet at a decided contact: weights and normal at the true time, each rounded once.
//!
//! With `a = s b + r c` and `n = b x c`, the weights are quotients of quartic forms: `s` is
//! `(a x c) . n / n . n`, `r` is `(b x a) . n / n . n`, and the rest to 1 is a form too. Which of
//! them are exactly 0 or 1 is a sign at the time of contact. The others come of an interval of time
//! that is halved until forms over it differ by `2^-62` of themselves, which ends, because they are
//! not 0 there.
//!
//! The side of the normal is that from which `a` comes: the sign of coplanarity just before the
//! contact, so the opposite of its first derivative that is not 0 there, or the same if that is the
//! second. As the first derivative is the relative velocity times the normal, that velocity is
//! never along it. No patch is too thin for this.
//!
//! Asked first is double-double with bounds (`ball.rs`): it has all of this nearly always where the
//! contact is inside of both features and passes through, as most do.

use super::ball::{self, Ball};
use super::features::Features;
use super::form::Form;
use super::integer::{Integer, power_of_two};
use super::vector::Number;
use super::words::{Longest, Words};
use super::zeros::{Time, Window, zeros};
use super::{
    at_begin_of, checked, moment, moving_features, never_zero, refine, searching, units, vectors,
};
use crate::math::expansion;
use crate::math::vec3::max_abs;
use crate::narrow_phase::contact_geometry::unit_vector;
use crate::narrow_phase::query::search;
use crate::narrow_phase::relative_motion::{Motion, Patch};
use crate::narrow_phase::search::Verdict;

/// How features meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// Of `v f0 f1 f2` or `ea0 ea1 eb0 eb1`; each within 0.51 units in the last place.
    pub weights: [f64; 4],
    /// From `b` towards `a`, in unit length to four units of roundoff; `None` of what is coplanar
    /// all the time.
    pub normal: Option<[f64; 3]>,
}

/// How features meet at a contact whose time, rounded down, is `toi`. `None` if there is no contact
/// before the next `f64`, if weights are not unique because the patch has no area or edges are
/// parallel then, and where [`vertex_face`](super::vertex_face) is `None`.
pub fn meeting(patch: Patch, x: [&[[f64; 3]; 4]; 2], toi: f64) -> Option<Meeting> {
    let window = [toi, toi.next_up().min(1.0)];
    let moderate = checked([x[0], x[1]], window)?;
    if moderate {
        if let Some(found) = by_pairs(patch, x, window) {
            return found;
        }
        let motion = Motion::new(patch, x[0], x[1], 0.0);
        if search(&motion, patch, &searching(window)).verdict == Verdict::Miss {
            return None;
        }
    }
    // At an end of the step that takes integers of the coordinates alone, as it has no unit.
    let at_begin = at_begin_of(x, window).and_then(|x| moment::touch(patch, x));
    let window = if at_begin == Some(true) { [toi; 2] } else { window };
    by_integers::<[u64; 8]>(patch, x, window)
        .or_else(|| by_integers::<[u64; 24]>(patch, x, window))
        .or_else(|| by_integers::<Longest>(patch, x, window))
        .flatten()
}

/// In double-double; `None` if that does not tell all of it.
fn by_pairs(
    patch: Patch,
    [t0, t1]: [&[[f64; 3]; 4]; 2],
    window: [f64; 2],
) -> Option<Option<Meeting>> {
    let zero = refine::zero(vectors(patch, [t0, t1]), window)?;
    if !zero.is_between(window)? {
        return Some(None);
    }
    let time = Ball::sum(zero.t, zero.correction).off_by(zero.off);
    let there = Features::new(patch, &[0, 1, 2, 3].map(|i| ball::at(&t0[i], &t1[i], &time)));
    let [s, r, one] = there.weights();
    let rest = one.minus(&s);
    // That none is 0 also shows that features touch.
    let weight = |of: Ball| of.quotient(&one);
    let weights = match patch {
        Patch::Triangle => [1.0, weight(rest.minus(&r))?, weight(s)?, weight(r)?],
        Patch::Parallelogram => [weight(rest)?, weight(s)?, weight(one.minus(&r))?, weight(r)?],
    };
    let n = there.normal().map(|n| n.rounded());
    if !there.normal().iter().all(|x| x.is_tight(max_abs(n))) {
        return None;
    }
    let before = if zero.rises { -1 } else { 1 };
    let side = before * towards(patch);
    Some(Some(Meeting { weights, normal: Some(unit_vector(n).map(|x| side as f64 * x)) }))
}

/// From the patch to `a`: for edges that is from the first to the second.
fn towards(patch: Patch) -> i32 {
    if patch == Patch::Triangle { 1 } else { -1 }
}

/// Within as many words as there are; `None` if they are too few.
fn by_integers<W: Words>(
    patch: Patch,
    ends: [&[[f64; 3]; 4]; 2],
    window: [f64; 2],
) -> Option<Option<Meeting>> {
    let features = moving_features(patch, ends);
    let window = Window::<W>::new(window)?;
    let coplanarity = features.coplanarity().checked()?;
    let part = window.part(&coplanarity)?;
    if never_zero(&part) {
        return Some(None);
    }
    let mut time = Time::At(window.begin());
    let mut first = None;
    if part.coefficients()[0].sign() == 0 && features.touch(&mut |form| time.sign(form))? {
        first = Some(time);
    } else if !coplanarity.vanishes() {
        for zero in zeros(&coplanarity, &window)?.iter_mut().flatten() {
            if features.touch(&mut |form| zero.sign(form))? {
                first = Some(earlier(first, zero)?);
            }
        }
    } else {
        // What is coplanar all the time first touches in the boundary, where weights are forms too.
        for edge in features.boundary() {
            for zero in zeros(edge.zero_at_contact(), &window)?.iter_mut().flatten() {
                if edge.touches(&mut |form| zero.sign(form))? {
                    first = Some(earlier(first, zero)?);
                }
            }
        }
    }
    let Some(mut time) = first else { return Some(None) };
    let mut is_zero = [false; 3];
    for (k, n) in features.normal().iter().enumerate() {
        is_zero[k] = time.sign(n)? == 0;
    }
    if is_zero == [true; 3] {
        return Some(None);
    }
    let [s, r, one] = features.weights();
    let rest = one.minus(&s);
    let weights = match patch {
        Patch::Triangle => {
            let [w0, w1, w2] = quotients(&mut time, [&rest.minus(&r), &s, &r], &one)?;
            [1.0, w0, w1, w2]
        }
        Patch::Parallelogram => quotients(&mut time, [&rest, &s, &one.minus(&r), &r], &one)?,
    };
    let side = towards(patch) * side_before(&mut time, coplanarity)?;
    let normal = match side {
        0 => None,
        _ => {
            let units = units(ends.into_iter().flatten());
            let n = direction(&mut time, features.normal(), is_zero, units)?;
            Some(n.map(|x| if side > 0 { x } else { -x }))
        }
    };
    Some(Some(Meeting { weights, normal }))
}

/// The earlier of two times: between a time rounded down and the next one features may touch more
/// than once.
fn earlier<W: Words>(first: Option<Time<W>>, time: &mut Time<W>) -> Option<Time<W>> {
    let Some(mut first) = first else { return Some(time.clone()) };
    Some(if time.is_before(&mut first)? { time.clone() } else { first })
}

/// The sign that a form has just before one of its zeros; 0 of what vanishes.
fn side_before<W: Words>(time: &mut Time<W>, form: Form<W>) -> Option<i32> {
    let (mut derivative, mut sign) = (form, 1);
    while derivative.degree() > 0 {
        (derivative, sign) = (derivative.derivative(), -sign);
        let there = time.sign(&derivative)?;
        if there != 0 {
            return Some(sign * there);
        }
    }
    Some(0)
}

/// Quotients of forms of one degree, in `[0, 1]`, at a time.
fn quotients<W: Words, const K: usize>(
    time: &mut Time<W>,
    of: [&Form<W>; K],
    by: &Form<W>,
) -> Option<[f64; K]> {
    let mut out = [0.0; K];
    for (out, of) in out.iter_mut().zip(of) {
        if time.sign(of)? > 0 {
            let [value, one] = values(time, [of, by])?;
            *out = quotient(&value, &one).min(1.0);
        }
    }
    Some(out)
}

/// Values of forms of one degree at a time at which none is 0, all times one positive number, each
/// off by at most `2^-62` of itself.
fn values<W: Words, const K: usize>(
    time: &mut Time<W>,
    forms: [&Form<W>; K],
) -> Option<[Integer<W>; K]> {
    loop {
        let mut out = [const { Integer::ZERO }; K];
        let mut tight = true;
        for (out, form) in out.iter_mut().zip(forms) {
            let [least, most] = match time {
                Time::At(time) => {
                    let value = form.at(time);
                    [value.clone(), value]
                }
                Time::Between(_, part) => part.part(form).range(),
            };
            let width = &most - &least;
            if !(least.is_exact() && width.is_exact()) {
                return None;
            }
            let same = least.sign() * most.sign() > 0;
            tight &= same && (width.sign() == 0 || width.bits() + 62 < least.bits());
            *out = least;
        }
        if tight {
            return Some(out);
        }
        time.narrow()?;
    }
}

/// The quotient of two positive numbers, to 0.51 units in the last place if that is a normal one.
fn quotient<W: Words>(of: &Integer<W>, by: &Integer<W>) -> f64 {
    let ([p, p_low], p_unit) = of.in_two();
    let ([q, q_low], q_unit) = by.in_two();
    let first = p / q;
    let (product, below) = expansion::product(first, q);
    let rest = (p - product) - below + (p_low - first * q_low);
    scaled(first + rest / q, p_unit - q_unit)
}

/// `x * 2^e`, in steps that are no power too large; 0 of what is tiny.
fn scaled(mut x: f64, mut e: i32) -> f64 {
    while e != 0 && x != 0.0 {
        let step = e.clamp(-1000, 1000);
        x *= power_of_two(step);
        e -= step;
    }
    x
}

/// The direction of a vector of forms, of which not all are 0: what is computed in a unit of each
/// axis, in one unit again.
fn direction<W: Words>(
    time: &mut Time<W>,
    n: &[Form<W>; 3],
    is_zero: [bool; 3],
    units: [i32; 3],
) -> Option<[f64; 3]> {
    // What is 0 stands for another one, to be left out.
    let known = is_zero.iter().position(|&is_zero| !is_zero)?;
    let value = values(time, [0, 1, 2].map(|k| &n[if is_zero[k] { known } else { k }]))?;
    let part = |k: usize| {
        let ([x, _], unit) = value[k].in_two();
        // Where an axis has no unit, only the normal along it is not 0.
        (
            if value[k].sign() < 0 { -x } else { x },
            unit - if units[k] == i32::MAX { 0 } else { units[k] },
        )
    };
    let parts = [0, 1, 2].map(part);
    let most = (0..3).filter(|&k| !is_zero[k]).map(|k| parts[k].1).max()?;
    Some(unit_vector([0, 1, 2].map(|k| {
        let (x, unit) = parts[k];
        if is_zero[k] { 0.0 } else { scaled(x, unit - most) }
    })))
}
