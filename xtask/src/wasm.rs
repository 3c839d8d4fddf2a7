//! `cargo xtask wasm`: the CPU's path built for WebAssembly, where there is no clock and no second
//! thread, gives under Node what it gives on this machine, bit for bit (tests/wasm). That the GPU's
//! compiles for browsers, `web.rs` shows.

use crate::programs::{
    beside, command_with, has_target, output, skipped, target_folder, test, text,
};
use std::path::Path;
use std::process::Command;

const TARGET: &str = "wasm32-unknown-unknown";
const PACKAGE: &str = "ccd-wasm-test";

/// Vectors of WebAssembly, which all browsers have since 2023 (Safari 16.4 was the last). A warning
/// is an error, because the npm package is what the gate compiles without the catalogue.
pub const SIMD: [(&str, &str); 1] =
    [("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", "-C target-feature=+simd128 -D warnings")];

/// Compares answers; `env` is for the build.
pub fn run(root: &Path, env: &[(&str, &str)]) -> Result<(), String> {
    if !has_target(TARGET) {
        skipped(&format!("nothing was built for WebAssembly: no target {TARGET} here"));
        return Ok(());
    }
    let beside = beside(root);
    let build = ["cargo", "build", "--release", "-p", PACKAGE, "--lib", "--target", TARGET];
    command_with(root, &[&build[..], &["--target-dir", text(&beside)?]].concat(), env)?;
    if let Err(why) = output(Command::new("node").arg("--version")) {
        skipped(&format!("what was built for WebAssembly was not run: {why}"));
        return Ok(());
    }
    test(root, "answers", &[], &[])?;
    let native = target_folder(root).join("tmp/answers.txt");
    let native =
        std::fs::read_to_string(&native).map_err(|e| format!("{}: {e}", native.display()))?;
    let module = beside.join(TARGET).join("release").join(PACKAGE.replace('-', "_"));
    let script = root.join("tests/wasm/answers.mjs");
    let wasm = output(Command::new("node").arg(script).arg(module.with_extension("wasm")))?;
    let n = compare(&native, &wasm)?;
    println!("WebAssembly under Node: {n} answers, all those of this machine");
    Ok(())
}

/// The number of answers, if both say the same.
fn compare(native: &str, wasm: &str) -> Result<usize, String> {
    let (ours, theirs): (Vec<_>, Vec<_>) = (native.lines().collect(), wasm.lines().collect());
    // A refused step is all ones, a scene without contacts shows nothing.
    let empty = |line: &&&str| line.ends_with(": 0 contacts") || line.ends_with(&"f".repeat(16));
    if let Some(line) = ours.iter().find(empty) {
        return Err(format!("{line}: that shows nothing"));
    }
    if let Some(i) = (0..ours.len().max(theirs.len())).find(|&i| ours.get(i) != theirs.get(i)) {
        let line = |lines: &[&str]| lines.get(i).map_or("nothing".to_owned(), |l| format!("{l:?}"));
        return Err(format!("WebAssembly says {}, this machine {}", line(&theirs), line(&ours)));
    }
    let n = ours.iter().filter(|line| !line.starts_with("scene")).count();
    if n > 0 { Ok(n) } else { Err("there are no answers to compare".into()) }
}

#[cfg(test)]
mod tests {
    use super::compare;

    #[test]
    fn other_answers_are_seen() {
        let want = "scene 0: 3 contacts\n0 0 0 12\n0 1 1 34";
        assert_eq!(compare(want, want), Ok(2));
        for wrong in ["", "scene 0: 3 contacts\n0 0 0 12", &want.replace("34", "35")] {
            assert!(compare(want, wrong).is_err(), "{wrong}");
        }
        let refused = format!("0 0 0 {}", "f".repeat(16));
        for nothing in ["", "scene 0: 0 contacts\n0 0 0 12", &refused] {
            assert!(compare(nothing, nothing).is_err(), "{nothing}");
        }
    }
}
