//! Sums of what comes before: in the rows of a table, and among the threads of a workgroup.

use crate::entry::kernel;
use crate::workgroup::{barrier, get, set};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::kernel::sort::DIGITS;

kernel! {
    /// Workgroup `r` turns the counts of row `r` into the sum of those before each, and writes
    /// their total behind the table. Four counts a thread and round.
    scan_rows[256](t; params: SortPass; sums: [u32; 512]; mut table: [u32]) {
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
