//! Meshes and animations from files, by the readers of the command.

use crate::errors::refused;
use crate::mesh::Mesh;
use ccd::io::{PointCache, read_frame};
use numpy::{PyArray1, PyArray2, PyArray3, PyArrayMethods};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// Reads a mesh: OBJ, PLY, STL, OFF, glTF or GLB.
///
/// Parameters
/// ----------
/// path : str or path
///     The file. Its ending says what it is.
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
pub fn read_mesh(py: Python<'_>, path: PathBuf) -> PyResult<(Mesh, Bound<'_, PyArray2<f64>>)> {
    let (mesh, x) = py.detach(|| {
        let frame = read_frame(&path).map_err(refused)?;
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
///
/// Returns
/// -------
/// x : (n_frames, n_vertices, 3) array of float64
///
/// Raises
/// ------
/// ValueError
///     If the file cannot be read: what is wrong, and where.
#[pyfunction]
pub fn read_positions(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyArray3<f64>>> {
    let (all, shape) = py.detach(|| {
        let mut cache = PointCache::open(&path).map_err(refused)?;
        let shape = [cache.n_frames(), cache.n_vertices(), 3];
        let mut all = Vec::new();
        for at in 0..cache.n_frames() {
            all.extend(cache.frame(at).map_err(refused)?.into_flattened());
        }
        Ok::<_, PyErr>((all, shape))
    })?;
    PyArray1::from_vec(py, all).reshape(shape)
}
