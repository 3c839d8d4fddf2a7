//! A tree of pairs: the pairs of nodes that a simultaneous traversal of two hierarchies visits,
//! each the parent of the overlapping pairs of its children. Any scheduler can run it.
//!
//! Twin: of ccd-shaders `scheduler/worker.rs`, whose workers are written over such trees.

use crate::broad_phase::pair_source::PairSink;
use crate::simd::RowSimd;
use ccd_core::backend::broad_phase::pair_descent::NodePair;

/// Two hierarchies, or one with itself, seen as a tree whose nodes are pairs of theirs: two words,
/// whatever the hierarchies are.
///
/// What takes an instruction set must be `#[inline(always)]`, or it is not enabled inside.
pub trait PairTree: Copy + Sync {
    /// Whether a pair has no children but rows of leaves.
    fn is_leaf(self, pair: NodePair) -> bool;
    /// Appends the overlapping pairs of children of a pair that is no leaf.
    fn expand<S: RowSimd>(self, simd: S, pair: NodePair, out: &mut Vec<NodePair>);
    /// Hands the rows of a leaf pair to the sink.
    fn rows<S: RowSimd, K: PairSink>(
        self,
        simd: S,
        pair: NodePair,
        sink: &K,
        worker: &mut K::Worker,
    );
}
