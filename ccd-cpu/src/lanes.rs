//! Eight `f32` side by side, for the bodies of `ccd-core` that are generic over `Num`.
//!
//! Plain arrays: every operation rounds as IEEE 754 says, nothing is contracted, so results are the same on every processor. The compiler turns
//! each operation into one instruction where the calling function has the instruction set enabled.

use ccd_core::Num;
use std::ops::{Add, Mul, Neg, Sub};

/// Number of lanes.
pub const WIDTH: usize = 8;

/// Eight numbers.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct Lanes(pub [f32; WIDTH]);

impl Lanes {
    #[inline(always)]
    fn zip(self, other: Self, f: impl Fn(f32, f32) -> f32) -> Self {
        let mut out = [0.0; WIDTH];
        for i in 0..WIDTH {
            out[i] = f(self.0[i], other.0[i]);
        }
        Self(out)
    }
}

impl Add for Lanes {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl Sub for Lanes {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl Neg for Lanes {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.zip(self, |a, _| -a)
    }
}

impl Num for Lanes {
    const UNIT: Self = Self([f32::UNIT; WIDTH]);
    const MIN_NORMAL: Self = Self([f32::MIN_NORMAL; WIDTH]);
    type Mask = u32;
    #[inline(always)]
    fn gt(self, other: Self) -> u32 {
        let mut mask = 0;
        for i in 0..WIDTH {
            mask |= ((self.0[i] > other.0[i]) as u32) << i;
        }
        mask
    }
    #[inline(always)]
    fn splat(x: f32) -> Self {
        Self([x; WIDTH])
    }
    #[inline(always)]
    fn abs(self) -> Self {
        self.zip(self, |a, _| f32::from_bits(a.to_bits() & 0x7fff_ffff))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        self.zip(other, |a, b| if a > b { a } else { b })
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        self.zip(other, |a, b| if a < b { a } else { b })
    }
}
