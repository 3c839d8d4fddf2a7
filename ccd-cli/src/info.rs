//! `ccd info`: the processor, the GPU that would be used, how, and which others there are.

use super::backend::{AdapterOptions, kernel_folder};
use super::{Failure, Outcome, output};
use ccd::gpu::{Device, Error, Path, described, wgpu};
use clap::Args;
use serde::Serialize;

#[derive(Args)]
pub struct InfoCommand {
    #[command(flatten)]
    adapter: AdapterOptions,
    /// Print one JSON object instead of text
    #[arg(short, long)]
    json: bool,
}

/// What to do where there is no GPU.
const HELP: [&str; 4] = [
    "Everything works on the processor. To use a GPU:",
    "Linux: its Vulkan driver (Mesa: mesa-vulkan-drivers) and libvulkan1",
    "a container: pass in the GPU and the files of its driver",
    "macOS, Windows: the driver of the system is enough",
];

#[derive(Serialize)]
struct Json {
    processor: String,
    threads: usize,
    instruction_set: &'static str,
    /// Why there is no GPU; then what follows is null.
    no_gpu: Option<String>,
    adapter: Option<Adapter>,
    shaders: Option<&'static str>,
    shaders_why: Option<&'static str>,
    f64: Option<bool>,
    flushed: Option<Vec<&'static str>>,
    timestamps: Option<bool>,
    max_binding_bytes: Option<u64>,
    max_buffer_bytes: Option<u64>,
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
        let device = match self.adapter.open() {
            Err(why) if !matches!(why, Error::Unavailable { .. }) || self.adapter.is_named() => {
                return Err(Failure(why.to_string()));
            }
            device => device,
        };
        let flushed = device.as_ref().ok().map(|device| device.flushes()).transpose();
        let flushed = flushed.map_err(|e| Failure(e.to_string()))?;
        let (info, why) = match &device {
            Ok(device) => (Some(device.info()), None),
            Err(why) => (None, Some(why.to_string())),
        };
        let adapters = Device::adapters();
        let threads = std::thread::available_parallelism().map_or(1, |n| n.get());
        if self.json {
            output::json(&Json {
                processor: output::processor(),
                threads,
                instruction_set: ccd::instruction_set(),
                no_gpu: why,
                adapter: info.map(|info| (&info.adapter).into()),
                shaders: info.map(|info| match info.path {
                    Path::Passthrough => "passthrough",
                    Path::Wgsl => "wgsl",
                }),
                shaders_why: info.map(|info| info.why),
                f64: info.map(|info| info.wide),
                flushed,
                timestamps: info.map(|info| info.timestamps),
                max_binding_bytes: info.map(|info| info.limits.max_storage_buffer_binding_size),
                max_buffer_bytes: info.map(|info| info.limits.max_buffer_size),
                kernel_folder: kernel_folder(),
                adapters: adapters.iter().map(Adapter::from).collect(),
            })?;
        } else {
            let processor = output::processor();
            let set = ccd::instruction_set();
            let what = format_args!("{processor}, {threads} threads, {set}");
            output::line("processor", what);
            if let (Some(info), Some(flushed)) = (info, flushed) {
                output::say!("{info}");
                let none = flushed.is_empty().then_some("nothing");
                let flushed: Vec<_> = flushed.into_iter().chain(none).collect();
                output::line("flushed", format_args!("to zero if tiny: {}", flushed.join(", ")));
            }
            if let Some(why) = why {
                output::line("adapter", why);
                HELP.iter().for_each(|text| output::line("", text));
            }
            for (i, a) in adapters.iter().enumerate() {
                let name = if i == 0 { "there are" } else { "" };
                output::line(name, format_args!("{i}: {}", described(a)));
            }
            if let (Ok(_), Some(folder)) = (&device, kernel_folder()) {
                output::line("kernels", format_args!("kept in {}", folder.display()));
            }
        }
        output::flush();
        Ok(false)
    }
}
