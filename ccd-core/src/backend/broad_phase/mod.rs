//! Which boxes overlap: swept boxes, their order, trees over them, and which overlaps are
//! candidates.

pub mod balanced;
pub mod block_bvh;
pub mod block_workers;
pub mod candidate;
pub mod grid_levels;
pub mod grid_rows;
pub mod halves;
pub mod key_intervals;
pub mod morton_key;
pub mod nearest_pair;
pub mod node_numbering;
pub mod oriented_nodes;
pub mod oriented_refit;
pub mod pair_descent;
pub mod pair_rules;
pub mod pair_stacks;
pub mod pair_workers;
pub mod placement;
pub mod ploc;
pub mod radix_tree;
pub mod recursive;
pub mod refit;
pub mod split_lists;
pub mod stack_traversal;
pub mod sweep_and_prune;
pub mod sweep_by_end_points;
pub mod sweep_in_strips;
pub mod swept_box;
#[cfg(test)]
mod test_trees;
pub mod uniform_grid;
pub mod wide_nodes;
pub mod worlds;
