//! The order of one set of boxes and the tree over it. No other set has a part of either, so that
//! those of several are made at once.
//!
//! Twin: none; on a GPU one sort has the keys of all sets.

use crate::broad_phase::block_bvh::BlockBvh;
use crate::broad_phase::block_pairs::BlockSource;
use crate::broad_phase::curve_order::CurveOrder;
use crate::broad_phase::leaf_boxes::{LeafBoxes, Order, Set};
use crate::broad_phase::marks::Marks;
use crate::broad_phase::worlds::fill_blocks;
use crate::simd::Block;
use crate::threads::Threads;
use ccd_core::Aabb;
use std::ops::Range;

/// The order of one set: what sorts its boxes, and its tree.
#[derive(Debug)]
pub struct BlockOrder<'a> {
    pub curve: &'a mut CurveOrder,
    pub tree: &'a mut BlockBvh,
}

impl Order for BlockOrder<'_> {
    fn sort(
        &mut self,
        threads: &Threads,
        _set: Set,
        boxes: &[Aabb<f32>],
        marks: &Marks,
        order: &mut Vec<u32>,
    ) {
        // What is fixed comes last, so that whole blocks are.
        self.curve.sort(threads, boxes, marks, order);
        if let Some(world) = marks.world {
            fill_blocks(order, world);
        }
        self.tree.begin(order, marks);
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        self.tree.fit(threads, leaves)
    }

    fn take_ends(
        &mut self,
        threads: &Threads,
        _: &LeafBoxes,
        ends: &[[Block; 2]],
        changed: &[Range<usize>],
        gap: f32,
    ) -> bool {
        self.tree.take_ends(threads, ends, changed, gap);
        true
    }
}

impl BlockSource {
    /// The order of one set.
    fn of(&mut self, set: usize) -> BlockOrder<'_> {
        self.make(set + 1);
        BlockOrder { curve: &mut self.curves[set], tree: &mut self.trees[set] }
    }

    /// Those of three sets.
    pub fn orders(&mut self) -> [BlockOrder<'_>; 3] {
        self.make(3);
        let [a, b, c] = &mut self.trees[..] else { unreachable!("three sets") };
        let [d, e, f] = &mut self.curves[..] else { unreachable!("three sets") };
        [(a, d), (b, e), (c, f)].map(|(tree, curve)| BlockOrder { curve, tree })
    }

    fn make(&mut self, n: usize) {
        self.cut = None;
        if self.trees.len() < n {
            self.trees.resize_with(n, BlockBvh::default);
            self.curves.resize_with(n, CurveOrder::default);
        }
    }
}

impl Order for BlockSource {
    fn sort(
        &mut self,
        threads: &Threads,
        set: Set,
        boxes: &[Aabb<f32>],
        marks: &Marks,
        order: &mut Vec<u32>,
    ) {
        self.of(set.index).sort(threads, set, boxes, marks, order);
    }

    fn fit(&mut self, threads: &Threads, leaves: &LeafBoxes) -> f64 {
        self.of(leaves.set().index).fit(threads, leaves)
    }

    fn take_ends(
        &mut self,
        threads: &Threads,
        leaves: &LeafBoxes,
        ends: &[[Block; 2]],
        changed: &[Range<usize>],
        gap: f32,
    ) -> bool {
        self.of(leaves.set().index).take_ends(threads, leaves, ends, changed, gap)
    }
}
