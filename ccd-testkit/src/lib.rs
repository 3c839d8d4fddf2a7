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
