//! `ccd` in Bevy's render world: a session on Bevy's device, and a step in every frame's commands.

use bevy::core_pipeline::schedule::camera_driver;
use bevy::prelude::*;
use bevy::render::mesh::allocator::MeshAllocator;
use bevy::render::render_asset::RenderAssets;
use bevy::render::renderer::{
    RenderAdapterInfo, RenderContext, RenderDevice, RenderGraph, RenderQueue,
};
use bevy::render::storage::{GpuShaderBuffer, ShaderBuffer};
use bevy::render::{RenderApp, RenderStartup};
use bytemuck::{pod_collect_to_vec, pod_read_unaligned};
use ccd::gpu::wgpu::{self, BufferUsages, util::DeviceExt};
use ccd_core::records::{LIST_HEADER, Path, Touch, TouchGeometry};

/// Entries of every list of the session.
const CAPACITY: u32 = 1 << 17;
/// Contacts that are read back, at most.
const MAX_READ: u64 = 1 << 14;
const HEADER: u64 = LIST_HEADER as u64 * 4;

/// Where parts of [`Scene::results`] begin, in bytes: headers of all lists, contacts, geometry,
/// paths.
const CONTACTS: u64 = 16 * HEADER;
const GEOMETRY: u64 = CONTACTS + HEADER + MAX_READ * size_of::<Touch>() as u64;
const PATHS: u64 = GEOMETRY + MAX_READ * size_of::<TouchGeometry>() as u64;

/// What moves and what it may touch; the same in both worlds.
#[derive(Resource, Clone)]
pub struct Scene {
    /// The cloth's vertices, then those of what stands still.
    pub mesh: ccd::Mesh,
    pub options: ccd::Options,
    /// At the start, of all vertices.
    pub positions: Vec<[f32; 3]>,
    /// Vertices on a side of the cloth, and metres between them.
    pub side: u32,
    pub spacing: f32,
    /// What Bevy draws of the cloth: positions and normals alone, which the GPU overwrites.
    pub cloth: Handle<Mesh>,
    /// What is read back of a frame.
    pub results: Handle<ShaderBuffer>,
    /// Whether that includes all paths.
    pub read_paths: bool,
}

impl Scene {
    /// A buffer for [`Scene::results`].
    pub fn results(n_vertices: usize, read_paths: bool) -> ShaderBuffer {
        let paths = if read_paths { n_vertices * size_of::<Path>() } else { 0 };
        let mut buffer = ShaderBuffer::with_size(PATHS + paths as u64, default());
        buffer.buffer_usage |= BufferUsages::COPY_SRC;
        buffer
    }
}

/// What was read back of a frame.
#[derive(Resource, Default)]
pub struct Found {
    pub touches: Vec<Touch>,
    /// One record for each of them.
    pub geometry: Vec<TouchGeometry>,
    pub paths: Vec<Path>,
}

impl Found {
    /// From the bytes of [`Scene::results`]; `None` before the first frame.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let headers: Vec<[u32; LIST_HEADER]> = pod_collect_to_vec(&bytes[..CONTACTS as usize]);
        if headers.iter().all(|[wanted, ..]| *wanted == 0) {
            return None;
        }
        for [wanted, _, beyond, _] in headers {
            let fits = wanted <= CAPACITY && beyond == 0;
            assert!(fits, "a list of the session wants {wanted} entries: reserve more");
        }
        let at = (CONTACTS + HEADER) as usize;
        let n: u32 = pod_read_unaligned(&bytes[CONTACTS as usize..][..4]);
        let n = n as usize;
        assert!(n <= MAX_READ as usize, "{n} contacts are more than are read back");
        let (touches, geometry) = (n * size_of::<Touch>(), n * size_of::<TouchGeometry>());
        Some(Self {
            touches: pod_collect_to_vec(&bytes[at..at + touches]),
            geometry: pod_collect_to_vec(&bytes[GEOMETRY as usize..GEOMETRY as usize + geometry]),
            paths: pod_collect_to_vec(&bytes[PATHS as usize..]),
        })
    }
}

/// Moves the cloth of [`Scene`], a resource that it copies to the render world.
pub struct ContactsPlugin;

impl Plugin for ContactsPlugin {
    fn build(&self, app: &mut App) {
        let scene = app.world().resource::<Scene>().clone();
        app.sub_app_mut(RenderApp)
            .insert_resource(scene)
            .add_systems(RenderStartup, open)
            .add_systems(RenderGraph, step.before(camera_driver));
    }
}

/// The session, and what the kernels of `cloth.wgsl` work on.
#[derive(Resource)]
struct Cloth {
    session: ccd::gpu::Session,
    kernels: [wgpu::ComputePipeline; 3],
    vertices: wgpu::Buffer,
    earliest: wgpu::Buffer,
    drawn: wgpu::Buffer,
}

/// Once Bevy has its device: a session on it. Bevy asks for all features of its adapter, so ccd
/// finds those of `Device::features()` that there are.
fn open(
    mut commands: Commands,
    scene: Res<Scene>,
    device: Res<RenderDevice>,
    queue: Res<RenderQueue>,
    adapter: Res<RenderAdapterInfo>,
) -> Result {
    let device = device.wgpu_device();
    let (d, q, info) = (device.clone(), (**queue).clone(), (**adapter).clone());
    let shared = ccd::gpu::Device::from_wgpu(d, q, info, &default())?;
    info!("ccd on Bevy's device:\n{}", shared.info());
    let mut session = ccd::gpu::Session::new(&shared, scene.mesh.clone(), scene.options.clone())?;
    session.reserve(CAPACITY)?;

    let module = device.create_shader_module(wgpu::include_wgsl!("cloth.wgsl"));
    let constants = [("SIDE", scene.side as f64), ("SPACING", scene.spacing as f64)];
    let kernels = ["predict", "respond", "settle"].map(|name| {
        let overrides: &[_] = if name == "respond" { &[] } else { &constants };
        device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(name),
            layout: None,
            module: &module,
            entry_point: Some(name),
            compilation_options: wgpu::PipelineCompilationOptions {
                constants: overrides,
                ..default()
            },
            cache: None,
        })
    });
    // The one upload of positions, each with a velocity of 0.
    let at_rest = |&[x, y, z]: &[f32; 3]| [x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0];
    let at_rest: Vec<[f32; 8]> = scene.positions.iter().map(at_rest).collect();
    let vertices = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("vertices"),
        contents: bytemuck::cast_slice(&at_rest),
        usage: BufferUsages::STORAGE,
    });
    let buffer = |label, size, usage| {
        let (label, mapped_at_creation) = (Some(label), false);
        device.create_buffer(&wgpu::BufferDescriptor { label, size, usage, mapped_at_creation })
    };
    let earliest = buffer("earliest", 4 * scene.positions.len() as u64, BufferUsages::STORAGE);
    let bytes_drawn = 24 * (scene.side * scene.side) as u64;
    let drawn = buffer("drawn", bytes_drawn, BufferUsages::STORAGE | BufferUsages::COPY_SRC);
    commands.insert_resource(Cloth { session, kernels, vertices, earliest, drawn });
    Ok(())
}

/// Records a frame before Bevy draws it, in the commands that Bevy submits: the cloth moves, ccd
/// finds contacts, these stop the cloth, and Bevy's mesh gets its new positions.
fn step(
    mut context: RenderContext,
    mut cloth: ResMut<Cloth>,
    scene: Res<Scene>,
    meshes: Res<MeshAllocator>,
    buffers: Res<RenderAssets<GpuShaderBuffer>>,
) -> Result {
    let mesh = meshes.mesh_vertex_slice(&scene.cloth.id());
    let (Some(mesh), Some(results)) = (mesh, buffers.get(&scene.results)) else {
        return Ok(()); // Bevy has not made them yet.
    };
    let results: &wgpu::Buffer = &results.buffer;
    let device = context.render_device().wgpu_device().clone();
    let encoder = context.command_encoder();
    let Cloth { session, kernels: [predict, respond, settle], vertices, earliest, drawn } =
        &mut *cloth;
    let paths = session.paths().clone();

    let bound = [(0, &*vertices), (1, &paths), (2, &*earliest), (5, &*drawn)];
    dispatch(&device, encoder, predict, &bound, 1);
    let found = session.record(encoder)?;
    assert!(found.lists.len() as u64 * HEADER <= CONTACTS, "room for headers");
    for (i, list) in found.lists.iter().enumerate() {
        encoder.copy_buffer_to_buffer(list.buffer(), 0, results, i as u64 * HEADER, HEADER);
    }
    let found = session.record_geometry(encoder)?;
    let (contacts, geometry) = (found.contacts.buffer(), found.geometry);
    let touched = [(2, &*earliest), (3, contacts), (4, geometry)];
    dispatch(&device, encoder, respond, &touched, 64);
    dispatch(&device, encoder, settle, &bound, 1);

    // For Bevy to draw, and for the host to read.
    let at = mesh.range.start as u64 * 24;
    encoder.copy_buffer_to_buffer(drawn, 0, mesh.buffer, at, drawn.size());
    encoder.copy_buffer_to_buffer(contacts, 0, results, CONTACTS, GEOMETRY - CONTACTS);
    encoder.copy_buffer_to_buffer(geometry, 0, results, GEOMETRY, PATHS - GEOMETRY);
    if scene.read_paths {
        encoder.copy_buffer_to_buffer(&paths, 0, results, PATHS, results.size() - PATHS);
    }
    Ok(())
}

/// A kernel with buffers at these bindings.
fn dispatch(
    device: &wgpu::Device,
    encoder: &mut wgpu::CommandEncoder,
    kernel: &wgpu::ComputePipeline,
    buffers: &[(u32, &wgpu::Buffer)],
    n_groups: u32,
) {
    let entries: Vec<_> = buffers
        .iter()
        .map(|&(binding, buffer)| wgpu::BindGroupEntry {
            binding,
            resource: buffer.as_entire_binding(),
        })
        .collect();
    let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &kernel.get_bind_group_layout(0),
        entries: &entries,
    });
    let mut pass = encoder.begin_compute_pass(&default());
    pass.set_pipeline(kernel);
    pass.set_bind_group(0, &bind_group, &[]);
    pass.dispatch_workgroups(n_groups, 1, 1);
}
