//! Squared distance of two features at one moment, with its gradient and its Hessian: what a
//! barrier or a penalty of a solver is made of.
//!
//! Which points of the features are nearest is the type of the distance. Within one type the
//! squared distance is smooth; where types change, only its first derivatives are continuous. The
//! types are those of ipc-toolkit, with the same numbers.
//!
//! All sixteen are one formula. Up to two parameters move the nearest points along edges or in the
//! face; `w`, `a` and `b` are differences of two vertices each:
//!
//! ```text
//!   f(x) = min over p, q of |r|^2,   r = w + p a + q b = sum of l_i x_i
//! ```
//!
//! The gradient of `f` by vertex `i` is `2 l_i r`, with the weights `l` of the minimum, where `f`
//! does not change with `p` and `q`. The Hessian is that of `F(x, p, q) = |r|^2` by `x`, less what
//! the parameters give way: `F_xx - F_xp (F_pp)^-1 F_px`, where `F_pp` has at most two rows.
//!
//! Nothing here is certified, unlike in [`Distance`](super::distance::Distance): results are
//! rounded. Where two edges come near parallel, the nearest points, and with them the gradient, are
//! known as badly as rounding of the coordinates lets them be, and the Hessian grows without bound.
//!
//! Beside vertex-face and edge-edge pairs, other pairs are types of these: a vertex and an edge are
//! nearest as [`VertexFaceType::F0F1`] says, or one of its ends.

use crate::math::real::Real;
use crate::math::vec3::{add, cross, dot, max_abs, scale, sub};

/// Positions of the vertices `v f0 f1 f2` or `ea0 ea1 eb0 eb1`.
type Points = [[f64; 3]; 4];

/// A squared distance of one type, in the square of the unit of length, with its derivatives by the
/// twelve coordinates, vertex by vertex.
///
/// ```
/// use ccd::squared_distance::VertexFaceType;
///
/// let x = [[0.25, 0.5, 0.25], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
/// let kind = VertexFaceType::of(&x);
/// let d = kind.at(&x);
/// assert_eq!((kind, d.value()), (VertexFaceType::Face, 0.25));
/// assert_eq!(d.gradient()[..6], [0.0, 1.0, 0.0, 0.0, -0.5, 0.0]);
/// assert_eq!(d.hessian()[1][1], 2.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SquaredDistance {
    /// Weights of the vertices in `r`.
    weights: [f64; 4],
    /// Between the nearest points, in `unit`.
    r: [f64; 3],
    /// `a` and `b` as weights of the vertices; zero where the type has none.
    free: [[f64; 4]; 2],
    /// `a` and `b`, in `unit`.
    along: [[f64; 3]; 2],
    /// The inverse of the matrix of their scalar products: elements (0, 0), (0, 1), (1, 1).
    inverse: [f64; 3],
    /// Coordinates were multiplied by it: a power of two.
    unit: f64,
}

impl SquaredDistance {
    fn new(Form { w, free, n_free }: Form, x: &Points) -> Self {
        let unit = unit_of(x);
        let difference = |[i, j]: [usize; 2]| scale(sub(x[i], x[j]), unit);
        let (w_at, along) = (difference(w), free.map(difference));
        let [a, b] = along;
        let (p, inverse, r) = match n_free {
            0 => ([0.0; 2], [0.0; 3], w_at),
            1 => {
                let aa = dot(a, a);
                let p = -dot(w_at, a) / aa;
                ([p, 0.0], [1.0 / aa, 0.0, 0.0], add(w_at, scale(a, p)))
            }
            _ => {
                let n = cross(a, b);
                let nn = dot(n, n);
                let p = [-dot(w_at, cross(b, n)) / nn, -dot(w_at, cross(n, a)) / nn];
                (p, [dot(b, b), -dot(a, b), dot(a, a)].map(|x| x / nn), scale(n, dot(w_at, n) / nn))
            }
        };
        let (w, free) = (weights_of(w), free.map(weights_of));
        let weights = [0, 1, 2, 3].map(|i| w[i] + p[0] * free[0][i] + p[1] * free[1][i]);
        Self { weights, r, free, along, inverse, unit }
    }

    /// The squared distance.
    pub fn value(&self) -> f64 {
        let r = scale(self.r, 1.0 / self.unit);
        dot(r, r)
    }

    /// First derivatives, in the unit of length.
    pub fn gradient(&self) -> [f64; 12] {
        core::array::from_fn(|i| 2.0 * self.weights[i / 3] * (self.r[i % 3] / self.unit))
    }

    /// Second derivatives, without a unit. Symmetric to the bit; it may have negative eigenvalues.
    pub fn hessian(&self) -> [[f64; 12]; 12] {
        let Self { weights, r, free, along, inverse: [aa, ab, bb], .. } = self;
        // Half of the mixed derivatives by coordinate and parameter.
        let mixed =
            |k: usize, i: usize| free[k][i / 3] * r[i % 3] + weights[i / 3] * along[k][i % 3];
        let (a, b): ([f64; 12], [f64; 12]) =
            (core::array::from_fn(|i| mixed(0, i)), core::array::from_fn(|i| mixed(1, i)));
        let mut out = [[0.0; 12]; 12];
        for i in 0..12 {
            for j in i..12 {
                let direct = if i % 3 == j % 3 { weights[i / 3] * weights[j / 3] } else { 0.0 };
                let gives = aa * a[i] * a[j] + ab * (a[i] * b[j] + b[i] * a[j]) + bb * b[i] * b[j];
                out[i][j] = 2.0 * (direct - gives);
                out[j][i] = out[i][j];
            }
        }
        out
    }
}

/// Differences by the places of their vertices: the first minus the second.
struct Form {
    w: [usize; 2],
    free: [[usize; 2]; 2],
    n_free: u8,
}

/// At less, rounding may have made most of a normal: of edges on one line all of it. Above, the
/// normal's direction is known to some `2^-26`, and so is the distance to the size.
const LEAST_SINE_SQUARED: f64 = f64::EPSILON;

/// No difference.
const NONE: [usize; 2] = [0; 2];

fn points(w: [usize; 2]) -> Form {
    Form { w, free: [NONE; 2], n_free: 0 }
}

fn line(w: [usize; 2], along: [usize; 2]) -> Form {
    Form { w, free: [along, NONE], n_free: 1 }
}

fn plane(w: [usize; 2], free: [[usize; 2]; 2]) -> Form {
    Form { w, free, n_free: 2 }
}

/// A difference as weights of the vertices.
fn weights_of([i, j]: [usize; 2]) -> [f64; 4] {
    core::array::from_fn(|k| (k == i) as u8 as f64 - (k == j) as u8 as f64)
}

/// Which part of a face `f0 f1 f2` is nearest to a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum VertexFaceType {
    /// The corner `f0`.
    F0 = 0,
    /// The corner `f1`.
    F1 = 1,
    /// The corner `f2`.
    F2 = 2,
    /// The inside of the side from `f0` to `f1`.
    F0F1 = 3,
    /// The inside of the side from `f1` to `f2`.
    F1F2 = 4,
    /// The inside of the side from `f2` to `f0`.
    F2F0 = 5,
    /// The inside of the face.
    Face = 6,
}

impl VertexFaceType {
    /// All, in the order of their numbers.
    pub const ALL: [Self; 7] =
        [Self::F0, Self::F1, Self::F2, Self::F0F1, Self::F1F2, Self::F2F0, Self::Face];

    /// The type at these positions. On the border of two it is either; of corners and sides that
    /// are equally far, that with the least number of a corner or of an end. A face whose sides at
    /// `f0` meet at an angle below 1.5e-8 counts as its three sides.
    pub fn of(x: &Points) -> Self {
        let d = in_unit(x);
        let (a, b, c) = (d([0, 1]), d([2, 1]), d([3, 1]));
        let n = cross(b, c);
        let (s, r) = (dot(cross(a, c), n), dot(cross(b, a), n));
        let nn = dot(n, n);
        if s > 0.0 && r > 0.0 && s + r < nn && nn > LEAST_SINE_SQUARED * dot(b, b) * dot(c, c) {
            return Self::Face;
        }
        nearest([
            beside(&d, 0, [1, 2], [Self::F0, Self::F1, Self::F0F1]),
            beside(&d, 0, [2, 3], [Self::F1, Self::F2, Self::F1F2]),
            beside(&d, 0, [3, 1], [Self::F2, Self::F0, Self::F2F0]),
        ])
    }

    /// The squared distance of this type: of the point or the line or the plane that it names,
    /// whether the nearest point is within the face or not. NaN where a side or the face that it
    /// names has no extent; [`VertexFaceType::of`] names none that has not.
    pub fn at(self, x: &Points) -> SquaredDistance {
        let form = match self {
            Self::F0 => points([0, 1]),
            Self::F1 => points([0, 2]),
            Self::F2 => points([0, 3]),
            Self::F0F1 => line([0, 1], [1, 2]),
            Self::F1F2 => line([0, 2], [2, 3]),
            Self::F2F0 => line([0, 3], [3, 1]),
            Self::Face => plane([0, 1], [[1, 2], [1, 3]]),
        };
        SquaredDistance::new(form, x)
    }
}

/// Which parts of two edges, `ea0 ea1` and `eb0 eb1`, are nearest to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u8)]
pub enum EdgeEdgeType {
    /// The ends `ea0` and `eb0`.
    A0B0 = 0,
    /// The ends `ea0` and `eb1`.
    A0B1 = 1,
    /// The ends `ea1` and `eb0`.
    A1B0 = 2,
    /// The ends `ea1` and `eb1`.
    A1B1 = 3,
    /// The inside of the first edge and the end `eb0`.
    AB0 = 4,
    /// The inside of the first edge and the end `eb1`.
    AB1 = 5,
    /// The end `ea0` and the inside of the second edge.
    A0B = 6,
    /// The end `ea1` and the inside of the second edge.
    A1B = 7,
    /// The insides of both.
    AB = 8,
}

impl EdgeEdgeType {
    /// All, in the order of their numbers.
    pub const ALL: [Self; 9] = [
        Self::A0B0,
        Self::A0B1,
        Self::A1B0,
        Self::A1B1,
        Self::AB0,
        Self::AB1,
        Self::A0B,
        Self::A1B,
        Self::AB,
    ];

    /// The type at these positions. On the border of two it is either; of parallel edges (those at
    /// an angle below 1.5e-8), it is that of an end, of `ea0` before `ea1`, `eb0`, `eb1` where
    /// several are equally near.
    pub fn of(x: &Points) -> Self {
        let d = in_unit(x);
        let (u, v, w) = (d([1, 0]), d([3, 2]), d([2, 0]));
        let n = cross(u, v);
        let nn = dot(n, n);
        let (s, t) = (dot(cross(w, v), n), dot(cross(w, u), n));
        let inside = s > 0.0 && s < nn && t > 0.0 && t < nn;
        if inside && nn > LEAST_SINE_SQUARED * dot(u, u) * dot(v, v) {
            return Self::AB;
        }
        nearest([
            beside(&d, 0, [2, 3], [Self::A0B0, Self::A0B1, Self::A0B]),
            beside(&d, 1, [2, 3], [Self::A1B0, Self::A1B1, Self::A1B]),
            beside(&d, 2, [0, 1], [Self::A0B0, Self::A1B0, Self::AB0]),
            beside(&d, 3, [0, 1], [Self::A0B1, Self::A1B1, Self::AB1]),
        ])
    }

    /// The squared distance of this type: of the points or lines that it names, whether the nearest
    /// points are within the edges or not. NaN where an edge that it names has no length, or both
    /// are parallel; [`EdgeEdgeType::of`] names none that are.
    pub fn at(self, x: &Points) -> SquaredDistance {
        let (along_a, along_b) = ([1, 0], [2, 3]);
        let form = match self {
            Self::A0B0 => points([0, 2]),
            Self::A0B1 => points([0, 3]),
            Self::A1B0 => points([1, 2]),
            Self::A1B1 => points([1, 3]),
            Self::AB0 => line([0, 2], along_a),
            Self::AB1 => line([0, 3], along_a),
            Self::A0B => line([0, 2], along_b),
            Self::A1B => line([1, 2], along_b),
            Self::AB => plane([0, 2], [along_a, along_b]),
        };
        SquaredDistance::new(form, x)
    }
}

/// The square of the distance from a vertex to a segment, by differences of vertices, and which of
/// the three is nearest: its first end, its second end, or its inside.
fn beside<T>(
    difference: &impl Fn([usize; 2]) -> [f64; 3],
    p: usize,
    [e0, e1]: [usize; 2],
    [first, second, inside]: [T; 3],
) -> (f64, T) {
    let [e, w, back] = [[e1, e0], [p, e0], [p, e1]].map(difference);
    let along = dot(w, e);
    if !(along > 0.0) {
        (dot(w, w), first)
    } else if !(dot(back, e) < 0.0) {
        (dot(back, back), second)
    } else {
        let r = sub(w, scale(e, along / dot(e, e)));
        (dot(r, r), inside)
    }
}

/// The first of those with the least square.
fn nearest<T: Copy, const N: usize>(all: [(f64, T); N]) -> T {
    all.iter().skip(1).fold(all[0], |best, &next| if next.0 < best.0 { next } else { best }).1
}

/// A power of two that brings differences of coordinates near 1, so that their fourth powers
/// neither overflow nor vanish; 1 where they are no numbers, or all are zero.
fn unit_of([p, others @ ..]: &Points) -> f64 {
    let size = others.iter().fold(0.0, |most, &q| f64::max(most, max_abs(sub(q, *p))));
    if size >= f64::MIN_POSITIVE && size.is_finite() { size.to_unit() } else { 1.0 }
}

/// Differences in that unit, by the places of their vertices: the first minus the second.
fn in_unit(x: &Points) -> impl Fn([usize; 2]) -> [f64; 3] {
    let unit = unit_of(x);
    move |[i, j]| scale(sub(x[i], x[j]), unit)
}

#[cfg(test)]
mod tests;
