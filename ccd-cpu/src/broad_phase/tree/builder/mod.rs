//! Builders of binary trees: boxes in, an order of leaves and the branches over them out.

#[cfg(feature = "catalogue")]
pub mod bottom_up;
pub mod lbvh;
#[cfg(feature = "catalogue")]
pub mod nearest_pair;
#[cfg(feature = "catalogue")]
pub mod ploc;
#[cfg(feature = "catalogue")]
mod ploc_search;
#[cfg(feature = "catalogue")]
pub mod split_lists;

use crate::broad_phase::curve_order::CurveOrder;
use crate::threads::Threads;
use ccd_core::backend::layout::Branch;
use ccd_core::{Aabb, Error};
use std::fmt::Debug;

/// Builds trees; keeps its buffers between calls, but for those of the order along the curve.
pub trait TreeBuilder: Debug + Send + Sync {
    /// Whether it builds trees over so many boxes.
    fn check(&self, _n: usize) -> Result<(), Error> {
        Ok(())
    }

    /// Fills `order`, from leaf to id, and the branches over it in the numbering of
    /// [`super::binary_tree`]: one fewer than boxes, none over fewer than two.
    fn build(
        &mut self,
        threads: &Threads,
        morton: &mut CurveOrder,
        boxes: &[Aabb<f32>],
        order: &mut Vec<u32>,
        branches: &mut Vec<Branch>,
    );
}
