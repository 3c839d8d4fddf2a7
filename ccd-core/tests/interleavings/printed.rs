//! Deques as they are printed in [da Silva 2013], for the checker to refute: algorithm 3.13, whose
//! owner takes without an exchange; and algorithm 3.6 of `ccd-core` without a fence or the tag.

use super::models::Scheme;
use super::words::Traced;
use ccd_core::backend::kernel::{FencedWords, Words};
use ccd_core::backend::scheduling::abp_deque::AbpDeque;
use ccd_core::backend::scheduling::deque::Item;
use std::cell::Cell;

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

/// Algorithm 3.6: the deque of `ccd-core`, or the same with a defect.
#[derive(Clone, Copy)]
pub struct Abp(pub Option<Defect>);

/// What the deque of algorithm 3.6 lacks.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Defect {
    /// The fence of a pop, between `bottom` and `age`.
    FenceOfPop,
    /// The fence of a steal, between `age` and `bottom`.
    FenceOfSteal,
    /// The fence before `age` is stored.
    FenceOfReset,
    /// The tag of `age`.
    Tag,
}

/// The deque; its first word is `age`, which has `top` in so many bits.
const ABP: AbpDeque = AbpDeque { base: 0, capacity: ROOM as u32 };
const TOP_BITS: u32 = 14;

/// Words without the tag, or without the fence of this number in a call.
struct View<'w> {
    words: &'w Traced,
    missing: Option<u32>,
    tags: bool,
    n_fences: Cell<u32>,
}

impl Abp {
    fn view(self, words: &Traced, fences: [Option<Defect>; 2]) -> View<'_> {
        let missing = fences.iter().position(|fence| fence.is_some() && *fence == self.0);
        let (missing, tags) = (missing.map(|k| k as u32), self.0 != Some(Defect::Tag));
        View { words, missing, tags, n_fences: Cell::new(0) }
    }
}

impl View<'_> {
    /// What is stored where `value` is to be.
    fn stored(&self, i: usize, value: u32) -> u32 {
        if i == 0 && !self.tags { value % (1 << TOP_BITS) } else { value }
    }
}

impl FencedWords for View<'_> {
    fn fence(&self) {
        if self.missing != Some(self.n_fences.replace(self.n_fences.get() + 1)) {
            self.words.fence();
        }
    }
}

impl Words for View<'_> {
    fn load(&self, i: usize) -> u32 {
        self.words.load(i)
    }
    fn store(&self, i: usize, value: u32) {
        self.words.store(i, self.stored(i, value));
    }
    fn add_acquire_release(&self, i: usize, value: u32) -> u32 {
        self.words.add_acquire_release(i, value)
    }
    fn load_acquire(&self, i: usize) -> u32 {
        self.words.load_acquire(i)
    }
    fn compare_exchange(&self, i: usize, old: u32, new: u32) -> u32 {
        self.words.compare_exchange(i, old, self.stored(i, new))
    }
}

impl Scheme for Abp {
    fn words(self) -> usize {
        AbpDeque::words(ABP.capacity)
    }

    fn name(i: usize) -> &'static str {
        match i {
            0 => "age",
            16 => "bottom",
            _ => "",
        }
    }

    fn push(self, words: &Traced, items: &[Item]) -> bool {
        let view = self.view(words, [None; 2]);
        items.iter().all(|&item| ABP.push(&view, item).is_ok())
    }

    fn pop(self, words: &Traced) -> Vec<Item> {
        let fences = [Defect::FenceOfPop, Defect::FenceOfReset].map(Some);
        Vec::from_iter(ABP.pop(&self.view(words, fences)))
    }

    fn steal(self, words: &Traced, _: u32) -> Vec<Item> {
        Vec::from_iter(ABP.steal(&self.view(words, [Some(Defect::FenceOfSteal), None])))
    }
}
