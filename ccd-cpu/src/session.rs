//! A mesh stepped frame by frame: buffers and the order of trees are kept, trees are refitted or
//! rebuilt by a stated rule.

mod rules;

use crate::broad_phase::method::Method;
use crate::broad_phase::pair_list::{Lister, Pairs, Run, order_runs};
use crate::clock::{Instant, milliseconds};
use crate::step::candidates::Given;
use crate::step::codimensional::Codimensional;
use crate::step::contact_order::ContactOrder;
use crate::step::find::{expand, find};
use crate::step::narrow_phase::{CONTACTS, Worker};
use crate::step::prepare::{Positions, Prepared};
use crate::step::selection::Selection;
use crate::threads::Threads;
use ccd_core::Error;
use ccd_core::model::contact::Kind;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::positions::{AsPositions, Ends, Gathered, ends};
use ccd_core::model::report::Report;
use changes::check_pipeline;
use passes::{collect, detect, least_toi, prepare};
use std::sync::Arc;

mod changes;
mod intersections;
mod memory;
mod once;
mod passes;

pub use intersections::{Intersection, intersections};
pub use once::{Candidates, earliest_toi, step};

/// Continuous collision detection of one mesh over many steps.
///
/// Positions are whatever is [`AsPositions`]: slices, arrays and vectors of `[f32; 3]` or
/// `[f64; 3]`, bytes with a stride, posed bodies, vectors of `glam`. Between steps, the `set_`
/// functions change what a session was made with; the next step finds what a new session would.
///
/// ```
/// use ccd_core::model::mesh::Mesh;
/// use ccd_core::model::options::Options;
/// use ccd_cpu::Session;
/// use std::sync::Arc;
///
/// // Many sessions share one mesh.
/// let mesh = Arc::new(Mesh::new(4, &[[0, 1, 2]])?);
/// let mut sessions = Vec::new();
/// for _ in 0..100 {
///     sessions.push(Session::new(mesh.clone(), Options::default())?);
/// }
/// let before = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2]];
/// let mut after = before;
/// after[3][1] = -1.0;
/// for session in &mut sessions {
///     let report = session.step(&before, &after)?;
///     // The report has the mesh that its ids refer to, while it borrows the session.
///     let contact = report.contacts[0];
///     assert_eq!(report.mesh().faces()[contact.b as usize], [0, 1, 2]);
/// }
/// # Ok::<(), ccd_core::Error>(())
/// ```
#[derive(Debug)]
pub struct Session {
    mesh: Arc<Mesh>,
    options: Options,
    threads: Threads,
    /// Bytes held for the mesh, from above.
    of_mesh: u64,
    prepared: Prepared,
    selection: Selection,
    method: Method,
    workers: Vec<Worker>,
    listers: [Vec<Lister>; 2],
    runs: [Vec<Run>; 2],
    order: ContactOrder,
    codimensional: Option<Box<Codimensional>>,
    report: Report,
    gathered: Gathered,
}

impl Session {
    /// A session for `mesh`: a [`Mesh`], a reference to one, which is copied, or an `Arc` of one,
    /// which is shared.
    ///
    /// # Errors
    /// What [`Options::check`] refuses; [`Error::Method`] for what a CPU does not have;
    /// [`Error::Threads`]; [`Error::Memory`].
    pub fn new(mesh: impl Into<Arc<Mesh>>, options: Options) -> Result<Self, Error> {
        Self::of(mesh.into(), options)
    }

    #[inline(never)]
    fn of(mesh: Arc<Mesh>, options: Options) -> Result<Self, Error> {
        options.check(&mesh)?;
        let method = Method::new(options.broad_phase, options.scheduling)?;
        check_pipeline(&options)?;
        let mut threads = Threads::new(options.threads)?;
        let of_mesh = memory::for_mesh(&mesh, &options, threads.count());
        threads.stop = memory::stop(None, &options, of_mesh)?;
        let selection = Selection::new(&options)?;
        let mut prepared = Prepared::new(&mesh, &options);
        prepared.set_rules(&mesh, selection.rules.as_ref());
        Ok(Self {
            codimensional: threads.enter(|| Codimensional::new(&mesh, &options))?,
            prepared,
            selection,
            mesh,
            options,
            threads,
            of_mesh,
            method,
            workers: Vec::new(),
            listers: Default::default(),
            runs: Default::default(),
            order: ContactOrder::default(),
            report: Report::default(),
            gathered: Gathered::default(),
        })
    }

    /// The mesh of the next step. [`Report::mesh`] is that of the last one.
    pub fn mesh(&self) -> &Arc<Mesh> {
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

    /// What the last call found; empty if that ended with an error.
    pub fn report(&self) -> &Report {
        &self.report
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
    ///
    /// # Errors
    /// [`Error::VertexCount`] and [`Error::Coordinate`]; for positions that are no slices, what
    /// their type says; [`Error::FixedMoves`]; [`Error::CrowdedCells`] and [`Error::TooMany`] where
    /// a method was chosen that has such limits; [`Error::Memory`] and [`Error::Cancelled`]. The
    /// session stays usable, and its report is empty.
    pub fn step<A, B>(&mut self, x0: &A, x1: &B) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.run(ends(x0, x1), WHOLE, false)?;
        Ok(&self.report)
    }

    /// Every contact of a step up to time `t_max` in `[0, 1]`: as [`Session::step_window`] from 0.
    ///
    /// # Errors
    /// Those of [`Session::step_window`].
    pub fn step_until<A, B>(&mut self, x0: &A, x1: &B, t_max: f64) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.step_window(x0, x1, [0.0, t_max])
    }

    /// Every contact that exists at some time in a window `[t_a, t_b]` of a step, with times of
    /// impact in units of the whole step: the first such time at or after `t_a`. Boxes are swept
    /// for the window alone.
    ///
    /// # Errors
    /// [`Error::Window`] unless `0 <= t_a <= t_b <= 1`, besides those of [`Session::step`].
    pub fn step_window<A, B>(&mut self, x0: &A, x1: &B, window: [f64; 2]) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.run(ends(x0, x1), window, false)?;
        Ok(&self.report)
    }

    /// The earliest time of impact of the step, without the list of contacts: cheaper than
    /// [`Session::step`].
    ///
    /// It is not later than the earliest contact. `None`: the whole step is free.
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn earliest_toi<A, B>(&mut self, x0: &A, x1: &B) -> Result<Option<f64>, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.run(ends(x0, x1), WHOLE, true)?;
        Ok(self.report.toi)
    }

    /// How much of the step is certainly free of contact: 1 if all of it is, else
    /// [`Session::earliest_toi`], which may be 0.
    ///
    /// With [`Options::leave_contact`], "free" means for features that are in contact at the start
    /// and separate that they neither come nearer than at the start nor touch again. At the time
    /// itself there may be contact: what keeps some distance goes by
    /// [`scaled_toi`](ccd_core::model::toi::scaled_toi) of it.
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn collision_free_step_size<A, B>(&mut self, x0: &A, x1: &B) -> Result<f64, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        Ok(self.earliest_toi(x0, x1)?.unwrap_or(1.0))
    }

    /// Lists all candidates of the step: pairs of features whose swept boxes overlap, without those
    /// that share a vertex or that the bodies rule out.
    ///
    /// A step does not need this: it never lists them.
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn candidates<A, B>(&mut self, x0: &A, x1: &B) -> Result<Candidates<'_>, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.list(ends(x0, x1))?;
        let [vf, ee] = [0, 1].map(|k| Pairs::new(&self.runs[k], &self.listers[k]));
        let [ve, vv] = match &self.codimensional {
            Some(of) => of.pairs.each_ref().map(Vec::as_slice),
            None => [&[][..]; 2],
        };
        Ok(Candidates { vf, ee, ve, vv })
    }

    /// Lists candidates.
    #[inline(never)]
    fn list(&mut self, ends: Ends) -> Result<(), Error> {
        self.gather(ends, |this, given| this.list_given(given))
    }

    /// Finds contacts in a window of the step, or only the earliest time of impact.
    #[inline(never)]
    fn run(&mut self, ends: Ends, window: [f64; 2], earliest: bool) -> Result<(), Error> {
        clear(&mut self.report);
        let done = self.gather(ends, |this, given| this.run_given(given, window, earliest));
        if done.is_err() {
            clear(&mut self.report);
        }
        done
    }

    /// Works on positions as slices.
    fn gather(
        &mut self,
        ends: Ends,
        work: impl FnOnce(&mut Self, Given) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.threads.stop.begin()?;
        let mut gathered = std::mem::take(&mut self.gathered);
        let done = gathered.slices(ends).and_then(|given| work(self, given));
        self.gathered = gathered;
        done
    }

    fn list_given(&mut self, given: Given) -> Result<(), Error> {
        let x = Positions::new(&self.mesh, given, WHOLE)?;
        let Self {
            mesh,
            options,
            threads,
            prepared,
            selection,
            method,
            listers,
            runs,
            codimensional,
            ..
        } = self;
        let (threads, mesh, options, selection) = (&*threads, &*mesh, &*options, &*selection);
        threads.enter(|| {
            let stop = &*threads.stop;
            prepared.boxes(threads, mesh, options, &x)?;
            stop.check()?;
            prepared.leaves(threads, method, mesh, selection.rules.as_ref(), &x)?;
            let scene = prepared.scene((mesh, options), selection, &x, WHOLE, false, stop);
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
            stop.check()?;
            for (lists, runs) in listers.iter().zip(runs.iter_mut()) {
                order_runs(lists, runs);
            }
            match codimensional {
                Some(of) => of.list(threads, mesh, (options, selection), x.given),
                None => Ok(()),
            }
        })
    }

    fn run_given(&mut self, given: Given, window: [f64; 2], earliest: bool) -> Result<(), Error> {
        let mut x = Positions::new(&self.mesh, given, window)?;
        let Self {
            mesh,
            options,
            threads,
            prepared,
            method,
            workers,
            order,
            codimensional,
            report,
            ..
        } = self;
        let (threads, mesh, options, selection) = (&*threads, &*mesh, &*options, &self.selection);
        threads.enter(|| {
            let start = Instant::now();
            workers.resize_with(threads.count(), Worker::default);
            workers.iter_mut().for_each(Worker::reset);
            report.set_mesh(mesh);
            let stop = &*threads.stop;
            prepare(threads, prepared, method, mesh, (options, selection), &x, report)?;
            if earliest {
                // A part of the tasks first; what it finds bounds the time that matters. Smaller
                // boxes for that time are worth it if there are many candidates.
                detect(
                    threads,
                    method,
                    prepared,
                    &prepared.scene((mesh, options), selection, &x, window, false, stop),
                    SAMPLE,
                    workers,
                    report,
                );
                stop.check()?;
                let n_features = mesh.n_vertices() + mesh.edges().len() + mesh.faces().len();
                if let Some(bound) = least_toi(workers)
                    && report.candidates.total() * SAMPLE as u64
                        > CANDIDATES_PER_FEATURE * n_features as u64
                {
                    (x.until, x.again) = (bound, true);
                    prepare(threads, prepared, method, mesh, (options, selection), &x, report)?;
                }
            }
            detect(
                threads,
                method,
                prepared,
                &prepared.scene((mesh, options), selection, &x, window, !earliest, stop),
                1,
                workers,
                report,
            );
            stop.check()?;
            // The last that calls a filter: where that panics there are no contacts yet.
            let listed = Instant::now();
            if let Some(of) = codimensional {
                of.list(threads, mesh, (options, selection), x.given)?;
            }
            report.times.narrow += milliseconds(listed);
            collect(workers, report, stop)?;
            let joined = Instant::now();
            order.sort(threads, mesh, &mut report.contacts);
            if let Some(of) = codimensional {
                let [ve, vv] = of.pairs.each_ref().map(|pairs| pairs.len() as u64);
                (report.candidates.ve, report.candidates.vv) = (ve, vv);
                (report.filtered.ve, report.filtered.vv) = (ve, vv);
                let found = of.decide(threads, mesh, &options.search(window), x.given)?;
                if !stop.reserve(CONTACTS, &mut report.contacts, found.len()) {
                    return stop.check();
                }
                found.iter().for_each(|&contact| report.add(contact, !earliest));
            }
            report.times.narrow += milliseconds(joined);
            report.front = method.front();
            report.times.total = milliseconds(start);
            Ok(())
        })
    }
}

/// Empties a report, which keeps its buffer.
fn clear(report: &mut Report) {
    let mut contacts = std::mem::take(&mut report.contacts);
    contacts.clear();
    *report = Report::default();
    report.contacts = contacts;
}

/// All times of a step.
const WHOLE: [f64; 2] = [0.0, 1.0];
/// Of how many tasks one is sampled to bound the earliest time of impact.
const SAMPLE: usize = 64;
/// From this many candidates per feature on, sweeping all boxes again for a shorter time costs less
/// than it saves: both take some 25 ns each.
const CANDIDATES_PER_FEATURE: u64 = 2;
