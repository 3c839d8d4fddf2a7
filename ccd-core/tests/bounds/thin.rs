//! Particles and rods that do not touch by less than rounding can tell: never a certain contact,
//! which exact arithmetic alone keeps apart from what touches.

use crate::common::random::Random;
use ccd_core::model::codimensional::Codimensional;
use ccd_core::model::mesh::Mesh;
use ccd_core::narrow_phase::codimensional::{
    VertexEdge, VertexVertex, search_vertex_edge, search_vertex_vertex,
};
use ccd_core::narrow_phase::intersection::segment_meets_triangle;
use ccd_core::narrow_phase::search::Search;
use ccd_core::{Real, Verdict};

/// Something falls by 2 through height 0 at half time, at `x`, onto an edge from 0 to `end`.
fn onto_edge(x: f64, end: f64, search: &Search<f64>) -> Verdict<f64> {
    let at = |y: f64| [[x, y, 0.0], [0.0; 3], [end, 0.0, 0.0]];
    search_vertex_edge(&VertexEdge { t0: at(1.0), t1: at(-1.0) }, search).verdict
}

fn onto_vertex(x: f64, search: &Search<f64>) -> Verdict<f64> {
    let at = |y: f64| [[x, y, 0.0], [0.0; 3]];
    search_vertex_vertex(&VertexVertex { t0: at(1.0), t1: at(-1.0) }, search).verdict
}

fn is_open(verdict: Verdict<f64>) -> bool {
    matches!(verdict, Verdict::Undecided { toi } if toi <= 0.5)
}

fn is_hit(verdict: Verdict<f64>) -> bool {
    matches!(verdict, Verdict::Hit { toi } if toi <= 0.5 && toi > 0.5 - 1e-6)
}

#[test]
fn what_passes_an_end_by_less_than_rounding_is_open() {
    let whole = Search::whole(0.0);
    let below = 2f64.powi(-60);
    for (x, end) in [(1.0f64.next_up(), 1.0), (-below, 1.0), (below, -1.0), (below, 0.0)] {
        let verdict = onto_edge(x, end, &whole);
        assert!(is_open(verdict), "{x:e} to {end}: {verdict:?}");
    }
    assert!(is_open(onto_vertex(below, &whole)) && is_open(onto_vertex(-below, &whole)));
    // The controls: what touches, and what is further away.
    for (x, end) in [(1.0, 1.0), (0.0, 1.0), (0.0, -1.0), (0.0, 0.0), (0.5, 1.0)] {
        assert!(is_hit(onto_edge(x, end, &whole)), "{x} to {end}");
    }
    assert!(is_hit(onto_vertex(0.0, &whole)));
    assert_eq!(onto_edge(1.0 + 1e-9, 1.0, &whole), Verdict::Miss);
    assert_eq!(onto_vertex(1e-9, &whole), Verdict::Miss);
}

#[test]
fn what_touches_after_a_window_is_no_contact_in_it() {
    for (until, hits) in [(0.5, true), (0.5f64.next_down(), false)] {
        let window = Search { until, ..Search::whole(0.0) };
        for verdict in [onto_edge(0.25, 1.0, &window), onto_vertex(0.0, &window)] {
            assert_eq!([is_hit(verdict), is_open(verdict)], [hits, !hits], "{until}: {verdict:?}");
        }
    }
}

#[test]
fn an_edge_in_the_plane_of_a_face_meets_it_within_and_at_its_border() {
    // A plane that no axis is normal to, in coordinates without rounding.
    let at = |u: f64, v: f64| [u, v, 2.0 * u - 3.0 * v];
    let face = [at(0.0, 0.0), at(8.0, 0.0), at(0.0, 8.0)];
    let meets = |p, q| segment_meets_triangle([p, q], face);
    for ((p, q), want) in [
        // Within, where it meets no side.
        ((at(1.0, 1.0), at(2.0, 3.0)), true),
        ((at(1.0, 1.0), at(1.0, 1.0)), true),
        // Across a side, along one, through a corner.
        ((at(1.0, 1.0), at(9.0, 1.0)), true),
        ((at(-1.0, 0.0), at(9.0, 0.0)), true),
        ((at(-1.0, 9.0), at(1.0, 7.0)), true),
        // Beside it.
        ((at(5.0, 5.0), at(9.0, 4.0)), false),
        ((at(9.0, 0.0), at(10.0, 0.0)), false),
        ((at(-1.0, -1.0), at(-2.0, 3.0)), false),
    ] {
        assert_eq!(meets(p, q), Some(want), "{p:?} to {q:?}");
        assert_eq!(meets(q, p), Some(want), "{q:?} to {p:?}");
    }
}

/// A particle that flies past a rod, or another particle, by some last digits of its coordinates,
/// across the plane of both ways: it is where the rod is at no time.
#[test]
fn what_flies_past_by_last_digits_is_no_certain_contact() {
    let mut random = Random::new(1);
    let product = |x: f64, y: f64| (x * y) as i64;
    let (n, mut n_open, mut n_hits) = (600, 0, 0);
    for _ in 0..n {
        let mut point = || -> [f64; 3] { std::array::from_fn(|_| random.below(5) as f64 - 2.0) };
        let (e0, side, way) = (point(), point(), point());
        let normal: [i64; 3] = std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            product(side[i], way[j]) - product(side[j], way[i])
        });
        let Some(axis) = (0..3).find(|&k| normal[k] != 0) else { continue };
        // Met at half time, at a quarter of the edge.
        let met: [f64; 3] = std::array::from_fn(|k| e0[k] + 0.25 * side[k]);
        let e1 = std::array::from_fn(|k| e0[k] + side[k]);
        let at = |s: f64, by: f64| {
            let mut p: [f64; 3] = std::array::from_fn(|k| met[k] + s * way[k]);
            p[axis] += by;
            p
        };
        let edge = |by: f64| VertexEdge { t0: [at(-1.0, by), e0, e1], t1: [at(1.0, by), e0, e1] };
        let vertex = |by: f64| VertexVertex { t0: [at(-1.0, by), met], t1: [at(1.0, by), met] };
        let of = |by: f64| {
            let whole = Search::whole(0.0);
            let answers =
                [search_vertex_edge(&edge(by), &whole), search_vertex_vertex(&vertex(by), &whole)];
            answers.map(|answer| answer.verdict)
        };
        let by = 2f64.powi(random.below(4) as i32 - 50) * random.sign();
        // As far at both ends, so that it is in between.
        let [p, q] = [-1.0, 1.0].map(|s| at(s, by)[axis] - at(s, 0.0)[axis]);
        if p != by || q != by {
            continue;
        }
        for verdict in of(by) {
            assert!(!matches!(verdict, Verdict::Hit { .. }), "{verdict:?} {by:e} {:?}", edge(by));
            n_open += (verdict != Verdict::Miss) as usize;
        }
        n_hits += of(0.0).into_iter().filter(|&verdict| is_hit(verdict)).count();
    }
    println!("{n_open} open, {n_hits} hits without the digits, of {n}");
    assert!(n_open > n / 3 && n_hits > n / 3, "{n_open} {n_hits}");
}

/// Boxes of what is within a distance overlap, whatever the unit, and not of what is twice as far.
#[test]
fn boxes_of_what_is_within_the_distance_overlap() {
    fn check<T: Real>(units: &[f64]) {
        // A rod along the first axis, a particle above its middle, another above that.
        let mesh = Mesh::with_edges(4, &[], &[[0, 1]]).unwrap();
        let thin = Codimensional::of(&mesh);
        for unit in units {
            for (d, overlaps) in [(0.1, true), (0.3, true), (0.1 / 2.001, false)] {
                let at = |y: f64| [1.0, y, 0.0];
                let x = [[0.0; 3], [3.0, 0.0, 0.0], at(0.1), at(0.2)];
                let x = x.map(|p| p.map(|c| T::from_f64(c * unit)));
                let least = x[2][1].to_f64().max(x[3][1].to_f64() - x[2][1].to_f64());
                let d = if d == 0.1 { least } else { d * unit };
                let [p, q] = [0, 1].map(|i| thin.vertex_box(i, [&x, &x], d));
                let rod = thin.edge_box(0, &mesh, [&x, &x], d);
                assert_eq!([p.overlaps(&rod), p.overlaps(&q)], [overlaps; 2], "{d:e} of {unit:e}");
            }
        }
    }
    check::<f64>(&[1.0, 1e-3, 1e100, 1e-150]);
    check::<f32>(&[1.0, 1e-3, 1e30, 1e-30]);
}
