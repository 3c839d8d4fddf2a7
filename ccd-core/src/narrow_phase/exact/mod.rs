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
//! Closed features, closed windows. Every loop ends: zeros of a form without double ones are
//! separated by some interval, and a sign that is not 0 shows in some interval around them.

mod form;
mod integer;
mod zeros;

use crate::narrow_phase::codimensional::{VertexEdge, VertexVertex};
use crate::narrow_phase::query::{EdgeEdge, VertexFace};
use form::Form;
use integer::Fixed;
use zeros::{Time, Window, begin, zeros};

/// The exact answer of a query.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Exact {
    /// No contact.
    Miss,
    /// Contact; the first is at a time between these two, which are at most two units in the last
    /// place apart.
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

type Vector<const N: usize> = [Form<N>; 3];

fn minus<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    core::array::from_fn(|k| a[k].minus(&b[k]))
}

fn dot<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Form<N> {
    a[0].times(&b[0]).plus(&a[1].times(&b[1])).plus(&a[2].times(&b[2]))
}

fn cross<const N: usize>(a: &Vector<N>, b: &Vector<N>) -> Vector<N> {
    core::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i].times(&b[j]).minus(&a[j].times(&b[i]))
    })
}

/// What must be so at a zero of a form for features to touch.
trait Touches<const N: usize> {
    fn touches(&self, time: &mut Time<N>) -> Option<bool>;

    /// The first contact among the zeros of a form.
    fn first(&self, form: &Form<N>, window: &Window<N>) -> Option<Exact> {
        let mut first = Exact::Miss;
        for time in zeros(form)?.as_mut_slice() {
            if self.touches(time)? {
                first = first.or(Exact::Contact(time.enclosure(window)?));
            }
        }
        Some(first)
    }

    /// A contact at the beginning.
    fn at_begin(&self, window: &Window<N>) -> Option<Exact> {
        let mut time = Time::At(begin());
        let touches = self.touches(&mut time)?;
        Some(if touches { Exact::Contact(time.enclosure(window)?) } else { Exact::Miss })
    }
}

/// Whether all of some forms are 0 at a time.
fn all_zero<const N: usize>(time: &mut Time<N>, forms: &[Form<N>]) -> Option<bool> {
    for form in forms {
        if time.sign(form)? != 0 {
            return Some(false);
        }
    }
    Some(true)
}

/// A vertex at the ends of an edge, as seen from the vertex.
struct OnEdge<const N: usize> {
    /// Both ends span nothing if the three are on a line.
    span: Vector<N>,
    /// Not positive if they are on two sides, or one of them at the vertex.
    sides: Form<N>,
}

impl<const N: usize> OnEdge<N> {
    fn new(a: &Vector<N>, b: &Vector<N>) -> Self {
        Self { span: cross(a, b), sides: dot(a, b) }
    }

    fn contact(&self, window: &Window<N>) -> Option<Exact> {
        let at_begin = self.at_begin(window)?;
        if at_begin != Exact::Miss {
            return Some(at_begin);
        }
        let span = self.span.iter().find(|form| !form.vanishes());
        // On one line all the time: it reaches an end.
        self.first(span.unwrap_or(&self.sides), window)
    }
}

impl<const N: usize> Touches<N> for OnEdge<N> {
    fn touches(&self, time: &mut Time<N>) -> Option<bool> {
        Some(all_zero(time, &self.span)? && time.sign(&self.sides)? <= 0)
    }
}

/// Features that touch where they are coplanar and some forms are not negative, or on a boundary.
struct Coplanar<'a, const N: usize> {
    normal: Vector<N>,
    inside: &'a [Form<N>],
    boundary: &'a [OnEdge<N>],
}

impl<const N: usize> Coplanar<'_, N> {
    fn contact(&self, coplanarity: &Form<N>, window: &Window<N>) -> Option<Exact> {
        let at_begin = if coplanarity.checked()?.coefficients()[0].sign() == 0 {
            self.at_begin(window)?
        } else {
            Exact::Miss
        };
        if at_begin != Exact::Miss {
            return Some(at_begin);
        }
        if !coplanarity.vanishes() {
            return self.first(coplanarity, window);
        }
        let contacts = self.boundary.iter().map(|edge| edge.contact(window));
        contacts.into_iter().try_fold(Exact::Miss, |first, next| Some(first.or(next?)))
    }
}

impl<const N: usize> Touches<N> for Coplanar<'_, N> {
    fn touches(&self, time: &mut Time<N>) -> Option<bool> {
        if all_zero(time, &self.normal)? {
            for edge in self.boundary {
                if edge.touches(time)? {
                    return Some(true);
                }
            }
            return Some(false);
        }
        for form in self.inside {
            if time.sign(form)? < 0 {
                return Some(false);
            }
        }
        Some(true)
    }
}

/// Moving points in a common unit over a window, and the window; `None` of what is not finite, or
/// a window that is not in `[0, 1]`.
fn points<const N: usize, const K: usize>(
    t0: &[[f64; 3]; K],
    t1: &[[f64; 3]; K],
    [from, until]: [f64; 2],
) -> Option<([Vector<N>; K], Window<N>)> {
    let all = || t0.iter().chain(t1).flatten();
    let is_window = 0.0 <= from && from <= until && until <= 1.0;
    if !is_window || !all().all(|x| x.is_finite()) {
        return None;
    }
    // In a unit of which all are multiples.
    let whole = |x: f64, unit: i32| {
        let (mantissa, exponent) = parts(x);
        Fixed::<N>::new(mantissa, if mantissa == 0 { 0 } else { (exponent - unit) as u32 })
    };
    let unit = parts(from).1.min(parts(until).1).min(0);
    let [from, until] = [from, until].map(|t| whole(t, unit));
    let window = Window { times: [from, until - from], unit: unit.unsigned_abs() };
    let of_space = all().map(|&x| parts(x).1).min()?;
    let coordinate = |x0: f64, x1: f64| {
        let (x0, x1) = (whole(x0, of_space), whole(x1, of_space));
        let at = |t: Fixed<N>| x0.shifted(window.unit) + (x1 - x0) * t;
        Form::linear([at(from), at(until)])
    };
    let point = |i: usize| core::array::from_fn(|k| coordinate(t0[i][k], t1[i][k]));
    Some((core::array::from_fn(point), window))
}

/// A number as an odd integer times a power of two; 0 has the greatest power.
fn parts(x: f64) -> (i64, i32) {
    let bits = x.to_bits();
    let (exponent, fraction) = ((bits >> 52 & 0x7ff) as i32, bits & ((1 << 52) - 1));
    let mantissa = if exponent > 0 { fraction | 1 << 52 } else { fraction };
    if mantissa == 0 {
        return (0, i32::MAX);
    }
    let zeros = mantissa.trailing_zeros();
    let magnitude = (mantissa >> zeros) as i64;
    let exponent = exponent.max(1) - 1075 + zeros as i32;
    (if x < 0.0 { -magnitude } else { magnitude }, exponent)
}

/// Whether a form is certainly not 0 from the beginning to the end.
fn never_zero<const N: usize>(form: &Form<N>) -> bool {
    let c = form.coefficients();
    c[0].sign() != 0 && c[form.degree()].sign() != 0 && form.variations() == 0
}

macro_rules! by_widths {
    ($($(#[$doc:meta])* $name:ident($query:ty) by $within:ident;)*) => {$(
        $(#[$doc])*
        pub fn $name(query: &$query, window: [f64; 2]) -> Option<Exact> {
            let (t0, t1) = (&query.t0, &query.t1);
            $within::<8>(t0, t1, window)
                .or_else(|| $within::<24>(t0, t1, window))
                .or_else(|| $within::<96>(t0, t1, window))
        }
    )*};
}

by_widths! {
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
    vertex_face(VertexFace<f64>) by vertex_face_within;
    /// The same of two edges.
    edge_edge(EdgeEdge<f64>) by edge_edge_within;
    /// The same of a vertex and an edge.
    vertex_edge(VertexEdge<f64>) by vertex_edge_within;
    /// The same of two vertices.
    vertex_vertex(VertexVertex<f64>) by vertex_vertex_within;
}

/// Vertex-face, `v f0 f1 f2`, within numbers of `N` words.
fn vertex_face_within<const N: usize>(
    t0: &[[f64; 3]; 4],
    t1: &[[f64; 3]; 4],
    window: [f64; 2],
) -> Option<Exact> {
    let ([p, a, b, c], window) = points::<N, 4>(t0, t1, window)?;
    let [a, b, c] = [a, b, c].map(|q| minus(&q, &p));
    let sides = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
    let normal = cross(&minus(&b, &a), &minus(&c, &a));
    let coplanarity = dot(&a, &sides[0]);
    if never_zero(&coplanarity.checked()?) {
        return Some(Exact::Miss);
    }
    let inside = sides.map(|side| dot(&side, &normal));
    let boundary = [OnEdge::new(&a, &b), OnEdge::new(&b, &c), OnEdge::new(&c, &a)];
    Coplanar { normal, inside: &inside, boundary: &boundary }.contact(&coplanarity, &window)
}

/// Edge-edge, `ea0 ea1 eb0 eb1`, within numbers of `N` words.
fn edge_edge_within<const N: usize>(
    t0: &[[f64; 3]; 4],
    t1: &[[f64; 3]; 4],
    window: [f64; 2],
) -> Option<Exact> {
    let ([a, b, c, d], window) = points::<N, 4>(t0, t1, window)?;
    let (ab, ac, cd) = (minus(&b, &a), minus(&c, &a), minus(&d, &c));
    let normal = cross(&ab, &cd);
    let coplanarity = dot(&ac, &normal);
    if never_zero(&coplanarity.checked()?) {
        return Some(Exact::Miss);
    }
    let square = dot(&normal, &normal);
    let [s, u] = [cross(&ac, &cd), cross(&ac, &ab)].map(|at| dot(&at, &normal));
    let inside = [s, square.minus(&s), u, square.minus(&u)];
    let ad = minus(&d, &a);
    let (bc, bd) = (minus(&c, &b), minus(&d, &b));
    let [ca, cb, da, db] = [&ac, &bc, &ad, &bd].map(|v| v.map(|f| f.minus(&f).minus(&f)));
    // Each end as seen from itself: `a` on `cd`, `b` on `cd`, `c` on `ab`, `d` on `ab`.
    let boundary = [
        OnEdge::new(&ac, &ad),
        OnEdge::new(&bc, &bd),
        OnEdge::new(&ca, &cb),
        OnEdge::new(&da, &db),
    ];
    Coplanar { normal, inside: &inside, boundary: &boundary }.contact(&coplanarity, &window)
}

/// Vertex-edge, `v e0 e1`, within numbers of `N` words.
fn vertex_edge_within<const N: usize>(
    t0: &[[f64; 3]; 3],
    t1: &[[f64; 3]; 3],
    window: [f64; 2],
) -> Option<Exact> {
    let ([p, a, b], window) = points::<N, 3>(t0, t1, window)?;
    OnEdge::new(&minus(&a, &p), &minus(&b, &p)).contact(&window)
}

/// Vertex-vertex, within numbers of `N` words.
fn vertex_vertex_within<const N: usize>(
    t0: &[[f64; 3]; 2],
    t1: &[[f64; 3]; 2],
    window: [f64; 2],
) -> Option<Exact> {
    let ([p, q], window) = points::<N, 2>(t0, t1, window)?;
    // A vertex on an edge without length.
    let between = minus(&q, &p);
    OnEdge::new(&between, &between).contact(&window)
}
