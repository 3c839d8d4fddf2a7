//! Readers of what the command takes: meshes (PLY, OBJ) and query files. Feature `io`.

mod obj;
mod ply;
mod queries;

pub use queries::{Queries, Query, read_queries};

use crate::Mesh;
use std::path::{Path, PathBuf};

/// One frame of a mesh as a file holds it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frame {
    /// Vertex positions in the file's unit; every `float` is exact in `f64`.
    pub positions: Vec<[f64; 3]>,
    /// Triangles; polygons are cut into fans from their first vertex.
    pub faces: Vec<[u32; 3]>,
    /// Edges that the file lists besides its faces.
    pub edges: Vec<[u32; 2]>,
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

/// What is wrong with a file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ReadErrorKind {
    /// It cannot be opened or read.
    #[error("{0}")]
    Io(#[from] std::io::Error),
    /// Its name ends neither in `.ply` nor in `.obj`.
    #[error("unknown kind of file; expected .ply or .obj")]
    Extension,
    /// A line cannot be understood.
    #[error("line {line}: {what}")]
    Line {
        /// Line number from 1.
        line: usize,
        /// What is wrong there.
        what: String,
    },
    /// An element cannot be used.
    #[error("{element} {at}: {what}")]
    Element {
        /// `"vertex"`, `"face"` or `"edge"`.
        element: &'static str,
        /// Index of the element from 0.
        at: usize,
        /// What is wrong there.
        what: String,
    },
    /// The header lacks something.
    #[error("header: {0}")]
    Header(String),
    /// The PLY reader stopped.
    #[error("{0}")]
    Ply(#[from] ply_rs_bw::parser::ParseError),
    /// The content is not a usable mesh.
    #[error("{0}")]
    Mesh(#[from] crate::Error),
}

/// Reads a mesh from a `.ply` file (ascii, binary of either byte order, any number type) or an
/// `.obj` file.
///
/// ```no_run
/// use std::path::Path;
///
/// let before = ccd::io::read_frame(Path::new("before.ply"))?;
/// let after = ccd::io::read_frame(Path::new("after.ply"))?;
/// let mut session = ccd::Session::new(before.mesh()?, ccd::Options::default())?;
/// println!("{:?}", session.earliest_toi(&before.positions, &after.positions)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`ReadError`] with the file and [`ReadErrorKind`] with what is wrong with it.
pub fn read_frame(path: &Path) -> Result<Frame, ReadError> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
    let frame = match extension.as_deref() {
        Some("ply") => ply::read(path),
        Some("obj") => obj::read(path),
        _ => Err(ReadErrorKind::Extension),
    };
    frame.map_err(|kind| ReadError { path: path.to_owned(), kind })
}

/// Appends a polygon as a fan of triangles.
fn push_polygon(faces: &mut Vec<[u32; 3]>, corners: &[u32]) {
    faces.extend((1..corners.len() - 1).map(|i| [corners[0], corners[i], corners[i + 1]]));
}
