//! What may change between steps: mesh, options, bodies. What depends on it is made anew, the rest
//! stays, buffers above all; each function makes all that can fail before it changes anything.

use super::{Engine, memory};
use crate::broad_phase::method::Method;
use crate::step::codimensional::Codimensional;
use crate::step::selection::Selection;
use crate::threads::Threads;
use ccd_core::Error;
use ccd_core::backend::rules::Rules;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::report::Report;
use std::sync::Arc;

impl Engine {
    #[inline(never)]
    pub(super) fn set_mesh(&mut self, mesh: Arc<Mesh>, options: Options) -> Result<(), Error> {
        options.check_backend("cpu")?;
        let old = &self.state.options;
        let other_mesh = !Arc::ptr_eq(&mesh, &self.state.mesh);
        let source =
            |options: &Options| (options.broad_phase, options.scheduling, options.pipeline);
        let other_threads = options.threads != old.threads;
        let other_source = source(&options) != source(old);
        // Lists are counted as they grow, so that those that are there go.
        let recounts = options.max_memory.or(old.max_memory).is_some();
        let method = if other_source || recounts {
            Some(Method::new(options.broad_phase, options.scheduling)?)
        } else {
            None
        };
        let other_rules = other_mesh || options.bodies != old.bodies;
        let Selection { rules, .. } = Selection::new(&options)?;
        let threads = if other_threads { Some(Threads::new(options.threads)?) } else { None };
        let n_threads = threads.as_ref().unwrap_or(&self.threads).count();
        let of_mesh = memory::for_mesh(&mesh, &options, n_threads).max(self.of_mesh);
        let stop = if recounts || other_threads {
            Some(memory::stop(self.threads.stop.token().cloned(), &options, of_mesh)?)
        } else {
            None
        };
        if other_mesh || method.is_some() || other_threads {
            let threads = threads.as_ref().unwrap_or(&self.threads);
            self.codimensional = threads.enter(|| Codimensional::new(&mesh, &options))?;
        }
        if let Some(threads) = threads {
            self.threads = threads;
        }
        self.of_mesh = of_mesh;
        if let Some(stop) = stop {
            self.threads.stop = stop;
        }
        if recounts {
            self.drop_lists();
        }
        if other_rules || method.is_some() {
            self.prepared.set_mesh(&mesh, &options);
        }
        if other_rules {
            self.prepared.set_rules(rules.as_ref());
            self.selection.rules = rules;
        }
        if let Some(method) = method {
            self.method = method;
        }
        self.prepared.set_min_distance(&mesh, &options);
        (self.state.mesh, self.state.options) = (mesh, options);
        Ok(())
    }

    pub(super) fn set_min_distance(&mut self, min_distance: f64) -> Result<(), Error> {
        self.state.options.min_distance = min_distance;
        self.prepared.set_min_distance(&self.state.mesh, &self.state.options);
        Ok(())
    }

    pub(super) fn set_bodies(&mut self, bodies: Option<Bodies>) -> Result<(), Error> {
        let rules = bodies.as_ref().map(Rules::new).transpose()?;
        self.prepared.set_rules(rules.as_ref());
        self.selection.rules = rules;
        self.state.options.bodies = bodies;
        Ok(())
    }

    /// Makes a call; if the limit of memory ends it, once more without what earlier ones have left.
    /// Each thread keeps the longest lists that it ever had, and which of them finds what is
    /// another one every time, so that together they would come to hold more and more.
    pub(super) fn within_limit(
        &mut self,
        mut call: impl FnMut(&mut Self) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.threads.stop.begin()?;
        let has_lists = self.threads.stop.held() > self.of_mesh;
        let done = call(self);
        if !has_lists || !matches!(done, Err(Error::Memory { .. })) {
            return done;
        }
        self.set_mesh(self.state.mesh.clone(), self.state.options.clone())?;
        self.threads.stop.begin()?;
        call(self)
    }

    /// Drops all whose length depends on the steps, but for what the method and particles have.
    fn drop_lists(&mut self) {
        (self.workers, self.order) = Default::default();
        (self.listers, self.runs) = Default::default();
        self.state.report = Report::default();
    }
}
