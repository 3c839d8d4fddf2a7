//! Nodes of a glTF file as the file writes them: the crate `gltf` rounds their numbers to `f32`.

use serde::Deserialize;
use serde::de::IgnoredAny;
use std::collections::HashMap;

/// Where nodes are within their parents, and what is not applied to their meshes.
#[derive(Deserialize)]
pub(super) struct Nodes {
    asset: Asset,
    #[serde(default)]
    nodes: Vec<Node>,
    #[serde(default)]
    meshes: Vec<Mesh>,
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase")]
struct Asset {
    version: String,
    min_version: Option<String>,
}

#[derive(Deserialize)]
struct Node {
    mesh: Option<usize>,
    matrix: Option<[f64; 16]>,
    translation: Option<[f64; 3]>,
    rotation: Option<[f64; 4]>,
    scale: Option<[f64; 3]>,
    skin: Option<IgnoredAny>,
    weights: Option<Vec<f64>>,
    #[serde(default)]
    extensions: HashMap<String, IgnoredAny>,
}

#[derive(Deserialize)]
struct Mesh {
    #[serde(default)]
    weights: Vec<f64>,
}

/// An extension that puts a mesh into many places.
const INSTANCES: &str = "EXT_mesh_gpu_instancing";

impl Nodes {
    /// From the JSON of a file.
    pub fn new(json: &[u8]) -> Result<Self, String> {
        let nodes: Self = serde_json::from_slice(json).map_err(|e| e.to_string())?;
        let Asset { version, min_version } = &nodes.asset;
        let needed = min_version.as_ref().unwrap_or(version);
        for version in [version, needed] {
            if !version.starts_with("2.") {
                return Err(format!("version {version} of glTF; 2 is read"));
            }
        }
        Ok(nodes)
    }

    /// The matrix of a node, by columns.
    ///
    /// # Errors
    /// What would move its vertices elsewhere and is not applied, in words.
    pub fn local(&self, at: usize) -> Result<[[f64; 4]; 4], String> {
        let node = self.nodes.get(at).ok_or("is not there")?;
        if let Some(mesh) = node.mesh {
            let of_mesh = self.meshes.get(mesh).map(|mesh| &mesh.weights);
            let weights = node.weights.as_ref().or(of_mesh);
            let what = if node.skin.is_some() {
                "has a skin"
            } else if weights.is_some_and(|weights| weights.iter().any(|&w| w != 0.0)) {
                "has a mesh with weights of morph targets"
            } else if node.extensions.contains_key(INSTANCES) {
                "has instances"
            } else {
                ""
            };
            if !what.is_empty() {
                return Err(format!("{what}, which is not applied: export posed meshes"));
            }
        }
        if let Some(m) = node.matrix {
            let (columns, _) = m.as_chunks::<4>();
            let matrix = [columns[0], columns[1], columns[2], columns[3]];
            if matrix.map(|column| column[3]) != [0.0, 0.0, 0.0, 1.0] {
                return Err("has a matrix whose last row is not 0 0 0 1".into());
            }
            return Ok(matrix);
        }
        let [x, y, z] = node.translation.unwrap_or_default();
        let [sx, sy, sz] = node.scale.unwrap_or([1.0; 3]);
        let [i, j, k, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
        let length = (i * i + j * j + k * k + w * w).sqrt();
        if (length - 1.0).abs() > 1e-3 {
            return Err(format!("has a rotation of length {length}, not 1"));
        }
        let (ii, jj, kk) = (2.0 * i * i, 2.0 * j * j, 2.0 * k * k);
        let (ij, ik, jk) = (2.0 * i * j, 2.0 * i * k, 2.0 * j * k);
        let (wi, wj, wk) = (2.0 * w * i, 2.0 * w * j, 2.0 * w * k);
        Ok([
            [(1.0 - jj - kk) * sx, (ij + wk) * sx, (ik - wj) * sx, 0.0],
            [(ij - wk) * sy, (1.0 - ii - kk) * sy, (jk + wi) * sy, 0.0],
            [(ik + wj) * sz, (jk - wi) * sz, (1.0 - ii - jj) * sz, 0.0],
            [x, y, z, 1.0],
        ])
    }
}
