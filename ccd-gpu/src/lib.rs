//! Continuous collision detection on the GPU: the host side of the kernels of `ccd-core`, over wgpu.
mod broad;
mod device;
mod error;
mod frame;
pub mod harness;
mod levels;
mod list;
mod modules;
mod readback;
mod recorder;
mod session;
mod tail;
mod tree;
mod upload;

pub use broad::{BroadPhase, Sorter};
pub use device::{Device, DeviceOptions, Info, Path};
pub use error::Error;
pub use list::List;
pub use session::{Candidates, OnDevice, Session};
pub use wgpu;
