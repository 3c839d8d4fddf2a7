//! What commands print and write: text, JSON, CSV.

use super::{Failure, in_file};
use ccd::{Contact, Kind, Mesh, PerKind, Report, State};
use serde::Serialize;
use std::io::Write;
use std::path::Path;

/// A line of text output: a bold name, and what it says.
pub fn line(name: &str, text: impl std::fmt::Display) {
    let bold = anstyle::Style::new().bold();
    anstream::println!("{bold}{name:<11}{bold:#} {text}");
}

/// Numbers of both kinds of pairs.
#[derive(Serialize)]
pub struct Counts {
    pub vf: u64,
    pub ee: u64,
}

impl From<PerKind> for Counts {
    fn from(n: PerKind) -> Self {
        Self { vf: n.vf, ee: n.ee }
    }
}

/// Size of a mesh.
#[derive(Serialize)]
pub struct MeshSize {
    pub vertices: usize,
    pub edges: usize,
    pub faces: usize,
}

impl From<&Mesh> for MeshSize {
    fn from(mesh: &Mesh) -> Self {
        Self { vertices: mesh.n_vertices(), edges: mesh.edges().len(), faces: mesh.faces().len() }
    }
}

impl std::fmt::Display for MeshSize {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} vertices, {} edges, {} faces", self.vertices, self.edges, self.faces)
    }
}

/// Times of a step in milliseconds; `total` includes loading.
#[derive(Serialize)]
pub struct TimesMs {
    pub load: f64,
    pub boxes: f64,
    pub build: f64,
    pub traverse: f64,
    pub narrow: f64,
    pub total: f64,
}

impl TimesMs {
    pub fn new(load: f64, report: &Report) -> Self {
        let t = report.times;
        Self {
            load,
            boxes: t.boxes,
            build: t.build,
            traverse: t.traverse,
            narrow: t.narrow,
            total: load + t.total,
        }
    }
}

/// A number with the digits that matter: milliseconds, microseconds below one.
pub fn milliseconds(ms: f64) -> String {
    if ms >= 100.0 {
        format!("{ms:.0} ms")
    } else if ms >= 1.0 {
        format!("{ms:.1} ms")
    } else {
        format!("{:.0} us", ms * 1e3)
    }
}

/// A whole number with a comma between thousands.
pub fn thousands(n: usize) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, c) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(c);
    }
    out
}

/// Prints an object as one line of JSON.
pub fn json(value: &impl Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string(value).map_err(|e| Failure(e.to_string()))?;
    println!("{text}");
    Ok(())
}

/// Contacts as CSV, one file for one step or, with frame numbers, for many.
pub struct ContactFile<'a> {
    path: &'a Path,
    writer: csv::Writer<std::fs::File>,
    frames: bool,
}

impl<'a> ContactFile<'a> {
    pub fn create(path: &'a Path, frames: bool) -> Result<Self, Failure> {
        let mut writer = csv::Writer::from_path(path).map_err(|e| in_file(path, e))?;
        let header = ["frame", "kind", "a", "b", "toi", "state"];
        writer.write_record(&header[usize::from(!frames)..]).map_err(|e| in_file(path, e))?;
        Ok(Self { path, writer, frames })
    }

    pub fn write(&mut self, frame: usize, contacts: &[Contact]) -> Result<(), Failure> {
        for c in contacts {
            let kind = match c.kind {
                Kind::VertexFace => "vf",
                Kind::EdgeEdge => "ee",
            };
            let row = [
                frame.to_string(),
                kind.into(),
                c.a.to_string(),
                c.b.to_string(),
                format!("{:?}", c.toi),
                state(c.state).into(),
            ];
            self.writer
                .write_record(&row[usize::from(!self.frames)..])
                .map_err(|e| in_file(self.path, e))?;
        }
        self.writer.flush().map_err(|e| in_file(self.path, e))
    }
}

fn state(state: State) -> &'static str {
    match state {
        State::Hit => "hit",
        State::Undecided => "undecided",
    }
}

/// Where progress is shown: nowhere if standard error is not a terminal.
pub fn progress(n: usize, what: &'static str) -> indicatif::ProgressBar {
    let template = "{msg} {wide_bar} {pos}/{len}, {eta} left";
    let style = indicatif::ProgressStyle::with_template(template)
        .unwrap_or_else(|_| indicatif::ProgressStyle::default_bar());
    indicatif::ProgressBar::new(n as u64).with_style(style).with_message(what)
}

/// Flushes standard output, ignoring a reader that has gone away.
pub fn flush() {
    let _ = std::io::stdout().flush();
}
