//! Boxes in, overlapping pairs out.

use crate::arrays::{Floats, numbers, pair_array};
use crate::device;
use crate::errors::{failed, refused};
use crate::options;
use crate::process::Guarded;
use ccd::Aabb;
use ccd::any;
use ccd::method::{BroadPhaseMethod, Scheduling, TreeStatistics};
use numpy::PyArray2;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict};

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
/// device : str, optional
///     None or "cpu"; "gpu" or "gpu:NAME" as for a Session. Boxes on a GPU are float32.
/// method, builder, traversal, volume, scheduler, front : str, optional
///     How pairs are found, by the names that `methods()` returns; all find the same pairs.
///
/// Raises
/// ------
/// ValueError
///     If there is no such method, or not on that device.
/// RuntimeError
///     If there is no GPU and one was asked for.
#[pyclass(frozen, module = "meshccd")]
pub struct BroadPhase {
    inner: Guarded<On>,
}

/// On the CPU, with boxes of either precision, or on a GPU.
enum On {
    Cpu(Box<ccd::BroadPhase>),
    Gpu(Box<any::BroadPhase>),
}

#[pymethods]
impl BroadPhase {
    #[new]
    #[pyo3(signature = (*, threads=0, device=None, **given))]
    #[pyo3(text_signature = "(*, threads=0, device=None, method=None, builder=None, \
        traversal=None, volume=None, scheduler=None, front=None)")]
    fn new(
        py: Python<'_>,
        threads: usize,
        device: Option<&str>,
        given: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let given = given.map_or_else(|| Ok(PyDict::new(py)), |given| given.copy())?;
        options::check_names("BroadPhase", &[], &given)?;
        let (method, scheduling) =
            options::method(BroadPhaseMethod::default(), Scheduling::default(), &given)?;
        let on = match device {
            None | Some("cpu") => {
                let inner = ccd::BroadPhase::scheduled(threads, method, scheduling);
                On::Cpu(Box::new(inner.map_err(refused)?))
            }
            Some("auto") => {
                return Err(refused(
                    "a broad phase has to be told its device, \"cpu\", \"gpu\" or \"gpu:NAME\"",
                ));
            }
            device => {
                let choice = device::choose(py, device, 0)?;
                let inner =
                    py.detach(|| any::BroadPhase::scheduled(&choice, threads, method, scheduling));
                On::Gpu(Box::new(inner.map_err(failed)?))
            }
        };
        Ok(Self { inner: Guarded::new("broad phase", on) })
    }

    /// Where it runs: "2 threads", or the name of the GPU.
    #[getter]
    fn place(&self, py: Python<'_>) -> PyResult<String> {
        self.inner.with(py, |on| {
            Ok(match on {
                On::Cpu(on) => any::Place::Cpu { threads: on.threads() }.to_string(),
                On::Gpu(on) => on.place().to_string(),
            })
        })
    }

    /// Where the time of the last call went, in milliseconds: "build" and "search". None on a GPU.
    #[getter]
    fn times<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let times = self.inner.with(py, |on| Ok(on.cpu().map(|on| on.times())))?;
        let of =
            |t: ccd::BroadPhaseTimes| [("build", t.build), ("search", t.search)].into_py_dict(py);
        times.map(of).transpose()
    }

    /// How many nodes of a tree, or pairs of nodes, the last call visited; 0 by a method without a
    /// binary tree. None on a GPU.
    #[getter]
    fn visits(&self, py: Python<'_>) -> PyResult<Option<u64>> {
        self.inner.with(py, |on| Ok(on.cpu().map(|on| on.visits())))
    }

    /// Figures of the binary tree of the last call, by name: "nodes", "depth", "sah_cost",
    /// "visited_per_query". None if the method has none, and on a GPU.
    #[getter]
    fn tree_statistics<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let figures = self.inner.with(py, |on| Ok(on.cpu().and_then(|on| on.tree_statistics())))?;
        let of = |tree: TreeStatistics| {
            let all = [("sah_cost", tree.sah_cost), ("visited_per_query", tree.visited_per_query)];
            let all = all.into_py_dict(py)?;
            all.set_item("nodes", tree.nodes)?;
            all.set_item("depth", tree.depth)?;
            Ok(all)
        };
        figures.map(of).transpose()
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
                self.inner.with(py, |on| match on {
                    On::Cpu(on) => Ok(flat(on.self_pairs(boxes).map_err(refused)?.iter())),
                    On::Gpu(on) => Ok(flat(on.self_pairs(boxes).map_err(failed)?.iter())),
                })
            }
            Floats::F64([boxes]) => {
                let boxes: &[Aabb<f64>] = bytemuck::cast_slice(numbers(boxes)?);
                self.inner.with(py, |on| {
                    let on = on.cpu().ok_or_else(not_single)?;
                    Ok(flat(on.self_pairs(boxes).map_err(refused)?.iter()))
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
                self.inner.with(py, |on| match on {
                    On::Cpu(on) => Ok(flat(on.pairs(a, b).map_err(refused)?.iter())),
                    On::Gpu(on) => Ok(flat(on.pairs(a, b).map_err(failed)?.iter())),
                })
            }
            Floats::F64([a, b]) => {
                let a: &[Aabb<f64>] = bytemuck::cast_slice(numbers(a)?);
                let b: &[Aabb<f64>] = bytemuck::cast_slice(numbers(b)?);
                self.inner.with(py, |on| {
                    let on = on.cpu().ok_or_else(not_single)?;
                    Ok(flat(on.pairs(a, b).map_err(refused)?.iter()))
                })
            }
        };
        pair_array(py, pairs?)
    }
}

impl On {
    /// The CPU's, which alone has figures and takes `f64`.
    fn cpu(&mut self) -> Option<&mut ccd::BroadPhase> {
        match self {
            Self::Cpu(on) => Some(on),
            Self::Gpu(_) => None,
        }
    }
}

fn flat(pairs: impl Iterator<Item = ccd::Pair>) -> Vec<u32> {
    pairs.flat_map(|pair| [pair.a, pair.b]).collect()
}

fn not_single() -> PyErr {
    refused("boxes on a GPU are float32: round their corners outward first")
}
