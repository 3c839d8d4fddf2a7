//! Trees of pairs, as workers descend them: two binary trees, or the block trees of two sets; or
//! one of either with itself.
//!
//! A worker moves pairs of nodes, two words each, between its stack, lists and deques, and knows
//! nothing else of them. What one is, which children of it meet, and how many threads expand one,
//! is said by a type, because shaders have neither closures nor structures that hold views.

use super::shared::{Round, Shared, Stack};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::layout::{NodeDescent, Pair, Params};

/// What becomes of a pair that meets: it is expanded, or it is one of leaves.
pub(super) const INNER: u32 = 1;
pub(super) const LEAF: u32 = 2;
/// It is apart, and belongs to the front, if one is kept. 0: there is none.
pub(super) const APART: u32 = 3;

/// A tree of pairs. The nodes of both sides are slices that a kernel passes on, and `more` is what
/// tells more of them apart; where there is no such thing, and where both sides are in one buffer,
/// the same slice stands for both.
pub(super) trait PairTree {
    /// What its kernels are told.
    type Args: Copy;
    type Node;
    type More;
    /// Children that a thread found, and where they go.
    type Found: Copy;
    type Places: Copy;

    /// Pairs that a worker expands in a turn.
    const WIDTH: u32;

    /// What its kernels are told of any pairs.
    fn descent(args: &Self::Args) -> NodeDescent;

    /// On which of the pairs of a turn a thread works.
    fn index(lane: u32) -> u32;

    /// The first thread, before a turn.
    fn begin(shared: &mut Shared);

    /// The children of a pair that this thread is to find. All threads of a worker call it, also
    /// those that have [`NO_PAIR`](ccd_core::backend::broad_phase::pair_descent::NO_PAIR): there
    /// may be barriers in it.
    fn expand(
        params: &Params<Self::Args>,
        lane: u32,
        pair: NodePair,
        a: &[Self::Node],
        b: &[Self::Node],
        more: &[Self::More],
        shared: &mut Shared,
    ) -> Self::Found;

    /// Counts what a thread found in its worker.
    fn claim(found: Self::Found, capacity_front: u32, shared: &mut Shared) -> Self::Places;

    /// Writes it to where it belongs.
    #[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
    fn put_away(
        args: &NodeDescent,
        round: Round,
        found: Self::Found,
        to: Self::Places,
        a: &[Self::Node],
        b: &[Self::Node],
        shared: &Shared,
        stack: &mut Stack,
        nodes: &mut [u32],
        pairs: &mut [u32],
        front: &mut [u32],
    );

    /// What becomes of a pair.
    fn fate(
        params: &Params<Self::Args>,
        pair: NodePair,
        a: &[Self::Node],
        b: &[Self::Node],
        more: &[Self::More],
    ) -> u32;

    /// What the list of results has of a pair of leaves.
    fn result(args: &NodeDescent, pair: NodePair, a: &[Self::Node], b: &[Self::Node]) -> Pair;
}
