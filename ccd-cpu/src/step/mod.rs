//! A step of a mesh, stage by stage: what is prepared, which pairs are candidates, what becomes of
//! them.

pub mod candidates;
pub mod leaves;
pub mod narrow_phase;
pub mod prepare;
