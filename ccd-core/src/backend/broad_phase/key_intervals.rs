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
//! | sweep and prune | where a box begins on an axis | 1 | 1 and 1 |
//! | uniform grid | its level and cell | 5, and 9 a coarser level | 9 a level, 9 a coarser one |
//!
//! Of two sets, sweep and prune asks for the boxes of the second that begin in one of the first or
//! with it, and then for those of the first that begin in one of the second, and not with it.
//!
//! Boxes of unequal sizes are in several grids over each other ([`super::grid_levels`]), and each
//! asks its own level and all coarser ones ([`super::grid_rows`]); of two sets first each of the
//! first set, its own level and coarser ones of the second, and then each of the second, coarser
//! ones of the first. A row is three cells that follow each other along `x`; in the own level half
//! of the neighbours are enough within one set. A level of few boxes is one row, one without boxes
//! is not looked at, and a row without boxes is no piece of work.
//!
//! Cost: a sort of 32-bit keys, then as many tests as there are pairs of boxes of a group with its
//! ranges. Keys have the set in their two highest bits, so that one sort serves all sets; those of
//! a grid then the level, in three bits, and the cell, in nine bits an axis.

use crate::broad_phase::block_bvh::sets;
use crate::broad_phase::grid_rows::{self, CELL_BITS, LEVELS, ROWS_A_LEVEL};
use crate::broad_phase::morton_key::{from_order_key, merged};
use crate::broad_phase::sweep_and_prune::axis_key;
use crate::broad_phase::uniform_grid::Sizes;
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
pub const BITS: u32 = 30;
/// Most boxes of all sets, by what a piece of work has room for.
pub const MOST_BOXES: u32 = 1 << 29;

/// Levels that a box asks: its own and coarser ones; 1 without levels.
#[inline(always)]
pub fn steps(method: u32) -> u32 {
    if method == UNIFORM_GRID { LEVELS } else { 1 }
}

/// Rows of each level.
#[inline(always)]
pub fn rows_a_step(method: u32) -> u32 {
    if method == UNIFORM_GRID { ROWS_A_LEVEL } else { 1 }
}

/// The first row that is looked at of a level with so many boxes, and behind the last.
#[inline(always)]
pub fn rows_taken(method: u32, n_boxes: u32) -> [u32; 2] {
    if method == UNIFORM_GRID { grid_rows::rows_taken(n_boxes) } else { [0, 1] }
}

/// Whether a row is one of those of a level with so many boxes.
#[inline(always)]
pub fn is_taken(method: u32, row: u32, n_boxes: u32) -> bool {
    if method != UNIFORM_GRID {
        return true;
    }
    let [first, end] = grid_rows::rows_taken(n_boxes);
    let row = grid_rows::step_and_row(row)[1];
    first <= row && row < end
}

/// Rows in which the boxes of one set ask.
#[inline(always)]
pub fn rows_a_turn(method: u32) -> u32 {
    steps(method) * rows_a_step(method)
}

/// Turns of a kind of pairs: of two sets first the boxes of the first ask, and then those of the
/// second.
#[inline(always)]
pub fn turns(method: u32, kind: u32) -> u32 {
    if kind == EDGE_EDGE || method == BRUTE_FORCE { 1 } else { 2 }
}

/// Rows of a method for a kind of pairs, at most 160.
#[inline(always)]
pub fn rows(method: u32, kind: u32) -> u32 {
    turns(method, kind) * rows_a_turn(method)
}

/// Whether a row is of the second turn.
#[inline(always)]
pub fn is_second_turn(method: u32, row: u32) -> bool {
    row >= rows_a_turn(method)
}

/// The set whose boxes ask in a row, and the set that they ask.
#[inline(always)]
pub fn asks(method: u32, kind: u32, row: u32) -> [u32; 2] {
    let [a, b] = sets(kind);
    if is_second_turn(method, row) { [b as u32, a as u32] } else { [a as u32, b as u32] }
}

/// The key of a box of `set`.
#[inline(always)]
pub fn key(method: u32, set: u32, b: &Aabb<f32>, survey: &[u32]) -> u32 {
    let place = if method == SWEEP_AND_PRUNE {
        place_on_axis(&b.min, at(survey, FOUND))
    } else if method == UNIFORM_GRID {
        grid_rows::key(b, &sizes(survey))
    } else {
        0
    };
    set << BITS | place
}

/// The level that a box of key `key` asks in a step, [`LEVELS`] if there is none; `row`: any of
/// the turn.
#[inline(always)]
pub fn asked_level(method: u32, row: u32, step: u32, key: u32) -> u32 {
    // In the own level the first set has found what there is.
    let none = step == 0 && is_second_turn(method, row);
    if method != UNIFORM_GRID || none { LEVELS } else { grid_rows::asked_level(key, step) }
}

/// As [`asked_level`], in the step of a row.
#[inline(always)]
pub fn asked_level_of(method: u32, row: u32, key: u32) -> u32 {
    asked_level(method, row, grid_rows::step_and_row(row)[0], key)
}

/// The cell of that level around which the box asks.
#[inline(always)]
pub fn asked_cell(method: u32, step: u32, key: u32, b: &Aabb<f32>, survey: &[u32]) -> [u32; 3] {
    if method == UNIFORM_GRID {
        grid_rows::asked_cell(key, step, b, &sizes(survey))
    } else {
        [0; 3]
    }
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
    let step = if method == UNIFORM_GRID { grid_rows::step_and_row(row)[0] } else { 0 };
    let level = asked_level(method, row, step, key);
    let cell = asked_cell(method, step, key, b, survey);
    interval_around(method, kind, row, asked, key, b, survey, level, cell)
}

/// As [`interval`], with what [`asked_level`] and [`asked_cell`] say.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a struct of slices does not translate to WGSL")]
pub fn interval_around(
    method: u32,
    kind: u32,
    row: u32,
    asked: u32,
    key: u32,
    b: &Aabb<f32>,
    survey: &[u32],
    level: u32,
    cell: [u32; 3],
) -> [u32; 2] {
    let set = asked << BITS;
    if method == SWEEP_AND_PRUNE {
        // Of two that begin at one place the one of the first set asks.
        let place = key & ((1 << BITS) - 1);
        [(set | place) + row, set | place_on_axis(&b.max, at(survey, FOUND))]
    } else if method == UNIFORM_GRID {
        // Within the own level of a set, rows from that of the own cell on.
        let [step, row] = grid_rows::step_and_row(row);
        let [first, last] = grid_rows::interval(level, cell, row, kind == EDGE_EDGE && step == 0);
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

/// A piece of work in two words: row in 8 bits, and group of those who ask in 24; boxes of the
/// chunk in groups, less one, in 3 bits, and first box of the chunk in 29.
#[inline(always)]
pub fn pack(row: u32, tiles: u32, group: u32, first: u32) -> [u32; 2] {
    [row << 24 | group, (tiles - 1) << 29 | first]
}

/// Row, groups in the chunk, group that asks, and first box of the chunk.
#[inline(always)]
pub fn unpack(work: [u32; 2]) -> [u32; 4] {
    [work[0] >> 24, (work[1] >> 29) + 1, work[0] & 0xff_ffff, work[1] & (MOST_BOXES - 1)]
}

const _: () = assert!(CHUNK / GROUP <= 8 && MOST_BOXES / GROUP <= 1 << 24);
const _: () = assert!(2 * LEVELS * ROWS_A_LEVEL <= 256 && LEVELS * ROWS_A_LEVEL <= GROUP);
const _: () = assert!(LEVELS << CELL_BITS == 1 << BITS);

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

    /// The rows among `some` in which either box asks for the other.
    fn asking(
        (method, kind): (u32, u32),
        some: impl Fn(u32) -> bool,
        boxes: [&Aabb<f32>; 2],
        survey: &[u32],
    ) -> Vec<u32> {
        let [a, b] = sets(kind).map(|set| set as u32);
        let keys = [key(method, a, boxes[0], survey), key(method, b, boxes[1], survey)];
        let mut out = Vec::new();
        for row in (0..rows(method, kind)).filter(|&row| some(row)) {
            for i in 0..2 {
                let [asking, asked] = asks(method, kind, row);
                // Within a set the box of the lesser key asks, of equal ones the first.
                let may = if kind == EDGE_EDGE {
                    (keys[i], i) < (keys[1 - i], 1 - i)
                } else {
                    asking == [a, b][i]
                };
                let [from, to] = interval(method, kind, row, asked, keys[i], boxes[i], survey);
                if may && (from..=to).contains(&keys[1 - i]) {
                    out.push(row);
                }
            }
        }
        out
    }

    #[test]
    fn boxes_that_overlap_ask_for_each_other_once() {
        let mut random = Random::new(9);
        // Zeros of both signs, in turn.
        let zero = |n: usize| if n.is_multiple_of(2) { 0.0 } else { -0.0 };
        let grown = |p: [f32; 3], by: f32| Aabb { min: p, max: p.map(|c| c + by) };
        // In general position; on a lattice, so that boxes touch and places are equal; huge; tiny;
        // all in one plane; zeros of both signs. Then of several levels, of many, on a lattice, and
        // around what a device flushes.
        let scenes: [(f32, f32, f32, u32); 11] = [
            (1.0, 0.05, 0.0, 0),
            (8.0, 1.0, 1.0, 0),
            (3.3e38, 2e37, 0.0, 0),
            (1e-37, 1e-38, 0.0, 0),
            (0.0, 0.0, 0.0, 0),
            (1.0, 0.1, 0.0, 4),
            (1.0, 1.0, 0.0, 12),
            (8.0, 4.0, 0.125, 5),
            (2e38, 1e38, 0.0, 11),
            (1e-27, 1e-27, 0.0, 14),
            (1e-37, 1e-37, 0.0, 14),
        ];
        // Pairs that one row of coarser levels finds, by row, by step, and by turn.
        let (mut by_row, mut by_step, mut by_turn) = ([0; 9], [0; LEVELS as usize], [0; 2]);
        for (side, size, lattice, span) in scenes {
            let mut point = |n: usize| -> [f32; 3] {
                core::array::from_fn(|_| {
                    let x = (random.unit() as f32 - 0.5) * side;
                    let x = if lattice > 0.0 { (x / lattice) as i32 as f32 * lattice } else { x };
                    if x == 0.0 { zero(n) } else { x }
                })
            };
            let mut boxes: Vec<_> = (0..120).map(|n| grown(point(n), size)).collect();
            for i in (0..boxes.len()).filter(|_| span > 0) {
                // Some long along an axis. Every second has a corner at one of the box before.
                let (small, before) = (random.below(span + 1), boxes[i.saturating_sub(1)]);
                for k in 0..3 {
                    let small = if random.below(9) == 0 { 0 } else { small };
                    let by = size / (1u32 << small) as f32;
                    let b = &mut boxes[i];
                    b.min[k] = match random.below(2) {
                        _ if i % 2 == 0 => b.min[k],
                        0 => before.min[k] - by,
                        _ => before.max[k],
                    };
                    b.max[k] = b.min[k] + by;
                }
            }
            boxes.extend((0..9).map(|n| Aabb::of_point([zero(n); 3])));
            for method in [BRUTE_FORCE, SWEEP_AND_PRUNE, UNIFORM_GRID] {
                let words = survey(method, 1, &boxes);
                let (a_turn, a_step, mut n_pairs) = (rows_a_turn(method), rows_a_step(method), 0);
                for (i, j) in (0..boxes.len()).flat_map(|i| (0..i).map(move |j| (i, j))) {
                    let pair = [&boxes[i], &boxes[j]];
                    let want = boxes[i].overlaps(&boxes[j]);
                    n_pairs += want as u32;
                    // A level of few boxes is one row, of many several.
                    for (kind, n_boxes) in [(0, 5), (1, 5), (0, 500), (1, 500)] {
                        let [first, end] = rows_taken(method, n_boxes);
                        let taken = |row| (first..end).contains(&(row % a_step));
                        let rows = asking((method, kind), taken, pair, &words);
                        assert!(
                            rows.len() <= 1 && rows.len() >= want as usize,
                            "method {method}, kind {kind}: {rows:?} {pair:?} of {side}"
                        );
                        if want && method == UNIFORM_GRID && n_boxes == 500 {
                            let (turn, row) = (rows[0] / a_turn, rows[0] % a_turn);
                            by_step[(row / a_step) as usize] += 1;
                            if row >= a_step {
                                by_row[(row % a_step) as usize] += 1;
                                by_turn[turn as usize] += 1;
                            }
                        }
                    }
                }
                assert!(n_pairs > 25, "{n_pairs} pairs in {side} show nothing");
            }
        }
        // The control: without any one of them, pairs would be missed.
        let counts = [&by_row[..], &by_step, &by_turn];
        assert!(counts.iter().all(|of| of.iter().all(|&n| n > 4)), "{counts:?}");
    }

    #[test]
    fn work_packs() {
        for work in [[159, 8, (1 << 24) - 1, MOST_BOXES - 1], [0, 1, 0, 0], [4, 3, 77, 99]] {
            let [row, tiles, group, first] = work;
            assert_eq!(unpack(pack(row, tiles, group, first)), work);
        }
        let keys = [1, 3, 3, 7];
        assert_eq!([0, 3, 4, 8].map(|key| lower_bound(&keys, 4, key)), [0, 1, 3, 4]);
    }
}
