//! Records in words of two and four numbers, which a device reads and writes in one piece each. The
//! fields are those of `ccd_core::backend::layout`, in their order.

use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::end_slot;
use ccd_core::backend::broad_phase::node_numbering;
use ccd_core::backend::kernel::memory::{Stored, at, put};
use ccd_core::backend::layout::{Branch, Cluster, Leaf, Path, WideNode};
use ccd_core::math::obb::Obb;
use spirv_std::glam::{UVec4, Vec2, Vec4};

/// An [`Aabb`].
#[derive(Clone, Copy)]
#[repr(C)]
pub struct BoxWords {
    low: Vec2,
    middle: Vec2,
    high: Vec2,
}

impl BoxWords {
    /// The words of a box.
    #[inline(always)]
    pub fn of(b: &Aabb) -> Self {
        Self {
            low: Vec2::new(b.min[0], b.min[1]),
            middle: Vec2::new(b.min[2], b.max[0]),
            high: Vec2::new(b.max[1], b.max[2]),
        }
    }
}

impl Stored<Aabb> for BoxWords {
    #[inline(always)]
    fn load(slice: &[Self], i: usize) -> Aabb {
        let w = at(slice, i);
        Aabb { min: [w.low.x, w.low.y, w.middle.x], max: [w.middle.y, w.high.x, w.high.y] }
    }
}

/// Box `i`.
#[inline(always)]
pub fn box_at(boxes: &[BoxWords], i: usize) -> Aabb {
    <BoxWords as Stored<Aabb>>::load(boxes, i)
}

/// Boxes of leaf `i` at the start and at the end of a step.
#[inline(always)]
pub fn ends_at(ends: &[Vec4], i: usize) -> (Aabb, Aabb) {
    let (p, q) = (at(ends, end_slot(i, 0)), at(ends, end_slot(i, 1)));
    let r = at(ends, end_slot(i, 2));
    let start = Aabb { min: [p.x, p.y, p.z], max: [p.w, q.x, q.y] };
    (start, Aabb { min: [q.z, q.w, r.x], max: [r.y, r.z, r.w] })
}

/// Puts them there.
#[inline(always)]
pub fn put_ends(ends: &mut [Vec4], i: usize, start: &Aabb, end: &Aabb) {
    let (a, b, c, d) = (start.min, start.max, end.min, end.max);
    put(ends, end_slot(i, 0), Vec4::new(a[0], a[1], a[2], b[0]));
    put(ends, end_slot(i, 1), Vec4::new(b[1], b[2], c[0], c[1]));
    put(ends, end_slot(i, 2), Vec4::new(c[2], d[0], d[1], d[2]));
}

/// The words of a [`Leaf`].
#[inline(always)]
pub fn leaf_words(leaf: &Leaf) -> UVec4 {
    UVec4::new(leaf.vertices[0], leaf.vertices[1], leaf.vertices[2], leaf.id)
}

/// Leaf `i`.
#[inline(always)]
pub fn leaf_at(leaves: &[UVec4], i: usize) -> Leaf {
    let w = at(leaves, i);
    Leaf { vertices: [w.x, w.y, w.z], id: w.w }
}

/// A [`Path`].
#[derive(Clone, Copy)]
#[repr(C)]
pub struct PathWords {
    t0: Vec4,
    t1: Vec4,
}

impl Stored<Path> for PathWords {
    #[inline(always)]
    fn load(slice: &[Self], i: usize) -> Path {
        let PathWords { t0, t1 } = at(slice, i);
        Path { t0: [t0.x, t0.y, t0.z, t0.w], t1: [t1.x, t1.y, t1.z, t1.w] }
    }
}

/// Branch `i`.
#[inline(always)]
pub fn branch_at(branches: &[UVec4], i: usize) -> Branch {
    let w = at(branches, i);
    Branch { left: w.x, right: w.y, first: w.z, last: w.w }
}

/// The words of a [`Branch`].
#[inline(always)]
pub fn branch_words(branch: &Branch) -> UVec4 {
    UVec4::new(branch.left, branch.right, branch.first, branch.last)
}

/// A [`WideNode`].
#[derive(Clone, Copy)]
#[repr(C)]
pub struct NodeWords {
    left_min: UVec4,
    left_max: UVec4,
    right_min: UVec4,
    right_max: UVec4,
}

impl NodeWords {
    /// The words of a node.
    #[inline(always)]
    pub fn of(node: &WideNode) -> Self {
        Self {
            left_min: words(node.left_min, node.unused),
            left_max: words(node.left_max, node.unused_too),
            right_min: words(node.right_min, node.split),
            right_max: words(node.right_max, node.flags),
        }
    }
}

/// Node `i`.
#[inline(always)]
pub fn node_at(nodes: &[NodeWords], i: usize) -> WideNode {
    let w = at(nodes, i);
    WideNode {
        left_min: corner(w.left_min),
        unused: w.left_min.w,
        left_max: corner(w.left_max),
        unused_too: w.left_max.w,
        right_min: corner(w.right_min),
        split: w.right_min.w,
        right_max: corner(w.right_max),
        flags: w.right_max.w,
    }
}

#[inline(always)]
fn words(corner: [f32; 3], word: u32) -> UVec4 {
    UVec4::new(corner[0].to_bits(), corner[1].to_bits(), corner[2].to_bits(), word)
}

#[inline(always)]
fn corner(w: UVec4) -> [f32; 3] {
    [f32::from_bits(w.x), f32::from_bits(w.y), f32::from_bits(w.z)]
}

/// A [`Cluster`].
#[derive(Clone, Copy)]
#[repr(C)]
pub struct ClusterWords {
    low: UVec4,
    high: UVec4,
}

impl ClusterWords {
    /// The words of a cluster.
    #[inline(always)]
    pub fn of(cluster: &Cluster) -> Self {
        Self { low: words(cluster.min, cluster.node), high: words(cluster.max, cluster.leaves) }
    }
}

/// Cluster `i`.
#[inline(always)]
pub fn cluster_at(clusters: &[ClusterWords], i: u32) -> Cluster {
    let w = at(clusters, i as usize);
    Cluster { min: corner(w.low), node: w.low.w, max: corner(w.high), leaves: w.high.w }
}

/// Writes the words that change when `parent` becomes the parent of two nodes; see
/// `ccd_core::backend::broad_phase::node_numbering`.
#[inline(always)]
pub fn put_join(joins: &mut [u32], parent: u32, children: [u32; 2], leaves: [u32; 2]) {
    let [a, b, c, d, e, f] = node_numbering::join_words(parent, children, leaves);
    put(joins, a.0, a.1);
    put(joins, b.0, b.1);
    put(joins, c.0, c.1);
    put(joins, d.0, d.1);
    put(joins, e.0, e.1);
    put(joins, f.0, f.1);
}

/// Likewise, when `node` becomes the root.
#[inline(always)]
pub fn put_root(joins: &mut [u32], node: u32) {
    let [a, b] = node_numbering::root_words(node);
    put(joins, a.0, a.1);
    put(joins, b.0, b.1);
}

/// An [`Obb`], and a word that is not used.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct ObbWords {
    first: Vec4,
    second: Vec4,
    third: Vec4,
    last: Vec4,
}

impl ObbWords {
    /// The words of a box.
    #[inline(always)]
    pub fn of(b: &Obb) -> Self {
        let ([c, h], [p, q, r]) = ([b.centre, b.half], b.axes);
        Self {
            first: Vec4::new(c[0], c[1], c[2], p[0]),
            second: Vec4::new(p[1], p[2], q[0], q[1]),
            third: Vec4::new(q[2], r[0], r[1], r[2]),
            last: Vec4::new(h[0], h[1], h[2], 0.0),
        }
    }
}

impl Stored<Obb> for ObbWords {
    #[inline(always)]
    fn load(slice: &[Self], i: usize) -> Obb {
        let w = at(slice, i);
        Obb {
            centre: [w.first.x, w.first.y, w.first.z],
            axes: [
                [w.first.w, w.second.x, w.second.y],
                [w.second.z, w.second.w, w.third.x],
                [w.third.y, w.third.z, w.third.w],
            ],
            half: [w.last.x, w.last.y, w.last.z],
        }
    }
}
