//! Parts of a step that backends share: trees, traversals, kernel bodies, records of devices.
//!
//! The rule: what `ccd_core` documents outside of this module keeps its meaning within a major
//! version. What stands here serves `ccd-cpu`, `ccd-gpu` and `ccd-shaders`, which have the version
//! of this crate, and may change with any release.
//!
//! | module | idea |
//! |---|---|
//! | [`broad_phase`] | swept boxes, trees, traversals, candidates |
//! | [`triangle_pairs`] | pairs of triangles as pairs of features, each once |
//! | [`scheduling`] | deques from which idle workers steal pairs of nodes |
//! | [`kernel`] | kernels of a device: their table, memory, sorting |
//! | [`layout`] | records that cross between CPU and GPU |
//! | [`quantization`] | coordinates in `f32`, and what rounding to it costs |
//! | [`rules`] | which features may touch: bodies, groups, worlds, exclusions as words |
//! | `clock` | the text of a clock, which the backends have and the core has not |

pub mod broad_phase;
mod clock;
pub mod kernel;
pub mod layout;
pub mod quantization;
#[cfg(feature = "alloc")]
pub mod rules;
pub mod scheduling;
pub mod triangle_pairs;
