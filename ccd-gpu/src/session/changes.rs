//! What may change between steps: mesh, minimum distance, options. Buffers that are large enough
//! stay, and nothing changes where something fails.

use super::Session;
use crate::broad_phase::method;
use crate::error::Error;
use crate::step::codimensional::Codimensional;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::error::check_min_distance;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::{Pipeline, TriangleOptions};
use std::sync::Arc;

/// Refuses options for a mesh, and what a GPU does not have.
pub fn check(mesh: &Mesh, options: &Options) -> Result<(), Error> {
    options.check(mesh)?;
    method::check(options.broad_phase)?;
    method::check_scheduling(options.broad_phase, options.scheduling)?;
    match options.pipeline.lacking("gpu") {
        Some(name) => Err(ccd_core::Error::Method { name, backend: "gpu" }.into()),
        None => Ok(()),
    }
}

impl Session {
    /// From now on steps of another mesh, as after a topology change: vertices, edges and faces
    /// have new ids. Buffers and lists stay where they are large enough; methods other than blocks,
    /// and triangles, keep their lists alone. The next step sorts anew. Of what an application has
    /// of the session on the device, [`Session::paths`] may be another buffer.
    ///
    /// The bodies of the options stay, if there are any: they must fit the new mesh. Where it has
    /// other vertices, give both at once, by [`Session::set_mesh_and_bodies`].
    ///
    /// # Errors
    /// [`Error::Input`] with bodies that do not fit; what the device refuses. The session stays as
    /// it was.
    pub fn set_mesh(&mut self, mesh: impl Into<Arc<Mesh>>) -> Result<(), Error> {
        let bodies = self.options.bodies.clone();
        self.change_mesh(mesh.into(), bodies)
    }

    /// The same with other bodies, or without any.
    ///
    /// # Errors
    /// Those of [`Session::set_mesh`].
    pub fn set_mesh_and_bodies(
        &mut self,
        mesh: impl Into<Arc<Mesh>>,
        bodies: impl Into<Option<Bodies>>,
    ) -> Result<(), Error> {
        self.change_mesh(mesh.into(), bodies.into())
    }

    #[inline(never)]
    fn change_mesh(&mut self, mesh: Arc<Mesh>, bodies: Option<Bodies>) -> Result<(), Error> {
        self.change(mesh, self.options.clone().with_bodies(bodies))
    }

    fn change(&mut self, mesh: Arc<Mesh>, options: Options) -> Result<(), Error> {
        check(&mesh, &options)?;
        let device = self.device.limited(options.max_memory);
        let codimensional = Codimensional::new(&device, &mesh, &options)?;
        self.frames.change(&device, &mesh, &options)?;
        self.device = device;
        (self.mesh, self.options, self.codimensional) = (mesh, options, codimensional);
        Ok(())
    }

    /// From now on another [`Options::min_distance`]. Buffers and the order of boxes stay, but with
    /// normal cones, which are there without a distance alone.
    ///
    /// # Errors
    /// [`Error::Input`] with a bad distance; what the device refuses. The session stays as it was.
    pub fn set_min_distance(&mut self, min_distance: f64) -> Result<(), Error> {
        check_min_distance(min_distance)?;
        let has_cones = |distance: f64| distance == 0.0;
        let cones = matches!(
            self.options.pipeline,
            Pipeline::Triangles(TriangleOptions { cones: true, .. })
        );
        if cones && has_cones(min_distance) != has_cones(self.options.min_distance) {
            let options = self.options.clone().with_min_distance(min_distance);
            return self.change(self.mesh.clone(), options);
        }
        self.options.min_distance = min_distance;
        Ok(())
    }

    /// From now on other options. Buffers stay where they are large enough, those of a method, its
    /// scheduling or a pipeline that is another one are new.
    ///
    /// # Errors
    /// Those of [`Session::new`]; the session stays as it was.
    pub fn set_options(&mut self, options: Options) -> Result<(), Error> {
        self.change(self.mesh.clone(), options)
    }
}
