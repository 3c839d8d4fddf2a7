//! Single queries decided exactly, one or many at once: the module `meshccd.exact`.

use crate::arrays::{Floats, numbers};
use crate::errors::{input, refused};
use crate::hit::{MISS, state_number};
use crate::queries::{check_shapes, points};
use ccd::exact::{self, Exact};
use ccd::{EdgeEdge, Error, State, VertexEdge, VertexFace, VertexVertex};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;

/// States and times of queries.
type Answers<'py> = (Bound<'py, PyArrayDyn<u8>>, Bound<'py, PyArrayDyn<f64>>);

/// A query of `N` points at both ends of a step, in a window of time.
type Query<const N: usize> = fn([[f64; 3]; N], [[f64; 3]; N], [f64; 2]) -> Option<Exact>;

/// Decides vertex-face queries exactly, of the coordinates as they are: a vertex `v` and a face
/// `f0 f1 f2` that move on straight lines.
///
/// Parameters
/// ----------
/// x0, x1 : (..., 4, 3) arrays
///     Positions of `v f0 f1 f2` at the start and at the end of the step; any number of axes
///     before, over queries.
/// window : (float, float)
///     The times of the step that matter, by default all of it; closed.
///
/// Returns
/// -------
/// state : (...) array of uint8
///     `State.MISS` or `State.HIT`; `State.UNDECIDED` only where coordinates are so unlike that
///     integers of 6,144 bits do not hold what comes of them.
/// toi : (..., 2) array of float64
///     The time of the first contact, rounded down and up; infinity for a miss. Of what is
///     undecided, the window.
///
/// Raises
/// ------
/// ValueError
///     If shapes do not fit, times are no window, or a number is not finite or beyond 1e100. The
///     error of a coordinate counts vertices through all queries, four each.
#[pyfunction]
#[pyo3(signature = (x0, x1, window=(0.0, 1.0)))]
#[pyo3(text_signature = "(x0, x1, window=(0.0, 1.0))")]
pub fn exact_vertex_face<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    window: (f64, f64),
) -> PyResult<Answers<'py>> {
    decide(x0, x1, window, |t0, t1, w| exact::vertex_face(&VertexFace { t0, t1 }, w))
}

/// Decides edge-edge queries exactly: as `vertex_face`, with positions of `ea0 ea1 eb0 eb1`.
#[pyfunction]
#[pyo3(signature = (x0, x1, window=(0.0, 1.0)))]
#[pyo3(text_signature = "(x0, x1, window=(0.0, 1.0))")]
pub fn exact_edge_edge<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    window: (f64, f64),
) -> PyResult<Answers<'py>> {
    decide(x0, x1, window, |t0, t1, w| exact::edge_edge(&EdgeEdge { t0, t1 }, w))
}

/// Decides vertex-edge queries exactly: as `vertex_face`, with positions `v e0 e1` of shape
/// (..., 3, 3).
#[pyfunction]
#[pyo3(signature = (x0, x1, window=(0.0, 1.0)))]
#[pyo3(text_signature = "(x0, x1, window=(0.0, 1.0))")]
pub fn exact_vertex_edge<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    window: (f64, f64),
) -> PyResult<Answers<'py>> {
    decide(x0, x1, window, |t0, t1, w| exact::vertex_edge(&VertexEdge { t0, t1 }, w))
}

/// Decides vertex-vertex queries exactly: as `vertex_face`, with positions `v w` of shape
/// (..., 2, 3).
#[pyfunction]
#[pyo3(signature = (x0, x1, window=(0.0, 1.0)))]
#[pyo3(text_signature = "(x0, x1, window=(0.0, 1.0))")]
pub fn exact_vertex_vertex<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    window: (f64, f64),
) -> PyResult<Answers<'py>> {
    decide(x0, x1, window, |t0, t1, w| exact::vertex_vertex(&VertexVertex { t0, t1 }, w))
}

fn decide<'py, const N: usize>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    (from, until): (f64, f64),
    query: Query<N>,
) -> PyResult<Answers<'py>> {
    let py = x0.py();
    let positions = Floats::new([("x0", x0), ("x1", x1)], &[N, 3])?;
    check_shapes(&positions)?;
    if !(0.0 <= from && from <= until && until <= 1.0) {
        return Err(refused(Error::Window { from, until }));
    }
    let ends = match &positions {
        Floats::F32([x0, x1]) => both(numbers(x0)?, numbers(x1)?),
        Floats::F64([x0, x1]) => both(numbers(x0)?, numbers(x1)?),
    };
    let ends = ends.map_err(input)?;
    let window = [from, until];
    let (state, toi): (Vec<u8>, Vec<[f64; 2]>) = py.detach(|| {
        let of = |end: usize| ends[end].as_chunks::<N>().0;
        let answers = of(0).iter().zip(of(1)).map(|(&t0, &t1)| query(t0, t1, window));
        let numbered = answers.map(|answer| match answer {
            Some(Exact::Miss) => (MISS, [f64::INFINITY; 2]),
            Some(Exact::Contact(toi)) => (state_number(State::Hit), toi),
            None => (state_number(State::Undecided), window),
        });
        numbered.unzip()
    });
    let shape = &positions.shape(0)[..positions.shape(0).len() - 2];
    Ok((
        PyArray1::from_vec(py, state).reshape(shape.to_vec())?,
        PyArray1::from_vec(py, toi.into_flattened()).reshape([shape, &[2]].concat())?,
    ))
}

/// Points at both ends in `f64`, in which every `f32` has its place.
fn both<T: Copy + Into<f64>>(x0: &[T], x1: &[T]) -> Result<[Vec<[f64; 3]>; 2], Error> {
    Ok([points(0, x0)?, points(1, x1)?])
}
