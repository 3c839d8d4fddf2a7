//! Records that cross between host and device: `u32` and `[f32; N]` fields only, sizes asserted here.

use crate::aabb::Aabb;
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

/// A node of a binary tree over `n` boxes: internal nodes are `0 .. n - 1`, leaves `n - 1 .. 2 n - 1` in Morton order.
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
    /// Left child; in a leaf, the id of its box.
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

/// What an internal node of the tree knows besides its box: children (node indices) and the range of leaves below it.
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

const _: () = assert!(size_of::<Pair>() == 8 && size_of::<Node>() == 32 && size_of::<Branch>() == 16);
