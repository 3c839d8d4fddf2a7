//! The verdict on a pair of features: ids of its vertices, and the answer for their positions as
//! given.

use crate::kernel::memory::at;
use crate::layout::Pair;
use crate::math::real::Real;
use crate::model::contact::Kind;
use crate::narrow_phase::query::search;
use crate::narrow_phase::relative_motion::Motion;
use crate::narrow_phase::search::{Answer, Search};

/// The answer for a pair of features with these vertices, in the precision `R`, from exact
/// positions at both times.
pub fn pair<T: Copy + Into<R>, R: Real>(
    kind: Kind,
    ids: [u32; 4],
    x: [&[[T; 3]]; 2],
    wanted: &Search<R>,
) -> Answer<R> {
    let patch = kind.patch();
    let motion = Motion::new(patch, &gather(ids, x[0]), &gather(ids, x[1]), R::splat(0.0));
    search(&motion, patch, wanted)
}

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
