//! One pass of the radix sort; see `ccd_core::backend::kernel::sort`.

use crate::entry::kernel;
use crate::workgroup::{add_shared, barrier, get, or_shared, set};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::kernel::sort::{DIGITS, KEYS, THREADS, TILE, before, digit, place};

/// Runs of 32 threads of a workgroup.
const RUNS: u32 = THREADS / 32;
/// Masks of one key a thread.
const HALF: u32 = RUNS * DIGITS;

kernel! {
    /// A workgroup counts the digits of its tile into `table[digit n_tiles + tile]`.
    sort_count[128](t; params: SortPass; counts: [u32; 256]; keys: [u32], mut table: [u32]) {
        let tile = t.group;
        set(counts, t.lane, 0);
        set(counts, t.lane + THREADS, 0);
        barrier();
        let first = tile * TILE + t.lane;
        let shift = params.args.shift;
        // All loads before the first addition, so that they overlap.
        macro_rules! count {
            ($($k:literal)*) => {
                let loaded = [$(load(keys, params.dispatch.n, first + $k * THREADS)),*];
                $(if first + $k * THREADS < params.dispatch.n {
                    add_shared(counts, digit(loaded[$k], shift), 1);
                })*
            };
        }
        count!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
        barrier();
        if tile < params.args.n_tiles {
            for half in 0..2 {
                let d = t.lane + half * THREADS;
                put(table, (d * params.args.n_tiles + tile) as usize, get(counts, d));
            }
        }
    }
}

kernel! {
    /// Workgroup `d` turns the counts of digit `d` into the number of keys with that digit in
    /// earlier tiles, and writes their total behind the table. Four counts a thread and round.
    sort_scan[256](t; params: SortPass; sums: [u32; 512]; mut table: [u32]) {
        let n_tiles = params.args.n_tiles;
        let row = t.group * n_tiles;
        let mut carry = 0;
        for round in 0..n_tiles.div_ceil(1024) {
            let i = round * 1024 + 4 * t.lane;
            let count = [
                count_of(table, row, n_tiles, i),
                count_of(table, row, n_tiles, i + 1),
                count_of(table, row, n_tiles, i + 2),
                count_of(table, row, n_tiles, i + 3),
            ];
            let sum = count[0] + count[1] + count[2] + count[3];
            let mut start = carry + scan(t.lane, 8, 256, sum, sums) - sum;
            macro_rules! write {
                ($($k:literal)*) => {$(
                    if i + $k < n_tiles {
                        put(table, (row + i + $k) as usize, start);
                    }
                    start += count[$k];
                )*};
            }
            write!(0 1 2 3);
            carry += get(sums, 255);
            barrier();
        }
        if t.lane == 0 {
            put(table, (DIGITS * n_tiles + t.group) as usize, carry);
        }
    }
}

/// Entry `i` of a row of the table, 0 past its end.
#[inline(always)]
fn count_of(table: &[u32], row: u32, n_tiles: u32, i: u32) -> u32 {
    if i < n_tiles { at(table, (row + i) as usize) } else { 0 }
}

/// Sum of the values of threads up to this one, among `2^steps` threads; after an even number of
/// steps the sum of all is in `sums[2^steps - 1]` until the next barrier. `sums` has two halves
/// that are used in turn, so that one barrier a step is enough.
#[inline(always)]
pub(crate) fn scan<const N: usize>(
    lane: u32,
    steps: u32,
    half: u32,
    value: u32,
    sums: &mut [u32; N],
) -> u32 {
    let mut sum = value;
    let mut reach = 1;
    let (mut from, mut to) = (0, half);
    set(sums, lane, sum);
    for _ in 0..steps {
        barrier();
        if lane >= reach {
            sum += get(sums, from + lane - reach);
        }
        set(sums, to + lane, sum);
        let swap = from;
        from = to;
        to = swap;
        reach *= 2;
    }
    barrier();
    sum
}

kernel! {
    /// A workgroup moves the keys and values of its tile to where they belong after this pass:
    /// first within the tile, in workgroup memory, so that neighbouring threads then write
    /// neighbouring words.
    sort_scatter[128](t; params: SortPass; words: [u32; 2048], counts: [u32; 1024],
        starts: [u32; 256]; table: [u32], keys: [u32], values: [u32], mut keys_out: [u32],
        mut values_out: [u32]) {
        let tile = t.group;
        let (run, shift, n_keys) = (t.lane / 32 * DIGITS, params.args.shift, params.dispatch.n);
        let n_tiles = params.args.n_tiles;
        // Unrolled, so that what is indexed by `k` stays in registers.
        macro_rules! move_all {
            ($($k:literal $second:literal)*) => {
                let (mut sorted, mut carried) = ([0u32; KEYS as usize], [0u32; KEYS as usize]);
                // All loads before the first barrier, so that they overlap.
                $(
                    sorted[$k] = load(keys, n_keys, tile * TILE + place(t.lane, $k));
                    sorted[$second] = load(keys, n_keys, tile * TILE + place(t.lane, $second));
                    carried[$k] = load(values, n_keys, tile * TILE + place(t.lane, $k));
                    carried[$second] = load(values, n_keys, tile * TILE + place(t.lane, $second));
                )*
                for k in 0..8 {
                    set(words, k * THREADS + t.lane, 0);
                    set(words, HALF + k * THREADS + t.lane, 0);
                    set(counts, k * THREADS + t.lane, 0);
                }
                barrier();
                // Rank of every key among those of the same digit before it in its run; two
                // keys a thread between barriers. The words are masks of lanes.
                let mut ranks = [0u32; KEYS as usize];
                $(
                    let active = tile * TILE + place(t.lane, $k) < n_keys;
                    let next_there = tile * TILE + place(t.lane, $second) < n_keys;
                    let first = run + digit(sorted[$k], shift);
                    let second = run + digit(sorted[$second], shift);
                    if active {
                        or_shared(words, first, 1 << (t.lane % 32));
                    }
                    if next_there {
                        or_shared(words, HALF + second, 1 << (t.lane % 32));
                    }
                    barrier();
                    let (mask, next_mask) = (get(words, first), get(words, HALF + second));
                    let (earlier, next_earlier) = (before(mask, t.lane), before(next_mask, t.lane));
                    ranks[$k] = get(counts, first) + earlier;
                    ranks[$second] =
                        get(counts, second) + get(words, second).count_ones() + next_earlier;
                    barrier();
                    if active && earlier == 0 {
                        add_shared(counts, first, mask.count_ones());
                        set(words, first, 0);
                    }
                    if next_there && next_earlier == 0 {
                        add_shared(counts, second, next_mask.count_ones());
                        set(words, HALF + second, 0);
                    }
                    barrier();
                )*
                // Where each digit starts in the tile and in all: a thread has two digits. Masks
                // are of no more use.
                let (mut here, mut all) = (0, 0);
                for half in 0..2 {
                    let d = 2 * t.lane + half;
                    for r in 0..RUNS {
                        here += get(counts, r * DIGITS + d);
                    }
                    all += at(table, (DIGITS * n_tiles + d) as usize);
                }
                let mut in_tile = scan(t.lane, 7, HALF, here, words) - here;
                let mut in_all = scan(t.lane, 7, HALF, all, words) - all;
                for half in 0..2 {
                    let d = 2 * t.lane + half;
                    let in_tiles =
                        if tile < n_tiles { at(table, (d * n_tiles + tile) as usize) } else { 0 };
                    // What a key of this digit adds to its place in the tile.
                    set(starts, d, (in_all + in_tiles).wrapping_sub(in_tile));
                    in_all += at(table, (DIGITS * n_tiles + d) as usize);
                    for r in 0..RUNS {
                        let count = get(counts, r * DIGITS + d);
                        set(counts, r * DIGITS + d, in_tile);
                        in_tile += count;
                    }
                }
                barrier();
                // The words are now the keys of the tile in order, then its values.
                macro_rules! keep {
                    ($i:literal) => {
                        if tile * TILE + place(t.lane, $i) < n_keys {
                            ranks[$i] += get(counts, run + digit(sorted[$i], shift));
                            set(words, ranks[$i], sorted[$i]);
                        }
                    };
                }
                $(keep!($k); keep!($second);)*
                barrier();
                // `sorted` is from here on where the words go.
                macro_rules! hand_over {
                    ($i:literal) => {
                        let i = $i * THREADS + t.lane;
                        if tile * TILE + i < n_keys {
                            let key = get(words, i);
                            sorted[$i] = get(starts, digit(key, shift)).wrapping_add(i);
                            put(keys_out, sorted[$i] as usize, key);
                        }
                    };
                }
                $(hand_over!($k); hand_over!($second);)*
                barrier();
                macro_rules! keep_value {
                    ($i:literal) => {
                        if tile * TILE + place(t.lane, $i) < n_keys {
                            set(words, ranks[$i], carried[$i]);
                        }
                    };
                }
                $(keep_value!($k); keep_value!($second);)*
                barrier();
                macro_rules! hand_over_value {
                    ($i:literal) => {
                        let i = $i * THREADS + t.lane;
                        if tile * TILE + i < n_keys {
                            put(values_out, sorted[$i] as usize, get(words, i));
                        }
                    };
                }
                $(hand_over_value!($k); hand_over_value!($second);)*
            };
        }
        move_all!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
    }
}

/// Element `i` of `n`, 0 past the end.
#[inline(always)]
fn load(words: &[u32], n: u32, i: u32) -> u32 {
    if i < n { at(words, i as usize) } else { 0 }
}
