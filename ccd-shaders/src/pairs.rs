//! Pairs of nodes, candidates, and candidates that pass the filters: a workgroup of 64 threads takes one pair of nodes after another.
//!
//! For each: the first 32 threads look at the children of one node, the others at those of the other; children that reach into the other node are gathered
//! in workgroup memory; those of one side become rows, those of the other columns, and every thread tests one row against its share of the columns.

use crate::share::{add, add_shared, barrier, get, group, length, set};
use ccd_core::Aabb;
use ccd_core::kernel::blocks::{THREADS, WIDTH, pack, row_bits, sets, slot, unpack, wanted};
use ccd_core::kernel::filter;
use ccd_core::layout::{LIST_HEADER, Leaf, Pair, Params, Path};
use ccd_core::slice::{at, put};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

/// Words of `counters`: children of either side, hits, hits that are kept, where they go in the list, hits that are candidates.
const ROWS: u32 = 0;
const HITS: u32 = 2;
const KEPT: u32 = 3;
const BASE: u32 = 4;
const WANTED: u32 = 5;

/// How many of the entries from `params.first` on, every `params.step`-th, are there for workgroup `own` of `groups`.
#[inline(always)]
fn rounds(params: &Params, there: u32, own: u32, groups: u32) -> u32 {
    let wanted = if there > params.first { (there - params.first).div_ceil(params.step) } else { 0 };
    let n = wanted.min(params.limit);
    if n > own { (n - own).div_ceil(groups) } else { 0 }
}

/// Finds which children of the nodes `pair` overlap and writes each hit into `hits`, their number into `counters[HITS]`. `leaves`: the children are boxes, and
/// a box is no pair with itself.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn test_children(
    lane: u32,
    params: &Params,
    pair: [u32; 2],
    leaves: bool,
    nodes: &[Aabb],
    sides: &mut [Aabb; 64],
    names: &mut [u32; 64],
    counters: &mut [u32; 8],
    hits: &mut [u32; 1024],
) {
    if lane < 8 {
        set(counters, lane, 0);
    }
    barrier();
    let [set_a, set_b] = sets(params.kind);
    let side = lane / WIDTH;
    let (own_set, own_node) = if side == 0 { (set_a, pair[0]) } else { (set_b, pair[1]) };
    let (other_set, other_node) = if side == 0 { (set_b, pair[1]) } else { (set_a, pair[0]) };
    let child = at(nodes, slot(params, params.level - 1, own_set, own_node * WIDTH + lane % WIDTH));
    if child.overlaps(&at(nodes, slot(params, params.level, other_set, other_node))) {
        let to = side * WIDTH + add_shared(counters, ROWS + side, 1);
        set(sides, to, child);
        set(names, to, lane % WIDTH);
    }
    barrier();
    let (n_rows, n_columns) = (get(counters, ROWS), get(counters, ROWS + 1));
    let bits = row_bits(n_rows);
    let row = lane & ((1 << bits) - 1);
    if row < n_rows {
        let a = get(sides, row);
        let i = get(names, row);
        let same = params.kind == 1 && pair[0] == pair[1];
        let mut column = lane >> bits;
        for _ in 0..WIDTH {
            if column >= n_columns {
                break;
            }
            let b = get(sides, WIDTH + column);
            if a.overlaps(&b) {
                let j = get(names, WIDTH + column);
                // Within one node each pair comes twice, and once with itself.
                if !same || i < j || (i == j && !leaves) {
                    let to = add_shared(counters, HITS, 1);
                    set(hits, to, pack(i, j));
                }
            }
            column += THREADS >> bits;
        }
    }
    barrier();
}

/// Reserves room in `list` for what the workgroup kept, `counters[KEPT]`; returns where it begins.
#[inline(always)]
fn reserve(lane: u32, counters: &mut [u32; 8], list: &mut [u32]) -> u32 {
    barrier();
    if lane == 0 {
        let n = get(counters, KEPT);
        if n > 0 {
            set(counters, BASE, add(list, 0, n));
        }
    }
    barrier();
    get(counters, BASE)
}

/// Writes pair `i` of a list; one for which there is no room is only counted.
#[inline(always)]
fn write(list: &mut [u32], room: u32, i: u32, pair: [u32; 2]) {
    if i < room {
        put(list, LIST_HEADER + 2 * i as usize, pair[0]);
        put(list, LIST_HEADER + 2 * i as usize + 1, pair[1]);
    }
}

#[inline(always)]
fn read(list: &[u32], i: u32) -> [u32; 2] {
    let at_word = LIST_HEADER + 2 * i as usize;
    [at(list, at_word), at(list, at_word + 1)]
}

/// From pairs of nodes of level `params.level` to those of their children that overlap.
#[spirv(compute(threads(64)))]
pub fn node_pairs(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] sides: &mut [Aabb; 64],
    #[spirv(workgroup)] names: &mut [u32; 64],
    #[spirv(workgroup)] counters: &mut [u32; 8],
    #[spirv(workgroup)] hits: &mut [u32; 1024],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] input: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] output: &mut [u32],
) {
    let (own, groups) = (group(id, n), n.x * n.y);
    for round in 0..rounds(params, length(input, params.room_in), own, groups) {
        let pair = read(input, params.first + (own + round * groups) * params.step);
        test_children(lane, params, pair, false, nodes, sides, names, counters, hits);
        let n_hits = get(counters, HITS);
        if lane == 0 {
            set(counters, KEPT, n_hits);
        }
        let base = reserve(lane, counters, output);
        let mut h = lane;
        for _ in 0..16 {
            if h >= n_hits {
                break;
            }
            let [i, j] = unpack(get(hits, h));
            write(output, params.room_out, base + h, [pair[0] * WIDTH + i, pair[1] * WIDTH + j]);
            h += THREADS;
        }
        barrier();
    }
}

/// From pairs of nodes of level 1 to candidates, as pairs of ids.
#[spirv(compute(threads(64)))]
pub fn list_candidates(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] sides: &mut [Aabb; 64],
    #[spirv(workgroup)] names: &mut [u32; 64],
    #[spirv(workgroup)] counters: &mut [u32; 8],
    #[spirv(workgroup)] hits: &mut [u32; 1024],
    #[spirv(workgroup)] kept: &mut [u32; 1024],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Aabb],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] leaves: &[Leaf],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] bodies: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] keys: &[[[u32; 2]; 6]],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] input: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] output: &mut [u32],
) {
    let (own, groups) = (group(id, n), n.x * n.y);
    let [set_a, set_b] = sets(params.kind);
    for round in 0..rounds(params, length(input, params.room_in), own, groups) {
        let pair = read(input, params.first + (own + round * groups) * params.step);
        test_children(lane, params, pair, true, nodes, sides, names, counters, hits);
        let n_hits = get(counters, HITS);
        let mut h = lane;
        for _ in 0..16 {
            if h >= n_hits {
                break;
            }
            let hit = get(hits, h);
            let [i, j] = unpack(hit);
            let (p, q) = (slot(params, 0, set_a, pair[0] * WIDTH + i), slot(params, 0, set_b, pair[1] * WIDTH + j));
            if wanted(params, &at(leaves, p), &at(leaves, q), [&at(nodes, p), &at(nodes, q)], bodies, keys) {
                let to = add_shared(counters, KEPT, 1);
                set(kept, to, hit);
            }
            h += THREADS;
        }
        let base = reserve(lane, counters, output);
        let n_kept = get(counters, KEPT);
        let mut h = lane;
        for _ in 0..16 {
            if h >= n_kept {
                break;
            }
            let [i, j] = unpack(get(kept, h));
            let (p, q) = (slot(params, 0, set_a, pair[0] * WIDTH + i), slot(params, 0, set_b, pair[1] * WIDTH + j));
            let (a, b) = (at(leaves, p).id, at(leaves, q).id);
            let pair = if params.kind == 0 { Pair { a, b } } else { Pair::ordered(a, b) };
            write(output, params.room_out, base + h, [pair.a, pair.b]);
            h += THREADS;
        }
        barrier();
    }
}

macro_rules! filter_entry {
    ($(#[$doc:meta])* $name:ident, $sets:expr, $may_touch:expr) => {
        $(#[$doc])*
        #[spirv(compute(threads(64)))]
        pub fn $name(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] sides: &mut [Aabb; 64],
            #[spirv(workgroup)] names: &mut [u32; 64],
            #[spirv(workgroup)] counters: &mut [u32; 8],
            #[spirv(workgroup)] hits: &mut [u32; 1024],
            #[spirv(workgroup)] kept: &mut [u32; 1024],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[Aabb],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] leaves: &[Leaf],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] bodies: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] keys: &[[[u32; 2]; 6]],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] paths: &[Path],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] input: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 7)] output: &mut [u32],
        ) {
            let (own, groups) = (group(id, n), n.x * n.y);
            let [set_a, set_b] = $sets;
            for round in 0..rounds(params, length(input, params.room_in), own, groups) {
                let pair = read(input, params.first + (own + round * groups) * params.step);
                test_children(lane, params, pair, true, nodes, sides, names, counters, hits);
                let n_hits = get(counters, HITS);
                let mut h = lane;
                for _ in 0..16 {
                    if h >= n_hits {
                        break;
                    }
                    let hit = get(hits, h);
                    let [i, j] = unpack(hit);
                    let (p, q) = (slot(params, 0, set_a, pair[0] * WIDTH + i), slot(params, 0, set_b, pair[1] * WIDTH + j));
                    let (a, b) = (at(leaves, p), at(leaves, q));
                    if wanted(params, &a, &b, [&at(nodes, p), &at(nodes, q)], bodies, keys) {
                        add_shared(counters, WANTED, 1);
                        if $may_touch(&a, &b, paths, params) {
                            let to = add_shared(counters, KEPT, 1);
                            set(kept, to, hit);
                        }
                    }
                    h += THREADS;
                }
                let base = reserve(lane, counters, output);
                // The candidates themselves are not written; how many there were is the second word of the list.
                if lane == 0 {
                    add(output, 1, get(counters, WANTED));
                }
                let n_kept = get(counters, KEPT);
                let mut h = lane;
                for _ in 0..16 {
                    if h >= n_kept {
                        break;
                    }
                    let [i, j] = unpack(get(kept, h));
                    let (p, q) = (slot(params, 0, set_a, pair[0] * WIDTH + i), slot(params, 0, set_b, pair[1] * WIDTH + j));
                    let (a, b) = (at(leaves, p).id, at(leaves, q).id);
                    let pair = if set_a != set_b { Pair { a, b } } else { Pair::ordered(a, b) };
                    write(output, params.room_out, base + h, [pair.a, pair.b]);
                    h += THREADS;
                }
                barrier();
            }
        }
    };
}

filter_entry!(
    /// From pairs of nodes of level 1 to the vertex-face candidates that may touch.
    filter_vertex_face,
    sets(0),
    may_touch_vertex_face
);
filter_entry!(
    /// From pairs of nodes of level 1 to the edge-edge candidates that may touch.
    filter_edge_edge,
    sets(1),
    may_touch_edge_edge
);

#[inline(always)]
fn may_touch_vertex_face(a: &Leaf, b: &Leaf, paths: &[Path], params: &Params) -> bool {
    filter::vertex_face(a, b, paths, params.path_error, params.min_distance)
}

/// Pairs enter the arithmetic with the lesser edge first, so no result depends on the order of leaves.
#[inline(always)]
fn may_touch_edge_edge(a: &Leaf, b: &Leaf, paths: &[Path], params: &Params) -> bool {
    let (first, second) = if a.id < b.id { (*a, *b) } else { (*b, *a) };
    filter::edge_edge(&first, &second, paths, params.path_error, params.min_distance)
}
