//! Task stealing: every worker has a deque; its owner pushes and pops pairs at one end, and whose
//! own is empty takes one from the other end of another's [Arora 1998], algorithms 3.5 and 3.6 of
//! [da Silva 2013].
//!
//! The deque is [`ccd_core::backend::scheduling`], whose ends stand in one word, so that no pair is
//! taken twice; a model checker goes through it (docs/SCHEDULING.md). The worker's loop is that of
//! [`super::task_pool`].
//!
//! Cost: a push and a pop a pair, each a few atomic operations on words that nobody else has in
//! hand most of the time. Choose [`super::lazy_stealing`], which moves as much with fewer.

use super::Lists;
use super::task_pool::{Pooled, TaskPool};
use crate::broad_phase::tree::shared_words::Shared;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::scheduling::deque::Full;
use ccd_core::backend::scheduling::stealing::{Taken, Workers};
use std::sync::atomic::AtomicU32;

/// The scheduler, with deques of this capacity in pairs: a power of two.
pub fn stealing(capacity: u32) -> Pooled<Deques> {
    Pooled::new(Deques::new(capacity, 1))
}

/// Capacity of a deque in a session.
pub const CAPACITY: u32 = 1 << 13;

/// The deques of all workers and the words in which they stand.
#[derive(Debug)]
pub struct Deques {
    /// Whose they are.
    pub workers: Workers,
    words: Vec<AtomicU32>,
}

impl Deques {
    /// With deques of so many batches of so many pairs.
    pub fn new(batches: u32, batch: u32) -> Self {
        Self { workers: Workers { n: 0, batches, batch }, words: Vec::new() }
    }

    /// The words.
    pub fn words(&self) -> Shared<'_> {
        Shared(&self.words)
    }

    /// Appends the pairs of a batch that was taken.
    pub fn read(&self, taken: Taken, out: &mut Vec<NodePair>) {
        let (deque, words) = (self.workers.deque(taken.owner), self.words());
        let n = deque.items(&words, taken.slot);
        out.extend((0..n).map(|i| deque.read(&words, taken.slot, i)));
        self.workers.done(&words, taken);
    }
}

impl TaskPool for Deques {
    /// To all deques in turn, in batches; what does not fit goes to a list of the same worker.
    fn deal(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, spilled: &Lists) {
        self.workers.n = n_workers as u32;
        self.words.resize_with(self.workers.words(), AtomicU32::default);
        let (workers, words) = (self.workers, Shared(&self.words));
        workers.clear(&words);
        for (k, batch) in tasks.chunks(workers.batch as usize).enumerate() {
            let worker = k % n_workers;
            if workers.deque(worker as u32).push(&words, batch).is_err() {
                spilled.of(worker).extend_from_slice(batch);
            }
        }
        tasks.clear();
    }

    fn take(&self, me: u32, out: &mut Vec<NodePair>) -> bool {
        let taken = self.workers.pop(&self.words(), me);
        taken.inspect(|&taken| self.read(taken, out)).is_some()
    }

    fn steal(&self, me: u32, first: u32, out: &mut Vec<NodePair>) -> bool {
        let taken = self.workers.steal_task(&self.words(), me, first);
        taken.inspect(|&taken| self.read(taken, out)).is_some()
    }

    fn put(&self, me: u32, pair: NodePair) -> Result<(), Full> {
        self.workers.deque(me).push(&self.words(), &[pair])
    }
}
