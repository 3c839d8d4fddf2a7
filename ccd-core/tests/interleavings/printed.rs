//! Deques as they are printed in [da Silva 2013], for the checker to refute: algorithm 3.13, whose
//! owner takes without an exchange, and algorithm 3.6 with weaker order than it needs.

use super::models::Scheme;
use super::words::Traced;
use ccd_core::backend::kernel::Words;
use ccd_core::backend::scheduling::deque::Item;

/// Items a take, of algorithm 3.13.
const POP_SIZE: u32 = 1;
/// Words: the ends, then items.
const TOP: usize = 0;
const BOTTOM: usize = 1;
const ITEMS: usize = 2;
const ROOM: usize = 4;

fn put(words: &Traced, i: u32, item: Item) {
    words.store(ITEMS + 2 * i as usize, item[0]);
    words.store(ITEMS + 2 * i as usize + 1, item[1]);
}

fn get(words: &Traced, i: u32) -> Item {
    [0, 1].map(|k| words.load(ITEMS + 2 * i as usize + k))
}

/// Algorithm 3.13: `top` and `bottom` in two words; thieves leave a margin of `2 * POP_SIZE + 1`
/// items, and the owner takes without an exchange. All fences are there that there can be, so that
/// order is not what is wrong.
#[derive(Clone, Copy)]
pub struct Lazy;

impl Scheme for Lazy {
    fn words(self) -> usize {
        ITEMS + 2 * ROOM
    }

    fn name(i: usize) -> &'static str {
        ["top", "bottom", ""][i.min(2)]
    }

    fn push(self, words: &Traced, items: &[Item]) -> bool {
        let bottom = words.load(BOTTOM);
        if bottom as usize + items.len() > ROOM {
            return false;
        }
        (0..).zip(items).for_each(|(i, &item)| put(words, bottom + i, item));
        words.store_release(BOTTOM, bottom + items.len() as u32);
        words.fence();
        true
    }

    fn pop(self, words: &Traced) -> Vec<Item> {
        words.fence();
        let (top, mut bottom) = (words.load_acquire(TOP), words.load(BOTTOM));
        if bottom == top {
            return Vec::new();
        }
        bottom -= POP_SIZE;
        let (first, n) = if bottom > top {
            words.store_release(BOTTOM, bottom);
            (bottom, POP_SIZE)
        } else {
            words.store_release(BOTTOM, top);
            (top, bottom + POP_SIZE - top)
        };
        words.fence();
        (first..first + n).map(|i| get(words, i)).collect()
    }

    fn steal(self, words: &Traced, _: u32) -> Vec<Item> {
        words.fence();
        let top = words.load_acquire(TOP);
        words.fence();
        let bottom = words.load_acquire(BOTTOM);
        if bottom < top + 2 * POP_SIZE + 1 {
            return Vec::new();
        }
        let n = POP_SIZE.min(bottom - top);
        if words.compare_exchange(TOP, top, top + n) != top {
            return Vec::new();
        }
        words.fence();
        (top..top + n).map(|i| get(words, i)).collect()
    }
}

/// Algorithm 3.6: `bot` in one word, `age`, which is `top` and a tag, in another; with a fence
/// wherever all threads must see one order, or, not `sequential`, with acquire and release alone.
#[derive(Clone, Copy)]
pub struct Task {
    pub sequential: bool,
}

/// The tag of `age`, above `top`.
const TAG: u32 = 1 << 16;

impl Task {
    fn fence(self, words: &Traced) {
        if self.sequential {
            words.fence();
        }
    }
}

impl Scheme for Task {
    fn words(self) -> usize {
        ITEMS + 2 * ROOM
    }

    fn name(i: usize) -> &'static str {
        ["age", "bot", ""][i.min(2)]
    }

    fn push(self, words: &Traced, items: &[Item]) -> bool {
        for &item in items {
            let bot = words.load(BOTTOM);
            if bot as usize == ROOM {
                return false;
            }
            put(words, bot, item);
            words.store_release(BOTTOM, bot + 1);
        }
        true
    }

    fn pop(self, words: &Traced) -> Vec<Item> {
        let bot = words.load(BOTTOM);
        if bot == 0 {
            return Vec::new();
        }
        let bot = bot - 1;
        words.store_release(BOTTOM, bot);
        self.fence(words);
        let item = get(words, bot);
        let old = words.load_acquire(TOP);
        let (top, tag) = (old % TAG, old / TAG);
        if bot > top {
            return vec![item];
        }
        words.store_release(BOTTOM, 0);
        let new = (tag + 1) * TAG;
        if bot == top && words.compare_exchange(TOP, old, new) == old {
            return vec![item];
        }
        words.store_release(TOP, new);
        Vec::new()
    }

    fn steal(self, words: &Traced, _: u32) -> Vec<Item> {
        let old = words.load_acquire(TOP);
        self.fence(words);
        let bot = words.load_acquire(BOTTOM);
        if bot <= old % TAG {
            return Vec::new();
        }
        let item = get(words, old % TAG);
        if words.compare_exchange(TOP, old, old + 1) == old { vec![item] } else { Vec::new() }
    }
}
