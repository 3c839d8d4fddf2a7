//! Mutations of `ccd-core` that make it unsound, one at a time: its tests must notice each of them.
//!
//! The list is `mutants.txt`: of each its name and file, what stands there (`-`), what is put there
//! (`+`), why that is unsound, and, where no test can see it, why it is not (`=`).
//!
//! Works in `target/mutants` on a copy of the crate, so that the sources are never touched and one
//! build serves the next.

use crate::programs::files_below;
use std::path::Path;
use std::process::Command;

/// Dependency of `ccd-core` that the copy leaves out: documentation tests alone need it.
const FACADE: &str = "ccd = { package = \"meshccd\", path = \"..\" }\n";

/// One change of one place.
#[derive(Debug)]
struct Mutant {
    name: &'static str,
    /// From the root of the repository.
    file: &'static str,
    /// Exactly what stands there, once.
    text: &'static str,
    with: &'static str,
    /// Why it is unsound.
    why: &'static str,
    /// Why no test can see it, if none can.
    survives: Option<&'static str>,
}

/// The list.
fn mutants() -> Result<Vec<Mutant>, String> {
    include_str!("mutants.txt").split("\n\n").map(parse).collect()
}

fn parse(block: &'static str) -> Result<Mutant, String> {
    let mut lines = block.lines();
    let mut line = |mark: &str| lines.next().and_then(|l| l.strip_prefix(mark));
    let parsed = || -> Option<Mutant> {
        let (name, file) = line("")?.split_once(" in ")?;
        let (text, with, why) = (line("- ")?, line("+ ")?, line("  ")?);
        Some(Mutant { name, file, text, with, why, survives: line("= ") })
    }();
    parsed.ok_or_else(|| format!("xtask/src/mutants.txt: cannot be read:\n{block}"))
}

/// Result of a run of the tests.
#[derive(Debug, PartialEq)]
enum Outcome {
    /// The first test that failed.
    Killed(String),
    Survived,
    /// Not a mutation: it does not compile.
    Broken(String),
}

/// Tries the mutants whose name contains one of `names`; all, if there are none.
pub fn run(root: &Path, names: &[String]) -> Result<(), String> {
    let all = mutants()?;
    if let Some(name) = names.iter().find(|n| !all.iter().any(|m| m.name.contains(*n))) {
        return Err(format!("no mutant is called {name}"));
    }
    let wanted = |m: &&Mutant| names.is_empty() || names.iter().any(|n| m.name.contains(n));
    let chosen: Vec<&Mutant> = all.iter().filter(wanted).collect();
    let copy = root.join("target/mutants/copy");
    prepare(root, &copy)?;
    // All texts first: a list that is out of date costs no hour.
    let texts = chosen.iter().map(|m| mutated(&copy, m)).collect::<Result<Vec<_>, _>>();
    let texts = texts.map_err(|e| format!("{e}; xtask/src/mutants.txt must follow the sources"))?;
    match test(root, &copy)? {
        Outcome::Survived => println!("no mutation: all tests pass"),
        other => return Err(format!("without a mutation: {other:?}")),
    }
    let mut bad = Vec::new();
    for (m, text) in chosen.iter().zip(texts) {
        let path = copy.join(m.file);
        let original = read(&path)?;
        write(&path, &text)?;
        let outcome = test(root, &copy);
        write(&path, &original)?;
        let outcome = outcome?;
        let line = match (&outcome, m.survives) {
            (Outcome::Killed(by), None) => format!("killed by {by}"),
            (Outcome::Killed(by), Some(_)) => format!("killed by {by}: no longer equivalent"),
            (Outcome::Survived, Some(why)) => format!("survives: {why}"),
            (Outcome::Survived, None) => format!("SURVIVED: {}", m.why),
            (Outcome::Broken(e), _) => format!("BROKEN: {e}"),
        };
        println!("{:<40} {line}", m.name);
        if !expected(&outcome, m.survives.is_some()) {
            bad.push(m.name);
        }
    }
    println!("{} mutants, {} not as expected", chosen.len(), bad.len());
    if bad.is_empty() { Ok(()) } else { Err(format!("mutants: {}", bad.join(", "))) }
}

/// Whether a mutant is noticed, or survives with a reason; one that does not compile shows nothing.
fn expected(outcome: &Outcome, explained: bool) -> bool {
    match outcome {
        Outcome::Killed(_) => !explained,
        Outcome::Survived => explained,
        Outcome::Broken(_) => false,
    }
}

/// Copies what the tests of `ccd-core` need, and a manifest of a workspace around it.
fn prepare(root: &Path, copy: &Path) -> Result<(), String> {
    // What is the same keeps its time, so that only what differs is built again.
    let mut files = files_below(&root.join("ccd-core"))?;
    files.push(root.join("src/scenes/random.rs"));
    files.push(root.join("Cargo.lock"));
    for from in &files {
        let name = from.strip_prefix(root).map_err(|e| e.to_string())?;
        let mut text = read(from)?;
        if name == Path::new("ccd-core/Cargo.toml") {
            text = text.replace(FACADE, "");
        }
        write_changed(&copy.join(name), &text)?;
    }
    for path in files_below(&copy.join("ccd-core"))? {
        let name = path.strip_prefix(copy).map_err(|e| e.to_string())?;
        if !root.join(name).exists() {
            std::fs::remove_file(&path).map_err(|e| format!("{}: {e}", path.display()))?;
        }
    }
    let manifest = read(&root.join("Cargo.toml"))?;
    let shared = manifest.find("[workspace.package]").zip(manifest.find("\n[profile."));
    let (from, to) = shared.ok_or("Cargo.toml has no [workspace.package] before its profiles")?;
    // Fast to compile, fast enough to run.
    let profile = "[profile.test]\nopt-level = 1\ndebug = false\n\
        [profile.test.package.\"*\"]\nopt-level = 2\n";
    let text = format!(
        "[workspace]\nresolver = \"3\"\nmembers = [\"ccd-core\"]\n{}\n{profile}",
        &manifest[from..to]
    );
    write_changed(&copy.join("Cargo.toml"), &text)
}

/// The file of a mutant, mutated.
fn mutated(copy: &Path, m: &Mutant) -> Result<String, String> {
    let text = read(&copy.join(m.file))?;
    match text.matches(m.text).count() {
        1 => Ok(text.replace(m.text, m.with)),
        n => Err(format!("{}: {:?} stands {n} times in {}, not once", m.name, m.text, m.file)),
    }
}

/// Runs the tests of the copy.
fn test(root: &Path, copy: &Path) -> Result<Outcome, String> {
    let out = Command::new("cargo")
        .args(["test", "--quiet", "--offline", "-p", "ccd-core", "--lib", "--tests"])
        .args(["--features", "alloc"])
        .current_dir(copy)
        .env("CARGO_TARGET_DIR", root.join("target/mutants/build"))
        .env("RUST_BACKTRACE", "0")
        .output()
        .map_err(|e| format!("cargo: {e}"))?;
    let (stdout, stderr) =
        (String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr));
    Ok(outcome(out.status.success(), &stdout, &stderr))
}

/// Result that the output of `cargo test --quiet` shows.
fn outcome(success: bool, stdout: &str, stderr: &str) -> Outcome {
    if success {
        return Outcome::Survived;
    }
    let failed =
        stdout.lines().filter_map(|l| l.strip_prefix("---- ")?.strip_suffix(" stdout ----")).next();
    match failed {
        Some(name) => Outcome::Killed(name.into()),
        None => Outcome::Broken(
            stderr.lines().find(|l| l.contains("error")).unwrap_or("no test ran").into(),
        ),
    }
}

fn write_changed(path: &Path, text: &str) -> Result<(), String> {
    if read(path).is_ok_and(|old| old == text) { Ok(()) } else { write(path, text) }
}

fn read(path: &Path) -> Result<String, String> {
    std::fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    if let Some(dir) = path.parent() {
        std::fs::create_dir_all(dir).map_err(|e| format!("{}: {e}", dir.display()))?;
    }
    std::fs::write(path, text).map_err(|e| format!("{}: {e}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_copy_does_without_the_facade() {
        assert_eq!(include_str!("../../ccd-core/Cargo.toml").matches(FACADE).count(), 1);
    }

    #[test]
    fn outcomes_are_told_apart() {
        assert_eq!(outcome(true, "", ""), Outcome::Survived);
        let failed = "failures:\n\n---- a::b stdout ----\npanicked\n";
        assert_eq!(outcome(false, failed, "error: test failed"), Outcome::Killed("a::b".into()));
        assert_eq!(outcome(false, "", "x\nerror: no"), Outcome::Broken("error: no".into()));
    }

    #[test]
    fn what_does_not_compile_is_never_as_expected() {
        let killed = Outcome::Killed("a".into());
        let broken = Outcome::Broken("error".into());
        for (outcome, unexplained, explained) in
            [(killed, true, false), (Outcome::Survived, false, true), (broken, false, false)]
        {
            let got = [expected(&outcome, false), expected(&outcome, true)];
            assert_eq!(got, [unexplained, explained], "{outcome:?}");
        }
    }

    #[test]
    fn every_mutant_has_its_place_and_its_reason() {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
        let all = mutants().unwrap_or_else(|e| panic!("{e}"));
        assert!(all.len() > 50, "{} mutants", all.len());
        for (i, m) in all.iter().enumerate() {
            // What is copied; all else is not there when the command runs.
            assert!(m.file.starts_with("ccd-core/"), "{}: {}", m.name, m.file);
            assert_ne!(mutated(root, m), read(&root.join(m.file)), "{} changes nothing", m.name);
            mutated(root, m).unwrap_or_else(|e| panic!("{e}"));
            assert!(!m.why.is_empty() && all[..i].iter().all(|n| n.name != m.name), "{}", m.name);
        }
    }
}
