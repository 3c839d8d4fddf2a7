//! What commands print and write: text, JSON, CSV.

use super::{Failure, in_file};
use ccd::any::Place;
use ccd::{Contact, Kind, Mesh, PerKind, Report, State};
use serde::Serialize;
use std::io::{ErrorKind, Write};
use std::path::Path;

/// Prints a line as `println!` does, but ends the program as [`ended`] says where that panics.
macro_rules! say {
    ($($text:tt)*) => {
        $crate::output::print(format_args!($($text)*))
    };
}
pub(crate) use say;

/// Prints a line to standard output.
pub fn print(text: std::fmt::Arguments) {
    if let Err(e) = writeln!(anstream::stdout(), "{text}") {
        ended(&e);
    }
}

/// Nothing can be printed any more. A reader that has gone away has seen what it wanted; all else
/// is an error.
fn ended(e: &std::io::Error) -> ! {
    if e.kind() == ErrorKind::BrokenPipe {
        std::process::exit(0);
    }
    super::complain(&Failure(format!("standard output: {e}")));
    std::process::exit(2)
}

/// A line of text output: a bold name, and what it says.
pub fn line(name: &str, text: impl std::fmt::Display) {
    let bold = anstyle::Style::new().bold();
    say!("{bold}{name:<11}{bold:#} {text}");
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

/// What a picture is of and where it was computed: the end of the first path, with the folders that
/// say which scene it is, and the names of the others.
pub fn title(files: &[&Path], place: &Place) -> String {
    let mut names = Vec::new();
    for (i, path) in files.iter().enumerate() {
        let parts: Vec<_> = path.iter().map(|part| part.to_string_lossy()).collect();
        let kept = if i == 0 { 3 } else { 1 };
        names.push(parts[parts.len().saturating_sub(kept)..].join("/"));
    }
    format!("{}; {}: {place}", names.join(" to "), place.backend().to_uppercase())
}

/// Prints an object as one line of JSON.
pub fn json(value: &impl Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string(value).map_err(|e| Failure(e.to_string()))?;
    say!("{text}");
    Ok(())
}

/// Refuses a path that ends otherwise than in what is written to it.
pub fn check_extension(path: &Path, extension: &str) -> Result<(), Failure> {
    if path.extension().is_some_and(|e| e.eq_ignore_ascii_case(extension)) {
        return Ok(());
    }
    Err(in_file(path, format_args!("is written as .{extension}; a name that ends so is expected")))
}

/// Whether a path means standard output.
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// Creates a file, so that one that cannot be written is known before any work.
pub fn create(path: &Path, extension: &str) -> Result<std::fs::File, Failure> {
    check_extension(path, extension)?;
    std::fs::File::create(path).map_err(|e| in_file(path, e))
}

/// Contacts as CSV, one file for one step or, with frame numbers, for many.
pub struct ContactFile<'a> {
    path: &'a Path,
    writer: csv::Writer<Box<dyn Write>>,
    frames: bool,
}

impl<'a> ContactFile<'a> {
    /// Opens the file, or standard output for `-`, and writes the names of columns.
    pub fn create(path: &'a Path, frames: bool) -> Result<Self, Failure> {
        let to: Box<dyn Write> = if is_stdout(path) {
            Box::new(std::io::stdout())
        } else {
            Box::new(create(path, "csv")?)
        };
        let mut file = Self { path, writer: csv::Writer::from_writer(to), frames };
        let header = ["frame", "kind", "a", "b", "toi", "state"];
        let written = file.writer.write_record(&header[usize::from(!frames)..]);
        written.map_err(|e| file.failure(e))?;
        Ok(file)
    }

    /// Why a row could not be written.
    fn failure(&self, e: csv::Error) -> Failure {
        match e.kind() {
            csv::ErrorKind::Io(e) if is_stdout(self.path) => ended(e),
            _ => in_file(self.path, e),
        }
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
            let written = self.writer.write_record(&row[usize::from(!self.frames)..]);
            written.map_err(|e| self.failure(e))?;
        }
        self.writer.flush().map_err(|e| self.failure(e.into()))
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

/// Flushes standard output.
pub fn flush() {
    if let Err(e) = std::io::stdout().flush() {
        ended(&e);
    }
}
