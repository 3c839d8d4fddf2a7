//! Meet: one bounded first-in-first-out queue that all workers share, lock-free: the dynamic task
//! queue of [Cederman 2009], as two rings of indices [Nikolaev 2019].
//!
//! ```text
//!   free    . . [ 5 2 7 ] . .           indices of cells that hold nothing
//!   ready   . [ 0 6 1 3 ] .             those of cells with an item, in the order of pushes
//!                 ^head   ^tail
//!   cells   | item 0 | item 1 | ..      two words each
//!
//!   push: take an index from `free`, write its cell, put the index to `ready`
//!   pop:  take an index from `ready`, read its cell, put the index to `free`
//! ```
//!
//! **An index is held by one worker, or in one ring.** So whoever holds it may write or read the
//! cell by plain accesses, and a ring of as many entries as there are indices is never overrun.
//!
//! **A ring.** Head and tail count takes and puts. An entry is one word: the index, and above it
//! the lap, which is what the counter had above the same bits. A put replaces the entry of the lap
//! before, then moves the tail; whoever finds the entry written and the tail behind it moves the
//! tail too. A take moves the head past an entry of this lap; an entry of the lap before says that
//! the ring is empty.
//!
//! **Lock-free.** An exchange fails only if another worker's succeeded, so that some worker always
//! makes progress, and a worker that is stopped anywhere withholds no more than the cell it holds.
//! The loops have no other bound. Counters wrap after 2^32 puts: a worker must not sleep through
//! exactly so many of one search.
//!
//! **Order.** A take acquires the entry that a put released: so cells are read after they were
//! written. Counters are acquired as well: whoever knows a tail knows all entries before it, so
//! that a worker which finds the queue empty after its last push knows that somebody took it.

use super::deque::{Full, Item};
use crate::kernel::Words;

/// A queue: where it stands among words, and its size.
#[derive(Clone, Copy, Debug)]
pub struct Queue {
    /// Its first word.
    pub base: usize,
    /// Capacity in items: a power of two, at most 2^16.
    pub capacity: u32,
}

/// Words by their use; a line of memory each, because all workers write them.
const HEAD: usize = 0;
const TAIL: usize = 16;
const ENTRIES: usize = 32;

impl Queue {
    /// Words that a queue for so many items takes.
    pub const fn words(capacity: u32) -> usize {
        2 * (ENTRIES + capacity as usize) + 2 * capacity as usize
    }

    /// Makes it empty; while nobody else uses it.
    pub fn clear(self, words: &impl Words) {
        self.free().fill(words, 0);
        self.ready().fill(words, self.capacity);
    }

    /// Appends an item.
    ///
    /// # Errors
    /// [`Full`]: every cell holds an item, or is being written or read.
    pub fn push(self, words: &impl Words, item: Item) -> Result<(), Full> {
        let index = self.free().take(words).ok_or(Full)?;
        let cell = self.cell(index);
        words.store(cell, item[0]);
        words.store(cell + 1, item[1]);
        self.ready().put(words, index);
        Ok(())
    }

    /// Takes the item that has been there longest; `None`: there is none.
    pub fn pop(self, words: &impl Words) -> Option<Item> {
        let index = self.ready().take(words)?;
        let cell = self.cell(index);
        let item = [words.load(cell), words.load(cell + 1)];
        self.free().put(words, index);
        Some(item)
    }

    fn free(self) -> Ring {
        Ring { base: self.base, n: self.capacity }
    }

    fn ready(self) -> Ring {
        Ring { base: self.base + ENTRIES + self.capacity as usize, n: self.capacity }
    }

    fn cell(self, index: u32) -> usize {
        self.base + 2 * (ENTRIES + self.capacity as usize) + 2 * index as usize
    }
}

/// A ring of indices below `n`, each of which is in it at most once.
#[derive(Clone, Copy)]
struct Ring {
    base: usize,
    n: u32,
}

impl Ring {
    /// All indices are in it if `head` is 0, none if it is `n`; the tail is at `n`.
    fn fill(self, words: &impl Words, head: u32) {
        (0..self.n).for_each(|i| words.store(self.entry(i), i));
        words.store(self.base + HEAD, head);
        words.store(self.base + TAIL, self.n);
    }

    /// Where the entry of a count stands.
    fn entry(self, count: u32) -> usize {
        self.base + ENTRIES + (count & (self.n - 1)) as usize
    }

    /// The lap of a count or an entry.
    fn lap(self, count: u32) -> u32 {
        count & !(self.n - 1)
    }

    fn put(self, words: &impl Words, index: u32) {
        let mut tail = words.load_acquire(self.base + TAIL);
        loop {
            let (at, next) = (self.entry(tail), tail.wrapping_add(1));
            let entry = words.load_acquire(at);
            if self.lap(entry) == self.lap(tail) {
                let moved = words.compare_exchange(self.base + TAIL, tail, next) == tail;
                tail = if moved { next } else { words.load_acquire(self.base + TAIL) };
            } else if self.lap(entry) != self.lap(tail.wrapping_sub(self.n)) {
                // Of a later lap: the tail is there by now.
                tail = words.load_acquire(self.base + TAIL);
            } else if words.compare_exchange(at, entry, self.lap(tail) | index) == entry {
                words.compare_exchange(self.base + TAIL, tail, next);
                return;
            }
            // Else another's put came first, which the next round acquires and helps.
        }
    }

    fn take(self, words: &impl Words) -> Option<u32> {
        let mut head = words.load_acquire(self.base + HEAD);
        loop {
            let entry = words.load_acquire(self.entry(head));
            if self.lap(entry) == self.lap(head.wrapping_sub(self.n)) {
                return None;
            }
            if self.lap(entry) == self.lap(head) {
                let next = head.wrapping_add(1);
                if words.compare_exchange(self.base + HEAD, head, next) == head {
                    return Some(entry & (self.n - 1));
                }
            }
            head = words.load_acquire(self.base + HEAD);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::test_words::Atomics;
    use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
    use std::vec::Vec;

    fn queue(capacity: u32) -> (Queue, Atomics) {
        let words = Atomics::new(3 + Queue::words(capacity), 0xdead_beef);
        let queue = Queue { base: 3, capacity };
        queue.clear(&words);
        (queue, words)
    }

    #[test]
    fn the_first_comes_first_lap_after_lap() {
        let (queue, words) = queue(4);
        assert_eq!(queue.pop(&words), None);
        for k in 0..1000 {
            for i in 0..4 {
                assert_eq!(queue.push(&words, [k, i]), Ok(()), "{k}, {i}");
            }
            assert_eq!(queue.push(&words, [9, 9]), Err(Full));
            for i in 0..4 {
                assert_eq!(queue.pop(&words), Some([k, i]));
            }
            assert_eq!(queue.pop(&words), None);
        }
        queue.push(&words, [1, 1]).unwrap();
        queue.clear(&words);
        assert_eq!(queue.pop(&words), None);
    }

    #[test]
    fn threads_lose_and_double_nothing() {
        const N: u32 = 20_000;
        for capacity in [1, 2, 64] {
            let (queue, words) = queue(capacity);
            let times: Vec<AtomicU32> = (0..4 * N).map(|_| AtomicU32::new(0)).collect();
            let count = |[a, b]: Item| {
                assert_eq!(a, !b, "half of an item");
                times[a as usize].fetch_add(1, Relaxed);
            };
            std::thread::scope(|scope| {
                for thread in 0..4 {
                    let (words, count) = (&words, &count);
                    scope.spawn(move || {
                        for item in (thread * N..(thread + 1) * N).map(|k| [k, !k]) {
                            if queue.push(words, item).is_err() {
                                count(item);
                            }
                            queue.pop(words).into_iter().for_each(count);
                        }
                        std::iter::from_fn(|| queue.pop(words)).for_each(count);
                    });
                }
            });
            assert!(times.iter().all(|n| n.load(Relaxed) == 1), "capacity {capacity}");
        }
    }
}
