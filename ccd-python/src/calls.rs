//! Calls of a session, each over positions of either precision, without the interpreter and one
//! after the other.

use crate::arrays::{Floats, numbers};
use crate::candidate_set::flat;
use crate::errors::{failed, lock};
use crate::filter::Wanted;
use crate::mesh::Mesh;
use crate::process::Guarded;
use crate::report::Columns;
use ccd::any;
use ccd::{BodyMotion, Coordinate, Kind, Options};
use pyo3::exceptions::{PyRuntimeError, PyTypeError};
use pyo3::gc::{PyTraverseError, PyVisit};
use pyo3::prelude::*;
use std::sync::{Arc, Mutex};

/// A session that threads of Python share, in the process that made it.
pub struct Shared {
    inner: Guarded<Inner>,
    filter: Mutex<Option<Py<PyAny>>>,
}

/// How often a filter is asked again because another thread, or the filter, changed the session.
const TURNS: usize = 16;

/// What one thread has at a time.
struct Inner {
    session: any::Session,
    mesh: Arc<Py<Mesh>>,
    /// How often something was done with the session besides calls: what a filter was asked about
    /// may be another scene afterwards.
    changes: u64,
}

/// Bodies, each with its positions at both ends of a step.
pub type Motions<'py> = Vec<(u32, Bound<'py, PyAny>, Bound<'py, PyAny>)>;

impl Shared {
    pub fn new(session: any::Session, mesh: Py<Mesh>) -> Self {
        let inner = Inner { session, mesh: Arc::new(mesh), changes: 0 };
        Self { inner: Guarded::new("session", inner), filter: Mutex::default() }
    }

    /// Makes a call.
    pub fn with<C: Call>(
        &self,
        py: Python<'_>,
        x: [&Bound<'_, PyAny>; 2],
        call: C,
    ) -> PyResult<C::Found> {
        Ok(self.with_mesh(py, x, call)?.0)
    }

    /// Makes a call; the mesh that it was made for besides.
    pub fn with_mesh<C: Call>(
        &self,
        py: Python<'_>,
        [x0, x1]: [&Bound<'_, PyAny>; 2],
        call: C,
    ) -> PyResult<(C::Found, Arc<Py<Mesh>>)> {
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
    ) -> PyResult<(C::Found, Arc<Py<Mesh>>)> {
        let x = x.map(|x| x.as_chunks().0);
        let filter = lock(&self.filter)?.as_ref().map(|filter| filter.clone_ref(py));
        let Some(filter) = filter.filter(|_| C::ASKS) else {
            return self.inner.with(py, move |inner| {
                Ok((call.call(&mut inner.session, x).map_err(failed)?, inner.mesh.clone()))
            });
        };
        // The callback may take its time, and may call the session: nothing is locked meanwhile.
        for _ in 0..TURNS {
            let (candidates, changes) = self.inner.with(py, move |inner| {
                Ok((call.candidates(&mut inner.session, x).map_err(failed)?, inner.changes))
            })?;
            let wanted = Wanted::new(py, &filter, candidates)?;
            let found = self.inner.with(py, move |inner| {
                if inner.changes != changes {
                    return Ok(None);
                }
                inner.session.set_filter(move |k, a, b| wanted.has(k, a, b)).map_err(failed)?;
                let found = call.call(&mut inner.session, x);
                // Other calls are of other positions, or ask nobody.
                inner.session.remove_filter();
                Ok(Some((found.map_err(failed)?, inner.mesh.clone())))
            })?;
            if let Some(found) = found {
                return Ok(found);
            }
        }
        let why = "the session was changed each time while its filter was asked";
        Err(PyRuntimeError::new_err(why))
    }

    /// Asks the session for what is no call.
    pub fn ask<R: Send>(
        &self,
        py: Python<'_>,
        ask: impl FnOnce(&any::Session) -> R + Send,
    ) -> PyResult<R> {
        self.inner.with(py, |inner| Ok(ask(&inner.session)))
    }

    /// The mesh of the next call.
    pub fn mesh(&self, py: Python<'_>) -> PyResult<Py<Mesh>> {
        Ok(self.inner.with(py, |inner| Ok(inner.mesh.clone()))?.clone_ref(py))
    }

    /// Changes the mesh, and bodies if some are given.
    pub fn set_mesh(
        &self,
        py: Python<'_>,
        mesh: Py<Mesh>,
        bodies: Option<ccd::Bodies>,
    ) -> PyResult<()> {
        let topology = mesh.get().inner.clone();
        self.inner.with(py, move |inner| {
            inner.changes += 1;
            let changed = match bodies {
                Some(bodies) => inner.session.set_mesh_and_bodies(topology, bodies),
                None => inner.session.set_mesh(topology),
            };
            changed.map_err(failed)?;
            Ok(std::mem::replace(&mut inner.mesh, Arc::new(mesh)))
        })?;
        Ok(())
    }

    /// Changes options to others, made of those of before, which may ask Python.
    pub fn change_options(
        &self,
        py: Python<'_>,
        others: impl Fn(Options) -> PyResult<Options>,
    ) -> PyResult<()> {
        for _ in 0..TURNS {
            let (options, changes) = self
                .inner
                .with(py, |inner| Ok((inner.session.options().clone(), inner.changes)))?;
            let options = others(options)?;
            let is_done = self.inner.with(py, move |inner| {
                let is_same = inner.changes == changes;
                if is_same {
                    inner.changes += 1;
                    inner.session.set_options(options).map_err(failed)?;
                }
                Ok(is_same)
            })?;
            if is_done {
                return Ok(());
            }
        }
        Err(PyRuntimeError::new_err("the options were changed each time by another thread"))
    }

    /// Changes the session.
    pub fn change<R: Send>(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut any::Session) -> Result<R, any::Error> + Send,
    ) -> PyResult<R> {
        self.inner.with(py, |inner| {
            inner.changes += 1;
            change(&mut inner.session).map_err(failed)
        })
    }

    /// Has the next calls ask a callback which pairs they want; none has them want all.
    pub fn set_filter(&self, py: Python<'_>, filter: Option<Py<PyAny>>) -> PyResult<()> {
        if filter.as_ref().is_some_and(|filter| !filter.bind(py).is_callable()) {
            return Err(PyTypeError::new_err(
                "filter must be a function of kind and pairs, or None",
            ));
        }
        let before = std::mem::replace(&mut *lock(&self.filter)?, filter);
        // Python runs its finalizer now, which may call the session: nothing is locked.
        drop(before);
        Ok(())
    }

    /// Makes a call in which bodies move.
    pub fn with_bodies<R: Send>(
        &self,
        py: Python<'_>,
        motions: &Motions<'_>,
        call: fn(&mut any::Session, &[BodyMotion]) -> Result<R, any::Error>,
    ) -> PyResult<(R, Arc<Py<Mesh>>)> {
        let positions = motions.iter().map(|(_, x0, x1)| {
            let given = [("x0", x0), ("x1", x1)];
            // So few rows may be made into an array twice.
            if x0.len().is_ok_and(|n| n == 4) {
                let arrays = Floats::new(given, &[])?;
                if [0, 1].iter().all(|&i| arrays.shape(i) == [4, 4]) {
                    return Ok(arrays);
                }
            }
            Floats::new(given, &[3])?.in_rows(["x0", "x1"], &[3])
        });
        let positions: Vec<Floats<'_, 2>> = positions.collect::<PyResult<_>>()?;
        let motions = motions.iter().zip(&positions).map(|(&(body, ..), positions)| {
            let posed = positions.shape(0) == [4, 4];
            Ok(match positions {
                Floats::F32([x0, x1]) => motion(body, posed, [numbers(x0)?, numbers(x1)?]),
                Floats::F64([x0, x1]) => motion(body, posed, [numbers(x0)?, numbers(x1)?]),
            })
        });
        let motions: Vec<BodyMotion> = motions.collect::<PyResult<_>>()?;
        self.inner.with(py, |inner| {
            Ok((call(&mut inner.session, &motions).map_err(failed)?, inner.mesh.clone()))
        })
    }

    /// For the collector of garbage: a callback may refer to what holds the session.
    pub fn traverse(&self, visit: &PyVisit<'_>) -> Result<(), PyTraverseError> {
        // One that is locked is in use, and so no garbage.
        self.filter.try_lock().map_or(Ok(()), |filter| visit.call(&*filter))
    }
}

/// The motion of a body between positions, or between poses: matrices of four rows.
fn motion<'a, T: Coordinate>(body: u32, posed: bool, x: [&'a [T]; 2]) -> BodyMotion<'a> {
    if posed {
        let pose = |x: &[T]| [0, 1, 2, 3].map(|k| [0, 1, 2, 3].map(|i| x[4 * i + k]));
        let [pose0, pose1] = x.map(pose);
        return BodyMotion::posed(body, &pose0, &pose1);
    }
    let [x0, x1] = x.map(|x| x.as_chunks::<3>().0);
    BodyMotion::new(body, x0, x1)
}

/// A call of a session, whatever the precision of positions.
pub trait Call: Send + Copy {
    /// What is found.
    type Found: Send;
    /// Whether a filter says which pairs count.
    const ASKS: bool = true;

    /// Makes it, for the positions at both ends of a step.
    fn call<T: Coordinate>(
        self,
        session: &mut any::Session,
        x: [&[[T; 3]]; 2],
    ) -> Result<Self::Found, any::Error>;

    /// The candidates that a filter is asked of before the call: those that the call may take.
    fn candidates<T: Coordinate>(
        self,
        session: &mut any::Session,
        x: [&[[T; 3]]; 2],
    ) -> Result<[Vec<u32>; 4], any::Error> {
        ListCandidates.call(session, x)
    }
}

/// Candidates for steps up to this far from the one that they are found for.
#[derive(Clone, Copy)]
pub struct MakeSet(pub f64);

impl Call for MakeSet {
    type Found = ccd::CandidateSet;

    fn call<T: Coordinate>(
        self,
        session: &mut any::Session,
        [x0, x1]: [&[[T; 3]]; 2],
    ) -> Result<ccd::CandidateSet, any::Error> {
        Ok(session.candidate_set(x0, x1, self.0)?)
    }

    fn candidates<T: Coordinate>(
        self,
        session: &mut any::Session,
        x: [&[[T; 3]]; 2],
    ) -> Result<[Vec<u32>; 4], any::Error> {
        let set = self.call(session, x)?;
        Ok(Kind::ALL.map(|kind| flat(&set, kind)))
    }
}

macro_rules! calls {
    ($($name:ident $(($of:ty))? $(asks: $asks:literal)?,
        |$this:pat_param, $session:ident, $x0:ident, $x1:ident|
        -> $found:ty { $($body:tt)* })*) => {$(
        #[derive(Clone, Copy)]
        pub struct $name $((pub $of))?;

        impl Call for $name {
            type Found = $found;
            $(const ASKS: bool = $asks;)?

            fn call<T: Coordinate>(
                self,
                $session: &mut any::Session,
                [$x0, $x1]: [&[[T; 3]]; 2],
            ) -> Result<$found, any::Error> {
                let $this = self;
                $($body)*
            }
        }
    )*};
}

calls! {
    Step([f64; 2]), |Self(window), session, x0, x1| -> Columns {
        session.step_window(x0, x1, window)?;
        Ok(Columns::new(session.report(), session.options()))
    }
    EarliestToi, |_, session, x0, x1| -> Option<f64> { session.earliest_toi(x0, x1) }
    FirstContact, |_, session, x0, x1| -> Option<ccd::Hit> { session.first_contact(x0, x1) }
    SetPositions asks: false, |_, session, x0, _x1| -> () { Ok(session.set_positions(x0)?) }
    ListCandidates, |_, session, x0, x1| -> [Vec<u32>; 4] {
        let all = session.candidates(x0, x1)?;
        let kinds = [all.vf, all.ee, all.ve, all.vv];
        Ok(kinds.map(|pairs| pairs.iter().flat_map(|p| [p.a, p.b]).collect()))
    }
    Intersect asks: false, |_, session, x0, _x1| -> Vec<u32> {
        let all = session.intersections(x0)?;
        Ok(all.iter().flat_map(|found| [found.edge, found.face]).collect())
    }
    Intersects asks: false, |_, session, x0, _x1| -> bool { Ok(session.has_intersections(x0)?) }
}
