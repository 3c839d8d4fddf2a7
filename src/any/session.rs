//! A session on either backend.

use super::{Choice, Either, Error, Pairs, Place, Turn, gpu};
use crate::method::BroadPhaseMethod;
use crate::{AsPositions, CancelToken, CandidateSet, Intersection, Mode, Real};
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
pub struct Engine {
    on: Either<crate::Session, gpu::Session>,
    /// Beside a GPU: what takes steps in which little moves.
    beside: Option<Box<crate::Session>>,
    /// Whether the last call found few candidates.
    is_light: bool,
    /// Whether the last call was taken beside the GPU.
    was_beside: bool,
}

/// A session on a GPU has the CPU take a step of which it is told what moves
/// ([`Session::step_bodies`](session::Session::step_bodies) and its like), if at most so many
/// vertices move in it and in the step before, together, and that one found at most
/// [`FEW_CANDIDATES`]: two threads are done with so little before a GPU has begun. A body that
/// moves in every step counts twice.
///
/// The first such step makes a session on the CPU, which takes as long as a first step there and
/// as much memory; so there is none with [`Options::max_memory`](crate::Options::max_memory), nor
/// where another method than the default was chosen. Contacts are the same; where the device has
/// no `f64`, or reads WGSL, conservative times are those of a CPU, which differ by up to the
/// tolerance. Nothing of the step is on the device then.
pub const FEW_VERTICES: usize = 512;
/// See [`FEW_VERTICES`].
pub const FEW_CANDIDATES: u64 = 4096;

impl session::Engine for Engine {
    type On = Choice;
    type Error = Error;
    type Candidates<'a> = Candidates<'a>;

    fn new(choice: &Choice, State { mesh, options, .. }: State) -> Result<Self, Error> {
        let on_cpu = || crate::Session::new(mesh.clone(), options.clone());
        let on_gpu = |device: &_| gpu::Session::new(device, mesh.clone(), options.clone());
        let on = Either::new(&choice.for_options(&options), on_cpu, on_gpu)?;
        Ok(Self { on, beside: None, is_light: false, was_beside: false })
    }

    fn state(&self) -> &State {
        match &self.on {
            Either::Cpu(on) => on.state(),
            Either::Gpu { on, .. } => on.state(),
        }
    }

    fn kept(&mut self) -> &mut Kept {
        match &mut self.on {
            Either::Cpu(on) => on.kept(),
            Either::Gpu { on, .. } => on.kept(),
        }
    }

    fn clear(&mut self) {
        match &mut self.on {
            Either::Cpu(on) => on.clear(),
            Either::Gpu { on, .. } => on.clear(),
        }
    }

    fn find(&mut self, given: Given, moved: Option<Moved>, ask: Ask) -> Result<(), Error> {
        let is_light = std::mem::take(&mut self.is_light);
        let little = moved.filter(|moved| {
            is_light && moved.runs.iter().map(|run| run.len()).sum::<usize>() <= FEW_VERTICES
        });
        self.was_beside = false;
        match little.and_then(|moved| self.find_beside(given, moved, ask)) {
            Some(found) => found?,
            None => match self.on.run(|on| on.find(given, moved, ask), on_cpu)? {
                Turn::Done(()) => {}
                Turn::Cpu(on) => {
                    self.beside = None;
                    on.find(given, moved, ask)?;
                }
            },
        }
        self.is_light = self.state().report.candidates.total() <= FEW_CANDIDATES;
        Ok(())
    }

    fn candidates(&mut self, given: Given) -> Result<Candidates<'_>, Error> {
        match self.on.run(|on| session::Engine::candidates(&mut **on, given), on_cpu)? {
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
        // Of another mesh there is nothing that it could keep.
        let kept = self.beside.take().filter(|_| !matches!(change, Change::Mesh(..)));
        let beside = kept.and_then(|mut on| on.change(change.clone()).is_ok().then_some(on));
        match self.on.run(|on| on.change(change.clone()), on_cpu)? {
            Turn::Done(()) => self.beside = beside,
            Turn::Cpu(on) => on.change(change)?,
        }
        Ok(())
    }

    fn set_cancel_token(&mut self, token: Option<CancelToken>) {
        if let Some(on) = &mut self.beside {
            on.set_cancel_token(token.clone());
        }
        match &mut self.on {
            Either::Cpu(on) => on.set_cancel_token(token),
            Either::Gpu { on, .. } => on.set_cancel_token(token),
        }
    }

    fn cancel_token(&self) -> Option<&CancelToken> {
        match &self.on {
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
        match &mut self.on {
            Either::Cpu(on) => Intersects::intersections(&mut ***on, given, first),
            Either::Gpu { on, .. } => {
                let mut on = beside(on, on.options().threads)?;
                Intersects::intersections(&mut *on, given, first)
            }
        }
    }
}

impl Engine {
    /// Has the CPU find what is asked for, beside a GPU, and leaves it in the GPU's report. `None`:
    /// it may not, or there are no threads or no memory for it.
    fn find_beside(&mut self, given: Given, moved: Moved, ask: Ask) -> Option<Result<(), Error>> {
        let Either::Gpu { on, .. } = &mut self.on else { return None };
        let options = on.options();
        let methods = (options.broad_phase, options.scheduling, options.pipeline);
        if options.max_memory.is_some() || methods != Default::default() {
            return None;
        }
        let threads = if options.threads == 1 { 1 } else { 2 };
        if self.beside.is_none() {
            self.beside = beside(on, threads).ok().map(Box::new);
        }
        let cpu = self.beside.as_mut()?;
        self.was_beside = true;
        // It has the contacts of the step before, whose memory serves again.
        std::mem::swap(on.report_mut(), cpu.report_mut());
        on.clear();
        let found = cpu.find(given, Some(moved), ask);
        std::mem::swap(on.report_mut(), cpu.report_mut());
        let options = cpu.options();
        let time_alone = matches!(ask, Ask::Earliest { .. });
        if time_alone && options.mode == Mode::Conservative && options.tolerance >= 1e-7 {
            // As a GPU says it.
            let toi = &mut on.report_mut().toi;
            *toi = toi.map(|toi| toi.round_down().into());
        }
        Some(found.map_err(Error::from))
    }

    /// Where steps run; those in which little moves run on the CPU all the same
    /// ([`FEW_VERTICES`](super::FEW_VERTICES)).
    pub fn place(&self) -> Place {
        match &self.on {
            Either::Cpu(on) => Place::Cpu { threads: on.threads() },
            Either::Gpu { on, .. } => Place::Gpu { adapter: gpu::name(on.device()).into() },
        }
    }

    /// Where the last step ran: [`Engine::place`], but for one in which little moved.
    pub fn last_place(&self) -> Place {
        match &self.beside {
            Some(on) if self.was_beside => Place::Cpu { threads: on.threads() },
            _ => self.place(),
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
        match &mut self.on {
            Either::Cpu(on) => on.candidate_set(x0, x1, inflation),
            Either::Gpu { on, .. } => {
                beside(on, on.options().threads)?.candidate_set(x0, x1, inflation)
            }
        }
    }

    /// The CPU's session, for calls that only the CPU has; `None` on a GPU.
    pub fn cpu(&mut self) -> Option<&mut crate::Session> {
        match &mut self.on {
            Either::Cpu(on) => Some(on),
            Either::Gpu { .. } => None,
        }
    }

    /// The GPU's session, for calls that only a GPU has; `None` on the CPU.
    #[cfg(feature = "gpu")]
    pub fn gpu(&mut self) -> Option<&mut gpu::Session> {
        match &mut self.on {
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
fn beside(on: &gpu::Session, threads: usize) -> Result<crate::Session, crate::Error> {
    let options = on.options().clone().with_threads(threads);
    let options = options.with_broad_phase(BroadPhaseMethod::default());
    let options = options.with_scheduling(Default::default()).with_pipeline(Default::default());
    let mut session = crate::Session::new(on.mesh().clone(), options)?;
    session.set_cancel_token(on.cancel_token().cloned());
    Ok(session)
}
