//! Regions of a mesh that certainly do not touch themselves during a step: their normals lie in a
//! half space, and their rim, seen along its direction, does not cross itself.
//!
//! # The theorem
//! It is that of [Volino 1994], at every time of the step [Tang 2008]. Let the triangles of a
//! region be such that
//! 1. each of their edges is in one of them or in two, and then they run along it in opposite
//!    directions;
//! 2. the edges in one of them form a single loop, the rim, which has no vertex twice;
//! 3. there is a direction `d` with `d . n > 0` for every normal `n`;
//! 4. the rim, projected along `d`, is a simple polygon: edges without a common vertex do not
//!    touch. (Then neighbours have only their vertex in common: if they overlapped, the end of the
//!    shorter one would bring the edge after it in touch with the longer one. A triangle is simple
//!    by 3.)
//!
//! Then projection is one-to-one on the region, so that features without a common vertex, which
//! are apart as sets of points of the region, are apart in the plane and therefore in space.
//!
//! *Proof.* By 3 every triangle keeps its orientation in the plane, so a point of the plane lies in
//! as many triangles as the boundary of their sum winds around it (but for points on edges). By 1
//! and 2 that boundary is the rim, by 4 it winds around each point once or not at all: triangles
//! overlap nowhere. Let two points of the region have one image. If neither is on the rim, images
//! of the surroundings of both are surroundings of it (two triangles at an edge are on either side
//! by 1 and 3; a closed fan goes around at least once), so triangles overlap there. If one is on
//! the rim, the triangle at it overlaps with the surroundings of the other. If both are, the rim
//! touches itself. Nothing is asked of how the region is connected: a second piece would have a
//! rim, or would be closed and break 3.
//!
//! The half space alone is not enough: a strip that winds up like a staircase or a figure of eight
//! has its normals in one, and touches itself where its rim crosses.
//!
//! # How it is certified
//! ```text
//!      d                        seen along d:   .---------.
//!      ^    n    n                             /  .---.    \     rims cross: not certified
//!      |   /|   |\                             | /     \   |
//!    --+--/-+---+-\--                          '-|------|--'
//!         a region                               '      '
//! ```
//! `d` is `(s, r, 1)` with the axes turned so that the last is the largest; the projection is
//! `(x - s z, y - r z)`, exact for any numbers `s` and `r`. Twice the area of a triangle is a
//! quadratic in time, whose three Bernstein values bound it: all positive beyond rounding. Two
//! edges of the rim are apart throughout if a direction in the plane separates them at both ends.
//!
//! # The bound
//! `u = 2^-53`, `M` the greatest component of a position less the origin of the region. A position
//! less the origin is off by `u M`, the product with a slope (at most 1) and the sum add `u M` and
//! `2 u M`, and the error of the factor `u M`: a projected coordinate is off by at most `5 u M`;
//! `e = 8 u M`. For two differences of projected points with components up to `L`, each off by
//! `2 e + u L`, a sum or difference of two products is off by `4 L (2 e + u L)`, and by `6 u L^2`
//! of its own, and half the sum of two of those by `2 u L^2` more: `8 L e + 12 u L^2`, and terms of
//! second order below `16 e^2`. The code doubles it. Along a direction `w` a point is off by
//! `5 u |w| M` and by `3 u |w| M'` of its own, with `M'` the greatest projected coordinate, at most
//! `2 M` to first order: two of them by `22 u |w| M`, and the code takes `32 u |w| M`. Underflow
//! loses less than the smallest normal number a term. Positions that are not finite, or whose
//! differences are not, certify nothing; up to 1e100 no product overflows.
//!
//! Only for contact as touching: with a minimum distance regions are not culled.

use crate::math::real::Num;
use crate::math::vec3::{self, cross};

/// A region that fulfils the first two conditions.
#[derive(Clone, Copy, Debug)]
pub struct Region<'a> {
    /// The faces of a mesh.
    pub faces: &'a [[u32; 3]],
    /// Those of the region.
    pub triangles: &'a [u32],
    /// The vertices of its rim, in order.
    pub rim: &'a [u32],
}

/// Positions of a vertex at both ends of a step.
pub trait Paths {
    /// Of vertex `v`.
    fn at(&self, v: u32) -> [[f64; 3]; 2];
}

impl<T: crate::Real> Paths for [&[[T; 3]]; 2] {
    fn at(&self, v: u32) -> [[f64; 3]; 2] {
        [self[0][v as usize].map(T::to_f64), self[1][v as usize].map(T::to_f64)]
    }
}

/// A point of the plane at both ends of a step.
pub type Point = [[f64; 2]; 2];

const UNIT: f64 = f64::EPSILON / 2.0;

impl Region<'_> {
    /// Whether no two features of the region without a common vertex touch during the step: `true`
    /// is certain, whatever the view. `seen` must be as long as the rim.
    pub fn free<P: Paths>(&self, x: &P, view: &View, seen: &mut [Point]) -> bool {
        let Some(seen) = seen.get_mut(..self.rim.len()) else { return false };
        if !self.triangles.iter().all(|&t| view.keeps_side(x, self.faces[t as usize])) {
            return false;
        }
        for (point, &v) in seen.iter_mut().zip(self.rim) {
            *point = view.point(x, v);
        }
        seen.len() >= 3 && is_simple(seen, view.reach)
    }
}

/// Sum of the normals of a face at both ends of the step, as long as its areas are large.
pub fn mean_normal<P: Paths>(x: &P, face: [u32; 3]) -> [f64; 3] {
    let [a, b, c] = face.map(|v| x.at(v));
    let normal = |end: usize| cross(vec3::sub(b[end], a[end]), vec3::sub(c[end], a[end]));
    vec3::add(normal(0), normal(1))
}

/// Greatest component of the positions of faces less an origin; `None` if one is not finite.
pub fn reach<P: Paths>(x: &P, faces: &[[u32; 3]], region: &[u32], origin: [f64; 3]) -> Option<f64> {
    let mut reach = 0f64;
    for &t in region {
        for v in faces[t as usize] {
            let [p, q] = x.at(v).map(|p| vec3::max_abs(vec3::sub(p, origin)));
            // NaN fails too.
            let finite = p <= f64::MAX && q <= f64::MAX;
            if !finite {
                return None;
            }
            reach = Num::max(reach, Num::max(p, q));
        }
    }
    Some(reach)
}

/// A projection onto a plane.
#[derive(Clone, Copy, Debug)]
pub struct View {
    origin: [f64; 3],
    /// Axes of the plane, and that along which it looks most.
    axes: [usize; 3],
    slopes: [f64; 2],
    /// Greatest component of a position less the origin.
    reach: f64,
}

impl View {
    /// Along `d`, of whatever length. `reach`: at least the greatest component of a position that
    /// will be looked at, less the origin, see [`reach`].
    pub fn along(d: [f64; 3], origin: [f64; 3], reach: f64) -> Option<Self> {
        let size = d.map(f64::abs);
        let k = match size {
            [x, y, z] if x >= y && x >= z => 0,
            [_, y, z] if y >= z => 1,
            _ => 2,
        };
        let (mut i, mut j) = ((k + 1) % 3, (k + 2) % 3);
        if d[k] < 0.0 {
            // The plane is seen from its other side.
            (i, j) = (j, i);
        }
        let slopes = [d[i] / d[k], d[j] / d[k]];
        let fine = slopes.iter().all(|s| (-1.0..=1.0).contains(s)) && reach < f64::MAX;
        fine.then_some(Self { origin, axes: [i, j, k], slopes, reach })
    }

    /// A vertex in the plane at both ends, off by at most `5 u reach`.
    fn point<P: Paths>(&self, x: &P, v: u32) -> Point {
        let [i, j, k] = self.axes;
        x.at(v).map(|p| {
            let q = vec3::sub(p, self.origin);
            [q[i] - self.slopes[0] * q[k], q[j] - self.slopes[1] * q[k]]
        })
    }

    /// Whether a triangle certainly shows its front during the whole step.
    fn keeps_side<P: Paths>(&self, x: &P, face: [u32; 3]) -> bool {
        let [a, b, c] = face.map(|v| self.point(x, v));
        least_area(difference(b, a), difference(c, a), self.reach) > 0.0
    }
}

/// Whether a polygon is certainly simple during the whole step; coordinates are off by at most
/// `5 u reach`.
fn is_simple(rim: &[Point], reach: f64) -> bool {
    let n = rim.len();
    let next = |i: usize| if i + 1 == n { 0 } else { i + 1 };
    for i in 0..n {
        // The edges after the next one, up to the one before the last if that ends here.
        for j in i + 2..n - (i == 0) as usize {
            if !apart([rim[i], rim[next(i)]], [rim[j], rim[next(j)]], reach) {
                return false;
            }
        }
    }
    true
}

/// Whether a direction certainly separates two edges throughout.
fn apart(a: [Point; 2], b: [Point; 2], reach: f64) -> bool {
    let side = |e: [Point; 2]| {
        let [u, v] = difference(e[1], e[0]);
        [u[1] + v[1], -(u[0] + v[0])]
    };
    separates([1.0, 0.0], a, b, reach)
        || separates([0.0, 1.0], a, b, reach)
        || separates(side(a), a, b, reach)
        || separates(side(b), a, b, reach)
}

fn separates(w: [f64; 2], a: [Point; 2], b: [Point; 2], reach: f64) -> bool {
    let bound = 32.0 * UNIT * (w[0].abs() + w[1].abs()) * reach + 8.0 * f64::MIN_POSITIVE;
    let along = |e: [Point; 2], end: usize| {
        let [p, q] = e.map(|p| w[0] * p[end][0] + w[1] * p[end][1]);
        if p < q { [p, q] } else { [q, p] }
    };
    let (a0, a1, b0, b1) = (along(a, 0), along(a, 1), along(b, 0), along(b, 1));
    (a0[0] - b0[1] > bound && a1[0] - b1[1] > bound)
        || (b0[0] - a0[1] > bound && b1[0] - a1[1] > bound)
}

/// The least Bernstein value of twice the area between two vectors that move linearly, less the
/// bound of its rounding.
fn least_area(u: Point, v: Point, reach: f64) -> f64 {
    let mut size = 0f64;
    for component in u.iter().chain(&v).flatten() {
        size = Num::max(size, component.abs());
    }
    let e = 8.0 * UNIT * reach;
    let bound = 16.0 * size * e + 24.0 * UNIT * size * size + 32.0 * e * e;
    let middle = 0.5 * (area(u[0], v[1]) + area(u[1], v[0]));
    let (first, last) = (area(u[0], v[0]), area(u[1], v[1]));
    Num::min(Num::min(first, last), middle) - bound - 8.0 * f64::MIN_POSITIVE
}

/// Positive if `v` is to the left of `u`.
fn area(u: [f64; 2], v: [f64; 2]) -> f64 {
    u[0] * v[1] - u[1] * v[0]
}

fn difference(a: Point, b: Point) -> Point {
    [0, 1].map(|end| [a[end][0] - b[end][0], a[end][1] - b[end][1]])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn still(p: [f64; 2]) -> Point {
        [p; 2]
    }

    /// Two edges on a line, of which one begins where the other ends, but for what a point may be
    /// off by along the line, twice.
    #[test]
    fn sides_are_told_apart_beyond_their_rounding() {
        let reach = 1.0;
        let apart_by = |units: f64| {
            let x = units * UNIT * reach;
            let ahead = [still([x, 0.0]), still([x + 1.0, 0.5])];
            separates([1.0, 0.0], ahead, [still([0.0, 0.0]), still([-1.0, 0.5])], reach)
        };
        assert!(!apart_by(22.0) && apart_by(40.0));
    }

    /// Of vectors in one direction the area is exactly 0, and what is left is the bound.
    #[test]
    fn areas_are_bounded_as_derived() {
        for (length, reach) in [(1.0, 1.0), (0.0625, 1.0), (1.0, 0.25)] {
            let along = still([length, 0.0]);
            let bound = -least_area(along, along, reach);
            let least = 8.0 * length * (5.0 * UNIT * reach) + 12.0 * UNIT * length * length;
            assert!(bound >= least, "{bound:e} of {least:e} for {length} and {reach}");
        }
        // Far above it there is an area.
        assert!(least_area(still([1.0, 0.0]), still([0.0, 1e-13]), 1.0) > 0.0);
    }
}
