//! A number whose denormals are zeros.

use bytemuck::{Pod, Zeroable};
use ccd_core::{Num, Real};
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// An `f32` or `f64` whose denormals are zeros where it is read, and where it is a result.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(transparent)]
pub struct Flushed<T>(pub T);

fn flush<T: Real>(x: T) -> T {
    if Num::abs(x) < T::MIN_NORMAL { T::splat(0.0) } else { x }
}

macro_rules! operation {
    ($trait:ident $name:ident $op:tt) => {
        impl<T: Real> $trait for Flushed<T> {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                Self(flush(flush(self.0) $op flush(other.0)))
            }
        }
    };
}

operation!(Add add +);
operation!(Sub sub -);
operation!(Mul mul *);
operation!(Div div /);

impl<T: Real> Neg for Flushed<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<T: Real> PartialEq for Flushed<T> {
    fn eq(&self, other: &Self) -> bool {
        flush(self.0) == flush(other.0)
    }
}

impl<T: Real> PartialOrd for Flushed<T> {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        flush(self.0).partial_cmp(&flush(other.0))
    }
}

impl<T: Real> From<Flushed<T>> for f64 {
    fn from(x: Flushed<T>) -> f64 {
        x.0.to_f64()
    }
}

impl<T: Real> Num for Flushed<T> {
    const UNIT: Self = Self(T::UNIT);
    const MIN_NORMAL: Self = Self(T::MIN_NORMAL);
    type Mask = bool;
    fn gt(self, other: Self) -> bool {
        self > other
    }
    fn splat(x: f32) -> Self {
        Self(T::splat(x))
    }
    fn abs(self) -> Self {
        Self(Num::abs(self.0))
    }
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
}

impl<T: Real> Real for Flushed<T> {
    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }
    fn from_f64(x: f64) -> Self {
        Self(T::from_f64(x))
    }
    fn round_down(self) -> f32 {
        self.0.round_down()
    }
    fn round_up(self) -> f32 {
        self.0.round_up()
    }
    fn sqrt_up(self) -> Self {
        // Nothing on the way to the root of a normal number is a denormal.
        Self(flush(self.0).sqrt_up())
    }
    fn next_up(self) -> Self {
        // As the library does it by bits, where comparisons flush.
        Self(if flush(self.0) == T::splat(0.0) { T::splat(0.0) } else { self.0 }.next_up())
    }
    fn next_down(self) -> Self {
        -(-self).next_up()
    }
    fn is_finite_number(self) -> bool {
        self.0.is_finite_number()
    }
    fn to_unit(self) -> Self {
        Self(self.0.to_unit())
    }
}
