//! The frames of a sequence: files, folders and patterns, in the order of the numbers in their
//! names; or one file of positions over time, with a mesh.

use super::files::has_extension;
use super::objects::{mesh_of, same_topology};
use super::{Failure, in_file};
use ccd::Mesh;
use ccd::io::{Frame, MESH_EXTENSIONS, PointCache, listed, mesh_format, read_frame, read_frame_as};
use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
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
                return Err(in_file(path, "has positions only: name their mesh by --mesh"));
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
            let what = "needs one file of positions over time";
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
/// one by one stay as they are listed; the second part says whether their numbers are out of order.
/// In a folder, names that begin with a point are those of hidden files, which are no frames.
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
        sort(&mut found);
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
    sort(&mut sorted);
    let is_sorted = sorted == frames || !differ_in_numbers_alone(&frames);
    Ok((frames, !is_sorted))
}

/// Whether names are the same but for the numbers in them.
fn differ_in_numbers_alone(paths: &[PathBuf]) -> bool {
    let letters = |path: &PathBuf| path.to_string_lossy().replace(|c: char| c.is_ascii_digit(), "");
    let mut all = paths.iter().map(letters);
    let first = all.next();
    all.all(|other| Some(&other) == first.as_ref())
}

/// Sorts by name, numbers in names as numbers, whatever the encoding of the names: the crate's
/// functions for paths do not know numbers in names that are not UTF-8.
fn sort(paths: &mut [PathBuf]) {
    paths.sort_by(|a, b| {
        let order = alphanumeric_sort::compare_str(a.to_string_lossy(), b.to_string_lossy());
        order.then_with(|| a.cmp(b))
    });
}

/// What names of one series may not differ in, and how it is taken away.
type Form = (&'static str, fn(&str) -> String);

const FORMS: [Form; 4] = [
    ("letters in upper and lower case", |shape| shape.to_lowercase()),
    ("numbers with a comma and with a point", |shape| shape.replace(',', ".")),
    ("numbers with and without a minus", |shape| shape.replace("-0", "0")),
    ("numbers with and without a digit before the point", |shape| shape.replace("0.0", ".0")),
];

/// Refuses files of a folder or a pattern whose order their names do not tell for certain.
fn check_order(found: &[PathBuf]) -> Result<(), Failure> {
    let mut names = BTreeMap::new();
    for path in found {
        if let Some(other) = names.insert(name(path), path) {
            let what = format!("and {} have one name: which is the frame?", path.display());
            return Err(in_file(other, what));
        }
    }
    // Folders that all are in tell no order.
    let is_common = |folder: &&Path| found.iter().all(|path| path.starts_with(folder));
    let folders = found.first().and_then(|path| path.ancestors().skip(1).find(is_common));
    // Digits as one letter, and how many there are behind a point.
    let (mut fractions, mut shapes) = (BTreeSet::new(), BTreeSet::new());
    for path in names.keys() {
        let (mut shape, mut n) = (String::new(), 0);
        let path = folders.and_then(|folders| path.strip_prefix(folders).ok()).unwrap_or(path);
        for c in path.to_string_lossy().chars().chain([' ']) {
            match (c.is_ascii_digit(), n) {
                (true, 0) => shape.push('0'),
                (false, _) => {
                    if n > 0 && (shape.ends_with("0.0") || shape.ends_with("0,0")) {
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
    let refused = |what: &str| {
        let name = found.first().map_or_else(Default::default, |path| path.display().to_string());
        Err(Failure(format!("{name} and the others: {what}; list the frames in their order")))
    };
    if fractions.len() > 1 {
        return refused("numbers with a point or a comma, of different lengths");
    }
    let has_exponent = |shape: &String| {
        let shape = shape.to_lowercase();
        shape.contains("0e-0") || shape.contains("0e+0")
    };
    if shapes.iter().any(has_exponent) {
        return refused("numbers with an exponent");
    }
    for (what, without) in FORMS {
        let fewer: BTreeSet<String> = shapes.iter().map(|shape| without(shape)).collect();
        if fewer.len() < shapes.len() {
            return refused(what);
        }
        shapes = fewer;
    }
    Ok(())
}

/// A path without the ending that names its format, and without `.gz`.
fn name(path: &Path) -> PathBuf {
    let is_packed = has_extension(path, &["gz"]);
    let unpacked = if is_packed { path.with_extension("") } else { path.to_owned() };
    unpacked.with_extension("")
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
        let is_hidden = |name: &OsStr| name.as_encoded_bytes().starts_with(b".");
        if mesh_format(&path).is_some() && !path.file_name().is_some_and(is_hidden) {
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

    #[cfg(unix)]
    #[test]
    fn names_need_not_be_utf_8() {
        use std::os::unix::ffi::OsStrExt;
        let path = |name: &[u8]| PathBuf::from(std::ffi::OsStr::from_bytes(name));
        let sorted = [&b"M\xfcller/f2.ply"[..], b"M\xfcller/f10.ply"].map(path);
        let mut found = sorted.clone();
        found.reverse();
        sort(&mut found);
        assert_eq!(found, sorted);
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
            ("f0.obj f0.obj.gz f1.obj", "one name"),
            ("f0.obj f0.old.obj f0.ply", "one name"),
            ("f0.obj f1.obj.gz f2.ply.GZ", ""),
            ("0/mesh.ply 1/mesh.ply 2/mesh.ply", ""),
            ("t_0.05/mesh.ply t_0.1/mesh.ply", "with a point"),
            ("t_9e-05.ply t_0.0001.ply t_1e-04.ply", "an exponent"),
            ("t_1E+5.ply t_2E+5.ply", "an exponent"),
            ("s01e05.ply s01e06.ply", ""),
            ("of_1e-06/0.05/f0.ply of_1e-06/0.05/f1.ply", ""),
            ("t0,5.ply t0,25.ply", "a comma"),
            ("t0,5.ply t0.7.ply", "with a comma"),
            ("t0.5.ply t.75.ply", "before the point"),
            ("F1.ply f2.ply F3.ply", "upper and lower case"),
        ] {
            let mut found: Vec<_> = names.split(' ').map(PathBuf::from).collect();
            sort(&mut found);
            match check_order(&found) {
                Ok(()) => assert_eq!(why, "", "{names}"),
                Err(Failure(what)) => assert!(!why.is_empty() && what.contains(why), "{what}"),
            }
        }
    }
}
