//! A mesh stepped frame by frame on a device: what callers ask, what they get, and what the CPU
//! decides of it.

use crate::broad_phase::worker_counts::WorkerCounts;
use crate::clock::Instant;
use crate::device::Device;
use crate::error::Error;
use crate::recorder::Timing;
use crate::step::Goal;
use crate::step::codimensional::Codimensional;
use crate::step::cpu_fallback::{self, Host};
use crate::step::frame::{Found, Frames};
use crate::step::upload::Input;
use ccd_core::backend::layout::Pair;
use ccd_core::model::cancel::CancelToken;
use ccd_core::model::contact::PerKind;
use ccd_core::model::decision::Decider;
use ccd_core::model::options::Mode;
use ccd_core::model::positions::Gathered;
use ccd_core::model::precision::{Given, Precision};
use ccd_core::model::report::Report;
use ccd_core::model::session::{self, Ask, Change, Kept, Moved, On, State};
use ccd_core::model::toi::toi_to_f32;
use ccd_core::narrow_phase::decide;
use in_flight::{Copied, Flight, Sought};
use std::task::{Context, Poll, ready};

mod changes;
mod in_flight;
mod on_device;

pub use on_device::{GeometryOnDevice, OnDevice};

/// Continuous collision detection of one mesh over many steps, on a GPU. All calls but those of
/// [`Engine`] are [those of every backend](session::Session). Of a report's times, `total` is wall
/// clock; stages are in [`Engine::stages`].
///
/// ```no_run
/// use ccd::{Mesh, Options};
/// use ccd::gpu::{Device, DeviceOptions, Session};
///
/// let device = Device::open(&DeviceOptions::default())?;
/// let mesh = Mesh::new(4, &[[0, 1, 2]])?;
/// let mut session = Session::new(&device, mesh, Options::default())?;
/// let report = session.step(&[[0.0f32; 3]; 4], &[[1.0; 3]; 4])?;
/// println!("{} contacts of {:?}", report.contacts.len(), report.mesh());
/// # Ok::<(), ccd::gpu::Error>(())
/// ```
pub type Session = session::Session<Engine, On<Device>>;

/// Candidates of a step: pairs of features whose swept boxes overlap, in no order.
///
/// ```no_run
/// use ccd::gpu::{Error, Session};
///
/// fn most(session: &mut Session, x: &[[f32; 3]]) -> Result<usize, Error> {
///     let mut candidates = session.candidates(x, x)?;
///     // In no order; sorted they are those of a CPU.
///     candidates.vf.sort_unstable();
///     Ok(candidates.vf.len().max(candidates.ee.len()))
/// }
/// # let _ = most;
/// ```
pub type Candidates = session::Candidates<Vec<Pair>>;

/// What a [`Session`] has on a GPU.
pub struct Engine {
    device: Device,
    state: State,
    frames: Frames,
    codimensional: Option<Codimensional>,
    left_open: PerKind,
    /// The step in flight.
    flight: Option<Flight>,
    /// Its positions, if it was submitted.
    copied: Copied,
    /// Buffers for positions that are no slices, of calls that do not block, and for those of
    /// chosen vertices.
    gathered: Gathered,
}

impl session::Engine for Engine {
    type On = Device;
    type Error = Error;
    type Candidates<'a> = Candidates;

    fn new(device: &Device, mut state: State) -> Result<Self, Error> {
        state.options = changes::of_device(state.options);
        let State { mesh, options, .. } = &state;
        changes::check(options)?;
        let device = device.limited(options.max_memory);
        Ok(Self {
            frames: Frames::new(&device, mesh, options)?,
            codimensional: Codimensional::new(&device, mesh, options)?,
            device,
            state,
            left_open: PerKind::default(),
            flight: None,
            copied: Copied::default(),
            gathered: Gathered::default(),
        })
    }

    fn state(&self) -> &State {
        &self.state
    }

    fn kept(&mut self) -> &mut Kept {
        &mut self.state.kept
    }

    fn clear(&mut self) {
        self.abandon();
        if !self.state.report.contacts.is_empty() {
            self.frames.spare = std::mem::take(&mut self.state.report.contacts);
        }
        self.state.report.clear();
        self.left_open = PerKind::default();
        self.frames.stages.clear();
        self.frames.geometry.listed = false;
    }

    fn find(&mut self, given: Given, moved: Option<Moved>, ask: Ask) -> Result<(), Error> {
        let (device, sought) = (self.device.clone(), self.sought(ask));
        device.block_on(self.run(Input::new(given, moved), sought))
    }

    fn candidates(&mut self, given: Given) -> Result<Candidates, Error> {
        let device = self.device.clone();
        device.block_on(self.list(given)).inspect_err(|_| self.clear())
    }

    fn change(&mut self, change: Change) -> Result<(), Error> {
        match change {
            Change::Mesh(mesh, options) => self.take_mesh(mesh, options),
            Change::Bodies(bodies) => self.take_bodies(bodies),
            Change::MinDistance(distance) => self.take_min_distance(distance),
            Change::Filter(None) => Ok(()),
            Change::Filter(Some(_)) => Err(ccd_core::Error::Filter { backend: "gpu" }.into()),
        }
    }

    fn set_cancel_token(&mut self, token: Option<CancelToken>) {
        self.frames.cancel = token;
    }

    fn cancel_token(&self) -> Option<&CancelToken> {
        self.frames.cancel.as_ref()
    }
}

impl Engine {
    /// Goes on with another device, after the last one was lost.
    ///
    /// # Errors
    /// What the device refuses; then the session stays on the one that it has.
    pub fn move_to(&mut self, device: &Device) -> Result<(), Error> {
        self.abandon();
        let device = device.limited(self.state.options.max_memory);
        let codimensional = Codimensional::new(&device, &self.state.mesh, &self.state.options)?;
        self.frames.move_to(&device, &self.state.mesh, &self.state.options)?;
        self.codimensional = codimensional;
        self.device = device;
        Ok(())
    }

    /// Makes all buffers anew after a command has failed late: they may be none.
    fn mend(&mut self) -> Result<(), Error> {
        let device = self.device.clone();
        device.mend(|| self.move_to(&device))
    }

    /// The report, for an engine over this one.
    #[doc(hidden)]
    pub fn report_mut(&mut self) -> &mut Report {
        &mut self.state.report
    }

    /// The device.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// What each call times on the device from now on.
    ///
    /// # Errors
    /// What the device refuses. Where it has no timestamps, nothing is timed.
    pub fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
        self.abandon();
        self.frames.bench.set_timing(timing)
    }

    /// Milliseconds on the device, from the first kernel to the last: of each stage or of all
    /// together.
    pub fn stages(&self) -> &[(&'static str, f64)] {
        &self.frames.stages
    }

    /// What each worker did in the last call, those of one kind of pairs after those of the other;
    /// empty where the scheduler has no workers.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn worker_counts(&mut self) -> Result<Vec<WorkerCounts>, Error> {
        self.abandon();
        self.frames.worker_counts(&self.device)
    }

    /// Pairs of the last call that the device left open and the CPU decided.
    pub fn left_open(&self) -> PerKind {
        self.left_open
    }

    /// How often a list was too short since the session began, so that a frame ran again.
    pub fn grown(&self) -> u32 {
        self.frames.grown
    }

    /// Gives every list this capacity: a smaller one makes the next step grow it, a larger one
    /// spares it that.
    ///
    /// # Errors
    /// [`Error::TooLarge`] and [`Error::OutOfMemory`].
    pub fn reserve(&mut self, entries: u32) -> Result<(), Error> {
        self.abandon();
        self.frames.reserve(&self.device, entries)
    }

    async fn list(&mut self, given: Given<'_>) -> Result<Candidates, Error> {
        self.run(Input::new(given, None), Sought::CANDIDATES).await?;
        let count = self.state.report.candidates;
        let lists = self.frames.read_candidates(&self.device, count).await?;
        let codimensional = self.codimensional.as_ref().map(|found| found.pairs.clone());
        Ok(Candidates::new(lists, codimensional.unwrap_or_default()))
    }

    /// What the device looks for.
    fn sought(&mut self, ask: Ask) -> Sought {
        let every = self.state.options.tolerance < 1e-7;
        let goal = match ask {
            Ask::Earliest { .. } if !every => self.frames.goal_of_earliest(),
            _ => Goal::Contacts,
        };
        Sought { goal, window: ask.window(), lists: !matches!(ask, Ask::Earliest { .. }) }
    }

    /// Sends positions and submits a frame; [`Engine::advance`] then makes the report.
    #[inline(never)]
    fn begin(&mut self, input: Input, sought: Sought) -> Result<(), Error> {
        let Input { given, moved, chosen } = input;
        self.abandon();
        self.mend()?;
        let State { mesh, options, .. } = &self.state;
        let known = moved.filter(|&moved| self.frames.buffers.positions.follows(moved));
        // The caller of `find_chosen` has checked its vertices.
        if let Some(rules) = self.frames.buffers.rules.as_ref().filter(|_| chosen.is_none()) {
            let runs = known.map(|moved| moved.runs);
            match given {
                Precision::F32([x0, x1]) => rules.check_still(x0, x1, runs),
                Precision::F64([x0, x1]) => rules.check_still(x0, x1, runs),
            }?;
        }
        let start = Instant::now();
        self.device.check_lost()?;
        self.frames.upload(&self.device, mesh, input, options.min_distance)?;
        session::Engine::clear(self);
        let State { mesh, options, report, .. } = &mut self.state;
        report.set_mesh(mesh);
        let uploaded = start.elapsed();
        let Sought { goal, window, .. } = sought;
        // Exact times are not the device's.
        let exact = options.mode == Mode::Exact && goal.is_earliest();
        let on_device = if exact { Goal::Contacts } else { goal };
        self.frames.begin(&self.device, options, (on_device, window))?;
        self.flight = Some(Flight { sought, start, uploaded, is_copied: false });
        Ok(())
    }

    /// Makes the report, if the device is done. `input`: the positions of the step in flight.
    #[inline(never)]
    fn advance(&mut self, input: Input, context: &mut Context) -> Poll<Result<(), Error>> {
        let Some(flight) = &self.flight else { return Poll::Ready(Err(Error::NotSubmitted)) };
        let &Flight { sought: Sought { goal, window, lists }, start, uploaded, .. } = flight;
        let State { options, report, .. } = &mut self.state;
        let contacts = &mut report.contacts;
        let found = ready!(self.frames.poll(&self.device, options, contacts, context));
        self.flight = None;
        let found = found?;
        report.times.boxes = uploaded.as_secs_f64() * 1e3;
        // Contacts that the device could not certify.
        let leaves = !found.summary.undecided.is_empty();
        match input.chosen {
            Some(chosen) if leaves => {
                let mut gathered = std::mem::take(&mut self.gathered);
                let given = gathered.choose(input.given, chosen.vertices);
                self.take(found, (goal, window), given);
                self.gathered = gathered;
            }
            _ => self.take(found, (goal, window), input.given),
        }
        self.take_codimensional((goal, window), input.given)?;
        let report = &mut self.state.report;
        report.times.total = start.elapsed().as_secs_f64() * 1e3;
        if !lists {
            report.contacts.clear();
            report.undecided = 0;
        }
        Poll::Ready(Ok(()))
    }

    /// Decides what the device left open, and makes the report.
    fn take(&mut self, mut found: Found, (goal, window): (Goal, [f64; 2]), given: Given) {
        let State { mesh, options, report, .. } = &mut self.state;
        let decider = &Decider::new(options, window);
        let contacts = &mut report.contacts;
        // By a minimum distance in `f64` the host would find no more.
        let is_left = options.min_distance == 0.0 || !self.device.info().wide;
        report.rebuilt = found.sorted;
        report.candidates = found.candidates;
        report.filtered = found.filtered;
        report.triangles = found.triangles;
        report.front = self.frames.buffers.source.finder().front();
        let summary = &mut found.summary;
        // Contacts that the device counted are not in the list; their earliest time is.
        let counted = goal.is_earliest() && options.mode == Mode::Conservative;
        let device = (counted && found.earliest != decide::NEVER)
            .then(|| f32::from_bits(found.earliest) as f64);
        let earliest = goal.is_earliest().then(|| device.unwrap_or(f64::INFINITY));
        let listed = (&mut *contacts, &mut *summary);
        self.left_open = match given {
            Precision::F32(x) => Host { mesh, x, decider }.finish(is_left, earliest, listed),
            Precision::F64(x) => Host { mesh, x, decider }.finish(is_left, earliest, listed),
        };
        let undecided = summary.undecided.iter().map(|&at| contacts[at as usize].toi);
        let toi = undecided.fold(summary.toi, f64::min);
        report.toi = toi.is_finite().then_some(toi);
        report.undecided = summary.undecided.len() as u64;
        if counted {
            // Rounded as those of the device, so that it is the same whoever decides a pair.
            let host = report.toi.map(|toi| toi_to_f32(toi) as f64);
            report.toi = host.into_iter().chain(device).reduce(f64::min);
        }
        if goal != Goal::Contacts {
            contacts.clear();
            report.undecided = 0;
        }
        if !found.in_order {
            cpu_fallback::sort(contacts);
        }
    }

    /// Adds what belongs to nothing of a higher dimension to the report.
    fn take_codimensional(
        &mut self,
        (goal, window): (Goal, [f64; 2]),
        given: Given,
    ) -> Result<(), Error> {
        let Self { state, codimensional: Some(found), frames, .. } = self else { return Ok(()) };
        let State { mesh, options, report, .. } = state;
        found.list(mesh, (frames.buffers.rules.as_ref(), options.min_distance), given)?;
        let [ve, vv] = found.pairs.each_ref().map(|pairs| pairs.len() as u64);
        (report.candidates.ve, report.candidates.vv) = (ve, vv);
        (report.filtered.ve, report.filtered.vv) = (ve, vv);
        if goal != Goal::Candidates {
            found
                .contacts(mesh, &Decider::new(options, window), given)
                .for_each(|contact| report.add(contact, goal == Goal::Contacts));
        }
        Ok(())
    }
}
