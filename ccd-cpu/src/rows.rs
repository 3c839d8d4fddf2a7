//! What happens to a row of overlaps before any arithmetic on features: pairs that share a vertex go, pairs of bodies that nobody wants, and pairs that
//! overlap only because boxes were rounded. What is left are candidates; whoever takes them does the rest.

use crate::broad::lane_ids;
use crate::lanes::{Lanes, WIDTH};
use crate::pyramid::Pyramid;
use crate::simd::{Block, Simd, Work};
use crate::threads::Threads;
use crate::traverse::Rows;
use ccd_core::broad_phase::swept_box;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::contact::Kind;
use ccd_core::model::mesh::Mesh;
use ccd_core::narrow_phase::separating_direction::axis_separated;
use ccd_core::{Num, Real};
use std::marker::PhantomData;

/// What all workers of a step read.
pub struct Scene<'a, T> {
    pub mesh: &'a Mesh,
    pub bodies: Option<&'a Bodies>,
    /// Positions as given.
    pub x0: &'a [[T; 3]],
    pub x1: &'a [[T; 3]],
    /// Per vertex `x y z _` at both ends in `f32`, each within `table_error` of the true one, in the origin and the unit of a
    /// [`ccd_core::model::quantization::Table`]; the minimum distance in that unit, rounded up.
    pub table: &'a [[f32; WIDTH]],
    pub table_error: f32,
    pub table_distance: f32,
    pub min_distance: f64,
    /// Where boxes were rounded: how far, see `slack_at`.
    pub slack: Option<f32>,
    /// Half of the minimum distance, by which boxes are grown.
    pub margin: T,
    /// Keep contacts, or only the least time of impact.
    pub keep_contacts: bool,
}

impl<T: Real> Scene<'_, T> {
    /// The gap that two features must keep along an axis to be apart: 1.0001 covers the rounding of this line and of the gap.
    fn needed_gap(&self) -> f32 {
        (self.table_distance + 2.0 * self.table_error) * 1.0001
    }

    /// Whether the swept boxes of two features overlap in the precision of the input.
    fn boxes_overlap<const A: usize, const B: usize>(&self, a: [u32; A], b: [u32; B]) -> bool {
        let swept = |v: u32| swept_box::swept(self.x0[v as usize], self.x1[v as usize]);
        let of = |ids: &[u32]| ids.iter().skip(1).fold(swept(ids[0]), |all, &v| all.union(&swept(v))).inflated(self.margin);
        of(&a).overlaps(&of(&b))
    }
}

/// The features of one tree in leaf order, eight side by side.
#[derive(Debug, Default)]
pub struct Leaves<const N: usize> {
    /// Vertices of the features.
    pub vertices: Vec<[[u32; WIDTH]; N]>,
    /// Boxes of the features at the start and at the end, of the positions in the table.
    pub ends: Vec<[Block; 2]>,
}

impl<const N: usize> Leaves<N> {
    /// Vertices, from those of every feature and the order of leaves.
    pub fn order(&mut self, threads: &Threads, order: &[u32], features: impl Fn(u32) -> [u32; N] + Sync) {
        self.vertices.resize(order.len().div_ceil(WIDTH), [[0; WIDTH]; N]);
        threads.fill(&mut self.vertices, |i| {
            let of = lane_ids(order, i).map(&features);
            std::array::from_fn(|k| of.map(|vertices| vertices[k]))
        });
    }

    /// Boxes at both ends, from the table of positions.
    pub fn place(&mut self, threads: &Threads, table: &[[f32; WIDTH]]) {
        let vertices = &self.vertices;
        self.ends.resize(vertices.len(), [Block::EMPTY; 2]);
        crate::simd::dispatch!(simd => threads.fill(&mut self.ends, |i| simd.run(Place { table, vertices: &vertices[i] })));
    }
}

/// The boxes of eight features at both ends.
struct Place<'a, const N: usize> {
    table: &'a [[f32; WIDTH]],
    vertices: &'a [[u32; WIDTH]; N],
}

impl<const N: usize> Work for Place<'_, N> {
    type Out = [Block; 2];

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) -> [Block; 2] {
        let first = simd.gather(self.table, &self.vertices[0]);
        let (mut min, mut max) = (first, first);
        for ids in &self.vertices[1..] {
            let next = simd.gather(self.table, ids);
            for k in 0..WIDTH {
                min[k] = min[k].min(next[k]);
                max[k] = max[k].max(next[k]);
            }
        }
        let block = |k: usize| Block { min: [min[k].0, min[k + 1].0, min[k + 2].0], max: [max[k].0, max[k + 1].0, max[k + 2].0] };
        [block(0), block(4)]
    }
}

/// Takes candidates.
pub trait Take: Send {
    /// Whether pairs that an axis separates throughout may be left out after they were counted.
    const FILTERED: bool;
    /// Counts candidates.
    fn count(&mut self, n: u64);
    /// Takes the pairs of `id` with the lanes `mask` of `ids`.
    fn take<S: Simd, T: Real>(&mut self, simd: S, scene: &Scene<T>, kind: Kind, id: u32, ids: &[u32; WIDTH], mask: u32);
    /// A task begins.
    fn begin(&mut self, task: usize);
    /// No further candidate comes.
    fn finish<T: Real>(&mut self, scene: &Scene<T>, kind: Kind);
}

/// Edges against edges of one tree.
pub struct EdgeRows<'a, T, W> {
    pub scene: &'a Scene<'a, T>,
    pub edges: &'a Pyramid,
    pub leaves: &'a Leaves<2>,
    pub worker: PhantomData<fn(W)>,
}

/// Vertices of one tree against faces of another.
pub struct FaceRows<'a, T, W> {
    pub scene: &'a Scene<'a, T>,
    pub vertices: &'a Pyramid,
    pub faces: &'a Pyramid,
    pub vertex_leaves: &'a Leaves<1>,
    pub face_leaves: &'a Leaves<3>,
    pub worker: PhantomData<fn(W)>,
}

impl<T: Real + Send + Sync, W: Take> Rows for EdgeRows<'_, T, W> {
    type Worker = W;

    #[inline(always)]
    fn row<S: Simd>(&self, worker: &mut W, simd: S, a: usize, lane: usize, b: usize, mut mask: u32) {
        let ends_a = [self.leaves.vertices[a][0][lane], self.leaves.vertices[a][1][lane]];
        let ends_b = &self.leaves.vertices[b];
        mask &= !(simd.equals(&ends_b[0], ends_a) | simd.equals(&ends_b[1], ends_a));
        if let Some(bodies) = self.scene.bodies {
            mask = keep(mask, |j| bodies.wants(bodies.body(ends_a[0]), bodies.body(ends_b[0][j])));
        }
        if let Some(slack) = self.scene.slack {
            let sure = simd.overlaps_shrunk(&self.edges.level(0)[a], lane, &self.edges.level(0)[b], slack);
            let unsure = mask & !sure;
            if unsure != 0 {
                mask = mask & sure | keep(unsure, |j| self.scene.boxes_overlap(ends_a, [ends_b[0][j], ends_b[1][j]]));
            }
        }
        worker.count(mask.count_ones() as u64);
        if W::FILTERED {
            mask &= !separated(&self.leaves.ends[a], lane, &self.leaves.ends[b], self.scene.needed_gap());
        }
        if mask != 0 {
            let (id, ids) = (self.edges.order()[a * WIDTH + lane], lane_ids(self.edges.order(), b));
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

impl<T: Real + Send + Sync, W: Take> Rows for FaceRows<'_, T, W> {
    type Worker = W;

    #[inline(always)]
    fn row<S: Simd>(&self, worker: &mut W, simd: S, a: usize, lane: usize, b: usize, mut mask: u32) {
        let vertex = self.vertex_leaves.vertices[a][0][lane];
        let corners = &self.face_leaves.vertices[b];
        mask &= !(simd.equals(&corners[0], [vertex; 2]) | simd.equals(&corners[1], [vertex; 2]) | simd.equals(&corners[2], [vertex; 2]));
        if let Some(bodies) = self.scene.bodies {
            mask = keep(mask, |j| bodies.wants(bodies.body(vertex), bodies.body(corners[0][j])));
        }
        if let Some(slack) = self.scene.slack {
            let sure = simd.overlaps_shrunk(&self.vertices.level(0)[a], lane, &self.faces.level(0)[b], slack);
            let unsure = mask & !sure;
            if unsure != 0 {
                let of = |j: usize| [corners[0][j], corners[1][j], corners[2][j]];
                mask = mask & sure | keep(unsure, |j| self.scene.boxes_overlap([vertex], of(j)));
            }
        }
        worker.count(mask.count_ones() as u64);
        if W::FILTERED {
            mask &= !separated(&self.vertex_leaves.ends[a], lane, &self.face_leaves.ends[b], self.scene.needed_gap());
        }
        if mask != 0 {
            worker.take(simd, self.scene, Kind::VertexFace, vertex, &lane_ids(self.faces.order(), b), mask);
        }
    }

    fn begin(&self, worker: &mut W, task: usize) {
        worker.begin(task);
    }

    fn end(&self, worker: &mut W) {
        worker.finish(self.scene, Kind::VertexFace);
    }
}

/// The bits `j` of `mask` for which `wanted(j)`.
#[inline(always)]
pub(crate) fn keep(mask: u32, wanted: impl Fn(usize) -> bool) -> u32 {
    let (mut rest, mut out) = (mask, mask);
    while rest != 0 {
        let j = rest.trailing_zeros();
        rest &= rest - 1;
        if !wanted(j as usize) {
            out &= !(1 << j);
        }
    }
    out
}

/// Lanes of `b` that an axis keeps further than `needed` from lane `i` of `a` during the whole step.
#[inline(always)]
fn separated(a: &[Block; 2], i: usize, b: &[Block; 2], needed: f32) -> u32 {
    axis_separated(&one(&a[0], i), &one(&a[1], i), &all(&b[0]), &all(&b[1]), Lanes([needed; WIDTH]))
}

/// Lane `i` in all lanes.
#[inline(always)]
fn one(block: &Block, i: usize) -> [[Lanes; 3]; 2] {
    let (min, max) = (&block.min, &block.max);
    [
        [Lanes([min[0][i]; WIDTH]), Lanes([min[1][i]; WIDTH]), Lanes([min[2][i]; WIDTH])],
        [Lanes([max[0][i]; WIDTH]), Lanes([max[1][i]; WIDTH]), Lanes([max[2][i]; WIDTH])],
    ]
}

#[inline(always)]
fn all(block: &Block) -> [[Lanes; 3]; 2] {
    let (min, max) = (&block.min, &block.max);
    [[Lanes(min[0]), Lanes(min[1]), Lanes(min[2])], [Lanes(max[0]), Lanes(max[1]), Lanes(max[2])]]
}

/// Whether `Num` for lanes rounds like `f32`: the bounds of the filters rest on it.
const _: () = assert!(<Lanes as Num>::UNIT.0[0] == <f32 as Num>::UNIT);
