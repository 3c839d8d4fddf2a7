//! Records that cross between host and device: `u32` and `[f32; N]` fields only, sizes asserted
//! here.

mod decision;
pub mod elements;
mod params;
mod touch;

pub use crate::math::f64_bits::{join, split};
pub use decision::{Decision, Filtering, IntegerDecision, Listing};
pub use params::{
    BlockDescent, Blocks, Building, Dispatch, Expansion, Frame, Intervals, NodeDescent, Params,
    Placing, Plain, Queries, SortPass, Worlds,
};
pub use touch::{PackedTouch, TOUCH_WORDS, Touch, TouchGeometry};

use crate::math::aabb::Aabb;
use bytemuck::{Pod, Zeroable};

/// A vertex and a face: [`Kind::VertexFace`](crate::model::contact::Kind) as a word.
pub const VERTEX_FACE: u32 = 0;
/// Two edges: [`Kind::EdgeEdge`](crate::model::contact::Kind) as a word.
pub const EDGE_EDGE: u32 = 1;

/// A candidate pair of primitives: two vertices' or edges' ids, or a vertex id and a face id.
///
/// ```
/// use ccd::Pair;
///
/// assert_eq!(Pair::ordered(7, 3), Pair { a: 3, b: 7 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Pod, Zeroable)]
#[repr(C)]
pub struct Pair {
    /// The vertex of a vertex-face pair, the lesser edge id of an edge-edge pair.
    pub a: u32,
    /// The face of a vertex-face pair, the greater edge id of an edge-edge pair.
    pub b: u32,
}

impl Pair {
    /// The pair of two items of one set, lesser id first.
    #[inline]
    pub fn ordered(a: u32, b: u32) -> Self {
        if a < b { Self { a, b } } else { Self { a: b, b: a } }
    }
}

/// A node of a binary tree over `n` boxes: internal nodes are `0 .. n - 1`, leaves
/// `n - 1 .. 2 n - 1` in Morton order.
///
/// | field | bytes |
/// |---|---|
/// | `min` | 0..12 |
/// | `left` | 12..16 |
/// | `max` | 16..28 |
/// | `right` | 28..32 |
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Node {
    /// Smallest corner of the node's box.
    pub min: [f32; 3],
    /// Left child; in a leaf, what a traversal finds: the id of its box, or its place among leaves.
    pub left: u32,
    /// Greatest corner of the node's box.
    pub max: [f32; 3],
    /// Right child; [`Node::LEAF`] in a leaf.
    pub right: u32,
}

impl Node {
    /// Marks a leaf in [`Node::right`].
    pub const LEAF: u32 = u32::MAX;

    /// The box of the node.
    #[inline]
    pub fn aabb(&self) -> Aabb<f32> {
        Aabb { min: self.min, max: self.max }
    }

    /// Whether the node is a leaf.
    #[inline]
    pub fn is_leaf(&self) -> bool {
        self.right == Self::LEAF
    }
}

/// What an internal node of the tree knows besides its box: children (node indices) and the range
/// of leaves below it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Branch {
    /// Left child.
    pub left: u32,
    /// Right child.
    pub right: u32,
    /// First leaf below (leaf number, from 0).
    pub first: u32,
    /// Last leaf below (leaf number, inclusive).
    pub last: u32,
}

/// A node of a binary tree that is being built bottom up.
///
/// | field | bytes |
/// |---|---|
/// | `min` | 0..12 |
/// | `node` | 12..16 |
/// | `max` | 16..28 |
/// | `leaves` | 28..32 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Cluster {
    /// Smallest corner of its box.
    pub min: [f32; 3],
    /// Its number as its builder counts: of `n - 1` internal nodes in any order, then of leaves.
    pub node: u32,
    /// Greatest corner of its box.
    pub max: [f32; 3],
    /// Leaves below it.
    pub leaves: u32,
}

impl Cluster {
    /// A node with this box.
    #[inline(always)]
    pub fn new(b: &Aabb<f32>, node: u32, leaves: u32) -> Self {
        Self { min: b.min, node, max: b.max, leaves }
    }

    /// The box of the node.
    #[inline(always)]
    pub fn aabb(&self) -> Aabb<f32> {
        Aabb { min: self.min, max: self.max }
    }
}

/// An internal node of a binary tree with the boxes of both children: see
/// [`wide_nodes`](crate::broad_phase::wide_nodes).
///
/// | field | bytes | | field | bytes |
/// |---|---|---|---|---|
/// | `left_min` | 0..12 | | `right_min` | 32..44 |
/// | | 12..16 | | `split` | 44..48 |
/// | `left_max` | 16..28 | | `right_max` | 48..60 |
/// | | 28..32 | | `flags` | 60..64 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct WideNode {
    /// Smallest corner of the left child's box.
    pub left_min: [f32; 3],
    /// Not used.
    pub unused: u32,
    /// Greatest corner of the left child's box.
    pub left_max: [f32; 3],
    /// Not used.
    pub unused_too: u32,
    /// Smallest corner of the right child's box.
    pub right_min: [f32; 3],
    /// Last leaf below the left child. The left child has this number, the right child the next.
    pub split: u32,
    /// Greatest corner of the right child's box.
    pub right_max: [f32; 3],
    /// [`WideNode::LEFT_IS_LEAF`] and so on.
    pub flags: u32,
}

impl WideNode {
    /// In [`WideNode::flags`]: the number of the left child is that of a leaf, not of a node.
    pub const LEFT_IS_LEAF: u32 = 1;
    /// The number of the right child is that of a leaf.
    pub const RIGHT_IS_LEAF: u32 = 2;
    /// The left child has fewer leaves than the right one.
    pub const LEFT_IS_SMALLER: u32 = 4;

    /// Whether a flag is set.
    #[inline(always)]
    pub fn has(&self, flag: u32) -> bool {
        self.flags & flag != 0
    }

    /// The box of the left child.
    #[inline(always)]
    pub fn left_box(&self) -> Aabb<f32> {
        Aabb { min: self.left_min, max: self.left_max }
    }

    /// The box of the right child.
    #[inline(always)]
    pub fn right_box(&self) -> Aabb<f32> {
        Aabb { min: self.right_min, max: self.right_max }
    }
}

/// Both ends of the path of a vertex, in `f32`, possibly recentred; the last component of each is
/// not used.
///
/// | field | bytes |
/// |---|---|
/// | `t0` | 0..16 |
/// | `t1` | 16..32 |
///
/// ```
/// use ccd_core::records::Path;
///
/// let path = Path { t0: [0.0, 1.0, 0.0, 0.0], t1: [0.0, -1.0, 0.0, 0.0] };
/// assert_eq!(bytemuck::bytes_of(&path).len(), 32);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Path {
    /// Position at the start of the step.
    pub t0: [f32; 4],
    /// Position at its end.
    pub t1: [f32; 4],
}

/// What a leaf of a block tree is besides its box.
///
/// | field | bytes |
/// |---|---|
/// | `vertices` | 0..12 |
/// | `id` | 12..16 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Leaf {
    /// Vertices of the feature; one that has fewer than three repeats its last.
    pub vertices: [u32; 3],
    /// Number of the feature among those of its kind; [`Leaf::NONE`] where there is none.
    pub id: u32,
}

impl Leaf {
    /// The id of a leaf that only fills up a block.
    pub const NONE: u32 = u32::MAX;
}

/// A triangle from which pairs of features are expanded: a face by its id, or one that stands for
/// what no face has, see [`triangle_pairs`](crate::backend::triangle_pairs).
///
/// | field | bytes |
/// |---|---|
/// | `corners` | 0..12 |
/// | `represents` | 12..16 |
/// | `sides` | 16..28 |
/// | `body` | 28..32 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Triangle {
    /// Its vertices.
    pub corners: [u32; 3],
    /// Bits 0 to 2: whether it represents that corner; bits 3 to 5: that side.
    pub represents: u32,
    /// Its edges, from corner 0 to 1, 1 to 2, 2 to 0; whatever from a vertex to itself.
    pub sides: [u32; 3],
    /// The word of its body; 0 without bodies.
    pub body: u32,
}

/// A test of two features whose representatives have a vertex in common: of an orphan, or of two
/// triangles that stand in.
///
/// | field | bytes |
/// |---|---|
/// | `pair` | 0..8 |
/// | `triangles` | 8..16 |
#[derive(Clone, Copy, Debug, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct NearTest {
    /// The features.
    pub pair: Pair,
    /// Those that stand in; of an orphan the representatives.
    pub triangles: Pair,
}

/// Words before the first entry of a list that a device writes: the number of entries wanted, which
/// may exceed the capacity; the number of candidates looked at; how often each of the two exceeded
/// 32 bits.
pub const LIST_HEADER: usize = 4;

/// Levels of a block tree: `32^7` exceeds every number of boxes, and level 0 is the boxes.
pub const MAX_LEVELS: usize = 8;

const _: () = assert!(size_of::<WideNode>() == 64 && size_of::<Cluster>() == 32);
const _: () = assert!(size_of::<Path>() == 32 && size_of::<Leaf>() == 16);
const _: () = assert!(size_of::<Triangle>() == 32 && size_of::<NearTest>() == 16);
const _: () = assert!(size_of::<Pair>() == 8);
const _: () = assert!(size_of::<Node>() == 32 && size_of::<Branch>() == 16);
