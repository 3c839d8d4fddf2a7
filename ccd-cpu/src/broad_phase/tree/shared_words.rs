//! Atomic words as kernel bodies see them, and branches that threads write wherever they belong.
//!
//! Twin: none; words of a device are shared as they are.

use crate::threads::Threads;
use ccd_core::backend::broad_phase::node_numbering::BRANCH;
use ccd_core::backend::kernel::{FencedWords, Words};
use ccd_core::backend::layout::Branch;
use std::sync::atomic::{AtomicU32, Ordering, fence};

/// Words that threads share.
#[derive(Clone, Copy)]
pub struct Shared<'a>(pub &'a [AtomicU32]);

impl Words for Shared<'_> {
    fn load(&self, i: usize) -> u32 {
        self.0[i].load(Ordering::Relaxed)
    }
    fn store(&self, i: usize, value: u32) {
        self.0[i].store(value, Ordering::Relaxed);
    }
    fn add_acquire_release(&self, i: usize, value: u32) -> u32 {
        self.0[i].fetch_add(value, Ordering::AcqRel)
    }
    fn load_acquire(&self, i: usize) -> u32 {
        self.0[i].load(Ordering::Acquire)
    }
    fn compare_exchange(&self, i: usize, old: u32, new: u32) -> u32 {
        let (taken, lost) = (Ordering::AcqRel, Ordering::Relaxed);
        self.0[i].compare_exchange(old, new, taken, lost).unwrap_or_else(|seen| seen)
    }
}

impl FencedWords for Shared<'_> {
    fn fence(&self) {
        fence(Ordering::SeqCst);
    }
}

/// Copies words to `out`.
pub fn copy(threads: &Threads, words: &[AtomicU32], out: &mut Vec<u32>) {
    out.resize(words.len(), 0);
    threads.fill(out, |i| words[i].load(Ordering::Relaxed));
}

/// Copies branches, in the words of
/// [`ccd_core::backend::broad_phase::node_numbering::store_branch`], to `out`.
pub fn copy_branches(threads: &Threads, words: &[AtomicU32], out: &mut Vec<Branch>) {
    let word = |i: usize, k: usize| words[i * BRANCH + k].load(Ordering::Relaxed);
    out.resize(words.len() / BRANCH, Branch { left: 0, right: 0, first: 0, last: 0 });
    threads.fill(out, |i| Branch {
        left: word(i, 0),
        right: word(i, 1),
        first: word(i, 2),
        last: word(i, 3),
    });
}
