//! Bounds and verdicts of the core against exact arithmetic, adversaries and independent
//! computation; no data needed.

mod advancement;
mod boxes;
mod common;
mod derived;
mod distance;
mod input;
mod leaving;
mod moment;
mod obb;
mod obb_rounding;
mod region_certificate;
mod resting;
mod rounding;
mod search;
mod tangential;
#[cfg(feature = "alloc")]
mod thin;
mod verdicts;
