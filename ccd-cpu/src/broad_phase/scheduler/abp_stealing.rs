//! Task stealing with the deque as it is printed: its owner takes at the bottom without an
//! exchange unless one pair is left, thieves exchange the top with its tag [Arora 1998], algorithm
//! 3.6 of [da Silva 2013].
//!
//! The deque is [`ccd_core::backend::scheduling::abp_deque`], with the fences that the print leaves
//! out (docs/SCHEDULING.md); the worker's loop is that of [`super::task_pool`].
//!
//! Cost: an addition a push, a fence a pop. Beside [`super::stealing`] for comparison.

use super::Lists;
use super::task_pool::{Pooled, TaskPool};
use crate::broad_phase::tree::shared_words::Shared;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::scheduling::abp_deque::AbpDeque;
use ccd_core::backend::scheduling::deque::Full;
use std::sync::atomic::AtomicU32;

/// The scheduler, with deques of this capacity in pairs.
pub fn abp_stealing(capacity: u32) -> Pooled<impl TaskPool> {
    Pooled::new(AbpDeques { n: 0, capacity, words: Vec::new() })
}

#[derive(Debug)]
struct AbpDeques {
    n: u32,
    capacity: u32,
    words: Vec<AtomicU32>,
}

impl AbpDeques {
    fn deque(&self, worker: u32) -> AbpDeque {
        let base = worker as usize * AbpDeque::words(self.capacity);
        AbpDeque { base, capacity: self.capacity }
    }

    fn words(&self) -> Shared<'_> {
        Shared(&self.words)
    }
}

impl TaskPool for AbpDeques {
    fn deal(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, spilled: &Lists) {
        self.n = n_workers as u32;
        let n_words = n_workers * AbpDeque::words(self.capacity);
        self.words.resize_with(n_words, AtomicU32::default);
        (0..self.n).for_each(|worker| self.deque(worker).clear(&self.words()));
        for (k, task) in tasks.drain(..).enumerate() {
            let worker = k % n_workers;
            if self.put(worker as u32, task).is_err() {
                spilled.of(worker).push(task);
            }
        }
    }

    fn take(&self, me: u32, out: &mut Vec<NodePair>) -> bool {
        let pair = self.deque(me).pop(&self.words());
        out.extend(pair);
        pair.is_some()
    }

    fn steal(&self, me: u32, first: u32, out: &mut Vec<NodePair>) -> bool {
        let others = (0..self.n).map(|k| (first % self.n + k) % self.n).filter(|&k| k != me);
        let pair = { others }.find_map(|victim| self.deque(victim).steal(&self.words()));
        out.extend(pair);
        pair.is_some()
    }

    fn put(&self, me: u32, pair: NodePair) -> Result<(), Full> {
        self.deque(me).push(&self.words(), pair)
    }
}
