//! Processes and their threads: a child made by a fork has the pool that all calls share without
//! its threads, and would wait for them without end.

use crate::errors::lock;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::process::id;
use std::sync::{Mutex, OnceLock};

/// The process that has loaded the module.
static LOADED_BY: OnceLock<u32> = OnceLock::new();

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

/// What threads of Python use one after the other, in the process that made it.
pub struct Guarded<T> {
    inner: Mutex<T>,
    made_by: u32,
    /// What errors call it.
    what: &'static str,
}

impl<T: Send> Guarded<T> {
    /// One of this process.
    pub fn new(what: &'static str, inner: T) -> Self {
        Self { inner: Mutex::new(inner), made_by: id(), what }
    }

    /// Does something while no other thread does, without the interpreter; refused in a process
    /// that did not make it.
    pub fn with<R: Send>(
        &self,
        py: Python<'_>,
        act: impl FnOnce(&mut T) -> PyResult<R> + Send,
    ) -> PyResult<R> {
        if self.made_by != id() {
            return Err(PyRuntimeError::new_err(format!(
                "the {} was made before a fork, and its threads are not in this process: make a \
                 new one here, or start processes by \"spawn\"",
                self.what
            )));
        }
        py.detach(|| act(&mut *lock(&self.inner)?))
    }
}
