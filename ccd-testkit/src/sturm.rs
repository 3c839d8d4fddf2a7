//! An oracle for exact decisions that shares nothing with them: polynomials in powers of time with
//! whole coefficients (coordinates are multiples of a power of two), zeros counted by Sturm
//! chains, signs at zeros by Tarski queries [Basu 2006].
//!
//! Features first touch at the beginning or at a zero of one of the polynomials that describe them
//! (coplanar; vertices collinear with edges; ends at one place): all of these times are tried.

mod meeting;
mod zeros;

pub use meeting::meet;
use num_bigint::BigInt;
use num_traits::{Float, FromPrimitive, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;
use zeros::{Place, Poly, Q, places};

type Vector = [Poly; 3];

fn minus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|k| a[k].plus(&b[k], -1))
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        a[i].times(&b[j]).plus(&a[j].times(&b[i]), -1)
    })
}

fn dot(a: &Vector, b: &Vector) -> Poly {
    (0..3).fold(Poly::new(Vec::new()), |sum, k| sum.plus(&a[k].times(&b[k]), 1))
}

/// Whether features touch where signs are these.
type Rule = Box<dyn Fn(&dyn Fn(&Poly) -> i32) -> bool>;

/// What features that touch have in common.
struct Case {
    /// All are 0 whenever they touch.
    always: Vec<Poly>,
    /// One is 0 when they first touch, where those are 0 all the time.
    first: Vec<Poly>,
    rule: Rule,
}

fn on_edge(a: &Vector, b: &Vector) -> Case {
    let (span, sides) = (cross(a, b), dot(a, b));
    let (always, first) = (span.to_vec(), vec![sides.clone(), dot(a, a), dot(b, b)]);
    let rule =
        move |sign: &dyn Fn(&Poly) -> i32| span.iter().all(|p| sign(p) == 0) && sign(&sides) <= 0;
    Case { always, first, rule: Box::new(rule) }
}

fn coplanar(cubic: Poly, normal: Vector, inside: Vec<Poly>, edges: Vec<Case>) -> Case {
    let of_edge = |edge: &Case| [edge.always.clone(), edge.first.clone()].concat();
    let (always, first) = (vec![cubic.clone()], edges.iter().flat_map(of_edge).collect());
    let rule = move |sign: &dyn Fn(&Poly) -> i32| {
        if sign(&cubic) != 0 {
            false
        } else if normal.iter().all(|p| sign(p) == 0) {
            edges.iter().any(|edge| (edge.rule)(sign))
        } else {
            inside.iter().all(|p| sign(p) >= 0)
        }
    };
    Case { always, first, rule: Box::new(rule) }
}

impl Case {
    /// Contacts in a window, the first one among them.
    fn contacts(&self, window: [f64; 2]) -> Contacts {
        let window = window.map(exact);
        let sign_at = |p: &Poly| {
            let value = p.at(&window[0]);
            value.is_positive() as i32 - value.is_negative() as i32
        };
        if (self.rule)(&sign_at) {
            let [begin, _] = window;
            return Contacts { begin: Some(begin), later: Vec::new(), of_one: true };
        }
        let one = self.always.iter().find(|p| !p.is_zero());
        let any = if one.is_none() { &self.first[..] } else { &[] };
        let all = one.into_iter().chain(any).filter(|p| !p.is_zero());
        let all = all.flat_map(|p| places(p, &window));
        let later = all.filter(|place| (self.rule)(&|p| place.sign(p))).collect();
        Contacts { begin: None, later, of_one: one.is_some() }
    }
}

/// Contacts of two features: one at the beginning of the window, or others after it.
#[derive(Clone, Debug)]
pub struct Contacts {
    begin: Option<Q>,
    later: Vec<Place>,
    /// Whether these are zeros of one polynomial, so that no two are the same.
    of_one: bool,
}

impl Contacts {
    /// How many there are: one if they touch at the beginning, or stay on one line or in one plane.
    pub fn count(&self) -> usize {
        let later = self.later.len();
        self.begin.is_some() as usize + if self.of_one { later } else { later.min(1) }
    }

    /// The first, between two numbers at most `2^-60` apart.
    pub fn first(&self) -> Option<[f64; 2]> {
        let number = |t: &Q| t.to_f64().expect("a time");
        if let Some(begin) = &self.begin {
            return Some([number(begin); 2]);
        }
        let narrow = Q::new(BigInt::from(1), BigInt::from(1u64 << 60));
        let ends = self.later.iter().map(|place| place.within(&narrow).map(|t| number(&t)));
        ends.reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1])])
    }

    /// What is wrong with an enclosure of the first: it must be that time rounded down, and up by
    /// at most one unit in the last place. Compared without rounding.
    ///
    /// # Errors
    /// What is wrong, in words.
    pub fn check(&self, found: Option<[f64; 2]>) -> Result<(), String> {
        let wrong = |what: &str| Err(format!("{what}: {found:?}, right is {:?}", self.first()));
        let Some([lo, hi]) = found else {
            return if self.count() == 0 { Ok(()) } else { wrong("a contact is missed") };
        };
        if self.count() == 0 {
            return wrong("no contact");
        }
        let above = lo.next_up();
        let beside = |t: f64| -> Vec<Ordering> {
            let t = exact(t);
            let begin = self.begin.iter().map(|begin| begin.cmp(&t));
            begin.chain(self.later.iter().map(|place| place.beside(&t))).collect()
        };
        if beside(lo).contains(&Ordering::Less) {
            wrong("late")
        } else if !beside(above).contains(&Ordering::Less) {
            wrong("early")
        } else if hi > above || hi < lo || hi == lo && !beside(lo).contains(&Ordering::Equal) {
            wrong("not rounded up")
        } else {
            Ok(())
        }
    }
}

fn exact(x: f64) -> Q {
    Q::from_f64(x).expect("a finite number")
}

/// Coordinates of points at both ends.
type Whole<const K: usize> = [[[BigInt; 3]; K]; 2];

/// Coordinates as multiples of a power of two.
fn whole<const K: usize>(t: [&[[f64; 3]; K]; 2]) -> Whole<K> {
    let decoded = t.map(|t| {
        t.map(|p| {
            p.map(|x| {
                assert!(x.is_finite(), "a finite coordinate");
                x.integer_decode()
            })
        })
    });
    let all = decoded.iter().flatten().flatten();
    let unit = all.filter(|(m, ..)| *m != 0).map(|&(_, e, _)| e).min().unwrap_or(0);
    let number = |(m, e, sign): (u64, i16, i8)| match m {
        0 => BigInt::zero(),
        m => (BigInt::from(m) << (e - unit)) * sign,
    };
    decoded.map(|t| t.map(|p| p.map(number)))
}

fn points<const K: usize>(t0: &[[f64; 3]; K], t1: &[[f64; 3]; K]) -> [Vector; K] {
    let [x0, x1] = whole([t0, t1]);
    std::array::from_fn(|i| {
        std::array::from_fn(|k| {
            let (a, b) = (&x0[i][k], &x1[i][k]);
            Poly::new(vec![a.clone(), b - a])
        })
    })
}

/// Vertex-face, `v f0 f1 f2`: contacts in a window.
pub fn vertex_face(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4], window: [f64; 2]) -> Contacts {
    let [p, a, b, c] = points(t0, t1);
    let [a, b, c] = [a, b, c].map(|q| minus(&q, &p));
    let normal = cross(&minus(&b, &a), &minus(&c, &a));
    let edges = [[&a, &b], [&b, &c], [&c, &a]];
    let inside = edges.map(|[a, b]| dot(&cross(a, b), &normal)).to_vec();
    let cubic = dot(&a, &normal);
    let edges = edges.map(|[a, b]| on_edge(a, b)).into();
    coplanar(cubic, normal, inside, edges).contacts(window)
}

/// Edge-edge, `ea0 ea1 eb0 eb1`: contacts in a window.
pub fn edge_edge(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4], window: [f64; 2]) -> Contacts {
    let [a, b, c, d] = points(t0, t1);
    let normal = cross(&minus(&b, &a), &minus(&d, &c));
    // Both ends of each are on different sides of the other, in the plane of both.
    let side =
        |p: &Vector, q: &Vector, r: &Vector| dot(&cross(&minus(q, p), &minus(r, p)), &normal);
    let opposite = |x: Poly, y: Poly| Poly::new(Vec::new()).plus(&x.times(&y), -1);
    let inside = vec![
        opposite(side(&a, &b, &c), side(&a, &b, &d)),
        opposite(side(&c, &d, &a), side(&c, &d, &b)),
    ];
    let cubic = dot(&minus(&c, &a), &normal);
    let seen = |p: &Vector, q: &Vector, r: &Vector| on_edge(&minus(q, p), &minus(r, p));
    let edges = vec![seen(&a, &c, &d), seen(&b, &c, &d), seen(&c, &a, &b), seen(&d, &a, &b)];
    coplanar(cubic, normal, inside, edges).contacts(window)
}

/// Vertex-edge, `v e0 e1`: contacts in a window.
pub fn vertex_edge(t0: &[[f64; 3]; 3], t1: &[[f64; 3]; 3], window: [f64; 2]) -> Contacts {
    let [p, a, b] = points(t0, t1);
    on_edge(&minus(&a, &p), &minus(&b, &p)).contacts(window)
}
