//! Continuous collision detection on the CPU, over rayon.
mod broad_phase;
mod session;
mod simd;
mod sort;
mod step;
mod threads;

pub use broad_phase::BroadPhase;
pub use broad_phase::pair_list::Pairs;
pub use session::{Candidates, Session, earliest_toi, step};
pub use step::prepare::MAX_LOOSENESS;
