//! A mesh stepped frame by frame, on the CPU or on a GPU.

use crate::arrays::{Floats, numbers, pair_array};
use crate::bodies::bodies;
use crate::calls::{
    Call, EarliestToi, FirstContact, Intersect, Intersects, ListCandidates, MakeSet, SetPositions,
    Step,
};
use crate::candidate_set::CandidateSet;
use crate::errors::{check_process, failed, lock, refused};
use crate::filter::Wanted;
use crate::mesh::Mesh;
use crate::options;
use crate::report::{Columns, Hit, Report};
use ccd::any::{self, Backend};
use ccd::{BodyMotion, Coordinate};
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::Mutex;

/// Continuous collision detection of one mesh over many steps: keep it for the next frames.
///
/// Every call takes the positions of all vertices at the start and at the end of a step, arrays of
/// shape (n_vertices, 3), between which they move on straight lines. C-ordered float32 and float64
/// are read where they are and must not be written to meanwhile; anything else is copied. If one
/// array is float32 and the other is not, both are taken as float64.
///
/// The interpreter is released during the work. Calls from several threads take turns. A session
/// serves the process that made it: after a fork, make another.
///
/// Parameters
/// ----------
/// mesh : Mesh
/// min_distance : float
///     Contact means a distance of at most this; 0 means touching.
/// threads : int
///     Threads on the CPU: 0 for all cores, 1 for the calling thread alone.
/// bodies : Bodies, or (n_vertices,) array of integers, optional
///     Bodies with their rules, or the body that each vertex belongs to.
/// fixed : (n_bodies,) array of bool, optional
///     Bodies that do not move; entry i is that of body i. Pairs of them are not looked at, and a
///     step in which one moves is refused.
/// self_contact : bool, optional
///     Whether pairs within one body are looked at; by default they are.
/// device : str, optional
///     None or "cpu"; "gpu", an error if there is none; or "auto", a GPU if there is one and work
///     enough for it.
/// max_memory : int, optional
///     Bytes that the session may hold; by default there is no limit. What would go beyond is
///     refused before it is allocated, and the session stays usable.
/// tolerance : float
///     How early a certain time of impact may be, in units of the step; at least 1e-12.
/// mode : str
///     "conservative": what cannot be certified is a contact that is undecided; or "exact": every
///     pair is decided as its coordinates are, and times are the true ones, rounded down. Exact
///     takes no minimum distance.
/// leave_contact : bool
///     Whether features that are in contact at the start may separate: no contact, unless they
///     come nearer or touch again.
/// method, builder, traversal, volume, pipeline, scheduler, front : str, optional
///     How pairs are found, by the names that `ccd list` prints. All find the same contacts.
///
/// Raises
/// ------
/// ValueError
///     If the options do not fit the mesh.
/// RuntimeError
///     If there is no GPU and one was asked for.
#[pyclass(frozen, module = "meshccd")]
pub struct Session {
    inner: Mutex<any::Session>,
    mesh: Mutex<Py<Mesh>>,
    filter: Mutex<Option<Py<PyAny>>>,
    made_by: u32,
}

#[pymethods]
impl Session {
    #[new]
    #[pyo3(signature = (mesh, **given))]
    #[pyo3(text_signature = "(mesh, *, min_distance=0.0, threads=0, bodies=None, fixed=None, \
        self_contact=None, device=None, max_memory=None, tolerance=1e-06, mode='conservative', \
        leave_contact=False, method=None, builder=None, traversal=None, volume=None, \
        pipeline=None, scheduler=None, front=None)")]
    fn new(py: Python<'_>, mesh: Py<Mesh>, given: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let given = given.map_or_else(|| Ok(PyDict::new(py)), |given| given.copy())?;
        let options = options::options(&given)?;
        let device: Option<String> = given.get_item("device")?.map_or(Ok(None), |d| d.extract())?;
        let (backend, topology) = (backend(device.as_deref())?, &mesh.get().inner);
        let inner = py.detach(|| {
            options.check(topology)?;
            let choice = backend.choose(topology.edges().len())?;
            any::Session::new(&choice, topology.clone(), options)
        });
        Ok(Self {
            inner: Mutex::new(inner.map_err(failed)?),
            mesh: Mutex::new(mesh),
            filter: Mutex::default(),
            made_by: std::process::id(),
        })
    }

    /// Every contact of the step from `x0` to `x1` that exists in the window of time
    /// `(t_a, t_b)`, by default (0, 1).
    #[pyo3(signature = (x0, x1, window=None))]
    fn step(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
        window: Option<[f64; 2]>,
    ) -> PyResult<Report> {
        let window = window.unwrap_or([0.0, 1.0]);
        self.with(py, [x0, x1], Step(window))?.into_report(py, self.mesh(py)?)
    }

    /// The earliest time of impact of the step, never late; None if all of it is free. Cheaper
    /// than `step`.
    fn earliest_toi(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Option<f64>> {
        self.with(py, [x0, x1], EarliestToi)
    }

    /// The first contact of the step with its point and normal; None if all of it is free.
    fn first_contact(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Option<Hit>> {
        Ok(self.with(py, [x0, x1], FirstContact)?.map(Hit::from))
    }

    /// The part of the step that is free of contact, in [0, 1]: the earliest time of impact, or 1
    /// if all of the step is free. Before that time nothing touches; at it something may.
    fn collision_free_stepsize(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<f64> {
        Ok(self.earliest_toi(py, x0, x1)?.unwrap_or(1.0))
    }

    /// Whether nothing touches during the step, both ends included. False if that could not be
    /// certified.
    fn is_step_collision_free(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<bool> {
        Ok(self.earliest_toi(py, x0, x1)?.is_none())
    }

    /// From now on all vertices stand at `x`, until `step_bodies` and its like move bodies.
    fn set_positions(&self, py: Python<'_>, x: &Bound<'_, PyAny>) -> PyResult<()> {
        self.with(py, [x, x], SetPositions)
    }

    /// Every contact of a step in which some bodies move, and all others stand where they are: a
    /// list of `(body, x0, x1)` with the positions of the vertices of that body. On a CPU what is
    /// fixed costs nothing then.
    fn step_bodies(&self, py: Python<'_>, motions: Motions<'_>) -> PyResult<Report> {
        let columns = self.with_bodies(py, &motions, |session, motions| {
            session.step_bodies(motions)?;
            Ok(Columns::new(session.report(), session.options()))
        })?;
        columns.into_report(py, self.mesh(py)?)
    }

    /// The earliest time of impact of a step in which some bodies move, as for `step_bodies`.
    fn earliest_toi_of_bodies(
        &self,
        py: Python<'_>,
        motions: Motions<'_>,
    ) -> PyResult<Option<f64>> {
        self.with_bodies(py, &motions, |session, motions| session.earliest_toi_of_bodies(motions))
    }

    /// The first contact of a step in which some bodies move, as for `step_bodies`.
    fn first_contact_of_bodies(
        &self,
        py: Python<'_>,
        motions: Motions<'_>,
    ) -> PyResult<Option<Hit>> {
        let first = self
            .with_bodies(py, &motions, |session, motions| session.first_contact_of_bodies(motions));
        Ok(first?.map(Hit::from))
    }

    /// All candidates of the step: pairs of features without a common vertex whose swept boxes
    /// overlap. Four arrays of shape (n, 2), uint32, in no particular order, in that of `Kind`:
    /// vertex and face; two edges, the lesser id first; and of particles (vertices of no edge) and
    /// rods (edges of no face) particle and rod, and two particles, the lesser id first.
    fn candidates<'py>(
        &self,
        py: Python<'py>,
        x0: &Bound<'py, PyAny>,
        x1: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyTuple>> {
        let all = self.with(py, [x0, x1], ListCandidates)?;
        let arrays: Vec<_> =
            all.into_iter().map(|pairs| pair_array(py, pairs)).collect::<PyResult<_>>()?;
        PyTuple::new(py, arrays)
    }

    /// Edges and faces without a common vertex that have a point in common at the positions `x`:
    /// an array of shape (n, 2), uint32, sorted; where the mesh goes through itself.
    fn intersections<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<u32>>> {
        pair_array(py, self.with(py, [x, x], Intersect)?)
    }

    /// Whether `intersections` would list any; the search ends with the first.
    fn has_intersections(&self, py: Python<'_>, x: &Bound<'_, PyAny>) -> PyResult<bool> {
        self.with(py, [x, x], Intersects)
    }

    /// Candidates of the step as an object that serves all steps near it: of vertices that are at
    /// most `inflation` outside of this one. Found and used on the CPU.
    #[pyo3(signature = (x0, x1, inflation=0.0))]
    fn candidate_set(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
        inflation: f64,
    ) -> PyResult<CandidateSet> {
        Ok(CandidateSet::new(self.with(py, [x0, x1], MakeSet(inflation))?))
    }

    /// From now on steps of another mesh, with other bodies if some are given.
    #[pyo3(signature = (mesh, bodies=None))]
    fn set_mesh(
        &self,
        py: Python<'_>,
        mesh: Py<Mesh>,
        bodies: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let others = bodies.map(self::bodies).transpose()?;
        let topology = mesh.get().inner.clone();
        self.change(py, move |session| match others {
            Some(bodies) => session.set_mesh_and_bodies(topology, bodies),
            None => session.set_mesh(topology),
        })?;
        *lock(&self.mesh)? = mesh;
        Ok(())
    }

    /// From now on these bodies, or none.
    #[pyo3(signature = (bodies=None))]
    fn set_bodies(&self, py: Python<'_>, bodies: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let bodies = bodies.map(self::bodies).transpose()?;
        self.change(py, move |session| session.set_bodies(bodies))
    }

    /// From now on another `min_distance`.
    fn set_min_distance(&self, py: Python<'_>, min_distance: f64) -> PyResult<()> {
        self.change(py, move |session| session.set_min_distance(min_distance))
    }

    /// From now on a body sleeps, or is awake.
    fn set_sleeping(&self, py: Python<'_>, body: u32, sleeping: bool) -> PyResult<()> {
        self.change(py, move |session| session.set_sleeping(body, sleeping))
    }

    /// From now on a body is fixed, or moves.
    fn set_fixed(&self, py: Python<'_>, body: u32, fixed: bool) -> PyResult<()> {
        self.change(py, move |session| session.set_fixed(body, fixed))
    }

    /// From now on `filter(kind, pairs)` says which candidates count: asked once a call for each
    /// `Kind` that has some, with an array of shape (n, 2), it returns n of bool. None: all count.
    /// Candidates are listed for it, which costs time. On the CPU; steps of bodies do not ask it.
    #[pyo3(signature = (filter=None))]
    fn set_filter(&self, py: Python<'_>, filter: Option<Py<PyAny>>) -> PyResult<()> {
        if filter.is_none() {
            self.change(py, |session| {
                session.remove_filter();
                Ok(())
            })?;
        }
        *lock(&self.filter)? = filter;
        Ok(())
    }

    /// The mesh of the next step.
    #[getter]
    fn mesh(&self, py: Python<'_>) -> PyResult<Py<Mesh>> {
        Ok(lock(&self.mesh)?.clone_ref(py))
    }

    /// Where steps run: "2 threads", or the name of the GPU.
    #[getter]
    fn place(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| Ok(lock(&self.inner)?.place().to_string()))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let (place, n) = (self.place(py)?, self.mesh(py)?.get().inner.n_vertices());
        Ok(format!("<Session of {n} vertices on {place}>"))
    }
}

/// Bodies, each with its positions at both ends of a step.
type Motions<'py> = Vec<(u32, Bound<'py, PyAny>, Bound<'py, PyAny>)>;

impl Session {
    /// Makes a call without the interpreter.
    fn with<C: Call>(
        &self,
        py: Python<'_>,
        [x0, x1]: [&Bound<'_, PyAny>; 2],
        call: C,
    ) -> PyResult<C::Found> {
        let positions = Floats::new([("x0", x0), ("x1", x1)], &[3])?.in_rows(["x0", "x1"], &[3])?;
        match &positions {
            Floats::F32([x0, x1]) => self.run(py, [numbers(x0)?, numbers(x1)?], call),
            Floats::F64([x0, x1]) => self.run(py, [numbers(x0)?, numbers(x1)?], call),
        }
    }

    fn run<T: Coordinate, C: Call>(
        &self,
        py: Python<'_>,
        x: [&[T]; 2],
        call: C,
    ) -> PyResult<C::Found> {
        let x = x.map(|x| x.as_chunks().0);
        let filter = lock(&self.filter)?.as_ref().map(|filter| filter.clone_ref(py));
        if let Some(filter) = filter {
            let candidates = self.change(py, move |session| {
                session.remove_filter();
                call.candidates(session, x)
            })?;
            let wanted = Wanted::new(py, &filter, candidates)?;
            self.change(py, |session| session.set_filter(move |k, a, b| wanted.has(k, a, b)))?;
        }
        self.change(py, move |session| call.call(session, x))
    }

    /// Does something with the session, without the interpreter.
    fn change<R: Send>(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut any::Session) -> Result<R, any::Error> + Send,
    ) -> PyResult<R> {
        check_process(self.made_by, "the session")?;
        py.detach(|| change(&mut *lock(&self.inner)?).map_err(failed))
    }

    fn with_bodies<R: Send>(
        &self,
        py: Python<'_>,
        motions: &Motions<'_>,
        call: fn(&mut any::Session, &[BodyMotion]) -> Result<R, any::Error>,
    ) -> PyResult<R> {
        let positions = motions.iter().map(|(_, x0, x1)| {
            Floats::new([("x0", x0), ("x1", x1)], &[3])?.in_rows(["x0", "x1"], &[3])
        });
        let positions: Vec<Floats<'_, 2>> = positions.collect::<PyResult<_>>()?;
        let motions = motions.iter().zip(&positions).map(|(&(body, ..), positions)| {
            Ok(match positions {
                Floats::F32([x0, x1]) => motion(body, [numbers(x0)?, numbers(x1)?]),
                Floats::F64([x0, x1]) => motion(body, [numbers(x0)?, numbers(x1)?]),
            })
        });
        let motions: Vec<BodyMotion> = motions.collect::<PyResult<_>>()?;
        self.change(py, |session| call(session, &motions))
    }
}

fn motion<'a, T: Coordinate>(body: u32, x: [&'a [T]; 2]) -> BodyMotion<'a> {
    let [x0, x1] = x.map(|x| x.as_chunks::<3>().0);
    BodyMotion::new(body, x0, x1)
}

/// The backend of a name.
pub fn backend(device: Option<&str>) -> PyResult<Backend> {
    match device {
        None | Some("cpu") => Ok(Backend::Cpu),
        Some("gpu") => Ok(Backend::Gpu),
        Some("auto") => Ok(Backend::Auto),
        Some(name) => Err(refused(format!(
            "device is {name:?}; it must be None, \"cpu\", \"gpu\" or \"auto\""
        ))),
    }
}
