//! Where the nodes of block trees are: every level of every set in one buffer, padded so that a
//! workgroup never meets two sets.
//!
//! Twin: on a CPU `tasks.rs`, which goes depth first.

use ccd_core::backend::broad_phase::block_bvh::{PADDING, WIDTH, sets};
use ccd_core::backend::layout::MAX_LEVELS;
use ccd_core::backend::layout::VERTEX_FACE;

/// All pairs of nodes on the level where a descent starts: at most this many.
const MAX_START_PAIRS: u64 = 1 << 14;

/// The levels of up to three trees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Levels {
    count: [u32; 3],
    /// First node of each set on each level, then the first of the next level; as in `Blocks`.
    pub slots: [[u32; 4]; MAX_LEVELS],
}

impl Levels {
    /// For sets of so many boxes. `None` if the nodes cannot be numbered with 32 bits.
    pub fn new(count: [u32; 3]) -> Option<Self> {
        let mut slots = [[0u32; 4]; MAX_LEVELS];
        let mut next = 0u64;
        for level in 0..MAX_LEVELS {
            for set in 0..3 {
                slots[level][set] = u32::try_from(next).ok()?;
                next += (nodes(count, level as u32, set) as u64).next_multiple_of(PADDING as u64);
            }
            slots[level][3] = u32::try_from(next).ok()?;
        }
        Some(Self { count, slots })
    }

    /// Nodes of a set on a level, without padding.
    pub fn nodes(&self, level: u32, set: usize) -> u32 {
        nodes(self.count, level, set)
    }

    /// Nodes of all sets on a level, with padding.
    pub fn padded(&self, level: u32) -> u32 {
        let slots = &self.slots[level as usize];
        slots[3] - slots[0]
    }

    /// Nodes of all levels.
    pub fn total(&self) -> u32 {
        self.slots[MAX_LEVELS - 1][3]
    }

    /// The level on which the descent for a kind of pairs starts, at least 1.
    pub fn start(&self, kind: u32) -> u32 {
        (1..MAX_LEVELS as u32 - 1)
            .find(|&level| self.n_pairs(kind, level) <= MAX_START_PAIRS)
            .unwrap_or(MAX_LEVELS as u32 - 1)
    }

    /// The highest level that any descent reads.
    pub fn top(&self) -> u32 {
        self.start(0).max(self.start(1))
    }

    fn n_pairs(&self, kind: u32, level: u32) -> u64 {
        let [a, b] = sets(kind).map(|set| self.nodes(level, set) as u64);
        if kind == VERTEX_FACE { a * b } else { a * (a + 1) / 2 }
    }

    /// All pairs of nodes on the level where the descent starts.
    pub fn start_pairs(&self, kind: u32) -> Vec<[u32; 2]> {
        let [a, b] = sets(kind).map(|set| self.nodes(self.start(kind), set));
        (0..a)
            .flat_map(|i| (if kind == VERTEX_FACE { 0 } else { i }..b).map(move |j| [i, j]))
            .collect()
    }
}

fn nodes(count: [u32; 3], level: u32, set: usize) -> u32 {
    (0..level).fold(count[set], |n, _| n.div_ceil(WIDTH))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn children_of_every_node_are_in_its_set() {
        for count in
            [[0, 0, 0], [1, 2, 3], [46_598, 138_825, 92_230], [0, 10_000_000, 0], [257, 8192, 8193]]
        {
            let levels = Levels::new(count).unwrap();
            for level in 1..MAX_LEVELS as u32 {
                for set in 0..3 {
                    let (first, end) = (
                        levels.slots[level as usize - 1][set],
                        levels.slots[level as usize - 1][set + 1],
                    );
                    assert!(
                        levels.nodes(level, set) * WIDTH <= end - first,
                        "{count:?} level {level} set {set}"
                    );
                    assert!((end - first) % PADDING == 0);
                }
            }
            for kind in [0, 1] {
                let pairs = levels.start_pairs(kind);
                assert!(
                    pairs.len() as u64 <= MAX_START_PAIRS
                        && pairs.len() as u64 == levels.n_pairs(kind, levels.start(kind))
                );
            }
        }
        assert_eq!(Levels::new([u32::MAX, u32::MAX, 1]), None);
    }
}
