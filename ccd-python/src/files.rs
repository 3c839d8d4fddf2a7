//! Meshes and animations from files, by the readers of the command.

use crate::arrays::kind_of;
use crate::errors::refused;
use crate::mesh::Mesh;
use ccd::Kind;
use ccd::io::{self, PointCache, Query, read_frame, read_frame_as};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Reads a mesh: OBJ, PLY, STL, OFF, glTF or GLB.
///
/// Parameters
/// ----------
/// path : str or path
///     The file. Its ending says what it is.
/// first : str or path, optional
///     The file of the first frame, if this is a later one. Vertices of STL and glTF files, which
///     are merged where they have one position, are then merged as they are there.
///
/// Returns
/// -------
/// mesh : Mesh
///     Triangles, of which polygons are cut as fans, and edges that the file lists besides.
/// x : (n_vertices, 3) array of float64
///     Positions in the file's unit; vertices are in the order of the file.
///
/// Raises
/// ------
/// ValueError
///     If the file cannot be read: what is wrong, and where.
#[pyfunction]
#[pyo3(signature = (path, first=None))]
pub fn read_mesh(
    py: Python<'_>,
    path: PathBuf,
    first: Option<PathBuf>,
) -> PyResult<(Mesh, Bound<'_, PyArray2<f64>>)> {
    let (mesh, x) = py.detach(|| {
        let frame = match first {
            None => read_frame(&path),
            Some(first) => read_frame(&first).and_then(|first| read_frame_as(&path, &first)),
        };
        let frame = frame.map_err(refused)?;
        let mesh = frame.mesh().map_err(|why| refused(format!("{}: {why}", path.display())))?;
        Ok::<_, PyErr>((mesh, frame.positions))
    })?;
    let n = x.len();
    let x = PyArray1::from_vec(py, x.into_flattened()).reshape([n, 3])?;
    Ok((Mesh { inner: Arc::new(mesh) }, x))
}

/// Reads positions over time: NPY, NPZ, PC2 or MDD.
///
/// Parameters
/// ----------
/// path : str or path
///     The file. Its ending says what it is.
/// frames : (int, int), optional
///     The first frame to read, and the one behind the last; by default all of them.
///
/// Returns
/// -------
/// x : (n_frames, n_vertices, 3) array of float64
///
/// Raises
/// ------
/// ValueError
///     If the file cannot be read: what is wrong, and where; if it has not so many frames.
#[pyfunction]
#[pyo3(signature = (path, frames=None))]
pub fn read_positions(
    py: Python<'_>,
    path: PathBuf,
    frames: Option<[usize; 2]>,
) -> PyResult<Bound<'_, PyArray3<f64>>> {
    let (all, shape) = py.detach(|| {
        let mut cache = PointCache::open(&path).map_err(refused)?;
        let n = cache.n_frames();
        let [from, until] = frames.unwrap_or([0, n]);
        if from > until || until > n {
            return Err(refused(format!("frames from {from} to {until} of {n}")));
        }
        let shape = [until - from, cache.n_vertices(), 3];
        let mut all = Vec::new();
        for at in from..until {
            all.extend(cache.frame(at).map_err(refused)?.into_flattened());
        }
        Ok::<_, PyErr>((all, shape))
    })?;
    PyArray1::from_vec(py, all).reshape(shape)
}

/// Kinds, positions at both ends and answers of queries.
type Queries<'py> = (
    Bound<'py, PyArray1<u8>>,
    Bound<'py, PyArray3<f64>>,
    Bound<'py, PyArray3<f64>>,
    Option<Bound<'py, PyArray1<bool>>>,
);

/// Reads a file of queries: eight rows each, coordinates as fractions.
///
/// Parameters
/// ----------
/// path : str or path
///     The file.
/// kind : Kind, optional
///     `Kind.VERTEX_FACE` or `Kind.EDGE_EDGE`; by default the name of the file or of a folder tells
///     it.
///
/// Returns
/// -------
/// kind : (n,) array of uint8
/// x0, x1 : (n, 4, 3) arrays of float64
///     As `vertex_face` and `edge_edge` take them.
/// answers : (n,) array of bool, or None
///     Whether each is a contact, if the file says it.
///
/// Raises
/// ------
/// ValueError
///     If the file cannot be read: what is wrong, and where.
#[pyfunction]
#[pyo3(signature = (path, kind=None))]
pub fn read_queries(py: Python<'_>, path: PathBuf, kind: Option<u8>) -> PyResult<Queries<'_>> {
    let kind = kind.map(kind_of).transpose()?;
    let read = |path: &Path| match kind {
        Some(kind) => io::read_queries_of(path, kind),
        None => io::read_queries(path),
    };
    let io::Queries { queries, answers } = py.detach(|| read(&path)).map_err(refused)?;
    let (mut kinds, mut ends) = (Vec::new(), [Vec::new(), Vec::new()]);
    for query in &queries {
        let (kind, t0, t1) = match query {
            Query::VertexFace(of) => (Kind::VertexFace, of.t0, of.t1),
            Query::EdgeEdge(of) => (Kind::EdgeEdge, of.t0, of.t1),
        };
        kinds.push(kind as u8);
        ends[0].extend(t0.as_flattened());
        ends[1].extend(t1.as_flattened());
    }
    let [x0, x1] = ends.map(|x| PyArray1::from_vec(py, x).reshape([queries.len(), 4, 3]));
    let answers = (!answers.is_empty()).then(|| PyArray1::from_vec(py, answers));
    Ok((PyArray1::from_vec(py, kinds), x0?, x1?, answers))
}
