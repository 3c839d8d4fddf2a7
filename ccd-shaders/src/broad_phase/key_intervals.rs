//! Boxes in the order of a key, each against an interval of keys: sort and sweep, a uniform grid
//! and brute force; see `ccd_core::backend::broad_phase::key_intervals`.

use crate::entry::kernel;
use crate::workgroup::{
    add_shared, append, barrier, count, get, lower_shared, part, raise, raise_shared,
    read_pair, set, write_pair,
};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::set_of;
use ccd_core::backend::broad_phase::grid_rows::{CELL_BITS, LEVELS};
use ccd_core::backend::broad_phase::key_intervals::{
    self, BITS, CHUNK, FOUND, GROUP, POOL, asked_cell, asked_level,
    asks, interval, is_second_turn, is_taken, lower_bound, pack,
    rows_a_step, rows_taken, step_of, steps, unpack,
};
use ccd_core::backend::broad_phase::morton_key::order_key;
use ccd_core::backend::broad_phase::sweep_and_prune::Moments;
use ccd_core::backend::broad_phase::uniform_grid::Sizes;
use ccd_core::backend::kernel::Id;
use ccd_core::backend::kernel::memory::{at, put};
use ccd_core::backend::layout::{EDGE_EDGE, Intervals, Pair, Params};
use ccd_core::narrow_phase::decide;

const THREADS: u32 = Id::IntervalKeys.threads();
/// Boxes of each thread of a survey.
const SHARE: u32 = 32;

/// Words of `counters`: pairs, and where they go.
const HITS: u32 = 0;
const BASE: u32 = 1;

/// Words of `ranges`, a word a row: bounds of the keys that a group asks for, where the range of
/// these keys begins and ends, and where its pieces of work go; then a word a level, where its
/// boxes begin, and where those of the last end.
const FROM: u32 = 0;
const TO: u32 = GROUP;
const BEGIN: u32 = 2 * GROUP;
const END: u32 = 3 * GROUP;
const PIECES: u32 = 4 * GROUP;
const LEVEL: u32 = 5 * GROUP;

kernel! {
    /// One workgroup finds the axis along which the centres of boxes vary most, of every
    /// `dispatch.first`-th box, at most `THREADS * SHARE` of them.
    survey_axis[256](t; params: Plain; shared: [Moments<f32>; 256]; boxes: [Aabb],
        mut survey: [u32]) {
        let mut moments = Moments::<f32>::none();
        for k in 0..SHARE {
            let i = (k * THREADS + t.lane) * params.dispatch.first;
            if i < params.dispatch.n {
                moments = moments.merged(&Moments::of(i as usize, 1, boxes));
            }
        }
        set(shared, t.lane, moments);
        let mut half = THREADS / 2;
        for _ in 0..8 {
            barrier();
            if t.lane < half {
                moments = moments.merged(&get(shared, t.lane + half));
                set(shared, t.lane, moments);
            }
            half /= 2;
        }
        if t.lane == 0 {
            put(survey, FOUND, moments.axes()[0] as u32);
        }
    }
}

kernel! {
    /// The largest half sides of all boxes: a workgroup raises the three words of `survey` by those
    /// of `THREADS * SHARE` boxes.
    survey_sides[256](t; params: Plain; sides: [u32; 4]; boxes: [Aabb], mut survey: [u32]) {
        if t.lane < 3 {
            set(sides, t.lane, 0);
        }
        barrier();
        let mut all = Sizes::NONE;
        for k in 0..SHARE {
            let i = (t.group * SHARE + k) * THREADS + t.lane;
            if i < params.dispatch.n {
                all = all.merged(&Sizes::of(&at(boxes, i as usize)));
            }
        }
        raise_shared(sides, 0, order_key(all.half[0]));
        raise_shared(sides, 1, order_key(all.half[1]));
        raise_shared(sides, 2, order_key(all.half[2]));
        barrier();
        if t.lane < 3 {
            raise(survey, FOUND + t.lane as usize, get(sides, t.lane));
        }
    }
}

kernel! {
    /// Thread `i` writes the key of box `i`, and `i`.
    interval_keys[256](t; params: Intervals;; boxes: [Aabb], survey: [u32], mut keys: [u32],
        mut order: [u32]) {
        let i = t.i;
        if i < params.frame.start[3] {
            let set = set_of(&params.frame.start, i) as u32;
            let b = at(boxes, i as usize);
            put(keys, i as usize, key_intervals::key(params.args.method, set, &b, survey));
            put(order, i as usize, i);
        }
    }
}

kernel! {
    /// Thread `i` copies the box that is `i`-th in order.
    order_boxes[256](t; params: Plain;; boxes: [Aabb], order: [u32], mut sorted: [Aabb]) {
        let i = t.i;
        if i < params.frame.start[3] {
            put(sorted, i as usize, at(boxes, at(order, i as usize) as usize));
        }
    }
}

/// Sorted boxes, their keys and the survey, with the parameters of a kernel.
#[derive(Clone, Copy)]
struct Sorted<'a> {
    params: &'a Params<Intervals>,
    boxes: &'a [Aabb],
    keys: &'a [u32],
    survey: &'a [u32],
}

impl Sorted<'_> {
    /// The place of a thread's box among all sorted ones, and whether there is one.
    #[inline(always)]
    fn asking(self, row: u32, group: u32, lane: u32) -> (u32, bool) {
        let Params { frame, args, .. } = self.params;
        let [set, _] = asks(args.method, args.kind, row);
        let k = group * GROUP + lane;
        (frame.start[set as usize] + k, k < frame.count[set as usize])
    }

    /// The interval of keys in a row of a thread's box, if the level and the cell there are known.
    #[inline(always)]
    fn interval(self, row: u32, place: u32, level: u32, cell: [u32; 3]) -> [u32; 2] {
        let (method, kind) = (self.params.args.method, self.params.args.kind);
        let [_, asked] = asks(method, kind, row);
        let (key, b) = (at(self.keys, place as usize), at(self.boxes, place as usize));
        interval(method, kind, row, asked, key, &b, self.survey, level, cell)
    }

    /// The interval of keys of a thread's box, an empty one where there is none; and the first
    /// place of its partners, as far as that is more than the interval says.
    #[inline(always)]
    fn partners(self, row: u32, place: u32, some: bool) -> [u32; 3] {
        if !some {
            return [u32::MAX, 0, 0];
        }
        let (method, kind) = (self.params.args.method, self.params.args.kind);
        let [_, asked] = asks(method, kind, row);
        let (key, b) = (at(self.keys, place as usize), at(self.boxes, place as usize));
        // Boxes of a group may be of different levels. A level of few boxes has the row that is all
        // of it, one of many has the other rows: in both kinds a box would find its partners twice.
        let step = step_of(method, row);
        let level = asked_level(method, row, step, key);
        let mut n_boxes = 0;
        if level < LEVELS {
            let first = (asked << BITS) + (level << CELL_BITS);
            let n_keys = self.params.frame.start[3];
            n_boxes = lower_bound(self.keys, n_keys, first + (1 << CELL_BITS))
                - lower_bound(self.keys, n_keys, first);
        }
        if !is_taken(method, row, n_boxes) {
            return [u32::MAX, 0, 0];
        }
        let cell = asked_cell(method, step, key, &b, self.survey);
        let [from, to] = interval(method, kind, row, asked, key, &b, self.survey, level, cell);
        [from, to, if kind == EDGE_EDGE { place + 1 } else { 0 }]
    }
}

kernel! {
    /// Workgroup `g` finds what the `g`-th group is compared with in the rows of a turn, and lists
    /// the pieces of that work. Thread `r` bisects for row `r`. `args.row`: the first of the turn.
    interval_work[128](t; params: Intervals; ranges: [u32; 656]; sorted: [Aabb], keys: [u32],
        survey: [u32], mut work: [u32]) {
        let Intervals { method, kind, row: turn } = params.args;
        let (group, n_keys, a_step) = (t.group, params.frame.start[3], rows_a_step(method));
        let [_, asked] = asks(method, kind, turn);
        set(ranges, FROM + t.lane, u32::MAX);
        set(ranges, TO + t.lane, 0);
        if t.lane <= LEVELS {
            let first = (asked << BITS) + (t.lane << CELL_BITS);
            set(ranges, LEVEL + t.lane, lower_bound(keys, n_keys, first));
        }
        barrier();
        let all = Sorted { params, boxes: sorted, keys, survey };
        let (place, some) = all.asking(turn, group, t.lane);
        if some {
            let (key, b) = (at(keys, place as usize), at(sorted, place as usize));
            for step in 0..steps(method) {
                let level = asked_level(method, turn, step, key);
                // Without levels, any number.
                let i = LEVEL + level.min(LEVELS - 1);
                let n_boxes = if level < LEVELS { get(ranges, i + 1) - get(ranges, i) } else { 0 };
                let [first, end] = rows_taken(method, n_boxes);
                let mut cell = [0; 3];
                if first < end {
                    cell = asked_cell(method, step, key, &b, survey);
                }
                for r in first..end {
                    let row = step * a_step + r;
                    let [from, to] = all.interval(turn + row, place, level, cell);
                    if from <= to {
                        lower_shared(ranges, FROM + row, from);
                        raise_shared(ranges, TO + row, to);
                    }
                }
            }
        }
        barrier();
        let (least, greatest) = (get(ranges, FROM + t.lane), get(ranges, TO + t.lane));
        let (mut begin, mut end, mut pieces) = (0, 0, 0);
        if least <= greatest {
            begin = lower_bound(keys, n_keys, least);
            if kind == EDGE_EDGE {
                // The first of the group asks from the second on.
                begin = begin.max(params.frame.start[1] + group * GROUP + 1);
            }
            // No key is the greatest number.
            end = lower_bound(keys, n_keys, greatest + 1);
            if begin < end {
                pieces = count(work, 0, (end - begin).div_ceil(CHUNK));
            }
        }
        set(ranges, BEGIN + t.lane, begin);
        set(ranges, END + t.lane, end);
        set(ranges, PIECES + t.lane, pieces);
        barrier();
        for row in 0..steps(method) * a_step {
            let (begin, end) = (get(ranges, BEGIN + row), get(ranges, END + row));
            let n_chunks = if begin < end { (end - begin).div_ceil(CHUNK) } else { 0 };
            for round in 0..n_chunks.div_ceil(GROUP) {
                let c = round * GROUP + t.lane;
                if c < n_chunks {
                    let first = begin + c * CHUNK;
                    let tiles = (end - first).min(CHUNK).div_ceil(GROUP);
                    let [a, b] = pack(turn + row, tiles, group, first);
                    let piece = get(ranges, PIECES + row) + c;
                    write_pair(work, params.dispatch.capacity_out, piece, Pair { a, b });
                }
            }
        }
    }
}

kernel! {
    /// A workgroup compares the boxes of a group with those of a chunk.
    interval_pairs[128](t; params: Intervals; boxes: [Aabb; 128], names: [u32; 128],
        hits: [u32; 2048], counters: [u32; 8]; sorted: [Aabb], keys: [u32], order: [u32],
        survey: [u32], work: [u32], mut pairs: [u32]) {
        let (group, groups) = (t.group, t.groups);
        let all = Sorted { params, boxes: sorted, keys, survey };
        let len = part(work, &params.dispatch);
        let n_keys = params.frame.start[3];
        // One piece a workgroup and round.
        for round in 0..decide::rounds(len, group, groups, 1) {
            let piece = read_pair(work, params.dispatch.first + group + round * groups);
            let [row, tiles, asks, first] = unpack([piece.a, piece.b]);
            let (place, some) = all.asking(row, asks, t.lane);
            let [from, to, after] = all.partners(row, place, some);
            let query = if some { at(sorted, place as usize) } else { Aabb::EMPTY };
            for tile in 0..tiles {
                let begin = first + tile * GROUP;
                let i = begin + t.lane;
                // No interval holds the greatest number.
                let (mut name, mut b) = (u32::MAX, Aabb::EMPTY);
                if i < n_keys {
                    name = at(keys, i as usize);
                    b = at(sorted, i as usize);
                }
                set(names, t.lane, name);
                set(boxes, t.lane, b);
                if t.lane == 0 {
                    set(counters, HITS, 0);
                }
                barrier();
                for c in 0..GROUP {
                    let name = get(names, c);
                    if name >= from
                        && name <= to
                        && begin + c >= after
                        && query.overlaps(&get(boxes, c))
                    {
                        let hit = add_shared(counters, HITS, 1);
                        if hit < POOL {
                            set(hits, hit, t.lane << 7 | c);
                        } else {
                            let pair = pair_of(params, row, place, begin + c, order);
                            append(pairs, params.dispatch.capacity_out, pair);
                        }
                    }
                }
                barrier();
                let n_hits = get(counters, HITS).min(POOL);
                if t.lane == 0 && n_hits > 0 {
                    set(counters, BASE, count(pairs, 0, n_hits));
                }
                barrier();
                let base = get(counters, BASE);
                for s in 0..POOL / GROUP {
                    let h = s * GROUP + t.lane;
                    if h >= n_hits {
                        break;
                    }
                    let hit = get(hits, h);
                    let (place, _) = all.asking(row, asks, hit >> 7);
                    let pair = pair_of(params, row, place, begin + hit % GROUP, order);
                    write_pair(pairs, params.dispatch.capacity_out, base + h, pair);
                }
                barrier();
            }
        }
    }
}

/// The ids of two boxes that overlap, from their places.
#[inline(always)]
fn pair_of(params: &Params<Intervals>, row: u32, asks: u32, asked: u32, order: &[u32]) -> Pair {
    let (a, b) = (at(order, asks as usize), at(order, asked as usize));
    let start = &params.frame.start;
    if params.args.kind == EDGE_EDGE {
        Pair::ordered(a - start[1], b - start[1])
    } else if is_second_turn(params.args.method, row) {
        Pair { a: b, b: a - start[2] }
    } else {
        Pair { a, b: b - start[2] }
    }
}
