//! A mesh stepped frame by frame: every call of a session, once for all backends. What calls come
//! down to is done by an [`Engine`], which each backend has.

mod both_ends;
mod candidates;
mod changes;
mod engine;
mod first_contact;
mod moving;
mod runs;

pub use both_ends::{Rigid, Rigids};
pub use candidates::{Candidates, Intersection};
pub use engine::{Ask, Change, Engine, Filter, Intersects, State};
pub use first_contact::Hit;
pub use moving::{BodyMotion, Kept, Moved, given};
pub use runs::RunsOfBodies;

use super::cancel::CancelToken;
use super::error::{Error, check_window};
use super::mesh::Mesh;
use super::options::Options;
use super::positions::{AsPositions, Ends, Gathered, ends};
use super::precision::Given;
use super::report::Report;
use alloc::sync::Arc;
use alloc::vec::Vec;
use core::marker::PhantomData;
use core::mem;
use core::ops::{Deref, DerefMut};

/// Continuous collision detection of one mesh over many steps.
///
/// Positions are whatever is [`AsPositions`]: slices, arrays and vectors of `[f32; 3]` or
/// `[f64; 3]`, bytes with a stride, posed bodies, vectors of `glam`. Between steps, the `set_`
/// functions change what a session was made with; the next step finds what a new session would.
///
/// `E` is the [`Engine`] of a backend, and `P` says what a session is opened on: nothing for a CPU,
/// a device for a GPU ([`On`]). Backends name their sessions: `ccd_cpu::Session`,
/// `ccd_gpu::Session`, `ccd::any::Session`. A session dereferences to its engine, which has the
/// calls that only one backend has.
///
/// Errors are [`Error`] on a CPU, and the variant `Input` of a GPU's error, which has others for
/// what a device refuses. After an error a session stays usable; after the loss of a device, on
/// another one.
#[derive(Debug)]
pub struct Session<E, P = ()> {
    engine: E,
    gathered: Gathered,
    place: PhantomData<fn() -> P>,
}

/// Marks sessions that are opened on a `D`.
#[derive(Debug)]
pub struct On<D>(PhantomData<D>);

impl<E: Engine<On = ()>> Session<E> {
    /// A session for `mesh`: a [`Mesh`], a reference to one, which is copied, or an `Arc` of one,
    /// which is shared.
    ///
    /// # Errors
    /// What [`Options::check`] refuses; [`Error::Method`] for what the backend does not have;
    /// [`Error::Threads`]; [`Error::Memory`].
    pub fn new(mesh: impl Into<Arc<Mesh>>, options: Options) -> Result<Self, E::Error> {
        Self::of(&(), mesh.into(), options)
    }
}

impl<E: Engine<On = D>, D> Session<E, On<D>> {
    /// A session on `on` (a device, or a choice of one) for `mesh`: a [`Mesh`], a reference to one,
    /// which is copied, or an `Arc` of one, which is shared.
    ///
    /// # Errors
    /// What [`Options::check`] refuses; [`Error::Method`] for what the backend does not have; what
    /// the device refuses.
    pub fn new(on: &D, mesh: impl Into<Arc<Mesh>>, options: Options) -> Result<Self, E::Error> {
        Self::of(on, mesh.into(), options)
    }
}

impl<E: Engine, P> Session<E, P> {
    fn of(on: &E::On, mesh: Arc<Mesh>, options: Options) -> Result<Self, E::Error> {
        options.check(&mesh)?;
        let engine = E::new(on, State::new(mesh, options))?;
        Ok(Self { engine, gathered: Gathered::default(), place: PhantomData })
    }

    /// The mesh of the next step. [`Report::mesh`] is that of the last one.
    pub fn mesh(&self) -> &Arc<Mesh> {
        &self.engine.state().mesh
    }

    /// The options.
    pub fn options(&self) -> &Options {
        &self.engine.state().options
    }

    /// What the last step or search for the first contact found; empty if that ended with an error.
    /// Listing candidates and changes of the session may empty it.
    pub fn report(&self) -> &Report {
        &self.engine.state().report
    }

    /// The token that ends calls.
    pub fn cancel_token(&self) -> Option<&CancelToken> {
        self.engine.cancel_token()
    }

    /// Every contact while vertices move on straight lines from `x0` to `x1`, one position per
    /// vertex of the mesh.
    ///
    /// On a CPU, after the first steps, nothing is allocated unless there are more contacts than
    /// before.
    ///
    /// # Errors
    /// [`Error::VertexCount`] and [`Error::Coordinate`]; for positions that are no slices, what
    /// their type says; [`Error::FixedMoves`]; [`Error::TooMany`] where a method
    /// was chosen that has such a limit; [`Error::Memory`] and [`Error::Cancelled`]; what
    /// the device refuses. The session stays usable, and its report is empty.
    pub fn step<A, B>(&mut self, x0: &A, x1: &B) -> Result<&Report, E::Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.step_window(x0, x1, [0.0, 1.0])
    }

    /// Every contact of a step up to time `t_max` in `[0, 1]`: as [`Session::step_window`] from 0.
    ///
    /// # Errors
    /// Those of [`Session::step_window`].
    pub fn step_until<A, B>(&mut self, x0: &A, x1: &B, t_max: f64) -> Result<&Report, E::Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.step_window(x0, x1, [0.0, t_max])
    }

    /// Every contact that exists at some time in a window `[t_a, t_b]` of a step, with times of
    /// impact in units of the whole step: the first such time at or after `t_a`. Boxes of features
    /// of faces are swept only for the window.
    ///
    /// # Errors
    /// [`Error::Window`] unless `0 <= t_a <= t_b <= 1`, besides those of [`Session::step`].
    pub fn step_window<A, B>(
        &mut self,
        x0: &A,
        x1: &B,
        window: [f64; 2],
    ) -> Result<&Report, E::Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.ask(ends(x0, x1), Ask::Contacts { window })?;
        Ok(self.report())
    }

    /// The earliest time of impact of the step, without the list of contacts: cheaper than
    /// [`Session::step`]. `None`: the whole step is free.
    ///
    /// Before it nothing touches. On a CPU it is the time of the earliest contact of the step, if
    /// that is a [`State::Hit`](super::contact::State::Hit). If it is undecided, the shorter step
    /// that is searched may show that it is none, and a later time is returned; which one may
    /// depend on the method and on calls before. On a GPU it is rounded
    /// down to an `f32`; in exact mode, and with a tolerance below 1e-7, which an `f32` cannot
    /// keep, it is not rounded there, and costs time and memory as [`Session::step`].
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn earliest_toi<A, B>(&mut self, x0: &A, x1: &B) -> Result<Option<f64>, E::Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.ask(ends(x0, x1), Ask::Earliest { whose: false })?;
        Ok(self.report().toi)
    }

    /// How much of the step is certainly free of contact: 1 if all of it is, else
    /// [`Session::earliest_toi`], which may be 0.
    ///
    /// With [`Options::leave_contact`], "free" means for features that are in contact at the start
    /// and separate that they neither come nearer than at the start nor touch again. At the time
    /// itself there may be contact: what keeps some distance goes by
    /// [`scaled_toi`](super::toi::scaled_toi) of it.
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn collision_free_step_size<A, B>(&mut self, x0: &A, x1: &B) -> Result<f64, E::Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        Ok(self.earliest_toi(x0, x1)?.unwrap_or(1.0))
    }

    /// From now on all vertices stand at `x`, until [`Session::step_bodies`] and
    /// [`Session::earliest_toi_of_bodies`] move bodies. Positions are copied.
    ///
    /// # Errors
    /// [`Error::VertexCount`], and what the type of positions says. Coordinates are checked by the
    /// next of these calls.
    pub fn set_positions<A>(&mut self, x: &A) -> Result<(), Error>
    where
        A: AsPositions + ?Sized,
    {
        let mesh = self.mesh().clone();
        self.engine.kept().set(&mesh, ends(x, x))
    }

    /// Every contact of a step in which these bodies move and all others stand where the last call
    /// that moved them left them, or [`Session::set_positions`]: what [`Session::step`] finds for
    /// the same positions, and the same bits.
    ///
    /// On a CPU, by the default method and pipeline, boxes and trees are made of the bodies alone
    /// that move in this call or moved in the one before; where these have more than a quarter of
    /// all vertices, of all but what is fixed or asleep. Pairs are sought among all others, since
    /// bodies at rest may touch. Of a body of 32 vertices or more without self-contact, in one
    /// world, that moves by poses ([`BodyMotion::posed`]), vertices alone are made anew: boxes in
    /// its tree are moved where something is near, and features have boxes where it is very near.
    /// After any other call, a change of options or bodies, or an error, the next one makes all.
    ///
    /// A body that is named stands at its `x1` afterwards; after an error all stand where they
    /// stood.
    ///
    /// ```
    /// use ccd::{Bodies, BodyMotion, Mesh, Options, Session};
    ///
    /// // A floor of one face, and a particle above it.
    /// let bodies = Bodies::new(&[0, 0, 0, 1]).with_fixed(0, true).with_self_contacts(false);
    /// let options = Options::default().with_bodies(bodies);
    /// let mut session = Session::new(Mesh::new(4, &[[0, 1, 2]])?, options)?;
    /// let x = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, 1.0, 0.2]];
    /// session.set_positions(&x)?;
    /// let (from, to) = ([x[3]], [[0.2, -1.0, 0.2]]);
    /// let report = session.step_bodies(&[BodyMotion::new(1, &from, &to)])?;
    /// assert_eq!(report.contacts.len(), 1);
    /// # Ok::<(), ccd::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::NoPositions`] before [`Session::set_positions`]; [`Error::NoBody`];
    /// [`Error::RepeatedBody`]; [`Error::BodyPositions`]; [`Error::MixedPrecision`]; besides those
    /// of [`Session::step`].
    pub fn step_bodies(&mut self, motions: &[BodyMotion]) -> Result<&Report, E::Error> {
        self.ask_of_bodies(motions, Ask::Contacts { window: [0.0, 1.0] })?;
        Ok(self.report())
    }

    /// The earliest time of impact of a step in which these bodies move: what
    /// [`Session::earliest_toi`] is to [`Session::step`].
    ///
    /// # Errors
    /// Those of [`Session::step_bodies`].
    pub fn earliest_toi_of_bodies(
        &mut self,
        motions: &[BodyMotion],
    ) -> Result<Option<f64>, E::Error> {
        self.ask_of_bodies(motions, Ask::Earliest { whose: false })?;
        Ok(self.report().toi)
    }

    /// Lists all [`Candidates`] of the step: pairs of features whose swept boxes overlap, without
    /// those that share a vertex or that the bodies rule out.
    ///
    /// A step does not need this: on a CPU it never lists them.
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn candidates<A, B>(&mut self, x0: &A, x1: &B) -> Result<E::Candidates<'_>, E::Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        let Self { engine, gathered, .. } = self;
        match given(&engine.state().mesh, gathered, ends(x0, x1)) {
            Ok(given) => engine.candidates(given),
            Err(why) => {
                engine.clear();
                Err(why.into())
            }
        }
    }

    /// Edges and faces at positions `x` that have a point in common but no vertex, sorted by edge,
    /// then by face: where the mesh goes through itself. Found on the CPU, wherever steps run.
    ///
    /// Both are closed: touching counts. Nothing is rounded. The report of the last step stays, and
    /// its trees serve again, if they are those of a CPU's default method and pipeline.
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn intersections<A>(&mut self, x: &A) -> Result<Vec<Intersection>, Error>
    where
        A: AsPositions + ?Sized,
        E: Intersects,
    {
        self.through(ends(x, x), false)
    }

    /// Whether an edge and a face without a common vertex have a point in common at positions `x`:
    /// whether [`Session::intersections`] would list any. The search ends with the first.
    ///
    /// # Errors
    /// Those of [`Session::step`].
    pub fn has_intersections<A>(&mut self, x: &A) -> Result<bool, Error>
    where
        A: AsPositions + ?Sized,
        E: Intersects,
    {
        Ok(!self.through(ends(x, x), true)?.is_empty())
    }

    fn through(&mut self, ends: Ends, first: bool) -> Result<Vec<Intersection>, Error>
    where
        E: Intersects,
    {
        let Self { engine, gathered, .. } = self;
        let given = given(&engine.state().mesh, gathered, ends)?;
        engine.intersections(given, first)
    }

    /// Asks something of a step.
    fn ask(&mut self, ends: Ends, ask: Ask) -> Result<(), E::Error> {
        let Self { engine, gathered, .. } = self;
        let checked = check_window(ask.window());
        let given = checked.and_then(|()| given(&engine.state().mesh, gathered, ends));
        let done = given.map_err(E::Error::from).and_then(|given| engine.find(given, None, ask));
        self.settled(done)
    }

    /// Asks something of a step in which bodies move.
    fn ask_of_bodies(&mut self, motions: &[BodyMotion], ask: Ask) -> Result<(), E::Error> {
        self.with_bodies_moved(motions, |engine, given, moved| engine.find(given, moved, ask))
    }

    /// What `find` finds while bodies move; they stand where they went, if it ends well.
    fn with_bodies_moved<T>(
        &mut self,
        motions: &[BodyMotion],
        find: impl FnOnce(&mut E, Given, Option<Moved>) -> Result<T, E::Error>,
    ) -> Result<T, E::Error> {
        /// Bodies on their way: they stand where they stood unless `find` ends well, also if it
        /// unwinds.
        struct Moving<'a, E: Engine> {
            engine: &'a mut E,
            kept: Kept,
            fails: bool,
        }
        impl<E: Engine> Drop for Moving<'_, E> {
            fn drop(&mut self) {
                self.kept.end(self.fails);
                *self.engine.kept() = mem::take(&mut self.kept);
            }
        }
        let engine = &mut self.engine;
        let kept = mem::take(engine.kept());
        let mut moving = Moving { engine, kept, fails: true };
        let Moving { engine, kept, .. } = &mut moving;
        let begun = kept.begin(engine.state().options.bodies.as_ref(), motions);
        let done = begun
            .map_err(E::Error::from)
            .and_then(|(given, moved)| find(engine, given, Some(moved)));
        moving.fails = done.is_err();
        drop(moving);
        self.settled(done)
    }

    /// Empties the report after a call that failed.
    fn settled<T>(&mut self, done: Result<T, E::Error>) -> Result<T, E::Error> {
        if done.is_err() {
            self.engine.clear();
        }
        done
    }
}

impl<E, P> Deref for Session<E, P> {
    type Target = E;

    fn deref(&self) -> &E {
        &self.engine
    }
}

impl<E, P> DerefMut for Session<E, P> {
    fn deref_mut(&mut self) -> &mut E {
        &mut self.engine
    }
}
