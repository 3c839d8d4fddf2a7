//! What may change between steps: mesh, minimum distance, options. What depends on it is made anew,
//! the rest stays, buffers above all; each function checks all that can fail before it changes
//! anything.

use super::{Session, memory};
#[cfg(feature = "catalogue")]
use crate::broad_phase::descent_times::DescentTimes;
use crate::broad_phase::method::Method;
use crate::step::codimensional::Codimensional;
use crate::step::selection::Selection;
use crate::stop::Stop;
use crate::threads::Threads;
use ccd_core::Error;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::cancel::CancelToken;
use ccd_core::model::error::check_min_distance;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use std::sync::Arc;

/// Refuses a pipeline that a CPU does not have.
pub fn check_pipeline(options: &Options) -> Result<(), Error> {
    match options.pipeline.lacking("cpu") {
        Some(name) => Err(Error::Method { name, backend: "cpu" }),
        None => Ok(()),
    }
}

impl Session {
    /// From now on steps of another mesh, as after a topology change: vertices, edges and faces
    /// have new ids. Buffers stay, and grow where the mesh is larger; trees are built anew and
    /// fronts begin at the roots.
    ///
    /// The bodies of the options stay, if there are any: they must fit the new mesh. Where it has
    /// other vertices, give both at once, by [`Session::set_mesh_and_bodies`].
    ///
    /// ```
    /// use ccd_core::model::{mesh::Mesh, options::Options};
    /// use ccd_cpu::Session;
    ///
    /// let mut session = Session::new(Mesh::new(3, &[[0, 1, 2]])?, Options::default())?;
    /// session.set_mesh(Mesh::new(4, &[[0, 1, 2], [2, 1, 3]])?)?;
    /// assert_eq!(session.step(&[[0.0; 3]; 4], &[[0.0; 3]; 4])?.mesh().n_vertices(), 4);
    /// # Ok::<(), ccd_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::BodyCount`], [`Error::MixedBodies`] and [`Error::Memory`]; the session stays as it
    /// was.
    pub fn set_mesh(&mut self, mesh: impl Into<Arc<Mesh>>) -> Result<(), Error> {
        self.change_mesh(mesh.into(), None)
    }

    /// The same with other bodies, or without any.
    ///
    /// # Errors
    /// Those of [`Session::set_mesh`]; the session stays as it was.
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
        let mut options = self.options.clone();
        if let Some(bodies) = bodies {
            options.bodies = bodies;
        }
        options.check(&mesh)?;
        let Selection { rules, .. } = Selection::new(&options)?;
        let of_mesh = memory::for_mesh(&mesh, &options, self.threads()).max(self.of_mesh);
        let token = || self.threads.stop.token().cloned();
        let limited = options.max_memory.map(|_| memory::stop(token(), &options, of_mesh));
        let limited = limited.transpose()?;
        let codimensional = self.threads.enter(|| Codimensional::new(&mesh, &options))?;
        if let Some(stop) = limited {
            self.method = Method::new(options.broad_phase, options.scheduling)?;
            self.drop_lists();
            self.threads.stop = stop;
        }
        self.of_mesh = of_mesh;
        (self.mesh, self.options) = (mesh, options);
        (self.selection.rules, self.codimensional) = (rules, codimensional);
        self.prepared.set_mesh(&self.mesh, &self.options);
        self.prepared.set_rules(&self.mesh, self.selection.rules.as_ref());
        Ok(())
    }

    /// From now on another [`Options::min_distance`]. Order, trees and fronts stay.
    ///
    /// # Errors
    /// [`Error::MinDistance`]; the session stays as it was.
    pub fn set_min_distance(&mut self, min_distance: f64) -> Result<(), Error> {
        check_min_distance(min_distance)?;
        self.options.min_distance = min_distance;
        self.prepared.set_min_distance(&self.mesh, &self.options);
        Ok(())
    }

    /// From now on other options, of which those count that differ: a pool of threads is started
    /// only if their number does; a method, its scheduling or a pipeline that is another one builds
    /// anew, as bodies do.
    ///
    /// ```
    /// # use ccd_core::model::{mesh::Mesh, options::Options};
    /// # use ccd_cpu::Session;
    /// # let mut session = Session::new(Mesh::new(3, &[[0, 1, 2]])?, Options::default())?;
    /// session.set_options(session.options().clone().with_threads(1))?;
    /// # assert_eq!(session.threads(), 1);
    /// # Ok::<(), ccd_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Session::new`]; the session stays as it was.
    #[inline(never)]
    pub fn set_options(&mut self, options: Options) -> Result<(), Error> {
        options.check(&self.mesh)?;
        check_pipeline(&options)?;
        let old = &self.options;
        let source = |of: &Options| (of.broad_phase, of.scheduling, of.pipeline);
        let other_threads = options.threads != old.threads;
        let other_source = source(&options) != source(old);
        // Lists are counted as they grow, so that those that are there go.
        let recounts = options.max_memory.or(old.max_memory).is_some();
        let method = if other_source || recounts {
            Some(Method::new(options.broad_phase, options.scheduling)?)
        } else {
            None
        };
        let other_bodies = options.bodies != old.bodies;
        let Selection { rules, .. } = Selection::new(&options)?;
        let threads = if other_threads { Some(Threads::new(options.threads)?) } else { None };
        let n_threads = threads.as_ref().unwrap_or(&self.threads).count();
        let of_mesh = memory::for_mesh(&self.mesh, &options, n_threads).max(self.of_mesh);
        let stop = memory::stop(self.threads.stop.token().cloned(), &options, of_mesh)?;
        if method.is_some() || other_threads {
            let threads = threads.as_ref().unwrap_or(&self.threads);
            self.codimensional = threads.enter(|| Codimensional::new(&self.mesh, &options))?;
        }
        if let Some(threads) = threads {
            self.threads = threads;
        }
        (self.of_mesh, self.threads.stop) = (of_mesh, stop);
        if recounts {
            self.drop_lists();
        }
        self.options = options;
        if method.is_some() || other_bodies {
            self.prepared.set_mesh(&self.mesh, &self.options);
        }
        if other_bodies {
            self.prepared.set_rules(&self.mesh, rules.as_ref());
            self.selection.rules = rules;
        }
        if let Some(method) = method {
            self.method = method;
        }
        self.prepared.set_min_distance(&self.mesh, &self.options);
        Ok(())
    }

    /// From now on calls end with [`Error::Cancelled`] once this token is cancelled, at the latest
    /// when each thread has done the task that it is at, of which a step has a thousand and more
    /// (of preparations, the one that is being made); `None`: they run to their ends. The session
    /// stays usable: with another token, or none, it goes on as a new one would.
    ///
    /// ```
    /// use ccd_core::{Error, model::{cancel::CancelToken, mesh::Mesh, options::Options}};
    /// use ccd_cpu::Session;
    ///
    /// let mut session = Session::new(Mesh::new(3, &[[0, 1, 2]])?, Options::default())?;
    /// let token = CancelToken::new();
    /// session.set_cancel_token(token.clone());
    /// std::thread::spawn(move || token.cancel()).join().unwrap();
    /// let x = [[0.0; 3]; 3];
    /// assert_eq!(session.step(&x, &x).err(), Some(Error::Cancelled));
    /// session.set_cancel_token(None);
    /// assert!(session.step(&x, &x)?.contacts.is_empty());
    /// # Ok::<(), Error>(())
    /// ```
    pub fn set_cancel_token(&mut self, token: impl Into<Option<CancelToken>>) {
        let stop = Stop::new(token.into(), self.options.max_memory, self.threads.stop.held());
        self.threads.stop = Arc::new(stop);
    }

    /// The token that ends calls.
    pub fn cancel_token(&self) -> Option<&CancelToken> {
        self.threads.stop.token()
    }

    /// Drops all whose length depends on the steps, but for what the method and particles have.
    fn drop_lists(&mut self) {
        (self.workers, self.order) = Default::default();
        (self.listers, self.runs) = Default::default();
        self.report.contacts = Vec::new();
    }

    /// From now on, whether the clock is asked where the time of descents goes, which costs time
    /// itself: two looks for every list of pairs that is expanded.
    #[cfg(feature = "catalogue")]
    #[doc(hidden)]
    pub fn set_timed(&mut self, timed: bool) {
        self.method.set_timed(timed);
    }

    /// Where it went since [`Session::set_timed`]: if a scheduler was chosen, by
    /// [`Options::scheduling`], that is not the default's.
    #[cfg(feature = "catalogue")]
    #[doc(hidden)]
    pub fn descent_times(&self) -> Option<DescentTimes> {
        self.method.descent_times()
    }
}
