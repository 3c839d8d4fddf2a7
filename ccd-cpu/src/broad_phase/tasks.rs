//! Runs a tree of pairs on threads, compiled into every sink: cut into tasks breadth first, of
//! which each worker has a share and does one after the other depth first, on a stack of its own.
//!
//! Twin: on a GPU `block_levels.rs`, which expands a level a dispatch.
//!
//! Other schedulers, for trees that list rows, are in [`crate::broad_phase::scheduler`].

use crate::broad_phase::pair_source::PairSink;
use crate::broad_phase::pair_tree::PairTree;
use crate::simd::{RowSimd, Work};
use crate::threads::{Own, Threads};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};

/// Tasks wanted: enough that the largest is a small part of the whole.
pub const MIN_TASKS: usize = 1024;

/// A tree of pairs, the pair that is its root, and what takes rows of its leaf pairs.
pub type Search<'a, T, K> = (T, NodePair, &'a K);

/// The tasks of one traversal, and those that are being made of them.
#[derive(Debug, Default)]
struct Cut {
    tasks: Vec<NodePair>,
    next: Vec<NodePair>,
}

/// The tasks of up to two traversals and the stack of each worker, kept between calls.
#[derive(Debug, Default)]
pub struct Tasks {
    cuts: [Cut; 2],
    shares: Shares,
    stacks: Vec<Own<Vec<NodePair>>>,
}

impl Tasks {
    /// Hands the rows of all leaf pairs below the roots of up to two trees to their sinks; workers
    /// share the tasks of both. `part`: only every so many-th task of each (1: all). `cut`: whether
    /// there are tasks of these traversals, from the call before.
    pub fn run<T: PairTree, K: PairSink, L: PairSink<Worker = K::Worker>>(
        &mut self,
        threads: &Threads,
        first: Option<Search<T, K>>,
        second: Option<Search<T, L>>,
        (part, cut): (usize, bool),
        workers: &mut [K::Worker],
    ) {
        let Self { cuts: [of_first, of_second], shares, stacks } = self;
        stacks.resize_with(workers.len(), || Own(Vec::with_capacity(1024)));
        if !cut {
            threads.together(
                || of_first.make(first.map(|(tree, root, _)| (tree, root))),
                || of_second.make(second.map(|(tree, root, _)| (tree, root))),
                || {},
            );
        }
        let tasks = [&of_first.tasks, &of_second.tasks];
        let [n_first, n_second] = tasks.each_ref().map(|tasks| tasks.len().div_ceil(part));
        let run = |k: usize, worker: &mut K::Worker, Own(stack): &mut Own<Vec<NodePair>>| {
            stack.clear();
            if let Some((tree, _, sink)) = first.filter(|_| k < n_first) {
                let k = k * part;
                stack.push(tasks[0][k]);
                sink.begin(worker, k);
                crate::simd::run_rows!(DepthFirst { tree, stack, sink, worker });
            } else if let Some((tree, _, sink)) = second {
                let k = (k - n_first) * part;
                stack.push(tasks[1][k]);
                sink.begin(worker, k);
                crate::simd::run_rows!(DepthFirst { tree, stack, sink, worker });
            }
        };
        let end = |worker: &mut K::Worker| {
            first.iter().for_each(|(_, _, sink)| sink.end(worker));
            second.iter().for_each(|(_, _, sink)| sink.end(worker));
        };
        shares.run(threads, n_first + n_second, workers, stacks, &run, &end);
    }
}

impl Cut {
    /// Cuts a traversal into tasks, if there is one.
    fn make<T: PairTree>(&mut self, traversal: Option<(T, NodePair)>) {
        let Self { tasks, next } = self;
        tasks.clear();
        let Some((tree, root)) = traversal else { return };
        tasks.push(root);
        while tasks.len() < MIN_TASKS && tasks.iter().any(|&task| !tree.is_leaf(task)) {
            next.clear();
            let (from, out) = (&*tasks, &mut *next);
            crate::simd::run_rows!(Split { tree, tasks: from, out });
            std::mem::swap(tasks, next);
        }
    }
}

/// The tasks that each worker has left, a run of them in one word.
///
/// Tasks that follow each other mostly read the same boxes, so each worker begins with a share of
/// neighbours: what one processor has in its caches another would have to fetch from there. Who has
/// nothing left takes half of what the one has that has the most, as in affinity scheduling
/// [Markatos 1994].
#[derive(Debug, Default)]
pub struct Shares(Vec<Own<AtomicU64>>);

impl Shares {
    /// Has workers do the tasks below `n`, until the call is to end; `run` does one, with what the
    /// worker gathers and what it needs for itself, and `end` ends each worker.
    pub fn run<W: Send, X: Send>(
        &mut self,
        threads: &Threads,
        n: usize,
        workers: &mut [W],
        scratch: &mut [X],
        run: &(dyn Fn(usize, &mut W, &mut X) + Sync),
        end: &(dyn Fn(&mut W) + Sync),
    ) {
        self.deal(n, workers.len());
        let shares = &*self;
        threads.each_with(workers, scratch, &|k, worker, scratch| {
            while let Some(task) = shares.next(k).filter(|_| !threads.stop.is_stopped()) {
                run(task, worker, scratch);
            }
            end(worker);
        });
    }

    /// Gives each of these workers its share of the tasks below `n`.
    fn deal(&mut self, n: usize, n_workers: usize) {
        let n = u64::from(u32::try_from(n).expect("tasks have numbers of 32 bits"));
        self.0.resize_with(n_workers, Own::default);
        let first = |k: usize| (n * k as u64 / n_workers as u64) as u32;
        for (k, Own(share)) in self.0.iter_mut().enumerate() {
            *share.get_mut() = packed(first(k)..first(k + 1));
        }
    }

    /// The next task of worker `k`, its own or another's; `None` if none was found.
    fn next(&self, k: usize) -> Option<usize> {
        let Own(own) = &self.0[k];
        let take = |run: Range<u32>| (!run.is_empty()).then(|| packed(run.start + 1..run.end));
        if let Ok(run) = own.fetch_update(Relaxed, Relaxed, |run| take(unpacked(run))) {
            return Some(unpacked(run).start as usize);
        }
        loop {
            let left = |Own(share): &Own<AtomicU64>| unpacked(share.load(Relaxed));
            let runs = self.0.iter().map(|share| (share, left(share)));
            let (Own(other), run) = runs.max_by_key(|(_, run)| run.len())?;
            if run.is_empty() {
                return None;
            }
            let middle = run.start + (run.end - run.start) / 2;
            let (kept, taken) = (packed(run.start..middle), packed(middle + 1..run.end));
            // No run comes back to where it was: its first task is done, or its end is another's.
            if other.compare_exchange(packed(run), kept, Relaxed, Relaxed).is_ok() {
                own.store(taken, Relaxed);
                return Some(middle as usize);
            }
        }
    }
}

/// A run of tasks in one word.
fn packed(run: Range<u32>) -> u64 {
    u64::from(run.start) << 32 | u64::from(run.end)
}

fn unpacked(run: u64) -> Range<u32> {
    (run >> 32) as u32..run as u32
}

/// The children of all `tasks`, and the leaf pairs among them, appended to `out`.
struct Split<'a, T: PairTree> {
    tree: T,
    tasks: &'a [NodePair],
    out: &'a mut Vec<NodePair>,
}

impl<S: RowSimd, T: PairTree> Work<S> for Split<'_, T> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        for &task in self.tasks {
            if self.tree.is_leaf(task) {
                self.out.push(task);
            } else {
                self.tree.expand(simd, task, self.out);
            }
        }
    }
}

/// Expands the pairs of a stack down to rows of leaves. Returns the number of expanded pairs.
pub struct DepthFirst<'a, T: PairTree, K: PairSink> {
    /// What is descended.
    pub tree: T,
    /// Pairs that wait; empty afterwards.
    pub stack: &'a mut Vec<NodePair>,
    /// Where rows go.
    pub sink: &'a K,
    /// What it gathers.
    pub worker: &'a mut K::Worker,
}

impl<S: RowSimd, T: PairTree, K: PairSink> Work<S> for DepthFirst<'_, T, K> {
    type Out = u64;

    #[inline(always)]
    fn call(self, simd: S) -> u64 {
        let Self { tree, stack, sink, worker } = self;
        let mut n_expanded = 0;
        while let Some(pair) = stack.pop() {
            if tree.is_leaf(pair) {
                tree.rows(simd, pair, sink, worker);
            } else {
                n_expanded += 1;
                tree.expand(simd, pair, stack);
            }
        }
        n_expanded
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_task_is_done_once() {
        for (n, n_workers) in [(0, 1), (1, 1), (5, 16), (512, 16), (4300, 1), (4301, 4), (9000, 3)]
        {
            let threads = Threads::new(n_workers).unwrap();
            let (mut shares, mut ended) = (Shares::default(), vec![false; n_workers]);
            let mut done = vec![Vec::new(); n_workers];
            let run = |task: usize, _: &mut bool, done: &mut Vec<usize>| {
                // One share takes much longer than the others.
                if task < n / n_workers {
                    std::thread::yield_now();
                }
                done.push(task);
            };
            shares.run(&threads, n, &mut ended, &mut done, &run, &|ended| *ended = true);
            assert!(ended.iter().all(|&ended| ended));
            let mut all = done.concat();
            all.sort_unstable();
            assert!(all.into_iter().eq(0..n), "{n} tasks, {n_workers} workers");
        }
    }

    #[test]
    fn who_has_nothing_left_takes_half_of_the_most() {
        let mut shares = Shares::default();
        shares.deal(100, 4);
        // Worker 1 does its own tasks, 25 to 49, and worker 2 the first of its own. Then workers 0
        // and 3 have 25 left, the most; of equal ones the last is taken from.
        (0..25).for_each(|i| assert_eq!(shares.next(1), Some(25 + i)));
        assert_eq!(shares.next(2), Some(50));
        assert_eq!(shares.next(1), Some(87), "half of worker 3's");
        assert_eq!(shares.next(1), Some(88));
        assert_eq!(shares.next(3), Some(75));
        // Worker 0, alone, does all that is left.
        let mut left: Vec<_> = std::iter::from_fn(|| shares.next(0)).collect();
        left.sort_unstable();
        let others = (0..25).chain(51..75).chain(76..87).chain(89..100);
        assert!(left.into_iter().eq(others));
        assert!((0..4).all(|k| shares.next(k).is_none()));
    }
}
