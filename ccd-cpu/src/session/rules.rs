//! Rules of a session that change between steps: bodies, what sleeps, what is fixed, a filter.

use super::Session;
use crate::step::selection::Selection;
use ccd_core::Error;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::contact::Kind;

impl Session {
    /// From now on these bodies, or none. Buffers are kept; the next step sorts boxes again.
    ///
    /// # Errors
    ///
    /// Those of [`Bodies::check`], and too many classes of bodies; then all is as before.
    pub fn set_bodies(&mut self, bodies: impl Into<Option<Bodies>>) -> Result<(), Error> {
        self.take_bodies(bodies.into())
    }

    /// From now on a body sleeps, or is awake. While it sleeps it is as one that is fixed, see
    /// [`Bodies::with_sleeping`].
    ///
    /// # Errors
    ///
    /// [`Error::NoBody`] if no vertex belongs to it, or there are no bodies.
    pub fn set_sleeping(&mut self, body: u32, sleeping: bool) -> Result<(), Error> {
        self.change(body, |bodies| bodies.set_sleeping(body, sleeping))
    }

    /// From now on a body is fixed, or moves: see [`Bodies::with_fixed`].
    ///
    /// # Errors
    ///
    /// [`Error::NoBody`] if no vertex belongs to it, or there are no bodies.
    pub fn set_fixed(&mut self, body: u32, fixed: bool) -> Result<(), Error> {
        self.change(body, |bodies| bodies.set_fixed(body, fixed))
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

    /// From now on pairs of features for which `filter` says no are left out: by their kind and
    /// ids, of edges the lesser first. Asked by many threads at once, of pairs alone whose boxes
    /// overlap, and in no order; it must say the same of a pair throughout a call.
    pub fn set_filter(&mut self, filter: impl Fn(Kind, u32, u32) -> bool + Send + Sync + 'static) {
        self.selection.filter = Some(Box::new(filter));
    }

    /// From now on no filter.
    pub fn remove_filter(&mut self) {
        self.selection.filter = None;
    }

    fn change(
        &mut self,
        body: u32,
        change: impl FnOnce(&mut Bodies) -> Result<(), Error>,
    ) -> Result<(), Error> {
        let mut bodies = self.options.bodies.clone().ok_or(Error::NoBody { body })?;
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
        let Selection { rules, .. } = Selection::new(&options)?;
        self.prepared.set_rules(&self.mesh, rules.as_ref());
        self.selection.rules = rules;
        self.options = options;
        Ok(())
    }
}
