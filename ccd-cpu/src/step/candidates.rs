//! What happens to a row of overlaps before any arithmetic on features: pairs that share a vertex
//! go, pairs of bodies that nobody wants, and pairs that overlap only because boxes were rounded.
//! What is left are candidates; whoever takes them does the rest.

use crate::broad_phase::keep;
use crate::broad_phase::pair_list::Lister;
use crate::broad_phase::pair_source::PairSink;
use crate::simd::{Bits, Block, Mask, RowSimd, WIDTH};
use crate::step::leaves::Leaves;
use crate::step::selection::Selection;
use crate::stop::Stop;
use ccd_core::broad_phase::candidate::{Ids, is_corner, share_vertex};
use ccd_core::broad_phase::swept_box;
use ccd_core::layout::Pair;
use ccd_core::model::contact::Kind;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::precision::{Points, Precision, Slices};
use ccd_core::model::quantization::margin;
use ccd_core::model::report::TriangleCounts;
use ccd_core::narrow_phase::search::Search;
use ccd_core::narrow_phase::separating_direction::axis_separated;
use ccd_core::{Aabb, Num, Real};
use std::marker::PhantomData;

/// Positions at both ends of a step, as given.
pub type Given<'a> = Slices<'a, Points, 2>;

/// What all workers of a step read.
pub struct Scene<'a> {
    pub mesh: &'a Mesh,
    pub selection: &'a Selection,
    pub given: Given<'a>,
    /// Per vertex `x y z _` at both ends in `f32`, each within `table_error` of the true one, in
    /// the origin and the unit of a [`ccd_core::model::quantization::Table`].
    pub table: &'a [[f32; WIDTH]],
    pub table_error: f32,
    /// The minimum distance in that unit, rounded up.
    pub table_distance: f32,
    pub min_distance: f64,
    /// What queries look for.
    pub search: Search<f64>,
    /// Where boxes were rounded: how far, see `slack_at`.
    pub slack: Option<f32>,
    /// Keep contacts, or only the least time of impact.
    pub keep_contacts: bool,
    /// What ends the step early.
    pub stop: &'a Stop,
}

/// What there is no memory for, if there is none.
const CANDIDATES: &str = "candidates";

impl Scene<'_> {
    /// The gap that two features must keep along an axis to be apart: 1.0001 covers the rounding of
    /// this line and of the gap.
    pub fn needed_gap(&self) -> f32 {
        (self.table_distance + 2.0 * self.table_error) * 1.0001
    }

    /// Whether the swept boxes of two features overlap in the precision of the input.
    #[inline(never)]
    pub fn boxes_overlap<const A: usize, const B: usize>(&self, a: [u32; A], b: [u32; B]) -> bool {
        match self.given {
            Precision::F32(x) => boxes_overlap(x, self.min_distance, &a, &b),
            Precision::F64(x) => boxes_overlap(x, self.min_distance, &a, &b),
        }
    }
}

fn boxes_overlap<T: Real>(x: [&[[T; 3]]; 2], min_distance: f64, a: &[u32], b: &[u32]) -> bool {
    let swept = |v: u32| swept_box::swept(x[0][v as usize], x[1][v as usize]);
    let of = |ids: &[u32]| {
        let all = ids.iter().skip(1).fold(swept(ids[0]), |all, &v| all.union(&swept(v)));
        all.inflated(margin(min_distance))
    };
    of(a).overlaps(&of(b))
}

/// Takes candidates.
pub trait Take: Send {
    /// Whether pairs that an axis separates throughout may be left out after they were counted: if
    /// so, contacts are sorted, else candidates are listed in the order in which they come.
    const FILTERED: bool;
    /// Counts candidates.
    fn count(&mut self, kind: Kind, n: u64);
    /// Counts pairs of triangles.
    fn count_triangles(&mut self, counts: TriangleCounts);
    /// Takes the pairs of `id` with the lanes `mask` of `ids`.
    fn take<S: RowSimd>(
        &mut self,
        simd: S,
        scene: &Scene,
        kind: Kind,
        id: u32,
        ids: &[u32; WIDTH],
        mask: u32,
    );
    /// Takes one pair, of edges the lesser id first.
    fn take_one(&mut self, scene: &Scene, kind: Kind, pair: Pair);
    /// A task begins.
    fn begin(&mut self, task: usize);
    /// No further candidate comes.
    fn finish(&mut self, scene: &Scene, kind: Kind);
}

impl Take for Lister {
    const FILTERED: bool = false;

    #[inline(always)]
    fn count(&mut self, _kind: Kind, _n: u64) {}

    #[inline(always)]
    fn count_triangles(&mut self, _counts: TriangleCounts) {}

    #[inline(always)]
    fn take<S: RowSimd>(
        &mut self,
        simd: S,
        scene: &Scene,
        kind: Kind,
        id: u32,
        ids: &[u32; WIDTH],
        mask: u32,
    ) {
        if !scene.stop.reserve(CANDIDATES, &mut self.pairs, WIDTH) {
            return;
        }
        match kind {
            Kind::VertexFace => simd.append::<false>(&mut self.pairs, id, ids, mask),
            _ => simd.append::<true>(&mut self.pairs, id, ids, mask),
        }
    }

    #[inline(always)]
    fn take_one(&mut self, scene: &Scene, _kind: Kind, pair: Pair) {
        if scene.stop.reserve(CANDIDATES, &mut self.pairs, 1) {
            self.pairs.push(pair);
        }
    }

    fn begin(&mut self, task: usize) {
        Lister::begin(self, task);
    }

    fn finish(&mut self, _scene: &Scene, _kind: Kind) {}
}

/// Edges against edges.
pub struct EdgePairs<'a, W> {
    pub scene: &'a Scene<'a>,
    pub edges: &'a Leaves<2>,
    pub worker: PhantomData<fn(W)>,
}

/// Vertices against faces.
pub struct FacePairs<'a, W> {
    pub scene: &'a Scene<'a>,
    pub vertices: &'a Leaves<1>,
    pub faces: &'a Leaves<3>,
    pub worker: PhantomData<fn(W)>,
}

impl<W: Take> PairSink for EdgePairs<'_, W> {
    type Worker = W;
    const ORDERED: bool = !W::FILTERED;

    #[inline(always)]
    fn row<S: RowSimd>(
        &self,
        worker: &mut W,
        simd: S,
        a: usize,
        lane: usize,
        b: usize,
        mut mask: u32,
    ) {
        // Two numbers and not an array: one that a call refers to would live in memory.
        let (a0, a1) = (self.edges.vertices[a][0][lane], self.edges.vertices[a][1][lane]);
        let ends_b = &self.edges.vertices[b];
        let b01 = [Row { simd, ids: &ends_b[0] }, Row { simd, ids: &ends_b[1] }];
        mask &= !share_vertex([a0, a1], b01).bits();
        if mask == 0 {
            return;
        }
        let of = &self.edges.bodies;
        mask = self.scene.selection.of_bodies(a0, &ends_b[0], mask, (of, a), (of, b));
        if let Some(slack) = self.scene.slack {
            let blocks = self.edges.boxes.blocks();
            let sure = simd.overlaps_surely(&blocks[a], lane, &blocks[b], slack);
            let unsure = mask & !sure;
            if unsure != 0 {
                mask = mask & sure
                    | keep(unsure, |j| {
                        self.scene.boxes_overlap([a0, a1], [ends_b[0][j], ends_b[1][j]])
                    });
            }
        }
        if self.scene.selection.is_of_features() && mask != 0 {
            let (id, ids) = (self.edges.boxes.order()[a * WIDTH + lane], self.edges.boxes.ids(b));
            mask = self.scene.selection.of_features(Kind::EdgeEdge, id, &ids, mask);
        }
        worker.count(Kind::EdgeEdge, mask.count_ones() as u64);
        if W::FILTERED {
            mask &= !separated(
                simd,
                &self.edges.ends[a],
                lane,
                &self.edges.ends[b],
                self.scene.needed_gap(),
            );
        }
        if mask != 0 {
            let (id, ids) = (self.edges.boxes.order()[a * WIDTH + lane], self.edges.boxes.ids(b));
            worker.take(simd, self.scene, Kind::EdgeEdge, id, &ids, mask);
        }
    }

    fn begin(&self, worker: &mut W, task: usize) {
        worker.begin(task);
    }

    fn end(&self, worker: &mut W) {
        worker.finish(self.scene, Kind::EdgeEdge);
    }
}

impl<W: Take> PairSink for FacePairs<'_, W> {
    type Worker = W;
    const ORDERED: bool = !W::FILTERED;

    #[inline(always)]
    fn row<S: RowSimd>(
        &self,
        worker: &mut W,
        simd: S,
        a: usize,
        lane: usize,
        b: usize,
        mut mask: u32,
    ) {
        let vertex = self.vertices.vertices[a][0][lane];
        let corners = &self.faces.vertices[b];
        let [f0, f1, f2] = corners;
        let face = [Row { simd, ids: f0 }, Row { simd, ids: f1 }, Row { simd, ids: f2 }];
        mask &= !is_corner(vertex, face).bits();
        if mask == 0 {
            return;
        }
        let (of_a, of_b) = ((&self.vertices.bodies, a), (&self.faces.bodies, b));
        mask = self.scene.selection.of_bodies(vertex, &corners[0], mask, of_a, of_b);
        if let Some(slack) = self.scene.slack {
            let sure = simd.overlaps_surely(
                &self.vertices.boxes.blocks()[a],
                lane,
                &self.faces.boxes.blocks()[b],
                slack,
            );
            let unsure = mask & !sure;
            if unsure != 0 {
                let of = |j: usize| [corners[0][j], corners[1][j], corners[2][j]];
                mask = mask & sure | keep(unsure, |j| self.scene.boxes_overlap([vertex], of(j)));
            }
        }
        if self.scene.selection.is_of_features() && mask != 0 {
            let ids = self.faces.boxes.ids(b);
            mask = self.scene.selection.of_features(Kind::VertexFace, vertex, &ids, mask);
        }
        worker.count(Kind::VertexFace, mask.count_ones() as u64);
        if W::FILTERED {
            mask &= !separated(
                simd,
                &self.vertices.ends[a],
                lane,
                &self.faces.ends[b],
                self.scene.needed_gap(),
            );
        }
        if mask != 0 {
            worker.take(simd, self.scene, Kind::VertexFace, vertex, &self.faces.boxes.ids(b), mask);
        }
    }

    fn begin(&self, worker: &mut W, task: usize) {
        worker.begin(task);
    }

    fn end(&self, worker: &mut W) {
        worker.finish(self.scene, Kind::VertexFace);
    }
}

/// Ids of a row, compared by an instruction set.
#[derive(Clone, Copy)]
pub struct Row<'a, S> {
    pub simd: S,
    pub ids: &'a [u32; WIDTH],
}

impl<S: RowSimd> Ids for Row<'_, S> {
    type Mask = Bits;
    #[inline(always)]
    fn is_one_of(self, a: u32, b: u32) -> Bits {
        Bits(self.simd.equals(self.ids, [a, b]))
    }
}

/// Lanes of `b` that an axis keeps further than `needed` from lane `i` of `a` during the whole
/// step.
#[inline(always)]
pub fn separated<S: RowSimd>(
    simd: S,
    a: &[Block; 2],
    i: usize,
    b: &[Block; 2],
    needed: f32,
) -> u32 {
    let (a0, a1) = (bounds(simd.one(&a[0], i)), bounds(simd.one(&a[1], i)));
    let (b0, b1) = (bounds(simd.boxes(&b[0])), bounds(simd.boxes(&b[1])));
    axis_separated(&a0, &a1, &b0, &b1, S::Lanes::splat(needed)).bits()
}

/// `[min, max]`.
#[inline(always)]
fn bounds<N>(of: Aabb<N>) -> [[N; 3]; 2] {
    [of.min, of.max]
}
