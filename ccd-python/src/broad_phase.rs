//! Boxes in, overlapping pairs out.

use crate::arrays::{Floats, numbers, pair_array};
use crate::errors::{failed, lock, refused};
use crate::options::by_name;
use crate::session::backend;
use ccd::Aabb;
use ccd::any::{self, Backend};
use ccd::method::BroadPhaseMethod;
use numpy::PyArray2;
use pyo3::prelude::*;
use std::sync::Mutex;

/// Finds overlapping boxes; keeps its buffers between calls. Overlap is closed: boxes that touch
/// are a pair.
///
/// Boxes are arrays of shape (n, 2, 3): the least corner, then the greatest. As positions of a
/// Session they are read where they are if they are C-ordered float32 or float64, else copied.
///
/// Parameters
/// ----------
/// threads : int
///     Threads on the CPU: 0 for all cores, 1 for the calling thread alone.
/// method : str
///     "blocks", "tree", "sweep-and-prune", "uniform-grid" or "brute-force"; on a CPU also
///     "sweep-in-strips" and "sweep-and-tiniest-queue", on a GPU "sweep-by-end-points"; all find
///     the same pairs.
/// device : str, optional
///     None or "cpu"; "gpu", an error if there is none. Boxes on a GPU are float32.
///
/// Raises
/// ------
/// ValueError
///     If there is no such method, or not on that device.
/// RuntimeError
///     If there is no GPU and one was asked for.
#[pyclass(frozen, module = "meshccd")]
pub struct BroadPhase {
    inner: Mutex<On>,
}

/// On the CPU, with boxes of either precision, or on a GPU.
enum On {
    Cpu(Box<ccd::BroadPhase>),
    Gpu(Box<any::BroadPhase>),
}

#[pymethods]
impl BroadPhase {
    #[new]
    #[pyo3(signature = (*, threads=0, method="blocks", device=None))]
    fn new(py: Python<'_>, threads: usize, method: &str, device: Option<&str>) -> PyResult<Self> {
        let method: BroadPhaseMethod = by_name("method", method)?;
        let on = match backend(device)? {
            Backend::Cpu => {
                let inner = ccd::BroadPhase::new(threads, method).map_err(refused)?;
                On::Cpu(Box::new(inner))
            }
            Backend::Gpu => {
                let inner =
                    py.detach(|| any::BroadPhase::new(&Backend::Gpu.choose(0)?, threads, method));
                On::Gpu(Box::new(inner.map_err(failed)?))
            }
            _ => {
                return Err(refused("a broad phase has to be told its device, \"cpu\" or \"gpu\""));
            }
        };
        Ok(Self { inner: Mutex::new(on) })
    }

    /// Pairs within one set of boxes, each once, the lesser index first: an array of shape (n, 2),
    /// uint32, in no particular order.
    fn self_pairs<'py>(
        &self,
        py: Python<'py>,
        boxes: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let boxes = Floats::new([("boxes", boxes)], &[2, 3])?.in_rows(["boxes"], &[2, 3])?;
        let pairs = match &boxes {
            Floats::F32([boxes]) => {
                let boxes: &[Aabb<f32>] = bytemuck::cast_slice(numbers(boxes)?);
                py.detach(|| match &mut *lock(&self.inner)? {
                    On::Cpu(on) => Ok(flat(on.self_pairs(boxes).map_err(refused)?.iter())),
                    On::Gpu(on) => Ok(flat(on.self_pairs(boxes).map_err(failed)?.iter())),
                })
            }
            Floats::F64([boxes]) => {
                let boxes: &[Aabb<f64>] = bytemuck::cast_slice(numbers(boxes)?);
                py.detach(|| match &mut *lock(&self.inner)? {
                    On::Cpu(on) => Ok(flat(on.self_pairs(boxes).map_err(refused)?.iter())),
                    On::Gpu(_) => Err(not_single()),
                })
            }
        };
        pair_array(py, pairs?)
    }

    /// Pairs of a box of `a` with a box of `b`: an array of shape (n, 2), uint32, in no particular
    /// order.
    fn pairs<'py>(
        &self,
        py: Python<'py>,
        a: &Bound<'py, PyAny>,
        b: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<u32>>> {
        let boxes = Floats::new([("a", a), ("b", b)], &[2, 3])?.in_rows(["a", "b"], &[2, 3])?;
        let pairs = match &boxes {
            Floats::F32([a, b]) => {
                let a: &[Aabb<f32>] = bytemuck::cast_slice(numbers(a)?);
                let b: &[Aabb<f32>] = bytemuck::cast_slice(numbers(b)?);
                py.detach(|| match &mut *lock(&self.inner)? {
                    On::Cpu(on) => Ok(flat(on.pairs(a, b).map_err(refused)?.iter())),
                    On::Gpu(on) => Ok(flat(on.pairs(a, b).map_err(failed)?.iter())),
                })
            }
            Floats::F64([a, b]) => {
                let a: &[Aabb<f64>] = bytemuck::cast_slice(numbers(a)?);
                let b: &[Aabb<f64>] = bytemuck::cast_slice(numbers(b)?);
                py.detach(|| match &mut *lock(&self.inner)? {
                    On::Cpu(on) => Ok(flat(on.pairs(a, b).map_err(refused)?.iter())),
                    On::Gpu(_) => Err(not_single()),
                })
            }
        };
        pair_array(py, pairs?)
    }
}

fn flat(pairs: impl Iterator<Item = ccd::Pair>) -> Vec<u32> {
    pairs.flat_map(|pair| [pair.a, pair.b]).collect()
}

fn not_single() -> PyErr {
    refused("boxes on a GPU are float32: round their corners outward first")
}
