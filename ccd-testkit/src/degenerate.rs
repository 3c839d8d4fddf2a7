//! Queries that are degenerate or nearly so, of four families, and the judgement of exact decisions
//! of them by [`sturm`]: the same for tests, searches and long runs.
//!
//! Positions at a time of contact and motions are small integers, so that the ends of the step
//! follow exactly; or points are on a lattice, where most of what happens is degenerate. A third is
//! then moved by very little on one axis.

use crate::grazing::random::Random;
use crate::sturm::{self, Contacts};
use ccd_core::narrow_phase::codimensional::{VertexEdge, VertexVertex};
use ccd_core::narrow_phase::exact::{self, Exact};
use ccd_core::{EdgeEdge, VertexFace};

/// What is asked: `v f0 f1 f2`, `ea0 ea1 eb0 eb1`, `v e0 e1`, `v w`.
pub const FAMILIES: [&str; 4] = ["vertex-face", "edge-edge", "vertex-edge", "vertex-vertex"];

/// Kinds of degeneracy.
pub const KINDS: [&str; 11] = [
    "lattice",
    "coplanar",
    "coplanar, tilted",
    "at rest",
    "inside",
    "on a side",
    "in a corner",
    "end of a window",
    "without an extent",
    "double root",
    "far apart",
];

/// A query.
#[derive(Clone, Copy, Debug)]
pub struct Query {
    /// Of [`FAMILIES`].
    pub family: usize,
    /// Of [`KINDS`].
    pub kind: usize,
    /// Whether it was moved by very little.
    pub moved: bool,
    /// Points at the start of the step; a family with fewer takes the first.
    pub t0: [[f64; 3]; 4],
    /// At its end.
    pub t1: [[f64; 3]; 4],
    /// Times that are asked about.
    pub window: [f64; 2],
}

/// What a query turned out to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// No contact.
    Miss,
    /// One contact, or one at the start of the window.
    Contact,
    /// Several, of which the first was found.
    Several,
}

type V = [i64; 3];

fn vector(r: &mut Random, most: usize) -> V {
    std::array::from_fn(|_| r.below(2 * most + 1) as i64 - most as i64)
}

/// Corners of a patch and a point: a vertex and a face, or the ends of two edges.
fn points(family: usize, [a, b, c]: [V; 3], o: V) -> [V; 4] {
    let add = |p: V, q: V| -> V { std::array::from_fn(|k| p[k] + q[k]) };
    let minus = |p: V, q: V| -> V { std::array::from_fn(|k| p[k] - q[k]) };
    match FAMILIES[family] {
        "edge-edge" => [o, add(o, b), add(o, a), add(o, minus(a, c))],
        _ => [add(o, a), o, add(o, b), add(o, c)],
    }
}

impl Query {
    /// Any query of a family and a kind.
    pub fn new(family: usize, kind: usize, r: &mut Random) -> Self {
        let whole = [[0.0, 1.0], [0.0, 1.0], [0.25, 0.75], [0.1, 0.9]][r.below(4)];
        let (ends, window) = match KINDS[kind] {
            "lattice" | "coplanar" | "coplanar, tilted" | "at rest" => {
                (lattice(KINDS[kind], r), whole)
            }
            "far apart" => {
                let ends = match r.below(3) {
                    0 => meeting(family, "inside", whole, r).0,
                    1 => meeting(family, "double root", whole, r).0,
                    _ => lattice("lattice", r),
                };
                (ends, [whole, [f64::from_bits(1), 0.7]][r.below(2)])
            }
            _ => meeting(family, KINDS[kind], whole, r),
        };
        // Whether features touch does not depend on the unit.
        let unit = 2f64.powi([0, 0, 0, -30, 40][r.below(5)]);
        let [mut t0, mut t1] = ends.map(|x| x.map(|p| p.map(|x| x as f64 * unit)));
        let is_far = KINDS[kind] == "far apart";
        let moved = is_far || r.below(3) == 0;
        if is_far {
            // On a vertex, or on an axis, which does not matter.
            let far = [(); 4].map(|()| [(); 3].map(|()| 2f64.powi([0, -400, 300][r.below(3)])));
            let by_axes = r.below(2) == 0;
            for x in [&mut t0, &mut t1] {
                for (p, far) in x.iter_mut().zip(if by_axes { [far[0]; 4] } else { far }) {
                    *p = [0, 1, 2].map(|k| p[k] * far[k]);
                }
            }
        }
        if moved {
            let x = &mut [&mut t0, &mut t1][r.below(2)][r.below(4)][r.below(3)];
            let by = [-20, -45, -300, -1000][r.below(if is_far { 4 } else { 2 })];
            *x += r.sign() * unit * 2f64.powi(by);
        }
        Self { family, kind, moved, t0, t1, window }
    }

    /// The decision by integers.
    pub fn decided(&self) -> Option<Exact> {
        let Self { t0, t1, window, .. } = *self;
        let three = |x: [[f64; 3]; 4]| [x[0], x[1], x[2]];
        let two = |x: [[f64; 3]; 4]| [x[0], x[1]];
        match FAMILIES[self.family] {
            "vertex-face" => exact::vertex_face(&VertexFace { t0, t1 }, window),
            "edge-edge" => exact::edge_edge(&EdgeEdge { t0, t1 }, window),
            "vertex-edge" => {
                exact::vertex_edge(&VertexEdge { t0: three(t0), t1: three(t1) }, window)
            }
            _ => exact::vertex_vertex(&VertexVertex { t0: two(t0), t1: two(t1) }, window),
        }
    }

    /// Its contacts by the oracle.
    pub fn contacts(&self) -> Contacts {
        let Self { t0, t1, window, .. } = self;
        let three = |x: &[[f64; 3]; 4]| [x[0], x[1], x[2]];
        // Two vertices: one on an edge without length.
        let two = |x: &[[f64; 3]; 4]| [x[0], x[1], x[1]];
        match FAMILIES[self.family] {
            "vertex-face" => sturm::vertex_face(t0, t1, *window),
            "edge-edge" => sturm::edge_edge(t0, t1, *window),
            "vertex-edge" => sturm::vertex_edge(&three(t0), &three(t1), *window),
            _ => sturm::vertex_edge(&two(t0), &two(t1), *window),
        }
    }

    /// Compares both.
    ///
    /// # Errors
    /// Where they differ: how, and the query.
    pub fn judged(&self) -> Result<Outcome, String> {
        let contacts = self.contacts();
        let wrong = |what: String| {
            format!("{}, {}: {what}: {self:?}", FAMILIES[self.family], KINDS[self.kind])
        };
        let found = match self.decided() {
            None => return Err(wrong("not decided".into())),
            Some(Exact::Miss) => None,
            Some(Exact::Contact(times)) => Some(times),
        };
        contacts.check(found).map_err(wrong)?;
        Ok(match contacts.count() {
            0 => Outcome::Miss,
            1 => Outcome::Contact,
            _ => Outcome::Several,
        })
    }
}

/// Points of a lattice at both ends.
fn lattice(kind: &str, r: &mut Random) -> [[V; 4]; 2] {
    let n = [2, 3, 4, 9][r.below(4)];
    let tilt = [r.below(5) as i64 - 2, r.below(5) as i64 - 2];
    let mut four = || {
        [(); 4].map(|()| {
            let [x, y, z] = [(); 3].map(|()| r.below(n) as i64);
            match kind {
                "coplanar" => [x, y, 0],
                "coplanar, tilted" => [x, y, tilt[0] * x + tilt[1] * y],
                _ => [x, y, z],
            }
        })
    };
    let t0 = four();
    [t0, if kind == "at rest" { t0 } else { four() }]
}

/// Features that are in contact at a time `p / q`, and a window.
fn meeting(family: usize, kind: &str, whole: [f64; 2], r: &mut Random) -> ([[V; 4]; 2], [f64; 2]) {
    let is_end = kind == "end of a window";
    let q = if is_end { 1 << r.below(5) } else { 1 + r.below(12) as i64 };
    let p = r.below(q as usize + 1) as i64;
    // A grid of quarters on the patch.
    let n = 4;
    let mut side = || vector(r, 3).map(|x| n * x);
    let (mut b, mut c) = (side(), side());
    if kind == "without an extent" {
        match r.below(3) {
            0 => c = [0; 3],
            1 => (b, c) = ([0; 3], [0; 3]),
            _ => c = b.map(|x| [-1, 0, 1, 2][r.clone().below(4)] * x),
        }
    }
    let is_triangle = FAMILIES[family] != "edge-edge";
    let at = |r: &mut Random| r.below(n as usize + 1) as i64;
    let (mut i, mut j) = match kind {
        "on a side" => [(0, at(r)), (at(r), 0), (n, at(r)), (at(r), n)][r.below(4)],
        "in a corner" => [(0, 0), (0, n), (n, 0), (n, n)][r.below(4)],
        "inside" => (1 + r.below(2) as i64, 1),
        _ => (at(r), at(r)),
    };
    match FAMILIES[family] {
        "vertex-edge" => j = 0,
        "vertex-vertex" => (i, j) = (0, 0),
        _ if is_triangle && i + j > n => j = n - i,
        _ => (),
    }
    let mut x = [std::array::from_fn(|k| (b[k] * i + c[k] * j) / n), b, c];
    let mut v = [vector(r, 3), vector(r, 3), vector(r, 3)];
    if r.below(3) == 0 {
        // One plane that moves: linear in time.
        (v[1], v[2]) = ([0; 3], [0; 3]);
    }
    if kind == "double root" && r.below(2) == 0 {
        // A patch that shrinks to a point has a double root there, and the other at the contact.
        let by = [-2, -1, 1, 2][r.below(4)];
        (v[1], v[2]) = (b.map(|x| x / n * by), c.map(|x| x / n * by));
    } else if kind == "double root" {
        // A patch that turns about a side: coplanar where `h x - n z = m t^2`, and near that time
        // twice or never if `z` is moved.
        let [h0, h1, x1] = vector(r, 3);
        let y1 = vector(r, 3)[0];
        x = [[i, j, h0 * i], [n, 0, n * h0], [0, n, 0]];
        v = [[x1, y1, h0 * x1 + h1 * i], [0, 0, n * h1], [0; 3]];
    }
    if FAMILIES[family] == "vertex-vertex" && r.below(2) == 0 {
        v[0] = [0; 3];
    }
    let (o, drift) = (vector(r, 9), if r.below(2) == 0 { vector(r, 3) } else { [0; 3] });
    let ends = [-p, q - p].map(|u| {
        let moved = |x: V, v: V| -> V { std::array::from_fn(|k| x[k] + u * v[k]) };
        let lines = [0, 1, 2].map(|k| moved(x[k], v[k]));
        points(family, lines, moved(o, drift))
    });
    let t = p as f64 / q as f64;
    let (before, after) = (t.next_down().max(0.0), t.next_up().min(1.0));
    let windows = [[0.0, t], [t, t], [t, 1.0], [0.0, before], [after, 1.0]];
    (ends, if is_end { windows[r.below(5)] } else { whole })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The judgement fails where a time is moved by the least there is, and where a contact is lost
    /// or made up.
    #[test]
    fn wrong_answers_are_wrong() {
        let mut random = Random::new(1);
        let mut contacts = 0;
        for i in 0..400 {
            let query = Query::new(i % 4, i / 4 % KINDS.len(), &mut random);
            query.judged().unwrap();
            let right = query.contacts();
            match query.decided() {
                Some(Exact::Contact([lo, hi])) => {
                    contacts += 1;
                    assert!(right.check(None).is_err());
                    assert!(right.check(Some([lo.next_up(), hi.next_up()])).is_err());
                    assert!(right.check(Some([lo.next_down(), hi.next_down()])).is_err());
                    assert!(right.check(Some([lo, hi.next_up().next_up()])).is_err());
                }
                _ => assert!(right.check(Some([0.5; 2])).is_err()),
            }
        }
        assert!(contacts > 100, "{contacts}");
    }
}
