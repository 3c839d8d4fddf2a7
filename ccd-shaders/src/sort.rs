//! One pass of the radix sort; see `ccd_core::backend::kernel::sort`.

use crate::entry::kernel;
use crate::workgroup::{add_shared, barrier, get, or_shared, set};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::kernel::sort::{
    COUNT_THREADS, DIGITS, KEYS, THREADS, TILE, before, digit, place,
};

/// Runs of 32 threads of a workgroup.
const RUNS: u32 = THREADS / 32;
/// Words of the counts of a run: two digits in one, which are below 2^16.
const PAIRS: u32 = DIGITS / 2;

kernel! {
    /// A workgroup counts the digits of its tile into `table[digit n_tiles + tile]`.
    sort_count[128](t; params: SortPass; counts: [u32; 256]; keys: [u32], mut table: [u32]) {
        let tile = t.group;
        set(counts, t.lane, 0);
        set(counts, t.lane + COUNT_THREADS, 0);
        barrier();
        let first = tile * TILE + t.lane;
        let shift = params.args.shift;
        // All loads before the first addition, so that they overlap.
        macro_rules! count {
            ($($k:literal)*) => {
                let loaded = [$(load(keys, params.dispatch.n, first + $k * COUNT_THREADS)),*];
                $(if first + $k * COUNT_THREADS < params.dispatch.n {
                    add_shared(counts, digit(loaded[$k], shift), 1);
                })*
            };
        }
        count!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
        barrier();
        if tile < params.args.n_tiles {
            for half in 0..2 {
                let d = t.lane + half * COUNT_THREADS;
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
    sort_scatter[256](t; params: SortPass; words: [u32; 2048], counts: [u32; 1024],
        starts: [u32; 256]; table: [u32], keys: [u32], values: [u32], mut keys_out: [u32],
        mut values_out: [u32]) {
        let tile = t.group;
        let (run, shift, n_keys) = (t.lane / 32 * DIGITS, params.args.shift, params.dispatch.n);
        let n_tiles = params.args.n_tiles;
        // Unrolled, so that what is indexed by `k` stays in registers.
        macro_rules! move_all {
            ($($k:literal)*) => {
                let (mut sorted, mut carried) = ([0u32; KEYS as usize], [0u32; KEYS as usize]);
                // All loads before the first barrier, so that they overlap.
                $(
                    sorted[$k] = load(keys, n_keys, tile * TILE + place(t.lane, $k));
                    carried[$k] = load(values, n_keys, tile * TILE + place(t.lane, $k));
                )*
                for k in 0..RUNS * DIGITS / THREADS {
                    set(words, k * THREADS + t.lane, 0);
                }
                for k in 0..RUNS * PAIRS / THREADS {
                    set(counts, k * THREADS + t.lane, 0);
                }
                barrier();
                // Rank of every key among those of the same digit before it in its run. The words
                // are masks of lanes.
                let mut ranks = [0u32; KEYS as usize];
                $(
                    let active = tile * TILE + place(t.lane, $k) < n_keys;
                    let slot = run + digit(sorted[$k], shift);
                    if active {
                        or_shared(words, slot, 1 << (t.lane % 32));
                    }
                    barrier();
                    let mask = get(words, slot);
                    let earlier = before(mask, t.lane);
                    ranks[$k] = half(get(counts, slot / 2), slot) + earlier;
                    barrier();
                    if active && earlier == 0 {
                        add_shared(counts, slot / 2, mask.count_ones() << (16 * (slot % 2)));
                        set(words, slot, 0);
                    }
                    barrier();
                )*
                // Where each digit starts in the tile and in all: the first threads have two digits
                // each. Masks are of no more use.
                let (mut here, mut all) = ([0, 0], [0, 0]);
                let d = 2 * t.lane;
                if t.lane < PAIRS {
                    let mut both = 0;
                    for r in 0..RUNS {
                        both += get(counts, r * PAIRS + t.lane);
                    }
                    here = [both & 0xffff, both >> 16];
                    all = [
                        at(table, (DIGITS * n_tiles + d) as usize),
                        at(table, (DIGITS * n_tiles + d + 1) as usize),
                    ];
                }
                let sum = [here[0] + here[1], all[0] + all[1]];
                let in_tile = scan(t.lane, 8, THREADS, sum[0], words) - sum[0];
                let in_all = scan(t.lane, 8, THREADS, sum[1], words) - sum[1];
                if t.lane < PAIRS {
                    let mut in_tiles = [0, 0];
                    if tile < n_tiles {
                        in_tiles = [
                            at(table, (d * n_tiles + tile) as usize),
                            at(table, ((d + 1) * n_tiles + tile) as usize),
                        ];
                    }
                    // What a key of these digits adds to its place in the tile.
                    let second = in_tile + here[0];
                    set(starts, d, (in_all + in_tiles[0]).wrapping_sub(in_tile));
                    set(starts, d + 1, (in_all + all[0] + in_tiles[1]).wrapping_sub(second));
                    let mut begin = in_tile | second << 16;
                    for r in 0..RUNS {
                        let count = get(counts, r * PAIRS + t.lane);
                        set(counts, r * PAIRS + t.lane, begin);
                        begin += count;
                    }
                }
                barrier();
                // The words are now the keys of the tile in order, then its values.
                $(
                    if tile * TILE + place(t.lane, $k) < n_keys {
                        let slot = run + digit(sorted[$k], shift);
                        ranks[$k] += half(get(counts, slot / 2), slot);
                        set(words, ranks[$k], sorted[$k]);
                    }
                )*
                barrier();
                // `sorted` is from here on where the words go.
                $(
                    let i = $k * THREADS + t.lane;
                    if tile * TILE + i < n_keys {
                        let key = get(words, i);
                        sorted[$k] = get(starts, digit(key, shift)).wrapping_add(i);
                        put(keys_out, sorted[$k] as usize, key);
                    }
                )*
                barrier();
                $(
                    if tile * TILE + place(t.lane, $k) < n_keys {
                        set(words, ranks[$k], carried[$k]);
                    }
                )*
                barrier();
                $(
                    let i = $k * THREADS + t.lane;
                    if tile * TILE + i < n_keys {
                        put(values_out, sorted[$k] as usize, get(words, i));
                    }
                )*
            };
        }
        move_all!(0 1 2 3 4 5 6 7);
    }
}

/// The count of a digit, of the two in a word.
#[inline(always)]
fn half(word: u32, digit: u32) -> u32 {
    word >> (16 * (digit % 2)) & 0xffff
}

/// Element `i` of `n`, 0 past the end.
#[inline(always)]
fn load(words: &[u32], n: u32, i: u32) -> u32 {
    if i < n { at(words, i as usize) } else { 0 }
}
