//! Ranks of the keys of a tile: among those of their digit in a run, and where each run begins.

use crate::workgroup::{add_shared, barrier, get, or_shared, set, subgroup_barrier};
use ccd_core::backend::kernel::sort::{
    DIGITS, SUBGROUP_THREADS, SUBGROUP_TILE, THREADS, TILE, before,
};
use spirv_std::arch::{subgroup_ballot, subgroup_inclusive_i_add};

/// Number `i` of those that are packed two in a word.
#[inline(always)]
pub fn part(word: u32, i: u32) -> u32 {
    word >> (16 * (i % 2)) & 0xffff
}

/// The word of the count of a digit in the run of a thread, or of half of one where two are packed.
#[inline(always)]
pub fn counter(lane: u32, digit: u32) -> u32 {
    lane / 32 * DIGITS + digit
}

/// Rank of a key among those of its digit before it in its run, which it is counted with, by masks
/// of threads in workgroup memory. Three barriers.
#[inline(always)]
pub fn rank_by_masks(
    masks: &mut [u32; TILE as usize],
    counts: &mut [u32; 1024],
    (lane, d): (u32, u32),
) -> u32 {
    let mask_of = counter(lane, d);
    or_shared(masks, mask_of, 1 << (lane % 32));
    barrier();
    let mask = get(masks, mask_of);
    let earlier = before(mask, lane);
    let rank = part(get(counts, mask_of / 2), d) + earlier;
    barrier();
    if earlier == 0 {
        add_shared(counts, mask_of / 2, mask.count_ones() << (16 * (d % 2)));
        set(masks, mask_of, 0);
    }
    barrier();
    rank
}

/// The same, by ballots.
#[inline(always)]
pub fn rank_by_ballots(counts: &mut [u32; SUBGROUP_TILE as usize], (lane, d): (u32, u32)) -> u32 {
    let mut mask = u32::MAX;
    macro_rules! bits {
        ($($bit:literal)*) => {$(
            let is_set = d >> $bit & 1 == 1;
            let ballot = subgroup_ballot(is_set).x;
            mask &= if is_set { ballot } else { !ballot };
        )*};
    }
    bits!(0 1 2 3 4 5 6 7);
    let counter = counter(lane, d);
    let (earlier, count) = (before(mask, lane), get(counts, counter));
    subgroup_barrier();
    if earlier == 0 {
        set(counts, counter, count + mask.count_ones());
    }
    subgroup_barrier();
    count + earlier
}

/// Sums of two numbers of threads up to one, of the first 256.
#[inline(always)]
pub fn sums_by_subgroups(lane: u32, a: u32, b: u32, sums: &mut [u32; 16]) -> (u32, u32) {
    let (mut a, mut b) = (subgroup_inclusive_i_add(a), subgroup_inclusive_i_add(b));
    if lane < DIGITS && lane % 32 == 31 {
        set(sums, lane / 32, a);
        set(sums, 8 + lane / 32, b);
    }
    barrier();
    // All loads before the first addition, so that they overlap.
    macro_rules! earlier {
        ($($i:literal)*) => {
            let of_subgroups = [$([get(sums, $i), get(sums, 8 + $i)]),*];
            $(if $i < lane / 32 {
                a += of_subgroups[$i][0];
                b += of_subgroups[$i][1];
            })*
        };
    }
    earlier!(0 1 2 3 4 5 6);
    (a, b)
}

/// How many keys of a tile have the digit of a thread, of the first 256, by packed counts of runs,
/// which become those of the runs before each.
#[inline(always)]
pub fn total_of_packed(lane: u32, counts: &mut [u32; 1024], digits: &mut [u32; 256]) -> u32 {
    if lane < DIGITS / 2 {
        let mut sum = 0;
        for run in 0..THREADS / 32 {
            let i = run * (DIGITS / 2) + lane;
            let count = get(counts, i);
            set(counts, i, sum);
            sum += count;
        }
        for i in 0..2 {
            set(digits, 2 * lane + i, part(sum, i));
        }
    }
    barrier();
    get(digits, lane)
}

/// Runs of a tile by subgroups.
pub const RUNS: usize = SUBGROUP_THREADS as usize / 32;

macro_rules! for_runs {
    ($each:ident) => {
        $each!(0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
    };
}

/// How many keys of each run have the digit of a thread, of the first 256, and their sum.
#[inline(always)]
pub fn counts_of_runs(lane: u32, counts: &[u32; SUBGROUP_TILE as usize]) -> ([u32; RUNS], u32) {
    macro_rules! counts {
        ($($run:literal)*) => {{
            // All loads before the first addition, so that they overlap.
            let counts = [$(get(counts, $run * DIGITS + lane)),*];
            (counts, 0 $(+ counts[$run])*)
        }};
    }
    if lane < DIGITS { for_runs!(counts) } else { ([0; RUNS], 0) }
}

/// Where the keys of a thread's digit begin in the tile, of each run.
#[inline(always)]
pub fn begin_runs(
    lane: u32,
    mut begin: u32,
    of_runs: &[u32; RUNS],
    counts: &mut [u32; SUBGROUP_TILE as usize],
) {
    macro_rules! begins {
        ($($run:literal)*) => {
            $(
                set(counts, $run * DIGITS + lane, begin);
                begin += of_runs[$run];
            )*
        };
    }
    for_runs!(begins);
}
