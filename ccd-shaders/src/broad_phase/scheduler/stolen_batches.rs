//! Batches of pairs that a worker pops, steals and pushes; see `stealing`.
//!
//! Words of workgroup memory tell all threads which batch was taken. A barrier of buffers stands
//! between any two of these functions, in the order in which a turn calls them.

use super::shared::{FROM_STACK, FROM_TASKS, Stack, TOP};
use super::worker::{ENDS, PairTree, STOPS, WORKS, Worker};
use crate::workgroup::{DeviceWords, add, get, load, lower_shared, set};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::broad_phase::pair_workers::{deques, idle, stolen};
use ccd_core::backend::scheduling::stealing::{HANDS, Workers};

/// Words that the threads of a worker share about batches: how many pairs of one were taken, from
/// where, whose deque, which slot; the first hand that holds something; where a batch is pushed to;
/// how often it has looked for work since it had some.
pub(super) const N_TAKEN: u32 = 0;
pub(super) const SOURCE: u32 = 1;
pub(super) const OWNER: u32 = 2;
pub(super) const SLOT: u32 = 3;
pub(super) const HAND: u32 = 4;
pub(super) const TO_PUSH: u32 = 5;
pub(super) const FRUITLESS: u32 = 6;
/// Three words that the worker counts, as [`stolen`] has them.
pub(super) const COUNTED: u32 = 8;
pub(super) const POPPED: u32 = COUNTED;
pub(super) const STOLEN: u32 = COUNTED + 1;
pub(super) const FULL: u32 = COUNTED + 2;
pub(super) type Batch = [u32; 11];

/// No slot.
pub(super) const NO_SLOT: u32 = u32::MAX;
/// A state of a worker, besides those of `workers`: it looks at other workers.
pub(super) const SEEKS: u32 = STOPS + 1;

/// The first thread notes which batch was taken; `source`: [`POPPED`] or [`STOLEN`].
#[inline(always)]
fn note(
    batch: &mut Batch,
    workers: Workers,
    words: &DeviceWords,
    source: u32,
    owner: u32,
    slot: u32,
) {
    set(batch, SOURCE, source);
    set(batch, OWNER, owner);
    set(batch, SLOT, slot);
    set(batch, N_TAKEN, workers.deque(owner).items(words, slot));
    set(batch, source, get(batch, source) + 1);
}

impl<T: PairTree> Worker<'_, T> {
    /// The deques of all workers, behind all counters.
    #[inline(always)]
    pub(super) fn deques(&mut self) -> DeviceWords<'_> {
        let first = deques(self.workers.n);
        DeviceWords::behind(self.control, first)
    }

    /// The first thread takes a batch from the worker's own deque; whether it could.
    #[inline(always)]
    pub(super) fn pop(&mut self, batch: &mut Batch) -> u32 {
        let (me, workers) = (self.me, self.workers);
        let words = &self.deques();
        let mut any = 0;
        if let Some(slot) = workers.deque(me).try_pop(words) {
            note(batch, workers, words, POPPED, me, slot);
            any = 1;
        }
        any
    }

    /// The first thread takes the next batch of a hand that holds one.
    #[inline(always)]
    pub(super) fn take_from_hand(&mut self, batch: &mut Batch) {
        let (me, workers) = (self.me, self.workers);
        let words = &self.deques();
        let hand = get(batch, HAND);
        if hand < HANDS {
            if workers.holds(words, me, hand) {
                let owner = workers.victim(words, me, hand);
                let slot = workers.next_slot(words, me, hand);
                note(batch, workers, words, STOLEN, owner, slot);
            }
        }
    }

    /// The first thread decides what its worker does in this turn.
    #[inline(always)]
    pub(super) fn look(&mut self, turn: u32, batch: &mut Batch) -> u32 {
        let (me, workers) = (self.me, self.workers);
        let mut next = self.plan(turn);
        set(batch, N_TAKEN, 0);
        set(batch, SOURCE, 0);
        set(batch, HAND, HANDS);
        set(batch, TO_PUSH, NO_SLOT);
        let busy = self.get(FROM_STACK) + self.get(FROM_TASKS);
        if busy + self.args.batch <= T::WIDTH {
            if self.pop(batch) != 0 {
                next = WORKS;
            }
        }
        if next == ENDS {
            let fruitless = get(batch, FRUITLESS);
            // A round without tasks has no work; if all are idle, nobody makes any.
            let patience = if self.tasks == 0 { 0 } else { self.args.patience };
            let n_idle = load(self.control, idle(self.round));
            if !workers.retires(&self.deques(), me, fruitless, patience, n_idle) {
                next = SEEKS;
                set(batch, FRUITLESS, fruitless + 1);
                if fruitless == 0 {
                    add(self.control, idle(self.round), 1);
                }
            }
        } else {
            self.found_work(batch);
        }
        next
    }

    /// The first thread, when the worker has work: it is idle no more.
    #[inline(always)]
    pub(super) fn found_work(&mut self, batch: &mut Batch) {
        if get(batch, FRUITLESS) > 0 {
            set(batch, FRUITLESS, 0);
            add(self.control, idle(self.round), u32::MAX);
        }
    }

    /// Finds the first hand that holds something, a thread a hand.
    #[inline(always)]
    pub(super) fn look_at_hands(&mut self, batch: &mut Batch) {
        let (me, lane, workers) = (self.me, self.lane, self.workers);
        if lane < HANDS {
            if workers.holds(&self.deques(), me, lane) {
                lower_shared(batch, HAND, lane);
            }
        }
    }

    /// Where no hand holds anything: a thread steals a range of one other worker's deque; of tasks,
    /// it only looks whether there are some.
    #[inline(always)]
    pub(super) fn reach_out(&mut self, batch: &mut Batch, victim: u32) {
        let (me, lane, most, workers) = (self.me, self.lane, self.args.most, self.workers);
        if workers.reach_out(&self.deques(), me, lane, victim, most) {
            lower_shared(batch, HAND, lane);
        }
    }

    /// The first thread, when the stack has many pairs: a slot for a batch of its bottom.
    #[inline(always)]
    pub(super) fn reserve_slot(&mut self, batch: &mut Batch) {
        if self.get(TOP) >= self.args.push {
            let (me, workers) = (self.me, self.workers);
            match workers.deque(me).reserve(&self.deques()) {
                Some(slot) => set(batch, TO_PUSH, slot),
                None => set(batch, FULL, get(batch, FULL) + 1),
            }
        }
    }

    /// A thread copies a pair of the stack's bottom to the slot and puts one of its top there.
    #[inline(always)]
    pub(super) fn copy_batch(&mut self, batch: &Batch, stack: &mut Stack) {
        let (me, lane, workers) = (self.me, self.lane, self.workers);
        let slot = get(batch, TO_PUSH);
        let (to, from) = (2 * lane, 2 * (self.get(TOP) - self.args.batch + lane));
        let pair = [get(stack, to), get(stack, to + 1)];
        workers.deque(me).write(&self.deques(), slot, lane, pair);
        set(stack, to, get(stack, from));
        set(stack, to + 1, get(stack, from + 1));
    }

    /// Pair `i` of the batch that was taken.
    #[inline(always)]
    pub(super) fn read_batch(&mut self, i: u32, batch: &Batch) -> NodePair {
        let deque = self.workers.deque(get(batch, OWNER));
        deque.read(&self.deques(), get(batch, SLOT), i)
    }

    /// The first thread gives the batch back, which all have read.
    #[inline(always)]
    pub(super) fn give_back(&mut self, batch: &Batch) {
        if get(batch, SOURCE) == STOLEN {
            let deque = self.workers.deque(get(batch, OWNER));
            deque.give_back(&self.deques(), 1);
        }
    }

    /// The first thread adds what its worker counted to the sums of all.
    #[inline(always)]
    pub(super) fn count_batches(&mut self, batch: &Batch) {
        let first = stolen(self.workers.n);
        for i in 0..3 {
            add(self.control, first + i as usize, get(batch, COUNTED + i));
        }
    }
}
