//! Bounds and verdicts of the core against exact arithmetic, adversaries and independent
//! computation; no data needed.

mod boxes;
mod common;
mod derived;
mod distance;
mod obb;
mod obb_rounding;
mod rounding;
mod tangential;
mod verdicts;
