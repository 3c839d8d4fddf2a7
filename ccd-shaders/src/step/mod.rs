//! What a step of a mesh does before and after its broad phase: boxes of what moves; triangles to
//! features; verdicts; contacts in their order.

pub mod contact_geometry;
pub mod contact_order;
pub mod decide;
pub mod filter;
pub mod sweep;
pub mod triangle_pairs;
