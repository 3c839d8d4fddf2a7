//! Which adapter, and how it is used: what is asked for, what is there, what every kernel needs.

use crate::error::Error;
use ccd_core::backend::kernel::sort;
use std::fmt;

/// How shaders reach the driver.
///
/// ```no_run
/// use ccd::gpu::{Device, DeviceOptions, Path};
///
/// let options = DeviceOptions { path: Some(Path::Wgsl), ..DeviceOptions::default() };
/// assert_eq!(Device::open(&options)?.info().path, Path::Wgsl);
/// # Ok::<(), ccd::gpu::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Path {
    /// SPIR-V as compiled, with contraction forbidden: Vulkan only.
    Passthrough,
    /// WGSL, through naga: every backend.
    Wgsl,
}

/// What is wanted of a device.
///
/// ```
/// use ccd::gpu::{DeviceOptions, Path};
///
/// let mut options = DeviceOptions::default();
/// options.adapter = Some("llvmpipe".into());
/// options.path = Some(Path::Wgsl);
/// # assert_ne!(options, DeviceOptions::default());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DeviceOptions {
    /// A number of `Device::adapters`, an adapter's PCI id (`0000:3b:00.0`, or `3b:00.0` in domain
    /// 0), or a part of its name, in any case; one or two digits are never a part of a name.
    /// `None`: the one that wgpu prefers, or what the environment variable `CCD_ADAPTER` says.
    pub adapter: Option<String>,
    /// The path for shaders; `None`: passthrough where there is Vulkan, else WGSL.
    pub path: Option<Path>,
    /// Leave `f64` unused even where the device has it: integers decide then, and the CPU what they
    /// leave open.
    pub narrow: bool,
    /// Have integers decide contacts, and `f64` what these leave open. `None`: where `f64` is slow,
    /// that is on every GPU but those that have an eighth or more of the units of `f32` for it, by
    /// their names. Both are as certain; times of impact differ within the tolerance.
    pub integers: Option<bool>,
    /// A folder in which compiled kernels are kept for the next process, of this user alone;
    /// `None`: they are compiled on first use. Vulkan alone has something to keep, and lavapipe has
    /// nothing; a folder that cannot be read or written is no error.
    ///
    /// Drivers trust what is there. On Unix it is made for the user alone, and neither it nor a
    /// file in it is used if it is another's, a link, or writable by others; elsewhere it must be a
    /// folder in which others cannot write.
    pub kernel_folder: Option<std::path::PathBuf>,
}

/// What a device is and how it is used.
///
/// ```no_run
/// use ccd::gpu::{Device, DeviceOptions};
///
/// let device = Device::open(&DeviceOptions::default())?;
/// let info = device.info();
/// println!("{}: {:?} because {}", info.adapter.name, info.path, info.why);
/// if !info.wide {
///     println!("integers of 32 bits decide, and the CPU what they leave open");
/// }
/// # Ok::<(), ccd::gpu::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Info {
    /// Adapter, backend, driver.
    pub adapter: wgpu::AdapterInfo,
    /// Limits in force.
    pub limits: wgpu::Limits,
    /// The path for shaders.
    pub path: Path,
    /// Why that path.
    pub why: &'static str,
    /// Whether `f64` is used on the device.
    pub wide: bool,
    /// Whether integers decide before `f64` does, or the CPU where there is none.
    pub integers: bool,
    /// Whether kernels by subgroups of 32 threads run.
    pub subgroups: bool,
    /// Whether there are timestamps, so that stages can be timed.
    pub timestamps: bool,
}

impl fmt::Display for Info {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let a = &self.adapter;
        let path = match self.path {
            Path::Passthrough => "SPIR-V passthrough",
            Path::Wgsl => "WGSL through naga",
        };
        writeln!(f, "adapter     {} ({:?}{})", a.name, a.device_type, pci_of(a))?;
        writeln!(f, "backend     {}, driver {} {}", a.backend, a.driver, a.driver_info)?;
        writeln!(f, "shaders     {path}: {}", self.why)?;
        writeln!(
            f,
            "f64         {}",
            match (self.wide, self.integers) {
                (true, false) => "on the device",
                (true, true) => "on the device, for what integers cannot decide",
                (false, _) => "on the CPU, for what integers cannot decide",
            }
        )?;
        writeln!(f, "timestamps  {}", if self.timestamps { "yes" } else { "no" })?;
        let l = &self.limits;
        writeln!(
            f,
            "limits      {} MiB a binding, {} MiB a buffer",
            l.max_storage_buffer_binding_size >> 20,
            l.max_buffer_size >> 20
        )?;
        write!(
            f,
            "            {} storage buffers a kernel, {} bytes of workgroup memory,\n            \
             {} threads a workgroup, {} workgroups a dimension",
            l.max_storage_buffers_per_shader_stage,
            l.max_compute_workgroup_storage_size,
            l.max_compute_invocations_per_workgroup,
            l.max_compute_workgroups_per_dimension
        )
    }
}

/// GPUs that have at least an eighth as many units for `f64` as for `f32`. Most have a
/// thirty-second or a sixty-fourth, and integers are faster there. Vulkan does not say which, so
/// names do, by these words.
const FAST_F64: &str = "A30, A100, A800, B200, GB200, GH200, GP100, GV100, H100, H200, H800, P100, \
     V100, V100S, TITAN V, INSTINCT, RADEON VII, RADEON PRO VII, DATA CENTER GPU MAX";

/// Whether a device that has `f64` has it fast: CPUs, and those of [`FAST_F64`].
pub fn has_fast_f64(adapter: &wgpu::AdapterInfo) -> bool {
    let words: Vec<&str> = adapter.name.split(|c: char| !c.is_alphanumeric()).collect();
    let name = format!(" {} ", words.join(" ").to_uppercase());
    adapter.device_type == wgpu::DeviceType::Cpu
        || FAST_F64.split(", ").any(|words| name.contains(&format!(" {words} ")))
}

/// Whether subgroups have the 32 threads that kernels by subgroups need, and no other number.
/// Besides, these count on full subgroups. Vulkan promises them for a flag that wgpu does not set;
/// no device of that one size is known to fill a workgroup of 128 or 512 threads otherwise.
pub fn are_of_32(adapter: &wgpu::AdapterInfo) -> bool {
    [adapter.subgroup_min_size, adapter.subgroup_max_size] == [sort::SUBGROUP; 2]
}

/// Whether kernels by subgroups run; they have no WGSL.
pub fn has_subgroups(
    adapter: &wgpu::AdapterInfo,
    limits: &wgpu::Limits,
    features: wgpu::Features,
    path: Path,
) -> bool {
    path == Path::Passthrough
        && features.contains(wgpu::Features::SUBGROUP)
        && are_of_32(adapter)
        && limits.max_compute_invocations_per_workgroup >= sort::SUBGROUP_THREADS
        && limits.max_compute_workgroup_storage_size >= 32_768
}

/// Features that are used where they are there.
pub fn wanted_features(options: &DeviceOptions) -> wgpu::Features {
    let mut wanted = wgpu::Features::TIMESTAMP_QUERY | wgpu::Features::PIPELINE_CACHE;
    if options.path != Some(Path::Wgsl) {
        wanted |= wgpu::Features::PASSTHROUGH_SHADERS | wgpu::Features::SUBGROUP;
    }
    if !options.narrow {
        wanted |= wgpu::Features::SHADER_F64 | wgpu::Features::SHADER_INT64;
    }
    wanted
}

/// What every kernel needs; all of it is within the limits that WebGPU guarantees.
pub fn check_limits(adapter: &wgpu::AdapterInfo, limits: &wgpu::Limits) -> Result<(), Error> {
    let needs = [
        ("storage buffers a kernel", limits.max_storage_buffers_per_shader_stage as u64, 8),
        ("bytes of workgroup memory", limits.max_compute_workgroup_storage_size as u64, 16_384),
        ("threads a workgroup", limits.max_compute_invocations_per_workgroup as u64, 256),
        (
            "dynamic storage buffers",
            limits.max_dynamic_storage_buffers_per_pipeline_layout as u64,
            1,
        ),
    ];
    match needs.iter().find(|(_, has, needed)| has < needed) {
        Some((what, has, needed)) => Err(Error::Unavailable {
            why: format!("{} has {has} {what}, {needed} are needed", adapter.name),
        }),
        None => Ok(()),
    }
}

/// The entry to wgpu.
pub fn instance() -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    // Arguments of indirect dispatches, if there were any, would be our own: checking them costs a
    // dispatch each.
    descriptor.flags.remove(wgpu::InstanceFlags::VALIDATION_INDIRECT_CALL);
    wgpu::Instance::new(descriptor)
}

/// Names an adapter where options do not.
const VARIABLE: &str = "CCD_ADAPTER";

/// The adapter that is asked for.
pub async fn choose(
    instance: &wgpu::Instance,
    options: &DeviceOptions,
) -> Result<wgpu::Adapter, Error> {
    let of_variable = || std::env::var(VARIABLE).ok().filter(|name| !name.is_empty());
    let (wanted, who) = match options.adapter.clone() {
        Some(wanted) => (Some(wanted), String::new()),
        None => (of_variable(), format!("{VARIABLE}: ")),
    };
    let Some(wanted) = wanted else {
        let request = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        return instance
            .request_adapter(&request)
            .await
            .map_err(|e| Error::Unavailable { why: of_this_build(&e.to_string()) });
    };
    let mut all = instance.enumerate_adapters(wgpu::Backends::all()).await;
    let infos: Vec<wgpu::AdapterInfo> = all.iter().map(|a| a.get_info()).collect();
    match find(&infos, &wanted) {
        Some(at) => Ok(all.swap_remove(at)),
        None => Err(Error::Unavailable { why: who + &missing(&infos, &wanted) }),
    }
}

/// What wgpu says, without the APIs that this build does not have.
fn of_this_build(said: &str) -> String {
    let (what, each) = said.split_once("; ").unwrap_or((said, ""));
    let others = each.split(", ").filter(|part| !part.ends_with("not compiled in"));
    others.filter(|part| !part.is_empty()).fold(what.to_owned(), |text, part| text + "; " + part)
}

/// What an adapter is, as it is listed: the name, in parentheses the type, the GPU API and, if it
/// is known, the PCI id, which tells adapters of one name apart.
///
/// ```
/// use ccd::gpu::{Device, described};
///
/// for (number, adapter) in Device::adapters().iter().enumerate() {
///     println!("{number}: {}", described(adapter));
/// }
/// ```
pub fn described(a: &wgpu::AdapterInfo) -> String {
    format!("{} ({:?}, {}{})", a.name, a.device_type, a.backend, pci_of(a))
}

fn pci_of(a: &wgpu::AdapterInfo) -> String {
    match a.device_pci_bus_id.as_str() {
        "" => String::new(),
        id => format!(", PCI {id}"),
    }
}

/// Why there is no adapter, and which there are.
fn missing(all: &[wgpu::AdapterInfo], wanted: &str) -> String {
    let list: Vec<String> =
        all.iter().enumerate().map(|(at, a)| format!("{at}: {}", described(a))).collect();
    let list = if list.is_empty() { "none".into() } else { list.join("; ") };
    format!("no adapter has the number, the PCI id or the name {wanted:?}; there are: {list}")
}

/// The adapter that `wanted` means: by its number, by its PCI id, by a part of its name.
fn find(all: &[wgpu::AdapterInfo], wanted: &str) -> Option<usize> {
    let number = wanted.parse().ok().filter(|&at: &usize| at < all.len());
    let id = pci_id(wanted);
    let pci = |a: &wgpu::AdapterInfo| id.is_some() && pci_id(&a.device_pci_bus_id) == id;
    // A number that no adapter has is in many names by chance: 2 in that of an H200.
    let is_number = wanted.len() < 3 && wanted.bytes().all(|b| b.is_ascii_digit());
    let wanted = wanted.to_lowercase();
    let name = |a: &wgpu::AdapterInfo| !is_number && a.name.to_lowercase().contains(&wanted);
    number.or_else(|| all.iter().position(pci)).or_else(|| all.iter().position(name))
}

/// Domain (0 if there is none), bus, device and function of a PCI id, however many zeros it has:
/// `nvidia-smi` prints a domain of eight digits.
fn pci_id(text: &str) -> Option<[u32; 4]> {
    let (rest, function) = text.rsplit_once('.')?;
    let (rest, device) = rest.rsplit_once(':')?;
    let (domain, bus) = rest.rsplit_once(':').unwrap_or(("0", rest));
    let number = |digits: &str| u32::from_str_radix(digits, 16).ok();
    Some([number(domain)?, number(bus)?, number(device)?, number(function)?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn few_gpus_have_fast_f64() {
        let has = |name: &str, kind| {
            let mut a = wgpu::AdapterInfo::new(kind, wgpu::Backend::Vulkan);
            a.name = name.into();
            has_fast_f64(&a)
        };
        let gpu = wgpu::DeviceType::DiscreteGpu;
        for name in [
            "NVIDIA H200",
            "NVIDIA A100-SXM4-80GB",
            "Tesla V100-SXM2-16GB",
            "NVIDIA TITAN V",
            "AMD Instinct MI300X (RADV GFX942)",
            "AMD Radeon VII (RADV VEGA20)",
            "Intel(R) Data Center GPU Max 1550",
        ] {
            assert!(has(name, gpu), "{name}");
        }
        for name in [
            "NVIDIA GeForce RTX 4090",
            "NVIDIA TITAN RTX",
            "NVIDIA A10",
            "NVIDIA L40S",
            "NVIDIA RTX A6000",
            "AMD Radeon RX 7900 XTX (RADV NAVI31)",
            "AMD Radeon Graphics (RADV VEGA10)",
            "Intel(R) Arc(tm) A770 Graphics (DG2)",
            "Apple M1 Max",
        ] {
            assert!(!has(name, gpu), "{name}");
        }
        assert!(has("llvmpipe (LLVM 15.0.6, 256 bits)", wgpu::DeviceType::Cpu));
    }

    #[test]
    fn adapters_of_one_name_are_told_apart() {
        let adapter = |name: &str, pci: &str| {
            let mut a =
                wgpu::AdapterInfo::new(wgpu::DeviceType::DiscreteGpu, wgpu::Backend::Vulkan);
            (a.name, a.device_pci_bus_id) = (name.into(), pci.into());
            a
        };
        let all = [
            adapter("NVIDIA H200", "0000:3b:00.0"),
            adapter("NVIDIA H200", "0000:AF:00.0"),
            adapter("llvmpipe 7", ""),
        ];
        for (wanted, want) in [
            ("h200", Some(0)),
            ("200", Some(0)),
            ("1", Some(1)),
            ("2", Some(2)),
            ("0000:af:00.0", Some(1)),
            ("af:00.0", Some(1)),
            ("00000000:3B:00.0", Some(0)),
            ("3b:00.0", Some(0)),
            ("0001:3b:00.0", None),
            ("7", None),
            ("3", None),
            ("", None),
            ("0000:af", None),
            ("LLVM", Some(2)),
        ] {
            assert_eq!(find(&all, wanted), want, "{wanted}");
        }
        assert_eq!(
            missing(&all, "3"),
            "no adapter has the number, the PCI id or the name \"3\"; there are: \
             0: NVIDIA H200 (DiscreteGpu, vulkan, PCI 0000:3b:00.0); \
             1: NVIDIA H200 (DiscreteGpu, vulkan, PCI 0000:AF:00.0); \
             2: llvmpipe 7 (DiscreteGpu, vulkan)"
        );
        assert!(missing(&[], "3").ends_with("; there are: none"));
    }
}
