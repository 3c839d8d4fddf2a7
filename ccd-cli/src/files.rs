//! The files that commands write: opened before any work, `-` for standard output, and none that is
//! read or written otherwise. Each is written beside its place, and put there once it is whole.

use super::output::{ended, is_unread, unfinished};
use super::{Failure, in_file, interrupt};
use ccd::io::listed;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Whether the name of a file ends in one of these.
pub fn has_extension(path: &Path, extensions: &[&str]) -> bool {
    path.extension().is_some_and(|e| extensions.iter().any(|x| e.eq_ignore_ascii_case(x)))
}

/// Whether a path means standard input or output.
pub fn is_standard(path: &Path) -> bool {
    path == Path::new("-")
}

/// Creates a file whose name ends in one of these, or opens standard output for `-`.
pub fn create(path: &Path, extensions: &[&str]) -> Result<Output, Failure> {
    if is_standard(path) {
        return Ok(Output { to: Box::new(Standard), places: None });
    }
    if !has_extension(path, extensions) {
        return Err(in_file(path, format_args!("the name must end in {}", listed(extensions))));
    }
    Output::beside(path).map_err(|e| in_file(path, e))
}

/// A file that is in its place once it is done: until then what was there stays, and if it is never
/// done, nothing of it.
pub struct Output {
    to: Box<dyn Write>,
    /// Path of the unfinished file and its final path, if it is no stream.
    places: Option<[PathBuf; 2]>,
}

impl Output {
    /// For the file of this name.
    pub fn beside(path: &Path) -> io::Result<Self> {
        // So that there is somebody who ends with an error.
        interrupt::token();
        // What a link points to is replaced, and not the link.
        let place = target(path);
        let existing = fs::metadata(&place).ok();
        if existing.is_some() {
            // What must not be written is not replaced either.
            let to = File::options().write(true).open(&place)?;
            if !existing.as_ref().is_some_and(fs::Metadata::is_file) {
                return Ok(Self { to: Box::new(to), places: None });
            }
        }
        let name = place.file_name().ok_or(ErrorKind::IsADirectory)?.to_string_lossy();
        let mut attempt = 0;
        loop {
            let beside =
                place.with_file_name(format!(".{name}.{}-{attempt}.part", std::process::id()));
            // Before the file is there: whoever removes unfinished files knows of it.
            let mut files = unfinished();
            let created = File::options().write(true).create_new(true).open(&beside);
            match created {
                Err(e) if e.kind() == ErrorKind::AlreadyExists && attempt < 100 => attempt += 1,
                other => {
                    let to = other?;
                    files.push(beside.clone());
                    drop(files);
                    let allowed = existing.map(|of| to.set_permissions(of.permissions()));
                    let output = Self { to: Box::new(to), places: Some([beside, place]) };
                    return allowed.unwrap_or(Ok(())).map(|()| output);
                }
            }
        }
    }

    /// All was written.
    pub fn done(mut self) -> io::Result<()> {
        self.to.flush()?;
        if interrupt::happened() {
            return Err(ErrorKind::Interrupted.into());
        }
        // Closed first: elsewhere than on Unix what is open cannot be renamed.
        self.to = Box::new(io::sink());
        match &self.places {
            Some([beside, place]) => fs::rename(beside, place),
            None => Ok(()),
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.to.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

impl Drop for Output {
    fn drop(&mut self) {
        self.to = Box::new(io::sink());
        if let Some([beside, _]) = &self.places {
            // After it was renamed there is none.
            let _ = fs::remove_file(beside);
            unfinished().retain(|path| path != beside);
        }
    }
}

/// Standard output. A reader that goes away is no error while other work goes on.
struct Standard;

impl Write for Standard {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match io::stdout().write(bytes) {
            Err(e) if is_unread(&e) => Ok(bytes.len()),
            written => written,
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match io::stdout().flush() {
            Err(e) if is_unread(&e) => Ok(()),
            flushed => flushed,
        }
    }
}

/// Why something could not be written; ends the program where nobody reads standard output.
pub fn failed(path: &Path, e: std::io::Error) -> Failure {
    if is_standard(path) { ended(&e) } else { in_file(path, e) }
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
        if is_standard(path) {
            let this = format!("`{option} -`");
            if let Some(other) = on_stdout {
                return Err(Failure(format!("{other} and {this} both go to standard output")));
            }
            on_stdout = Some(this);
            continue;
        }
        let this = identity(path);
        if let Some((other, _)) = seen.iter().find(|(_, path)| *path == this) {
            return Err(in_file(path, format_args!("{other} and {option} would both write it")));
        }
        if read.contains(&this) {
            return Err(in_file(path, format_args!("is an input; {option} would overwrite it")));
        }
        seen.push((option, this));
    }
    Ok(())
}

/// The file that a path means: that to which links lead, whether it is there or not.
fn target(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| {
        let mut place = path.to_owned();
        // As many links as Linux follows.
        for _ in 0..40 {
            let Ok(next) = fs::read_link(&place) else { break };
            place = place.parent().unwrap_or(Path::new("")).join(next);
        }
        place
    })
}

/// A path by which files are compared; the file need not exist.
fn identity(path: &Path) -> PathBuf {
    let path = &target(path);
    let in_folder = || {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new(".")).canonicalize().ok()?;
        Some(folder.join(path.file_name()?))
    };
    path.canonicalize().ok().or_else(in_folder).unwrap_or_else(|| path.to_owned())
}
