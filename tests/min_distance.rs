//! Steps with a minimum distance against every pair measured by other means, with gaps of half to
//! all of the distance.

use ccd::scenes::{Random, triangle_soup};
use ccd::{Coordinate, Kind, Mesh, Options, Pair, Session, State, TOI_TOLERANCE};
use ccd_testkit::brute::feature_pairs;
use first::{First, first_within, point_triangle, segment_segment};
use std::collections::HashMap;

#[path = "../ccd-core/tests/bounds/common/distance.rs"]
mod first;

type Positions = Vec<[f64; 3]>;

/// How much later than the first time a time may seem, by the rounding of positions and of the
/// comparison.
const LATE: f64 = 1e-8;

/// Pairs of flat triangles, far from each other, with a gap along one axis of a third of the
/// distance to more than all of it; the upper one slides and sinks a little.
fn stacks(n: usize, d: f64, seed: u32) -> (Mesh, Positions, Positions) {
    let mut random = Random::new(seed);
    let (mut x0, mut x1) = (Vec::new(), Vec::new());
    for i in 0..n {
        let gap = d * (0.3 + random.unit());
        let slide =
            [0.2 * (random.unit() - 0.5), 0.2 * (random.unit() - 0.5), -0.2 * d * random.unit()];
        let axis = i % 3;
        for (height, moves) in [(0.0, [0.0; 3]), (gap, slide)] {
            for _ in 0..3 {
                let p = [random.unit(), random.unit(), height];
                let q = [p[0] + moves[0], p[1] + moves[1], p[2] + moves[2]];
                let place = |p: [f64; 3]| -> [f64; 3] {
                    std::array::from_fn(|k| {
                        p[(k + axis) % 3] + 3.0 * [i % 4, i / 4 % 4, i / 16][k] as f64
                    })
                };
                x0.push(place(p));
                x1.push(place(q));
            }
        }
    }
    let faces: Vec<[u32; 3]> = (0..2 * n as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    (Mesh::new(6 * n, &faces).expect("valid stacks"), x0, x1)
}

/// Every pair without a common vertex, and the first time at which it is within the distance.
fn every_pair(
    mesh: &Mesh,
    x0: &[[f64; 3]],
    x1: &[[f64; 3]],
    d: f64,
) -> Vec<((Kind, u32, u32), First)> {
    let first = |(kind, pair): (Kind, Pair)| {
        let [p, q] = [x0, x1].map(|x| mesh.vertices_of(kind, pair).map(|v| x[v as usize]));
        let first = match kind {
            Kind::VertexFace => first_within(point_triangle, 1, &p, &q, d),
            _ => first_within(segment_segment, 2, &p, &q, d),
        };
        ((kind, pair.a, pair.b), first)
    };
    feature_pairs(mesh).into_iter().map(first).collect()
}

/// Contacts of a step are those of every pair. Returns how many of them begin with a gap in half to
/// all of the distance.
fn check<T: Coordinate>(mesh: &Mesh, x0: &Positions, x1: &Positions, d: f64) -> usize {
    let narrow = |x: &Positions| -> Vec<[T; 3]> { x.iter().map(|p| p.map(T::from_f64)).collect() };
    let (x0, x1) = (narrow(x0), narrow(x1));
    let wide = |x: &[[T; 3]]| -> Positions { x.iter().map(|p| p.map(|c| c.to_f64())).collect() };
    let options = Options::default().with_min_distance(d).with_threads(2);
    let mut session = Session::new(mesh.clone(), options).expect("valid options");
    let report = session.step(&x0, &x1).expect("valid positions");
    let mut got: HashMap<_, _> =
        report.contacts.iter().map(|c| ((c.kind, c.a, c.b), (c.toi, c.state))).collect();
    assert_eq!(got.len(), report.contacts.len(), "contacts twice");
    let (x0, x1) = (wide(&x0), wide(&x1));
    let near: HashMap<_, _> = every_pair(mesh, &x0, &x1, 0.5 * d).into_iter().collect();
    let mut n = 0;
    for (pair, first) in every_pair(mesh, &x0, &x1, d) {
        let contact = got.remove(&pair);
        let fine = match (first, contact) {
            (First::At(t), Some((toi, State::Hit))) => {
                toi <= t + LATE && toi >= t - TOI_TOLERANCE - LATE
            }
            (First::At(t), Some((toi, _))) => toi <= t + LATE,
            (First::At(_), None) => false,
            (First::Never, contact) => !matches!(contact, Some((_, State::Hit))),
            (First::Unclear, _) => true,
        };
        assert!(fine, "{pair:?}: {contact:?}, but {first:?}, d = {d}");
        n += (matches!(first, First::At(_)) && near[&pair] == First::Never) as usize;
    }
    assert!(got.is_empty(), "contacts of no pair: {got:?}");
    n
}

#[test]
fn steps_at_a_distance_equal_every_pair() {
    for seed in 0..3 {
        let d = [0.05, 1e-3, 0.3][seed as usize];
        let (mesh, x0, x1) = stacks(30, d, seed);
        let n = [check::<f64>(&mesh, &x0, &x1, d), check::<f32>(&mesh, &x0, &x1, d)];
        assert!(n.iter().all(|n| *n > 30), "{n:?} gaps of half to all of {d} show nothing");
        let soup = triangle_soup(60, 0.15, seed);
        let n = check::<f64>(&soup.mesh, &soup.x0, &soup.x1, 0.02);
        assert!(n > 10, "{n} gaps of half to all of the distance show nothing");
    }
}
