//! Report of a step: arrays with one entry per contact.

use crate::arrays::rows;
use ccd::State;
use numpy::{PyArray1, PyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// What a step found: arrays with an entry for each contact, sorted by kind, then `a`, then `b`;
/// `len(report)` is their number.
#[pyclass(frozen, get_all, module = "meshccd")]
pub struct Report {
    /// Kind of each contact, uint8: `Kind.VERTEX_FACE`, `Kind.EDGE_EDGE`, and of particles and rods
    /// `Kind.VERTEX_EDGE`, `Kind.VERTEX_VERTEX`.
    kind: Py<PyArray1<u8>>,
    /// Vertex id, or the lesser edge id, of each contact, uint32.
    a: Py<PyArray1<u32>>,
    /// Face id, or the greater edge id, of each contact, uint32.
    b: Py<PyArray1<u32>>,
    /// Time of impact of each contact in [0, 1], float64; never late.
    toi: Py<PyArray1<f64>>,
    /// How certain each contact is, uint8: `State.HIT` or `State.UNDECIDED`.
    state: Py<PyArray1<u8>>,
    /// The vertices of each contact, (n, 4) uint32: `v f0 f1 f2`, or `ea0 ea1 eb0 eb1`; where there
    /// are fewer, the last one repeated.
    vertices: Py<PyArray2<u32>>,
    /// Least time of impact; None without contact.
    earliest_toi: Option<f64>,
    /// Numbers of candidates, pairs of features whose swept boxes overlap, of each kind in the
    /// order of `Kind`.
    n_candidates: (u64, u64, u64, u64),
    /// Number of contacts that are undecided.
    n_undecided: u64,
    /// Where the time went, in milliseconds, by name.
    times: Py<PyDict>,
}

#[pymethods]
impl Report {
    /// All columns but `vertices` in one new structured array, with the fields kind, a, b, toi,
    /// state.
    #[getter]
    fn contacts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let fields =
            [("kind", "u1"), ("a", "u4"), ("b", "u4"), ("toi", "f8"), ("state", "u1")].to_vec();
        let all = py.import("numpy")?.call_method1("empty", (self.toi.bind(py).len()?, fields))?;
        all.set_item("kind", &self.kind)?;
        all.set_item("a", &self.a)?;
        all.set_item("b", &self.b)?;
        all.set_item("toi", &self.toi)?;
        all.set_item("state", &self.state)?;
        Ok(all)
    }

    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        self.toi.bind(py).len()
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let n = self.toi.bind(py).len()?;
        let undecided = self.n_undecided;
        Ok(match self.earliest_toi {
            Some(toi) => {
                format!("<Report: {n} contacts, {undecided} undecided, earliest at {toi}>")
            }
            None => "<Report: no contact>".into(),
        })
    }
}

/// Columns of a report, made without the interpreter.
pub struct Columns {
    kind: Vec<u8>,
    a: Vec<u32>,
    b: Vec<u32>,
    toi: Vec<f64>,
    state: Vec<u8>,
    vertices: Vec<u32>,
    earliest_toi: Option<f64>,
    n_candidates: (u64, u64, u64, u64),
    n_undecided: u64,
    times: ccd::Times,
}

impl Columns {
    pub fn new(report: &ccd::Report, mesh: &ccd::Mesh) -> Self {
        let (contacts, n) = (&report.contacts, report.candidates);
        let vertices =
            contacts.iter().flat_map(|c| mesh.vertices_of(c.kind, ccd::Pair { a: c.a, b: c.b }));
        Self {
            kind: contacts.iter().map(|c| c.kind as u8).collect(),
            a: contacts.iter().map(|c| c.a).collect(),
            b: contacts.iter().map(|c| c.b).collect(),
            toi: contacts.iter().map(|c| c.toi).collect(),
            state: contacts.iter().map(|c| state_number(c.state)).collect(),
            vertices: vertices.collect(),
            earliest_toi: report.toi,
            n_candidates: (n.vf, n.ee, n.ve, n.vv),
            n_undecided: report.undecided,
            times: report.times,
        }
    }

    /// As Python's arrays, without a copy.
    pub fn into_report(self, py: Python<'_>) -> PyResult<Report> {
        let times = PyDict::new(py);
        let t = self.times;
        for (name, value) in [
            ("boxes", t.boxes),
            ("build", t.build),
            ("traverse", t.traverse),
            ("narrow", t.narrow),
            ("total", t.total),
        ] {
            times.set_item(name, value)?;
        }
        Ok(Report {
            kind: PyArray1::from_vec(py, self.kind).unbind(),
            a: PyArray1::from_vec(py, self.a).unbind(),
            b: PyArray1::from_vec(py, self.b).unbind(),
            toi: PyArray1::from_vec(py, self.toi).unbind(),
            state: PyArray1::from_vec(py, self.state).unbind(),
            vertices: rows::<4>(py, self.vertices)?.unbind(),
            earliest_toi: self.earliest_toi,
            n_candidates: self.n_candidates,
            n_undecided: self.n_undecided,
            times: times.unbind(),
        })
    }
}

/// The number of `State.MISS` in Python.
pub const MISS: u8 = 0;

/// The numbers of `State` in Python.
pub fn state_number(state: State) -> u8 {
    if state == State::Hit { 1 } else { 2 }
}
