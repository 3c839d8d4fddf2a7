//! From pairs of blocks to candidates, or to candidates that pass the filters: pairs of boxes as in
//! `block_pairs`, then one hit a thread.
//!
//! Twin: on a CPU `block_pairs.rs`, whose sink looks at candidates.

use super::block_pairs::{HITS, KEPT, SHARE, Teams};
use crate::entry::kernel;
use crate::records::{BoxWords, box_at};
use crate::workgroup::{add_shared, append, barrier, count, get, length, set, write_pair};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{
    NOT_KEPT, POOL, THREADS, WIDTH, keep, kept, sets, slot, unpack,
};
use ccd_core::backend::broad_phase::candidate::wanted;
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::{Blocks, Frame, Leaf, Pair, Params, Path};
use ccd_core::narrow_phase::cascade;
use ccd_core::narrow_phase::relative_motion::Patch;

/// A word of `counters` besides those of `block_pairs`: hits that are candidates.
const WANTED: u32 = 7;

macro_rules! leaf_entry {
    ($(#[$doc:meta])* $name:ident, $kind:ident, $may_touch:ident [$($paths:ident)?]) => {
        kernel! {
            $(#[$doc])*
            $name[128](t; params: Blocks; columns: [Aabb; 128], names: [u32; 128],
                ranges: [u32; 1], counters: [u32; 8], hits: [u32; 2048], firsts: [u32; 8];
                nodes: [BoxWords], leaves: [Leaf], bodies: [u32], keys: [[[u32; 2]; 6]],
                $($paths: [Path],)? input: [u32], mut output: [u32]) {
                let (frame, capacity) = (&params.frame, params.dispatch.capacity_out);
                let len = length(input, params.dispatch.capacity_in);
                let (lane, team, i) = (t.lane, t.lane / WIDTH, t.lane % WIDTH);
                let kind = $kind(params);
                let [set_a, set_b] = sets(kind);
                let mut teams =
                    Teams { t, params, nodes, columns, names, ranges, counters, hits, firsts };
                for round in 0..teams.rounds(len) {
                    let (pair, some) = teams.pair(input, len, round);
                    teams.clear();
                    let (first_a, first_b) = (
                        slot(&params.args, 0, set_a, pair.a * WIDTH) as u32,
                        slot(&params.args, 0, set_b, pair.b * WIDTH) as u32,
                    );
                    if i == 0 {
                        set(teams.firsts, 2 * team, first_a);
                        set(teams.firsts, 2 * team + 1, first_b);
                    }
                    let row = teams.gather(pair, some);
                    let same = set_a == set_b && pair.a == pair.b;
                    let mut beyond = teams.test(row, same, true, 0);
                    for _ in 0..WIDTH {
                        if beyond == 0 {
                            break;
                        }
                        let j = get(teams.names, team * WIDTH + beyond.trailing_zeros());
                        beyond &= beyond - 1;
                        // Not filtered, which is allowed: filters only save work.
                        let (p, q) = ((first_a + i) as usize, (first_b + j) as usize);
                        let (a, b) = (at(leaves, p), at(leaves, q));
                        let both = [&box_at(nodes, p), &box_at(nodes, q)];
                        if wanted(frame, kind, &a, &b, both, bodies, keys) {
                            append(output, capacity, ids(set_a == set_b, a.id, b.id));
                            count(output, 1, 1);
                        }
                    }
                    barrier();
                    let n_hits = get(teams.counters, HITS).min(POOL);
                    for s in 0..SHARE {
                        let h = lane + s * THREADS;
                        if h >= n_hits {
                            break;
                        }
                        let hit = get(teams.hits, h);
                        let [p, q] = teams.leaves_of(hit);
                        let (a, b) = (at(leaves, p), at(leaves, q));
                        let both = [&box_at(nodes, p), &box_at(nodes, q)];
                        if wanted(frame, kind, &a, &b, both, bodies, keys) {
                            add_shared(teams.counters, WANTED, 1);
                            if $may_touch(&a, &b, frame, $($paths)?) {
                                let to = add_shared(teams.counters, KEPT, 1);
                                set(teams.hits, h, keep(hit, to));
                            }
                        }
                    }
                    let base = teams.reserve(output);
                    // The candidates themselves need not be written; their number is the second
                    // word of the list.
                    if lane == 0 {
                        let n = get(teams.counters, WANTED);
                        if n > 0 {
                            count(output, 1, n);
                        }
                    }
                    for s in 0..SHARE {
                        let h = lane + s * THREADS;
                        if h >= n_hits {
                            break;
                        }
                        let hit = get(teams.hits, h);
                        let to = kept(hit);
                        if to != NOT_KEPT {
                            let [p, q] = teams.leaves_of(hit);
                            let (a, b) = (at(leaves, p), at(leaves, q));
                            let pair = ids(set_a == set_b, a.id, b.id);
                            write_pair(output, capacity, base + to, pair);
                        }
                    }
                    barrier();
                }
            }
        }
    };
}

impl<const N: usize> Teams<'_, N> {
    /// Where the two leaves of a hit are.
    #[inline(always)]
    fn leaves_of(&self, hit: u32) -> [usize; 2] {
        let [team, i, j] = unpack(hit);
        let (a, b) = (get(self.firsts, 2 * team) + i, get(self.firsts, 2 * team + 1) + j);
        [a as usize, b as usize]
    }
}

leaf_entry!(
    /// From pairs of nodes of level 1 to candidates, as pairs of ids.
    list_candidates, any_kind, all []
);
leaf_entry!(
    /// From pairs of nodes of level 1 to the vertex-face candidates that may touch.
    filter_vertex_face, vertex_face_kind, may_touch_vertex_face [paths]
);
leaf_entry!(
    /// From pairs of nodes of level 1 to the edge-edge candidates that may touch.
    filter_edge_edge, edge_edge_kind, may_touch_edge_edge [paths]
);

#[inline(always)]
fn any_kind(params: &Params<Blocks>) -> u32 {
    params.args.kind
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
    let ids = [a.vertices[0], b.vertices[0], b.vertices[1], b.vertices[2]];
    cascade::may_touch(Patch::Triangle, ids, paths, frame.path_error, frame.min_distance)
}

/// Pairs enter the arithmetic with the lesser edge first, so no result depends on the order of
/// leaves.
#[inline(always)]
fn may_touch_edge_edge(a: &Leaf, b: &Leaf, frame: &Frame, paths: &[Path]) -> bool {
    let (first, second) = if a.id < b.id { (*a, *b) } else { (*b, *a) };
    let ([p, q, _], [r, s, _]) = (first.vertices, second.vertices);
    let ids = [p, q, r, s];
    cascade::may_touch(Patch::Parallelogram, ids, paths, frame.path_error, frame.min_distance)
}
