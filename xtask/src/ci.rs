//! The checks that a change must pass, in the order of what fails fastest.

use crate::programs::{command, command_with, has_target, skipped};
use std::path::Path;

/// A target without a standard library or an operating system.
const BARE_METAL: &str = "thumbv7em-none-eabihf";

/// What this crate is built with for one task each, and by default without: clippy sees all of it.
const XTASK_FEATURES: [&str; 5] = ["report", "attack", "shaders", "loom", "soak"];

pub fn run(root: &Path) -> Result<(), String> {
    command(root, &["cargo", "fmt", "--all", "--check"])?;
    crate::tidy::run(root)?;
    crate::python::check_lock(root)?;
    let features = XTASK_FEATURES.map(|feature| format!("xtask/{feature}")).join(",");
    // As the tests are built, so that procedural macros are compiled once.
    let clippy =
        ["cargo", "clippy", "--release", "--workspace", "--all-targets", "--features", &features];
    command(root, &[&clippy[..], &["--", "-D", "warnings"]].concat())?;
    bare_metal(root)?;
    command(root, &["cargo", "xtask", "loom"])?;
    command(root, &["cargo", "xtask", "shaders", "--check"])?;
    let test = readme_test_command(root)?;
    command(root, &test.split_whitespace().collect::<Vec<_>>())?;
    // The first cases of a seed: two minutes together, with those that are begun last.
    for (backend, minutes) in [("cpu", "0.5"), ("gpu", "0.9")] {
        command(root, &["cargo", "xtask", "attack", "--minutes", minutes, "--backend", backend])?;
    }
    // After the tests, which compile most of what they need.
    crate::wasm::run(root)?;
    crate::python::run(root)?;
    command_with(
        root,
        &["cargo", "doc", "--release", "--workspace", "--no-deps"],
        &[("RUSTDOCFLAGS", "-D warnings")],
    )
}

/// Builds `ccd-core` where there is no standard library: a use of one would not compile.
fn bare_metal(root: &Path) -> Result<(), String> {
    if !has_target(BARE_METAL) {
        skipped(&format!(
            "the target {BARE_METAL} cannot be installed here, so ccd-core was not shown to be \
             no_std"
        ));
        return Ok(());
    }
    for features in ["", "alloc"] {
        command(
            root,
            &["cargo", "build", "-p", "ccd-core", "--target", BARE_METAL, "--features", features],
        )?;
    }
    Ok(())
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
