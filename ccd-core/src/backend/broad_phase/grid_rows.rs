//! Rows of cells in which a box of a device asks for others: grids over each other, as keys of 30
//! bits.
//!
//! ```text
//!   29   27 26       18 17        9 8         0
//!   | level |     z    |     y     |     x     |     rows of a level: nine of three cells each,
//!                                                    and one that is all of the level
//! ```
//!
//! Twin: none; kernels have it by `key_intervals.rs`, and a CPU has keys of 64 bits.
//!
//! Levels count from that of the asking box on (*steps*), so that boxes that follow each other ask
//! for cells that follow each other, also at the border of two levels. What is found, and why each
//! pair once, is proved in [`super::grid_levels`] and [`super::uniform_grid`].

use crate::broad_phase::grid_levels;
use crate::broad_phase::uniform_grid::{OWN_ROW, ROWS, Sizes, UniformGrid};
use crate::math::aabb::Aabb;

/// Bits of a cell along an axis: a grid has at most 512 cells there.
const AXIS_BITS: u32 = 9;
/// Bits of a key below the level.
pub const CELL_BITS: u32 = 3 * AXIS_BITS;
/// Levels at most: those of boxes from half of the largest to an eighth are one with that of the
/// largest where there would be more.
pub const LEVELS: u32 = 8;
/// Rows of a level: those around a cell, and one that is all of the level.
pub const ROWS_A_LEVEL: u32 = ROWS + 1;
const ALL_ROW: u32 = ROWS;
/// Boxes of a level up to which it is one row: that is two tiles of a comparison, rather than one
/// for each row that is not empty.
const FEW: u32 = 256;

type Grid = UniformGrid<AXIS_BITS>;
type Levels = grid_levels::Levels<AXIS_BITS, LEVELS>;

/// Level and cell of a box.
#[inline(always)]
pub fn key(b: &Aabb<f32>, sizes: &Sizes) -> u32 {
    let levels = Levels::new(sizes);
    let level = levels.level(b);
    level << CELL_BITS | Grid::key(levels.grid(level).cell(b))
}

/// The first row of a level with so many boxes that is looked at, and behind the last.
#[inline(always)]
pub fn rows_taken(n_boxes: u32) -> [u32; 2] {
    if n_boxes == 0 {
        [0, 0]
    } else if n_boxes <= FEW {
        [ALL_ROW, ALL_ROW + 1]
    } else {
        [0, ROWS]
    }
}

/// The step of a row of either turn, and the row in that step. Divisors are constants, which no
/// kernel checks.
#[inline(always)]
pub fn step_and_row(row: u32) -> [u32; 2] {
    let row = row % (LEVELS * ROWS_A_LEVEL);
    [row / ROWS_A_LEVEL, row % ROWS_A_LEVEL]
}

/// The level that a box asks in a step, [`LEVELS`] if there is none.
#[inline(always)]
pub fn asked_level(key: u32, step: u32) -> u32 {
    let level = (key >> CELL_BITS) % LEVELS + step;
    if level < LEVELS { level } else { LEVELS }
}

/// The cell of that level around which it asks.
#[inline(always)]
pub fn asked_cell(key: u32, step: u32, b: &Aabb<f32>, sizes: &Sizes) -> [u32; 3] {
    if step == 0 {
        Grid::cell_of(key & ((1 << CELL_BITS) - 1))
    } else {
        Levels::new(sizes).grid(asked_level(key, step)).cell(b)
    }
}

/// The first and the last key of a row around a cell of a level; a first that is greater than the
/// last where there are none. `forward`: only rows from that of the cell on.
#[inline(always)]
pub fn interval(level: u32, cell: [u32; 3], row: u32, forward: bool) -> [u32; 2] {
    if level >= LEVELS || (forward && row < OWN_ROW) {
        return [1, 0];
    }
    let [first, last] =
        if row == ALL_ROW { [0, (1 << CELL_BITS) - 1] } else { Grid::row(cell, row, forward) };
    [level << CELL_BITS | first, level << CELL_BITS | last]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_of_few_boxes_are_one_row() {
        assert_eq!([0, 1, FEW, FEW + 1].map(rows_taken), [[0, 0], [9, 10], [9, 10], [0, 9]]);
        let all = interval(3, [1, 2, 3], ALL_ROW, true);
        assert_eq!(all.map(|key| asked_level(key, 0)), [3, 3]);
        assert_eq!(all.map(|key| asked_level(key, 4)), [7, 7]);
        assert_eq!(all.map(|key| asked_level(key, 5)), [LEVELS; 2]);
        for row in 0..ROWS {
            let [first, last] = interval(3, [1, 2, 3], row, false);
            assert!(all[0] <= first && first + 2 == last && last <= all[1], "row {row}");
        }
        assert_eq!(interval(LEVELS, [1; 3], OWN_ROW, false), [1, 0]);
    }
}
