//! Records that cross between host and device: `u32` and `[f32; N]` fields only, sizes asserted
//! here.

use crate::math::aabb::Aabb;
use bytemuck::{Pod, Zeroable};

/// A candidate pair of primitives: two vertices' or edges' ids, or a vertex id and a face id.
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

/// An internal node of a binary tree with the boxes of both children: see
/// [`wide_nodes`](crate::broad_phase::wide_nodes).
///
/// | field | bytes | | field | bytes |
/// |---|---|---|---|---|
/// | `left_min` | 0..12 | | `right_min` | 32..44 |
/// | `left` | 12..16 | | `split` | 44..48 |
/// | `left_max` | 16..28 | | `right_max` | 48..60 |
/// | `right` | 28..32 | | `last` | 60..64 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct WideNode {
    /// Smallest corner of the left child's box.
    pub left_min: [f32; 3],
    /// The left child: an internal node, or, with [`WideNode::MARK`], a leaf.
    pub left: u32,
    /// Greatest corner of the left child's box.
    pub left_max: [f32; 3],
    /// The right child, likewise.
    pub right: u32,
    /// Smallest corner of the right child's box.
    pub right_min: [f32; 3],
    /// Last leaf below the left child.
    pub split: u32,
    /// Greatest corner of the right child's box.
    pub right_max: [f32; 3],
    /// Last leaf below the node; with [`WideNode::MARK`] if the left child has fewer leaves.
    pub last: u32,
}

impl WideNode {
    /// The bit that numbers of nodes do not use.
    pub const MARK: u32 = 1 << 31;

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

/// A contact as a device writes it.
///
/// | field | bytes |
/// |---|---|
/// | `kind` | 0..4 |
/// | `state` | 4..8 |
/// | `a` | 8..12 |
/// | `b` | 12..16 |
/// | `toi` | 16..24 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Touch {
    /// 0: vertex-face, 1: edge-edge.
    pub kind: u32,
    /// 0: certain, 1: undecided.
    pub state: u32,
    /// The vertex, or the lesser edge.
    pub a: u32,
    /// The face, or the greater edge.
    pub b: u32,
    /// Time of impact: the bits of an `f64`, low word first.
    pub toi: [u32; 2],
}

/// 2^32. Products and quotients, because a shader language counts the bits of a shift in 32 bits
/// and translators forget that.
const TWO_32: u64 = 1 << 32;

/// An `f64` from its bits, low word first.
#[inline(always)]
pub fn join(words: [u32; 2]) -> f64 {
    f64::from_bits(words[1] as u64 * TWO_32 + words[0] as u64)
}

/// The bits of an `f64`, low word first.
#[inline(always)]
pub fn split(x: f64) -> [u32; 2] {
    let bits = x.to_bits();
    [bits as u32, (bits / TWO_32) as u32]
}

/// Words before the first entry of a list that a device writes: the number of entries wanted, which
/// may exceed the room; the number of candidates looked at; how often each of the two exceeded 32
/// bits.
pub const LIST_HEADER: usize = 4;

/// Words of a [`Touch`].
pub const TOUCH_WORDS: usize = size_of::<Touch>() / 4;

/// Levels of a block tree: `32^7` exceeds every number of boxes, and level 0 is the boxes.
pub const MAX_LEVELS: usize = 8;

/// What kernels are told besides their buffers: what is the same for a whole frame, what one
/// dispatch is about, and a record of one algorithm, one after the other without gaps, because all
/// are made of 32-bit words.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct Params<A = Plain> {
    /// Of the frame.
    pub frame: Frame,
    /// Of the dispatch.
    pub dispatch: Dispatch,
    /// Of the algorithm.
    pub own: A,
}

impl<A: Pod> Params<A> {
    /// The bytes of each part, in their order.
    pub fn parts(&self) -> [&[u8]; 3] {
        let Self { frame, dispatch, own } = self;
        [bytemuck::bytes_of(frame), bytemuck::bytes_of(dispatch), bytemuck::bytes_of(own)]
    }
}

/// What a frame says to every kernel. Sets are numbered 0: vertices, 1: edges, 2: faces.
///
/// | field | bytes | | field | bytes |
/// |---|---|---|---|---|
/// | `count` | 0..12 | | `min_distance` | 40..44 |
/// | `flags` | 12..16 | | `slack` | 44..48 |
/// | `start` | 16..32 | | `distance_bits` | 48..56 |
/// | `margin` | 32..36 | | `origin` | 56..80 |
/// | `path_error` | 36..40 | | `margin_bits` | 80..88 |
/// | | | | `scale_bits` | 88..96 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Frame {
    /// Boxes of each set.
    pub count: [u32; 3],
    /// The `FLAG_` constants of this type.
    pub flags: u32,
    /// First box of each set among all boxes, then their number.
    pub start: [u32; 4],
    /// By how much boxes of paths are grown, in the unit of paths.
    pub margin: f32,
    /// How far a coordinate of a [`Path`] may be from the true one, in the unit of paths.
    pub path_error: f32,
    /// Contact means at most this distance, in the unit of paths; rounded up.
    pub min_distance: f32,
    /// Boxes that overlap by less may overlap only because they were rounded.
    pub slack: f32,
    /// The minimum distance as bits of an `f64`, low word first.
    pub distance_bits: [u32; 2],
    /// What is subtracted from positions before they become `f32`: bits of `f64`, low words first.
    pub origin: [[u32; 2]; 3],
    /// By how much exact boxes are grown: bits of an `f64`, low word first.
    pub margin_bits: [u32; 2],
    /// By what positions are multiplied before they become `f32`, a power of two: bits of an `f64`,
    /// low word first. See [`Table`](crate::model::quantization::Table).
    pub scale_bits: [u32; 2],
}

impl Frame {
    /// Features that share a vertex are no pair.
    pub const FLAG_TOPOLOGY: u32 = 1;
    /// Bodies select pairs.
    pub const FLAG_BODIES: u32 = 2;
    /// Features of one body are a pair, too.
    pub const FLAG_SELF_CONTACT: u32 = 4;
    /// Paths are exact: there are no wider ones.
    pub const FLAG_EXACT: u32 = 8;
    /// Contacts are kept; else only the earliest time of impact.
    pub const FLAG_KEEP: u32 = 16;
    /// Overlap that rounding may have made is looked at again, by the keys of the exact bounds.
    pub const FLAG_CONFIRM: u32 = 32;

    /// Whether a flag is set.
    #[inline(always)]
    pub fn has(&self, flag: u32) -> bool {
        self.flags & flag != 0
    }
}

/// What a dispatch says: which items it is about, and the rooms of the lists that it reads and
/// writes.
///
/// | field | bytes |
/// |---|---|
/// | `n` | 0..4 |
/// | `first` | 4..8 |
/// | `room_in` | 8..12 |
/// | `room_out` | 12..16 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Dispatch {
    /// Items of a map.
    pub n: u32,
    /// The first of them, or the first entry of a list that is looked at.
    pub first: u32,
    /// Entries that the list which is read has room for.
    pub room_in: u32,
    /// Entries that the list which is written has room for.
    pub room_out: u32,
}

/// No record: for kernels that need no more than [`Frame`] and [`Dispatch`]. Shaders have no
/// structure without a member.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Plain {
    unused: u32,
}

/// What kernels of the block tree are told: where its nodes are, and which of them a dispatch is
/// about.
///
/// | field | bytes |
/// |---|---|
/// | `slots` | 0..128 |
/// | `kind` | 128..132 |
/// | `level` | 132..136 |
/// | `step` | 136..140 |
/// | `limit` | 140..144 |
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Blocks {
    /// First node of each set on each level, then the first of the next level.
    pub slots: [[u32; 4]; MAX_LEVELS],
    /// 0: vertices against faces, 1: edges against edges; the set, for a kernel that is about one.
    pub kind: u32,
    /// Level that a kernel reads.
    pub level: u32,
    /// Every so many-th entry of the list that is read is looked at.
    pub step: u32,
    /// Entries that a dispatch looks at, at most.
    pub limit: u32,
}

/// What a traversal of a binary tree is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Queries {
    /// 0: vertices against faces, 1: edges against edges; the tree is over the second.
    pub kind: u32,
    /// 1: queries in the order of leaves, 0: in that of input.
    pub sorted: u32,
}

/// What the kernels of methods by keys are told; see
/// [`key_intervals`](crate::broad_phase::key_intervals).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Intervals {
    /// A constant of that module.
    pub method: u32,
    /// 0: vertices against faces, 1: edges against edges.
    pub kind: u32,
    /// Which intervals.
    pub row: u32,
    /// By set: above this number of boxes in the cells around those of a sample nothing is done.
    pub most: [u32; 3],
}

/// What the descent of pairs of nodes is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct NodeDescent {
    /// 0: vertices against faces, 1: edges against edges; the set, for a kernel that is about one.
    pub kind: u32,
    /// 1: the larger of two nodes into its children, 0: both.
    pub larger: u32,
    /// Nodes of a cut.
    pub nodes: u32,
    /// Entries that the list of pairs of nodes has room for.
    pub room_nodes: u32,
}

/// What one pass of the radix sort is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct SortPass {
    /// Lowest bit of the digit that is sorted by.
    pub shift: u32,
    /// Tiles of the sort.
    pub n_tiles: u32,
}

/// What the kernels that decide in `f32` are told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct Decision {
    /// Entries that the list of undecided pairs has room for.
    pub room_open: u32,
}

/// What the keys of contacts depend on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
#[repr(C)]
pub struct ContactSort {
    /// Which of two sorts: 0 by `b`, 1 by kind and `a`.
    pub pass: u32,
}

const _: () = assert!(size_of::<WideNode>() == 64);
const _: () = assert!(size_of::<Path>() == 32 && size_of::<Leaf>() == 16);
const _: () = assert!(size_of::<Touch>() == 24 && size_of::<Frame>() == 96);
const _: () = assert!(size_of::<Dispatch>() == 16 && size_of::<Blocks>() == 144);
const _: () = assert!(size_of::<SortPass>() == 8 && size_of::<Plain>() == 4);
const _: () = assert!(size_of::<Queries>() == 8 && size_of::<Intervals>() == 24);
const _: () = assert!(size_of::<NodeDescent>() == 16);
const _: () = assert!(size_of::<Decision>() == 4 && size_of::<ContactSort>() == 4);
const _: () = assert!(size_of::<Params<Blocks>>() == 96 + 16 + 144);
const _: () = assert!(size_of::<Params>() == 96 + 16 + 4);
const _: () =
    assert!(size_of::<Pair>() == 8 && size_of::<Node>() == 32 && size_of::<Branch>() == 16);
