//! Readers of what the command takes: meshes (PLY, OBJ, OFF, STL, glTF; also by gzip), positions
//! over time (NPY, NPZ, PC2, MDD) and query files. Feature `io`. What is read of each format is
//! said in `docs/formats.md`.

mod gltf;
mod gltf_nodes;
mod input;
mod npy;
mod obj;
mod off;
mod ply;
mod point_cache;
mod queries;
mod stl;
mod weld;

pub use point_cache::PointCache;
pub use queries::{Queries, Query, read_queries, read_queries_of};

use crate::Mesh;
use input::Input;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Reads a mesh; the path is that of files beside it.
type Reader = fn(Input, &Path) -> Result<Frame, ReadErrorKind>;

/// Ends of names, and what reads such files.
const READERS: [(&str, Reader); 6] = [
    ("ply", ply::read),
    ("obj", obj::read),
    ("off", off::read),
    ("stl", stl::read),
    ("gltf", gltf::read),
    ("glb", gltf::read),
];

/// Ends of the names of files that [`read_frame`] reads.
pub const MESH_EXTENSIONS: [&str; READERS.len()] = {
    let mut all = [""; READERS.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = READERS[i].0;
        i += 1;
    }
    all
};

/// Ends of names as a text lists them: `.ply, .obj or .glb`.
///
/// ```
/// assert_eq!(ccd::io::listed(&["npy", "npz", "mdd"]), ".npy, .npz or .mdd");
/// ```
pub fn listed(extensions: &[&str]) -> String {
    let all: Vec<String> = extensions.iter().map(|end| format!(".{end}")).collect();
    match all.split_last() {
        Some((last, first)) if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        _ => all.concat(),
    }
}

/// One frame of a mesh as a file holds it.
///
/// ```
/// use ccd::io::Frame;
///
/// let positions = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.1]];
/// let frame = Frame { positions, faces: vec![[0, 1, 2]], ..Frame::default() };
/// assert_eq!(frame.mesh()?.edges().len(), 3);
/// assert_eq!(frame.positions_f32()[2], [0.0, 1.0, 0.1f32]);
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// Vertex positions in the file's unit, in the order of the file; every `float` is exact in
    /// `f64`.
    pub positions: Vec<[f64; 3]>,
    /// Triangles; polygons are cut into fans from their first vertex.
    pub faces: Vec<[u32; 3]>,
    /// Edges that the file lists besides its faces.
    pub edges: Vec<[u32; 2]>,
    /// For each triangle the face of the file that it is cut from, counted from 0.
    pub polygons: Vec<u32>,
    /// For each vertex that the file has, in its order, the vertex that it became; empty where none
    /// are merged.
    pub merged: Vec<u32>,
}

impl Frame {
    /// The topology of the frame.
    ///
    /// # Errors
    /// Those of [`Mesh::with_edges`].
    pub fn mesh(&self) -> Result<Mesh, crate::Error> {
        Mesh::with_edges(self.positions.len(), &self.faces, &self.edges)
    }

    /// Positions rounded to the nearest `f32`, as an engine stores them.
    pub fn positions_f32(&self) -> Vec<[f32; 3]> {
        self.positions.iter().map(|p| p.map(|x| x as f32)).collect()
    }

    /// Appends a polygon as a fan of triangles.
    fn push_polygon(&mut self, corners: &[u32]) {
        let polygon = self.polygons.last().map_or(0, |last| last + 1);
        for i in 1..corners.len() - 1 {
            self.faces.push([corners[0], corners[i], corners[i + 1]]);
            self.polygons.push(polygon);
        }
    }

    /// How many polygons of the file are not convex, as far as the triangles that they were cut
    /// into tell: those turn against each other, and are not the polygon's surface.
    pub fn folded_polygons(&self) -> usize {
        let normal = |face: &[u32; 3]| {
            let [a, b, c] = face.map(|v| self.positions[v as usize]);
            let [p, q] = [b, c].map(|end| [0, 1, 2].map(|k| end[k] - a[k]));
            [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
        };
        let folds = |p: [f64; 3], q: [f64; 3]| p[0] * q[0] + p[1] * q[1] + p[2] * q[2] < 0.0;
        let (mut folded, mut last) = (0, None);
        // The polygon of the triangle before, and its normal: one without area has none.
        let mut before = (None, [0.0; 3]);
        let triangles = self.polygons.iter().zip(self.faces.iter().map(normal));
        for (polygon, normal) in triangles.filter(|(_, normal)| *normal != [0.0; 3]) {
            let polygon = Some(*polygon);
            if polygon == before.0 && polygon != last && folds(before.1, normal) {
                (folded, last) = (folded + 1, polygon);
            }
            before = (polygon, normal);
        }
        folded
    }

    /// Refuses what no step takes, by the numbers of the file.
    fn check(&self) -> Result<(), ReadErrorKind> {
        let limit = crate::Error::MAX_COORDINATE;
        for (at, p) in self.positions.iter().enumerate() {
            // Written so that NaN fails.
            if let Some(axis) = (0..3).find(|&axis| !(p[axis].abs() <= limit)) {
                let (name, value) = (["x", "y", "z"][axis], p[axis]);
                let what = format!("{name} = {value}; it must be finite and at most {limit:e}");
                return Err(ReadErrorKind::Element { element: "vertex", at, what });
            }
        }
        let n = self.positions.len();
        let faces = self.faces.iter().zip(&self.polygons);
        let faces = faces.map(|(face, &at)| ("face", at as usize, &face[..]));
        let edges = self.edges.iter().enumerate().map(|(at, edge)| ("edge", at, &edge[..]));
        for (element, at, corners) in faces.chain(edges) {
            if let Some(v) = corners.iter().find(|&&v| v as usize >= n) {
                let what = format!("refers to vertex {v}; there are {n} vertices");
                return Err(ReadErrorKind::Element { element, at, what });
            }
        }
        Ok(())
    }
}

/// Why a file could not be read.
///
/// ```
/// let error = ccd::io::read_frame("nowhere.ply".as_ref()).unwrap_err();
/// assert!(error.to_string().starts_with("nowhere.ply: "));
/// ```
#[derive(Debug, thiserror::Error)]
#[error("{}: {kind}", path.display())]
pub struct ReadError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with it.
    pub kind: ReadErrorKind,
}

/// What is wrong with a file. Texts quote at most 200 characters of it.
///
/// ```
/// use ccd::io::{ReadErrorKind, read_frame};
///
/// let error = read_frame("mesh.doc".as_ref()).unwrap_err();
/// assert!(matches!(error.kind, ReadErrorKind::Extension { .. }));
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadErrorKind {
    /// It cannot be opened or read.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// Its name ends in nothing that is read.
    #[error("unknown kind of file; expected {}", listed(expected))]
    Extension {
        /// What it may end in, without the dot.
        expected: &'static [&'static str],
    },
    /// A line cannot be understood.
    #[error("line {line}: {what}")]
    Line {
        /// Line number from 1.
        line: usize,
        /// What is wrong there.
        what: String,
    },
    /// An element cannot be used.
    #[error("{element} {at} (counted from 0): {what}")]
    Element {
        /// `"vertex"`, `"face"`, `"edge"` or `"frame"`.
        element: &'static str,
        /// Index of the element from 0.
        at: usize,
        /// What is wrong there.
        what: String,
    },
    /// The header lacks something.
    #[error("header: {0}")]
    Header(String),
    /// The reader of the format stopped.
    #[error("{0}")]
    Format(String),
    /// The content is not a usable mesh.
    #[error("{0}")]
    Mesh(#[from] crate::Error),
}

/// Reads a mesh from a `.ply` file (ascii, binary of either byte order, any number type), an
/// `.obj`, `.off` or `.stl` file, or the scene of a `.gltf` or `.glb` file. A file that is
/// compressed by gzip is unpacked on the way, whether its name ends in `.gz` or not.
///
/// Vertices of STL and glTF files, which repeat a vertex for every triangle or normal, are merged
/// where they have exactly the same position (in glTF: within one node), and numbered as they first
/// appear.
///
/// ```no_run
/// use std::path::Path;
///
/// let before = ccd::io::read_frame(Path::new("before.ply"))?;
/// let after = ccd::io::read_frame(Path::new("after.ply.gz"))?;
/// let mut session = ccd::Session::new(before.mesh()?, ccd::Options::default())?;
/// println!("{:?}", session.earliest_toi(&before.positions, &after.positions)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the file and [`ReadErrorKind`] with what is wrong with it.
/// What cannot be understood is refused with its line or element, as is a coordinate that is not
/// finite or beyond [`crate::Error::MAX_COORDINATE`], or a face of a vertex that is not there.
pub fn read_frame(path: &Path) -> Result<Frame, ReadError> {
    let reader = mesh_format(path).ok_or(ReadErrorKind::Extension { expected: &MESH_EXTENSIONS });
    let frame = reader.and_then(|format| {
        let (input, head) = input::open(std::fs::File::open(path)?)?;
        read_as(format, input, &head, path)
    });
    frame.map_err(|kind| ReadError { path: path.to_owned(), kind })
}

/// Reads a mesh from a stream, such as standard input. `format` is one of [`MESH_EXTENSIONS`];
/// without it the first bytes say what the stream is. `name` is what errors call it; buffers of
/// glTF in files of their own are sought beside it.
///
/// ```
/// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
/// let frame = ccd::io::read_frame_from(text.as_bytes(), "a text".as_ref(), None)?;
/// assert_eq!(frame.faces, [[0, 1, 2]]);
/// # Ok::<(), ccd::io::ReadError>(())
/// ```
///
/// # Errors
/// As [`read_frame`].
pub fn read_frame_from(
    from: impl Read,
    name: &Path,
    format: Option<&str>,
) -> Result<Frame, ReadError> {
    let opened = input::open(from).map_err(ReadErrorKind::from);
    let frame = opened.and_then(|(input, head)| {
        let known = |format| MESH_EXTENSIONS.into_iter().find(|&known| known == format);
        let format = format.map_or(Some(input::format_of(&head)), known);
        let format = format.ok_or(ReadErrorKind::Extension { expected: &MESH_EXTENSIONS })?;
        read_as(format, input, &head, name)
    });
    frame.map_err(|kind| ReadError { path: name.to_owned(), kind })
}

/// Reads a format; `head` are the first bytes of the input, which has them still.
fn read_as(format: &str, input: Input, head: &[u8], path: &Path) -> Result<Frame, ReadErrorKind> {
    let reader = READERS.iter().find(|reader| reader.0 == format);
    let (_, read) = reader.ok_or(ReadErrorKind::Extension { expected: &MESH_EXTENSIONS })?;
    let foreign = |kind| input::foreign(head, format).map_or(kind, ReadErrorKind::Format);
    let frame = read(input, path).map_err(foreign)?;
    frame.check()?;
    if frame.positions.is_empty() {
        return Err(ReadErrorKind::Header("there are no vertices".into()));
    }
    Ok(frame)
}

/// The one of [`MESH_EXTENSIONS`] that the name of a file ends in, before an ending `.gz` if it has
/// one.
///
/// ```
/// assert_eq!(ccd::io::mesh_format("before.ply.GZ".as_ref()), Some("ply"));
/// assert_eq!(ccd::io::mesh_format("before.npy".as_ref()), None);
/// ```
pub fn mesh_format(path: &Path) -> Option<&'static str> {
    let end = match extension(path)?.as_str() {
        "gz" => extension(path.file_stem()?.as_ref())?,
        end => end.to_owned(),
    };
    MESH_EXTENSIONS.into_iter().find(|&format| format == end)
}

/// Reads another frame of the mesh of `first`, see [`Frame::merged_as`].
///
/// ```no_run
/// use ccd::io::{read_frame, read_frame_as};
///
/// let before = read_frame("before.stl".as_ref())?;
/// let after = read_frame_as("after.stl".as_ref(), &before)?;
/// assert_eq!(before.faces, after.faces);
/// # Ok::<(), ccd::io::ReadError>(())
/// ```
///
/// # Errors
/// As [`read_frame`] and [`Frame::merged_as`].
pub fn read_frame_as(path: &Path, first: &Frame) -> Result<Frame, ReadError> {
    let merged = read_frame(path)?.merged_as(first);
    merged.map_err(|kind| ReadError { path: path.to_owned(), kind })
}

/// What the name of a file ends in, in lower case.
fn extension(path: &Path) -> Option<String> {
    path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase())
}

/// As much of a file's text as fits into a message, without control characters: a terminal would
/// obey them.
fn quote(text: &str) -> String {
    let mut quoted = String::new();
    for c in text.chars().take(201) {
        match c.is_control() {
            true => quoted.extend(c.escape_debug()),
            false => quoted.push(c),
        }
    }
    let place = |n| quoted.char_indices().nth(n).map(|(at, _)| at);
    match (place(198), place(200)) {
        (Some(end), Some(_)) => format!("{}..", &quoted[..end]),
        _ => quoted,
    }
}

/// A number of a file.
fn number(word: &str) -> Result<f64, String> {
    let failed = |_| format!("`{}` is not a number{}", quote(word), of_comma(word));
    let x: f64 = word.parse().map_err(failed)?;
    if x.is_finite() { Ok(x) } else { Err(format!("`{}` is not a finite number", quote(word))) }
}

/// What to add to a message about text that has a comma where numbers have a point.
fn of_comma(text: &str) -> &'static str {
    let is_one = |word: &str| word.contains(',') && word.replace(',', ".").parse::<f64>().is_ok();
    if text.split_whitespace().any(is_one) { "; decimals are written with a point" } else { "" }
}
