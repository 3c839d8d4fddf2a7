//! Single queries, one or many at once.

use crate::arrays::{Floats, numbers};
use crate::errors::refused;
use crate::report::{MISS, state_number};
use ccd::{EdgeEdge, Error, State, Verdict, VertexFace};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;

/// Times and states of queries.
type Answers<'py> = (Bound<'py, PyArrayDyn<u8>>, Bound<'py, PyArrayDyn<f64>>);

/// Decides vertex-face queries: a vertex `v` and a face `f0 f1 f2` that move on straight lines.
///
/// Parameters
/// ----------
/// x0, x1 : (..., 4, 3) arrays
///     Positions of `v f0 f1 f2` at the start and at the end of the step; any number of axes
///     before, over queries.
/// min_distance : float
///     Contact means a distance of at most this; 0 means touching.
///
/// Returns
/// -------
/// state : (...) array of uint8
///     `State.MISS`, `State.HIT` or `State.UNDECIDED`; what is undecided is to be treated as a hit.
/// toi : (...) array of float64
///     Times of impact in [0, 1], never late; infinity for a miss.
///
/// Raises
/// ------
/// ValueError
///     If shapes do not fit, or a number is not finite or beyond 1e100. The error of a coordinate
///     counts vertices through all queries, four each.
#[pyfunction]
#[pyo3(signature = (x0, x1, min_distance=0.0))]
pub fn vertex_face<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    min_distance: f64,
) -> PyResult<Answers<'py>> {
    decide(x0, x1, min_distance, |t0, t1, d| ccd::vertex_face(&VertexFace { t0, t1 }, d))
}

/// Decides edge-edge queries: edges `ea0 ea1` and `eb0 eb1` that move on straight lines.
///
/// Parameters, results and errors are those of `vertex_face`, with positions of `ea0 ea1 eb0 eb1`.
#[pyfunction]
#[pyo3(signature = (x0, x1, min_distance=0.0))]
pub fn edge_edge<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    min_distance: f64,
) -> PyResult<Answers<'py>> {
    decide(x0, x1, min_distance, |t0, t1, d| ccd::edge_edge(&EdgeEdge { t0, t1 }, d))
}

/// Four points at one time.
type Quad = [[f64; 3]; 4];

fn decide<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    min_distance: f64,
    query: fn(Quad, Quad, f64) -> Verdict<f64>,
) -> PyResult<Answers<'py>> {
    let py = x0.py();
    let positions = Floats::new([("x0", x0), ("x1", x1)], &[4, 3])?;
    if positions.shape(0) != positions.shape(1) {
        let [a, b] = [0, 1].map(|i| positions.shape(i));
        return Err(refused(format!(
            "x0 has the shape {a:?}, x1 has {b:?}; they must be the same"
        )));
    }
    if !(min_distance >= 0.0 && min_distance.is_finite()) {
        return Err(refused(Error::MinDistance { value: min_distance }));
    }
    let answers = match &positions {
        Floats::F32([x0, x1]) => {
            let (x0, x1) = (numbers(x0)?, numbers(x1)?);
            py.detach(|| all(x0, x1, min_distance, query))
        }
        Floats::F64([x0, x1]) => {
            let (x0, x1) = (numbers(x0)?, numbers(x1)?);
            py.detach(|| all(x0, x1, min_distance, query))
        }
    };
    let (state, toi) = answers.map_err(refused)?;
    let shape = &positions.shape(0)[..positions.shape(0).len() - 2];
    Ok((
        PyArray1::from_vec(py, state).reshape(shape.to_vec())?,
        PyArray1::from_vec(py, toi).reshape(shape.to_vec())?,
    ))
}

/// Decides all queries in `f64`, in which every `f32` has its place.
fn all<T: Copy + Into<f64>>(
    x0: &[T],
    x1: &[T],
    min_distance: f64,
    query: fn(Quad, Quad, f64) -> Verdict<f64>,
) -> Result<(Vec<u8>, Vec<f64>), Error> {
    let ends = [points(0, x0)?, points(1, x1)?];
    let quads = |end: usize| ends[end].as_chunks::<4>().0;
    let verdicts = quads(0).iter().zip(quads(1)).map(|(&t0, &t1)| query(t0, t1, min_distance));
    Ok(verdicts
        .map(|verdict| match verdict {
            Verdict::Miss => (MISS, f64::INFINITY),
            Verdict::Hit { toi } => (state_number(State::Hit), toi),
            Verdict::Undecided { toi } => (state_number(State::Undecided), toi),
        })
        .unzip())
}

/// Points in `f64`, checked.
fn points<T: Copy + Into<f64>>(time: u8, x: &[T]) -> Result<Vec<[f64; 3]>, Error> {
    let points: Vec<[f64; 3]> =
        x.as_chunks::<3>().0.iter().map(|point| point.map(Into::into)).collect();
    for (vertex, point) in points.iter().enumerate() {
        for (axis, &value) in point.iter().enumerate() {
            if !(value.abs() <= Error::MAX_COORDINATE) {
                return Err(Error::Coordinate { time, vertex, axis: axis as u8, value });
            }
        }
    }
    Ok(points)
}
