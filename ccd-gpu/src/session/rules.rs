//! Rules of a session that change between steps: bodies, what sleeps, what is fixed.

use super::Session;
use crate::error::Error;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::contact::Kind;

impl Session {
    /// From now on these bodies, or none. Buffers of positions, trees and lists are kept; the next
    /// step sorts boxes again. With [`Pipeline::Triangles`](ccd_core::model::pipeline::Pipeline)
    /// the records of triangles are sent again.
    ///
    /// # Errors
    ///
    /// Those of [`Bodies::check`], too many classes of bodies, and those of the device; then all is
    /// as before.
    pub fn set_bodies(&mut self, bodies: impl Into<Option<Bodies>>) -> Result<(), Error> {
        self.take_bodies(bodies.into())
    }

    /// From now on a body sleeps, or is awake. While it sleeps it is as one that is fixed, see
    /// [`Bodies::with_sleeping`].
    ///
    /// # Errors
    ///
    /// [`ccd_core::Error::NoBody`] if no vertex belongs to it, or there are no bodies.
    pub fn set_sleeping(&mut self, body: u32, sleeping: bool) -> Result<(), Error> {
        self.change_body(body, |bodies| bodies.set_sleeping(body, sleeping))
    }

    /// From now on a body is fixed, or moves: see [`Bodies::with_fixed`].
    ///
    /// # Errors
    ///
    /// [`ccd_core::Error::NoBody`] if no vertex belongs to it, or there are no bodies.
    pub fn set_fixed(&mut self, body: u32, fixed: bool) -> Result<(), Error> {
        self.change_body(body, |bodies| bodies.set_fixed(body, fixed))
    }

    /// From now on bodies that are fixed or asleep may be moved by the caller, or not: see
    /// [`Bodies::with_fixed_motion`]. Without bodies this does nothing.
    ///
    /// # Errors
    ///
    /// None but those of [`Session::set_bodies`].
    pub fn set_fixed_motion(&mut self, may_move: bool) -> Result<(), Error> {
        let bodies = self.options.bodies.clone();
        self.take_bodies(bodies.map(|bodies| bodies.with_fixed_motion(may_move)))
    }

    /// Refused: a device cannot call a filter. Lists of excluded features and bodies say what it
    /// can.
    ///
    /// # Errors
    ///
    /// [`ccd_core::Error::Filter`], always.
    pub fn set_filter(
        &mut self,
        _filter: impl Fn(Kind, u32, u32) -> bool + Send + Sync + 'static,
    ) -> Result<(), Error> {
        Err(ccd_core::Error::Filter { backend: "gpu" }.into())
    }

    fn change_body(
        &mut self,
        body: u32,
        change: impl FnOnce(&mut Bodies) -> Result<(), ccd_core::Error>,
    ) -> Result<(), Error> {
        let bodies = self.options.bodies.clone();
        let mut bodies = bodies.ok_or(ccd_core::Error::NoBody { body })?;
        change(&mut bodies)?;
        self.take_bodies(Some(bodies))
    }

    #[inline(never)]
    fn take_bodies(&mut self, bodies: Option<Bodies>) -> Result<(), Error> {
        if bodies == self.options.bodies {
            return Ok(());
        }
        let options = self.options.clone().with_bodies(bodies);
        options.check(&self.mesh)?;
        self.frames.set_bodies(&self.device, &self.mesh, &options)?;
        self.options = options;
        Ok(())
    }
}
