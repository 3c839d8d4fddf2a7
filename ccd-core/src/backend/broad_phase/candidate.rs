//! Which overlaps are candidates: features without a common vertex, of bodies that are wanted,
//! whose boxes overlap in the precision of the input.
//!
//! Written for one pair; the comparison of boxes serves lanes of pairs, too. A CPU compares the ids
//! of a row of eight by instructions of its own (`shared` in its `step/candidates.rs`).

use super::pair_rules::{classes_meet, is_excluded};
use crate::kernel::memory::at;
use crate::layout::VERTEX_FACE;
use crate::layout::{Frame, Leaf, split};
use crate::math::aabb::Aabb;
use crate::math::real::Num;

/// Whether a vertex is a corner of the face: then it is no candidate.
#[inline(always)]
pub fn is_corner(vertex: u32, face: [u32; 3]) -> bool {
    is_one_of(face[0], vertex, vertex)
        | is_one_of(face[1], vertex, vertex)
        | is_one_of(face[2], vertex, vertex)
}

/// Whether two edges have a common vertex: then they are no candidate.
#[inline(always)]
pub fn share_vertex(a: [u32; 2], b: [u32; 2]) -> bool {
    is_one_of(b[0], a[0], a[1]) | is_one_of(b[1], a[0], a[1])
}

#[inline(always)]
fn is_one_of(id: u32, a: u32, b: u32) -> bool {
    id == a || id == b
}

/// Whether features of two bodies are looked at, as far as their words say: not if both stand
/// still, and of one body only with self-contact. What [`pair_rules`](super::pair_rules) says
/// besides is asked where there is a table.
///
/// A word is four times the number of a body, plus two with self-contact, plus one if it stands
/// still: [`crate::backend::rules::Rules::words`].
#[inline(always)]
pub fn bodies_meet(a: u32, b: u32) -> bool {
    (a / 4 != b / 4 || a & 2 != 0) && a & b & 1 == 0
}

/// Whether two boxes overlap by more than `slack` on every axis: then also those that they were
/// rounded from. False if a bound is NaN.
#[inline(always)]
pub fn overlap_surely<N: Num>(a: &Aabb<N>, b: &Aabb<N>, slack: N) -> N::Mask {
    let x = (a.max[0] - b.min[0]).gt(slack) & (b.max[0] - a.min[0]).gt(slack);
    let y = (a.max[1] - b.min[1]).gt(slack) & (b.max[1] - a.min[1]).gt(slack);
    let z = (a.max[2] - b.min[2]).gt(slack) & (b.max[2] - a.min[2]).gt(slack);
    x & y & z
}

/// Keys of a vertex.
const KEYS: u32 = 6;

/// Whether two leaves of a device's trees, whose boxes overlap, are a candidate. `kind` 0: a vertex
/// and a face, 1: two edges.
///
/// `bodies`: a word per vertex, then, with [`Frame::FLAG_RULES`], the table of rules.
/// `keys`: per vertex the six bounds of its exact box, lower ones first, two words each, see
/// [`bound_key`].
#[inline(always)]
pub fn wanted(
    frame: &Frame,
    kind: u32,
    a: &Leaf,
    b: &Leaf,
    boxes: [&Aabb<f32>; 2],
    bodies: &[u32],
    keys: &[u32],
) -> bool {
    let (p, q) = (&a.vertices, &b.vertices);
    if are_neighbours(kind, a, b) {
        return false;
    }
    if frame.has(Frame::FLAG_BODIES) {
        let (body_a, body_b) = (at(bodies, p[0] as usize), at(bodies, q[0] as usize));
        if !bodies_meet(body_a, body_b) {
            return false;
        }
        if frame.has(Frame::FLAG_RULES) {
            let table = frame.count[0] as usize;
            if !classes_meet(body_a, body_b, bodies, table)
                || is_excluded(kind, a.id, b.id, bodies, table)
            {
                return false;
            }
        }
    }
    if frame.has(Frame::FLAG_CONFIRM) && !overlap_surely(boxes[0], boxes[1], frame.slack) {
        return overlap_exactly(p, q, keys);
    }
    true
}

/// Whether two leaves have a common vertex.
#[inline(always)]
pub fn are_neighbours(kind: u32, a: &Leaf, b: &Leaf) -> bool {
    let (p, q) = (&a.vertices, &b.vertices);
    if kind == VERTEX_FACE { is_corner(p[0], *q) } else { share_vertex([p[0], p[1]], [q[0], q[1]]) }
}

/// Whether the exact boxes of two features overlap. A loop, not three times its code: few pairs
/// come here.
#[inline(always)]
fn overlap_exactly(p: &[u32; 3], q: &[u32; 3], keys: &[u32]) -> bool {
    for axis in 0..3 {
        if above(least(p, axis, keys), greatest(q, axis, keys))
            || above(least(q, axis, keys), greatest(p, axis, keys))
        {
            return false;
        }
    }
    true
}

/// Whether the number of key `a` is greater than that of key `b`.
#[inline(always)]
pub fn above(a: [u32; 2], b: [u32; 2]) -> bool {
    a[1] > b[1] || (a[1] == b[1] && a[0] > b[0])
}

/// Key `i` among those of all vertices.
#[inline(always)]
fn key_at(keys: &[u32], i: u32) -> [u32; 2] {
    [at(keys, 2 * i as usize), at(keys, 2 * i as usize + 1)]
}

/// The key of the least lower bound of vertices on an axis.
#[inline(always)]
fn least(vertices: &[u32; 3], axis: u32, keys: &[u32]) -> [u32; 2] {
    let lesser = |a: [u32; 2], b: [u32; 2]| if above(a, b) { b } else { a };
    let key = |i: u32| key_at(keys, KEYS * i + axis);
    lesser(lesser(key(vertices[0]), key(vertices[1])), key(vertices[2]))
}

/// The key of the greatest upper bound.
#[inline(always)]
fn greatest(vertices: &[u32; 3], axis: u32, keys: &[u32]) -> [u32; 2] {
    let greater = |a: [u32; 2], b: [u32; 2]| if above(b, a) { b } else { a };
    let key = |i: u32| key_at(keys, KEYS * i + 3 + axis);
    greater(greater(key(vertices[0]), key(vertices[1])), key(vertices[2]))
}

/// A bound as two words, low first, whose order as integers is that of the numbers: exact
/// comparisons on devices without `f64`.
#[inline(always)]
pub fn bound_key(x: f64) -> [u32; 2] {
    let [low, high] = split(x);
    // Both zeros are equal as bounds. Without branches: signs are hard to foresee.
    let is_below_zero = (high >> 31 == 1) & !((high == 1 << 31) & (low == 0));
    let flip = 0u32.wrapping_sub(is_below_zero as u32);
    [low ^ flip, (high ^ flip) | (!flip & 1 << 31)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_in_the_order_of_numbers() {
        let x = [-1e300, -2.0, -1.0, -1e-300, 0.0, 1e-310, 1.0, 1.0 + f64::EPSILON, 4e9, 1e300];
        for i in 0..x.len() {
            for j in 0..x.len() {
                assert_eq!(
                    above(bound_key(x[i]), bound_key(x[j])),
                    x[i] > x[j],
                    "{:e} {:e}",
                    x[i],
                    x[j]
                );
            }
        }
        assert_eq!(bound_key(0.0), bound_key(-0.0));
    }

    #[test]
    fn neighbours_and_bodies_are_told_apart() {
        assert!(is_corner(5, [1, 5, 2]) && !is_corner(5, [1, 2, 3]));
        assert!(
            share_vertex([1, 2], [2, 9])
                && share_vertex([1, 2], [9, 1])
                && !share_vertex([1, 2], [3, 4])
        );
        let [a, b, fixed, other_fixed] = [4, 8, 15, 19];
        assert!(bodies_meet(a, b) && bodies_meet(a, fixed) && bodies_meet(b + 2, b + 2));
        assert!(
            !bodies_meet(a, a) && !bodies_meet(fixed, other_fixed) && !bodies_meet(fixed, fixed)
        );
    }

    #[test]
    fn sure_overlap_is_more_than_the_slack() {
        let of = |min: f32, max: f32| Aabb { min: [min, 0.0, 0.0], max: [max, 1.0, 1.0] };
        assert!(overlap_surely(&of(0.0, 1.0), &of(0.5, 2.0), 0.25));
        assert!(
            !overlap_surely(&of(0.0, 1.0), &of(0.75, 2.0), 0.25)
                && !overlap_surely(&of(0.0, f32::NAN), &of(0.5, 2.0), 0.25)
        );
    }
}
