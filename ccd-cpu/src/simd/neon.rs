//! NEON: eight `f32` in two registers. Every AArch64 processor has it.

use super::{F32x8, RowSimd, Simd, WIDTH, transposed};
use std::arch::aarch64::*;

/// The instruction set.
#[derive(Clone, Copy, Debug)]
pub struct Neon(());

impl Neon {
    /// It is always there.
    #[inline]
    pub fn new() -> Self {
        Self(())
    }
}

/// Eight numbers.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct V8([float32x4_t; 2]);

/// Eight answers: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct M8([uint32x4_t; 2]);

super::num!(V8(WIDTH), M8, neg, abs, add, sub, mul, div, max, min, gt);
super::num!(@mask M8([uint32x4_t; 2]), and, or, bits);

/// A function of two vectors from one of their halves.
macro_rules! halves {
    ($name:ident, $in:ty => $out:ty, $of:expr) => {
        #[inline]
        #[target_feature(enable = "neon")]
        fn $name(x: [$in; 2], y: [$in; 2]) -> [$out; 2] {
            let of = $of;
            [of(x[0], y[0]), of(x[1], y[1])]
        }
    };
}
halves!(add, float32x4_t => float32x4_t, |x, y| vaddq_f32(x, y));
halves!(sub, float32x4_t => float32x4_t, |x, y| vsubq_f32(x, y));
halves!(mul, float32x4_t => float32x4_t, |x, y| vmulq_f32(x, y));
halves!(div, float32x4_t => float32x4_t, |x, y| vdivq_f32(x, y));
// By comparison: the instructions for maximum and minimum order zeros and pass on NaN.
halves!(max, float32x4_t => float32x4_t, |x, y| vbslq_f32(vcgtq_f32(x, y), x, y));
halves!(min, float32x4_t => float32x4_t, |x, y| vbslq_f32(vcltq_f32(x, y), x, y));
halves!(gt, float32x4_t => uint32x4_t, |x, y| vcgtq_f32(x, y));
halves!(and, uint32x4_t => uint32x4_t, |x, y| vandq_u32(x, y));
halves!(or, uint32x4_t => uint32x4_t, |x, y| vorrq_u32(x, y));

#[inline]
#[target_feature(enable = "neon")]
fn neg(x: [float32x4_t; 2]) -> [float32x4_t; 2] {
    [vnegq_f32(x[0]), vnegq_f32(x[1])]
}

#[inline]
#[target_feature(enable = "neon")]
fn abs(x: [float32x4_t; 2]) -> [float32x4_t; 2] {
    [vabsq_f32(x[0]), vabsq_f32(x[1])]
}

/// One bit a lane: each answer keeps a bit of its own, and the lanes are added.
#[inline]
#[target_feature(enable = "neon")]
fn bits(x: [uint32x4_t; 2]) -> u32 {
    const LOW: [u32; 4] = [1, 2, 4, 8];
    const HIGH: [u32; 4] = [16, 32, 64, 128];
    // SAFETY: four words are readable in each.
    let (low, high) = unsafe { (vld1q_u32(LOW.as_ptr()), vld1q_u32(HIGH.as_ptr())) };
    vaddvq_u32(vorrq_u32(vandq_u32(x[0], low), vandq_u32(x[1], high)))
}

#[inline]
#[target_feature(enable = "neon")]
fn load(x: &[f32; WIDTH]) -> V8 {
    // SAFETY: eight floats are readable.
    V8(unsafe { [vld1q_f32(x.as_ptr()), vld1q_f32(x.as_ptr().add(4))] })
}

#[inline]
#[target_feature(enable = "neon")]
fn store(x: V8) -> F32x8 {
    let mut out = F32x8([0.0; WIDTH]);
    // SAFETY: eight floats are writable.
    unsafe {
        vst1q_f32(out.0.as_mut_ptr(), x.0[0]);
        vst1q_f32(out.0.as_mut_ptr().add(4), x.0[1]);
    }
    out
}

#[inline]
#[target_feature(enable = "neon")]
fn equals(lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
    // SAFETY: eight words are readable.
    let lanes = unsafe { [vld1q_u32(lanes.as_ptr()), vld1q_u32(lanes.as_ptr().add(4))] };
    let (x0, x1) = (vdupq_n_u32(x[0]), vdupq_n_u32(x[1]));
    let first = vorrq_u32(vceqq_u32(lanes[0], x0), vceqq_u32(lanes[0], x1));
    let second = vorrq_u32(vceqq_u32(lanes[1], x0), vceqq_u32(lanes[1], x1));
    bits([first, second])
}

#[inline]
#[target_feature(enable = "neon")]
fn gather(table: &[[f32; WIDTH]], ids: &[u32]) -> [V8; WIDTH] {
    transposed(table, ids, |row| load(row).0, |rows| quads(rows)).map(V8)
}

/// Transpose of 4 x 4: interleave rows 0 and 2, 1 and 3, then the results.
#[inline]
#[target_feature(enable = "neon")]
fn quads([r0, r1, r2, r3]: [float32x4_t; 4]) -> [float32x4_t; 4] {
    let (p, q) = (vzip1q_f32(r0, r2), vzip2q_f32(r0, r2));
    let (s, t) = (vzip1q_f32(r1, r3), vzip2q_f32(r1, r3));
    [vzip1q_f32(p, s), vzip2q_f32(p, s), vzip1q_f32(q, t), vzip2q_f32(q, t)]
}

// SAFETY of every call below: every AArch64 processor has NEON.
impl Simd for Neon {
    const NAME: &'static str = "NEON";
    type Lanes = V8;
    const LANES: usize = WIDTH;

    #[inline(always)]
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32]) -> [V8; WIDTH] {
        // SAFETY: see above.
        unsafe { gather(table, ids) }
    }
}

impl RowSimd for Neon {
    #[inline(always)]
    fn load(self, x: &F32x8) -> V8 {
        // SAFETY: see above.
        unsafe { load(&x.0) }
    }
    #[inline(always)]
    fn store(self, x: V8) -> F32x8 {
        // SAFETY: see above.
        unsafe { store(x) }
    }
    #[inline(always)]
    fn equals(self, lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
        // SAFETY: see above.
        unsafe { equals(lanes, x) }
    }
}
