//! Oriented boxes around points and around two boxes; their bounds are derived in [`super`].

use super::{Obb, absolute, along, greater, lesser, reach};
use crate::math::real::{Num, Real};
use crate::math::symmetric_eigen::symmetric_eigen;
use crate::math::vec3::{add, max_abs, scale, sub, sum_abs};

impl<T: Real> Obb<T> {
    /// A box around points.
    ///
    /// Five loops over them: bounds, mean, covariance, the range along each axis, and how far they
    /// are from its middle, rounded. Points that do not spread get axes along the coordinates;
    /// those whose differences overflow get all of space.
    #[inline]
    pub fn around<const N: usize>(points: &[[T; 3]; N]) -> Self {
        let (mut low, mut high) = (points[0], points[0]);
        for i in 1..N {
            (low, high) = (lesser(low, points[i]), greater(high, points[i]));
        }
        let half = T::splat(0.5);
        let middle = add(scale(low, half), scale(high, half));
        let unit = unit_of(max_abs(sub(high, middle)).max(max_abs(sub(low, middle))));
        let mut mean = [T::splat(0.0); 3];
        for i in 0..N {
            mean = add(mean, scale(sub(points[i], middle), unit));
        }
        mean = scale(mean, T::splat(1.0 / N as f32));
        let mut scatter = Scatter::new();
        for i in 0..N {
            let place = scale(sub(points[i], middle), unit);
            scatter.add(sub(place, mean), T::splat(1.0));
        }
        let axes = symmetric_eigen(&scatter.0).vectors;
        let (mut low, mut high) = ([T::splat(0.0); 3], [T::splat(0.0); 3]);
        for i in 0..N {
            let x = along(&axes, sub(points[i], middle));
            (low, high) = (lesser(low, x), greater(high, x));
        }
        let centre = add(middle, combine(&axes, scale(add(low, high), half)));
        Self::reaching(centre, axes, points)
    }

    /// The box of a triangle that moves from `t0` to `t1`: it holds both, and so all in between.
    ///
    /// No leaf of a tree here has it: candidates are the pairs whose boxes along the axes overlap,
    /// by every method the same, and a tree of such leaves would lose many of those. Pairs of
    /// triangles on a CPU are rejected by it once their candidates are counted.
    #[inline]
    pub fn of_moving_triangle(t0: &[[T; 3]; 3], t1: &[[T; 3]; 3]) -> Self {
        Self::around(&[t0[0], t0[1], t0[2], t1[0], t1[1], t1[2]])
    }

    /// The same box, reaching further by `distance` along each axis: it holds every point that is
    /// so near to one of the box, or nearer, by axes of length 1. Axes are up to `8 u` longer: what
    /// counts on this has that in its distance.
    #[inline]
    pub fn grown(self, distance: T) -> Self {
        // A sum and a product are rounded, `2 u`.
        let up = T::splat(1.0) + T::UNIT * T::splat(4.0);
        Self { half: scale(add(self.half, [distance; 3]), up), ..self }
    }

    /// The box with this centre and these axes that reaches as far as the points do; the axes
    /// orthonormal as in [`Obb`].
    #[inline]
    pub fn reaching<const N: usize>(
        centre: [T; 3],
        axes: [[T; 3]; 3],
        points: &[[T; 3]; N],
    ) -> Self {
        let (mut half, mut span) = ([T::splat(0.0); 3], [T::splat(0.0); 3]);
        let mut finite = true;
        for i in 0..N {
            let d = sub(points[i], centre);
            let x = along(&axes, d);
            finite &= all_finite(x);
            (half, span) = (greater(half, absolute(x)), greater(span, absolute(d)));
        }
        if !finite {
            return Self::everything();
        }
        let margin = scale(sizes(&axes, span), T::UNIT * T::splat(6.0));
        let half = add(half, add(margin, [T::MIN_NORMAL * T::splat(64.0); 3]));
        Self { centre, axes, half }
    }

    /// A box around two.
    #[inline]
    pub fn around_two(a: &Self, b: &Self) -> Self {
        let d = sub(b.centre, a.centre);
        let unit = unit_of(max_abs(d).max(max_abs(a.half)).max(max_abs(b.half)));
        // Of the sixteen corners, as parts of eight.
        let mut scatter = Scatter::new();
        scatter.add(scale(d, unit), T::splat(0.5));
        scatter.add_corners(a, unit);
        scatter.add_corners(b, unit);
        let axes = symmetric_eigen(&scatter.0).vectors;
        let (of_a, of_b) = (a.reach(&axes), b.reach(&axes));
        let x = along(&axes, d);
        let low = lesser(scale(of_a, T::splat(-1.0)), sub(x, of_b));
        let high = greater(of_a, add(x, of_b));
        let centre = add(a.centre, combine(&axes, scale(add(low, high), T::splat(0.5))));
        Self::reaching_two(centre, axes, a, b)
    }

    /// The box with this centre and these axes that reaches as far as the two do; the axes
    /// orthonormal as in [`Obb`]. The centre may be that of `a` and a multiple of each axis, summed
    /// in one way where it is kept and in another where it is subtracted.
    #[inline]
    pub fn reaching_two(centre: [T; 3], axes: [[T; 3]; 3], a: &Self, b: &Self) -> Self {
        let far = greater(absolute(a.centre), absolute(b.centre));
        let off = sum_abs(sub(a.centre, centre)) * (T::UNIT * T::splat(16.0));
        let off = add(scale(sizes(&axes, far), T::UNIT * T::splat(12.0)), [off; 3]);
        let (of_a, of_b) = (a.beyond(centre, &axes), b.beyond(centre, &axes));
        let (of_a, of_b) = (add(of_a, off), add(of_b, off));
        if !(all_finite(of_a) && all_finite(of_b)) {
            return Self::everything();
        }
        Self { centre, axes, half: greater(of_a, of_b) }
    }

    /// How far the box certainly reaches at most beyond the centre of another along its axes.
    #[inline(always)]
    fn beyond(&self, centre: [T; 3], axes: &[[T; 3]; 3]) -> [T; 3] {
        let d = sub(self.centre, centre);
        let rounding = sum_abs(self.half) * (T::UNIT * T::splat(64.0));
        let margin = scale(sizes(axes, absolute(d)), T::UNIT * T::splat(8.0));
        let margin = add(margin, [rounding + T::MIN_NORMAL * T::splat(64.0); 3]);
        add(add(absolute(along(axes, d)), self.reach(axes)), margin)
    }
}

impl<N: Num> Obb<N> {
    /// How far the box reaches beyond its centre along three directions, up to rounding.
    #[inline(always)]
    fn reach(&self, w: &[[N; 3]; 3]) -> [N; 3] {
        let Self { axes, half, .. } = self;
        [
            reach(along(axes, w[0]), *half),
            reach(along(axes, w[1]), *half),
            reach(along(axes, w[2]), *half),
        ]
    }
}

/// `sum weight v v^T`, the upper triangle.
struct Scatter<T>([[T; 3]; 3]);

impl<T: Real> Scatter<T> {
    #[inline(always)]
    fn new() -> Self {
        Self([[T::splat(0.0); 3]; 3])
    }

    #[inline(always)]
    fn add(&mut self, v: [T; 3], weight: T) {
        let [x, y, z] = scale(v, weight);
        let m = &mut self.0;
        m[0] = add(m[0], scale(v, x));
        m[1] = [m[1][0], m[1][1] + y * v[1], m[1][2] + y * v[2]];
        m[2][2] = m[2][2] + z * v[2];
    }

    /// The corners of a box about its own centre.
    #[inline(always)]
    fn add_corners(&mut self, b: &Obb<T>, unit: T) {
        self.add(scale(b.axes[0], b.half[0] * unit), T::splat(1.0));
        self.add(scale(b.axes[1], b.half[1] * unit), T::splat(1.0));
        self.add(scale(b.axes[2], b.half[2] * unit), T::splat(1.0));
    }
}

/// A power of two that brings lengths up to `size` to about 1; 0 where there is no size, or none
/// that is a number.
#[inline(always)]
fn unit_of<T: Real>(size: T) -> T {
    if size > T::MIN_NORMAL && size.is_finite_number() { size.to_unit() } else { T::splat(0.0) }
}

/// What the products in [`along`] sum to at most, of vectors with components up to those of `span`.
#[inline(always)]
fn sizes<N: Num>(axes: &[[N; 3]; 3], span: [N; 3]) -> [N; 3] {
    [reach(axes[0], span), reach(axes[1], span), reach(axes[2], span)]
}

/// The vector that goes so far along each axis.
#[inline(always)]
fn combine<N: Num>(axes: &[[N; 3]; 3], x: [N; 3]) -> [N; 3] {
    add(add(scale(axes[0], x[0]), scale(axes[1], x[1])), scale(axes[2], x[2]))
}

#[inline(always)]
fn all_finite<T: Real>(x: [T; 3]) -> bool {
    x[0].is_finite_number() && x[1].is_finite_number() && x[2].is_finite_number()
}
