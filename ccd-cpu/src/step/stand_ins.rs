//! Stand-ins in the order of leaves: which blocks hold a triangle with which a leaf makes tests
//! besides those that both represent, eight compared at once.

use crate::broad_phase::leaf_boxes::LeafBoxes;
use crate::simd::{RowSimd, WIDTH};
use ccd_core::triangle_pairs::orphans::OrphanSets;

/// No block.
const NONE: u32 = u32::MAX;

/// Stand-ins by leaf.
#[derive(Debug, Default)]
pub struct StandIns {
    starts: Vec<u32>,
    blocks: Vec<[u32; WIDTH]>,
    others: Vec<[Other; WIDTH]>,
    leaf_of: Vec<u32>,
}

/// A triangle of a block, and the tests that a leaf makes with it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Other {
    /// Its lane.
    pub lane: u32,
    /// The triangle.
    pub id: u32,
    /// Bits of [`ccd_core::triangle_pairs::Test`]s, of the leaf as the first triangle.
    pub tests: u16,
}

impl StandIns {
    /// Those of a mesh, for leaves in a new order.
    pub fn order(&mut self, sets: &OrphanSets, leaves: &LeafBoxes) {
        let order = leaves.order();
        self.leaf_of.resize(order.len(), 0);
        for (leaf, &t) in order.iter().enumerate() {
            self.leaf_of[t as usize] = leaf as u32;
        }
        self.starts.clear();
        self.blocks.clear();
        self.others.clear();
        self.starts.push(0);
        for &t in order {
            for some in sets.stand_ins(t).chunks(WIDTH) {
                let mut blocks = [NONE; WIDTH];
                let mut others = [Other::default(); WIDTH];
                for (i, stand_in) in some.iter().enumerate() {
                    let leaf = self.leaf_of[stand_in.other as usize];
                    let (width, id, tests) = (WIDTH as u32, stand_in.other, stand_in.tests);
                    blocks[i] = leaf / width;
                    others[i] = Other { lane: leaf % width, id, tests };
                }
                self.blocks.push(blocks);
                self.others.push(others);
            }
            self.starts.push(self.blocks.len() as u32);
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
