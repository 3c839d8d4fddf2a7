//! Lazy work stealing: a worker expands from a stack of its own, and pushes the oldest batch to its
//! deque when the stack holds more than a threshold; whose stack and deque are empty takes batches
//! from all other deques at once, and fetches one after the other [da Silva 2013], algorithms 3.7
//! to 3.13.
//!
//! ```text
//!   1  own stack          2  own deque        3  batches stolen before   4  all other deques
//!      [ .. # # # # ]        [ ### ### ]         b: ###  d: ### ###         up to so many of each
//!        |      ^ expands
//!        +-> above the threshold, and while the deque is empty, the oldest go there: below
//!            them there is most
//! ```
//!
//! The deques and the three levels are those of [`ccd_core::backend::scheduling`]; what was changed
//! to make them sound is said there. What does not fit a deque stays on the stack. No worker
//! waits for another, as in [`super::stealing`].
//!
//! Cost: a few atomic operations a batch rather than a pair, and none while a stack neither
//! overflows nor runs empty. Choose it where tasks differ much and processors are not one's own.

use super::stealing::Deques;
use super::task_pool::{ROUNDS, TaskPool, pause};
use super::{Launch, Lists, Schedule, drain};
use crate::stop::Stop;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::model::scheduling::WorkerOptions;

/// Pairs of a batch.
const BATCH: usize = 16;
/// Batches on a stack from which on the oldest goes to the deque. While the deque is empty, one is
/// enough, so that there is something to steal.
const THRESHOLD: usize = 4;
/// Batches that are stolen from a deque at once.
const MOST: u32 = 4;

/// The deques and the stacks of all workers.
#[derive(Debug)]
pub struct LazyStealing {
    deques: Deques,
    stacks: Lists,
    /// Pairs on a stack from which on the oldest batch goes to the deque.
    threshold: usize,
}

impl LazyStealing {
    /// Capacity of a deque in a session.
    pub const CAPACITY: u32 = 1 << 10;

    /// With deques of this capacity, in batches: a power of two.
    pub fn new(capacity: u32, options: WorkerOptions) -> Self {
        let batch = if options.batch > 0 { options.batch as usize } else { BATCH };
        let threshold = match options.threshold as usize {
            0 => THRESHOLD * batch,
            pairs => pairs.max(2 * batch),
        };
        Self { deques: Deques::new(capacity, batch as u32), stacks: Lists::default(), threshold }
    }
}

impl Schedule for LazyStealing {
    fn run(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, _stop: &Stop, launch: Launch) {
        self.stacks.prepare(n_workers);
        self.deques.deal(n_workers, tasks, &self.stacks);
        let (deques, stacks) = (&self.deques, &self.stacks);
        let (workers, words) = (deques.workers, deques.words());
        let (batch, threshold) = (workers.batch as usize, self.threshold);
        let rounds = if n_workers == 1 { 1 } else { ROUNDS };
        launch(&|hand| {
            let mut stack = stacks.of(hand.worker);
            let (me, mut fruitless) = (hand.worker as u32, 0);
            while fruitless < rounds {
                if !stack.is_empty() {
                    drain(hand, &mut stack, 1);
                    let deque = workers.deque(me);
                    while stack.len() > if deque.is_empty(&words) { batch } else { threshold }
                        && deque.push(&words, &stack[..batch]).is_ok()
                    {
                        stack.drain(..batch);
                    }
                } else if let Some(taken) = workers.take_lazily(&words, me, MOST) {
                    deques.read(taken, &mut stack);
                    fruitless = 0;
                } else {
                    fruitless += 1;
                    pause();
                }
            }
        });
    }
}
