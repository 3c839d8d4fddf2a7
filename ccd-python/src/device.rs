//! Devices by name.

use crate::errors::{failed, refused};
use ccd::any::{Backend, Choice};
use pyo3::prelude::*;

/// Names of the GPUs of this machine, once for every API that reaches them; none where the module
/// was built without GPU. `device="gpu:1"` is the second, `device="gpu:NAME"` the first whose name
/// has that part.
#[pyfunction]
pub fn gpus(py: Python<'_>) -> Vec<String> {
    py.detach(names)
}

/// The backend of a device's name, with `size` edges of a mesh, or boxes.
pub fn choose(py: Python<'_>, device: Option<&str>, size: usize) -> PyResult<Choice> {
    let choice = match device {
        None | Some("cpu") => Backend::Cpu.choose(size),
        Some("gpu") => py.detach(|| Backend::Gpu.choose(size)),
        Some("auto") => py.detach(|| Backend::Auto.choose(size)),
        Some(device) => match device.strip_prefix("gpu:") {
            Some(name) => py.detach(|| named(name)),
            None => {
                return Err(refused(format!(
                    "device is {device:?}; it must be None, \"cpu\", \"gpu\", \"gpu:NAME\" or \
                     \"auto\""
                )));
            }
        },
    };
    choice.map_err(failed)
}

#[cfg(feature = "gpu")]
fn named(name: &str) -> Result<Choice, ccd::any::Error> {
    let options = ccd::gpu::DeviceOptions { adapter: Some(name.to_owned()), ..Default::default() };
    Backend::Gpu.choose_with(0, &options)
}

#[cfg(feature = "gpu")]
fn names() -> Vec<String> {
    ccd::gpu::Device::adapters().into_iter().map(|adapter| adapter.name).collect()
}

/// The error says that there is no GPU in this build.
#[cfg(not(feature = "gpu"))]
fn named(_: &str) -> Result<Choice, ccd::any::Error> {
    Backend::Gpu.choose(0)
}

#[cfg(not(feature = "gpu"))]
fn names() -> Vec<String> {
    Vec::new()
}
