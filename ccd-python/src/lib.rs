//! The Python module `meshccd._native`, over the facade `ccd`: arrays in, arrays out.
//!
//! | file | idea |
//! |---|---|
//! | `arrays.rs` | NumPy arrays as slices: as they are, or copied on purpose |
//! | `mesh.rs` | topology |
//! | `session.rs`, `report.rs` | a mesh stepped frame by frame, and what a step found |
//! | `broad_phase.rs`, `queries.rs` | boxes alone; single queries |
//! | `errors.rs` | our messages as Python's exceptions |
//!
//! Work is done with the interpreter released. What a `Mutex` here guards is used by one thread of
//! Python at a time: others wait, without the interpreter.

mod arrays;
mod broad_phase;
mod errors;
mod mesh;
mod queries;
mod report;
mod session;

/// Continuous collision detection for triangle meshes.
#[pyo3::pymodule]
mod _native {
    #[pymodule_export]
    use crate::broad_phase::BroadPhase;
    #[pymodule_export]
    use crate::mesh::Mesh;
    #[pymodule_export]
    use crate::queries::{edge_edge, vertex_face};
    #[pymodule_export]
    use crate::report::Report;
    #[pymodule_export]
    use crate::session::Session;
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "Python's name")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
