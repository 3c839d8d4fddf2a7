//! Single queries decided exactly, one or many at once: the module `meshccd.exact`.

use crate::errors::refused;
use crate::hit::{MISS, state_number};
use crate::queries::{Answers, decide, queries};
use ccd::exact::{self, Exact};
use ccd::{EdgeEdge, Error, State, VertexEdge, VertexFace, VertexVertex};
use pyo3::prelude::*;

queries! {
    window: [f64; 2] = [0.0, 1.0], "(x0, x1, window=(0.0, 1.0))", window_of_times, numbered;

    /// Decides vertex-face queries exactly, of the coordinates as they are: a vertex `v` and a face
    /// `f0 f1 f2` that move on straight lines.
    ///
    /// Parameters
    /// ----------
    /// x0, x1 : (..., 4, 3) arrays
    ///     Positions of `v f0 f1 f2` at the start and at the end of the step; any number of axes
    ///     before, over queries.
    /// window : two floats
    ///     The times of the step that matter, by default all of it; closed.
    ///
    /// Returns
    /// -------
    /// state : (...) array of uint8
    ///     `State.MISS` or `State.HIT`.
    /// toi : (..., 2) array of float64
    ///     The time of the first contact, rounded down and up; infinity for a miss.
    ///
    /// Raises
    /// ------
    /// ValueError
    ///     If shapes do not fit, times are no window, or a number is not finite or beyond 1e100.
    ///     The error of a coordinate counts vertices through all queries, four each.
    exact_vertex_face: exact::vertex_face, VertexFace;

    /// Decides edge-edge queries exactly: as `vertex_face`, with positions of `ea0 ea1 eb0 eb1`.
    exact_edge_edge: exact::edge_edge, EdgeEdge;

    /// Decides vertex-edge queries exactly: as `vertex_face`, with positions `v e0 e1` of shape
    /// (..., 3, 3).
    exact_vertex_edge: exact::vertex_edge, VertexEdge;

    /// Decides vertex-vertex queries exactly: as `vertex_face`, with positions `v w` of shape
    /// (..., 2, 3).
    exact_vertex_vertex: exact::vertex_vertex, VertexVertex;
}

/// A window of time, checked.
fn window_of_times([from, until]: [f64; 2]) -> PyResult<[f64; 2]> {
    if 0.0 <= from && from <= until && until <= 1.0 {
        return Ok([from, until]);
    }
    Err(refused(Error::Window { from, until }))
}

fn numbered(answer: Option<Exact>, window: [f64; 2]) -> (u8, [f64; 2]) {
    match answer {
        Some(Exact::Miss) => (MISS, [f64::INFINITY; 2]),
        Some(Exact::Contact(toi)) => (state_number(State::Hit), toi),
        None => (state_number(State::Undecided), window),
    }
}
