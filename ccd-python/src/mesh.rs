//! Topology: faces, and the edges in a canonical order.

use crate::arrays::{Floats, ids, kind_of, pair_array, rows};
use crate::errors::{input, of_one, refused};
use ccd::{Exclusions, Kind, Pair};
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};
use std::sync::Arc;

/// Pairs of vertex and face, and of edges.
type PairLists<'py> = (Bound<'py, PyArray2<u32>>, Bound<'py, PyArray2<u32>>);
/// Arguments by place and by name.
type NewArgs<'py> = (PairLists<'py>, Bound<'py, PyDict>);

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
    pub inner: Arc<ccd::Mesh>,
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
        Ok(Self { inner: Arc::new(inner.map_err(refused)?) })
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

    /// Vertices of no edge, the particles: a new array of shape (n,), uint32, sorted.
    #[getter]
    fn isolated_vertices<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        PyArray1::from_slice(py, self.inner.isolated_vertices())
    }

    /// The vertices of pairs of features, ids of shape (n, 2), of one `Kind`: an array of shape
    /// (n, 4), uint32, as `Report.vertices`.
    fn vertices_of<'py>(
        &self,
        kind: u8,
        pairs: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let (py, kind, mesh) = (pairs.py(), kind_of(kind)?, &self.inner);
        let (v, e, f) = (mesh.n_vertices(), mesh.edges().len(), mesh.faces().len());
        let counts = match kind {
            Kind::VertexFace => [v, f],
            Kind::EdgeEdge => [e, e],
            Kind::VertexEdge => [v, e],
            Kind::VertexVertex => [v, v],
        };
        let pairs = ids::<2>("pairs", pairs)?;
        let beyond = |pair: &&[u32; 2]| (0..2).any(|i| pair[i] as usize >= counts[i]);
        if let Some([a, b]) = pairs.iter().find(beyond) {
            let [n, m] = counts;
            return Err(refused(format!(
                "pairs has the entry [{a}, {b}]; there are {n} and {m} such features"
            )));
        }
        let vertices = pairs.iter().flat_map(|&[a, b]| mesh.vertices_of(kind, Pair { a, b }));
        rows::<4>(py, vertices.collect())
    }

    /// Pairs of features that at most `rings` edges join, to be excluded where a distance is kept
    /// that is larger than the edges: arrays of shape (n, 2), uint32, of vertex and face, and of
    /// two edges.
    fn neighbours<'py>(&self, py: Python<'py>, rings: u32) -> PyResult<PairLists<'py>> {
        pair_lists(py, py.detach(|| Exclusions::of_neighbours(&self.inner, rings)))
    }

    /// Pairs of features without a common vertex that are at most `distance` apart at the positions
    /// `x`, as `neighbours` returns them.
    fn near_at_rest<'py>(&self, x: &Bound<'py, PyAny>, distance: f64) -> PyResult<PairLists<'py>> {
        let py = x.py();
        let positions = Floats::new([("x", x)], &[3])?.in_rows(["x"], &[3])?;
        let near = positions.points(py).and_then(|[x]| {
            py.detach(|| ccd::near_at_rest(&self.inner, &x, distance)).map_err(input)
        });
        pair_lists(py, near.map_err(|why| of_one(py, why))?)
    }

    /// What a copy is made of.
    fn __getnewargs_ex__<'py>(&self, py: Python<'py>) -> PyResult<NewArgs<'py>> {
        let more = [("n_vertices", self.n_vertices())].into_py_dict(py)?;
        Ok(((self.faces(py)?, self.edges(py)?), more))
    }

    fn __repr__(&self) -> String {
        let mesh = &self.inner;
        let (v, e, f) = (mesh.n_vertices(), mesh.edges().len(), mesh.faces().len());
        format!("<Mesh of {v} vertices, {e} edges, {f} faces>")
    }
}

fn pair_lists(py: Python<'_>, lists: Exclusions) -> PyResult<PairLists<'_>> {
    let array = |pairs: Vec<[u32; 2]>| pair_array(py, pairs.into_flattened());
    Ok((array(lists.vf)?, array(lists.ee)?))
}
