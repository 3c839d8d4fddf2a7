//! SIMD of WebAssembly: eight `f32` in two vectors, in modules built with `simd128`.
#![allow(unused_unsafe, reason = "other sets need it in the macro `num`; calls here are safe")]

use super::{F32x8, RowSimd, Simd, WIDTH, transposed};
use std::arch::wasm32::*;

/// The instruction set: a module that has it is refused as a whole where there is none.
#[derive(Clone, Copy, Debug)]
pub struct Simd128;

/// Eight numbers.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct V8([v128; 2]);

/// Eight answers: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct M8([v128; 2]);

super::num!(V8(WIDTH), M8, neg, abs, add, sub, mul, div, max, min, gt);
super::num!(@mask M8([v128; 2]), and, or, bits);

/// A function of two vectors from one of their halves.
macro_rules! halves {
    ($name:ident, $of:expr) => {
        #[inline(always)]
        fn $name(x: [v128; 2], y: [v128; 2]) -> [v128; 2] {
            let of = $of;
            [of(x[0], y[0]), of(x[1], y[1])]
        }
    };
}
halves!(add, f32x4_add);
halves!(sub, f32x4_sub);
halves!(mul, f32x4_mul);
halves!(div, f32x4_div);
// `y < x ? x : y` and `x < y ? x : y`: the greater or smaller by one comparison.
halves!(max, |x, y| f32x4_pmax(y, x));
halves!(min, |x, y| f32x4_pmin(y, x));
halves!(gt, f32x4_gt);
halves!(and, v128_and);
halves!(or, v128_or);

#[inline(always)]
fn neg(x: [v128; 2]) -> [v128; 2] {
    [f32x4_neg(x[0]), f32x4_neg(x[1])]
}

#[inline(always)]
fn abs(x: [v128; 2]) -> [v128; 2] {
    [f32x4_abs(x[0]), f32x4_abs(x[1])]
}

/// One bit a lane.
#[inline(always)]
fn bits(x: [v128; 2]) -> u32 {
    u32::from(i32x4_bitmask(x[0]) | i32x4_bitmask(x[1]) << 4)
}

/// Two vectors from eight words.
#[inline(always)]
fn load<T: Copy>(x: &[T; WIDTH]) -> [v128; 2] {
    const { assert!(size_of::<T>() == 4) };
    let words: *const v128 = x.as_ptr().cast();
    // SAFETY: eight words are readable; no alignment is needed.
    unsafe { [v128_load(words), v128_load(words.add(1))] }
}

/// Transpose of 4 x 4: interleave rows 0 and 2, 1 and 3, then the results.
#[inline(always)]
fn quads([r0, r1, r2, r3]: [v128; 4]) -> [v128; 4] {
    let (p, q) = (low(r0, r2), high(r0, r2));
    let (s, t) = (low(r1, r3), high(r1, r3));
    [low(p, s), high(p, s), low(q, t), high(q, t)]
}

/// The first halves, interleaved.
#[inline(always)]
fn low(x: v128, y: v128) -> v128 {
    i32x4_shuffle::<0, 4, 1, 5>(x, y)
}

/// The second halves, interleaved.
#[inline(always)]
fn high(x: v128, y: v128) -> v128 {
    i32x4_shuffle::<2, 6, 3, 7>(x, y)
}

impl Simd for Simd128 {
    const NAME: &'static str = "simd128";
    type Lanes = V8;
    const LANES: usize = WIDTH;

    #[inline(always)]
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32]) -> [V8; WIDTH] {
        transposed(table, ids, load, quads).map(V8)
    }
}

impl RowSimd for Simd128 {
    #[inline(always)]
    fn load(self, x: &F32x8) -> V8 {
        V8(load(&x.0))
    }
    #[inline(always)]
    fn store(self, x: V8) -> F32x8 {
        let mut out = F32x8([0.0; WIDTH]);
        let words: *mut v128 = out.0.as_mut_ptr().cast();
        // SAFETY: eight floats are writable.
        unsafe {
            v128_store(words, x.0[0]);
            v128_store(words.add(1), x.0[1]);
        }
        out
    }
    #[inline(always)]
    fn equals(self, lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
        let (x0, x1) = (u32x4_splat(x[0]), u32x4_splat(x[1]));
        bits(load(lanes).map(|half| v128_or(u32x4_eq(half, x0), u32x4_eq(half, x1))))
    }
}
