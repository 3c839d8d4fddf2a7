//! A number whose every operation is as wrong as an adversary wants it, within what the bounds
//! allow.
//!
//! The unit roundoff is 2^-24, carried in `f64`, so that exact values are computed beside it. The
//! adversary chooses for each operation, in the order of execution, an error of `-u`, 0 or `+u`
//! (quotients: five times that, 2.5 units in the last place); 0 for a product stands for
//! contraction. It may also flush operands and results that are not normal.

use bytemuck::{Pod, Zeroable};
use ccd_core::{Num, Real};
use std::cell::{Cell, RefCell};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Unit roundoff of [`Adversarial`].
pub const UNIT: f64 = 1.0 / 16_777_216.0;
/// Its smallest normal number.
pub const MIN_NORMAL: f64 = f32::MIN_POSITIVE as f64;

#[derive(Clone, Copy, Debug, PartialEq, PartialOrd, Pod, Zeroable)]
#[repr(transparent)]
pub struct Adversarial(pub f64);

thread_local! {
    static CHOICES: RefCell<Vec<i8>> = const { RefCell::new(Vec::new()) };
    static NEXT: Cell<usize> = const { Cell::new(0) };
    static FLUSH: Cell<bool> = const { Cell::new(false) };
}

/// Runs `work` under these choices, 0 where they end. Returns its result and the number of
/// operations.
pub fn under<T>(choices: &[i8], flush: bool, work: impl FnOnce() -> T) -> (T, usize) {
    CHOICES.with_borrow_mut(|all| {
        all.clear();
        all.extend_from_slice(choices);
    });
    NEXT.set(0);
    FLUSH.set(flush);
    let out = work();
    (out, NEXT.get())
}

/// Runs `work` without the adversary, in the middle of a run under choices.
pub fn undisturbed<T>(work: impl FnOnce() -> T) -> T {
    let next = NEXT.replace(usize::MAX / 2);
    let out = work();
    NEXT.set(next);
    out
}

/// The powers of two that the geometry multiplies by: exact in any binary arithmetic.
fn is_scale(x: f64) -> bool {
    [0.5, 2.0, 4.0, 8.0].contains(&x)
}

fn operand(x: f64) -> f64 {
    if FLUSH.get() && x.abs() < MIN_NORMAL { 0.0 } else { x }
}

fn rounded(x: f64, worst: f64) -> Adversarial {
    let i = NEXT.get();
    NEXT.set(i + 1);
    let choice = CHOICES.with_borrow(|all| all.get(i).copied().unwrap_or(0));
    Adversarial(operand(x * (1.0 + choice as f64 * worst)))
}

macro_rules! operator {
    ($trait:ident, $name:ident, $symbol:tt, $worst:expr) => {
        impl $trait for Adversarial {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                let (a, b) = (operand(self.0), operand(other.0));
                let exact = stringify!($name) == "mul" && (is_scale(a) || is_scale(b));
                rounded(a $symbol b, if exact { 0.0 } else { $worst })
            }
        }
    };
}
operator!(Add, add, +, UNIT);
operator!(Sub, sub, -, UNIT);
operator!(Mul, mul, *, UNIT);
operator!(Div, div, /, 5.0 * UNIT);

impl Neg for Adversarial {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl From<Adversarial> for f64 {
    fn from(x: Adversarial) -> f64 {
        x.0
    }
}

impl Num for Adversarial {
    const UNIT: Self = Self(UNIT);
    const MIN_NORMAL: Self = Self(MIN_NORMAL);
    type Mask = bool;
    fn gt(self, other: Self) -> bool {
        self.0 > other.0
    }
    fn splat(x: f32) -> Self {
        Self(x as f64)
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn max(self, other: Self) -> Self {
        if self.0 > other.0 { self } else { other }
    }
    fn min(self, other: Self) -> Self {
        if self.0 < other.0 { self } else { other }
    }
}

impl Real for Adversarial {
    fn to_f64(self) -> f64 {
        self.0
    }
    fn from_f64(x: f64) -> Self {
        Self(x)
    }
    fn round_down(self) -> f32 {
        self.0.round_down()
    }
    fn round_up(self) -> f32 {
        self.0.round_up()
    }
    fn sqrt_up(self) -> Self {
        // At or above the root, by up to 16 units of roundoff as the real ones.
        let slack = rounded(1.0, UNIT).0 - 1.0;
        Self(operand(self.0).max(0.0).sqrt() * (1.0 + 8.0 * (slack + UNIT)))
    }
    fn next_up(self) -> Self {
        Self(self.0 + self.0.abs() * 2.0 * UNIT + MIN_NORMAL * UNIT)
    }
    fn next_down(self) -> Self {
        -self.neg().next_up()
    }
    fn is_finite_number(self) -> bool {
        self.0.is_finite()
    }
    fn to_unit(self) -> Self {
        Self(self.0.to_unit())
    }
}
