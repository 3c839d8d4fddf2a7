//! Map: the verdict of one candidate pair from the mesh's arrays.

use crate::layout::Pair;
use crate::motion::{Motion, Patch};
use crate::query::{Verdict, solve};
use crate::real::Real;

/// Positions of four vertices at one time.
#[inline]
pub fn gather<R: Copy>(ids: [u32; 4], x: &[[R; 3]]) -> [[R; 3]; 4] {
    [x[ids[0] as usize], x[ids[1] as usize], x[ids[2] as usize], x[ids[3] as usize]]
}

/// The vertex ids `v f0 f1 f2` of a vertex-face pair.
#[inline]
pub fn vertex_face_ids(pair: Pair, faces: &[[u32; 3]]) -> [u32; 4] {
    let [f0, f1, f2] = faces[pair.b as usize];
    [pair.a, f0, f1, f2]
}

/// The vertex ids `ea0 ea1 eb0 eb1` of an edge-edge pair.
#[inline]
pub fn edge_edge_ids(pair: Pair, edges: &[[u32; 2]]) -> [u32; 4] {
    let ([a0, a1], [b0, b1]) = (edges[pair.a as usize], edges[pair.b as usize]);
    [a0, a1, b0, b1]
}

/// Verdict of a vertex-face pair; every coordinate may be off by `coordinate_error`.
pub fn vertex_face<R: Real>(ids: [u32; 4], x0: &[[R; 3]], x1: &[[R; 3]], min_distance: R, coordinate_error: R) -> Verdict<R> {
    let m = Motion::vertex_face(&gather(ids, x0), &gather(ids, x1), coordinate_error);
    solve(&m, Patch::Triangle, min_distance)
}

/// Verdict of an edge-edge pair; every coordinate may be off by `coordinate_error`.
pub fn edge_edge<R: Real>(ids: [u32; 4], x0: &[[R; 3]], x1: &[[R; 3]], min_distance: R, coordinate_error: R) -> Verdict<R> {
    let m = Motion::edge_edge(&gather(ids, x0), &gather(ids, x1), coordinate_error);
    solve(&m, Patch::Parallelogram, min_distance)
}
