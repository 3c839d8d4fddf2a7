//! Processes and their threads: a child made by a fork has the pool that all calls share without
//! its threads, and would wait for them without end.

use pyo3::PyResult;
use pyo3::exceptions::PyRuntimeError;
use std::process::id;

/// The process that has loaded the module.
static LOADED_BY: std::sync::OnceLock<u32> = std::sync::OnceLock::new();

/// Notes the process that loads the module.
pub fn loaded() {
    LOADED_BY.get_or_init(id);
}

/// A number of threads that works here: "all cores" are those of the shared pool, or where that has
/// no threads of a pool for each object.
pub fn threads_here(threads: usize) -> usize {
    if threads != 0 || LOADED_BY.get() == Some(&id()) {
        return threads;
    }
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// The process that has made an object with threads.
pub struct MadeBy(u32);

impl MadeBy {
    /// This one.
    pub fn this() -> Self {
        Self(id())
    }

    /// Refuses another one.
    pub fn check(&self, what: &str) -> PyResult<()> {
        if self.0 == id() {
            return Ok(());
        }
        Err(PyRuntimeError::new_err(format!(
            "the {what} was made before a fork, and its threads are not in this process: make a \
             new one here, or start processes by \"spawn\""
        )))
    }
}
