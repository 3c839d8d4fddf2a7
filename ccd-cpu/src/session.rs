//! A mesh stepped frame by frame: buffers and the order of trees are kept, trees are refitted or
//! rebuilt by a stated rule.

#[cfg(feature = "catalogue")]
use crate::broad_phase::descent_times::DescentTimes;
use crate::broad_phase::method::Method;
use crate::broad_phase::pair_list::{Lister, Pairs, Run, order_runs};
use crate::clock::{Instant, milliseconds};
use crate::step::candidates::{Given, Scene};
use crate::step::codimensional::Codimensional;
use crate::step::contact_order::ContactOrder;
use crate::step::find::find;
use crate::step::narrow_phase::{CONTACTS, Worker};
use crate::step::positions::Positions;
use crate::step::prepare::Prepared;
use crate::step::selection::Selection;
use crate::stop::Stop;
use crate::threads::Threads;
use ccd_core::backend::layout::Pair;
use ccd_core::model::cancel::CancelToken;
use ccd_core::model::contact::Kind;
use ccd_core::model::decision::Decider;
use ccd_core::model::options::Options;
use ccd_core::model::report::Report;
use ccd_core::model::session::{self, Ask, Change, Intersection, Intersects, Kept, Moved, State};
use ccd_core::{Error, Real};
use passes::{collect, detect, drop_repeated, ends, first_contact, prepare, swept_until};
use std::sync::Arc;

mod candidate_set;
mod changes;
mod intersections;
mod memory;
mod once;
mod passes;

pub use candidate_set::CandidateSet;
pub use intersections::{has_intersections, intersections};
pub use once::{earliest_toi, step};

/// Continuous collision detection of one mesh over many steps, on threads of this machine. All
/// calls but those of [`Engine`] are [those of every backend](session::Session).
///
/// ```
/// use ccd::{Mesh, Options, Session};
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
/// # Ok::<(), ccd::Error>(())
/// ```
///
/// Between steps a session may go on with another mesh or other options, and have its calls ended
/// by another thread.
///
/// ```
/// use ccd::{CancelToken, Error, Mesh, Options, Session};
///
/// let mut session = Session::new(Mesh::new(3, &[[0, 1, 2]])?, Options::default())?;
/// session.set_mesh(Mesh::new(4, &[[0, 1, 2], [2, 1, 3]])?)?;
/// let x = [[0.0; 3]; 4];
/// assert_eq!(session.step(&x, &x)?.mesh().n_vertices(), 4);
///
/// session.set_options(session.options().clone().with_threads(1))?;
/// assert_eq!(session.threads(), 1);
///
/// let token = CancelToken::new();
/// session.set_cancel_token(token.clone());
/// std::thread::spawn(move || token.cancel()).join().unwrap();
/// assert_eq!(session.step(&x, &x).err(), Some(Error::Cancelled));
/// session.set_cancel_token(None);
/// assert!(session.step(&x, &x).is_ok());
/// # Ok::<(), Error>(())
/// ```
pub type Session = session::Session<Engine>;

/// Candidates of a step, lent by the session, in an order that no thread changes.
///
/// ```
/// use ccd::{Mesh, Options, Session};
///
/// let mut session = Session::new(Mesh::new(4, &[[0, 1, 2]])?, Options::default())?;
/// let x = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.0, 0.2]];
/// let candidates = session.candidates(&x, &x)?;
/// assert_eq!((candidates.vf.len(), candidates.ee.len()), (1, 0));
/// # Ok::<(), ccd::Error>(())
/// ```
pub type Candidates<'a> = session::Candidates<Pairs<'a>, &'a [Pair]>;

/// What a [`Session`] has on a CPU.
#[derive(Debug)]
pub struct Engine {
    state: State,
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
    /// Whether the last step was little work, see [`LITTLE`].
    is_light: bool,
}

impl session::Engine for Engine {
    type On = ();
    type Error = Error;
    type Candidates<'a> = Candidates<'a>;

    fn new((): &(), state: State) -> Result<Self, Error> {
        let State { mesh, options, .. } = &state;
        options.check_backend("cpu")?;
        let method = Method::new(options.broad_phase, options.scheduling)?;
        let mut threads = Threads::new(options.threads)?;
        let of_mesh = memory::for_mesh(mesh, options, threads.count());
        threads.stop = memory::stop(None, options, of_mesh)?;
        let selection = Selection::new(options)?;
        let mut prepared = Prepared::new(mesh, options);
        prepared.set_rules(selection.rules.as_ref());
        Ok(Self {
            codimensional: threads.enter(|| Codimensional::new(mesh, options))?,
            prepared,
            selection,
            state,
            threads,
            of_mesh,
            method,
            workers: Vec::new(),
            listers: Default::default(),
            runs: Default::default(),
            order: ContactOrder::default(),
            is_light: false,
        })
    }

    fn state(&self) -> &State {
        &self.state
    }

    fn kept(&mut self) -> &mut Kept {
        &mut self.state.kept
    }

    fn clear(&mut self) {
        self.state.report.clear();
    }

    fn find(&mut self, given: Given, mut moved: Option<Moved>, ask: Ask) -> Result<(), Error> {
        self.clear();
        let x = Positions::new(given, ask.window());
        self.within_limit(|engine| engine.run(Positions { moved: moved.take(), ..x }, ask))
    }

    fn candidates(&mut self, given: Given) -> Result<Candidates<'_>, Error> {
        if let Err(why) = self.within_limit(|engine| engine.list(given, None)) {
            self.clear();
            return Err(why);
        }
        Ok(self.listed())
    }

    fn change(&mut self, change: Change) -> Result<(), Error> {
        self.is_light = false;
        match change {
            Change::Mesh(mesh, options) => self.set_mesh(mesh, options),
            Change::Bodies(bodies) => self.set_bodies(bodies),
            Change::MinDistance(distance) => self.set_min_distance(distance),
            Change::Filter(filter) => {
                self.selection.filter = filter;
                Ok(())
            }
        }
    }

    fn set_cancel_token(&mut self, token: Option<CancelToken>) {
        let limit = self.state.options.max_memory;
        self.threads.stop = Arc::new(Stop::new(token, limit, self.threads.stop.held()));
    }

    fn cancel_token(&self) -> Option<&CancelToken> {
        self.threads.stop.token()
    }
}

impl Intersects for Engine {
    fn intersections(&mut self, given: Given, first: bool) -> Result<Vec<Intersection>, Error> {
        self.find_intersections(given, first)
    }
}

impl Engine {
    /// What was listed last.
    fn listed(&self) -> Candidates<'_> {
        let lists = [0, 1].map(|k| Pairs::new(&self.runs[k], &self.listers[k]));
        let codimensional = self.codimensional.as_ref();
        let pairs = codimensional.map(|found| found.pairs.each_ref().map(Vec::as_slice));
        Candidates::new(lists, pairs.unwrap_or_default())
    }

    /// The report, for an engine over this one.
    #[doc(hidden)]
    pub fn report_mut(&mut self) -> &mut Report {
        &mut self.state.report
    }

    /// Number of threads that steps use; one in which little happens uses the calling one alone.
    pub fn threads(&self) -> usize {
        self.threads.count()
    }

    #[cfg(feature = "catalogue")]
    #[doc(hidden)]
    /// From now on, whether the clock is asked where the time of descents goes, which costs time
    /// itself: two looks for every list of pairs that is expanded.
    pub fn set_timed(&mut self, timed: bool) {
        if let Method::Scheduled(source) = &mut self.method {
            source.set_timed(timed);
        }
    }

    #[cfg(feature = "catalogue")]
    #[doc(hidden)]
    /// Where it went since [`Engine::set_timed`]: if a scheduler was chosen, by
    /// [`Options::scheduling`](ccd_core::model::options::Options::scheduling), that is not the
    /// default's.
    pub fn descent_times(&self) -> Option<DescentTimes> {
        match &self.method {
            Method::Scheduled(source) => source.times(),
            _ => None,
        }
    }

    #[cfg(feature = "catalogue")]
    #[doc(hidden)]
    /// Milliseconds in which the last step put its contacts in their order.
    pub fn order_ms(&self) -> f64 {
        self.order.ms
    }

    /// Lists candidates; `wide`: by other options than the session's.
    #[inline(never)]
    fn list(&mut self, given: Given, wide: Option<&Options>) -> Result<(), Error> {
        let x = Positions::new(given, WHOLE);
        let Self { state, threads, prepared, selection, method, listers, runs, .. } = self;
        let (State { mesh, options, .. }, codimensional) = (state, &mut self.codimensional);
        let options = wide.unwrap_or(options);
        let (threads, mesh, selection) = (&*threads, &*mesh, &*selection);
        threads.enter(|| {
            let stop = &*threads.stop;
            prepared.boxes(threads, options, &x)?;
            stop.check()?;
            prepared.leaves(threads, method, (mesh, options), selection.rules.as_ref(), &x)?;
            let scene = prepared.scene((mesh, options), selection, &x, WHOLE, false, stop);
            for (kind, lists) in
                [Kind::VertexFace, Kind::EdgeEdge].into_iter().zip(listers.iter_mut())
            {
                lists.resize_with(threads.count(), Lister::default);
                lists.iter_mut().for_each(Lister::clear);
                find(Some(kind), threads, method, prepared, &scene, 1, lists);
            }
            stop.check()?;
            for (lists, runs) in listers.iter().zip(runs.iter_mut()) {
                order_runs(lists, runs);
            }
            match codimensional {
                Some(features) => features.list(threads, mesh, (options, selection), x.given),
                None => Ok(()),
            }
        })
    }

    #[inline(never)]
    fn run(&mut self, mut x: Positions, ask: Ask) -> Result<(), Error> {
        let (window, earliest) = ([x.from, x.until], !matches!(ask, Ask::Contacts { .. }));
        let Self { state, threads, prepared, method, workers, order, codimensional, .. } = self;
        let State { mesh, options, report, .. } = state;
        workers.resize_with(threads.count(), Worker::default);
        let n_moving = match x.moved.filter(|moved| prepared.precedes(moved)) {
            Some(moved) => moved.runs.iter().map(|run| run.len()).sum(),
            None => mesh.n_vertices(),
        };
        let is_light = std::mem::take(&mut self.is_light) && n_moving <= FEW;
        let is_light = is_light && codimensional.is_none() && prepared.keeps_rest(method);
        let alone = is_light.then(|| threads.alone());
        let threads = alone.as_ref().unwrap_or(threads);
        let (mesh, options, selection) = (&*mesh, &*options, &self.selection);
        let is_light = &mut self.is_light;
        threads.enter(|| {
            let start = Instant::now();
            workers.iter_mut().for_each(Worker::reset);
            report.set_mesh(mesh);
            let stop = &*threads.stop;
            prepare(threads, prepared, method, mesh, (options, selection), &x, report)?;
            let mut latest = 1.0f32;
            if earliest {
                // A part of the tasks first; what it finds bounds the time that matters. Boxes and
                // trees of that time are made if they cost less than the pairs that they spare.
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
                let work = report.candidates.total() + PER_DECISION * report.filtered.total();
                if let Some(first) = first_contact(workers) {
                    let is_plain = codimensional.is_none() && method.front().is_none();
                    if first.toi <= 0.0 && ask == (Ask::Earliest { whose: false }) && is_plain {
                        // Nothing is earlier.
                        report.toi = Some(first.toi);
                        *is_light = is_little(work * SAMPLE as u64, workers);
                        report.times.total = milliseconds(start);
                        return Ok(());
                    }
                    let until = swept_until(first.toi, options);
                    if work * SAMPLE as u64 > PER_BOX * prepared.n_swept(mesh) as u64 {
                        (x.until, x.again) = (until, true);
                        prepare(threads, prepared, method, mesh, (options, selection), &x, report)?;
                    } else {
                        // Then what the filters look at is the whole step.
                        debug_assert!(x.whole());
                        latest = until.round_up();
                    }
                }
            }
            ends(threads, prepared, method, options, &x, report);
            let scene = prepared.scene((mesh, options), selection, &x, window, !earliest, stop);
            let scene = Scene { latest, ..scene };
            detect(threads, method, prepared, &scene, 1, workers, report);
            stop.check()?;
            // The last that calls a filter: where that panics there are no contacts yet.
            let listed = Instant::now();
            if let Some(features) = codimensional {
                features.list(threads, mesh, (options, selection), x.given)?;
            }
            report.times.narrow += milliseconds(listed);
            collect(threads, mesh, workers, order, report)?;
            let joined = Instant::now();
            if options.pipeline.repeats_tests() {
                drop_repeated(report);
            }
            if let Some(features) = codimensional {
                let [ve, vv] = features.pairs.each_ref().map(|pairs| pairs.len() as u64);
                (report.candidates.ve, report.candidates.vv) = (ve, vv);
                (report.filtered.ve, report.filtered.vv) = (ve, vv);
                let decider = Decider::new(options, window);
                let found = features.decide(threads, mesh, &decider, x.given)?;
                if !stop.reserve(CONTACTS, &mut report.contacts, found.len()) {
                    return stop.check();
                }
                found.iter().for_each(|&contact| report.add(contact, !earliest));
            }
            report.times.narrow += milliseconds(joined);
            report.front = method.front();
            report.times.total = milliseconds(start);
            let work = report.candidates.total() + PER_DECISION * report.filtered.total();
            *is_light = is_little(work, workers);
            Ok(())
        })
    }
}

/// A step by the default method runs in the calling thread if at most so many vertices move in it
/// and in the one before, together, which was at most [`LITTLE`] work: others cost more to wake.
const FEW: usize = 1024;
/// In what any candidate costs.
const LITTLE: u64 = 8192;

fn is_little(work: u64, workers: &[Worker]) -> bool {
    work <= LITTLE && workers.iter().all(|worker| worker.n_open == 0)
}

/// All times of a step.
const WHOLE: [f64; 2] = [0.0, 1.0];
/// Of how many tasks one is sampled to bound the earliest time of impact.
const SAMPLE: usize = 64;
/// What a candidate costs that filters leave, in what any candidate costs, some 25 ns.
const PER_DECISION: u64 = 16;
/// What a box costs that is swept again, refitted and compared, in the same.
const PER_BOX: u64 = 2;
