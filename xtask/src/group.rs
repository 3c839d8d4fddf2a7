//! The part `group` of `cargo xtask report --gpu`: steps of one mesh on all GPUs of this host,
//! beside the first of them alone, in turn. Contacts must be the same.

use crate::measure::{median, median_of, timed, warm};
use ccd::gpu::{Device, DeviceOptions, Error, Group, Session};
use ccd::{Mesh, Options, Report, scenes};
use ccd_core::model::session::Engine;
use ccd_testkit::data::{SCENES, data_dir};
use std::fmt::Write as _;
use std::sync::Arc;

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

/// cloth-ball, if there are data, and sheets of five and ten million triangles; small ones where
/// the device is emulated.
fn scenes(is_emulated: bool) -> Vec<Scene> {
    let mut all = Vec::new();
    if let (Ok(dir), Some(scene)) = (data_dir(), SCENES.iter().find(|s| s.name == "cloth-ball")) {
        let [t0, t1] = scene.load(&dir);
        if let Ok(mesh) = t0.mesh() {
            let x = [rounded(&t0.positions), rounded(&t1.positions)];
            all.push(Scene::new(scene.name.into(), mesh, x));
        }
    }
    for n in if is_emulated { [40, 80] } else { [1600, 2240] } {
        let step = scenes::crumpled_sheet(n, 1);
        let x = step.rounded();
        all.push(Scene::new(format!("crumpled_sheet({n}, 1)"), step.mesh, x));
    }
    all
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
