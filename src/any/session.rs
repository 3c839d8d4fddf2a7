//! A session on either backend.

mod rules;

use super::{Choice, Either, Error, Pairs, Place, Turn, gpu};
use crate::{Coordinate, Mesh, Options, Report};

/// Continuous collision detection of one mesh over many steps, on the CPU or on a GPU: the calls
/// of [`crate::Session`].
pub struct Session(Either<crate::Session, gpu::Session>);

/// Candidates of a step: pairs of features whose swept boxes overlap.
pub struct Candidates<'a> {
    /// Vertex, face.
    pub vf: Pairs<'a>,
    /// Two edges, the lesser id first.
    pub ee: Pairs<'a>,
    /// A vertex of no edge, an edge of no face.
    pub ve: Pairs<'a>,
    /// Two vertices of no edge, the lesser id first.
    pub vv: Pairs<'a>,
}

impl Session {
    /// A session for `mesh` where the choice wants it.
    pub fn new(choice: &Choice, mesh: Mesh, options: Options) -> Result<Self, Error> {
        let choice = &choice.for_methods(options.broad_phase, options.pipeline, options.scheduling);
        let on_cpu = || crate::Session::new(mesh.clone(), options.clone());
        let on_gpu = |device: &_| gpu::Session::new(device, mesh.clone(), options.clone());
        Either::new(choice, on_cpu, on_gpu).map(Self)
    }

    /// Every contact of a step: see [`crate::Session::step`].
    pub fn step<T>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<&Report, Error>
    where
        T: Coordinate,
    {
        match self.0.run(|on| on.step(x0, x1).map(|_| ()), on_cpu)? {
            Turn::Done(()) => {}
            Turn::Cpu(on) => _ = on.step(x0, x1)?,
        }
        Ok(self.report())
    }

    /// The earliest time of impact of a step: see [`crate::Session::earliest_toi`].
    pub fn earliest_toi<T>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<Option<f64>, Error>
    where
        T: Coordinate,
    {
        match self.0.run(|on| on.earliest_toi(x0, x1), on_cpu)? {
            Turn::Done(toi) => Ok(toi),
            Turn::Cpu(on) => Ok(on.earliest_toi(x0, x1)?),
        }
    }

    /// Every contact of a step up to a time: see [`crate::Session::step_until`].
    pub fn step_until<T>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
        t_max: f64,
    ) -> Result<&Report, Error>
    where
        T: Coordinate,
    {
        self.step_window(x0, x1, [0.0, t_max])
    }

    /// Every contact in a window of a step: see [`crate::Session::step_window`].
    pub fn step_window<T>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
        window: [f64; 2],
    ) -> Result<&Report, Error>
    where
        T: Coordinate,
    {
        match self.0.run(|on| on.step_window(x0, x1, window).map(|_| ()), on_cpu)? {
            Turn::Done(()) => {}
            Turn::Cpu(on) => _ = on.step_window(x0, x1, window)?,
        }
        Ok(self.report())
    }

    /// How much of a step is certainly free: see [`crate::Session::collision_free_step_size`].
    pub fn collision_free_step_size<T>(
        &mut self,
        x0: &[[T; 3]],
        x1: &[[T; 3]],
    ) -> Result<f64, Error>
    where
        T: Coordinate,
    {
        Ok(self.earliest_toi(x0, x1)?.unwrap_or(1.0))
    }

    /// All candidates of a step: see [`crate::Session::candidates`].
    pub fn candidates<T>(&mut self, x0: &[[T; 3]], x1: &[[T; 3]]) -> Result<Candidates<'_>, Error>
    where
        T: Coordinate,
    {
        match self.0.run(|on| on.candidates(x0, x1), on_cpu)? {
            Turn::Done(all) => {
                let [vf, ee, ve, vv] = [all.vf, all.ee, all.ve, all.vv].map(Pairs::owned);
                Ok(Candidates { vf, ee, ve, vv })
            }
            Turn::Cpu(on) => {
                let all = on.candidates(x0, x1)?;
                let ([vf, ee], [ve, vv]) = (
                    [all.vf, all.ee].map(Pairs::lent),
                    [all.ve, all.vv].map(|of| Pairs::owned(of.to_vec())),
                );
                Ok(Candidates { vf, ee, ve, vv })
            }
        }
    }

    /// What the last step found.
    pub fn report(&self) -> &Report {
        match &self.0 {
            Either::Cpu(on) => on.report(),
            Either::Gpu { on, .. } => on.report(),
        }
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh {
        match &self.0 {
            Either::Cpu(on) => on.mesh(),
            Either::Gpu { on, .. } => on.mesh(),
        }
    }

    /// The options.
    pub fn options(&self) -> &Options {
        match &self.0 {
            Either::Cpu(on) => on.options(),
            Either::Gpu { on, .. } => on.options(),
        }
    }

    /// Where steps run.
    pub fn place(&self) -> Place {
        match &self.0 {
            Either::Cpu(on) => Place::Cpu { threads: on.threads() },
            Either::Gpu { on, .. } => Place::Gpu { adapter: gpu::name(on.device()).into() },
        }
    }

    /// The GPU's session, for what only a GPU does; `None` on the CPU.
    #[cfg(feature = "gpu")]
    pub fn gpu(&mut self) -> Option<&mut gpu::Session> {
        match &mut self.0 {
            Either::Cpu(_) => None,
            Either::Gpu { on, .. } => Some(on),
        }
    }
}

/// What takes over from a GPU.
fn on_cpu(on: &gpu::Session) -> Result<crate::Session, crate::Error> {
    crate::Session::new(on.mesh().clone(), on.options().clone())
}
