//! Eight `f32` side by side as plain arrays: on any processor, and what the others are compared
//! with.
//!
//! Tests, which do not look at its speed, compile in three quarters of the time because nothing has
//! to be inlined there.

use super::{F32x8, Mask, RowSimd, Simd, WIDTH};
use ccd_core::Num;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Sub};

/// Eight answers: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
pub struct Mask8([u32; WIDTH]);

/// `out[i] = f(a[i], b[i])`, in a loop of which compilers make vectors; closures they compile
/// apart.
macro_rules! each {
    (|$a:ident, $b:ident| $f:expr, $x:expr, $y:expr) => {{
        let (x, y) = ($x, $y);
        let mut out = [Default::default(); WIDTH];
        for i in 0..WIDTH {
            let ($a, $b) = (x[i], y[i]);
            out[i] = $f;
        }
        out
    }};
}

impl Add for F32x8 {
    type Output = Self;
    #[cfg_attr(not(test), inline(always))]
    fn add(self, other: Self) -> Self {
        Self(each!(|a, b| a + b, self.0, other.0))
    }
}

impl Sub for F32x8 {
    type Output = Self;
    #[cfg_attr(not(test), inline(always))]
    fn sub(self, other: Self) -> Self {
        Self(each!(|a, b| a - b, self.0, other.0))
    }
}

impl Mul for F32x8 {
    type Output = Self;
    #[cfg_attr(not(test), inline(always))]
    fn mul(self, other: Self) -> Self {
        Self(each!(|a, b| a * b, self.0, other.0))
    }
}

impl Div for F32x8 {
    type Output = Self;
    #[cfg_attr(not(test), inline(always))]
    fn div(self, other: Self) -> Self {
        Self(each!(|a, b| a / b, self.0, other.0))
    }
}

impl Neg for F32x8 {
    type Output = Self;
    #[cfg_attr(not(test), inline(always))]
    fn neg(self) -> Self {
        Self(each!(|a, _b| -a, self.0, self.0))
    }
}

impl BitAnd for Mask8 {
    type Output = Self;
    #[cfg_attr(not(test), inline(always))]
    fn bitand(self, other: Self) -> Self {
        Self(each!(|a, b| a & b, self.0, other.0))
    }
}

impl BitOr for Mask8 {
    type Output = Self;
    #[cfg_attr(not(test), inline(always))]
    fn bitor(self, other: Self) -> Self {
        Self(each!(|a, b| a | b, self.0, other.0))
    }
}

impl Mask for Mask8 {
    const ALL: u32 = 0xff;
    #[cfg_attr(not(test), inline(always))]
    fn bits(self) -> u32 {
        (0..WIDTH).fold(0, |bits, i| bits | (self.0[i] & 1) << i)
    }
}

impl Num for F32x8 {
    const UNIT: Self = Self([f32::UNIT; WIDTH]);
    const MIN_NORMAL: Self = Self([f32::MIN_NORMAL; WIDTH]);
    type Mask = Mask8;
    #[cfg_attr(not(test), inline(always))]
    fn gt(self, other: Self) -> Mask8 {
        Mask8(each!(|a, b| if a > b { u32::MAX } else { 0 }, self.0, other.0))
    }
    #[cfg_attr(not(test), inline(always))]
    fn splat(x: f32) -> Self {
        Self([x; WIDTH])
    }
    #[cfg_attr(not(test), inline(always))]
    fn abs(self) -> Self {
        Self(each!(|a, _b| f32::from_bits(a.to_bits() & 0x7fff_ffff), self.0, self.0))
    }
    #[cfg_attr(not(test), inline(always))]
    fn max(self, other: Self) -> Self {
        Self(each!(|a, b| if a > b { a } else { b }, self.0, other.0))
    }
    #[cfg_attr(not(test), inline(always))]
    fn min(self, other: Self) -> Self {
        Self(each!(|a, b| if a < b { a } else { b }, self.0, other.0))
    }
}

/// Plain Rust.
#[derive(Clone, Copy, Debug)]
pub struct Portable;

impl Simd for Portable {
    const NAME: &'static str = "portable";
    type Lanes = F32x8;
    const LANES: usize = WIDTH;

    #[cfg_attr(not(test), inline(always))]
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32]) -> [F32x8; WIDTH] {
        let mut out = [F32x8([0.0; WIDTH]); WIDTH];
        for (lane, &id) in ids[..WIDTH].iter().enumerate() {
            let row = &table[id as usize];
            for k in 0..WIDTH {
                out[k].0[lane] = row[k];
            }
        }
        out
    }
}

impl RowSimd for Portable {
    #[cfg_attr(not(test), inline(always))]
    fn load(self, x: &F32x8) -> F32x8 {
        *x
    }

    #[cfg_attr(not(test), inline(always))]
    fn store(self, x: F32x8) -> F32x8 {
        x
    }

    #[cfg_attr(not(test), inline(always))]
    fn equals(self, lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
        (0..WIDTH).fold(0, |bits, j| bits | ((lanes[j] == x[0] || lanes[j] == x[1]) as u32) << j)
    }
}
