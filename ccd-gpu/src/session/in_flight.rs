//! A step in flight: calls that do not block. A frame loop submits, does other work and polls; a
//! program with an executor awaits.

use super::{Candidates, Engine};
use crate::clock::Instant;
use crate::error::Error;
use crate::step::upload::Input;
use crate::step::{Goal, WHOLE};
use ccd_core::model::error::check_window;
use ccd_core::model::options::Mode;
use ccd_core::model::positions::{AsPositions, Chosen, Ends, Gathered, ends};
use ccd_core::model::precision::{Given, Precision};
use ccd_core::model::report::Report;
use ccd_core::model::session::{self, Ask, Engine as _};
use core::time::Duration;
use std::future::poll_fn;
use std::mem::take;
use std::task::{Context, Poll, Waker};

/// A step whose report is not made yet.
pub(super) struct Flight {
    pub sought: Sought,
    /// When the call began.
    pub start: Instant,
    /// What checking and sending the positions took.
    pub uploaded: Duration,
    /// Whether its positions were copied.
    pub is_copied: bool,
}

/// What a frame looks for.
#[derive(Clone, Copy)]
pub(super) struct Sought {
    pub goal: Goal,
    pub window: [f64; 2],
    /// Whether contacts are listed that were found.
    pub lists: bool,
}

impl Sought {
    /// Candidates of the whole step.
    pub const CANDIDATES: Self = Self { goal: Goal::Candidates, window: WHOLE, lists: true };
}

/// Positions of a step that was submitted, which its end needs: what the device leaves open is
/// decided from them. In buffers that are kept.
#[derive(Default)]
pub(super) struct Copied {
    is_wide: bool,
    narrow: [Vec<[f32; 3]>; 2],
    wide: [Vec<[f64; 3]>; 2],
}

impl Copied {
    fn set(&mut self, given: Given) {
        fn copy<T: Copy>(to: &mut [Vec<T>; 2], from: [&[T]; 2]) {
            for (to, from) in to.iter_mut().zip(from) {
                to.clear();
                to.extend_from_slice(from);
            }
        }
        match given {
            Precision::F32(x) => copy(&mut self.narrow, x),
            Precision::F64(x) => copy(&mut self.wide, x),
        }
        self.is_wide = matches!(given, Precision::F64(_));
    }

    fn given(&self) -> Given<'_> {
        if self.is_wide {
            Precision::F64(self.wide.each_ref().map(|x| &x[..]))
        } else {
            Precision::F32(self.narrow.each_ref().map(|x| &x[..]))
        }
    }
}

/// Ends a call that is dropped, or fails, as an error ends it.
struct Unfinished<'a> {
    engine: &'a mut Engine,
    is_done: bool,
}

impl Drop for Unfinished<'_> {
    fn drop(&mut self) {
        if !self.is_done {
            self.engine.clear();
        }
    }
}

/// # Without blocking
///
/// A step is in flight from [`Engine::submit`], or from the first poll of a future, until its
/// report is there. Several sessions may each have one, on one device or on several. A call of a
/// session that gives the device other work, or changes mesh, options, buffers or what is timed,
/// forgets the step in flight; so does dropping a future. The session then finds what a new one
/// does. [`Engine::poll`], calls that only read,
/// [`Session::set_positions`](session::Session::set_positions) and
/// [`Session::set_cancel_token`](session::Session::set_cancel_token) leave it in flight.
///
/// Outside of a browser a device makes its results known only when it is asked. So each poll of a
/// future asks, and wakes its task at once: an executor that has nothing else to do polls all the
/// time. Where that matters, [`Engine::poll`] asks once.
impl Engine {
    /// Begins a step, of which [`Engine::poll`] gets the report: what
    /// [`Session::step`](session::Session::step) finds. Copies the positions, sends them and
    /// submits the work. A step that is still in flight is forgotten. Until the report is there,
    /// that of the session is empty.
    ///
    /// ```no_run
    /// use ccd::gpu::{Error, Session};
    ///
    /// /// Called once a frame. Contacts are those of the last step that has ended.
    /// fn frame(session: &mut Session, x: [&[[f32; 3]]; 2]) -> Result<(), Error> {
    ///     if !session.is_in_flight() {
    ///         session.submit(x[0], x[1])?;
    ///     }
    ///     // .. other work of the frame, then:
    ///     if let Some(report) = session.poll()? {
    ///         println!("{} contacts", report.contacts.len());
    ///     }
    ///     Ok(())
    /// }
    /// # let _ = frame;
    /// ```
    ///
    /// # Errors
    /// Those of [`Session::step`](session::Session::step).
    pub fn submit<A, B>(&mut self, x0: &A, x1: &B) -> Result<(), Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.submit_ask(ends(x0, x1), Ask::Contacts { window: WHOLE })
    }

    /// As [`Engine::submit`], for the earliest time of impact alone, which the report has then:
    /// [`Session::earliest_toi`](session::Session::earliest_toi).
    ///
    /// # Errors
    /// Those of [`Session::step`](session::Session::step).
    pub fn submit_earliest_toi<A, B>(&mut self, x0: &A, x1: &B) -> Result<(), Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.submit_ask(ends(x0, x1), Ask::Earliest { whose: false })
    }

    /// The report of the step that was submitted, if the device is done; it does not wait for it.
    /// If a list was too short, the work is submitted once more. What the device leaves open is
    /// decided here, and pairs of particles, and of particles and rods, are found here, for which
    /// it does wait.
    ///
    /// # Errors
    /// [`Error::NotSubmitted`] if no step is in flight; those of
    /// [`Session::step`](session::Session::step).
    pub fn poll(&mut self) -> Result<Option<&Report>, Error> {
        if !self.is_in_flight() {
            return Err(Error::NotSubmitted);
        }
        let copied = take(&mut self.copied);
        let polled =
            self.advance(Input::new(copied.given(), None), &mut Context::from_waker(Waker::noop()));
        self.copied = copied;
        match polled {
            Poll::Pending => Ok(None),
            Poll::Ready(Ok(())) => Ok(Some(&self.state.report)),
            Poll::Ready(Err(why)) => {
                self.clear();
                Err(why)
            }
        }
    }

    /// Whether a step was submitted whose report is not there yet.
    pub fn is_in_flight(&self) -> bool {
        self.flight.as_ref().is_some_and(|flight| flight.is_copied)
    }

    /// As [`Session::step`](session::Session::step), without blocking.
    ///
    /// ```no_run
    /// use ccd::gpu::{Error, Session};
    ///
    /// async fn contacts(session: &mut Session, x: [&[[f32; 3]]; 2]) -> Result<usize, Error> {
    ///     Ok(session.step_async(x[0], x[1]).await?.contacts.len())
    /// }
    /// # let _ = contacts;
    /// ```
    ///
    /// # Errors
    /// Those of [`Session::step`](session::Session::step).
    pub async fn step_async<A, B>(&mut self, x0: &A, x1: &B) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.ask(ends(x0, x1), Ask::Contacts { window: WHOLE }).await?;
        Ok(&self.state.report)
    }

    /// As [`Session::step_window`](session::Session::step_window), without blocking.
    ///
    /// # Errors
    /// Those of [`Session::step_window`](session::Session::step_window).
    pub async fn step_window_async<A, B>(
        &mut self,
        x0: &A,
        x1: &B,
        window: [f64; 2],
    ) -> Result<&Report, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.ask(ends(x0, x1), Ask::Contacts { window }).await?;
        Ok(&self.state.report)
    }

    /// As [`Session::earliest_toi`](session::Session::earliest_toi), without blocking.
    ///
    /// # Errors
    /// Those of [`Session::step`](session::Session::step).
    pub async fn earliest_toi_async<A, B>(&mut self, x0: &A, x1: &B) -> Result<Option<f64>, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        self.ask(ends(x0, x1), Ask::Earliest { whose: false }).await?;
        Ok(self.state.report.toi)
    }

    /// As [`Session::candidates`](session::Session::candidates), without blocking.
    ///
    /// # Errors
    /// Those of [`Session::step`](session::Session::step).
    pub async fn candidates_async<A, B>(&mut self, x0: &A, x1: &B) -> Result<Candidates, Error>
    where
        A: AsPositions + ?Sized,
        B: AsPositions<Scalar = A::Scalar> + ?Sized,
    {
        let ends = ends(x0, x1);
        let mut call = Unfinished { engine: self, is_done: false };
        let mut gathered = take(&mut call.engine.gathered);
        let mesh = call.engine.state.mesh.clone();
        let found = call.engine.list(session::given(&mesh, &mut gathered, ends)?).await?;
        call.engine.gathered = gathered;
        call.is_done = true;
        Ok(found)
    }

    async fn ask(&mut self, ends: Ends<'_>, ask: Ask) -> Result<(), Error> {
        let mut call = Unfinished { engine: self, is_done: false };
        check_window(ask.window())?;
        let mut gathered = take(&mut call.engine.gathered);
        let mesh = call.engine.state.mesh.clone();
        let (given, sought) =
            (session::given(&mesh, &mut gathered, ends)?, call.engine.sought(ask));
        call.engine.run(Input::new(given, None), sought).await?;
        call.engine.gathered = gathered;
        call.is_done = true;
        Ok(())
    }

    fn submit_ask(&mut self, ends: Ends, ask: Ask) -> Result<(), Error> {
        let (mut copied, mut gathered) = (take(&mut self.copied), take(&mut self.gathered));
        let begun = self.begin_copied(ends, ask, &mut copied, &mut gathered);
        (self.copied, self.gathered) = (copied, gathered);
        begun.inspect_err(|_| self.clear())
    }

    fn begin_copied(
        &mut self,
        ends: Ends,
        ask: Ask,
        copied: &mut Copied,
        gathered: &mut Gathered,
    ) -> Result<(), Error> {
        copied.set(session::given(&self.state.mesh, gathered, ends)?);
        let sought = self.sought(ask);
        self.begin(Input::new(copied.given(), None), sought)?;
        if let Some(flight) = &mut self.flight {
            flight.is_copied = true;
        }
        Ok(())
    }

    /// What [`session::Engine::find`] finds of a mesh whose vertices are some of those that have
    /// these positions. None of them moves that must not. While the device works, `holds` looks
    /// whether [`Chosen::scan`] covers the positions; where it does not, nothing was found.
    ///
    /// # Errors
    /// Those of [`session::Engine::find`].
    #[doc(hidden)]
    pub fn find_chosen(
        &mut self,
        given: Given,
        chosen: Chosen,
        ask: Ask,
        holds: impl FnOnce() -> bool,
    ) -> Result<bool, Error> {
        // Where the host reads all positions, they are copied first.
        let host = self.state.options.mode == Mode::Exact
            || self.codimensional.is_some()
            || self.frames.buffers.source.triangles().is_some();
        if host {
            if !holds() {
                return Ok(false);
            }
            let mut gathered = take(&mut self.gathered);
            let found = self.find(gathered.choose(given, chosen.vertices), None, ask);
            self.gathered = gathered;
            return found.map(|()| true);
        }
        let (device, sought) = (self.device.clone(), self.sought(ask));
        let input = Input { given, moved: None, chosen: Some(chosen) };
        device.block_on(self.run_if(input, sought, holds))
    }

    /// Makes the report of a step; what is in flight is forgotten if this is dropped.
    pub(super) async fn run(&mut self, input: Input<'_>, sought: Sought) -> Result<(), Error> {
        self.run_if(input, sought, || true).await.map(|_| ())
    }

    /// The same, unless it turns out while the device works that its input does not hold.
    async fn run_if(
        &mut self,
        input: Input<'_>,
        sought: Sought,
        holds: impl FnOnce() -> bool,
    ) -> Result<bool, Error> {
        let mut call = Unfinished { engine: self, is_done: false };
        call.engine.begin(input, sought)?;
        if !holds() {
            return Ok(false);
        }
        poll_fn(|context| call.engine.advance(input, context)).await?;
        call.is_done = true;
        Ok(true)
    }

    /// Forgets the step in flight.
    pub(super) fn abandon(&mut self) {
        self.flight = None;
        self.frames.abandon();
    }
}
