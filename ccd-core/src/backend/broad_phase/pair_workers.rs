//! Workers of a device that descend pairs of nodes: how tasks are shared out among them, and where
//! they count.
//!
//! ```text
//!  a round    tasks  [p p p p p p p p p p p p p]  a list of pairs of nodes
//!                     |   |     |       a part of it, or the next piece of it
//!             worker  v   v     v
//!             stack  [..][...][.]   the last 128 are expanded, what they leave goes on top;
//!                     |   |     |   what does not fit, or is left when the worker ends:
//!  the next   tasks  [p p p p p p]
//! ```
//!
//! A worker is a workgroup with a stack in its own memory. A thread expands a pair of binary trees,
//! 32 threads one of blocks ([`block_workers`](super::block_workers)). A worker takes tasks when
//! its stack has fewer pairs than a turn takes; it ends when it finds none, when too many
//! others have, or after so many turns, so that no driver thinks that it hangs. Nobody waits for
//! another, nothing but counters passes between workgroups inside a dispatch, and of those nothing
//! but the order of work depends: what is on a list is read by the next dispatch.
//!
//! There is a power of two of workers, because a division by what is not known is a check, and a
//! failed check would leave before a barrier. Counters of all rounds stand in one buffer,
//! `control`, so that none is cleared between rounds; behind them stand the deques of workers that
//! steal, which are empty between rounds: who ends drains its own.

use crate::layout::NodeDescent;
use crate::scheduling::stealing::Workers;

/// Threads of a worker.
pub const THREADS: u32 = 128;
/// Capacity of the stack of a worker, in pairs.
pub const STACK: u32 = 1024;
/// Rounds of a search, at most, and one: as many as a list a level takes for trees of any shape.
pub const ROUNDS: u32 = 512;
/// Turns of a worker before it looks whether too many others are idle, so that a round always gets
/// on.
pub const QUANTUM: u32 = 16;

/// Word of `control`: set if pairs are left after the last round.
pub const LEFT: usize = 3 * ROUNDS as usize;
/// Words of `control`: pairs of the front that is written; how often that count ran over.
pub const FRONT: usize = LEFT + 1;
/// First word of `control` of what each worker counts: turns, then pairs that it expanded.
pub const COUNTS: usize = LEFT + 4;

/// Word of `control`: capacity that the list of a round wants.
#[inline(always)]
pub const fn listed(round: u32) -> usize {
    round as usize
}

/// Word of `control`: the next task of a round that has not been taken.
#[inline(always)]
pub const fn taken(round: u32) -> usize {
    (ROUNDS + round) as usize
}

/// Word of `control`: workers that are idle in a round.
#[inline(always)]
pub const fn idle(round: u32) -> usize {
    (2 * ROUNDS + round) as usize
}

/// First word of what a worker counts.
#[inline(always)]
pub const fn counts(worker: u32) -> usize {
    COUNTS + 2 * worker as usize
}

/// Words of `control` for so many workers.
pub const fn words(workers: u32) -> usize {
    counts(workers)
}

/// First word of `control` of what workers that steal count together: batches that were popped, and
/// stolen; pushes that a full deque refused.
#[inline(always)]
pub const fn stolen(workers: u32) -> usize {
    counts(workers)
}

/// First word of `control` of their deques.
#[inline(always)]
pub const fn deques(workers: u32) -> usize {
    counts(workers) + 4
}

/// Words of `control` for workers that steal.
pub const fn words_with_deques(workers: Workers) -> usize {
    deques(workers.n) + workers.words()
}

/// The workers that a record speaks of.
#[inline(always)]
pub fn thieves(args: &NodeDescent) -> Workers {
    Workers { n: 1 << args.workers, batches: args.batches, batch: args.batch }
}

/// Whose deque hand `hand` of worker `me` of `n`, a power of two, looks at in a turn: those after
/// one that changes from turn to turn, maybe its own.
#[inline(always)]
pub fn victim(n: u32, me: u32, turn: u32, hand: u32) -> u32 {
    let at_random = (me + turn).wrapping_mul(0x9e37_79b9) >> 8;
    (me + 1 + at_random + hand) & (n - 1)
}

/// Tasks that worker `me` of `2^workers` has if all are dealt out: `me`, `me + 2^workers` ..
#[inline(always)]
pub fn share(tasks: u32, me: u32, workers: u32) -> u32 {
    if me < tasks { ((tasks - 1 - me) >> workers) + 1 } else { 0 }
}

/// Tasks that one of `2^workers` takes at once from the counter: about a quarter of what is there
/// for each, at least so many and at most for all of its threads.
#[inline(always)]
pub fn piece(tasks: u32, workers: u32, least: u32) -> u32 {
    (tasks >> (workers + 2)).max(least).min(THREADS)
}

/// Whether of `2^workers` workers so many percent are idle; 0 percent: never.
#[inline(always)]
pub fn is_over(n_idle: u32, workers: u32, percent: u32) -> bool {
    percent > 0 && n_idle * 100 >= percent << workers
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scheduling::stealing::HANDS;
    use std::collections::BTreeSet;
    use std::vec::Vec;

    #[test]
    fn shares_are_all_tasks() {
        for (tasks, workers) in [(0, 2), (1, 2), (4, 2), (100, 3), (1_000_003, 11)] {
            let sum: u32 = (0..1 << workers).map(|me| share(tasks, me, workers)).sum();
            assert_eq!(sum, tasks);
            let last = (0..1 << workers).filter(|&me| share(tasks, me, workers) > 0).max();
            assert_eq!(last, tasks.min(1 << workers).checked_sub(1));
        }
    }

    #[test]
    fn a_piece_is_never_empty() {
        let of = [(0, 1), (5, 1), (80_000, 1), (u32::MAX, 1), (5, THREADS)];
        assert_eq!(of.map(|(n, least)| piece(n, 11, least)), [1, 1, 9, 128, 128]);
    }

    #[test]
    fn thieves_look_at_all_others() {
        for n in [1, 2, 16, 2048] {
            for (me, turn) in [(0, 0), (n / 2, 7), (n - 1, 4096)] {
                let mut seen: Vec<u32> = (0..HANDS).map(|hand| victim(n, me, turn, hand)).collect();
                seen.sort_unstable();
                seen.dedup();
                assert_eq!(seen.len() as u32, n.min(HANDS), "{n} workers, worker {me}");
                assert!(seen.iter().all(|&other| other < n));
            }
            let seen: BTreeSet<u32> = (0..4 * n).map(|turn| victim(n, 0, turn, 0)).collect();
            assert!(2 * seen.len() as u32 >= n, "{n} workers: {} are seen", seen.len());
        }
    }

    #[test]
    fn a_round_is_over_when_enough_are_idle() {
        let of = [(0, 0), (2048, 0), (20, 1), (21, 1), (1023, 50), (1024, 50), (2047, 100)];
        let over = of.map(|(n_idle, percent)| is_over(n_idle, 11, percent));
        assert_eq!(over, [false, false, false, true, false, true, false]);
    }

    #[test]
    fn no_word_counts_two_things() {
        let last = ROUNDS - 1;
        let words = [listed(0), listed(last), taken(0), taken(last), idle(0), idle(last)];
        let all = words.into_iter().chain([LEFT, FRONT, FRONT + 1, counts(0), counts(1)]);
        assert!(all.clone().zip(all.skip(1)).all(|(a, b)| a < b));
    }
}
