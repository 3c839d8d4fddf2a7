//! The cascade of filters, written once for one number and for lanes: what `f32` certifies about
//! candidates before any is decided.

use crate::kernel::memory::Stored;
use crate::layout::Path;
use crate::math::aabb::Aabb;
use crate::math::real::{Mask, Num};
use crate::narrow_phase::coplanarity::Coplanarity;
use crate::narrow_phase::relative_motion::{Motion, Patch};
use crate::narrow_phase::separating_direction::{axis_separated, beside};

/// Pairs that a thread of a device looks at before what the cheap filters leave is gathered.
pub const PAIRS_A_THREAD: u32 = 4;

/// The first and cheapest filter: whether no axis keeps the features of a query over `patch`
/// further than `min_distance` apart, by their boxes at both ends; `false` is certain. The others
/// are [`apart_throughout`] and [`apart_where_coplanar`]. Of two edges, the lesser id is the first.
///
/// `error`: how far a coordinate of a path may be from the true one.
#[inline(always)]
pub fn near_on_axes<P: Stored<Path>>(
    patch: Patch,
    ids: [u32; 4],
    paths: &[P],
    error: f32,
    min_distance: f32,
) -> bool {
    let (x0, x1) = ends(ids, paths);
    let ((a0, b0), (a1, b1)) = (boxes(patch, &x0), boxes(patch, &x1));
    !axis_separated(&a0, &a1, &b0, &b1, needed_gap(error, min_distance))
}

/// The same of features `a` and `b` by their boxes at the start and at the end of the step, with
/// the [`needed_gap`].
#[inline(always)]
pub fn near_at_ends((a0, a1): (Aabb, Aabb), (b0, b1): (Aabb, Aabb), gap: f32) -> bool {
    let (a0, a1) = ([a0.min, a0.max], [a1.min, a1.max]);
    let (b0, b1) = ([b0.min, b0.max], [b1.min, b1.max]);
    !axis_separated(&a0, &a1, &b0, &b1, gap)
}

/// The gap along an axis that keeps features apart. 1.0001 covers the rounding of this line and of
/// the gap; of either operand of a gap less than the smallest normal number is flushed.
#[inline(always)]
pub fn needed_gap(error: f32, min_distance: f32) -> f32 {
    (min_distance + 2.0 * error) * 1.0001 + 8.0 * f32::MIN_POSITIVE
}

/// The boxes of a feature with these vertices, some of which may be the same, at the start and at
/// the end of the step.
#[inline(always)]
pub fn boxes_at_ends<P: Stored<Path>>(vertices: [u32; 3], paths: &[P]) -> (Aabb, Aabb) {
    let p = P::load(paths, vertices[0] as usize);
    let q = P::load(paths, vertices[1] as usize);
    let r = P::load(paths, vertices[2] as usize);
    let of = |p: [f32; 4], q: [f32; 4], r: [f32; 4]| {
        let [min, max] = hull(three(p), three(q));
        Aabb { min: hull(min, three(r))[0], max: hull(max, three(r))[1] }
    };
    (of(p.t0, q.t0, r.t0), of(p.t1, q.t1, r.t1))
}

/// The motion that the filters behind it look at.
#[inline(always)]
pub fn motion<P: Stored<Path>>(
    patch: Patch,
    ids: [u32; 4],
    paths: &[P],
    error: f32,
) -> Motion<f32> {
    let (x0, x1) = ends(ids, paths);
    Motion::new(patch, &x0, &x1, error)
}

/// The boxes `[min, max]` of both features of a query at one time.
#[inline(always)]
fn boxes(patch: Patch, x: &[[f32; 3]; 4]) -> ([[f32; 3]; 2], [[f32; 3]; 2]) {
    match patch {
        Patch::Triangle => {
            let [low, high] = hull(x[1], x[2]);
            ([x[0], x[0]], [hull(low, x[3])[0], hull(high, x[3])[1]])
        }
        Patch::Parallelogram => (hull(x[0], x[1]), hull(x[2], x[3])),
    }
}

/// The box of two points.
#[inline(always)]
fn hull(p: [f32; 3], q: [f32; 3]) -> [[f32; 3]; 2] {
    [
        [p[0].min(q[0]), p[1].min(q[1]), p[2].min(q[2])],
        [p[0].max(q[0]), p[1].max(q[1]), p[2].max(q[2])],
    ]
}

/// Positions of four vertices at both ends.
#[inline(always)]
pub fn ends<P: Stored<Path>>(ids: [u32; 4], paths: &[P]) -> ([[f32; 3]; 4], [[f32; 3]; 4]) {
    let (p, q) = (P::load(paths, ids[0] as usize), P::load(paths, ids[1] as usize));
    let (r, s) = (P::load(paths, ids[2] as usize), P::load(paths, ids[3] as usize));
    (
        [three(p.t0), three(q.t0), three(r.t0), three(s.t0)],
        [three(p.t1), three(q.t1), three(r.t1), three(s.t1)],
    )
}

#[inline(always)]
fn three(p: [f32; 4]) -> [f32; 3] {
    [p[0], p[1], p[2]]
}

/// Where two features certainly stay further than `min_distance` apart: over the whole step, or at
/// the times at which they may be coplanar.
#[inline(always)]
pub fn apart<N: Num>(m: &Motion<N>, patch: Patch, min_distance: N) -> N::Mask {
    let whole = apart_throughout(m, patch, min_distance);
    if whole.all() { whole } else { whole | apart_where_coplanar(m, patch, min_distance) }
}

/// Where they certainly do by what one look at the whole of a motion tells: by the sign of
/// coplanarity, or beside each other.
#[inline(always)]
pub fn apart_throughout<N: Num>(m: &Motion<N>, patch: Patch, min_distance: N) -> N::Mask {
    let zero = N::splat(0.0);
    let by_plane = Coplanarity::new(m).clearance(min_distance).gt(zero);
    if by_plane.all() { by_plane } else { by_plane | beside(m, patch, min_distance).gt(zero) }
}

/// Where they certainly do by a look at what [`clipped`] leaves, and at what it leaves of that.
#[inline(always)]
pub fn apart_where_coplanar<N: Num>(m: &Motion<N>, patch: Patch, min_distance: N) -> N::Mask {
    let (zero, one) = (N::splat(0.0), N::splat(1.0));
    let (part, is_known) = clipped(m, min_distance, one);
    let apart = is_known & beside(&part, patch, min_distance).gt(zero);
    if apart.all() {
        return apart;
    }
    // The cubic of the part is what it is clipped by.
    let by_plane = is_known & Coplanarity::new(&part).clearance(min_distance).gt(zero);
    let (part, is_known_too) = clipped(&part, min_distance, one);
    let is_beside = is_known_too & beside(&part, patch, min_distance).gt(zero);
    apart | by_plane | (is_known & is_beside)
}

/// The motion during the times until `latest` at which features may be coplanar, or as near to it
/// as `min_distance`, as a step of its own: they certainly are further apart at all other times.
/// And where these times are known: a computation that overflowed leaves nothing certain.
#[inline(always)]
pub fn clipped<N: Num>(m: &Motion<N>, min_distance: N, latest: N) -> (Motion<N>, N::Mask) {
    let [lo, hi] = Coplanarity::new(m).clip(min_distance);
    let (hi, less) = (hi.min(latest), N::splat(-1.0));
    (m.part(lo, hi), lo.gt(less) & hi.gt(less))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether the axes leave a query whose vertices lie at the origin, but for those that are
    /// `far`, which are at the gaps along axis `k` at either end.
    fn is_left(patch: Patch, far: [bool; 4], k: usize, gaps: [f32; 2], [e, d]: [f32; 2]) -> bool {
        let at = |far: bool, gap: f32| {
            let mut p = [0.0; 4];
            p[k] = if far { gap } else { 0.0 };
            p
        };
        let paths = far.map(|far| Path { t0: at(far, gaps[0]), t1: at(far, gaps[1]) });
        let left = near_on_axes(patch, [0, 1, 2, 3], &paths, e, d);
        let [a, b] = match patch {
            Patch::Triangle => [[0; 3], [1, 2, 3]],
            Patch::Parallelogram => [[0, 1, 1], [2, 3, 3]],
        };
        let [a, b] = [a, b].map(|of| boxes_at_ends(of, &paths));
        assert_eq!(near_at_ends(a, b, needed_gap(e, d)), left);
        left
    }

    #[test]
    fn axes_keep_apart_what_is_further_than_distance_and_errors() {
        let sides = [
            (Patch::Triangle, [true, false, false, false]),
            (Patch::Parallelogram, [true, true, false, false]),
        ];
        for (patch, far) in sides {
            for far in [far, far.map(|f| !f)] {
                for (k, sign) in [(0, 1.0), (1, 1.0), (2, 1.0), (0, -1.0), (1, -1.0), (2, -1.0)] {
                    let left =
                        |a: f32, b: f32, of| is_left(patch, far, k, [a * sign, b * sign], of);
                    // Coordinates may be off by 0.125: so these may be 0.25 apart.
                    let of = [0.125, 0.25];
                    assert!(left(0.5, 0.5, of) && left(0.5, 9.0, of) && left(9.0, 0.5, of));
                    assert!(!left(0.501, 0.501, of) && !left(0.501, 9.0, of));
                    // Through each other.
                    assert!(left(9.0, -9.0, of));
                    // A device may flush what is less than the smallest normal number.
                    assert!(left(f32::MIN_POSITIVE, f32::MIN_POSITIVE, [0.0, 0.0]));
                    assert!(!left(1e-30, 1e-30, [0.0, 0.0]));
                }
            }
        }
    }
}
