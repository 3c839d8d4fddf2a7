//! The first contact of a step, and how contacts are numbered in Python.

use ccd::{Kind, State};
use pyo3::prelude::*;

/// The first contact of a step.
#[pyclass(frozen, get_all, module = "meshccd")]
pub struct Hit {
    /// Time of impact in [0, 1]; never late.
    toi: f64,
    /// Which features touch: a `Kind`.
    kind: u8,
    /// How certain it is: `State.HIT` or `State.UNDECIDED`.
    state: u8,
    /// Vertex and face, or the lesser and the greater edge.
    features: [u32; 2],
    /// The bodies of the features; both 0 without bodies.
    bodies: [u32; 2],
    /// Vertices, as a row of `Report.vertices`.
    vertices: [u32; 4],
    /// Where they meet.
    point: [f64; 3],
    /// Unit vector from the second feature towards the first.
    normal: [f64; 3],
    /// Of each of the vertices, in the point of its feature.
    weights: [f64; 4],
    /// How far the features are apart at that time.
    distance: f64,
}

#[pymethods]
impl Hit {
    /// The normal that points towards `body`, away from what it touches.
    fn normal_towards(&self, body: u32) -> [f64; 3] {
        let [a, b] = self.bodies;
        if body == b && body != a { self.normal.map(|c| -c) } else { self.normal }
    }

    fn __repr__(&self) -> String {
        let ([a, b], toi) = (self.features, self.toi);
        let kind = Kind::ALL[self.kind as usize];
        format!("<Hit: {kind:?} {a} {b} at {toi}>")
    }
}

impl From<ccd::Hit> for Hit {
    fn from(hit: ccd::Hit) -> Self {
        Self {
            toi: hit.toi,
            kind: hit.kind as u8,
            state: state_number(hit.state),
            features: hit.features,
            bodies: hit.bodies,
            vertices: hit.vertices,
            point: hit.point,
            normal: hit.normal,
            weights: hit.weights,
            distance: hit.distance,
        }
    }
}

/// The number of `State.MISS` in Python.
pub const MISS: u8 = 0;

/// The numbers of `State` in Python.
pub fn state_number(state: State) -> u8 {
    if state == State::Hit { 1 } else { 2 }
}
