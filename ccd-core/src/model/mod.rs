//! What a step is asked and what it answers: meshes, bodies, positions, options, contacts, errors.

#[cfg(feature = "alloc")]
pub mod bodies;
#[cfg(feature = "alloc")]
pub mod cancel;
pub mod catalogue;
#[cfg(feature = "alloc")]
pub mod codimensional;
pub mod contact;
#[cfg(feature = "alloc")]
mod contact_on_mesh;
#[cfg(feature = "serde")]
mod data;
#[cfg(feature = "alloc")]
pub mod decision;
pub mod digest;
pub mod error;
#[cfg(feature = "alloc")]
pub mod exclusions;
pub mod groups;
#[cfg(feature = "alloc")]
pub(crate) mod incidence;
#[cfg(feature = "alloc")]
pub mod mesh;
pub mod method;
#[cfg(feature = "alloc")]
pub mod options;
pub mod pipeline;
pub mod positions;
pub mod precision;
#[cfg(feature = "alloc")]
pub mod report;
pub mod scheduling;
#[cfg(feature = "alloc")]
pub mod session;
pub mod toi;
pub mod tree_statistics;
