//! The C API of the facade `ccd`: pointers in, status and library-owned arrays out.
//!
//! | file | idea |
//! |---|---|
//! | `status.rs` | status codes, the message of the last error, and no unwinding to the caller |
//! | `memory.rs` | pointers of the caller as references and slices, as far as they can be checked |
//! | `mesh.rs` | meshes and positions |
//! | `bodies.rs` | which pairs of bodies are looked at |
//! | `options.rs` | options in a struct that may grow |
//! | `results.rs` | contacts, reports and other results as C sees them |
//! | `session.rs`, `moving.rs` | a mesh stepped frame by frame; bodies that move |
//!
//! `include/ccd.h` is written from these files by `tests/header.rs` of the workspace; doc comments
//! of what is exported are its documentation, for readers of C. An exported function is `unsafe` if
//! it is given a pointer: the caller's duties are in the header's first comment (`cbindgen.toml`).
#![allow(clippy::missing_safety_doc, reason = "the header's first comment says it for all")]

pub mod bodies;
mod memory;
pub mod mesh;
pub mod moving;
pub mod options;
pub mod results;
pub mod session;
pub mod status;
