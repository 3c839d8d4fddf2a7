//! The few operations that are written per instruction set, behind one trait: plain Rust, and AVX2 chosen at run time.
//!
//! Both give the same bits. `unsafe` in this crate is here and nowhere else: entering a function that needs AVX2 after asking the
//! processor, and one store past the length of a vector within its capacity.

use crate::lanes::{Lanes, WIDTH};
use ccd_core::layout::Pair;

/// Eight boxes side by side; a lane without a box holds the empty one.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub struct Block {
    /// `min[axis][lane]`
    pub min: [[f32; WIDTH]; 3],
    /// `max[axis][lane]`
    pub max: [[f32; WIDTH]; 3],
}

impl Block {
    /// Eight empty boxes.
    pub const EMPTY: Self = Self { min: [[f32::INFINITY; WIDTH]; 3], max: [[f32::NEG_INFINITY; WIDTH]; 3] };
}

/// An instruction set.
pub trait Simd: Copy + Send + Sync {
    /// Lanes of `b` whose closed boxes overlap that of lane `i` of `a`.
    fn overlaps(self, a: &Block, i: usize, b: &Block) -> u32;
    /// The same after each bound of lane `i` of `a` was moved inward by `shrink`.
    fn overlaps_shrunk(self, a: &Block, i: usize, b: &Block, shrink: f32) -> u32;
    /// Lanes in which `x` is one of the two.
    fn equals(self, lanes: &[u32; WIDTH], x: [u32; 2]) -> u32;
    /// Lanes that are greater than `x`; NaN is not.
    fn greater(self, lanes: Lanes, x: f32) -> u32;
    /// Appends `(a, b[j])` for every lane `j` in `mask`, ascending; lesser id first if `ORDERED`.
    fn append<const ORDERED: bool>(self, out: &mut Vec<Pair>, a: u32, b: &[u32; WIDTH], mask: u32);
    /// Rows `ids` of a table, transposed: component `k` of all rows in `out[k]`.
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32; WIDTH]) -> [Lanes; WIDTH];
    /// Runs `work` with the instruction set enabled for everything that is inlined into it.
    fn run<W: Work>(self, work: W) -> W::Out;
}

/// Something to run with an instruction set. `call` must be `#[inline(always)]`, or the set is not enabled inside.
pub trait Work {
    /// What it returns.
    type Out;
    /// Does the work.
    fn call<S: Simd>(self, simd: S) -> Self::Out;
}

/// Runs `$body` with `$simd` bound to the best instruction set of this processor.
macro_rules! dispatch {
    ($simd:ident => $body:expr) => {{
        #[cfg(target_arch = "x86_64")]
        {
            if let Some($simd) = $crate::simd::Avx2::new() {
                $body
            } else {
                let $simd = $crate::simd::Plain;
                $body
            }
        }
        #[cfg(not(target_arch = "x86_64"))]
        {
            let $simd = $crate::simd::Plain;
            $body
        }
    }};
}
pub(crate) use dispatch;

/// Portable Rust.
#[derive(Clone, Copy, Debug)]
pub struct Plain;

impl Simd for Plain {
    #[inline(always)]
    fn overlaps(self, a: &Block, i: usize, b: &Block) -> u32 {
        self.overlaps_shrunk(a, i, b, 0.0)
    }

    #[inline(always)]
    fn overlaps_shrunk(self, a: &Block, i: usize, b: &Block, shrink: f32) -> u32 {
        let mut mask = 0;
        for j in 0..WIDTH {
            let mut hit = true;
            for k in 0..3 {
                hit &= a.min[k][i] + shrink <= b.max[k][j];
                hit &= b.min[k][j] <= a.max[k][i] - shrink;
            }
            mask |= (hit as u32) << j;
        }
        mask
    }

    #[inline(always)]
    fn equals(self, lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
        let mut mask = 0;
        for j in 0..WIDTH {
            mask |= ((lanes[j] == x[0] || lanes[j] == x[1]) as u32) << j;
        }
        mask
    }

    #[inline(always)]
    fn greater(self, lanes: Lanes, x: f32) -> u32 {
        let mut mask = 0;
        for j in 0..WIDTH {
            mask |= ((lanes.0[j] > x) as u32) << j;
        }
        mask
    }

    #[inline(always)]
    fn append<const ORDERED: bool>(self, out: &mut Vec<Pair>, a: u32, b: &[u32; WIDTH], mut mask: u32) {
        while mask != 0 {
            let b = b[mask.trailing_zeros() as usize];
            out.push(if ORDERED { Pair::ordered(a, b) } else { Pair { a, b } });
            mask &= mask - 1;
        }
    }

    #[inline(always)]
    fn gather(self, table: &[[f32; WIDTH]], ids: &[u32; WIDTH]) -> [Lanes; WIDTH] {
        let mut out = [Lanes([0.0; WIDTH]); WIDTH];
        for (lane, &id) in ids.iter().enumerate() {
            let row = &table[id as usize];
            for k in 0..WIDTH {
                out[k].0[lane] = row[k];
            }
        }
        out
    }

    #[inline(always)]
    fn run<W: Work>(self, work: W) -> W::Out {
        work.call(self)
    }
}

#[cfg(target_arch = "x86_64")]
pub use avx2::Avx2;

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use super::{Block, Lanes, Pair, Simd, WIDTH, Work};
    use std::arch::x86_64::*;

    /// Proof that the processor has AVX2 and the bit instructions that came with it; only [`Avx2::new`] makes one.
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
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn load(x: &[f32; WIDTH]) -> __m256 {
        // SAFETY: eight floats are readable; the load needs no alignment.
        unsafe { _mm256_loadu_ps(x.as_ptr()) }
    }

    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn load_ids(x: &[u32; WIDTH]) -> __m256i {
        // SAFETY: eight words are readable; the load needs no alignment.
        unsafe { _mm256_loadu_si256(x.as_ptr().cast()) }
    }

    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn overlaps<const SHRUNK: bool>(a: &Block, i: usize, b: &Block, shrink: f32) -> u32 {
        let mut hit = _mm256_castsi256_ps(_mm256_set1_epi32(-1));
        for k in 0..3 {
            let (low, high) = (a.min[k][i], a.max[k][i]);
            let (low, high) = if SHRUNK { (low + shrink, high - shrink) } else { (low, high) };
            let (low, high) = (_mm256_set1_ps(low), _mm256_set1_ps(high));
            hit = _mm256_and_ps(hit, _mm256_cmp_ps::<_CMP_LE_OQ>(low, load(&b.max[k])));
            hit = _mm256_and_ps(hit, _mm256_cmp_ps::<_CMP_LE_OQ>(load(&b.min[k]), high));
        }
        _mm256_movemask_ps(hit) as u32
    }

    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn equals(lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
        let lanes = load_ids(lanes);
        let first = _mm256_cmpeq_epi32(lanes, _mm256_set1_epi32(x[0] as i32));
        let second = _mm256_cmpeq_epi32(lanes, _mm256_set1_epi32(x[1] as i32));
        _mm256_movemask_ps(_mm256_castsi256_ps(_mm256_or_si256(first, second))) as u32
    }

    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn greater(lanes: Lanes, x: f32) -> u32 {
        _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_GT_OQ>(load(&lanes.0), _mm256_set1_ps(x))) as u32
    }

    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn append<const ORDERED: bool>(out: &mut Vec<Pair>, a: u32, b: &[u32; WIDTH], mask: u32) {
        let mask = mask & 0xff;
        if out.capacity() - out.len() < WIDTH {
            out.reserve(WIDTH);
        }
        // SAFETY: the row of the table has eight readable bytes.
        let order = unsafe { _mm_loadl_epi64(FRONT[mask as usize].as_ptr().cast()) };
        let b = _mm256_permutevar8x32_epi32(load_ids(b), _mm256_cvtepu8_epi32(order));
        let a = _mm256_set1_epi32(a as i32);
        let (first, second) = if ORDERED { (_mm256_min_epu32(a, b), _mm256_max_epu32(a, b)) } else { (a, b) };
        let (low, high) = (_mm256_unpacklo_epi32(first, second), _mm256_unpackhi_epi32(first, second));
        let n = mask.count_ones() as usize;
        // SAFETY: room for eight pairs was made above; the first `n` of them are written before the length grows by `n`. A `Pair` is two
        // words without padding.
        unsafe {
            let end: *mut __m256i = out.as_mut_ptr().add(out.len()).cast();
            _mm256_storeu_si256(end, _mm256_permute2x128_si256::<0x20>(low, high));
            _mm256_storeu_si256(end.add(1), _mm256_permute2x128_si256::<0x31>(low, high));
            out.set_len(out.len() + n);
        }
    }

    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn gather(table: &[[f32; WIDTH]], ids: &[u32; WIDTH]) -> [Lanes; WIDTH] {
        let [r0, r1, r2, r3] = [row(table, ids[0]), row(table, ids[1]), row(table, ids[2]), row(table, ids[3])];
        let [r4, r5, r6, r7] = [row(table, ids[4]), row(table, ids[5]), row(table, ids[6]), row(table, ids[7])];
        // Transpose of 8 x 8: interleave pairs of rows, then quadruples, then halves.
        let [c0, c1, c2, c3] = quads(r0, r1, r2, r3);
        let [d0, d1, d2, d3] = quads(r4, r5, r6, r7);
        [
            lanes(_mm256_permute2f128_ps::<0x20>(c0, d0)),
            lanes(_mm256_permute2f128_ps::<0x20>(c1, d1)),
            lanes(_mm256_permute2f128_ps::<0x20>(c2, d2)),
            lanes(_mm256_permute2f128_ps::<0x20>(c3, d3)),
            lanes(_mm256_permute2f128_ps::<0x31>(c0, d0)),
            lanes(_mm256_permute2f128_ps::<0x31>(c1, d1)),
            lanes(_mm256_permute2f128_ps::<0x31>(c2, d2)),
            lanes(_mm256_permute2f128_ps::<0x31>(c3, d3)),
        ]
    }

    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn row(table: &[[f32; WIDTH]], id: u32) -> __m256 {
        load(&table[id as usize])
    }

    /// The four components of four rows, in each half: `[x x x x | x' x' x' x']`, and so on.
    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn quads(r0: __m256, r1: __m256, r2: __m256, r3: __m256) -> [__m256; 4] {
        let (p, q) = (_mm256_unpacklo_ps(r0, r1), _mm256_unpackhi_ps(r0, r1));
        let (s, t) = (_mm256_unpacklo_ps(r2, r3), _mm256_unpackhi_ps(r2, r3));
        [_mm256_shuffle_ps::<0x44>(p, s), _mm256_shuffle_ps::<0xee>(p, s), _mm256_shuffle_ps::<0x44>(q, t), _mm256_shuffle_ps::<0xee>(q, t)]
    }

    #[inline]
    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn lanes(x: __m256) -> Lanes {
        let mut out = Lanes([0.0; WIDTH]);
        // SAFETY: eight floats are writable; the store needs no alignment.
        unsafe { _mm256_storeu_ps(out.0.as_mut_ptr(), x) };
        out
    }

    #[target_feature(enable = "avx2,popcnt,bmi1,lzcnt")]
    fn run<W: Work>(simd: Avx2, work: W) -> W::Out {
        work.call(simd)
    }

    // SAFETY of every call below: `Avx2` exists only on a processor that has the instructions.
    impl Simd for Avx2 {
        #[inline(always)]
        fn overlaps(self, a: &Block, i: usize, b: &Block) -> u32 {
            // SAFETY: see above.
            unsafe { overlaps::<false>(a, i, b, 0.0) }
        }
        #[inline(always)]
        fn overlaps_shrunk(self, a: &Block, i: usize, b: &Block, shrink: f32) -> u32 {
            // SAFETY: see above.
            unsafe { overlaps::<true>(a, i, b, shrink) }
        }
        #[inline(always)]
        fn equals(self, lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
            // SAFETY: see above.
            unsafe { equals(lanes, x) }
        }
        #[inline(always)]
        fn greater(self, lanes: Lanes, x: f32) -> u32 {
            // SAFETY: see above.
            unsafe { greater(lanes, x) }
        }
        #[inline(always)]
        fn append<const ORDERED: bool>(self, out: &mut Vec<Pair>, a: u32, b: &[u32; WIDTH], mask: u32) {
            // SAFETY: see above.
            unsafe { append::<ORDERED>(out, a, b, mask) }
        }
        #[inline(always)]
        fn gather(self, table: &[[f32; WIDTH]], ids: &[u32; WIDTH]) -> [Lanes; WIDTH] {
            // SAFETY: see above.
            unsafe { gather(table, ids) }
        }
        #[inline(always)]
        fn run<W: Work>(self, work: W) -> W::Out {
            // SAFETY: see above.
            unsafe { run(self, work) }
        }
    }
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use super::*;

    /// A few distinct numbers, so that comparisons are often equal, and all that is special.
    const VALUES: [f32; 10] = [0.0, -0.0, 1.0, 1.5, -1.0, 2.0, f32::MAX, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];

    #[test]
    fn instruction_sets_give_the_same_bits() {
        let Some(avx2) = Avx2::new() else {
            println!("no AVX2 here: nothing to compare");
            return;
        };
        let mut x = 3u32;
        let mut bits = || {
            x = x.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (x >> 16) as usize
        };
        let (mut plain_pairs, mut avx2_pairs, mut n_overlaps) = (Vec::new(), Vec::new(), 0);
        for _ in 0..5000 {
            let mut value = || VALUES[bits() % VALUES.len()];
            let mut rows = || std::array::from_fn(|_| std::array::from_fn(|_| value()));
            let (a, b) = (Block { min: rows(), max: rows() }, Block { min: rows(), max: rows() });
            for i in 0..WIDTH {
                let mask = Plain.overlaps(&a, i, &b);
                n_overlaps += mask.count_ones();
                assert_eq!(mask, avx2.overlaps(&a, i, &b), "{a:?} {i} {b:?}");
                assert_eq!(Plain.overlaps_shrunk(&a, i, &b, 0.5), avx2.overlaps_shrunk(&a, i, &b, 0.5), "{a:?} {i} {b:?}");
            }
            let limit = value();
            assert_eq!(Plain.greater(Lanes(a.min[0]), limit), avx2.greater(Lanes(a.min[0]), limit), "{a:?} {limit}");
            let ids: [u32; WIDTH] = std::array::from_fn(|_| bits() as u32 % 5);
            let (id, mask) = (bits() as u32 % 5, bits() as u32 & 0xff);
            assert_eq!(Plain.equals(&ids, [id, 2]), avx2.equals(&ids, [id, 2]), "{ids:?} {id}");
            Plain.append::<true>(&mut plain_pairs, id, &ids, mask);
            avx2.append::<true>(&mut avx2_pairs, id, &ids, mask);
            Plain.append::<false>(&mut plain_pairs, id, &ids, mask);
            avx2.append::<false>(&mut avx2_pairs, id, &ids, mask);
            let table = [a.min[0], a.min[1], a.max[0], b.min[2], b.max[1]];
            let to_bits = |lanes: [Lanes; WIDTH]| lanes.map(|l| l.0.map(f32::to_bits));
            assert_eq!(to_bits(Plain.gather(&table, &ids)), to_bits(avx2.gather(&table, &ids)), "{table:?} {ids:?}");
        }
        assert_eq!(plain_pairs, avx2_pairs);
        assert!(n_overlaps > 100 && plain_pairs.len() > 1000, "{n_overlaps} overlaps, {} pairs", plain_pairs.len());
    }
}
