//! Threads of a workgroup that bodies count on, as the table has them.

use super::Id;
use crate::broad_phase::{
    block_bvh, halves, key_intervals, nearest_pair, pair_workers, ploc, wide_nodes,
};

const _: () = assert!(Id::SortCount.threads() == super::sort::COUNT_THREADS);
const _: () = assert!(Id::SortScatter.threads() == super::sort::THREADS);
const _: () = assert!(Id::SortScatterBySubgroups.threads() == super::sort::SUBGROUP_THREADS);
const _: () = assert!(Id::IntervalPairs.threads() == key_intervals::GROUP);
const _: () = assert!(Id::NearNodes.threads() == wide_nodes::TILE);
const _: () = assert!(Id::PlocFinish.threads() == ploc::FEW);
const _: () = assert!(Id::PlocFinish.threads() == super::prefix::TILE);
const _: () = assert!(Id::PlocJoin.threads() == super::prefix::TILE);
const _: () = assert!(Id::PlocCount.threads() == super::prefix::TILE);
const _: () = assert!(Id::PairSearch.threads() == nearest_pair::GROUP);
const _: () = assert!(Id::OrientNear.threads() == wide_nodes::TILE);
const _: () = assert!(Id::PairWorkers.threads() == pair_workers::THREADS);
const _: () = assert!(Id::StealPairs.threads() == pair_workers::THREADS);
const _: () = assert!(Id::ResumeFront.threads() == pair_workers::THREADS);
const _: () = assert!(Id::BlockWorkers.threads() == block_bvh::THREADS);
const _: () = assert!(Id::BlockWorkers.threads() == pair_workers::THREADS);
const _: () = assert!(Id::StealBlockPairs.threads() == pair_workers::THREADS);
const _: () = assert!(Id::HalveRuns.threads() == halves::RUN);
const _: () = assert!(Id::NodePairs.threads() == block_bvh::THREADS);
const _: () = assert!(Id::NodePairsOfWorlds.threads() == block_bvh::THREADS);
const _: () = assert!(Id::ListOverlaps.threads() == block_bvh::THREADS);
const _: () = assert!(Id::ListOverlapsBySubgroups.threads() == block_bvh::THREADS);
const _: () = assert!(Id::ListCandidates.threads() == block_bvh::THREADS);
const _: () = assert!(Id::ListWanted.threads() == block_bvh::THREADS);
