//! Pairs of blocks as pairs of nodes: what a scheduler descends and a front keeps of them.

use crate::broad_phase::block_bvh::BlockBvh;
use crate::broad_phase::block_pairs::{BlockPair, BlockPairs, BlockSource, child, raise};
use crate::broad_phase::descend::{FrontTree, Pairs, PairsOfNodes, Place};
use crate::broad_phase::front::Writer;
use crate::broad_phase::leaf_boxes::Sides;
use crate::simd::{RowSimd, WIDTH, get_lane};
use crate::threads::Threads;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use std::cmp::Ordering;

impl PairsOfNodes for BlockSource {
    fn descend(&mut self, _threads: &Threads, sides: Sides, run: &mut dyn FnMut(Pairs)) {
        raise(&mut self.trees, sides);
        let Some(pairs) = BlockPairs::of(&self.trees, sides) else { return };
        let builds = [pairs.a.build(), pairs.b.build()];
        run(Pairs { tree: &pairs, roots: &[pairs.root().packed()], builds });
    }
}

/// A front keeps pairs of blocks of blocks, and what is below them is found anew in each step:
/// where 64 pairs are tested in eight instructions each, reading them one by one from a front costs
/// more.
impl FrontTree for BlockPairs<'_> {
    const WHOLE_ROWS: bool = true;

    #[inline(always)]
    fn place(self, pair: NodePair) -> Place {
        let deepest = (self.a.height() as u32 - 1).min(1);
        match BlockPair::unpacked(pair).level.cmp(&deepest) {
            Ordering::Greater => Place::Above,
            Ordering::Equal => Place::At,
            Ordering::Less => Place::Below,
        }
    }

    #[inline(always)]
    fn meets(self, pair: NodePair) -> bool {
        let BlockPair { level, a, b } = BlockPair::unpacked(pair);
        let (level, a, b) = (level as usize + 1, a as usize, b as usize);
        if level >= self.a.height() {
            return true;
        }
        let lane = |tree: &BlockBvh, i: usize| get_lane(&tree.level(level)[i / WIDTH], i % WIDTH);
        lane(self.a, a).overlaps(&lane(self.b, b))
    }

    #[inline(always)]
    fn expand_all<S: RowSimd>(
        self,
        simd: S,
        pair: NodePair,
        out: &mut Vec<NodePair>,
        front: &mut Writer,
    ) {
        let pair = BlockPair::unpacked(pair);
        let (met, mut masks) = (self.overlaps(simd, pair), self.wanted(pair));
        if self.a.marks.worlds().are_known() {
            masks &= self.in_one_world(pair);
        }
        let below = pair.level as usize - 1;
        let (n_a, n_b) = (self.a.level(below).len() as u32, self.b.level(below).len() as u32);
        while masks != 0 {
            let bit = masks.trailing_zeros();
            masks &= masks - 1;
            let child = child(pair, bit);
            if met >> bit & 1 == 1 {
                out.push(child.packed());
            } else if child.a < n_a && child.b < n_b {
                front.push(child.packed());
            }
        }
    }
}
