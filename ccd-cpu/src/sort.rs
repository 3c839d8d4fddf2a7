//! Parallel least-significant-digit radix sort of numbers by 63-bit keys. Stable, so the result
//! does not depend on threads.
//!
//! A word holds the upper 33 bits of a number's key and the number. It is sorted digit by digit;
//! numbers whose keys agree in those bits are few in most scenes, and are then sorted by their
//! whole keys, run by run, which are not made before. Digits that are equal in all keys are
//! skipped. Arrays are atomic words with relaxed access, which is plain loads and stores: threads
//! write disjoint places that no slice could express.

use crate::threads::Threads;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Bits of a digit: counts stay in the first-level cache.
const BITS: u32 = 11;
const BINS: usize = 1 << BITS;
/// Digits of the upper bits of a key.
const PASSES: usize = 3;
/// Bits of a key below those.
pub const LOW_BITS: u32 = 30;
/// Bits of a number.
const NUMBER_BITS: u32 = 31;
/// Numbers that can be sorted.
pub const MOST: usize = 1 << NUMBER_BITS;

/// Buffers of the sort, kept between calls.
#[derive(Debug, Default)]
pub struct RadixSort {
    words: [Vec<AtomicU64>; 2],
    workers: Vec<Worker>,
}

#[derive(Debug)]
struct Worker {
    counts: Box<[[u32; BINS]; PASSES]>,
    ties: Vec<(u64, u32)>,
}

/// Numbers whose keys are made at once.
pub const LANES: usize = 4;

/// Keys below `2^63`.
pub struct Keys<'a> {
    /// Their upper bits, those from [`LOW_BITS`] on. The last number may be asked for more than
    /// once.
    pub upper: &'a (dyn Fn([usize; LANES]) -> [u64; LANES] + Sync),
    /// All bits of one.
    pub whole: &'a (dyn Fn(usize) -> u64 + Sync),
}

/// Items per worker under which more threads cost more than they give.
const MIN_PART: usize = 8192;

impl RadixSort {
    /// Sorts `0 .. n` by `key(i) < 2^63` into `order`. More than [`MOST`] fail a check.
    pub fn sort(
        &mut self,
        threads: &Threads,
        n: usize,
        key: impl Fn(usize) -> u64 + Sync,
        order: &mut Vec<u32>,
    ) {
        let upper = |of: [usize; LANES]| of.map(|i| key(i) >> LOW_BITS);
        self.sort_keys(threads, n, &Keys { upper: &upper, whole: &key }, order);
    }

    /// The same. Compiled once for all keys.
    #[inline(never)]
    pub fn sort_keys(&mut self, threads: &Threads, n: usize, keys: &Keys, order: &mut Vec<u32>) {
        assert!(n <= MOST, "a sort of {n}, of {MOST} at most");
        for words in &mut self.words {
            threads.resize(words, n, AtomicU64::default);
        }
        let n_workers = threads.count().min(n.div_ceil(MIN_PART)).max(1);
        while self.workers.len() < n_workers {
            self.workers.push(Worker { counts: Box::new([[0; BINS]; PASSES]), ties: Vec::new() });
        }
        let workers = &mut self.workers[..n_workers];
        let part = n.div_ceil(n_workers).max(1);
        let range = |k: usize| (k * part).min(n)..((k + 1) * part).min(n);
        let words = &self.words;

        threads.each(workers, &|k, worker| {
            let end = range(k).end;
            for first in range(k).step_by(LANES) {
                let some = (keys.upper)(std::array::from_fn(|j| (first + j).min(end - 1)));
                for (i, upper) in (first..end).zip(some) {
                    words[0][i].store(upper << NUMBER_BITS | i as u64, Relaxed);
                }
            }
            count(&words[0][range(k)], &mut worker.counts, 0..PASSES);
        });
        let mut from = 0;
        let mut moved = false;
        for pass in 0..PASSES {
            let total =
                |bin: usize| workers.iter().map(|w| w.counts[pass][bin] as usize).sum::<usize>();
            let first_bin = (0..BINS).find(|&bin| total(bin) > 0).unwrap_or(0);
            if total(first_bin) == n {
                continue;
            }
            if moved && n_workers > 1 {
                // Words moved between workers: count this digit again where they are now.
                threads.each(workers, &|k, worker| {
                    count(&words[from][range(k)], &mut worker.counts, pass..pass + 1)
                });
            }
            moved = true;
            let mut next = 0;
            for bin in 0..BINS {
                for worker in workers.iter_mut() {
                    let here = worker.counts[pass][bin];
                    worker.counts[pass][bin] = next;
                    next += here;
                }
            }
            let to = 1 - from;
            threads.each(workers, &|k, worker| {
                let offsets = &mut worker.counts[pass];
                for word in &words[from][range(k)] {
                    let word = word.load(Relaxed);
                    let slot = &mut offsets[digit(word, pass)];
                    words[to][*slot as usize].store(word, Relaxed);
                    *slot += 1;
                }
            });
            from = to;
        }
        let sorted = &words[from];
        threads
            .each(workers, &|k, worker| sort_ties(sorted, range(k), keys.whole, &mut worker.ties));
        threads.resize(order, n, u32::default);
        threads.fill(order, |i| number(sorted[i].load(Relaxed)));
    }
}

#[inline]
fn digit(word: u64, pass: usize) -> usize {
    (word >> (NUMBER_BITS + BITS * pass as u32)) as usize & (BINS - 1)
}

/// The number in a word.
#[inline]
fn number(word: u64) -> u32 {
    word as u32 & ((1 << NUMBER_BITS) - 1)
}

/// Sorts every run of numbers with equal upper bits that begins in `range`, by whole keys.
fn sort_ties(
    words: &[AtomicU64],
    range: Range<usize>,
    key: &(dyn Fn(usize) -> u64 + Sync),
    ties: &mut Vec<(u64, u32)>,
) {
    let upper = |i: usize| words[i].load(Relaxed) >> NUMBER_BITS;
    let mut i = range.start;
    // A run that began before this range is sorted by whoever has its beginning.
    while i > 0 && i < range.end && upper(i) == upper(i - 1) {
        i += 1;
    }
    while i < range.end {
        let mut end = i + 1;
        while end < words.len() && upper(end) == upper(i) {
            end += 1;
        }
        if end - i > 1 {
            let first = upper(i) << NUMBER_BITS;
            let numbers = words[i..end].iter().map(|word| number(word.load(Relaxed)));
            ties.clear();
            ties.extend(numbers.map(|number| (key(number as usize), number)));
            ties.sort_unstable();
            for (word, &(_, number)) in words[i..end].iter().zip(ties.iter()) {
                word.store(first | number as u64, Relaxed);
            }
        }
        i = end;
    }
}

fn count(words: &[AtomicU64], counts: &mut [[u32; BINS]; PASSES], passes: Range<usize>) {
    for pass in passes.clone() {
        counts[pass].fill(0);
    }
    for word in words {
        let word = word.load(Relaxed);
        for pass in passes.clone() {
            counts[pass][digit(word, pass)] += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_sort(n: usize, bits: u32, n_threads: usize) {
        let mut x = 7u64;
        let keys: Vec<u64> = (0..n)
            .map(|_| {
                x = x
                    .wrapping_mul(6_364_136_223_846_793_005)
                    .wrapping_add(1_442_695_040_888_963_407);
                (x >> 1) & ((1 << bits) - 1)
            })
            .collect();
        let mut want: Vec<u32> = (0..n as u32).collect();
        want.sort_by_key(|&i| keys[i as usize]);
        let mut got = Vec::new();
        let threads = Threads::new(n_threads).unwrap();
        RadixSort::default().sort(&threads, n, |i| keys[i], &mut got);
        assert_eq!(got, want, "{n} keys of {bits} bits, {n_threads} threads");
    }

    #[test]
    fn equals_a_stable_sort() {
        for n_threads in [1, 2, 3] {
            for n in [0, 1, 2, 1000, 50_000] {
                for bits in [1, 13, 30, 63] {
                    check_sort(n, bits, n_threads);
                }
            }
        }
    }
}
