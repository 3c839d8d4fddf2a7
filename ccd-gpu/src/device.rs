//! The device: choosing an adapter and a path for shaders, saying which and why, pipelines, and
//! what happens when it fails.

use crate::error::Error;
use crate::shaders::module;
use ccd_core::kernel::{Access, Id, TABLE};
use std::fmt;
use std::sync::{Arc, Mutex, OnceLock};

/// How shaders reach the driver.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Path {
    /// SPIR-V as compiled, with contraction forbidden: Vulkan only.
    Passthrough,
    /// WGSL, through naga: every backend.
    Wgsl,
}

/// What is wanted of a device.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DeviceOptions {
    /// A part of the adapter's name, in any case; `None`: the one that wgpu prefers, and the
    /// environment variable `CCD_ADAPTER` if it is set.
    pub adapter: Option<String>,
    /// The path for shaders; `None`: passthrough where there is Vulkan, else WGSL.
    pub path: Option<Path>,
    /// Leave `f64` unused even where the device has it: what `f32` cannot decide is then decided on
    /// the CPU.
    pub narrow: bool,
}

/// What a device is and how it is used.
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
        writeln!(f, "adapter     {} ({:?})", a.name, a.device_type)?;
        writeln!(f, "backend     {}, driver {} {}", a.backend, a.driver, a.driver_info)?;
        writeln!(f, "shaders     {path}: {}", self.why)?;
        writeln!(
            f,
            "f64         {}",
            if self.wide { "on the device" } else { "on the CPU, for what f32 cannot decide" }
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
            "            {} storage buffers a kernel, {} bytes of workgroup memory, {} threads a workgroup, {} workgroups a dimension",
            l.max_storage_buffers_per_shader_stage,
            l.max_compute_workgroup_storage_size,
            l.max_compute_invocations_per_workgroup,
            l.max_compute_workgroups_per_dimension
        )
    }
}

/// A GPU, its queue, and the compiled kernels. Clones share them.
#[derive(Clone)]
pub struct Device {
    inner: Arc<Inner>,
}

struct Inner {
    device: wgpu::Device,
    queue: wgpu::Queue,
    info: Info,
    lost: Arc<Mutex<Option<String>>>,
    pipelines: Vec<OnceLock<Pipeline>>,
}

/// A compiled kernel.
pub(crate) struct Pipeline {
    pub pipeline: wgpu::ComputePipeline,
    pub layout: wgpu::BindGroupLayout,
}

impl fmt::Debug for Device {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Device")
            .field("adapter", &self.inner.info.adapter.name)
            .field("path", &self.inner.info.path)
            .finish_non_exhaustive()
    }
}

/// Features that are used where they are there.
fn wanted_features(options: &DeviceOptions) -> wgpu::Features {
    let mut wanted = wgpu::Features::TIMESTAMP_QUERY;
    if options.path != Some(Path::Wgsl) {
        wanted |= wgpu::Features::PASSTHROUGH_SHADERS;
    }
    if !options.narrow {
        wanted |= wgpu::Features::SHADER_F64 | wgpu::Features::SHADER_INT64;
    }
    wanted
}

impl Device {
    /// What an application should ask of its own device so that [`Device::from_wgpu`] can use all
    /// of it; intersect with what its adapter has.
    pub fn features() -> wgpu::Features {
        wanted_features(&DeviceOptions::default())
    }

    /// Opens a device. Blocks until it is there.
    pub fn open(options: &DeviceOptions) -> Result<Self, Error> {
        pollster::block_on(Self::open_async(options))
    }

    /// All adapters of this machine, once for every GPU API that reaches them.
    pub fn adapters() -> Vec<wgpu::AdapterInfo> {
        pollster::block_on(instance().enumerate_adapters(wgpu::Backends::all()))
            .iter()
            .map(|a| a.get_info())
            .collect()
    }

    async fn open_async(options: &DeviceOptions) -> Result<Self, Error> {
        let instance = instance();
        let adapter = choose(&instance, options).await?;
        let info = adapter.get_info();
        let features = wanted_features(options) & adapter.features();
        let refused = |e: wgpu::RequestDeviceError| Error::Unavailable {
            why: format!("{} gives no device: {e}", info.name),
        };
        let passthrough = features.contains(wgpu::Features::PASSTHROUGH_SHADERS);
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor {
                label: Some("ccd"),
                required_features: features,
                required_limits: adapter.limits(),
                experimental_features: if passthrough {
                    // SAFETY: passthrough is the one experimental feature asked for; what it needs
                    // is said at `Device::compile`.
                    unsafe { wgpu::ExperimentalFeatures::enabled() }
                } else {
                    wgpu::ExperimentalFeatures::disabled()
                },
                ..Default::default()
            })
            .await
            .map_err(refused)?;
        let out = Self::from_wgpu(device, queue, info, options)?;
        let lost = out.inner.lost.clone();
        out.inner.device.set_device_lost_callback(move |reason, message| {
            *lost.lock().unwrap_or_else(|e| e.into_inner()) = Some(format!("{reason:?} {message}"));
        });
        Ok(out)
    }

    /// Uses a device that an application owns; see [`Device::features`]. The application keeps its
    /// callbacks for errors and for the loss of the device.
    pub fn from_wgpu(
        device: wgpu::Device,
        queue: wgpu::Queue,
        adapter: wgpu::AdapterInfo,
        options: &DeviceOptions,
    ) -> Result<Self, Error> {
        let features = device.features();
        let can_pass = adapter.backend == wgpu::Backend::Vulkan
            && features.contains(wgpu::Features::PASSTHROUGH_SHADERS);
        let (path, why) = match options.path {
            Some(Path::Passthrough) if !can_pass => {
                let why =
                    format!("{} ({}) has no passthrough of shaders", adapter.name, adapter.backend);
                return Err(Error::Unavailable { why });
            }
            Some(path) => (path, "as asked"),
            None if can_pass => (Path::Passthrough, "the device takes compiled shaders"),
            None => (Path::Wgsl, "the device takes no compiled shaders"),
        };
        if adapter.backend == wgpu::Backend::Gl {
            // Its kernels were seen to end without results and without an error.
            let why = format!(
                "{} through OpenGL: kernels do not run there; Vulkan, Metal and DX12 are supported",
                adapter.name
            );
            return Err(Error::Unavailable { why });
        }
        let limits = device.limits();
        check_limits(&adapter, &limits)?;
        let wide_features = wgpu::Features::SHADER_F64 | wgpu::Features::SHADER_INT64;
        let info = Info {
            path,
            why,
            wide: !options.narrow && features.contains(wide_features),
            timestamps: features.contains(wgpu::Features::TIMESTAMP_QUERY),
            adapter,
            limits,
        };
        let pipelines = TABLE.iter().map(|_| OnceLock::new()).collect();
        Ok(Self { inner: Arc::new(Inner { device, queue, info, lost: Arc::default(), pipelines }) })
    }

    /// What the device is and how it is used.
    pub fn info(&self) -> &Info {
        &self.inner.info
    }

    /// The wgpu device.
    pub fn wgpu(&self) -> &wgpu::Device {
        &self.inner.device
    }

    /// Its queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.inner.queue
    }

    /// Runs `work` and turns what the device reports meanwhile into an error. `what`, `bytes`: for
    /// lack of memory.
    pub(crate) fn guarded<T>(
        &self,
        what: &'static str,
        bytes: u64,
        work: impl FnOnce() -> T,
    ) -> Result<T, Error> {
        self.check_lost()?;
        let device = &self.inner.device;
        let scopes = [
            wgpu::ErrorFilter::Internal,
            wgpu::ErrorFilter::Validation,
            wgpu::ErrorFilter::OutOfMemory,
        ]
        .map(|f| device.push_error_scope(f));
        let out = work();
        let [internal, validation, memory] = scopes;
        let memory = pollster::block_on(memory.pop());
        let validation = pollster::block_on(validation.pop());
        let internal = pollster::block_on(internal.pop());
        self.check_lost()?;
        if memory.is_some() {
            return Err(Error::OutOfMemory { what, bytes });
        }
        match validation.or(internal) {
            Some(e) => Err(Error::Refused { why: e.to_string() }),
            None => Ok(out),
        }
    }

    /// Fails once the device is lost.
    pub(crate) fn check_lost(&self) -> Result<(), Error> {
        match &*self.inner.lost.lock().unwrap_or_else(|e| e.into_inner()) {
            Some(why) => Err(Error::Lost { why: why.clone() }),
            None => Ok(()),
        }
    }

    /// Waits for all that was submitted.
    pub(crate) fn wait(&self) -> Result<(), Error> {
        let waited = self.inner.device.poll(wgpu::PollType::wait_indefinitely());
        self.check_lost()?;
        waited.map(|_| ()).map_err(|e| Error::Lost { why: e.to_string() })
    }

    /// A buffer, or why there is none.
    pub(crate) fn buffer(
        &self,
        what: &'static str,
        bytes: u64,
        usage: wgpu::BufferUsages,
    ) -> Result<wgpu::Buffer, Error> {
        // A binding is never empty, and at least as large as one record of any kind.
        let bytes = bytes.max(256).next_multiple_of(16);
        let limits = &self.inner.info.limits;
        let limit = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        if bytes > limit {
            return Err(Error::TooLarge { what, bytes, limit });
        }
        let descriptor = wgpu::BufferDescriptor {
            label: Some(what),
            size: bytes,
            usage,
            mapped_at_creation: false,
        };
        self.guarded(what, bytes, || self.inner.device.create_buffer(&descriptor))
    }

    /// The pipeline of a kernel, compiled on first use.
    pub(crate) fn pipeline(&self, id: Id) -> &Pipeline {
        self.inner.pipelines[id as usize].get_or_init(|| self.compile(id))
    }

    fn compile(&self, id: Id) -> Pipeline {
        let Inner { device, info, .. } = &*self.inner;
        let row = id.row();
        let module = module(id);
        let shader = match info.path {
            Path::Wgsl => {
                let source = wgpu::ShaderSource::Wgsl(module.wgsl.into());
                device.create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some(row.name),
                    source,
                })
            }
            Path::Passthrough => {
                let words: Vec<u32> = module
                    .spirv
                    .chunks_exact(4)
                    .map(|b| u32::from_le_bytes([b[0], b[1], b[2], b[3]]))
                    .collect();
                let entry = wgpu::PassthroughShaderEntryPoint {
                    name: row.name.into(),
                    workgroup_size: (row.threads, 1, 1),
                };
                let descriptor = wgpu::ShaderModuleDescriptorPassthrough {
                    label: Some(row.name),
                    entry_points: vec![entry].into(),
                    spirv: Some(words.into()),
                    ..Default::default()
                };
                // SAFETY: the module passed the validator, its bindings are those of the table
                // (both are tested), and it indexes only what the parameters say is there.
                unsafe { device.create_shader_module_passthrough(descriptor) }
            }
        };
        let entries: Vec<_> = (0..)
            .zip(row.bindings())
            .map(|(i, access)| layout_entry(i, access, row.params.is_some() && i == 0))
            .collect();
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some(row.name),
            entries: &entries,
        });
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(row.name),
            bind_group_layouts: &[Some(&layout)],
            ..Default::default()
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(row.name),
            layout: Some(&pipeline_layout),
            module: &shader,
            entry_point: Some(row.name),
            // Kernels set what they read.
            compilation_options: wgpu::PipelineCompilationOptions {
                zero_initialize_workgroup_memory: false,
                ..Default::default()
            },
            cache: None,
        });
        Pipeline { pipeline, layout }
    }
}

fn layout_entry(binding: u32, access: Access, is_params: bool) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only: access != Access::Write },
            has_dynamic_offset: is_params,
            min_binding_size: None,
        },
        count: None,
    }
}

/// What every kernel needs; all of it is within the limits that WebGPU guarantees.
fn check_limits(adapter: &wgpu::AdapterInfo, limits: &wgpu::Limits) -> Result<(), Error> {
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

fn instance() -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    // Arguments of indirect dispatches, if there were any, would be our own: checking them costs a
    // dispatch each.
    descriptor.flags.remove(wgpu::InstanceFlags::VALIDATION_INDIRECT_CALL);
    wgpu::Instance::new(descriptor)
}

async fn choose(
    instance: &wgpu::Instance,
    options: &DeviceOptions,
) -> Result<wgpu::Adapter, Error> {
    let wanted = options.adapter.clone().or_else(|| std::env::var("CCD_ADAPTER").ok());
    let Some(wanted) = wanted else {
        let request = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        return instance
            .request_adapter(&request)
            .await
            .map_err(|e| Error::Unavailable { why: e.to_string() });
    };
    let all = instance.enumerate_adapters(wgpu::Backends::all()).await;
    let names: Vec<String> = all.iter().map(|a| a.get_info().name).collect();
    let found =
        all.into_iter().find(|a| a.get_info().name.to_lowercase().contains(&wanted.to_lowercase()));
    found.ok_or_else(|| Error::Unavailable {
        why: format!("no adapter is named like \"{wanted}\"; there are: {}", names.join(", ")),
    })
}
