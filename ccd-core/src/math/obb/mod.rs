//! Oriented boxes: fitted by covariance, joined, and told apart by fifteen axes [Gottschalk 1996].
//!
//! ```text
//!      a1     __          a box is all points p with
//!       \  _-'  \           |a0 . (p - c)| <= h0
//!    h1  \'   c  \  a0      |a1 . (p - c)| <= h1
//!         \    _-'-'        |a2 . (p - c)| <= h2
//!          \_-'  h0       for the numbers a, c, h as they are, in exact arithmetic
//! ```
//!
//! The axes of a box around points are the eigenvectors of their covariance: the direction in which
//! they spread most, the one across it in which they do so most, and the third. A box around two
//! boxes takes the covariance of their sixteen corners, which is a sum of squares of half lengths,
//! and reaches as far as the two do: as far as their corners, without looking at these.
//!
//! Two boxes are disjoint exactly if one of fifteen directions separates them: the normals of the
//! faces of either, and the products of an edge of one with an edge of the other. The products are
//! never formed; with `c[i][j] = a_i . b_j` the direction for edges `a_0` and `b_j` is the
//! combination `c[1][j] a_2 - c[2][j] a_1` of axes. Where edges are parallel it is nearly zero and
//! proves nothing, because what must be exceeded does not shrink with it.
//!
//! Cost: a fit some 600 operations, a test of two boxes 60 for the faces and 150 for the edges,
//! against 6 comparisons of boxes along the axes. To choose where things are long, thin and
//! slanted, and a pair that a box along the axes lets through costs much.
//!
//! # What is guaranteed
//! Every point that a box was fitted around, and all of every box that it was joined from, is in
//! it; two boxes that are told apart have no point in common. Exactly, whatever the axes are, with
//! scalar products within [`ORTHONORMAL`] of those of orthonormal ones.
//!
//! # The bounds
//! First order in `u`; `|v|` is the sum of absolute components of `v`, at least its length.
//!
//! *Points.* Along an axis `a` a computed `a . (p - c)` is off by `4 u` times the products with
//! their signs left out: a difference, a product, two sums. Adding the bound to the greatest one
//! costs one more: `5 u`, and `6` is used. Flushing: `9` times the smallest normal number for three
//! differences, `3` for products and `3` for sums, and `2` for the bound: below `64`.
//!
//! *Reach of a box along a direction.* Let `M` have the axes as rows: `M M^T` and `M^T M` differ
//! from the identity by at most `3 x 16 u = 48 u`, as a norm. Any direction `w` is
//! `M^T l + r` with the computed `l` of `M w`; its scalar products are off by `3 u` each, `5.2 u`
//! together, so `r` is at most `54 u` times the length of `w`. A point of the box is at most
//! `|l0| h0 + |l1| h1 + |l2| h2 + |r| |h|` beyond `c` along `w`: the sum is rounded three times,
//! `57 u |h|` in all.
//!
//! *Joining.* The reach, its sum with the distance of the centres, and the bound on top: `59 u
//! |h|`, `6 u` of the distance as for points with one sum more; `64` and `8` are used. What is then
//! added for the centre costs one sum more of each, `60` and `7`.
//!
//! *A centre that is two numbers.* The centre of two boxes is `a + s`, with `a` that of the first
//! and `s = s_0 + s_1 + s_2` a multiple of each axis, and what follows takes its difference from
//! the centre `b` of either. A compiler that takes sums in any order may form `b - a - s` of its
//! five terms, although what is kept is `a + s`, rounded. Of each component, with `|s|` the sum of
//! `|s_i|`: what is kept is off by three sums and a product, `u (3 |a| + 4 |s|)`; the difference by
//! four sums and a product, `u (4 |a| + 4 |b| + 5 |s|)`; together at most `11 u` of the greater one
//! of `|a|` and `|b|`, and `9 u |s|`, which along an axis is no longer than `9 sqrt(3) < 15.6`
//! times `s`. `12` and `16` are used. That is all: axes and the centre of a box along the
//! coordinates pass a choice between numbers, through which no sum goes on, and half lengths have
//! room for one more rounding.
//!
//! *Faces.* Along `a_i` the box of `a` reaches `h_i`, exactly; the other one as above; the distance
//! is off by `4 u |t|`.
//!
//! *Edges.* The direction is what its coefficients say, so the reach of the first box is exact, and
//! that of the second needs `w` as a combination of its own axes, `c[i][2] b_1 - c[i][1] b_2`. For
//! orthonormal axes both are the same vector up to its sign. The nearest such axes differ from `M`
//! by half of `48 u`, `24 u`, and the `c` from theirs by `2 x 24 u + 3 u = 51 u`; so each of the
//! two combinations is off by at most `51 sqrt(2) + 24 < 97 u`, their difference by `194 u`. With
//! the roundings of two products and three sums `199 u |h|`; the distance is off by
//! `(4 sqrt(2) + 3) u |t|`.
//!
//! So `256 u (|t| + |h_a| + |h_b|)` is more than all of it, `128` of twice the sum, and more than
//! what is lost to rounding in itself. Flushing: `14` a distance along an axis, two of which are
//! added, and `10` for products and sums: below `128` smallest normal numbers. Overflow: a product
//! or sum is at most `2 (|t| + |h_a| + |h_b|)`, so where one is infinite so is the bound, and
//! nothing exceeds that.

mod fit;
mod separating_axes;

use crate::math::aabb::Aabb;
use crate::math::real::{Num, Real};
use crate::math::symmetric_eigen::identity;
use crate::math::vec3::{add, dot, scale, sub};

#[cfg(doc)]
use crate::math::symmetric_eigen::ORTHONORMAL;

/// A closed box along axes of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Obb<T = f32> {
    /// Its centre.
    pub centre: [T; 3],
    /// Three axes, orthonormal up to [`ORTHONORMAL`].
    pub axes: [[T; 3]; 3],
    /// How far it reaches to either side along each axis; in a box of everything as far as there
    /// are numbers.
    pub half: [T; 3],
}

impl<T: Real> Obb<T> {
    /// All of space, as far as there are `f32`; of `f64` all but the last ten-millionth.
    #[inline(always)]
    pub fn everything() -> Self {
        // Not infinite, because shader languages cannot write that; three of them overflow, so
        // that no bound is exceeded.
        let half = T::MIN_NORMAL.to_unit() * T::splat(3.999_999_8);
        Self { centre: [T::splat(0.0); 3], axes: identity(), half: [half; 3] }
    }
}

impl<N: Num> Obb<N> {
    /// The box along the coordinates that holds this one, and is larger by roundings only.
    #[inline(always)]
    pub fn of_box(b: &Aabb<N>) -> Self {
        let [min, max] = [scale(b.min, N::splat(0.5)), scale(b.max, N::splat(0.5))];
        // In the box it is as it is; but what was chosen is the same number wherever it is read.
        let centre = greater(lesser(add(min, max), b.max), b.min);
        let reach = greater(sub(b.max, centre), sub(centre, b.min));
        let grown = scale(reach, N::splat(1.0) + N::UNIT * N::splat(4.0));
        Self { centre, axes: identity(), half: add(grown, [N::MIN_NORMAL * N::splat(8.0); 3]) }
    }
}

/// How far a box of these half lengths reaches along a direction of these components.
#[inline(always)]
fn reach<N: Num>(l: [N; 3], half: [N; 3]) -> N {
    dot(absolute(l), half)
}

/// How far `d` goes along each axis.
#[inline(always)]
fn along<N: Num>(axes: &[[N; 3]; 3], d: [N; 3]) -> [N; 3] {
    [dot(axes[0], d), dot(axes[1], d), dot(axes[2], d)]
}

#[inline(always)]
fn absolute<N: Num>(v: [N; 3]) -> [N; 3] {
    [v[0].abs(), v[1].abs(), v[2].abs()]
}

#[inline(always)]
fn greater<N: Num>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[0].max(b[0]), a[1].max(b[1]), a[2].max(b[2])]
}

#[inline(always)]
fn lesser<N: Num>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[0].min(b[0]), a[1].min(b[1]), a[2].min(b[2])]
}
