//! Bounds of all boxes, and the keys by which boxes are sorted.
//!
//! Twin: on a CPU `curve_order.rs`, which bounds boxes as it codes them.

use crate::entry::kernel;
use crate::records::BoxWords;
use crate::workgroup::{barrier, get, raise, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh;
use ccd_core::backend::broad_phase::morton_key::{self, Curve};
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::put;
use ccd_core::backend::layout::Frame;
use ccd_core::math::morton::MortonGrid;

const THREADS: u32 = Id::SceneBounds.threads();

kernel! {
    /// A workgroup merges `THREADS * CHUNK` of the first `dispatch.n` boxes, and its first thread
    /// merges that into the six words of `words`, zero before.
    scene_bounds[256](t; params: Plain; shared: [Aabb; 256]; boxes: [BoxWords], mut words: [u32]) {
        let first = (t.group * THREADS * morton_key::CHUNK as u32 + t.lane) as usize;
        let mut merged =
            morton_key::scene_bounds(first, THREADS as usize, boxes, params.dispatch.n as usize);
        set(shared, t.lane, merged);
        let mut half = THREADS / 2;
        for _ in 0..8 {
            barrier();
            if t.lane < half {
                merged = merged.union(&get(shared, t.lane + half));
                set(shared, t.lane, merged);
            }
            half /= 2;
        }
        if t.lane == 0 {
            for k in 0..6 {
                raise(words, k, morton_key::shared_word(&merged, k));
            }
        }
    }
}

kernel! {
    /// Thread `i` writes the sort key of box `i`, and `i`.
    curve_keys[256](t; params: Plain;; boxes: [BoxWords], words: [u32], mut keys: [u32],
        mut order: [u32]) {
        let i = t.i;
        if i < params.frame.start[3] {
            let set = block_bvh::set_of(&params.frame.start, i);
            let grid = MortonGrid::new(&morton_key::merged(words), 10);
            let curve =
                if params.frame.has(Frame::FLAG_HILBERT) { Curve::Hilbert } else { Curve::Morton };
            put(keys, i as usize, morton_key::sort_key(i as usize, set, boxes, &grid, curve));
            put(order, i as usize, i);
        }
    }
}
