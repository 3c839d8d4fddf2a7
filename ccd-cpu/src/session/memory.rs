//! What a session holds for its mesh, whatever the steps are: an estimate from above, by which
//! `Options::max_memory` is kept. What steps add is counted where it grows, by [`Stop`].

use crate::stop::Stop;
use ccd_core::Error;
use ccd_core::model::cancel::CancelToken;
use ccd_core::model::codimensional::edges_of_no_face;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::method::{BroadPhaseMethod, Traversal, Volume};
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::Pipeline;
use std::sync::Arc;

/// Bytes of an element of the mesh, for all that any method has of it but trees: its box in two
/// orders, boxes at both ends, vertices, the keys of a sort, bodies; of a vertex also its row of
/// the table, and positions where they are gathered.
const ELEMENT: u64 = 192;
/// The same for the nodes of a binary tree, and for oriented boxes of nodes and triangles.
const TREE: u64 = 256;
const ORIENTED: u64 = 192;
/// Of an isolated vertex, and of an edge of no face where there are such vertices: its box in `f64`
/// and its id. They have a broad phase of their own, which holds as much of them as the session's.
const PARTICLE: u64 = 56;
/// Of a face, an edge and an isolated vertex, for all that pairs of triangles are expanded by.
const TRIANGLE: u64 = 512;
/// Of a worker: its stacks, deques and queues, and tables of a sort.
const WORKER: u64 = 1 << 20;

/// Bytes for steps of this mesh by so many threads.
pub fn for_mesh(mesh: &Mesh, options: &Options, n_threads: usize) -> u64 {
    let [v, e, f] = [mesh.n_vertices(), mesh.edges().len(), mesh.faces().len()].map(|n| n as u64);
    let (mut element, mut of_tree, mut rest) = (ELEMENT, 0, 0);
    if let BroadPhaseMethod::Tree(tree) = options.broad_phase {
        of_tree = TREE + if tree.volume == Volume::Aabb { 0 } else { ORIENTED };
        element += of_tree;
        // What a query found, and the pairs of a cut.
        rest += 8 * v.max(e).max(f) * n_threads as u64;
        if let Traversal::Cut { nodes, .. } = tree.traversal {
            rest += 16 * (nodes as u64).pow(2);
        }
    }
    let particles = mesh.isolated_vertices().len() as u64;
    if particles > 0 {
        // Vertices are sought among themselves and in edges: two sets.
        rest += (particles + edges_of_no_face(mesh).len() as u64) * (element + of_tree + PARTICLE);
    }
    let of_triangles = if options.pipeline == Pipeline::Features { 0 } else { TRIANGLE };
    element * (v + e + f) + of_triangles * (f + e + particles) + rest + WORKER * n_threads as u64
}

/// What ends calls of a session that holds these bytes for its mesh, and no list yet.
///
/// # Errors
/// [`Error::Memory`] if that is more than the options allow.
pub fn stop(
    token: Option<CancelToken>,
    options: &Options,
    of_mesh: u64,
) -> Result<Arc<Stop>, Error> {
    match options.max_memory {
        Some(limit) if limit < of_mesh => {
            let what = "boxes and trees of the mesh";
            Err(Error::Memory { what, bytes: of_mesh, held: 0, limit })
        }
        limit => Ok(Arc::new(Stop::new(token, limit, of_mesh))),
    }
}
