//! LBVH: a binary radix tree over sorted Morton codes, every internal node by itself [Karras 2012].

use super::TreeBuilder;
use crate::broad_phase::curve_order::CurveOrder;
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::radix_tree;
use ccd_core::backend::layout::Branch;

/// Sorts by 63-bit codes; ties are broken by place.
#[derive(Debug, Default)]
pub struct Lbvh {
    codes: Vec<[u32; 2]>,
}

impl TreeBuilder for Lbvh {
    fn build(
        &mut self,
        threads: &Threads,
        morton: &mut CurveOrder,
        boxes: &[Aabb<f32>],
        order: &mut Vec<u32>,
        branches: &mut Vec<Branch>,
    ) {
        let (n, codes) = (boxes.len(), &mut self.codes);
        morton.sort_codes(threads, boxes, order, codes);
        branches.resize(n.saturating_sub(1), Branch { left: 0, right: 0, first: 0, last: 0 });
        threads.fill(branches, |i| radix_tree::branch(i as u32, n as u32, codes));
    }
}
