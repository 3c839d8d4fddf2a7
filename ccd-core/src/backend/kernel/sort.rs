//! Cooperative: least-significant-digit radix sort of 32-bit keys with their ids, stable, in four
//! passes of 8 bits.
//!
//! `sort_count` counts the digits of all four passes. A pass is one kernel (`sort_scatter`, or
//! `sort_scatter_by_subgroups`; "onesweep" of [Adinets 2022]): a workgroup ranks the keys of its
//! tile, publishes how many it has of each digit, adds what earlier tiles have, brings its tile
//! into order in workgroup memory and moves it, so that neighbouring threads write neighbouring
//! words.
//!
//! **Looking back.** A tile publishes in a row of the table, a word a digit, first [`COUNTED`] with
//! its number of keys, then [`SUMMED`] with that of all tiles up to it. The next tiles add rows
//! backwards, up to one that is summed. Flag and number are one word, so no order of memory is
//! needed. **Nothing waits without end**: a device need not run workgroups side by side, or in
//! order. A workgroup that has looked at a row [`LOOKS`] times in vain counts that tile itself, all
//! of its threads together, and goes on [Smith 2025].
//!
//! The count begins with round [`Dispatch::first`](crate::layout::Dispatch::first), a pass with the
//! tile of that number: 0, but in tests.
//!
//! **Ranks.** Keys are in runs of 32 neighbours a round. `sort_scatter` depends on no size of
//! subgroups: a digit has a word in workgroup memory in which each of 32 threads sets its bit.
//! Where subgroups have 32 threads, ballots give the same masks, and no thread of another subgroup
//! is waited for.

/// Digits of a pass.
pub const DIGITS: u32 = 256;
/// Passes of a sort.
pub const PASSES: u32 = 4;
/// Threads of a workgroup of the count.
pub const COUNT_THREADS: u32 = 256;
/// Keys of each of them in a round.
pub const COUNT_KEYS: u32 = 8;
/// Workgroups of the count at most: each adds to the same words in the end.
pub const COUNT_GROUPS: u32 = 1024;
/// Threads of a workgroup of a pass. A device runs as many workgroups at a time as their memory
/// allows, so that more threads for the same tile hide more of what each waits for.
pub const THREADS: u32 = 256;
/// Threads of a workgroup of a pass by subgroups.
pub const SUBGROUP_THREADS: u32 = 512;
/// Threads of a subgroup, where ballots are used.
pub const SUBGROUP: u32 = 32;
/// Keys of each thread: few tiles, since most of what one takes does not depend on its keys. More
/// would not fit into the workgroup memory that every device has.
pub const KEYS: u32 = 10;
/// Keys of each thread by subgroups. With 12, a thread takes so many registers that a processor of
/// an NVIDIA H200 runs one workgroup at a time instead of two.
pub const SUBGROUP_KEYS: u32 = 11;
/// Keys of a workgroup.
pub const TILE: u32 = THREADS * KEYS;
/// Keys of a workgroup by subgroups.
pub const SUBGROUP_TILE: u32 = SUBGROUP_THREADS * SUBGROUP_KEYS;

/// Flag of a number of keys of a tile.
pub const COUNTED: u32 = 1 << 30;
/// Flag of a number of keys of all tiles up to one.
pub const SUMMED: u32 = 2 << 30;
/// Most keys: numbers of keys are below the flags.
pub const MOST_KEYS: u32 = COUNTED - 1;
/// How often a workgroup looks at what another has not published before it counts by itself.
pub const LOOKS: u32 = 256;

/// Where the rows for passes of even (0) and of odd (1) number begin in the table, and, for 2, how
/// many words it has. Before them are the totals of each pass. Totals and the first rows are zero
/// when a sort begins.
#[inline(always)]
pub const fn first_row(odd: u32, n_tiles: u32) -> u32 {
    (PASSES + odd * n_tiles) * DIGITS
}

/// The digit of `key` at bit `shift`.
#[inline(always)]
pub fn digit(key: u32, shift: u32) -> u32 {
    (key >> shift) & (DIGITS - 1)
}

/// Where key `k` of `N` of thread `lane` is in its tile: 32 threads share a run of `32 N` keys, so
/// that their steps follow one another.
#[inline(always)]
pub fn place<const N: u32>(lane: u32, k: u32) -> u32 {
    lane / 32 * (32 * N) + k * 32 + lane % 32
}

/// Lanes before `lane` in a mask of 32.
#[inline(always)]
pub fn before(mask: u32, lane: u32) -> u32 {
    (mask & ((1 << (lane % 32)) - 1)).count_ones()
}
