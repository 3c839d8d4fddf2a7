//! A query per box in the order of leaves [Karras 2012b]: boxes that are near each other are
//! queried one after the other, and visit the same nodes while these are still in the cache.
//!
//! ```text
//!   input     7  2  5  0 ..     each somewhere else in the tree
//!   leaves    0  1  2  3 ..     each beside the one before
//! ```
//!
//! Everything else is as in [`super::iterative`]: all of the tree is asked for every box, each pair
//! is found twice within one set and kept once. Of two sets, only the boxes of the first are put in
//! this order, and a tree over them is not needed.
//!
//! Cost: the nodes of [`super::iterative`], in less time each. It is here for comparison: within
//! one set [`super::half`] does the same with half of the work.

use super::queries::Query;

/// In the order of leaves.
#[derive(Debug)]
pub struct LeafOrder;

impl Query for LeafOrder {}
