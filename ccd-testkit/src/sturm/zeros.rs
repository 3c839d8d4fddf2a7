//! Zeros of polynomials with whole coefficients: Sturm chains, and signs of others there.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Signed, Zero};
use std::cmp::Ordering;

pub type Q = BigRational;

/// A polynomial, the constant first; no last coefficient is 0. Whole numbers are much faster than
/// fractions, which are reduced one bit at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Poly(pub Vec<BigInt>);

impl Poly {
    pub fn new(mut c: Vec<BigInt>) -> Self {
        while c.last().is_some_and(Zero::is_zero) {
            c.pop();
        }
        Self(c)
    }

    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    pub fn plus(&self, other: &Self, factor: i32) -> Self {
        let at = |p: &Self, i: usize| p.0.get(i).cloned().unwrap_or_else(BigInt::zero);
        let n = self.0.len().max(other.0.len());
        Self::new((0..n).map(|i| at(self, i) + at(other, i) * factor).collect())
    }

    pub fn times(&self, other: &Self) -> Self {
        let mut c = vec![BigInt::zero(); (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                c[i + j] += a * b;
            }
        }
        Self::new(c)
    }

    fn derivative(&self) -> Self {
        let c = self.0.iter().enumerate().skip(1);
        Self::new(c.map(|(i, c)| c * i).collect())
    }

    /// The value at `n / d` times `d` to the degree, whose sign is that of the value.
    pub fn at(&self, t: &Q) -> BigInt {
        let (mut sum, mut power) = (BigInt::zero(), BigInt::one());
        for c in self.0.iter().rev() {
            sum = sum * t.numer() + c * &power;
            power *= t.denom();
        }
        sum
    }

    /// Divided by what its coefficients have in common.
    fn primitive(mut self) -> Self {
        let common = self.0.iter().fold(BigInt::zero(), |common, c| common.gcd(c));
        if common > BigInt::one() {
            self.0.iter_mut().for_each(|c| *c /= &common);
        }
        self
    }

    /// Quotient and remainder, both times a positive number of no interest.
    fn divided(&self, by: &Self) -> [Self; 2] {
        let (by, lead) = by.0.split_at(by.0.len() - 1);
        let (size, is_negative) = (lead[0].abs(), lead[0].is_negative());
        let (mut rest, mut quotient) = (self.0.clone(), vec![BigInt::zero(); self.0.len()]);
        while rest.len() > by.len() {
            let top = rest.pop().expect("long enough");
            let top = if is_negative { -top } else { top };
            let shift = rest.len() - by.len();
            rest.iter_mut().chain(&mut quotient).for_each(|c| *c *= &size);
            for (i, c) in by.iter().enumerate() {
                rest[i + shift] -= &top * c;
            }
            quotient[shift] = top;
        }
        [quotient, rest].map(|p| Self::new(p).primitive())
    }

    /// Without multiple zeros.
    fn simple(&self) -> Self {
        let (mut a, mut b) = (self.clone(), self.derivative());
        while !b.is_zero() {
            let [_, rest] = a.divided(&b);
            (a, b) = (b, rest);
        }
        let [simple, _] = self.divided(&a);
        simple
    }

    /// The sum of the signs of `of` at the zeros between two places that are none: Tarski's query.
    pub fn query(&self, of: &Self, from: &Q, to: &Q) -> i32 {
        let product = self.derivative().times(of).primitive();
        let mut chain = vec![self.clone(), product];
        while chain.last().is_some_and(|p| !p.is_zero()) {
            let [_, rest] = chain[chain.len() - 2].divided(&chain[chain.len() - 1]);
            chain.push(Self(rest.0.into_iter().map(|c| -c).collect()));
        }
        let variations = |t: &Q| {
            let signs: Vec<bool> = chain
                .iter()
                .map(|p| p.at(t))
                .filter(|v| !v.is_zero())
                .map(|v| v.is_positive())
                .collect();
            signs.windows(2).filter(|two| two[0] != two[1]).count() as i32
        };
        variations(from) - variations(to)
    }
}

/// A zero of the first without multiple zeros, the only one between two places that are none.
#[derive(Clone, Debug)]
pub struct Place {
    of: Poly,
    from: Q,
    to: Q,
}

impl Place {
    /// The sign of another polynomial there.
    pub fn sign(&self, of: &Poly) -> i32 {
        self.of.query(of, &self.from, &self.to)
    }

    /// A time before it, since which the polynomial whose zero it is has no other.
    pub fn before(&self) -> &Q {
        &self.from
    }

    /// Where it is, seen from a time: by the sign there, as a zero that is simple changes it.
    pub fn beside(&self, t: &Q) -> Ordering {
        if *t <= self.from {
            return Ordering::Greater;
        }
        if *t >= self.to {
            return Ordering::Less;
        }
        let (there, before) = (self.of.at(t), self.of.at(&self.from));
        if there.is_zero() {
            Ordering::Equal
        } else if there.is_positive() == before.is_positive() {
            Ordering::Greater
        } else {
            Ordering::Less
        }
    }

    /// Two numbers at most `width` apart around it.
    pub fn within(&self, width: &Q) -> [Q; 2] {
        let two = Q::from_integer(BigInt::from(2));
        let (mut from, mut to) = (self.from.clone(), self.to.clone());
        while &to - &from > *width {
            let middle = (&from + &to) / &two;
            match self.beside(&middle) {
                Ordering::Greater => from = middle,
                Ordering::Less => to = middle,
                Ordering::Equal => return [middle.clone(), middle],
            }
        }
        [from, to]
    }
}

fn constant(x: i32) -> Poly {
    Poly::new(vec![BigInt::from(x)])
}

/// The zeros in `[from, to]`.
pub fn places(p: &Poly, [from, to]: &[Q; 2]) -> Vec<Place> {
    if p.0.len() < 2 {
        return Vec::new();
    }
    let p = p.simple();
    // A little outside, where it is not 0: by the bound of Cauchy no zero is beyond.
    let mut margin = Q::one();
    loop {
        let ends = [from - &margin, to + &margin];
        let outside = |a: &Q, b: &Q| -> bool {
            // None between the window and the margin.
            [a, b].iter().all(|t| !p.at(t).is_zero())
        };
        if outside(&ends[0], &ends[1]) {
            let inside = closed(&p, from, to);
            if p.query(&constant(1), &ends[0], &ends[1]) == inside {
                return isolated(&p, &ends[0], &ends[1]);
            }
        }
        margin /= Q::from_i32(2).expect("a number");
    }
}

/// How many zeros there are in a closed interval.
fn closed(p: &Poly, from: &Q, to: &Q) -> i32 {
    let at = |t: &Q| p.at(t).is_zero() as i32;
    if from == to {
        return at(from);
    }
    // Sturm's count is of `(from, to]` if chains are signed as at the ends themselves.
    let ends = [from, to].map(at);
    let mut q = p.clone();
    for (t, is) in [(from, ends[0]), (to, ends[1])] {
        if is > 0 {
            let zero = Poly::new(vec![-t.numer(), t.denom().clone()]);
            [q, _] = q.divided(&zero);
        }
    }
    ends[0] + ends[1] + if q.0.len() < 2 { 0 } else { q.query(&constant(1), from, to) }
}

fn isolated(p: &Poly, from: &Q, to: &Q) -> Vec<Place> {
    match p.query(&constant(1), from, to) {
        0 => Vec::new(),
        1 => vec![Place { of: p.clone(), from: from.clone(), to: to.clone() }],
        _ => {
            let two = Q::from_i32(2).expect("a number");
            let mut middle = (from + to) / &two;
            while p.at(&middle).is_zero() {
                middle = (from + middle) / &two;
            }
            [isolated(p, from, &middle), isolated(p, &middle, to)].into_iter().flatten().collect()
        }
    }
}
