//! `cargo xtask python`: the module of ccd-python as a user meets it: tests against ipctk, ranks
//! under mpirun, stubs against the module, types as mypy and pyright see them, the examples.
//!
//! The tests of the workspace have compiled the module already (`ccd-python/tests/module.rs`): it
//! is put beside the Python sources in a folder below target. `--wheel` builds, installs and tests
//! a wheel with maturin instead, which compiles much again. Packages are the versions of
//! `ccd-python/requirements.txt`, and for a wheel also the large ones of `requirements-wheel.txt`.

use crate::programs::{command, command_with, output, skipped, target_folder, text};
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::Command;

const FOLDER: &str = "ccd-python";
/// Versions of CPython for which a wheel is tested, where they are installed.
const VERSIONS: [&str; 6] = ["3.9", "3.10", "3.11", "3.12", "3.13", "3.14"];
/// Tests that need no package but NumPy.
const TESTS_OF_VERSIONS: [&str; 3] =
    ["tests/test_api.py", "tests/test_sessions.py", "tests/test_distributed.py"];
/// Examples; the last one needs a package of `requirements-wheel.txt`.
const EXAMPLES: [&str; 3] =
    ["examples/line_search.py", "examples/alembic_frames.py", "examples/rerun_log.py"];

pub fn run(root: &Path, wheel: bool) -> Result<(), String> {
    let target = target_folder(root);
    let python = match environment(root, &target.join("python"), wheel) {
        Ok(python) => python,
        Err(why) => {
            skipped(&format!("the Python module was not tested: {why}"));
            return Ok(());
        }
    };
    let path = path_of(&python)?;
    let (python, folder) = (text(&python)?, root.join(FOLDER));
    let site = if wheel { install_wheel(&folder, &target, python)? } else { assemble(root)? };
    let cache = target.join("python/mypy");
    let (site, cache) = (text(&site)?, text(&cache)?);
    let env = [
        ("PYTHONPATH", site),
        ("MYPYPATH", site),
        ("MYPY_CACHE_DIR", cache),
        ("PATH", &path),
        // A module without it is a mistake of the build here.
        ("CCD_CATALOGUE", "require"),
    ];
    if let Err(why) = output(Command::new("mpirun").arg("--version")) {
        skipped(&format!("meshccd.mpi was not tested: {why}"));
    }
    let examples = if wheel { &EXAMPLES[..] } else { &EXAMPLES[..2] };
    if !wheel {
        skipped(
            "Ray, JAX and the example of rerun, which take 300 MB of packages: `cargo xtask \
             python --wheel` has them",
        );
    }
    for words in [
        &["-m", "pytest", "--quiet", "-p", "no:cacheprovider"][..],
        &["-m", "mypy.stubtest", "meshccd"],
        &["-m", "mypy", "--strict", "--package", "meshccd"],
        &[&["-m", "mypy", "--check-untyped-defs"], examples].concat(),
    ] {
        command_with(&folder, &[&[python][..], words].concat(), &env)?;
    }
    for example in examples {
        command_with(&folder, &[python, example], &env)?;
    }
    if let Err(why) = output(Command::new("node").arg("--version")) {
        skipped(&format!("types were not checked by pyright, which needs Node: {why}"));
        return Ok(());
    }
    let pyright = [python, "-m", "pyright"];
    let (package, mut files) = (format!("{site}/meshccd"), examples.to_vec());
    // A wheel has the same sources, in the environment.
    if !wheel {
        files.push(&package);
    }
    for words in [&["--verifytypes", "meshccd", "--ignoreexternal"][..], &files] {
        command_with(&folder, &[&pyright[..], words].concat(), &env)?;
    }
    Ok(())
}

/// A folder with the package: the Python sources, and the module that the tests were built with.
fn assemble(root: &Path) -> Result<PathBuf, String> {
    // All packages are named, so that dependencies have the features that the tests gave them.
    let build = ["cargo", "test", "--release", "--workspace", "--test", "module", "--no-run"];
    command(root, &build)?;
    let target = target_folder(root);
    let site = target.join("python/site");
    let package = site.join("meshccd");
    // Anew, so that a file that was renamed is not there by its old name, too.
    let _ = std::fs::remove_dir_all(&package);
    std::fs::create_dir_all(&package).map_err(|e| format!("{}: {e}", package.display()))?;
    let copy = |from: &Path, name: &OsStr| match std::fs::copy(from, package.join(name)) {
        Ok(_) => Ok(()),
        Err(e) => Err(format!("{}: {e}", from.display())),
    };
    let sources = root.join(FOLDER).join("python/meshccd");
    let entries = std::fs::read_dir(&sources).map_err(|e| format!("{}: {e}", sources.display()))?;
    for file in entries.flatten().map(|entry| entry.path()).filter(|path| path.is_file()) {
        copy(&file, file.file_name().unwrap_or_default())?;
    }
    let library =
        format!("{}_native{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let name = if cfg!(windows) { "_native.pyd" } else { "_native.abi3.so" };
    copy(&target.join("release/deps").join(library), name.as_ref())?;
    Ok(site)
}

/// Builds a wheel and installs it into the environment; a folder without a package of that name.
fn install_wheel(folder: &Path, target: &Path, python: &str) -> Result<PathBuf, String> {
    let wheels = target.join("python/wheels");
    let _ = std::fs::remove_dir_all(&wheels);
    let env = [("CARGO_TARGET_DIR", text(target)?)];
    // As wheels are handed out, not as pip builds a checkout.
    let build = [python, "-m", "maturin", "build", "--locked", "--profile", "release"];
    let build = [&build[..], &["--features", "catalogue", "--out", text(&wheels)?]].concat();
    command_with(folder, &build, &env)?;
    let wheel = only_wheel(&wheels)?;
    let install = ["-m", "pip", "install", "--quiet", "--no-deps", "--force-reinstall"];
    command(folder, &[&[python][..], &install, &[text(&wheel)?]].concat())?;
    for version in VERSIONS {
        let venv = target.join(format!("python/venv-{version}"));
        match make_venv(&format!("python{version}"), &venv) {
            Ok(python) => test_version(folder, text(&python)?, text(&wheel)?)?,
            Err(why) => skipped(&format!("the wheel was not tested by Python {version}: {why}")),
        }
    }
    Ok(wheels)
}

/// Tests a wheel in an environment of another interpreter.
fn test_version(folder: &Path, python: &str, wheel: &str) -> Result<(), String> {
    let install = ["-m", "pip", "install", "--quiet", "--force-reinstall", "pytest", wheel];
    command(folder, &[&[python][..], &install].concat())?;
    let test = ["-m", "pytest", "--quiet", "-p", "no:cacheprovider"];
    command(folder, &[&[python][..], &test, &TESTS_OF_VERSIONS].concat())
}

/// The interpreter of an environment with all packages; why there is none otherwise.
fn environment(root: &Path, at: &Path, wheel: bool) -> Result<PathBuf, String> {
    let system = if cfg!(windows) { "python" } else { "python3" };
    let python = make_venv(system, &at.join("venv"))?;
    let how = ["--quiet", "--disable-pip-version-check", "--retries", "1", "--timeout", "20"];
    let mut pip = Command::new(&python);
    // Of modules that nothing imports no bytecode is made.
    pip.args(["-m", "pip", "install", "--no-compile"]).args(how);
    let lists = ["requirements.txt", "requirements-wheel.txt"];
    for list in &lists[..if wheel { 2 } else { 1 }] {
        pip.arg("-r").arg(root.join(FOLDER).join(list));
    }
    output(&mut pip)?;
    Ok(python)
}

/// The interpreter of an environment, which is made of a system's interpreter if it is not there.
fn make_venv(system: &str, venv: &Path) -> Result<PathBuf, String> {
    let bin = if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" };
    let python = venv.join(bin);
    // One whose interpreter has gone is made anew.
    if output(Command::new(&python).arg("--version")).is_err() {
        output(Command::new(system).args(["-m", "venv", "--clear"]).arg(venv))?;
    }
    Ok(python)
}

/// `PATH` that begins with an environment: pyright knows the packages of the first interpreter.
fn path_of(python: &Path) -> Result<String, String> {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let own = python.parent().map(Path::to_path_buf);
    let all = std::env::join_paths(own.into_iter().chain(std::env::split_paths(&path)));
    all.map_err(|e| e.to_string())?.into_string().map_err(|path| format!("{path:?}: not Unicode"))
}

fn only_wheel(folder: &Path) -> Result<PathBuf, String> {
    let entries = std::fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let wheels: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    match &wheels[..] {
        [wheel] => Ok(wheel.clone()),
        _ => Err(format!("{} wheels in {}", wheels.len(), folder.display())),
    }
}
