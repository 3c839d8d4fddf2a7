//! The files that commands write: opened before any work, `-` for standard output, and none that is
//! read or written otherwise.

use super::output::ended;
use super::{Failure, in_file};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Refuses a path that ends otherwise than in what is written to it.
fn check_extension(path: &Path, extension: &str) -> Result<(), Failure> {
    if path.extension().is_some_and(|e| e.eq_ignore_ascii_case(extension)) {
        return Ok(());
    }
    Err(in_file(path, format_args!("is written as .{extension}; a name that ends so is expected")))
}

/// Whether a path means standard output.
pub fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// Creates a file, or opens standard output for `-`.
pub fn create(path: &Path, extension: &str) -> Result<Box<dyn Write>, Failure> {
    if is_stdout(path) {
        return Ok(Box::new(std::io::stdout()));
    }
    check_extension(path, extension)?;
    Ok(Box::new(File::create(path).map_err(|e| in_file(path, e))?))
}

/// Looks whether a file can be created, which is done once there is something to write: until then
/// what an earlier run wrote stays.
pub fn open(path: &Path, extension: &str) -> Result<(), Failure> {
    if is_stdout(path) {
        return Ok(());
    }
    check_extension(path, extension)?;
    let opened = File::options().write(true).create(true).truncate(false).open(path);
    opened.map(drop).map_err(|e| in_file(path, e))
}

/// Why something could not be written; ends the program where nobody reads standard output.
pub fn failed(path: &Path, e: std::io::Error) -> Failure {
    if is_stdout(path) { ended(&e) } else { in_file(path, e) }
}

/// Refuses outputs that would lie over each other or over what is read, before one of them is
/// opened. `json`: the option by which JSON is printed; `written`: options and their paths.
pub fn check(
    json: Option<&str>,
    written: &[(&str, Option<&Path>)],
    read: &[&Path],
) -> Result<(), Failure> {
    let mut seen: Vec<(&str, PathBuf)> = Vec::new();
    let read: Vec<PathBuf> = read.iter().map(|path| identity(path)).collect();
    let mut on_stdout = json.map(str::to_owned);
    for &(option, path) in written {
        let Some(path) = path else { continue };
        if is_stdout(path) {
            let this = format!("`{option} -`");
            if let Some(other) = on_stdout {
                return Err(Failure(format!("{other} and {this} both go to standard output")));
            }
            on_stdout = Some(this);
            continue;
        }
        let this = identity(path);
        if let Some((other, _)) = seen.iter().find(|(_, path)| *path == this) {
            return Err(in_file(path, format_args!("{other} and {option} both write it")));
        }
        if read.contains(&this) {
            return Err(in_file(path, format_args!("is read; {option} would write over it")));
        }
        seen.push((option, this));
    }
    Ok(())
}

/// What two paths of one file have in common, whether it is there or not.
fn identity(path: &Path) -> PathBuf {
    let in_folder = || {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new(".")).canonicalize().ok()?;
        Some(folder.join(path.file_name()?))
    };
    path.canonicalize().ok().or_else(in_folder).unwrap_or_else(|| path.to_owned())
}
