//! A cloth falls onto a sphere in a Bevy app: its positions stay on the GPU, where `ccd` finds
//! contacts on Bevy's own render device. Contacts alone are read back, and drawn as gizmos.
//!
//! In this folder, `cargo run` opens a window. `--frames N` ends after N frames, `--screenshot
//! FILE.png` saves the last one, and `--check` compares every frame's contacts with the CPU's.

mod contacts;
mod scene;

use bevy::prelude::*;
use bevy::render::RenderPlugin;
use bevy::render::gpu_readback::{Readback, ReadbackComplete};
use bevy::render::settings::{Backends, WgpuSettings};
use bevy::render::view::screenshot::{Screenshot, ScreenshotCaptured, save_to_disk};
use contacts::{ContactsPlugin, Found, Scene};

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
    let scene = scene::spawn(app.world_mut(), args.check)?;
    app.world_mut().spawn(Readback::buffer(scene.results.clone())).observe(receive);
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
    let differ = have.iter().filter(|c| want.binary_search(c).is_err()).count();
    if differ > 0 || have.len() != want.len() {
        let (have, want) = (have.len(), want.len());
        return Err(format!("{have} contacts, {differ} of them not among the CPU's {want}").into());
    }
    Ok(())
}

/// Contacts of the cloth's vertices with faces, as lines along their normals: red early in the
/// step, yellow late. The others, most of two edges, would hide these.
fn draw(found: Res<Found>, scene: Res<Scene>, mut gizmos: Gizmos) {
    for (touch, at) in found.touches.iter().zip(&found.geometry) {
        if touch.kind == 0 && at.vertices[0] < scene.side * scene.side {
            let toi = ccd_core::records::join(touch.toi) as f32;
            let point = Vec3::from(at.point);
            let end = point + 0.05 * Vec3::from(at.normal);
            gizmos.line(point, end, Color::hsl(60.0 * toi, 1.0, 0.5));
        }
    }
}
