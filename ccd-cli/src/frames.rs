//! The frames of a sequence: files, folders and patterns, in the order of the numbers in their
//! names.

use super::{Failure, in_file};
use std::path::{Path, PathBuf};

/// Kinds of files that hold a frame.
const EXTENSIONS: [&str; 2] = ["ply", "obj"];

/// Files in order: those of a folder or of a pattern (`frames/*.ply`, for shells that leave it
/// alone) by name, numbers in them as numbers, so that f2 comes before f10. Files that are listed
/// one by one stay as they are listed; the second part says whether that order is another one.
pub fn expand(given: &[PathBuf]) -> Result<(Vec<PathBuf>, bool), Failure> {
    let mut frames = Vec::new();
    for path in given {
        let mut found = if path.is_dir() {
            in_folder(path)?
        } else if path.exists() {
            vec![path.clone()]
        } else {
            of_pattern(path)?
        };
        alphanumeric_sort::sort_path_slice(&mut found);
        frames.append(&mut found);
    }
    if frames.len() < 2 {
        let n = frames.len();
        return Err(Failure(format!("a sequence needs two frames or more; there are {n}")));
    }
    let mut sorted = frames.clone();
    alphanumeric_sort::sort_path_slice(&mut sorted);
    let is_sorted = sorted == frames;
    Ok((frames, !is_sorted))
}

fn in_folder(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let entries = std::fs::read_dir(folder).map_err(|e| in_file(folder, e))?;
    let mut found = Vec::new();
    for entry in entries {
        let path = entry.map_err(|e| in_file(folder, e))?.path();
        let is_frame = |e: &std::ffi::OsStr| EXTENSIONS.iter().any(|x| e.eq_ignore_ascii_case(x));
        if path.extension().is_some_and(is_frame) {
            found.push(path);
        }
    }
    if found.is_empty() {
        return Err(in_file(folder, "holds no .ply or .obj file"));
    }
    Ok(found)
}

fn of_pattern(pattern: &Path) -> Result<Vec<PathBuf>, Failure> {
    let Some(text) = pattern.to_str().filter(|text| text.contains(['*', '?', '['])) else {
        return Err(in_file(pattern, "there is no such file"));
    };
    let paths = glob::glob(text).map_err(|e| in_file(pattern, e))?;
    let found: Result<Vec<PathBuf>, _> = paths.collect();
    let found = found.map_err(|e| in_file(pattern, e))?;
    if found.is_empty() {
        return Err(in_file(pattern, "no file fits this pattern"));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_names_are_numbers() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["f10.ply", "f2.ply", "f1.OBJ", "readme.txt"] {
            std::fs::write(folder.path().join(name), "").unwrap();
        }
        let names = |given: &[&str]| {
            let given: Vec<_> = given.iter().map(|name| folder.path().join(name)).collect();
            let (frames, warns) = expand(&given).map_err(|e| e.0).unwrap();
            let name = |path: &PathBuf| path.file_name().unwrap().to_str().unwrap().to_owned();
            (frames.iter().map(name).collect::<Vec<_>>().join(" "), warns)
        };
        assert_eq!(names(&[""]), ("f1.OBJ f2.ply f10.ply".into(), false));
        assert_eq!(names(&["*.ply"]), ("f2.ply f10.ply".into(), false));
        assert_eq!(names(&["f10.ply", "f2.ply"]), ("f10.ply f2.ply".into(), true));
        for bad in ["f3.ply", "*.stl", "f2.ply"] {
            assert!(expand(&[folder.path().join(bad)]).is_err(), "{bad}");
        }
    }
}
