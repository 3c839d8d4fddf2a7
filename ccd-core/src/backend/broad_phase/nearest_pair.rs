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

/// Nodes up to which one workgroup looks for the nearest, so that a dispatch has many targets: four
/// a thread. Of more the whole device does, a thread each, and a target is two dispatches.
pub const FEW: u32 = 1024;

/// Targets of a level of `n` nodes, the first ones, that more than `few` nodes come after.
pub fn wide_targets(n: u32, few: u32) -> u32 {
    n.saturating_sub(few.saturating_add(1)).div_ceil(2)
}

/// Words in which the whole device looks for the nearest of `n` nodes: the place of the target,
/// and of every 256 nodes the least distance and where it is.
pub fn words(n: u32) -> u32 {
    1 + 2 * n.div_ceil(GROUP)
}

/// Nodes of a workgroup, a thread each.
pub const GROUP: u32 = 256;

/// Nodes of the level above a level of `n`.
#[inline(always)]
pub fn parents(n: usize) -> usize {
    n.div_ceil(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wide_targets_are_those_before_many_nodes() {
        for n in 0..60u32 {
            for few in [0, 1, 2, 7, 31, 58, 59, u32::MAX] {
                let want = (0..n / 2).filter(|k| n - 2 * k - 1 > few).count();
                assert_eq!(wide_targets(n, few) as usize, want, "{n} nodes, few: {few}");
            }
        }
    }
}
