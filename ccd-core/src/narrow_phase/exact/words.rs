//! Where the words of integers are: on the stack, or on the heap.

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// Where the words of an integer are.
pub trait Words: Clone + AsRef<[u64]> + AsMut<[u64]> {
    /// How many there may be.
    const MOST: usize;
    /// None, or as many as there are, each 0.
    const NONE: Self;

    /// Makes it at least `len` of them, which are at most [`Words::MOST`]; new ones are 0.
    fn grow(&mut self, len: usize);
}

impl<const N: usize> Words for [u64; N] {
    const MOST: usize = N;
    const NONE: Self = [0; N];

    fn grow(&mut self, _: usize) {}
}

#[cfg(feature = "alloc")]
impl Words for Vec<u64> {
    const MOST: usize = usize::MAX;
    const NONE: Self = Vec::new();

    fn grow(&mut self, len: usize) {
        if self.len() < len {
            self.resize(len, 0);
        }
    }
}

/// Words for what fits no other integers: as many as there is memory for, or without a heap 96.
#[cfg(feature = "alloc")]
pub type Longest = Vec<u64>;
/// Words for what fits no other integers: as many as there is memory for, or without a heap 96.
#[cfg(not(feature = "alloc"))]
pub type Longest = [u64; 96];
