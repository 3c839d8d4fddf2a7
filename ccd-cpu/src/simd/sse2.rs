//! SSE2: eight `f32` in two registers. Every x86-64 processor has it.

use super::{F32x8, RowSimd, Simd, WIDTH, transposed};
use std::arch::x86_64::*;

/// The instruction set.
#[derive(Clone, Copy, Debug)]
pub struct Sse2;

/// Eight numbers.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct V8([__m128; 2]);

/// Eight answers: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct M8([__m128; 2]);

super::num!(V8(WIDTH), M8, neg, abs, add, sub, mul, div, max, min, gt);
super::num!(@mask M8([__m128; 2]), and, or, bits);

/// A function of two vectors from one of their halves.
macro_rules! halves {
    ($name:ident, $of:expr) => {
        #[inline]
        #[target_feature(enable = "sse2")]
        fn $name(x: [__m128; 2], y: [__m128; 2]) -> [__m128; 2] {
            [$of(x[0], y[0]), $of(x[1], y[1])]
        }
    };
}
halves!(add, _mm_add_ps);
halves!(sub, _mm_sub_ps);
halves!(mul, _mm_mul_ps);
halves!(div, _mm_div_ps);
halves!(max, _mm_max_ps);
halves!(min, _mm_min_ps);
halves!(gt, _mm_cmpgt_ps);
halves!(and, _mm_and_ps);
halves!(or, _mm_or_ps);

#[inline]
#[target_feature(enable = "sse2")]
fn neg(x: [__m128; 2]) -> [__m128; 2] {
    x.map(|half| _mm_xor_ps(half, _mm_set1_ps(-0.0)))
}

#[inline]
#[target_feature(enable = "sse2")]
fn abs(x: [__m128; 2]) -> [__m128; 2] {
    x.map(|half| _mm_andnot_ps(_mm_set1_ps(-0.0), half))
}

/// One bit a lane.
#[inline]
#[target_feature(enable = "sse2")]
fn bits(x: [__m128; 2]) -> u32 {
    (_mm_movemask_ps(x[0]) | _mm_movemask_ps(x[1]) << 4) as u32
}

#[inline]
#[target_feature(enable = "sse2")]
fn load(x: &[f32; WIDTH]) -> [__m128; 2] {
    // SAFETY: eight floats are readable; the loads need no alignment.
    unsafe { [_mm_loadu_ps(x.as_ptr()), _mm_loadu_ps(x.as_ptr().add(4))] }
}

/// Transpose of 4 x 4: interleave rows 0 and 1, 2 and 3, then the results.
#[inline]
#[target_feature(enable = "sse2")]
fn quads([r0, r1, r2, r3]: [__m128; 4]) -> [__m128; 4] {
    let (p, q) = (_mm_unpacklo_ps(r0, r1), _mm_unpackhi_ps(r0, r1));
    let (s, t) = (_mm_unpacklo_ps(r2, r3), _mm_unpackhi_ps(r2, r3));
    [_mm_movelh_ps(p, s), _mm_movehl_ps(s, p), _mm_movelh_ps(q, t), _mm_movehl_ps(t, q)]
}

#[inline]
#[target_feature(enable = "sse2")]
fn gather(table: &[[f32; WIDTH]], ids: &[u32]) -> [V8; WIDTH] {
    transposed(table, ids, |row| load(row), |rows| quads(rows)).map(V8)
}

#[inline]
#[target_feature(enable = "sse2")]
fn store(x: V8) -> F32x8 {
    let mut out = F32x8([0.0; WIDTH]);
    // SAFETY: eight floats are writable; the stores need no alignment.
    unsafe {
        _mm_storeu_ps(out.0.as_mut_ptr(), x.0[0]);
        _mm_storeu_ps(out.0.as_mut_ptr().add(4), x.0[1]);
    }
    out
}

#[inline]
#[target_feature(enable = "sse2")]
fn equals(lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
    // SAFETY: eight words are readable; the loads need no alignment.
    let load = |i: usize| unsafe { _mm_loadu_si128(lanes[i..i + 4].as_ptr().cast()) };
    let (x0, x1) = (_mm_set1_epi32(x[0] as i32), _mm_set1_epi32(x[1] as i32));
    let equal = |half| _mm_or_si128(_mm_cmpeq_epi32(half, x0), _mm_cmpeq_epi32(half, x1));
    bits([load(0), load(4)].map(|half| _mm_castsi128_ps(equal(half))))
}

// SAFETY of every call below: every x86-64 processor has SSE2.
impl Simd for Sse2 {
    const NAME: &'static str = "SSE2";
    type Lanes = V8;
    const LANES: usize = WIDTH;

    #[inline(always)]
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32]) -> [V8; WIDTH] {
        // SAFETY: see above.
        unsafe { gather(table, ids) }
    }
}

impl RowSimd for Sse2 {
    #[inline(always)]
    fn load(self, x: &F32x8) -> V8 {
        // SAFETY: see above.
        V8(unsafe { load(&x.0) })
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
