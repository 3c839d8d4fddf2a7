//! The boxes of one set in the order of a method's leaves, eight side by side: what a source of
//! pairs numbers its leaves by, and what a sink looks them up in.

use crate::broad_phase::pair_source::{Fixed, Order};
use crate::simd::{Block, EMPTY, WIDTH};
use crate::threads::Threads;
use ccd_core::Aabb;

/// Which of the sets that a source keeps, and what for.
#[derive(Clone, Copy, Debug)]
pub struct Set {
    /// Its number, from 0; nothing else has it in the same source.
    pub index: usize,
    /// Whether pairs are sought within it or with it as the second of two. Of a set that is only
    /// ever the first of two, a source may need the order alone.
    pub searched: bool,
}

/// Boxes of a set: leaf `8 i + j` is lane `j` of block `i`.
#[derive(Debug)]
pub struct LeafBoxes {
    set: Set,
    order: Vec<u32>,
    blocks: Vec<Block>,
}

impl LeafBoxes {
    /// No boxes yet.
    pub fn new(set: Set) -> Self {
        Self { set, order: Vec::new(), blocks: Vec::new() }
    }

    /// Which set this is.
    pub fn set(&self) -> Set {
        self.set
    }

    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.order.len()
    }

    /// Whether there is no box.
    pub fn is_empty(&self) -> bool {
        self.order.is_empty()
    }

    /// From leaf to id.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The boxes; lanes past the last hold the empty one.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// The box of a leaf.
    #[inline]
    pub fn get(&self, leaf: usize) -> Aabb<f32> {
        get_lane(&self.blocks[leaf / WIDTH], leaf % WIDTH)
    }

    /// The ids of block `b`; lanes past the end repeat the last id.
    #[inline(always)]
    pub fn ids(&self, b: usize) -> [u32; WIDTH] {
        let order = &self.order;
        match order.get(b * WIDTH..(b + 1) * WIDTH) {
            Some(ids) => ids.try_into().unwrap_or([0; WIDTH]),
            None => std::array::from_fn(|j| order[(b * WIDTH + j).min(order.len() - 1)]),
        }
    }

    /// Takes boxes, in an order that the source chooses, and has it build what it needs.
    pub fn build(
        &mut self,
        threads: &Threads,
        source: &mut dyn Order,
        boxes: &[Aabb<f32>],
        fixed: Option<Fixed>,
    ) {
        source.sort(threads, self.set, boxes, fixed, &mut self.order);
        self.place(threads, boxes);
        source.fit(threads, self);
    }

    /// Keeps the order of the last build and takes new boxes, as many as then. Returns how much
    /// looser the source has become since, see [`Order::fit`].
    pub fn refit(&mut self, threads: &Threads, source: &mut dyn Order, boxes: &[Aabb<f32>]) -> f64 {
        assert_eq!(boxes.len(), self.len(), "refit with another number of boxes");
        self.place(threads, boxes);
        source.fit(threads, self)
    }

    fn place(&mut self, threads: &Threads, boxes: &[Aabb<f32>]) {
        let Self { order, blocks, .. } = self;
        blocks.resize(order.len().div_ceil(WIDTH), EMPTY);
        threads.fill(blocks, |i| {
            let mut block = EMPTY;
            let ids = &order[i * WIDTH..((i + 1) * WIDTH).min(order.len())];
            for (j, &id) in ids.iter().enumerate() {
                set_lane(&mut block, j, &boxes[id as usize]);
            }
            block
        });
    }
}

/// The box in lane `j`.
#[inline]
pub fn get_lane(block: &Block, j: usize) -> Aabb<f32> {
    Aabb { min: block.min.map(|x| x.0[j]), max: block.max.map(|x| x.0[j]) }
}

/// Puts a box into lane `j`.
pub fn set_lane(block: &mut Block, j: usize, aabb: &Aabb<f32>) {
    for k in 0..3 {
        block.min[k].0[j] = aabb.min[k];
        block.max[k].0[j] = aabb.max[k];
    }
}
