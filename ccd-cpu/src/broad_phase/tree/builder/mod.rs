//! Builders of binary trees: boxes in, an order of leaves and the branches over them out.

pub mod bottom_up;
mod lbvh;
mod nearest_pair;
mod ploc;
mod ploc_search;
mod split_lists;

use crate::threads::Threads;
use ccd_core::layout::Branch;
use ccd_core::model::catalogue::Catalogued;
use ccd_core::model::method::Builder;
use ccd_core::{Aabb, Error};
use std::fmt::Debug;

/// Builds trees; keeps its buffers between calls.
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
        boxes: &[Aabb<f32>],
        order: &mut Vec<u32>,
        branches: &mut Vec<Branch>,
    );

    /// Fills `order` alone, for boxes that need no tree but are near each other in it.
    fn sort(&mut self, threads: &Threads, boxes: &[Aabb<f32>], order: &mut Vec<u32>);
}

/// The builder of a choice, if there is one here.
pub fn new(choice: Builder) -> Result<Box<dyn TreeBuilder>, Error> {
    Ok(match choice {
        Builder::Lbvh => Box::new(lbvh::Lbvh::default()),
        Builder::SplitLists => Box::new(split_lists::SplitLists::default()),
        Builder::NearestPair { limit } => Box::new(nearest_pair::NearestPair::new(limit)),
        Builder::Ploc { radius } => Box::new(ploc::Ploc::new(radius)),
        other => return Err(Error::Method { name: other.row().name, backend: "cpu" }),
    })
}
