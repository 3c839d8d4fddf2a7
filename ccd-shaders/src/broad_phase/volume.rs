//! What tells nodes of binary trees apart whose boxes overlap: nothing, or oriented boxes.
//!
//! Twin: on a CPU `tree/traversal/`, whose traversals take the volume.

use crate::records::{NodeWords, ObbWords};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::sets;
use ccd_core::backend::broad_phase::oriented_nodes::{only_reaching, reach, reaches};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::kernel::memory::Stored;
use ccd_core::backend::layout::EDGE_EDGE;
use ccd_core::backend::layout::{Node, NodeDescent, Params};

/// The volume of nodes. A kernel passes on a slice of `More`: a record a node of each tree, at the
/// place of the set's boxes; or nodes `N`, of which no use is made.
pub(super) trait Volume {
    type More<N>;

    /// Of pairs of nodes whose boxes overlap, those that meet.
    fn only_meeting(
        params: &Params<NodeDescent>,
        all: [NodePair; 4],
        a: &[Node],
        b: &[Node],
        more: &[Self::More<Node>],
    ) -> [NodePair; 4];

    /// Whether a pair of nodes whose boxes overlap meets.
    fn meets(
        params: &Params<NodeDescent>,
        pair: NodePair,
        a: &[Node],
        b: &[Node],
        more: &[Self::More<Node>],
    ) -> bool;

    /// Whether a box may overlap leaves below the node at a place.
    fn reaches(query: &Aabb, place: u32, more: &[Self::More<NodeWords>]) -> bool;
}

/// Axis-aligned boxes alone.
pub(super) struct Boxes;

impl Volume for Boxes {
    type More<N> = N;

    #[inline(always)]
    fn only_meeting(
        _: &Params<NodeDescent>,
        all: [NodePair; 4],
        _: &[Node],
        _: &[Node],
        _: &[Node],
    ) -> [NodePair; 4] {
        all
    }

    #[inline(always)]
    fn meets(_: &Params<NodeDescent>, _: NodePair, _: &[Node], _: &[Node], _: &[Node]) -> bool {
        true
    }

    #[inline(always)]
    fn reaches(_: &Aabb, _: u32, _: &[NodeWords]) -> bool {
        true
    }
}

/// Oriented boxes of all nodes of all trees besides.
pub(super) struct Oriented;

impl Volume for Oriented {
    type More<N> = ObbWords;

    #[inline(always)]
    fn only_meeting(
        params: &Params<NodeDescent>,
        all: [NodePair; 4],
        a: &[Node],
        b: &[Node],
        more: &[ObbWords],
    ) -> [NodePair; 4] {
        let within = params.args.kind == EDGE_EDGE;
        only_reaching(within, all, internal(params), first(params), a, b, more, more)
    }

    #[inline(always)]
    fn meets(
        params: &Params<NodeDescent>,
        pair: NodePair,
        a: &[Node],
        b: &[Node],
        more: &[ObbWords],
    ) -> bool {
        reach(
            params.args.kind == EDGE_EDGE,
            pair,
            internal(params),
            first(params),
            a,
            b,
            more,
            more,
        )
    }

    #[inline(always)]
    fn reaches(query: &Aabb, place: u32, more: &[ObbWords]) -> bool {
        reaches(&ObbWords::load(more, place as usize), query)
    }
}

/// Internal nodes of either tree.
#[inline(always)]
pub(super) fn internal(params: &Params<NodeDescent>) -> [u32; 2] {
    let [set_a, set_b] = sets(params.args.kind);
    [params.frame.count[set_a] - 1, params.frame.count[set_b] - 1]
}

/// First places of either tree.
#[inline(always)]
fn first(params: &Params<NodeDescent>) -> [u32; 2] {
    let [set_a, set_b] = sets(params.args.kind);
    [params.frame.start[set_a], params.frame.start[set_b]]
}
