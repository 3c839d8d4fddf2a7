//! What happens to a row of overlaps before any arithmetic on features: pairs that share a vertex
//! go, pairs of bodies that nobody wants, and pairs that overlap only because boxes were rounded.
//! What is left are candidates; whoever takes them does the rest.

pub use ccd_core::model::precision::Given;

use crate::broad_phase::keep;
use crate::broad_phase::pair_list::Lister;
use crate::broad_phase::pair_source::{Overlaps, PairSink, confirmed_overlaps};
use crate::simd::{Block, ROOM, RowSimd, WIDTH};
use crate::step::leaves::{Leaves, Side};
use crate::step::selection::Selection;
use crate::stop::Stop;
use ccd_core::backend::broad_phase::swept_box;
use ccd_core::backend::layout::Pair;
use ccd_core::backend::quantization::margin;
use ccd_core::model::contact::Kind;
use ccd_core::model::decision::Decider;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::precision::Precision;
use ccd_core::model::report::TriangleCounts;
use ccd_core::narrow_phase::separating_direction::axis_separated;
use ccd_core::{Num, Real};
use std::marker::PhantomData;

/// What all workers of a step read.
pub struct Scene<'a> {
    pub mesh: &'a Mesh,
    pub selection: &'a Selection,
    pub given: Given<'a>,
    /// Per vertex `x y z _` at both ends in `f32`, each within `table_error` of the true one, in
    /// the origin and the unit of a [`ccd_core::backend::quantization::Table`].
    pub table: &'a [[f32; WIDTH]],
    pub table_error: f32,
    /// The minimum distance in that unit, rounded up.
    pub table_distance: f32,
    /// The gap in that unit that two features must keep along an axis to be apart.
    pub needed_gap: f32,
    /// Whether a search looks at boxes at both ends, in which an axis may keep features apart: else
    /// pairs that filters leave are asked, each by itself.
    pub asks_ends: bool,
    pub min_distance: f64,
    /// What decides pairs that filters leave.
    pub decider: Decider,
    /// Where boxes were rounded: how far, see `slack_at`.
    pub slack: Option<f32>,
    /// The last time of the table's at which a contact matters.
    pub latest: f32,
    /// Keep contacts, or only the first one.
    pub keep_contacts: bool,
    /// What ends the step early.
    pub stop: &'a Stop,
}

/// The name of lists in [`ccd_core::Error::Memory`].
const CANDIDATES: &str = "candidates";

impl Scene<'_> {
    /// Whether the swept boxes of two features overlap in the precision of the input.
    #[inline(never)]
    pub fn boxes_overlap<const A: usize, const B: usize>(&self, a: [u32; A], b: [u32; B]) -> bool {
        match self.given {
            Precision::F32(x) => boxes_overlap(x, self.min_distance, &a, &b),
            Precision::F64(x) => boxes_overlap(x, self.min_distance, &a, &b),
        }
    }
}

impl Scene<'_> {
    /// Whether an axis keeps two features apart at both ends, and so throughout.
    pub fn axis_separated<const A: usize, const B: usize>(&self, a: [u32; A], b: [u32; B]) -> bool {
        let (a0, b0) = (bounds(self.table, a, 0), bounds(self.table, b, 0));
        let (a1, b1) = (bounds(self.table, a, 4), bounds(self.table, b, 4));
        axis_separated(&a0, &a1, &b0, &b1, self.needed_gap)
    }
}

/// `[min, max]` of positions in the table, from its component `k` on.
fn bounds<const N: usize>(table: &[[f32; WIDTH]], ids: [u32; N], k: usize) -> [[f32; 3]; 2] {
    let at = |v: u32| [0, 1, 2].map(|axis| table[v as usize][k + axis]);
    let first = at(ids[0]);
    ids.iter().skip(1).fold([first; 2], |[min, max], &v| {
        let p = at(v);
        let lesser = [0, 1, 2].map(|axis| Num::min(min[axis], p[axis]));
        [lesser, [0, 1, 2].map(|axis| Num::max(max[axis], p[axis]))]
    })
}

/// The rule of candidates for a row, after boxes, common vertices and bodies.
impl Scene<'_> {
    /// The lanes of `mask` whose boxes in `b` overlap that of lane `lane` of `a` in the precision
    /// of the input.
    #[inline(always)]
    pub fn confirmed<'a, S: RowSimd, const N: usize, const M: usize>(
        &self,
        simd: S,
        (a, lane): (impl Side<'a, N>, usize),
        b: impl Side<'a, M>,
        mask: u32,
    ) -> u32 {
        let Some(slack) = self.slack else { return mask };
        let sure = simd.overlaps_surely(a.boxes(), lane, b.boxes(), slack);
        let unsure = mask & !sure;
        if unsure == 0 {
            return mask;
        }
        let of_a = a.vertices_of(lane);
        mask & sure | keep(unsure, |j| self.boxes_overlap(of_a, b.vertices_of(j)))
    }

    /// Counts the lanes of `mask` whose features are wanted and that are `first` to name them, and
    /// hands those on that are not known to be `apart`, and that no axis keeps apart. Of a face in
    /// `a` and vertices in `b` pairs have the vertex first, as all do.
    #[inline(always)]
    pub fn hand_on<'a, W: Take, S: RowSimd, const N: usize, const M: usize>(
        &self,
        worker: &mut W,
        simd: S,
        (a, lane): (impl Side<'a, N>, usize),
        b: impl Side<'a, M>,
        [mut mask, first, apart]: [u32; 3],
    ) {
        let (kind, face_first) = (kind_of(N), N == 3);
        if self.selection.is_of_features() && mask != 0 {
            mask = self.selection.of_features(kind, (a.ids()[lane], face_first), b.ids(), mask);
        }
        worker.count(kind, (mask & first).count_ones() as u64);
        if W::FILTERED && self.asks_ends && mask != 0 {
            mask &= !apart & !simd.axis_separated(a.ends(), lane, b.ends(), self.needed_gap);
        }
        if mask == 0 {
            return;
        }
        let id = a.ids()[lane];
        if !face_first {
            return worker.take(simd, self, kind, (id, b.ids()), mask);
        }
        while mask != 0 {
            let j = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            worker.take_one(self, kind, Pair { a: b.ids()[j], b: id });
        }
    }
}

/// Whether the swept boxes of two features overlap, grown for a minimum distance.
pub fn boxes_overlap<T: Real>(x: [&[[T; 3]]; 2], min_distance: f64, a: &[u32], b: &[u32]) -> bool {
    let swept = |v: u32| swept_box::swept(x[0][v as usize], x[1][v as usize]);
    let feature_box = |ids: &[u32]| {
        let all = ids.iter().skip(1).fold(swept(ids[0]), |all, &v| all.union(&swept(v)));
        all.inflated(margin(min_distance))
    };
    feature_box(a).overlaps(&feature_box(b))
}

/// Takes candidates.
pub trait Take: Send {
    /// Whether pairs that an axis separates throughout may be left out after they were counted: if
    /// so, contacts are sorted, else candidates are listed in the order in which they come.
    const FILTERED: bool;
    /// Counts candidates.
    #[inline(always)]
    fn count(&mut self, _kind: Kind, _n: u64) {}
    /// Counts pairs of triangles.
    #[inline(always)]
    fn count_triangles(&mut self, _counts: TriangleCounts) {}
    /// The list that pairs of a kind go to, with room for `n` of them, at most [`ROOM`]; none if a
    /// limit of memory ends the call.
    fn list(&mut self, scene: &Scene, kind: Kind, n: usize) -> Option<&mut Vec<Pair>>;
    /// Pairs were added to it.
    #[inline(always)]
    fn listed(&mut self, _scene: &Scene, _kind: Kind) {}
    /// Takes the pairs of `id` with the lanes `mask` of `ids`.
    #[inline(always)]
    fn take<S: RowSimd>(
        &mut self,
        simd: S,
        scene: &Scene,
        kind: Kind,
        (id, ids): (u32, &[u32; WIDTH]),
        mask: u32,
    ) {
        let Some(list) = self.list(scene, kind, WIDTH) else { return };
        match kind {
            Kind::VertexFace => simd.append::<false>(list, id, ids, mask),
            _ => simd.append::<true>(list, id, ids, mask),
        }
        self.listed(scene, kind);
    }
    /// Takes the pairs of two lists in the lanes of a mask.
    #[inline(always)]
    fn take_each<S: RowSimd>(
        &mut self,
        simd: S,
        scene: &Scene,
        kind: Kind,
        [a, b]: [&[u32; WIDTH]; 2],
        mask: u32,
    ) {
        let Some(list) = self.list(scene, kind, WIDTH) else { return };
        match kind {
            Kind::VertexFace => simd.append_each::<false>(list, a, b, mask),
            _ => simd.append_each::<true>(list, a, b, mask),
        }
        self.listed(scene, kind);
    }
    /// Takes one pair, of edges the lesser id first.
    #[inline(always)]
    fn take_one(&mut self, scene: &Scene, kind: Kind, pair: Pair) {
        let Some(list) = self.list(scene, kind, 1) else { return };
        list.push(pair);
        self.listed(scene, kind);
    }
    /// A task begins.
    #[inline(always)]
    fn begin(&mut self, _task: usize) {}
    /// No further candidate comes.
    fn finish(&mut self, _scene: &Scene, _kind: Kind) {}
}

impl Take for Lister {
    const FILTERED: bool = false;

    #[inline(always)]
    fn list(&mut self, scene: &Scene, _kind: Kind, n: usize) -> Option<&mut Vec<Pair>> {
        self.room(scene.stop, CANDIDATES, n)
    }

    fn begin(&mut self, task: usize) {
        Lister::begin(self, task);
    }
}

/// Features of `N` vertices against features of `M`: vertices against faces, or edges against
/// edges.
pub struct FeaturePairs<'a, W, const N: usize, const M: usize> {
    pub scene: &'a Scene<'a>,
    pub a: &'a Leaves<N>,
    pub b: &'a Leaves<M>,
    pub worker: PhantomData<fn(W)>,
}

/// The kind of pairs of a feature of `n` vertices and another.
const fn kind_of(n: usize) -> Kind {
    if n == 2 { Kind::EdgeEdge } else { Kind::VertexFace }
}

impl<W: Take, const N: usize, const M: usize> PairSink for FeaturePairs<'_, W, N, M> {
    type Worker = W;
    const ORDERED: bool = !W::FILTERED;

    #[inline(always)]
    fn row<S: RowSimd>(&self, worker: &mut W, simd: S, row: Overlaps) {
        let Overlaps { a, lane, b, mut mask } = row;
        let (of_a, of_b) = ((self.a, a), (self.b, b));
        let vertices = of_a.vertices_of(lane);
        mask &= !shared(simd, vertices, of_b.vertices());
        if mask == 0 {
            return;
        }
        let (bodies_a, bodies_b) = ((&self.a.bodies, a), (&self.b.bodies, b));
        mask = self.scene.selection.of_bodies(
            vertices[0],
            of_b.vertices()[0],
            mask,
            bodies_a,
            bodies_b,
        );
        mask = self.scene.confirmed(simd, (of_a, lane), of_b, mask);
        self.scene.hand_on(worker, simd, (of_a, lane), of_b, [mask, !0, 0]);
    }

    #[inline(always)]
    fn blocks<S: RowSimd>(
        &self,
        worker: &mut W,
        simd: S,
        (a, b): (usize, usize),
        boxes: [&Block; 2],
        mut masks: u64,
    ) {
        const { assert!(N != 3, "a face would come before its vertex") };
        let scene = self.scene;
        let asks_ends = W::FILTERED && scene.asks_ends;
        if scene.selection.selects() || asks_ends && !S::PICKS {
            return self.row_by_row(worker, simd, (a, b), masks);
        }
        let (of_a, of_b) = ((self.a, a), (self.b, b));
        if let Some(slack) = scene.slack {
            masks = confirmed_overlaps(simd, boxes, masks, slack, |i, j| {
                let (a, b) = (of_a.vertices_of(i), of_b.vertices_of(j));
                // Features that share a vertex, often unsure, are dropped below in any case.
                a.iter().any(|v| b.contains(v)) || scene.boxes_overlap(a, b)
            });
        }
        if masks == 0 {
            return;
        }
        if asks_ends {
            self.eights(worker, simd, (a, b), masks);
        } else if let Some(list) = worker.list(scene, kind_of(N), ROOM) {
            let (ids, of) = ([of_a.ids(), of_b.ids()], (of_a.vertices(), of_b.vertices()));
            let n = match N {
                2 => simd.append_rows::<true, N, M>(list, ids, of.0, of.1, masks),
                _ => simd.append_rows::<false, N, M>(list, ids, of.0, of.1, masks),
            };
            worker.count(kind_of(N), n as u64);
            worker.listed(scene, kind_of(N));
        }
    }

    fn begin(&self, worker: &mut W, task: usize) {
        worker.begin(task);
    }

    fn end(&self, worker: &mut W) {
        worker.finish(self.scene, kind_of(N));
    }
}

impl<W: Take, const N: usize, const M: usize> FeaturePairs<'_, W, N, M> {
    /// Takes pairs of lanes of two blocks that overlap, eight at a time: without a common vertex,
    /// and, once they were counted, such as no axis keeps apart.
    #[inline(always)]
    fn eights<S: RowSimd>(&self, worker: &mut W, simd: S, (a, b): (usize, usize), mut masks: u64) {
        let (scene, kind) = (self.scene, kind_of(N));
        let (of_a, of_b) = ((self.a, a), (self.b, b));
        while masks != 0 {
            let ([at_a, at_b], mut mask) = simd.eight(&mut masks);
            mask &= !shared_each(simd, (of_a.vertices(), &at_a), (of_b.vertices(), &at_b));
            worker.count(kind, mask.count_ones() as u64);
            if mask != 0 {
                let (a, b) = (of_a.ends(), of_b.ends());
                let ends_a = [simd.picked(&a[0], &at_a), simd.picked(&a[1], &at_a)];
                let ends_b = [simd.picked(&b[0], &at_b), simd.picked(&b[1], &at_b)];
                mask &= !simd.separated_each(ends_a, ends_b, scene.needed_gap);
            }
            if mask != 0 {
                let ids = [simd.pick_ids(of_a.ids(), &at_a), simd.pick_ids(of_b.ids(), &at_b)];
                worker.take_each(simd, scene, kind, [&ids[0], &ids[1]], mask);
            }
        }
    }
}

/// Lanes of `b` with one of the vertices of `a`.
#[inline(always)]
pub fn shared<S: RowSimd, const N: usize, const M: usize>(
    simd: S,
    a: [u32; N],
    b: [&[u32; WIDTH]; M],
) -> u32 {
    let mut out = 0;
    for ids in b {
        out |= simd.equals(ids, [a[0], a[N - 1]]);
        if N == 3 {
            out |= simd.equals(ids, [a[1]; 2]);
        }
    }
    out
}

/// Lanes in which feature `at_a` of `a` and feature `at_b` of `b` have a common vertex.
#[inline(always)]
fn shared_each<S: RowSimd, const N: usize, const M: usize>(
    simd: S,
    (a, at_a): ([&[u32; WIDTH]; N], &[u32; WIDTH]),
    (b, at_b): ([&[u32; WIDTH]; M], &[u32; WIDTH]),
) -> u32 {
    let [first, last] = [simd.pick_ids(b[0], at_b), simd.pick_ids(b[M - 1], at_b)];
    let mut out = 0;
    for ids in a {
        let of_a = simd.pick_ids(ids, at_a);
        out |= simd.equals_each(&of_a, [&first, &last]);
        if M == 3 {
            let second = simd.pick_ids(b[1], at_b);
            out |= simd.equals_each(&of_a, [&second, &second]);
        }
    }
    out
}
