//! Where the words of integers are: on the stack, or on the heap.

#[cfg(feature = "alloc")]
use alloc::{vec, vec::Vec};

/// Where the words of an integer are.
pub trait Words: Clone + AsRef<[u64]> + AsMut<[u64]> {
    /// How many there may be.
    const MOST: usize;
    /// None, or as many as there are, each 0.
    const NONE: Self;

    /// At least `len` of them, which are at most [`Words::MOST`], each 0.
    fn zeros(len: usize) -> Self;
}

impl<const N: usize> Words for [u64; N] {
    const MOST: usize = N;
    const NONE: Self = [0; N];

    fn zeros(_: usize) -> Self {
        Self::NONE
    }
}

#[cfg(feature = "alloc")]
impl Words for Vec<u64> {
    const MOST: usize = usize::MAX;
    const NONE: Self = Vec::new();

    fn zeros(len: usize) -> Self {
        vec![0; len]
    }
}

/// Words for what fits no other integers: as many as there is memory for, or without a heap 96.
#[cfg(feature = "alloc")]
pub type Longest = Vec<u64>;
/// Words for what fits no other integers: as many as there is memory for, or without a heap 96.
#[cfg(not(feature = "alloc"))]
pub type Longest = [u64; 96];
