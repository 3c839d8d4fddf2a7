//! Weights and normals of contacts, judged at the true time without rounding.

use super::zeros::{Place, Poly, Q, places};
use super::{Vector, cross, dot, exact, minus, points, whole};
use num_bigint::BigInt;
use num_traits::Signed;

/// Units in the last place by which a weight may be off.
const WEIGHT: f64 = 0.51;
/// How far quotients of components of a normal may be off.
const DIRECTION: f64 = 8.0 * f64::EPSILON;

/// Features in contact, `a = s b + r c`, as polynomials of time.
struct Meeting {
    /// 0 when coplanar.
    cubic: Poly,
    normal: Vector,
    /// Of each weight, and what they are to be divided by.
    weights: Vec<Poly>,
    one: Poly,
    /// Of the direction from `b` to `a`, in terms of the normal.
    towards: i32,
}

/// What is wrong with the geometry of `v f0 f1 f2`, or of two edges `ea0 ea1 eb0 eb1`, at a contact
/// whose time, rounded down, is `toi`: weights, each within 0.51 units in the last place; the
/// normal's side, that from which the first feature comes; its direction. `false` of what is not
/// judged, because it is coplanar all the time or has no normal then.
///
/// # Errors
/// What is wrong, in words.
pub fn meet(
    edges: bool,
    [t0, t1]: [&[[f64; 3]; 4]; 2],
    toi: f64,
    weights: [f64; 4],
    normal: [f64; 3],
) -> Result<bool, String> {
    let meeting = Meeting::new(edges, &points(t0, t1));
    if meeting.cubic.is_zero() {
        return Ok(false);
    }
    let window = [toi, toi.next_up().min(1.0)].map(exact);
    let zeros = places(&meeting.cubic, &window);
    let mut wrong = String::from("no contact at that time");
    for place in &zeros {
        if place.sign(&meeting.one) == 0 {
            return Ok(false);
        }
        match meeting.check(place, &weights[if edges { 0 } else { 1 }..], normal) {
            Ok(()) => return Ok(true),
            Err(what) => wrong = what,
        }
    }
    Err(wrong)
}

impl Meeting {
    fn new(edges: bool, x: &[Vector; 4]) -> Self {
        let [p, q, u, v] = x;
        let (a, b, c) = if edges {
            (minus(u, p), minus(q, p), minus(u, v))
        } else {
            (minus(p, q), minus(u, q), minus(v, q))
        };
        // By normal equations.
        let (bb, bc, cc) = (dot(&b, &b), dot(&b, &c), dot(&c, &c));
        let (ab, ac) = (dot(&a, &b), dot(&a, &c));
        let by = |p: Poly, q: Poly| p.plus(&q, -1);
        let s = by(ab.times(&cc), ac.times(&bc));
        let r = by(ac.times(&bb), ab.times(&bc));
        let one = by(bb.times(&cc), bc.times(&bc));
        let rest = one.plus(&s, -1);
        let weights =
            if edges { vec![rest, s, one.plus(&r, -1), r] } else { vec![rest.plus(&r, -1), s, r] };
        let normal = cross(&b, &c);
        let cubic = dot(&a, &normal);
        Self { cubic, normal, weights, one, towards: if edges { -1 } else { 1 } }
    }

    fn check(&self, place: &Place, weights: &[f64], normal: [f64; 3]) -> Result<(), String> {
        for (i, (&w, value)) in weights.iter().zip(&self.weights).enumerate() {
            let slack = exact(w.next_up() - w) * exact(WEIGHT);
            let beside = |slack: Q| place.sign(&value.minus_times(&(exact(w) + slack), &self.one));
            let is_right = if w == 0.0 {
                place.sign(value) == 0
            } else {
                beside(-slack.clone()) >= 0 && beside(slack) <= 0
            };
            if !is_right {
                return Err(format!("weight {i} of {weights:?}"));
            }
        }
        // No other zero is between the place and the time before it.
        let before = self.cubic.at(place.before());
        let before = before.is_positive() as i32 - before.is_negative() as i32;
        let zero = Poly::new(Vec::new());
        let [[given], _] = whole([&[normal]; 2]);
        let times = |k: usize| self.normal[k].times(&Poly::new(vec![given[k].clone()]));
        let along = (0..3).fold(zero, |sum, k| sum.plus(&times(k), 1));
        if place.sign(&along) != before * self.towards {
            return Err(format!("the side of {normal:?}"));
        }
        let m = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).expect("three");
        let sign = place.sign(&self.normal[m]);
        for k in 0..3 {
            let beside = |slack: f64| {
                let ratio = exact(normal[k]) / exact(normal[m]) + exact(slack);
                sign * place.sign(&self.normal[k].minus_times(&ratio, &self.normal[m]))
            };
            if beside(-DIRECTION) < 0 || beside(DIRECTION) > 0 {
                return Err(format!("the direction of {normal:?}"));
            }
        }
        Ok(())
    }
}

impl Poly {
    /// This less a number times another, all times the number's denominator, which is positive.
    fn minus_times(&self, by: &Q, other: &Self) -> Self {
        let times = |n: &BigInt| Self::new(vec![n.clone()]);
        self.times(&times(by.denom())).plus(&other.times(&times(by.numer())), -1)
    }
}
