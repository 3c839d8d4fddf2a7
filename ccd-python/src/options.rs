//! Options of a session: Python's arguments by name, and back.

use crate::bodies::bodies;
use crate::errors::refused;
use ccd::method::{
    BroadPhaseMethod, Builder, Catalogued, Front, Pipeline, Row, Scheduler, Scheduling, Traversal,
    TreeOptions, Volume,
};
use ccd::{Mode, Options};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Names of a tree's choices, which imply the method.
const OF_TREES: [&str; 3] = ["builder", "traversal", "volume"];

/// Options from what was given by name; `device` is not theirs.
pub fn options(given: &Bound<'_, PyDict>) -> PyResult<Options> {
    let value = |name: &str| -> PyResult<Option<Bound<'_, PyAny>>> {
        Ok(given.get_item(name)?.filter(|value| !value.is_none()))
    };
    for (name, _) in given.iter() {
        let name: String = name.extract()?;
        if !NAMES.contains(&&name[..]) {
            let why = format!("Session() got an unexpected keyword argument '{name}'");
            return Err(PyTypeError::new_err(why));
        }
    }
    let mut options = Options::default();
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
    let threads = value("threads")?.map_or(Ok(0), |threads| threads.extract())?;
    options = options.with_threads(in_this_process(threads));

    let (fixed, self_contact) = (value("fixed")?, value("self_contact")?);
    if let Some(given) = value("bodies")? {
        let mut all = bodies(&given)?;
        if let Some(fixed) = fixed {
            all = all.with_fixed_mask(&fixed.extract::<Vec<bool>>()?);
        }
        if let Some(self_contact) = self_contact {
            all = all.with_self_contacts(self_contact.extract()?);
        }
        options = options.with_bodies(all);
    } else if fixed.is_some() || self_contact.is_some() {
        return Err(refused("fixed and self_contact say something of bodies: give bodies too"));
    }

    let method = named::<BroadPhaseMethod>("method", value("method")?)?;
    let of_tree = OF_TREES.iter().find(|name| matches!(value(name), Ok(Some(_))));
    let method = match (of_tree, method) {
        (None, method) => method.unwrap_or_default(),
        (Some(_), None | Some(BroadPhaseMethod::Tree(_))) => BroadPhaseMethod::Tree(
            TreeOptions::default()
                .builder(named::<Builder>("builder", value("builder")?)?.unwrap_or_default())
                .traversal(
                    named::<Traversal>("traversal", value("traversal")?)?.unwrap_or_default(),
                )
                .volume(named::<Volume>("volume", value("volume")?)?.unwrap_or_default()),
        ),
        (Some(name), Some(other)) => {
            let method = other.row().name;
            return Err(refused(format!("{name} is for the method \"tree\", not {method:?}")));
        }
    };
    let mut scheduling = Scheduling::default();
    if let Some(scheduler) = named::<Scheduler>("scheduler", value("scheduler")?)? {
        scheduling = scheduling.scheduler(scheduler);
    }
    if let Some(front) = named::<Front>("front", value("front")?)? {
        scheduling = scheduling.front(front);
    }
    let pipeline = named::<Pipeline>("pipeline", value("pipeline")?)?.unwrap_or_default();
    Ok(options.with_broad_phase(method).with_pipeline(pipeline).with_scheduling(scheduling))
}

/// The mode of a name.
fn mode_named(name: &str) -> PyResult<Mode> {
    Mode::ALL.into_iter().find(|mode| mode.name() == name).ok_or_else(|| {
        let names = Mode::ALL.map(|mode| mode.name()).join(", ");
        refused(format!("mode is {name:?}; it must be one of {names}"))
    })
}

/// All names of options.
const NAMES: [&str; 17] = [
    "min_distance",
    "threads",
    "bodies",
    "fixed",
    "self_contact",
    "device",
    "max_memory",
    "tolerance",
    "mode",
    "leave_contact",
    "method",
    "builder",
    "traversal",
    "volume",
    "pipeline",
    "scheduler",
    "front",
];

/// The value of a name.
fn named<T: Catalogued>(what: &str, given: Option<Bound<'_, PyAny>>) -> PyResult<Option<T>> {
    given.map(|name| by_name(what, &name.extract::<String>()?)).transpose()
}

/// The value of a name, or all names that there are.
pub fn by_name<T: Catalogued>(what: &str, name: &str) -> PyResult<T> {
    T::named(name).ok_or_else(|| {
        let names: Vec<_> = T::ROWS.iter().map(|row: &Row<T>| row.name).collect();
        refused(format!("{what} is {name:?}; it must be one of {}", names.join(", ")))
    })
}

/// The process that has loaded the module.
static LOADED_BY: std::sync::OnceLock<u32> = std::sync::OnceLock::new();

/// Notes the process that loads the module.
pub fn loaded() {
    LOADED_BY.get_or_init(std::process::id);
}

/// A number of threads that works here. "All cores" are those of a pool that all sessions share;
/// a child made by a fork has the pool without its threads, and gets one for each session.
fn in_this_process(threads: usize) -> usize {
    if threads != 0 || LOADED_BY.get() == Some(&std::process::id()) {
        return threads;
    }
    std::thread::available_parallelism().map_or(1, usize::from)
}
