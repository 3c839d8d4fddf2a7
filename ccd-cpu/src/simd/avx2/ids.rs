//! Numbers of leaves by AVX2: eight in a register, compared, picked by their lanes, and appended to
//! lists of pairs.
//!
//! All of this may be called only where the processor has the instructions.

use crate::simd::{ROOM, WIDTH};
use ccd_core::backend::layout::Pair;
use std::arch::x86_64::*;

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
pub fn load_ids(x: &[u32; WIDTH]) -> __m256i {
    // SAFETY: eight words are readable; the load needs no alignment.
    unsafe { _mm256_loadu_si256(x.as_ptr().cast()) }
}

#[inline]
#[target_feature(enable = "avx2")]
pub fn equals(lanes: &[u32; WIDTH], x: [u32; 2]) -> u32 {
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
pub fn places(bytes: u64) -> [[u32; WIDTH]; 2] {
    let each = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(bytes as i64));
    [store_ids(_mm256_srli_epi32::<3>(each)), store_ids(each)]
}

#[inline]
#[target_feature(enable = "avx2")]
pub fn pick_ids(ids: &[u32; WIDTH], at: &[u32; WIDTH]) -> [u32; WIDTH] {
    store_ids(_mm256_permutevar8x32_epi32(load_ids(ids), load_ids(at)))
}

#[inline]
#[target_feature(enable = "avx2")]
pub fn equals_each(a: &[u32; WIDTH], b: [&[u32; WIDTH]; 2]) -> u32 {
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
    debug_assert!(n <= WIDTH);
    // SAFETY: room for eight pairs was made above; they are written before the length grows by `n`,
    // which is at most eight.
    unsafe {
        store_pairs::<ORDERED>(out.as_mut_ptr().add(out.len()).cast(), a, b);
        out.set_len(out.len() + n);
    }
}

/// Writes eight pairs: a [`Pair`] is two words without padding.
///
/// # Safety
///
/// Eight pairs must be writable there.
#[inline]
#[target_feature(enable = "avx2")]
unsafe fn store_pairs<const ORDERED: bool>(to: *mut __m256i, a: __m256i, b: __m256i) {
    let (first, second) =
        if ORDERED { (_mm256_min_epu32(a, b), _mm256_max_epu32(a, b)) } else { (a, b) };
    let (low, high) = (_mm256_unpacklo_epi32(first, second), _mm256_unpackhi_epi32(first, second));
    // SAFETY: as above.
    unsafe {
        _mm256_storeu_si256(to, _mm256_permute2x128_si256::<0x20>(low, high));
        _mm256_storeu_si256(to.add(1), _mm256_permute2x128_si256::<0x31>(low, high));
    }
}

#[inline]
#[target_feature(enable = "avx2,popcnt")]
pub fn append_row<const ORDERED: bool>(out: &mut Vec<Pair>, a: u32, b: &[u32; WIDTH], mask: u32) {
    let b = _mm256_permutevar8x32_epi32(load_ids(b), front(mask));
    append::<ORDERED>(out, _mm256_set1_epi32(a as i32), b, (mask & 0xff).count_ones() as usize);
}

#[inline]
#[target_feature(enable = "avx2,popcnt")]
pub fn append_each<const ORDERED: bool>(
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

#[inline]
#[target_feature(enable = "avx2,popcnt,bmi1")]
pub fn append_rows<const ORDERED: bool, const N: usize, const M: usize>(
    out: &mut Vec<Pair>,
    [a, b]: [&[u32; WIDTH]; 2],
    of_a: [&[u32; WIDTH]; N],
    of_b: [&[u32; WIDTH]; M],
    mut masks: u64,
) -> usize {
    assert!(out.capacity() - out.len() >= ROOM);
    let (b, of_b) = (load_ids(b), of_b.map(|ids| load_ids(ids)));
    let spare = out.spare_capacity_mut();
    let mut n = 0;
    while masks != 0 {
        let first = masks.trailing_zeros() as usize & !7;
        let row = (masks >> first) as u32 & 0xff;
        masks &= !(0xff << first);
        let lane = first / WIDTH % WIDTH;
        let mut common = _mm256_setzero_si256();
        for ids in of_a {
            let id = _mm256_set1_epi32(ids[lane] as i32);
            for ids in of_b {
                common = _mm256_or_si256(common, _mm256_cmpeq_epi32(ids, id));
            }
        }
        let row = row & !(_mm256_movemask_ps(_mm256_castsi256_ps(common)) as u32);
        let b = _mm256_permutevar8x32_epi32(b, front(row));
        // SAFETY: the rows before had at most eight pairs each, so that there is room for eight.
        unsafe {
            let end = spare.as_mut_ptr().add(n).cast();
            store_pairs::<ORDERED>(end, _mm256_set1_epi32(a[lane] as i32), b);
        }
        n += row.count_ones() as usize;
    }
    // SAFETY: so many more have been written.
    unsafe { out.set_len(out.len() + n) };
    n
}
