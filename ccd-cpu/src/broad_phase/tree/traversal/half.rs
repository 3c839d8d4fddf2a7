//! Half traversal: in the order of leaves, each query looking only at leaves after its own [Karras
//! 2012b]. Every pair is found once, and half of the tree is never visited.
//!
//! ```text
//!            0 .. 7             the query of leaf 2: of 0 .. 1 nothing comes after it,
//!         /          \          so that it is passed by without a look at its box
//!      0 .. 3      4 .. 7
//!      /    \
//!   0 .. 1  2 .. 3
//! ```
//!
//! The last leaf below a node says whether anything below it comes later. It is the number of an
//! internal left child, so that nothing needs to be read for it. Of two sets there is no such
//! order, and this is [`super::leaf_order`].
//!
//! Cost: about half of the nodes and half of the tests of [`super::leaf_order`], no pair twice.
//! Choose it for boxes of which few overlap: it is the fastest of the queries.

use super::queries::Query;

/// In the order of leaves, of those after its own.
#[derive(Debug)]
pub struct Half;

impl Query for Half {
    const HALF: bool = true;
}
