//! `cargo xtask compile-times`: how long it takes to compile a program that uses the library, the
//! command, and the tests; beside bars, and a failure above twice a bar.
//!
//! Everything is built in folders of its own below `target/compile-times`, so nothing that was
//! built before counts. Not part of CI: it takes as long as it says, and means something only on
//! a machine that does nothing else.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// What is measured, and what it should take at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Part {
    /// A program of six lines, all it depends on being built: 5 CPU seconds
    Dependent,
    /// `cargo build --release` of the command from nothing: 4 minutes on two idle cores
    Command,
    /// `cargo test --release --workspace --no-run` after that: 12 minutes on two idle cores
    Tests,
}

/// The program: what an application has to compile is the calls, not the library behind them.
const PROGRAM: &str = "
fn main() {
    let mesh = ccd::Mesh::new(3, &[[0, 1, 2]]).unwrap();
    let mut session = ccd::Session::new(mesh, ccd::Options::default()).unwrap();
    let (x0, x1) = ([[0.0f32; 3]; 3], [[1.0f32; 3]; 3]);
    println!(\"{:?}\", session.earliest_toi(&x0, &x1));
}
";

/// Measures one part, or all in turn; the tests come after the command, whose parts they share.
pub fn run(root: &Path, only: Option<Part>) -> Result<(), String> {
    let folder = root.join("target/compile-times");
    let mut failures = Vec::new();
    println!("{:<12} {:>10} {:>10}   bar", "", "CPU", "wall");
    for part in [Part::Dependent, Part::Command, Part::Tests] {
        if only.is_some_and(|only| only != part && !(only == Part::Tests && part == Part::Command))
        {
            continue;
        }
        let (name, spent, bar, found) = match part {
            Part::Dependent => {
                let spent = dependent(root, &folder)?;
                ("dependent", spent, "5 s of CPU", spent.cpu.map(|cpu| cpu / 5.0))
            }
            Part::Command => {
                remove(&folder.join("command"))?;
                let spent = cargo(
                    root,
                    &folder.join("command"),
                    &["build", "--release", "-p", "meshccd-cli"],
                )?;
                ("command", spent, "240 s", Some(spent.wall / 240.0))
            }
            Part::Tests => {
                let words = ["test", "--release", "--workspace", "--no-run"];
                let spent = cargo(root, &folder.join("command"), &words)?;
                ("tests", spent, "720 s", Some(spent.wall / 720.0))
            }
        };
        let cpu = spent.cpu.map_or("unknown".into(), |cpu| format!("{cpu:.1} s"));
        println!("{name:<12} {cpu:>10} {:>8.1} s   {bar}", spent.wall);
        match found {
            Some(ratio) if ratio <= 2.0 => {}
            Some(ratio) => failures.push(format!("{name}: {ratio:.1} times its bar")),
            None => failures.push(format!("{name}: this system does not tell CPU times")),
        }
    }
    if failures.is_empty() { Ok(()) } else { Err(failures.join("\n")) }
}

/// Seconds that a build took.
#[derive(Clone, Copy)]
struct Spent {
    /// Of all processes; `None` where there is no `/proc`.
    cpu: Option<f64>,
    wall: f64,
}

/// Builds a crate of its own that depends on the library, changes it, and times the second build.
fn dependent(root: &Path, folder: &Path) -> Result<Spent, String> {
    let (program, built) = (folder.join("dependent"), folder.join("dependent-target"));
    let root_text = root.display().to_string();
    let manifest = format!(
        "[package]\nname = \"dependent\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n\
         [dependencies]\nmeshccd = {{ path = {root_text:?} }}\n\n\
         [workspace]\n"
    );
    write(&program.join("Cargo.toml"), &manifest)?;
    // The same versions as ours; what is not used is dropped from it.
    let lock = std::fs::read_to_string(root.join("Cargo.lock"));
    write(&program.join("Cargo.lock"), &lock.map_err(|e| format!("Cargo.lock: {e}"))?)?;
    write(&program.join("src/main.rs"), &format!("//! Before.{PROGRAM}"))?;
    cargo(&program, &built, &["build", "--release"])?;
    write(&program.join("src/main.rs"), &format!("//! After.{PROGRAM}"))?;
    cargo(&program, &built, &["build", "--release"])
}

/// Runs cargo in a folder with a target folder of its own.
fn cargo(folder: &Path, target: &Path, words: &[&str]) -> Result<Spent, String> {
    let before = cpu_of_children();
    let start = Instant::now();
    let mut command = Command::new("cargo");
    command.args(words).arg("--quiet").current_dir(folder).env("CARGO_TARGET_DIR", target);
    let status = command.status().map_err(|e| format!("cargo: {e}"))?;
    if !status.success() {
        return Err(format!(
            "`cargo {}` in {} failed: {status}",
            words.join(" "),
            folder.display()
        ));
    }
    let wall = start.elapsed().as_secs_f64();
    let cpu = cpu_of_children().zip(before).map(|(after, before)| after - before);
    Ok(Spent { cpu, wall })
}

/// CPU seconds of all processes that this one waited for, and of those that they waited for.
fn cpu_of_children() -> Option<f64> {
    let text = std::fs::read_to_string("/proc/self/stat").ok()?;
    let ticks = Command::new("getconf").arg("CLK_TCK").output().ok()?.stdout;
    let ticks: f64 = String::from_utf8(ticks).ok()?.trim().parse().ok()?;
    children_ticks(&text).map(|n| n as f64 / ticks)
}

/// Fields 16 and 17 of `/proc/self/stat`: user and system time of children. The second field may
/// hold spaces and ends with the last parenthesis.
fn children_ticks(stat: &str) -> Option<u64> {
    let rest = stat.rsplit_once(')')?.1;
    let mut fields = rest.split_whitespace().skip(13).map(|field| field.parse::<u64>().ok());
    Some(fields.next()?? + fields.next()??)
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    let folder = path.parent().unwrap_or(Path::new("."));
    let done = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(path, text));
    done.map_err(|e| format!("{}: {e}", path.display()))
}

fn remove(folder: &Path) -> Result<(), String> {
    match std::fs::remove_dir_all(folder) {
        Err(e) if e.kind() != std::io::ErrorKind::NotFound => {
            Err(format!("{}: {e}", folder.display()))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_of_children_are_read() {
        let stat = "7 (a) b) S 1 2 3 4 5 6 7 8 9 10 11 12 130 140 15";
        assert_eq!(children_ticks(stat), Some(270));
        assert_eq!(children_ticks("7 (a) S 1 2"), None);
        let before = cpu_of_children();
        let text = "i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done";
        assert!(Command::new("sh").args(["-c", text]).status().is_ok_and(|s| s.success()));
        assert!(before.is_none() || cpu_of_children() > before);
    }
}
