//! Map: what a thread does when nodes are paired bottom up, each with the nearest one that is still
//! free [Tian and Wan].
//!
//! Nodes of a level are in an array. The first that is free is the target; every thread finds how
//! far its own node is from it, the least distance is found by comparing in pairs ([`nearer`]), and
//! the nearest node changes places with the one after the target. So the array becomes a sequence
//! of pairs, from which the next level is made; a node that is left over goes there as it is. The
//! paper does not say how far boxes are from each other; here it is the distance of their centres,
//! because boxes that overlap would all be at none.

use crate::math::aabb::Aabb;

/// Twice the centre of a box.
#[inline(always)]
pub fn centre(b: &Aabb<f32>) -> [f32; 3] {
    [b.min[0] + b.max[0], b.min[1] + b.max[1], b.min[2] + b.max[2]]
}

/// The square of the distance of two points.
#[inline(always)]
pub fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    let (x, y, z) = (a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    x * x + y * y + z * z
}

/// A distance and where in the array the node is that has it.
pub type Found = (f32, u32);

/// More than any distance in cells of a Morton grid.
pub const FAR: f32 = 3.0e38;

/// What a search begins with: the first node that is free, as if it were farther than any.
#[inline(always)]
pub fn beginning(first: u32) -> Found {
    (FAR, first)
}

/// The nearer of two nodes; of equally near ones that which comes first in the array. So the order
/// in which they are compared does not matter.
#[inline(always)]
pub fn nearer(a: Found, b: Found) -> Found {
    if b.0 < a.0 || (b.0 == a.0 && b.1 < a.1) { b } else { a }
}

/// Nodes of the level above a level of `n`.
#[inline(always)]
pub fn parents(n: usize) -> usize {
    n.div_ceil(2)
}
