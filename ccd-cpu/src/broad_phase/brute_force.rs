//! Every box against every other, eight at a time: what all other methods are compared with.
//!
//! Twin: on a GPU `key_intervals.rs`, of which this is the interval of all boxes.
//!
//! The only limit is time: `n (n - 1) / 2` tests within one set, some 10^9 a second and thread.
//! For a few hundred boxes it is also fast, because nothing is built.

use crate::broad_phase::leaf_boxes::{Order, Set, Sides};
use crate::broad_phase::marks::Marks;
use crate::broad_phase::rows::{RowSource, Rows, Scratch};
use crate::simd::{RowSimd, WIDTH, Work};
use crate::threads::Threads;
use ccd_core::Aabb;

/// Tests all pairs; keeps nothing.
#[derive(Debug)]
pub struct BruteForce;

impl Order for BruteForce {
    fn sort(
        &mut self,
        _threads: &Threads,
        _set: Set,
        boxes: &[Aabb<f32>],
        _marks: &Marks,
        order: &mut Vec<u32>,
    ) {
        order.clear();
        order.extend(0..boxes.len() as u32);
    }
}

impl RowSource for BruteForce {
    /// A task is a block of eight boxes against all blocks, or against those from its own on.
    fn begin(&mut self, _threads: &Threads, (a, _): Sides) -> usize {
        a.blocks().len()
    }

    fn task(&self, k: usize, sides: Sides, _scratch: &mut Scratch, rows: &mut Rows) {
        crate::simd::run_rows!(OneAgainstAll { a: k, sides, rows });
    }
}

/// The boxes of block `a` against the other side.
struct OneAgainstAll<'a, 'b> {
    a: usize,
    sides: Sides<'a>,
    rows: &'a mut Rows<'b>,
}

impl<S: RowSimd> Work<S> for OneAgainstAll<'_, '_> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let Self { a, sides: (leaves, other), rows } = self;
        let block = &leaves.blocks()[a];
        let first = if other.is_none() { a } else { 0 };
        let others = other.unwrap_or(leaves).blocks();
        let lanes = (leaves.len() - a * WIDTH).min(WIDTH);
        for (b, against) in others.iter().enumerate().skip(first) {
            for lane in 0..lanes {
                let mut mask = simd.overlaps(block, lane, against);
                if other.is_none() && b == a {
                    mask &= !0 << (lane + 1);
                }
                rows.push(a * WIDTH + lane, b, mask);
            }
        }
    }
}
