//! Pairs of triangles on their way to pairs of features: each row is expanded into the tests that
//! its triangles represent, eight at a time; what stands in for them and orphans come one by one.
//!
//! A test becomes a candidate by the rule that holds for pairs of features: no common vertex,
//! bodies that are wanted, boxes of its own that overlap in the precision of the input. Candidates
//! and contacts are those of the other pipeline.

use crate::broad_phase::pair_source::{Overlaps, PairSink};
use crate::simd::{RowSimd, WIDTH};
use crate::step::candidates::{Scene, Take, shared};
use crate::step::leaves::{Side, feature_box};
use crate::step::triangle_leaves::{TriangleLeaves, TriangleSide};
use crate::threads::Threads;
use ccd_core::Aabb;
use ccd_core::backend::broad_phase::candidate::{is_corner, share_vertex};
use ccd_core::backend::layout::Pair;
use ccd_core::backend::triangle_pairs::Test;
use ccd_core::backend::triangle_pairs::free_regions::NONE;
use ccd_core::model::contact::Kind;
use ccd_core::model::report::TriangleCounts;
use std::marker::PhantomData;

/// Triangles against triangles.
pub struct TrianglePairs<'a, W> {
    pub scene: &'a Scene<'a>,
    pub leaves: &'a TriangleLeaves,
    /// Of vertices.
    pub boxes: &'a [Aabb<f32>],
    /// The one kind that is wanted, or both.
    pub only: Option<Kind>,
    pub worker: PhantomData<fn(W)>,
}

/// Orphans after which a worker looks whether to go on.
const PART: usize = 1024;

impl<W: Take> PairSink for TrianglePairs<'_, W> {
    type Worker = W;
    const ORDERED: bool = !W::FILTERED;

    #[inline(always)]
    fn row<S: RowSimd>(&self, worker: &mut W, simd: S, row: Overlaps) {
        let Overlaps { a, lane, b, mut mask } = row;
        let leaves = self.leaves;
        let (of_a, of_b) = (&leaves.blocks[a], &leaves.blocks[b]);
        let corners = of_a.corners.map(|ids| ids[lane]);
        let (bodies_a, bodies_b) = ((&leaves.bodies, a), (&leaves.bodies, b));
        mask =
            self.scene.selection.of_bodies(corners[0], &of_b.corners[0], mask, bodies_a, bodies_b);
        let n_pairs = mask.count_ones();
        let mut near = mask & shared(simd, corners, of_b.corners.each_ref());
        if self.leaves.orphans.is_some() {
            mask &= !near;
        }
        let n_apart = mask.count_ones();
        if leaves.regions.is_some() {
            let region = leaves.region_of_leaf[a][lane];
            if region != NONE {
                mask &= !simd.equals(&leaves.region_of_leaf[b], [region; 2]);
            }
        }
        let mut counts = TriangleCounts::default();
        counts.pairs = n_pairs as u64;
        counts.adjacent = (n_pairs - n_apart) as u64;
        counts.free = (n_apart - mask.count_ones()) as u64;
        if mask == 0 {
            worker.count_triangles(counts);
            return;
        }
        near &= mask;
        // Of triangles with a common vertex boxes are never apart.
        let apart = if W::FILTERED { leaves.apart((a, lane), b, mask & !near) } else { 0 };
        counts.separated = apart.count_ones() as u64;
        let mut represented = 0;
        let tests = |k: usize| of_a.tests[k] >> lane & 1 == 1;
        // Lanes whose test of two features is the one that counts.
        let first = |k: usize| if of_a.represents[k] >> lane & 1 == 1 { !0 } else { 0 };
        if self.wants(Kind::VertexFace) {
            let faces = mask & of_b.faces;
            let is_face = of_a.faces >> lane & 1 == 1;
            for k in 0..3 {
                if tests(k) && faces != 0 {
                    represented += faces.count_ones();
                    let (vertex, face) = (leaves.corner(a, k), leaves.face(b));
                    self.expand(worker, simd, (vertex, lane), face, [faces, near, first(k), apart]);
                }
                let vertices = mask & of_b.tests[k];
                if is_face && vertices != 0 {
                    represented += vertices.count_ones();
                    let (face, vertex) = (leaves.face(a), leaves.corner(b, k));
                    let masks = [vertices, near, of_b.represents[k], apart];
                    self.expand(worker, simd, (face, lane), vertex, masks);
                }
            }
        }
        if self.wants(Kind::EdgeEdge) {
            for i in 0..3 {
                if !tests(3 + i) {
                    continue;
                }
                let edge = leaves.side(a, i);
                for j in 0..3 {
                    let edges = mask & of_b.tests[3 + j];
                    if edges != 0 {
                        represented += edges.count_ones();
                        let first = first(3 + i) & of_b.represents[3 + j];
                        let masks = [edges, near, first, apart];
                        self.expand(worker, simd, (edge, lane), leaves.side(b, j), masks);
                    }
                }
            }
        }
        if self.leaves.orphans.is_some() {
            let stand_ins = &self.leaves.stand_ins;
            for group in stand_ins.groups(a * WIDTH + lane) {
                let mut rest = stand_ins.of_block(simd, group, b);
                while rest != 0 {
                    let other = stand_ins.get(group, rest.trailing_zeros() as usize);
                    rest &= rest - 1;
                    if mask >> other.lane & 1 == 1 {
                        let pair = [of_a.ids[lane], other.id];
                        let apart = apart >> other.lane & 1 == 1;
                        represented += self.stand_in(worker, pair, other.tests, apart);
                    }
                }
            }
        }
        counts.represented = represented as u64;
        worker.count_triangles(counts);
    }

    fn begin(&self, worker: &mut W, task: usize) {
        worker.begin(task);
    }

    fn end(&self, worker: &mut W) {
        worker.finish(self.scene, Kind::VertexFace);
        worker.finish(self.scene, Kind::EdgeEdge);
    }
}

impl<W: Take> TrianglePairs<'_, W> {
    #[inline(always)]
    fn wants(&self, kind: Kind) -> bool {
        self.only.is_none_or(|only| only == kind)
    }

    /// Hands on the lanes of a mask in which two features are candidates; with it: those in which
    /// they may have a common vertex; those that count, of which no other pair of triangles counts
    /// the same; and those of triangles that are apart.
    #[inline(always)]
    fn expand<S: RowSimd, const N: usize, const M: usize>(
        &self,
        worker: &mut W,
        simd: S,
        (a, lane): (TriangleSide<N>, usize),
        b: TriangleSide<M>,
        [mut mask, near, first, apart]: [u32; 4],
    ) {
        mask &= simd.overlaps(a.boxes(), lane, b.boxes());
        if mask & near != 0 {
            mask &= !shared(simd, a.vertices_of(lane), b.vertices());
        }
        mask = self.scene.confirmed(simd, (a, lane), b, mask);
        if !W::FILTERED {
            // A list has each pair once.
            mask &= first;
        }
        if mask != 0 {
            self.scene.hand_on(worker, simd, (a, lane), b, [mask, first, apart]);
        }
    }

    /// Makes tests besides those that two triangles represent; returns how many. `apart`: of none
    /// of them more than its candidate is counted.
    #[inline(never)]
    fn stand_in(&self, worker: &mut W, [first, second]: [u32; 2], tests: u16, apart: bool) -> u32 {
        let mut n = 0;
        for test in Test::all(tests) {
            let (kind, pair) = test.features(&self.leaves.triangles, first, second);
            if self.wants(kind) {
                n += 1;
                self.test(worker, kind, pair, apart);
            }
        }
        n
    }

    /// Makes the tests of all orphans, in the order in which they are listed.
    pub fn orphans(&self, threads: &Threads, workers: &mut [W]) {
        let Some(sets) = &self.leaves.orphans else { return };
        let (n_vf, n_workers) = (sets.vf().len(), workers.len());
        let n = n_vf + sets.ee().len();
        threads.each(workers, &|k, worker| {
            // After all tasks of the source, in the order of the list for any number of workers.
            worker.begin(usize::MAX - n_workers + k);
            let mut orphans = 0;
            for i in n * k / n_workers..n * (k + 1) / n_workers {
                if i % PART == 0 && threads.stop.is_stopped() {
                    break;
                }
                let (kind, pair) = if i < n_vf {
                    (Kind::VertexFace, sets.vf()[i])
                } else {
                    (Kind::EdgeEdge, sets.ee()[i - n_vf])
                };
                let skipped = self.in_free_region(kind, pair);
                if self.wants(kind) && !skipped && self.of_wanted_bodies(kind, pair) {
                    orphans += 1;
                    self.test(worker, kind, pair, false);
                }
            }
            let mut counts = TriangleCounts::default();
            counts.orphans = orphans;
            worker.count_triangles(counts);
            self.end(worker);
        });
    }

    fn in_free_region(&self, kind: Kind, pair: Pair) -> bool {
        let Some(regions) = &self.leaves.regions else { return false };
        let triangles = &self.leaves.triangles;
        let (a, b) = match kind {
            Kind::VertexFace => (triangles.of_vertex(pair.a)[0], pair.b),
            _ => (triangles.of_edge(pair.a)[0], triangles.of_edge(pair.b)[0]),
        };
        regions.hold_both(a, b)
    }

    fn of_wanted_bodies(&self, kind: Kind, pair: Pair) -> bool {
        let v = self.scene.mesh.vertices_of(kind, pair);
        let second = if kind == Kind::VertexFace { 1 } else { 2 };
        self.scene.selection.rules.as_ref().is_none_or(|rules| rules.wants(v[0], v[second]))
    }

    /// One test of two features of wanted bodies without a common vertex.
    fn test(&self, worker: &mut W, kind: Kind, pair: Pair, apart: bool) {
        let [v0, v1, v2, v3] = self.scene.mesh.vertices_of(kind, pair);
        match kind {
            Kind::VertexFace => {
                debug_assert!(!is_corner(v0, [v1, v2, v3]));
                self.test_of(worker, (kind, pair, apart), [v0], [v1, v2, v3]);
            }
            _ => {
                debug_assert!(!share_vertex([v0, v1], [v2, v3]));
                self.test_of(worker, (kind, pair, apart), [v0, v1], [v2, v3]);
            }
        }
    }

    fn test_of<const N: usize, const M: usize>(
        &self,
        worker: &mut W,
        (kind, pair, apart): (Kind, Pair, bool),
        a: [u32; N],
        b: [u32; M],
    ) {
        if !feature_box(a, self.boxes).overlaps(&feature_box(b, self.boxes))
            || self.scene.slack.is_some() && !self.scene.boxes_overlap(a, b)
            || !self.scene.selection.wants(kind, pair)
        {
            return;
        }
        worker.count(kind, 1);
        if !(W::FILTERED && (apart || self.scene.axis_separated(a, b))) {
            worker.take_one(self.scene, kind, pair);
        }
    }
}
