//! Bodies: which vertices belong together, and which pairs of them are looked at.

use crate::arrays::{flags, flat_ids, ids, kind_of};
use crate::errors::refused;
use crate::mesh::Mesh;
use ccd::{Groups, Kind};
use numpy::PyArray1;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyDict, PyType};

/// Bodies of a mesh and the rules of their pairs. An array with an entry for each body has that of
/// body i at place i; what is missing there is as by default.
///
/// Parameters
/// ----------
/// of_vertex : (n_vertices,) array of integers
///     The body that each vertex belongs to.
/// fixed : (n_bodies,) array of bool, optional
///     Bodies that do not move: pairs of them are not looked at, and a step in which one moves is
///     refused.
/// sleeping : (n_bodies,) array of bool, optional
///     Bodies that are as fixed ones until they wake.
/// self_contact : bool or (n_bodies,) array of bool
///     Whether pairs within a body are looked at.
/// memberships, filters : (n_bodies,) arrays of uint32, optional
///     Groups, a bit each: a body is a member of those of `memberships`, and looked at against
///     members of those of `filters`. Each of two bodies must want the other.
/// worlds : (n_bodies,) array of integers below 65536, optional
///     Bodies of two worlds are never looked at, wherever they are.
/// excluded_bodies : (n, 2) array of integers, optional
///     Pairs of bodies that are not looked at.
/// excluded_vertex_face, excluded_edge_edge : (n, 2) arrays of integers, optional
///     Pairs of features that are not looked at, by their ids in the mesh; see
///     `Mesh.neighbours` and `Mesh.near_at_rest`.
/// fixed_motion : bool
///     Whether bodies that are fixed or asleep may be moved by the caller.
///
/// Raises
/// ------
/// ValueError
///     If an array has another shape or type. What does not fit a mesh is refused by `Session`.
#[pyclass(frozen, module = "meshccd")]
pub struct Bodies {
    pub inner: ccd::Bodies,
}

#[pymethods]
impl Bodies {
    #[new]
    #[pyo3(signature = (of_vertex, **rules))]
    #[pyo3(text_signature = "(of_vertex, *, fixed=None, sleeping=None, self_contact=True, \
        memberships=None, filters=None, worlds=None, excluded_bodies=None, \
        excluded_vertex_face=None, excluded_edge_edge=None, fixed_motion=False)")]
    fn new(of_vertex: &Bound<'_, PyAny>, rules: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let py = of_vertex.py();
        let rules = rules.map_or_else(|| Ok(PyDict::new(py)), |rules| rules.copy())?;
        let names = flat_ids("of_vertex", of_vertex)?;
        Ok(Self { inner: with_rules(ccd::Bodies::new(&names), &names, &rules)? })
    }

    /// Static obstacles: vertices whose entry of `is_static`, an array of bool, is true are body 1,
    /// which is fixed; all others are body 0. Obstacles are tested against what moves alone.
    #[staticmethod]
    fn of_obstacles(is_static: &Bound<'_, PyAny>) -> PyResult<Self> {
        let is_static = flags("is_static", is_static, "vertex")?;
        let of_vertex: Vec<u32> = is_static.into_iter().map(u32::from).collect();
        Ok(Self { inner: ccd::Bodies::new(&of_vertex).with_fixed_mask(&[false, true]) })
    }

    /// Patches of vertices: each is a body, without self-contact. `patches` has that of each
    /// vertex.
    #[staticmethod]
    fn of_patches(patches: &Bound<'_, PyAny>) -> PyResult<Self> {
        Self::new(patches, Some(&[("self_contact", false)].into_py_dict(patches.py())?))
    }

    /// Connected components of a mesh: vertices that a path of edges joins are a body. They are
    /// numbered from 0 in the order of their first vertices. `self_contact`: whether pairs within a
    /// component are looked at.
    #[staticmethod]
    #[pyo3(signature = (mesh, self_contact=true))]
    fn of_components(mesh: &Bound<'_, Mesh>, self_contact: bool) -> Self {
        let (py, mesh) = (mesh.py(), &mesh.get().inner);
        let bodies = py.detach(|| ccd::Bodies::of_components(mesh));
        Self { inner: bodies.with_self_contacts(self_contact) }
    }

    /// The body of each vertex: a new array of shape (n_vertices,), uint32.
    #[getter]
    fn of_vertex<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        PyArray1::from_slice(py, self.inner.body_of_vertex())
    }

    /// Whether pairs of features of the bodies of these two vertices are looked at.
    fn wants(&self, v: u32, w: u32) -> PyResult<bool> {
        Ok(self.inner.wants(self.vertex(v)?, self.vertex(w)?))
    }

    /// Whether a pair of features is excluded, by its `Kind` and the ids of both.
    fn excludes(&self, kind: u8, a: u32, b: u32) -> PyResult<bool> {
        Ok(self.inner.excludes(kind_of(kind)?, a, b))
    }

    /// Whether the body of a vertex is fixed.
    fn is_fixed(&self, v: u32) -> PyResult<bool> {
        Ok(self.inner.is_fixed(self.vertex(v)?))
    }

    /// The world of a vertex.
    fn world(&self, v: u32) -> PyResult<u32> {
        Ok(self.inner.world(self.vertex(v)?))
    }

    /// Whether bodies that are fixed or asleep may be moved by the caller.
    #[getter]
    fn fixed_motion(&self) -> bool {
        self.inner.fixed_may_move()
    }

    /// The body of each vertex and all rules as text that `from_json` reads.
    fn to_json(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| serde_json::to_string(&self.inner)).map_err(refused)
    }

    /// Bodies from the text of `to_json`.
    #[staticmethod]
    fn from_json(py: Python<'_>, text: &str) -> PyResult<Self> {
        Ok(Self { inner: py.detach(|| serde_json::from_str(text)).map_err(refused)? })
    }

    fn __reduce__<'py>(of: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, (String,))> {
        Ok((PyType::new::<Self>(of.py()).getattr("from_json")?, (of.get().to_json(of.py())?,)))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().inner == self.inner)
    }

    fn __repr__(&self) -> String {
        let names = self.inner.body_of_vertex();
        let mut all = names.to_vec();
        all.sort_unstable();
        all.dedup();
        format!("<Bodies: {} of {} vertices>", all.len(), names.len())
    }
}

impl Bodies {
    /// A vertex that is there.
    fn vertex(&self, v: u32) -> PyResult<u32> {
        let n = self.inner.body_of_vertex().len();
        if (v as usize) < n { Ok(v) } else { Err(refused(format!("vertex {v} of {n}"))) }
    }
}

/// Rules in the order in which they are applied, whatever a caller's: what excludes a body from
/// itself comes after what lets it touch itself.
const RULES: [&str; 10] = [
    "fixed",
    "sleeping",
    "self_contact",
    "memberships",
    "filters",
    "worlds",
    "excluded_bodies",
    "excluded_vertex_face",
    "excluded_edge_edge",
    "fixed_motion",
];

fn with_rules(
    mut bodies: ccd::Bodies,
    names: &[u32],
    rules: &Bound<'_, PyDict>,
) -> PyResult<ccd::Bodies> {
    // Rules name bodies; an entry of a body that no vertex belongs to says nothing.
    let mut all = names.to_vec();
    all.sort_unstable();
    all.dedup();
    let of_bodies = |n: usize| all.iter().copied().take_while(move |&body| (body as usize) < n);
    let (mut memberships, mut filters) = (Vec::new(), Vec::new());
    let py = rules.py();
    for name in rules.keys() {
        let name: String = name.extract()?;
        if !RULES.contains(&&*name) {
            let why = format!("Bodies() got an unexpected keyword argument '{name}'");
            return Err(PyTypeError::new_err(why));
        }
    }
    for name in RULES {
        let Some(given) = rules.get_item(name)?.filter(|given| !given.is_none()) else { continue };
        match name {
            "fixed" => bodies = bodies.with_fixed_mask(&flags(name, &given, "body")?),
            "sleeping" => {
                let sleeping = flags(name, &given, "body")?;
                for body in of_bodies(sleeping.len()) {
                    bodies = bodies.with_sleeping(body, sleeping[body as usize]);
                }
            }
            "self_contact" => match given.extract::<bool>() {
                Ok(self_contact) => bodies = bodies.with_self_contacts(self_contact),
                Err(_) => {
                    let each = flags(name, &given, "body")?;
                    for body in of_bodies(each.len()) {
                        bodies = bodies.with_self_contact(body, each[body as usize]);
                    }
                }
            },
            "memberships" => memberships = flat_ids(name, &given)?,
            "filters" => filters = flat_ids(name, &given)?,
            "worlds" => bodies = bodies.with_worlds(&flat_ids(name, &given)?),
            "excluded_bodies" => bodies = bodies.with_excluded_bodies(&ids::<2>(name, &given)?),
            "excluded_vertex_face" => {
                let pairs = ids::<2>(name, &given)?;
                bodies = py.detach(|| bodies.with_excluded_features(Kind::VertexFace, &pairs));
            }
            "excluded_edge_edge" => {
                let pairs = ids::<2>(name, &given)?;
                bodies = py.detach(|| bodies.with_excluded_features(Kind::EdgeEdge, &pairs));
            }
            "fixed_motion" => bodies = bodies.with_fixed_motion(given.extract()?),
            _ => {}
        }
    }
    for body in of_bodies(memberships.len().max(filters.len())) {
        let of = |words: &[u32]| words.get(body as usize).copied().unwrap_or(u32::MAX);
        let groups = Groups { memberships: of(&memberships), filter: of(&filters) };
        bodies = bodies.with_groups(body, groups);
    }
    Ok(bodies)
}

/// What a caller gives as bodies: an object with rules, or the body of each vertex.
pub fn bodies(given: &Bound<'_, PyAny>) -> PyResult<ccd::Bodies> {
    match given.cast::<Bodies>() {
        Ok(bodies) => Ok(bodies.get().inner.clone()),
        Err(_) => Ok(ccd::Bodies::new(&flat_ids("bodies", given)?)),
    }
}
