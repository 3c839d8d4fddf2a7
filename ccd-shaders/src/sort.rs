//! One pass of the radix sort; see `ccd_core::kernel::sort`.

use crate::workgroup::{add_shared, barrier, get, group, or_shared, set};
use ccd_core::kernel::memory::{at, put};
use ccd_core::kernel::sort::{DIGITS, KEYS, THREADS, TILE, before, digit, place};
use ccd_core::layout::{Params, SortPass};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

/// Runs of 32 threads of a workgroup.
const RUNS: u32 = THREADS / 32;
/// Masks of one key a thread.
const HALF: u32 = RUNS * DIGITS;

/// A workgroup counts the digits of its tile into `table[digit n_tiles + tile]`.
#[spirv(compute(threads(128)))]
pub fn sort_count(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] counts: &mut [u32; 256],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<SortPass>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] keys: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] table: &mut [u32],
) {
    let tile = group(id, n);
    set(counts, lane, 0);
    set(counts, lane + THREADS, 0);
    barrier();
    let first = tile * TILE + lane;
    let shift = params.own.shift;
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
    if tile < params.own.n_tiles {
        for half in 0..2 {
            let d = lane + half * THREADS;
            put(table, (d * params.own.n_tiles + tile) as usize, get(counts, d));
        }
    }
}

/// Workgroup `d` turns the counts of digit `d` into the number of keys with that digit in earlier
/// tiles, and writes their total behind the table. Four counts a thread and round.
#[spirv(compute(threads(256)))]
pub fn sort_scan(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] sums: &mut [u32; 512],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<SortPass>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] table: &mut [u32],
) {
    let n_tiles = params.own.n_tiles;
    let row = id.x * n_tiles;
    let mut carry = 0;
    for round in 0..n_tiles.div_ceil(1024) {
        let i = round * 1024 + 4 * lane;
        let count = [
            count_of(table, row, n_tiles, i),
            count_of(table, row, n_tiles, i + 1),
            count_of(table, row, n_tiles, i + 2),
            count_of(table, row, n_tiles, i + 3),
        ];
        let own = count[0] + count[1] + count[2] + count[3];
        let mut start = carry + scan(lane, 8, 256, own, sums) - own;
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
    if lane == 0 {
        put(table, (DIGITS * n_tiles + id.x) as usize, carry);
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
fn scan<const N: usize>(lane: u32, steps: u32, half: u32, value: u32, sums: &mut [u32; N]) -> u32 {
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

/// A workgroup moves the keys and values of its tile to where they belong after this pass: first
/// within the tile, in workgroup memory, so that neighbouring threads then write neighbouring
/// words.
#[spirv(compute(threads(128)))]
pub fn sort_scatter(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] words: &mut [u32; 2048],
    #[spirv(workgroup)] counts: &mut [u32; 1024],
    #[spirv(workgroup)] starts: &mut [u32; 256],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<SortPass>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] table: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] keys: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] values: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] keys_out: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] values_out: &mut [u32],
) {
    let tile = group(id, n);
    let (run, shift, n_keys) = (lane / 32 * DIGITS, params.own.shift, params.dispatch.n);
    let n_tiles = params.own.n_tiles;
    // Unrolled, so that what is indexed by `k` stays in registers.
    macro_rules! move_all {
        ($($k:literal $second:literal)*) => {
            let (mut sorted, mut carried) = ([0u32; KEYS as usize], [0u32; KEYS as usize]);
            // All loads before the first barrier, so that they overlap.
            $(
                sorted[$k] = load(keys, n_keys, tile * TILE + place(lane, $k));
                sorted[$second] = load(keys, n_keys, tile * TILE + place(lane, $second));
                carried[$k] = load(values, n_keys, tile * TILE + place(lane, $k));
                carried[$second] = load(values, n_keys, tile * TILE + place(lane, $second));
            )*
            for k in 0..8 {
                set(words, k * THREADS + lane, 0);
                set(words, HALF + k * THREADS + lane, 0);
                set(counts, k * THREADS + lane, 0);
            }
            barrier();
            // Rank of every key among those of the same digit that come before it in its run; two
            // keys a thread between barriers. The words are masks of lanes.
            let mut ranks = [0u32; KEYS as usize];
            $(
                let there = tile * TILE + place(lane, $k) < n_keys;
                let next_there = tile * TILE + place(lane, $second) < n_keys;
                let first = run + digit(sorted[$k], shift);
                let second = run + digit(sorted[$second], shift);
                if there {
                    or_shared(words, first, 1 << (lane % 32));
                }
                if next_there {
                    or_shared(words, HALF + second, 1 << (lane % 32));
                }
                barrier();
                let (mask, next_mask) = (get(words, first), get(words, HALF + second));
                let (earlier, next_earlier) = (before(mask, lane), before(next_mask, lane));
                ranks[$k] = get(counts, first) + earlier;
                ranks[$second] =
                    get(counts, second) + get(words, second).count_ones() + next_earlier;
                barrier();
                if there && earlier == 0 {
                    add_shared(counts, first, mask.count_ones());
                    set(words, first, 0);
                }
                if next_there && next_earlier == 0 {
                    add_shared(counts, second, next_mask.count_ones());
                    set(words, HALF + second, 0);
                }
                barrier();
            )*
            // Where each digit starts in the tile and in all: a thread has two digits. The masks
            // are not needed any more.
            let (mut here, mut all) = (0, 0);
            for half in 0..2 {
                let d = 2 * lane + half;
                for r in 0..RUNS {
                    here += get(counts, r * DIGITS + d);
                }
                all += at(table, (DIGITS * n_tiles + d) as usize);
            }
            let mut in_tile = scan(lane, 7, HALF, here, words) - here;
            let mut in_all = scan(lane, 7, HALF, all, words) - all;
            for half in 0..2 {
                let d = 2 * lane + half;
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
                    if tile * TILE + place(lane, $i) < n_keys {
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
                    let i = $i * THREADS + lane;
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
                    if tile * TILE + place(lane, $i) < n_keys {
                        set(words, ranks[$i], carried[$i]);
                    }
                };
            }
            $(keep_value!($k); keep_value!($second);)*
            barrier();
            macro_rules! hand_over_value {
                ($i:literal) => {
                    let i = $i * THREADS + lane;
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

/// Element `i` of `n`, 0 past the end.
#[inline(always)]
fn load(words: &[u32], n: u32, i: u32) -> u32 {
    if i < n { at(words, i as usize) } else { 0 }
}
