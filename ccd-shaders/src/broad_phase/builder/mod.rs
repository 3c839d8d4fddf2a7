//! Builders of binary trees; see `ccd_gpu::broad_phase::builder`.

pub mod lbvh;
pub mod nearest_pair;
pub mod node_numbering;
pub mod ploc;
pub mod split_lists;
