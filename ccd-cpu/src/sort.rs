//! Parallel least-significant-digit radix sort of 64-bit keys with 32-bit values; stable, so the
//! result does not depend on threads.
//!
//! Only the upper 33 bits are sorted digit by digit; keys that agree in them are few in most scenes
//! and are then sorted by comparison, run by run. Digits that are equal in all keys are skipped.
//! Arrays are atomic words with relaxed access, which is plain loads and stores: threads write
//! disjoint places that no slice could express.

use crate::threads::Threads;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering::Relaxed};

/// Bits of a digit: counts stay in the first-level cache.
const BITS: u32 = 11;
const BINS: usize = 1 << BITS;
/// Digits sorted: bits 30 to 63.
const PASSES: usize = 3;
/// Bits below the sorted digits.
const LOW_BITS: u32 = 30;

/// Buffers of the sort, kept between calls.
#[derive(Debug, Default)]
pub struct RadixSort {
    keys: [Vec<AtomicU64>; 2],
    values: [Vec<AtomicU32>; 2],
    workers: Vec<Worker>,
}

#[derive(Debug)]
struct Worker {
    counts: Box<[[u32; BINS]; PASSES]>,
    ties: Vec<(u64, u32)>,
}

/// Items whose keys are made at once.
pub const LANES: usize = 4;

/// What makes them.
pub type Keys<'a> = dyn Fn([usize; LANES]) -> [u64; LANES] + Sync + 'a;

/// Items per worker under which more threads cost more than they give.
const MIN_PART: usize = 8192;

impl RadixSort {
    /// Sorts `0 .. n` by `key(i) < 2^63` into `order`.
    pub fn sort(
        &mut self,
        threads: &Threads,
        n: usize,
        key: impl Fn(usize) -> u64 + Sync,
        order: &mut Vec<u32>,
    ) {
        self.sort_keys(threads, n, &|of| of.map(&key), order);
    }

    /// The same by the keys of [`LANES`] items at once; the last one may be asked for more than
    /// once. Compiled once for all keys.
    #[inline(never)]
    pub fn sort_keys(&mut self, threads: &Threads, n: usize, keys_of: &Keys, order: &mut Vec<u32>) {
        for half in 0..2 {
            threads.resize(&mut self.keys[half], n, AtomicU64::default);
            threads.resize(&mut self.values[half], n, AtomicU32::default);
        }
        let n_workers = threads.count().min(n.div_ceil(MIN_PART)).max(1);
        while self.workers.len() < n_workers {
            self.workers.push(Worker { counts: Box::new([[0; BINS]; PASSES]), ties: Vec::new() });
        }
        let workers = &mut self.workers[..n_workers];
        let part = n.div_ceil(n_workers).max(1);
        let range = |k: usize| (k * part).min(n)..((k + 1) * part).min(n);
        let (keys, values) = (&self.keys, &self.values);

        threads.each(workers, &|k, worker| {
            let end = range(k).end;
            for first in range(k).step_by(LANES) {
                let some = keys_of(std::array::from_fn(|j| (first + j).min(end - 1)));
                for (i, key) in (first..end).zip(some) {
                    keys[0][i].store(key, Relaxed);
                    values[0][i].store(i as u32, Relaxed);
                }
            }
            count(&keys[0][range(k)], &mut worker.counts, 0..PASSES);
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
                // Keys moved between workers: count this digit again where they are now.
                threads.each(workers, &|k, worker| {
                    count(&keys[from][range(k)], &mut worker.counts, pass..pass + 1)
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
                for i in range(k) {
                    let key = keys[from][i].load(Relaxed);
                    let slot = &mut offsets[digit(key, pass)];
                    keys[to][*slot as usize].store(key, Relaxed);
                    values[to][*slot as usize].store(values[from][i].load(Relaxed), Relaxed);
                    *slot += 1;
                }
            });
            from = to;
        }
        threads.each(workers, &|k, worker| {
            sort_ties(&keys[from], &values[from], range(k), &mut worker.ties)
        });
        threads.resize(order, n, u32::default);
        threads.fill(order, |i| values[from][i].load(Relaxed));
    }
}

#[inline]
fn digit(key: u64, pass: usize) -> usize {
    (key >> (LOW_BITS + BITS * pass as u32)) as usize & (BINS - 1)
}

/// Sorts every run of keys with equal upper bits that begins in `range`.
fn sort_ties(
    keys: &[AtomicU64],
    values: &[AtomicU32],
    range: std::ops::Range<usize>,
    ties: &mut Vec<(u64, u32)>,
) {
    let upper = |i: usize| keys[i].load(Relaxed) >> LOW_BITS;
    let mut i = range.start;
    // A run that began before this range is sorted by whoever has its beginning.
    while i > 0 && i < range.end && upper(i) == upper(i - 1) {
        i += 1;
    }
    while i < range.end {
        let mut end = i + 1;
        while end < keys.len() && upper(end) == upper(i) {
            end += 1;
        }
        if end - i > 1 {
            ties.clear();
            ties.extend((i..end).map(|k| (keys[k].load(Relaxed), values[k].load(Relaxed))));
            ties.sort_unstable();
            for (k, &(key, value)) in (i..end).zip(ties.iter()) {
                keys[k].store(key, Relaxed);
                values[k].store(value, Relaxed);
            }
        }
        i = end;
    }
}

fn count(keys: &[AtomicU64], counts: &mut [[u32; BINS]; PASSES], passes: std::ops::Range<usize>) {
    for pass in passes.clone() {
        counts[pass].fill(0);
    }
    for key in keys {
        let key = key.load(Relaxed);
        for pass in passes.clone() {
            counts[pass][digit(key, pass)] += 1;
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
