//! Continuous collision detection on the CPU, over rayon.
mod broad;
mod lanes;
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
pub use session::{Candidates, MAX_LOOSENESS, Session, earliest_toi, step};
