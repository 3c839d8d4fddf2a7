//! Continuous collision detection on the GPU: the host side of the kernels of `ccd-core`, over wgpu.
//!
//! [`Device`] opens a GPU or takes the device of an application, [`Session`] steps a mesh on it, [`BroadPhase`] finds overlapping boxes. Every call blocks until the device is
//! done, except [`Session::record`]. Vulkan, Metal and DX12; OpenGL is refused. No contact is missed on any of them: what `f32` on the device cannot decide is decided in
//! `f64`, on the device or on the CPU.
//!
//! | file | idea |
//! |---|---|
//! | `device.rs`, `error.rs` | adapters, paths for shaders, pipelines, failures |
//! | `session.rs`, `frame.rs` | a step: calls and results; buffers and dispatches |
//! | `tree.rs`, `levels.rs`, `list.rs` | block trees, where their nodes are, lists that kernels append to |
//! | `radix_tree.rs` | the binary tree over the same order, for boxes alone |
//! | `sort.rs`, `order.rs` | the radix sort; contacts in their order |
//! | `upload.rs`, `readback.rs`, `tail.rs` | positions in, results out, what the CPU does at the end |
//! | `recorder.rs`, `modules.rs` | dispatches by the kernel table, the compiled shaders |
//! | `broad.rs`, `harness.rs` | boxes alone; one kernel by itself, for tests |
//!
//! With `RUST_LOG` and a logger, wgpu says what it does. The environment variable `CCD_ADAPTER` chooses an adapter by a part of its name.
mod broad;
mod device;
mod error;
mod frame;
pub mod harness;
mod levels;
mod list;
mod modules;
mod order;
mod radix_tree;
mod readback;
mod recorder;
mod session;
mod sort;
mod tail;
mod tree;
mod upload;

pub use broad::BroadPhase;
pub use device::{Device, DeviceOptions, Info, Path};
pub use error::Error;
pub use list::List;
pub use recorder::Timing;
pub use session::{Candidates, OnDevice, Session};
pub use sort::Sorter;
pub use wgpu;
