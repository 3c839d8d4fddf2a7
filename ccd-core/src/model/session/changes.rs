//! What may change between steps: mesh, options, bodies, a filter, what ends calls. Each function
//! checks what a mesh and options say; the engine does the rest, all of it or nothing.

use super::{Change, Engine, Session};
use crate::model::bodies::Bodies;
use crate::model::cancel::CancelToken;
use crate::model::contact::Kind;
use crate::model::error::{Error, check_min_distance};
use crate::model::mesh::Mesh;
use crate::model::options::Options;
use alloc::sync::Arc;

/// After an error, the session stays as it was.
impl<E: Engine, P> Session<E, P> {
    /// From now on steps of another mesh, as after a topology change: vertices, edges and faces
    /// have new ids. Buffers stay where they are large enough; trees are built anew and fronts
    /// begin at the roots. Of what an application has of a session on a device, the buffer of paths
    /// may be another one.
    ///
    /// The bodies of the options stay, if there are any: they must fit the new mesh. Where it has
    /// other vertices, give both at once, by [`Session::set_mesh_and_bodies`].
    ///
    /// # Errors
    /// [`Error::BodyCount`], [`Error::MixedBodies`] and [`Error::Memory`]; what the device refuses.
    pub fn set_mesh(&mut self, mesh: impl Into<Arc<Mesh>>) -> Result<(), E::Error> {
        self.change_mesh(mesh.into(), self.options().clone())
    }

    /// The same with other bodies, or without any.
    ///
    /// # Errors
    /// Those of [`Session::set_mesh`].
    pub fn set_mesh_and_bodies(
        &mut self,
        mesh: impl Into<Arc<Mesh>>,
        bodies: impl Into<Option<Bodies>>,
    ) -> Result<(), E::Error> {
        self.change_mesh(mesh.into(), self.options().clone().with_bodies(bodies))
    }

    fn change_mesh(&mut self, mesh: Arc<Mesh>, options: Options) -> Result<(), E::Error> {
        options.check(&mesh)?;
        let same = Arc::ptr_eq(&mesh, self.mesh());
        self.engine.change(Change::Mesh(mesh, options))?;
        self.engine.kept().forget(!same);
        Ok(())
    }

    /// From now on another [`Options::min_distance`]. Order, trees and fronts are kept, except on a
    /// GPU with free regions, which there are only without a distance.
    ///
    /// # Errors
    /// [`Error::MinDistance`]; [`Error::ExactDistance`]; what the device refuses.
    pub fn set_min_distance(&mut self, min_distance: f64) -> Result<(), E::Error> {
        check_min_distance(min_distance)?;
        self.options().mode.check(min_distance)?;
        self.engine.change(Change::MinDistance(min_distance))
    }

    /// From now on other options, of which those count that differ: a pool of threads is started
    /// only if their number does; a method, its scheduling or a pipeline that is another one builds
    /// anew, as bodies do. What a GPU does not have is refused there, whatever chose it. Memory
    /// that a CPU's session once took stays its own, and counts against [`Options::max_memory`].
    ///
    /// # Errors
    /// Those of [`Session::new`].
    pub fn set_options(&mut self, options: Options) -> Result<(), E::Error> {
        self.change_mesh(self.mesh().clone(), options)
    }

    /// From now on these bodies, or none. Buffers are kept; the next step sorts boxes again. With
    /// [`Pipeline::Triangles`](crate::model::pipeline::Pipeline) on a GPU the records of triangles
    /// are sent again.
    ///
    /// # Errors
    /// Those of [`Bodies::check`], and too many classes of bodies; what the device refuses.
    pub fn set_bodies(&mut self, bodies: impl Into<Option<Bodies>>) -> Result<(), E::Error> {
        self.change_bodies(bodies.into())
    }

    /// From now on a body sleeps, or is awake. While it sleeps it is as one that is fixed, see
    /// [`Bodies::with_sleeping`].
    ///
    /// # Errors
    /// [`Error::NoBody`] if no vertex belongs to it, or there are no bodies; what the device
    /// refuses.
    pub fn set_sleeping(&mut self, body: u32, sleeping: bool) -> Result<(), E::Error> {
        let mut bodies = self.bodies_with(body)?;
        bodies.set_sleeping(body, sleeping)?;
        self.change_bodies(Some(bodies))
    }

    /// From now on a body is fixed, or moves: see [`Bodies::with_fixed`].
    ///
    /// # Errors
    /// Those of [`Session::set_sleeping`].
    pub fn set_fixed(&mut self, body: u32, fixed: bool) -> Result<(), E::Error> {
        let mut bodies = self.bodies_with(body)?;
        bodies.set_fixed(body, fixed)?;
        self.change_bodies(Some(bodies))
    }

    /// From now on bodies that are fixed or asleep may be moved by the caller, or not: see
    /// [`Bodies::with_fixed_motion`]. Without bodies this does nothing.
    ///
    /// # Errors
    /// None but those of [`Session::set_bodies`].
    pub fn set_fixed_motion(&mut self, may_move: bool) -> Result<(), E::Error> {
        let bodies = self.options().bodies.clone();
        self.change_bodies(bodies.map(|bodies| bodies.with_fixed_motion(may_move)))
    }

    fn bodies_with(&self, body: u32) -> Result<Bodies, Error> {
        self.options().bodies.clone().ok_or(Error::NoBody { body })
    }

    fn change_bodies(&mut self, bodies: Option<Bodies>) -> Result<(), E::Error> {
        if bodies == self.options().bodies {
            return Ok(());
        }
        bodies.as_ref().map_or(Ok(()), |bodies| bodies.check(self.mesh()))?;
        self.engine.change(Change::Bodies(bodies))?;
        self.engine.kept().forget(false);
        Ok(())
    }

    /// From now on pairs of features for which `filter` says no are left out: by their kind and
    /// ids, of edges the lesser first. Asked by many threads at once, of pairs alone whose boxes
    /// overlap, and in no order; it must say the same of a pair throughout a call.
    ///
    /// # Errors
    /// [`Error::Filter`] on a GPU, which cannot call it: lists of excluded features and bodies say
    /// what it can. Where the CPU may take over from a GPU, it does, and there is no error.
    pub fn set_filter(
        &mut self,
        filter: impl Fn(Kind, u32, u32) -> bool + Send + Sync + 'static,
    ) -> Result<(), E::Error> {
        self.engine.change(Change::Filter(Some(Arc::new(filter))))
    }

    /// From now on no filter.
    pub fn remove_filter(&mut self) {
        _ = self.engine.change(Change::Filter(None));
    }

    /// From now on calls end with [`Error::Cancelled`] once this token is cancelled; `None`: they
    /// run to their ends. The session stays usable: with another token, or none, it goes on as a
    /// new one would.
    ///
    /// On a CPU, at the latest when each thread has done the task that it is at, of which a step
    /// has a thousand and more (of preparations, the one that is being made). On a GPU, before the
    /// next frame is submitted: one that was submitted runs to its end.
    pub fn set_cancel_token(&mut self, token: impl Into<Option<CancelToken>>) {
        self.engine.set_cancel_token(token.into());
    }
}
