//! Cooperative: least-significant-digit radix sort of 32-bit keys with their ids, stable, 8 bits a
//! pass, in three kernels a pass.
//!
//! `sort_count` counts the digits of each tile, `sort_scan` turns the counts of each digit into
//! offsets, `sort_scatter` ranks each tile, brings it into order in workgroup memory and moves it,
//! so that neighbouring threads write neighbouring words. Nothing waits for another workgroup
//! (reduce, then scan), and nothing depends on the size of subgroups: the ranks within 32 keys come
//! from a mask of lanes for each digit in workgroup memory: a digit's mask has a bit for every of
//! 32 threads that has the digit.

/// Digits of a pass.
pub const DIGITS: u32 = 256;
/// Threads of a workgroup of the count.
pub const COUNT_THREADS: u32 = 128;
/// Keys of each of them.
pub const COUNT_KEYS: u32 = 16;
/// Threads of a workgroup of the scatter. A device runs as many workgroups at a time as their
/// memory allows, so that more threads for the same tile hide more of what each waits for.
pub const THREADS: u32 = 256;
/// Keys of each of them.
pub const KEYS: u32 = 8;
/// Keys of a workgroup.
pub const TILE: u32 = THREADS * KEYS;

const _: () = assert!(TILE == COUNT_THREADS * COUNT_KEYS);

/// The digit of `key` at bit `shift`.
#[inline(always)]
pub fn digit(key: u32, shift: u32) -> u32 {
    (key >> shift) & (DIGITS - 1)
}

/// Where key `k` of thread `lane` is in its tile: 32 threads share a run of `32 KEYS` keys, so that
/// their steps follow one another.
#[inline(always)]
pub fn place(lane: u32, k: u32) -> u32 {
    (lane / 32) * (32 * KEYS) + k * 32 + lane % 32
}

/// Lanes before `lane` in a mask of 32.
#[inline(always)]
pub fn before(mask: u32, lane: u32) -> u32 {
    (mask & ((1 << (lane % 32)) - 1)).count_ones()
}
