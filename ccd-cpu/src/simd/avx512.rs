//! AVX-512: sixteen `f32` in one register, for filters; rows of boxes stay with AVX2.

use super::avx2::load;
use super::{Simd, WIDTH, Work};
use std::arch::x86_64::*;

/// Proof that the processor has AVX-512 (F and DQ) and what [`super::Avx2`] proves; only
/// [`Avx512::new`] makes one.
#[derive(Clone, Copy, Debug)]
pub struct Avx512(());

impl Avx512 {
    /// `Some` if the processor has them.
    #[inline]
    pub fn new() -> Option<Self> {
        let all = super::Avx2::new().is_some()
            && std::is_x86_feature_detected!("avx512f")
            && std::is_x86_feature_detected!("avx512dq");
        all.then_some(Self(()))
    }
}

/// Numbers in a register.
const LANES: usize = 16;

/// Sixteen numbers.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct V16(__m512);

super::num!(
    V16(LANES),
    u16,
    neg,
    abs,
    _mm512_add_ps,
    _mm512_sub_ps,
    _mm512_mul_ps,
    _mm512_div_ps,
    _mm512_max_ps,
    _mm512_min_ps,
    _mm512_cmp_ps_mask::<_CMP_GT_OQ>
);

#[inline]
#[target_feature(enable = "avx512f,avx512dq")]
fn neg(x: __m512) -> __m512 {
    _mm512_xor_ps(x, _mm512_set1_ps(-0.0))
}

#[inline]
#[target_feature(enable = "avx512f,avx512dq")]
fn abs(x: __m512) -> __m512 {
    _mm512_andnot_ps(_mm512_set1_ps(-0.0), x)
}

/// The rows of two ids, side by side.
#[inline]
#[target_feature(enable = "avx2,avx512f,avx512dq")]
fn two(table: &[[f32; WIDTH]], low: u32, high: u32) -> __m512 {
    let (low, high) = (load(&table[low as usize]), load(&table[high as usize]));
    _mm512_insertf32x8::<1>(_mm512_castps256_ps512(low), high)
}

/// The four components of four rows, in each quarter.
#[inline]
#[target_feature(enable = "avx512f")]
fn quads(r0: __m512, r1: __m512, r2: __m512, r3: __m512) -> [__m512; 4] {
    let (p, q) = (_mm512_unpacklo_ps(r0, r1), _mm512_unpackhi_ps(r0, r1));
    let (s, t) = (_mm512_unpacklo_ps(r2, r3), _mm512_unpackhi_ps(r2, r3));
    [
        _mm512_shuffle_ps::<0x44>(p, s),
        _mm512_shuffle_ps::<0xee>(p, s),
        _mm512_shuffle_ps::<0x44>(q, t),
        _mm512_shuffle_ps::<0xee>(q, t),
    ]
}

#[target_feature(enable = "avx2,popcnt,bmi1,lzcnt,avx512f,avx512dq")]
fn run<W: Work<Avx512>>(simd: Avx512, work: W) -> W::Out {
    work.call(simd)
}

// SAFETY of both calls below: `Avx512` exists only on a processor that has the instructions.
impl Simd for Avx512 {
    const NAME: &'static str = "AVX-512";
    type Lanes = V16;
    const LANES: usize = LANES;

    // Inlined always, which a function that enables the set cannot be: the vectors stay in
    // registers.
    #[inline(always)]
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32]) -> [V16; WIDTH] {
        let ids = &ids[..LANES];
        // SAFETY: see above.
        unsafe {
            // Rows `i` and `i + 4` share a register, so that the last shuffle leaves lanes in
            // order.
            let r0 = two(table, ids[0], ids[4]);
            let r1 = two(table, ids[1], ids[5]);
            let r2 = two(table, ids[2], ids[6]);
            let r3 = two(table, ids[3], ids[7]);
            let r4 = two(table, ids[8], ids[12]);
            let r5 = two(table, ids[9], ids[13]);
            let r6 = two(table, ids[10], ids[14]);
            let r7 = two(table, ids[11], ids[15]);
            let [c0, c1, c2, c3] = quads(r0, r1, r2, r3);
            let [d0, d1, d2, d3] = quads(r4, r5, r6, r7);
            [
                V16(_mm512_shuffle_f32x4::<0b10_00_10_00>(c0, d0)),
                V16(_mm512_shuffle_f32x4::<0b10_00_10_00>(c1, d1)),
                V16(_mm512_shuffle_f32x4::<0b10_00_10_00>(c2, d2)),
                V16(_mm512_shuffle_f32x4::<0b10_00_10_00>(c3, d3)),
                V16(_mm512_shuffle_f32x4::<0b11_01_11_01>(c0, d0)),
                V16(_mm512_shuffle_f32x4::<0b11_01_11_01>(c1, d1)),
                V16(_mm512_shuffle_f32x4::<0b11_01_11_01>(c2, d2)),
                V16(_mm512_shuffle_f32x4::<0b11_01_11_01>(c3, d3)),
            ]
        }
    }
    #[inline(always)]
    fn run<W: Work<Self>>(self, work: W) -> W::Out {
        // SAFETY: see above.
        unsafe { run(self, work) }
    }
}
