//! What a step looks for and how.

use super::bodies::Bodies;
use super::error::{Error, check_min_distance};
use super::mesh::Mesh;
use super::method::BroadPhaseMethod;
use super::pipeline::Pipeline;
use super::scheduling::Scheduling;

/// What a step looks for and how.
///
/// ```
/// use ccd_core::model::options::Options;
///
/// let options = Options::default().with_min_distance(0.001).with_threads(1);
/// assert_eq!(options.min_distance, 0.001);
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Options {
    /// Contact means a distance of at most this, in the unit of the coordinates; 0 (touching) or
    /// more.
    pub min_distance: f64,
    /// Threads of work on a CPU: 0 for those of rayon's current pool, 1 for the calling one alone,
    /// more for a pool of the session's own, up to [`Options::MAX_THREADS`].
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
}

impl Options {
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

    /// Checks the options for steps of `mesh`.
    pub fn check(&self, mesh: &Mesh) -> Result<(), Error> {
        check_min_distance(self.min_distance)?;
        self.broad_phase.check()?;
        self.scheduling.check(self.broad_phase)?;
        self.bodies.as_ref().map_or(Ok(()), |bodies| bodies.check(mesh))
    }
}
