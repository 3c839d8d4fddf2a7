//! Output of commands: text and JSON.

use super::{Failure, Precision};
use ccd::any;
use ccd::{Mesh, PerKind, Report};
use serde::{Deserialize, Serialize};
use std::io::{ErrorKind, Write};
use std::path::{Component, Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// Prints a line as `println!` does, but ends the program as [`ended`] says where that panics;
/// nothing with `--quiet`.
macro_rules! say {
    ($($text:tt)*) => {
        if !$crate::output::is_quiet() {
            $crate::output::print(format_args!($($text)*))
        }
    };
}
pub(crate) use say;

/// Tells of something beside the work, on standard error; nothing with `--quiet`.
macro_rules! notice {
    ($($text:tt)*) => {
        if !$crate::output::is_quiet() {
            $crate::output::tell(format_args!($($text)*))
        }
    };
}
pub(crate) use notice;

static QUIET: AtomicBool = AtomicBool::new(false);

/// From now on nothing is said but what was asked for: JSON, files, and errors.
pub fn be_quiet() {
    QUIET.store(true, Relaxed);
}

/// Whether `--quiet` was given.
pub fn is_quiet() -> bool {
    QUIET.load(Relaxed)
}

/// Whether more is wanted than what is printed, and whether nobody reads that any more.
static GOES_ON: AtomicBool = AtomicBool::new(false);
static UNREAD: AtomicBool = AtomicBool::new(false);
/// Unfinished files, which nobody wants if the program ends where it is.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// From now on a reader of standard output that goes away does not end the program: its exit status
/// is wanted as well, or files are.
pub fn go_on() {
    GOES_ON.store(true, Relaxed);
}

/// The files that are removed if the program ends where it is. None is begun while this is held.
pub fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes unfinished files. Who holds what this returns until the program ends leaves none.
pub fn remove_unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    let files = unfinished();
    for path in files.iter() {
        let _ = std::fs::remove_file(path);
    }
    files
}

/// Prints a notice. Where it cannot be written the work goes on all the same.
pub fn tell(text: std::fmt::Arguments) {
    let _ = writeln!(std::io::stderr(), "ccd: {text}");
}

/// Prints a line to standard output.
pub fn print(text: std::fmt::Arguments) {
    if UNREAD.load(Relaxed) {
        return;
    }
    match writeln!(anstream::stdout(), "{text}") {
        Ok(()) => {}
        Err(e) if is_unread(&e) => {}
        Err(e) => ended(&e),
    }
}

/// Whether nobody reads any more, and the work goes on.
pub fn is_unread(e: &std::io::Error) -> bool {
    let is_unread = e.kind() == ErrorKind::BrokenPipe && GOES_ON.load(Relaxed);
    UNREAD.fetch_or(is_unread, Relaxed);
    is_unread
}

/// Nothing can be printed any more. A reader that has gone away has seen what it wanted; all else
/// is an error.
pub fn ended(e: &std::io::Error) -> ! {
    let _none_begins = remove_unfinished();
    if e.kind() == ErrorKind::BrokenPipe {
        std::process::exit(0);
    }
    Failure(format!("standard output: {e}")).print();
    std::process::exit(2)
}

/// A line of text output: a bold name, and what it says.
pub fn line(name: &str, text: impl std::fmt::Display) {
    let bold = anstyle::Style::new().bold();
    say!("{bold}{name:<11}{bold:#} {text}");
}

/// Numbers of the kinds of pairs; those of particles and rods where there are any.
#[derive(Serialize, Deserialize)]
pub struct Counts {
    pub vf: u64,
    pub ee: u64,
    #[serde(default, skip_serializing_if = "is_zero")]
    pub ve: u64,
    #[serde(default, skip_serializing_if = "is_zero")]
    pub vv: u64,
}

fn is_zero(n: &u64) -> bool {
    *n == 0
}

impl Counts {
    /// All together.
    pub fn total(&self) -> u64 {
        [self.ee, self.ve, self.vv].into_iter().fold(self.vf, u64::saturating_add)
    }
}

/// In words: `3 vertex-face, 4 edge-edge`, and the other kinds where there are any.
impl std::fmt::Display for Counts {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} vertex-face, {} edge-edge", self.vf, self.ee)?;
        for (n, kind) in [(self.ve, "vertex-edge"), (self.vv, "vertex-vertex")] {
            if n > 0 {
                write!(f, ", {n} {kind}")?;
            }
        }
        Ok(())
    }
}

impl From<PerKind> for Counts {
    fn from(n: PerKind) -> Self {
        Self { vf: n.vf, ee: n.ee, ve: n.ve, vv: n.vv }
    }
}

/// Size of a mesh.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct MeshSize {
    pub vertices: usize,
    pub edges: usize,
    pub faces: usize,
}

impl MeshSize {
    pub fn of(mesh: &Mesh) -> Self {
        Self { vertices: mesh.n_vertices(), edges: mesh.edges().len(), faces: mesh.faces().len() }
    }
}

impl std::fmt::Display for MeshSize {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} vertices, {} edges, {} faces", self.vertices, self.edges, self.faces)
    }
}

/// Where work ran, and the precision of its coordinates where there is a choice.
#[derive(Serialize)]
pub struct Place<'a> {
    backend: &'static str,
    adapter: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    precision: Option<&'static str>,
    threads: Option<usize>,
}

impl<'a> Place<'a> {
    pub fn new(place: &'a any::Place, precision: Option<Precision>) -> Self {
        Self {
            backend: place.backend(),
            adapter: place.adapter(),
            precision: precision.map(Precision::name),
            threads: place.threads(),
        }
    }
}

/// Times of a step in milliseconds; `total` includes loading. On a GPU `boxes` is the upload, and
/// what the clock does not see is none.
#[derive(Serialize, Deserialize)]
pub struct TimesMs {
    pub load: f64,
    pub boxes: f64,
    pub build: Option<f64>,
    pub traverse: Option<f64>,
    pub narrow: Option<f64>,
    pub total: f64,
}

impl TimesMs {
    pub fn new(load: f64, report: &Report, place: &any::Place) -> Self {
        let t = report.times;
        let seen = |ms| matches!(place, any::Place::Cpu { .. }).then_some(ms);
        Self {
            load,
            boxes: t.boxes,
            build: seen(t.build),
            traverse: seen(t.traverse),
            narrow: seen(t.narrow),
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

/// The median of sorted times, which is the mean of the middle two of an even number of them.
pub fn median(sorted: &[f64]) -> Option<f64> {
    let upper = *sorted.get(sorted.len() / 2)?;
    Some(sorted[(sorted.len() - 1) / 2].midpoint(upper))
}

/// Number of contacts at t = 0.
pub fn at_start(report: &Report) -> u64 {
    report.contacts.iter().filter(|c| c.toi == 0.0).count() as u64
}

/// Prints what undecided contacts mean and why there are contacts at t = 0, if there are any.
/// `first`: the frame that the step starts from.
pub fn explain(undecided: u64, at_start: u64, min_distance: f64, first: &str) {
    if undecided > 0 {
        line("", "undecided: too close to tell in rounded numbers; treat as contacts");
    }
    if at_start > 0 {
        // Some are undecided, and a time of 0 may be that much early.
        let why = match min_distance > 0.0 {
            true => "is or may be within the minimum distance",
            false => "may touch or pass through itself",
        };
        line("", format_args!("{at_start} at t = 0: {first} {why}"));
    }
}

/// So many things: `1 step`, `2 steps`.
pub fn counted(n: u64, thing: &str) -> String {
    format!("{n} {thing}{}", plural(n))
}

/// What a noun ends with, of so many things.
pub fn plural(n: u64) -> &'static str {
    if n == 1 { "" } else { "s" }
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

/// Title of a picture: the end of the first path with the folders that name its scene, the names of
/// the other files, the minimum distance, and the place of the computation.
pub fn title(files: &[&Path], min_distance: f64, place: &any::Place) -> String {
    let mut names = Vec::new();
    for (i, path) in files.iter().enumerate() {
        // Without `..` and the like, which name no scene.
        let parts = path.components().filter_map(|part| match part {
            Component::Normal(part) => Some(part.to_string_lossy()),
            _ => None,
        });
        let parts: Vec<_> = parts.collect();
        let kept = if i == 0 { 3 } else { 1 };
        names.push(parts[parts.len().saturating_sub(kept)..].join("/"));
    }
    let (names, backend) = (names.join(" to "), place.backend().to_uppercase());
    format!("{names}; minimum distance {min_distance}; {backend}: {place}")
}

/// Prints an object as one line of JSON.
pub fn json(value: &impl Serialize) -> Result<(), Failure> {
    let text = serde_json::to_string(value).map_err(|e| Failure(e.to_string()))?;
    print(format_args!("{text}"));
    Ok(())
}

/// The processor, as Linux names it; elsewhere its architecture.
pub fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text
        .lines()
        .find(|l| l.starts_with("model name"))
        .and_then(|l| l.split_once(':'))
        .map(|(_, name)| name.trim().to_string());
    name.unwrap_or_else(|| format!("{}, {}", std::env::consts::ARCH, std::env::consts::OS))
}

/// Flushes standard output.
pub fn flush() {
    match std::io::stdout().flush() {
        Ok(()) => {}
        Err(e) if is_unread(&e) => {}
        Err(e) => ended(&e),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_are_in_the_middle() {
        for (sorted, want) in [
            (&[0.0; 0][..], None),
            (&[3.0], Some(3.0)),
            (&[1.0, 3.0], Some(2.0)),
            (&[1.0, 3.0, 9.0], Some(3.0)),
            (&[1.0, 3.0, 5.0, 90.0], Some(4.0)),
            (&[f64::MAX, f64::MAX], Some(f64::MAX)),
        ] {
            assert_eq!(median(sorted), want, "{sorted:?}");
        }
    }
}
