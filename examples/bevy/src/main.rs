//! A cloth falls onto a sphere in a Bevy app: its positions stay on the GPU, where `ccd` finds
//! contacts on Bevy's own render device. Contacts alone are read back, and drawn as gizmos.
//!
//! In this folder, `cargo run` opens a window. `--frames N` ends after N frames, `--screenshot
//! FILE.png` saves the last one, and `--check` compares every frame's contacts with the CPU's.

mod contacts;

use bevy::asset::RenderAssetUsages;
use bevy::camera::visibility::NoFrustumCulling;
use bevy::core_pipeline::tonemapping::Tonemapping;
use bevy::mesh::{Indices, PrimitiveTopology, VertexAttributeValues};
use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::gpu_readback::{Readback, ReadbackComplete};
use bevy::render::settings::{Backends, WgpuSettings};
use bevy::render::storage::ShaderBuffer;
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured, save_to_disk};
use contacts::{ContactsPlugin, Found, Scene};

/// Vertices on a side of the cloth.
const SIDE: u32 = 60;
/// Metres between two of them.
const SPACING: f32 = 0.035;
/// Metres.
const RADIUS: f32 = 0.7;

/// What the command line asks for.
#[derive(Resource, Default)]
struct Args {
    frames: Option<u32>,
    screenshot: Option<String>,
    check: bool,
}

/// What was found so far: frames, frames with contacts, and most contacts of a frame.
#[derive(Resource, Default)]
struct Seen {
    frames: u32,
    touching: u32,
    most: usize,
}

/// The session on the CPU that `--check` compares with.
#[derive(Resource)]
struct Cpu(ccd::Session);

fn main() -> Result<AppExit> {
    let args = args()?;
    let mut app = App::new();
    // Not OpenGL, which ccd refuses; and the first frame waits for its pipelines, so that a run of
    // few frames shows something.
    let settings = WgpuSettings { backends: Some(Backends::PRIMARY), ..default() };
    let render = RenderPlugin {
        render_creation: settings.into(),
        synchronous_pipeline_compilation: true,
        ..default()
    };
    let window = Window { title: "ccd".into(), resolution: (840, 640).into(), ..default() };
    let window = WindowPlugin { primary_window: Some(window), ..default() };
    app.add_plugins(DefaultPlugins.set(render).set(window));
    let scene = scene(app.world_mut(), args.check)?;
    app.insert_resource(Cpu(ccd::Session::new(scene.mesh.clone(), scene.options.clone())?))
        .insert_resource(scene)
        .insert_resource(args)
        .init_resource::<Found>()
        .init_resource::<Seen>()
        .add_plugins(ContactsPlugin)
        .add_systems(Update, draw);
    Ok(app.run())
}

fn args() -> Result<Args> {
    let mut args = Args::default();
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--frames" => args.frames = Some(words.next().ok_or("--frames N")?.parse()?),
            "--screenshot" => args.screenshot = words.next(),
            "--check" => args.check = true,
            _ => return Err(format!("{word}: --frames N, --screenshot FILE.png, --check").into()),
        }
    }
    Ok(args)
}

/// Spawns cloth, sphere, camera and light. Bevy's meshes and ccd's mesh have the same vertices.
fn scene(world: &mut World, read_paths: bool) -> Result<Scene> {
    let half = SPACING * (SIDE - 1) as f32 / 2.0;
    let at = |v: u32| [v % SIDE, v / SIDE].map(|i| i as f32 * SPACING - half);
    let cloth = |v| -> [f32; 3] { [at(v)[0], RADIUS + 0.1, at(v)[1]] };
    let mut positions: Vec<[f32; 3]> = (0..SIDE * SIDE).map(cloth).collect();
    let quads = (0..SIDE * (SIDE - 1)).filter(|v| v % SIDE != SIDE - 1);
    let mut indices: Vec<u32> =
        quads.flat_map(|v| [v, v + SIDE, v + 1, v + 1, v + SIDE, v + SIDE + 1]).collect();
    let drawn = Mesh::new(PrimitiveTopology::TriangleList, RenderAssetUsages::RENDER_WORLD)
        .with_inserted_attribute(Mesh::ATTRIBUTE_NORMAL, vec![[0.0, 1.0, 0.0]; positions.len()])
        .with_inserted_attribute(Mesh::ATTRIBUTE_POSITION, positions.clone())
        .with_inserted_indices(Indices::U32(indices.clone()));

    let sphere = Sphere::new(RADIUS).mesh().ico(12)?;
    let (n_cloth, first) = (positions.len(), positions.len() as u32);
    if let Some(VertexAttributeValues::Float32x3(more)) = sphere.attribute(Mesh::ATTRIBUTE_POSITION)
    {
        positions.extend(more);
    }
    indices.extend(sphere.indices().ok_or("no indices")?.iter().map(|i| first + i as u32));
    let body: Vec<u32> = (0..positions.len()).map(|v| (v >= n_cloth) as u32).collect();

    let mut buffers = world.resource_mut::<Assets<ShaderBuffer>>();
    let results = buffers.add(Scene::results(positions.len(), read_paths));
    world.spawn(Readback::buffer(results.clone())).observe(receive);
    let mut meshes = world.resource_mut::<Assets<Mesh>>();
    let (cloth, sphere) = (meshes.add(drawn), meshes.add(sphere));
    let mut materials = world.resource_mut::<Assets<StandardMaterial>>();
    let linen = materials.add(StandardMaterial {
        base_color: Color::srgb(0.25, 0.4, 0.65),
        perceptual_roughness: 0.9,
        double_sided: true,
        cull_mode: None,
        ..default()
    });
    let stone = materials.add(Color::srgb(0.75, 0.7, 0.65));
    // Bevy does not know where the GPU moves the cloth.
    world.spawn((Mesh3d(cloth.clone()), MeshMaterial3d(linen), NoFrustumCulling));
    world.spawn((Mesh3d(sphere), MeshMaterial3d(stone)));
    world.spawn((
        Camera3d::default(),
        // The default one needs tables that are a feature of Bevy.
        Tonemapping::AcesFitted,
        AmbientLight { brightness: 700.0, ..default() },
        Transform::from_xyz(1.0, 0.75, 2.1).looking_at(Vec3::new(-0.03, -0.03, 0.0), Vec3::Y),
    ));
    world.spawn((
        DirectionalLight { shadow_maps_enabled: true, illuminance: 6000.0, ..default() },
        Transform::from_xyz(0.0, 3.0, 2.5).looking_at(Vec3::ZERO, Vec3::Y),
    ));
    // Lines lie over what they are on.
    let mut gizmos = world.resource_mut::<GizmoConfigStore>();
    let (config, _) = gizmos.config_mut::<DefaultGizmoConfigGroup>();
    config.depth_bias = -0.01;

    Ok(Scene {
        mesh: ccd::Mesh::new(positions.len(), bytemuck::cast_slice::<u32, [u32; 3]>(&indices))?,
        options: ccd::Options::default().with_bodies(ccd::Bodies::new(&body).with_fixed(1, true)),
        positions,
        side: SIDE,
        spacing: SPACING,
        cloth,
        results,
        read_paths,
    })
}

/// Takes the contacts of a frame, some frames later, and ends the app after the last one.
fn receive(
    results: On<ReadbackComplete>,
    args: Res<Args>,
    mut cpu: ResMut<Cpu>,
    mut seen: ResMut<Seen>,
    mut found: ResMut<Found>,
    mut commands: Commands,
) -> Result {
    let Some(now) = Found::read(&results) else { return Ok(()) };
    *found = now;
    seen.frames += 1;
    seen.touching += !found.touches.is_empty() as u32;
    seen.most = seen.most.max(found.touches.len());
    if args.check {
        check(&found, &mut cpu.0)?;
    }
    if args.frames != Some(seen.frames) {
        return Ok(());
    }
    println!(
        "{} frames, {} of them with contacts, at most {} and at last {}{}",
        seen.frames,
        seen.touching,
        seen.most,
        found.touches.len(),
        if args.check { "; the CPU finds the same in every frame" } else { "" }
    );
    assert!(seen.touching > 0, "the cloth has not touched anything");
    let Some(file) = &args.screenshot else {
        commands.write_message(AppExit::Success);
        return Ok(());
    };
    let mut screenshot = commands.spawn(Screenshot::primary_window());
    screenshot.observe(save_to_disk(file.clone()));
    screenshot.observe(|_: On<ScreenshotCaptured>, mut commands: Commands| {
        commands.write_message(AppExit::Success);
    });
    Ok(())
}

/// Compares a frame's contacts with those of a CPU, from the paths that the GPU was given.
fn check(found: &Found, cpu: &mut ccd::Session) -> Result {
    let at = |end: fn(&ccd_core::records::Path) -> [f32; 4]| -> Vec<[f32; 3]> {
        found.paths.iter().map(end).map(|[x, y, z, _]| [x, y, z]).collect()
    };
    let want = cpu.step(&at(|p| p.t0), &at(|p| p.t1))?;
    let want: Vec<_> = want.contacts.iter().map(|c| (c.kind, c.a, c.b)).collect();
    let mut have: Vec<_> =
        found.touches.iter().map(ccd::Contact::from).map(|c| (c.kind, c.a, c.b)).collect();
    have.sort_unstable();
    assert_eq!(have, want, "contacts of the GPU and of the CPU");
    Ok(())
}

/// Contacts of the cloth's vertices with faces, as lines along their normals: red early in the step,
/// yellow late. The others, mostly of two edges, would hide these.
fn draw(found: Res<Found>, mut gizmos: Gizmos) {
    for (touch, at) in found.touches.iter().zip(&found.geometry) {
        if touch.kind == 0 && at.vertices[0] < SIDE * SIDE {
            let toi = ccd_core::records::join(touch.toi) as f32;
            let point = Vec3::from(at.point);
            let end = point + 0.05 * Vec3::from(at.normal);
            gizmos.line(point, end, Color::hsl(60.0 * toi, 1.0, 0.5));
        }
    }
}
