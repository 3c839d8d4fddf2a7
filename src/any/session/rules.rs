//! Rules of a session on either backend that change between steps.

use super::{Either, Error, Session, Turn, on_cpu};
use crate::{Bodies, Kind};

impl Session {
    /// From now on these bodies, or none: see [`crate::Session::set_bodies`].
    ///
    /// # Errors
    ///
    /// As there; then all is as before.
    pub fn set_bodies(&mut self, bodies: impl Into<Option<Bodies>>) -> Result<(), Error> {
        let bodies = bodies.into();
        match self.0.run(|on| on.set_bodies(bodies.clone()), on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.set_bodies(bodies)?),
        }
    }

    /// From now on a body sleeps, or is awake: see [`crate::Session::set_sleeping`].
    ///
    /// # Errors
    ///
    /// As there.
    pub fn set_sleeping(&mut self, body: u32, sleeping: bool) -> Result<(), Error> {
        match self.0.run(|on| on.set_sleeping(body, sleeping), on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.set_sleeping(body, sleeping)?),
        }
    }

    /// From now on a body is fixed, or moves: see [`crate::Session::set_fixed`].
    ///
    /// # Errors
    ///
    /// As there.
    pub fn set_fixed(&mut self, body: u32, fixed: bool) -> Result<(), Error> {
        match self.0.run(|on| on.set_fixed(body, fixed), on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.set_fixed(body, fixed)?),
        }
    }

    /// From now on bodies that are fixed or asleep may be moved by the caller, or not: see
    /// [`crate::Session::set_fixed_motion`].
    ///
    /// # Errors
    ///
    /// As there.
    pub fn set_fixed_motion(&mut self, may_move: bool) -> Result<(), Error> {
        match self.0.run(|on| on.set_fixed_motion(may_move), on_cpu)? {
            Turn::Done(()) => Ok(()),
            Turn::Cpu(on) => Ok(on.set_fixed_motion(may_move)?),
        }
    }

    /// From now on pairs of features for which `filter` says no are left out: see
    /// [`crate::Session::set_filter`]. A choice that was free goes on with the CPU.
    ///
    /// # Errors
    ///
    /// [`crate::Error::Filter`] on a GPU that was chosen.
    pub fn set_filter(
        &mut self,
        filter: impl Fn(Kind, u32, u32) -> bool + Send + Sync + 'static,
    ) -> Result<(), Error> {
        if let Either::Gpu { on, free, notice } = &self.0 {
            let why = Error::Input(crate::Error::Filter { backend: "gpu" });
            if !*free {
                return Err(why);
            }
            if let Some(notice) = notice {
                notice(&why);
            }
            self.0 = Either::Cpu(Box::new(on_cpu(on)?));
        }
        if let Either::Cpu(on) = &mut self.0 {
            on.set_filter(filter);
        }
        Ok(())
    }
}
