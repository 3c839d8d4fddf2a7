//! A mesh stepped frame by frame: buffers and the order of trees are kept, trees are refitted or rebuilt by a stated rule.

use crate::broad::slack_at;
use crate::contact::{Contact, Kind, PerKind, Report, State};
use crate::lanes::WIDTH;
use crate::narrow::{EdgeRows, FaceRows, LeafVertices, Scene, Worker};
use crate::pyramid::Pyramid;
use crate::threads::Threads;
use crate::traverse::Traversal;
use ccd_core::error::check_min_distance;
use ccd_core::kernel::sweep;
use ccd_core::topology::{Bodies, Mesh};
use ccd_core::{Aabb, Error, Num, Real};
use std::time::Instant;

/// What a step looks for and how.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// Contact means a distance of at most this, in the unit of the coordinates; 0 (touching) or more.
    pub min_distance: f64,
    /// Threads: 0 for those of rayon's current pool, 1 for the calling one alone, more for a pool of the session's own.
    pub threads: usize,
    /// Which pairs of bodies are looked at; `None`: all pairs of features that share no vertex.
    pub bodies: Option<Bodies>,
}

/// Blocks may become this much looser than after the last build before trees are built anew: building costs about a tenth of a step, and
/// traversal grows with looseness.
pub const MAX_LOOSENESS: f64 = 1.15;

/// Continuous collision detection of one mesh over many steps.
#[derive(Debug)]
pub struct Session {
    mesh: Mesh,
    options: Options,
    threads: Threads,
    state: Buffers,
    report: Report,
}

#[derive(Debug, Default)]
struct Buffers {
    built: bool,
    scans: Vec<Scan>,
    table: Vec<[f32; WIDTH]>,
    vertices: Feature<1>,
    edges: Feature<2>,
    faces: Feature<3>,
    traversal: Traversal,
    workers: Vec<Worker>,
}

#[derive(Debug, Default)]
struct Feature<const N: usize> {
    boxes: Vec<Aabb<f32>>,
    pyramid: Pyramid,
    leaves: LeafVertices<N>,
}

/// What one pass over a part of the positions finds.
#[derive(Clone, Copy, Debug)]
struct Scan {
    bounds: Aabb<f64>,
    exact: bool,
    finite: bool,
}

impl Scan {
    const NONE: Self = Self { bounds: Aabb { min: [f64::INFINITY; 3], max: [f64::NEG_INFINITY; 3] }, exact: true, finite: true };
}

impl Session {
    /// A session for `mesh`.
    pub fn new(mesh: Mesh, options: Options) -> Result<Self, Error> {
        check_min_distance(options.min_distance)?;
        if let Some(bodies) = &options.bodies {
            bodies.check(&mesh)?;
        }
        let threads = Threads::new(options.threads)?;
        Ok(Self { mesh, options, threads, state: Buffers::default(), report: Report::default() })
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The options.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// Number of threads that steps use.
    pub fn threads(&self) -> usize {
        self.threads.count()
    }

    /// What the last step found.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Every contact while vertices move on straight lines from `x0` to `x1`, one position per vertex of the mesh.
    ///
    /// After the first steps, nothing is allocated unless there are more contacts than before.
    pub fn step<T: Real + Send + Sync>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<&Report, Error> {
        self.run(x0, x1, false)?;
        Ok(&self.report)
    }

    /// The earliest time of impact of the step, without the list of contacts: cheaper than [`Session::step`].
    ///
    /// It is not later than the earliest contact. `None`: the whole step is free.
    pub fn earliest_toi<T: Real + Send + Sync>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<Option<f64>, Error> {
        self.run(x0, x1, true)?;
        Ok(self.report.toi)
    }

    fn run<T: Real + Send + Sync>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]], earliest: bool) -> Result<(), Error> {
        for (time, x) in [(0, x0), (1, x1)] {
            let (expected, found) = (self.mesh.n_vertices(), x.len());
            if expected != found {
                return Err(Error::VertexCount { time, expected, found });
            }
        }
        let Self { mesh, options, threads, state, report } = self;
        let threads = &*threads;
        threads.enter(|| {
            let start = Instant::now();
            state.workers.resize_with(threads.count(), Worker::default);
            state.workers.iter_mut().for_each(Worker::reset);
            report.contacts.clear();
            (report.candidates, report.filtered) = (PerKind::default(), PerKind::default());
            report.times = Default::default();
            let mut x = Positions { x0, x1, until: 1.0 };
            if earliest {
                // A part of the tasks first; what it finds bounds the time that matters, and with it all boxes.
                state.pass(threads, mesh, options, &x, report, true, SAMPLE)?;
                if let Some(toi) = state.workers.iter().filter_map(|w| w.toi).reduce(f64::min) {
                    x.until = toi;
                }
            }
            state.pass(threads, mesh, options, &x, report, earliest, 1)?;
            state.collect(threads, report);
            report.times.total = milliseconds(start);
            Ok(())
        })
    }
}

/// Every contact of one step, with no session to keep: see [`Session::step`].
pub fn step<T: Real + Send + Sync>(mesh: &Mesh, x0: &[[T; 3]], x1: &[[T; 3]], options: &Options) -> Result<Report, Error> {
    let mut session = Session::new(mesh.clone(), options.clone())?;
    session.step(x0, x1)?;
    Ok(session.report)
}

/// The earliest time of impact of one step: see [`Session::earliest_toi`].
pub fn earliest_toi<T: Real + Send + Sync>(mesh: &Mesh, x0: &[[T; 3]], x1: &[[T; 3]], options: &Options) -> Result<Option<f64>, Error> {
    Session::new(mesh.clone(), options.clone())?.earliest_toi(x0, x1)
}

/// Of how many tasks one is sampled to bound the earliest time of impact.
const SAMPLE: usize = 64;

/// Positions of a step, of which only the times up to `until` matter.
struct Positions<'a, T> {
    x0: &'a [[T; 3]],
    x1: &'a [[T; 3]],
    until: f64,
}

impl<T: Real> Positions<'_, T> {
    /// Whether the whole step matters.
    fn whole(&self) -> bool {
        self.until >= 1.0
    }

    /// Position of vertex `i` at `until`, up to the rounding of four operations in `f64`.
    fn end(&self, i: usize) -> [f64; 3] {
        let (p, q) = (self.x0[i].map(T::to_f64), self.x1[i].map(T::to_f64));
        if self.whole() { q } else { std::array::from_fn(|k| p[k] + (q[k] - p[k]) * self.until) }
    }
}

impl Buffers {
    /// Boxes, trees, traversal and decisions over the times up to `x.until`.
    #[allow(clippy::too_many_arguments, reason = "the parts of a session, borrowed one by one")]
    fn pass<T: Real + Send + Sync>(
        &mut self,
        threads: &Threads,
        mesh: &Mesh,
        options: &Options,
        x: &Positions<T>,
        report: &mut Report,
        earliest: bool,
        part: usize,
    ) -> Result<(), Error> {
        let start = Instant::now();
        let scan = self.scan(threads, x)?;
        let table_error = self.fill_table(threads, x, &scan);
        let half = T::splat(options.min_distance * 0.5);
        let margin = if half > T::splat(0.0) { half.next_up() } else { half };
        self.sweep(threads, mesh, x, margin);
        report.times.boxes += milliseconds(start);

        let start = Instant::now();
        report.rebuilt = self.fit(threads, mesh);
        report.times.build += milliseconds(start);

        let start = Instant::now();
        let greatest = (0..3).fold(0f64, |m, k| m.max(scan.bounds.min[k].abs()).max(scan.bounds.max[k].abs()));
        // A shorter time has boxes of its own, which nobody compares with those of the input.
        let rounded = T::UNIT < f32::UNIT && !(scan.exact && options.min_distance == 0.0) && x.whole();
        let scene = Scene {
            mesh,
            bodies: options.bodies.as_ref(),
            x0: x.x0,
            x1: x.x1,
            table: &self.table,
            table_error,
            min_distance: options.min_distance,
            slack: rounded.then(|| slack_at(ccd_core::aabb::round_up(greatest + options.min_distance))),
            margin,
            keep_contacts: !earliest,
        };
        let before: std::time::Duration = self.workers.iter().map(|w| w.narrow).sum();
        let (vertices, edges, faces) = (&self.vertices, &self.edges, &self.faces);
        self.workers.iter_mut().for_each(Worker::start_kind);
        let rows = FaceRows { scene: &scene, vertices: &vertices.pyramid, faces: &faces.pyramid, corners: &faces.leaves };
        self.traversal.run(threads, (&vertices.pyramid, Some(&faces.pyramid)), part, &rows, &mut self.workers);
        count(&mut self.workers, report, Kind::VertexFace);
        let rows = EdgeRows { scene: &scene, edges: &edges.pyramid, ends: &edges.leaves };
        self.traversal.run(threads, (&edges.pyramid, None), part, &rows, &mut self.workers);
        count(&mut self.workers, report, Kind::EdgeEdge);
        let after: std::time::Duration = self.workers.iter().map(|w| w.narrow).sum();
        let narrow = (after - before).as_secs_f64() * 1e3 / threads.count() as f64;
        report.times.narrow += narrow;
        report.times.traverse += (milliseconds(start) - narrow).max(0.0);
        Ok(())
    }

    /// Checks coordinates and finds their bounds and whether each is an `f32`.
    fn scan<T: Real + Send + Sync>(&mut self, threads: &Threads, x: &Positions<T>) -> Result<Scan, Error> {
        const CHUNK: usize = 2048;
        self.scans.resize(x.x0.len().div_ceil(CHUNK), Scan::NONE);
        threads.fill(&mut self.scans, |i| {
            let mut scan = Scan::NONE;
            for v in i * CHUNK..((i + 1) * CHUNK).min(x.x0.len()) {
                for p in [x.x0[v], x.x1[v]] {
                    for k in 0..3 {
                        let c = p[k].to_f64();
                        scan.bounds.min[k] = scan.bounds.min[k].min(c);
                        scan.bounds.max[k] = scan.bounds.max[k].max(c);
                        scan.exact &= c as f32 as f64 == c;
                        scan.finite &= c.abs() <= Error::MAX_COORDINATE;
                    }
                }
            }
            scan
        });
        let all = self.scans.iter().fold(Scan::NONE, |all, s| Scan {
            bounds: all.bounds.union(&s.bounds),
            exact: all.exact & s.exact,
            finite: all.finite & s.finite,
        });
        if !all.finite {
            ccd_core::error::check_coordinates(0, x.x0)?;
            ccd_core::error::check_coordinates(1, x.x1)?;
        }
        Ok(all)
    }

    /// Fills the table that filters read; returns how far its numbers may be from the true ones (minus a common origin).
    fn fill_table<T: Real + Send + Sync>(&mut self, threads: &Threads, x: &Positions<T>, scan: &Scan) -> f32 {
        let exact = scan.exact && x.whole();
        let centre: [f64; 3] =
            std::array::from_fn(|k| if exact || x.x0.is_empty() { 0.0 } else { 0.5 * scan.bounds.min[k] + 0.5 * scan.bounds.max[k] });
        self.table.resize(x.x0.len(), [0.0; WIDTH]);
        threads.fill(&mut self.table, |i| {
            let (p, q) = (x.x0[i].map(T::to_f64), x.end(i));
            let f = |x: [f64; 3], k: usize| (x[k] - centre[k]) as f32;
            [f(p, 0), f(p, 1), f(p, 2), 0.0, f(q, 0), f(q, 1), f(q, 2), 0.0]
        });
        if exact {
            return 0.0;
        }
        // Rounding to f32, and before it at most six roundings in f64 of numbers no greater than the coordinates.
        let reach = (0..3).fold(0f64, |m, k| m.max(scan.bounds.max[k] - centre[k]).max(centre[k] - scan.bounds.min[k]));
        let greatest = (0..3).fold(0f64, |m, k| m.max(scan.bounds.max[k].abs()).max(scan.bounds.min[k].abs()));
        ccd_core::aabb::round_up(reach * (1.01 * f32::UNIT) + greatest * (16.0 * f64::UNIT) + f32::MIN_NORMAL)
    }

    /// Boxes of all features.
    fn sweep<T: Real + Send + Sync>(&mut self, threads: &Threads, mesh: &Mesh, x: &Positions<T>, margin: T) {
        let boxes = &mut self.vertices.boxes;
        boxes.resize(mesh.n_vertices(), Aabb::EMPTY);
        if x.whole() {
            threads.fill(boxes, |i| sweep::vertex(i, x.x0, x.x1, margin));
        } else {
            threads.fill(boxes, |i| {
                let (p, q) = (x.x0[i].map(T::to_f64), x.end(i));
                let largest = ccd_core::vec3::max_abs(p).max(ccd_core::vec3::max_abs(x.x1[i].map(T::to_f64)));
                // Four roundings of numbers at most twice the largest coordinate.
                sweep::swept(p, q).inflated(margin.to_f64() + largest * (16.0 * f64::UNIT)).round_out()
            });
        }
        let vertices = &self.vertices.boxes;
        self.edges.boxes.resize(mesh.edges().len(), Aabb::EMPTY);
        threads.fill(&mut self.edges.boxes, |i| sweep::edge(i, mesh.edges(), vertices));
        self.faces.boxes.resize(mesh.faces().len(), Aabb::EMPTY);
        threads.fill(&mut self.faces.boxes, |i| sweep::face(i, mesh.faces(), vertices));
    }

    /// Refits all trees, or builds them if they never were or if one has become too loose. Returns whether they were built.
    fn fit(&mut self, threads: &Threads, mesh: &Mesh) -> bool {
        let Self { vertices, edges, faces, .. } = self;
        if self.built {
            let v = vertices.pyramid.refit(threads, &vertices.boxes);
            let e = edges.pyramid.refit(threads, &edges.boxes);
            let f = faces.pyramid.refit(threads, &faces.boxes);
            let height = vertices.pyramid.height().max(faces.pyramid.height());
            vertices.pyramid.raise(height);
            faces.pyramid.raise(height);
            if v.max(e).max(f) <= MAX_LOOSENESS {
                return false;
            }
        }
        self.built = true;
        vertices.pyramid.build(threads, &vertices.boxes);
        edges.pyramid.build(threads, &edges.boxes);
        faces.pyramid.build(threads, &faces.boxes);
        let height = vertices.pyramid.height().max(faces.pyramid.height());
        vertices.pyramid.raise(height);
        faces.pyramid.raise(height);
        edges.leaves.fill(threads, edges.pyramid.order(), mesh.edges());
        faces.leaves.fill(threads, faces.pyramid.order(), mesh.faces());
        true
    }

    /// Joins the workers' contacts in canonical order.
    fn collect(&mut self, threads: &Threads, report: &mut Report) {
        let start = Instant::now();
        let total: usize = self.workers.iter().map(|w| w.contacts.len()).sum();
        report.contacts.reserve(total);
        for worker in &mut self.workers {
            report.contacts.extend_from_slice(&worker.contacts);
            // Whichever worker finds them next time, there is room.
            worker.contacts.clear();
            worker.contacts.reserve(total + total / 8);
        }
        let key = |c: &Contact| (c.kind, c.a, c.b);
        threads.sort(&mut report.contacts, key);
        report.toi = self.workers.iter().filter_map(|w| w.toi).reduce(f64::min);
        report.undecided = report.contacts.iter().filter(|c| c.state == State::Undecided).count() as u64;
        report.times.narrow += milliseconds(start);
    }
}

/// Takes the workers' counts of one kind of pair into the report. If a sample came before, the last pass counts.
fn count(workers: &mut [Worker], report: &mut Report, kind: Kind) {
    *report.candidates.of(kind) = workers.iter().map(|w| w.n_candidates).sum();
    *report.filtered.of(kind) = workers.iter().map(|w| w.n_filtered).sum();
    workers.iter_mut().for_each(Worker::start_kind);
}

fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}
