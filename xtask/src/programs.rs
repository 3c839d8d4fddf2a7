//! Other programs that are run. What a machine may lack: a check that needs it is skipped there,
//! loudly and with the reason, never silently.

use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};
use std::sync::Mutex;
use std::time::Instant;

/// Commands that ran, and their seconds.
pub static TIMES: Mutex<Vec<(String, f64)>> = Mutex::new(Vec::new());

/// Runs a command in `root`, showing it; an error if it fails.
pub fn command(root: &Path, words: &[&str]) -> Result<(), String> {
    command_with(root, words, &[])
}

pub fn command_with(root: &Path, words: &[&str], env: &[(&str, &str)]) -> Result<(), String> {
    println!("$ {}", words.join(" "));
    let begun = Instant::now();
    timed(words, begun, prepared(root, words, env).status())
}

/// A command with its environment.
pub type Words<'a> = (Vec<&'a str>, Vec<(&'a str, &'a str)>);

/// Runs a command, and meanwhile others, one after another, up to one that fails. What the others
/// print is shown afterwards.
pub fn command_beside(root: &Path, own: &Words, others: &[Words]) -> Result<(), String> {
    let beside = || {
        let mut printed = String::new();
        let done = others.iter().try_for_each(|(words, env)| {
            printed += &format!("$ {}\n", words.join(" "));
            let begun = Instant::now();
            let status = status_and_output(prepared(root, words, env), &mut printed);
            timed(words, begun, status)
        });
        (printed, done)
    };
    let (own, (printed, others)) = std::thread::scope(|scope| {
        let others = scope.spawn(beside);
        let own = command_with(root, &own.0, &own.1);
        (own, others.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    });
    print!("{printed}");
    own.and(others)
}

fn prepared(root: &Path, words: &[&str], env: &[(&str, &str)]) -> Command {
    let mut command = Command::new(words[0]);
    command.args(&words[1..]).envs(env.iter().copied()).current_dir(root);
    command
}

/// Runs a command and appends what it prints.
fn status_and_output(mut command: Command, printed: &mut String) -> io::Result<ExitStatus> {
    let (mut reader, writer) = io::pipe()?;
    let mut child = command.stdout(writer.try_clone()?).stderr(writer).spawn()?;
    // Its ends of the pipe, without which reading ends when the child's are closed.
    drop(command);
    let mut bytes = Vec::new();
    reader.read_to_end(&mut bytes)?;
    *printed += &String::from_utf8_lossy(&bytes);
    child.wait()
}

/// Notes how long a command took that ends now; an error if it failed.
fn timed(words: &[&str], begun: Instant, status: io::Result<ExitStatus>) -> Result<(), String> {
    let (shown, seconds) = (words.join(" "), begun.elapsed().as_secs_f64());
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
pub fn target_folder(root: &Path) -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), |dir| root.join(dir))
}

/// A target folder besides cargo's, so that what is built there does not wait for other builds.
pub fn beside(root: &Path) -> PathBuf {
    target_folder(root).join("beside")
}

/// All files below a folder; a file itself.
pub fn files_below(path: &Path) -> Result<Vec<PathBuf>, String> {
    if !path.is_dir() {
        return Ok(vec![path.to_path_buf()]);
    }
    let failed = |e: io::Error| format!("{}: {e}", path.display());
    let mut files = Vec::new();
    for entry in std::fs::read_dir(path).map_err(failed)? {
        files.extend(files_below(&entry.map_err(failed)?.path())?);
    }
    Ok(files)
}

/// The Rust that is named by `rust-toolchain.toml` of a folder.
pub fn channel(folder: &Path) -> Result<String, String> {
    let path = folder.join("rust-toolchain.toml");
    let text = std::fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    let named = text.lines().find_map(|line| line.strip_prefix("channel = \"")?.strip_suffix('"'));
    named.map(str::to_owned).ok_or_else(|| format!("{}: no channel", path.display()))
}

/// A path as a word of a command.
pub fn text(path: &Path) -> Result<&str, String> {
    path.to_str().ok_or_else(|| format!("{}: not Unicode", path.display()))
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
    fn commands_beside_another_fail_like_it() {
        let run = |own: &str, other: &str| {
            let others = [(vec!["cargo", other], Vec::new())];
            command_beside(Path::new("."), &(vec!["cargo", own], Vec::new()), &others)
        };
        assert_eq!(run("--version", "--version"), Ok(()));
        for (own, other) in [("no-such-command", "--version"), ("--version", "no-such-command")] {
            let failed = run(own, other).unwrap_err();
            assert!(failed.starts_with("`cargo no-such-command` failed"), "{failed}");
        }
        let mut printed = String::new();
        let command = prepared(Path::new("."), &["cargo", "no-such-command"], &[]);
        assert!(!status_and_output(command, &mut printed).unwrap().success());
        assert!(printed.contains("no-such-command"), "{printed}");
    }

    #[test]
    fn what_is_missing_is_named() {
        let failed = output(Command::new("cargo").arg("no-such-command")).unwrap_err();
        assert!(failed.starts_with("cargo: ") && failed.len() > 20, "{failed}");
        let missing = output(&mut Command::new("no-such-program")).unwrap_err();
        assert!(missing.starts_with("no-such-program: "), "{missing}");
        assert!(output(Command::new("cargo").arg("--version")).unwrap().starts_with("cargo "));
    }
}
