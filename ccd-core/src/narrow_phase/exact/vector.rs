//! Vectors of numbers whose signs are certain: integers at a moment, forms over a step.

use super::form::Form;
use super::integer::Integer;
use super::words::Words;

/// What polynomials of coordinates are computed with.
pub trait Number: Clone {
    /// The sum.
    fn plus(&self, other: &Self) -> Self;
    /// The difference.
    fn minus(&self, other: &Self) -> Self;
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// Adds a product, or its negative.
    fn add_product(&mut self, a: &Self, b: &Self, negated: bool) {
        let product = a.times(b);
        *self = if negated { self.minus(&product) } else { self.plus(&product) };
    }
}

impl<W: Words> Number for Integer<W> {
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn add_product(&mut self, a: &Self, b: &Self, negated: bool) {
        Integer::add_product(self, a, b, negated);
    }
}

impl<W: Words> Number for Form<W> {
    fn plus(&self, other: &Self) -> Self {
        Form::plus(self, other)
    }
    fn minus(&self, other: &Self) -> Self {
        Form::minus(self, other)
    }
    fn times(&self, other: &Self) -> Self {
        Form::times(self, other)
    }
    fn add_product(&mut self, a: &Self, b: &Self, negated: bool) {
        Form::add_product(self, a, b, negated);
    }
}

/// Three numbers.
pub type Vector<T> = [T; 3];

/// `a - b`
pub fn minus<T: Number>(a: &Vector<T>, b: &Vector<T>) -> Vector<T> {
    [a[0].minus(&b[0]), a[1].minus(&b[1]), a[2].minus(&b[2])]
}

/// `a . b`
pub fn dot<T: Number>(a: &Vector<T>, b: &Vector<T>) -> T {
    let mut sum = a[0].times(&b[0]);
    sum.add_product(&a[1], &b[1], false);
    sum.add_product(&a[2], &b[2], false);
    sum
}

/// `a x b`
pub fn cross<T: Number>(a: &Vector<T>, b: &Vector<T>) -> Vector<T> {
    let at = |i: usize, j: usize| {
        let mut minor = a[i].times(&b[j]);
        minor.add_product(&a[j], &b[i], true);
        minor
    };
    [at(1, 2), at(2, 0), at(0, 1)]
}
