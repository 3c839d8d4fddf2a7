//! `cargo xtask soak`: one session and one device for an hour, through changing meshes, bodies and
//! methods. What is found must never change, and memory must not grow.

use ccd::any::{Backend, Session};
use ccd::{Bodies, Mesh, Options, Report, scenes};
use ccd_testkit::methods::is_near_default;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// MiB by which memory may grow after the warm-up: what the allocator keeps varies by some.
const SLACK: f64 = 16.0;
/// Cycles before memory is looked at: the first one compiles kernels and grows every buffer.
const WARM_UP: u64 = 2;

struct Scene {
    name: &'static str,
    mesh: Arc<Mesh>,
    bodies: Option<Bodies>,
    min_distance: f64,
    frames: Vec<Vec<[f64; 3]>>,
}

impl Scene {
    /// Three steps from a frame on.
    fn new(
        name: &'static str,
        sequence: scenes::Sequence,
        first: usize,
        with_bodies: bool,
    ) -> Self {
        let bodies = with_bodies.then(|| Bodies::new(&sequence.body).with_self_contacts(false));
        let frames = (first..first + 4).map(|i| sequence.frame(i)).collect();
        Self { name, mesh: sequence.mesh.into(), bodies, min_distance: 0.0, frames }
    }

    fn of_step(name: &'static str, step: scenes::Step, min_distance: f64) -> Self {
        let frames = vec![step.x0.clone(), step.x1, step.x0];
        Self { name, mesh: step.mesh.into(), bodies: None, min_distance, frames }
    }

    fn all() -> Vec<Self> {
        let (copies, bodies) = scenes::copies(&scenes::crumpled_sheet(12, 3), 4);
        vec![
            Self::new("two meshes", scenes::interpenetrating(1024), 0, false),
            Self::of_step("particles and rods", scenes::particles_and_rods(50, 1), 0.0),
            // The cloth comes near the wall of the funnel, but does not touch it.
            Self { min_distance: 0.05, ..Self::new("funnel", scenes::funnel(24), 200, true) },
            Self { bodies: Some(bodies), ..Self::of_step("copies", copies, 0.0) },
            Self::new("cloth on a ball", scenes::cloth_on_ball(40), 0, false),
            Self::of_step("soup", scenes::triangle_soup(400, 0.1, 5), 0.01),
            Self::new("spheres in a box", scenes::n_body(16, 10), 0, true),
        ]
    }
}

/// Runs for so many minutes, and one cycle after the warm-up at least.
pub fn run(minutes: f64, backend: &str) -> Result<(), String> {
    let kind = if backend == "gpu" { Backend::Gpu } else { Backend::Cpu };
    let choice = kind.choose(usize::MAX).map_err(|e| e.to_string())?;
    let scenes = Scene::all();
    let options = Options::default().with_bodies(scenes[0].bodies.clone());
    let session = Session::new(&choice, scenes[0].mesh.clone(), options);
    let mut session = session.map_err(|e| e.to_string())?;
    println!("soak: {minutes} minutes on {}", session.place());
    let (start, length) = (Instant::now(), Duration::from_secs_f64(60.0 * minutes));
    let (mut cycles, mut steps, mut said) = (0, 0, 0);
    let mut first: Option<Vec<u64>> = None;
    let mut warm = None;
    while start.elapsed() < length || cycles <= WARM_UP {
        for method in ccd::method::every(backend).filter(|&method| is_near_default(method)) {
            let mut found = Vec::new();
            for scene in &scenes {
                let what = |e: ccd::any::Error| format!("{}, {method}: {e}", scene.name);
                let changed = session.set_mesh_and_bodies(scene.mesh.clone(), scene.bodies.clone());
                changed.map_err(what)?;
                let options = Options::default()
                    .with_bodies(scene.bodies.clone())
                    .with_min_distance(scene.min_distance)
                    .with_broad_phase(method);
                session.set_options(options).map_err(what)?;
                let mut n_contacts = 0;
                for frames in scene.frames.windows(2) {
                    let report = session.step(&frames[0], &frames[1]).map_err(what)?;
                    found.push(digest(report));
                    n_contacts += report.contacts.len();
                    steps += 1;
                }
                if n_contacts == 0 {
                    return Err(format!("soak: {}, {method}: no contacts", scene.name));
                }
            }
            // By no other method is anything else found.
            let want = first.get_or_insert_with(|| found.clone());
            if *want != found {
                return Err(format!("soak: cycle {cycles}, {method}: other contacts"));
            }
        }
        cycles += 1;
        let (memory, minute) = (memory()?, start.elapsed().as_secs() / 60);
        if minute > said || cycles <= WARM_UP + 1 {
            said = minute;
            let mut all = DefaultHasher::new();
            first.hash(&mut all);
            let (seconds, digest) = (start.elapsed().as_secs(), all.finish());
            println!(
                "{seconds:>5} s, {cycles:>6} cycles, {steps:>8} steps, {memory:>7.1} MiB, \
                 contacts {digest:016x}"
            );
        }
        if cycles == WARM_UP {
            warm = Some(memory);
        }
        if let Some(warm) = warm.filter(|warm| memory > warm + SLACK) {
            return Err(format!(
                "soak: cycle {cycles}: {memory:.1} MiB of memory; after the warm-up {warm:.1}"
            ));
        }
    }
    println!("soak: the same contacts in {cycles} cycles; memory grew by less than {SLACK} MiB");
    Ok(())
}

/// All contacts of a step as one number.
fn digest(report: &Report) -> u64 {
    let mut all = DefaultHasher::new();
    for c in &report.contacts {
        (c.kind, c.state, c.a, c.b, c.toi.to_bits()).hash(&mut all);
    }
    (report.contacts.len(), report.toi.map(f64::to_bits)).hash(&mut all);
    all.finish()
}

/// MiB of memory that this process has in use, as Linux says.
fn memory() -> Result<f64, String> {
    let file = "/proc/self/status";
    let text = std::fs::read_to_string(file).map_err(|e| format!("{file}: {e}"))?;
    let line = text.lines().find_map(|line| line.strip_prefix("VmRSS:"));
    let kib = line.and_then(|line| line.split_whitespace().next()?.parse::<f64>().ok());
    kib.map(|kib| kib / 1024.0).ok_or_else(|| format!("{file} has no VmRSS"))
}
