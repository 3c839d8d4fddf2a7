//! Map: boxes that enclose a primitive over the whole step, rounded outward to `f32`.
//!
//! Vertices move on straight lines, so the box of both ends holds the whole path; edges and faces
//! are unions of their vertices.

use crate::kernel::memory::at;
use crate::layout::Path;
use crate::math::aabb::{Aabb, GREATEST};
use crate::math::real::{Num, Real};
use crate::math::vec3::lerp;

/// Boxes of vertices from positions at `t = 0` and `t = 1` during `times`, grown by `margin >= 0`.
/// Of what does not move they are those of the whole step.
#[inline(always)]
pub fn vertices<R: Real>(
    x0: &[[R; 3]],
    x1: &[[R; 3]],
    times: [f64; 2],
    margin: R,
    out: &mut [Aabb<f32>],
) {
    if times[0] <= 0.0 && times[1] >= 1.0 {
        each_coordinate::<_, true>(x0, x1, times, margin, out);
    } else {
        each_coordinate::<_, false>(x0, x1, times, margin, out);
    }
}

/// Four vertices at a time, so that the compiler makes vectors of their coordinates.
#[inline(always)]
fn each_coordinate<R: Real, const WHOLE: bool>(
    x0: &[[R; 3]],
    x1: &[[R; 3]],
    times: [f64; 2],
    margin: R,
    out: &mut [Aabb<f32>],
) {
    const LANES: usize = 12;
    let ((p, p_rest), (q, q_rest)) = (x0.as_chunks::<4>(), x1.as_chunks::<4>());
    let (fours, rest) = out.as_chunks_mut::<4>();
    for ((p, q), out) in p.iter().zip(q).zip(fours) {
        let (p, q) = (p.as_flattened(), q.as_flattened());
        let (mut min, mut max) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            (min[i], max[i]) = coordinate::<_, WHOLE>(p[i], q[i], times, margin);
        }
        for (i, out) in out.iter_mut().enumerate() {
            out.min.copy_from_slice(&min[3 * i..3 * i + 3]);
            out.max.copy_from_slice(&max[3 * i..3 * i + 3]);
        }
    }
    for ((p, q), out) in p_rest.iter().zip(q_rest).zip(rest) {
        for k in 0..3 {
            (out.min[k], out.max[k]) = coordinate::<_, WHOLE>(p[k], q[k], times, margin);
        }
    }
}

/// Bounds of a coordinate on its way from `p` to `q`, or, unless that is the `WHOLE` of it, during
/// `times`, whose ends are as [`end`] has them.
#[inline(always)]
fn coordinate<R: Real, const WHOLE: bool>(p: R, q: R, times: [f64; 2], margin: R) -> (f32, f32) {
    if WHOLE {
        return bounds(p, q, margin);
    }
    let (p, q, margin) = (p.to_f64(), q.to_f64(), margin.to_f64());
    let [from, until] = times;
    let start = if from > 0.0 { p + (q - p) * from } else { p };
    let end = if until < 1.0 { p + (q - p) * until } else { q };
    let error = end_error(Num::max(Num::abs(p), Num::abs(q)));
    bounds(start, end, if p == q { margin } else { margin + error })
}

/// Of a coordinate between `p` and `q`, as [`Aabb::inflated`] and [`Aabb::round_out`] have them.
#[inline(always)]
fn bounds<R: Real>(p: R, q: R, margin: R) -> (f32, f32) {
    let (min, max) = (p.min(q), p.max(q));
    let (below, above) = ((min - margin).next_down(), (max + margin).next_up());
    let (min, max) = if margin > R::splat(0.0) { (below, above) } else { (min, max) };
    let within = |bound: f32| Num::min(Num::max(bound, -GREATEST), GREATEST);
    (within(min.round_down()), within(max.round_up()))
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
    use std::{vec, vec::Vec};

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

    fn check_whole<R: Real>(number: &mut dyn FnMut() -> R, margins: &[R]) {
        for n in 0..14 {
            let [x0, x1] = [0, 1].map(|_| -> Vec<[R; 3]> {
                (0..n).map(|_| [number(), number(), number()]).collect()
            });
            for &margin in margins {
                let mut boxes = vec![Aabb::EMPTY; n];
                vertices(&x0, &x1, [0.0, 1.0], margin, &mut boxes);
                for (i, aabb) in boxes.iter().enumerate() {
                    let want = swept(x0[i], x1[i]).inflated(margin).round_out();
                    assert_eq!(*aabb, want, "{:?} {:?} {margin:?}", x0[i], x1[i]);
                }
            }
        }
    }

    #[test]
    fn boxes_four_at_a_time_are_those_of_each() {
        let mut random = Random::new(2);
        let scales = [0.0, 1e-310, 1e-45, 1e-38, 1.0, 1e30, 1e300];
        for _ in 0..500 {
            let mut wide =
                || scales[random.below(scales.len() as u32) as usize] * (2.0 * random.unit() - 1.0);
            check_whole(&mut wide, &[0.0, 1e-300, 1e-7, 0.5]);
            check_whole(&mut || wide().clamp(-3e38, 3e38) as f32, &[0.0, 1e-45, 1e-7, 0.5]);
        }
    }

    /// Coordinates are multiples of 2^-40, times of 2^-10, so that positions are integers.
    #[test]
    fn boxes_of_a_part_hold_all_positions_of_it() {
        const ONE: f64 = (1u64 << 40) as f64;
        let mut random = Random::new(3);
        for _ in 0..20_000 {
            let mut number = || {
                let bits = 2 + random.below(49);
                let wide = (random.unit() * (1u64 << 52) as f64) as i64 >> (52 - bits);
                if random.below(2) == 0 { wide } else { -wide }
            };
            let [p, mut q] = [[number(), number(), number()], [number(), number(), number()]];
            q[1] = p[1];
            let near = (number() as f32) as i64;
            let margin = [0.0, 1e-9, 0.25][random.below(3) as usize];
            let mut times = [random.below(1025), random.below(1025)];
            times.sort_unstable();
            if times[1] >= 512 {
                // Where it ends an `f32` is near, to which a position that is rounded may come.
                q[2] = p[2] + ((near - p[2]) as i128 * 1024 / times[1] as i128) as i64;
            }
            let [x0, x1] = [p, q].map(|p| [p.map(|c| c as f64 / ONE)]);
            let mut aabb = [Aabb::EMPTY];
            vertices(&x0, &x1, times.map(|t| t as f64 / 1024.0), margin, &mut aabb);
            let mut whole = [Aabb::EMPTY];
            vertices(&x0, &x1, [0.0, 1.0], margin, &mut whole);
            let [aabb, whole] = [aabb[0], whole[0]];
            assert_eq!((aabb.min[1], aabb.max[1]), (whole.min[1], whole.max[1]), "does not move");
            // In units of 2^-80, in which bounds of an `f32` from 2^-60 on are integers.
            let exact = |x: f32| (x as f64 * ONE * 1048576.0) as i128 * (1 << 20);
            for k in 0..3 {
                for t in times {
                    let at = (p[k] as i128 * 1024 + (q[k] - p[k]) as i128 * t as i128) << 30;
                    let margin = (margin * ONE * 1048576.0) as i128 * (1 << 20);
                    let holds =
                        exact(aabb.min[k]) <= at - margin && at + margin <= exact(aabb.max[k]);
                    assert!(holds, "{p:?} {q:?} {times:?} {margin} {aabb:?}");
                }
            }
        }
    }
}
