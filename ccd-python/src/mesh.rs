//! Topology: faces, and the edges in a canonical order.

use crate::arrays::{ids, pair_array, rows};
use crate::errors::refused;
use numpy::PyArray2;
use pyo3::prelude::*;

/// The connectivity of a triangle mesh; it stays the same while vertices move.
///
/// Parameters
/// ----------
/// faces : (n, 3) array of integers
///     Vertex indices. May be empty.
/// edges : (n, 2) array of integers, optional
///     Edges that no face has (rods, wires) besides those of the faces.
/// n_vertices : int, optional
///     Number of vertices; by default the greatest index plus one. Needed if the last vertices are
///     in no face and no edge.
///
/// Raises
/// ------
/// ValueError
///     If an index is out of range, or there are more than 2^31 - 1 elements of a kind.
#[pyclass(frozen, module = "meshccd")]
pub struct Mesh {
    pub inner: ccd::Mesh,
}

#[pymethods]
impl Mesh {
    #[new]
    #[pyo3(signature = (faces, edges=None, *, n_vertices=None))]
    fn new(
        faces: &Bound<'_, PyAny>,
        edges: Option<&Bound<'_, PyAny>>,
        n_vertices: Option<usize>,
    ) -> PyResult<Self> {
        let py = faces.py();
        let faces = ids::<3>("faces", faces)?;
        let edges = edges.map_or(Ok(Vec::new()), |edges| ids::<2>("edges", edges))?;
        let last = faces.as_flattened().iter().chain(edges.as_flattened()).max();
        let n_vertices = n_vertices.unwrap_or_else(|| last.map_or(0, |&v| v as usize + 1));
        let inner = py.detach(|| ccd::Mesh::with_edges(n_vertices, &faces, &edges));
        Ok(Self { inner: inner.map_err(refused)? })
    }

    /// Number of vertices, also those in no face.
    #[getter]
    fn n_vertices(&self) -> usize {
        self.inner.n_vertices()
    }

    /// Faces as given: a new array of shape (n, 3), uint32.
    #[getter]
    fn faces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        rows::<3>(py, self.inner.faces().as_flattened().to_vec())
    }

    /// Undirected edges `[a, b]`, `a < b`, sorted by `b`, then by `a`: a new array of shape (n, 2),
    /// uint32. Ids of edges are rows of it.
    #[getter]
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        pair_array(py, self.inner.edges().as_flattened().to_vec())
    }

    fn __repr__(&self) -> String {
        let mesh = &self.inner;
        let (v, e, f) = (mesh.n_vertices(), mesh.edges().len(), mesh.faces().len());
        format!("<Mesh of {v} vertices, {e} edges, {f} faces>")
    }
}
