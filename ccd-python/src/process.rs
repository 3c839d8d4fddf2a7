//! Processes and their threads: a child made by a fork has pools and devices without their threads,
//! and would wait for them without end.

use crate::errors::lock;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use std::process::id;
use std::sync::Mutex;

/// What threads of Python use one after the other, in the process that made it.
pub struct Guarded<T: Send> {
    /// There until it is dropped.
    inner: Option<Mutex<T>>,
    made_by: u32,
    /// What errors call it.
    what: &'static str,
}

impl<T: Send> Guarded<T> {
    /// One of this process.
    pub fn new(what: &'static str, inner: T) -> Self {
        Self { inner: Some(Mutex::new(inner)), made_by: id(), what }
    }

    /// Does something while no other thread does, without the interpreter; refused in a process
    /// that did not make it.
    pub fn with<R: Send>(
        &self,
        py: Python<'_>,
        act: impl FnOnce(&mut T) -> PyResult<R> + Send,
    ) -> PyResult<R> {
        let Some(inner) = self.inner.as_ref().filter(|_| self.made_by == id()) else {
            return Err(PyRuntimeError::new_err(format!(
                "the {} was made before a fork, and its threads are not in this process: make a \
                 new one here, or start processes by \"spawn\"",
                self.what
            )));
        };
        py.detach(|| act(&mut *lock(inner)?))
    }
}

impl<T: Send> Drop for Guarded<T> {
    /// Without the interpreter, because a device is waited for. In another process nothing ends:
    /// that would wait for threads that are not there, or take a device from the parent.
    fn drop(&mut self) {
        let inner = self.inner.take();
        if self.made_by == id() {
            Python::try_attach(|py| py.detach(|| drop(inner)));
        } else {
            std::mem::forget(inner);
        }
    }
}
