//! Map: the verdict of one candidate pair from the mesh's arrays.

use crate::layout::Pair;
use crate::motion::{Motion, Patch};
use crate::query::{Verdict, solve};
use crate::real::Real;
use crate::slice::at;

/// Positions of four vertices at one time, in the precision `R` of the arithmetic.
#[inline]
pub fn gather<T: Copy + Into<R>, R: Real>(ids: [u32; 4], x: &[[T; 3]]) -> [[R; 3]; 4] {
    let mut out = [[R::splat(0.0); 3]; 4];
    for i in 0..4 {
        let p = at(x, ids[i] as usize);
        out[i] = [p[0].into(), p[1].into(), p[2].into()];
    }
    out
}

/// The vertex ids `v f0 f1 f2` of a vertex-face pair.
#[inline(always)]
pub fn vertex_face_ids(pair: Pair, faces: &[[u32; 3]]) -> [u32; 4] {
    let [f0, f1, f2] = at(faces, pair.b as usize);
    [pair.a, f0, f1, f2]
}

/// The vertex ids `ea0 ea1 eb0 eb1` of an edge-edge pair.
#[inline(always)]
pub fn edge_edge_ids(pair: Pair, edges: &[[u32; 2]]) -> [u32; 4] {
    let ([a0, a1], [b0, b1]) = (at(edges, pair.a as usize), at(edges, pair.b as usize));
    [a0, a1, b0, b1]
}

/// Verdict of a vertex-face pair of vertices `v f0 f1 f2`; every coordinate may be off by `coordinate_error`.
pub fn vertex_face<T: Copy + Into<R>, R: Real>(
    ids: [u32; 4],
    x0: &[[T; 3]],
    x1: &[[T; 3]],
    min_distance: R,
    coordinate_error: R,
) -> Verdict<R> {
    let m = Motion::vertex_face(&gather(ids, x0), &gather(ids, x1), coordinate_error);
    solve(&m, Patch::Triangle, min_distance)
}

/// Verdict of an edge-edge pair of vertices `ea0 ea1 eb0 eb1`; every coordinate may be off by `coordinate_error`.
pub fn edge_edge<T: Copy + Into<R>, R: Real>(
    ids: [u32; 4],
    x0: &[[T; 3]],
    x1: &[[T; 3]],
    min_distance: R,
    coordinate_error: R,
) -> Verdict<R> {
    let m = Motion::edge_edge(&gather(ids, x0), &gather(ids, x1), coordinate_error);
    solve(&m, Patch::Parallelogram, min_distance)
}
