//! A session on either backend.

mod rules;

use super::{Choice, Either, Error, Pairs, Place, Turn, gpu};
use crate::positions::{AsPositions, Ends, PositionView, Precision, ends};
use crate::{Bodies, CancelToken, Coordinate, Mesh, Options, Report};
use std::sync::Arc;

/// Continuous collision detection of one mesh over many steps, on the CPU or on a GPU: the calls
/// of [`crate::Session`].
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
pub struct Session(Either<crate::Session, gpu::Session>);

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
    ///
    /// # Errors
    /// Those of [`crate::Session::new`], and, where the choice was a GPU alone, what that refuses.
    pub fn new(
        choice: &Choice,
        mesh: impl Into<Arc<Mesh>>,
        options: Options,
    ) -> Result<Self, Error> {
        Self::of(choice, mesh.into(), options)
    }

    #[inline(never)]
    fn of(choice: &Choice, mesh: Arc<Mesh>, options: Options) -> Result<Self, Error> {
        let choice = &choice.for_methods(options.broad_phase, options.pipeline, options.scheduling);
        let on_cpu = || crate::Session::new(mesh.clone(), options.clone());
        let on_gpu = |device: &_| gpu::Session::new(device, mesh.clone(), options.clone());
        Either::new(choice, on_cpu, on_gpu).map(Self)
    }

    /// Every contact of a step: see [`crate::Session::step`].
    ///
    /// # Errors
    /// [`Error::Input`] with those of [`crate::Session::step`], and, where the choice was a GPU
    /// alone, what that refuses.
    pub fn step<A, B>(&mut self, x0: &A, x1: &B) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.step_of(ends(x0, x1), [0.0, 1.0])?;
        Ok(self.report())
    }

    #[inline(never)]
    fn step_of(&mut self, ends: Ends, window: [f64; 2]) -> Result<(), Error> {
        match ends {
            Precision::F32(x) => self.step_in(x, window),
            Precision::F64(x) => self.step_in(x, window),
        }
    }

    fn step_in<T: Coordinate>(
        &mut self,
        [x0, x1]: [PositionView<T>; 2],
        window: [f64; 2],
    ) -> Result<(), Error> {
        match self.0.run(|on| on.step_window(&x0, &x1, window).map(|_| ()), on_cpu)? {
            Turn::Done(()) => {}
            Turn::Cpu(on) => _ = on.step_window(&x0, &x1, window)?,
        }
        Ok(())
    }

    /// The earliest time of impact of a step: see [`crate::Session::earliest_toi`].
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn earliest_toi<A, B>(&mut self, x0: &A, x1: &B) -> Result<Option<f64>, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.earliest_of(ends(x0, x1))
    }

    #[inline(never)]
    fn earliest_of(&mut self, ends: Ends) -> Result<Option<f64>, Error> {
        match ends {
            Precision::F32(x) => self.earliest_in(x),
            Precision::F64(x) => self.earliest_in(x),
        }
    }

    fn earliest_in<T: Coordinate>(
        &mut self,
        [x0, x1]: [PositionView<T>; 2],
    ) -> Result<Option<f64>, Error> {
        match self.0.run(|on| on.earliest_toi(&x0, &x1), on_cpu)? {
            Turn::Done(toi) => Ok(toi),
            Turn::Cpu(on) => Ok(on.earliest_toi(&x0, &x1)?),
        }
    }

    /// Every contact of a step up to a time: see [`crate::Session::step_until`].
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

    /// Every contact in a window of a step: see [`crate::Session::step_window`].
    ///
    /// # Errors
    /// Those of [`Session::step`], and a window that is none.
    pub fn step_window<A, B>(&mut self, x0: &A, x1: &B, window: [f64; 2]) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.step_of(ends(x0, x1), window)?;
        Ok(self.report())
    }

    /// How much of a step is certainly free: see [`crate::Session::collision_free_step_size`].
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

    /// All candidates of a step: see [`crate::Session::candidates`].
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn candidates<A, B>(&mut self, x0: &A, x1: &B) -> Result<Candidates<'_>, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.candidates_of(ends(x0, x1))
    }

    /// Where the mesh goes through itself at positions `x`, on the CPU: see
    /// [`crate::Session::intersections`].
    ///
    /// # Errors
    /// Those of [`crate::Session::intersections`].
    pub fn intersections<A>(&mut self, x: &A) -> Result<Vec<crate::Intersection>, crate::Error>
    where
        A: AsPositions + ?Sized,
    {
        match &mut self.0 {
            Either::Cpu(on) => on.intersections(x),
            Either::Gpu { on, .. } => crate::intersections(on.mesh(), x, on.options()),
        }
    }

    #[inline(never)]
    fn candidates_of(&mut self, ends: Ends) -> Result<Candidates<'_>, Error> {
        match ends {
            Precision::F32(x) => self.candidates_in(x),
            Precision::F64(x) => self.candidates_in(x),
        }
    }

    fn candidates_in<T: Coordinate>(
        &mut self,
        [x0, x1]: [PositionView<T>; 2],
    ) -> Result<Candidates<'_>, Error> {
        match self.0.run(|on| on.candidates(&x0, &x1), on_cpu)? {
            Turn::Done(all) => {
                let [vf, ee, ve, vv] = [all.vf, all.ee, all.ve, all.vv].map(Pairs::owned);
                Ok(Candidates { vf, ee, ve, vv })
            }
            Turn::Cpu(on) => {
                let all = on.candidates(&x0, &x1)?;
                let ([vf, ee], [ve, vv]) = (
                    [all.vf, all.ee].map(Pairs::lent),
                    [all.ve, all.vv].map(|of| Pairs::owned(of.to_vec())),
                );
                Ok(Candidates { vf, ee, ve, vv })
            }
        }
    }

    /// From now on steps of another mesh: see [`crate::Session::set_mesh`].
    ///
    /// # Errors
    /// [`Error::Input`] with bodies that do not fit, and, where the choice was a GPU alone, what
    /// that refuses. The session stays as it was.
    pub fn set_mesh(&mut self, mesh: impl Into<Arc<Mesh>>) -> Result<(), Error> {
        self.change_mesh(mesh.into(), None)
    }

    /// The same with other bodies, or without any.
    ///
    /// # Errors
    /// Those of [`Session::set_mesh`].
    pub fn set_mesh_and_bodies(
        &mut self,
        mesh: impl Into<Arc<Mesh>>,
        bodies: impl Into<Option<Bodies>>,
    ) -> Result<(), Error> {
        self.change_mesh(mesh.into(), Some(bodies.into()))
    }

    #[inline(never)]
    fn change_mesh(
        &mut self,
        mesh: Arc<Mesh>,
        bodies: Option<Option<Bodies>>,
    ) -> Result<(), Error> {
        let bodies = bodies.unwrap_or_else(|| self.options().bodies.clone());
        let on_gpu = |on: &mut gpu::Session| on.set_mesh_and_bodies(mesh.clone(), bodies.clone());
        match self.0.run(on_gpu, on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.set_mesh_and_bodies(mesh, bodies)?),
        }
    }

    /// From now on another minimum distance: see [`crate::Session::set_min_distance`].
    ///
    /// # Errors
    /// [`Error::Input`] with a bad distance, and, where the choice was a GPU alone, what that
    /// refuses. The session stays as it was.
    pub fn set_min_distance(&mut self, min_distance: f64) -> Result<(), Error> {
        match self.0.run(|on| on.set_min_distance(min_distance), on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.set_min_distance(min_distance)?),
        }
    }

    /// From now on other options: see [`crate::Session::set_options`]. What a GPU does not have is
    /// refused there; a new session would go to the CPU for it.
    ///
    /// # Errors
    /// [`Error::Input`] with options that are refused, and, where the choice was a GPU alone, what
    /// that refuses. The session stays as it was.
    pub fn set_options(&mut self, options: Options) -> Result<(), Error> {
        match self.0.run(|on| on.set_options(options.clone()), on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.set_options(options)?),
        }
    }

    /// From now on calls end with [`crate::Error::Cancelled`] once this token is cancelled: see
    /// [`crate::Session::set_cancel_token`]. On a GPU a frame that was submitted runs to its end.
    pub fn set_cancel_token(&mut self, token: impl Into<Option<CancelToken>>) {
        match &mut self.0 {
            Either::Cpu(on) => on.set_cancel_token(token),
            Either::Gpu { on, .. } => on.set_cancel_token(token),
        }
    }

    /// What the last step found.
    pub fn report(&self) -> &Report {
        match &self.0 {
            Either::Cpu(on) => on.report(),
            Either::Gpu { on, .. } => on.report(),
        }
    }

    /// The mesh of the next step. [`Report::mesh`] is that of the last one.
    pub fn mesh(&self) -> &Arc<Mesh> {
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
    let mut session = crate::Session::new(on.mesh().clone(), on.options().clone())?;
    session.set_cancel_token(on.cancel_token().cloned());
    Ok(session)
}
