//! From overlapping boxes to contacts without listing candidates: filters of eight pairs at a time, then certified queries.
//!
//! A row of overlaps passes the filters of topology, its pairs go to a queue, full queues pass the `f32` filters eight at a time, and what is left is decided in
//! `f64`. Pairs enter the arithmetic with the lesser edge first, so no result depends on the order of leaves.

use crate::broad::lane_ids;
use crate::contact::{Contact, Kind, State};
use crate::lanes::{Lanes, WIDTH};
use crate::pyramid::Pyramid;
use crate::simd::{Simd, Work};
use crate::traverse::Rows;
use ccd_core::bernstein::Coplanarity;
use ccd_core::kernel::{narrow, sweep};
use ccd_core::layout::Pair;
use ccd_core::motion::{Motion, Patch};
use ccd_core::query::solve;
use ccd_core::separate::{axis_gap, beside};
use ccd_core::topology::{Bodies, Mesh};
use ccd_core::{Num, Real, Verdict};
use std::time::{Duration, Instant};

/// Pairs that a queue holds before it is worked off: fits the first-level cache with the positions it touches.
const QUEUE: usize = 512;

/// What all workers of a step read.
pub struct Scene<'a, T> {
    pub mesh: &'a Mesh,
    pub bodies: Option<&'a Bodies>,
    /// Positions as given.
    pub x0: &'a [[T; 3]],
    pub x1: &'a [[T; 3]],
    /// Per vertex `x y z _` at both ends in `f32`, each within `table_error` of the true one after recentring.
    pub table: &'a [[f32; WIDTH]],
    pub table_error: f32,
    pub min_distance: f64,
    /// Where boxes were rounded: how far, see `slack_at`.
    pub slack: Option<f32>,
    /// Half of the minimum distance, by which boxes are grown.
    pub margin: T,
    /// Keep contacts, or only the least time of impact.
    pub keep_contacts: bool,
}

/// The vertices of the features of one tree in leaf order, eight features side by side.
#[derive(Debug, Default)]
pub struct LeafVertices<const N: usize>(pub Vec<[[u32; WIDTH]; N]>);

impl<const N: usize> LeafVertices<N> {
    /// From the vertices of every feature and the order of leaves.
    pub fn fill(&mut self, threads: &crate::threads::Threads, order: &[u32], features: &[[u32; N]]) {
        self.0.resize(order.len().div_ceil(WIDTH), [[0; WIDTH]; N]);
        threads.fill(&mut self.0, |i| {
            let ids = lane_ids(order, i);
            std::array::from_fn(|k| ids.map(|id| features[id as usize][k]))
        });
    }
}

/// What one worker gathers.
#[derive(Debug, Default)]
#[repr(align(128))]
pub struct Worker {
    queue: Vec<Pair>,
    near: Vec<Pair>,
    pub contacts: Vec<Contact>,
    pub toi: Option<f64>,
    pub n_candidates: u64,
    pub n_filtered: u64,
    pub narrow: Duration,
}

impl Worker {
    /// Forgets the last step, keeps buffers.
    pub fn reset(&mut self) {
        self.queue.clear();
        self.queue.reserve(QUEUE + WIDTH);
        self.near.clear();
        self.near.reserve(QUEUE + WIDTH);
        self.contacts.clear();
        self.toi = None;
        self.start_kind();
        self.narrow = Duration::ZERO;
    }

    /// Starts counting another kind of pair.
    pub fn start_kind(&mut self) {
        self.n_candidates = 0;
        self.n_filtered = 0;
    }
}

/// Edges against edges of one tree.
pub struct EdgeRows<'a, T> {
    pub scene: &'a Scene<'a, T>,
    pub edges: &'a Pyramid,
    pub ends: &'a LeafVertices<2>,
}

/// Vertices of one tree against faces of another.
pub struct FaceRows<'a, T> {
    pub scene: &'a Scene<'a, T>,
    pub vertices: &'a Pyramid,
    pub faces: &'a Pyramid,
    pub corners: &'a LeafVertices<3>,
}

impl<T: Real + Send + Sync> Rows for EdgeRows<'_, T> {
    type Worker = Worker;

    #[inline(always)]
    fn row<S: Simd>(&self, worker: &mut Worker, simd: S, a: usize, lane: usize, b: usize, mut mask: u32) {
        let ends_a = [0, 1].map(|k| self.ends.0[a][k][lane]);
        let ends_b = &self.ends.0[b];
        mask &= !(simd.equals(&ends_b[0], ends_a) | simd.equals(&ends_b[1], ends_a));
        if mask == 0 {
            return;
        }
        let id = self.edges.order()[a * WIDTH + lane];
        let ids = lane_ids(self.edges.order(), b);
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
        worker.n_candidates += mask.count_ones() as u64;
        simd.append::<true>(&mut worker.queue, id, &ids, mask);
        if worker.queue.len() >= QUEUE {
            self.flush(worker, simd);
        }
    }

    fn end(&self, worker: &mut Worker) {
        crate::simd::dispatch!(simd => self.flush(worker, simd));
    }
}

impl<T: Real + Send + Sync> EdgeRows<'_, T> {
    fn flush<S: Simd>(&self, worker: &mut Worker, simd: S) {
        let edges = self.scene.mesh.edges();
        worker.flush(simd, self.scene, Kind::EdgeEdge, |pair| narrow::edge_edge_ids(pair, edges));
    }
}

impl<T: Real + Send + Sync> Rows for FaceRows<'_, T> {
    type Worker = Worker;

    #[inline(always)]
    fn row<S: Simd>(&self, worker: &mut Worker, simd: S, a: usize, lane: usize, b: usize, mut mask: u32) {
        let vertex = self.vertices.order()[a * WIDTH + lane];
        let corners = &self.corners.0[b];
        let shared = simd.equals_one(&corners[0], vertex) | simd.equals_one(&corners[1], vertex) | simd.equals_one(&corners[2], vertex);
        mask &= !shared;
        if mask == 0 {
            return;
        }
        let ids = lane_ids(self.faces.order(), b);
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
        worker.n_candidates += mask.count_ones() as u64;
        simd.append::<false>(&mut worker.queue, vertex, &ids, mask);
        if worker.queue.len() >= QUEUE {
            self.flush(worker, simd);
        }
    }

    fn end(&self, worker: &mut Worker) {
        crate::simd::dispatch!(simd => self.flush(worker, simd));
    }
}

impl<T: Real + Send + Sync> FaceRows<'_, T> {
    fn flush<S: Simd>(&self, worker: &mut Worker, simd: S) {
        let faces = self.scene.mesh.faces();
        worker.flush(simd, self.scene, Kind::VertexFace, |pair| narrow::vertex_face_ids(pair, faces));
    }
}

/// The bits `j` of `mask` for which `wanted(j)`.
#[inline(always)]
fn keep(mask: u32, wanted: impl Fn(usize) -> bool) -> u32 {
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

impl<T: Real> Scene<'_, T> {
    /// Whether the swept boxes of two features overlap in the precision of the input.
    fn boxes_overlap<const A: usize, const B: usize>(&self, a: [u32; A], b: [u32; B]) -> bool {
        let swept = |v: u32| sweep::swept(self.x0[v as usize], self.x1[v as usize]);
        let of = |ids: &[u32]| ids.iter().skip(1).fold(swept(ids[0]), |all, &v| all.union(&swept(v))).inflated(self.margin);
        of(&a).overlaps(&of(&b))
    }
}

impl Worker {
    #[inline(always)]
    fn flush<S: Simd, T: Real>(&mut self, simd: S, scene: &Scene<T>, kind: Kind, ids: impl Fn(Pair) -> [u32; 4]) {
        if self.queue.is_empty() {
            return;
        }
        let start = Instant::now();
        simd.run(Filter { queue: &self.queue, near: &mut self.near, scene, kind, ids: &ids });
        self.n_filtered += self.near.len() as u64;
        for i in 0..self.near.len() {
            let pair = self.near[i];
            self.decide(scene, kind, pair, ids(pair));
        }
        self.queue.clear();
        self.near.clear();
        self.narrow += start.elapsed();
    }

    fn decide<T: Real>(&mut self, scene: &Scene<T>, kind: Kind, pair: Pair, ids: [u32; 4]) {
        let wide = |x: &[[T; 3]]| narrow::gather(ids, x).map(|p| p.map(T::to_f64));
        let (t0, t1) = (wide(scene.x0), wide(scene.x1));
        let verdict = match kind {
            Kind::VertexFace => solve(&Motion::vertex_face(&t0, &t1, 0.0), Patch::Triangle, scene.min_distance),
            Kind::EdgeEdge => solve(&Motion::edge_edge(&t0, &t1, 0.0), Patch::Parallelogram, scene.min_distance),
        };
        let (state, toi) = match verdict {
            Verdict::Miss => return,
            Verdict::Hit { toi } => (State::Hit, toi),
            Verdict::Undecided { toi } => (State::Undecided, toi),
        };
        self.toi = Some(self.toi.map_or(toi, |t| t.min(toi)));
        if scene.keep_contacts {
            self.contacts.push(Contact { kind, state, a: pair.a, b: pair.b, toi });
        }
    }
}

/// Moves what the `f32` filters cannot reject from `queue` to `near`.
struct Filter<'a, T, F> {
    queue: &'a [Pair],
    near: &'a mut Vec<Pair>,
    scene: &'a Scene<'a, T>,
    kind: Kind,
    ids: &'a F,
}

impl<T: Real, F: Fn(Pair) -> [u32; 4]> Work for Filter<'_, T, F> {
    type Out = ();

    #[inline(always)]
    fn call<S: Simd>(self, simd: S) {
        let Filter { queue, near, scene, kind, ids } = self;
        let distance = ccd_core::aabb::round_up(scene.min_distance);
        // The gap between rounded positions must exceed the distance by the error of both; 1.0001 covers the rounding of this line.
        let needed = (distance + 2.0 * scene.table_error) * 1.0001;
        let (distance, error) = (Lanes([distance; WIDTH]), Lanes([scene.table_error; WIDTH]));
        for eight in queue.chunks(WIDTH) {
            let mut v = [[0u32; WIDTH]; 4];
            for j in 0..WIDTH {
                let four = ids(eight[j.min(eight.len() - 1)]);
                for k in 0..4 {
                    v[k][j] = four[k];
                }
            }
            let mut x0 = [[distance; 3]; 4];
            let mut x1 = [[distance; 3]; 4];
            for k in 0..4 {
                let p = simd.gather(scene.table, &v[k]);
                x0[k] = [p[0], p[1], p[2]];
                x1[k] = [p[4], p[5], p[6]];
            }
            let (n_first, patch) = match kind {
                Kind::VertexFace => (1, Patch::Triangle),
                Kind::EdgeEdge => (2, Patch::Parallelogram),
            };
            let mut rejected = axis_gap(&x0, &x1, n_first).greater(needed);
            if rejected != 0xff {
                let motion = match kind {
                    Kind::VertexFace => Motion::vertex_face(&x0, &x1, error),
                    Kind::EdgeEdge => Motion::edge_edge(&x0, &x1, error),
                };
                rejected |= Coplanarity::new(&motion).clearance(distance).greater(0.0);
                if rejected != 0xff {
                    rejected |= beside(&motion, patch, distance).greater(0.0);
                }
            }
            let mut left = !rejected & (0xff >> (WIDTH - eight.len()));
            while left != 0 {
                near.push(eight[left.trailing_zeros() as usize]);
                left &= left - 1;
            }
        }
    }
}

/// Whether `Num` for lanes rounds like `f32`: the bounds of the filters rest on it.
const _: () = assert!(<Lanes as Num>::UNIT == <f32 as Num>::UNIT);
