//! What a step looks for and how.

use super::bodies::Bodies;
use super::error::{Error, check_min_distance, check_tolerance};
use super::mesh::Mesh;
use super::method::BroadPhaseMethod;
use super::pipeline::Pipeline;
use super::scheduling::Scheduling;
use crate::narrow_phase::query::{LEAST_TOLERANCE, TOI_TOLERANCE};
use crate::narrow_phase::search::Search;

/// How times of impact are found. Which pairs touch is decided exactly in all modes.
///
/// ```
/// use ccd::Mode;
///
/// let names: Vec<&str> = Mode::ALL.iter().map(Mode::name).collect();
/// assert_eq!(names, ["auto", "conservative", "exact"]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[non_exhaustive]
pub enum Mode {
    /// [`Mode::Exact`] on the CPU, if there is no minimum distance; else, and in sessions on a GPU
    /// also for what they leave to the CPU, [`Mode::Conservative`].
    #[default]
    Auto,
    /// A time of impact is never late, and early by the tolerance at most.
    ///
    /// A pair that `f64` certifies neither as a contact nor as none is decided exactly, on the CPU:
    /// also its time is early by the tolerance at most. With a minimum distance it is a contact of
    /// state [`State::Undecided`](super::contact::State::Undecided) instead.
    Conservative,
    /// Every time of impact is the true one rounded down, of the coordinates as they are: see
    /// [`narrow_phase::exact`](crate::narrow_phase::exact). A GPU decides pairs, and the CPU finds
    /// the last digits of the times, and all of what the device leaves open.
    ///
    /// Refused with a minimum distance, [`Error::ExactDistance`]; [`Options::leave_contact`] has no
    /// effect. A pair takes microseconds; one whose coordinates on one axis are hundreds of powers
    /// of two apart takes milliseconds.
    Exact,
}

impl Mode {
    /// All, the default first.
    pub const ALL: [Mode; 3] = [Mode::Auto, Mode::Conservative, Mode::Exact];

    /// Its name, as a command takes it.
    pub fn name(&self) -> &'static str {
        match self {
            Mode::Auto => "auto",
            Mode::Conservative => "conservative",
            Mode::Exact => "exact",
        }
    }

    /// What it is in a session on a GPU.
    #[must_use]
    pub fn on_device(self) -> Self {
        if self == Mode::Auto { Mode::Conservative } else { self }
    }

    /// Checks that the mode takes a minimum distance.
    ///
    /// # Errors
    /// [`Error::ExactDistance`] of one above 0 for [`Mode::Exact`].
    pub fn check(&self, min_distance: f64) -> Result<(), Error> {
        match self {
            Mode::Exact if min_distance > 0.0 => Err(Error::ExactDistance { value: min_distance }),
            _ => Ok(()),
        }
    }
}

/// What a step looks for and how.
///
/// ```
/// use ccd::Options;
///
/// let options = Options::default().with_min_distance(0.001).with_threads(1);
/// assert_eq!(options.min_distance, 0.001);
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[non_exhaustive]
pub struct Options {
    /// Contact means a distance of at most this, in the unit of the coordinates; 0 (touching) or
    /// more.
    pub min_distance: f64,
    /// Threads of work on a CPU: 0 for those of rayon's current pool, 1 for the calling one alone,
    /// more for a pool of the session's own, up to [`Options::MAX_THREADS`]. On a thread of a rayon
    /// pool, a call that is not alone waits by taking up other work of that pool: hold no lock then
    /// that such work takes.
    pub threads: usize,
    /// Which pairs of bodies are looked at; `None`: all pairs of features that share no vertex.
    pub bodies: Option<Bodies>,
    /// How pairs whose boxes overlap are found; results do not depend on it. A session of a backend
    /// that does not have the method is refused.
    pub broad_phase: BroadPhaseMethod,
    /// What is looked for in boxes: pairs of features, or of triangles; results do not depend on
    /// it. A session of a backend that does not have the pipeline is refused.
    pub pipeline: Pipeline,
    /// How the work of the broad phase is shared out, and where it begins; results do not depend on
    /// it. A session of a backend that does not have it is refused.
    pub scheduling: Scheduling,
    /// How early a certain time of impact may be, in units of the step, from
    /// [`Options::LEAST_TOLERANCE`] to 1. A pair that cannot be certified within it is treated as
    /// undecided, see [`Mode::Conservative`]. With one near 1 the pipeline of triangles with
    /// oriented boxes leaves fewer pairs undecided than others do. Exact times do not use it.
    pub tolerance: f64,
    /// How times of impact are found.
    pub mode: Mode,
    /// Whether two features that are in contact at the start of a step, or of its window, may leave
    /// it: where they certainly separate, that contact is none. A line search can leave contacts by
    /// it.
    ///
    /// At every time before the time of impact of such a pair, and in all of the step if it has no
    /// contact, its distance is above the minimum distance or at least what it is at the start. A
    /// return to the minimum distance is a contact if a time in between is found at which they
    /// certainly are farther apart; one that stays beyond the distance at the start may be left
    /// out. What cannot be certified to separate stays a contact at the start, among it everything
    /// that touches where the minimum distance is 0: see
    /// [`approach`](crate::narrow_phase::approach).
    pub leave_contact: bool,
    /// Bytes of memory that a session may hold; `None`: no limit. What would go beyond is refused
    /// with [`Error::Memory`] before it is allocated, and the session stays usable.
    ///
    /// Counted are what a session has for its mesh (boxes, trees, tables, and what each thread has
    /// of its own), as an estimate from above that is made when it gets the mesh, and every list
    /// whose length depends on where things are: contacts, candidates, pairs of nodes, fronts. On a
    /// GPU, the session's buffers there. Not counted are the mesh and the bodies themselves, stacks
    /// of threads, the old part of a list while it is copied to a longer one, compiled kernels,
    /// what positions and results of a GPU take on the host, tables of the runs that lists are
    /// joined from (64 bytes for some 1024 rows), a few pairs of nodes that threads take from each
    /// other at one moment, and of [`Pipeline::Triangles`] on a CPU the orphans: pairs of features
    /// that are listed once a mesh.
    pub max_memory: Option<u64>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            min_distance: 0.0,
            threads: 0,
            bodies: None,
            broad_phase: BroadPhaseMethod::default(),
            pipeline: Pipeline::default(),
            scheduling: Scheduling::default(),
            tolerance: TOI_TOLERANCE,
            mode: Mode::default(),
            leave_contact: false,
            max_memory: None,
        }
    }
}

impl Options {
    /// The least [`Options::tolerance`]: differences of times are exact to four digits there.
    pub const LEAST_TOLERANCE: f64 = LEAST_TOLERANCE;
    /// Most threads of a session or of a broad phase.
    pub const MAX_THREADS: usize = 1024;

    /// With this [`Options::min_distance`].
    #[must_use]
    pub fn with_min_distance(mut self, min_distance: f64) -> Self {
        self.min_distance = min_distance;
        self
    }

    /// With so many [`Options::threads`].
    #[must_use]
    pub fn with_threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self
    }

    /// With these [`Options::bodies`], or none.
    #[must_use]
    pub fn with_bodies(mut self, bodies: impl Into<Option<Bodies>>) -> Self {
        self.bodies = bodies.into();
        self
    }

    /// With this [`Options::broad_phase`].
    #[must_use]
    pub fn with_broad_phase(mut self, broad_phase: BroadPhaseMethod) -> Self {
        self.broad_phase = broad_phase;
        self
    }

    /// With this [`Options::pipeline`].
    #[must_use]
    pub fn with_pipeline(mut self, pipeline: Pipeline) -> Self {
        self.pipeline = pipeline;
        self
    }

    /// With this [`Options::scheduling`].
    #[must_use]
    pub fn with_scheduling(mut self, scheduling: Scheduling) -> Self {
        self.scheduling = scheduling;
        self
    }

    /// With this [`Options::tolerance`].
    #[must_use]
    pub fn with_tolerance(mut self, tolerance: f64) -> Self {
        self.tolerance = tolerance;
        self
    }

    /// With this [`Options::mode`].
    #[must_use]
    pub fn with_mode(mut self, mode: Mode) -> Self {
        self.mode = mode;
        self
    }

    /// With this [`Options::leave_contact`].
    #[must_use]
    pub fn with_leave_contact(mut self, leave_contact: bool) -> Self {
        self.leave_contact = leave_contact;
        self
    }

    /// With this [`Options::max_memory`], or none.
    #[must_use]
    pub fn with_max_memory(mut self, max_memory: impl Into<Option<u64>>) -> Self {
        self.max_memory = max_memory.into();
        self
    }

    /// What queries of a step look for, from time `from` to `until`.
    pub fn search(&self, [from, until]: [f64; 2]) -> Search<f64> {
        let Self { min_distance, tolerance, leave_contact: leaves, .. } = *self;
        // No time is a negative zero.
        let (from, until) = (from + 0.0, until + 0.0);
        Search { min_distance, tolerance, from, until, latest: until, leaves }
    }

    /// Checks the options for steps of `mesh`.
    ///
    /// # Errors
    /// [`Error::MinDistance`]; [`Error::ExactDistance`]; [`Error::Tolerance`]; [`Error::Setting`]
    /// and [`Error::NoPairsOfNodes`] for a method and its scheduling; what [`Bodies::check`]
    /// refuses.
    pub fn check(&self, mesh: &Mesh) -> Result<(), Error> {
        check_min_distance(self.min_distance)?;
        self.mode.check(self.min_distance)?;
        check_tolerance(self.tolerance)?;
        self.broad_phase.check()?;
        self.scheduling.check(self.broad_phase)?;
        self.bodies.as_ref().map_or(Ok(()), |bodies| bodies.check(mesh))
    }

    /// The name of what a backend, `"cpu"` or `"gpu"`, lacks of a method, a pipeline or a
    /// scheduling, if it lacks something.
    pub fn lacking(&self, backend: &str) -> Option<&'static str> {
        let Self { broad_phase, pipeline, scheduling, .. } = *self;
        if backend == "gpu" && pipeline.repeats_tests() {
            return Some("triangles without representatives");
        }
        let lacking = broad_phase.lacking(backend).or_else(|| pipeline.lacking(backend));
        lacking.or_else(|| scheduling.lacking(backend))
    }

    /// Checks that a backend has all that the options choose.
    ///
    /// # Errors
    /// [`Error::Method`] with the name of what it lacks.
    pub fn check_backend(&self, backend: &'static str) -> Result<(), Error> {
        self.lacking(backend).map_or(Ok(()), |name| Err(Error::Method { name, backend }))
    }
}
