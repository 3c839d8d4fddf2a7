//! The Python module `meshccd._native`, over the facade `ccd`: arrays in, arrays out.
//!
//! | file | idea |
//! |---|---|
//! | `arrays.rs` | NumPy arrays as slices: as they are, or copied on purpose |
//! | `mesh.rs`, `bodies.rs` | topology; which pairs are looked at |
//! | `files.rs` | meshes and animations from files |
//! | `session.rs`, `calls.rs`, `report.rs` | a mesh stepped frame by frame, and what a step found |
//! | `candidate_set.rs` | candidates for many steps |
//! | `options.rs`, `filter.rs` | how a session works; a callback that selects pairs |
//! | `broad_phase.rs`, `queries.rs` | boxes alone; single queries |
//! | `squared_distance.rs` | squared distances with derivatives |
//! | `errors.rs` | our messages as Python's exceptions |
//!
//! Work is done with the interpreter released. What a `Mutex` here guards is used by one thread of
//! Python at a time: others wait, without the interpreter.

mod arrays;
mod bodies;
mod broad_phase;
mod calls;
mod candidate_set;
mod errors;
mod files;
mod filter;
mod mesh;
mod options;
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
    use crate::files::{read_mesh, read_positions};
    #[pymodule_export]
    use crate::mesh::Mesh;
    #[pymodule_export]
    use crate::queries::{distance, edge_edge, vertex_edge, vertex_face, vertex_vertex};
    #[pymodule_export]
    use crate::report::{Geometry, Hit, Report};
    #[pymodule_export]
    use crate::session::Session;
    #[pymodule_export]
    use crate::squared_distance::{
        distance_type, squared_distance, squared_distance_gradient, squared_distance_hessian,
    };
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "Python's name")]
    const __version__: &str = env!("CARGO_PKG_VERSION");

    /// Once, by the process that imports the module.
    #[pymodule_init]
    fn init(_module: &pyo3::Bound<'_, pyo3::types::PyModule>) -> pyo3::PyResult<()> {
        crate::options::loaded();
        Ok(())
    }
}
