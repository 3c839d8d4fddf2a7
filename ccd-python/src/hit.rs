//! The first contact of a step, and how contacts are numbered in Python.

use crate::arrays::kind_of;
use crate::parts::result;
use ccd::State;
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

result! {
    /// The first contact of a step.
    Hit:
    /// Time of impact in [0, 1]; never late.
    toi: f64,
    /// Which features touch: a `Kind`.
    kind: u8,
    /// How certain it is: `State.HIT` or `State.UNDECIDED`.
    state: u8,
    /// Vertex and face, or the lesser and the greater edge.
    features: (u32, u32),
    /// The bodies of the features; both 0 without bodies.
    bodies: (u32, u32),
    /// Vertices, as a row of `Report.vertices`: (4,) uint32.
    vertices: Py<PyArray1<u32>>,
    /// Where they meet, (3,) float64.
    point: Py<PyArray1<f64>>,
    /// Unit vector from the second feature towards the first, (3,) float64.
    normal: Py<PyArray1<f64>>,
    /// Of each of the vertices, in the point of its feature: (4,) float64.
    weights: Py<PyArray1<f64>>,
    /// How far the features are apart at that time.
    distance: f64,
}

#[pymethods]
impl Hit {
    #[new]
    #[pyo3(signature = (**parts))]
    fn of_names(parts: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        Self::of_parts(parts)
    }

    /// All parts by their names.
    fn __getnewargs_ex__<'py>(of: &Bound<'py, Self>) -> PyResult<((), Bound<'py, PyDict>)> {
        Self::parts(of)
    }

    /// The normal that points towards `body`, away from what it touches: a new array.
    fn normal_towards<'py>(
        &self,
        py: Python<'py>,
        body: u32,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let (a, b) = self.bodies;
        let sign = if body == b && body != a { -1.0 } else { 1.0 };
        let normal = self.normal.bind(py).to_vec()?;
        Ok(PyArray1::from_iter(py, normal.into_iter().map(|c| sign * c)))
    }

    fn __repr__(&self) -> PyResult<String> {
        let ((a, b), toi) = (self.features, self.toi);
        Ok(format!("<Hit: {:?} {a} {b} at {toi}>", kind_of(self.kind)?))
    }
}

impl Hit {
    /// As Python has it.
    pub fn new(py: Python<'_>, hit: ccd::Hit) -> Self {
        let numbers = |of: &[f64]| PyArray1::from_slice(py, of).unbind();
        Self {
            toi: hit.toi,
            kind: hit.kind as u8,
            state: state_number(hit.state),
            features: hit.features.into(),
            bodies: hit.bodies.into(),
            vertices: PyArray1::from_slice(py, &hit.vertices).unbind(),
            point: numbers(&hit.point),
            normal: numbers(&hit.normal),
            weights: numbers(&hit.weights),
            distance: hit.distance,
        }
    }
}

/// The number of `State.MISS` in Python.
pub const MISS: u8 = 0;

/// The numbers of `State` in Python.
pub fn state_number(state: State) -> u8 {
    if state == State::Hit { 1 } else { 2 }
}
