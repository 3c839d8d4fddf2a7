//! Squared distances with derivatives, of one pair of features or of many.

use crate::arrays::{Floats, as_array, flat_ids};
use crate::errors::{of_one, refused};
use ccd::squared_distance::{EdgeEdgeType, SquaredDistance, VertexFaceType};
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;

/// Which parts of two features are nearest: the type of their distance.
///
/// Parameters
/// ----------
/// kind : Kind
///     `Kind.VERTEX_FACE` or `Kind.EDGE_EDGE`.
/// x : (..., 4, 3) array
///     Positions of `v f0 f1 f2`, or of `ea0 ea1 eb0 eb1`.
///
/// Returns
/// -------
/// types : (...) array of uint8
///     Numbers of `VertexFaceType` or of `EdgeEdgeType`.
///
/// Raises
/// ------
/// ValueError
///     If the shape does not fit, or a number is not finite or beyond 1e100.
#[pyfunction]
pub fn distance_type<'py>(kind: u8, x: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<u8>>> {
    let pairs = Pairs::new(kind, x, None)?;
    PyArray1::from_vec(x.py(), pairs.types).reshape(pairs.shape)
}

/// Squared distances of features at one moment.
///
/// Parameters
/// ----------
/// kind : Kind
///     `Kind.VERTEX_FACE` or `Kind.EDGE_EDGE`.
/// x : (..., 4, 3) array
///     Positions of `v f0 f1 f2`, or of `ea0 ea1 eb0 eb1`.
/// types : int or array of integers, optional
///     The type of each distance, of a shape that broadcasts to (...); by default that of
///     `distance_type`. A type that is given is the distance of the points, lines or plane that it
///     names, whether they are nearest or not.
///
/// Returns
/// -------
/// value : (...) array of float64
///     In the square of the unit of length.
///
/// Raises
/// ------
/// ValueError
///     If a shape does not fit, a type has no meaning, or a number is not finite or beyond 1e100.
#[pyfunction]
#[pyo3(signature = (kind, x, types=None))]
pub fn squared_distance<'py>(
    kind: u8,
    x: &Bound<'py, PyAny>,
    types: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    evaluate(kind, x, types, &[], |d, out| out.push(d.value()))
}

/// Gradients of squared distances: an array of shape (..., 12), by the coordinates of each vertex
/// in turn.
///
/// Parameters and errors are those of `squared_distance`.
#[pyfunction]
#[pyo3(signature = (kind, x, types=None))]
pub fn squared_distance_gradient<'py>(
    kind: u8,
    x: &Bound<'py, PyAny>,
    types: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    evaluate(kind, x, types, &[12], |d, out| out.extend(d.gradient()))
}

/// Hessians of squared distances: an array of shape (..., 12, 12), symmetric, by the coordinates of
/// each vertex in turn. They may have negative eigenvalues.
///
/// Parameters and errors are those of `squared_distance`.
#[pyfunction]
#[pyo3(signature = (kind, x, types=None))]
pub fn squared_distance_hessian<'py>(
    kind: u8,
    x: &Bound<'py, PyAny>,
    types: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    evaluate(kind, x, types, &[12, 12], |d, out| out.extend(d.hessian().as_flattened()))
}

/// Pairs of a kind, each with the number of its type.
struct Pairs {
    kind: u8,
    x: Vec<[f64; 3]>,
    types: Vec<u8>,
    /// The axes over pairs.
    shape: Vec<usize>,
}

impl Pairs {
    fn new(kind: u8, x: &Bound<'_, PyAny>, types: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let py = x.py();
        if kind > 1 {
            return Err(refused(format!("kind is {kind}; it must be 0 or 1, see Kind")));
        }
        let positions = Floats::new([("x", x)], &[4, 3])?;
        let [x] = positions.points(py).map_err(|why| of_one(py, why))?;
        let shape = positions.shape(0);
        let shape = shape[..shape.len() - 2].to_vec();
        let nearest = |at: &[[f64; 3]; 4]| match kind {
            0 => VertexFaceType::of(at) as u8,
            _ => EdgeEdgeType::of(at) as u8,
        };
        let types = match types {
            None => py.detach(|| x.as_chunks::<4>().0.iter().map(nearest).collect()),
            Some(given) => given_types(kind, given, &shape)?,
        };
        Ok(Self { kind, x, types, shape })
    }

    /// The distance of pair `i`, whose type is one of its kind.
    fn at(&self, i: usize) -> SquaredDistance {
        let (x, number) = (&self.x.as_chunks::<4>().0[i], self.types[i] as usize);
        match self.kind {
            0 => VertexFaceType::ALL[number].at(x),
            _ => EdgeEdgeType::ALL[number].at(x),
        }
    }
}

/// Types that the caller gives, one for each pair.
fn given_types(kind: u8, given: &Bound<'_, PyAny>, shape: &[usize]) -> PyResult<Vec<u8>> {
    let numpy = given.py().import("numpy")?;
    let given = as_array("types", given)?;
    let all = numpy.call_method1("broadcast_to", (given, shape.to_vec()))?;
    let n = [VertexFaceType::ALL.len(), EdgeEdgeType::ALL.len()][kind as usize];
    let number = |of_pair: u32| match u8::try_from(of_pair) {
        Ok(number) if (number as usize) < n => Ok(number),
        _ => Err(refused(format!("types has the entry {of_pair}; it must be below {n}"))),
    };
    flat_ids("types", &all.call_method0("ravel")?)?.into_iter().map(number).collect()
}

fn evaluate<'py>(
    kind: u8,
    x: &Bound<'py, PyAny>,
    types: Option<&Bound<'py, PyAny>>,
    of_each: &[usize],
    write: fn(&SquaredDistance, &mut Vec<f64>),
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let py = x.py();
    let pairs = Pairs::new(kind, x, types)?;
    let n = of_each.iter().product::<usize>() * pairs.types.len();
    let numbers = py.detach(|| {
        let mut out = Vec::with_capacity(n);
        (0..pairs.types.len()).for_each(|i| write(&pairs.at(i), &mut out));
        out
    });
    let shape = [&pairs.shape[..], of_each].concat();
    PyArray1::from_vec(py, numbers).reshape(shape)
}
