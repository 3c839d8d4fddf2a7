//! A mesh stepped frame by frame, on the CPU or on a GPU.

use crate::arrays::pair_array;
use crate::bodies::bodies;
use crate::calls::{
    EarliestToi, FirstContact, Intersect, Intersects, ListCandidates, MakeSet, Motions,
    SetPositions, Shared, Step,
};
use crate::candidate_set::CandidateSet;
use crate::device;
use crate::errors::{failed, of_one};
use crate::hit::Hit;
use crate::mesh::Mesh;
use crate::options::{self, CancelToken, Options};
use crate::report::{Columns, Report};
use ccd::any;
use numpy::{PyArray2, PyUntypedArray};
use pyo3::gc::{PyTraverseError, PyVisit};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

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
/// options : Options, optional
///     What is looked for, and how.
/// device : str, optional
///     None or "cpu"; "gpu", an error if there is none; "gpu:NAME" with a part of its name, its
///     place in `gpus()`, or its PCI id; or "auto", a GPU if there is one and work enough for it.
/// min_distance, threads, bodies, .. : optional
///     Each option by its name, instead of an `Options` or besides; see there.
///
/// Raises
/// ------
/// ValueError
///     If the options do not fit the mesh.
/// RuntimeError
///     If there is no GPU and one was asked for.
#[pyclass(frozen, module = "meshccd")]
pub struct Session {
    shared: Shared,
}

#[pymethods]
impl Session {
    #[new]
    #[pyo3(signature = (mesh, options=None, **given))]
    #[pyo3(text_signature = "(mesh, options=None, *, device=None, min_distance=None, \
        threads=None, bodies=None, fixed=None, self_contact=None, max_memory=None, \
        tolerance=None, mode=None, leave_contact=None, method=None, builder=None, \
        traversal=None, volume=None, pipeline=None, scheduler=None, front=None)")]
    fn new(
        py: Python<'_>,
        mesh: Py<Mesh>,
        options: Option<&Bound<'_, Options>>,
        given: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let given = given.map_or_else(|| Ok(PyDict::new(py)), |given| given.copy())?;
        let device: Option<String> = match given.get_item("device")? {
            Some(device) => {
                given.del_item("device")?;
                device.extract()?
            }
            None => None,
        };
        let options = options::changed("Session", options::inner(options), &given)?;
        let topology = &mesh.get().inner;
        py.detach(|| options.check(topology)).map_err(|why| failed(why.into()))?;
        let choice = device::choose(py, device.as_deref(), topology.edges().len())?;
        let session = py.detach(|| any::Session::new(&choice, topology.clone(), options));
        Ok(Self { shared: Shared::new(session.map_err(failed)?, mesh) })
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
        let (columns, mesh) = self.shared.with_mesh(py, [x0, x1], Step(window))?;
        columns.into_report(py, mesh.clone_ref(py))
    }

    /// A report of each step of an animation: from each of these positions to the next. `frames`
    /// is an array of shape (n_frames, n_vertices, 3), a list or tuple of arrays of shape
    /// (n_vertices, 3), or anything that yields such arrays one after the other; those are copied,
    /// so that it may yield the same one again with other positions in it.
    fn step_many(&self, py: Python<'_>, frames: &Bound<'_, PyAny>) -> PyResult<Vec<Report>> {
        let is_array = frames.cast::<PyUntypedArray>().is_ok();
        let keeps =
            is_array || frames.is_instance_of::<PyList>() || frames.is_instance_of::<PyTuple>();
        let numpy = py.import("numpy")?;
        let whole = frames.hasattr("__dlpack__")? && !frames.hasattr("__iter__")?;
        let given = whole.then(|| numpy.call_method1("from_dlpack", (frames,))).transpose()?;
        let mut frames = given.as_ref().unwrap_or(frames).try_iter()?.map(|frame| {
            let mut frame = frame?;
            if keeps {
                return Ok(frame);
            }
            if frame.hasattr("__dlpack__")? && !frame.hasattr("__array__")? {
                frame = numpy.call_method1("from_dlpack", (frame,))?;
            }
            numpy.call_method1("array", (frame,))
        });
        let Some(mut before) = frames.next().transpose()? else { return Ok(Vec::new()) };
        let mut reports = Vec::new();
        for frame in frames {
            let after = frame?;
            py.check_signals()?;
            reports.push(self.step(py, &before, &after, None)?);
            before = after;
        }
        Ok(reports)
    }

    /// The earliest time of impact of the step, never late; None if all of it is free. Cheaper
    /// than `step`.
    fn earliest_toi(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Option<f64>> {
        self.shared.with(py, [x0, x1], EarliestToi)
    }

    /// The first contact of the step with its point and normal; None if all of it is free.
    fn first_contact(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Option<Hit>> {
        Ok(self.shared.with(py, [x0, x1], FirstContact)?.map(|hit| Hit::new(py, hit)))
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
        self.shared.with(py, [x, x], SetPositions).map_err(|e| of_one(py, e))
    }

    /// Every contact of a step in which some bodies move, and all others stand where they are: a
    /// list of `(body, x0, x1)` with the positions of the vertices of that body, or with the poses
    /// that move them from where `set_positions` has them: matrices of shape (4, 4) for columns
    /// `(x, y, z, 1)`. On a CPU what is fixed costs nothing then, and what moves by poses little.
    fn step_bodies(&self, py: Python<'_>, motions: Motions<'_>) -> PyResult<Report> {
        let (columns, mesh) = self.shared.with_bodies(py, &motions, |session, motions| {
            session.step_bodies(motions)?;
            Ok(Columns::new(session.report(), session.options()))
        })?;
        columns.into_report(py, mesh.clone_ref(py))
    }

    /// The earliest time of impact of a step in which some bodies move, as for `step_bodies`.
    fn earliest_toi_of_bodies(
        &self,
        py: Python<'_>,
        motions: Motions<'_>,
    ) -> PyResult<Option<f64>> {
        let find: fn(&mut any::Session, &[ccd::BodyMotion]) -> _ =
            |session, motions| session.earliest_toi_of_bodies(motions);
        Ok(self.shared.with_bodies(py, &motions, find)?.0)
    }

    /// The first contact of a step in which some bodies move, as for `step_bodies`.
    fn first_contact_of_bodies(
        &self,
        py: Python<'_>,
        motions: Motions<'_>,
    ) -> PyResult<Option<Hit>> {
        let find: fn(&mut any::Session, &[ccd::BodyMotion]) -> _ =
            |session, motions| session.first_contact_of_bodies(motions);
        Ok(self.shared.with_bodies(py, &motions, find)?.0.map(|hit| Hit::new(py, hit)))
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
        let all = self.shared.with(py, [x0, x1], ListCandidates)?;
        let arrays: Vec<_> =
            all.into_iter().map(|pairs| pair_array(py, pairs)).collect::<PyResult<_>>()?;
        PyTuple::new(py, arrays)
    }

    /// Edges and faces without a common vertex that have a point in common at the positions `x`:
    /// an array of shape (n, 2), uint32, sorted; where the mesh goes through itself. Exact where
    /// coordinates are zero or from 2^-200 to 2^200; beyond, all that are not certainly apart.
    fn intersections<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let found = self.shared.with(py, [x, x], Intersect);
        pair_array(py, found.map_err(|e| of_one(py, e))?)
    }

    /// Whether `intersections` would list any; the search ends with the first.
    fn has_intersections(&self, py: Python<'_>, x: &Bound<'_, PyAny>) -> PyResult<bool> {
        self.shared.with(py, [x, x], Intersects).map_err(|e| of_one(py, e))
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
        Ok(CandidateSet::new(self.shared.with(py, [x0, x1], MakeSet(inflation))?))
    }

    /// From now on steps of another mesh, with other bodies if some are given.
    #[pyo3(signature = (mesh, bodies=None))]
    fn set_mesh(
        &self,
        py: Python<'_>,
        mesh: Py<Mesh>,
        bodies: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        let bodies = bodies.map(self::bodies).transpose()?;
        self.shared.set_mesh(py, mesh, bodies)
    }

    /// From now on these bodies, or none.
    #[pyo3(signature = (bodies=None))]
    fn set_bodies(&self, py: Python<'_>, bodies: Option<&Bound<'_, PyAny>>) -> PyResult<()> {
        let bodies = bodies.map(self::bodies).transpose()?;
        self.shared.change(py, move |session| session.set_bodies(bodies))
    }

    /// From now on another `min_distance`.
    fn set_min_distance(&self, py: Python<'_>, min_distance: f64) -> PyResult<()> {
        self.shared.change(py, move |session| session.set_min_distance(min_distance))
    }

    /// From now on a body sleeps, or is awake.
    fn set_sleeping(&self, py: Python<'_>, body: u32, sleeping: bool) -> PyResult<()> {
        self.shared.change(py, move |session| session.set_sleeping(body, sleeping))
    }

    /// From now on a body is fixed, or moves.
    fn set_fixed(&self, py: Python<'_>, body: u32, fixed: bool) -> PyResult<()> {
        self.shared.change(py, move |session| session.set_fixed(body, fixed))
    }

    /// From now on bodies that are fixed or asleep may be moved by the caller, or not.
    fn set_fixed_motion(&self, py: Python<'_>, may_move: bool) -> PyResult<()> {
        self.shared.change(py, move |session| session.set_fixed_motion(may_move))
    }

    /// From now on these options, or those of before; each that is given by its name is changed
    /// besides, unless it is None: `Options` without a limit of memory takes it away.
    #[pyo3(signature = (options=None, **given))]
    #[pyo3(text_signature = "($self, options=None, *, min_distance=None, threads=None, \
        bodies=None, fixed=None, self_contact=None, max_memory=None, tolerance=None, mode=None, \
        leave_contact=None, method=None, builder=None, traversal=None, volume=None, \
        pipeline=None, scheduler=None, front=None)")]
    fn set_options(
        &self,
        py: Python<'_>,
        options: Option<&Bound<'_, Options>>,
        given: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<()> {
        let given = given.map_or_else(|| Ok(PyDict::new(py)), |given| given.copy())?;
        self.shared.change_options(py, |before| {
            let base = options.map_or(before, |options| options.get().inner.clone());
            options::changed("set_options", base, &given)
        })
    }

    /// From now on calls end with a RuntimeError once this token is cancelled, by another thread;
    /// None: they run to their ends. The session stays usable.
    #[pyo3(signature = (token=None))]
    fn set_cancel_token(
        &self,
        py: Python<'_>,
        token: Option<&Bound<'_, CancelToken>>,
    ) -> PyResult<()> {
        let token = token.map(|token| token.get().inner.clone());
        self.shared.change(py, move |session| {
            session.set_cancel_token(token);
            Ok(())
        })
    }

    /// From now on `filter(kind, pairs)` says which candidates count: asked once a call for each
    /// `Kind` that has some, with an array of shape (n, 2), it returns n of bool. None: all count.
    /// Candidates are listed for it, which costs time. On the CPU; in steps of bodies all count.
    #[pyo3(signature = (filter=None))]
    fn set_filter(&self, py: Python<'_>, filter: Option<Py<PyAny>>) -> PyResult<()> {
        self.shared.set_filter(py, filter)
    }

    /// The mesh of the next step.
    #[getter]
    fn mesh(&self, py: Python<'_>) -> PyResult<Py<Mesh>> {
        self.shared.mesh(py)
    }

    /// The options of the next step.
    #[getter]
    fn options(&self, py: Python<'_>) -> PyResult<Options> {
        let inner = self.shared.ask(py, |session| session.options().clone())?;
        Ok(Options { inner })
    }

    /// Where steps run: "2 threads", or the name of the GPU.
    #[getter]
    fn place(&self, py: Python<'_>) -> PyResult<String> {
        self.shared.ask(py, |session| session.place().to_string())
    }

    /// Where the last step ran: `place`, or the CPU for one on a GPU in which little moved.
    #[getter]
    fn last_place(&self, py: Python<'_>) -> PyResult<String> {
        self.shared.ask(py, |session| session.last_place().to_string())
    }

    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        self.shared.traverse(&visit)
    }

    fn __clear__(&self, py: Python<'_>) {
        let _ = self.shared.set_filter(py, None);
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let (place, n) = (self.place(py)?, self.mesh(py)?.get().inner.n_vertices());
        Ok(format!("<Session of {n} vertices on {place}>"))
    }
}
