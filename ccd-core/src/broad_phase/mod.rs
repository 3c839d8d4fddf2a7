//! Which boxes overlap: swept boxes, their order, trees over them, and which overlaps are
//! candidates.

pub mod block_bvh;
pub mod candidate;
pub mod key_intervals;
pub mod morton_key;
pub mod pair_descent;
pub mod placement;
pub mod radix_tree;
pub mod refit;
pub mod stack_traversal;
pub mod sweep_and_prune;
pub mod swept_box;
#[cfg(test)]
mod test_trees;
pub mod uniform_grid;
