//! Entry points of shaders, to be compiled by rust-gpu: a few lines each around the kernel bodies of `ccd-core`.
//!
//! There are none yet. The crate is outside of the workspace because it has a toolchain of its own.
#![no_std]

pub use ccd_core::kernel;
