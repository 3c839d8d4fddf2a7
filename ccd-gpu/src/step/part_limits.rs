//! How large the parts of a step are: so that the candidates of each fit into a list that every
//! device can bind. Mostly there is one part.

use crate::growable_list::Header;
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
    /// Of a kind.
    pub fn of(&self, kind: usize) -> u32 {
        self.0[kind]
    }

    /// Makes parts of a kind smaller, of `n_pairs` at most in all, if one had more than `most`
    /// candidates, and takes as wanted what a list may have. Returns whether that was so.
    pub fn settle(&mut self, kind: usize, header: &mut Header, n_pairs: u32, most: u32) -> bool {
        let is_over = header.wanted > most;
        if is_over {
            let limit = self.0[kind].min(n_pairs);
            // Half of what would fit if all parts were alike; not less than what always fits, of
            // pairs of blocks.
            let fits = limit as u64 * most as u64 / header.wanted as u64 / 2;
            self.0[kind] = (fits as u32).max(most / (WIDTH * WIDTH)).max(1);
            header.wanted = most;
        }
        is_over
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_become_smaller_until_their_candidates_fit() {
        let mut limits = PartLimits::default();
        let mut settle = |kind, wanted, n_pairs| {
            let mut header = Header { wanted, looked_at: 0 };
            let smaller = limits.settle(kind, &mut header, n_pairs, MOST);
            (smaller, header.wanted, limits.of(kind))
        };
        assert_eq!(settle(0, MOST, 1 << 18), (false, MOST, u32::MAX));
        assert_eq!(settle(1, 4 * MOST, 1 << 18), (true, MOST, 1 << 15));
        // Never to less than what always fits.
        assert_eq!(settle(1, u32::MAX, 1 << 18), (true, MOST, MOST / 1024));
    }
}
