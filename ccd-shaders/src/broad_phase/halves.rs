//! Runs of boxes in order by halves, a run a workgroup; see
//! `ccd_core::backend::broad_phase::halves`.
//!
//! Twin: none on a CPU, where it made a first step a quarter to three quarters longer, and those
//! that keep the order little shorter.

use crate::entry::kernel;
use crate::records::{BoxWords, box_at};
use crate::workgroup::{barrier, get, or_shared, set};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::set_of;
use ccd_core::backend::broad_phase::halves::{LEVELS, RUN, half_surface, key, least, place};
use ccd_core::backend::kernel::memory::{at, put};
use spirv_std::glam::UVec4;

/// Boxes by bound, see [`put_box`].
type Boxes = [f32; 6 * BOUNDS as usize];
/// Bounds of parts of a run, and their surfaces.
type Merged = [f32; SURFACES as usize + 8];
/// Ranks of a part along an axis as bits, see [`words`].
type Masks = [u32; 3 * RUN as usize / 64 * (RUN as usize / 32)];

/// Words of a bound of 32 boxes, and of all.
const STRIDE: u32 = 36;
const BOUNDS: u32 = RUN / 32 * STRIDE;
/// Bounds of quarters of blocks; behind them those of blocks, and surfaces.
const QUARTERS: u32 = 6 * 4 * (RUN / 32);
const SURFACES: u32 = QUARTERS + 6 * (RUN / 32);

kernel! {
    /// Thread `i` puts a box into place `i` of all sets: the boxes of a workgroup in order by
    /// halves.
    halve_runs[256](t; params: Blocks; keys: [UVec4; 256], boxes_by_bound: [f32; 1728],
        merged: [f32; 248], masks: [u32; 96]; boxes: [BoxWords], mut order: [u32]) {
        let (frame, first) = (&params.frame, &params.args.slots[0]);
        let set = set_of(first, t.i);
        let k = t.i - first[set];
        let is_box = t.i < first[3] && k < frame.count[set];
        let place_in_order = (frame.start[set] + k) as usize;
        let (mut aabb, mut id) = (Aabb::EMPTY, 0);
        if is_box {
            id = at(order, place_in_order);
            aabb = box_at(boxes, id as usize);
        }
        let halved = halved(t.lane, aabb, id, keys, boxes_by_bound, merged, masks);
        if is_box {
            put(order, place_in_order, halved);
        }
    }
}

/// Which box of the run comes at place `lane`; `id` is the box `aabb` that is there, or there is
/// none, and it is empty.
#[inline(always)]
fn halved(
    lane: u32,
    mut aabb: Aabb,
    id: u32,
    keys: &mut [UVec4; 256],
    boxes: &mut Boxes,
    merged: &mut Merged,
    masks: &mut Masks,
) -> u32 {
    let key = UVec4::new(key(&aabb, 0, lane), key(&aabb, 1, lane), key(&aabb, 2, lane), id);
    set(keys, lane, key);
    barrier();
    // Ranks of this box among all of the run, by axis.
    let mut own = UVec4::new(0, 0, 0, id);
    for eight in 0..RUN / 8 {
        // Unrolled, so that reads overlap.
        macro_rules! compare {
            ($($k:literal)*) => {
                let others = [$(get(keys, 8 * eight + $k)),*];
                $(
                    own.x += (others[$k].x < key.x) as u32;
                    own.y += (others[$k].y < key.y) as u32;
                    own.z += (others[$k].z < key.z) as u32;
                )*
            };
        }
        compare!(0 1 2 3 4 5 6 7);
    }
    for level in 0..LEVELS {
        if lane < masks.len() as u32 {
            set(masks, lane, 0);
        }
        barrier();
        let width = RUN >> level;
        let (part, first) = (lane >> (RUN.ilog2() - level), lane & !(width - 1));
        mark(masks, 0, part, own.x);
        mark(masks, 1, part, own.y);
        mark(masks, 2, part, own.z);
        barrier();
        let x = first + below(masks, 0, part, own.x);
        let y = first + below(masks, 1, part, own.y);
        let z = first + below(masks, 2, part, own.z);
        let axis = least([
            surfaces(lane, x, &aabb, level, boxes, merged),
            surfaces(lane, y, &aabb, level, boxes, merged),
            surfaces(lane, z, &aabb, level, boxes, merged),
        ]);
        let to = place(axis, [x, y, z]);
        set(keys, to, own);
        put_box(boxes, to, &aabb);
        barrier();
        own = get(keys, lane);
        aabb = box_of(boxes, lane);
    }
    own.w
}

/// The first of the eight words in which each rank along an axis that a part has is a bit.
#[inline(always)]
fn words(axis: u32, part: u32) -> u32 {
    (axis * (RUN / 64) + part) * (RUN / 32)
}

/// Marks a rank.
#[inline(always)]
fn mark(masks: &mut Masks, axis: u32, part: u32, rank: u32) {
    or_shared(masks, words(axis, part) + rank / 32, 1 << (rank % 32));
}

/// How many marked ranks are below one.
#[inline(always)]
fn below(masks: &Masks, axis: u32, part: u32, rank: u32) -> u32 {
    let first = words(axis, part);
    let mut n = (get(masks, first + rank / 32) & ((1 << (rank % 32)) - 1)).count_ones();
    for word in 0..rank / 32 {
        n += get(masks, first + word).count_ones();
    }
    n
}

/// Surfaces of both halves of the thread's part on a level, added, where its box is at `place`.
/// Nobody reads `boxes` after it returned.
#[inline(always)]
fn surfaces(
    lane: u32,
    place: u32,
    aabb: &Aabb,
    level: u32,
    boxes: &mut Boxes,
    merged: &mut Merged,
) -> f32 {
    put_box(boxes, place, aabb);
    barrier();
    // A run of 32 threads has a bound, four of its threads a block.
    if lane < QUARTERS {
        let from = lane / 32 * BOUNDS + lane % 32 / 4 * STRIDE + lane % 4;
        let at = |k: u32| get(boxes, from + 4 * k);
        let most = [at(0).max(at(1)), at(2).max(at(3)), at(4).max(at(5)), at(6).max(at(7))];
        set(merged, lane, most[0].max(most[1]).max(most[2].max(most[3])));
    }
    barrier();
    if lane < SURFACES - QUARTERS {
        let at = |k: u32| get(merged, 4 * lane + k);
        set(merged, QUARTERS + lane, at(0).max(at(1)).max(at(2).max(at(3))));
    }
    barrier();
    let blocks = RUN / 64 >> level;
    if lane < 2 << level {
        let mut b = Aabb::EMPTY;
        for k in lane * blocks..(lane + 1) * blocks {
            let at = |bound: u32| get(merged, QUARTERS + bound * (RUN / 32) + k);
            let block = Aabb { min: [-at(0), -at(1), -at(2)], max: [at(3), at(4), at(5)] };
            b = b.union(&block);
        }
        set(merged, SURFACES + lane, half_surface(&b));
    }
    barrier();
    let of_half = SURFACES + 2 * (lane >> (RUN.ilog2() - level));
    get(merged, of_half) + get(merged, of_half + 1)
}

/// Puts a box at its place: its bounds apart from each other, lower ones negated, so that all are
/// merged by maxima; a block of 32 further than its length from the next, so that threads that read
/// several do not wait for each other.
#[inline(always)]
fn put_box(boxes: &mut Boxes, place: u32, b: &Aabb) {
    let at = place / 32 * STRIDE + place % 32;
    set(boxes, at, -b.min[0]);
    set(boxes, BOUNDS + at, -b.min[1]);
    set(boxes, 2 * BOUNDS + at, -b.min[2]);
    set(boxes, 3 * BOUNDS + at, b.max[0]);
    set(boxes, 4 * BOUNDS + at, b.max[1]);
    set(boxes, 5 * BOUNDS + at, b.max[2]);
}

/// The box at a place.
#[inline(always)]
fn box_of(boxes: &Boxes, place: u32) -> Aabb {
    let at = place / 32 * STRIDE + place % 32;
    Aabb {
        min: [-get(boxes, at), -get(boxes, BOUNDS + at), -get(boxes, 2 * BOUNDS + at)],
        max: [
            get(boxes, 3 * BOUNDS + at),
            get(boxes, 4 * BOUNDS + at),
            get(boxes, 5 * BOUNDS + at),
        ],
    }
}
