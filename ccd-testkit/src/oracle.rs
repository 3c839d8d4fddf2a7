//! The exact answer of a query in integers: nothing is rounded, nothing is shared with the code
//! under test. Coordinates are multiples of a power of two, and ends of intervals of a power of
//! 1/7; signs alone matter, so both are left out and nothing is divided.
//!
//! Roots of the coplanarity cubic are isolated by sign variations of exact Bernstein coefficients;
//! at each, the containment conditions are decided by the signs of exact polynomials over the
//! isolating interval, which is divided until they are certain. Queries where that never ends
//! (contact exactly on a boundary, coplanar motion, double roots) are reported as degenerate: the
//! published ground truth covers those.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Float, One, Signed, ToPrimitive, Zero};

/// Exact answer of a query.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// No contact in `[0, 1]`.
    Free,
    /// The earliest contact lies in this interval, at most 2^-60 wide (rounded to `f64`).
    Contact(f64, f64),
    /// Not decided by this oracle.
    Degenerate,
}

type Poly = Vec<BigInt>;

/// Vertex-face: `v f0 f1 f2`.
pub fn vertex_face(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4]) -> Answer {
    let t = whole([t0, t1]);
    let d = |i: usize, j: usize| difference(&t, i, j);
    decide(d(0, 1), d(2, 1), d(3, 1), true)
}

/// Edge-edge: `ea0 ea1 eb0 eb1`.
pub fn edge_edge(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4]) -> Answer {
    let t = whole([t0, t1]);
    let d = |i: usize, j: usize| difference(&t, i, j);
    decide(d(2, 0), d(1, 0), d(2, 3), false)
}

/// Coordinates of points at both ends.
type Whole<const K: usize> = [[[BigInt; 3]; K]; 2];

/// Coordinates as multiples of a power of two.
pub(crate) fn whole<const K: usize>(t: [&[[f64; 3]; K]; 2]) -> Whole<K> {
    let decoded = t.map(|t| {
        t.map(|p| {
            p.map(|x| {
                assert!(x.is_finite(), "a finite coordinate");
                x.integer_decode()
            })
        })
    });
    let all = decoded.iter().flatten().flatten();
    let unit = all.filter(|(m, ..)| *m != 0).map(|&(_, e, _)| e).min().unwrap_or(0);
    let number = |(m, e, sign): (u64, i16, i8)| match m {
        0 => BigInt::zero(),
        m => (BigInt::from(m) << (e - unit)) * sign,
    };
    decoded.map(|t| t.map(|p| p.map(number)))
}

/// Point `i` minus point `j`, each coordinate a linear polynomial of time.
fn difference([t0, t1]: &Whole<4>, i: usize, j: usize) -> [Poly; 3] {
    std::array::from_fn(|k| {
        let start = &t0[i][k] - &t0[j][k];
        let end = &t1[i][k] - &t1[j][k];
        vec![start.clone(), end - start]
    })
}

fn add(p: &Poly, q: &Poly) -> Poly {
    let at = |p: &Poly, i: usize| p.get(i).cloned().unwrap_or_else(BigInt::zero);
    (0..p.len().max(q.len())).map(|i| at(p, i) + at(q, i)).collect()
}

fn negate(p: &Poly) -> Poly {
    p.iter().map(|c| -c.clone()).collect()
}

fn multiply(p: &Poly, q: &Poly) -> Poly {
    let mut out = vec![BigInt::zero(); p.len() + q.len() - 1];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            out[i + j] += a * b;
        }
    }
    out
}

fn cross2(p: &[Poly; 3], q: &[Poly; 3], k: usize) -> Poly {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    add(&multiply(&p[i], &q[j]), &negate(&multiply(&p[j], &q[i])))
}

/// An interval of time, `[lo / unit, hi / unit]`.
struct Interval {
    lo: BigInt,
    hi: BigInt,
    unit: BigInt,
}

impl Interval {
    /// Both parts, divided at 3/7 of it. Not at the middle: roots at simple fractions of two would
    /// fall on the ends of intervals.
    fn divided(self) -> [Self; 2] {
        let Self { lo, hi, unit } = self;
        let middle: BigInt = &lo * 4 + &hi * 3;
        let unit: BigInt = unit * 7;
        [
            Self { lo: lo * 7, hi: middle.clone(), unit: unit.clone() },
            Self { lo: middle, hi: hi * 7, unit },
        ]
    }
}

/// Coefficients in the Bernstein basis of an interval, up to a factor that is positive.
fn bernstein(p: &Poly, Interval { lo, hi, unit }: &Interval) -> Poly {
    let n = p.len() - 1;
    let width = hi - lo;
    // unit^n p((lo + width x) / unit) by Horner's scheme.
    let mut shifted: Poly = vec![BigInt::zero(); n + 1];
    let mut power = BigInt::one();
    for c in p.iter().rev() {
        for i in (0..=n).rev() {
            let carry = if i > 0 { &shifted[i - 1] * &width } else { BigInt::zero() };
            shifted[i] = &shifted[i] * lo + carry;
        }
        shifted[0] += c * &power;
        power *= unit;
    }
    let choose = |n: usize, k: usize| (0..k).fold(1, |c, i| c * (n - i) / (i + 1));
    let all: usize = (0..=n).map(|j| choose(n, j)).product();
    (0..=n)
        .map(|i| {
            let weighted = |j: usize| &shifted[j] * (choose(i, j) * (all / choose(n, j)));
            (0..=i).fold(BigInt::zero(), |sum, j| sum + weighted(j))
        })
        .collect()
}

/// The sign that a polynomial has everywhere on an interval, if its Bernstein coefficients show
/// one.
fn sign(p: &Poly, interval: &Interval) -> Option<bool> {
    let c = bernstein(p, interval);
    if c.iter().all(|c| c.is_positive()) {
        Some(true)
    } else if c.iter().all(|c| c.is_negative()) {
        Some(false)
    } else {
        None
    }
}

/// Divisions after which a query counts as degenerate.
const MAX_DEPTH: u32 = 110;
/// Divisions after which an interval is narrow enough: `(4/7)^75` is below 2^-60.
const NARROW_DEPTH: u32 = 75;

fn decide(a: [Poly; 3], b: [Poly; 3], c: [Poly; 3], triangle: bool) -> Answer {
    let n: [Poly; 3] = std::array::from_fn(|k| cross2(&b, &c, k));
    let f = (0..3).fold(vec![BigInt::zero()], |sum, k| add(&sum, &multiply(&a[k], &n[k])));
    let conditions: [(Poly, Vec<Poly>); 3] = std::array::from_fn(|k| {
        let (d, s, r) = (n[k].clone(), cross2(&a, &c, k), cross2(&b, &a, k));
        let minus = |p: &Poly, q: &Poly| add(p, &negate(q));
        let more = if triangle {
            vec![minus(&minus(&d, &s), &r)]
        } else {
            vec![minus(&d, &s), minus(&d, &r)]
        };
        (d, [vec![s, r], more].concat())
    });
    let all = Interval { lo: BigInt::zero(), hi: BigInt::one(), unit: BigInt::one() };
    let mut stack = vec![(all, 0u32)];
    while let Some((interval, depth)) = stack.pop() {
        let coefficients = bernstein(&f, &interval);
        let nonzero: Vec<bool> =
            coefficients.iter().filter(|c| !c.is_zero()).map(|c| c.is_positive()).collect();
        let variations = nonzero.windows(2).filter(|w| w[0] != w[1]).count();
        let (first, last) = (&coefficients[0], &coefficients[coefficients.len() - 1]);
        if variations == 0 && !first.is_zero() && !last.is_zero() {
            continue;
        }
        if depth > MAX_DEPTH || nonzero.is_empty() {
            return Answer::Degenerate;
        }
        if variations == 1 && !first.is_zero() && !last.is_zero() {
            match contained(&conditions, &interval) {
                Some(false) => continue,
                Some(true) if depth >= NARROW_DEPTH => {
                    let Interval { lo, hi, unit } = interval;
                    let time =
                        |x: BigInt| BigRational::new(x, unit.clone()).to_f64().expect("a time");
                    return Answer::Contact(time(lo), time(hi));
                }
                _ => {}
            }
        }
        let [first, second] = interval.divided();
        stack.extend([(second, depth + 1), (first, depth + 1)]);
    }
    Answer::Free
}

/// Whether the features meet at coplanar times within an interval: the first projection with a
/// determinant of one sign decides.
fn contained(conditions: &[(Poly, Vec<Poly>); 3], interval: &Interval) -> Option<bool> {
    for (determinant, rest) in conditions {
        let Some(positive) = sign(determinant, interval) else { continue };
        let signs: Vec<Option<bool>> = rest.iter().map(|p| sign(p, interval)).collect();
        if signs.contains(&Some(!positive)) {
            return Some(false);
        }
        if signs.iter().all(|s| *s == Some(positive)) {
            return Some(true);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_falls_through_a_face() {
        let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        let at = |x: f64, y: f64| [[x, y, 0.25], face[0], face[1], face[2]];
        let Answer::Contact(lo, hi) = vertex_face(&at(0.25, 1.0), &at(0.25, -2.0)) else {
            panic!("no contact")
        };
        assert!(lo <= 1.0 / 3.0 && hi >= 1.0 / 3.0 && hi - lo < 1e-15);
        assert_eq!(vertex_face(&at(0.25, 1.0), &at(0.25, 0.5)), Answer::Free);
        assert_eq!(vertex_face(&at(2.0, 1.0), &at(2.0, -2.0)), Answer::Free);
    }
}
