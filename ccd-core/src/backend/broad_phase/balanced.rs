//! Map: what workers leave between two rounds when they are balanced, and how it is dealt out again
//! [Lauterbach 2010], as in algorithms 3.3 and 3.4 of [da Silva 2013].
//!
//! ```text
//!  worker         0        1      2          3     at the end of a round: a stack, and what is
//!              [s s|r r r] []  [s s s s|]   [|r]   left of the part of the tasks
//!  counts          5        0      4          1
//!  first           0        5      5          9  10        reduced; exclusive prefix sums
//!  next tasks  [p p p][p p p][p p p][p]                    even parts, a workgroup each
//! ```
//!
//! Each worker saves its stack to a segment of memory of its own, and its two counts. One workgroup
//! turns the counts into prefix sums. Then a workgroup a worker fills the part that this worker has
//! of the next tasks: for each place it finds whose pair comes there. Parts are equal but for the
//! last, so that no worker has more to copy than another, however uneven the stacks are. What had
//! no room on a stack is already among the next tasks; the rest comes behind it.
//!
//! Departures from the paper: pairs are counted in parallel but copied by as many workgroups as
//! there are workers, rather than by one; and a full stack does not stop its worker.

use super::pair_workers::{STACK, counts, thieves, words_with_deques};
use crate::kernel::memory::at;
use crate::layout::NodeDescent;

/// First word of `control` of what one of `2^workers` workers leaves: pairs on its stack, then
/// tasks of its part that it has not taken.
#[inline(always)]
pub const fn left(workers: u32, me: u32) -> usize {
    counts(1 << workers) + 2 * me as usize
}

/// Word of `control`: the place among the next tasks of the first pair that a worker leaves. Behind
/// that of the last worker stands the end.
#[inline(always)]
pub const fn first(workers: u32, me: u32) -> usize {
    left(workers, 1 << workers) + me as usize
}

/// First word of `control` of the saved stack of a worker, two words a pair.
#[inline(always)]
pub const fn saved(workers: u32, me: u32) -> usize {
    first(workers, 1 << workers) + 1 + 2 * (STACK * me) as usize
}

/// Words of `control` for `2^workers` workers that are balanced.
pub const fn words(workers: u32) -> usize {
    saved(workers, 1 << workers)
}

/// Words of `control` for the workers that a record speaks of.
pub fn words_of(args: &NodeDescent) -> usize {
    if args.tasks == NodeDescent::TASKS_BALANCED {
        words(args.workers)
    } else {
        words_with_deques(thieves(args))
    }
}

/// The tasks of worker `me` of `2^workers` if all have equal parts, and the last ones less: the
/// first, and how many. For fewer than 2^31 tasks.
#[inline(always)]
pub fn part(tasks: u32, me: u32, workers: u32) -> [u32; 2] {
    let size = (tasks + (1 << workers) - 1) >> workers;
    let first = (me * size).min(tasks);
    [first, size.min(tasks - first)]
}

/// Whose pair comes to `place` of the next tasks: the last of `2^workers` workers whose pairs begin
/// at most there. A search in halves, `workers` steps.
#[inline(always)]
pub fn owner(control: &[u32], workers: u32, place: u32) -> u32 {
    let mut owner = 0;
    for k in 0..workers {
        let later = owner + (1 << (workers - 1 - k));
        if at(control, first(workers, later)) <= place {
            owner = later;
        }
    }
    owner
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::vec;
    use std::vec::Vec;

    #[test]
    fn parts_are_all_tasks_in_order() {
        for (tasks, workers) in [(0, 2), (1, 2), (4, 2), (5, 2), (100, 3), (1_000_003, 11)] {
            let mut next = 0;
            for me in 0..1 << workers {
                let [first, n] = part(tasks, me, workers);
                assert_eq!(first, next, "{tasks} tasks, worker {me}");
                assert!(n <= (tasks + (1 << workers) - 1) >> workers);
                next = first + n;
            }
            assert_eq!(next, tasks);
        }
    }

    #[test]
    fn owners_are_those_of_a_search_one_by_one() {
        for counts in [vec![3, 0, 0, 5], vec![0, 0, 0, 1], vec![2, 2, 2, 2], vec![7, 0, 1, 0]] {
            let mut control = vec![0; first(2, 4) + 1];
            let (mut place, mut owners) = (40, Vec::new());
            for (me, &n) in (0..).zip(&counts) {
                control[first(2, me)] = place;
                owners.extend(vec![me; n as usize]);
                place += n;
            }
            let found: Vec<u32> = (40..place).map(|place| owner(&control, 2, place)).collect();
            assert_eq!(found, owners, "{counts:?}");
        }
    }

    #[test]
    fn no_word_is_two_things() {
        let all = [counts(7), left(3, 0), left(3, 7) + 1, first(3, 0), first(3, 8), saved(3, 0)];
        assert!(all.windows(2).all(|w| w[0] < w[1]));
        assert_eq!(words(3) - saved(3, 7), 2 * STACK as usize);
    }
}
