//! Pairs of nodes of block trees: a workgroup takes four pairs of nodes at once, a team of 32
//! threads each.
//!
//! A thread holds one child of the first node; the children of the second that reach into the first
//! are gathered in workgroup memory, and every thread whose child reaches into the second tests it
//! against all of them. The hits of all teams are then worked on together, one a thread.

use crate::entry::{Thread, kernel};
use crate::records::{BoxWords, box_at};
use crate::workgroup::{
    add_shared, append, barrier, count, get, length, read_pair, set, write_pair,
};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{
    POOL, TEAMS, THREADS, WIDTH, pack, sets, slot, unpack,
};
use ccd_core::backend::broad_phase::worlds::{meet, range};
use ccd_core::backend::layout::EDGE_EDGE;
use ccd_core::backend::layout::{Blocks, Pair, Params};

/// Words of `counters`: columns of each team, hits, hits that are kept, where they go in the list,
/// hits that are candidates.
pub(super) const HITS: u32 = 4;
pub(super) const KEPT: u32 = 5;
const BASE: u32 = 6;
/// Hits of the pool that a thread works on, at most.
pub(super) const SHARE: u32 = POOL / THREADS;

/// Rounds of workgroup `group` of `groups`: how often it takes `TEAMS` of the entries from
/// `dispatch.first` on, every `group.step`-th.
#[inline(always)]
pub(super) fn rounds(params: &Params<Blocks>, len: u32, group: u32, groups: u32) -> u32 {
    let n = entries(params, len).div_ceil(TEAMS);
    if n > group { (n - group).div_ceil(groups) } else { 0 }
}

/// Entries that this dispatch looks at.
#[inline(always)]
fn entries(params: &Params<Blocks>, len: u32) -> u32 {
    let wanted = if len > params.dispatch.first {
        (len - params.dispatch.first).div_ceil(params.args.step)
    } else {
        0
    };
    wanted.min(params.args.limit)
}

/// The pair of nodes of a team; the second part says whether there is one: a team without tests
/// nothing, see [`gather`].
#[inline(always)]
pub(super) fn team_pair(
    params: &Params<Blocks>,
    list: &[u32],
    len: u32,
    group: u32,
    groups: u32,
    round: u32,
    team: u32,
) -> (Pair, bool) {
    let i = (group + round * groups) * TEAMS + team;
    let some = i < entries(params, len);
    let pair = read_pair(list, params.dispatch.first + if some { i * params.args.step } else { 0 });
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
    let [set_a, set_b] = sets(params.args.kind);
    let (team, child) = (lane / WIDTH, lane % WIDTH);
    let (a, b) = (
        box_at(nodes, slot(&params.args, params.args.level, set_a, pair.a)),
        box_at(nodes, slot(&params.args, params.args.level, set_b, pair.b)),
    );
    let row =
        box_at(nodes, slot(&params.args, params.args.level - 1, set_a, pair.a * WIDTH + child));
    let column =
        box_at(nodes, slot(&params.args, params.args.level - 1, set_b, pair.b * WIDTH + child));
    if some && column.overlaps(&a) {
        let to = team * WIDTH + add_shared(counters, team, 1);
        set(columns, to, column);
        set(names, to, child);
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
/// of those for which the pool has no room, as bits. `OF_WORLDS`: only those that have a world in
/// common: `worlds` are those of the row, `ranges` those of the second node's children.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
pub(super) fn test<const N: usize, const OF_WORLDS: bool>(
    lane: u32,
    row: Aabb,
    same: bool,
    leaves: bool,
    columns: &[Aabb; 128],
    names: &[u32; 128],
    counters: &mut [u32; 8],
    hits: &mut [u32; 2048],
    worlds: u32,
    ranges: &[u32; N],
) -> u32 {
    let (team, i) = (lane / WIDTH, lane % WIDTH);
    let mut beyond = 0;
    for c in 0..get(counters, team) {
        let j = get(names, team * WIDTH + c);
        if row.overlaps(&get(columns, team * WIDTH + c))
            && counts(same, leaves, i, j)
            && (!OF_WORLDS || meet(worlds, get(ranges, team * WIDTH + j)))
        {
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

kernel! {
    /// From pairs of nodes of level `args.level` to those of their children that overlap.
    node_pairs[128](t; params: Blocks; columns: [Aabb; 128], names: [u32; 128], ranges: [u32; 1],
        counters: [u32; 8], hits: [u32; 2048], firsts: [u32; 8]; nodes: [BoxWords], input: [u32],
        mut output: [u32]) {
        children::<1, false>(
            t, params, columns, names, ranges, counters, hits, firsts, nodes, input, input, output,
        );
    }
}

kernel! {
    /// As `node_pairs`, of nodes that have a world in common. `worlds`: of the leaves of level 0.
    node_pairs_of_worlds[128](t; params: Blocks; columns: [Aabb; 128], names: [u32; 128],
        ranges: [u32; 128], counters: [u32; 8], hits: [u32; 2048], firsts: [u32; 8];
        nodes: [BoxWords], worlds: [u32], input: [u32], mut output: [u32]) {
        children::<128, true>(
            t, params, columns, names, ranges, counters, hits, firsts, nodes, worlds, input, output,
        );
    }
}

#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
fn children<const N: usize, const OF_WORLDS: bool>(
    t: Thread,
    params: &Params<Blocks>,
    columns: &mut [Aabb; 128],
    names: &mut [u32; 128],
    ranges: &mut [u32; N],
    counters: &mut [u32; 8],
    hits: &mut [u32; 2048],
    firsts: &mut [u32; 8],
    nodes: &[BoxWords],
    worlds: &[u32],
    input: &[u32],
    output: &mut [u32],
) {
    let len = length(input, params.dispatch.capacity_in);
    let (team, i) = (t.lane / WIDTH, t.lane % WIDTH);
    for round in 0..rounds(params, len, t.group, t.groups) {
        let (pair, some) = team_pair(params, input, len, t.group, t.groups, round, team);
        clear(t.lane, counters);
        if i == 0 {
            set(firsts, 2 * team, pair.a * WIDTH);
            set(firsts, 2 * team + 1, pair.b * WIDTH);
        }
        let mut of_row = 0;
        if OF_WORLDS {
            let ([a, b], level, n) =
                (sets(params.args.kind), params.args.level - 1, params.frame.count);
            let args = &params.args;
            of_row = range(args, level, a, pair.a * WIDTH + i, n[a], worlds);
            set(ranges, t.lane, range(args, level, b, pair.b * WIDTH + i, n[b], worlds));
        }
        let row = gather(t.lane, params, pair, some, nodes, columns, names, counters);
        let same = params.args.kind == EDGE_EDGE && pair.a == pair.b;
        let mut beyond = test::<N, OF_WORLDS>(
            t.lane, row, same, false, columns, names, counters, hits, of_row, ranges,
        );
        for _ in 0..WIDTH {
            if beyond == 0 {
                break;
            }
            let j = get(names, team * WIDTH + beyond.trailing_zeros());
            beyond &= beyond - 1;
            let pair = Pair { a: pair.a * WIDTH + i, b: pair.b * WIDTH + j };
            append(output, params.dispatch.capacity_out, pair);
        }
        barrier();
        let n_hits = get(counters, HITS).min(POOL);
        if t.lane == 0 {
            set(counters, KEPT, n_hits);
        }
        let base = reserve(t.lane, counters, output);
        for s in 0..SHARE {
            let h = t.lane + s * THREADS;
            if h >= n_hits {
                break;
            }
            let [team, i, j] = unpack(get(hits, h));
            let pair = Pair { a: get(firsts, 2 * team) + i, b: get(firsts, 2 * team + 1) + j };
            write_pair(output, params.dispatch.capacity_out, base + h, pair);
        }
        barrier();
    }
}
