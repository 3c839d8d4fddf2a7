//! What a step of a mesh does before and after its broad phase: boxes of what moves; verdicts;
//! contacts in their order.

pub mod contact_order;
pub mod decide;
pub mod sweep;
