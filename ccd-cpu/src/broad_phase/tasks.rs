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
use std::sync::atomic::{AtomicUsize, Ordering};

/// Tasks wanted: enough that the largest is a small part of the whole.
pub const MIN_TASKS: usize = 1024;
/// A worker takes one of so many parts of its share of the tasks that are left, and at most so many
/// tasks.
const SHARES: usize = 32;
const MAX_TAKEN: usize = 64;

/// The tasks of a traversal and the stack of each worker, kept between calls.
#[derive(Debug, Default)]
pub struct Tasks {
    tasks: Vec<NodePair>,
    next: Vec<NodePair>,
    stacks: Vec<Own<Vec<NodePair>>>,
}

impl Tasks {
    /// Hands the rows of all leaf pairs below the root of `tree` to the sink. `part`: only every so
    /// many-th task (1: all).
    pub fn run<T: PairTree, K: PairSink>(
        &mut self,
        threads: &Threads,
        (tree, root): (T, NodePair),
        part: usize,
        sink: &K,
        workers: &mut [K::Worker],
    ) {
        self.split(tree, root);
        self.stacks.resize_with(workers.len(), || Own(Vec::with_capacity(1024)));
        let tasks = &self.tasks;
        let descend = |k: usize, worker: &mut K::Worker, Own(stack): &mut Own<Vec<NodePair>>| {
            stack.clear();
            stack.push(tasks[k]);
            crate::simd::run_rows!(DepthFirst { tree, stack, sink, worker });
        };
        share(threads, tasks.len(), part, sink, workers, &mut self.stacks, &descend);
    }

    /// Cuts the traversal into tasks.
    fn split<T: PairTree>(&mut self, tree: T, root: NodePair) {
        self.tasks.clear();
        self.tasks.push(root);
        while self.tasks.len() < MIN_TASKS && self.tasks.iter().any(|&task| !tree.is_leaf(task)) {
            self.next.clear();
            let (tasks, out) = (&self.tasks, &mut self.next);
            crate::simd::run_rows!(Split { tree, tasks, out });
            std::mem::swap(&mut self.tasks, &mut self.next);
        }
    }
}

/// Has workers take the tasks `0`, `part`, `2 part` .. below `n` from a shared counter, until the
/// call is to end; `run` does one, with what the worker gathers and what it needs for itself.
///
/// A worker takes several tasks that follow each other, because these mostly read the same boxes:
/// the fewer the fewer are left.
pub fn share<K: PairSink, X: Send>(
    threads: &Threads,
    n: usize,
    part: usize,
    sink: &K,
    workers: &mut [K::Worker],
    scratch: &mut [X],
    run: &(dyn Fn(usize, &mut K::Worker, &mut X) + Sync),
) {
    let (counter, n_workers) = (AtomicUsize::new(0), workers.len());
    let n = n.div_ceil(part);
    let end_of = |first: usize| first + ((n - first) / (SHARES * n_workers)).clamp(1, MAX_TAKEN);
    let take = || {
        let next = |first: usize| (first < n).then(|| end_of(first));
        counter.fetch_update(Ordering::Relaxed, Ordering::Relaxed, next)
    };
    threads.each_with(workers, scratch, &|worker, scratch| {
        while let Ok(first) = take() {
            for k in (first..end_of(first)).map(|k| k * part) {
                if threads.stop.is_stopped() {
                    return sink.end(worker);
                }
                sink.begin(worker, k);
                run(k, worker, scratch);
            }
        }
        sink.end(worker);
    });
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
