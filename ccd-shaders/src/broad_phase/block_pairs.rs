//! Pairs of nodes, candidates, and candidates that pass the filters: a workgroup takes four pairs
//! of nodes at once, a team of 32 threads each.
//!
//! A thread holds one child of the first node; the children of the second that reach into the first
//! are gathered in workgroup memory, and every thread whose child reaches into the second tests it
//! against all of them. The hits of all teams are then worked on together, one a thread.

use crate::records::{BoxWords, box_at};
use crate::workgroup::{
    add_shared, append, barrier, count, get, group, length, read_pair, set, write_pair,
};
use ccd_core::Aabb;
use ccd_core::broad_phase::block_bvh::{
    NOT_KEPT, POOL, TEAMS, THREADS, WIDTH, keep, kept, pack, sets, slot, unpack,
};
use ccd_core::broad_phase::candidate::wanted;
use ccd_core::kernel::memory::at;
use ccd_core::layout::{Blocks, Frame, Leaf, Pair, Params, Path};
use ccd_core::narrow_phase::cascade;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

/// Words of `counters`: columns of each team, hits, hits that are kept, where they go in the list,
/// hits that are candidates.
pub(super) const HITS: u32 = 4;
pub(super) const KEPT: u32 = 5;
const BASE: u32 = 6;
const WANTED: u32 = 7;
/// Hits of the pool that a thread works on, at most.
const SHARE: u32 = POOL / THREADS;

/// Rounds of workgroup `own` of `groups`: how often it takes `TEAMS` of the entries from
/// `dispatch.first` on, every `own.step`-th.
#[inline(always)]
pub(super) fn rounds(params: &Params<Blocks>, there: u32, own: u32, groups: u32) -> u32 {
    let n = entries(params, there).div_ceil(TEAMS);
    if n > own { (n - own).div_ceil(groups) } else { 0 }
}

/// Entries that this dispatch looks at.
#[inline(always)]
fn entries(params: &Params<Blocks>, there: u32) -> u32 {
    let wanted = if there > params.dispatch.first {
        (there - params.dispatch.first).div_ceil(params.own.step)
    } else {
        0
    };
    wanted.min(params.own.limit)
}

/// The pair of nodes of a team; the second part says whether there is one: a team without tests
/// nothing, see [`gather`].
#[inline(always)]
pub(super) fn team_pair(
    params: &Params<Blocks>,
    list: &[u32],
    there: u32,
    own: u32,
    groups: u32,
    round: u32,
    team: u32,
) -> (Pair, bool) {
    let i = (own + round * groups) * TEAMS + team;
    let some = i < entries(params, there);
    let pair = read_pair(list, params.dispatch.first + if some { i * params.own.step } else { 0 });
    (pair, some)
}

#[inline(always)]
pub(super) fn clear(lane: u32, counters: &mut [u32; 8]) {
    if lane < 8 {
        set(counters, lane, 0);
    }
    barrier();
}

/// Gathers the columns of each team. Returns this thread's child of the first node, empty if it
/// does not reach into the second.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
pub(super) fn gather(
    lane: u32,
    params: &Params<Blocks>,
    pair: Pair,
    some: bool,
    nodes: &[BoxWords],
    columns: &mut [Aabb; 128],
    names: &mut [u32; 128],
    counters: &mut [u32; 8],
) -> Aabb {
    let [set_a, set_b] = sets(params.own.kind);
    let (team, own) = (lane / WIDTH, lane % WIDTH);
    let (a, b) = (
        box_at(nodes, slot(&params.own, params.own.level, set_a, pair.a)),
        box_at(nodes, slot(&params.own, params.own.level, set_b, pair.b)),
    );
    let row = box_at(nodes, slot(&params.own, params.own.level - 1, set_a, pair.a * WIDTH + own));
    let column =
        box_at(nodes, slot(&params.own, params.own.level - 1, set_b, pair.b * WIDTH + own));
    if some && column.overlaps(&a) {
        let to = team * WIDTH + add_shared(counters, team, 1);
        set(columns, to, column);
        set(names, to, own);
    }
    barrier();
    if some && row.overlaps(&b) { row } else { Aabb::EMPTY }
}

/// Whether child `i` of the first node and `j` of the second are a pair: within one node each pair
/// comes twice, and once with itself.
#[inline(always)]
fn counts(same: bool, leaves: bool, i: u32, j: u32) -> bool {
    !same || i < j || (i == j && !leaves)
}

/// Tests this thread's row against the columns of its team and pools the hits. Returns the columns
/// of those for which the pool has no room, as bits.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
fn test(
    lane: u32,
    row: Aabb,
    same: bool,
    leaves: bool,
    columns: &[Aabb; 128],
    names: &[u32; 128],
    counters: &mut [u32; 8],
    hits: &mut [u32; 2048],
) -> u32 {
    let (team, i) = (lane / WIDTH, lane % WIDTH);
    let mut beyond = 0;
    for c in 0..get(counters, team) {
        let j = get(names, team * WIDTH + c);
        if row.overlaps(&get(columns, team * WIDTH + c)) && counts(same, leaves, i, j) {
            let to = add_shared(counters, HITS, 1);
            if to < POOL {
                set(hits, to, pack(team, i, j));
            } else {
                beyond |= 1 << c;
            }
        }
    }
    beyond
}

/// Reserves room in `list` for what the workgroup kept, `counters[KEPT]`; returns where it begins.
#[inline(always)]
pub(super) fn reserve(lane: u32, counters: &mut [u32; 8], list: &mut [u32]) -> u32 {
    barrier();
    if lane == 0 {
        let n = get(counters, KEPT);
        if n > 0 {
            set(counters, BASE, count(list, 0, n));
        }
    }
    barrier();
    get(counters, BASE)
}

/// From pairs of nodes of level `own.level` to those of their children that overlap.
#[spirv(compute(threads(128)))]
pub fn node_pairs(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] columns: &mut [Aabb; 128],
    #[spirv(workgroup)] names: &mut [u32; 128],
    #[spirv(workgroup)] counters: &mut [u32; 8],
    #[spirv(workgroup)] hits: &mut [u32; 2048],
    #[spirv(workgroup)] firsts: &mut [u32; 8],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] input: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] output: &mut [u32],
) {
    let (own, groups) = (group(id, n), n.x * n.y);
    let there = length(input, params.dispatch.room_in);
    let team = lane / WIDTH;
    for round in 0..rounds(params, there, own, groups) {
        let (pair, some) = team_pair(params, input, there, own, groups, round, team);
        clear(lane, counters);
        if lane % WIDTH == 0 {
            set(firsts, 2 * team, pair.a * WIDTH);
            set(firsts, 2 * team + 1, pair.b * WIDTH);
        }
        let row = gather(lane, params, pair, some, nodes, columns, names, counters);
        let same = params.own.kind == 1 && pair.a == pair.b;
        let mut beyond = test(lane, row, same, false, columns, names, counters, hits);
        for _ in 0..WIDTH {
            if beyond == 0 {
                break;
            }
            let j = get(names, team * WIDTH + beyond.trailing_zeros());
            beyond &= beyond - 1;
            append(
                output,
                params.dispatch.room_out,
                Pair { a: pair.a * WIDTH + lane % WIDTH, b: pair.b * WIDTH + j },
            );
        }
        barrier();
        let n_hits = get(counters, HITS).min(POOL);
        if lane == 0 {
            set(counters, KEPT, n_hits);
        }
        let base = reserve(lane, counters, output);
        for s in 0..SHARE {
            let h = lane + s * THREADS;
            if h >= n_hits {
                break;
            }
            let [t, i, j] = unpack(get(hits, h));
            let pair = Pair { a: get(firsts, 2 * t) + i, b: get(firsts, 2 * t + 1) + j };
            write_pair(output, params.dispatch.room_out, base + h, pair);
        }
        barrier();
    }
}

macro_rules! leaf_entry {
    (
        $(#[$doc:meta])* $name:ident, $kind:ident, $may_touch:ident, [$($paths:ident)?],
        $input:literal, $output:literal
    ) => {
        $(#[$doc])*
        #[spirv(compute(threads(128)))]
        pub fn $name(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] columns: &mut [Aabb; 128],
            #[spirv(workgroup)] names: &mut [u32; 128],
            #[spirv(workgroup)] counters: &mut [u32; 8],
            #[spirv(workgroup)] hits: &mut [u32; 2048],
            #[spirv(workgroup)] firsts: &mut [u32; 8],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<Blocks>,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] nodes: &[BoxWords],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] leaves: &[Leaf],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] bodies: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] keys: &[[[u32; 2]; 6]],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = 5)] $paths: &[Path],)?
            #[spirv(storage_buffer, descriptor_set = 0, binding = $input)] input: &[u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $output)] output: &mut [u32],
        ) {
            let (own, groups) = (group(id, n), n.x * n.y);
            let there = length(input, params.dispatch.room_in);
            let (team, i) = (lane / WIDTH, lane % WIDTH);
            let kind = $kind(params);
            let [set_a, set_b] = sets(kind);
            for round in 0..rounds(params, there, own, groups) {
                let (pair, some) = team_pair(params, input, there, own, groups, round, team);
                clear(lane, counters);
                let (first_a, first_b) = (
                    slot(&params.own, 0, set_a, pair.a * WIDTH) as u32,
                    slot(&params.own, 0, set_b, pair.b * WIDTH) as u32,
                );
                if i == 0 {
                    set(firsts, 2 * team, first_a);
                    set(firsts, 2 * team + 1, first_b);
                }
                let row = gather(lane, params, pair, some, nodes, columns, names, counters);
                let same = set_a == set_b && pair.a == pair.b;
                let mut beyond = test(lane, row, same, true, columns, names, counters, hits);
                for _ in 0..WIDTH {
                    if beyond == 0 {
                        break;
                    }
                    let j = get(names, team * WIDTH + beyond.trailing_zeros());
                    beyond &= beyond - 1;
                    // Not filtered, which is allowed: filters only save work.
                    let (p, q) = ((first_a + i) as usize, (first_b + j) as usize);
                    let (a, b) = (at(leaves, p), at(leaves, q));
                    if wanted(
                        &params.frame,
                        kind,
                        &a,
                        &b,
                        [&box_at(nodes, p), &box_at(nodes, q)],
                        bodies,
                        keys,
                    ) {
                        append(output, params.dispatch.room_out, ids(set_a == set_b, a.id, b.id));
                        count(output, 1, 1);
                    }
                }
                barrier();
                let n_hits = get(counters, HITS).min(POOL);
                for s in 0..SHARE {
                    let h = lane + s * THREADS;
                    if h >= n_hits {
                        break;
                    }
                    let hit = get(hits, h);
                    let [t, i, j] = unpack(hit);
                    let (p, q) = (
                        (get(firsts, 2 * t) + i) as usize,
                        (get(firsts, 2 * t + 1) + j) as usize,
                    );
                    let (a, b) = (at(leaves, p), at(leaves, q));
                    if wanted(
                        &params.frame,
                        kind,
                        &a,
                        &b,
                        [&box_at(nodes, p), &box_at(nodes, q)],
                        bodies,
                        keys,
                    ) {
                        add_shared(counters, WANTED, 1);
                        if $may_touch(&a, &b, &params.frame, $($paths)?) {
                            let to = add_shared(counters, KEPT, 1);
                            set(hits, h, keep(hit, to));
                        }
                    }
                }
                let base = reserve(lane, counters, output);
                // The candidates themselves need not be written; how many there were is the second
                // word of the list.
                if lane == 0 {
                    let n = get(counters, WANTED);
                    if n > 0 {
                        count(output, 1, n);
                    }
                }
                for s in 0..SHARE {
                    let h = lane + s * THREADS;
                    if h >= n_hits {
                        break;
                    }
                    let hit = get(hits, h);
                    let to = kept(hit);
                    if to != NOT_KEPT {
                        let [t, i, j] = unpack(hit);
                        let (a, b) = (
                            at(leaves, (get(firsts, 2 * t) + i) as usize),
                            at(leaves, (get(firsts, 2 * t + 1) + j) as usize),
                        );
                        write_pair(
                            output,
                            params.dispatch.room_out,
                            base + to,
                            ids(set_a == set_b, a.id, b.id),
                        );
                    }
                }
                barrier();
            }
        }
    };
}

leaf_entry!(
    /// From pairs of nodes of level 1 to candidates, as pairs of ids.
    list_candidates,
    any_kind,
    all,
    [],
    5,
    6
);
leaf_entry!(
    /// From pairs of nodes of level 1 to the vertex-face candidates that may touch.
    filter_vertex_face,
    vertex_face_kind,
    may_touch_vertex_face,
    [paths],
    6,
    7
);
leaf_entry!(
    /// From pairs of nodes of level 1 to the edge-edge candidates that may touch.
    filter_edge_edge,
    edge_edge_kind,
    may_touch_edge_edge,
    [paths],
    6,
    7
);

#[inline(always)]
fn any_kind(params: &Params<Blocks>) -> u32 {
    params.own.kind
}

#[inline(always)]
fn vertex_face_kind(_params: &Params<Blocks>) -> u32 {
    0
}

#[inline(always)]
fn edge_edge_kind(_params: &Params<Blocks>) -> u32 {
    1
}

/// Ids of a pair; within one set the lesser first.
#[inline(always)]
fn ids(one_set: bool, a: u32, b: u32) -> Pair {
    if one_set { Pair::ordered(a, b) } else { Pair { a, b } }
}

#[inline(always)]
fn all(_a: &Leaf, _b: &Leaf, _frame: &Frame) -> bool {
    true
}

#[inline(always)]
fn may_touch_vertex_face(a: &Leaf, b: &Leaf, frame: &Frame, paths: &[Path]) -> bool {
    cascade::vertex_face(a, b, paths, frame.path_error, frame.min_distance)
}

/// Pairs enter the arithmetic with the lesser edge first, so no result depends on the order of
/// leaves.
#[inline(always)]
fn may_touch_edge_edge(a: &Leaf, b: &Leaf, frame: &Frame, paths: &[Path]) -> bool {
    let (first, second) = if a.id < b.id { (*a, *b) } else { (*b, *a) };
    cascade::edge_edge(&first, &second, paths, frame.path_error, frame.min_distance)
}
