//! Where a mesh goes through itself at one moment: edges through faces, exactly.

use super::{Engine, Session, WHOLE};
use crate::broad_phase::method::Method;
use crate::broad_phase::pair_source::{Overlaps, PairSink, PairSource};
use crate::simd::{F32x8, Mask, RowSimd, WIDTH, Work};
use crate::step::candidates::{Given, Scene, boxes_overlap, shared};
use crate::step::leaves::Leaves;
use crate::step::positions::Positions;
use crate::threads::{Own, Threads};
use ccd_core::model::contact::State;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::Pipeline;
use ccd_core::model::positions::AsPositions;
use ccd_core::model::precision::Precision;
use ccd_core::model::scheduling::Scheduling;
use ccd_core::model::session::{Intersection, State as Stepped};
use ccd_core::narrow_phase::intersection::{Slab, are_outside, segment_meets_triangle, slabs};
use ccd_core::{Error, Num};

/// Edges and faces of `mesh` at positions `x` that have a point in common but no vertex, sorted by
/// edge, then by face. A mesh without any does not intersect itself.
///
/// Of the options, bodies, threads and the memory count. [`Session::intersections`] says more, and
/// costs less.
///
/// ```
/// use ccd::{Mesh, Options, State, intersections};
///
/// let mesh = Mesh::new(6, &[[0, 1, 2], [3, 4, 5]])?;
/// let x = [
///     [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0],
///     [0.2, -1.0, 0.2], [0.2, 1.0, 0.2], [5.0, 1.0, 5.0],
/// ];
/// let found = intersections(&mesh, &x, &Options::default())?;
/// let edges: Vec<_> = found.iter().map(|i| mesh.edges()[i.edge as usize]).collect();
/// assert_eq!(edges, [[1, 2], [3, 4]]);
///
/// // An edge whose end is in a face: touching counts.
/// let mesh = Mesh::with_edges(5, &[[0, 1, 2]], &[[3, 4]])?;
/// let end = [[0.25, 0.0, 0.25], [0.25, 1.0, 0.25]];
/// let found = intersections(&mesh, &[&x[..3], &end].concat(), &Options::default())?;
/// assert_eq!((found[0].face, found[0].state), (0, State::Hit));
/// assert_eq!(mesh.edges()[found[0].edge as usize], [3, 4]);
/// # Ok::<(), ccd::Error>(())
/// ```
///
/// # Errors
/// Those of [`Session::new`] and of [`Session::intersections`].
pub fn intersections<A: AsPositions + ?Sized>(
    mesh: &Mesh,
    x: &A,
    options: &Options,
) -> Result<Vec<Intersection>, Error> {
    session(mesh, options)?.intersections(x)
}

/// Whether [`intersections`] would list any: whether the mesh goes through itself, or touches
/// itself, at positions `x`. The search ends with the first one that is found.
///
/// ```
/// use ccd::{Mesh, Options, has_intersections};
///
/// // A face, and an edge above it, whose first end sinks into it.
/// let mesh = Mesh::with_edges(5, &[[0, 1, 2]], &[[3, 4]])?;
/// let at = |y: f64| {
///     [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.25, y, 0.25], [0.25, 2.0, 0.25]]
/// };
/// let ask = |y: f64| has_intersections(&mesh, &at(y), &Options::default());
/// assert_eq!((ask(1e-9)?, ask(-1e-9)?), (false, true));
/// # Ok::<(), ccd::Error>(())
/// ```
///
/// # Errors
/// Those of [`intersections`].
pub fn has_intersections<A: AsPositions + ?Sized>(
    mesh: &Mesh,
    x: &A,
    options: &Options,
) -> Result<bool, Error> {
    session(mesh, options)?.has_intersections(x)
}

/// A session that finds them by the default method.
fn session(mesh: &Mesh, options: &Options) -> Result<Session, Error> {
    let options = options.clone().with_broad_phase(BroadPhaseMethod::default());
    let options = options.with_scheduling(Scheduling::default()).with_min_distance(0.0);
    Session::new(mesh, options.with_pipeline(Pipeline::default()))
}

impl Engine {
    pub(super) fn find_intersections(
        &mut self,
        given: Given,
        first: bool,
    ) -> Result<Vec<Intersection>, Error> {
        if !matches!(self.method, Method::Blocks(_)) || self.prepared.triangles.is_some() {
            let Stepped { mesh, options, .. } = &self.state;
            let mut options = options.clone();
            // What this session holds stays.
            let held = self.threads.stop.held();
            options.max_memory = options.max_memory.map(|limit| limit.saturating_sub(held));
            let mut plain = session(mesh, &options)?;
            plain.set_cancel_token(self.threads.stop.token().cloned());
            return plain.find_intersections(given, first);
        }
        let stop = self.threads.stop.clone();
        stop.begin()?;
        let held = stop.held();
        let found = self.intersections_given(given, first);
        // All lists of it are gone, or the caller's.
        stop.hold(held);
        found
    }

    fn intersections_given(
        &mut self,
        given: Given,
        first: bool,
    ) -> Result<Vec<Intersection>, Error> {
        let x = Positions::new(given, WHOLE);
        let Self { state, threads, prepared, selection, method, .. } = self;
        let Stepped { mesh, options, .. } = state;
        let (threads, mesh, options, selection) = (&*threads, &*mesh, &*options, &*selection);
        threads.enter(|| {
            let stop = &*threads.stop;
            prepared.boxes(threads, options, &x)?;
            stop.check()?;
            prepared.edges_and_faces(
                threads,
                method,
                (mesh, options),
                selection.rules.as_ref(),
                &x,
            )?;
            stop.check()?;
            let scene = &prepared.scene((mesh, options), selection, &x, WHOLE, true, stop);
            let (edges, faces) = (&prepared.edges.leaves, &prepared.faces.leaves);
            let mut sink = Through { scene, edges, faces, slabs: Vec::new(), first };
            sink.fill(threads);
            stop.check()?;
            let mut workers = Vec::new();
            workers.resize_with(threads.count(), Own::default);
            let sides = (&edges.boxes, Some(&faces.boxes));
            method.find(threads, sides, 1, &sink, &mut workers);
            if first && let Some(Own(found)) = workers.iter_mut().find(|own| !own.0.is_empty()) {
                return Ok(std::mem::take(found));
            }
            let mut all = Vec::new();
            for Own(found) in workers {
                if stop.reserve(WHAT, &mut all, found.len()) {
                    all.extend(found);
                }
            }
            stop.check()?;
            threads.sort(&mut all, |i: &Intersection| (i.edge, i.face));
            Ok(all)
        })
    }
}

/// The name of lists in [`Error::Memory`].
const WHAT: &str = "intersections";

/// Edges against faces.
struct Through<'a> {
    scene: &'a Scene<'a>,
    edges: &'a Leaves<2>,
    faces: &'a Leaves<3>,
    /// By block of faces: between which planes they lie.
    slabs: Vec<[Slab<F32x8>; 4]>,
    /// Whether the first one that is found is enough.
    first: bool,
}

impl Through<'_> {
    fn fill(&mut self, threads: &Threads) {
        let Self { scene, faces, slabs, .. } = self;
        let n = faces.vertices.len();
        if !scene.stop.reserve(WHAT, slabs, n) {
            return;
        }
        slabs.resize(n, [Slab::default(); 4]);
        let table = scene.table;
        let reach = table.iter().flatten().fold(0f32, |most, x| most.max(x.abs()));
        threads.chunks(slabs, &|first, out| {
            let vertices = &faces.vertices[first..first + out.len()];
            crate::simd::run_rows!(Fill { table, reach, error: scene.table_error, vertices, out });
        });
    }

    /// Whether an edge goes through a face, without rounding.
    #[inline(never)]
    fn meet(&self, edge: [u32; 2], face: [u32; 3]) -> Option<State> {
        let at = |v: u32| match self.scene.given {
            Precision::F32([x, _]) => x[v as usize].map(f64::from),
            Precision::F64([x, _]) => x[v as usize],
        };
        match segment_meets_triangle(edge.map(at), face.map(at)) {
            Some(meet) => meet.then_some(State::Hit),
            // Without the minimum distance, which may be there with the boxes of a session.
            None => match self.scene.given {
                Precision::F32(x) => boxes_overlap(x, 0.0, &edge, &face),
                Precision::F64(x) => boxes_overlap(x, 0.0, &edge, &face),
            }
            .then_some(State::Undecided),
        }
    }
}

impl PairSink for Through<'_> {
    type Worker = Own<Vec<Intersection>>;

    #[inline(always)]
    fn row<S: RowSimd>(&self, Own(found): &mut Own<Vec<Intersection>>, simd: S, row: Overlaps) {
        let Overlaps { a, lane, b, mut mask } = row;
        let (v, w) = (self.edges.vertices[a][0][lane], self.edges.vertices[a][1][lane]);
        let [f0, f1, f2] = &self.faces.vertices[b];
        mask &= !shared(simd, [v, w], [f0, f1, f2]);
        if mask == 0 {
            return;
        }
        let ends = [end(simd, self.scene.table, v), end(simd, self.scene.table, w)];
        for slab in &self.slabs[b] {
            mask &= !are_outside(&loaded(simd, slab), &ends).bits();
            if mask == 0 {
                return;
            }
        }
        let (of_a, of_b) = ((&self.edges.bodies, a), (&self.faces.bodies, b));
        mask = self.scene.selection.of_bodies(v, f0, mask, of_a, of_b);
        while mask != 0 {
            let j = mask.trailing_zeros() as usize;
            mask &= mask - 1;
            if let Some(state) = self.meet([v, w], [f0[j], f1[j], f2[j]])
                && self.scene.stop.reserve(WHAT, found, 1)
            {
                let edge = self.edges.boxes.order()[a * WIDTH + lane];
                found.push(Intersection::new(edge, self.faces.boxes.ids(b)[j], state));
                if self.first {
                    return self.scene.stop.enough();
                }
            }
        }
    }
}

/// A vertex in all lanes.
#[inline(always)]
fn end<S: RowSimd>(_simd: S, table: &[[f32; WIDTH]], v: u32) -> [S::Lanes; 3] {
    let x = &table[v as usize];
    [S::Lanes::splat(x[0]), S::Lanes::splat(x[1]), S::Lanes::splat(x[2])]
}

#[inline(always)]
fn loaded<S: RowSimd>(
    simd: S,
    Slab { direction: [x, y, z], low, high }: &Slab<F32x8>,
) -> Slab<S::Lanes> {
    Slab {
        direction: [simd.load(x), simd.load(y), simd.load(z)],
        low: simd.load(low),
        high: simd.load(high),
    }
}

/// Finds between which planes faces lie, block by block.
struct Fill<'a> {
    table: &'a [[f32; WIDTH]],
    reach: f32,
    error: f32,
    vertices: &'a [[[u32; WIDTH]; 3]],
    out: &'a mut [[Slab<F32x8>; 4]],
}

impl<S: RowSimd> Work<S> for Fill<'_> {
    type Out = ();

    #[inline(always)]
    fn call(self, simd: S) {
        let (reach, error) = (S::Lanes::splat(self.reach), S::Lanes::splat(self.error));
        for ([a, b, c], out) in self.vertices.iter().zip(self.out) {
            let [ax, ay, az, ..] = simd.gather(self.table, a);
            let [bx, by, bz, ..] = simd.gather(self.table, b);
            let [cx, cy, cz, ..] = simd.gather(self.table, c);
            let slabs = slabs(&[[ax, ay, az], [bx, by, bz], [cx, cy, cz]], reach, error);
            for (Slab { direction: [x, y, z], low, high }, out) in slabs.into_iter().zip(out) {
                out.direction = [simd.store(x), simd.store(y), simd.store(z)];
                (out.low, out.high) = (simd.store(low), simd.store(high));
            }
        }
    }
}
