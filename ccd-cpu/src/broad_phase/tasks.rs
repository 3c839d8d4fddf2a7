//! Runs a tree of pairs on threads, compiled into every sink: cut into tasks breadth first, which
//! workers take from a shared counter and finish depth first, each with a stack of its own.
//!
//! Twin: on a GPU `block_levels.rs`, which expands a level a dispatch.
//!
//! That is self-scheduling, which [`crate::broad_phase::scheduler`] has too, beside others, for
//! trees that list rows.

use crate::broad_phase::pair_source::PairSink;
use crate::broad_phase::pair_tree::PairTree;
use crate::simd::{RowSimd, Work};
use crate::threads::{Own, Threads};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Tasks wanted: enough that the largest is a small part of the whole.
pub const MIN_TASKS: usize = 1024;
/// A worker takes one of so many parts of its share of the tasks that are left, and at most so many
/// tasks.
const SHARES: usize = 32;
const MAX_TAKEN: usize = 64;

/// A tree of pairs, the pair that is its root, and what takes rows of its leaf pairs.
pub type Search<'a, T, K> = (T, NodePair, &'a K);

/// The tasks of up to two traversals and the stack of each worker, kept between calls.
#[derive(Debug, Default)]
pub struct Tasks {
    tasks: [Vec<NodePair>; 2],
    next: Vec<NodePair>,
    stacks: Vec<Own<Vec<NodePair>>>,
}

impl Tasks {
    /// Hands the rows of all leaf pairs below the roots of up to two trees to their sinks; who
    /// finds no task of the first begins with the second. `part`: only every so many-th task of
    /// each (1: all).
    pub fn run<T: PairTree, K: PairSink, L: PairSink<Worker = K::Worker>>(
        &mut self,
        threads: &Threads,
        first: Option<Search<T, K>>,
        second: Option<Search<T, L>>,
        part: usize,
        workers: &mut [K::Worker],
    ) {
        self.stacks.resize_with(workers.len(), || Own(Vec::with_capacity(1024)));
        self.split(0, first.map(|(tree, root, _)| (tree, root)));
        self.split(1, second.map(|(tree, root, _)| (tree, root)));
        let tasks = &self.tasks;
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
        share(threads, n_first + n_second, workers, &mut self.stacks, &run, &end);
    }

    /// Cuts a traversal into tasks, if there is one.
    fn split<T: PairTree>(&mut self, of: usize, traversal: Option<(T, NodePair)>) {
        let Self { tasks, next, .. } = self;
        let tasks = &mut tasks[of];
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

/// Has workers take the tasks below `n` from a shared counter, until the call is to end; `run` does
/// one, with what the worker gathers and what it needs for itself, and `end` ends each worker.
///
/// A worker takes several tasks that follow each other, because these mostly read the same boxes:
/// the fewer the fewer are left.
pub fn share<W: Send, X: Send>(
    threads: &Threads,
    n: usize,
    workers: &mut [W],
    scratch: &mut [X],
    run: &(dyn Fn(usize, &mut W, &mut X) + Sync),
    end: &(dyn Fn(&mut W) + Sync),
) {
    let (counter, n_workers) = (AtomicUsize::new(0), workers.len());
    threads.each_with(workers, scratch, &|worker, scratch| {
        let mut parts = TaskParts::new(n, n_workers);
        // An addition never has to be tried again, as an exchange has if another thread was first.
        while let Some(part) = parts.part(counter.fetch_add(1, Ordering::Relaxed)) {
            for k in part {
                if threads.stop.is_stopped() {
                    return end(worker);
                }
                run(k, worker, scratch);
            }
        }
        end(worker);
    });
}

/// Tasks in parts: rounds of one for each worker, all of one size, which falls from round to round.
struct TaskParts {
    n_workers: usize,
    /// The number of the first part of a round, its first task, and the tasks from there on.
    first_part: usize,
    first: usize,
    left: usize,
}

impl TaskParts {
    fn new(n: usize, n_workers: usize) -> Self {
        Self { n_workers, first_part: 0, first: 0, left: n }
    }

    /// Part `k`, not before one that was asked for; `None` after the last one.
    fn part(&mut self, k: usize) -> Option<Range<usize>> {
        while self.left > 0 {
            let size = (self.left / (SHARES * self.n_workers)).clamp(1, MAX_TAKEN);
            let end = self.first + self.left;
            if k - self.first_part < self.n_workers {
                let first = self.first + (k - self.first_part) * size;
                return (first < end).then(|| first..(first + size).min(end));
            }
            let of_round = (size * self.n_workers).min(self.left);
            self.first_part += self.n_workers;
            self.first += of_round;
            self.left -= of_round;
        }
        None
    }
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
    fn parts_have_each_task_once() {
        for (n, n_workers) in [(0, 1), (1, 1), (5, 16), (512, 16), (4300, 1), (4301, 16), (9000, 3)]
        {
            let mut parts = TaskParts::new(n, n_workers);
            let mut next = 0;
            let mut k = 0;
            while let Some(part) = parts.part(k) {
                assert_eq!(part.start, next, "{n} tasks, {n_workers} workers, part {k}");
                assert!(part.len() <= MAX_TAKEN && !part.is_empty());
                (next, k) = (part.end, k + 1);
            }
            assert_eq!(next, n);
            // Who sees few of the parts sees the same.
            let (mut all, mut some) = (TaskParts::new(n, n_workers), TaskParts::new(n, n_workers));
            for k in 0..k + 2 {
                let part = all.part(k);
                assert!(k % 7 > 0 || some.part(k) == part, "part {k}");
            }
        }
    }
}
