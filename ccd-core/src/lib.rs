//! Certified geometry for continuous collision detection; no_std, no allocator, no thread, no file.
//!
//! The same functions run on a CPU and, compiled by rust-gpu, on a GPU. Elemental queries
//! ([`vertex_face`], [`edge_edge`]) answer with a [`Verdict`] that is never a missed contact;
//! everything else here serves to ask few of them.
//!
//! | room | idea |
//! |---|---|
//! | [`math`] | numbers, vectors, boxes rounded outward, space-filling codes |
//! | [`narrow_phase`] | filters and verdicts of single queries, each with its error bound |
//! | [`broad_phase`] | swept boxes, trees, traversals, candidates |
//! | [`model`] | meshes, bodies, positions in `f32`, contacts, reports, errors |
//! | [`triangle_pairs`] | pairs of triangles as pairs of features, each once |
//! | [`scheduling`] | deques from which idle workers steal pairs of nodes |
//! | [`kernel`] | what runs on a device: the table of kernels, memory, sorting |
//! | [`layout`] | records that cross between CPU and GPU |
//!
//! What applications use is in [`model`], in the queries of [`narrow_phase`], and, of [`layout`],
//! `Pair`, `Path`, `Touch` and `TouchGeometry`; the crate `ccd` re-exports most of it. The rest is
//! public for the backends and may change with them: [`broad_phase`], [`triangle_pairs`],
//! [`scheduling`], [`kernel`], [`model::quantization`], [`model::rules`].
#![no_std]
#![deny(unsafe_code)]
#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]
#[cfg(any(feature = "alloc", test))]
extern crate alloc;
#[cfg(test)]
extern crate std;

pub mod broad_phase;
pub mod kernel;
pub mod layout;
pub mod math;
pub mod model;
pub mod narrow_phase;
#[cfg(test)]
#[path = "../../src/scenes/random.rs"]
#[allow(dead_code, reason = "tests need a part of it")]
mod random;
pub mod scheduling;
pub mod triangle_pairs;

pub use math::aabb::Aabb;
pub use math::real::{Num, Real};
pub use model::error::Error;
pub use model::precision::Coordinate;
pub use narrow_phase::query::{
    EdgeEdge, TOI_TOLERANCE, Verdict, VertexFace, edge_edge, vertex_face,
};
