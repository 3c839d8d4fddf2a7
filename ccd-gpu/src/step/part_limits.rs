//! How large the parts of a step are: so that the candidates of each fit into a list that every
//! device can bind. Mostly there is one part.

use ccd_core::backend::broad_phase::block_bvh::WIDTH;

/// Candidates that a part of a step has at most, lest the list be larger than what every device
/// binds, 128 MiB.
pub const MOST: u32 = (1 << 24) - 2;

/// Candidates for which there is room before any frame, `of_each` for each of `n` features: about
/// what scenes of cloth have that are near at an end.
pub fn of_part(of_each: u32, n: u32) -> u32 {
    n.saturating_mul(of_each).min(MOST / 4)
}

/// How many of the pairs that are looked at a part takes at most, by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PartLimits([u32; 2]);

impl Default for PartLimits {
    fn default() -> Self {
        Self([u32::MAX; 2])
    }
}

impl PartLimits {
    /// Of a kind with `n_pairs` at most in all: not so few that there are more parts than
    /// [`MOST_PARTS`].
    pub fn of(&self, kind: usize, n_pairs: u32) -> u32 {
        self.0[kind].max(fewest(n_pairs))
    }

    /// Makes the parts of a kind smaller, of `n_pairs` at most in all, because one wanted more
    /// candidates than the `most` that a list is to have. Returns whether they can be.
    pub fn shrink(&mut self, kind: usize, wanted: u32, n_pairs: u32, most: u32) -> bool {
        let limit = self.of(kind, n_pairs).min(n_pairs);
        // Pairs of blocks of which no more can be candidates; and so many parts that a frame has
        // few dispatches.
        let least = (most / (WIDTH * WIDTH)).max(fewest(n_pairs));
        // Half of what would fit if all parts were alike.
        let fits = limit as u64 * most as u64 / (wanted as u64).max(1) / 2;
        let shrinks = limit > least;
        if shrinks {
            self.0[kind] = (fits as u32).max(least);
        }
        shrinks
    }

    /// All pairs of a kind are one part again.
    pub fn reset(&mut self, kind: usize) {
        self.0[kind] = u32::MAX;
    }
}

/// Parts of a frame, at most: each is two dispatches at least, of the 2,048 that a frame can have.
const MOST_PARTS: u32 = 256;

/// Of `n_pairs`, as many as a part has at least, lest there be more parts than that.
fn fewest(n_pairs: u32) -> u32 {
    n_pairs.div_ceil(MOST_PARTS).max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_become_smaller_until_their_candidates_fit() {
        let mut limits = PartLimits::default();
        let mut shrink = |kind, wanted, n_pairs| {
            (limits.shrink(kind, wanted, n_pairs, MOST), limits.of(kind, n_pairs))
        };
        assert_eq!(shrink(1, 4 * MOST, 1 << 18), (true, 1 << 15));
        assert_eq!(shrink(1, 2 * MOST, 1 << 18), (true, MOST / 1024));
        // Not to less than what always fits, nor to more parts than a frame can have.
        assert_eq!(shrink(1, u32::MAX, 1 << 18), (false, MOST / 1024));
        assert_eq!(shrink(0, u32::MAX, 1 << 26), (true, 1 << 18));
        assert_eq!(shrink(0, u32::MAX, 1 << 26), (false, 1 << 18));
        limits.reset(0);
        assert_eq!([0, 1].map(|kind| limits.of(kind, 1 << 18)), [u32::MAX, MOST / 1024]);
        // Nor when a list of pairs has become longer since.
        assert_eq!(limits.of(1, 1 << 30), 1 << 22);
    }
}
