//! Schedulers: who expands which pairs of nodes, where nobody knows beforehand what is below one.
//!
//! Twin: on a GPU `scheduler/` has two files: levels, and workers by any rule.
//!
//! | scheduler | a pair that was found goes to | a worker without pairs |
//! |---|---|---|
//! | [`self_scheduling`] | the worker's own stack | takes the next task from a shared counter |
//! | [`frontier`] | the queue of the next level | takes the next piece of the queue |
//! | static lists, of [`balanced`] | the worker's own stack | is done |
//! | [`balanced`] | the worker's own stack | waits until all is dealt out again |
//! | [`shared_queue`] | one queue of all workers | takes the first of that queue |
//! | [`stealing`] | the worker's own deque | takes one from another's deque |
//! | [`abp_stealing`] | the same, as printed | takes one from another's deque |
//! | [`lazy_stealing`] | the worker's stack, then its deque | takes batches from all deques |
//!
//! They know pairs of words and nothing of boxes or trees: what a pair is, and where rows of leaves
//! go, is behind a [`Hand`], one a worker. So each is compiled once, for all trees and sinks; and
//! none decides anything but who does what: a scheduler that drops or doubles a pair is the only
//! way in which one can be wrong.
//!
//! docs/SCHEDULING.md compares them.

pub mod abp_stealing;
pub mod balanced;
pub mod frontier;
pub mod lazy_stealing;
pub mod self_scheduling;
pub mod shared_queue;
pub mod stealing;
pub mod task_pool;
#[cfg(test)]
mod tests;

use crate::stop::Stop;
use crate::threads::Own;
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair};
use std::fmt::Debug;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What a worker expands pairs with.
pub struct Hand<'h> {
    /// The number of the worker, which no other has.
    pub worker: usize,
    /// Expands pairs that meet: hands on rows of leaves, and appends the children that meet and are
    /// no leaves.
    pub expand: &'h mut dyn FnMut(&[NodePair], &mut Vec<NodePair>),
}

/// What a worker does.
pub type Job<'j> = &'j (dyn Fn(&mut Hand) + Sync);

/// Has every worker do a job, and waits until all have. Workers may do it at the same time or one
/// after the other.
pub type Launch<'l> = &'l mut dyn FnMut(Job);

/// Shares out pairs of nodes among workers.
pub trait Schedule: Debug + Send + Sync {
    /// Has all tasks expanded, and all that is found below them; none is left. Results do not
    /// depend on who does what.
    ///
    /// What an earlier run left, one that unwound, is gone.
    fn run(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, stop: &Stop, launch: Launch);
}

/// Pairs that are expanded together: the last of a stack.
const BATCH: usize = 16;
/// The name of lists in [`ccd_core::Error::Memory`].
pub const PAIRS_OF_NODES: &str = "pairs of nodes of trees";
/// Capacity of a list from the beginning, so that it rarely grows later.
const CAPACITY: usize = 1 << 13;

/// A list a worker, kept between calls.
#[derive(Debug, Default)]
pub struct Lists(Vec<Own<Mutex<Vec<NodePair>>>>);

impl Lists {
    /// One each for so many workers, all empty.
    pub fn prepare(&mut self, n_workers: usize) {
        for Own(list) in &mut self.0 {
            list.get_mut().unwrap_or_else(PoisonError::into_inner).clear();
        }
        self.0.resize_with(n_workers, || Own(Mutex::new(Vec::with_capacity(CAPACITY))));
    }

    /// That of a worker, which nobody else asks for.
    pub fn of(&self, worker: usize) -> MutexGuard<'_, Vec<NodePair>> {
        self.0[worker].0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Moves tasks to all lists in turn.
    pub fn deal(&mut self, tasks: &mut Vec<NodePair>) {
        let n = self.0.len();
        for (worker, Own(list)) in self.0.iter_mut().enumerate() {
            let list = list.get_mut().unwrap_or_else(PoisonError::into_inner);
            list.extend(tasks.iter().skip(worker).step_by(n));
        }
        tasks.clear();
    }

    /// Moves all that is in the lists to `into`, unless the call is to end for it.
    pub fn gather(&mut self, into: &mut Vec<NodePair>, stop: &Stop) {
        for Own(list) in &mut self.0 {
            let list = list.get_mut().unwrap_or_else(PoisonError::into_inner);
            if stop.reserve(PAIRS_OF_NODES, into, list.len()) {
                into.append(list);
            }
        }
        if stop.is_limited() {
            return;
        }
        // Any worker may have all of them next time.
        for Own(list) in &mut self.0 {
            let list = list.get_mut().unwrap_or_else(PoisonError::into_inner);
            list.reserve(into.len() + into.len() / 8);
        }
    }
}

/// Expands what is on a stack, and what that leaves on it, the last first: at most so many batches.
fn drain(hand: &mut Hand, stack: &mut Vec<NodePair>, most: usize) {
    let mut batch = [NO_PAIR; BATCH];
    for _ in 0..most {
        let n = stack.len().min(BATCH);
        if n == 0 {
            break;
        }
        let from = stack.len() - n;
        batch[..n].copy_from_slice(&stack[from..]);
        stack.truncate(from);
        (hand.expand)(&batch[..n], stack);
    }
}
