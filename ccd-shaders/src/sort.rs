//! One pass of the radix sort; see `ccd_core::kernel::sort`.

use crate::workgroup::{add_shared, barrier, get, group, or_shared, set};
use ccd_core::kernel::memory::{at, put};
use ccd_core::kernel::sort::{DIGITS, KEYS, THREADS, TILE, before, digit, place};
use ccd_core::layout::{Params, SortPass};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

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
/// tiles, and writes their total behind the table.
#[spirv(compute(threads(256)))]
pub fn sort_scan(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] sums: &mut [u32; 512],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<SortPass>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] table: &mut [u32],
) {
    let row = id.x * params.own.n_tiles;
    let mut carry = 0;
    for round in 0..params.own.n_tiles.div_ceil(256) {
        let i = round * 256 + lane;
        let count = if i < params.own.n_tiles { at(table, (row + i) as usize) } else { 0 };
        let sum = scan(lane, 8, 256, count, sums);
        if i < params.own.n_tiles {
            put(table, (row + i) as usize, carry + sum - count);
        }
        carry += get(sums, 255);
        barrier();
    }
    if lane == 0 {
        put(table, (DIGITS * params.own.n_tiles + id.x) as usize, carry);
    }
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

/// A workgroup moves the keys and values of its tile to where they belong after this pass.
#[spirv(compute(threads(128)))]
pub fn sort_scatter(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] masks: &mut [u32; 2048],
    #[spirv(workgroup)] counts: &mut [u32; 1024],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<SortPass>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] table: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] keys: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] values: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] keys_out: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] values_out: &mut [u32],
) {
    let tile = group(id, n);
    let (run, shift, n_keys) = (lane / 32 * DIGITS, params.own.shift, params.dispatch.n);
    // All loads before the first barrier, so that they overlap; unrolled, so that what they give
    // stays in registers.
    macro_rules! move_all {
        ($($k:literal $second:literal)*) => {
            let (mut sorted, mut carried) = ([0u32; KEYS as usize], [0u32; KEYS as usize]);
            $(
                sorted[$k] = load(keys, n_keys, tile * TILE + place(lane, $k));
                sorted[$second] = load(keys, n_keys, tile * TILE + place(lane, $second));
                carried[$k] = load(values, n_keys, tile * TILE + place(lane, $k));
                carried[$second] = load(values, n_keys, tile * TILE + place(lane, $second));
            )*
            for k in 0..8 {
                set(masks, k * THREADS + lane, 0);
                set(masks, 1024 + k * THREADS + lane, 0);
                set(counts, k * THREADS + lane, 0);
            }
            barrier();
            // Rank of every key among those of the same digit that come before it in its run; two
            // keys a thread between barriers.
            let mut ranks = [0u32; KEYS as usize];
            $(
                let there = tile * TILE + place(lane, $k) < n_keys;
                let next_there = tile * TILE + place(lane, $second) < n_keys;
                let first = run + digit(sorted[$k], shift);
                let second = run + digit(sorted[$second], shift);
                if there {
                    or_shared(masks, first, 1 << (lane % 32));
                }
                if next_there {
                    or_shared(masks, 1024 + second, 1 << (lane % 32));
                }
                barrier();
                let (mask, next_mask) = (get(masks, first), get(masks, 1024 + second));
                let (earlier, next_earlier) = (before(mask, lane), before(next_mask, lane));
                ranks[$k] = get(counts, first) + earlier;
                ranks[$second] =
                    get(counts, second) + get(masks, second).count_ones() + next_earlier;
                barrier();
                if there && earlier == 0 {
                    add_shared(counts, first, mask.count_ones());
                    set(masks, first, 0);
                }
                if next_there && next_earlier == 0 {
                    add_shared(counts, second, next_mask.count_ones());
                    set(masks, 1024 + second, 0);
                }
                barrier();
            )*
            // Where each digit starts: keys of lesser digits, of earlier tiles, of earlier runs. A
            // thread has two digits. The masks are not needed any more.
            let totals = DIGITS * params.own.n_tiles;
            let low = at(table, (totals + 2 * lane) as usize);
            let both = low + at(table, (totals + 2 * lane + 1) as usize);
            let mut start = scan(lane, 7, 1024, both, masks) - both;
            for half in 0..2 {
                let d = 2 * lane + half;
                let in_tiles = if tile < params.own.n_tiles {
                    at(table, (d * params.own.n_tiles + tile) as usize)
                } else {
                    0
                };
                let mut next = start + in_tiles;
                for r in 0..4 {
                    let word = r * DIGITS + d;
                    let count = get(counts, word);
                    set(counts, word, next);
                    next += count;
                }
                start += low;
            }
            barrier();
            $(
                if tile * TILE + place(lane, $k) < n_keys {
                    let to = get(counts, run + digit(sorted[$k], shift)) + ranks[$k];
                    put(keys_out, to as usize, sorted[$k]);
                    put(values_out, to as usize, carried[$k]);
                }
                if tile * TILE + place(lane, $second) < n_keys {
                    let to = get(counts, run + digit(sorted[$second], shift)) + ranks[$second];
                    put(keys_out, to as usize, sorted[$second]);
                    put(values_out, to as usize, carried[$second]);
                }
            )*
        };
    }
    move_all!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
}

/// Element `i` of `n`, 0 past the end.
#[inline(always)]
fn load(words: &[u32], n: u32, i: u32) -> u32 {
    if i < n { at(words, i as usize) } else { 0 }
}
