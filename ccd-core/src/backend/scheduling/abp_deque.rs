//! Meet: the deque of task stealing as it is printed, with `bottom` in one word and `age`, which is
//! `top` with a tag, in another [Arora 1998], algorithm 3.6 of [da Silva 2013]; and the fences
//! that the print leaves out.
//!
//! ```text
//!   AGE  | tag, 18 bits | top, 14 bits |        BOTTOM  | 32 bits |
//!
//!   items   [ t t t x x x x . . . ]             t taken by thieves, x there to be taken
//!                   ^top    ^bottom             both go back to 0 when the owner finds none
//! ```
//!
//! The owner takes without an exchange as long as there is more than one item, which is the merit
//! of two words; a thief, and the owner at the last item, exchange `age`.
//!
//! **Fences.** A pop stores `bottom` and then loads `age`; a steal loads `age` and then `bottom`.
//! All threads must see one order of these, or both take the last item: a fence of sequential
//! consistency stands between the two of each. A third one stands before `age` is reset by a store:
//! whoever sees the new `age` must see `bottom` at 0.
//!
//! **The tag** counts resets, so that a thief which slept since before one fails. It must not come
//! around again while a thief sleeps: after 2^18 - 1 resets the deque refuses every push until it
//! is cleared, instead of wrapping as printed.
//!
//! A kernel has no such fence; [`super::deque`] needs none.

use super::deque::{Full, Item};
use crate::kernel::FencedWords;

/// A deque: where it stands among words, and its size.
#[derive(Clone, Copy, Debug)]
pub struct AbpDeque {
    /// Its first word.
    pub base: usize,
    /// Capacity in items, at most 2^14 - 1: what `top` counts.
    pub capacity: u32,
}

/// Words by their use; a line of memory each.
const AGE: usize = 0;
const BOTTOM: usize = 16;
const ITEMS: usize = 32;

impl AbpDeque {
    const TOP: u32 = (1 << 14) - 1;
    const TAG: u32 = !Self::TOP;

    /// Words that a deque of so many items takes.
    pub const fn words(capacity: u32) -> usize {
        ITEMS + 2 * capacity as usize
    }

    /// Makes it empty; while nobody else uses it.
    pub fn clear(self, words: &impl FencedWords) {
        words.store(self.base + AGE, 0);
        words.store(self.base + BOTTOM, 0);
    }

    /// The owner pushes an item.
    ///
    /// # Errors
    /// [`Full`]: there is no place for it at the bottom, or no tag for another reset.
    pub fn push(self, words: &impl FencedWords, item: Item) -> Result<(), Full> {
        // The owner alone changes the bottom and the tag.
        let bottom = words.load(self.base + BOTTOM);
        let tag = words.load(self.base + AGE) & Self::TAG;
        if bottom == self.capacity || tag == Self::TAG {
            return Err(Full);
        }
        let at = self.item(bottom);
        words.store(at, item[0]);
        words.store(at + 1, item[1]);
        // Releases the item.
        words.add_acquire_release(self.base + BOTTOM, 1);
        Ok(())
    }

    /// The owner takes the item that it pushed last.
    pub fn pop(self, words: &impl FencedWords) -> Option<Item> {
        let bottom = words.load(self.base + BOTTOM).checked_sub(1)?;
        // An addition, so that a thief which sees it still acquires what pushes released.
        words.add_acquire_release(self.base + BOTTOM, 1_u32.wrapping_neg());
        words.fence();
        let item = self.read(words, bottom);
        let age = words.load_acquire(self.base + AGE);
        let top = age & Self::TOP;
        if bottom > top {
            return Some(item);
        }
        words.store(self.base + BOTTOM, 0);
        let reset = (age & Self::TAG) + Self::TOP + 1;
        if bottom == top && words.compare_exchange(self.base + AGE, age, reset) == age {
            return Some(item);
        }
        // A thief has the last item, and no other can succeed: this is the only store of `age`.
        words.fence();
        words.store(self.base + AGE, reset);
        None
    }

    /// A thief takes the item that was pushed first, in one attempt; `None`: there is none, or
    /// somebody else took it.
    pub fn steal(self, words: &impl FencedWords) -> Option<Item> {
        let age = words.load_acquire(self.base + AGE);
        words.fence();
        let top = age & Self::TOP;
        if words.load_acquire(self.base + BOTTOM) <= top {
            return None;
        }
        let item = self.read(words, top);
        (words.compare_exchange(self.base + AGE, age, age + 1) == age).then_some(item)
    }

    fn item(self, i: u32) -> usize {
        self.base + ITEMS + 2 * i as usize
    }

    fn read(self, words: &impl FencedWords, i: u32) -> Item {
        [words.load(self.item(i)), words.load(self.item(i) + 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::test_words::Atomics;

    #[test]
    fn owners_take_the_last_and_thieves_the_first() {
        let words = Atomics::new(3 + AbpDeque::words(3), 0xdead_beef);
        let deque = AbpDeque { base: 3, capacity: 3 };
        deque.clear(&words);
        assert_eq!((deque.pop(&words), deque.steal(&words)), (None, None));
        for round in 0..10 {
            (0..3).for_each(|i| deque.push(&words, [round, i]).unwrap());
            assert_eq!(deque.push(&words, [9, 9]), Err(Full));
            assert_eq!(deque.steal(&words), Some([round, 0]));
            assert_eq!(deque.pop(&words), Some([round, 2]));
            if round % 2 == 0 {
                assert_eq!(deque.steal(&words), Some([round, 1]));
            } else {
                assert_eq!(deque.pop(&words), Some([round, 1]));
            }
            assert_eq!((deque.pop(&words), deque.steal(&words)), (None, None));
        }
    }

    /// The tag never comes around: a deque that has none left is full until it is cleared.
    #[test]
    fn tags_run_out_and_do_not_wrap() {
        let words = Atomics::new(AbpDeque::words(1), 0);
        let deque = AbpDeque { base: 0, capacity: 1 };
        deque.clear(&words);
        let resets = (0..1 << 20).take_while(|&k| {
            let pushed = deque.push(&words, [k, k]).is_ok();
            assert_eq!(deque.pop(&words), pushed.then_some([k, k]));
            pushed
        });
        assert_eq!(resets.count(), (1 << 18) - 1);
        deque.clear(&words);
        assert_eq!(deque.push(&words, [1, 1]), Ok(()));
    }
}
