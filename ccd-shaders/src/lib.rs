//! Entry points of shaders, compiled by rust-gpu: a few lines each around the kernel bodies of
//! `ccd-core`, which hold all arithmetic on geometry.
//!
//! Here is what a CPU does not have: which thread does which item, workgroup memory, barriers,
//! atomics. Every barrier is reached by all threads of a workgroup: loops around one are
//! bounded by values that are the same for all of them.
#![no_std]
#![deny(unsafe_code)]

pub mod broad_phase;
mod entry;
pub mod probe;
mod records;
pub mod scan;
pub mod sort;
pub mod step;
mod workgroup;
