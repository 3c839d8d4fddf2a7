//! Continuous collision detection on the CPU, over rayon.
//!
//! | module | idea |
//! |---|---|
//! | `session.rs` | a mesh stepped frame by frame |
//! | `step/` | boxes and tables, candidates, the narrow phase |
//! | `broad_phase/` | sources of pairs: blocks, the binary tree; boxes alone |
//! | `simd/` | lanes of each instruction set |
//! | `sort.rs`, `threads.rs`, `pages.rs` | the radix sort; where work runs; pages of its memory |
//! | `stop.rs` | what ends a call early |
#![deny(unsafe_code)]
#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

#[cfg_attr(
    not(feature = "catalogue"),
    allow(dead_code, reason = "what only methods of the catalogue call")
)]
mod broad_phase;
mod clock;
mod exclusions;
mod pages;
mod session;
#[allow(unsafe_code, reason = "intrinsics, after asking the processor; a write within capacity")]
mod simd;
mod sort;
mod step;
mod stop;
mod threads;

#[cfg(feature = "catalogue")]
#[doc(hidden)]
pub use broad_phase::descent_times::DescentTimes;
pub use broad_phase::pair_list::Pairs;
pub use broad_phase::{BroadPhase, BroadPhaseTimes};
pub use ccd_core::model::session::Intersection;
#[cfg(all(target_family = "wasm", target_os = "unknown"))]
pub use clock::set_clock;
pub use exclusions::{near_at_rest, near_at_rest_on};
pub use session::{
    CandidateSet, Candidates, Engine, Session, earliest_toi, has_intersections, intersections, step,
};
pub use simd::instruction_set;
pub use step::prepare::MAX_LOOSENESS;
