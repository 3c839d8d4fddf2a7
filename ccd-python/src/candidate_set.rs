//! Candidates that serve many steps.

use crate::arrays::{Floats, numbers, pair_array};
use crate::errors::failed;
use crate::process::Guarded;
use ccd::Kind;
use numpy::PyArray2;
use pyo3::prelude::*;

/// Candidates of a step, for all steps near it: those of a line search. `Session.candidate_set`
/// makes one, with the options, bodies and filter that the session has.
///
/// It holds for steps whose vertices are, at both ends, at most `inflation` outside of the box
/// around their two positions of the step that it was made for, along each axis, and what rounding
/// may add where a part of that step is taken. Others are refused.
#[pyclass(frozen, module = "meshccd")]
pub struct CandidateSet {
    inner: Guarded<ccd::CandidateSet>,
}

impl CandidateSet {
    /// A set that serves this process.
    pub fn new(inner: ccd::CandidateSet) -> Self {
        Self { inner: Guarded::new("set of candidates", inner) }
    }

    fn pairs<'py>(&self, py: Python<'py>, kind: Kind) -> PyResult<Bound<'py, PyArray2<u32>>> {
        pair_array(py, self.inner.with(py, |set| Ok(flat(set, kind)))?)
    }
}

/// The pairs of a kind, one behind the other.
pub fn flat(set: &ccd::CandidateSet, kind: Kind) -> Vec<u32> {
    set.pairs(kind).iter().flat_map(|pair| [pair.a, pair.b]).collect()
}

#[pymethods]
impl CandidateSet {
    /// Vertex and face: a new array of shape (n, 2), uint32.
    #[getter]
    fn vf<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        self.pairs(py, Kind::VertexFace)
    }

    /// Two edges, the lesser id first: a new array of shape (n, 2), uint32.
    #[getter]
    fn ee<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        self.pairs(py, Kind::EdgeEdge)
    }

    /// Particle and rod: a new array of shape (n, 2), uint32.
    #[getter]
    fn ve<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        self.pairs(py, Kind::VertexEdge)
    }

    /// Two particles, the lesser id first: a new array of shape (n, 2), uint32.
    #[getter]
    fn vv<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<u32>>> {
        self.pairs(py, Kind::VertexVertex)
    }

    /// How far vertices may be outside of the step that the candidates were found for.
    #[getter]
    fn inflation(&self, py: Python<'_>) -> PyResult<f64> {
        self.inner.with(py, |set| Ok(set.inflation()))
    }

    /// The earliest time of impact of a step, never late; None if all of it is free.
    ///
    /// Raises
    /// ------
    /// ValueError
    ///     If a vertex is beyond what the set holds for, and what `Session.step` refuses.
    /// RuntimeError
    ///     If the token that the session had when the set was made is cancelled.
    fn earliest_toi(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Option<f64>> {
        let positions = Floats::new([("x0", x0), ("x1", x1)], &[3])?.in_rows(["x0", "x1"], &[3])?;
        match &positions {
            Floats::F32([x0, x1]) => {
                let [x0, x1] = [numbers(x0)?, numbers(x1)?].map(|x| x.as_chunks().0);
                self.inner
                    .with(py, |set| set.earliest_toi(x0, x1).map_err(|why| failed(why.into())))
            }
            Floats::F64([x0, x1]) => {
                let [x0, x1] = [numbers(x0)?, numbers(x1)?].map(|x| x.as_chunks().0);
                self.inner
                    .with(py, |set| set.earliest_toi(x0, x1).map_err(|why| failed(why.into())))
            }
        }
    }

    /// The part of a step that is free of contact, in [0, 1]; errors are those of `earliest_toi`.
    fn collision_free_stepsize(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<f64> {
        Ok(self.earliest_toi(py, x0, x1)?.unwrap_or(1.0))
    }

    /// Whether nothing touches during a step, both ends included. False if that could not be
    /// certified; errors are those of `earliest_toi`.
    fn is_step_collision_free(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<bool> {
        Ok(self.earliest_toi(py, x0, x1)?.is_none())
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let n: usize = self
            .inner
            .with(py, |set| Ok(Kind::ALL.into_iter().map(|kind| set.pairs(kind).len()).sum()))?;
        Ok(format!("<CandidateSet of {n} pairs>"))
    }
}
