//! Meshes and bodies as data (feature `serde`): what their constructors take, so that what is read
//! is checked as what is given.

use super::bodies::Bodies;
use super::mesh::Mesh;
use alloc::vec;
use alloc::vec::Vec;
use serde::de::Error as _;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// What [`Mesh::with_edges`] takes. `edges`: those that no face has; one that joins a vertex with
/// itself stands for each that was given so, because these are counted.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Mesh", deny_unknown_fields)]
struct MeshData<Faces, Edges> {
    n_vertices: usize,
    faces: Faces,
    #[serde(default)]
    edges: Edges,
}

impl Serialize for Mesh {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let (n_vertices, faces) = (self.n_vertices(), self.faces());
        let of_faces = Mesh::new(n_vertices, faces).map_err(serde::ser::Error::custom)?;
        let key = |&[a, b]: &[u32; 2]| (b, a);
        let is_side = |e: &[u32; 2]| of_faces.edges().binary_search_by_key(&key(e), key).is_ok();
        let mut edges = vec![[0, 0]; self.n_degenerate() - of_faces.n_degenerate()];
        edges.extend(self.edges().iter().filter(|edge| !is_side(edge)));
        MeshData { n_vertices, faces, edges }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Mesh {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let data = MeshData::<Vec<[u32; 3]>, Vec<[u32; 2]>>::deserialize(deserializer)?;
        Mesh::with_edges(data.n_vertices, &data.faces, &data.edges).map_err(D::Error::custom)
    }
}

/// What [`Bodies::new`] takes.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Bodies", deny_unknown_fields)]
struct BodiesData<Numbers> {
    body_of_vertex: Numbers,
    fixed: Vec<bool>,
    self_contact: bool,
}

impl Serialize for Bodies {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let body_of_vertex = self.body_of_vertex();
        let mut fixed = Vec::new();
        for (v, &body) in body_of_vertex.iter().enumerate() {
            if self.is_fixed(v as u32) {
                fixed.resize(fixed.len().max(body as usize + 1), false);
                fixed[body as usize] = true;
            }
        }
        let self_contact = self.self_contact();
        BodiesData { body_of_vertex, fixed, self_contact }.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Bodies {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let data = BodiesData::<Vec<u32>>::deserialize(deserializer)?;
        Ok(Bodies::new(&data.body_of_vertex, &data.fixed, data.self_contact))
    }
}
