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
//! contact with the time to the last bit (`refine.rs`). Most of what is left rests on each other,
//! and so touches at the start of the window already. So that moment is tested next; it needs no
//! polynomial of time (`moment.rs`).
//!
//! Closed features, closed windows. Every loop ends: simple zeros are separated by halving often
//! enough, and a polynomial that is not 0 at a zero of another has coefficients of one sign over a
//! small enough interval around it.

mod ball;
mod features;
mod form;
mod geometry;
mod integer;
mod moment;
mod refine;
mod vector;
mod words;
mod zeros;

use crate::narrow_phase::codimensional::{VertexEdge, VertexVertex, search_vertex_edge};
use crate::narrow_phase::query::{EdgeEdge, VertexFace, search};
use crate::narrow_phase::relative_motion::{Motion, Patch};
use crate::narrow_phase::search::{Search, Verdict};
use features::{Features, OnEdge, differences};
use form::Form;
pub(crate) use geometry::{Meeting, meeting};
use integer::{Integer, parts};
pub(crate) use moment::shares_a_point;
use vector::Vector;
use words::{Longest, Words};
use zeros::{Time, Window, zeros};

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
fn first<W: Words>(
    form: &Form<W>,
    window: &Window<W>,
    touches: impl Fn(&mut Time<W>) -> Option<bool>,
) -> Option<Exact> {
    let mut first = Exact::Miss;
    for time in zeros(form, window)?.iter_mut().flatten() {
        if touches(time)? {
            first = first.or(Exact::Contact(time.enclosure()?));
        }
    }
    Some(first)
}

/// A contact at the beginning.
fn at_begin<W: Words>(
    window: &Window<W>,
    touches: impl Fn(&mut Time<W>) -> Option<bool>,
) -> Option<Exact> {
    let mut time = Time::At(window.begin());
    let touches = touches(&mut time)?;
    Some(if touches { Exact::Contact(time.enclosure()?) } else { Exact::Miss })
}

impl<W: Words> OnEdge<Form<W>> {
    fn contact(&self, window: &Window<W>) -> Option<Exact> {
        let touches = |time: &mut Time<W>| self.touches(&mut |form| time.sign(form));
        let at_begin = at_begin(window, touches)?;
        if at_begin != Exact::Miss {
            return Some(at_begin);
        }
        first(self.zero_at_contact(), window, touches)
    }

    /// A form that is 0 at the first contact, if that is not at the beginning.
    fn zero_at_contact(&self) -> &Form<W> {
        // If all three points stay on one line, the first contact is with an end of the edge,
        // where `sides` is 0.
        self.span.iter().find(|form| !form.vanishes()).unwrap_or(&self.sides)
    }
}

impl<W: Words> Features<Form<W>> {
    fn contact(&self, window: &Window<W>) -> Option<Exact> {
        let coplanarity = self.coplanarity().checked()?;
        let part = window.part(&coplanarity)?;
        if never_zero(&part) {
            return Some(Exact::Miss);
        }
        let touches = |time: &mut Time<W>| self.touch(&mut |form| time.sign(form));
        if part.coefficients()[0].sign() == 0 {
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

/// Differences of points that move over a step, in a unit of each axis of which all its coordinates
/// are whole multiples: whether features touch does not depend on how axes are scaled.
fn moving<W: Words, const N: usize, const K: usize>(
    pairs: [[usize; 2]; K],
    ends: [&[[f64; 3]; N]; 2],
) -> [Vector<Form<W>>; K] {
    let units = units(ends.into_iter().flatten());
    let mut out = [const { [const { Form::ZERO }; 3] }; K];
    for (difference, [p, q]) in out.iter_mut().zip(pairs) {
        for (k, form) in difference.iter_mut().enumerate() {
            let at = |x: f64| Integer::of(x, units[k]);
            *form = Form::linear(ends.map(|x| at(x[p][k]) - at(x[q][k])));
        }
    }
    out
}

/// Features that move over a step, `v f0 f1 f2` or `ea0 ea1 eb0 eb1`.
fn moving_features<W: Words>(patch: Patch, ends: [&[[f64; 3]; 4]; 2]) -> Features<Form<W>> {
    Features::of_differences(patch, moving(differences(patch), ends))
}

/// For each axis the greatest power of two of which all coordinates on it are whole multiples.
fn units<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> [i32; 3] {
    let least = |units: [i32; 3], p: &[f64; 3]| [0, 1, 2].map(|k| units[k].min(parts(p[k]).1));
    points.fold([i32::MAX; 3], least)
}

/// Whether a form is certainly not 0 from the beginning to the end.
fn never_zero<W: Words>(form: &Form<W>) -> bool {
    let c = form.coefficients();
    c[0].sign() != 0 && c[form.degree()].sign() != 0 && form.variations() == 0
}

/// Whether a vertex and a face touch at a time of a window in `[0, 1]`, and when they first do.
///
/// `None` of coordinates that are not finite, and of a window that is not in `[0, 1]`; nothing else
/// with the feature `alloc`, which `meshccd` turns on. Most queries take less than a microsecond,
/// ties tens. Integers are as long as they must be: coordinates whose exponents on one axis are
/// hundreds apart, or a window that begins at a tiny time, take milliseconds, and any bits of `f64`
/// at most tens of these.
///
/// Without `alloc` integers have at most 6,144 bits, and `None` is also what these do not hold. Of
/// the whole step no search has found such a query where on each axis the lowest bit of a
/// coordinate stands at most 200 places below the highest of another, as of all `f32` between
/// 2^-100 and 2^76.
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
    let moderate = checked([t0, t1], window)?;
    if moderate && search_vertex_edge(query, &searching(window)).verdict == Verdict::Miss {
        return Some(Exact::Miss);
    }
    on_edge_by_integers::<[u64; 8]>([t0, t1], window)
        .or_else(|| on_edge_by_integers::<[u64; 24]>([t0, t1], window))
        .or_else(|| on_edge_by_integers::<Longest>([t0, t1], window))
}

/// The same of two vertices.
pub fn vertex_vertex(query: &VertexVertex<f64>, window: [f64; 2]) -> Option<Exact> {
    // A vertex on an edge without length.
    let [t0, t1] = [query.t0, query.t1].map(|[p, q]| [p, q, q]);
    vertex_edge(&VertexEdge { t0, t1 }, window)
}

/// Whether two features touch, `v f0 f1 f2` or `ea0 ea1 eb0 eb1` at both ends of the step: as `f64`
/// certifies it, else by integers.
fn of_patch(patch: Patch, x: [&[[f64; 3]; 4]; 2], window: [f64; 2]) -> Option<Exact> {
    quick(patch, x, &searching(window)).or_else(|| left_open(patch, x, window))
}

/// As far as `f64` certifies it; `None`: see [`left_open`]. Where they first touch after
/// [`Search::latest`], it may be a miss.
pub(crate) fn quick(patch: Patch, x: [&[[f64; 3]; 4]; 2], wanted: &Search<f64>) -> Option<Exact> {
    let &Search { from, until, .. } = wanted;
    let moderate = checked([x[0], x[1]], [from, until])?;
    if at_begin_of(x, [from, until]).is_some_and(|x| shares_a_point(patch, x.each_ref())) {
        return Some(Exact::Contact([from; 2]));
    }
    if !moderate {
        return None;
    }
    match search(&Motion::new(patch, x[0], x[1], 0.0), patch, wanted).verdict {
        Verdict::Miss => Some(Exact::Miss),
        Verdict::Hit { toi } => first_between(patch, x, [toi, (toi + wanted.tolerance).min(until)]),
        Verdict::Undecided { .. } => None,
    }
}

/// The same of which `f64` has certified nothing; `None` as of [`vertex_face`].
pub(crate) fn left_open(patch: Patch, x: [&[[f64; 3]; 4]; 2], window: [f64; 2]) -> Option<Exact> {
    checked([x[0], x[1]], window)?;
    let [from, until] = window;
    match at_begin_of(x, window).map(|x| moment::touch(patch, x)) {
        Some(Some(true)) => return Some(Exact::Contact([from; 2])),
        Some(Some(false)) if x[0] == x[1] || from == until => return Some(Exact::Miss),
        _ => (),
    }
    by_integers::<[u64; 8]>(patch, x, window)
        .or_else(|| by_integers::<[u64; 24]>(patch, x, window))
        .or_else(|| by_integers::<Longest>(patch, x, window))
}

/// The first contact, which certainly is between two times, as far as `f64` finds it.
pub(crate) fn first_between(
    patch: Patch,
    x: [&[[f64; 3]; 4]; 2],
    times: [f64; 2],
) -> Option<Exact> {
    let time = refine::rounded_down(vectors(patch, x), times)?;
    Some(Exact::Contact([time, time.next_up()]))
}

/// Both points of each difference `a b c`, at both ends of the step.
fn vectors(patch: Patch, x: [&[[f64; 3]; 4]; 2]) -> [[[[f64; 3]; 2]; 2]; 3] {
    let ends = |[i, j]: [usize; 2]| [[x[0][i], x[1][i]], [x[0][j], x[1][j]]];
    let [a, b, c] = differences(patch);
    [ends(a), ends(b), ends(c)]
}

/// Positions at the beginning of a window, if they are among those given.
fn at_begin_of([x0, x1]: [&[[f64; 3]; 4]; 2], [from, _]: [f64; 2]) -> Option<&[[f64; 3]; 4]> {
    if from == 0.0 || x0 == x1 { Some(x0) } else { (from == 1.0).then_some(x1) }
}

/// The greatest coordinate of which the bounds of the conservative search hold.
const MAX_COORDINATE: f64 = 1e100;

/// What `f64` is asked first.
pub(crate) fn searching([from, until]: [f64; 2]) -> Search<f64> {
    Search { from, until, ..Search::whole(0.0) }
}

/// Whether coordinates are such as `f64` computes with; `None` if some are not finite, or the
/// window is not in `[0, 1]`.
fn checked(ends: [&[[f64; 3]]; 2], [from, until]: [f64; 2]) -> Option<bool> {
    if !(0.0 <= from && from <= until && until <= 1.0) {
        return None;
    }
    // Without branches: every pair of a step comes here.
    let within = |most: f64| {
        let mut all = true;
        for points in ends {
            for [x, y, z] in points {
                all &= (x.abs() <= most) & (y.abs() <= most) & (z.abs() <= most);
            }
        }
        all
    };
    let moderate = within(MAX_COORDINATE);
    (moderate || within(f64::MAX)).then_some(moderate)
}

/// Within as many words as there are; `None` if they are too few.
fn by_integers<W: Words>(
    patch: Patch,
    ends: [&[[f64; 3]; 4]; 2],
    window: [f64; 2],
) -> Option<Exact> {
    moving_features(patch, ends).contact(&Window::<W>::new(window)?)
}

/// The same of a vertex and an edge.
fn on_edge_by_integers<W: Words>(ends: [&[[f64; 3]; 3]; 2], window: [f64; 2]) -> Option<Exact> {
    let [a, b] = moving([[1, 0], [2, 0]], ends);
    OnEdge::new(&a, &b).contact(&Window::<W>::new(window)?)
}

#[cfg(test)]
mod tests;
