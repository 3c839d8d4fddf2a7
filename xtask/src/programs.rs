//! Other programs that are run. What a machine may lack: a check that needs it is skipped there,
//! loudly and with the reason, never silently.

use std::path::Path;
use std::process::Command;
use std::sync::Mutex;
use std::time::Instant;

/// Commands that ran, and their seconds.
pub static TIMES: Mutex<Vec<(String, f64)>> = Mutex::new(Vec::new());

/// Runs a command in `root`, showing it; an error if it fails.
pub fn command(root: &Path, words: &[&str]) -> Result<(), String> {
    command_with(root, words, &[])
}

pub fn command_with(root: &Path, words: &[&str], env: &[(&str, &str)]) -> Result<(), String> {
    let shown = words.join(" ");
    println!("$ {shown}");
    let begun = Instant::now();
    let status = Command::new(words[0])
        .args(&words[1..])
        .envs(env.iter().copied())
        .current_dir(root)
        .status();
    let seconds = begun.elapsed().as_secs_f64();
    TIMES.lock().map_err(|e| e.to_string())?.push((shown.clone(), seconds));
    match status {
        Ok(s) if s.success() => Ok(()),
        Ok(s) => Err(format!("`{shown}` failed: {s}")),
        Err(e) => Err(format!("`{shown}`: {e}")),
    }
}

/// Runs a test program of the workspace. All packages are named, so that dependencies have the
/// features that `cargo test --workspace` gives them and nothing is built twice.
pub fn test(root: &Path, name: &str, args: &[String], env: &[(&str, &str)]) -> Result<(), String> {
    let test = ["cargo", "test", "--release", "--workspace", "--test", name, "--"];
    let args = args.iter().map(String::as_str);
    command_with(root, &test.into_iter().chain(args).collect::<Vec<_>>(), env)
}

/// Cargo's target folder.
pub fn target_folder(root: &Path) -> std::path::PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), |dir| root.join(dir))
}

/// Prints that a check was skipped.
pub fn skipped(why: &str) {
    println!("SKIPPED: {why}");
}

/// Whether rustup has a target, or can install it.
pub fn has_target(target: &str) -> bool {
    Command::new("rustup").args(["target", "add", target]).status().is_ok_and(|s| s.success())
}

/// Output of a program, or why it failed: the last line that it printed.
pub fn output(command: &mut Command) -> Result<String, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.output().map_err(|e| format!("{name}: {e}"))?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).trim().to_owned();
    if output.status.success() {
        return Ok(text(&output.stdout));
    }
    let said = [text(&output.stderr), text(&output.stdout)].join("\n");
    let last = said.lines().map(str::trim).rfind(|line| !line.is_empty());
    Err(format!("{name}: {} ({})", last.unwrap_or("no word"), output.status))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_is_named() {
        let failed = output(Command::new("cargo").arg("no-such-command")).unwrap_err();
        assert!(failed.starts_with("cargo: ") && failed.len() > 20, "{failed}");
        let missing = output(&mut Command::new("no-such-program")).unwrap_err();
        assert!(missing.starts_with("no-such-program: "), "{missing}");
        assert!(output(Command::new("cargo").arg("--version")).unwrap().starts_with("cargo "));
    }
}
