//! Where two features meet: the point, the normal and the weights of their vertices at one time.
//!
//! Both kinds of pairs are a vector against a patch (`relative_motion.rs`): what is looked for is
//! the point `(s, r)` of the patch that is nearest, as in [`closest_point`](super::closest_point),
//! but with its parameters, and as exact as the input allows:
//!
//! - of a face, the two shorter sides span the patch, so that a needle has the widest angle that it
//!   can have;
//! - inside of the patch `s` and `r` come from vector products, whose error grows with the inverse
//!   of the sine of the angle (that of normal equations with its square), and are then improved
//!   each against the other, by which the two points are nearest though the angle may be tiny;
//! - edges that are parallel to rounding meet in the middle of where they overlap.
//!
//! # The normal
//! It points from `b` towards `a`. The first of these that is more than rounding says which way:
//!
//! 1. the vector between the two nearest points; inside of both features that is the normal of the
//!    face, or the vector product of the edges, whichever is known better;
//! 2. where there is no distance: that normal, against the velocity of `a` relative to `b`;
//! 3. where velocity lies in the plane, or there is none because a face has no area or edges are
//!    parallel: against the part of the velocity that leaves the side on which they meet;
//! 4. nothing moves: the normal of the face as its vertices go round, `(f1 - f0) x (f2 - f0)`, or
//!    the product of the edges, `(ea1 - ea0) x (eb1 - eb0)`;
//! 5. nothing but a line: some direction perpendicular to it; nothing but a point: the first axis;
//!    the opposite if the velocity goes that way by more than rounding.
//!
//! Nothing here is certified: a bound of rounding says only which rule applies. The normal has unit
//! length and the weights lie in the patch whatever the input: weights are limited, and what is
//! not of unit length (NaN, where coordinates are none) becomes the first axis.

use crate::math::real::Real;
use crate::math::vec3::{add, cross, dot, max_abs, scale, sub, sum_abs};
use crate::narrow_phase::relative_motion::{Motion, Patch};

/// How two features meet at a time: points in the coordinates of the input, the normal a unit
/// vector.
///
/// ```
/// use ccd::geometry::Patch;
/// use ccd_core::narrow_phase::contact_geometry::contact_geometry;
///
/// // Two edges that cross, the first above the second, at rest.
/// let x = [[-1.0, 0.5, 0.0], [1.0, 0.5, 0.0], [0.0, 0.0, -1.0], [0.0, 0.0, 3.0f64]];
/// let at = contact_geometry(Patch::Parallelogram, &x, &x, 0.0, 0.0);
/// assert_eq!((at.point, at.normal), ([0.0, 0.25, 0.0], [0.0, 1.0, 0.0]));
/// assert_eq!((at.weights, at.distance), ([0.5, 0.5, 0.75, 0.25], 0.5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ContactGeometry<R = f64> {
    /// Halfway between [`on_a`](Self::on_a) and [`on_b`](Self::on_b).
    pub point: [R; 3],
    /// Unit vector from `b` towards `a`: pushing `a` along it parts the two. The relative velocity
    /// of `a` along it is not positive, unless there is a distance and they separate.
    pub normal: [R; 3],
    /// Of the vertices `v f0 f1 f2` or `ea0 ea1 eb0 eb1`: those of a face and those of each edge
    /// are in `[0, 1]` and add up to 1 (to rounding), that of a vertex is 1.
    pub weights: [R; 4],
    /// The nearest point of `a` (a vertex, or the first edge): weights times positions.
    pub on_a: [R; 3],
    /// The nearest point of `b` (a face, or the second edge): weights times positions.
    pub on_b: [R; 3],
    /// From `on_a` to `on_b`, more exactly than from their rounded coordinates. At a time of impact
    /// that is at most 1e-6 early it is at most what they move in that time, besides the minimum
    /// distance.
    pub distance: R,
}

/// Geometry of the features `v f0 f1 f2` or `ea0 ea1 eb0 eb1`, which move on straight lines from
/// `t0` to `t1`, at the time `t` in `[0, 1]`. `coordinate_error`: how far each coordinate may be
/// from the true one.
pub fn contact_geometry<R: Real>(
    patch: Patch,
    t0: &[[R; 3]; 4],
    t1: &[[R; 3]; 4],
    t: R,
    coordinate_error: R,
) -> ContactGeometry<R> {
    let one = R::splat(1.0);
    let t = within(t, one);
    let first = if matches!(patch, Patch::Triangle) { widest(t0, t1, t) } else { 0 };
    let (t0, t1) = (turned(t0, first), turned(t1, first));
    let m = Motion::new(patch, &t0, &t1, coordinate_error);
    let (a, b, c) = (mix(m.a[0], m.a[1], t), mix(m.b[0], m.b[1], t), mix(m.c[0], m.c[1], t));
    let unit = power_of_two(max_abs(a).max(max_abs(b)).max(max_abs(c)));
    let spread = Spread::new(&m, [scale(a, unit), scale(b, unit), scale(c, unit)], unit);
    let near = spread.nearest(patch);
    let (s, r, length) = (near.s, near.r, root(near.square));

    // From the patch to the vector: for edges that is from the first to the second.
    let sign = if matches!(patch, Patch::Triangle) { one } else { -one };
    let velocity = sub(sub(moved(m.a), scale(moved(m.b), s)), scale(moved(m.c), r));
    let normal = spread.normal(&near, length, sign, scale(velocity, sign), &m);
    // Not so where coordinates are no numbers, or so large that their differences are none.
    let is_unit = dot(normal, normal) > R::splat(0.5);
    let normal = if is_unit { normal } else { [one, R::splat(0.0), R::splat(0.0)] };

    let x =
        [mix(t0[0], t1[0], t), mix(t0[1], t1[1], t), mix(t0[2], t1[2], t), mix(t0[3], t1[3], t)];
    let (weights, on_a, on_b) = match patch {
        Patch::Triangle => {
            let w = [(one - s - r).max(R::splat(0.0)), s, r];
            let on_b = add(add(scale(x[1], w[0]), scale(x[2], w[1])), scale(x[3], w[2]));
            (turned_back([one, w[0], w[1], w[2]], first), x[0], on_b)
        }
        Patch::Parallelogram => ([one - s, s, one - r, r], mix(x[0], x[1], s), mix(x[2], x[3], r)),
    };
    let point = mix(on_a, on_b, R::splat(0.5));
    ContactGeometry { point, normal, weights, on_a, on_b, distance: length / unit }
}

/// The three vectors at the time that is looked at, in a unit in which the greatest component is
/// about 1, and what is known about their errors.
struct Spread<R> {
    a: [R; 3],
    b: [R; 3],
    c: [R; 3],
    /// `b x c`.
    n: [R; 3],
    /// Its length; 0 if that is no more than rounding.
    area: R,
    /// Bound of its error.
    area_error: R,
    /// Bound of the error of the vector between the nearest points.
    noise: R,
}

/// The nearest point of the patch.
struct Nearest<R> {
    s: R,
    r: R,
    /// From there to `a`, and the square of its length.
    w: [R; 3],
    square: R,
}

impl<R: Real> Spread<R> {
    /// Errors: a difference of coordinates has one unit of roundoff, its interpolation three of the
    /// greater end, products and sums of `a - s b - r c` up to six of all three: below `16 u` with
    /// the length of a vector of three components. Components of `b x c` err by those of `b` and
    /// `c`, and by two of their products.
    fn new(m: &Motion<R>, [a, b, c]: [[R; 3]; 3], unit: R) -> Self {
        let [ma, mb, mc] = m.magnitudes();
        let sixteen = R::UNIT * R::splat(16.0);
        let input = m.error * R::splat(4.0);
        let noise = ((ma + mb + mc) * sixteen + input) * unit;
        let n = cross(b, c);
        let (b_error, c_error) = (mb * sixteen + input, mc * sixteen + input);
        let area_error = b_error * unit * max_abs(c) + c_error * unit * max_abs(b);
        let length = root(dot(n, n));
        let area = if length > area_error { length } else { R::splat(0.0) };
        Self { a, b, c, n, area, area_error, noise }
    }

    fn at(&self, s: R, r: R) -> Nearest<R> {
        let w = sub(sub(self.a, scale(self.b, s)), scale(self.c, r));
        Nearest { s, r, w, square: dot(w, w) }
    }

    /// The `r` within `[0, most]` that is nearest for this `s`.
    fn best_r(&self, s: R, most: R) -> R {
        let to = sub(self.a, scale(self.b, s));
        within(dot(to, self.c) / dot(self.c, self.c), most)
    }

    /// The `s` within `[0, most]` that is nearest for this `r`.
    fn best_s(&self, r: R, most: R) -> R {
        let to = sub(self.a, scale(self.c, r));
        within(dot(to, self.b) / dot(self.b, self.b), most)
    }

    fn nearest(&self, patch: Patch) -> Nearest<R> {
        let (zero, one) = (R::splat(0.0), R::splat(1.0));
        let triangle = matches!(patch, Patch::Triangle);
        if self.area > zero {
            let nn = dot(self.n, self.n);
            let s = dot(cross(self.a, self.c), self.n) / nn;
            let r = dot(cross(self.b, self.a), self.n) / nn;
            let inside = if triangle { s + r <= one } else { s <= one && r <= one };
            if s >= zero && r >= zero && inside {
                let r = self.best_r(s, if triangle { one - s } else { one });
                let s = self.best_s(r, if triangle { one - r } else { one });
                return self.at(s, r);
            }
        } else if !triangle {
            // Both ends of the second edge along the first.
            let (p, q) = (dot(self.a, self.b), dot(sub(self.a, self.c), self.b));
            let bb = dot(self.b, self.b);
            let (low, high) = (within(p.min(q) / bb, one), within(p.max(q) / bb, one));
            if low < high {
                let s = (low + high) * R::splat(0.5);
                return self.at(s, self.best_r(s, one));
            }
        }
        let first =
            nearer(self.at(self.best_s(zero, one), zero), self.at(zero, self.best_r(zero, one)));
        if triangle {
            let side = sub(self.c, self.b);
            let r = within(dot(sub(self.a, self.b), side) / dot(side, side), one);
            nearer(first, self.at(one - r, r))
        } else {
            let second =
                nearer(self.at(one, self.best_r(one, one)), self.at(self.best_s(one, one), one));
            nearer(first, second)
        }
    }

    /// The normal by the rules above. `length`: of `w`; `sign`: from `w` to the direction from `b`
    /// to `a`; `velocity` is that of `a` relative to `b`, in the unit of the input.
    fn normal(
        &self,
        near: &Nearest<R>,
        length: R,
        sign: R,
        velocity: [R; 3],
        m: &Motion<R>,
    ) -> [R; 3] {
        let (zero, one) = (R::splat(0.0), R::splat(1.0));
        let (s, r) = (near.s, near.r);
        let (s_free, r_free) = (s > zero && s < one, r > zero && r < one);
        let triangle = sign > zero;
        let inside = s_free && r_free && (!triangle || s + r < one - R::UNIT * R::splat(4.0));
        let flat = self.area > zero;
        let across = scale(self.n, sign);
        if length > self.noise {
            let towards = scale(near.w, sign);
            if flat && inside && self.area_error * length <= self.noise * self.area {
                return unit_vector(if dot(towards, across) >= zero {
                    across
                } else {
                    scale(across, -one)
                });
            }
            return unit_vector(towards);
        }
        // A difference of two ends, of three vectors: twice the magnitudes, as many roundings.
        let [ma, mb, mc] = m.magnitudes();
        let still = (ma + mb + mc) * (R::UNIT * R::splat(32.0)) + m.error * R::splat(8.0);
        if flat {
            let direction = unit_vector(across);
            let speed = dot(velocity, direction);
            let unknown = still + sum_abs(velocity) * (self.area_error / self.area);
            if speed.abs() > unknown {
                return if speed < zero { direction } else { scale(direction, -one) };
            }
        }
        if !(flat && inside) {
            // Along the side on which they meet; nothing in a corner.
            let side = if triangle && s_free && r_free {
                sub(self.c, self.b)
            } else if s_free && !(r_free && max_abs(self.c) > max_abs(self.b)) {
                self.b
            } else if r_free {
                self.c
            } else {
                [zero; 3]
            };
            // One that has shrunk to rounding is no side.
            let side = if max_abs(side) > self.noise { side } else { [zero; 3] };
            let off = beside(velocity, side);
            if sum_abs(off) > still {
                return unit_vector(scale(off, -one));
            }
        }
        let some = if flat { unit_vector(across) } else { perpendicular(self.b, self.c) };
        if dot(velocity, some) > still { scale(some, -one) } else { some }
    }
}

/// The part of `v` perpendicular to `side`; all of it if that has no length.
fn beside<R: Real>(v: [R; 3], side: [R; 3]) -> [R; 3] {
    let length = max_abs(side);
    if length > R::splat(0.0) {
        let e = unit_vector(side);
        sub(v, scale(e, dot(v, e)))
    } else {
        v
    }
}

/// A unit vector perpendicular to the longer of two parallel vectors; the first axis if neither has
/// a length.
fn perpendicular<R: Real>(b: [R; 3], c: [R; 3]) -> [R; 3] {
    let (zero, one) = (R::splat(0.0), R::splat(1.0));
    let e = if max_abs(c) > max_abs(b) { c } else { b };
    if !(max_abs(e) > zero) {
        return [one, zero, zero];
    }
    let (x, y, z) = (e[0].abs(), e[1].abs(), e[2].abs());
    let axis = if x <= y && x <= z {
        [one, zero, zero]
    } else if y <= z {
        [zero, one, zero]
    } else {
        [zero, zero, one]
    };
    unit_vector(cross(unit_vector(e), axis))
}

/// The square root, to about one unit of roundoff.
fn root<R: Real>(x: R) -> R {
    let above = x.sqrt_up();
    if above > R::splat(0.0) { (above + x / above) * R::splat(0.5) } else { above }
}

/// `v`, which is finite and not zero, in unit length: to two units of roundoff, by a step of
/// Newton-Raphson after the division.
pub(super) fn unit_vector<R: Real>(v: [R; 3]) -> [R; 3] {
    let v = scale(v, power_of_two(max_abs(v)));
    let v = scale(v, R::splat(1.0) / dot(v, v).sqrt_up());
    scale(v, (R::splat(3.0) - dot(v, v)) * R::splat(0.5))
}

/// A power of two that brings `size` near 1: to `[1, 4)` from a normal number, to at least the unit
/// roundoff from a lesser one.
fn power_of_two<R: Real>(size: R) -> R {
    if !size.is_finite_number() {
        R::splat(1.0)
    } else if size >= R::MIN_NORMAL {
        size.to_unit()
    } else {
        R::splat(1.0) / R::MIN_NORMAL
    }
}

/// `x` limited to `[0, most]`; NaN (from a side of no length) becomes 0.
fn within<R: Real>(x: R, most: R) -> R {
    let zero = R::splat(0.0);
    if x > zero {
        let x = if x < most { x } else { most };
        if x > zero { x } else { zero }
    } else {
        zero
    }
}

/// What moves from the first to the second.
fn moved<R: Real>(x: [[R; 3]; 2]) -> [R; 3] {
    sub(x[1], x[0])
}

fn nearer<R: Real>(p: Nearest<R>, q: Nearest<R>) -> Nearest<R> {
    if q.square < p.square { q } else { p }
}

/// From `p` to `q`, without a difference that could overflow, and exact at both ends.
fn mix<R: Real>(p: [R; 3], q: [R; 3], t: R) -> [R; 3] {
    add(scale(p, R::splat(1.0) - t), scale(q, t))
}

/// The corner of the face opposite to its longest side, 0 to 2, at time `t`.
fn widest<R: Real>(t0: &[[R; 3]; 4], t1: &[[R; 3]; 4], t: R) -> u32 {
    let at_0 = sum_abs(mix(sub(t0[3], t0[2]), sub(t1[3], t1[2]), t));
    let at_1 = sum_abs(mix(sub(t0[1], t0[3]), sub(t1[1], t1[3]), t));
    let at_2 = sum_abs(mix(sub(t0[2], t0[1]), sub(t1[2], t1[1]), t));
    if at_0 >= at_1 && at_0 >= at_2 {
        0
    } else if at_1 >= at_2 {
        1
    } else {
        2
    }
}

/// The points with this corner of the face first.
fn turned<R: Real>(x: &[[R; 3]; 4], first: u32) -> [[R; 3]; 4] {
    match first {
        0 => *x,
        1 => [x[0], x[2], x[3], x[1]],
        _ => [x[0], x[3], x[1], x[2]],
    }
}

/// Weights of such points as those of the face as it was given.
fn turned_back<R: Real>(w: [R; 4], first: u32) -> [R; 4] {
    match first {
        0 => w,
        1 => [w[0], w[3], w[1], w[2]],
        _ => [w[0], w[2], w[3], w[1]],
    }
}
