//! Certified geometry for continuous collision detection; no_std, no allocator, no thread, no file.
//!
//! The same functions run on a CPU and, compiled by rust-gpu, on a GPU. Elemental queries ([`vertex_face`], [`edge_edge`])
//! answer with a [`Verdict`] that is never a missed contact; everything else here serves to ask few of them.
//!
//! | module | idea |
//! |---|---|
//! | [`query`] | vertex-face and edge-edge over a step, with verdicts |
//! | [`bernstein`] | the non-penetration filter and its rounding bound |
//! | [`separate`] | cheap certificates of passing beside |
//! | [`cubic`], [`inside`], [`advance`] | roots, containment, advancement: how a query is decided |
//! | [`aabb`], [`morton`] | boxes rounded outward, space-filling codes |
//! | [`method`] | the ways to find overlapping boxes |
//! | [`layout`] | records that cross between CPU and GPU |
//! | [`kernel`] | one per-thread function per stage of the pipeline |
//! | `topology` | edges and adjacency of a triangle mesh (feature `alloc`) |
#![no_std]
#[cfg(any(feature = "alloc", test))]
extern crate alloc;
#[cfg(test)]
extern crate std;

pub mod aabb;
pub mod advance;
pub mod bernstein;
pub mod closest;
pub mod cubic;
pub mod digest;
pub mod error;
pub mod input;
pub mod inside;
pub mod kernel;
pub mod layout;
pub mod method;
pub mod morton;
pub mod motion;
pub mod query;
pub mod real;
#[cfg(feature = "alloc")]
pub mod report;
pub mod separate;
pub mod slice;
#[cfg(feature = "alloc")]
pub mod topology;
pub mod vec3;

pub use aabb::Aabb;
pub use error::Error;
pub use query::{EdgeEdge, TOI_TOLERANCE, Verdict, VertexFace, edge_edge, vertex_face};
pub use real::{Num, Real};
