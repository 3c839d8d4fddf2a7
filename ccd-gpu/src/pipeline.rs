//! Compiled kernels: from a row of the kernel table and its module to a pipeline.

use crate::adapter::{Info, Path};
use crate::shaders::module;
use ccd_core::backend::kernel::{Access, Id};
use std::iter::once;

/// A compiled kernel.
pub struct Pipeline {
    pub pipeline: wgpu::ComputePipeline,
    pub layout: wgpu::BindGroupLayout,
}

/// Modules that check their indices, by id, and the buffer in which each counts those past the end;
/// see [`crate::harness::open_checked`].
pub struct Checked {
    pub modules: Vec<Vec<u8>>,
    pub status: wgpu::Buffer,
}

impl Checked {
    /// Bytes from the word of a kernel to that of the next.
    pub const STRIDE: u64 = 256;

    /// The word of a kernel, which is bound behind all of its buffers.
    pub fn word(&self, id: Id) -> wgpu::BindingResource<'_> {
        let (offset, size) = (id as u64 * Self::STRIDE, wgpu::BufferSize::new(16));
        wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer: &self.status, offset, size })
    }
}

impl Pipeline {
    /// Compiles a kernel, through one of the paths for shaders, or takes it from the cache.
    pub fn compile(
        device: &wgpu::Device,
        info: &Info,
        id: Id,
        cache: Option<&wgpu::PipelineCache>,
        checked: Option<&Checked>,
    ) -> Self {
        let row = id.row();
        let module = || module(id, info.path);
        let shader = match info.path {
            Path::Wgsl => {
                let source = String::from_utf8(module()).unwrap_or_default();
                let source = wgpu::ShaderSource::Wgsl(source.into());
                let descriptor = wgpu::ShaderModuleDescriptor { label: Some(row.name), source };
                if info.adapter.backend == wgpu::Backend::Vulkan {
                    let checks = wgpu::ShaderRuntimeChecks {
                        bounds_checks: false,
                        force_loop_bounding: false,
                        ..wgpu::ShaderRuntimeChecks::checked()
                    };
                    // SAFETY: every loop ends. The indices are those of the SPIR-V from which the
                    // module was translated, and as safe as they are below.
                    #[allow(unsafe_code, reason = "wgpu trusts no shader to stay in its memory")]
                    unsafe {
                        device.create_shader_module_trusted(descriptor, checks)
                    }
                } else {
                    device.create_shader_module(descriptor)
                }
            }
            Path::Passthrough => {
                let spirv =
                    checked.map_or_else(module, |checked| checked.modules[id as usize].clone());
                let words: Vec<u32> = spirv
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
                // SAFETY: the module passed the validator and its bindings are those of the table
                // (both are tested). No index is checked. Those into buffers are bounded by
                // robustBufferAccess on every device that wgpu has opened; another that an
                // application made must have it on. Those into workgroup memory nothing bounds but
                // the kernels, which tests run with a check of each (`harness::open_checked`).
                #[allow(unsafe_code, reason = "wgpu does not check SPIR-V that it passes through")]
                unsafe {
                    device.create_shader_module_passthrough(descriptor)
                }
            }
        };
        let entries: Vec<_> = (0..)
            .zip(row.bindings().chain(checked.iter().flat_map(|_| once(Access::Write))))
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
            cache,
        });
        Self { pipeline, layout }
    }
}

/// A cache of compiled kernels with what a driver gave before, or an empty one.
pub fn cache(device: &wgpu::Device, stored: Option<&[u8]>) -> wgpu::PipelineCache {
    let descriptor =
        wgpu::PipelineCacheDescriptor { label: Some("ccd"), data: stored, fallback: true };
    // SAFETY: the data are what `PipelineCache::get_data` gave for such an adapter and driver,
    // whole and unchanged: `KernelFile::read` has compared length and digest, and on Unix the file
    // is one that nobody but the user could write. wgpu compares device and driver once more.
    #[allow(unsafe_code, reason = "wgpu does not check what drivers keep")]
    unsafe {
        device.create_pipeline_cache(&descriptor)
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
