//! A step of a mesh, stage by stage: what is prepared, which pairs are candidates, what becomes of
//! them.

pub mod candidates;
pub mod codimensional;
pub mod contact_order;
pub mod find;
pub mod leaf_ends;
pub mod leaves;
pub mod movers;
pub mod narrow_phase;
pub mod positions;
pub mod prepare;
pub mod rigid;
pub mod scans;
pub mod selection;
pub mod stand_ins;
pub mod still;
pub mod triangle_leaves;
pub mod triangle_pairs;
