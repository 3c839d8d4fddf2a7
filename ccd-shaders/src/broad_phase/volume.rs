//! Two binary trees whose pairs of nodes are descended, and the volume of their nodes: axis-aligned
//! boxes, or oriented boxes besides.
//!
//! Twin: on a CPU `tree/traversal/`, whose traversals take the volume.

use crate::records::ObbWords;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::sets;
use ccd_core::backend::broad_phase::oriented_nodes::{only_reaching, reach, reaches};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::kernel::memory::{Stored, at};
use ccd_core::backend::layout::{EDGE_EDGE, Node, NodeDescent, Pair, Params};
use ccd_core::model::method::Descent;

/// What becomes of a pair of nodes: it is expanded, it is one of leaves, or it is apart and belongs
/// to the front, if one is kept. 0: no pair.
pub(super) const INNER: u32 = 1;
pub(super) const LEAF: u32 = 2;
pub(super) const APART: u32 = 3;

/// The volume of nodes, which tells some apart whose boxes overlap.
pub(super) trait Volume: Copy {
    /// Of pairs of nodes whose boxes overlap, those that meet.
    fn only_meeting(trees: BinaryTrees<Self>, all: [NodePair; 4]) -> [NodePair; 4];

    /// Whether a pair of nodes whose boxes overlap meets.
    fn meets(trees: BinaryTrees<Self>, pair: NodePair) -> bool;

    /// Whether a box may overlap leaves below the node at a place.
    fn reaches(self, query: &Aabb, place: u32) -> bool;
}

/// Axis-aligned boxes alone.
#[derive(Clone, Copy)]
pub(super) struct Boxes;

impl Volume for Boxes {
    #[inline(always)]
    fn only_meeting(_: BinaryTrees<Self>, all: [NodePair; 4]) -> [NodePair; 4] {
        all
    }

    #[inline(always)]
    fn meets(_: BinaryTrees<Self>, _: NodePair) -> bool {
        true
    }

    #[inline(always)]
    fn reaches(self, _: &Aabb, _: u32) -> bool {
        true
    }
}

/// Oriented boxes besides: a record for each node of each tree, at the place of the set's box.
#[derive(Clone, Copy)]
pub(super) struct Oriented<'a>(pub &'a [ObbWords]);

impl Volume for Oriented<'_> {
    #[inline(always)]
    fn only_meeting(trees: BinaryTrees<Self>, all: [NodePair; 4]) -> [NodePair; 4] {
        let BinaryTrees { a, b, volume: Self(boxes), .. } = trees;
        let (internal, first) = (trees.internal(), trees.first());
        only_reaching(trees.within(), all, internal, first, a, b, boxes, boxes)
    }

    #[inline(always)]
    fn meets(trees: BinaryTrees<Self>, pair: NodePair) -> bool {
        let BinaryTrees { a, b, volume: Self(boxes), .. } = trees;
        let (internal, first) = (trees.internal(), trees.first());
        reach(trees.within(), pair, internal, first, a, b, boxes, boxes)
    }

    #[inline(always)]
    fn reaches(self, query: &Aabb, place: u32) -> bool {
        reaches(&ObbWords::load(self.0, place as usize), query)
    }
}

/// Two binary trees, or one given twice.
#[derive(Clone, Copy)]
pub(super) struct BinaryTrees<'a, V> {
    pub params: &'a Params<NodeDescent>,
    pub a: &'a [Node],
    pub b: &'a [Node],
    pub volume: V,
}

impl<V: Volume> BinaryTrees<'_, V> {
    /// Whether pairs are looked for within one tree.
    #[inline(always)]
    pub fn within(self) -> bool {
        self.params.args.kind == EDGE_EDGE
    }

    /// Which nodes of a pair are replaced by their children.
    #[inline(always)]
    pub fn rule(self) -> Descent {
        if self.params.args.larger != 0 { Descent::Larger } else { Descent::Both }
    }

    /// Number of internal nodes of either tree.
    #[inline(always)]
    pub fn internal(self) -> [u32; 2] {
        let [set_a, set_b] = sets(self.params.args.kind);
        [self.params.frame.count[set_a] - 1, self.params.frame.count[set_b] - 1]
    }

    /// First box of the set of either tree.
    #[inline(always)]
    fn first(self) -> [u32; 2] {
        let [set_a, set_b] = sets(self.params.args.kind);
        [self.params.frame.start[set_a], self.params.frame.start[set_b]]
    }

    /// The nodes of a pair.
    #[inline(always)]
    pub fn nodes(self, pair: NodePair) -> (Node, Node) {
        (at(self.a, pair[0] as usize), at(self.b, pair[1] as usize))
    }

    /// The ids of a pair of leaves.
    #[inline(always)]
    pub fn ids(self, pair: NodePair) -> Pair {
        let (a, b) = (at(self.a, pair[0] as usize).left, at(self.b, pair[1] as usize).left);
        if self.within() { Pair::ordered(a, b) } else { Pair { a, b } }
    }
}

/// What becomes of a pair of nodes that meets, or of none.
#[inline(always)]
pub(super) fn fate(pair: NodePair, internal: [u32; 2]) -> u32 {
    if pair[0] == NONE {
        0
    } else if pair[0] >= internal[0] && pair[1] >= internal[1] {
        LEAF
    } else {
        INNER
    }
}
