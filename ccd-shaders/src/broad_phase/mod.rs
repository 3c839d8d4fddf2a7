//! From boxes to pairs of them: order, trees, traversal. The filters stand here, too, with the
//! pairs of blocks at which they go on at once, in the same workgroup.

pub mod binary_tree;
pub mod block_bvh;
pub mod block_candidates;
pub mod block_overlaps;
pub mod block_pairs;
pub mod bounds;
pub mod builder;
pub mod halves;
pub mod key_intervals;
pub mod listed;
pub mod oriented;
pub mod pair_descent;
pub mod pair_stacks;
pub mod scheduler;
pub mod stack_traversal;
pub mod sweep_by_end_points;
mod volume;
pub mod worlds;
