//! Pseudo-random numbers, the same on every machine. Tests of `ccd-core` include this file, so it
//! names nothing of the library.

/// Pseudo-random numbers: [`pcg`] of a counter.
///
/// ```
/// use ccd::scenes::Random;
///
/// let (mut one, mut same) = (Random::new(7), Random::new(7));
/// assert_eq!(one.point(), same.point());
/// assert_ne!(one.bits(), one.bits());
/// ```
#[derive(Clone, Debug)]
pub struct Random(u32);

/// The 32-bit PCG output hash (RXS-M-XS) [O'Neill 2014].
pub fn pcg(v: u32) -> u32 {
    let state = v.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

/// Where the counters of a seed begin: 2^32 over the golden ratio apart.
pub(super) fn origin(seed: u32) -> u32 {
    seed.wrapping_mul(0x9e37_79b9)
}

impl Random {
    /// From a seed.
    pub fn new(seed: u32) -> Self {
        Self(origin(seed))
    }

    /// 32 random bits.
    pub fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(1);
        pcg(self.0)
    }

    /// A number in `[0, 1)`, a multiple of 2^-24.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 8) as f64 / 16_777_216.0
    }

    /// A point in the unit cube.
    pub fn point(&mut self) -> [f64; 3] {
        [self.unit(), self.unit(), self.unit()]
    }

    /// An integer in `0 .. n`.
    pub fn below(&mut self, n: u32) -> u32 {
        self.bits() % n
    }
}
