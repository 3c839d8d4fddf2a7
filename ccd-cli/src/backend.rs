//! Options of the commands that can use a GPU, and the choice that they make.

use super::Failure;
use ccd::any::{self, Choice};
use ccd::gpu::{self, Device, DeviceOptions};
use clap::{Args, ValueEnum};

/// What runs the work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Backend {
    /// Threads of this machine
    Cpu,
    /// A GPU; an error if there is none
    Gpu,
    /// A GPU if there is one, and work enough for it; else the CPU
    Auto,
}

/// How shaders reach the driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Shaders {
    /// SPIR-V as compiled, Vulkan only
    Passthrough,
    /// WGSL, every GPU API
    Wgsl,
}

/// Options of every command that can use a GPU.
#[derive(Args)]
pub struct AdapterOptions {
    /// Use the GPU whose name contains NAME, whatever it is and however small the mesh (`ccd info`
    /// lists names)
    #[arg(long, value_name = "NAME")]
    adapter: Option<String>,
    /// How shaders reach the driver; without it the first that is possible
    #[arg(long, value_enum)]
    shaders: Option<Shaders>,
}

impl AdapterOptions {
    fn of_device(&self) -> DeviceOptions {
        let path = self.shaders.map(|s| match s {
            Shaders::Passthrough => gpu::Path::Passthrough,
            Shaders::Wgsl => gpu::Path::Wgsl,
        });
        DeviceOptions { adapter: self.adapter.clone(), path, narrow: false }
    }

    /// The device, or why there is none.
    pub fn open(&self) -> Result<Device, gpu::Error> {
        Device::open(&self.of_device())
    }
}

/// Options of every command that works on either.
#[derive(Args)]
pub struct BackendOptions {
    /// What runs the work
    #[arg(long, value_enum, default_value_t = Backend::Auto)]
    backend: Backend,
    #[command(flatten)]
    adapter: AdapterOptions,
}

impl BackendOptions {
    /// Chooses. `size`: edges of the mesh, or boxes.
    pub fn choose(&self, size: usize) -> Result<Choice, Failure> {
        let backend = match self.backend {
            Backend::Cpu => any::Backend::Cpu,
            Backend::Gpu => any::Backend::Gpu,
            Backend::Auto => any::Backend::Auto,
        };
        let choice = backend.choose_with(size, &self.adapter.of_device());
        let choice = choice.map_err(|e| Failure(format!("--backend gpu: {e}")))?;
        Ok(choice.with_notice(|why| eprintln!("ccd: {why}; going on with the CPU")))
    }
}
