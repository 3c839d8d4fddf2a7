//! Single queries, one or many at once.

use crate::arrays::{Floats, kind_of, numbers};
use crate::errors::{input, of_one, refused};
use crate::hit::{MISS, state_number};
use ccd::{Distance, EdgeEdge, Error, Kind, State, Verdict, VertexEdge, VertexFace, VertexVertex};
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

/// Decides vertex-edge queries: a particle `v` and a rod `e0 e1` that move on straight lines.
///
/// Parameters, results and errors are those of `vertex_face`, with positions `v e0 e1` of shape
/// (..., 3, 3).
#[pyfunction]
#[pyo3(signature = (x0, x1, min_distance=0.0))]
pub fn vertex_edge<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    min_distance: f64,
) -> PyResult<Answers<'py>> {
    decide(x0, x1, min_distance, |t0, t1, d| ccd::vertex_edge(&VertexEdge { t0, t1 }, d))
}

/// Decides vertex-vertex queries: two particles `v` and `w` that move on straight lines.
///
/// Parameters, results and errors are those of `vertex_face`, with positions `v w` of shape
/// (..., 2, 3).
#[pyfunction]
#[pyo3(signature = (x0, x1, min_distance=0.0))]
pub fn vertex_vertex<'py>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    min_distance: f64,
) -> PyResult<Answers<'py>> {
    decide(x0, x1, min_distance, |t0, t1, d| ccd::vertex_vertex(&VertexVertex { t0, t1 }, d))
}

/// How far features are apart at one moment, between two bounds.
///
/// Parameters
/// ----------
/// kind : Kind
///     Which features.
/// x : (..., n, 3) array
///     Their positions: `v f0 f1 f2`, `ea0 ea1 eb0 eb1`, `v e0 e1` or `v w`; n is 4, 4, 3 or 2.
///
/// Returns
/// -------
/// least, greatest : (...) arrays of float64
///     The distance is certainly not below `least`, and not above `greatest`.
///
/// Raises
/// ------
/// ValueError
///     If the shape does not fit, or a number is not finite or beyond 1e100.
#[pyfunction]
pub fn distance<'py>(kind: u8, x: &Bound<'py, PyAny>) -> PyResult<Bounds<'py>> {
    match kind_of(kind)? {
        Kind::VertexFace => bounds(x, Distance::vertex_face),
        Kind::EdgeEdge => bounds(x, Distance::edge_edge),
        Kind::VertexEdge => bounds(x, Distance::vertex_edge),
        Kind::VertexVertex => bounds(x, Distance::vertex_vertex),
    }
}

/// Least and greatest distances.
type Bounds<'py> = (Bound<'py, PyArrayDyn<f64>>, Bound<'py, PyArrayDyn<f64>>);

fn bounds<'py, const N: usize>(
    x: &Bound<'py, PyAny>,
    distance: fn([[f64; 3]; N]) -> Distance,
) -> PyResult<Bounds<'py>> {
    let py = x.py();
    let positions = Floats::new([("x", x)], &[N, 3])?;
    let all = match &positions {
        Floats::F32([x]) => points(0, numbers(x)?),
        Floats::F64([x]) => points(0, numbers(x)?),
    };
    let all = all.map_err(|why| of_one(py, input(why)))?;
    let (least, greatest): (Vec<_>, Vec<_>) = py.detach(|| {
        let each = all.as_chunks::<N>().0.iter().map(|&at| distance(at));
        each.map(|found| (found.least, found.greatest)).unzip()
    });
    let shape = &positions.shape(0)[..positions.shape(0).len() - 2];
    Ok((
        PyArray1::from_vec(py, least).reshape(shape.to_vec())?,
        PyArray1::from_vec(py, greatest).reshape(shape.to_vec())?,
    ))
}

/// The greatest number that a float32 holds and that is not above a time of impact. A cast rounds
/// to the nearest, which may be later than the contact.
#[pyfunction]
pub fn toi_to_f32(toi: f64) -> f32 {
    ccd::toi_to_f32(toi)
}

/// A time of impact times a factor in [0, 1], rounded down: how far a step may go that keeps some
/// of the distance that is left.
#[pyfunction]
pub fn scaled_toi(toi: f64, factor: f64) -> f64 {
    ccd::scaled_toi(toi, factor)
}

/// The vector instructions that the CPU's path uses here, as "AVX2".
#[pyfunction]
pub fn instruction_set() -> &'static str {
    ccd::instruction_set()
}

/// A query of `N` points at both ends of a step, with a minimum distance.
type Query<const N: usize> = fn([[f64; 3]; N], [[f64; 3]; N], f64) -> Verdict<f64>;

fn decide<'py, const N: usize>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    min_distance: f64,
    query: Query<N>,
) -> PyResult<Answers<'py>> {
    let py = x0.py();
    let positions = Floats::new([("x0", x0), ("x1", x1)], &[N, 3])?;
    check_shapes(&positions)?;
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
    let (state, toi) = answers.map_err(input)?;
    let shape = &positions.shape(0)[..positions.shape(0).len() - 2];
    Ok((
        PyArray1::from_vec(py, state).reshape(shape.to_vec())?,
        PyArray1::from_vec(py, toi).reshape(shape.to_vec())?,
    ))
}

/// Refuses queries whose ends have different shapes.
pub fn check_shapes(positions: &Floats<'_, 2>) -> PyResult<()> {
    let [a, b] = [0, 1].map(|i| positions.shape(i));
    if a == b {
        return Ok(());
    }
    Err(refused(format!("x0 has the shape {a:?}, x1 has {b:?}; they must be the same")))
}

/// Decides all queries in `f64`, in which every `f32` has its place.
fn all<T: Copy + Into<f64>, const N: usize>(
    x0: &[T],
    x1: &[T],
    min_distance: f64,
    query: Query<N>,
) -> Result<(Vec<u8>, Vec<f64>), Error> {
    let ends = [points(0, x0)?, points(1, x1)?];
    let of = |end: usize| ends[end].as_chunks::<N>().0;
    let verdicts = of(0).iter().zip(of(1)).map(|(&t0, &t1)| query(t0, t1, min_distance));
    Ok(verdicts
        .map(|verdict| match verdict {
            Verdict::Miss => (MISS, f64::INFINITY),
            Verdict::Hit { toi } => (state_number(State::Hit), toi),
            Verdict::Undecided { toi } => (state_number(State::Undecided), toi),
        })
        .unzip())
}

/// Points in `f64`, checked.
pub fn points<T: Copy + Into<f64>>(time: u8, x: &[T]) -> Result<Vec<[f64; 3]>, Error> {
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
