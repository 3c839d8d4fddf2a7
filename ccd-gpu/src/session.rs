//! A mesh stepped frame by frame on a device: what callers ask, what they get, and what the CPU
//! decides of it.

use crate::broad_phase::worker_counts::WorkerCounts;
use crate::device::Device;
use crate::error::Error;
use crate::recorder::Timing;
use crate::step::codimensional::Codimensional;
use crate::step::frame::{Found, Frames};
use crate::step::{Goal, WHOLE, cpu_fallback};
use ccd_core::layout::Pair;
use ccd_core::model::cancel::CancelToken;
use ccd_core::model::contact::{Kind, PerKind};
use ccd_core::model::error::check_window;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::positions::{AsPositions, Ends, Gathered, ends};
use ccd_core::model::precision::{Given, Precision};
use ccd_core::model::report::Report;
use ccd_core::narrow_phase::decide;
use std::sync::Arc;
use std::time::Instant;

mod changes;
mod on_device;
mod rules;

pub use on_device::{GeometryOnDevice, OnDevice};

/// Continuous collision detection of one mesh over many steps, on a GPU.
///
/// Positions are whatever is [`AsPositions`]: slices, arrays and vectors of `[f32; 3]` or
/// `[f64; 3]`, bytes with a stride, posed bodies, vectors of `glam`. Between steps, the `set_`
/// functions change what a session was made with; the next step finds what a new session would.
///
/// ```no_run
/// use ccd_core::model::{mesh::Mesh, options::Options};
/// use ccd_gpu::{Device, DeviceOptions, Session};
///
/// let device = Device::open(&DeviceOptions::default())?;
/// let mesh = Mesh::new(4, &[[0, 1, 2]])?;
/// let mut session = Session::new(&device, mesh, Options::default())?;
/// let report = session.step(&[[0.0f32; 3]; 4], &[[1.0; 3]; 4])?;
/// println!("{} contacts of {:?}", report.contacts.len(), report.mesh());
/// # Ok::<(), ccd_gpu::Error>(())
/// ```
pub struct Session {
    device: Device,
    mesh: Arc<Mesh>,
    options: Options,
    frames: Frames,
    codimensional: Option<Codimensional>,
    report: Report,
    left_open: PerKind,
    gathered: Gathered,
}

/// Candidates of a step: pairs of features whose swept boxes overlap, in no order.
///
/// ```no_run
/// use ccd_gpu::{Error, Session};
///
/// fn most(session: &mut Session, x: &[[f32; 3]]) -> Result<usize, Error> {
///     let mut candidates = session.candidates(x, x)?;
///     // In no order; sorted they are those of a CPU.
///     candidates.vf.sort_unstable();
///     Ok(candidates.vf.len().max(candidates.ee.len()))
/// }
/// # let _ = most;
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Candidates {
    /// Vertex, face.
    pub vf: Vec<Pair>,
    /// Two edges, the lesser id first.
    pub ee: Vec<Pair>,
    /// A vertex of no edge, an edge of no face.
    pub ve: Vec<Pair>,
    /// Two vertices of no edge, the lesser id first.
    pub vv: Vec<Pair>,
}

impl Session {
    /// A session for `mesh` on `device`: a [`Mesh`], a reference to one, which is copied, or an
    /// `Arc` of one, which is shared.
    ///
    /// # Errors
    /// [`Error::Input`] with what [`Options::check`] refuses or a GPU does not have;
    /// what the device refuses.
    pub fn new(
        device: &Device,
        mesh: impl Into<Arc<Mesh>>,
        options: Options,
    ) -> Result<Self, Error> {
        Self::of(device, mesh.into(), options)
    }

    #[inline(never)]
    fn of(device: &Device, mesh: Arc<Mesh>, options: Options) -> Result<Self, Error> {
        changes::check(&mesh, &options)?;
        let device = device.limited(options.max_memory);
        Ok(Self {
            frames: Frames::new(&device, &mesh, &options)?,
            codimensional: Codimensional::new(&device, &mesh, &options)?,
            device,
            mesh,
            options,
            report: Report::default(),
            left_open: PerKind::default(),
            gathered: Gathered::default(),
        })
    }

    /// Goes on with another device, after the last one was lost.
    ///
    /// # Errors
    /// What the device refuses; then the session stays on the one that it has.
    pub fn move_to(&mut self, device: &Device) -> Result<(), Error> {
        let device = device.limited(self.options.max_memory);
        let codimensional = Codimensional::new(&device, &self.mesh, &self.options)?;
        self.frames.move_to(&device, &self.mesh, &self.options)?;
        self.codimensional = codimensional;
        self.device = device;
        Ok(())
    }

    /// The mesh of the next step. [`Report::mesh`] is that of the last one.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.mesh
    }

    /// The options.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The device.
    pub fn device(&self) -> &Device {
        &self.device
    }

    /// From now on calls end with [`ccd_core::Error::Cancelled`] once this token is cancelled,
    /// before the next frame is submitted: one that was submitted runs to its end. `None`: none
    /// does. The session stays usable.
    pub fn set_cancel_token(&mut self, token: impl Into<Option<CancelToken>>) {
        self.frames.cancel = token.into();
    }

    /// The token that ends calls.
    pub fn cancel_token(&self) -> Option<&CancelToken> {
        self.frames.cancel.as_ref()
    }

    /// What the last step found; empty if it failed. Of its times, `total` is wall clock; stages
    /// are in [`Session::stages`].
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// What each call times on the device from now on.
    ///
    /// # Errors
    /// What the device refuses. Where it has no timestamps, nothing is timed.
    pub fn set_timing(&mut self, timing: Timing) -> Result<(), Error> {
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
        self.frames.worker_counts(&self.device)
    }

    /// Pairs of the last call that `f32` on the device left open and the CPU decided.
    pub fn left_open(&self) -> PerKind {
        self.left_open
    }

    /// How often a list was too short since the session began, so that a frame ran again.
    pub fn grown(&self) -> u32 {
        self.frames.grown
    }

    /// Makes room for so many entries in every list, more or less than there is: less makes the
    /// next step grow them, more spares it that.
    ///
    /// # Errors
    /// [`Error::TooLarge`] and [`Error::OutOfMemory`].
    pub fn reserve(&mut self, entries: u32) -> Result<(), Error> {
        self.frames.reserve(&self.device, entries)
    }

    /// Every contact while vertices move on straight lines from `x0` to `x1`, one position per
    /// vertex of the mesh.
    ///
    /// # Errors
    /// [`Error::Input`] with what is wrong with positions; what the device refuses. The session
    /// stays usable, after [`Error::Lost`] on another device.
    pub fn step<A, B>(&mut self, x0: &A, x1: &B) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.run(ends(x0, x1), WHOLE, Goal::Contacts)?;
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
    /// impact in units of the whole step: the first such time at or after `t_a`. Paths are cut to
    /// the window, and boxes swept for it alone.
    ///
    /// # Errors
    /// [`ccd_core::Error::Window`] unless `0 <= t_a <= t_b <= 1`, besides those of
    /// [`Session::step`].
    pub fn step_window<A, B>(&mut self, x0: &A, x1: &B, window: [f64; 2]) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.run(ends(x0, x1), window, Goal::Contacts)?;
        Ok(&self.report)
    }

    /// The earliest time of impact of the step, without the list of contacts: cheaper than
    /// [`Session::step`]. `None`: the whole step is free.
    ///
    /// It is not later than the earliest contact, and rounded down to an `f32`; with a tolerance
    /// below 1e-7, which an `f32` cannot keep, it is not rounded, and costs as much as
    /// [`Session::step`].
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn earliest_toi<A, B>(&mut self, x0: &A, x1: &B) -> Result<Option<f64>, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        let exact = self.options.tolerance < 1e-7;
        let goal = if exact { Goal::Contacts } else { self.frames.goal_of_earliest() };
        self.run(ends(x0, x1), WHOLE, goal)?;
        if exact {
            self.report.contacts.clear();
            self.report.undecided = 0;
        }
        Ok(self.report.toi)
    }

    /// How much of the step is certainly free of contact: 1 if all of it is, else
    /// [`Session::earliest_toi`], which may be 0.
    ///
    /// With [`Options::leave_contact`], "free" means for features that are in contact at the start
    /// and separate that they neither come nearer than at the start nor touch again.
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
    /// # Errors
    /// Those of [`Session::step`].
    pub fn candidates<A, B>(&mut self, x0: &A, x1: &B) -> Result<Candidates, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.list(ends(x0, x1))
    }

    /// Lists candidates.
    #[inline(never)]
    fn list(&mut self, ends: Ends) -> Result<Candidates, Error> {
        self.run(ends, WHOLE, Goal::Candidates)?;
        let read = self.frames.read_candidates(&self.device, self.report.candidates);
        let [vf, ee] = read.inspect_err(|_| self.clear_report())?;
        let [ve, vv] =
            self.codimensional.as_ref().map_or_else(Default::default, |of| of.pairs.clone());
        Ok(Candidates { vf, ee, ve, vv })
    }

    #[inline(never)]
    fn run(&mut self, ends: Ends, window: [f64; 2], goal: Goal) -> Result<(), Error> {
        let mut gathered = std::mem::take(&mut self.gathered);
        let given = gathered.slices(ends).map_err(Error::from);
        let done = given.and_then(|given| self.run_given(given, window, goal));
        self.gathered = gathered;
        if done.is_err() {
            self.clear_report();
            self.frames.geometry.listed = false;
        }
        done
    }

    /// An empty report, with the memory of the contacts of the last one.
    fn clear_report(&mut self) {
        let mut contacts = std::mem::take(&mut self.report.contacts);
        contacts.clear();
        self.report = Report::default();
        self.report.contacts = contacts;
        self.left_open = PerKind::default();
    }

    fn run_given(&mut self, given: Given, window: [f64; 2], goal: Goal) -> Result<(), Error> {
        check_window(window)?;
        match given {
            Precision::F32([x0, x1]) => self.mesh.check_positions(x0, x1),
            Precision::F64([x0, x1]) => self.mesh.check_positions(x0, x1),
        }?;
        if let Some(rules) = &self.frames.buffers.rules {
            match given {
                Precision::F32([x0, x1]) => rules.check_still(x0, x1),
                Precision::F64([x0, x1]) => rules.check_still(x0, x1),
            }?;
        }
        let start = Instant::now();
        self.device.check_lost()?;
        self.frames.upload(&self.device, &self.mesh, given, self.options.min_distance)?;
        self.clear_report();
        self.report.set_mesh(&self.mesh);
        let uploaded = start.elapsed();
        let contacts = &mut self.report.contacts;
        let found = self.frames.run(&self.device, &self.options, (goal, window), contacts)?;
        self.report.times.boxes = uploaded.as_secs_f64() * 1e3;
        self.take(found, (goal, window), given);
        self.take_codimensional((goal, window), given)?;
        self.report.times.total = start.elapsed().as_secs_f64() * 1e3;
        Ok(())
    }

    /// Decides what the device left open, and makes the report.
    fn take(&mut self, found: Found, (goal, window): (Goal, [f64; 2]), given: Given) {
        let search = &self.options.search(window);
        let report = &mut self.report;
        self.left_open = PerKind::new(found.open[0].len() as u64, found.open[1].len() as u64);
        report.rebuilt = found.sorted;
        report.candidates = found.candidates;
        report.filtered = found.filtered;
        report.triangles = found.triangles;
        report.front = self.frames.buffers.source.front();
        let contacts = &mut report.contacts;
        for (kind, open) in [Kind::VertexFace, Kind::EdgeEdge].into_iter().zip(&found.open) {
            let mesh = &self.mesh;
            match given {
                Precision::F32(x) => cpu_fallback::decide(mesh, kind, open, x, search, contacts),
                Precision::F64(x) => cpu_fallback::decide(mesh, kind, open, x, search, contacts),
            }
        }
        (report.toi, report.undecided) = cpu_fallback::summary(contacts);
        if goal.is_earliest() {
            // Contacts that the device counted are not in the list; their earliest time is.
            let device =
                (found.earliest != decide::NEVER).then(|| f32::from_bits(found.earliest) as f64);
            report.toi = report.toi.into_iter().chain(device).reduce(f64::min);
        }
        if goal != Goal::Contacts {
            contacts.clear();
            report.undecided = 0;
        }
        if !found.in_order || found.open.iter().any(|open| !open.is_empty()) {
            cpu_fallback::sort(contacts);
        }
    }

    /// Adds what belongs to nothing of a higher dimension to the report.
    fn take_codimensional(
        &mut self,
        (goal, window): (Goal, [f64; 2]),
        given: Given,
    ) -> Result<(), Error> {
        let Self { mesh, options, codimensional: Some(of), report, frames, .. } = self else {
            return Ok(());
        };
        of.list(mesh, (frames.buffers.rules.as_ref(), options.min_distance), given)?;
        let [ve, vv] = of.pairs.each_ref().map(|pairs| pairs.len() as u64);
        (report.candidates.ve, report.candidates.vv) = (ve, vv);
        (report.filtered.ve, report.filtered.vv) = (ve, vv);
        if goal != Goal::Candidates {
            of.contacts(mesh, &options.search(window), given)
                .for_each(|contact| report.add(contact, goal == Goal::Contacts));
        }
        Ok(())
    }
}
