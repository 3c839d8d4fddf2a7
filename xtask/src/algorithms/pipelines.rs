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
        ("triangles, orphan sets", triangles(true, false)),
        ("triangles, orphan sets, cones", triangles(true, true)),
    ];
    let mut text = String::new();
    for name in ["cloth-funnel", "cloth-ball", "rod-twist"] {
        let [t0, t1] = Scene::named(name).load(&dir);
        let mesh = t0.mesh().map_err(|e| e.to_string())?;
        let _ = writeln!(
            text,
            "**{name}**: {} faces\n\n| pipeline | pairs of triangles | 15 tests a pair | \
             skipped: neighbours, free regions | represented, orphans | own boxes overlap | \
             left by filters | contacts | ms |\n|---|---|---|---|---|---|---|---|---|",
            mesh.faces().len()
        );
        let mut contacts = None;
        for (name, pipeline) in rows {
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
            row(&mut text, name, report, times[times.len() / 2]);
        }
        text.push('\n');
    }
    Ok(text)
}

fn row(text: &mut String, name: &str, report: &Report, ms: f64) {
    let before = report.triangles.map_or("| | | ".to_owned(), |t| {
        format!(
            "{} | {} | {}, {} | {}, {}",
            t.pairs,
            t.all_tests(),
            t.adjacent,
            t.free,
            t.represented,
            t.orphans
        )
    });
    let _ = writeln!(
        text,
        "| {name} | {before} | {} | {} | {} | {ms:.1} |",
        report.candidates.total(),
        report.filtered.total(),
        report.contacts.len()
    );
}
