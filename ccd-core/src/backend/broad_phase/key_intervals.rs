//! Emit: boxes in the order of a key, each against those whose keys lie in an interval: what sort
//! and sweep, a uniform grid and brute force are to a device.
//!
//! ```text
//!   keys   1 1 2 3 3 4 5 5 6 7 8 9        a group of boxes that follow each other ...
//!          [ group ]                      ... and the interval of each of them:
//!          |-----------|   |------|       all keys of interest to the group are one range,
//!             |-----------|               cut into chunks, each a piece of work of its own
//! ```
//!
//! A method says what the key of a box is and which intervals of keys its partners have; several
//! intervals (*rows*) are disjoint, so that every pair is found once. A workgroup takes a group of
//! [`GROUP`] boxes, one a thread, and a chunk of at most [`CHUNK`] boxes, which pass through
//! workgroup memory [`GROUP`] at a time: reads are coalesced, threads do not diverge, and how
//! unequal boxes are decides how many pieces of work there are but not how long one takes. Within
//! one set only boxes that come later are partners.
//!
//! | method | key | rows within a set | between two |
//! |---|---|---|---|
//! | brute force | none | 1 | 1 |
//! | sweep and prune | where a box begins on an axis | 1 | 2 |
//! | uniform grid | its cell | 5 | 9 |
//!
//! Of two sets, sweep and prune asks for the boxes of the second that begin in one of the first or
//! with it, and then for those of the first that begin in one of the second, and not with it. A row
//! of a grid is three cells that follow each other along `x`; within one set half of the
//! neighbours are enough.
//!
//! Cost: a sort of 32-bit keys, then as many tests as there are pairs of boxes of a group with its
//! ranges. Keys have the set in their two highest bits, so that one sort serves all sets.

use crate::broad_phase::block_bvh::sets;
use crate::broad_phase::morton_key::{from_order_key, merged};
use crate::broad_phase::sweep_and_prune::axis_key;
use crate::broad_phase::uniform_grid::{self, OWN_ROW, Sizes, UniformGrid};
use crate::kernel::memory::at;
use crate::layout::EDGE_EDGE;
use crate::math::aabb::Aabb;

/// Boxes of a group, and threads of a workgroup.
pub const GROUP: u32 = 128;
/// Boxes that a piece of work compares with a group, at most.
pub const CHUNK: u32 = 8 * GROUP;
/// Pairs that a workgroup gathers before it writes them; those beyond are written one by one.
pub const POOL: u32 = 2048;

/// Every box against every other.
pub const BRUTE_FORCE: u32 = 0;
/// Sort and sweep.
pub const SWEEP_AND_PRUNE: u32 = 1;
/// A uniform grid.
pub const UNIFORM_GRID: u32 = 2;

/// Words of a survey: bounds of all boxes as in `morton_key::merged`; the axis of
/// a sweep, or half of the largest side on each axis, as `order_key`.
pub const SURVEY_WORDS: usize = 9;
/// Where the axis, or the three sides, stand in a survey.
pub const FOUND: usize = 6;
/// Bits of a key below the set.
const BITS: u32 = 30;

/// Rows of a method for a kind of pairs.
#[inline(always)]
pub fn rows(method: u32, kind: u32) -> u32 {
    match (method, kind) {
        (SWEEP_AND_PRUNE, 0) => 2,
        (UNIFORM_GRID, 0) => 9,
        (UNIFORM_GRID, _) => 5,
        _ => 1,
    }
}

/// The set whose boxes ask in a row, and the set that they ask.
#[inline(always)]
pub fn asks(method: u32, kind: u32, row: u32) -> [u32; 2] {
    let [a, b] = sets(kind);
    if method == SWEEP_AND_PRUNE && row == 1 { [b as u32, a as u32] } else { [a as u32, b as u32] }
}

/// The key of a box of `set`.
#[inline(always)]
pub fn key(method: u32, set: u32, b: &Aabb<f32>, survey: &[u32]) -> u32 {
    let place = if method == SWEEP_AND_PRUNE {
        place_on_axis(&b.min, at(survey, FOUND))
    } else if method == UNIFORM_GRID {
        uniform_grid::key(UniformGrid::new(&sizes(survey)).cell(b))
    } else {
        0
    };
    set << BITS | place
}

/// The first and the last key of the partners in a row of a box of key `key`; a first that is
/// greater than the last where there are none. `asked`: the set that is asked.
#[inline(always)]
pub fn interval(
    method: u32,
    kind: u32,
    row: u32,
    asked: u32,
    key: u32,
    b: &Aabb<f32>,
    survey: &[u32],
) -> [u32; 2] {
    let set = asked << BITS;
    let place = key & ((1 << BITS) - 1);
    if method == SWEEP_AND_PRUNE {
        // Of two that begin at one place the one of the first set asks.
        [(set | place) + row, set | place_on_axis(&b.max, at(survey, FOUND))]
    } else if method == UNIFORM_GRID {
        // Within a set, rows from that of the own cell on.
        let forward = kind == EDGE_EDGE;
        let row = if forward { OWN_ROW + row } else { row };
        let [first, last] = uniform_grid::row(uniform_grid::cell_of(place), row, forward);
        [set | first, set | last]
    } else {
        [set, set]
    }
}

/// Where a corner is on an axis, as an integer of 30 bits of the same order: a little coarser than
/// the number itself, so that what is equal here need not be equal there; an overlap of boxes is
/// one of these, too.
#[inline(always)]
pub fn place_on_axis(p: &[f32; 3], axis: u32) -> u32 {
    axis_key(if axis == 0 {
        p[0]
    } else if axis == 1 {
        p[1]
    } else {
        p[2]
    }) >> 2
}

/// What a survey says of bounds and sides.
#[inline(always)]
pub fn sizes(survey: &[u32]) -> Sizes {
    let half = [
        from_order_key(at(survey, FOUND)),
        from_order_key(at(survey, FOUND + 1)),
        from_order_key(at(survey, FOUND + 2)),
    ];
    Sizes { scene: merged(survey), half }
}

/// A piece of work in two words: row, boxes of the chunk in groups, and group of those who ask;
/// first box of the chunk.
#[inline(always)]
pub fn pack(row: u32, tiles: u32, group: u32, first: u32) -> [u32; 2] {
    [row << 28 | (tiles - 1) << 24 | group, first]
}

/// Row, groups in the chunk, group that asks, and first box of the chunk.
#[inline(always)]
pub fn unpack(work: [u32; 2]) -> [u32; 4] {
    [work[0] >> 28, (work[0] >> 24 & 15) + 1, work[0] & 0xff_ffff, work[1]]
}

/// The first of `n` sorted keys that is not less than `key`; `n` if there is none. At most 32
/// steps.
#[inline(always)]
pub fn lower_bound(keys: &[u32], n: u32, key: u32) -> u32 {
    let (mut from, mut to) = (0, n);
    for _ in 0..32 {
        if from >= to {
            break;
        }
        let middle = from + (to - from) / 2;
        if at(keys, middle as usize) < key {
            from = middle + 1;
        } else {
            to = middle;
        }
    }
    from
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::broad_phase::morton_key::{order_key, shared_word};
    use crate::random::Random;
    use alloc::vec::Vec;

    /// The survey of some boxes: bounds and sides, or bounds and an axis.
    fn survey(method: u32, axis: u32, boxes: &[Aabb<f32>]) -> Vec<u32> {
        let all = boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
        let mut words: Vec<u32> = (0..6).map(|k| shared_word(&all, k)).collect();
        for k in 0..3 {
            let all = boxes.iter().fold(Sizes::NONE, |all, b| all.merged(&Sizes::of(b)));
            words.push(if method == SWEEP_AND_PRUNE { axis } else { order_key(all.half[k]) });
        }
        words
    }

    /// How often a row of either box asks for the other.
    fn times(method: u32, kind: u32, boxes: [&Aabb<f32>; 2], survey: &[u32]) -> u32 {
        let [a, b] = sets(kind).map(|set| set as u32);
        let keys = [key(method, a, boxes[0], survey), key(method, b, boxes[1], survey)];
        let mut n = 0;
        for row in 0..rows(method, kind) {
            for i in 0..2 {
                let [asking, asked] = asks(method, kind, row);
                // Within a set the box of the lesser key asks, of equal ones the first.
                let may = if kind == EDGE_EDGE {
                    (keys[i], i) < (keys[1 - i], 1 - i)
                } else {
                    asking == [a, b][i]
                };
                let [from, to] = interval(method, kind, row, asked, keys[i], boxes[i], survey);
                n += (may && from <= keys[1 - i] && keys[1 - i] <= to) as u32;
            }
        }
        n
    }

    /// Zeros of both signs, in turn.
    fn zero(n: usize) -> f32 {
        if n.is_multiple_of(2) { 0.0 } else { -0.0 }
    }

    #[test]
    fn boxes_that_overlap_ask_for_each_other_once() {
        let mut random = Random::new(9);
        let grown = |p: [f32; 3], by: f32| Aabb { min: p, max: p.map(|c| c + by) };
        // In general position; on a lattice, so that boxes touch and places are equal; huge; tiny;
        // all in one plane; zeros of both signs.
        let scenes: [(f32, f32, f32); 5] = [
            (1.0, 0.05, 0.0),
            (8.0, 1.0, 1.0),
            (3.3e38, 2e37, 0.0),
            (1e-37, 1e-38, 0.0),
            (0.0, 0.0, 0.0),
        ];
        for (side, size, lattice) in scenes {
            let mut point = |n: usize| -> [f32; 3] {
                core::array::from_fn(|_| {
                    let x = (random.unit() as f32 - 0.5) * side;
                    let x = if lattice > 0.0 { (x / lattice) as i32 as f32 * lattice } else { x };
                    if x == 0.0 { zero(n) } else { x }
                })
            };
            let mut boxes: Vec<Aabb<f32>> = (0..120).map(|n| grown(point(n), size)).collect();
            boxes.extend((0..9).map(|n| Aabb::of_point([zero(n); 3])));
            for method in [BRUTE_FORCE, SWEEP_AND_PRUNE, UNIFORM_GRID] {
                let words = survey(method, 1, &boxes);
                let mut n_pairs = 0;
                for i in 0..boxes.len() {
                    for j in i + 1..boxes.len() {
                        for kind in [0, 1] {
                            let n = times(method, kind, [&boxes[i], &boxes[j]], &words);
                            let want = boxes[i].overlaps(&boxes[j]) as u32;
                            n_pairs += want;
                            assert!(
                                n <= 1 && n >= want,
                                "method {method}, kind {kind}: {n} times {:?} {:?} of {side}",
                                boxes[i],
                                boxes[j]
                            );
                        }
                    }
                }
                assert!(n_pairs > 50, "{n_pairs} pairs in {side} show nothing");
            }
        }
    }

    #[test]
    fn work_packs() {
        for work in [[8, 8, (1 << 24) - 1, u32::MAX], [0, 1, 0, 0], [4, 3, 77, 99]] {
            let [row, tiles, group, first] = work;
            assert_eq!(unpack(pack(row, tiles, group, first)), work);
        }
        let keys = [1, 3, 3, 7];
        assert_eq!([0, 3, 4, 8].map(|key| lower_bound(&keys, 4, key)), [0, 1, 3, 4]);
    }
}
