//! Map: boxes that enclose a primitive over the whole step, rounded outward to `f32`.
//!
//! Vertices move on straight lines, so the box of both ends holds the whole path; edges and faces are unions of their vertices.

use crate::kernel::memory::at;
use crate::layout::Path;
use crate::math::aabb::Aabb;
use crate::math::real::Real;
use crate::math::vec3::lerp;

/// Box of vertex `i` from positions at `t = 0` and `t = 1`, grown by `margin >= 0`.
#[inline]
pub fn vertex<R: Real>(i: usize, x0: &[[R; 3]], x1: &[[R; 3]], margin: R) -> Aabb<f32> {
    swept(x0[i], x1[i]).inflated(margin).round_out()
}

/// Box of a path, grown by `margin >= 0`.
#[inline(always)]
pub fn path(path: &Path, margin: f32) -> Aabb<f32> {
    let (p, q) = (path.t0, path.t1);
    swept([p[0], p[1], p[2]], [q[0], q[1], q[2]]).inflated(margin).round_out()
}

/// A path up to time `until` in `[0, 1]`; its end is off by at most four roundings of numbers no greater than twice the coordinates.
#[inline(always)]
pub fn shorten(path: &Path, until: f32) -> Path {
    let (p, q) = (path.t0, path.t1);
    let end = lerp([p[0], p[1], p[2]], [q[0], q[1], q[2]], until);
    Path { t0: p, t1: [end[0], end[1], end[2], 0.0] }
}

/// Box of the path from `p` to `q`, in the precision of the coordinates.
#[inline]
pub fn swept<R: Real>(p: [R; 3], q: [R; 3]) -> Aabb<R> {
    Aabb::of_point(p).union(&Aabb::of_point(q))
}

/// Box of edge `i` from the boxes of all vertices.
#[inline]
pub fn edge<B: Copy + Real>(i: usize, edges: &[[u32; 2]], vertices: &[Aabb<B>]) -> Aabb<B> {
    let [a, b] = at(edges, i);
    at(vertices, a as usize).union(&at(vertices, b as usize))
}

/// Box of face `i` from the boxes of all vertices.
#[inline]
pub fn face<B: Copy + Real>(i: usize, faces: &[[u32; 3]], vertices: &[Aabb<B>]) -> Aabb<B> {
    let [a, b, c] = at(faces, i);
    at(vertices, a as usize).union(&at(vertices, b as usize)).union(&at(vertices, c as usize))
}
