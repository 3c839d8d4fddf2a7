//! Geometry of all contacts of a report, as columns.

use crate::arrays::{Floats, kind_of, numbers};
use crate::errors::{input, refused};
use crate::hit::state_number;
use crate::parts::result;
use ccd::{Contact, Coordinate, Kind, Mesh, State};
use numpy::{Element, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

result! {
    /// How features meet at the times of impact: arrays with an entry for each contact.
    Geometry:
    /// Halfway between the nearest points, (n, 3) float64.
    point: Py<PyArray2<f64>>,
    /// Unit vector from `b` towards `a`: pushing `a` along it parts the two, (n, 3) float64.
    normal: Py<PyArray2<f64>>,
    /// Of the vertices in `Report.vertices`, in the nearest point of their feature: (n, 4) float64.
    weights: Py<PyArray2<f64>>,
    /// The nearest point of `a`, (n, 3) float64.
    on_a: Py<PyArray2<f64>>,
    /// The nearest point of `b`, (n, 3) float64.
    on_b: Py<PyArray2<f64>>,
    /// Between the nearest points, (n,) float64.
    distance: Py<PyArray1<f64>>,
}

#[pymethods]
impl Geometry {
    #[new]
    #[pyo3(signature = (**parts))]
    fn of_names(parts: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        Self::of_parts(parts)
    }

    /// All parts by their names.
    fn __getnewargs_ex__<'py>(of: &Bound<'py, Self>) -> PyResult<((), Bound<'py, PyDict>)> {
        Self::parts(of)
    }
}

/// Contacts between two looks at what interrupts: some tenths of a second.
const CHUNK: usize = 1 << 14;

/// Columns that say which contacts.
pub struct Contacts<'py> {
    kind: PyReadonlyArray1<'py, u8>,
    state: PyReadonlyArray1<'py, u8>,
    a: PyReadonlyArray1<'py, u32>,
    b: PyReadonlyArray1<'py, u32>,
    toi: PyReadonlyArray1<'py, f64>,
}

impl<'py> Contacts<'py> {
    pub fn new(
        (kind, state): (&Bound<'py, PyArray1<u8>>, &Bound<'py, PyArray1<u8>>),
        (a, b): (&Bound<'py, PyArray1<u32>>, &Bound<'py, PyArray1<u32>>),
        toi: &Bound<'py, PyArray1<f64>>,
    ) -> PyResult<Self> {
        Ok(Self {
            kind: kind.try_readonly().map_err(refused)?,
            state: state.try_readonly().map_err(refused)?,
            a: a.try_readonly().map_err(refused)?,
            b: b.try_readonly().map_err(refused)?,
            toi: toi.try_readonly().map_err(refused)?,
        })
    }

    /// Where they are, from positions at both ends of the step.
    pub fn geometry(
        &self,
        py: Python<'_>,
        mesh: &Mesh,
        [x0, x1]: [&Bound<'_, PyAny>; 2],
    ) -> PyResult<Geometry> {
        let positions = Floats::new([("x0", x0), ("x1", x1)], &[3])?.in_rows(["x0", "x1"], &[3])?;
        match &positions {
            Floats::F32([x0, x1]) => self.of(py, mesh, [numbers(x0)?, numbers(x1)?]),
            Floats::F64([x0, x1]) => self.of(py, mesh, [numbers(x0)?, numbers(x1)?]),
        }
    }

    fn of<T: Coordinate + Element>(
        &self,
        py: Python<'_>,
        mesh: &Mesh,
        x: [&[T]; 2],
    ) -> PyResult<Geometry> {
        let [x0, x1] = x.map(|x| x.as_chunks().0);
        mesh.check_positions(x0, x1).map_err(input)?;
        let kind = self.kind.as_slice().map_err(refused)?;
        let (a, b) = (self.a.as_slice().map_err(refused)?, self.b.as_slice().map_err(refused)?);
        let toi = self.toi.as_slice().map_err(refused)?;
        let state = self.state.as_slice().map_err(refused)?;
        let undecided = state_number(State::Undecided);
        if [kind.len(), a.len(), b.len(), state.len()] != [toi.len(); 4] {
            return Err(refused("the columns of the report have different lengths"));
        }
        // The columns of a report can be written to.
        for ((&number, &a), &b) in kind.iter().zip(a).zip(b) {
            let [of_a, of_b] = match kind_of(number)? {
                Kind::VertexFace => [mesh.n_vertices(), mesh.faces().len()],
                Kind::EdgeEdge => [mesh.edges().len(); 2],
                Kind::VertexEdge => [mesh.n_vertices(), mesh.edges().len()],
                Kind::VertexVertex => [mesh.n_vertices(); 2],
            };
            if a as usize >= of_a || b as usize >= of_b {
                return Err(refused(format!("the mesh has no pair {a}, {b} of kind {number}")));
            }
        }
        let mut columns: [Vec<f64>; 6] = Default::default();
        for first in (0..toi.len()).step_by(CHUNK) {
            py.check_signals()?;
            py.detach(|| {
                for i in first..toi.len().min(first + CHUNK) {
                    let is_undecided = state[i] == undecided;
                    let state = if is_undecided { State::Undecided } else { State::Hit };
                    let kind = Kind::ALL[kind[i] as usize];
                    let at = Contact::new(kind, state, a[i], b[i], toi[i]).geometry(mesh, x0, x1);
                    let values: [&[f64]; 6] =
                        [&at.point, &at.normal, &at.weights, &at.on_a, &at.on_b, &[at.distance]];
                    columns.iter_mut().zip(values).for_each(|(column, v)| column.extend(v));
                }
            });
        }
        let [point, normal, weights, on_a, on_b, distance] = columns;
        let n = toi.len();
        let rows = |flat: Vec<f64>, width: usize| -> PyResult<Py<PyArray2<f64>>> {
            Ok(PyArray1::from_vec(py, flat).reshape([n, width])?.unbind())
        };
        Ok(Geometry {
            point: rows(point, 3)?,
            normal: rows(normal, 3)?,
            weights: rows(weights, 4)?,
            on_a: rows(on_a, 3)?,
            on_b: rows(on_b, 3)?,
            distance: PyArray1::from_vec(py, distance).unbind(),
        })
    }
}
