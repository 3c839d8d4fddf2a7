//! Pseudo-random numbers of a seed, the same on every machine (SplitMix64) [Steele 2014].

#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let x = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        x ^ (x >> 31)
    }

    /// In `[0, 1)`.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// In `[lo, hi)`.
    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    pub fn below(&mut self, n: usize) -> usize {
        ((self.bits() >> 32) as usize * n) >> 32
    }

    pub fn sign(&mut self) -> f64 {
        if self.bits() >> 63 == 0 { 1.0 } else { -1.0 }
    }

    /// About `2^x`, `x` uniform in `[lo, hi)`; without a logarithm, which machines round
    /// differently.
    pub fn power(&mut self, lo: f64, hi: f64) -> f64 {
        let x = self.between(lo, hi);
        (1.0 + (x - x.floor())) * f64::from_bits(((x.floor() as i64 + 1023) as u64) << 52)
    }

    /// A vector of components in `[-1, 1)`.
    pub fn vector(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.between(-1.0, 1.0))
    }
}
