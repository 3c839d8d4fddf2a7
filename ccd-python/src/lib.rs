//! The Python module `meshccd._native`, over the facade `ccd`: arrays in, arrays out.
//!
//! | file | idea |
//! |---|---|
//! | `arrays.rs` | NumPy arrays as slices: as they are, or copied on purpose |
//! | `mesh.rs`, `bodies.rs` | topology; which pairs are looked at |
//! | `files.rs` | meshes and animations from files |
//! | `session.rs`, `calls.rs` | a mesh stepped frame by frame |
//! | `report.rs`, `geometry.rs`, `hit.rs` | what a step found |
//! | `options.rs`, `filter.rs` | how a session works; a callback that selects pairs |
//! | `broad_phase.rs`, `queries.rs`, `exact.rs` | boxes alone; single queries |
//! | `device.rs`, `process.rs` | GPUs by name; processes and their threads |
//! | `candidate_set.rs`, `squared_distance.rs` | candidates for many steps; squared distances |
//! | `errors.rs` | our messages as Python's exceptions |
//!
//! Work is done with the interpreter released. What a `Mutex` here guards is used by one thread of
//! Python at a time: others wait, without the interpreter.

mod arrays;
mod bodies;
mod broad_phase;
mod calls;
mod candidate_set;
mod device;
mod errors;
mod exact;
mod files;
mod filter;
mod geometry;
mod hit;
mod mesh;
mod options;
mod parts;
mod process;
mod queries;
mod report;
mod session;
mod squared_distance;

/// Continuous collision detection for triangle meshes.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use crate::bodies::Bodies;
    #[pymodule_export]
    use crate::broad_phase::BroadPhase;
    #[pymodule_export]
    use crate::candidate_set::CandidateSet;
    #[pymodule_export]
    use crate::device::gpus;
    #[pymodule_export]
    use crate::exact::{
        exact_edge_edge, exact_vertex_edge, exact_vertex_face, exact_vertex_vertex,
    };
    #[pymodule_export]
    use crate::files::{read_mesh, read_positions, read_queries};
    #[pymodule_export]
    use crate::geometry::Geometry;
    #[pymodule_export]
    use crate::hit::Hit;
    #[pymodule_export]
    use crate::mesh::Mesh;
    #[pymodule_export]
    use crate::options::{CancelToken, Options, methods};
    #[pymodule_export]
    use crate::queries::{
        distance, edge_edge, instruction_set, scaled_toi, toi_to_f32, vertex_edge, vertex_face,
        vertex_vertex,
    };
    #[pymodule_export]
    use crate::report::Report;
    #[pymodule_export]
    use crate::session::Session;

    #[pymodule_export]
    use crate::squared_distance::{
        distance_type, squared_distance, squared_distance_gradient, squared_distance_hessian,
    };
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "Python's name")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
