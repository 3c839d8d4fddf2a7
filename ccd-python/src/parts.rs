//! Plain results: classes of parts with names, made of a dict of all of them, as pickle does.

use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A class of these parts. Its methods `new` and `__getnewargs_ex__` call `of_parts` and `parts`.
macro_rules! result {
    ($(#[$doc:meta])* $class:ident: $($(#[$of_part:meta])* $name:ident: $of:ty,)*) => {
        $(#[$doc])*
        #[pyclass(frozen, get_all, module = "meshccd")]
        pub struct $class {
            $($(#[$of_part])* $name: $of,)*
        }

        impl $class {
            fn of_parts(parts: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
                let part = |name| crate::parts::part(stringify!($class), parts, name);
                Ok(Self {
                    $($name: part(stringify!($name))?.extract::<$of>().map_err(PyErr::from)?,)*
                })
            }

            fn parts<'py>(of: &Bound<'py, Self>) -> PyResult<((), Bound<'py, PyDict>)> {
                let parts = PyDict::new(of.py());
                $(parts.set_item(stringify!($name), of.getattr(stringify!($name))?)?;)*
                Ok(((), parts))
            }
        }
    };
}
pub(crate) use result;

/// A part that has to be there.
pub fn part<'py>(
    class: &str,
    parts: Option<&Bound<'py, PyDict>>,
    name: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let missing = || PyTypeError::new_err(format!("{class}() lacks {name}; sessions make these"));
    parts.map(|parts| parts.get_item(name)).transpose()?.flatten().ok_or_else(missing)
}
