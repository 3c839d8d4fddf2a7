//! Which boxes overlap: swept boxes, their order, trees over them, and which overlaps are
//! candidates.

pub mod block_bvh;
pub mod candidate;
pub mod morton_key;
pub mod placement;
pub mod radix_tree;
pub mod refit;
pub mod stack_traversal;
pub mod swept_box;
pub mod wide_nodes;
