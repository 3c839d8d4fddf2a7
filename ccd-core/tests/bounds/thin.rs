//! Particles and rods that do not touch by less than rounding can tell: never a certain contact,
//! which exact arithmetic alone keeps apart from what touches.

use ccd_core::Verdict;
use ccd_core::narrow_phase::codimensional::{
    VertexEdge, VertexVertex, search_vertex_edge, search_vertex_vertex,
};
use ccd_core::narrow_phase::search::Search;

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
