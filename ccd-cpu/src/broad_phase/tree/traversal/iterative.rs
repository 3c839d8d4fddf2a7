//! A query per box in the order of input, with a stack of its own rather than recursion [Karras
//! 2012b].
//!
//! ```text
//!   node    stack           both children overlap: go on with one, put the other on the stack
//!    0                      one does: go on with it
//!    1      4               none does: take one from the stack
//!    2      4 3
//! ```
//!
//! The stack is [`ccd_core::backend::broad_phase::stack_traversal::Walk`], which a GPU uses too:
//! there it makes neighbouring threads run the same loop, whatever each decides. On a CPU it saves
//! the calls of [`super::recursive`]. Neighbours in the input need not be neighbours in the tree,
//! so each query may begin with cold caches; [`super::leaf_order`] mends that.
//!
//! Cost: per query, the nodes whose boxes overlap it; each pair is found twice within one set and
//! kept once. It is here for comparison.

use super::queries::Query;

/// In the order of input, with a stack.
#[derive(Debug)]
pub struct Iterative;

impl Query for Iterative {
    const INPUT_ORDER: bool = true;
}
