//! From pairs of blocks to candidates: pairs of boxes as in `block_pairs`, then one hit a thread.
//!
//! Two kernels have this body. `list_wanted` also looks at bodies and at exact boxes; a step that
//! needs neither runs `list_candidates`, which is faster without them.
//!
//! Where a step has boxes at both ends, what an axis keeps apart there is counted and not listed: a
//! third to three quarters of the candidates of real scenes. Neither their leaves nor their paths
//! are read.
//!
//! Twin: on a CPU `block_pairs.rs`, whose sink looks at candidates.

use super::block_pairs::{Hits, KEPT, Places, Teams, WANTED, entries};
use crate::entry::kernel;
use crate::records::{BoxWords, box_at, ends_at, leaf_at};
use crate::workgroup::{add_shared, barrier, count, get, set, write_pair};
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::block_bvh::{POOL, TEAMS, THREADS};
use ccd_core::backend::broad_phase::candidate::{are_neighbours, overlap_surely, wanted};
use ccd_core::backend::layout::{EDGE_EDGE, Frame, Pair};
use ccd_core::narrow_phase::cascade;
use spirv_std::glam::{UVec4, Vec4};

impl<const N: usize> Teams<'_, N> {
    /// Boxes of the teams' pairs of blocks that overlap.
    #[inline(always)]
    fn hits_of_leaves(&mut self, kind: u32, (pair, some): (Pair, bool)) -> Hits {
        self.clear();
        let same = kind == EDGE_EDGE && pair.a == pair.b;
        let row = self.gather(pair, some, same);
        self.test(row, same, true, 0)
    }

    /// Where the two leaves of a hit of the pool are.
    #[inline(always)]
    fn places(&self, h: u32) -> [usize; 2] {
        let [p, q] = self.hit(h);
        [p as usize, q as usize]
    }

    /// Whether two leaves of a hit, which was counted, are a candidate; if not, it is no longer
    /// counted.
    #[inline(always)]
    fn is_candidate<const RULES: bool>(
        &mut self,
        [p, q]: [usize; 2],
        leaves: &[UVec4],
        (frame, kind): (&Frame, u32),
        (bodies, keys): (&[u32], &[u32]),
    ) -> bool {
        let (a, b) = (leaf_at(leaves, p), leaf_at(leaves, q));
        let is_wanted = if RULES {
            let mut both = [Aabb::EMPTY; 2];
            if frame.has(Frame::FLAG_CONFIRM) {
                both = [box_at(self.nodes, p), box_at(self.nodes, q)];
            }
            wanted(frame, kind, &a, &b, [&both[0], &both[1]], bodies, keys)
        } else {
            !are_neighbours(kind, &a, &b)
        };
        if !is_wanted {
            add_shared(self.counters, WANTED, u32::MAX);
        }
        is_wanted
    }

    /// Whether two leaves that are apart at both ends are a candidate for certain, without a look
    /// at them: two that are apart share no vertex.
    #[inline(always)]
    fn counts_apart<const RULES: bool>(&self, [p, q]: [usize; 2], frame: &Frame) -> bool {
        !RULES
            || !frame.has(Frame::FLAG_BODIES)
                && (!frame.has(Frame::FLAG_CONFIRM)
                    || overlap_surely(&box_at(self.nodes, p), &box_at(self.nodes, q), frame.slack))
    }

    /// Appends the hits of the pool that were kept to `list`, as pairs of ids. `kept`: which of its
    /// shares this thread keeps, as bits.
    #[inline(always)]
    fn write_kept(&mut self, (kind, n): (u32, u32), kept: u32, leaves: &[UVec4], list: &mut [u32]) {
        let capacity = self.params.dispatch.capacity_out;
        // All threads at once, of which a compiler makes one addition of many.
        let mut to = add_shared(self.counters, KEPT, kept.count_ones());
        to += self.reserve(list);
        for share in 0..n.div_ceil(THREADS) {
            if kept >> share & 1 == 1 {
                let [p, q] = self.places(self.t.lane + share * THREADS);
                let (a, b) = (leaf_at(leaves, p), leaf_at(leaves, q));
                write_pair(list, capacity, to, ids(kind == EDGE_EDGE, a.id, b.id));
                to += 1;
            }
        }
        barrier();
    }

    /// Adds the workgroup's candidates to the second word of `list`: they themselves need not be
    /// written.
    #[inline(always)]
    fn count_candidates(&self, list: &mut [u32]) {
        if self.t.lane == 0 {
            let n = get(self.counters, WANTED);
            if n > 0 {
                count(list, 1, n);
            }
        }
    }
}

impl Teams<'_, 1> {
    /// From pairs of nodes of level 1 to candidates. `RULES`: bodies and exact boxes are looked at.
    #[inline(always)]
    fn list<const RULES: bool>(
        mut self,
        leaves: &[UVec4],
        ends: &[Vec4],
        rules: (&[u32], &[u32]),
        input: &[u32],
        output: &mut [u32],
    ) {
        // A copy: what is read of the record in a loop would be read again and again.
        let (frame, kind) = (&{ self.params.frame }, self.params.args.kind);
        let has_ends = frame.has(Frame::FLAG_ENDS);
        let gap = cascade::needed_gap(frame.path_error, frame.min_distance);
        if self.t.lane == 0 {
            set(self.counters, WANTED, 0);
        }
        let mut four = self.t.group;
        while four < self.n.div_ceil(TEAMS) {
            let pair = self.pair(input, four);
            let mut found = self.hits_of_leaves(kind, pair);
            four += self.t.groups;
            let passes = self.number(&mut found);
            if self.t.lane == 0 {
                let n = get(self.counters, WANTED) + get(self.n_hits, 0);
                set(self.counters, WANTED, n);
            }
            for pass in 0..passes {
                let n = self.fill(&found, pass);
                let mut kept = 0;
                for share in 0..POOL / THREADS {
                    let h = self.t.lane + share * THREADS;
                    if h >= n {
                        break;
                    }
                    let places = self.places(h);
                    let is_near = !has_ends || is_near(places, gap, ends);
                    if (is_near || !self.counts_apart::<RULES>(places, frame))
                        && self.is_candidate::<RULES>(places, leaves, (frame, kind), rules)
                        && is_near
                    {
                        kept |= 1 << share;
                    }
                }
                self.write_kept((kind, n), kept, leaves, output);
            }
        }
        self.count_candidates(output);
    }
}

kernel! {
    /// From pairs of nodes of level 1 to candidates, as pairs of ids; with `FLAG_ENDS` those that
    /// are near at an end. For exact boxes, without bodies.
    list_candidates[128](t; params: Blocks; rows: [u32; 4], columns: [Aabb; 128],
        names: [u32; 128], ranges: [u32; 1], counters: [u32; 8], n_hits: [u32; 1],
        hits: [u32; 384]; nodes: [BoxWords], leaves: [UVec4], ends: [Vec4], input: [u32],
        mut output: [u32]) {
        let (n, at) = (entries(params, input), Places::of(&params.args, 1));
        Teams { t, params, n, nodes, at, rows, columns, names, ranges, counters, n_hits, hits }
            .list::<false>(leaves, ends, (input, input), input, output);
    }
}

kernel! {
    /// The same where bodies select pairs or boxes were rounded.
    list_wanted[128](t; params: Blocks; rows: [u32; 4], columns: [Aabb; 128],
        names: [u32; 128], ranges: [u32; 1], counters: [u32; 8], n_hits: [u32; 1],
        hits: [u32; 384]; nodes: [BoxWords], leaves: [UVec4], ends: [Vec4], bodies: [u32],
        keys: [u32], input: [u32], mut output: [u32]) {
        let (n, at) = (entries(params, input), Places::of(&params.args, 1));
        Teams { t, params, n, nodes, at, rows, columns, names, ranges, counters, n_hits, hits }
            .list::<true>(leaves, ends, (bodies, keys), input, output);
    }
}

/// Ids of a pair; within one set the lesser first.
#[inline(always)]
pub(super) fn ids(one_set: bool, a: u32, b: u32) -> Pair {
    if one_set { Pair::ordered(a, b) } else { Pair { a, b } }
}

/// Whether the boxes of two leaves at both ends leave them.
#[inline(always)]
fn is_near([p, q]: [usize; 2], gap: f32, ends: &[Vec4]) -> bool {
    let (a, b) = (ends_at(ends, p), ends_at(ends, q));
    cascade::near_at_ends(a, b, gap)
}
