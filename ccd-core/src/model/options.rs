//! What a step looks for and how.

use super::bodies::Bodies;
use super::error::{Error, check_min_distance};
use super::mesh::Mesh;
use super::method::BroadPhaseMethod;
use super::pipeline::Pipeline;
use super::scheduling::Scheduling;

/// What a step looks for and how.
#[derive(Clone, Debug, Default, PartialEq)]
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

    /// Checks the options for steps of `mesh`.
    pub fn check(&self, mesh: &Mesh) -> Result<(), Error> {
        check_min_distance(self.min_distance)?;
        self.broad_phase.check()?;
        self.scheduling.check(self.broad_phase)?;
        self.bodies.as_ref().map_or(Ok(()), |bodies| bodies.check(mesh))
    }
}
