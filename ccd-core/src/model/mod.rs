//! What a step is asked and what it answers: meshes, bodies, positions, options, contacts, errors.

#[cfg(feature = "alloc")]
pub mod bodies;
pub mod catalogue;
pub mod contact;
pub mod digest;
pub mod error;
pub mod groups;
#[cfg(feature = "alloc")]
pub mod mesh;
pub mod method;
#[cfg(feature = "alloc")]
pub mod options;
pub mod pipeline;
pub mod precision;
pub mod quantization;
#[cfg(feature = "alloc")]
pub mod report;
#[cfg(feature = "alloc")]
pub mod rules;
pub mod scheduling;
