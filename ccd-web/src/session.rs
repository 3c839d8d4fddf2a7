//! A session with its positions: JavaScript writes them into buffers here, then calls.

use crate::columns::{Columns, Places, place};
use crate::options::{RawMesh, RawOptions};
use crate::refused;
use ccd::{PerKind, Report, Session};
use wasm_bindgen::prelude::*;

/// Positions at both ends of a step, for one precision.
pub type Ends<T> = [Vec<[T; 3]>; 2];

/// A session of the library, with buffers for what goes in and comes out.
#[wasm_bindgen]
pub struct RawSession {
    inner: Session,
    f32: Ends<f32>,
    f64: Ends<f64>,
    columns: Columns,
    /// Candidates of each kind.
    pairs: [Vec<u32>; 4],
}

/// Calls a function of the session with the positions of a precision.
macro_rules! with_positions {
    ($self:ident, $f64:ident, $session:ident, $x0:ident, $x1:ident, $call:expr) => {{
        let $session = &mut $self.inner;
        if $f64 {
            let [$x0, $x1] = &$self.f64;
            $call
        } else {
            let [$x0, $x1] = &$self.f32;
            $call
        }
    }};
}

/// What sessions on a CPU and on a GPU do alike.
macro_rules! shared {
    ($session:ident) => {
        #[wasm_bindgen]
        impl $session {
            /// Where positions of this precision go: those at the start, then those at the end,
            /// three numbers a vertex of the mesh. The buffers stay where they are until the mesh
            /// has more vertices.
            pub fn positions(&mut self, in_f64: bool) -> Places {
                let n = self.inner.mesh().n_vertices();
                $crate::session::places(&mut self.f32, &mut self.f64, n, in_f64)
            }

            /// Columns of the contacts.
            pub fn columns(&self) -> Places {
                self.columns.places()
            }

            /// Numbers of the last report: the earliest time or NaN, undecided contacts, whether
            /// trees were built anew, then per kind contacts, candidates and what filters left,
            /// then times.
            pub fn numbers(&self) -> Vec<f64> {
                $crate::session::numbers(self.inner.report())
            }

            pub fn set_min_distance(&mut self, distance: f64) -> Result<(), JsError> {
                self.inner.set_min_distance(distance).map_err(refused)
            }

            pub fn set_fixed(&mut self, body: u32, fixed: bool) -> Result<(), JsError> {
                self.inner.set_fixed(body, fixed).map_err(refused)
            }

            pub fn set_sleeping(&mut self, body: u32, sleeping: bool) -> Result<(), JsError> {
                self.inner.set_sleeping(body, sleeping).map_err(refused)
            }
        }
    };
}

#[cfg(feature = "gpu")]
pub(crate) use {shared, with_positions};

shared!(RawSession);

#[wasm_bindgen]
impl RawSession {
    #[wasm_bindgen(constructor)]
    pub fn new(mesh: &RawMesh, options: &RawOptions) -> Result<RawSession, JsError> {
        let inner = Session::new(mesh.0.clone(), options.0.clone()).map_err(refused)?;
        let (f32, f64, columns, pairs) = Default::default();
        Ok(Self { inner, f32, f64, columns, pairs })
    }

    /// Finds the contacts in a window of time.
    pub fn step(
        &mut self,
        in_f64: bool,
        from: f64,
        to: f64,
        geometry: bool,
    ) -> Result<(), JsError> {
        self.columns.clear();
        with_positions!(self, in_f64, session, x0, x1, {
            let report = session.step_window(x0, x1, [from, to]).map_err(refused)?;
            self.columns.fill(&report.contacts);
            if geometry {
                self.columns.fill_geometry(&report.contacts, report.mesh(), [x0, x1]);
            }
        });
        Ok(())
    }

    /// The earliest time of impact.
    pub fn earliest_toi(&mut self, in_f64: bool) -> Result<Option<f64>, JsError> {
        with_positions!(self, in_f64, session, x0, x1, session.earliest_toi(x0, x1))
            .map_err(refused)
    }

    /// The first contact: time, kind, state, two features, two bodies, four vertices, point,
    /// normal, four weights, distance; nothing if there is none.
    pub fn first_contact(&mut self, in_f64: bool) -> Result<Option<Vec<f64>>, JsError> {
        let hit = with_positions!(self, in_f64, session, x0, x1, session.first_contact(x0, x1));
        let numbers = |hit: ccd::Hit| {
            let ids = [&hit.features[..], &hit.bodies, &hit.vertices].concat();
            let ids: Vec<f64> = ids.into_iter().map(f64::from).collect();
            let first = [hit.toi, hit.kind as u8 as f64, hit.state as u8 as f64];
            [&first[..], &ids, &hit.point, &hit.normal, &hit.weights, &[hit.distance]].concat()
        };
        hit.map(|hit| hit.map(numbers)).map_err(refused)
    }

    /// Candidates: a list of pairs for each kind, whose length is in ids.
    pub fn candidates(&mut self, in_f64: bool) -> Result<Places, JsError> {
        with_positions!(self, in_f64, session, x0, x1, {
            let all = session.candidates(x0, x1).map_err(refused)?;
            let ids = |pair: ccd::Pair| [pair.a, pair.b];
            self.pairs = [
                all.vf.iter().flat_map(ids).collect(),
                all.ee.iter().flat_map(ids).collect(),
                all.ve.iter().copied().flat_map(ids).collect(),
                all.vv.iter().copied().flat_map(ids).collect(),
            ];
        });
        Ok(Places(self.pairs.iter().map(|list| place(list)).collect()))
    }

    /// Edge, face and state (0: certain) of each intersection of the positions at the start.
    pub fn intersections(&mut self, in_f64: bool) -> Result<Vec<u32>, JsError> {
        let found = with_positions!(self, in_f64, session, x0, _x1, session.intersections(x0));
        let numbers = |at: &ccd::Intersection| [at.edge, at.face, at.state as u32];
        Ok(found.map_err(refused)?.iter().flat_map(numbers).collect())
    }

    /// Whether there is any.
    pub fn has_intersections(&mut self, in_f64: bool) -> Result<bool, JsError> {
        with_positions!(self, in_f64, session, x0, _x1, session.has_intersections(x0))
            .map_err(refused)
    }
}

/// Where the positions of `n` vertices go.
pub fn places(f32: &mut Ends<f32>, f64: &mut Ends<f64>, n: usize, in_f64: bool) -> Places {
    if in_f64 {
        f64.iter_mut().for_each(|x| x.resize(n, [0.0; 3]));
        Places(f64.iter().map(|x| place(x.as_flattened())).collect())
    } else {
        f32.iter_mut().for_each(|x| x.resize(n, [0.0; 3]));
        Places(f32.iter().map(|x| place(x.as_flattened())).collect())
    }
}

/// Numbers of a report; see [`RawSession::numbers`].
pub fn numbers(report: &Report) -> Vec<f64> {
    let times = &report.times;
    let per_kind = |n: PerKind| [n.vf, n.ee, n.ve, n.vv].map(|n| n as f64);
    let first =
        [report.toi.unwrap_or(f64::NAN), report.undecided as f64, report.rebuilt as u8 as f64];
    let counts = [report.n_contacts(), report.candidates, report.filtered].map(per_kind);
    let times = [times.boxes, times.build, times.traverse, times.narrow, times.total];
    [&first[..], counts.as_flattened(), &times].concat()
}
