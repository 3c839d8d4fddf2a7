//! Words that threads share: what a kernel body asks of them, whatever they stand in.

use super::memory::at;

/// Shared 32-bit words, as a kernel sees them: atomics on a CPU, a storage buffer on a GPU.
pub trait Words {
    /// Relaxed load of word `i`.
    fn load(&self, i: usize) -> u32;
    /// Relaxed store to word `i`.
    fn store(&self, i: usize, value: u32);
    /// Adds and returns the old value; acquires what others released by this call on the same word,
    /// releases what this thread stored before.
    fn add_acquire_release(&self, i: usize, value: u32) -> u32;
    /// Load of word `i` that acquires what others released before they changed it.
    fn load_acquire(&self, i: usize) -> u32;
    /// Stores `new` if the word is `old`, and returns what it was; acquires and releases if it
    /// stores. Never fails for another reason.
    fn compare_exchange(&self, i: usize, old: u32, new: u32) -> u32;
}

/// The same with fences, which kernels do not have.
pub trait FencedWords: Words {
    /// A fence of sequential consistency: all threads see the same order of what stands before and
    /// behind any two of them.
    fn fence(&self);
}

/// The same to be read only: also a buffer that no thread writes in the same dispatch.
pub trait ReadWords {
    /// Word `i`.
    fn word(&self, i: usize) -> u32;
}

impl<W: Words> ReadWords for W {
    #[inline(always)]
    fn word(&self, i: usize) -> u32 {
        self.load(i)
    }
}

impl ReadWords for [u32] {
    #[inline(always)]
    fn word(&self, i: usize) -> u32 {
        at(self, i)
    }
}
