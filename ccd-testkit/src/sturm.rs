//! An oracle for exact decisions that shares nothing with them: polynomials in powers of time with
//! rational coefficients, zeros counted by Sturm chains, signs at zeros by Tarski queries
//! [Basu 2006].
//!
//! Features first touch at the beginning or at a zero of one of the polynomials that describe them
//! (coplanar; vertices collinear with edges; ends at one place): all of these times are tried.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{FromPrimitive, One, Signed, ToPrimitive, Zero};

type Q = BigRational;

/// A polynomial, the constant first; no last coefficient is 0.
#[derive(Clone, Debug, PartialEq)]
struct Poly(Vec<Q>);

impl Poly {
    fn new(mut c: Vec<Q>) -> Self {
        while c.last().is_some_and(Zero::is_zero) {
            c.pop();
        }
        Self(c)
    }

    fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    fn plus(&self, other: &Self, factor: i32) -> Self {
        let at = |p: &Self, i: usize| p.0.get(i).cloned().unwrap_or_else(Q::zero);
        let factor = Q::from_i32(factor).expect("a number");
        let n = self.0.len().max(other.0.len());
        Self::new((0..n).map(|i| at(self, i) + &factor * at(other, i)).collect())
    }

    fn times(&self, other: &Self) -> Self {
        let mut c = vec![Q::zero(); (self.0.len() + other.0.len()).saturating_sub(1)];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                c[i + j] += a * b;
            }
        }
        Self::new(c)
    }

    fn derivative(&self) -> Self {
        let c = self.0.iter().enumerate().skip(1);
        Self::new(c.map(|(i, c)| c * Q::from_usize(i).expect("a number")).collect())
    }

    fn at(&self, t: &Q) -> Q {
        self.0.iter().rev().fold(Q::zero(), |sum, c| sum * t + c)
    }

    /// Quotient and remainder.
    fn divided(&self, by: &Self) -> (Self, Self) {
        let (mut rest, lead) = (self.0.clone(), by.0.last().expect("not 0"));
        let mut quotient = vec![Q::zero(); self.0.len().saturating_sub(by.0.len()) + 1];
        while rest.len() >= by.0.len() {
            let factor = rest.last().expect("long enough") / lead;
            let shift = rest.len() - by.0.len();
            for (i, c) in by.0.iter().enumerate() {
                rest[i + shift] -= &factor * c;
            }
            quotient[shift] = factor;
            rest.pop();
        }
        (Self::new(quotient), Self::new(rest))
    }

    /// Without multiple zeros.
    fn simple(&self) -> Self {
        let (mut a, mut b) = (self.clone(), self.derivative());
        while !b.is_zero() {
            let rest = a.divided(&b).1;
            (a, b) = (b, rest);
        }
        self.divided(&a).0
    }

    /// The sum of the signs of `of` at the zeros between two places that are none: Tarski's query.
    fn query(&self, of: &Self, from: &Q, to: &Q) -> i32 {
        let mut chain = vec![self.clone(), self.derivative().times(of)];
        while let Some(last) = chain.last().filter(|p| !p.is_zero()) {
            let rest = chain[chain.len() - 2].divided(last).1;
            chain.push(Poly::new(Vec::new()).plus(&rest, -1));
        }
        let variations = |t: &Q| {
            let signs: Vec<bool> = chain
                .iter()
                .map(|p| p.at(t))
                .filter(|v| !v.is_zero())
                .map(|v| v.is_positive())
                .collect();
            signs.windows(2).filter(|two| two[0] != two[1]).count() as i32
        };
        variations(from) - variations(to)
    }
}

/// A zero of the first without multiple zeros, the only one between two places that are none.
struct Place {
    of: Poly,
    from: Q,
    to: Q,
}

impl Place {
    fn sign(&self, of: &Poly) -> i32 {
        self.of.query(of, &self.from, &self.to)
    }

    /// Halves the interval; the zero must not become an end.
    fn halve(&mut self) {
        let part = Q::new(BigInt::from(1), BigInt::from(2));
        let mut middle = (&self.from + &self.to) * &part;
        while self.of.at(&middle).is_zero() {
            middle = (&self.from + &middle) * &part;
        }
        match self.of.query(&constant(1), &self.from, &middle) {
            0 => self.from = middle,
            _ => self.to = middle,
        }
    }
}

fn constant(x: i32) -> Poly {
    Poly::new(vec![Q::from_i32(x).expect("a number")])
}

/// The zeros in `[from, to]`.
fn places(p: &Poly, [from, to]: &[Q; 2]) -> Vec<Place> {
    if p.0.len() < 2 {
        return Vec::new();
    }
    let p = p.simple();
    // A little outside, where it is not 0: by the bound of Cauchy no zero is beyond.
    let mut margin = Q::one();
    loop {
        let ends = [from - &margin, to + &margin];
        let outside = |a: &Q, b: &Q| -> bool {
            // None between the window and the margin.
            [a, b].iter().all(|t| !p.at(t).is_zero())
        };
        if outside(&ends[0], &ends[1]) {
            let inside = closed(&p, from, to);
            if p.query(&constant(1), &ends[0], &ends[1]) == inside {
                return isolated(&p, &ends[0], &ends[1]);
            }
        }
        margin /= Q::from_i32(2).expect("a number");
    }
}

/// How many zeros there are in a closed interval.
fn closed(p: &Poly, from: &Q, to: &Q) -> i32 {
    let at = |t: &Q| p.at(t).is_zero() as i32;
    if from == to {
        return at(from);
    }
    // Sturm's count is of `(from, to]` if chains are signed as at the ends themselves.
    let ends = [from, to].map(at);
    let mut q = p.clone();
    for (t, is) in [(from, ends[0]), (to, ends[1])] {
        if is > 0 {
            q = q.divided(&Poly::new(vec![-t.clone(), Q::one()])).0;
        }
    }
    ends[0] + ends[1] + if q.0.len() < 2 { 0 } else { q.query(&constant(1), from, to) }
}

fn isolated(p: &Poly, from: &Q, to: &Q) -> Vec<Place> {
    match p.query(&constant(1), from, to) {
        0 => Vec::new(),
        1 => vec![Place { of: p.clone(), from: from.clone(), to: to.clone() }],
        _ => {
            let two = Q::from_i32(2).expect("a number");
            let mut middle = (from + to) / &two;
            while p.at(&middle).is_zero() {
                middle = (from + middle) / &two;
            }
            [isolated(p, from, &middle), isolated(p, &middle, to)].into_iter().flatten().collect()
        }
    }
}

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

/// Polynomials one of which is 0 when features first touch, or all are all the time.
struct Case {
    zeros: Vec<Poly>,
    rule: Rule,
}

fn on_edge(a: &Vector, b: &Vector) -> Case {
    let (span, sides) = (cross(a, b), dot(a, b));
    let zeros = span.iter().cloned().chain([sides.clone(), dot(a, a), dot(b, b)]).collect();
    let rule =
        move |sign: &dyn Fn(&Poly) -> i32| span.iter().all(|p| sign(p) == 0) && sign(&sides) <= 0;
    Case { zeros, rule: Box::new(rule) }
}

fn coplanar(cubic: Poly, normal: Vector, inside: Vec<Poly>, edges: Vec<Case>) -> Case {
    let zeros = edges.iter().flat_map(|edge| edge.zeros.clone()).chain([cubic.clone()]).collect();
    let rule = move |sign: &dyn Fn(&Poly) -> i32| {
        if sign(&cubic) != 0 {
            false
        } else if normal.iter().all(|p| sign(p) == 0) {
            edges.iter().any(|edge| (edge.rule)(sign))
        } else {
            inside.iter().all(|p| sign(p) >= 0)
        }
    };
    Case { zeros, rule: Box::new(rule) }
}

impl Case {
    /// The first contact in a window, between two numbers at most `2^-60` apart.
    fn first(&self, window: [f64; 2]) -> Option<[f64; 2]> {
        let window = window.map(|t| Q::from_f64(t).expect("a time"));
        let begin = &window[0];
        let sign_at = |p: &Poly| {
            let value = p.at(begin);
            value.is_positive() as i32 - value.is_negative() as i32
        };
        if (self.rule)(&sign_at) {
            return Some([begin.to_f64()?; 2]);
        }
        let all = self.zeros.iter().filter(|p| !p.is_zero()).flat_map(|p| places(p, &window));
        let touching = all.filter(|place| (self.rule)(&|p| place.sign(p)));
        let narrow = Q::new(BigInt::from(1), BigInt::from(1u64 << 60));
        let ends = touching.map(|mut place| {
            while &place.to - &place.from > narrow {
                place.halve();
            }
            [place.from.to_f64().expect("a time"), place.to.to_f64().expect("a time")]
        });
        ends.reduce(|a, b| [a[0].min(b[0]), a[1].min(b[1])])
    }
}

fn points<const K: usize>(t0: &[[f64; 3]; K], t1: &[[f64; 3]; K]) -> [Vector; K] {
    let exact = |x: f64| Q::from_f64(x).expect("a finite coordinate");
    std::array::from_fn(|i| {
        std::array::from_fn(|k| {
            let (a, b) = (exact(t0[i][k]), exact(t1[i][k]));
            Poly::new(vec![a.clone(), b - a])
        })
    })
}

/// Vertex-face, `v f0 f1 f2`: the first contact in a window, or none.
pub fn vertex_face(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4], window: [f64; 2]) -> Option<[f64; 2]> {
    let [p, a, b, c] = points(t0, t1);
    let [a, b, c] = [a, b, c].map(|q| minus(&q, &p));
    let normal = cross(&minus(&b, &a), &minus(&c, &a));
    let edges = [[&a, &b], [&b, &c], [&c, &a]];
    let inside = edges.map(|[a, b]| dot(&cross(a, b), &normal)).to_vec();
    let cubic = dot(&a, &normal);
    let edges = edges.map(|[a, b]| on_edge(a, b)).into();
    coplanar(cubic, normal, inside, edges).first(window)
}

/// Edge-edge, `ea0 ea1 eb0 eb1`: the first contact in a window, or none.
pub fn edge_edge(t0: &[[f64; 3]; 4], t1: &[[f64; 3]; 4], window: [f64; 2]) -> Option<[f64; 2]> {
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
    coplanar(cubic, normal, inside, edges).first(window)
}

/// Vertex-edge, `v e0 e1`: the first contact in a window, or none.
pub fn vertex_edge(t0: &[[f64; 3]; 3], t1: &[[f64; 3]; 3], window: [f64; 2]) -> Option<[f64; 2]> {
    let [p, a, b] = points(t0, t1);
    on_edge(&minus(&a, &p), &minus(&b, &p)).first(window)
}
