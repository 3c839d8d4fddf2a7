//! An engine that has its own wgpu device: its kernel moves a mesh on the device, and in the same
//! submission `ccd` finds the contacts of that motion. Nothing crosses to the host in between.
//! docs/engine.md explains it step by step; run it with `cargo run --release --example engine`.
#![deny(unsafe_code)]

use ccd::gpu::wgpu::{self, util::DeviceExt};
use ccd::gpu::{Device, DeviceOptions, Session};
use ccd::{Contact, Mesh, Options};
use ccd_core::records::{LIST_HEADER, Path, Touch, TouchGeometry};

/// What the engine's own kernel does: every vertex of the triangle falls, and is written at both
/// ends of the step as `ccd` reads it.
const MOVE: &str = "
struct Path { t0: vec4f, t1: vec4f }
@group(0) @binding(0) var<storage, read> rest: array<vec4f>;
@group(0) @binding(1) var<storage, read_write> paths: array<Path>;

@compute @workgroup_size(64)
fn move_vertices(@builtin(global_invocation_id) id: vec3u) {
    let v = id.x;
    if v < arrayLength(&rest) {
        let p = vec4f(rest[v].xyz, 0.0);
        // The last component says by how much the vertex falls in the step.
        paths[v] = Path(p, p - vec4f(0.0, rest[v].w, 0.0, 0.0));
    }
}";

/// x, y, z and fall of a vertex: a square that stands still, and a triangle that falls through it
/// with one corner first.
const REST: [[f32; 4]; 7] = [
    [0.0, 0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [1.0, 0.0, 1.0, 0.0],
    [0.3, 0.5, 0.3, 1.0],
    [0.2, 2.0, 0.3, 1.0],
    [0.4, 2.0, 0.3, 1.0],
];
const FACES: [[u32; 3]; 3] = [[0, 1, 2], [2, 1, 3], [4, 5, 6]];

/// All of it, once; the tests of the GPU call it too.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The engine's device, with what ccd can use of it.
    let instance =
        wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter =
        pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
    let features = Device::features() & adapter.features();
    let passthrough = features.contains(wgpu::Features::PASSTHROUGH_SHADERS);
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("engine"),
        required_features: features,
        required_limits: adapter.limits(),
        experimental_features: experimental_features(passthrough),
        ..Default::default()
    }))?;

    // A session of ccd on that device. Handles of wgpu are shared by cloning.
    let ccd_device = Device::from_wgpu(
        device.clone(),
        queue.clone(),
        adapter.get_info(),
        &DeviceOptions::default(),
    )?;
    println!("{}\n", ccd_device.info());
    let mesh = Mesh::new(REST.len(), &FACES)?;
    let mut session = Session::new(&ccd_device, mesh.clone(), Options::default())?;

    // The engine's kernel writes into the session's buffer of paths.
    let rest = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
        label: Some("rest"),
        contents: bytemuck::cast_slice(&REST),
        usage: wgpu::BufferUsages::STORAGE,
    });
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("move"),
        source: wgpu::ShaderSource::Wgsl(MOVE.into()),
    });
    let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label: Some("move"),
        layout: None,
        module: &module,
        entry_point: Some("move_vertices"),
        compilation_options: Default::default(),
        cache: None,
    });
    let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("move"),
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: rest.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 1, resource: session.paths().as_entire_binding() },
        ],
    });

    // One encoder: move, detect, copy to where the host can look.
    let mut encoder =
        device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("frame") });
    {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        pass.set_pipeline(&pipeline);
        pass.set_bind_group(0, &bind_group, &[]);
        pass.dispatch_workgroups((REST.len() as u32).div_ceil(64), 1, 1);
    }
    let paths = session.paths().clone();
    let found = session.record(&mut encoder)?;
    // Those that are undecided are contacts for an engine, too. A real one would go on with the
    // list on the device.
    let capacity = found.contacts.capacity();
    let bytes = found.contacts.bytes(capacity);
    let copy = copy_out(&device, &mut encoder, found.contacts.buffer(), bytes);
    // Where and along which normal each of them touches, for a kernel that responds.
    let geometry = session.record_geometry(&mut encoder)?.geometry.clone();
    let geometry = copy_out(&device, &mut encoder, &geometry, geometry.size());
    let path_bytes = (REST.len() * size_of::<Path>()) as u64;
    let paths = copy_out(&device, &mut encoder, &paths, path_bytes);
    queue.submit([encoder.finish()]);

    // On the host: how many, then which.
    let words: Vec<u32> = read(&device, &copy)?;
    assert!(words[0] <= capacity, "a list was too short: `Session::step` would make room");
    let n = words[0] as usize;
    let entries = &words[LIST_HEADER..LIST_HEADER + n * size_of::<Touch>() / 4];
    let mut contacts: Vec<Contact> =
        bytemuck::cast_slice(entries).iter().map(Contact::from).collect();
    let records = read(&device, &geometry)?;
    let records = &records[..n * size_of::<TouchGeometry>() / 4];
    let records: Vec<TouchGeometry> = bytemuck::cast_slice(records).to_vec();
    for (c, at) in contacts.iter().zip(&records) {
        let (time, point, normal) = (c.toi, at.point, at.normal);
        println!("{:?} {} {} at {time}, {:?}", c.kind, c.a, c.b, c.state);
        println!("  vertices {:?}, in {point:.3?} along {normal:.3?}", at.vertices);
    }
    println!("{n} contacts");

    // The same step on the CPU, from the positions that the engine's kernel wrote.
    let paths: Vec<Path> = bytemuck::cast_slice(&read(&device, &paths)?).to_vec();
    let at = |end: fn(&Path) -> [f32; 4]| -> Vec<[f32; 3]> {
        paths.iter().map(end).map(|[x, y, z, _]| [x, y, z]).collect()
    };
    let positions = [at(|p| p.t0), at(|p| p.t1)];
    let want = ccd::step(&mesh, &positions[0], &positions[1], session.options())?;
    assert!(!want.contacts.is_empty(), "the scene has contacts");
    for (c, at) in contacts.iter().zip(&records) {
        let want = c.geometry(&mesh, &positions[0], &positions[1]);
        let same = |a: [f32; 3], b: [f64; 3]| (0..3).all(|k| (a[k] as f64 - b[k]).abs() < 1e-4);
        assert!(same(at.point, want.point) && same(at.normal, want.normal), "{at:?} {want:?}");
    }
    contacts.sort_by_key(|c| (c.kind, c.a, c.b));
    assert_eq!(contacts, want.contacts);
    println!("the CPU finds the same");
    Ok(())
}

/// What wgpu calls experimental: the passthrough of shaders, or nothing.
#[allow(unsafe_code, reason = "wgpu has callers vouch for experimental features")]
fn experimental_features(passthrough: bool) -> wgpu::ExperimentalFeatures {
    if !passthrough {
        return wgpu::ExperimentalFeatures::disabled();
    }
    // SAFETY: the one experimental feature that is asked for is the passthrough of shaders, and
    // only ccd passes shaders through.
    unsafe { wgpu::ExperimentalFeatures::enabled() }
}

/// Records a copy of the front of a buffer into one that the host can read.
fn copy_out(
    device: &wgpu::Device,
    encoder: &mut wgpu::CommandEncoder,
    from: &wgpu::Buffer,
    bytes: u64,
) -> wgpu::Buffer {
    let usage = wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ;
    let copy = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("results"),
        size: bytes,
        usage,
        mapped_at_creation: false,
    });
    encoder.copy_buffer_to_buffer(from, 0, &copy, 0, bytes);
    copy
}

/// Waits for the device; the words of a buffer.
fn read(
    device: &wgpu::Device,
    buffer: &wgpu::Buffer,
) -> Result<Vec<u32>, Box<dyn std::error::Error>> {
    buffer.map_async(wgpu::MapMode::Read, .., |_| {});
    device.poll(wgpu::PollType::wait_indefinitely())?;
    let words = bytemuck::cast_slice(&buffer.get_mapped_range(..)?).to_vec();
    Ok(words)
}
