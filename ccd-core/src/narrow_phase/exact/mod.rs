//! Exact decisions: whether features touch within a window of time, and when they first do, of the
//! coordinates as they are.
//!
//! Coordinates are dyadic numbers; in a common unit they are integers, and so are the coefficients
//! of every polynomial of time below (`form.rs`). A face and a vertex touch where the cubic of
//! coplanarity is 0 and three quartics are not negative; where the normal vanishes as well, where
//! the vertex is on an edge. What is coplanar all the time first touches at the beginning or on the
//! boundary: of a face an edge, of an edge a vertex.
//!
//! | question | if not always so | at its zeros |
//! |---|---|---|
//! | vertex, face | coplanar: a cubic | three quartics, or edges |
//! | edge, edge | coplanar: a cubic | four quartics, or ends |
//! | vertex, edge | collinear: three quadratics | a quadratic |
//! | vertex, vertex | at one place: three linear forms | |
//!
//! Asked first is the conservative search in `f64`: what it certifies stands, a miss as it is, a
//! contact with the time to the last bit (`refine.rs`). What it leaves is mostly features that rest
//! on each other, so the beginning of the window is looked at next, by itself (`moment.rs`).
//!
//! Closed features, closed windows. Every loop ends: zeros of a form without double ones are
//! separated by some interval, and a sign that is not 0 shows in some interval around them.

mod features;
mod form;
mod integer;
mod moment;
mod refine;
mod vector;
mod zeros;

use crate::narrow_phase::codimensional::{VertexEdge, VertexVertex, search_vertex_edge};
use crate::narrow_phase::query::{EdgeEdge, VertexFace, search};
use crate::narrow_phase::relative_motion::{Motion, Patch};
use crate::narrow_phase::search::{Search, Verdict};
use features::{Features, OnEdge, differences};
use form::Form;
use integer::{Fixed, parts};
use vector::{Vector, minus};
use zeros::{Time, Window, begin, zeros};

/// The exact answer of a query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exact {
    /// No contact.
    Miss,
    /// Contact; the time of the first, rounded down and up.
    Contact([f64; 2]),
}

impl Exact {
    /// The earlier contact.
    fn or(self, other: Self) -> Self {
        match (self, other) {
            (Exact::Contact(a), Exact::Contact(b)) => {
                Exact::Contact([a[0].min(b[0]), a[1].min(b[1])])
            }
            (Exact::Miss, other) => other,
            (found, _) => found,
        }
    }
}

/// The first time among the zeros of a form at which features touch.
fn first<const N: usize>(
    form: &Form<N>,
    window: &Window<N>,
    touches: impl Fn(&mut Time<N>) -> Option<bool>,
) -> Option<Exact> {
    let mut first = Exact::Miss;
    for time in zeros(form)?.as_mut_slice() {
        if touches(time)? {
            first = first.or(Exact::Contact(time.enclosure(window)?));
        }
    }
    Some(first)
}

/// A contact at the beginning.
fn at_begin<const N: usize>(
    window: &Window<N>,
    touches: impl Fn(&mut Time<N>) -> Option<bool>,
) -> Option<Exact> {
    let mut time = Time::At(begin());
    let touches = touches(&mut time)?;
    Some(if touches { Exact::Contact(time.enclosure(window)?) } else { Exact::Miss })
}

impl<const N: usize> OnEdge<Form<N>> {
    fn contact(&self, window: &Window<N>) -> Option<Exact> {
        let touches = |time: &mut Time<N>| self.touches(&mut |form| time.sign(form));
        let at_begin = at_begin(window, touches)?;
        if at_begin != Exact::Miss {
            return Some(at_begin);
        }
        let span = self.span.iter().find(|form| !form.vanishes());
        // On one line all the time: it reaches an end.
        first(span.unwrap_or(&self.sides), window, touches)
    }
}

impl<const N: usize> Features<Form<N>> {
    fn contact(&self, window: &Window<N>) -> Option<Exact> {
        let coplanarity = self.coplanarity().checked()?;
        if never_zero(&coplanarity) {
            return Some(Exact::Miss);
        }
        let touches = |time: &mut Time<N>| self.touch(&mut |form| time.sign(form));
        if coplanarity.coefficients()[0].sign() == 0 {
            let at_begin = at_begin(window, touches)?;
            if at_begin != Exact::Miss {
                return Some(at_begin);
            }
        }
        if !coplanarity.vanishes() {
            return first(&coplanarity, window, touches);
        }
        self.boundary().try_fold(Exact::Miss, |first, edge| Some(first.or(edge.contact(window)?)))
    }
}

/// Moving points in a common unit over a window, and the window.
fn points<const N: usize, const K: usize>(
    t0: &[[f64; 3]; K],
    t1: &[[f64; 3]; K],
    [from, until]: [f64; 2],
) -> Option<([Vector<Form<N>>; K], Window<N>)> {
    // In a unit of which all are multiples.
    let unit = parts(from).1.min(parts(until).1).min(0);
    let [from, until] = [from, until].map(|t| Fixed::<N>::of(t, unit));
    let window = Window { times: [from, until - from], unit: unit.unsigned_abs() };
    let of_space = t0.iter().chain(t1).flatten().map(|&x| parts(x).1).min()?;
    let coordinate = |x0: f64, x1: f64| {
        let (x0, x1) = (Fixed::of(x0, of_space), Fixed::of(x1, of_space));
        let at = |t: Fixed<N>| x0.shifted(window.unit) + (x1 - x0) * t;
        Form::linear([at(from), at(until)])
    };
    let point = |i: usize| core::array::from_fn(|k| coordinate(t0[i][k], t1[i][k]));
    Some((core::array::from_fn(point), window))
}

/// Whether a form is certainly not 0 from the beginning to the end.
fn never_zero<const N: usize>(form: &Form<N>) -> bool {
    let c = form.coefficients();
    c[0].sign() != 0 && c[form.degree()].sign() != 0 && form.variations() == 0
}

/// Whether a vertex and a face touch at a time of a window in `[0, 1]`, and when they first do.
///
/// `None` of coordinates that are not finite, of a window that is none, and where coordinates
/// are so unlike that integers of 6,144 bits do not hold what comes of them, as they may where
/// the lowest bit of one stands hundreds of places below the highest of another.
///
/// ```
/// use ccd::VertexFace;
/// use ccd::exact::{Exact, vertex_face};
///
/// // A vertex passes the corner of a face, and one that moves beside it by the least there is.
/// let at = |y: f64, x: f64| [[x, y, 0.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
/// let query = |x: f64| VertexFace { t0: at(1.0, x), t1: at(-2.0, x) };
/// let third = 1.0 / 3.0f64;
/// let Some(Exact::Contact([lo, hi])) = vertex_face(&query(0.0), [0.0, 1.0]) else { panic!() };
/// assert!(lo <= third && third <= hi && hi - lo < 1e-15);
/// assert_eq!(vertex_face(&query(-5e-324), [0.0, 1.0]), Some(Exact::Miss));
/// assert_eq!(vertex_face(&query(0.0), [0.0, 0.25]), Some(Exact::Miss));
/// ```
pub fn vertex_face(query: &VertexFace<f64>, window: [f64; 2]) -> Option<Exact> {
    of_patch(Patch::Triangle, [&query.t0, &query.t1], window)
}

/// The same of two edges.
pub fn edge_edge(query: &EdgeEdge<f64>, window: [f64; 2]) -> Option<Exact> {
    of_patch(Patch::Parallelogram, [&query.t0, &query.t1], window)
}

/// The same of a vertex and an edge.
pub fn vertex_edge(query: &VertexEdge<f64>, window: [f64; 2]) -> Option<Exact> {
    let VertexEdge { t0, t1 } = query;
    let moderate = checked(t0.iter().chain(t1), window)?;
    if moderate && search_vertex_edge(query, &searching(window)).verdict == Verdict::Miss {
        return Some(Exact::Miss);
    }
    on_edge_by_integers::<8>([t0, t1], window)
        .or_else(|| on_edge_by_integers::<24>([t0, t1], window))
        .or_else(|| on_edge_by_integers::<96>([t0, t1], window))
}

/// The same of two vertices.
pub fn vertex_vertex(query: &VertexVertex<f64>, window: [f64; 2]) -> Option<Exact> {
    // A vertex on an edge without length.
    let [t0, t1] = [query.t0, query.t1].map(|[p, q]| [p, q, q]);
    vertex_edge(&VertexEdge { t0, t1 }, window)
}

/// Whether two features touch, `v f0 f1 f2` or `ea0 ea1 eb0 eb1` at both ends of the step: as `f64`
/// certifies it, else by integers.
pub(crate) fn of_patch(patch: Patch, x: [&[[f64; 3]; 4]; 2], window: [f64; 2]) -> Option<Exact> {
    let moderate = checked(x[0].iter().chain(x[1]), window)?;
    let [from, until] = window;
    let still = x[0] == x[1];
    let first = if from == 0.0 || still { Some(x[0]) } else { (from == 1.0).then_some(x[1]) };
    if first.is_some_and(|x| moment::shares_a_point(patch, x)) {
        return Some(Exact::Contact([from; 2]));
    }
    let wanted = searching(window);
    let motion = Motion::new(patch, x[0], x[1], 0.0);
    match moderate.then(|| search(&motion, patch, &wanted).verdict) {
        Some(Verdict::Miss) => return Some(Exact::Miss),
        Some(Verdict::Hit { toi }) => {
            let last = (toi + wanted.tolerance).min(until);
            let vectors = differences(patch).map(|pair| pair.map(|i| x.map(|x| x[i])));
            if let Some(time) = refine::rounded_down(vectors, [toi, last]) {
                return Some(Exact::Contact([time, time.next_up()]));
            }
        }
        _ => (),
    }
    match first.map(|x| moment::touch(patch, x)) {
        Some(Some(true)) => return Some(Exact::Contact([from; 2])),
        Some(Some(false)) if still || from == until => return Some(Exact::Miss),
        _ => (),
    }
    by_integers::<8>(patch, x, window)
        .or_else(|| by_integers::<24>(patch, x, window))
        .or_else(|| by_integers::<96>(patch, x, window))
}

/// The greatest coordinate of which the bounds of the conservative search hold.
const MAX_COORDINATE: f64 = 1e100;

/// What `f64` is asked first.
fn searching([from, until]: [f64; 2]) -> Search<f64> {
    Search { from, until, ..Search::whole(0.0) }
}

/// Whether coordinates are such as `f64` computes with; `None` if some are not finite, or the
/// window is not in `[0, 1]`.
fn checked<'a>(
    points: impl Iterator<Item = &'a [f64; 3]>,
    [from, until]: [f64; 2],
) -> Option<bool> {
    let is_window = 0.0 <= from && from <= until && until <= 1.0;
    let most =
        points.flatten().try_fold(0.0, |most: f64, x| x.is_finite().then(|| most.max(x.abs())));
    most.filter(|_| is_window).map(|most| most <= MAX_COORDINATE)
}

/// Within numbers of `N` words.
fn by_integers<const N: usize>(
    patch: Patch,
    [t0, t1]: [&[[f64; 3]; 4]; 2],
    window: [f64; 2],
) -> Option<Exact> {
    let (points, window) = points::<N, 4>(t0, t1, window)?;
    Features::new(patch, &points).contact(&window)
}

/// The same of a vertex and an edge.
fn on_edge_by_integers<const N: usize>(
    [t0, t1]: [&[[f64; 3]; 3]; 2],
    window: [f64; 2],
) -> Option<Exact> {
    let ([p, a, b], window) = points::<N, 3>(t0, t1, window)?;
    OnEdge::new(&minus(&a, &p), &minus(&b, &p)).contact(&window)
}

#[cfg(test)]
mod tests;
