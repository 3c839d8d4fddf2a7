//! The radix sort; see `ccd_core::backend::kernel::sort`.

use crate::entry::kernel;
use crate::scan::scan;
use crate::workgroup::{
    add, add_shared, barrier, get, get_uniform, load as load_word, lower_shared, or_shared, set,
    store, subgroup_barrier,
};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::kernel::sort::{
    COUNT_KEYS, COUNT_THREADS, COUNTED, DIGITS, KEYS, LOOKS, PASSES, SUBGROUP_THREADS, SUMMED,
    THREADS, before, digit, first_row, place,
};
use spirv_std::arch::{subgroup_ballot, subgroup_inclusive_i_add};

kernel! {
    /// Adds the digits of the keys to the totals of each pass.
    sort_count[256](t; params: SortPass; counts: [u32; 1024]; keys: [u32], mut table: [u32]) {
        for pass in 0..PASSES {
            set(counts, pass * DIGITS + t.lane, 0);
        }
        barrier();
        let n = params.dispatch.n;
        let mut round = params.dispatch.first + t.group;
        while round < n.div_ceil(COUNT_THREADS * COUNT_KEYS) {
            let first = round * (COUNT_THREADS * COUNT_KEYS) + t.lane;
            // All loads before the first addition, so that they overlap.
            macro_rules! count {
                ($($k:literal)*) => {
                    let loaded = [$(load(keys, n, first + $k * COUNT_THREADS)),*];
                    $(if first + $k * COUNT_THREADS < n {
                        for pass in 0..PASSES {
                            add_shared(counts, pass * DIGITS + digit(loaded[$k], 8 * pass), 1);
                        }
                    })*
                };
            }
            count!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15);
            round += t.groups;
        }
        barrier();
        for pass in 0..PASSES {
            let word = pass * DIGITS + t.lane;
            let count = get(counts, word);
            if count > 0 {
                add(table, word as usize, count);
            }
        }
    }
}

/// The body of a pass. What its two instances do differently: `rank` ranks a key among those of its
/// digit before it in its run, and counts it; `counts` has the counts of the runs, one digit in a
/// word or two, since they are below 2^16; `sums` adds two numbers of all threads up to each;
/// `missing` is the same word of `lowest` for all threads, and knows that it is.
///
/// Workgroup memory is used for one thing after another: `words` for what `rank` needs, then for
/// the keys of the tile in order, then for its values; `digits` for where a digit begins in the
/// tile, then for what a key of it adds to its place there. Unrolled, so that what is indexed by
/// `k` stays in registers.
macro_rules! scatter {
    (
        ($t:ident, $params:ident, $threads:ident, $per_word:literal)
        ($keys:ident, $values:ident, $table:ident, $keys_out:ident, $values_out:ident)
        ($words:ident, $counts:ident, $digits:ident, $lowest:ident)
        clear: $clear:expr;
        rank: |$d:ident, $active:ident| $rank:expr;
        sums: |$a:ident, $b:ident| $sums:expr;
        missing: $missing:expr;
        $($k:literal)*
    ) => {
        let (shift, n_keys, n_tiles) =
            ($params.args.shift, $params.dispatch.n, $params.args.n_tiles);
        let tile = $params.dispatch.first + $t.group;
        let first = tile * ($threads * KEYS);
        // All loads before the first barrier, so that they overlap.
        let mut sorted = [$(load($keys, n_keys, first + place($t.lane, $k))),*];
        for k in 0..DIGITS / 32 {
            set($words, k * $threads + $t.lane, 0);
        }
        $clear;
        if $t.lane == 0 {
            set($lowest, 0, u32::MAX);
        }
        barrier();
        let mut ranks = [0u32; KEYS as usize];
        $({
            let $active = first + place($t.lane, $k) < n_keys;
            let $d = digit(sorted[$k], shift);
            ranks[$k] = $rank;
        })*
        barrier();
        // From the counts of a run to those of the runs before it.
        if $t.lane < DIGITS / $per_word {
            let mut sum = 0;
            for run in 0..$threads / 32 {
                let i = run * (DIGITS / $per_word) + $t.lane;
                let count = get($counts, i);
                set($counts, i, sum);
                sum += count;
            }
            for i in 0..$per_word {
                set($digits, $per_word * $t.lane + i, part::<$per_word>(sum, i));
            }
        }
        barrier();
        // A thread has a digit.
        let has_digit = $t.lane < DIGITS && tile < n_tiles;
        let odd = shift / 8 % 2;
        let row = first_row(odd, n_tiles) + $t.lane;
        let (mut $a, mut $b) = (0, 0);
        if has_digit {
            $a = get($digits, $t.lane);
            $b = at($table, (shift / 8 * DIGITS + $t.lane) as usize);
            let flag = if tile == 0 { SUMMED } else { COUNTED };
            store($table, (row + tile * DIGITS) as usize, flag | $a);
            // For the next pass.
            let other = first_row(1 - odd, n_tiles) + tile * DIGITS + $t.lane;
            put($table, other as usize, 0);
        }
        let (up_to, all_up_to) = $sums;
        let begin = up_to - $a;
        if $t.lane < DIGITS {
            set($digits, $t.lane, begin);
        }
        barrier();
        $(if first + place($t.lane, $k) < n_keys {
            let d = digit(sorted[$k], shift);
            let in_runs = part::<$per_word>(get($counts, counter::<$per_word>($t.lane, d)), d);
            ranks[$k] += in_runs + get($digits, d);
        })*
        barrier();
        $(if first + place($t.lane, $k) < n_keys {
            set($words, ranks[$k], sorted[$k]);
        })*
        // What earlier tiles have of the digit.
        let mut back = if has_digit { tile } else { 0 };
        let mut earlier = 0;
        loop {
            let (end, sum) = look_back($table, row, back);
            back = end;
            earlier += sum;
            if back > 0 {
                lower_shared($lowest, 0, back - 1);
            }
            barrier();
            let missing = $missing;
            if missing == u32::MAX {
                break;
            }
            // A tile that has not published anything: counted here.
            if $t.lane < DIGITS {
                set($digits, $t.lane, 0);
            }
            barrier();
            if $t.lane == 0 {
                set($lowest, 0, u32::MAX);
            }
            $({
                let i = missing * ($threads * KEYS) + $k * $threads + $t.lane;
                add_shared($digits, digit(at($keys, i as usize), shift), 1);
            })*
            barrier();
            if back == missing + 1 {
                earlier += get($digits, $t.lane);
                back = missing;
            }
            barrier();
        }
        if has_digit && tile > 0 {
            store($table, (row + tile * DIGITS) as usize, SUMMED | (earlier + $a));
        }
        if $t.lane < DIGITS {
            set($digits, $t.lane, (all_up_to - $b + earlier).wrapping_sub(begin));
        }
        barrier();
        let carried = [$(load($values, n_keys, first + place($t.lane, $k))),*];
        // `sorted` is from here on where the words go.
        $({
            let i = $k * $threads + $t.lane;
            if first + i < n_keys {
                let key = get($words, i);
                sorted[$k] = get($digits, digit(key, shift)).wrapping_add(i);
                put($keys_out, sorted[$k] as usize, key);
            }
        })*
        barrier();
        $(if first + place($t.lane, $k) < n_keys {
            set($words, ranks[$k], carried[$k]);
        })*
        barrier();
        $({
            let i = $k * $threads + $t.lane;
            if first + i < n_keys {
                put($values_out, sorted[$k] as usize, get($words, i));
            }
        })*
    };
}

/// What tiles before `back` have of a digit, whose word in the row of tile 0 is `row`: backwards,
/// up to a tile that has published a sum, or nothing after so many looks. Returns where that ended,
/// behind the tile without anything or at 0, and the sum.
#[inline(always)]
fn look_back(table: &[u32], row: u32, mut back: u32) -> (u32, u32) {
    let (mut sum, mut looks) = (0, 0);
    while back > 0 && looks < LOOKS {
        looks += 1;
        // Four loads at a time, so that they overlap.
        let mut is_there = true;
        macro_rules! look {
            ($($k:literal)*) => {
                let words = [$(load_word(table, row_before(row, back, $k))),*];
                $(
                    is_there = is_there && words[$k] != 0;
                    if back > 0 && is_there {
                        sum += words[$k] & (COUNTED - 1);
                        back = if words[$k] >= SUMMED { 0 } else { back - 1 };
                        looks = 0;
                    }
                )*
            };
        }
        look!(0 1 2 3);
    }
    (back, sum)
}

/// The word of a digit in the row of tile `back - 1 - k`, of tile 0 if there is none.
#[inline(always)]
fn row_before(row: u32, back: u32, k: u32) -> usize {
    (row + if back > k { (back - 1 - k) * DIGITS } else { 0 }) as usize
}

/// A digit's count, of `N` in a word.
#[inline(always)]
fn part<const N: u32>(word: u32, digit: u32) -> u32 {
    if N == 2 { word >> (16 * (digit % 2)) & 0xffff } else { word }
}

/// The word of the count of a digit in the run of a thread.
#[inline(always)]
fn counter<const N: u32>(lane: u32, digit: u32) -> u32 {
    (lane / 32 * DIGITS + digit) / N
}

/// Rank of a key among those of its digit before it in its run, which it is counted with, by masks
/// of threads in workgroup memory. Three barriers.
#[inline(always)]
fn rank_by_masks(
    masks: &mut [u32; 2048],
    counts: &mut [u32; 1024],
    (lane, d, active): (u32, u32, bool),
) -> u32 {
    let mask_of = counter::<1>(lane, d);
    if active {
        or_shared(masks, mask_of, 1 << (lane % 32));
    }
    barrier();
    let mask = get(masks, mask_of);
    let earlier = before(mask, lane);
    let rank = part::<2>(get(counts, mask_of / 2), d) + earlier;
    barrier();
    if active && earlier == 0 {
        add_shared(counts, mask_of / 2, mask.count_ones() << (16 * (d % 2)));
        set(masks, mask_of, 0);
    }
    barrier();
    rank
}

/// The same, by ballots.
#[inline(always)]
fn rank_by_ballots(counts: &mut [u32; 4096], (lane, d, active): (u32, u32, bool)) -> u32 {
    let mut mask = subgroup_ballot(active).x;
    macro_rules! bits {
        ($($bit:literal)*) => {$(
            let is_set = d >> $bit & 1 == 1;
            let ballot = subgroup_ballot(is_set).x;
            mask &= if is_set { ballot } else { !ballot };
        )*};
    }
    bits!(0 1 2 3 4 5 6 7);
    let counter = counter::<1>(lane, d);
    let (earlier, count) = (before(mask, lane), get(counts, counter));
    subgroup_barrier();
    if active && earlier == 0 {
        set(counts, counter, count + mask.count_ones());
    }
    subgroup_barrier();
    count + earlier
}

/// Sums of two numbers of threads up to one, of the first 256.
#[inline(always)]
fn sums_by_subgroups(lane: u32, a: u32, b: u32, sums: &mut [u32; 16]) -> (u32, u32) {
    let (mut a, mut b) = (subgroup_inclusive_i_add(a), subgroup_inclusive_i_add(b));
    if lane < DIGITS && lane % 32 == 31 {
        set(sums, lane / 32, a);
        set(sums, 8 + lane / 32, b);
    }
    barrier();
    if lane < DIGITS {
        for i in 0..lane / 32 {
            a += get(sums, i);
            b += get(sums, 8 + i);
        }
    }
    (a, b)
}

kernel! {
    /// One pass: moves the keys and values of a tile to where they belong after it.
    sort_scatter[256](t; params: SortPass; words: [u32; 2048], counts: [u32; 1024],
        digits: [u32; 256], lowest: [u32; 1], missing: [u32; 1]; keys: [u32], values: [u32],
        mut table: [u32], mut keys_out: [u32], mut values_out: [u32]) {
        scatter! {
            (t, params, THREADS, 2)
            (keys, values, table, keys_out, values_out)
            (words, counts, digits, lowest)
            clear: for k in 0..DIGITS / 64 { set(counts, k * THREADS + t.lane, 0) };
            rank: |d, active| rank_by_masks(words, counts, (t.lane, d, active));
            sums: |a, b| (
                scan(t.lane, 8, THREADS, a, words),
                scan(t.lane, 8, THREADS, b, words),
            );
            missing: {
                if t.lane == 0 {
                    set(missing, 0, get(lowest, 0));
                }
                get_uniform(missing, 0)
            };
            0 1 2 3 4 5 6 7
        }
    }
}

kernel! {
    /// The same, where subgroups have 32 threads.
    sort_scatter_by_subgroups[512 by (subgroup, lane_of_subgroup)](t; params: SortPass;
        words: [u32; 4096], digits: [u32; 256], sums: [u32; 16], lowest: [u32; 1];
        keys: [u32], values: [u32], mut table: [u32], mut keys_out: [u32],
        mut values_out: [u32]) {
        scatter! {
            (t, params, SUBGROUP_THREADS, 1)
            (keys, values, table, keys_out, values_out)
            (words, words, digits, lowest)
            clear: ();
            rank: |d, active| rank_by_ballots(words, (t.lane, d, active));
            sums: |a, b| sums_by_subgroups(t.lane, a, b, sums);
            missing: get(lowest, 0);
            0 1 2 3 4 5 6 7
        }
    }
}

/// Element `i` of `n`, 0 past the end.
#[inline(always)]
fn load(words: &[u32], n: u32, i: u32) -> u32 {
    if i < n { at(words, i as usize) } else { 0 }
}
