//! Our messages as Python's exceptions: `ValueError` for input, `RuntimeError` for a device and for
//! a call that was cancelled.

use ccd::any;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::fmt::Display;
use std::sync::{Mutex, MutexGuard};

/// Input that is refused, with our message.
pub fn refused(why: impl Display) -> PyErr {
    PyValueError::new_err(why.to_string())
}

/// Input that is refused: positions by the names of the arguments, `x0` and `x1`.
pub fn input(why: ccd::Error) -> PyErr {
    let mut text = why.to_string();
    for (time, name) in [("t0", "x0"), ("t1", "x1")] {
        text = text.replace(&format!(" at {time} "), &format!(" of {name} "));
        if let Some(rest) = text.strip_prefix(time) {
            text = format!("{name}{rest}");
        }
    }
    refused(text)
}

/// The error of a call that has one array of positions, whose name is `x`.
pub fn of_one(py: Python<'_>, error: PyErr) -> PyErr {
    if !error.is_instance_of::<PyValueError>(py) {
        return error;
    }
    refused(error.value(py).to_string().replace("x0", "x").replace("x1", "x"))
}

/// Input that is refused, or a device that did not do what was asked.
pub fn failed(why: any::Error) -> PyErr {
    match why {
        any::Error::Input(why @ ccd::Error::Cancelled) => PyRuntimeError::new_err(why.to_string()),
        any::Error::Input(why) => input(why),
        why => PyRuntimeError::new_err(why.to_string()),
    }
}

/// What a mutex guards; an error after a panic, which may have left anything in it.
pub fn lock<T>(mutex: &Mutex<T>) -> Result<MutexGuard<'_, T>, PyErr> {
    let broken = "an earlier call panicked: make a new object";
    mutex.lock().map_err(|_| PyRuntimeError::new_err(broken))
}
