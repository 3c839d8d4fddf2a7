//! Whether two features touch at a time, by signs.

use super::vector::{Number, Vector, cross, dot, minus};
use crate::narrow_phase::relative_motion::Patch;

/// The sign of a number at a time; `None` if what the number is computed with does not show it.
pub type Sign<'a, T> = &'a mut dyn FnMut(&T) -> Option<i32>;

/// A vector `a` against the patch of `b` and `c`, as in
/// [`relative_motion`](crate::narrow_phase::relative_motion).
pub struct Features<T> {
    patch: Patch,
    a: Vector<T>,
    b: Vector<T>,
    c: Vector<T>,
    /// Of the plane of the patch.
    normal: Vector<T>,
}

/// The points whose differences `a b c` are.
pub fn differences(patch: Patch) -> [[usize; 2]; 3] {
    match patch {
        Patch::Triangle => [[0, 1], [2, 1], [3, 1]],
        Patch::Parallelogram => [[2, 0], [1, 0], [2, 3]],
    }
}

impl<T: Number> Features<T> {
    /// From `v f0 f1 f2` or `ea0 ea1 eb0 eb1`.
    pub fn new(patch: Patch, x: &[Vector<T>; 4]) -> Self {
        Self::of_differences(patch, differences(patch).map(|[p, q]| minus(&x[p], &x[q])))
    }

    /// From `a b c`.
    pub fn of_differences(patch: Patch, [a, b, c]: [Vector<T>; 3]) -> Self {
        let normal = cross(&b, &c);
        Self { patch, a, b, c, normal }
    }

    /// The normal of the plane of the patch.
    pub fn normal(&self) -> &Vector<T> {
        &self.normal
    }

    /// `s` and `r` of `a = s b + r c` at contact, and 1, all times the square of the normal.
    pub fn weights(&self) -> [T; 3] {
        let Self { a, b, c, normal, .. } = self;
        [dot(&cross(a, c), normal), dot(&cross(b, a), normal), dot(normal, normal)]
    }

    /// 0 when the features are coplanar.
    pub fn coplanarity(&self) -> T {
        dot(&self.a, &self.normal)
    }

    /// The sides of the patch. Where it is flattened to a segment or a point, they cover all of it.
    pub fn boundary(&self) -> impl Iterator<Item = OnEdge<T>> {
        let Self { patch, a, b, c, .. } = self;
        let (ab, ac) = (minus(a, b), minus(a, c));
        // In the order of a way around it.
        let (corners, n) = match patch {
            Patch::Triangle => ([a.clone(), ab, ac.clone(), ac], 3),
            Patch::Parallelogram => ([a.clone(), ab.clone(), minus(&ab, c), ac], 4),
        };
        (0..n).map(move |i| OnEdge::new(&corners[i], &corners[(i + 1) % n]))
    }

    /// Whether they touch at a time at which they are coplanar.
    pub fn touch(&self, sign: Sign<T>) -> Option<bool> {
        let Self { patch, a, b, c, normal } = self;
        if all_zero(normal, sign)? {
            for edge in self.boundary() {
                if edge.touches(sign)? {
                    return Some(true);
                }
            }
            return Some(false);
        }
        // `a = s b + r c`, and both times the square of the normal.
        let s = dot(&cross(a, c), normal);
        if sign(&s)? < 0 {
            return Some(false);
        }
        let r = dot(&cross(b, a), normal);
        if sign(&r)? < 0 {
            return Some(false);
        }
        let one = dot(normal, normal);
        let rest = one.minus(&s);
        Some(match patch {
            Patch::Triangle => sign(&rest.minus(&r))? >= 0,
            Patch::Parallelogram => sign(&rest)? >= 0 && sign(&one.minus(&r))? >= 0,
        })
    }
}

/// Whether all of some numbers are 0.
fn all_zero<T>(all: &[T], sign: Sign<T>) -> Option<bool> {
    for x in all {
        if sign(x)? != 0 {
            return Some(false);
        }
    }
    Some(true)
}

/// A vertex and an edge, whose ends are seen from the vertex.
pub struct OnEdge<T> {
    /// The cross product of both ends, as seen from the vertex: 0 if all three are on one line.
    pub span: Vector<T>,
    /// Not positive if they are on two sides, or one of them at the vertex.
    pub sides: T,
}

impl<T: Number> OnEdge<T> {
    /// From the ends as seen from the vertex.
    pub fn new(e0: &Vector<T>, e1: &Vector<T>) -> Self {
        Self { span: cross(e0, e1), sides: dot(e0, e1) }
    }

    /// Whether they touch.
    pub fn touches(&self, sign: Sign<T>) -> Option<bool> {
        Some(all_zero(&self.span, sign)? && sign(&self.sides)? <= 0)
    }
}
