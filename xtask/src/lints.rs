//! Lints of a build from nothing. As cargo's wrapper of rustc this program has Clippy and rustdoc
//! read each crate of the workspace when rustc has compiled it. `cargo clippy` and `cargo doc` find
//! the same, but first check all third-party code again, which takes as long as the reading.

use crate::programs::{target_folder, text};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// Set where cargo runs this program as its wrapper: the folder of the workspace.
const ROOT: &str = "CCD_LINTS";

/// The environment in which cargo compiles with lints.
pub fn environment(root: &Path) -> Result<[(&str, String); 2], String> {
    let program = std::env::current_exe().map_err(|e| format!("this program: {e}"))?;
    Ok([("RUSTC_WRAPPER", text(&program)?.to_owned()), (ROOT, text(root)?.to_owned())])
}

/// Whether anything was read: an error if cargo named no crate of the workspace as its own.
pub fn check(root: &Path) -> Result<(), String> {
    let target = target_folder(root);
    match ["lints", "doc"].into_iter().find(|folder| !target.join(folder).exists()) {
        Some(folder) => Err(format!("nothing was read by Clippy and rustdoc: no {folder} there")),
        None => Ok(()),
    }
}

/// If cargo runs this program as its wrapper: compiles, reads what is of the workspace, and returns
/// whether both went well.
pub fn wrapped() -> Option<ExitCode> {
    let root = PathBuf::from(std::env::var_os(ROOT)?);
    let words: Vec<String> = std::env::args().skip(1).collect();
    let (rustc, args) = words.split_first()?;
    // Cargo says so of packages that it was told to compile.
    let own = std::env::var_os("CARGO_PRIMARY_PACKAGE").is_some();
    let done = run(Command::new(rustc).args(args)) && (!own || read(&root, rustc, args));
    Some(if done { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn run(command: &mut Command) -> bool {
    match command.status() {
        Ok(status) => status.success(),
        Err(e) => {
            eprintln!("{}: {e}", command.get_program().to_string_lossy());
            false
        }
    }
}

/// Has Clippy read a crate, and rustdoc if it has pages.
fn read(root: &Path, rustc: &str, args: &[String]) -> bool {
    let cargo = PathBuf::from(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    let target = target_folder(root);
    let mut clippy = Command::new(cargo.with_file_name("clippy-driver"));
    clippy.arg(rustc).args(for_clippy(args)).arg("--out-dir").arg(target.join("lints"));
    // As `cargo clippy -- -D warnings` says it.
    clippy.env("CLIPPY_ARGS", "-D__CLIPPY_HACKERY__warnings__CLIPPY_HACKERY__");
    let mut rustdoc = Command::new(cargo.with_file_name("rustdoc"));
    rustdoc.args(for_rustdoc(args)).args(["-D", "warnings", "--out-dir"]).arg(target.join("doc"));
    run(&mut clippy) && (!has_pages(args) || run(&mut rustdoc))
}

/// What Clippy is told of a crate: to make nothing that cargo takes for what rustc made.
fn for_clippy(args: &[String]) -> Vec<String> {
    let mut args = without(args, &["--out-dir"], &["--emit="]);
    for arg in &mut args {
        // Or cargo would go on without what is named there.
        if arg.starts_with("--json=") {
            *arg = arg.replace(",artifacts", "");
        }
    }
    args.push("--emit=metadata".into());
    args
}

/// What rustdoc is told of it; what it finds is for people, as cargo hands it on.
fn for_rustdoc(args: &[String]) -> Vec<String> {
    let flags = ["--emit=", "--json=", "--error-format=", "--diagnostic-width=", "--test"];
    let mut args = without(args, &["--out-dir", "-C"], &flags);
    if is_this(&args) {
        args.push("--document-private-items".into());
    }
    args
}

/// All words but `options` with their values, and but what begins with one of `flags`.
fn without(args: &[String], options: &[&str], flags: &[&str]) -> Vec<String> {
    let mut left = Vec::new();
    let mut args = args.iter();
    while let Some(arg) = args.next() {
        if options.contains(&arg.as_str()) {
            args.next();
        } else if !flags.iter().any(|flag| arg.starts_with(flag)) {
            left.push(arg.clone());
        }
    }
    left
}

/// Whether rustdoc makes pages of it: of libraries for Rust, and of this program.
fn has_pages(args: &[String]) -> bool {
    has(args, "--crate-type", "lib") || is_this(args)
}

fn is_this(args: &[String]) -> bool {
    has(args, "--crate-name", env!("CARGO_PKG_NAME"))
}

fn has(args: &[String], option: &str, value: &str) -> bool {
    args.windows(2).any(|two| two == [option, value])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What cargo tells rustc of a crate.
    fn told(words: &str) -> Vec<String> {
        words.split(' ').map(str::to_owned).collect()
    }

    #[test]
    fn readers_make_nothing_where_cargo_looks() {
        let args = told(
            "--crate-name ccd --edition=2024 src/lib.rs --error-format=json \
             --json=diagnostic-rendered-ansi,artifacts,future-incompat --crate-type lib \
             --emit=dep-info,metadata,link -C opt-level=3 --cfg feature=\"io\" --out-dir deps",
        );
        let clippy = "--crate-name ccd --edition=2024 src/lib.rs --error-format=json \
                      --json=diagnostic-rendered-ansi,future-incompat --crate-type lib \
                      -C opt-level=3 --cfg feature=\"io\" --emit=metadata";
        assert_eq!(for_clippy(&args), told(clippy));
        let rustdoc = "--crate-name ccd --edition=2024 src/lib.rs --crate-type lib \
                       --cfg feature=\"io\"";
        assert_eq!(for_rustdoc(&args), told(rustdoc));
        assert!(has_pages(&args));
        let module = told("--crate-name _native --crate-type cdylib --crate-type rlib");
        assert!(!has_pages(&module));
        assert!(has_pages(&told("--crate-name xtask --crate-type bin")));
    }
}
