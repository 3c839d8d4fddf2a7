//! Several objects in one check: their files, joined to one mesh of which each object is a body.

use super::{Failure, files, in_file, output};
use ccd::Mesh;
use ccd::io::{Frame, read_frame, read_frame_from};
use std::fmt::Debug;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// The files of an object at the start and at the end of the step; one if it stands still.
#[derive(Clone)]
pub struct Files {
    start: PathBuf,
    end: Option<PathBuf>,
}

impl Files {
    /// An object that moves from one file to another.
    pub fn moving(start: &Path, end: &Path) -> Self {
        Self { start: start.into(), end: Some(end.into()) }
    }

    /// What is read; `-` is standard input.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        [Some(&self.start), self.end.as_ref()].into_iter().flatten().map(PathBuf::as_path)
    }
}

impl FromStr for Files {
    type Err = String;

    /// A name, or two with a comma between them.
    fn from_str(text: &str) -> Result<Self, String> {
        let mut names = text.split(',').filter(|name| !name.is_empty()).map(PathBuf::from);
        let n = text.split(',').count();
        match [names.next(), names.next()] {
            [Some(start), end] if n == 1 + end.is_some() as usize => Ok(Self { start, end }),
            _ => Err("one file, or two with a comma between them".into()),
        }
    }
}

/// Objects, and the frames that they are joined to.
pub struct Objects {
    files: Vec<Files>,
    /// Vertices and triangles before each object, and of all.
    before: Vec<[usize; 2]>,
    pub start: Frame,
    pub end: Frame,
}

impl Objects {
    /// Reads all files and joins them in their order. `format`: that of standard input, if it is
    /// not told by its first bytes.
    pub fn read(mut files: Vec<Files>, format: Option<&str>) -> Result<Self, Failure> {
        let streams = files.iter().flat_map(Files::paths).filter(|path| files::is_standard(path));
        match streams.count() {
            0 if format.is_some() => {
                return Err(Failure("--format is that of standard input; no file is `-`".into()));
            }
            0 | 1 => {}
            _ => return Err(Failure("`-` is given twice; standard input has one mesh".into())),
        }
        let read = |path: &mut PathBuf| -> Result<Frame, Failure> {
            if path.is_dir() {
                return Err(in_file(path, "is a folder; `ccd sequence` takes the frames in it"));
            }
            if !files::is_standard(path) {
                return Ok(read_frame(path)?);
            }
            *path = "standard input".into();
            Ok(read_frame_from(std::io::stdin().lock(), path, format)?)
        };
        let (start, end) = (Frame::default(), Frame::default());
        let mut all = Self { files: Vec::new(), before: vec![[0; 2]], start, end };
        for files in &mut files {
            let start = read(&mut files.start)?;
            mesh_of(&files.start, &start)?;
            notice_folded(&files.start, &start);
            if let Some(path) = &mut files.end {
                let end = read(path)?.merged_as(&start).map_err(|e| in_file(path, e))?;
                same_topology((&files.start, &start), (path, &end))?;
                append(&mut all.end, &end);
            } else {
                append(&mut all.end, &start);
            }
            append(&mut all.start, &start);
            all.before.push([all.start.positions.len(), all.start.faces.len()]);
        }
        all.files = files;
        Ok(all)
    }

    /// The files of the first object, as they are called in what is said of them.
    pub fn first(&self) -> Vec<&Path> {
        self.files[0].paths().collect()
    }

    /// The object of each vertex, and whether each stands still; `None` of one object.
    pub fn bodies(&self) -> Option<(Vec<u32>, Vec<bool>)> {
        let objects = (0..).zip(self.before.windows(2));
        let of_object =
            |(object, n): (u32, &[[usize; 2]])| std::iter::repeat_n(object, n[1][0] - n[0][0]);
        let of_vertex = objects.flat_map(of_object).collect();
        let fixed = self.files.iter().map(|files| files.end.is_none()).collect();
        (self.files.len() > 1).then_some((of_vertex, fixed))
    }

    /// The file that has a vertex at the start or at the end, and its number there.
    pub fn place(&self, end: bool, vertex: usize) -> (&Path, usize) {
        let object = self.before.partition_point(|before| before[0] <= vertex) - 1;
        let Files { start, end: other } = &self.files[object];
        let path = other.as_ref().filter(|_| end).unwrap_or(start);
        (path, vertex - self.before[object][0])
    }

    /// What moves; of several objects a line for each: its body, its files, its numbers in what is
    /// reported.
    pub fn print(&self) {
        if let [Files { start, end: Some(end) }] = &self.files[..] {
            let both = self.start.positions.iter().zip(&self.end.positions);
            let n = both.clone().filter(|(x0, x1)| x0 != x1).count();
            let (start, end) = (start.display(), end.display());
            output::line(
                "motion",
                format!("{start} to {end}: {n} of {} vertices move", both.len()),
            );
        }
        if self.files.len() == 1 {
            return;
        }
        for (body, files) in self.files.iter().enumerate() {
            let [[v, f], [v_end, f_end]] = [self.before[body], self.before[body + 1]];
            let name = match &files.end {
                Some(end) => format!("{} to {}", files.start.display(), end.display()),
                None => format!("{}, fixed", files.start.display()),
            };
            let faces = match f_end - f {
                0 => String::new(),
                _ => format!(", faces {f} to {}", f_end - 1),
            };
            let what = format!("{body}: {name}: vertices {v} to {}{faces}", v_end - 1);
            output::line(if body == 0 { "bodies" } else { "" }, what);
        }
    }
}

/// Adds a mesh behind those that are there.
fn append(all: &mut Frame, more: &Frame) {
    let n = all.positions.len() as u32;
    all.positions.extend_from_slice(&more.positions);
    all.faces.extend(more.faces.iter().map(|face| face.map(|v| v + n)));
    all.edges.extend(more.edges.iter().map(|edge| edge.map(|v| v + n)));
    // As in their own file.
    all.polygons.extend_from_slice(&more.polygons);
}

/// Says where polygons are not the surface of the triangles that they are cut into.
pub fn notice_folded(path: &Path, frame: &Frame) {
    let n = frame.folded_polygons();
    if n > 0 {
        let plural = if n == 1 { " is" } else { "s are" };
        let what =
            format!("polygon{plural} not convex: triangles that they are cut into leave them");
        output::notice!("{}: {n} {what}", path.display());
    }
}

/// An error that names the first difference in topology.
pub fn same_topology(a: (&Path, &Frame), b: (&Path, &Frame)) -> Result<(), Failure> {
    let ((path_a, a), (path_b, b)) = (a, b);
    let counts = [
        ("vertices", a.positions.len(), b.positions.len()),
        ("faces", a.faces.len(), b.faces.len()),
        ("edges", a.edges.len(), b.edges.len()),
    ];
    for (what, n_a, n_b) in counts {
        if n_a != n_b {
            return Err(in_file(
                path_b,
                format_args!(
                    "has {n_b} {what}, {} has {n_a}: all frames must have the same vertices and \
                     faces (to add another object, use `ccd check --with`)",
                    path_a.display()
                ),
            ));
        }
    }
    let other = other("triangle", &a.faces, &b.faces).or(other("edge", &a.edges, &b.edges));
    other.map_or(Ok(()), |(what, [x, y])| {
        let path_a = path_a.display();
        Err(in_file(path_b, format_args!("{what} is {y}, in {path_a} it is {x}")))
    })
}

/// The first element that two frames do not share: its name, and its vertices in each.
fn other<T: PartialEq + Debug>(name: &str, a: &[T], b: &[T]) -> Option<(String, [String; 2])> {
    let i = a.iter().zip(b).position(|(a, b)| a != b)?;
    Some((format!("{name} {i} (counted from 0)"), [&a[i], &b[i]].map(|v| format!("{v:?}"))))
}

/// The mesh of a frame with the path in its errors.
pub fn mesh_of(path: &Path, frame: &Frame) -> Result<Mesh, Failure> {
    frame.mesh().map_err(|e| in_file(path, e))
}
