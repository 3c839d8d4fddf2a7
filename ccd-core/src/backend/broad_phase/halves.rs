//! Sort: boxes that follow each other along a curve, in order by halves.
//!
//! A run of [`RUN`] boxes is halved at the median of that axis whose halves have the least surface,
//! and so is each half, down to blocks. A curve sees centres in cells of a grid; halves see whole
//! boxes, which are long where something moves. Pairs of blocks are a sixth to a quarter fewer.

use super::block_bvh::{PADDING, WIDTH};
use super::morton_key::order_key;
use super::ploc::distance;
use crate::math::aabb::Aabb;

/// Boxes that are put in order together: no more than a set is padded to, so that a run is of one.
pub const RUN: u32 = PADDING;
/// How often a run is halved.
pub const LEVELS: u32 = (RUN / WIDTH).ilog2();

/// The centre of box `i` of a run along an axis, for comparisons: its highest 24 bits, then `i`, so
/// that no two are the same. Where there is no box, more than all others.
#[inline(always)]
pub fn key(aabb: &Aabb<f32>, axis: usize, i: u32) -> u32 {
    let (min, max) = (aabb.min[axis], aabb.max[axis]);
    let bits = if min <= max { order_key(0.5 * min + 0.5 * max) } else { u32::MAX };
    bits & !(RUN - 1) | i
}

/// Half the surface of a box; of nothing 0.
#[inline(always)]
pub fn half_surface(b: &Aabb<f32>) -> f32 {
    if b.min[0] <= b.max[0] { distance(b, b) } else { 0.0 }
}

/// The axis of the least of three surfaces, the first of equal ones.
#[inline(always)]
pub fn least(surfaces: [f32; 3]) -> usize {
    let [x, y, z] = surfaces;
    if y < x {
        if z < y { 2 } else { 1 }
    } else if z < x {
        2
    } else {
        0
    }
}

/// The place along an axis.
#[inline(always)]
pub fn place(axis: usize, [x, y, z]: [u32; 3]) -> u32 {
    if axis == 0 {
        x
    } else if axis == 1 {
        y
    } else {
        z
    }
}
