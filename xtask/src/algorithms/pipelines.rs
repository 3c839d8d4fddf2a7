//! Features against triangles: how many tests of features each step of either pipeline leaves.

use crate::markdown::Table;
use crate::measure::{Place, median, warm};
use ccd::gpu::{self, Timing};
use ccd::io::Frame;
use ccd::method::{Pipeline, TriangleOptions};
use ccd::{Mesh, Options, Report, Session};
use ccd_testkit::data::{Scene, data_dir};
use std::fmt::Write;

/// One table a scene, by one thread and by the GPU if there is one; every pipeline must find the
/// contacts of the first.
pub fn table(places: &[Place], runs: usize) -> Result<String, String> {
    let device = places.iter().find_map(|place| match place {
        Place::Gpu { device, name } => Some((device, name)),
        Place::Cpu { .. } => None,
    });
    let dir = data_dir()?;
    let triangles = |orphans, free_regions| {
        Pipeline::Triangles(TriangleOptions::default().orphans(orphans).free_regions(free_regions))
    };
    let rows = [
        ("features", Pipeline::Features),
        ("triangles", triangles(false, false)),
        ("+ orphans", triangles(true, false)),
        ("+ regions", triangles(true, true)),
    ];
    let mut text = String::new();
    for name in ["cloth-funnel", "cloth-ball", "rod-twist"] {
        let frames = Scene::named(name).load(&dir);
        let [t0, t1] = &frames;
        let mesh = t0.mesh().map_err(|e| e.to_string())?;
        let mut columns =
            vec!["pipeline", "pairs", "skipped", "tests", "overlap", "filtered", "ms"];
        columns.extend(device.map(|(_, name)| name.as_str()));
        let mut table = Table::new(columns);
        let mut contacts = None;
        for (row_name, pipeline) in rows {
            let options = Options::default().with_threads(1).with_pipeline(pipeline);
            let mut session = Session::new(mesh.clone(), options).map_err(|e| e.to_string())?;
            let mut times = Vec::new();
            for _ in 0..=runs {
                let report = session.step(&t0.positions, &t1.positions);
                times.push(report.map_err(|e| e.to_string())?.times.total);
            }
            times.remove(0);
            let report = session.report();
            let found = report.contacts.len();
            if *contacts.get_or_insert(found) != found {
                return Err(format!("{name}: {found} contacts, features have {contacts:?}"));
            }
            let mut cells = cells(row_name, report, median(times));
            if let Some((device, _)) = device {
                let [total, own] = on_gpu(device, &mesh, &frames, pipeline, report, runs)?;
                cells.push(format!("{total:.2} ({own:.2})"));
            }
            table.row(cells);
        }
        let (n_faces, n_contacts) = (mesh.faces().len(), contacts.unwrap_or(0));
        let _ =
            writeln!(text, "**{name}**: {n_faces} faces, {n_contacts} contacts by each\n\n{table}");
    }
    Ok(text)
}

fn cells(name: &str, report: &Report, ms: f64) -> Vec<String> {
    let before = report.triangles.map(|t| {
        let (skipped, tests) = ((t.adjacent, t.free), (t.represented, t.orphans));
        let two = |(a, b)| format!("{a} + {b}");
        [t.pairs.to_string(), two(skipped), two(tests)]
    });
    let (boxes, filtered) = (report.candidates.total(), report.filtered.total());
    let after = [boxes.to_string(), filtered.to_string(), format!("{ms:.1}")];
    [&[name.to_owned()][..], &before.unwrap_or_default(), &after].concat()
}

/// Milliseconds of a step on a GPU, by the clock on the wall and by timestamps; candidates and what
/// pairs of triangles are expanded to must be those of the CPU.
fn on_gpu(
    device: &gpu::Device,
    mesh: &Mesh,
    [t0, t1]: &[Frame; 2],
    pipeline: Pipeline,
    want: &Report,
    runs: usize,
) -> Result<[f64; 2], String> {
    let options = Options::default().with_pipeline(pipeline);
    let failed = |e: gpu::Error| e.to_string();
    let mut session = gpu::Session::new(device, mesh.clone(), options).map_err(failed)?;
    session.set_timing(Timing::Whole).map_err(failed)?;
    let times = warm(runs, || {
        let report = session.step(&t0.positions, &t1.positions).map_err(failed)?;
        let (total, same) = (report.times.total, report.candidates == want.candidates);
        if !same || report.triangles != want.triangles {
            return Err(format!("{pipeline:?}: {report:?} on the GPU, {want:?} on the CPU"));
        }
        Ok([total, session.stages().iter().map(|stage| stage.1).sum()])
    })?;
    Ok([0, 1].map(|k| median(times.iter().map(|t| t[k]))))
}
