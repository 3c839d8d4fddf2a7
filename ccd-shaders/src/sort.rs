//! The radix sort; see `ccd_core::backend::kernel::sort`.

mod ranks;

use crate::entry::kernel;
use crate::scan::scan;
use crate::workgroup::{
    add, add_shared, barrier, get, get_uniform, load as load_word, lower_shared, set, store,
};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::kernel::sort::{
    COUNT_KEYS, COUNT_THREADS, COUNTED, DIGITS, KEYS, LOOKS, PASSES, SUBGROUP_KEYS,
    SUBGROUP_THREADS, SUMMED, THREADS, digit, first_row, place,
};
use ranks::{
    RUNS, begin_runs, counter, counts_of_runs, part, rank_by_ballots, rank_by_masks,
    sums_by_subgroups, total_of_packed,
};

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
                    const _: () = assert!([$($k),*].len() == COUNT_KEYS as usize, "some uncounted");
                    let loaded = [$(load(keys, n, first + $k * COUNT_THREADS)),*];
                    $(if first + $k * COUNT_THREADS < n {
                        for pass in 0..PASSES {
                            add_shared(counts, pass * DIGITS + digit(loaded[$k], 8 * pass), 1);
                        }
                    })*
                };
            }
            count!(0 1 2 3 4 5 6 7);
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

/// The body of a pass. What its two instances do differently:
///
/// - `rank` ranks a key among those of its digit before it in its run, and counts it;
/// - `total` is how many keys of the tile have a digit, for the first 256 threads, one a digit;
/// - `sums` adds two numbers of theirs up to each;
/// - `begins` takes where a digit begins in the tile, and `before` is where one begins of a run;
/// - `missing` is the same word of `lowest` for all threads, and knows that it is.
///
/// Workgroup memory is used for one thing after another: `words` for what `rank` needs, then for
/// the keys of the tile in order, then for its values; `digits` for where a digit begins in the
/// tile, then for what a key of it adds to its place there. Unrolled, so that what is indexed by
/// `k` stays in registers, of which there must be few: ranks and digits are packed.
macro_rules! scatter {
    (
        ($t:ident, $params:ident, $threads:ident, $keys_each:ident)
        ($keys:ident, $values:ident, $table:ident, $keys_out:ident, $values_out:ident)
        ($words:ident, $digits:ident, $lowest:ident)
        clear: $clear:expr;
        rank: |$d:ident| $rank:expr;
        total: $total:expr;
        sums: |$a:ident, $b:ident| $sums:expr;
        begins: |$begin:ident| $begins:expr;
        before: $before:expr;
        missing: $missing:expr;
        $($k:literal)*
    ) => {
        const _: () = assert!([$($k),*].len() == $keys_each as usize, "a list without some keys");
        let (shift, n_keys, n_tiles) =
            ($params.args.shift, $params.dispatch.n, $params.args.n_tiles);
        let tile = $params.dispatch.first + $t.group;
        let first = tile * ($threads * $keys_each);
        // All loads before the first barrier, so that they overlap.
        let sorted = [$(load($keys, n_keys, first + place::<$keys_each>($t.lane, $k))),*];
        // How many keys all tiles have of the digit of a thread.
        let mut $b = 0;
        if $t.lane < DIGITS {
            $b = at($table, (shift / 8 * DIGITS + $t.lane) as usize);
        }
        $clear;
        if $t.lane == 0 {
            set($lowest, 0, u32::MAX);
        }
        barrier();
        let mut ranks = [0u32; ($keys_each as usize).div_ceil(2)];
        $({
            let $d = digit(sorted[$k], shift);
            ranks[$k / 2] |= $rank << (16 * ($k % 2));
        })*
        barrier();
        let has_digit = $t.lane < DIGITS && tile < n_tiles;
        let odd = shift / 8 % 2;
        let row = first_row(odd, n_tiles) + $t.lane;
        let $a = $total;
        if has_digit {
            let flag = if tile == 0 { SUMMED } else { COUNTED };
            store($table, (row + tile * DIGITS) as usize, flag | $a);
            // For the next pass.
            let other = first_row(1 - odd, n_tiles) + tile * DIGITS + $t.lane;
            put($table, other as usize, 0);
        }
        let (up_to, all_up_to) = $sums;
        let $begin = up_to - $a;
        if $t.lane < DIGITS {
            $begins;
        }
        barrier();
        $({
            let $d = digit(sorted[$k], shift);
            ranks[$k / 2] += $before << (16 * ($k % 2));
        })*
        barrier();
        $(set($words, part(ranks[$k / 2], $k), sorted[$k]);)*
        // While other tiles are looked at. Behind the last key it does not matter which.
        let carried = [$({
            let i = first + place::<$keys_each>($t.lane, $k);
            at($values, i.min(n_keys - 1) as usize)
        }),*];
        // What earlier tiles have of the digit.
        let mut back = if has_digit { tile } else { 0 };
        let mut earlier = 0;
        loop {
            let (end, sum) = look_back($table, row, back);
            back = end;
            earlier += sum;
            if back > 0 {
                lower_shared($lowest, 0, back - 1);
            } else if has_digit && tile > 0 {
                store($table, (row + tile * DIGITS) as usize, SUMMED | (earlier + $a));
            }
            if $t.lane < DIGITS {
                set($digits, $t.lane, (all_up_to - $b + earlier).wrapping_sub($begin));
            }
            barrier();
            let missing = $missing;
            if missing == u32::MAX {
                break;
            }
            // A tile that has not published anything: counted here.
            barrier();
            if $t.lane < DIGITS {
                set($digits, $t.lane, 0);
            }
            if $t.lane == 0 {
                set($lowest, 0, u32::MAX);
            }
            barrier();
            for k in 0..$keys_each {
                let i = missing * ($threads * $keys_each) + k * $threads + $t.lane;
                add_shared($digits, digit(at($keys, i as usize), shift), 1);
            }
            barrier();
            if back == missing + 1 {
                earlier += get($digits, $t.lane);
                back = missing;
            }
        }
        // Digits of the keys in order, four in a word.
        let mut in_order = [0u32; ($keys_each as usize).div_ceil(4)];
        $({
            let i = $k * $threads + $t.lane;
            if first + i < n_keys {
                let key = get($words, i);
                let d = digit(key, shift);
                in_order[$k / 4] |= d << (8 * ($k % 4));
                put($keys_out, get($digits, d).wrapping_add(i) as usize, key);
            }
        })*
        barrier();
        $(set($words, part(ranks[$k / 2], $k), carried[$k]);)*
        barrier();
        $({
            let i = $k * $threads + $t.lane;
            if first + i < n_keys {
                let d = digit(in_order[$k / 4], 8 * ($k % 4));
                put($values_out, get($digits, d).wrapping_add(i) as usize, get($words, i));
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

kernel! {
    /// One pass: moves the keys and values of a tile to where they belong after it.
    sort_scatter[256](t; params: SortPass; words: [u32; 2560], counts: [u32; 1024],
        digits: [u32; 256], lowest: [u32; 1], missing: [u32; 1]; keys: [u32], values: [u32],
        mut table: [u32], mut keys_out: [u32], mut values_out: [u32]) {
        scatter! {
            (t, params, THREADS, KEYS)
            (keys, values, table, keys_out, values_out)
            (words, digits, lowest)
            clear: {
                for k in 0..DIGITS / 64 {
                    set(counts, k * THREADS + t.lane, 0);
                }
                for k in 0..DIGITS / 32 {
                    set(words, k * THREADS + t.lane, 0);
                }
            };
            rank: |d| rank_by_masks(words, counts, (t.lane, d));
            total: total_of_packed(t.lane, counts, digits);
            sums: |a, b| (
                scan(t.lane, 8, THREADS, a, words),
                scan(t.lane, 8, THREADS, b, words),
            );
            begins: |begin| set(digits, t.lane, begin);
            before: part(get(counts, counter(t.lane, d) / 2), d) + get(digits, d);
            missing: {
                if t.lane == 0 {
                    set(missing, 0, get(lowest, 0));
                }
                get_uniform(missing, 0)
            };
            0 1 2 3 4 5 6 7 8 9
        }
    }
}

kernel! {
    /// The same, where subgroups have 32 threads.
    sort_scatter_by_subgroups[512 by (subgroup, lane_of_subgroup)](t; params: SortPass;
        words: [u32; 5632], digits: [u32; 256], sums: [u32; 16], lowest: [u32; 1];
        keys: [u32], values: [u32], mut table: [u32], mut keys_out: [u32],
        mut values_out: [u32]) {
        let mut of_runs = [0; RUNS];
        scatter! {
            (t, params, SUBGROUP_THREADS, SUBGROUP_KEYS)
            (keys, values, table, keys_out, values_out)
            (words, digits, lowest)
            clear: for k in 0..DIGITS / 32 {
                set(words, k * SUBGROUP_THREADS + t.lane, 0);
            };
            rank: |d| rank_by_ballots(words, (t.lane, d));
            total: {
                let (counts, sum) = counts_of_runs(t.lane, words);
                of_runs = counts;
                sum
            };
            sums: |a, b| sums_by_subgroups(t.lane, a, b, sums);
            begins: |begin| begin_runs(t.lane, begin, &of_runs, words);
            before: get(words, counter(t.lane, d));
            missing: get(lowest, 0);
            0 1 2 3 4 5 6 7 8 9 10
        }
    }
}

/// Key `i` of `n`; behind the last one the greatest, which stays behind all others and is not
/// written. The last tile counts it, in a row at which no tile looks.
#[inline(always)]
fn load(keys: &[u32], n: u32, i: u32) -> u32 {
    if i < n { at(keys, i as usize) } else { u32::MAX }
}
