//! The exact answer of a query in rational arithmetic: nothing is rounded, nothing is shared with
//! the code under test.
//!
//! Roots of the coplanarity cubic are isolated by sign variations of exact Bernstein coefficients;
//! at each, the containment conditions are decided by the signs of exact polynomials over the
//! isolating interval, which is divided until they are certain. Queries where that never ends
//! (contact exactly on a boundary, coplanar motion, double roots) are reported as degenerate: the
//! published ground truth covers those.

use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Signed, Zero};

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

type Poly = Vec<BigRational>;

/// Vertex-face: `v f0 f1 f2`.
pub fn vertex_face(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4]) -> Answer {
    let d = |i: usize, j: usize| difference(t0, t1, i, j);
    decide(d(0, 1), d(2, 1), d(3, 1), true)
}

/// Edge-edge: `ea0 ea1 eb0 eb1`.
pub fn edge_edge(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4]) -> Answer {
    let d = |i: usize, j: usize| difference(t0, t1, i, j);
    decide(d(2, 0), d(1, 0), d(2, 3), false)
}

fn exact(x: f64) -> BigRational {
    BigRational::from_f64(x).expect("a finite coordinate")
}

/// Point `i` minus point `j`, each coordinate a linear polynomial of time.
fn difference(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4], i: usize, j: usize) -> [Poly; 3] {
    std::array::from_fn(|k| {
        let start = exact(t0[i][k]) - exact(t0[j][k]);
        let end = exact(t1[i][k]) - exact(t1[j][k]);
        vec![start.clone(), end - start]
    })
}

fn add(p: &Poly, q: &Poly) -> Poly {
    let at = |p: &Poly, i: usize| p.get(i).cloned().unwrap_or_else(BigRational::zero);
    (0..p.len().max(q.len())).map(|i| at(p, i) + at(q, i)).collect()
}

fn negate(p: &Poly) -> Poly {
    p.iter().map(|c| -c.clone()).collect()
}

fn multiply(p: &Poly, q: &Poly) -> Poly {
    let mut out = vec![BigRational::zero(); p.len() + q.len() - 1];
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

/// Coefficients in the Bernstein basis of `[lo, hi]`.
fn bernstein(p: &Poly, lo: &BigRational, hi: &BigRational) -> Poly {
    let n = p.len() - 1;
    let width = hi - lo;
    // p(lo + width x) by Horner's scheme.
    let mut shifted: Poly = vec![BigRational::zero(); n + 1];
    for c in p.iter().rev() {
        for i in (0..=n).rev() {
            let carry = if i > 0 { &shifted[i - 1] * &width } else { BigRational::zero() };
            shifted[i] = &shifted[i] * lo + carry;
        }
        shifted[0] += c;
    }
    let choose = |n: usize, k: usize| {
        (0..k).fold(BigRational::one(), |c, i| c * exact((n - i) as f64) / exact((i + 1) as f64))
    };
    (0..=n)
        .map(|i| {
            (0..=i)
                .fold(BigRational::zero(), |sum, j| sum + choose(i, j) / choose(n, j) * &shifted[j])
        })
        .collect()
}

/// The sign that a polynomial has everywhere on `[lo, hi]`, if its Bernstein coefficients show one.
fn sign(p: &Poly, lo: &BigRational, hi: &BigRational) -> Option<bool> {
    let c = bernstein(p, lo, hi);
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
    let f = (0..3).fold(vec![BigRational::zero()], |sum, k| add(&sum, &multiply(&a[k], &n[k])));
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
    let mut stack = vec![(BigRational::zero(), BigRational::one(), 0u32)];
    // Not at the middle: roots at simple fractions of two would fall on the ends of intervals.
    let part = exact(3.0) / exact(7.0);
    while let Some((lo, hi, depth)) = stack.pop() {
        let coefficients = bernstein(&f, &lo, &hi);
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
            match contained(&conditions, &lo, &hi) {
                Some(false) => continue,
                Some(true) if depth >= NARROW_DEPTH => {
                    use num_traits::ToPrimitive;
                    let f = |x: &BigRational| x.to_f64().expect("a time");
                    return Answer::Contact(f(&lo), f(&hi));
                }
                _ => {}
            }
        }
        let middle = &lo + (&hi - &lo) * &part;
        stack.push((middle.clone(), hi, depth + 1));
        stack.push((lo, middle, depth + 1));
    }
    Answer::Free
}

/// Whether the features meet at coplanar times within `[lo, hi]`: the first projection with a
/// determinant of one sign decides.
fn contained(
    conditions: &[(Poly, Vec<Poly>); 3],
    lo: &BigRational,
    hi: &BigRational,
) -> Option<bool> {
    for (determinant, rest) in conditions {
        let Some(positive) = sign(determinant, lo, hi) else { continue };
        let signs: Vec<Option<bool>> = rest.iter().map(|p| sign(p, lo, hi)).collect();
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
