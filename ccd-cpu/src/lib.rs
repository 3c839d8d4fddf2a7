//! Continuous collision detection on the CPU, over rayon.
mod broad;
mod narrow;
mod order;
mod prepare;
mod pyramid;
mod radix;
mod rows;
mod session;
mod simd;
mod threads;
mod traverse;
mod tree;

pub use broad::{BroadPhase, Pairs};
pub use prepare::MAX_LOOSENESS;
pub use session::{Candidates, Session, earliest_toi, step};
