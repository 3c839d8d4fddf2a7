//! A callback that selects pairs: asked once a call, with arrays of all candidates.

use crate::arrays::pair_array;
use crate::errors::refused;
use ccd::Kind;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::IntoPyDict;

/// Pairs that a callback wants, sorted, by their kind.
pub struct Wanted([Vec<[u32; 2]>; 4]);

impl Wanted {
    /// Asks `callback(kind, pairs)` for each kind that has candidates, given one behind the other.
    pub fn new(py: Python<'_>, callback: &Py<PyAny>, candidates: [Vec<u32>; 4]) -> PyResult<Self> {
        let mut wanted: [Vec<[u32; 2]>; 4] = Default::default();
        for ((kind, pairs), wanted) in (0u8..).zip(candidates).zip(&mut wanted) {
            let pairs = pairs.as_chunks::<2>().0;
            if pairs.is_empty() {
                continue;
            }
            let array = pair_array(py, pairs.as_flattened().to_vec())?;
            let mask = callback.call1(py, (kind, array))?;
            let as_array = py.import("numpy")?.getattr("asarray")?;
            // One number behind the other, whatever it is a view of.
            let mask = as_array.call((mask,), Some(&[("order", "C")].into_py_dict(py)?))?;
            let Ok(mask) = mask.cast_into::<PyArray1<bool>>() else {
                return Err(refused("the filter must return a one-dimensional array of bool"));
            };
            let mask = mask.to_vec()?;
            if mask.len() != pairs.len() {
                let (n, found) = (pairs.len(), mask.len());
                return Err(refused(format!(
                    "the filter was asked of {n} pairs and returned {found} answers"
                )));
            }
            py.detach(|| {
                let all = pairs.iter().zip(mask);
                wanted.extend(all.filter(|(_, want)| *want).map(|(pair, _)| *pair));
                wanted.sort_unstable();
            });
        }
        Ok(Self(wanted))
    }

    /// Whether a pair is wanted. One that was no candidate of the whole step is no contact either.
    pub fn has(&self, kind: Kind, a: u32, b: u32) -> bool {
        self.0[kind as usize].binary_search(&[a, b]).is_ok()
    }
}
