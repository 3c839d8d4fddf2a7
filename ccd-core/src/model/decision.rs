//! From a pair that filters could not reject to its contact, if it has one: the same on every CPU
//! path, of every kind.

use crate::layout::Pair;
use crate::math::real::Real;
use crate::model::contact::{Contact, Kind};
use crate::model::mesh::Mesh;
use crate::model::options::{Mode, Options};
use crate::narrow_phase::approach::Approach;
use crate::narrow_phase::codimensional::{
    VertexEdge, VertexVertex, search_vertex_edge, search_vertex_vertex,
};
use crate::narrow_phase::decide::{self, gather};
use crate::narrow_phase::exact::{self, Exact};
use crate::narrow_phase::search::{Answer, Search, Verdict};

/// What decides pairs of a step.
///
/// ```
/// use ccd::{Kind, Mesh, Options, Pair};
/// use ccd_core::model::decision::Decider;
///
/// // A vertex falls through a triangle.
/// let mesh = Mesh::new(4, &[[0, 1, 2]])?;
/// let at = |y: f64| [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.2, y, 0.2]];
/// let decider = Decider::new(&Options::default(), [0.0, 0.75]);
/// let contact = |until: f64| {
///     decider.contact(&mesh, Kind::VertexFace, Pair { a: 3, b: 0 }, [&at(1.0), &at(until)])
/// };
/// assert!(contact(-1.0).is_some_and(|contact| contact.toi <= 0.5));
/// assert!(contact(-0.25).is_none());
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decider {
    search: Search<f64>,
    mode: Mode,
}

impl Decider {
    /// For the times of a window.
    pub fn new(options: &Options, window: [f64; 2]) -> Self {
        Self { search: options.search(window), mode: options.mode }
    }

    /// The contact of a pair, if it has one, from positions as given at both ends of the step.
    pub fn contact<T: Real>(
        &self,
        mesh: &Mesh,
        kind: Kind,
        pair: Pair,
        x: [&[[T; 3]]; 2],
    ) -> Option<Contact> {
        let ids = mesh.vertices_of(kind, pair);
        let decided = match self.mode {
            Mode::Conservative => None,
            Mode::Exact => self.exact(kind, ids, x),
        };
        Contact::of(kind, pair, decided.unwrap_or_else(|| self.certified(kind, ids, x)))
    }

    /// The conservative answer.
    #[inline]
    fn certified<T: Real>(&self, kind: Kind, ids: [u32; 4], x: [&[[T; 3]]; 2]) -> Answer<f64> {
        match kind {
            Kind::VertexFace | Kind::EdgeEdge => decide::pair(kind, ids, x, &self.search),
            Kind::VertexEdge => search_vertex_edge(&vertex_edge(ids, x), &self.search),
            Kind::VertexVertex => search_vertex_vertex(&vertex_vertex(ids, x), &self.search),
        }
    }

    /// The exact answer; `None` if its integers do not hold it.
    fn exact<T: Real>(&self, kind: Kind, ids: [u32; 4], x: [&[[T; 3]]; 2]) -> Option<Answer<f64>> {
        let Search { from, until, .. } = self.search;
        let window = [from, until];
        let found = match kind {
            Kind::VertexFace | Kind::EdgeEdge => {
                let [x0, x1] = x.map(|x| gather(ids, x));
                exact::of_patch(kind.patch(), [&x0, &x1], window)
            }
            Kind::VertexEdge => exact::vertex_edge(&vertex_edge(ids, x), window),
            Kind::VertexVertex => exact::vertex_vertex(&vertex_vertex(ids, x), window),
        };
        Some(match found? {
            Exact::Miss => Answer::from(Verdict::Miss),
            Exact::Contact([toi, _]) => {
                // No contact from the start of the window to `toi`, so they approach there.
                let approach = if toi > from { Approach::Approaching } else { Approach::Unknown };
                Answer { verdict: Verdict::Hit { toi }, approach }
            }
        })
    }
}

fn vertex_edge<T: Real>(ids: [u32; 4], x: [&[[T; 3]]; 2]) -> VertexEdge<f64> {
    let [[v, e0, e1, _], [w, f0, f1, _]] = x.map(|x| gather(ids, x));
    VertexEdge { t0: [v, e0, e1], t1: [w, f0, f1] }
}

fn vertex_vertex<T: Real>(ids: [u32; 4], x: [&[[T; 3]]; 2]) -> VertexVertex<f64> {
    let [[v, w, ..], [p, q, ..]] = x.map(|x| gather(ids, x));
    VertexVertex { t0: [v, w], t1: [p, q] }
}
