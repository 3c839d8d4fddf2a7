//! Options of a session: Python's arguments by name, and back.

use crate::arrays::flags;
use crate::bodies::{Bodies, bodies};
use crate::errors::refused;
use ccd::Mode;
use ccd::method::{
    BroadPhaseMethod, Builder, Catalogued, Front, Pipeline, Row, Scheduler, Scheduling, Traversal,
    TreeOptions, Volume,
};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};

/// Names of a tree's choices, which imply the method.
const OF_TREES: [&str; 3] = ["builder", "traversal", "volume"];

/// What a session looks for, and how. Options do not change; a session takes others by
/// `Session.set_options`.
///
/// Parameters
/// ----------
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
/// max_memory : int, optional
///     Bytes that the session may hold; by default there is no limit. What would go beyond is
///     refused before it is allocated, and the session stays usable.
/// tolerance : float
///     How early a certain time of impact may be, in units of the step; at least 1e-12. By default
///     1e-6.
/// mode : str
///     How times of impact are found: "exact", the true ones, rounded down, without a minimum
///     distance; "conservative", early by the tolerance at most; or "auto", the default, which is
///     exact on the CPU if there is no minimum distance, else conservative. Contacts are the same.
/// leave_contact : bool
///     Whether features that are in contact at the start may separate: no contact, unless they
///     come nearer or touch again.
/// method, builder, traversal, volume, pipeline, scheduler, front : str, optional
///     How pairs are found, by the names that `methods()` returns. All find the same contacts.
///
/// Raises
/// ------
/// ValueError
///     If an option is not one of its names. What does not fit a mesh is refused by `Session`.
#[pyclass(frozen, module = "meshccd")]
pub struct Options {
    pub inner: ccd::Options,
}

#[pymethods]
impl Options {
    #[new]
    #[pyo3(signature = (**given))]
    #[pyo3(text_signature = "(*, min_distance=None, threads=None, bodies=None, fixed=None, \
        self_contact=None, max_memory=None, tolerance=None, mode=None, leave_contact=None, \
        method=None, builder=None, traversal=None, volume=None, pipeline=None, scheduler=None, \
        front=None)")]
    fn new(py: Python<'_>, given: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let given = given.map_or_else(|| Ok(PyDict::new(py)), |given| given.copy())?;
        Ok(Self { inner: changed("Options", ccd::Options::default(), &given)? })
    }

    /// Contact means a distance of at most this.
    #[getter]
    fn min_distance(&self) -> f64 {
        self.inner.min_distance
    }

    /// Threads on the CPU, 0 for all cores.
    #[getter]
    fn threads(&self) -> usize {
        self.inner.threads
    }

    /// Bodies and the rules of their pairs, if there are any.
    #[getter]
    fn bodies(&self) -> Option<Bodies> {
        self.inner.bodies.clone().map(|inner| Bodies { inner })
    }

    /// Bytes that a session may hold.
    #[getter]
    fn max_memory(&self) -> Option<u64> {
        self.inner.max_memory
    }

    /// How early a certain time of impact may be.
    #[getter]
    fn tolerance(&self) -> f64 {
        self.inner.tolerance
    }

    /// "auto", "conservative" or "exact".
    #[getter]
    fn mode(&self) -> &'static str {
        self.inner.mode.name()
    }

    /// Whether features that are in contact at the start may separate.
    #[getter]
    fn leave_contact(&self) -> bool {
        self.inner.leave_contact
    }

    /// The broad phase; of a tree with its builder, its traversal and its volume.
    #[getter]
    fn method(&self) -> String {
        self.inner.broad_phase.to_string()
    }

    /// What is looked for in boxes: pairs of features, or of triangles.
    #[getter]
    fn pipeline(&self) -> &'static str {
        self.inner.pipeline.row().name
    }

    /// How work is shared out; None: as the method does by itself.
    #[getter]
    fn scheduler(&self) -> Option<&'static str> {
        self.inner.scheduling.scheduler.map(|scheduler| scheduler.row().name)
    }

    /// Whether descents begin where the last ones ended.
    #[getter]
    fn front(&self) -> &'static str {
        self.inner.scheduling.front.row().name
    }

    /// All options as text that `from_json` reads, bodies with their rules too.
    fn to_json(&self) -> PyResult<String> {
        serde_json::to_string(&self.inner).map_err(refused)
    }

    /// Options from the text of `to_json`.
    #[staticmethod]
    fn from_json(text: &str) -> PyResult<Self> {
        Ok(Self { inner: serde_json::from_str(text).map_err(refused)? })
    }

    fn __reduce__<'py>(of: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        Ok((PyType::new::<Self>(of.py()).getattr("from_json")?, (of.get().to_json()?,)))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().inner == self.inner)
    }

    fn __repr__(&self) -> String {
        let Self { inner } = self;
        let (mode, distance, tolerance) = (inner.mode.name(), inner.min_distance, inner.tolerance);
        format!("<Options: {mode}, min_distance {distance}, tolerance {tolerance}>")
    }
}

/// Ends the calls of sessions that have it, from any thread: see `Session.set_cancel_token`.
#[pyclass(frozen, module = "meshccd")]
pub struct CancelToken {
    pub inner: ccd::CancelToken,
}

#[pymethods]
impl CancelToken {
    #[new]
    fn new() -> Self {
        Self { inner: ccd::CancelToken::new() }
    }

    /// Ends the calls that run, and all later ones, of sessions that have it.
    fn cancel(&self) {
        self.inner.cancel();
    }

    /// Whether it is cancelled.
    #[getter]
    fn is_cancelled(&self) -> bool {
        self.inner.is_cancelled()
    }
}

/// What a caller has given as options, or the default.
pub fn inner(given: Option<&Bound<'_, Options>>) -> ccd::Options {
    given.map_or_else(ccd::Options::default, |options| options.get().inner.clone())
}

/// Options with what was given by name to a function of Python.
pub fn changed(
    function: &str,
    mut options: ccd::Options,
    given: &Bound<'_, PyDict>,
) -> PyResult<ccd::Options> {
    let value = |name: &str| value(given, name);
    check_names(function, &NAMES, given)?;
    if let Some(distance) = value("min_distance")? {
        options = options.with_min_distance(distance.extract()?);
    }
    if let Some(tolerance) = value("tolerance")? {
        options = options.with_tolerance(tolerance.extract()?);
    }
    if let Some(leaves) = value("leave_contact")? {
        options = options.with_leave_contact(leaves.extract()?);
    }
    if let Some(mode) = value("mode")? {
        options = options.with_mode(mode_named(&mode.extract::<String>()?)?);
    }
    if let Some(bytes) = value("max_memory")? {
        options = options.with_max_memory(bytes.extract::<u64>()?);
    }
    if let Some(threads) = value("threads")? {
        options = options.with_threads(threads.extract()?);
    }

    if let Some(given) = value("bodies")? {
        options = options.with_bodies(bodies(&given)?);
    }
    let (fixed, self_contact) = (value("fixed")?, value("self_contact")?);
    if fixed.is_some() || self_contact.is_some() {
        let Some(mut all) = options.bodies.take() else {
            return Err(refused("fixed and self_contact say something of bodies: give bodies too"));
        };
        if let Some(fixed) = fixed {
            all = all.with_fixed_mask(&flags("fixed", &fixed, "body")?);
        }
        if let Some(self_contact) = self_contact {
            all = all.with_self_contacts(self_contact.extract()?);
        }
        options = options.with_bodies(all);
    }

    if let Some(pipeline) = named::<Pipeline>(given, "pipeline")? {
        options = options.with_pipeline(pipeline);
    }
    let (method, scheduling) = method(options.broad_phase, options.scheduling, given)?;
    Ok(options.with_broad_phase(method).with_scheduling(scheduling))
}

/// A broad phase and its scheduling with what was given by name.
pub fn method(
    method: BroadPhaseMethod,
    mut scheduling: Scheduling,
    given: &Bound<'_, PyDict>,
) -> PyResult<(BroadPhaseMethod, Scheduling)> {
    let wanted = named::<BroadPhaseMethod>(given, "method")?;
    let of_tree = OF_TREES.iter().find(|name| matches!(value(given, name), Ok(Some(_))));
    let method = match (of_tree, wanted) {
        (None, wanted) => wanted.unwrap_or(method),
        (Some(_), None | Some(BroadPhaseMethod::Tree(_))) => {
            let mut tree = match method {
                BroadPhaseMethod::Tree(tree) => tree,
                _ => TreeOptions::default(),
            };
            if let Some(builder) = named::<Builder>(given, "builder")? {
                tree = tree.builder(builder);
            }
            if let Some(traversal) = named::<Traversal>(given, "traversal")? {
                tree = tree.traversal(traversal);
            }
            if let Some(volume) = named::<Volume>(given, "volume")? {
                tree = tree.volume(volume);
            }
            BroadPhaseMethod::Tree(tree)
        }
        (Some(name), Some(other)) => {
            let method = other.row().name;
            return Err(refused(format!("{name} is for the method \"tree\", not {method:?}")));
        }
    };
    if let Some(scheduler) = named::<Scheduler>(given, "scheduler")? {
        scheduling = scheduling.scheduler(scheduler);
    }
    if let Some(front) = named::<Front>(given, "front")? {
        scheduling = scheduling.front(front);
    }
    Ok((method, scheduling))
}

/// The choices of methods: dicts with what is chosen ("method", "builder", "traversal", "volume",
/// "pipeline", "scheduler" or "front"), its name, a line about it, its source (None: this project),
/// the backends that have it, and whether it is of the feature `catalogue`, without which a module
/// may have been built.
#[pyfunction]
pub fn methods(py: Python<'_>) -> PyResult<Vec<Bound<'_, PyDict>>> {
    let mut all = rows::<BroadPhaseMethod>(py, "method")?;
    all.extend(rows::<Builder>(py, "builder")?);
    all.extend(rows::<Traversal>(py, "traversal")?);
    all.extend(rows::<Volume>(py, "volume")?);
    all.extend(rows::<Pipeline>(py, "pipeline")?);
    all.extend(rows::<Scheduler>(py, "scheduler")?);
    all.extend(rows::<Front>(py, "front")?);
    Ok(all)
}

fn rows<'py, T: Catalogued>(py: Python<'py>, what: &str) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let row = |row: &Row<T>| {
        let all = PyDict::new(py);
        all.set_item("what", what)?;
        all.set_item("name", row.name)?;
        all.set_item("about", row.about)?;
        all.set_item("source", row.source)?;
        all.set_item("backends", row.backends)?;
        all.set_item("catalogue", !T::ALWAYS.contains(&row.name))?;
        Ok(all)
    };
    T::ROWS.iter().map(row).collect()
}

/// The mode of a name.
fn mode_named(name: &str) -> PyResult<Mode> {
    Mode::ALL.into_iter().find(|mode| mode.name() == name).ok_or_else(|| {
        let names = Mode::ALL.map(|mode| mode.name()).join(", ");
        refused(format!("mode is {name:?}; it must be one of {names}"))
    })
}

/// Names of options that choose no method.
const NAMES: [&str; 10] = [
    "min_distance",
    "threads",
    "bodies",
    "fixed",
    "self_contact",
    "max_memory",
    "tolerance",
    "mode",
    "leave_contact",
    "pipeline",
];

/// Those that choose one.
const NAMES_OF_METHODS: [&str; 6] =
    ["method", "builder", "traversal", "volume", "scheduler", "front"];

/// Refuses names that are none of `names`, nor of what chooses a method.
pub fn check_names(function: &str, names: &[&str], given: &Bound<'_, PyDict>) -> PyResult<()> {
    for (name, _) in given.iter() {
        let name: String = name.extract()?;
        if !names.contains(&&name[..]) && !NAMES_OF_METHODS.contains(&&name[..]) {
            let why = format!("{function}() got an unexpected keyword argument '{name}'");
            return Err(PyTypeError::new_err(why));
        }
    }
    Ok(())
}

/// What was given by a name, unless it is None.
fn value<'py>(given: &Bound<'py, PyDict>, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
    Ok(given.get_item(name)?.filter(|value| !value.is_none()))
}

/// The choice of a name that was given, or all names that there are.
fn named<T: Catalogued>(given: &Bound<'_, PyDict>, what: &str) -> PyResult<Option<T>> {
    let Some(name) = value(given, what)? else { return Ok(None) };
    let name: String = name.extract()?;
    let found = T::named(&name).ok_or_else(|| {
        let names: Vec<_> = T::ROWS.iter().map(|row: &Row<T>| row.name).collect();
        refused(format!("{what} is {name:?}; it must be one of {}", names.join(", ")))
    });
    found.map(Some)
}
