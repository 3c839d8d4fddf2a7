//! `ccd info`: the GPU that would be used, how, and which others there are.

use super::backend::{AdapterOptions, kernel_folder};
use super::{Failure, Outcome, output};
use ccd::gpu::{Device, Info, Path, described, wgpu};
use clap::Args;
use serde::Serialize;

#[derive(Args)]
pub struct InfoCommand {
    #[command(flatten)]
    adapter: AdapterOptions,
    /// Print one JSON object instead of text
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Json {
    adapter: Adapter,
    shaders: &'static str,
    shaders_why: &'static str,
    f64: bool,
    flushed: Vec<&'static str>,
    timestamps: bool,
    max_binding_bytes: u64,
    max_buffer_bytes: u64,
    kernel_folder: Option<std::path::PathBuf>,
    adapters: Vec<Adapter>,
}

#[derive(Serialize)]
struct Adapter {
    name: String,
    kind: String,
    backend: String,
    driver: String,
    pci: Option<String>,
}

impl From<&wgpu::AdapterInfo> for Adapter {
    fn from(a: &wgpu::AdapterInfo) -> Self {
        let driver = format!("{} {}", a.driver, a.driver_info).trim().to_string();
        Self {
            name: a.name.clone(),
            kind: format!("{:?}", a.device_type),
            backend: a.backend.to_string(),
            driver,
            pci: Some(a.device_pci_bus_id.clone()).filter(|id| !id.is_empty()),
        }
    }
}

impl InfoCommand {
    pub fn run(&self) -> Outcome {
        let device = self
            .adapter
            .open()
            .map_err(|e| Failure(format!("{e}; every command works on the CPU without one")))?;
        let info = device.info();
        let flushed = device.flushes().map_err(|e| Failure(e.to_string()))?;
        let adapters = Device::adapters();
        if self.json {
            output::json(&json(info, flushed, adapters.iter().map(Adapter::from).collect()))?;
        } else {
            output::say!("{info}");
            let none = flushed.is_empty().then_some("nothing");
            let flushed: Vec<_> = flushed.into_iter().chain(none).collect();
            output::line("flushed", format_args!("to zero if tiny: {}", flushed.join(", ")));
            for (i, a) in adapters.iter().enumerate() {
                let name = if i == 0 { "there are" } else { "" };
                output::line(name, format_args!("{i}: {}", described(a)));
            }
            if let Some(folder) = kernel_folder() {
                output::line("kernels", format_args!("kept in {}", folder.display()));
            }
        }
        output::flush();
        Ok(false)
    }
}

fn json(info: &Info, flushed: Vec<&'static str>, adapters: Vec<Adapter>) -> Json {
    Json {
        adapter: (&info.adapter).into(),
        shaders: match info.path {
            Path::Passthrough => "passthrough",
            Path::Wgsl => "wgsl",
        },
        shaders_why: info.why,
        f64: info.wide,
        flushed,
        timestamps: info.timestamps,
        max_binding_bytes: info.limits.max_storage_buffer_binding_size,
        max_buffer_bytes: info.limits.max_buffer_size,
        kernel_folder: kernel_folder(),
        adapters,
    }
}
