//! The checks that a change must pass, in the order of what fails fastest.

use crate::programs::{
    TIMES, Words, beside, command, command_beside, command_with, has_target, skipped,
    target_folder, text,
};
use crate::{lints, wasm};
use std::path::Path;
use std::time::{Instant, SystemTime};

/// A target without a standard library or an operating system.
const BARE_METAL: &str = "thumbv7em-none-eabihf";

/// A program for it, a workspace of its own, and how it is built.
const PROGRAM: &str = "examples/bare-metal/Cargo.toml";
const PROGRAM_CONFIG: &str = "examples/bare-metal/.cargo/config.toml";

/// Libraries of other languages, whose manifests say that they have no pages.
const NO_PAGES: [&str; 4] = ["meshccd-python", "meshccd-c", "meshccd-web", "ccd-wasm-test"];

/// Features of this crate, off by default and one a task.
const XTASK_FEATURES: [&str; 4] = ["report", "shaders", "soak", "web"];

/// Runs the gate, or `whole`: that with nothing left out, and the searches that take long.
/// Prints at the end how long each command took.
pub fn run(root: &Path, whole: bool) -> Result<(), String> {
    let begun = Instant::now();
    let result = gate(root).and_then(|()| if whole { long(root) } else { Ok(()) });
    let times = std::mem::take(&mut *TIMES.lock().map_err(|e| e.to_string())?);
    let total = begun.elapsed().as_secs_f64();
    println!("{total:7.0} s in all, of which, some side by side,");
    for (words, seconds) in times.iter().filter(|(_, seconds)| *seconds >= 1.0) {
        println!("{seconds:7.0} s {words}");
    }
    result
}

fn gate(root: &Path) -> Result<(), String> {
    command(root, &["cargo", "fmt", "--all", "--check"])?;
    crate::tidy::run(root)?;
    // The gate builds neither, so nothing else of it sees a lock file that lags behind manifests.
    for manifest in ["fuzz/Cargo.toml", "examples/bevy/Cargo.toml"] {
        let update = ["cargo", "update", "--quiet", "--workspace", "--locked"];
        command(root, &[&update[..], &["--manifest-path", manifest]].concat())?;
    }
    let mut env = Vec::new();
    let lints = lints::environment(root)?;
    let is_new = !target_folder(root).join("release/deps").exists();
    if !is_new {
        read(root)?;
    } else {
        // Nothing is compiled yet, so all of the workspace is read while it is.
        env.extend(lints.iter().map(|(name, value)| (*name, value.as_str())));
    }
    let test = readme_test_command(root)?;
    let test: Vec<&str> = test.split_whitespace().collect();
    // Compilers leave a core idle now and then, which takes what is built in other folders.
    let beside = beside(root);
    let build = [&test[..], &["--no-run"]].concat();
    command_beside(root, &(build, env), &bare_metal(text(&beside)?))?;
    if is_new {
        lints::check(root)?;
    }
    // Tests leave a core idle for long, and so do some of these, which need what was compiled. The
    // first compiles nothing, so that the tests begin at once. Of attacks the tests run the first
    // cases too, on the CPU alone.
    let attack = |backend, minutes| {
        let attack = ["cargo", "xtask", "attack", "--minutes", minutes, "--backend", backend];
        (attack.to_vec(), vec![])
    };
    let others = [
        (vec!["cargo", "xtask", "python"], vec![]),
        (vec!["cargo", "xtask", "c-api"], vec![]),
        (vec!["cargo", "xtask", "web"], vec![]),
        attack("cpu", "0.1"),
        attack("gpu", "0.2"),
    ];
    command_beside(root, &(test, vec![]), &others)
}

/// Has Clippy and rustdoc read the workspace with all features.
fn read(root: &Path) -> Result<(), String> {
    let features = XTASK_FEATURES.map(|feature| format!("xtask/{feature}")).join(",");
    let all = ["--release", "--workspace", "--features", &features];
    // As the tests are built, so that procedural macros are compiled once.
    let clippy = [&["cargo", "clippy"], &all[..], &["--all-targets", "--", "-D", "warnings"]];
    command(root, &clippy.concat())?;
    // With an example the dependencies have the features of tests, and clippy has checked those.
    // Not the command, whose pages would lie over those of the library of the same name.
    let pages = ["--no-deps", "--lib", "--bin", "xtask", "--example", "static_world"];
    let doc = [&["cargo", "doc"], &all[..], &pages].concat();
    let doc = NO_PAGES.iter().fold(doc, |doc, name| [&doc[..], &["--exclude", name]].concat());
    command_with(root, &doc, &[("RUSTDOCFLAGS", "-D warnings")])
}

/// Checks that take too long for the gate.
fn long(root: &Path) -> Result<(), String> {
    read(root)?;
    // A test of the gate compares hashes of sources and kernels; here the kernels are compiled.
    command(root, &["cargo", "xtask", "shaders", "--check"])?;
    // The npm package, which the gate tests, has the default methods, over vectors.
    for env in [&[][..], &wasm::SIMD] {
        wasm::run(root, env)?;
    }
    // The gate's own adapter; under `--whole` all other tests run on the system's.
    let newer = root.join("target/lavapipe/icd.json");
    if let Some(newer) = newer.to_str().filter(|_| newer.exists()) {
        crate::programs::test(root, "gpu", &[], &[("VK_ICD_FILENAMES", newer)])?;
    }
    command(root, &["cargo", "xtask", "web", "--page"])?;
    crate::python::run(root, true)?;
    crate::c_api::run(root, true)?;
    crate::bevy::run(root)?;
    // What a dependent compiles: the default methods alone. The gate has built them for the web.
    for features in ["", "gpu"] {
        let clippy = ["cargo", "clippy", "--release", "-p", "meshccd", "--features", features];
        command(root, &[&clippy[..], &["--", "-D", "warnings"]].concat())?;
    }
    let no_gpu = ["--release", "-p", "meshccd-python", "--no-default-features", "--lib"];
    command(root, &[&["cargo", "clippy"][..], &no_gpu, &["--", "-D", "warnings"]].concat())?;
    let no_gpu = ["--release", "-p", "meshccd-c", "--no-default-features", "--lib"];
    command(root, &[&["cargo", "clippy"][..], &no_gpu, &["--", "-D", "warnings"]].concat())?;
    // Other cases every day; one that fails is printed with the command that replays it.
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    let seed = (since.map_err(|e| e.to_string())?.as_secs() / 86_400).to_string();
    let attack = ["cargo", "xtask", "attack", "--seed", &seed];
    for backend in ["cpu", "gpu"] {
        for kind in ["boxes", "queries", "sessions"] {
            command(root, &[&attack[..], &["--backend", backend, "--kind", kind]].concat())?;
        }
    }
    // 20,000 queries of each family; 10000 cases are a million.
    command(root, &[&attack[..], &["--kind", "exact", "--cases", "200"]].concat())?;
    let benches = ["--release", "-p", "ccd-benches", "--features", "criterion"];
    let clippy = [&["cargo", "clippy", "--all-targets"][..], &benches, &["--", "-D", "warnings"]];
    command(root, &clippy.concat())?;
    // It includes files of the command, and only runs with a nightly.
    command(root, &["cargo", "check", "--manifest-path", "fuzz/Cargo.toml", "--locked"])?;
    // Each benchmark once: its answer.
    let bench = ["cargo", "bench", "-p", "ccd-benches", "--features", "criterion", "--", "--test"];
    command(root, &bench)?;
    command(root, &["cargo", "xtask", "mutants"])
}

/// Checks of `ccd-core` where there is no standard library: a use of one would not compile.
fn bare_metal(folder: &str) -> Vec<Words<'_>> {
    if !has_target(BARE_METAL) {
        skipped(&format!(
            "the target {BARE_METAL} cannot be installed here, so ccd-core was not shown to be \
             no_std"
        ));
        return Vec::new();
    }
    // Procedural macros are compiled once for all of these.
    let folder = ["--target-dir", folder];
    let check = |features| {
        let check = ["cargo", "check", "--release", "-p", "ccd-core", "--target", BARE_METAL];
        ([&check[..], &folder, &["--features", features]].concat(), vec![])
    };
    // A program that links there, with an allocator; its own configuration names the target.
    let program = ["cargo", "build", "--release", "--locked", "--manifest-path", PROGRAM];
    let program = [&program[..], &folder, &["--config", PROGRAM_CONFIG]].concat();
    vec![check(""), check("glam,serde"), (program, vec![])]
}

/// The line of the README that runs the tests: what CI runs is what it says.
fn readme_test_command(root: &Path) -> Result<String, String> {
    let text =
        std::fs::read_to_string(root.join("README.md")).map_err(|e| format!("README.md: {e}"))?;
    let line = text.lines().find(|l| l.starts_with("cargo test"));
    line.map(str::to_owned)
        .ok_or_else(|| "README.md has no line that begins with `cargo test`".into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clippy_sees_every_feature() {
        let manifest = include_str!("../Cargo.toml");
        let (_, rest) = manifest.split_once("[features]\n").expect("features");
        let (features, _) = rest.split_once("\n[").expect("what follows");
        let named: Vec<&str> =
            features.lines().filter_map(|line| Some(line.split_once(" = [")?.0)).collect();
        assert_eq!(named, XTASK_FEATURES);
    }
}
