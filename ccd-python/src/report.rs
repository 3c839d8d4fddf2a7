//! Report of a step: arrays with one entry per contact.

use crate::arrays::{Floats, numbers, rows};
use crate::errors::refused;
use crate::mesh::Mesh;
use ccd::{Contact, Coordinate, Kind, Options, State};
use numpy::{Element, PyArray1, PyArray2, PyArrayMethods};
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
    /// Least time of impact of each world of the session's bodies, float64; infinity where there is
    /// no contact. None without bodies.
    toi_of_worlds: Option<Py<PyArray1<f64>>>,
    /// The mesh of the step.
    mesh: Py<Mesh>,
}

/// How features meet at the times of impact: arrays with an entry for each contact.
#[pyclass(frozen, get_all, module = "meshccd")]
pub struct Geometry {
    /// Halfway between the nearest points, (n, 3) float64.
    point: Py<PyArray2<f64>>,
    /// Unit vector from `b` towards `a`: pushing `a` along it parts the two, (n, 3) float64.
    normal: Py<PyArray2<f64>>,
    /// Of the vertices in `Report.vertices`, in the nearest point of their feature: (n, 4) float64.
    weights: Py<PyArray2<f64>>,
    /// The nearest point of `a`, (n, 3) float64.
    on_a: Py<PyArray2<f64>>,
    /// The nearest point of `b`, (n, 3) float64.
    on_b: Py<PyArray2<f64>>,
    /// Between the nearest points, (n,) float64.
    distance: Py<PyArray1<f64>>,
}

/// The first contact of a step.
#[pyclass(frozen, get_all, module = "meshccd")]
pub struct Hit {
    /// Time of impact in [0, 1]; never late.
    toi: f64,
    /// Which features touch: a `Kind`.
    kind: u8,
    /// How certain it is: `State.HIT` or `State.UNDECIDED`.
    state: u8,
    /// Vertex and face, or the lesser and the greater edge.
    features: [u32; 2],
    /// The bodies of the features; both 0 without bodies.
    bodies: [u32; 2],
    /// Vertices, as a row of `Report.vertices`.
    vertices: [u32; 4],
    /// Where they meet.
    point: [f64; 3],
    /// Unit vector from the second feature towards the first.
    normal: [f64; 3],
    /// Of each of the vertices, in the point of its feature.
    weights: [f64; 4],
    /// How far the features are apart at that time.
    distance: f64,
}

#[pymethods]
impl Hit {
    /// The normal that points towards `body`, away from what it touches.
    fn normal_towards(&self, body: u32) -> [f64; 3] {
        let [a, b] = self.bodies;
        if body == b && body != a { self.normal.map(|c| -c) } else { self.normal }
    }

    fn __repr__(&self) -> String {
        let ([a, b], toi) = (self.features, self.toi);
        let kind = Kind::ALL[self.kind as usize];
        format!("<Hit: {kind:?} {a} {b} at {toi}>")
    }
}

impl From<ccd::Hit> for Hit {
    fn from(hit: ccd::Hit) -> Self {
        Self {
            toi: hit.toi,
            kind: hit.kind as u8,
            state: state_number(hit.state),
            features: hit.features,
            bodies: hit.bodies,
            vertices: hit.vertices,
            point: hit.point,
            normal: hit.normal,
            weights: hit.weights,
            distance: hit.distance,
        }
    }
}

/// What a report is made of, in the order of its arguments.
type Parts = (
    Py<PyArray1<u8>>,
    Py<PyArray1<u32>>,
    Py<PyArray1<u32>>,
    Py<PyArray1<f64>>,
    Py<PyArray1<u8>>,
    Py<PyArray2<u32>>,
    Option<f64>,
    (u64, u64, u64, u64),
    u64,
    Py<PyDict>,
    Option<Py<PyArray1<f64>>>,
    Py<Mesh>,
);

#[pymethods]
impl Report {
    /// A copy of the parts of another report. Sessions make reports.
    #[new]
    #[allow(clippy::too_many_arguments, reason = "Python's, of a copy")]
    fn new(
        kind: Py<PyArray1<u8>>,
        a: Py<PyArray1<u32>>,
        b: Py<PyArray1<u32>>,
        toi: Py<PyArray1<f64>>,
        state: Py<PyArray1<u8>>,
        vertices: Py<PyArray2<u32>>,
        earliest_toi: Option<f64>,
        n_candidates: (u64, u64, u64, u64),
        n_undecided: u64,
        times: Py<PyDict>,
        toi_of_worlds: Option<Py<PyArray1<f64>>>,
        mesh: Py<Mesh>,
    ) -> Self {
        Self {
            kind,
            a,
            b,
            toi,
            state,
            vertices,
            earliest_toi,
            n_candidates,
            n_undecided,
            times,
            toi_of_worlds,
            mesh,
        }
    }

    /// What a copy is made of.
    fn __getnewargs__(&self, py: Python<'_>) -> Parts {
        (
            self.kind.clone_ref(py),
            self.a.clone_ref(py),
            self.b.clone_ref(py),
            self.toi.clone_ref(py),
            self.state.clone_ref(py),
            self.vertices.clone_ref(py),
            self.earliest_toi,
            self.n_candidates,
            self.n_undecided,
            self.times.clone_ref(py),
            self.toi_of_worlds.as_ref().map(|toi| toi.clone_ref(py)),
            self.mesh.clone_ref(py),
        )
    }

    /// Points, normals and weights of all contacts, from the positions of the step.
    fn geometry(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Geometry> {
        let positions = Floats::new([("x0", x0), ("x1", x1)], &[3])?.in_rows(["x0", "x1"], &[3])?;
        match &positions {
            Floats::F32([x0, x1]) => self.geometry_of(py, [numbers(x0)?, numbers(x1)?]),
            Floats::F64([x0, x1]) => self.geometry_of(py, [numbers(x0)?, numbers(x1)?]),
        }
    }

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

impl Report {
    fn geometry_of<T: Coordinate + Element>(
        &self,
        py: Python<'_>,
        x: [&[T]; 2],
    ) -> PyResult<Geometry> {
        let [x0, x1] = x.map(|x| x.as_chunks().0);
        let mesh = &self.mesh.get().inner;
        mesh.check_positions(x0, x1).map_err(crate::errors::input)?;
        let (kind, toi) = (self.kind.bind(py).readonly(), self.toi.bind(py).readonly());
        let (a, b) = (self.a.bind(py).readonly(), self.b.bind(py).readonly());
        let (kind, toi) = (kind.as_slice().map_err(refused)?, toi.as_slice().map_err(refused)?);
        let (a, b) = (a.as_slice().map_err(refused)?, b.as_slice().map_err(refused)?);
        let [point, normal, weights, on_a, on_b, distance] = py.detach(|| {
            let mut columns: [Vec<f64>; 6] = Default::default();
            for (((&kind, &a), &b), &toi) in kind.iter().zip(a).zip(b).zip(toi) {
                let contact = Contact::new(Kind::ALL[kind as usize], State::Hit, a, b, toi);
                let at = contact.geometry(mesh, x0, x1);
                let values: [&[f64]; 6] =
                    [&at.point, &at.normal, &at.weights, &at.on_a, &at.on_b, &[at.distance]];
                columns.iter_mut().zip(values).for_each(|(column, v)| column.extend(v));
            }
            columns
        });
        let n = toi.len();
        let rows = |flat: Vec<f64>, width: usize| -> PyResult<Py<PyArray2<f64>>> {
            Ok(PyArray1::from_vec(py, flat).reshape([n, width])?.unbind())
        };
        Ok(Geometry {
            point: rows(point, 3)?,
            normal: rows(normal, 3)?,
            weights: rows(weights, 4)?,
            on_a: rows(on_a, 3)?,
            on_b: rows(on_b, 3)?,
            distance: PyArray1::from_vec(py, distance).unbind(),
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
    toi_of_worlds: Option<Vec<f64>>,
}

impl Columns {
    pub fn new(report: &ccd::Report, options: &Options) -> Self {
        let (contacts, n) = (&report.contacts, report.candidates);
        let vertices = contacts.iter().flat_map(|c| c.vertices(report.mesh()));
        let of_worlds = options.bodies.as_ref().map(|bodies| report.toi_of_worlds(bodies));
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
            toi_of_worlds: of_worlds
                .map(|all| all.into_iter().map(|toi| toi.unwrap_or(f64::INFINITY)).collect()),
        }
    }

    /// As Python's arrays, without a copy.
    pub fn into_report(self, py: Python<'_>, mesh: Py<Mesh>) -> PyResult<Report> {
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
            toi_of_worlds: self.toi_of_worlds.map(|all| PyArray1::from_vec(py, all).unbind()),
            mesh,
        })
    }
}

/// The number of `State.MISS` in Python.
pub const MISS: u8 = 0;

/// The numbers of `State` in Python.
pub fn state_number(state: State) -> u8 {
    if state == State::Hit { 1 } else { 2 }
}
