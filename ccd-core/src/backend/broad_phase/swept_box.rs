//! Map: boxes that enclose a primitive over the whole step, rounded outward to `f32`.
//!
//! Vertices move on straight lines, so the box of both ends holds the whole path; edges and faces
//! are unions of their vertices.

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
    let (p, q) = (Aabb::of_point([p[0], p[1], p[2]]), Aabb::of_point([q[0], q[1], q[2]]));
    of_ends(&p, &q, margin)
}

/// Box of a feature from its boxes at both ends, grown by `margin >= 0`: the union of the boxes of
/// its vertices' paths, because rounding keeps the order of bounds.
#[inline(always)]
pub fn of_ends(start: &Aabb<f32>, end: &Aabb<f32>, margin: f32) -> Aabb<f32> {
    start.union(end).inflated(margin).round_out()
}

/// Where a path from `p` to `q` is at time `until` in `[0, 1]`, up to [`end_error`].
#[inline(always)]
pub fn end<R: Real>(p: [R; 3], q: [R; 3], until: R) -> [R; 3] {
    lerp(p, q, until)
}

/// How far a coordinate of [`end`] may be from the true one, for coordinates up to `largest`: three
/// roundings of numbers up to two and three times that are below `8 u`; where denormals are
/// flushed, less than the smallest normal number for what is read and each of three results, and
/// once more for the start of the path where boxes read it.
#[inline(always)]
pub fn end_error<R: Real>(largest: R) -> R {
    largest * (R::UNIT * R::splat(16.0)) + R::MIN_NORMAL * R::splat(8.0)
}

/// A path from time `from` to time `until` in `[0, 1]`; its end, and its start unless that is the
/// path's own, are off by [`end_error`].
#[inline(always)]
pub fn shorten(path: &Path, from: f32, until: f32) -> Path {
    let (p, q) = (path.t0, path.t1);
    let (p, q) = ([p[0], p[1], p[2]], [q[0], q[1], q[2]]);
    let (start, end) = (if from > 0.0 { end(p, q, from) } else { p }, end(p, q, until));
    Path { t0: [start[0], start[1], start[2], 0.0], t1: [end[0], end[1], end[2], 0.0] }
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
    triangle(at(faces, i), vertices)
}

/// Box of the triangle of three vertices from the boxes of all.
#[inline]
pub fn triangle<B: Copy + Real>([a, b, c]: [u32; 3], vertices: &[Aabb<B>]) -> Aabb<B> {
    at(vertices, a as usize).union(&at(vertices, b as usize)).union(&at(vertices, c as usize))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::narrow_phase::cascade::boxes_at_ends;
    use crate::random::Random;

    #[test]
    fn boxes_of_features_are_those_of_their_vertices() {
        let mut random = Random::new(1);
        let scales = [0.0, 1e-45, 1e-38, 1.0, 1e30, f32::MAX];
        for i in 0..20_000 {
            let mut number = || {
                let scale = scales[random.below(scales.len() as u32) as usize];
                (2.0 * random.unit() - 1.0) as f32 * scale
            };
            let mut point = || [number(), number(), number(), 0.0];
            let paths = [(); 3].map(|()| Path { t0: point(), t1: point() });
            for margin in [0.0, 1e-45, 1e-7, 0.5, 1e30] {
                let boxes = [0, 1, 2].map(|v| path(&paths[v], margin));
                let vertices = if i % 2 == 0 { [0, 1, 2] } else { [0, 1, 1] };
                let (start, end) = boxes_at_ends(vertices, &paths);
                assert_eq!(of_ends(&start, &end, margin), triangle(vertices, &boxes), "{paths:?}");
            }
        }
    }
}
