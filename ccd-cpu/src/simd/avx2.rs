//! AVX2: eight `f32` in one register.

mod ids;

use super::{F32x8, RowSimd, Simd, WIDTH, Work};
use ccd_core::Aabb;
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
fn pick(x: &[f32; WIDTH], at: &[u32; WIDTH]) -> __m256 {
    _mm256_permutevar8x32_ps(load(x), ids::load_ids(at))
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

/// The bounds of a box, `[x y z X | z X Y Z]`.
#[inline]
#[target_feature(enable = "avx2")]
fn load_box(aabb: &Aabb<f32>) -> __m256 {
    let bounds: &[f32; 6] = bytemuck::cast_ref(aabb);
    // SAFETY: four floats are readable at each place.
    unsafe { _mm256_loadu2_m128(bounds.as_ptr().add(2), bounds.as_ptr()) }
}

#[inline]
#[target_feature(enable = "avx2")]
fn gather_boxes(boxes: &[Aabb<f32>], ids: &[u32; WIDTH]) -> Aabb<V8> {
    let rows = ids.map(|id| load_box(&boxes[id as usize]));
    let [c0, c1, c2, c3] = quads(rows[0], rows[1], rows[2], rows[3]);
    let [d0, d1, d2, d3] = quads(rows[4], rows[5], rows[6], rows[7]);
    Aabb {
        min: [
            V8(_mm256_permute2f128_ps::<0x20>(c0, d0)),
            V8(_mm256_permute2f128_ps::<0x20>(c1, d1)),
            V8(_mm256_permute2f128_ps::<0x20>(c2, d2)),
        ],
        max: [
            V8(_mm256_permute2f128_ps::<0x31>(c1, d1)),
            V8(_mm256_permute2f128_ps::<0x31>(c2, d2)),
            V8(_mm256_permute2f128_ps::<0x31>(c3, d3)),
        ],
    }
}

/// One number of each list, by `of` two, which may choose either.
#[inline]
#[target_feature(enable = "avx2")]
fn one_of_each(lists: [&F32x8; WIDTH], of: impl Fn(__m256, __m256) -> __m256) -> __m256 {
    let x = lists.map(|list| load(&list.0));
    let pair = |i: usize| {
        let (x, y) = (x[i], x[i + 1]);
        of(_mm256_unpacklo_ps(x, y), _mm256_unpackhi_ps(x, y))
    };
    let four = |i: usize| {
        let (x, y) = (pair(i), pair(i + 2));
        of(_mm256_shuffle_ps::<0x44>(x, y), _mm256_shuffle_ps::<0xee>(x, y))
    };
    let (x, y) = (four(0), four(4));
    of(_mm256_permute2f128_ps::<0x20>(x, y), _mm256_permute2f128_ps::<0x31>(x, y))
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
        unsafe { ids::equals(lanes, x) }
    }
    #[inline(always)]
    fn append<const ORDERED: bool>(self, out: &mut Vec<Pair>, a: u32, b: &[u32; WIDTH], mask: u32) {
        // SAFETY: see above.
        unsafe { ids::append_row::<ORDERED>(out, a, b, mask) }
    }

    #[inline(always)]
    fn gather_boxes(self, boxes: &[Aabb<f32>], ids: &[u32; WIDTH]) -> Aabb<V8> {
        // SAFETY: see above.
        unsafe { gather_boxes(boxes, ids) }
    }
    #[inline(always)]
    fn least_of_each(self, lists: [&F32x8; WIDTH]) -> V8 {
        // SAFETY: see above.
        V8(unsafe { one_of_each(lists, |x, y| _mm256_min_ps(x, y)) })
    }
    #[inline(always)]
    fn greatest_of_each(self, lists: [&F32x8; WIDTH]) -> V8 {
        // SAFETY: see above.
        V8(unsafe { one_of_each(lists, |x, y| _mm256_max_ps(x, y)) })
    }
    #[inline(always)]
    fn append_rows<const ORDERED: bool, const N: usize, const M: usize>(
        self,
        out: &mut Vec<Pair>,
        ids: [&[u32; WIDTH]; 2],
        of_a: [&[u32; WIDTH]; N],
        of_b: [&[u32; WIDTH]; M],
        masks: u64,
    ) -> usize {
        // SAFETY: see above.
        unsafe { ids::append_rows::<ORDERED, N, M>(out, ids, of_a, of_b, masks) }
    }

    const PICKS: bool = true;
    #[inline(always)]
    fn places(self, bytes: u64) -> [[u32; WIDTH]; 2] {
        // SAFETY: see above.
        unsafe { ids::places(bytes) }
    }
    #[inline(always)]
    fn pick_ids(self, ids: &[u32; WIDTH], at: &[u32; WIDTH]) -> [u32; WIDTH] {
        // SAFETY: see above.
        unsafe { ids::pick_ids(ids, at) }
    }
    #[inline(always)]
    fn pick(self, x: &F32x8, at: &[u32; WIDTH]) -> V8 {
        // SAFETY: see above.
        V8(unsafe { pick(&x.0, at) })
    }
    #[inline(always)]
    fn equals_each(self, a: &[u32; WIDTH], b: [&[u32; WIDTH]; 2]) -> u32 {
        // SAFETY: see above.
        unsafe { ids::equals_each(a, b) }
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
        unsafe { ids::append_each::<ORDERED>(out, a, b, mask) }
    }
}
