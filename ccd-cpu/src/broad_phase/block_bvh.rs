//! The default tree: boxes sorted along the Morton curve, in blocks of eight, in blocks of eight
//! blocks, and so on.
//!
//! Every node is one [`Block`], eight boxes side by side; node `i` of a level has the nodes `8 i ..
//! 8 i + 8` of the level below as children, so there are no pointers, and refitting is one pass
//! over the levels.

use crate::broad_phase::morton_order::MortonOrder;
use crate::simd::{Block, EMPTY, WIDTH};
use crate::threads::Threads;
use ccd_core::Aabb;

/// A tree over `n` boxes.
#[derive(Debug, Default)]
pub struct BlockBvh {
    n: usize,
    order: Vec<u32>,
    /// `levels[0]` holds the boxes, `levels[height - 1]` is one block; those above are kept for
    /// their memory.
    levels: Vec<Vec<Block>>,
    height: usize,
    /// Per level and block: the lanes that hold fixed boxes only; empty where none was marked.
    fixed: Vec<Vec<u8>>,
    any_fixed: bool,
    morton: MortonOrder,
    looseness_at_build: f64,
    sums: Vec<f64>,
}

impl BlockBvh {
    /// Whether there is no box.
    pub fn is_empty(&self) -> bool {
        self.n == 0
    }

    /// Number of levels above the boxes; a tree without boxes has one empty block.
    pub fn height(&self) -> usize {
        self.height
    }

    /// Blocks of a level, 0 being the boxes themselves. A level above the last is one block with
    /// one lane used.
    pub fn level(&self, level: usize) -> &[Block] {
        &self.levels[level]
    }

    /// Ids of the boxes in leaf order: lane `j` of block `i` of level 0 is box `order()[8 i + j]`.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Lanes of block `i` of a level that hold fixed boxes only.
    #[inline(always)]
    pub fn fixed(&self, level: usize, i: usize) -> u8 {
        if level < self.fixed.len() && i < self.fixed[level].len() { self.fixed[level][i] } else { 0 }
    }

    /// Whether any box is fixed.
    pub fn any_fixed(&self) -> bool {
        self.any_fixed
    }

    /// Sorts the boxes anew and builds all levels. Boxes for which `fixed(i)` come last, so that
    /// whole blocks are fixed.
    pub fn build(&mut self, threads: &Threads, boxes: &[Aabb<f32>], fixed: Option<&(dyn Fn(usize) -> bool + Sync)>) {
        self.n = boxes.len();
        self.morton.sort(threads, boxes, fixed, &mut self.order);
        self.fit(threads, boxes);
        self.mark_fixed(fixed);
        self.looseness_at_build = self.looseness(threads);
    }

    fn mark_fixed(&mut self, fixed: Option<&(dyn Fn(usize) -> bool + Sync)>) {
        self.any_fixed = fixed.is_some();
        // Levels beyond those of this build, too: `raise` may need them, and they are not marked.
        self.fixed.iter_mut().for_each(Vec::clear);
        let Some(fixed) = fixed else { return };
        for level in 0..self.height {
            if self.fixed.len() == level {
                self.fixed.push(Vec::new());
            }
            let (below, here) = self.fixed.split_at_mut(level);
            match below.last() {
                None => here[0].extend(self.order.chunks(WIDTH).map(|ids| all_of(ids, |&id| fixed(id as usize)))),
                Some(below) => here[0].extend(below.chunks(WIDTH).map(|masks| all_of(masks, |&mask| mask == 0xff))),
            }
        }
    }

    /// Keeps the order of the last build and takes new boxes, as many as then. Returns how much
    /// looser blocks have become since: the ratio of [`BlockBvh::looseness`] to what it was after
    /// the build.
    pub fn refit(&mut self, threads: &Threads, boxes: &[Aabb<f32>]) -> f64 {
        assert_eq!(boxes.len(), self.n, "refit with another number of boxes");
        self.fit(threads, boxes);
        let looseness = self.looseness(threads);
        if self.looseness_at_build > 0.0 { looseness / self.looseness_at_build } else { 1.0 }
    }

    /// Sum of the side lengths of all blocks of eight, relative to that of the boxes in them: what
    /// a block costs its tests.
    fn looseness(&mut self, threads: &Threads) -> f64 {
        if self.height < 2 {
            return 1.0;
        }
        let boxes = extents(threads, &self.levels[0], &mut self.sums);
        let blocks = extents(threads, &self.levels[1], &mut self.sums);
        if boxes > 0.0 { blocks / boxes } else { 1.0 }
    }

    fn fit(&mut self, threads: &Threads, boxes: &[Aabb<f32>]) {
        let mut n_blocks = self.n.div_ceil(WIDTH).max(1);
        let mut height = 0;
        let order = &self.order;
        loop {
            if self.levels.len() == height {
                self.levels.push(Vec::new());
            }
            let (below, here) = self.levels.split_at_mut(height);
            here[0].resize(n_blocks, EMPTY);
            match below.last() {
                None => threads.fill(&mut here[0], |i| {
                    let mut block = EMPTY;
                    let leaves = &order[(i * WIDTH).min(order.len())..((i + 1) * WIDTH).min(order.len())];
                    for (j, &id) in leaves.iter().enumerate() {
                        set_lane(&mut block, j, &boxes[id as usize]);
                    }
                    block
                }),
                Some(children) => threads.fill(&mut here[0], |i| {
                    let mut block = EMPTY;
                    let children = &children[i * WIDTH..((i + 1) * WIDTH).min(children.len())];
                    for (j, child) in children.iter().enumerate() {
                        set_lane(&mut block, j, &union_of_lanes(child));
                    }
                    block
                }),
            }
            height += 1;
            if n_blocks == 1 {
                break;
            }
            n_blocks = n_blocks.div_ceil(WIDTH);
        }
        self.height = height;
    }

    /// Adds levels of one used lane until the tree is `height` high, so that two trees can be
    /// descended in step.
    pub fn raise(&mut self, height: usize) {
        while self.height < height {
            let mut block = EMPTY;
            set_lane(&mut block, 0, &union_of_lanes(&self.levels[self.height - 1][0]));
            if self.levels.len() == self.height {
                self.levels.push(Vec::new());
            }
            self.levels[self.height].clear();
            self.levels[self.height].push(block);
            self.height += 1;
        }
    }
}

/// Sum of the side lengths of all boxes of a level; the order of additions does not depend on
/// threads.
fn extents(threads: &Threads, level: &[Block], sums: &mut Vec<f64>) -> f64 {
    sums.resize(level.len(), 0.0);
    threads.fill(sums, |i| {
        let block = &level[i];
        let side = |k: usize, j: usize| {
            if block.min[k].0[j] <= block.max[k].0[j] { block.max[k].0[j] as f64 - block.min[k].0[j] as f64 } else { 0.0 }
        };
        (0..WIDTH).map(|j| side(0, j) + side(1, j) + side(2, j)).sum()
    });
    sums.iter().sum()
}

/// The items for which `f`, as bits; a lane past the last item counts as fixed.
fn all_of<T>(items: &[T], f: impl Fn(&T) -> bool) -> u8 {
    items.iter().enumerate().fold(0xff, |mask, (j, item)| if f(item) { mask } else { mask & !(1 << j) })
}

fn set_lane(block: &mut Block, j: usize, aabb: &Aabb<f32>) {
    for k in 0..3 {
        block.min[k].0[j] = aabb.min[k];
        block.max[k].0[j] = aabb.max[k];
    }
}

fn union_of_lanes(block: &Block) -> Aabb<f32> {
    let mut out = Aabb::EMPTY;
    for k in 0..3 {
        for j in 0..WIDTH {
            out.min[k] = out.min[k].min(block.min[k].0[j]);
            out.max[k] = out.max[k].max(block.max[k].0[j]);
        }
    }
    out
}

/// The ids of block `b`; lanes past the end repeat the last id.
#[inline(always)]
pub fn lane_ids(order: &[u32], b: usize) -> [u32; 8] {
    match order.get(b * 8..b * 8 + 8) {
        Some(ids) => ids.try_into().unwrap_or([0; 8]),
        None => std::array::from_fn(|j| order[(b * 8 + j).min(order.len() - 1)]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check_well_formed(bvh: &BlockBvh, boxes: &[Aabb<f32>]) {
        let mut seen: Vec<u32> = bvh.order.clone();
        seen.sort_unstable();
        assert!(seen.iter().copied().eq(0..boxes.len() as u32), "order is no permutation");
        for (leaf, &id) in bvh.order.iter().enumerate() {
            let mut at = leaf;
            for level in &bvh.levels[..bvh.height] {
                let (block, j) = (&level[at / WIDTH], at % WIDTH);
                for k in 0..3 {
                    let b = &boxes[id as usize];
                    assert!(block.min[k].0[j] <= b.min[k] && block.max[k].0[j] >= b.max[k], "leaf {leaf}, axis {k}");
                }
                at /= WIDTH;
            }
            assert_eq!(at, 0);
        }
    }

    #[test]
    fn every_ancestor_holds_every_box() {
        let threads = Threads::new(1).unwrap();
        let mut bvh = BlockBvh::default();
        for n in [0usize, 1, 7, 8, 9, 64, 65, 1000, 20_000] {
            let mut x = n as u32;
            let mut unit = || {
                x = x.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
                (x >> 8) as f32 / 16_777_216.0
            };
            let mut boxes: Vec<_> = (0..n).map(|_| Aabb::of_point([unit(), unit(), unit()])).collect();
            bvh.build(&threads, &boxes, None);
            check_well_formed(&bvh, &boxes);
            for b in &mut boxes {
                b.max[1] += unit();
            }
            bvh.refit(&threads, &boxes);
            check_well_formed(&bvh, &boxes);
        }
    }

    #[test]
    fn fixed_lanes_are_those_of_the_last_build() {
        let threads = Threads::new(1).unwrap();
        let boxes: Vec<_> = (0..4096).map(|i| Aabb::of_point([i as f32, 0.0, 0.0])).collect();
        let (all, none) = (|_: usize| true, |_: usize| false);
        let mut bvh = BlockBvh::default();
        bvh.build(&threads, &boxes, Some(&all));
        let height = bvh.height();
        let any = |bvh: &BlockBvh| (0..height).any(|level| bvh.fixed(level, 0) != 0);
        assert!(any(&bvh), "all boxes are fixed");
        // Fewer boxes and fewer levels, then as many levels as before.
        bvh.build(&threads, &boxes[..WIDTH], Some(&none));
        bvh.raise(height);
        assert!(!any(&bvh), "lanes of an earlier build");
        bvh.build(&threads, &boxes, Some(&all));
        bvh.build(&threads, &boxes, None);
        assert!(!any(&bvh), "lanes of an earlier build that had fixed boxes");
    }
}
