//! Vertex against edge and vertex against vertex: queries of features that belong to nothing of a
//! higher dimension, particles and rods.
//!
//! Contact is a distance of zero between sets so thin that the least change of a path undoes it.
//! What is certain is the time until which the features stay apart, by the directions of
//! [conservative advancement](super::conservative_advancement): a vector `a` against the segment
//! `s b`, which is a patch whose other side has no length. That they do meet is certain where
//! exact arithmetic says so at a time that is an `f64`; else the answer is
//! [`Verdict::Undecided`], to be treated as a contact. With a minimum distance all is as for the
//! other queries.

use crate::math::expansion::{Expansion, is_safe};
use crate::math::vec3::{cross, max_abs, sub};
use crate::narrow_phase::approach::Approach;
use crate::narrow_phase::conservative_advancement::{Advance, advance};
use crate::narrow_phase::query::{Verdict, at_distance};
use crate::narrow_phase::relative_motion::{Motion, Patch, in_unit};
use crate::narrow_phase::search::{Answer, Search};
use core::cmp::Ordering::{Greater, Less};

/// A segment and a point are parallelograms without an area.
const PATCH: Patch = Patch::Parallelogram;

/// A vertex-edge query: `v e0 e1` at both ends of the step.
///
/// ```
/// use ccd::{VertexEdge, vertex_edge};
///
/// let t0 = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
/// // All move alike.
/// let t1 = t0.map(|[x, y, z]| [x + 3.0, y, z]);
/// assert_eq!(vertex_edge(&VertexEdge { t0, t1 }, 0.5).toi(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexEdge<T> {
    /// `v e0 e1` at `t = 0`.
    pub t0: [[T; 3]; 3],
    /// `v e0 e1` at `t = 1`.
    pub t1: [[T; 3]; 3],
}

/// A vertex-vertex query: `v w` at both ends of the step.
///
/// ```
/// use ccd::{VertexVertex, vertex_vertex};
///
/// // Two particles of radius 0.5 meet half-way.
/// let (t0, t1) = ([[0.0; 3], [3.0, 0.0, 0.0]], [[0.0; 3], [-1.0, 0.0, 0.0]]);
/// let toi = vertex_vertex(&VertexVertex { t0, t1 }, 1.0).toi();
/// assert!(toi.is_some_and(|t| t <= 0.5 && t > 0.5 - 1e-6));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexVertex<T> {
    /// `v w` at `t = 0`.
    pub t0: [[T; 3]; 2],
    /// `v w` at `t = 1`.
    pub t1: [[T; 3]; 2],
}

/// Decides a vertex-edge query.
///
/// `min_distance >= 0`. Coordinates must be finite and at most 1e100; what overflows or underflows
/// is undecided, not wrong.
///
/// ```
/// use ccd::{Verdict, VertexEdge, vertex_edge};
///
/// // A particle falls through a wire.
/// let wire = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]];
/// let at = |y: f64| [[0.25, y, 0.0], wire[0], wire[1]];
/// let verdict = vertex_edge(&VertexEdge { t0: at(1.0), t1: at(-1.0) }, 0.0);
/// assert!(matches!(verdict, Verdict::Hit { toi } if toi <= 0.5 && toi > 0.5 - 1e-6));
/// ```
pub fn vertex_edge(q: &VertexEdge<f64>, min_distance: f64) -> Verdict<f64> {
    search_vertex_edge(q, &Search::whole(min_distance)).verdict
}

/// Decides a vertex-vertex query. See [`vertex_edge`] for what is accepted.
pub fn vertex_vertex(q: &VertexVertex<f64>, min_distance: f64) -> Verdict<f64> {
    search_vertex_vertex(q, &Search::whole(min_distance)).verdict
}

/// The same as [`vertex_edge`], of the times and with the tolerance of a search.
pub fn search_vertex_edge(q: &VertexEdge<f64>, search: &Search<f64>) -> Answer<f64> {
    let VertexEdge { t0, t1 } = q;
    let b = [sub(t0[2], t0[1]), sub(t1[2], t1[1])];
    let motion = of([sub(t0[0], t0[1]), sub(t1[0], t1[1])], b);
    solve(&motion, search, &|t| touches_edge(q, t))
}

/// The same as [`vertex_vertex`], of the times and with the tolerance of a search.
pub fn search_vertex_vertex(q: &VertexVertex<f64>, search: &Search<f64>) -> Answer<f64> {
    let VertexVertex { t0, t1 } = q;
    let motion = of([sub(t0[0], t0[1]), sub(t1[0], t1[1])], [[0.0; 3]; 2]);
    let edge = VertexEdge { t0: [t0[0], t0[1], t0[1]], t1: [t1[0], t1[1], t1[1]] };
    solve(&motion, search, &|t| touches_edge(&edge, t))
}

fn of(a: [[f64; 3]; 2], b: [[f64; 3]; 2]) -> Motion<f64> {
    Motion { a, b, c: [[0.0; 3]; 2], error: 0.0 }
}

/// `touches`: whether the features certainly touch at a time.
fn solve(m: &Motion<f64>, search: &Search<f64>, touches: &dyn Fn(f64) -> bool) -> Answer<f64> {
    let (m, min_distance) = in_unit(m, search.min_distance);
    if min_distance > 0.0 {
        return at_distance(&m, PATCH, &Search { min_distance, ..*search });
    }
    let Search { from, until, tolerance, .. } = *search;
    let Advance::Stuck(toi) = advance(&m, PATCH, from, until, 0.0, tolerance) else {
        return Answer::from(Verdict::Miss);
    };
    let soon = |t: &f64| *t >= toi && *t <= until && *t - toi <= tolerance;
    if [toi, until].into_iter().chain(times(&m)).filter(soon).any(touches) {
        // It certainly is apart until the time of impact.
        let approach = if toi > from { Approach::Approaching } else { Approach::Unknown };
        Answer { verdict: Verdict::Hit { toi }, approach }
    } else {
        Answer::from(Verdict::Undecided { toi })
    }
}

/// Times at which the features may touch, as far as rounding lets them be found: where `a` is in
/// the line of `b`, and where it is at either end.
fn times(m: &Motion<f64>) -> impl Iterator<Item = f64> {
    let ends = [m.a, [sub(m.a[0], m.b[0]), sub(m.a[1], m.b[1])]];
    let at_ends = ends.map(|[x0, x1]| {
        let travel = sub(x0, x1);
        let k = (0..3).fold(0, |k, i| if travel[i].abs() > travel[k].abs() { i } else { k });
        x0[k] / travel[k]
    });
    let start = cross(m.a[0], m.b[0]);
    let (one, other) = (cross(m.a[0], m.b[1]), cross(m.a[1], m.b[0]));
    let end = cross(m.a[1], m.b[1]);
    // Of the component that is greatest, with `x0 + 2 h t + s t^2`.
    let size = |k: usize| start[k].abs() + one[k].abs() + other[k].abs() + end[k].abs();
    let k = (0..3).fold(0, |k, i| if size(i) > size(k) { i } else { k });
    let (x0, h) = (start[k], (one[k] + other[k]) * 0.5 - start[k]);
    let s = end[k] - start[k] - h * 2.0;
    let in_line = if max_abs([s, 0.0, 0.0]) <= size(k) * (4.0 * f64::EPSILON) {
        [-x0 / (h * 2.0); 2]
    } else {
        let root = square_root(h * h - x0 * s);
        let far = -(h + if h < 0.0 { -root } else { root });
        [far / s, x0 / far]
    };
    at_ends.into_iter().chain(in_line)
}

/// Of a number that is not negative, else zero.
fn square_root(x: f64) -> f64 {
    use crate::math::real::Real;
    if x > 0.0 { x.sqrt_up() } else { 0.0 }
}

/// Whether the vertex is a point of the edge at time `t`, exactly; false if that cannot be said.
fn touches_edge(q: &VertexEdge<f64>, t: f64) -> bool {
    if !q.t0.iter().chain(&q.t1).flatten().chain([&t]).all(|&x| is_safe(x)) {
        return false;
    }
    let time = Expansion::of(t);
    let x = |i: usize, k: usize| {
        let travel = Expansion::difference(q.t1[i][k], q.t0[i][k]);
        Expansion::of(q.t0[i][k]).plus(&travel.times(&time))
    };
    let from_first = |i: usize| [0, 1, 2].map(|k| x(i, k).minus(&x(1, k)));
    let (a, b) = (from_first(0), from_first(2));
    let in_line = |i: usize, j: usize| a[i].times(&b[j]).minus(&a[j].times(&b[i])).is_zero();
    let dot = |p: &[Expansion; 3], q: &[Expansion; 3]| {
        p[0].times(&q[0]).plus(&p[1].times(&q[1])).plus(&p[2].times(&q[2]))
    };
    let along = dot(&a, &b);
    let length = dot(&b, &b);
    // Where the edge has no length, the vertex must be where that is.
    let has_direction = !length.is_zero() || a.iter().all(Expansion::is_zero);
    in_line(0, 1)
        && in_line(1, 2)
        && in_line(2, 0)
        && has_direction
        && along.sign() != Less
        && along.minus(&length).sign() != Greater
}

#[cfg(test)]
mod exact_tests;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_nothing_count() {
        let still = |p: [f64; 3]| VertexVertex { t0: [p, [1.0; 3]], t1: [p, [1.0; 3]] };
        assert_eq!(vertex_vertex(&still([1.0; 3]), 0.0), Verdict::Hit { toi: 0.0 });
        assert_eq!(vertex_vertex(&still([2.0; 3]), 0.0), Verdict::Miss);
        // Along the edge's own line, up to its end at t = 1, and not quite.
        let wire = [[0.0; 3], [1.0, 0.0, 0.0]];
        let until = |x: f64| VertexEdge {
            t0: [[3.0, 0.0, 0.0], wire[0], wire[1]],
            t1: [[x, 0.0, 0.0], wire[0], wire[1]],
        };
        assert!(matches!(vertex_edge(&until(1.0), 0.0), Verdict::Hit { toi } if toi > 0.999_999));
        assert_eq!(vertex_edge(&until(1.0 + 1e-9), 0.0), Verdict::Miss);
        // Beyond what exact arithmetic takes.
        let tiny = VertexVertex { t0: [[1e-80; 3], [0.0; 3]], t1: [[-1e-80; 3], [0.0; 3]] };
        assert!(matches!(vertex_vertex(&tiny, 0.0), Verdict::Undecided { toi } if toi <= 0.5));
    }
}
