//! What may change between steps: mesh, minimum distance, options, bodies. Buffers that are large
//! enough stay, and nothing changes where something fails.

use super::Engine;
use crate::broad_phase::method;
use crate::error::Error;
use crate::step::codimensional::Codimensional;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::{Pipeline, TriangleOptions};
use std::sync::Arc;

/// Refuses what this backend does not have, and what is not compiled in.
pub(super) fn check(options: &Options) -> Result<(), Error> {
    options.check_backend("gpu")?;
    method::check(options.broad_phase)?;
    method::check_scheduling(options.broad_phase, options.scheduling)
}

/// As this backend takes them.
pub(super) fn of_device(options: Options) -> Options {
    let mode = options.mode.on_device();
    options.with_mode(mode)
}

impl Engine {
    /// Methods other than blocks, and triangles, keep their lists alone. The next step sorts anew.
    #[inline(never)]
    pub(super) fn take_mesh(&mut self, mesh: Arc<Mesh>, options: Options) -> Result<(), Error> {
        let options = of_device(options);
        check(&options)?;
        self.mend()?;
        let device = self.device.limited(options.max_memory);
        let codimensional = Codimensional::new(&device, &mesh, &options)?;
        self.abandon();
        self.frames.change(&device, &mesh, &options)?;
        (self.device, self.codimensional) = (device, codimensional);
        (self.state.mesh, self.state.options) = (mesh, options);
        Ok(())
    }

    /// Free regions are there without a distance alone.
    pub(super) fn take_min_distance(&mut self, min_distance: f64) -> Result<(), Error> {
        let options = &self.state.options;
        let has_regions = |distance: f64| distance == 0.0;
        let free_regions = matches!(
            options.pipeline,
            Pipeline::Triangles(TriangleOptions { free_regions: true, .. })
        );
        if free_regions && has_regions(min_distance) != has_regions(options.min_distance) {
            let options = options.clone().with_min_distance(min_distance);
            return self.take_mesh(self.state.mesh.clone(), options);
        }
        self.abandon();
        let options = &mut self.state.options;
        options.min_distance = min_distance;
        Ok(())
    }

    pub(super) fn take_bodies(&mut self, bodies: Option<Bodies>) -> Result<(), Error> {
        self.abandon();
        let options = self.state.options.clone().with_bodies(bodies);
        self.frames.set_bodies(&self.device, &self.state.mesh, &options)?;
        self.state.options = options;
        Ok(())
    }
}
