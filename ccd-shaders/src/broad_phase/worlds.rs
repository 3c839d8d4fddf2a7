//! Boxes of many worlds: bounds and keys of each.

use crate::entry::kernel;
use crate::records::{BoxWords, box_at};
use crate::workgroup::raise;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{self};
use ccd_core::backend::broad_phase::morton_key;
use ccd_core::backend::broad_phase::worlds::{self, BOUND_WORDS};
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::math::morton::MortonGrid;

kernel! {
    /// Thread `i` merges `CHUNK` of the first `dispatch.n` boxes, those that follow each other in
    /// one world at once, into six words a world, zero before.
    world_bounds[256](t; params: Worlds;; boxes: [BoxWords], worlds: [u32], mut words: [u32]) {
        let first = t.i * morton_key::CHUNK as u32;
        let mut merged = Aabb::EMPTY;
        for k in 0..morton_key::CHUNK as u32 {
            let i = first + k;
            if i < params.dispatch.n {
                let world = at(worlds, i as usize);
                merged = merged.union(&box_at(boxes, i as usize));
                let mut is_last = k + 1 == morton_key::CHUNK as u32 || i + 1 == params.dispatch.n;
                if !is_last {
                    is_last = at(worlds, i as usize + 1) != world;
                }
                if is_last {
                    for axis in 0..BOUND_WORDS {
                        let word = morton_key::shared_word(&merged, axis);
                        raise(words, BOUND_WORDS * world as usize + axis, word);
                    }
                    merged = Aabb::EMPTY;
                }
            }
        }
    }
}

kernel! {
    /// Thread `i` writes the sort key of box `i`, and `i`.
    world_keys[256](t; params: Worlds;; boxes: [BoxWords], worlds: [u32], words: [u32],
        mut keys: [u32], mut order: [u32]) {
        let i = t.i;
        if i < params.frame.start[3] {
            let set = block_bvh::set_of(&params.frame.start, i);
            let world = at(worlds, i as usize);
            let grid = MortonGrid::new(&worlds::bounds(words, world), 10);
            let key = worlds::sort_key(i as usize, set, world, params.args.bits, boxes, &grid);
            put(keys, i as usize, key);
            put(order, i as usize, i);
        }
    }
}
