//! Stand-ins in the order of leaves: which blocks hold a triangle with which a leaf makes tests
//! besides those that both represent, eight compared at once.

use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::simd::{RowSimd, WIDTH};
use ccd_core::backend::triangle_pairs::orphans::OrphanSets;

/// No block.
const NONE: u32 = u32::MAX;

/// Stand-ins by leaf.
#[derive(Debug, Default)]
pub struct StandIns {
    starts: Vec<u32>,
    blocks: Vec<[u32; WIDTH]>,
    others: Vec<[Other; WIDTH]>,
    /// Where the leaves of each triangle begin in the next list, then their number.
    firsts: Vec<u32>,
    leaves: Vec<u32>,
}

/// A triangle of a block, and the tests that a leaf makes with it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Other {
    /// Its lane.
    pub lane: u32,
    /// The triangle.
    pub id: u32,
    /// Bits of [`ccd_core::backend::triangle_pairs::Test`]s, of the leaf as the first triangle.
    pub tests: u16,
}

impl StandIns {
    /// Those of a mesh, for leaves in a new order, in which a triangle may have several leaves.
    pub fn order(&mut self, sets: &OrphanSets, leaves: &LeafBoxes) {
        self.find_leaves(leaves.order());
        self.starts.clear();
        self.blocks.clear();
        self.others.clear();
        self.starts.push(0);
        for &t in leaves.order() {
            let mut n_in_group = WIDTH;
            for stand_in in sets.stand_ins(t) {
                let (id, tests) = (stand_in.other, stand_in.tests);
                let of_other = self.firsts[id as usize]..self.firsts[id as usize + 1];
                for at in of_other {
                    let leaf = self.leaves[at as usize];
                    if n_in_group == WIDTH {
                        self.blocks.push([NONE; WIDTH]);
                        self.others.push([Other::default(); WIDTH]);
                        n_in_group = 0;
                    }
                    let (group, width) = (self.blocks.len() - 1, WIDTH as u32);
                    self.blocks[group][n_in_group] = leaf / width;
                    self.others[group][n_in_group] = Other { lane: leaf % width, id, tests };
                    n_in_group += 1;
                }
            }
            self.starts.push(self.blocks.len() as u32);
        }
    }

    /// Lists the leaves of each triangle.
    fn find_leaves(&mut self, order: &[u32]) {
        let n = order.iter().map(|&t| t as usize + 1).max().unwrap_or(0);
        self.firsts.clear();
        self.firsts.resize(n + 1, 0);
        for &t in order {
            self.firsts[t as usize] += 1;
        }
        let mut sum = 0;
        for first in &mut self.firsts {
            sum += *first;
            *first = sum;
        }
        self.leaves.resize(order.len(), 0);
        // From the back: what was the end of a triangle's leaves becomes their beginning.
        for (leaf, &t) in order.iter().enumerate().rev() {
            self.firsts[t as usize] -= 1;
            self.leaves[self.firsts[t as usize] as usize] = leaf as u32;
        }
    }

    /// Groups of eight of a leaf.
    #[inline(always)]
    pub fn groups(&self, leaf: usize) -> std::ops::Range<usize> {
        self.starts[leaf] as usize..self.starts[leaf + 1] as usize
    }

    /// Those of a group that are in block `b`, a bit each.
    #[inline(always)]
    pub fn of_block<S: RowSimd>(&self, simd: S, group: usize, b: usize) -> u32 {
        simd.equals(&self.blocks[group], [b as u32; 2])
    }

    /// One of a group.
    #[inline(always)]
    pub fn get(&self, group: usize, i: usize) -> Other {
        self.others[group][i]
    }
}
