//! Task stealing: every worker has a deque; its owner pushes and pops pairs at one end, and whose
//! own is empty takes one from the other end of another's [Arora 1998], algorithms 3.5 and 3.6 of
//! [da Silva 2013].
//!
//! The deque is [`ccd_core::backend::scheduling`], whose ends stand in one word, so that no pair is
//! taken twice; a model checker goes through it (docs/SCHEDULING.md). A pair that does not fit
//! stays with its worker, where nobody else sees it. No worker waits for another: after some
//! rounds without success it retires, and whoever has work drains its own deque.
//!
//! Cost: a push and a pop a pair, each a few atomic operations on words that nobody else has in
//! hand most of the time. Choose [`super::lazy_stealing`], which moves as much with fewer.

use super::{Launch, Lists, PAIRS_OF_NODES, Schedule};
use crate::broad_phase::tree::shared_words::Shared;
use crate::stop::Stop;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::scheduling::stealing::{Taken, Workers};
use std::sync::atomic::AtomicU32;

/// Rounds over all deques without success after which a worker retires: some 100 us in all.
pub const ROUNDS: usize = 64;

/// Between two rounds: a microsecond or two. Never `yield_now`, which on a busy machine returns
/// only after all others have had their turn, some milliseconds later, while the rest waits for
/// this worker to retire.
pub fn pause() {
    for _ in 0..32 {
        std::hint::spin_loop();
    }
}

/// The deques of all workers, and a list each for what does not fit them.
#[derive(Debug)]
pub struct Stealing {
    deques: Deques,
    spilled: Lists,
    taken: Lists,
    found: Lists,
}

impl Stealing {
    /// Capacity of a deque in a session.
    pub const CAPACITY: u32 = 1 << 13;

    /// With deques of this capacity, in pairs: a power of two.
    pub fn new(capacity: u32) -> Self {
        let (spilled, taken, found) = Default::default();
        Self { deques: Deques::new(capacity, 1), spilled, taken, found }
    }
}

impl Schedule for Stealing {
    fn run(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, stop: &Stop, launch: Launch) {
        let Self { deques, spilled, taken, found } = self;
        for lists in [&mut *spilled, taken, found] {
            lists.prepare(n_workers);
        }
        deques.deal(n_workers, tasks, spilled);
        let (deques, spilled, taken, found) = (&*deques, &*spilled, &*taken, &*found);
        let (workers, words) = (deques.workers, deques.words());
        let rounds = if n_workers == 1 { 1 } else { ROUNDS };
        launch(&|hand| {
            let me = hand.worker;
            let (mut spilled, mut pairs, mut found) = (spilled.of(me), taken.of(me), found.of(me));
            let (me, mut fruitless) = (me as u32, 0);
            while fruitless < rounds {
                pairs.clear();
                if let Some(taken) = workers.pop(&words, me) {
                    deques.read(taken, &mut pairs);
                } else if let Some(pair) = spilled.pop() {
                    pairs.push(pair);
                } else if let Some(taken) =
                    workers.steal_task(&words, me, me + 1 + fruitless as u32)
                {
                    deques.read(taken, &mut pairs);
                } else {
                    fruitless += 1;
                    pause();
                    continue;
                }
                fruitless = 0;
                (hand.expand)(&pairs, &mut found);
                for pair in found.drain(..) {
                    if workers.deque(me).push(&words, &[pair]).is_err()
                        && stop.reserve(PAIRS_OF_NODES, &mut spilled, 1)
                    {
                        spilled.push(pair);
                    }
                }
            }
        });
    }
}

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

    /// Clears the deques and deals tasks out to all of them in turn, in batches; what does not
    /// fit goes to a list of the same worker.
    pub fn deal(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, spilled: &Lists) {
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

    /// Appends the pairs of a batch that was taken.
    pub fn read(&self, taken: Taken, out: &mut Vec<NodePair>) {
        let (deque, words) = (self.workers.deque(taken.owner), self.words());
        let n = deque.items(&words, taken.slot);
        out.extend((0..n).map(|i| deque.read(&words, taken.slot, i)));
        self.workers.done(&words, taken);
    }
}
