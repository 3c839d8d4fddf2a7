//! Meet: the deques of all workers. Task stealing takes one batch at a time [Arora 1998]; lazy work
//! stealing takes a range from every other deque at once and transfers batch by batch what it has
//! got [da Silva 2013], algorithms 3.9 to 3.12, made sound.
//!
//! ```text
//!   level   from                     task stealing       lazy work stealing
//!     1     the worker's own stack   take                take
//!     2     its own deque            pop                 pop
//!     3     ranges it has stolen                         next_stolen: one batch
//!     4     the others' deques       steal_task: one     steal_all: a range of each, then 3
//! ```
//!
//! The stack is the caller's, and nobody else sees it: it takes batches from it as long as it can,
//! and from a threshold on it pushes one to its deque, for others to find. If the deque is full,
//! the batch stays on the stack.
//!
//! **Nothing is lost.** An item is at any time on the stack of one worker, or in one deque, or in a
//! range that one worker has stolen and not read. A worker retires only when its stack is empty and
//! it found its deque and its ranges empty; nobody else pushes to that deque, so that it stays
//! empty. When all have retired, there is nothing left. No worker waits for another: it looks at
//! the others' deques a bounded number of times, then retires; whoever has work goes on, alone if
//! it must be, and drains its own deque. So no assumption is made about which workers make
//! progress at the same time.
//!
//! Cost: task stealing is one exchange for every batch that moves, and workers without work look
//! around more often; lazy stealing takes more at a time, which others then cannot steal again from
//! it. Ranges are held by their thief alone, so keep them short where a batch means much work.

use super::deque::{Deque, Range, Steal};
use crate::kernel::Words;

/// Ranges that a worker holds at once, each from another worker, at most.
pub const HANDS: u32 = 32;

/// The deques of a number of workers and the ranges that each has stolen, in one array of words.
#[derive(Clone, Copy, Debug)]
pub struct Workers {
    /// How many there are.
    pub n: u32,
    /// Capacity of each deque in batches, as in [`Deque::batches`].
    pub batches: u32,
    /// Most items of a batch.
    pub batch: u32,
}

/// A batch that a worker has taken: it reads its items, then says so ([`Workers::done`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Taken {
    /// Whose deque it stands in.
    pub owner: u32,
    /// Its slot there.
    pub slot: u32,
    /// Whether it was stolen.
    pub stolen: bool,
}

impl Workers {
    /// Words that they take.
    pub const fn words(self) -> usize {
        self.n as usize * (Deque::words(self.batches, self.batch) + 2 * HANDS as usize)
    }

    /// Makes all deques empty; before the workers start.
    pub fn clear(self, words: &impl Words) {
        for worker in 0..self.n {
            self.deque(worker).clear(words);
            for hand in 0..HANDS {
                words.store(self.hand(worker, hand) + 1, 0);
            }
        }
    }

    /// The deque of a worker.
    #[inline(always)]
    pub fn deque(self, worker: u32) -> Deque {
        let base = worker as usize * Deque::words(self.batches, self.batch);
        Deque { base, batches: self.batches, batch: self.batch }
    }

    /// Level 2: the worker pops from its own deque.
    #[inline(always)]
    pub fn pop(self, words: &impl Words, me: u32) -> Option<Taken> {
        let slot = self.deque(me).pop(words)?;
        Some(Taken { owner: me, slot, stolen: false })
    }

    /// Level 4 of task stealing: looks at all other deques once, from that of `first` on, and
    /// steals one batch.
    #[inline(always)]
    pub fn steal_task(self, words: &impl Words, me: u32, first: u32) -> Option<Taken> {
        for k in 0..self.n {
            let victim = (first % self.n + k) % self.n;
            if victim != me
                && let Steal::Stolen(range) = self.deque(victim).steal(words, 1)
            {
                let slot = self.deque(victim).slot_of(range, 0);
                return Some(Taken { owner: victim, slot, stolen: true });
            }
        }
        None
    }

    /// Level 3: the next batch of the ranges that the worker has stolen.
    #[inline(always)]
    pub fn next_stolen(self, words: &impl Words, me: u32) -> Option<Taken> {
        for hand in 0..HANDS {
            if let Some(taken) = self.next_in_hand(words, me, hand) {
                return Some(taken);
            }
        }
        None
    }

    /// Whether the worker holds a range in this hand.
    #[inline(always)]
    pub fn holds(self, words: &impl Words, me: u32, hand: u32) -> bool {
        words.load(self.hand(me, hand) + 1) != 0
    }

    /// The next batch of one of these ranges.
    #[inline(always)]
    pub fn next_in_hand(self, words: &impl Words, me: u32, hand: u32) -> Option<Taken> {
        if !self.holds(words, me, hand) {
            return None;
        }
        let owner = self.victim(words, me, hand);
        Some(Taken { owner, slot: self.next_slot(words, me, hand), stolen: true })
    }

    /// From whom the range in this hand is.
    #[inline(always)]
    pub fn victim(self, words: &impl Words, me: u32, hand: u32) -> u32 {
        words.load(self.hand(me, hand))
    }

    /// The slot of the first batch of the range in this hand, which is not empty; the range is
    /// without it afterwards.
    #[inline(always)]
    pub fn next_slot(self, words: &impl Words, me: u32, hand: u32) -> u32 {
        let at = self.hand(me, hand) + 1;
        let range = Range::unpacked(words.load(at));
        words.store(at, range.rest().packed());
        self.deque(me).slot_of(range, 0)
    }

    /// Level 4 of lazy stealing: steals up to `most` batches from every other deque, an attempt
    /// each, of [`HANDS`] workers at most, the first after it; whether it got any. Only when
    /// [`Workers::next_stolen`] finds nothing.
    #[inline(always)]
    pub fn steal_all(self, words: &impl Words, me: u32, most: u32) -> bool {
        let mut any = false;
        for hand in 0..HANDS.min(self.n - 1) {
            any |= self.steal_to_hand(words, me, hand, (me + 1 + hand) % self.n, most);
        }
        any
    }

    /// The same from one other, into a hand that is empty; for owners of several threads.
    #[inline(always)]
    pub fn steal_to_hand(
        self,
        words: &impl Words,
        me: u32,
        hand: u32,
        victim: u32,
        most: u32,
    ) -> bool {
        match self.deque(victim).steal(words, most) {
            Steal::Stolen(range) => {
                let at = self.hand(me, hand);
                words.store(at, victim);
                words.store(at + 1, range.packed());
                true
            }
            _ => false,
        }
    }

    /// Level 4 for owners of several threads, one a hand, when all hands are empty: the thread of
    /// `hand` steals up to `most` batches from `victim`; of tasks, with `most` 0, it only looks
    /// whether there are some. Whether there is something in its hand, or for it.
    #[inline(always)]
    pub fn reach_out(self, words: &impl Words, me: u32, hand: u32, victim: u32, most: u32) -> bool {
        let mut any = false;
        if hand < HANDS && victim != me {
            if most == 0 {
                any = !self.deque(victim).is_empty(words);
            } else {
                any = self.steal_to_hand(words, me, hand, victim, most);
            }
        }
        any
    }

    /// After that, of tasks: whether the thread of `hand` takes one. `first`: the first hand for
    /// which there was something; [`HANDS`] if nobody had anything, which is the number of a thread
    /// without a hand.
    #[inline(always)]
    pub fn takes_task(hand: u32, first: u32) -> bool {
        hand < HANDS && hand == first
    }

    /// Whether a worker that has found nothing, so many times in a row, retires; `idle` are without
    /// work. Its deque is looked at, because [`Deque::try_pop`] fails also if a thief was there.
    #[inline(always)]
    pub fn retires(
        self,
        words: &impl Words,
        me: u32,
        fruitless: u32,
        patience: u32,
        idle: u32,
    ) -> bool {
        (fruitless >= patience || idle == self.n) && self.deque(me).is_empty(words)
    }

    /// Turns in which a worker that ends empties its deque and its hands: a turn a batch, one in
    /// which a thief takes it included, and a last one that finds nothing.
    #[inline(always)]
    pub fn drain_turns(self, most: u32) -> u32 {
        self.batches + HANDS * most.max(1) + 1
    }

    /// Levels 2 and 4 of task stealing.
    #[inline(always)]
    pub fn take_task(self, words: &impl Words, me: u32, first: u32) -> Option<Taken> {
        match self.pop(words, me) {
            Some(taken) => Some(taken),
            None => self.steal_task(words, me, first),
        }
    }

    /// Levels 2, 3 and 4 of lazy stealing.
    #[inline(always)]
    pub fn take_lazily(self, words: &impl Words, me: u32, most: u32) -> Option<Taken> {
        if let Some(taken) = self.pop(words, me) {
            return Some(taken);
        }
        if let Some(taken) = self.next_stolen(words, me) {
            return Some(taken);
        }
        if self.steal_all(words, me, most) { self.next_stolen(words, me) } else { None }
    }

    /// Says that the items of a batch have been read.
    #[inline(always)]
    pub fn done(self, words: &impl Words, taken: Taken) {
        if taken.stolen {
            self.deque(taken.owner).give_back(words, 1);
        }
    }

    /// The words of a range that a worker has stolen: from whom, and which; the worker's own.
    #[inline(always)]
    fn hand(self, worker: u32, hand: u32) -> usize {
        debug_assert!(hand < HANDS);
        let deques = self.n as usize * Deque::words(self.batches, self.batch);
        deques + 2 * (worker * HANDS + hand) as usize
    }
}

#[cfg(test)]
mod tests;
