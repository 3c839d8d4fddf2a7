//! Emit: sort and sweep with a thread an end point [Karras 2012a]. Both ends of all boxes along one
//! axis are sorted; the thread of a start walks forward to the end of the same box and tests every
//! box that starts on the way.
//!
//! ```text
//!   a |---------|           sorted:  a( b( c( a) c) b)
//!   b    |-----------|      a( meets b( and c(, and stops at a)
//!   c       |-----|         b( meets c(, passes a) and c), and stops at b)
//!   ------------------>     threads of a), b), c) are done at once
//! ```
//!
//! **Each pair is found once.** Of two starts one comes first in the sorted list, whatever their
//! keys are, and only its thread can meet the other. **No pair is missed.** Boxes are closed: two
//! that overlap begin, each, no later than the other ends. The places of numbers have their order
//! ([`place_on_axis`]), and at one place starts come before ends, because the lowest bit of a key
//! says which it is. So the later of two starts stands before the end of the box of the other.
//!
//! Boxes of vertices and of faces are in one list, which comes first, and a thread passes over
//! those of its own set; edges are in the other.
//!
//! Cost: a sort of two keys a box, then a step for every end point inside a box's interval, ends
//! among them: twice the steps of a sweep over starts alone, as [`super::key_intervals`] and a CPU
//! do it. Half of the threads have nothing to do, and the others as much as their box is long: this
//! divergence is what the source shows by it, and why it is here.

use crate::broad_phase::block_bvh::sets;
use crate::broad_phase::key_intervals::place_on_axis;
use crate::broad_phase::stack_traversal::NONE;
use crate::kernel::memory::at;
use crate::layout::{EDGE_EDGE, Pair, VERTEX_FACE};
use crate::math::aabb::Aabb;

/// Marks the end of a box in an end point; the other bits are the number of the box.
const END: u32 = 1;

/// The two end points of box `i`, start and end.
#[inline(always)]
pub fn points(i: u32) -> [u32; 2] {
    [i << 1, i << 1 | END]
}

/// Their keys. From the highest bit: the list, the place on the axis, and whether the box ends.
#[inline(always)]
pub fn keys(set: u32, b: &Aabb<f32>, axis: u32) -> [u32; 2] {
    let list = ((set == 1) as u32) << 31;
    [list | place_on_axis(&b.min, axis) << 1, list | place_on_axis(&b.max, axis) << 1 | END]
}

/// First end point of a kind of pairs among all sorted ones, and the first behind the last.
/// `count`: boxes of each set.
#[inline(always)]
pub fn range(kind: u32, count: &[u32; 3]) -> [u32; 2] {
    let first_list = 2 * (count[0] + count[2]);
    if kind == EDGE_EDGE { [first_list, first_list + 2 * count[1]] } else { [0, first_list] }
}

/// The kind of pairs that end point `k` is for.
#[inline(always)]
pub fn kind_of(k: u32, count: &[u32; 3]) -> u32 {
    if k < range(VERTEX_FACE, count)[1] { VERTEX_FACE } else { EDGE_EDGE }
}

/// The walk of a thread between two of its steps.
#[derive(Clone, Copy, Debug)]
pub struct Walk {
    own: u32,
    k: u32,
    /// Whether the box is still open.
    pub goes_on: bool,
}

impl Walk {
    /// At end point `k`: a walk that goes on if a box starts there.
    #[inline(always)]
    pub fn new(points: &[u32], k: u32) -> Self {
        let own = at(points, k as usize);
        Self { own, k, goes_on: own & END == 0 }
    }

    /// The box whose end point this is.
    #[inline(always)]
    pub fn box_idx(&self) -> u32 {
        self.own >> 1
    }

    /// Goes to the next end point. Returns the box that starts there, [`NONE`] if one ends; the
    /// walk is over if that is its own. The end of a box stands behind its start, so that of `n`
    /// end points in the list there are fewer than `n` steps.
    #[inline(always)]
    pub fn step(&mut self, points: &[u32]) -> u32 {
        self.k += 1;
        let point = at(points, self.k as usize);
        self.goes_on = point != self.own | END;
        if point & END == 0 { point >> 1 } else { NONE }
    }
}

/// Whether two boxes can be a pair: not two of vertices, nor two of faces. `start`: first box of
/// each set.
#[inline(always)]
pub fn may_pair(kind: u32, start: &[u32; 4], i: u32, j: u32) -> bool {
    kind == EDGE_EDGE || (i < start[1]) != (j < start[1])
}

/// The ids of two boxes of a pair.
#[inline(always)]
pub fn pair(kind: u32, start: &[u32; 4], i: u32, j: u32) -> Pair {
    let [a, b] = sets(kind);
    let Pair { a: first, b: second } = Pair::ordered(i, j);
    Pair { a: first - start[a], b: second - start[b] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use std::collections::BTreeMap;
    use std::vec::Vec;

    /// How often each pair is found, by all threads one after the other; `sets` are vertices, edges
    /// and faces.
    fn found(sets: [&[Aabb]; 3], kind: u32, axis: u32) -> BTreeMap<(u32, u32), u32> {
        let boxes = sets.concat();
        let count = sets.map(|set| set.len() as u32);
        let start = [0, count[0], count[0] + count[1], boxes.len() as u32];
        let set_of = |i: u32| (i >= start[1]) as u32 + (i >= start[2]) as u32;
        let all = (0..boxes.len() as u32)
            .flat_map(|i| keys(set_of(i), &boxes[i as usize], axis).into_iter().zip(points(i)));
        let mut all = Vec::from_iter(all);
        all.sort_by_key(|&(key, _)| key);
        let list = Vec::from_iter(all.into_iter().map(|(_, point)| point));
        let [first, end] = range(kind, &count);
        let mut out = BTreeMap::new();
        for k in first..end {
            assert_eq!(kind_of(k, &count), kind);
            let mut walk = Walk::new(&list, k);
            let i = walk.box_idx();
            while walk.goes_on {
                let j = walk.step(&list);
                assert!(walk.k < end, "the end of box {i} is missed");
                let tested = j != NONE && may_pair(kind, &start, i, j);
                if tested && boxes[i as usize].overlaps(&boxes[j as usize]) {
                    let Pair { a, b } = pair(kind, &start, i, j);
                    *out.entry((a, b)).or_insert(0) += 1;
                }
            }
        }
        out
    }

    fn check(boxes: &[Aabb], axis: u32) -> usize {
        let (a, b) = boxes.split_at(boxes.len() / 3);
        let overlap = |x: &[Aabb], y: &[Aabb], within: bool| {
            let mut want = BTreeMap::new();
            for (i, p) in (0..).zip(x) {
                let others = (0..).zip(y).filter(|&(j, q)| (!within || i < j) && p.overlaps(q));
                want.extend(others.map(|(j, _)| ((i, j), 1u32)));
            }
            want
        };
        let within = overlap(boxes, boxes, true);
        assert_eq!(found([a, boxes, b], EDGE_EDGE, axis), within, "within one set");
        let between = overlap(a, b, false);
        assert_eq!(found([a, boxes, b], VERTEX_FACE, axis), between, "between two sets");
        assert_eq!(found([b, &[], a], VERTEX_FACE, axis).len(), between.len());
        within.len()
    }

    #[test]
    fn every_pair_is_found_once() {
        let mut random = Random::new(4);
        for (side, size, lattice) in
            [(1.0, 0.1, 0.0), (6.0, 1.0, 1.0), (3.3e38, 5e37, 0.0), (1e-37, 2e-38, 0.0)]
        {
            let mut place = || {
                let x = (random.unit() as f32 - 0.5) * side;
                if lattice > 0.0 { (x / lattice) as i32 as f32 * lattice } else { x }
            };
            let corners = (0..90).map(|_| [place(), place(), place()]);
            let grown = |min: [f32; 3]| Aabb { min, max: min.map(|c| c + size) };
            let mut boxes = Vec::from_iter(corners.map(grown));
            // Points where others begin or end, and one box that holds all.
            let points = boxes.iter().take(30).flat_map(|b| [b.min, b.max]).map(Aabb::of_point);
            boxes.extend(Vec::from_iter(points));
            boxes.push(Aabb { min: [-0.5 * side; 3], max: [0.5 * side; 3] });
            for axis in 0..3 {
                assert!(check(&boxes, axis) > 100, "few pairs in {side}");
            }
        }
    }

    #[test]
    fn boxes_that_touch_at_zeros_of_both_signs() {
        let ends = [[-0.0, 0.0], [0.0, 0.0], [-0.0, -0.0], [-1.0, -0.0], [0.0, 1.0]];
        let boxes = ends.map(|[min, max]| Aabb { min: [min; 3], max: [max; 3] });
        assert_eq!(check(&boxes, 2), 10);
        assert_eq!(check(&boxes[..1], 0), 0);
    }
}
