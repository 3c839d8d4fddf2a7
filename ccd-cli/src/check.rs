//! `ccd check`: contacts between two frames.

use super::output::{self, Counts, MeshSize, TimesMs};
use super::{Failure, Outcome, Precision, StepOptions, in_file, picture};
use ccd::Mesh;
use ccd::any::{Error, Place, Session};
use ccd::io::{Frame, read_frame};
use clap::Args;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::time::Instant;

#[derive(Args)]
pub struct Check {
    /// The mesh at the start of the step (.ply or .obj)
    #[arg(value_name = "T0")]
    t0: PathBuf,
    /// The same mesh at the end of the step
    #[arg(value_name = "T1")]
    t1: PathBuf,
    #[command(flatten)]
    pub options: StepOptions,
}

#[derive(Serialize)]
struct Json<'a> {
    mesh: MeshSize,
    candidates: Counts,
    contacts: Counts,
    undecided: u64,
    toi: Option<f64>,
    backend: &'static str,
    adapter: Option<&'a str>,
    precision: &'static str,
    threads: Option<usize>,
    times_ms: TimesMs,
}

impl Check {
    pub fn run(&self) -> Outcome {
        let file = self.options.contact_file(false)?;
        let start = Instant::now();
        let (t0, t1) = (read_frame(&self.t0)?, read_frame(&self.t1)?);
        let mesh = mesh_of(&self.t0, &t0)?;
        same_topology((&self.t0, &t0), (&self.t1, &t1))?;
        let load = start.elapsed().as_secs_f64() * 1e3;

        let mut session = self.options.session(mesh)?;
        step(&mut session, self.options.precision, (&self.t0, &t0), (&self.t1, &t1))?;
        let (mesh, report) = (session.mesh(), session.report());
        if let Some(mut file) = file {
            file.write(0, &report.contacts)?;
        }
        if let Some(path) = &self.options.picture {
            let title = output::title(&[&self.t0, &self.t1], &session.place());
            let x = [&t0.positions[..], &t1.positions];
            let (contacts, zoom) = (&report.contacts, self.options.zoom);
            picture::write(path, &picture::Scene { title: &title, mesh, x, contacts, zoom })?;
        }
        let contacts = report.n_contacts();
        if self.options.json {
            let place = session.place();
            output::json(&Json {
                mesh: mesh.into(),
                candidates: report.candidates.into(),
                contacts: contacts.into(),
                undecided: report.undecided,
                toi: report.toi,
                backend: place.backend(),
                adapter: place.adapter(),
                precision: self.options.precision.name(),
                threads: place.threads(),
                times_ms: TimesMs::new(load, report),
            })?;
        } else if self.options.prints_text() {
            print(&session, load);
        }
        output::flush();
        Ok(contacts.total() > 0)
    }
}

fn print(session: &Session, load: f64) {
    let (mesh, report) = (session.mesh(), session.report());
    let contacts = report.n_contacts();
    output::line("mesh", MeshSize::from(mesh));
    if mesh.n_degenerate() > 0 {
        output::line(
            "",
            format_args!("{} faces or edges name a vertex twice", mesh.n_degenerate()),
        );
    }
    output::line(
        "candidates",
        format_args!("{} vertex-face, {} edge-edge", report.candidates.vf, report.candidates.ee),
    );
    output::line(
        "contacts",
        format_args!(
            "{} vertex-face, {} edge-edge ({} undecided)",
            contacts.vf, contacts.ee, report.undecided
        ),
    );
    match report.toi {
        Some(toi) => output::line("earliest", format_args!("t = {toi:?}")),
        None => output::line("earliest", "none: the whole step is free"),
    }
    let (t, ms, place) = (report.times, output::milliseconds, session.place());
    let parts = match place {
        Place::Gpu { .. } => format!("upload {}", ms(t.boxes)),
        Place::Cpu { .. } => format!(
            "boxes {}, build {}, traverse {}, narrow {}",
            ms(t.boxes),
            ms(t.build),
            ms(t.traverse),
            ms(t.narrow)
        ),
    };
    output::line(
        "time",
        format_args!("{} on {place} ({parts}); loading {}", ms(t.total), ms(load)),
    );
}

/// One step between two frames; an error in coordinates names the file.
pub fn step(
    session: &mut Session,
    precision: Precision,
    t0: (&Path, &Frame),
    t1: (&Path, &Frame),
) -> Result<(), Failure> {
    let result = match precision {
        Precision::F64 => session.step(&t0.1.positions, &t1.1.positions).map(|_| ()),
        Precision::F32 => session.step(&t0.1.positions_f32(), &t1.1.positions_f32()).map(|_| ()),
    };
    result.map_err(|e| match e {
        Error::Input(ccd::Error::Coordinate { time: 0, .. }) => in_file(t0.0, e),
        Error::Input(ccd::Error::Coordinate { .. }) => in_file(t1.0, e),
        _ => e.into(),
    })
}

/// An error that names the first difference in topology.
pub fn same_topology(a: (&Path, &Frame), b: (&Path, &Frame)) -> Result<(), Failure> {
    let ((path_a, a), (path_b, b)) = (a, b);
    let counts = [
        ("vertices", a.positions.len(), b.positions.len()),
        ("faces", a.faces.len(), b.faces.len()),
        ("edges", a.edges.len(), b.edges.len()),
    ];
    for (what, n_a, n_b) in counts {
        if n_a != n_b {
            return Err(in_file(
                path_b,
                format_args!("has {n_b} {what}, {} has {n_a}", path_a.display()),
            ));
        }
    }
    if let Some(i) = (0..a.faces.len()).find(|&i| a.faces[i] != b.faces[i]) {
        return Err(in_file(
            path_b,
            format_args!(
                "face {i} is {:?}, in {} it is {:?}",
                b.faces[i],
                path_a.display(),
                a.faces[i]
            ),
        ));
    }
    if let Some(i) = (0..a.edges.len()).find(|&i| a.edges[i] != b.edges[i]) {
        return Err(in_file(
            path_b,
            format_args!(
                "edge {i} is {:?}, in {} it is {:?}",
                b.edges[i],
                path_a.display(),
                a.edges[i]
            ),
        ));
    }
    Ok(())
}

/// The mesh of a frame with the path in its errors.
pub fn mesh_of(path: &Path, frame: &Frame) -> Result<Mesh, Failure> {
    frame.mesh().map_err(|e| in_file(path, e))
}
