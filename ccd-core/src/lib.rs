//! Certified geometry for continuous collision detection; no_std, no allocator, no thread, no file.
//!
//! The same functions run on a CPU and, compiled by rust-gpu, on a GPU. Elemental queries
//! ([`vertex_face`], [`edge_edge`]) answer with a [`Verdict`] that is never a missed contact;
//! everything else here serves to ask few of them.
//!
//! | module | idea |
//! |---|---|
//! | [`math`] | numbers, vectors, boxes rounded outward, oriented boxes, space-filling codes |
//! | [`narrow_phase`] | filters and verdicts of single queries, each with its error bound |
//! | [`model`] | meshes, bodies, positions, options, contacts, reports, errors |
//! | `reference` (feature `alloc`) | a step without threads or a standard library |
//! | [`records`] | paths, pairs and contacts as they lie in a device's memory |
//!
//! These modules and the names below are what the crate promises; the crate `meshccd` re-exports
//! what applications use. A module that is not documented, `backend`, has the parts of a step that
//! the CPU and the GPU share; it may change with any release.
#![no_std]
#![deny(unsafe_code)]
#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]
#[cfg(any(feature = "alloc", test))]
extern crate alloc;
#[cfg(test)]
extern crate std;

#[doc(hidden)]
pub mod backend;
pub mod math;
pub mod model;
pub mod narrow_phase;
#[cfg(feature = "alloc")]
pub mod reference;
/// Records that an engine exchanges with a device: `u32` and `[f32; N]` fields, sizes fixed.
pub mod records {
    #[doc(inline)]
    pub use crate::backend::layout::{LIST_HEADER, Pair, Path, Touch, TouchGeometry, join, split};
}
#[cfg(test)]
#[path = "../../src/scenes/random.rs"]
#[allow(dead_code, reason = "tests need a part of it")]
mod random;

use backend::{broad_phase, kernel, layout, scheduling};
pub use math::aabb::Aabb;
pub use math::real::{Num, Real};
pub use model::error::Error;
pub use model::precision::Coordinate;
pub use narrow_phase::query::{
    EdgeEdge, TOI_TOLERANCE, Verdict, VertexFace, edge_edge, vertex_face,
};
