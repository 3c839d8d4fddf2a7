//! What may change between steps: mesh, minimum distance, options. What depends on it is made anew,
//! the rest stays, buffers above all; each function checks all that can fail before it changes
//! anything.

use super::{Session, check_pipeline};
use crate::broad_phase::descent_times::DescentTimes;
use crate::broad_phase::method::Method;
use crate::step::codimensional::Codimensional;
use crate::step::selection::Selection;
use crate::threads::Threads;
use ccd_core::Error;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::error::check_min_distance;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use std::sync::Arc;

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
    /// [`Error::BodyCount`] and [`Error::MixedBodies`]; the session stays as it was.
    pub fn set_mesh(&mut self, mesh: impl Into<Arc<Mesh>>) -> Result<(), Error> {
        self.change_mesh(mesh.into(), None)
    }

    /// The same with other bodies, or without any.
    ///
    /// # Errors
    /// [`Error::BodyCount`] and [`Error::MixedBodies`]; the session stays as it was.
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
        let codimensional = self.threads.enter(|| Codimensional::new(&mesh, &options))?;
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
        let method = if source(&options) == source(old) {
            None
        } else {
            Some(Method::new(options.broad_phase, options.scheduling)?)
        };
        let other_bodies = options.bodies != old.bodies;
        let Selection { rules, .. } = Selection::new(&options)?;
        let other_threads = options.threads != old.threads;
        let threads = if other_threads { Some(Threads::new(options.threads)?) } else { None };
        if method.is_some() || other_threads {
            let threads = threads.as_ref().unwrap_or(&self.threads);
            self.codimensional = threads.enter(|| Codimensional::new(&self.mesh, &options))?;
        }
        if let Some(threads) = threads {
            self.threads = threads;
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

    /// From now on, whether the clock is asked where the time of descents goes, which costs time
    /// itself: two looks for every list of pairs that is expanded.
    pub fn set_timed(&mut self, timed: bool) {
        self.method.set_timed(timed);
    }

    /// Where it went since [`Session::set_timed`]: if a scheduler was chosen, by
    /// [`Options::scheduling`], that is not the default's.
    pub fn descent_times(&self) -> Option<DescentTimes> {
        self.method.descent_times()
    }
}
