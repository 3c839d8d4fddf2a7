//! AVX2: eight `f32` in one register.

use super::{F32x8, RowSimd, Simd, WIDTH, Work};
use ccd_core::backend::layout::Pair;
use std::arch::x86_64::*;

/// Proof that the processor has AVX2 and the bit instructions that came with it; only [`Avx2::new`]
/// makes one.
#[derive(Clone, Copy, Debug)]
pub struct Avx2(());

impl Avx2 {
    /// `Some` if the processor has them.
    #[inline]
    pub fn new() -> Option<Self> {
        let all = std::is_x86_feature_detected!("avx2")
            && std::is_x86_feature_detected!("popcnt")
            && std::is_x86_feature_detected!("bmi1")
            && std::is_x86_feature_detected!("lzcnt");
        all.then_some(Self(()))
    }
}

/// Eight numbers.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct V8(__m256);

/// Eight answers: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct M8(__m256);

super::num!(
    V8(WIDTH),
    M8,
    neg,
    abs,
    _mm256_add_ps,
    _mm256_sub_ps,
    _mm256_mul_ps,
    _mm256_div_ps,
    _mm256_max_ps,
    _mm256_min_ps,
    _mm256_cmp_ps::<_CMP_GT_OQ>
);

super::num!(@mask M8(__m256), _mm256_and_ps, _mm256_or_ps, bits);

#[inline]
#[target_feature(enable = "avx2")]
fn bits(x: __m256) -> u32 {
    _mm256_movemask_ps(x) as u32
}

#[inline]
#[target_feature(enable = "avx2")]
fn neg(x: __m256) -> __m256 {
    _mm256_xor_ps(x, _mm256_set1_ps(-0.0))
}

#[inline]
#[target_feature(enable = "avx2")]
fn abs(x: __m256) -> __m256 {
    _mm256_andnot_ps(_mm256_set1_ps(-0.0), x)
}

/// For each mask, its set bits first: the permutation that moves chosen lanes to the front.
static FRONT: [[u8; WIDTH]; 256] = {
    let mut table = [[0u8; WIDTH]; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut n, mut bit) = (0, 0);
        while bit < WIDTH {
            if mask >> bit & 1 == 1 {
                table[mask][n] = bit as u8;
                n += 1;
            }
            bit += 1;
        }
        mask += 1;
    }
    table
};

#[inline]
#[target_feature(enable = "avx2")]
pub(super) fn load(x: &[f32; WIDTH]) -> __m256 {
    // SAFETY: eight floats are readable; the load needs no alignment.
    unsafe { _mm256_loadu_ps(x.as_ptr()) }
}

#[inline]
#[target_feature(enable = "avx2")]
fn store(x: __m256) -> F32x8 {
    let mut out = F32x8([0.0; WIDTH]);
    // SAFETY: eight floats are writable; the store needs no alignment.
    unsafe { _mm256_storeu_ps(out.0.as_mut_ptr(), x) };
    out
}

#[inline]
#[target_feature(enable = "avx2")]
fn load_ids(x: &[u32; WIDTH]) -> __m256i {
    // SAFETY: eight words are readable; the load needs no alignment.
    unsafe { _mm256_loadu_si256(x.as_ptr().cast()) }
}

#[inline]
#[target_feature(enable = "avx2")]
fn equals(lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
    let lanes = load_ids(lanes);
    let first = _mm256_cmpeq_epi32(lanes, _mm256_set1_epi32(x[0] as i32));
    let second = _mm256_cmpeq_epi32(lanes, _mm256_set1_epi32(x[1] as i32));
    _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_or_si256(first, second))) as u32
}

#[inline]
#[target_feature(enable = "avx2")]
fn store_ids(x: __m256i) -> [u32; WIDTH] {
    let mut out = [0; WIDTH];
    // SAFETY: eight words are writable; the store needs no alignment.
    unsafe { _mm256_storeu_si256(out.as_mut_ptr().cast(), x) };
    out
}

#[inline]
#[target_feature(enable = "avx2")]
fn places(bytes: u64) -> [[u32; WIDTH]; 2] {
    let each = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(bytes as i64));
    [store_ids(_mm256_srli_epi32::<3>(each)), store_ids(each)]
}

#[inline]
#[target_feature(enable = "avx2")]
fn pick_ids(ids: &[u32; WIDTH], at: &[u32; WIDTH]) -> [u32; WIDTH] {
    store_ids(_mm256_permutevar8x32_epi32(load_ids(ids), load_ids(at)))
}

#[inline]
#[target_feature(enable = "avx2")]
fn pick(x: &[f32; WIDTH], at: &[u32; WIDTH]) -> __m256 {
    _mm256_permutevar8x32_ps(load(x), load_ids(at))
}

#[inline]
#[target_feature(enable = "avx2")]
fn equals_each(a: &[u32; WIDTH], b: [&[u32; WIDTH]; 2]) -> u32 {
    let a = load_ids(a);
    let first = _mm256_cmpeq_epi32(a, load_ids(b[0]));
    let second = _mm256_cmpeq_epi32(a, load_ids(b[1]));
    _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_or_si256(first, second))) as u32
}

/// The permutation that moves the lanes of a mask to the front.
#[inline]
#[target_feature(enable = "avx2")]
fn front(mask: u32) -> __m256i {
    // SAFETY: the row of the table has eight readable bytes.
    let order = unsafe { _mm_loadl_epi64(FRONT[mask as usize & 0xff].as_ptr().cast()) };
    _mm256_cvtepu8_epi32(order)
}

/// Appends the first `n <= 8` pairs of two lists.
#[inline]
#[target_feature(enable = "avx2")]
fn append<const ORDERED: bool>(out: &mut Vec<Pair>, a: __m256i, b: __m256i, n: usize) {
    if out.capacity() - out.len() < WIDTH {
        out.reserve(WIDTH);
    }
    let (first, second) =
        if ORDERED { (_mm256_min_epu32(a, b), _mm256_max_epu32(a, b)) } else { (a, b) };
    let (low, high) = (_mm256_unpacklo_epi32(first, second), _mm256_unpackhi_epi32(first, second));
    debug_assert!(n <= WIDTH);
    // SAFETY: room for eight pairs was made above; they are written before the length grows by `n`,
    // which is at most eight. A `Pair` is two words without padding.
    unsafe {
        let end: *mut __m256i = out.as_mut_ptr().add(out.len()).cast();
        _mm256_storeu_si256(end, _mm256_permute2x128_si256::<0x20>(low, high));
        _mm256_storeu_si256(end.add(1), _mm256_permute2x128_si256::<0x31>(low, high));
        out.set_len(out.len() + n);
    }
}

#[inline]
#[target_feature(enable = "avx2,popcnt")]
fn append_row<const ORDERED: bool>(out: &mut Vec<Pair>, a: u32, b: &[u32; WIDTH], mask: u32) {
    let b = _mm256_permutevar8x32_epi32(load_ids(b), front(mask));
    append::<ORDERED>(out, _mm256_set1_epi32(a as i32), b, (mask & 0xff).count_ones() as usize);
}

#[inline]
#[target_feature(enable = "avx2,popcnt")]
fn append_each<const ORDERED: bool>(
    out: &mut Vec<Pair>,
    a: &[u32; WIDTH],
    b: &[u32; WIDTH],
    mask: u32,
) {
    let front = front(mask);
    let a = _mm256_permutevar8x32_epi32(load_ids(a), front);
    let b = _mm256_permutevar8x32_epi32(load_ids(b), front);
    append::<ORDERED>(out, a, b, (mask & 0xff).count_ones() as usize);
}

/// The four components of four rows, in each half: `[x x x x | x' x' x' x']`, and so on.
#[inline]
#[target_feature(enable = "avx2")]
fn quads(r0: __m256, r1: __m256, r2: __m256, r3: __m256) -> [__m256; 4] {
    let (p, q) = (_mm256_unpacklo_ps(r0, r1), _mm256_unpackhi_ps(r0, r1));
    let (s, t) = (_mm256_unpacklo_ps(r2, r3), _mm256_unpackhi_ps(r2, r3));
    [
        _mm256_shuffle_ps::<0x44>(p, s),
        _mm256_shuffle_ps::<0xee>(p, s),
        _mm256_shuffle_ps::<0x44>(q, t),
        _mm256_shuffle_ps::<0xee>(q, t),
    ]
}

#[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
fn run<W: Work<Avx2>>(simd: Avx2, work: W) -> W::Out {
    work.call(simd)
}

// SAFETY of every call below: `Avx2` exists only on a processor that has the instructions.
impl Simd for Avx2 {
    const NAME: &'static str = "AVX2";
    type Lanes = V8;
    const LANES: usize = WIDTH;

    // Inlined always, which a function that enables the set cannot be: the vectors stay in
    // registers.
    #[inline(always)]
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32]) -> [V8; WIDTH] {
        let ids = &ids[..WIDTH];
        // SAFETY: see above.
        unsafe {
            let r0 = load(&table[ids[0] as usize]);
            let r1 = load(&table[ids[1] as usize]);
            let r2 = load(&table[ids[2] as usize]);
            let r3 = load(&table[ids[3] as usize]);
            let r4 = load(&table[ids[4] as usize]);
            let r5 = load(&table[ids[5] as usize]);
            let r6 = load(&table[ids[6] as usize]);
            let r7 = load(&table[ids[7] as usize]);
            // Transpose of 8 x 8: interleave pairs of rows, then quadruples, then halves.
            let [c0, c1, c2, c3] = quads(r0, r1, r2, r3);
            let [d0, d1, d2, d3] = quads(r4, r5, r6, r7);
            [
                V8(_mm256_permute2f128_ps::<0x20>(c0, d0)),
                V8(_mm256_permute2f128_ps::<0x20>(c1, d1)),
                V8(_mm256_permute2f128_ps::<0x20>(c2, d2)),
                V8(_mm256_permute2f128_ps::<0x20>(c3, d3)),
                V8(_mm256_permute2f128_ps::<0x31>(c0, d0)),
                V8(_mm256_permute2f128_ps::<0x31>(c1, d1)),
                V8(_mm256_permute2f128_ps::<0x31>(c2, d2)),
                V8(_mm256_permute2f128_ps::<0x31>(c3, d3)),
            ]
        }
    }
    #[inline(always)]
    fn run<W: Work<Self>>(self, work: W) -> W::Out {
        // SAFETY: see above.
        unsafe { run(self, work) }
    }
}

impl RowSimd for Avx2 {
    #[inline(always)]
    fn load(self, x: &F32x8) -> V8 {
        // SAFETY: see above.
        V8(unsafe { load(&x.0) })
    }
    #[inline(always)]
    fn store(self, x: V8) -> F32x8 {
        // SAFETY: see above.
        unsafe { store(x.0) }
    }
    #[inline(always)]
    fn equals(self, lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
        // SAFETY: see above.
        unsafe { equals(lanes, x) }
    }
    #[inline(always)]
    fn append<const ORDERED: bool>(self, out: &mut Vec<Pair>, a: u32, b: &[u32; WIDTH], mask: u32) {
        // SAFETY: see above.
        unsafe { append_row::<ORDERED>(out, a, b, mask) }
    }

    const PICKS: bool = true;
    #[inline(always)]
    fn places(self, bytes: u64) -> [[u32; WIDTH]; 2] {
        // SAFETY: see above.
        unsafe { places(bytes) }
    }
    #[inline(always)]
    fn pick_ids(self, ids: &[u32; WIDTH], at: &[u32; WIDTH]) -> [u32; WIDTH] {
        // SAFETY: see above.
        unsafe { pick_ids(ids, at) }
    }
    #[inline(always)]
    fn pick(self, x: &F32x8, at: &[u32; WIDTH]) -> V8 {
        // SAFETY: see above.
        V8(unsafe { pick(&x.0, at) })
    }
    #[inline(always)]
    fn equals_each(self, a: &[u32; WIDTH], b: [&[u32; WIDTH]; 2]) -> u32 {
        // SAFETY: see above.
        unsafe { equals_each(a, b) }
    }
    #[inline(always)]
    fn append_each<const ORDERED: bool>(
        self,
        out: &mut Vec<Pair>,
        a: &[u32; WIDTH],
        b: &[u32; WIDTH],
        mask: u32,
    ) {
        // SAFETY: see above.
        unsafe { append_each::<ORDERED>(out, a, b, mask) }
    }
}
