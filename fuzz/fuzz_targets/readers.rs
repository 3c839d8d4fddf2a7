//! All readers of files against arbitrary bytes: `CCD_TARGET` says which one, by the end of the
//! name that its files have (`obj`, `npz`, ..), or `csv`, `bodies` or `merge`.
#![no_main]
#![deny(unsafe_code)]
#![allow(dead_code, unused_imports, reason = "of the command's files only the readers are used")]

mod command;
mod library;
mod memory;

#[path = "../../ccd-cli/src/bodies.rs"]
mod bodies;
#[path = "../../ccd-cli/src/files.rs"]
mod files;
#[path = "../../ccd-cli/src/interrupt.rs"]
mod interrupt;
#[path = "../../ccd-cli/src/join.rs"]
mod join;
#[path = "../../ccd-cli/src/lines.rs"]
mod lines;
#[path = "../../ccd-cli/src/merge.rs"]
mod merge;
#[allow(unused_macros, reason = "notices of the command")]
#[path = "../../ccd-cli/src/output.rs"]
mod output;
#[path = "../../ccd-cli/src/part.rs"]
mod part;
#[path = "../../ccd-cli/src/start.rs"]
mod start;
#[path = "../../ccd-cli/src/toi.rs"]
mod toi;

use libfuzzer_sys::fuzz_target;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;

/// What is read, and the folder of this process in which it lies, in memory where there is one.
static TARGET: LazyLock<(String, PathBuf)> = LazyLock::new(|| {
    let name = std::env::var("CCD_TARGET").expect("CCD_TARGET names what is read");
    let memory = Path::new("/dev/shm");
    let parent = if memory.is_dir() { memory.to_owned() } else { std::env::temp_dir() };
    let folder = parent.join(format!("ccd-fuzz-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the input");
    (name, folder)
});

fuzz_target!(|data: &[u8]| {
    let (name, folder) = &*TARGET;
    match name.as_str() {
        "merge" => command::merge(folder, data),
        "bodies" => command::bodies(&write(folder, "a.txt", data), data),
        "csv" => library::queries(&write(folder, "a.csv", data), data.len()),
        "npy" | "npz" | "pc2" | "mdd" => {
            library::cache(&write(folder, &format!("a.{name}"), data), data.len());
        }
        _ => library::mesh(&write(folder, &format!("a.{name}"), data), data.len()),
    }
});

fn write(folder: &Path, name: &str, data: &[u8]) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, data).expect("the input can be written");
    path
}

/// What the command's files have from its `main.rs` and `failure.rs`, which would need all of its
/// files and the GPU backend.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
struct Failure(String);

impl Failure {
    fn print(&self) {
        panic!("{self}");
    }
}

impl From<ccd::Error> for Failure {
    fn from(e: ccd::Error) -> Self {
        Failure(e.to_string())
    }
}

type Outcome = Result<bool, Failure>;

fn in_file(path: &Path, e: impl std::fmt::Display) -> Failure {
    Failure(format!("{}: {e}", path.display()))
}

/// Headings of options in the help.
const INPUT: &str = "";
const QUESTION: &str = "";

/// The coordinates that a step starts from: nothing here takes a step.
#[derive(Clone, Copy)]
enum Precision {}

impl Precision {
    fn name(self) -> &'static str {
        match self {}
    }
}
