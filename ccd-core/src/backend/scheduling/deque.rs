//! Meet: a bounded deque of batches, whose two ends stand in one atomic word: its owner pushes and
//! pops at the bottom, thieves take from the top, and every take is a compare-and-exchange of that
//! word [da Silva 2013], algorithms 3.6 and 3.13, made sound.
//!
//! ```text
//!                  word ENDS:  | bottom, 16 bits | top, 16 bits |
//!
//!   slots, a ring:   . . . [ r r s s x x x x x . . . ]        r  read again: free
//!                            ^   ^   ^         ^              s  stolen, not read yet
//!                    reclaimed   |   top       bottom         x  there to be taken
//!                                returned: a count of r, which thieves add to
//! ```
//!
//! **The word says all.** `top` and `bottom` count batches, modulo 2^16; the slots from `top` up to
//! `bottom` hold what nobody has taken, whatever happened before. Whoever takes exchanges the word
//! first and reads the slots afterwards: what it takes depends on the word alone, and on nothing
//! that was read before. So a thief that was delayed for any time between its load and its
//! exchange either fails, or finds the same word again and takes what that word says *now*. Counts
//! that wrap around, or a word that returns to an old value (a pop and a push do that), do no harm:
//! there is nothing that a tag would have to tell apart. But both ends must stand in one word: with
//! two, as printed, an owner and a thief can both take the last batch (docs/SCHEDULING.md).
//!
//! **A slot is overwritten only when it has been read.** A batch that was popped is read by the
//! owner itself before it pushes again. A stolen range belongs to its thief until the thief has
//! read it, at once or much later, and has counted it in `RETURNED`. Only if that count, loaded
//! first, is equal to `top`, loaded after it, has every range below that `top` been read: then the
//! owner moves `reclaimed` there, and slots from `reclaimed` on up to the ring's size may be
//! written. Both counts are modulo 2^16; at most 2^15 batches are in the ring, so that a difference
//! of zero means none.
//!
//! **Order.** Slots are written and read by relaxed operations. A push releases them by an addition
//! to the word, all other changes of which are exchanges: a thief that succeeds acquires from that
//! addition, or from exchanges that follow it without a gap. A thief releases its reads by the
//! addition to `RETURNED`, which the owner acquires. Nothing needs sequential consistency.
//!
//! **Bounds.** A push takes one attempt. An owner's exchange fails only if a thief took something,
//! so that a pop takes at most as many attempts as there are batches. A thief tries once. Nobody
//! waits. The capacity is fixed; a push beyond it is refused with [`Full`],
//! also while thieves still read slots that it would overwrite, and its caller keeps the items.

use crate::kernel::Words;

/// What a deque holds: two words, a pair of nodes.
pub type Item = [u32; 2];

/// The deque is full: the items stay with the caller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Full;

/// What a thief's attempt came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steal {
    /// There was nothing.
    Empty,
    /// Somebody else took or pushed at the same time.
    Lost,
    /// These batches are the thief's.
    Stolen(Range),
}

/// Batches that follow each other in a deque, at the most 2^15.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// Where the first stands, modulo 2^16.
    pub first: u32,
    /// How many.
    pub n: u32,
}

impl Range {
    /// In one word, which is 0 for an empty range.
    #[inline(always)]
    pub fn packed(self) -> u32 {
        if self.n == 0 { 0 } else { self.n << BITS | self.first }
    }

    /// Without its first batch; of a range that is not empty.
    #[inline(always)]
    pub fn rest(self) -> Self {
        Self { first: self.first.wrapping_add(1) & MASK, n: self.n - 1 }
    }

    /// From that word.
    #[inline(always)]
    pub fn unpacked(word: u32) -> Self {
        Self { first: word & MASK, n: word >> BITS }
    }
}

/// A deque: where it stands among words, and its size.
#[derive(Clone, Copy, Debug)]
pub struct Deque {
    /// Its first word.
    pub base: usize,
    /// Capacity in batches: a power of two, at most 2^15, half of what 16 bits count.
    pub batches: u32,
    /// Most items of a batch.
    pub batch: u32,
}

const BITS: u32 = 16;
const MASK: u32 = (1 << BITS) - 1;
/// One batch more at the bottom; what overflows leaves the word.
const BOTTOM: u32 = 1 << BITS;
/// Words by their use; a line of memory each, because different workers write them.
const ENDS: usize = 0;
const RETURNED: usize = 16;
const RECLAIMED: usize = 32;
const SLOTS: usize = 48;

#[inline(always)]
fn length(ends: u32) -> u32 {
    (ends >> BITS).wrapping_sub(ends) & MASK
}

impl Deque {
    /// Words that a deque of so many batches of so many items takes.
    pub const fn words(batches: u32, batch: u32) -> usize {
        SLOTS + batches as usize * (1 + 2 * batch as usize)
    }

    /// Makes it empty; while nobody else uses it.
    #[inline(always)]
    pub fn clear(self, words: &impl Words) {
        words.store(self.base + ENDS, 0);
        words.store(self.base + RETURNED, 0);
        words.store(self.base + RECLAIMED, 0);
    }

    /// Batches that are there, which others may change at once.
    #[inline(always)]
    pub fn len(self, words: &impl Words) -> u32 {
        length(words.load(self.base + ENDS))
    }

    /// Whether nothing is there: if the owner asks, it stays so until its next push.
    #[inline(always)]
    pub fn is_empty(self, words: &impl Words) -> bool {
        self.len(words) == 0
    }

    /// The owner pushes a batch of at most [`Deque::batch`] items.
    ///
    /// # Errors
    /// [`Full`]: there is no room for it.
    #[inline(always)]
    pub fn push(self, words: &impl Words, items: &[Item]) -> Result<(), Full> {
        debug_assert!(items.len() <= self.batch as usize);
        let slot = self.reserve(words).ok_or(Full)?;
        for i in 0..items.len() {
            self.write(words, slot, i as u32, items[i]);
        }
        self.publish(words, slot, items.len() as u32);
        Ok(())
    }

    /// First third of a push, for owners of several threads: the slot that the owner may write. If
    /// none is certainly free, `None`: full.
    #[inline(always)]
    pub fn reserve(self, words: &impl Words) -> Option<u32> {
        // The owner alone moves the bottom.
        let bottom = words.load(self.base + ENDS) >> BITS;
        let mut used = bottom.wrapping_sub(words.load(self.base + RECLAIMED)) & MASK;
        if used > self.batches / 2 {
            let returned = words.load_acquire(self.base + RETURNED);
            // Later than that count, so that no steal that it counts is missing.
            let top = words.load(self.base + ENDS) & MASK;
            if returned & MASK == top {
                words.store(self.base + RECLAIMED, top);
                used = bottom.wrapping_sub(top) & MASK;
            }
        }
        if used < self.batches { Some(bottom & (self.batches - 1)) } else { None }
    }

    /// Second third: item `i` of a batch.
    #[inline(always)]
    pub fn write(self, words: &impl Words, slot: u32, i: u32, item: Item) {
        let at = self.slot(slot) + 1 + 2 * i as usize;
        words.store(at, item[0]);
        words.store(at + 1, item[1]);
    }

    /// Last third: `n` items of the slot that was reserved are there to be taken.
    #[inline(always)]
    pub fn publish(self, words: &impl Words, slot: u32, n: u32) {
        words.store(self.slot(slot), n);
        words.add_acquire_release(self.base + ENDS, BOTTOM);
    }

    /// The owner takes the batch at the bottom: its slot, which it must have read before it pushes
    /// again.
    #[inline(always)]
    pub fn pop(self, words: &impl Words) -> Option<u32> {
        let mut ends = words.load(self.base + ENDS);
        // An attempt fails only if a thief took a batch.
        for _ in 0..=self.batches {
            match self.exchange_bottom(words, ends) {
                Ok(slot) => return slot,
                Err(seen) => ends = seen,
            }
        }
        None
    }

    /// The same in one attempt: `None` also if a thief took a batch at the same time. For kernels,
    /// which may not repeat it (`DeviceWords` in ccd-shaders says why).
    #[inline(always)]
    pub fn try_pop(self, words: &impl Words) -> Option<u32> {
        self.exchange_bottom(words, words.load(self.base + ENDS)).unwrap_or(None)
    }

    /// One attempt: the slot, if there is a batch, or what stood there instead of `ends`.
    #[inline(always)]
    fn exchange_bottom(self, words: &impl Words, ends: u32) -> Result<Option<u32>, u32> {
        if length(ends) == 0 {
            return Ok(None);
        }
        let popped = ends.wrapping_sub(BOTTOM);
        let seen = words.compare_exchange(self.base + ENDS, ends, popped);
        if seen == ends { Ok(Some(popped >> BITS & (self.batches - 1))) } else { Err(seen) }
    }

    /// A thief takes up to `most` batches from the top, in one attempt. They are its own: it reads
    /// them by [`Deque::read`] whenever it likes, then says so by [`Deque::give_back`].
    #[inline(always)]
    pub fn steal(self, words: &impl Words, most: u32) -> Steal {
        let ends = words.load(self.base + ENDS);
        let n = length(ends).min(most);
        if n == 0 {
            return Steal::Empty;
        }
        let stolen = ends & !MASK | ends.wrapping_add(n) & MASK;
        if words.compare_exchange(self.base + ENDS, ends, stolen) != ends {
            return Steal::Lost;
        }
        Steal::Stolen(Range { first: ends & MASK, n })
    }

    /// The slot of batch `i` of a range that was stolen.
    #[inline(always)]
    pub fn slot_of(self, range: Range, i: u32) -> u32 {
        range.first.wrapping_add(i) & (self.batches - 1)
    }

    /// Items of a batch that was taken.
    #[inline(always)]
    pub fn items(self, words: &impl Words, slot: u32) -> u32 {
        words.load(self.slot(slot)).min(self.batch)
    }

    /// Item `i` of a batch that was taken.
    #[inline(always)]
    pub fn read(self, words: &impl Words, slot: u32, i: u32) -> Item {
        let at = self.slot(slot) + 1 + 2 * i as usize;
        [words.load(at), words.load(at + 1)]
    }

    /// A thief has read `n` of the batches that it stole; never more often than once each.
    #[inline(always)]
    pub fn give_back(self, words: &impl Words, n: u32) {
        words.add_acquire_release(self.base + RETURNED, n);
    }

    #[inline(always)]
    fn slot(self, slot: u32) -> usize {
        self.base + SLOTS + slot as usize * (1 + 2 * self.batch as usize)
    }
}
