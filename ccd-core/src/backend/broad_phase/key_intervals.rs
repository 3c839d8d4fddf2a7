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

/// The step of a row: 0 without levels.
#[inline(always)]
pub fn step_of(method: u32, row: u32) -> u32 {
    if method == UNIFORM_GRID { grid_rows::step_and_row(row)[0] } else { 0 }
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
/// greater than the last where there are none. `asked`: the set that is asked; `level`, `cell`:
/// what [`asked_level`] and [`asked_cell`] say in the step of the row.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a struct of slices does not translate to WGSL")]
pub fn interval(
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
mod tests;
