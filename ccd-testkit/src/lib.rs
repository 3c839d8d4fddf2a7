//! Shared by tests, benches and reports: real scenes with their ground truth, generated scenes,
//! brute force, an exact oracle.
#![deny(unsafe_code)]

pub mod brute;
pub mod collapse;
pub mod compare;
pub mod data;
pub mod degenerate;
pub mod grazing;
pub mod methods;
pub mod sturm;

pub use ccd::scenes as generate;

/// Set to 1, this variable has tests leave nothing out.
pub const WHOLE: &str = "CCD_WHOLE";

/// Whether tests are to leave nothing out.
pub fn is_whole() -> bool {
    std::env::var(WHOLE).is_ok_and(|value| value == "1")
}
