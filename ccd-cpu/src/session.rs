//! A mesh stepped frame by frame: buffers and the order of trees are kept, trees are refitted or
//! rebuilt by a stated rule.

use crate::broad_phase::descent_times::DescentTimes;
use crate::broad_phase::method::Method;
use crate::broad_phase::pair_list::{Lister, Pairs, Run, order_runs};
use crate::clock::{Instant, milliseconds};
use crate::step::candidates::{Given, Scene};
use crate::step::contact_order::ContactOrder;
use crate::step::find::{expand, find};
use crate::step::narrow_phase::Worker;
use crate::step::prepare::{Positions, Prepared};
use crate::threads::Threads;
use ccd_core::model::contact::{Kind, PerKind, State};
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::precision::Points;
use ccd_core::model::report::{Report, TriangleCounts};
use ccd_core::{Coordinate, Error};
use std::time::Duration;

/// Continuous collision detection of one mesh over many steps.
#[derive(Debug)]
pub struct Session {
    mesh: Mesh,
    options: Options,
    threads: Threads,
    prepared: Prepared,
    method: Method,
    workers: Vec<Worker>,
    listers: [Vec<Lister>; 2],
    runs: [Vec<Run>; 2],
    order: ContactOrder,
    report: Report,
}

impl Session {
    /// A session for `mesh`.
    pub fn new(mesh: Mesh, options: Options) -> Result<Self, Error> {
        options.check(&mesh)?;
        let method = Method::new(options.broad_phase, options.scheduling)?;
        if let Some(name) = options.pipeline.lacking("cpu") {
            return Err(Error::Method { name, backend: "cpu" });
        }
        let threads = Threads::new(options.threads)?;
        Ok(Self {
            prepared: Prepared::new(&mesh, &options),
            mesh,
            options,
            threads,
            method,
            workers: Vec::new(),
            listers: Default::default(),
            runs: Default::default(),
            order: ContactOrder::default(),
            report: Report::default(),
        })
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

    /// From now on, whether the clock is asked where the time of descents goes, which costs time
    /// itself: two looks for every list of pairs that is expanded.
    pub fn set_timed(&mut self, timed: bool) {
        self.method.set_timed(timed);
    }

    /// Where it went since [`Session::set_timed`]: if a scheduler was chosen, by
    /// [`Options::scheduling`], that is not the default's.
    pub fn descent_times(&self) -> Option<DescentTimes> {
        self.method.descent_times()
    }

    /// Takes what the last step found out of the session.
    #[inline(never)]
    fn into_report(self) -> Report {
        self.report
    }

    /// Every contact while vertices move on straight lines from `x0` to `x1`, one position per
    /// vertex of the mesh.
    ///
    /// After the first steps, nothing is allocated unless there are more contacts than before.
    pub fn step<T: Coordinate>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<&Report, Error> {
        self.run(T::slices::<Points, 2>([x0, x1]), false)?;
        Ok(&self.report)
    }

    /// The earliest time of impact of the step, without the list of contacts: cheaper than
    /// [`Session::step`].
    ///
    /// It is not later than the earliest contact. `None`: the whole step is free.
    pub fn earliest_toi<T: Coordinate>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
    ) -> Result<Option<f64>, Error> {
        self.run(T::slices::<Points, 2>([x0, x1]), true)?;
        Ok(self.report.toi)
    }

    /// Lists all candidates of the step: pairs of features whose swept boxes overlap, without those
    /// that share a vertex or that the bodies rule out.
    ///
    /// A step does not need this: it never lists them.
    pub fn candidates<T: Coordinate>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
    ) -> Result<Candidates<'_>, Error> {
        self.list(T::slices::<Points, 2>([x0, x1]))?;
        let [vf, ee] = [0, 1].map(|k| Pairs::new(&self.runs[k], &self.listers[k]));
        Ok(Candidates { vf, ee })
    }

    /// Lists candidates.
    #[inline(never)]
    fn list(&mut self, given: Given) -> Result<(), Error> {
        let x = Positions::new(&self.mesh, given)?;
        let Self { mesh, options, threads, prepared, method, listers, runs, .. } = self;
        let (threads, mesh, options) = (&*threads, &*mesh, &*options);
        threads.enter(|| {
            prepared.boxes(threads, mesh, options, &x)?;
            prepared.leaves(threads, method, mesh, options.bodies.as_ref(), &x)?;
            let scene = prepared.scene(mesh, options, &x, false);
            for (kind, lists) in
                [Kind::VertexFace, Kind::EdgeEdge].into_iter().zip(listers.iter_mut())
            {
                lists.resize_with(threads.count(), Lister::default);
                lists.iter_mut().for_each(Lister::clear);
                if prepared.triangles.is_some() {
                    expand(Some(kind), threads, method, prepared, &scene, 1, lists);
                } else {
                    find(kind, threads, method, prepared, &scene, 1, lists);
                }
            }
            for (lists, runs) in listers.iter().zip(runs.iter_mut()) {
                order_runs(lists, runs);
            }
            Ok(())
        })
    }

    /// Finds contacts, or only the earliest time of impact.
    #[inline(never)]
    fn run(&mut self, given: Given, earliest: bool) -> Result<(), Error> {
        let mut x = Positions::new(&self.mesh, given)?;
        let Self { mesh, options, threads, prepared, method, workers, order, report, .. } = self;
        let (threads, mesh, options) = (&*threads, &*mesh, &*options);
        threads.enter(|| {
            let start = Instant::now();
            workers.resize_with(threads.count(), Worker::default);
            workers.iter_mut().for_each(Worker::reset);
            report.contacts.clear();
            report.times = Default::default();
            prepare(threads, prepared, method, mesh, options, &x, report)?;
            if earliest {
                // A part of the tasks first; what it finds bounds the time that matters. Smaller
                // boxes for that time are worth it if there are many candidates.
                detect(
                    threads,
                    method,
                    prepared,
                    &prepared.scene(mesh, options, &x, false),
                    SAMPLE,
                    workers,
                    report,
                );
                let n_features = mesh.n_vertices() + mesh.edges().len() + mesh.faces().len();
                if let Some(bound) = least_toi(workers)
                    && report.candidates.total() * SAMPLE as u64
                        > CANDIDATES_PER_FEATURE * n_features as u64
                {
                    x.until = bound;
                    prepare(threads, prepared, method, mesh, options, &x, report)?;
                }
            }
            detect(
                threads,
                method,
                prepared,
                &prepared.scene(mesh, options, &x, !earliest),
                1,
                workers,
                report,
            );
            collect(workers, report);
            let joined = Instant::now();
            order.sort(threads, mesh, &mut report.contacts);
            report.times.narrow += milliseconds(joined);
            report.front = method.front();
            report.times.total = milliseconds(start);
            Ok(())
        })
    }
}

/// Candidates of a step; see [`Session::candidates`].
#[derive(Clone, Copy, Debug)]
pub struct Candidates<'a> {
    /// Vertex, face.
    pub vf: Pairs<'a>,
    /// Two edges, the lesser id first.
    pub ee: Pairs<'a>,
}

/// Every contact of one step, with no session to keep: see [`Session::step`].
pub fn step<T: Coordinate>(
    mesh: &Mesh,
    x0: &[[T; 3]],
    x1: &[[T; 3]],
    options: &Options,
) -> Result<Report, Error> {
    let mut session = Session::new(mesh.clone(), options.clone())?;
    session.step(x0, x1)?;
    Ok(session.into_report())
}

/// The earliest time of impact of one step: see [`Session::earliest_toi`].
pub fn earliest_toi<T: Coordinate>(
    mesh: &Mesh,
    x0: &[[T; 3]],
    x1: &[[T; 3]],
    options: &Options,
) -> Result<Option<f64>, Error> {
    Session::new(mesh.clone(), options.clone())?.earliest_toi(x0, x1)
}

/// Of how many tasks one is sampled to bound the earliest time of impact.
const SAMPLE: usize = 64;
/// From this many candidates per feature on, sweeping all boxes again for a shorter time costs less
/// than it saves: both take some 25 ns each.
const CANDIDATES_PER_FEATURE: u64 = 2;

/// Boxes and trees of a step up to the time that matters.
fn prepare(
    threads: &Threads,
    prepared: &mut Prepared,
    method: &mut Method,
    mesh: &Mesh,
    options: &Options,
    x: &Positions,
    report: &mut Report,
) -> Result<(), Error> {
    let start = Instant::now();
    prepared.boxes(threads, mesh, options, x)?;
    report.times.boxes += milliseconds(start);
    let start = Instant::now();
    let rebuilt = prepared.leaves(threads, method, mesh, options.bodies.as_ref(), x)?;
    report.rebuilt = rebuilt || (report.rebuilt && !x.whole());
    report.times.build += milliseconds(start);
    Ok(())
}

/// The least time of impact that any worker found.
fn least_toi(workers: &[Worker]) -> Option<f64> {
    workers.iter().filter_map(|w| w.toi).reduce(f64::min)
}

/// Finds and decides all candidates, or those of every `part`-th task.
fn detect(
    threads: &Threads,
    method: &mut Method,
    prepared: &Prepared,
    scene: &Scene,
    part: usize,
    workers: &mut [Worker],
    report: &mut Report,
) {
    let start = Instant::now();
    let narrow = |workers: &[Worker]| workers.iter().map(|w| w.narrow).sum::<Duration>();
    let before = narrow(workers);
    // If a sample came before, the last pass counts.
    workers.iter_mut().for_each(Worker::restart_counts);
    if prepared.triangles.is_some() {
        expand(None, threads, method, prepared, scene, part, workers);
    } else {
        find(Kind::VertexFace, threads, method, prepared, scene, part, workers);
        find(Kind::EdgeEdge, threads, method, prepared, scene, part, workers);
    }
    count(workers, report, prepared.triangles.is_some());
    let narrow = (narrow(workers) - before).as_secs_f64() * 1e3 / threads.count() as f64;
    report.times.narrow += narrow;
    report.times.traverse += (milliseconds(start) - narrow).max(0.0);
}

/// Adds up what the workers counted.
fn count(workers: &[Worker], report: &mut Report, triangles: bool) {
    let (mut candidates, mut filtered) = (PerKind::default(), PerKind::default());
    let mut counts = TriangleCounts::default();
    for worker in workers {
        candidates = candidates.plus(worker.candidates);
        filtered = filtered.plus(worker.filtered);
        counts = counts.plus(worker.triangles);
    }
    (report.candidates, report.filtered) = (candidates, filtered);
    report.triangles = triangles.then_some(counts);
}

/// Joins the workers' contacts.
fn collect(workers: &mut [Worker], report: &mut Report) {
    let start = Instant::now();
    let total: usize = workers.iter().map(|w| w.contacts.len()).sum();
    report.contacts.reserve(total);
    for worker in workers.iter_mut() {
        report.contacts.extend_from_slice(&worker.contacts);
        // Whichever worker finds them next time, there is room.
        worker.contacts.clear();
        worker.contacts.reserve(total + total / 8);
    }
    report.toi = least_toi(workers);
    report.undecided =
        report.contacts.iter().filter(|c| c.state == State::Undecided).count() as u64;
    report.times.narrow += milliseconds(start);
}
