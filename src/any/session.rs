//! A session on either backend.

use super::{Choice, Either, Error, Pairs, Place, Turn, gpu};
use crate::method::BroadPhaseMethod;
use crate::{AsPositions, CancelToken, CandidateSet, Intersection};
use ccd_core::model::precision::Given;
use ccd_core::model::session::Engine as _;
use ccd_core::model::session::{self, Ask, Change, Intersects, Kept, Moved, On, State};

/// Continuous collision detection of one mesh over many steps, on the CPU or on a GPU: the calls
/// of [`crate::Session`], and those of [`Engine`].
///
/// ```
/// use ccd::any::{Backend, Session};
/// use ccd::{Mesh, Options};
///
/// let mesh = Mesh::new(4, &[[0, 1, 2]])?;
/// let choice = Backend::Cpu.choose(mesh.edges().len())?;
/// let mut session = Session::new(&choice, mesh, Options::default())?;
/// let (before, after) = ([[0.0f32; 3]; 4], [[1.0f32; 3]; 4]);
/// assert_eq!(session.step(&before, &after)?.mesh().n_vertices(), 4);
/// session.set_min_distance(0.01)?;
/// assert_eq!(session.earliest_toi(&before, &after)?, Some(0.0));
/// # Ok::<(), ccd::any::Error>(())
/// ```
pub type Session = session::Session<Engine, On<Choice>>;

/// Candidates of a step: pairs of features whose swept boxes overlap.
///
/// ```
/// use ccd::any::{Backend, Session};
/// use ccd::{Mesh, Options, Pair};
///
/// let (choice, mesh) = (Backend::Cpu.choose(0)?, Mesh::new(4, &[[0, 1, 2]])?);
/// let mut session = Session::new(&choice, mesh, Options::default())?;
/// let x = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 0.0, 0.2]];
/// let candidates = session.candidates(&x, &x)?;
/// assert_eq!(candidates.vf.iter().next(), Some(Pair { a: 3, b: 0 }));
/// assert!(candidates.ee.is_empty());
/// # Ok::<(), ccd::any::Error>(())
/// ```
pub type Candidates<'a> = session::Candidates<Pairs<'a>>;

/// A [`Session`] of either backend.
pub struct Engine(Either<crate::Session, gpu::Session>);

impl session::Engine for Engine {
    type On = Choice;
    type Error = Error;
    type Candidates<'a> = Candidates<'a>;

    fn new(choice: &Choice, State { mesh, options, .. }: State) -> Result<Self, Error> {
        let on_cpu = || crate::Session::new(mesh.clone(), options.clone());
        let on_gpu = |device: &_| gpu::Session::new(device, mesh.clone(), options.clone());
        Either::new(&choice.for_options(&options), on_cpu, on_gpu).map(Self)
    }

    fn state(&self) -> &State {
        match &self.0 {
            Either::Cpu(on) => on.state(),
            Either::Gpu { on, .. } => on.state(),
        }
    }

    fn kept(&mut self) -> &mut Kept {
        match &mut self.0 {
            Either::Cpu(on) => on.kept(),
            Either::Gpu { on, .. } => on.kept(),
        }
    }

    fn clear(&mut self) {
        match &mut self.0 {
            Either::Cpu(on) => on.clear(),
            Either::Gpu { on, .. } => on.clear(),
        }
    }

    fn find(&mut self, given: Given, moved: Option<Moved>, ask: Ask) -> Result<(), Error> {
        match self.0.run(|on| on.find(given, moved, ask), on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.find(given, moved, ask)?),
        }
    }

    fn candidates(&mut self, given: Given) -> Result<Candidates<'_>, Error> {
        match self.0.run(|on| session::Engine::candidates(&mut **on, given), on_cpu)? {
            Turn::Done(all) => {
                let lists = [[all.vf, all.ee], [all.ve, all.vv]].map(|of| of.map(Pairs::owned));
                let [of_faces, of_particles] = lists;
                Ok(Candidates::new(of_faces, of_particles))
            }
            Turn::Cpu(on) => {
                let all = session::Engine::candidates(&mut **on, given)?;
                let of_particles = [all.ve, all.vv].map(|of| Pairs::owned(of.to_vec()));
                Ok(Candidates::new([all.vf, all.ee].map(Pairs::lent), of_particles))
            }
        }
    }

    fn change(&mut self, change: Change) -> Result<(), Error> {
        match self.0.run(|on| on.change(change.clone()), on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.change(change)?),
        }
    }

    fn set_cancel_token(&mut self, token: Option<CancelToken>) {
        match &mut self.0 {
            Either::Cpu(on) => on.set_cancel_token(token),
            Either::Gpu { on, .. } => on.set_cancel_token(token),
        }
    }

    fn cancel_token(&self) -> Option<&CancelToken> {
        match &self.0 {
            Either::Cpu(on) => on.cancel_token(),
            Either::Gpu { on, .. } => on.cancel_token(),
        }
    }
}

impl Intersects for Engine {
    fn intersections(
        &mut self,
        given: Given,
        first: bool,
    ) -> Result<Vec<Intersection>, crate::Error> {
        match &mut self.0 {
            Either::Cpu(on) => Intersects::intersections(&mut ***on, given, first),
            Either::Gpu { on, .. } => {
                let mut on = beside(on)?;
                Intersects::intersections(&mut *on, given, first)
            }
        }
    }
}

impl Engine {
    /// Where steps run.
    pub fn place(&self) -> Place {
        match &self.0 {
            Either::Cpu(on) => Place::Cpu { threads: on.threads() },
            Either::Gpu { on, .. } => Place::Gpu { adapter: gpu::name(on.device()).into() },
        }
    }

    /// Candidates of a step that is near many others, found and used on the CPU wherever steps run:
    /// see [`CandidateSet`].
    ///
    /// # Errors
    /// Those of the [CPU's call](ccd_cpu::Engine::candidate_set).
    pub fn candidate_set<A, B>(
        &mut self,
        x0: &A,
        x1: &B,
        inflation: f64,
    ) -> Result<CandidateSet, crate::Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        match &mut self.0 {
            Either::Cpu(on) => on.candidate_set(x0, x1, inflation),
            Either::Gpu { on, .. } => beside(on)?.candidate_set(x0, x1, inflation),
        }
    }

    /// The CPU's session, for calls that only the CPU has; `None` on a GPU.
    pub fn cpu(&mut self) -> Option<&mut crate::Session> {
        match &mut self.0 {
            Either::Cpu(on) => Some(on),
            Either::Gpu { .. } => None,
        }
    }

    /// The GPU's session, for calls that only a GPU has; `None` on the CPU.
    #[cfg(feature = "gpu")]
    pub fn gpu(&mut self) -> Option<&mut gpu::Session> {
        match &mut self.0 {
            Either::Cpu(_) => None,
            Either::Gpu { on, .. } => Some(on),
        }
    }
}

/// The session on the CPU that takes over from a GPU, with the bodies where they are.
fn on_cpu(on: &mut gpu::Session) -> Result<crate::Session, crate::Error> {
    let mut session = crate::Session::new(on.mesh().clone(), on.options().clone())?;
    session.set_cancel_token(on.cancel_token().cloned());
    *session.kept() = std::mem::take(on.kept());
    Ok(session)
}

/// A session on the CPU for what a GPU does not do, by the default method.
fn beside(on: &gpu::Session) -> Result<crate::Session, crate::Error> {
    let options = on.options().clone().with_broad_phase(BroadPhaseMethod::default());
    let options = options.with_scheduling(Default::default()).with_pipeline(Default::default());
    let mut session = crate::Session::new(on.mesh().clone(), options)?;
    session.set_cancel_token(on.cancel_token().cloned());
    Ok(session)
}
