//! Runs of blocks, or of other elements of a list.
//!
//! Sorted by where they begin, and apart: what a call makes anew, or leaves as it is.
//!
//! Twin: none; a GPU makes the boxes of a whole set.

use std::ops::Range;

/// Adds runs to others; they are sorted and apart then.
pub fn add_runs(runs: &mut Vec<Range<usize>>, more: &[Range<usize>]) {
    runs.extend_from_slice(more);
    runs.sort_unstable_by_key(|run| run.start);
    join(runs);
}

/// Joins runs, sorted by where they begin, that touch or overlap.
pub fn join(runs: &mut Vec<Range<usize>>) {
    runs.dedup_by(|next, run| {
        let joins = next.start <= run.end;
        if joins {
            run.end = run.end.max(next.end);
        }
        joins
    });
}
