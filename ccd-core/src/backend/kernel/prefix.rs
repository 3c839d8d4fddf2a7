//! Cooperative: places for the items that are kept of many, in their order, in two kernels.
//!
//! The first counts those of each tile, and adds the counts of so many tiles to a word of their
//! group; the second ranks the items of its tile, after those of the tiles before it in its group
//! and of the groups before that. Nothing waits for another workgroup (reduce, then scan); a
//! workgroup of the second reads the counts of at most [`TILE`] tiles and all groups, which are as
//! few as one for 65,536 items.

/// Items of a tile, tiles of a group; threads of a workgroup.
pub const TILE: u32 = 256;

/// Tiles of `n` items.
#[inline(always)]
pub fn tiles(n: u32) -> u32 {
    n.div_ceil(TILE)
}

/// Words of the sums of at most `capacity` items: those of groups, then those of tiles.
#[inline(always)]
pub fn words(capacity: u32) -> u32 {
    tiles(capacity) + tiles(tiles(capacity))
}

/// The word of the group of a tile.
#[inline(always)]
pub fn group_word(tile: u32) -> usize {
    (tile / TILE) as usize
}

/// The word of a tile.
#[inline(always)]
pub fn tile_word(tile: u32, capacity: u32) -> usize {
    (tiles(tiles(capacity)) + tile) as usize
}
