//! The cascade of filters, written once for one number and for lanes: what `f32` certifies about
//! candidates before any is decided.

use crate::kernel::memory::at;
use crate::layout::Path;
use crate::math::real::{Mask, Num};
use crate::narrow_phase::coplanarity::Coplanarity;
use crate::narrow_phase::relative_motion::{Motion, Patch};
use crate::narrow_phase::separating_direction::beside;

/// Whether the features of a query over `patch` may come within `min_distance`; `false` is certain.
/// Of two edges, the lesser id is the first.
///
/// `error`: how far a coordinate of a path may be from the true one.
#[inline(always)]
pub fn may_touch(
    patch: Patch,
    ids: [u32; 4],
    paths: &[Path],
    error: f32,
    min_distance: f32,
) -> bool {
    let (x0, x1) = ends(ids, paths);
    !apart(&Motion::new(patch, &x0, &x1, error), patch, min_distance)
}

/// Positions of four vertices at both ends.
#[inline(always)]
pub fn ends(ids: [u32; 4], paths: &[Path]) -> ([[f32; 3]; 4], [[f32; 3]; 4]) {
    let (p, q) = (at(paths, ids[0] as usize), at(paths, ids[1] as usize));
    let (r, s) = (at(paths, ids[2] as usize), at(paths, ids[3] as usize));
    (
        [three(p.t0), three(q.t0), three(r.t0), three(s.t0)],
        [three(p.t1), three(q.t1), three(r.t1), three(s.t1)],
    )
}

#[inline(always)]
fn three(p: [f32; 4]) -> [f32; 3] {
    [p[0], p[1], p[2]]
}

/// Where two features certainly stay further than `min_distance` apart: over the whole step, else
/// over each half of it.
#[inline(always)]
pub fn apart<N: Num>(m: &Motion<N>, patch: Patch, min_distance: N) -> N::Mask {
    let whole = apart_throughout(m, patch, min_distance);
    if whole.all() { whole } else { whole | apart_in_halves(m, patch, min_distance) }
}

/// Where they certainly do by what one look at the whole of a motion tells: by the sign of
/// coplanarity, or beside each other.
#[inline(always)]
pub fn apart_throughout<N: Num>(m: &Motion<N>, patch: Patch, min_distance: N) -> N::Mask {
    let zero = N::splat(0.0);
    let by_plane = Coplanarity::new(m).clearance(min_distance).gt(zero);
    if by_plane.all() { by_plane } else { by_plane | beside(m, patch, min_distance).gt(zero) }
}

/// Where they certainly do in the first half of a motion and in the second.
#[inline(always)]
pub fn apart_in_halves<N: Num>(m: &Motion<N>, patch: Patch, min_distance: N) -> N::Mask {
    let (first, second) = m.halves();
    let apart = apart_throughout(&first, patch, min_distance);
    if apart.any() { apart & apart_throughout(&second, patch, min_distance) } else { apart }
}
