//! From boxes to pairs of them: order, trees, traversal. The filters stand here, too, with the
//! pairs of blocks at which they go on at once, in the same workgroup.

mod binary_pair_tree;
pub mod block_bvh;
mod block_pair_tree;
pub mod block_pairs;
pub mod bounds;
pub mod key_intervals;
pub mod listed;
pub mod nearest_pair;
pub mod node_numbering;
pub mod oriented;
pub mod oriented_pairs;
pub mod pair_descent;
pub mod pair_stealing;
mod pair_tree;
pub mod pair_workers;
pub mod ploc;
pub mod radix_tree;
pub mod split_lists;
mod stolen_batches;
mod worker;
pub mod worlds;
