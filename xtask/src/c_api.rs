//! `cargo xtask c-api`: the C API as a user of CMake meets it: its package is installed below
//! target, and the examples are built against that and run by ctest, one of them with a wrong
//! answer, which must fail.
//!
//! The tests of the workspace have compiled the libraries already (`ccd-c/tests/c_api.rs`).
//! `--cargo` has CMake build them by cargo instead, which compiles everything anew.

use crate::programs::{command, output, skipped, target_folder, text};
use std::path::Path;
use std::process::Command;

const FOLDER: &str = "ccd-c";

pub fn run(root: &Path, by_cargo: bool) -> Result<(), String> {
    if let Err(why) = has_tools() {
        skipped(&format!("the C API was not built and run by CMake: {why}"));
        return Ok(());
    }
    let target = target_folder(root).join("c-api");
    if by_cargo {
        let build = target.join("subproject");
        configure(root, root.join(FOLDER).as_path(), &build, &[("MESHCCD_EXAMPLES", "ON")])?;
        return build_and_test(root, &build);
    }
    // All packages are named, so that dependencies have the features that the tests gave them.
    let tests = ["cargo", "test", "--release", "--workspace", "--test", "c_api", "--no-run"];
    command(root, &tests)?;
    let [package, prefix, examples] =
        ["package", "prefix", "examples"].map(|name| target.join(name));
    // What an earlier version has installed is not found.
    let _ = std::fs::remove_dir_all(&prefix);
    let libraries = target_folder(root).join("release/deps");
    let libraries = [("MESHCCD_LIBRARY_DIR", text(&libraries)?)];
    configure(root, &root.join(FOLDER), &package, &libraries)?;
    command(root, &["cmake", "--install", text(&package)?, "--prefix", text(&prefix)?])?;
    let prefix = [("CMAKE_PREFIX_PATH", text(&prefix)?)];
    configure(root, &root.join(FOLDER).join("examples"), &examples, &prefix)?;
    build_and_test(root, &examples)
}

fn configure(
    root: &Path,
    source: &Path,
    build: &Path,
    settings: &[(&str, &str)],
) -> Result<(), String> {
    let settings: Vec<String> =
        settings.iter().map(|(name, value)| format!("-D{name}={value}")).collect();
    let words = ["cmake", "-S", text(source)?, "-B", text(build)?, "-DCMAKE_BUILD_TYPE=Release"];
    let words = words.into_iter().chain(settings.iter().map(String::as_str));
    command(root, &words.collect::<Vec<_>>())
}

fn build_and_test(root: &Path, build: &Path) -> Result<(), String> {
    let build = text(build)?;
    command(root, &["cmake", "--build", build, "--config", "Release"])?;
    let test = ["ctest", "--test-dir", build, "--build-config", "Release"];
    command(root, &[&test[..], &["--output-on-failure", "--no-tests=error"]].concat())
}

/// Whether there are CMake and a compiler of C++; why not.
fn has_tools() -> Result<(), String> {
    output(Command::new("cmake").arg("--version"))?;
    let chosen = std::env::var("CXX").ok();
    let compilers = chosen.as_deref().into_iter().chain(["c++", "g++", "clang++"]);
    let found = |name: &str| output(Command::new(name).arg("--version")).is_ok();
    // Visual Studio's compiler is found by CMake alone.
    if cfg!(windows) || compilers.into_iter().any(found) {
        Ok(())
    } else {
        Err("there is no compiler of C++".into())
    }
}
