//! A mesh stepped frame by frame, on the CPU or on a GPU.

use crate::arrays::{Floats, flat_ids, numbers, pair_array};
use crate::errors::{failed, lock, refused};
use crate::mesh::Mesh;
use crate::report::{Columns, Report};
use ccd::any::{self, Backend};
use ccd::{Bodies, Coordinate, Options};
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::sync::Mutex;

/// Continuous collision detection of one mesh over many steps: keep it for the next frames.
///
/// Every call takes the positions of all vertices at the start and at the end of a step, arrays of
/// shape (n_vertices, 3), between which they move on straight lines. C-ordered float32 and float64
/// are read where they are and must not be written to meanwhile; anything else is copied. If one
/// array is float32 and the other is not, both are taken as float64.
///
/// The interpreter is released during the work. Calls from several threads take turns.
///
/// Parameters
/// ----------
/// mesh : Mesh
/// min_distance : float
///     Contact means a distance of at most this; 0 means touching.
/// threads : int
///     Threads on the CPU: 0 for all cores, 1 for the calling thread alone.
/// bodies : (n_vertices,) array of integers, optional
///     The body that each vertex belongs to.
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
///
/// Raises
/// ------
/// ValueError
///     If the options do not fit the mesh.
/// RuntimeError
///     If there is no GPU and one was asked for.
#[pyclass(frozen, module = "meshccd")]
pub struct Session {
    #[pyo3(get)]
    /// The mesh.
    mesh: Py<Mesh>,
    inner: Mutex<any::Session>,
}

#[pymethods]
impl Session {
    #[new]
    #[pyo3(signature = (
        mesh, *, min_distance=0.0, threads=0, bodies=None, fixed=None, self_contact=None,
        device=None, max_memory=None
    ))]
    #[allow(clippy::too_many_arguments, reason = "Python's, by name")]
    fn new(
        py: Python<'_>,
        mesh: Py<Mesh>,
        min_distance: f64,
        threads: usize,
        bodies: Option<&Bound<'_, PyAny>>,
        fixed: Option<Vec<bool>>,
        self_contact: Option<bool>,
        device: Option<&str>,
        max_memory: Option<u64>,
    ) -> PyResult<Self> {
        if bodies.is_none() && (fixed.is_some() || self_contact.is_some()) {
            return Err(refused("fixed and self_contact say something of bodies: give bodies too"));
        }
        let bodies = bodies.map(|bodies| flat_ids("bodies", bodies)).transpose()?;
        let bodies = bodies.map(|bodies| {
            Bodies::new(&bodies)
                .with_fixed_mask(&fixed.unwrap_or_default())
                .with_self_contacts(self_contact.unwrap_or(true))
        });
        let options = Options::default()
            .with_min_distance(min_distance)
            .with_threads(threads)
            .with_bodies(bodies)
            .with_max_memory(max_memory);
        let backend = backend(device)?;
        let topology = &mesh.get().inner;
        let inner = py.detach(|| {
            options.check(topology)?;
            let choice = backend.choose(topology.edges().len())?;
            any::Session::new(&choice, topology.clone(), options)
        });
        Ok(Self { inner: Mutex::new(inner.map_err(failed)?), mesh })
    }

    /// Every contact of the step from `x0` to `x1`.
    fn step(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Report> {
        self.with(py, [x0, x1], step, step)?.into_report(py)
    }

    /// The earliest time of impact of the step, never late; None if all of it is free. Cheaper
    /// than `step`.
    fn earliest_toi(
        &self,
        py: Python<'_>,
        x0: &Bound<'_, PyAny>,
        x1: &Bound<'_, PyAny>,
    ) -> PyResult<Option<f64>> {
        self.with(py, [x0, x1], |s, a, b| s.earliest_toi(a, b), |s, a, b| s.earliest_toi(a, b))
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
        let all = self.with(py, [x0, x1], candidates, candidates)?;
        let arrays: Vec<_> =
            all.into_iter().map(|pairs| pair_array(py, pairs)).collect::<PyResult<_>>()?;
        PyTuple::new(py, arrays)
    }

    /// Where steps run: "2 threads", or the name of the GPU.
    #[getter]
    fn place(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| Ok(lock(&self.inner)?.place().to_string()))
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let (place, n) = (self.place(py)?, self.mesh.get().inner.n_vertices());
        Ok(format!("<Session of {n} vertices on {place}>"))
    }
}

/// A call of a session, for positions of one precision.
type Call<T, R> = fn(&mut any::Session, &[[T; 3]], &[[T; 3]]) -> Result<R, any::Error>;

fn step<T: Coordinate>(
    session: &mut any::Session,
    x0: &[[T; 3]],
    x1: &[[T; 3]],
) -> Result<Columns, any::Error> {
    session.step(x0, x1)?;
    Ok(Columns::new(session.report(), session.mesh()))
}

fn candidates<T: Coordinate>(
    session: &mut any::Session,
    x0: &[[T; 3]],
    x1: &[[T; 3]],
) -> Result<[Vec<u32>; 4], any::Error> {
    let all = session.candidates(x0, x1)?;
    let kinds = [all.vf, all.ee, all.ve, all.vv];
    Ok(kinds.map(|pairs| pairs.iter().flat_map(|p| [p.a, p.b]).collect()))
}

impl Session {
    /// Makes a call without the interpreter.
    fn with<R: Send>(
        &self,
        py: Python<'_>,
        [x0, x1]: [&Bound<'_, PyAny>; 2],
        narrow: Call<f32, R>,
        wide: Call<f64, R>,
    ) -> PyResult<R> {
        let positions = Floats::new([("x0", x0), ("x1", x1)], &[3])?.in_rows(["x0", "x1"], &[3])?;
        match &positions {
            Floats::F32([x0, x1]) => self.run(py, numbers(x0)?, numbers(x1)?, narrow),
            Floats::F64([x0, x1]) => self.run(py, numbers(x0)?, numbers(x1)?, wide),
        }
    }

    fn run<T: Coordinate, R: Send>(
        &self,
        py: Python<'_>,
        x0: &[T],
        x1: &[T],
        call: Call<T, R>,
    ) -> PyResult<R> {
        py.detach(|| {
            let mut session = lock(&self.inner)?;
            call(&mut session, x0.as_chunks().0, x1.as_chunks().0).map_err(failed)
        })
    }
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
