//! A binary tree from lists of where neighbours of the sorted codes part; see
//! `ccd_core::backend::broad_phase::split_lists`.

use crate::entry::kernel;
use crate::records::branch_words;
use crate::workgroup::{add_shared, barrier, get, or, or_shared, set};
use ccd_core::backend::broad_phase::radix_tree::branch_from;
use ccd_core::backend::broad_phase::split_lists::{
    MAX_LEVELS, PRESENT, branch, last_level, level, rank,
};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::kernel::sort::{DIGITS, before};
use ccd_core::backend::layout::{Building, LIST_HEADER, Params};
use spirv_std::glam::UVec4;

/// Threads of a workgroup, which are the places of a tile.
const TILE: u32 = Id::SplitEmit.threads();
/// Words of a mask of the places of a tile.
const MASK: u32 = TILE / 32;

#[inline(always)]
fn n_internal(params: &Params<Building>) -> u32 {
    params.frame.count[params.args.set as usize] - 1
}

/// The levels that occur.
#[inline(always)]
fn present_in(present: &[u32]) -> [u32; PRESENT] {
    [at(present, 0), at(present, 1), at(present, 2)]
}

/// The first and the last level of place `i`, numbered without gaps; after the last place none.
#[inline(always)]
fn range(i: u32, n_internal: u32, levels: &[u32], present: &[u32]) -> [u32; 2] {
    let mut range = [1, 0];
    if i < n_internal {
        let present = present_in(present);
        let last = last_level(i as usize, n_internal as usize, levels);
        range = [rank(at(levels, i as usize), present), rank(last, present)];
    }
    range
}

/// Entries of all levels before level `l`.
#[inline(always)]
fn begin_of(l: u32, n_tiles: u32, table: &[u32]) -> u32 {
    let mut begin = 0;
    for k in 0..l.min(MAX_LEVELS as u32) {
        begin += at(table, (DIGITS * n_tiles + k) as usize);
    }
    begin
}

kernel! {
    /// Thread `i` finds the level at which leaf `i` and the next part.
    split_levels[256](t; params: Building; shared: [u32; 4]; keys: [u32], mut levels: [u32],
        mut present: [u32]) {
        let i = t.i;
        if t.lane < PRESENT as u32 {
            set(shared, t.lane, 0);
        }
        barrier();
        if i < n_internal(params) {
            let from = params.frame.start[params.args.set as usize];
            let at_level = level(i as usize, from as usize, keys);
            put(levels, i as usize, at_level);
            or_shared(shared, at_level / 32, 1 << (at_level % 32));
        }
        barrier();
        if t.lane < PRESENT as u32 {
            or(present, t.lane as usize, get(shared, t.lane));
        }
    }
}

kernel! {
    /// A workgroup counts the entries that its places have on each level into
    /// `table[level n_tiles + tile]`.
    split_count[256](t; params: Building; counts: [u32; 256]; levels: [u32], present: [u32],
        mut table: [u32]) {
        let (tile, n_internal) = (t.group, n_internal(params));
        set(counts, t.lane, 0);
        barrier();
        let [first, last] = range(tile * TILE + t.lane, n_internal, levels, present);
        for l in first..last + 1 {
            add_shared(counts, l, 1);
        }
        barrier();
        let n_tiles = n_internal.div_ceil(TILE);
        if tile < n_tiles {
            put(table, (t.lane * n_tiles + tile) as usize, get(counts, t.lane));
        }
    }
}

kernel! {
    /// Thread `i` writes the entries of place `i` into the lists of all levels, which follow one
    /// another, and where the first of them is.
    split_emit[256](t; params: Building; masks: [u32; 768], begins: [u32; 256]; levels: [u32],
        present: [u32], table: [u32], mut entries: [u32], mut list: [u32]) {
        let (tile, n_internal) = (t.group, n_internal(params));
        let n_tiles = n_internal.div_ceil(TILE);
        let i = tile * TILE + t.lane;
        for k in 0..3 {
            set(masks, k * TILE + t.lane, 0);
        }
        set(begins, t.lane, begin_of(t.lane, n_tiles, table));
        barrier();
        let [first, last] = range(i, n_internal, levels, present);
        for l in first..last + 1 {
            or_shared(masks, l * MASK + t.lane / 32, 1 << (t.lane % 32));
        }
        barrier();
        for l in first..last + 1 {
            let mut slot = get(begins, l) + at(table, (l * n_tiles + tile) as usize);
            for word in 0..t.lane / 32 {
                slot += get(masks, l * MASK + word).count_ones();
            }
            slot += before(get(masks, l * MASK + t.lane / 32), t.lane);
            if slot < params.dispatch.capacity_out {
                put(list, LIST_HEADER + slot as usize, i);
            }
            if l == first {
                put(entries, i as usize, slot);
            }
        }
        if i == 0 {
            put(list, 0, get(begins, MAX_LEVELS as u32));
        }
    }
}

kernel! {
    /// Thread `i` writes the node that is split at place `i`. If the list is too short, it finds
    /// node `i` from the keys, so that kernels which run before the list has grown read a tree.
    split_branches[256](t; params: Building; begins: [u32; 256]; keys: [u32], levels: [u32],
        present: [u32], table: [u32], entries: [u32], list: [u32], mut branches: [UVec4]) {
        let i = t.i;
        let n_internal = n_internal(params);
        set(begins, t.lane, begin_of(t.lane, n_internal.div_ceil(TILE), table));
        barrier();
        let is_whole = at(list, 0) <= params.dispatch.capacity_out;
        if i < n_internal && is_whole {
            let at_level = at(levels, i as usize);
            let l = rank(at_level, present_in(present));
            let begin_end =
                [LIST_HEADER + get(begins, l) as usize, LIST_HEADER + get(begins, l + 1) as usize];
            let k = LIST_HEADER + at(entries, i as usize) as usize;
            let (number, branch) = branch(k, at_level, begin_end, n_internal, list, levels);
            put(branches, number as usize, branch_words(&branch));
        }
        if i < n_internal && !is_whole {
            let from = params.frame.start[params.args.set as usize];
            put(branches, i as usize, branch_words(&branch_from(i, from, n_internal + 1, keys)));
        }
    }
}
