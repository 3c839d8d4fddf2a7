//! NumPy arrays as slices. Rows of `float32` or `float64` that lie one behind the other are read
//! where they are; all else is copied, on purpose and once: Fortran order, strides, foreign byte
//! order, integers, lists. NumPy's word for "in one piece" is also true of Fortran order, whose
//! numbers lie in another sequence; so C order is asked for by name.

use crate::errors::{input, refused};
use ccd::{Error, Kind};
use numpy::{
    Element, PyArray1, PyArray2, PyArrayDescrMethods, PyArrayDyn, PyArrayMethods,
    PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods, dtype,
};
use pyo3::exceptions::PyException;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

/// `N` arrays of one precision: `float32` if all were, else `float64`.
pub enum Floats<'py, const N: usize> {
    F32([PyReadonlyArrayDyn<'py, f32>; N]),
    F64([PyReadonlyArrayDyn<'py, f64>; N]),
}

impl<'py, const N: usize> Floats<'py, N> {
    /// Arrays of numbers, each with its name and of any shape that ends in `last`.
    pub fn new(given: [(&str, &Bound<'py, PyAny>); N], last: &[usize]) -> PyResult<Self> {
        let mut arrays = Vec::with_capacity(N);
        for (name, any) in given {
            let array = as_array(name, any)?;
            if !array.shape().ends_with(last) {
                return Err(wrong_shape(name, "..", last, array.shape()));
            }
            arrays.push((name, array));
        }
        let single = arrays.iter().all(|(_, array)| is_single(array));
        Ok(if single { Self::F32(all(&arrays)?) } else { Self::F64(all(&arrays)?) })
    }

    /// The shape of the `i`-th.
    pub fn shape(&self, i: usize) -> &[usize] {
        match self {
            Self::F32(arrays) => arrays[i].shape(),
            Self::F64(arrays) => arrays[i].shape(),
        }
    }

    /// Points in `f64`, in which every `f32` has its place, checked.
    pub fn points(&self, py: Python<'_>) -> PyResult<[Vec<[f64; 3]>; N]> {
        let mut all = std::array::from_fn(|_| Vec::new());
        for (i, points_of) in all.iter_mut().enumerate() {
            *points_of = match self {
                Self::F32(arrays) => points(py, i as u8, numbers(&arrays[i])?)?,
                Self::F64(arrays) => points(py, i as u8, numbers(&arrays[i])?)?,
            };
        }
        Ok(all)
    }

    /// The same, if each has one axis before the last ones.
    pub fn in_rows(self, names: [&str; N], last: &[usize]) -> PyResult<Self> {
        for (i, name) in names.into_iter().enumerate() {
            if self.shape(i).len() != last.len() + 1 {
                return Err(wrong_shape(name, "n", last, self.shape(i)));
            }
        }
        Ok(self)
    }
}

/// The numbers of an array that [`Floats`] made, in C order.
pub fn numbers<'a, T: Element>(array: &'a PyReadonlyArrayDyn<'_, T>) -> PyResult<&'a [T]> {
    array.as_slice().map_err(refused)
}

fn points<T: Element + Copy + Into<f64>>(
    py: Python<'_>,
    time: u8,
    x: &[T],
) -> PyResult<Vec<[f64; 3]>> {
    let found = py.detach(|| {
        let points: Vec<[f64; 3]> =
            x.as_chunks::<3>().0.iter().map(|point| point.map(Into::into)).collect();
        let all = points.as_flattened();
        match all.iter().position(|c| !(c.abs() <= Error::MAX_COORDINATE)) {
            Some(at) => {
                let (vertex, axis, value) = (at / 3, (at % 3) as u8, all[at]);
                Err(Error::Coordinate { time, vertex, axis, value })
            }
            None => Ok(points),
        }
    });
    found.map_err(input)
}

/// Rows of `N` indices.
pub fn ids<const N: usize>(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<[u32; N]>> {
    let array = as_array(name, given)?;
    if array.len() == 0 {
        return Ok(Vec::new());
    }
    if array.ndim() != 2 || array.shape()[1] != N {
        return Err(wrong_shape(name, "n", &[N], array.shape()));
    }
    Ok(integers(name, &array)?.as_chunks().0.to_vec())
}

/// Indices in one row.
pub fn flat_ids(name: &str, given: &Bound<'_, PyAny>) -> PyResult<Vec<u32>> {
    let array = as_array(name, given)?;
    if array.ndim() != 1 {
        return Err(wrong_shape(name, "n", &[], array.shape()));
    }
    if array.len() == 0 { Ok(Vec::new()) } else { integers(name, &array) }
}

/// Truths in one row, one for each `of_what`.
pub fn flags(name: &str, given: &Bound<'_, PyAny>, of_what: &str) -> PyResult<Vec<bool>> {
    let array = as_array(name, given)?;
    if array.len() == 0 {
        return Ok(Vec::new());
    }
    let array = array.cast_into::<PyArray1<bool>>().map_err(|_| {
        refused(format!("{name} is not an array of bool with an entry for each {of_what}"))
    })?;
    Ok(array.try_readonly().map_err(refused)?.as_array().to_vec())
}

/// Pairs as an array of shape (n, 2), without a copy.
pub fn pair_array<'py>(py: Python<'py>, flat: Vec<u32>) -> PyResult<Bound<'py, PyArray2<u32>>> {
    rows::<2>(py, flat)
}

/// Numbers as rows of `N`, without a copy.
pub fn rows<const N: usize>(py: Python<'_>, flat: Vec<u32>) -> PyResult<Bound<'_, PyArray2<u32>>> {
    let n = flat.len() / N;
    PyArray1::from_vec(py, flat).reshape([n, N])
}

/// Whether numbers are of four bytes, in whatever order.
fn is_single(array: &Bound<'_, PyUntypedArray>) -> bool {
    let dtype = array.dtype();
    dtype.kind() == b'f' && dtype.itemsize() == 4
}

/// As NumPy sees it: an array as it is, one of another library by DLPack and without a copy, a list
/// as a new one.
pub fn as_array<'py>(
    name: &str,
    given: &Bound<'py, PyAny>,
) -> PyResult<Bound<'py, PyUntypedArray>> {
    if let Ok(array) = given.cast::<PyUntypedArray>() {
        if !array.is_exact_instance_of::<PyUntypedArray>() && array.hasattr("mask")? {
            return Err(refused(format!(
                "{name} is a masked array, whose masked entries would count"
            )));
        }
        return Ok(array.clone());
    }
    let numpy = given.py().import("numpy")?;
    let array = if given.hasattr("__dlpack__")? {
        numpy.call_method1("from_dlpack", (given,)).map_err(|why| {
            match why.is_instance_of::<PyException>(given.py()) {
                true => refused(format!("{name} cannot be read by DLPack: {why}")),
                // Such as KeyboardInterrupt.
                false => why,
            }
        })?
    } else {
        numpy.call_method1("asarray", (given,))?
    };
    Ok(array.cast_into()?)
}

fn all<'py, T: Element, const N: usize>(
    arrays: &[(&str, Bound<'py, PyUntypedArray>)],
) -> PyResult<[PyReadonlyArrayDyn<'py, T>; N]> {
    let read: Vec<_> =
        arrays.iter().map(|(name, array)| in_c_order(name, array)).collect::<PyResult<_>>()?;
    read.try_into().map_err(|_| refused("as many arrays as were given"))
}

/// The array itself if its numbers are a `T` each and lie in C order, else a copy of which that is
/// true.
fn in_c_order<'py, T: Element>(
    name: &str,
    array: &Bound<'py, PyUntypedArray>,
) -> PyResult<PyReadonlyArrayDyn<'py, T>> {
    let py = array.py();
    let wanted = dtype::<T>(py);
    let as_is = array.dtype().is_equiv_to(&wanted) && array.is_c_contiguous() && array.is_aligned();
    let array = if as_is { array.clone().into_any() } else { converted(name, array, wanted)? };
    array.cast_into::<PyArrayDyn<T>>()?.try_into_readonly().map_err(refused)
}

/// A copy in C order, of another type if each of its numbers has a place there.
fn converted<'py>(
    name: &str,
    array: &Bound<'py, PyUntypedArray>,
    wanted: impl std::fmt::Display + IntoPyObject<'py>,
) -> PyResult<Bound<'py, PyAny>> {
    let (py, text) = (array.py(), wanted.to_string());
    let how: Bound<'py, PyDict> = [("order", "C"), ("casting", "safe")].into_py_dict(py)?;
    how.set_item("subok", false)?;
    // NumPy takes rounding of these for safe.
    if text == "float64" && array.dtype().itemsize() == 8 && !array.is_empty() {
        let beyond = match array.dtype().kind() {
            b'u' => array.call_method0("max")?.extract::<u64>()? > 1 << 53,
            b'i' => {
                let least: i64 = array.call_method0("min")?.extract()?;
                let most: i64 = array.call_method0("max")?.extract()?;
                least < -(1 << 53) || most > 1 << 53
            }
            _ => false,
        };
        if beyond {
            return Err(refused(format!("{name} has integers beyond 2**53, which float64 rounds")));
        }
    }
    array.call_method("astype", (wanted,), Some(&how)).map_err(|_| {
        refused(format!("{name} is an array of {}, which {text} does not hold", array.dtype()))
    })
}

fn integers(name: &str, array: &Bound<'_, PyUntypedArray>) -> PyResult<Vec<u32>> {
    if !matches!(array.dtype().kind(), b'i' | b'u') {
        return Err(refused(format!("{name} is an array of {}, not of integers", array.dtype())));
    }
    if array.dtype().is_equiv_to(&dtype::<u32>(array.py())) {
        return Ok(numbers(&in_c_order::<u32>(name, array)?)?.to_vec());
    }
    // Whole numbers of any type as the widest ones; what is too large for those is negative then.
    let wide = array.call_method("astype", ("int64",), None)?.cast_into::<PyUntypedArray>()?;
    let wide = in_c_order::<i64>(name, &wide)?;
    let narrow = |&x: &i64| {
        u32::try_from(x).map_err(|_| {
            refused(format!("{name} has the entry {x}; it must be in 0 .. {}", u32::MAX))
        })
    };
    numbers(&wide)?.iter().map(narrow).collect()
}

fn wrong_shape(name: &str, first: &str, last: &[usize], found: &[usize]) -> PyErr {
    let text = |axes: &mut dyn Iterator<Item = String>| {
        let axes: Vec<String> = axes.collect();
        format!("({}{})", axes.join(", "), if axes.len() == 1 { "," } else { "" })
    };
    let mut wanted = std::iter::once(first.to_owned()).chain(last.iter().map(usize::to_string));
    let (wanted, found) = (text(&mut wanted), text(&mut found.iter().map(usize::to_string)));
    refused(format!("{name} has the shape {found}; it must be {wanted}"))
}

/// The kind of a number.
pub fn kind_of(kind: u8) -> PyResult<Kind> {
    let of_number = Kind::ALL.get(usize::from(kind)).copied();
    of_number.ok_or_else(|| refused(format!("kind is {kind}; it must be 0, 1, 2 or 3, see Kind")))
}
