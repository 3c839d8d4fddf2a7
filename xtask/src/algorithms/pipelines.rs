//! Features against triangles: how many tests of features each step of either pipeline leaves.

use ccd::{Options, Pipeline, Report, Session, TriangleOptions};
use ccd_testkit::data::{Scene, data_dir};
use std::fmt::Write;

/// One table a scene, by one thread; every pipeline must find the contacts of the first.
pub fn table(runs: usize) -> Result<String, String> {
    let dir = data_dir()?;
    let triangles = |orphans, cones| {
        Pipeline::Triangles(TriangleOptions::default().orphans(orphans).cones(cones))
    };
    let rows = [
        ("features", Pipeline::Features),
        ("triangles", triangles(false, false)),
        ("+ orphans", triangles(true, false)),
        ("+ orphans, cones", triangles(true, true)),
    ];
    let mut text = String::new();
    for name in ["cloth-funnel", "cloth-ball", "rod-twist"] {
        let [t0, t1] = Scene::named(name).load(&dir);
        let mesh = t0.mesh().map_err(|e| e.to_string())?;
        let mut lines = String::new();
        let mut contacts = None;
        for (row_name, pipeline) in rows {
            let options = Options { threads: 1, pipeline, ..Options::default() };
            let mut session = Session::new(mesh.clone(), options).map_err(|e| e.to_string())?;
            let mut times = Vec::new();
            for _ in 0..=runs {
                let report = session.step(&t0.positions, &t1.positions);
                times.push(report.map_err(|e| e.to_string())?.times.total);
            }
            times.remove(0);
            times.sort_unstable_by(f64::total_cmp);
            let report = session.report();
            let found = report.contacts.len();
            if *contacts.get_or_insert(found) != found {
                return Err(format!("{name}: {found} contacts, features have {contacts:?}"));
            }
            row(&mut lines, row_name, report, times[times.len() / 2]);
        }
        let (n_faces, n_contacts) = (mesh.faces().len(), contacts.unwrap_or(0));
        let _ = writeln!(
            text,
            "**{name}**: {n_faces} faces, {n_contacts} contacts by each\n\n\
             | pipeline | pairs of triangles | skipped | tests | own boxes overlap | filtered | \
             ms |\n|---|---|---|---|---|---|---|\n{lines}"
        );
    }
    Ok(text)
}

fn row(text: &mut String, name: &str, report: &Report, ms: f64) {
    let before = report.triangles.map_or("| | ".to_owned(), |t| {
        let (skipped, tests) = ((t.adjacent, t.free), (t.represented, t.orphans));
        format!("{} | {} + {} | {} + {}", t.pairs, skipped.0, skipped.1, tests.0, tests.1)
    });
    let (boxes, filtered) = (report.candidates.total(), report.filtered.total());
    let _ = writeln!(text, "| {name} | {before} | {boxes} | {filtered} | {ms:.1} |");
}
