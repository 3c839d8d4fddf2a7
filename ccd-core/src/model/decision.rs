//! Whether a pair that filters could not reject is a contact, of every kind: decided on a CPU, in
//! its own steps and at the end of a step of a GPU, for what the device left open.

use crate::layout::Pair;
use crate::math::real::Real;
use crate::model::contact::{Contact, Kind};
use crate::model::mesh::Mesh;
use crate::model::options::{Mode, Options};
use crate::narrow_phase::approach::Approach;
use crate::narrow_phase::codimensional::{
    VertexEdge, VertexVertex, search_vertex_edge, search_vertex_vertex,
};
use crate::narrow_phase::exact::{self, Exact, shares_a_point};
use crate::narrow_phase::pair_verdict::{self, gather};
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
    exact_times: bool,
}

/// A pair that rounded arithmetic leaves open, as far as it was tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Open;

impl Decider {
    /// For the times of a window.
    pub fn new(options: &Options, window: [f64; 2]) -> Self {
        let exact_times = options.mode != Mode::Conservative && options.min_distance == 0.0;
        Self { search: options.search(window), exact_times }
    }

    /// Whether it finds exact times.
    pub fn has_exact_times(&self) -> bool {
        self.exact_times
    }

    /// The same, but that contacts of a later time of impact than `latest` may be missed.
    pub fn up_to(&self, latest: f64) -> Self {
        Self { search: Search { latest, ..self.search }, ..*self }
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
        let answer = match kind {
            Kind::VertexFace | Kind::EdgeEdge => {
                self.of_patch(kind, ids, x).unwrap_or_else(|open| self.of_open(kind, ids, x, open))
            }
            Kind::VertexEdge => {
                let query = vertex_edge(ids, x);
                self.codimensional(
                    |search| search_vertex_edge(&query, search),
                    |window| exact::vertex_edge(&query, window),
                )
            }
            Kind::VertexVertex => {
                let query = vertex_vertex(ids, x);
                self.codimensional(
                    |search| search_vertex_vertex(&query, search),
                    |window| exact::vertex_vertex(&query, window),
                )
            }
        };
        Contact::of(kind, pair, answer)
    }

    /// The same, but for pairs of a vertex and a face, or of two edges, that are left to integers:
    /// these take a hundred times as long.
    ///
    /// # Errors
    /// [`Open`]: what is left to [`Decider::contact`].
    pub fn quick_contact<T: Real>(
        &self,
        mesh: &Mesh,
        kind: Kind,
        pair: Pair,
        x: [&[[T; 3]]; 2],
    ) -> Result<Option<Contact>, Open> {
        if !matches!(kind, Kind::VertexFace | Kind::EdgeEdge) {
            return Ok(self.contact(mesh, kind, pair, x));
        }
        let answer = self.of_patch(kind, mesh.vertices_of(kind, pair), x).map_err(|_| Open)?;
        Ok(Contact::of(kind, pair, answer))
    }

    /// A certain contact of a vertex and a face, or of two edges, whose time is early by the
    /// tolerance of the options at most, with its exact time, as far as `f64` finds that.
    pub fn with_exact_time<T: Real>(
        &self,
        mesh: &Mesh,
        contact: &Contact,
        x: [&[[T; 3]]; 2],
    ) -> Option<Contact> {
        let &Contact { kind, a, b, toi, .. } = contact;
        let pair = Pair { a, b };
        let ids = mesh.vertices_of(kind, pair);
        let (x0, x1) = (gather(ids, x[0]), gather(ids, x[1]));
        // A device may have rounded its time down to an `f32`.
        let last = (toi + 1.5 * self.search.tolerance + 1e-6).min(self.search.until);
        let found = exact::first_between(kind.patch(), [&x0, &x1], [toi, last])?;
        Contact::of(kind, pair, self.exact(found))
    }

    /// The answer for a vertex and a face, or two edges; an error: what integers are to decide, and
    /// the answer of the search if one was made.
    #[inline]
    fn of_patch<T: Real>(
        &self,
        kind: Kind,
        ids: [u32; 4],
        x: [&[[T; 3]]; 2],
    ) -> Result<Answer<f64>, Option<Answer<f64>>> {
        let exactly = self.search.min_distance == 0.0;
        let patch = kind.patch();
        if self.exact_times {
            let (x0, x1) = (gather(ids, x[0]), gather(ids, x[1]));
            let wanted = Search { latest: self.search.latest, ..exact::searching(self.window()) };
            let found = exact::quick(patch, [&x0, &x1], &wanted);
            return found.map(|found| self.exact(found)).ok_or(None);
        }
        if exactly
            && self.search.from == 0.0
            && shares_a_point(patch, ids.map(|v| &x[0][v as usize]))
        {
            return Ok(self.exact(Exact::Contact([0.0; 2])));
        }
        let answer = pair_verdict::pair(kind, ids, x, &self.search);
        if exactly && answer.is_open() { Err(Some(answer)) } else { Ok(answer) }
    }

    /// What the search left open, decided; without a heap, only if integers hold it.
    #[cold]
    fn of_open<T: Real>(
        &self,
        kind: Kind,
        ids: [u32; 4],
        x: [&[[T; 3]]; 2],
        open: Option<Answer<f64>>,
    ) -> Answer<f64> {
        let (x0, x1) = (gather(ids, x[0]), gather(ids, x[1]));
        let found = exact::left_open(kind.patch(), [&x0, &x1], self.window());
        let rounded = || open.unwrap_or_else(|| pair_verdict::pair(kind, ids, x, &self.search));
        match found {
            Some(found) if self.exact_times => self.exact(found),
            Some(found) => self.settled(rounded(), found),
            None => rounded(),
        }
    }

    /// The answer for a vertex and an edge, or two vertices: exact if exact times are wanted or the
    /// search leaves the pair open; else that of the search.
    fn codimensional(
        &self,
        certified: impl Fn(&Search<f64>) -> Answer<f64>,
        exact: impl Fn([f64; 2]) -> Option<Exact>,
    ) -> Answer<f64> {
        let exactly = self.search.min_distance == 0.0;
        if self.exact_times
            && let Some(found) = exact(self.window())
        {
            return self.exact(found);
        }
        let answer = certified(&self.search);
        let found = if exactly && answer.is_open() { exact(self.window()) } else { None };
        found.map_or(answer, |found| self.settled(answer, found))
    }

    /// What the search left open, decided: a contact keeps its time if that is early by the
    /// tolerance at most, because the features are then mostly still apart.
    fn settled(&self, answer: Answer<f64>, found: Exact) -> Answer<f64> {
        match (answer.verdict.toi(), found) {
            (Some(toi), Exact::Contact([exact, _])) if exact - toi <= self.search.tolerance => {
                Answer { verdict: Verdict::Hit { toi }, ..answer }
            }
            _ => self.exact(found),
        }
    }

    fn window(&self) -> [f64; 2] {
        [self.search.from, self.search.until]
    }

    /// An exact answer; early by nothing.
    fn exact(&self, found: Exact) -> Answer<f64> {
        match found {
            Exact::Miss => Answer::from(Verdict::Miss),
            Exact::Contact([toi, _]) => {
                // No contact from the start of the window to `toi`, so they approach there.
                let approach =
                    if toi > self.search.from { Approach::Approaching } else { Approach::Unknown };
                Answer { verdict: Verdict::Hit { toi }, approach }
            }
        }
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
