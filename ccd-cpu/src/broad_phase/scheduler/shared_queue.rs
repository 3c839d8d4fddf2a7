//! Dynamic task queues: one queue that all workers share, behind a lock or lock-free, of which each
//! takes the first pair and to whose end each adds what it found [Cederman 2009].
//!
//! ```text
//!   worker a, b, c  <- take    [ p p p p p p . . ]    <- put    a, b, c
//! ```
//!
//! A queue has a fixed capacity. By the lock a worker waits for whoever has it, which may have lost
//! its processor; the lock-free one is [`ccd_core::backend::scheduling::queue`], where no worker
//! waits.
//!
//! Cost: every pair goes through the same few words, or the same lock, so that it grows with the
//! number of workers; work is spread as evenly as it can be. For comparison: choose
//! [`super::self_scheduling`], where the queue has tasks alone.

use super::Lists;
use super::task_pool::{Pooled, TaskPool};
use crate::broad_phase::tree::shared_words::Shared;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::scheduling::deque::Full;
use ccd_core::backend::scheduling::queue::Queue;
use std::collections::VecDeque;
use std::sync::atomic::AtomicU32;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Capacity of a queue in a session: more than the tasks at the beginning.
pub const CAPACITY: u32 = 1 << 13;

/// The scheduler by a queue behind a lock.
pub fn blocking(capacity: u32) -> Pooled<impl TaskPool> {
    Pooled::new(Locked { queue: Mutex::default(), capacity: capacity as usize })
}

/// The scheduler by a lock-free queue; the capacity is a power of two.
pub fn lock_free(capacity: u32) -> Pooled<impl TaskPool> {
    Pooled::new(LockFree { queue: Queue { base: 0, capacity }, words: Vec::new() })
}

#[derive(Debug)]
struct Locked {
    queue: Mutex<VecDeque<NodePair>>,
    capacity: usize,
}

impl Locked {
    fn queue(&self) -> MutexGuard<'_, VecDeque<NodePair>> {
        self.queue.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl TaskPool for Locked {
    fn deal(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, spilled: &Lists) {
        let mut queue = self.queue();
        queue.clear();
        queue.reserve_exact(self.capacity);
        drop(queue);
        deal(self, n_workers, tasks, spilled);
    }

    fn take(&self, _me: u32, out: &mut Vec<NodePair>) -> bool {
        let pair = self.queue().pop_front();
        out.extend(pair);
        pair.is_some()
    }

    fn put(&self, _me: u32, pair: NodePair) -> Result<(), Full> {
        let mut queue = self.queue();
        if queue.len() == self.capacity {
            return Err(Full);
        }
        queue.push_back(pair);
        Ok(())
    }
}

#[derive(Debug)]
struct LockFree {
    queue: Queue,
    words: Vec<AtomicU32>,
}

impl TaskPool for LockFree {
    fn deal(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, spilled: &Lists) {
        self.words.resize_with(Queue::words(self.queue.capacity), AtomicU32::default);
        self.queue.clear(&Shared(&self.words));
        deal(self, n_workers, tasks, spilled);
    }

    fn take(&self, _me: u32, out: &mut Vec<NodePair>) -> bool {
        let pair = self.queue.pop(&Shared(&self.words));
        out.extend(pair);
        pair.is_some()
    }

    fn put(&self, _me: u32, pair: NodePair) -> Result<(), Full> {
        self.queue.push(&Shared(&self.words), pair)
    }
}

/// Puts all tasks into a queue; what does not fit goes to the workers in turn.
fn deal(pool: &impl TaskPool, n_workers: usize, tasks: &mut Vec<NodePair>, spilled: &Lists) {
    for (k, task) in tasks.drain(..).enumerate() {
        if pool.put(0, task).is_err() {
            spilled.of(k % n_workers).push(task);
        }
    }
}
