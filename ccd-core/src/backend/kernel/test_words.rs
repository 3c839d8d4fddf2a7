//! Words of memory as threads of this machine share them, for tests.

use super::{FencedWords, Words};
use std::sync::atomic::{AtomicU32, Ordering, fence};
use std::vec::Vec;

pub struct Atomics(pub Vec<AtomicU32>);

impl Atomics {
    pub fn new(n: usize, word: u32) -> Self {
        Self((0..n).map(|_| AtomicU32::new(word)).collect())
    }
}

impl FencedWords for Atomics {
    fn fence(&self) {
        fence(Ordering::SeqCst);
    }
}

impl Words for Atomics {
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
