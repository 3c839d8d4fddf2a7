//! The frames of a sequence: files, folders and patterns, in the order of the numbers in their
//! names; or one file of positions over time, with a mesh.

use super::files::has_extension;
use super::objects::{mesh_of, same_topology};
use super::{Failure, in_file};
use ccd::Mesh;
use ccd::io::{Frame, MESH_EXTENSIONS, PointCache, listed, mesh_format, read_frame, read_frame_as};
use std::path::{Path, PathBuf};

/// Source of frames.
pub enum Frames {
    /// A file each.
    Files(Vec<PathBuf>),
    /// All in one file, which has positions alone.
    Cache { mesh: Box<Frame>, cache: Box<PointCache>, path: PathBuf },
}

impl Frames {
    /// The frames that were asked for; the second part says whether files that are listed one by
    /// one are in another order than the numbers in their names.
    pub fn open(given: &[PathBuf], mesh: Option<&Path>) -> Result<(Self, bool), Failure> {
        if let [path] = given
            && has_extension(path, &PointCache::EXTENSIONS)
            && path.is_file()
        {
            let Some(mesh) = mesh else {
                return Err(in_file(
                    path,
                    "holds positions alone; --mesh says what they belong to",
                ));
            };
            let (cache, frame) = (PointCache::open(path)?, read_frame(mesh)?);
            if !frame.merged.is_empty() {
                let what = "merges vertices, so that positions over time do not belong to them; \
                            OBJ, OFF and PLY keep their numbers";
                return Err(in_file(mesh, what));
            }
            let (n, expected) = (cache.n_vertices(), frame.positions.len());
            if n != expected {
                let what = format!("has {n} vertices, {} has {expected}", mesh.display());
                return Err(in_file(path, what));
            }
            at_least_two(cache.n_frames()).map_err(|e| in_file(path, e))?;
            let (mesh, cache) = (Box::new(frame), Box::new(cache));
            return Ok((Self::Cache { mesh, cache, path: path.clone() }, false));
        }
        if let Some(missing) = given.iter().find(|path| {
            mesh.is_some() && has_extension(path, &PointCache::EXTENSIONS) && !path.exists()
        }) {
            return Err(in_file(missing, "there is no such file"));
        }
        if let Some(mesh) = mesh {
            let formats = listed(&PointCache::EXTENSIONS);
            let what = "is for one file of positions over time";
            return Err(Failure(format!("--mesh {} {what} ({formats})", mesh.display())));
        }
        let (files, is_unsorted) = expand(given)?;
        Ok((Self::Files(files), is_unsorted))
    }

    /// Number of frames.
    pub fn len(&self) -> usize {
        match self {
            Self::Files(files) => files.len(),
            Self::Cache { cache, .. } => cache.n_frames(),
        }
    }

    /// What a frame is called: its file, or its number in the file, counted from 0.
    pub fn name(&self, at: usize) -> PathBuf {
        match self {
            Self::Files(files) => files[at].clone(),
            Self::Cache { path, .. } => format!("{}[{at}]", path.display()).into(),
        }
    }

    /// The first frame of a part, and the mesh.
    pub fn first(&mut self, at: usize) -> Result<(Frame, Mesh), Failure> {
        let frame = match self {
            Self::Files(files) if at == 0 => read_frame(&files[0])?,
            Self::Files(files) => read_frame_as(&files[at], &read_frame(&files[0])?)?,
            Self::Cache { mesh, cache, .. } => {
                Frame { positions: cache.frame(at)?, ..Frame::clone(mesh) }
            }
        };
        let mesh = mesh_of(&self.name(at), &frame)?;
        Ok((frame, mesh))
    }

    /// The frame after `before`, which is that at `at - 1`; both have the same topology.
    pub fn next(&mut self, before: &Frame, at: usize) -> Result<Frame, Failure> {
        match self {
            Self::Files(files) => {
                let frame = read_frame_as(&files[at], before)?;
                same_topology((&files[at - 1], before), (&files[at], &frame))?;
                Ok(frame)
            }
            Self::Cache { cache, .. } => {
                Ok(Frame { positions: cache.frame(at)?, ..Frame::default() })
            }
        }
    }
}

/// Files in order: those of a folder or of a pattern (`frames/*.ply`, for shells that leave it
/// alone) by name, numbers in them as numbers, so that f2 comes before f10. Files that are listed
/// one by one stay as they are listed; the second part says whether that order is another one.
fn expand(given: &[PathBuf]) -> Result<(Vec<PathBuf>, bool), Failure> {
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
        if !path.is_file() {
            check_order(&found)?;
        }
        frames.append(&mut found);
    }
    at_least_two(frames.len()).map_err(|e| match given {
        [only] => in_file(only, e),
        _ => e,
    })?;
    let mut sorted = frames.clone();
    alphanumeric_sort::sort_path_slice(&mut sorted);
    let is_sorted = sorted == frames;
    Ok((frames, !is_sorted))
}

/// Refuses files of a folder or a pattern whose order their names do not tell for certain.
fn check_order(found: &[PathBuf]) -> Result<(), Failure> {
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let name = |path: &Path| path.with_extension("");
    if let Some(two) = found.windows(2).find(|two| name(&two[0]) == name(&two[1])) {
        let what = format!("and {} have one name: which is the frame?", two[1].display());
        return Err(in_file(&two[0], what));
    }
    // Digits as one letter, and how many there are behind a point.
    let mut fractions = std::collections::BTreeSet::new();
    let mut shapes = std::collections::BTreeSet::new();
    for path in found {
        let (mut shape, mut n) = (String::new(), 0);
        for c in stem(path).chars().chain([' ']) {
            match (c.is_ascii_digit(), n) {
                (true, 0) => shape.push('0'),
                (false, _) => {
                    if n > 0 && shape.ends_with("0.0") {
                        fractions.insert(n);
                    }
                    shape.push(c);
                }
                _ => {}
            }
            n = if c.is_ascii_digit() { n + 1 } else { 0 };
        }
        shapes.insert(shape);
    }
    let is_signed = shapes.iter().any(|shape| {
        let without = shape.replace("-0", "0");
        without != *shape && shapes.contains(&without)
    });
    let what = match (fractions.len() > 1, is_signed) {
        (true, _) => "numbers with a point, of different lengths",
        (_, true) => "numbers with and without a minus",
        _ => return Ok(()),
    };
    let name = found.first().map_or_else(Default::default, |path| path.display().to_string());
    Err(Failure(format!("{name} and the others: {what}; list the frames in their order")))
}

fn at_least_two(n: usize) -> Result<(), Failure> {
    match n {
        2.. => Ok(()),
        1 => Err(Failure("a sequence needs two frames or more; this is one".into())),
        _ => Err(Failure("a sequence needs two frames or more; this is none".into())),
    }
}

fn in_folder(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let entries = std::fs::read_dir(folder).map_err(|e| in_file(folder, e))?;
    let mut found = Vec::new();
    for entry in entries {
        let path = entry.map_err(|e| in_file(folder, e))?.path();
        if mesh_format(&path).is_some() {
            found.push(path);
        }
    }
    if found.is_empty() {
        let formats = listed(&MESH_EXTENSIONS);
        return Err(in_file(folder, format_args!("holds no mesh ({formats})")));
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

    #[test]
    fn an_order_that_names_do_not_tell_is_refused() {
        for (names, why) in [
            ("f0.ply f1.ply f10.ply", ""),
            ("frame.0.ply frame.10.ply", ""),
            ("t-0.05.ply t-0.10.ply", ""),
            ("a-1.ply a-2.ply", ""),
            ("t_0.05.ply t_0.1.ply", "with a point"),
            ("t0.ply t0.5.ply", ""),
            ("f-2.ply f-1.ply f0.ply f1.ply", "a minus"),
            ("f0.obj f0.ply f1.obj f1.ply", "one name"),
            ("0/mesh.ply 1/mesh.ply 2/mesh.ply", ""),
        ] {
            let mut found: Vec<_> = names.split(' ').map(PathBuf::from).collect();
            alphanumeric_sort::sort_path_slice(&mut found);
            match check_order(&found) {
                Ok(()) => assert_eq!(why, "", "{names}"),
                Err(Failure(what)) => assert!(!why.is_empty() && what.contains(why), "{what}"),
            }
        }
    }
}
