//! `cargo xtask python`: the wheel of ccd-python, built into an environment below target, and what
//! a user meets there: tests against ipctk, stubs against the module, the example.
//!
//! Packages are the versions of `ccd-python/requirements.txt`. The crate is outside of the
//! workspace, but built into its target folder: a dependency that has the same features there is
//! not compiled again.

use crate::programs::{command, command_with, output, skipped, target_folder};
use std::path::{Path, PathBuf};
use std::process::Command;

const FOLDER: &str = "ccd-python";

/// The lock file of the wheel is of the manifests that there are.
pub fn check_lock(root: &Path) -> Result<(), String> {
    command(&root.join(FOLDER), &["cargo", "fetch", "--quiet", "--locked"])
}

pub fn run(root: &Path) -> Result<(), String> {
    let target = target_folder(root);
    let python = match environment(root, &target.join("python")) {
        Ok(python) => python,
        Err(why) => {
            skipped(&format!("the Python wheel was neither built nor tested: {why}"));
            return Ok(());
        }
    };
    let (python, folder) = (text(&python)?, root.join(FOLDER));
    let wheels = target.join("python/wheels");
    let _ = std::fs::remove_dir_all(&wheels);
    let env = [("CARGO_TARGET_DIR", text(&target)?), ("PYO3_PYTHON", python)];
    command(&folder, &["cargo", "fmt", "--check"])?;
    let build = ["-m", "maturin", "build", "--release", "--locked", "--interpreter", python];
    let out = ["--out", text(&wheels)?];
    command_with(&folder, &[&[python][..], &build, &out].concat(), &env)?;
    let clippy = ["cargo", "clippy", "--locked", "--", "-D", "warnings"];
    command_with(&folder, &clippy, &env)?;
    let wheel = only_wheel(&wheels)?;
    let install = ["-m", "pip", "install", "--quiet", "--no-deps", "--force-reinstall"];
    command(&folder, &[&[python][..], &install, &[text(&wheel)?]].concat())?;
    command(&folder, &[python, "-m", "pytest", "--quiet", "-p", "no:cacheprovider"])?;
    let cache = target.join("python/mypy");
    let stubs = [python, "-m", "mypy.stubtest", "meshccd"];
    command_with(&folder, &stubs, &[("MYPY_CACHE_DIR", text(&cache)?)])?;
    command(&folder, &[python, "examples/line_search.py"])
}

/// The interpreter of an environment with all packages; why there is none otherwise.
fn environment(root: &Path, at: &Path) -> Result<PathBuf, String> {
    let venv = at.join("venv");
    let bin = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };
    let python = venv.join(bin);
    // One whose interpreter has gone is made anew.
    if output(Command::new(&python).arg("--version")).is_err() {
        let system = if cfg!(windows) { "python" } else { "python3" };
        let make = ["-m", "venv", "--clear"];
        output(Command::new(system).args(make).arg(&venv))?;
    }
    let how = ["--quiet", "--disable-pip-version-check", "--retries", "1", "--timeout", "20"];
    let list = root.join(FOLDER).join("requirements.txt");
    let pip = ["-m", "pip", "install"];
    output(Command::new(&python).args(pip).args(how).arg("-r").arg(list))?;
    Ok(python)
}

fn only_wheel(folder: &Path) -> Result<PathBuf, String> {
    let entries = std::fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let wheels: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    match &wheels[..] {
        [wheel] => Ok(wheel.clone()),
        _ => Err(format!("{} wheels in {}", wheels.len(), folder.display())),
    }
}

fn text(path: &Path) -> Result<&str, String> {
    path.to_str().ok_or_else(|| format!("{}: not Unicode", path.display()))
}
