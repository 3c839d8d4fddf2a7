//! Task pools: a worker takes one pair from where workers put pairs for each other, expands it, and
//! puts what it found there; the worker's loop of [`super::stealing`] and [`super::shared_queue`]
//! [Cederman 2009].
//!
//! A pair that does not fit stays with its worker, where nobody else sees it. After some rounds
//! without success a worker retires, and whoever has work goes on: nobody waits for another to find
//! pairs.

use super::{Launch, Lists, PAIRS_OF_NODES, Schedule};
use crate::stop::Stop;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::scheduling::deque::Full;
use std::fmt::Debug;

/// Rounds over all of a pool without success after which a worker retires: some 100 us in all.
pub const ROUNDS: usize = 64;

/// Between two rounds: a microsecond or two. Never `yield_now`, which on a busy machine returns
/// only after all others have had their turn, some milliseconds later, while the rest waits for
/// this worker to retire.
pub fn pause() {
    for _ in 0..32 {
        std::hint::spin_loop();
    }
}

/// Where workers put pairs for each other. A worker that puts a pair finds that pair again, unless
/// another has taken it.
pub trait TaskPool: Debug + Send + Sync {
    /// Makes the pool empty and deals tasks out to it; what does not fit goes to the list of a
    /// worker.
    fn deal(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, spilled: &Lists);

    /// Appends the pair that is the next of worker `me`; whether there is one.
    fn take(&self, me: u32, out: &mut Vec<NodePair>) -> bool;

    /// Appends a pair of another worker, `first` or one after it; whether there is one. None where
    /// all workers share everything.
    fn steal(&self, _me: u32, _first: u32, _out: &mut Vec<NodePair>) -> bool {
        false
    }

    /// Puts a pair there, by worker `me`.
    ///
    /// # Errors
    /// [`Full`]: the pair stays with the worker.
    fn put(&self, me: u32, pair: NodePair) -> Result<(), Full>;
}

/// The scheduler of a pool, and a list a worker for what does not fit it.
#[derive(Debug)]
pub struct Pooled<P> {
    pool: P,
    spilled: Lists,
    taken: Lists,
    found: Lists,
}

impl<P> Pooled<P> {
    /// With this pool.
    pub fn new(pool: P) -> Self {
        let (spilled, taken, found) = Default::default();
        Self { pool, spilled, taken, found }
    }
}

impl<P: TaskPool> Schedule for Pooled<P> {
    fn run(&mut self, n_workers: usize, tasks: &mut Vec<NodePair>, stop: &Stop, launch: Launch) {
        let Self { pool, spilled, taken, found } = self;
        for lists in [&mut *spilled, taken, found] {
            lists.prepare(n_workers);
        }
        pool.deal(n_workers, tasks, spilled);
        let (pool, spilled, taken, found) = (&*pool, &*spilled, &*taken, &*found);
        let rounds = if n_workers == 1 { 1 } else { ROUNDS };
        launch(&|hand| {
            let me = hand.worker;
            let (mut spilled, mut pairs, mut found) = (spilled.of(me), taken.of(me), found.of(me));
            let (me, mut fruitless) = (me as u32, 0);
            while fruitless < rounds {
                pairs.clear();
                if !pool.take(me, &mut pairs) {
                    if let Some(pair) = spilled.pop() {
                        pairs.push(pair);
                    } else if !pool.steal(me, me + 1 + fruitless as u32, &mut pairs) {
                        fruitless += 1;
                        pause();
                        continue;
                    }
                }
                fruitless = 0;
                (hand.expand)(&pairs, &mut found);
                for pair in found.drain(..) {
                    if pool.put(me, pair).is_err() && stop.reserve(PAIRS_OF_NODES, &mut spilled, 1)
                    {
                        spilled.push(pair);
                    }
                }
            }
        });
    }
}
