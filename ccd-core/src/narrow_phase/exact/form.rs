//! Polynomials of a step as binary forms: `c_0 u^n + c_1 u^(n-1) v + .. + c_n v^n` with `u = 1 - s`
//! and `v = s`, and integer coefficients.
//!
//! These are Bernstein coefficients times binomial ones, which are positive: signs and their
//! variations are the same [Farouki 2012], but products are convolutions and nothing is divided.

use super::integer::Integer;
use super::words::Words;

/// The highest degree: of an inside sign, `(a x b) . n`.
pub const DEGREE: usize = 4;

/// A binary form.
#[derive(Clone, Debug)]
pub struct Form<W> {
    c: [Integer<W>; DEGREE + 1],
    degree: usize,
}

impl<W: Words> Form<W> {
    /// 0, of degree 0.
    pub const ZERO: Self = Self { c: [Integer::ZERO; DEGREE + 1], degree: 0 };
    /// A form whose numbers did not fit.
    const LOST: Self = Self { c: [Integer::LOST; DEGREE + 1], degree: 0 };

    /// The form `u c_0 + v c_1`: a number that moves from one to the other.
    pub fn linear(c: [Integer<W>; 2]) -> Self {
        let mut out = Self::zero(1);
        let [c0, c1] = c;
        (out.c[0], out.c[1]) = (c0, c1);
        out
    }

    fn zero(degree: usize) -> Self {
        Self { c: [Integer::ZERO; DEGREE + 1], degree }
    }

    /// Its degree, where leading coefficients may be 0.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Its coefficients.
    pub fn coefficients(&self) -> &[Integer<W>] {
        &self.c[..=self.degree]
    }

    /// Whether nothing was lost.
    pub fn is_exact(&self) -> bool {
        self.coefficients().iter().all(Integer::is_exact)
    }

    /// The form, if nothing was lost: signs mean nothing otherwise.
    pub fn checked(self) -> Option<Self> {
        self.is_exact().then_some(self)
    }

    /// Whether it is 0 at all times.
    pub fn vanishes(&self) -> bool {
        self.coefficients().iter().all(|c| c.sign() == 0 && c.is_exact())
    }

    /// The sign next to the beginning, or at it if it is not 0 there.
    pub fn first_sign(&self) -> i32 {
        self.coefficients().iter().map(Integer::sign).find(|&s| s != 0).unwrap_or(0)
    }

    /// The sign that it has everywhere between the ends, as far as coefficients show it; 0 of what
    /// vanishes.
    pub fn sign(&self) -> Option<i32> {
        let first = self.first_sign();
        let same = self.coefficients().iter().all(|c| c.sign() * first >= 0);
        same.then_some(first)
    }

    /// How often coefficients change their sign: as many zeros as there are between the ends, or
    /// more by an even number.
    pub fn variations(&self) -> usize {
        let mut signs = self.coefficients().iter().map(Integer::sign).filter(|&s| s != 0);
        let Some(mut last) = signs.next() else { return 0 };
        signs.filter(|&s| core::mem::replace(&mut last, s) != s).count()
    }

    /// The sum of two forms of one degree.
    pub fn plus(&self, other: &Self) -> Self {
        self.sum(other, false)
    }

    /// The difference of two forms of one degree.
    pub fn minus(&self, other: &Self) -> Self {
        self.sum(other, true)
    }

    fn sum(&self, other: &Self, negated: bool) -> Self {
        debug_assert_eq!(self.degree, other.degree);
        let mut out = self.clone();
        for (x, y) in out.c.iter_mut().zip(other.coefficients()) {
            x.accumulate(y, negated);
        }
        out
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        let mut out = Self::zero(self.degree + other.degree);
        out.add_product(self, other, false);
        out
    }

    /// Adds the product of two forms, of this degree, or its negative.
    pub fn add_product(&mut self, a: &Self, b: &Self, negated: bool) {
        debug_assert_eq!(self.degree, a.degree + b.degree);
        for (i, x) in a.coefficients().iter().enumerate() {
            for (j, y) in b.coefficients().iter().enumerate() {
                self.c[i + j].add_product(x, y, negated);
            }
        }
    }

    fn times_number(&self, x: &Integer<W>) -> Self {
        let mut out = Self::zero(self.degree);
        (0..=self.degree).for_each(|i| out.c[i] = &self.c[i] * x);
        out
    }

    /// Its value where `u` and `v` are these.
    pub fn at(&self, [u, v]: &[Integer<W>; 2]) -> Integer<W> {
        let (mut out, mut power) = (Integer::ZERO, Integer::new(1, 0));
        for c in self.coefficients() {
            out = out * u;
            out.add_product(c, &power, false);
            power = power * v;
        }
        out
    }

    /// The sign half of the way; `None` if the sum does not fit.
    pub fn sign_halfway(&self) -> Option<i32> {
        let mut sum = Integer::ZERO;
        self.coefficients().iter().for_each(|c| sum.accumulate(c, false));
        sum.is_exact().then(|| sum.sign())
    }

    /// As a form over a part of the step: `from` and `to` are `u` and `v` at its ends, whose sums
    /// are one power of two.
    ///
    /// With `x` and `y` of the part and `z = x + y`, `v = v_0 z + (v_1 - v_0) y`, and `u + v` is
    /// the power of two times `z`. So the form becomes one of `u + v` and `v`, by differences; one
    /// of `z` and `y`, by a Taylor shift, which has ten products with `v_0` of degree 4; and one of
    /// `x` and `y`, by sums.
    pub fn over(&self, from: &[Integer<W>; 2], to: &[Integer<W>; 2]) -> Self {
        let (mut out, n) = (self.clone(), self.degree);
        let c = &mut out.c;
        add_second(&mut c[..=n], true);
        let (one, way) = (&from[0] + &from[1], &to[1] - &from[1]);
        let Some(shift) = one.bits().checked_sub(1) else { return Self::LOST };
        for (k, c) in c[..=n].iter_mut().enumerate() {
            *c = c.shifted(shift * (n - k) as u32);
        }
        for first in 0..n {
            for k in (first + 1..=n).rev() {
                let [before, here] = neighbours(c, k);
                before.add_product(here, &from[1], false);
            }
        }
        let mut power = way.clone();
        for c in &mut c[1..=n] {
            *c = &*c * &power;
            power = power * &way;
        }
        add_second(&mut c[..=n], false);
        out
    }

    /// Its derivative by time, times a positive number.
    pub fn derivative(&self) -> Self {
        let n = self.degree;
        let mut out = Self::zero(n.saturating_sub(1));
        let times = |c: &Integer<W>, k: usize| c * Integer::new(k as i64, 0);
        for i in 0..n {
            out.c[i] = times(&self.c[i + 1], i + 1) - times(&self.c[i], n - i);
        }
        out
    }

    /// The least and the greatest of its Bernstein coefficients, between which its values are, and
    /// both times 12.
    pub fn range(&self) -> [Integer<W>; 2] {
        let binomial = |n: usize, k: usize| (0..k).fold(1, |b, i| b * (n - i) / (i + 1));
        let at = |i: usize| &self.c[i] * Integer::new(12 / binomial(self.degree, i) as i64, 0);
        let mut least = at(0);
        let mut most = least.clone();
        for c in (1..=self.degree).map(at) {
            if (&c - &least).sign() < 0 || !c.is_exact() {
                least = c.clone();
            }
            if (&c - &most).sign() > 0 || !c.is_exact() {
                most = c;
            }
        }
        [least, most]
    }

    /// About where it is 0 between its ends, of which it has different signs next to them.
    pub fn guess(&self) -> f64 {
        let bits = self.coefficients().iter().map(Integer::bits).max().unwrap_or(0);
        let rounded = self.c.each_ref().map(|c| c.rounded(bits));
        let value = |v: f64| {
            let (u, mut power, mut sum) = (1.0 - v, 1.0, 0.0);
            for &c in &rounded[..=self.degree] {
                (sum, power) = (sum * u + c * power, power * v);
            }
            sum
        };
        let first = self.first_sign() as f64;
        let (mut from, mut to) = (0.0, 1.0);
        for _ in 0..48 {
            let middle = 0.5 * (from + to);
            if value(middle) * first > 0.0 {
                from = middle;
            } else {
                to = middle;
            }
        }
        from
    }

    /// Without factors `u + v`, which are 1 at all times: those of a form whose degree in time is
    /// less than it could be, where something stands still.
    pub fn reduced(&self) -> Self {
        let mut out = self.clone();
        while out.degree > 0 {
            let mut quotient = Self::zero(out.degree - 1);
            let mut rest = out.c[0].clone();
            for i in 0..out.degree {
                let next = &out.c[i + 1] - &rest;
                quotient.c[i] = core::mem::replace(&mut rest, next);
            }
            if rest.sign() != 0 || !rest.is_exact() {
                break;
            }
            out = quotient;
        }
        out
    }

    /// Without factors `u` and `v`: zeros at the ends; how many of each. Not of what vanishes.
    pub fn without_ends(&self) -> (Self, [usize; 2]) {
        let c = self.coefficients();
        let first = c.iter().take_while(|c| c.sign() == 0).count();
        let last = c.iter().rev().take_while(|c| c.sign() == 0).count();
        let mut out = Self::zero(self.degree - first.min(self.degree) - last.min(self.degree));
        out.c[..=out.degree].clone_from_slice(&c[first..=first + out.degree]);
        (out, [first, last])
    }

    /// The remainder by another, of a lower degree in `v / u`, times a positive number. The other
    /// is [`Form::trimmed`], of at least degree 1.
    fn remainder(&self, by: &Self) -> Self {
        let mut out = self.trimmed();
        let lead = &by.c[by.degree];
        let negative = lead.sign() < 0;
        let positive = |x: &Integer<W>| if negative { -x.clone() } else { x.clone() };
        while out.degree >= by.degree && out.is_exact() {
            let (factor, shift) = (positive(&out.c[out.degree]), out.degree - by.degree);
            out = out.times_number(&positive(lead));
            for i in 0..=by.degree {
                out.c[i + shift].add_product(&by.c[i], &factor, true);
            }
            out = out.trimmed();
        }
        out
    }

    /// Of the least degree in `v / u`.
    fn trimmed(&self) -> Self {
        let is_zero = |c: &Integer<W>| c.sign() == 0 && c.is_exact();
        let mut out = self.clone();
        while out.degree > 0 && is_zero(&out.c[out.degree]) {
            out.degree -= 1;
        }
        out
    }

    /// A greatest common divisor in `v / u`; of degree 0 if there is none but numbers. Remainders
    /// below degree 1 are not needed: whether there is a divisor is seen by a determinant, which
    /// has fewer bits.
    pub fn common(&self, other: &Self) -> Option<Self> {
        let (mut a, mut b) = (self.trimmed(), other.trimmed());
        if a.degree < b.degree {
            (a, b) = (b, a);
        }
        if b.vanishes() {
            return Some(a);
        }
        let resultant = match b.degree {
            1 => a.at(&[b.c[1].clone(), -b.c[0].clone()]),
            _ => a.bezout(&b),
        };
        if !resultant.is_exact() {
            return None;
        }
        if b.degree == 0 || resultant.sign() != 0 {
            let mut none = b;
            none.degree = 0;
            return Some(none);
        }
        while b.degree > 1 {
            let rest = a.remainder(&b).checked()?;
            if rest.vanishes() {
                break;
            }
            (a, b) = (b, rest);
        }
        Some(b)
    }

    /// The determinant of the matrix of Bezout with a form of no higher degree [Basu 2006]: the
    /// resultant, times a power of the leading coefficient.
    fn bezout(&self, other: &Self) -> Integer<W> {
        let (p, q, n, zero) = (&self.c, &other.c, self.degree, Integer::ZERO);
        let q = |i: usize| if i <= other.degree { &q[i] } else { &zero };
        let mut rows: [[_; DEGREE]; DEGREE] = core::array::from_fn(|_| [Integer::ZERO; DEGREE]);
        for (i, row) in rows.iter_mut().enumerate().take(n) {
            for (j, entry) in row.iter_mut().enumerate().take(n) {
                for k in 0..=i.min(n - 1 - j) {
                    let (low, high) = (i - k, j + k + 1);
                    entry.add_product(&p[high], q(low), false);
                    entry.add_product(&p[low], q(high), true);
                }
            }
        }
        determinant(&rows, n, 0, [0, 1, 2, 3])
    }
}

/// Makes a form of `u` and `v` that of `u + v` and `v`, or with `negated` of `u - v` and `v`.
fn add_second<W: Words>(c: &mut [Integer<W>], negated: bool) {
    for last in (1..c.len()).rev() {
        for k in 1..=last {
            let [before, here] = neighbours(c, k);
            here.accumulate(before, negated);
        }
    }
}

/// A coefficient and the one before it.
fn neighbours<W>(c: &mut [Integer<W>], k: usize) -> [&mut Integer<W>; 2] {
    let [before, here] = &mut c[k - 1..=k] else { unreachable!("two of them") };
    [before, here]
}

/// The determinant of the rows from `row` on and the first columns of a list, of an `n x n` matrix.
fn determinant<W: Words>(
    rows: &[[Integer<W>; DEGREE]; DEGREE],
    n: usize,
    row: usize,
    columns: [usize; DEGREE],
) -> Integer<W> {
    let left = n - row;
    let mut sum = Integer::ZERO;
    for k in 0..left {
        let entry = &rows[row][columns[k]];
        if entry.sign() == 0 && entry.is_exact() {
            continue;
        }
        let mut others = columns;
        others.copy_within(k + 1.., k);
        let minor =
            if left == 1 { Integer::new(1, 0) } else { determinant(rows, n, row + 1, others) };
        sum.add_product(entry, &minor, k % 2 == 1);
    }
    sum
}
