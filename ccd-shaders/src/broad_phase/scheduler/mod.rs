//! Workers that descend pairs of nodes, of binary trees or of blocks, with stealing and without.
//!
//! Twin: on a CPU `scheduler/` has a file for each way to share out work.

pub mod balanced;
mod binary_pair_tree;
mod block_pair_tree;
mod left_over;
mod places;
mod shared;
mod stealing;
mod stolen_batches;
mod worker;
pub mod workers;
