//! Single queries, one or many at once.

use crate::arrays::{Floats, kind_of};
use crate::errors::{of_one, refused};
use crate::hit::{MISS, state_number};
use ccd::{Distance, EdgeEdge, Error, Kind, State, Verdict, VertexEdge, VertexFace, VertexVertex};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;

/// States and times of queries.
pub type Answers<'py> = (Bound<'py, PyArrayDyn<u8>>, Bound<'py, PyArrayDyn<f64>>);

/// Functions of Python over arrays of queries. All take the same limit of what is a contact, which
/// `$check` refuses or passes on; `$numbered` makes a state and times of an answer.
macro_rules! queries {
    ($limit:ident: $of:tt = $default:tt, $text:tt, $check:ident, $numbered:ident;
        $($(#[$doc:meta])* $name:ident: $query:path, $query_of:ident;)*) => {$(
        $(#[$doc])*
        #[pyfunction]
        #[pyo3(signature = (x0, x1, $limit = $default))]
        #[pyo3(text_signature = $text)]
        pub fn $name<'py>(
            x0: &Bound<'py, PyAny>,
            x1: &Bound<'py, PyAny>,
            $limit: $of,
        ) -> PyResult<Answers<'py>> {
            let limit = $check($limit)?;
            decide(x0, x1, |t0, t1| $numbered($query(&$query_of { t0, t1 }, limit), limit))
        }
    )*};
}
pub(crate) use queries;

queries! {
    min_distance: f64 = 0.0, "(x0, x1, min_distance=0.0)", distance_of_contact, numbered;

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
    ///     `State.MISS`, `State.HIT` or `State.UNDECIDED`; what is undecided is to be treated as a
    ///     hit.
    /// toi : (...) array of float64
    ///     Times of impact in [0, 1], never late; infinity for a miss.
    ///
    /// Raises
    /// ------
    /// ValueError
    ///     If shapes do not fit, or a number is not finite or beyond 1e100. The error of a
    ///     coordinate counts vertices through all queries, four each.
    vertex_face: ccd::vertex_face, VertexFace;

    /// Decides edge-edge queries: edges `ea0 ea1` and `eb0 eb1` that move on straight lines.
    ///
    /// Parameters, results and errors are those of `vertex_face`, with positions of
    /// `ea0 ea1 eb0 eb1`.
    edge_edge: ccd::edge_edge, EdgeEdge;

    /// Decides vertex-edge queries: a particle `v` and a rod `e0 e1` that move on straight lines.
    ///
    /// Parameters, results and errors are those of `vertex_face`, with positions `v e0 e1` of shape
    /// (..., 3, 3).
    vertex_edge: ccd::vertex_edge, VertexEdge;

    /// Decides vertex-vertex queries: two particles `v` and `w` that move on straight lines.
    ///
    /// Parameters, results and errors are those of `vertex_face`, with positions `v w` of shape
    /// (..., 2, 3).
    vertex_vertex: ccd::vertex_vertex, VertexVertex;
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
    let [all] = positions.points(py).map_err(|why| of_one(py, why))?;
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

/// A minimum distance, checked.
fn distance_of_contact(min_distance: f64) -> PyResult<f64> {
    if min_distance >= 0.0 && min_distance.is_finite() {
        return Ok(min_distance);
    }
    Err(refused(Error::MinDistance { value: min_distance }))
}

fn numbered(verdict: Verdict<f64>, _min_distance: f64) -> (u8, [f64; 1]) {
    match verdict {
        Verdict::Miss => (MISS, [f64::INFINITY]),
        Verdict::Hit { toi } => (state_number(State::Hit), [toi]),
        Verdict::Undecided { toi } => (state_number(State::Undecided), [toi]),
    }
}

/// States of queries of `N` points at both ends of a step, and `K` times of each.
pub fn decide<'py, const N: usize, const K: usize>(
    x0: &Bound<'py, PyAny>,
    x1: &Bound<'py, PyAny>,
    query: impl Fn([[f64; 3]; N], [[f64; 3]; N]) -> (u8, [f64; K]) + Sync,
) -> PyResult<Answers<'py>> {
    let py = x0.py();
    let positions = Floats::new([("x0", x0), ("x1", x1)], &[N, 3])?;
    let [shape, other] = [0, 1].map(|i| positions.shape(i));
    if shape != other {
        let why = format!("x0 has the shape {shape:?}, x1 has {other:?}; they must be the same");
        return Err(refused(why));
    }
    let [x0, x1] = positions.points(py)?;
    let (state, toi): (Vec<u8>, Vec<[f64; K]>) = py.detach(|| {
        let ends = x0.as_chunks::<N>().0.iter().zip(x1.as_chunks::<N>().0);
        ends.map(|(&t0, &t1)| query(t0, t1)).unzip()
    });
    let shape = shape[..shape.len() - 2].to_vec();
    let of_times = if K > 1 { [&shape[..], &[K]].concat() } else { shape.clone() };
    Ok((
        PyArray1::from_vec(py, state).reshape(shape)?,
        PyArray1::from_vec(py, toi.into_flattened()).reshape(of_times)?,
    ))
}
