//! Families of queries that are nearly degenerate, in integers: features that are in contact at a
//! known time `p / q`, whatever their motion is, so that what is right needs no arithmetic.
//!
//! A query is a patch spanned by `b` and `c` from a corner, and a point `a` seen from there
//! (`relative_motion.rs`): contact is `a = s b + r c`. Positions at the time of contact and motions
//! are chosen; the ends of the step follow, and are exact.

use ccd::geometry::Patch;
use ccd::{Kind, TOI_TOLERANCE};
use ccd_testkit::grazing::random::Random;
use ccd_testkit::grazing::{Points, tangential, widen};
use serde::{Deserialize, Serialize};

pub type V = [i64; 3];

/// A vector at the time of contact, and its motion in `1 / q` of the step.
pub type Line = [V; 2];

/// Answer of a query that is known by construction.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Known {
    /// Contact at the time of the batch; whether it is the first for certain.
    At { first: bool },
    /// No contact.
    Free,
    /// Only exact arithmetic knows.
    Nothing,
}

/// A query in integers.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Form {
    pub a: Line,
    pub b: Line,
    pub c: Line,
    /// The corner from which these are seen.
    pub o: Line,
    pub known: Known,
}

/// Queries that have all in common but their positions: what one session is asked at once.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Batch {
    pub family: usize,
    /// Whether coordinates are `f64`.
    pub wide: bool,
    /// Coordinates are multiples of two to this.
    pub unit: i32,
    /// The time of contact, `p / q`.
    pub p: i64,
    pub q: i64,
    pub min_distance: f64,
    pub window: [f64; 2],
    pub leaves: bool,
    pub queries: Vec<Query>,
    /// Bits of positions, of motions, of the offset; whether the offset moves.
    pub bits: [u32; 3],
    pub moves: bool,
    /// A vector of whole length.
    pub gap: (V, i64),
}

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Query {
    pub kind: Kind,
    /// In the unit of the batch.
    pub t0: Points<f64>,
    pub t1: Points<f64>,
    pub known: Known,
    pub form: Option<Form>,
}

/// Names, and what makes a form of what meets anywhere.
type Family = (&'static str, fn(&mut Random, &Batch, &mut Form, Patch));

const ZERO: Line = [[0; 3]; 2];

/// Vectors of whole length, for gaps and distances.
const GAPS: [(V, i64); 5] =
    [([1, 2, 2], 3), ([2, 3, 6], 7), ([3, 4, 0], 5), ([2, 6, 9], 11), ([3, 4, 12], 13)];

pub const FAMILIES: [Family; 26] = [
    ("inside", |_, _, _, _| {}),
    ("corners", |r, _, f, patch| meet(r, f, patch, 2)),
    ("sides", |r, _, f, patch| meet(r, f, patch, 1)),
    ("tangential", |r, s, f, patch| tangent(r, s, f, patch, false)),
    ("tangential on a side", |r, s, f, patch| tangent(r, s, f, patch, true)),
    ("nearly tangential", |r, s, f, patch| {
        tangent(r, s, f, patch, r.clone().below(2) == 0);
        f.a[0][2] += [-1, 1][r.below(2)];
        f.known = Known::Nothing;
    }),
    ("coplanar", |_, _, f, _| flatten(f)),
    ("coplanar, tilted", |r, _, f, _| {
        flatten(f);
        let (g, h) = (small(r), small(r));
        let tilt = |v: V| std::array::from_fn(|k| v[0] * g[k] + v[1] * h[k]);
        [f.a, f.b, f.c] = [f.a, f.b, f.c].map(|line| line.map(tilt));
    }),
    ("at rest", |_, _, f, _| (f.a[1], f.b[1], f.c[1]) = ([0; 3], [0; 3], [0; 3])),
    ("patch at rest", |_, _, f, _| (f.b[1], f.c[1]) = ([0; 3], [0; 3])),
    ("at the start", |_, _, _, _| {}),
    ("at the end", |_, _, _, _| {}),
    ("end of a window", |_, _, _, _| {}),
    ("outside of a window", |r, _, f, patch| {
        (f.b[1], f.c[1]) = ([0; 3], [0; 3]);
        meet(r, f, patch, 0);
    }),
    ("parallel", |r, _, f, patch| {
        let by = r.below(5) as i64 - 2;
        (f.c[0], f.c[1]) = (f.b[0].map(|x| by * x), f.b[1].map(|x| by * x));
        let ends = [[0; 3], f.b[0], f.c[0], add(f.b[0], f.c[0])];
        f.a[0] = ends[r.below(if patch == Patch::Triangle { 3 } else { 4 })];
    }),
    ("without an extent", |r, _, f, _| {
        (f.c, f.a[0]) = (ZERO, [0; 3]);
        if r.below(2) == 0 {
            f.b = ZERO
        }
    }),
    ("needles", |r, _, f, patch| {
        f.c = f.c.map(|v| v.map(|x| x.signum()));
        meet(r, f, patch, 1);
    }),
    ("fast", |r, s, f, patch| {
        (f.b[0], f.c[0]) = (small(r), small(r));
        meet(r, f, patch, 0);
        f.a[1] = vector(r, s.bits[0]);
    }),
    ("slow", |_, _, f, _| {
        [f.a, f.b, f.c] = [f.a, f.b, f.c].map(|[x, v]| [x, v.map(i64::signum)]);
    }),
    ("offset by much", |_, _, _, _| {}),
    ("distance", |r, s, f, patch| {
        meet(r, f, patch, r.clone().below(3));
        f.a[0] = add(f.a[0], turned(r, s.gap.0));
    }),
    ("distance, passing", |r, s, f, _| {
        // Nearest where the way between them is at right angles to the motion.
        let g = turned(r, s.gap.0);
        let w = small(r);
        f.a =
            [g, [g[1] * w[2] - g[2] * w[1], g[2] * w[0] - g[0] * w[2], g[0] * w[1] - g[1] * w[0]]];
        let away = |v: V| {
            let along: i64 = (0..3).map(|k| v[k] * g[k]).sum();
            if along > 0 { v.map(|x| -x) } else { v }
        };
        (f.b, f.c) = ([away(f.b[0]), [0; 3]], [away(f.c[0]), [0; 3]]);
    }),
    ("distance, just not", |r, s, f, patch| {
        flatten(f);
        meet(r, f, patch, 0);
        (f.a[1], f.b[1], f.c[1]) = ([0; 3], [0; 3], [0; 3]);
        f.a[0][2] = s.gap.1;
        f.known = Known::Free;
    }),
    ("leaving", |_, s, f, _| {
        // In contact with nothing at the start for certain, so that it has been left.
        let start = |line: Line| -> V { std::array::from_fn(|k| line[0][k] - s.p * line[1][k]) };
        if determinant(start(f.b), start(f.c), start(f.a)) == 0 {
            f.known = Known::Nothing;
        }
    }),
    ("grazing", |_, _, f, _| f.known = Known::Nothing),
    ("coarse", |_, _, f, _| f.known = Known::Nothing),
];

fn named(family: usize) -> &'static str {
    FAMILIES[family].0
}

impl Batch {
    pub fn name(&self) -> &'static str {
        named(self.family)
    }

    /// A batch of `n` queries of any family.
    pub fn new(random: &mut Random, n: usize) -> Self {
        let family = random.below(FAMILIES.len());
        let name = named(family);
        let wide = random.below(2) == 0;
        let q = match name {
            "end of a window" | "outside of a window" => 1i64 << random.below(6),
            _ => 1 + random.below(48) as i64,
        };
        let p = match name {
            "at the start" => 0,
            "at the end" => q,
            "leaving" => 1 + random.below(q as usize) as i64,
            _ => random.below(q as usize + 1) as i64,
        };
        let bits = |random: &mut Random, most: u32| 1 + random.below(most as usize) as u32;
        let sizes = if wide { [30, 22, 40] } else { [12, 8, 21] };
        let offset = match name {
            "offset by much" => sizes[2],
            _ => [0, bits(random, sizes[2])][random.below(2)],
        };
        let size = [bits(random, sizes[0]), bits(random, sizes[1]), offset];
        let unit = match (random.below(6), wide) {
            (0..3, _) => 0,
            (3 | 4, false) => random.below(250) as i32 - 149,
            (3 | 4, true) => random.below(1000) as i32 - 740,
            // Where the least numbers are, and where sums and products begin to be subnormal.
            (_, false) => -149 + random.below(32) as i32,
            (_, true) => -1074 + random.below(64) as i32,
        };
        let (v, length) = GAPS[random.below(GAPS.len())];
        let by = 1i64 << random.below(size[0] as usize);
        let gap = (v.map(|x| x * by), length * by);
        let time = p as f64 / q as f64;
        let window = match (name, random.below(3)) {
            ("end of a window", 0) => [0.0, time],
            ("end of a window", 1) => [time, time],
            ("end of a window", _) => [time, 1.0],
            ("outside of a window", 0) if time > 0.25 => [0.0, time - 0.25],
            ("outside of a window", _) if time < 0.75 => [time + 0.25, 1.0],
            _ => [0.0, 1.0],
        };
        let min_distance = match name {
            "distance" | "distance, passing" => gap.1 as f64,
            "distance, just not" => (gap.1 - 1) as f64,
            "leaving" => (1i64 << size[0]) as f64,
            _ => 0.0,
        };
        let leaves = name == "leaving";
        let queries = Vec::new();
        let moves = random.below(3) == 0;
        let mut batch = Self {
            family,
            wide,
            unit,
            p,
            q,
            min_distance,
            window,
            leaves,
            queries,
            bits: size,
            moves,
            gap,
        };
        batch.queries = (0..n).map(|_| batch.query(random)).collect();
        batch
    }

    fn query(&self, random: &mut Random) -> Query {
        let kind = [Kind::VertexFace, Kind::EdgeEdge][random.below(2)];
        let patch = kind.patch();
        match self.name() {
            "grazing" if self.wide => given(tangential::query::<f64>(random)),
            "grazing" => given(tangential::query::<f32>(random)),
            "coarse" => {
                let mut four = || std::array::from_fn(|_| small(random).map(|x| x as f64));
                let (t0, t1) = (four(), four());
                Query { kind, t0, t1, known: Known::Nothing, form: None }
            }
            _ => {
                let [at, motion, offset] = self.bits;
                let n = 2 << random.below(3);
                let mut side = || {
                    let from = vector(random, at).map(|x| (x + n - 1) / n * n);
                    [from, vector(random, motion)]
                };
                let mut form = Form {
                    b: side(),
                    c: side(),
                    a: side(),
                    o: ZERO,
                    known: Known::At { first: false },
                };
                meet(random, &mut form, patch, 0);
                FAMILIES[self.family].1(random, self, &mut form, patch);
                let drift = if self.moves { vector(random, motion) } else { [0; 3] };
                form.o = [vector(random, offset), drift];
                let (axis, way) = (random.below(3), random.below(2));
                let turn = |v: V| {
                    let v = [v[axis], v[(axis + 1) % 3], v[(axis + 2) % 3]];
                    if way == 0 { v } else { [v[1], v[0], v[2]] }
                };
                let Form { a, b, c, .. } = form;
                [form.a, form.b, form.c] = [a, b, c].map(|line| line.map(turn));
                self.assembled(kind, form)
            }
        }
    }

    /// The ends of the step; what is the only time of coplanarity is the first contact.
    pub fn assembled(&self, kind: Kind, form: Form) -> Query {
        let Form { a, b, c, o, known } = form;
        let at = |u: i64| -> Points<f64> {
            let [a, b, c, o]: [V; 4] =
                [a, b, c, o].map(|line| std::array::from_fn(|k| line[0][k] + u * line[1][k]));
            let minus = |v: V, w: V| std::array::from_fn(|k| v[k] - w[k]);
            let points = match kind.patch() {
                Patch::Triangle => [add(o, a), o, add(o, b), add(o, c)],
                Patch::Parallelogram => [o, add(o, b), add(o, a), add(o, minus(a, c))],
            };
            points.map(|p| p.map(|x| x as f64))
        };
        let linear = b[1] == [0; 3] && c[1] == [0; 3] && determinant(b[0], c[0], a[1]) != 0;
        let known = match known {
            Known::At { .. } if self.name() == "outside of a window" => {
                let outside = self.window != [0.0, 1.0] && linear;
                if outside { Known::Free } else { Known::Nothing }
            }
            Known::At { .. } => Known::At { first: linear && self.min_distance == 0.0 },
            other => other,
        };
        Query { kind, t0: at(-self.p), t1: at(self.q - self.p), known, form: Some(form) }
    }

    /// Whether a time is not after the contact; exact, as the product is rounded once.
    pub fn in_time(&self, toi: f64) -> bool {
        toi.mul_add(self.q as f64, -(self.p as f64)) <= 0.0
    }

    pub fn is_early(&self, toi: f64) -> bool {
        toi < self.p as f64 / self.q as f64 - TOI_TOLERANCE * 1.000_001 - 1e-15
    }
}

/// A query of floating-point numbers.
fn given<R: ccd::Real>(q: tangential::Query<R>) -> Query {
    let (t0, t1) = (widen(&q.t0), widen(&q.t1));
    let kind = if q.patch == Patch::Triangle { Kind::VertexFace } else { Kind::EdgeEdge };
    Query { kind, t0, t1, known: Known::Nothing, form: None }
}

fn add(a: V, b: V) -> V {
    std::array::from_fn(|k| a[k] + b[k])
}

fn determinant(b: V, c: V, a: V) -> i128 {
    let [b, c, a] = [b, c, a].map(|v| v.map(i128::from));
    (0..3).map(|k| a[k] * (b[(k + 1) % 3] * c[(k + 2) % 3] - b[(k + 2) % 3] * c[(k + 1) % 3])).sum()
}

/// Components of so many bits.
fn vector(r: &mut Random, bits: u32) -> V {
    let size = (1u64 << bits) - 1;
    std::array::from_fn(|_| (r.bits() % (2 * size + 1)) as i64 - size as i64)
}

fn small(r: &mut Random) -> V {
    vector(r, 2)
}

/// The same length in another direction.
fn turned(r: &mut Random, v: V) -> V {
    let first = r.below(3);
    std::array::from_fn(|k| v[(first + k) % 3] * [-1, 1][r.below(2)])
}

fn flatten(f: &mut Form) {
    for line in [&mut f.a, &mut f.b, &mut f.c] {
        line.iter_mut().for_each(|v| v[2] = 0);
    }
}

/// Puts `a` on the patch, where that is whole: in it, on a side (1), in a corner (2).
fn meet(r: &mut Random, f: &mut Form, patch: Patch, place: usize) {
    let divides = |n: i64| f.b[0].iter().chain(&f.c[0]).all(|x| x % n == 0);
    let n = [8, 4, 2, 1].into_iter().find(|&n| divides(n)).unwrap_or(1);
    let any = r.below(n as usize + 1) as i64;
    // Not on a side, where there is anything else.
    let inner = |r: &mut Random| if n > 2 { 1 + r.below(n as usize - 1) as i64 } else { any };
    let (mut i, mut j) = match place {
        0 => (inner(r), inner(r)),
        1 => [(0, any), (any, 0), (n, any), (any, n)][r.below(4)],
        _ => [(0, 0), (0, n), (n, 0), (n, n)][r.below(4)],
    };
    if patch == Patch::Triangle && i + j > n {
        (i, j) = if place == 0 { (n - i, n - j) } else { (i, n - i) };
    }
    f.a[0] = std::array::from_fn(|k| f.b[0][k] / n * i + f.c[0][k] / n * j);
}

/// A patch that turns about a side, and a point for which coplanarity has a double root at the time
/// of contact: `h x - n z = m t^2`, with `b = (n, 0, h)`, `c = (0, n, 0)`, `a = (x, y, z)`.
fn tangent(r: &mut Random, s: &Batch, f: &mut Form, patch: Patch, side: bool) {
    let bits = s.bits[0].min(s.bits[1]).min(if s.wide { 10 } else { 5 });
    let n = 1i64 << r.below(bits.min(5) as usize + 1);
    let [h0, h1, x1] = vector(r, bits.div_ceil(2));
    let x0 = r.below(n as usize + 1) as i64;
    let most = if patch == Patch::Triangle { n - x0 } else { n };
    let y0 = if side { [0, most][r.below(2)] } else { r.below(most as usize + 1) as i64 };
    let y1 = vector(r, bits)[0];
    f.a = [[x0, y0, h0 * x0], [x1, y1, h0 * x1 + h1 * x0]];
    f.b = [[n, 0, n * h0], [0, 0, n * h1]];
    f.c = [[0, n, 0], [0, 0, 0]];
}
