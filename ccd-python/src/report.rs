//! Report of a step: arrays with one entry per contact.

use crate::arrays::{kind_of, rows};
use crate::errors::refused;
use crate::geometry::{Contacts, Geometry};
use crate::hit::state_number;
use crate::mesh::Mesh;
use crate::parts::result;
use ccd::method::{FrontCounts, TriangleCounts};
use ccd::{Options, PerKind};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

result! {
    /// What a step found: arrays with an entry for each contact, sorted by kind, then `a`, then
    /// `b`; `len(report)` is their number.
    ///
    /// Sessions make reports, and pickle makes copies.
    Report:
    /// Kind of each contact, uint8: `Kind.VERTEX_FACE`, `Kind.EDGE_EDGE`, and of particles and rods
    /// `Kind.VERTEX_EDGE`, `Kind.VERTEX_VERTEX`.
    kind: Py<PyArray1<u8>>,
    /// The vertex of a vertex-face or vertex-edge pair, else the lesser edge or vertex, uint32.
    a: Py<PyArray1<u32>>,
    /// The face or edge that the vertex `a` touches, else the greater edge or vertex, uint32.
    b: Py<PyArray1<u32>>,
    /// Time of impact of each contact in [0, 1], float64; never late.
    toi: Py<PyArray1<f64>>,
    /// How certain each contact is, uint8: `State.HIT` or `State.UNDECIDED`.
    state: Py<PyArray1<u8>>,
    /// Whether features come nearer at the time of impact, uint8: an `Approach`.
    approach: Py<PyArray1<u8>>,
    /// The vertices of each contact, (n, 4) uint32: `v f0 f1 f2`, or `ea0 ea1 eb0 eb1`; where there
    /// are fewer, the last one repeated.
    vertices: Py<PyArray2<u32>>,
    /// Least time of impact; None without contact.
    earliest_toi: Option<f64>,
    /// Numbers of candidates, pairs of features whose swept boxes overlap, of each kind in the
    /// order of `Kind`.
    n_candidates: (u64, u64, u64, u64),
    /// Numbers of candidates that the filters left open, as `n_candidates`.
    n_filtered: (u64, u64, u64, u64),
    /// Number of contacts that are undecided.
    n_undecided: u64,
    /// Figures of pairs of triangles, by name; None but with the pipeline "triangles".
    triangles: Option<Py<PyDict>>,
    /// Figures of the front, by name; None without one.
    front: Option<Py<PyDict>>,
    /// Whether trees were built anew rather than refitted.
    rebuilt: bool,
    /// Where the time went, in milliseconds, by name.
    times: Py<PyDict>,
    /// Least time of impact of each world of the session's bodies, float64; infinity where there is
    /// no contact. None without bodies.
    toi_of_worlds: Option<Py<PyArray1<f64>>>,
    /// The mesh of the step.
    mesh: Py<Mesh>,
}

#[pymethods]
impl Report {
    #[new]
    #[pyo3(signature = (**parts))]
    fn new(parts: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        Self::of_parts(parts)
    }

    /// All parts by their names.
    fn __getnewargs_ex__<'py>(of: &Bound<'py, Self>) -> PyResult<((), Bound<'py, PyDict>)> {
        Self::parts(of)
    }

    /// Numbers of contacts of each kind in the order of `Kind`.
    #[getter]
    fn n_contacts(&self, py: Python<'_>) -> PyResult<(u64, u64, u64, u64)> {
        let mut n = [0; 4];
        for &kind in self.kind.bind(py).try_readonly().map_err(refused)?.as_array() {
            n[kind_of(kind)? as usize] += 1;
        }
        Ok(n.into())
    }

    /// Points, normals and weights of all contacts, from the positions of the step.
    fn geometry(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Geometry> {
        let ids = (self.a.bind(py), self.b.bind(py));
        let what = (self.kind.bind(py), self.state.bind(py));
        let contacts = Contacts::new(what, ids, self.toi.bind(py))?;
        contacts.geometry(py, &self.mesh.get().inner, [x0, x1])
    }

    /// One new structured array with the fields kind, a, b, toi, state: all columns but `vertices`
    /// and `approach`.
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
    approach: Vec<u8>,
    vertices: Vec<u32>,
    earliest_toi: Option<f64>,
    n_candidates: PerKind,
    n_filtered: PerKind,
    n_undecided: u64,
    triangles: Option<TriangleCounts>,
    front: Option<FrontCounts>,
    rebuilt: bool,
    times: ccd::Times,
    toi_of_worlds: Option<Vec<f64>>,
}

impl Columns {
    pub fn new(report: &ccd::Report, options: &Options) -> Self {
        let contacts = &report.contacts;
        let vertices = contacts.iter().flat_map(|c| c.vertices(report.mesh()));
        let of_worlds = options.bodies.as_ref().map(|bodies| report.toi_of_worlds(bodies));
        Self {
            kind: contacts.iter().map(|c| c.kind as u8).collect(),
            a: contacts.iter().map(|c| c.a).collect(),
            b: contacts.iter().map(|c| c.b).collect(),
            toi: contacts.iter().map(|c| c.toi).collect(),
            state: contacts.iter().map(|c| state_number(c.state)).collect(),
            approach: contacts.iter().map(|c| c.approach.word() as u8).collect(),
            vertices: vertices.collect(),
            earliest_toi: report.toi,
            n_candidates: report.candidates,
            n_filtered: report.filtered,
            n_undecided: report.undecided,
            triangles: report.triangles,
            front: report.front,
            rebuilt: report.rebuilt,
            times: report.times,
            toi_of_worlds: of_worlds
                .map(|all| all.into_iter().map(|toi| toi.unwrap_or(f64::INFINITY)).collect()),
        }
    }

    /// As Python's arrays, without a copy.
    pub fn into_report(self, py: Python<'_>, mesh: Py<Mesh>) -> PyResult<Report> {
        let t = self.times;
        let times = [
            ("boxes", t.boxes),
            ("build", t.build),
            ("traverse", t.traverse),
            ("narrow", t.narrow),
            ("total", t.total),
        ];
        let triangles = self.triangles.map(|n| {
            let all = [
                ("pairs", n.pairs),
                ("adjacent", n.adjacent),
                ("free", n.free),
                ("separated", n.separated),
                ("represented", n.represented),
                ("orphans", n.orphans),
            ];
            all.into_py_dict(py).map(Bound::unbind)
        });
        let front = self.front.map(|n| {
            let all = [("pairs", n.pairs), ("begun", n.begun), ("bytes", n.bytes)];
            all.into_py_dict(py).map(Bound::unbind)
        });
        Ok(Report {
            kind: PyArray1::from_vec(py, self.kind).unbind(),
            a: PyArray1::from_vec(py, self.a).unbind(),
            b: PyArray1::from_vec(py, self.b).unbind(),
            toi: PyArray1::from_vec(py, self.toi).unbind(),
            state: PyArray1::from_vec(py, self.state).unbind(),
            approach: PyArray1::from_vec(py, self.approach).unbind(),
            vertices: rows::<4>(py, self.vertices)?.unbind(),
            earliest_toi: self.earliest_toi,
            n_candidates: of_kinds(self.n_candidates),
            n_filtered: of_kinds(self.n_filtered),
            n_undecided: self.n_undecided,
            triangles: triangles.transpose()?,
            front: front.transpose()?,
            rebuilt: self.rebuilt,
            times: times.into_py_dict(py)?.unbind(),
            toi_of_worlds: self.toi_of_worlds.map(|all| PyArray1::from_vec(py, all).unbind()),
            mesh,
        })
    }
}

fn of_kinds(n: PerKind) -> (u64, u64, u64, u64) {
    (n.vf, n.ee, n.ve, n.vv)
}
