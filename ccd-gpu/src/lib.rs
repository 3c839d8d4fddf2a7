//! Continuous collision detection on the GPU: the host side of the kernels of `ccd-core`, over
//! wgpu.
//!
//! [`Device`] opens a GPU or takes the device of an application, [`Session`] steps a mesh on it,
//! [`BroadPhase`] finds overlapping boxes. A call blocks until the device is done, except
//! [`Engine::record`], [`Engine::submit`], [`Engine::poll`] and those that end in `_async`. In a
//! browser, calls that block fail with [`Error::CannotBlock`].
//!
//! Vulkan, Metal, DX12 and WebGPU; OpenGL is refused. No contact is missed on any of them: what
//! `f32` cannot decide is decided in `f64` or by integers, and on the CPU what these leave.
//!
//! | file | idea |
//! |---|---|
//! | `session.rs`, `broad_phase/mod.rs` | what callers have: a mesh over many steps; boxes alone |
//! | `adapter.rs`, `device.rs`, `device/`, `error.rs` | which GPU and how it is used, failures |
//! | `bind.rs`, `shaders.rs`, `pipeline.rs` | from the kernel table: buffers by name, pipelines |
//! | `kernel_cache.rs` | compiled kernels on disk |
//! | `clock.rs` | times of reports |
//! | `flushing.rs` | which numbers a device takes as zero |
//! | `recorder.rs` | dispatches, bind groups, times |
//! | `growable_list.rs` | lists that kernels append to |
//! | `readback.rs`, `staging.rs` | results to the host, positions from it |
//! | `sort.rs` | the radix sort |
//! | `broad_phase/` | sources of pairs, one a file; `method.rs` has an arm each |
//! | `step/` | buffers, dispatches, a frame, positions in, triangles, contacts in order, the CPU |
//! | `harness.rs` | one kernel by itself, for tests and `flushing.rs`; a device that fails |
//!
//! The kernels of the default methods are always there: blocks, and trees by LBVH that each box
//! queries; with the feature `catalogue` those of all others, too. A method without its kernels is
//! refused with that reason.
//!
//! [`bind`] and [`harness`] are public for tests, and may change with the kernels.
//!
//! With `RUST_LOG` and a logger, wgpu says what it does. The environment variable `CCD_ADAPTER`
//! chooses an adapter by its number, its PCI id or a part of its name.
#![deny(unsafe_code)]
#![warn(clippy::missing_errors_doc, clippy::missing_panics_doc)]

mod adapter;
pub mod bind;
mod broad_phase;
mod clock;
mod device;
mod error;
mod flushing;
mod growable_list;
pub mod harness;
mod kernel_cache;
mod pipeline;
mod readback;
mod recorder;
mod session;
mod shaders;
mod sort;
mod staging;
mod step;
mod threads;

pub use adapter::{DeviceOptions, Info, Path, described};
pub use broad_phase::BroadPhase;
pub use broad_phase::method::check_scheduling;
pub use broad_phase::worker_counts::WorkerCounts;
#[cfg(all(target_family = "wasm", target_os = "unknown"))]
pub use clock::set_clock;
pub use device::{Compilation, Device};
pub use error::Error;
pub use growable_list::List;
pub use recorder::Timing;
pub use session::{Candidates, Engine, GeometryOnDevice, OnDevice, Session};
pub use sort::Sorter;
pub use wgpu;
