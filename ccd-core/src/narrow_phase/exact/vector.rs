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
}

/// Three numbers.
pub type Vector<T> = [T; 3];

/// `a - b`
pub fn minus<T: Number>(a: &Vector<T>, b: &Vector<T>) -> Vector<T> {
    [a[0].minus(&b[0]), a[1].minus(&b[1]), a[2].minus(&b[2])]
}

/// `a . b`
pub fn dot<T: Number>(a: &Vector<T>, b: &Vector<T>) -> T {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

/// `a x b`
pub fn cross<T: Number>(a: &Vector<T>, b: &Vector<T>) -> Vector<T> {
    let at = |i: usize, j: usize| a[i].times(&b[j]).minus(&a[j].times(&b[i]));
    [at(1, 2), at(2, 0), at(0, 1)]
}
