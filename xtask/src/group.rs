//! The part `group` of `cargo xtask report --gpu`: steps of one mesh on all GPUs of this host,
//! beside the first of them alone, in turn. Contacts must be the same.

use crate::measure::{median, median_of, timed, warm};
use ccd::gpu::{Device, DeviceOptions, Error, Group, Session};
use ccd::scenes::{self, Random, Step};
use ccd::{Aabb, Mesh, Options, Report};
use ccd_core::model::session::Engine;
use ccd_testkit::data::{SCENES, data_dir};
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A step in the precision that it is given in.
struct Scene {
    name: String,
    mesh: Arc<Mesh>,
    x: [Vec<[f32; 3]>; 2],
}

impl Scene {
    fn new(name: String, mesh: Mesh, x: [Vec<[f32; 3]>; 2]) -> Self {
        Self { name, mesh: Arc::new(mesh), x }
    }
}

fn rounded(x: &[[f64; 3]]) -> Vec<[f32; 3]> {
    x.iter().map(|p| p.map(|c| c as f32)).collect()
}

/// cloth-ball, if there are data, one and many side by side; cloths that fall; sheets of five and
/// ten million triangles. Small ones where the device is emulated.
fn scenes(is_emulated: bool) -> Vec<Scene> {
    let mut all = Vec::new();
    if let (Ok(dir), Some(scene)) = (data_dir(), SCENES.iter().find(|s| s.name == "cloth-ball")) {
        let [t0, t1] = scene.load(&dir);
        if let Ok(mesh) = t0.mesh() {
            let x = [rounded(&t0.positions), rounded(&t1.positions)];
            let many = (!is_emulated).then(|| side_by_side(&mesh, &x, MANY)).flatten();
            all.push(Scene::new(scene.name.into(), mesh, x));
            all.extend(many.map(|(mesh, x)| {
                Scene::new(format!("{MANY} of {}, side by side", scene.name), mesh, x)
            }));
        }
    }
    let (layers, n) = if is_emulated { (4, 20) } else { (12, 500) };
    let step = falling_stack(layers, n);
    let (name, x) = (format!("{layers} falling cloths"), step.rounded());
    all.push(Scene::new(name, step.mesh, x));
    for n in if is_emulated { [40, 80] } else { [1600, 2240] } {
        let step = scenes::crumpled_sheet(n, 1);
        let x = step.rounded();
        all.push(Scene::new(format!("crumpled_sheet({n}, 1)"), step.mesh, x));
    }
    all
}

/// Until all devices are at their clocks.
const WARM_UP: Duration = Duration::from_secs(3);

/// Cloths on each other, six hundredths of an edge apart, as thin as cloths are, that fall by an
/// edge in the step; one vertex in 4,096 gets through the next cloth. Pairs of boxes are many,
/// contacts few.
fn falling_stack(layers: usize, n: usize) -> Step {
    let (edge, mut random) = (1.0 / n as f64, Random::new(1));
    let (mut faces, mut x0, mut x1) = (Vec::new(), Vec::new(), Vec::new());
    for layer in 0..layers {
        scenes::grid(&mut faces, n, (layer * n * n) as u32);
        for v in 0..n * n {
            let [x, z, from, to] = [(); 4].map(|()| random.unit());
            let [x, z] = [(v % n) as f64 + 0.5 * x, (v / n) as f64 + 0.5 * z];
            let height = |within: f64| 0.06 * (layer as f64 + 0.4 * within);
            let through = if random.below(4096) == 0 { 0.1 } else { 0.0 };
            x0.push([x, height(from), z].map(|c| c * edge));
            x1.push([x, height(to) - 1.0 - through, z].map(|c| c * edge));
        }
    }
    Step { mesh: Mesh::new(x0.len(), &faces).expect("a valid stack"), x0, x1 }
}

/// Copies of cloth-ball: five million triangles.
const MANY: usize = 56;

/// So many copies of a step in rows, far enough from each other that none meets another.
fn side_by_side(
    mesh: &Mesh,
    x: &[Vec<[f32; 3]>; 2],
    n: usize,
) -> Option<(Mesh, [Vec<[f32; 3]>; 2])> {
    let points = x.iter().flatten();
    let bounds = points.fold(Aabb::EMPTY, |all, &p| all.union(&Aabb::of_point(p)));
    let size = [0, 2].map(|k| 1.1 * (bounds.max[k] - bounds.min[k]));
    let row = (n as f64).sqrt().ceil() as usize;
    let moved = |x: &Vec<[f32; 3]>| -> Vec<[f32; 3]> {
        let of_copy = |i: usize| {
            let by = [(i % row) as f32 * size[0], (i / row) as f32 * size[1]];
            x.iter().map(move |p| [p[0] + by[0], p[1], p[2] + by[1]])
        };
        (0..n).flat_map(of_copy).collect()
    };
    let n_vertices = mesh.n_vertices() as u32;
    let faces: Vec<[u32; 3]> = (0..n as u32)
        .flat_map(|i| mesh.faces().iter().map(move |face| face.map(|v| v + i * n_vertices)))
        .collect();
    let x = x.each_ref().map(moved);
    Some((Mesh::new(x[0].len(), &faces).ok()?, x))
}

/// Adds its table.
pub fn measure(runs: usize, text: &mut String) -> Result<(), Error> {
    let devices = Device::open_all(&DeviceOptions::default())?;
    if devices.len() == 1 {
        return Ok(());
    }
    let _ = writeln!(text, "\n## One mesh on {} GPUs\n", devices.len());
    text.push_str(
        "Wall, in milliseconds, medians of steps in turn; positions in `f32`. Sent: until \
         positions are on their way. First: with parts being made and buffers.\n\n\
         | scene | triangles | contacts | one GPU: sent | step | all: sent | step | ratio | \
         earliest: one | all | ratio | parts: triangles | first |\n\
         |---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
    );
    let is_emulated = devices[0].info().adapter.name.starts_with("llvmpipe");
    for Scene { name, mesh, x: [x0, x1] } in scenes(is_emulated) {
        let n_faces = mesh.faces().len();
        let mut one = Session::new(&devices[0], mesh.clone(), Options::default())?;
        let mut all = Group::new(&devices, mesh, Options::default())?;
        let contacts = one.step(&x0, &x1)?.contacts.clone();
        let (first, done) = timed(|| all.step(&x0, &x1).map(|_| ()));
        done?;
        assert!(all.report().contacts == contacts, "contacts of {name}");
        // Each in a row, so that all devices that it uses are at their clocks.
        let until = |report: &Report, ms| (report.times.boxes, ms);
        let steps = warm(runs, || {
            let (ms, report) = timed(|| one.step(&x0, &x1));
            report.map(|report| until(report, ms))
        })?;
        // A device that was idle until now takes longest.
        let start = Instant::now();
        while start.elapsed() < WARM_UP {
            all.step(&x0, &x1)?;
        }
        let steps_of_all = warm(runs, || {
            let (ms, report) = timed(|| all.step(&x0, &x1));
            report.map(|report| until(report, ms))
        })?;
        let (toi, earliest) = median_of(runs, || one.earliest_toi(&x0, &x1))?;
        let (toi_all, earliest_of_all) = median_of(runs, || all.earliest_toi(&x0, &x1))?;
        assert_eq!(earliest, earliest_of_all, "earliest of {name}");
        let of = |steps: &[(f64, f64)]| {
            (median(steps.iter().map(|of| of.0)), median(steps.iter().map(|of| of.1)))
        };
        let ((sent, one_ms), (sent_all, all_ms)) = (of(&steps), of(&steps_of_all));
        let members = all.members().take(all.n_used());
        let parts: Vec<String> =
            members.map(|of| Engine::state(of).mesh.faces().len().to_string()).collect();
        let _ = writeln!(
            text,
            "| {name} | {n_faces} | {} | {sent:.2} | {one_ms:.2} | {sent_all:.2} | {all_ms:.2} | \
             {:.2} | {toi:.2} | {toi_all:.2} | {:.2} | {} | {first:.0} |",
            contacts.len(),
            one_ms / all_ms,
            toi / toi_all,
            parts.join(" + ")
        );
    }
    Ok(())
}
