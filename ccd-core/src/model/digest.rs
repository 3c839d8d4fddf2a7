//! A digest of a set of pairs that does not depend on their order: what every backend must share
//! for the same input.

use crate::layout::Pair;

/// Number of pairs and the sum of their hashes.
///
/// ```
/// use ccd::{Digest, Pair};
///
/// let pairs = [Pair { a: 1, b: 2 }, Pair { a: 0, b: 7 }];
/// let digest = Digest::of(1, pairs.into_iter());
/// assert_eq!(digest, Digest::of(1, pairs.into_iter().rev()));
/// assert_ne!(digest, Digest::of(0, pairs.into_iter()));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Digest {
    /// How many pairs.
    pub count: u64,
    /// Sum, modulo 2^64, of a hash of each pair.
    pub sum: u64,
}

impl Digest {
    /// Takes one pair. `kind` keeps apart pairs of different kinds with the same ids.
    #[inline]
    pub fn add(&mut self, kind: u32, pair: Pair) {
        self.count += 1;
        self.sum = self
            .sum
            .wrapping_add(mix(((pair.a as u64) << 32 | pair.b as u64) ^ mix(kind as u64 + 1)));
    }

    /// The digest of all pairs of one kind.
    pub fn of(kind: u32, pairs: impl Iterator<Item = Pair>) -> Self {
        pairs.fold(Self::default(), |mut digest, pair| {
            digest.add(kind, pair);
            digest
        })
    }
}

impl core::fmt::Display for Digest {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{} {:016x}", self.count, self.sum)
    }
}

/// A bijection of 64 bits with good avalanche (the finaliser of SplitMix64) [Steele 2014].
fn mix(x: u64) -> u64 {
    let x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}
