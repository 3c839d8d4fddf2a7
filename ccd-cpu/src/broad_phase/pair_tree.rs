//! A tree of pairs: the pairs of nodes that a simultaneous traversal of two hierarchies visits,
//! each the parent of the overlapping pairs of its children. Any scheduler can run it.

use crate::broad_phase::pair_source::PairSink;
use crate::simd::RowSimd;

/// Two hierarchies, or one with itself, seen as a tree whose nodes are pairs of theirs.
///
/// What takes an instruction set must be `#[inline(always)]`, or it is not enabled inside.
pub trait PairTree: Copy + Sync {
    /// A pair of nodes.
    type Pair: Copy + Send + Sync;
    /// Appends the pairs at which traversal begins.
    fn roots(self, out: &mut Vec<Self::Pair>);
    /// Whether a pair has no children but rows of leaves.
    fn is_leaf(self, pair: Self::Pair) -> bool;
    /// Appends the overlapping pairs of children of a pair that is no leaf.
    fn expand<S: RowSimd>(self, simd: S, pair: Self::Pair, out: &mut Vec<Self::Pair>);
    /// Hands the rows of a leaf pair to the sink.
    fn rows<S: RowSimd, K: PairSink>(self, simd: S, pair: Self::Pair, sink: &K, worker: &mut K::Worker);
}
