//! Topology and options as JavaScript gives them: flat lists of numbers, and names.

use crate::refused;
use ccd::{Bodies, Mesh, Mode, Options};
use std::sync::Arc;
use wasm_bindgen::prelude::*;

/// Topology, which sessions share.
#[wasm_bindgen]
pub struct RawMesh(pub(crate) Arc<Mesh>);

#[wasm_bindgen]
impl RawMesh {
    /// Of ids of edges, two each, and of faces, three each.
    #[wasm_bindgen(constructor)]
    pub fn new(n_vertices: usize, edges: &[u32], faces: &[u32]) -> Result<RawMesh, JsError> {
        let (edges, rest) = edges.as_chunks();
        let (faces, over) = faces.as_chunks();
        if !rest.is_empty() || !over.is_empty() {
            return Err(refused("edges are lists of 2 ids each, faces of 3"));
        }
        Mesh::with_edges(n_vertices, faces, edges).map(|mesh| Self(mesh.into())).map_err(refused)
    }

    pub fn n_vertices(&self) -> usize {
        self.0.n_vertices()
    }

    pub fn edges(&self) -> Vec<u32> {
        self.0.edges().as_flattened().to_vec()
    }

    pub fn faces(&self) -> Vec<u32> {
        self.0.faces().as_flattened().to_vec()
    }
}

/// What a session looks for, put together option by option.
#[wasm_bindgen]
#[derive(Default)]
pub struct RawOptions(pub(crate) Options);

#[wasm_bindgen]
impl RawOptions {
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    pub fn set_min_distance(&mut self, distance: f64) {
        self.0.min_distance = distance;
    }

    pub fn set_tolerance(&mut self, tolerance: f64) {
        self.0.tolerance = tolerance;
    }

    pub fn set_leave_contact(&mut self, leave: bool) {
        self.0.leave_contact = leave;
    }

    pub fn set_max_memory(&mut self, bytes: f64) {
        self.0.max_memory = Some(bytes as u64);
    }

    pub fn set_mode(&mut self, name: &str) -> Result<(), JsError> {
        let mode = Mode::ALL.into_iter().find(|mode| mode.name() == name);
        let names = || format!("{:?}", Mode::ALL.map(|mode| mode.name()));
        self.0.mode = mode
            .ok_or_else(|| refused(format!("mode is {name:?}; it must be one of {}", names())))?;
        Ok(())
    }

    /// The body of each vertex, bodies that stand still, bodies that do not touch themselves, and
    /// pairs of bodies that are not looked at.
    pub fn set_bodies(
        &mut self,
        of_vertex: &[u32],
        fixed: &[u32],
        no_self_contact: &[u32],
        excluded: &[u32],
    ) -> Result<(), JsError> {
        let (pairs, rest) = excluded.as_chunks();
        if !rest.is_empty() {
            return Err(refused("excluded bodies are lists of 2 bodies each"));
        }
        let bodies = Bodies::new(of_vertex).with_excluded_bodies(pairs);
        let bodies = fixed.iter().fold(bodies, |bodies, &body| bodies.with_fixed(body, true));
        let alone = no_self_contact.iter();
        let bodies = alone.fold(bodies, |bodies, &body| bodies.with_self_contact(body, false));
        self.0.bodies = Some(bodies);
        Ok(())
    }
}
