//! A tree of pairs: the pairs of nodes that a simultaneous traversal of two hierarchies visits,
//! each the parent of the overlapping pairs of its children. Any scheduler can run it.

use crate::broad_phase::front::Writer;
use crate::broad_phase::pair_source::PairSink;
use crate::simd::RowSimd;
use ccd_core::broad_phase::pair_descent::NodePair;

/// Two hierarchies, or one with itself, seen as a tree whose nodes are pairs of theirs: two words,
/// whatever the hierarchies are.
///
/// What takes an instruction set must be `#[inline(always)]`, or it is not enabled inside.
pub trait PairTree: Copy + Sync {
    /// Appends the pairs at which traversal begins.
    fn roots(self, out: &mut Vec<NodePair>);
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

/// Where a pair is, seen from the deepest front that there can be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Its children may be in a front.
    Above,
    /// It stays in every front that has come this far, and what is below it is found anew each
    /// time.
    At,
    /// It is never in a front.
    Below,
}

/// A tree of pairs that can be begun at a front.
pub trait FrontTree: PairTree {
    /// Whether a row of leaves comes once with all of its lanes, rather than in pieces.
    const WHOLE_ROWS: bool;
    /// Where a pair is.
    fn place(self, pair: NodePair) -> Place;
    /// Whether the volumes of both nodes overlap, and there is anything below the pair.
    fn meets(self, pair: NodePair) -> bool;
    /// As [`PairTree::expand`] of a pair above all fronts; children that are apart are written to
    /// the front. Those that can have no pair of leaves, whatever the boxes are, are in neither.
    fn expand_all<S: RowSimd>(
        self,
        simd: S,
        pair: NodePair,
        out: &mut Vec<NodePair>,
        front: &mut Writer,
    );
}
