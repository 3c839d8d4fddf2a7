//! Properties that hold for every input, on random ones; and the exact oracle, brute force and
//! dense sampling as judges. Here: single queries.

mod codimensional;
mod exact;
mod exact_geometry;
mod geometry;
mod separation;
mod worlds;

use ccd::{EdgeEdge, TOI_TOLERANCE, Verdict, VertexFace};
use ccd_core::narrow_phase::coplanarity::Coplanarity;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_testkit::grazing::exact::{Contact, contact};
use proptest::prelude::*;

type Points = [[f64; 3]; 4];

/// Coordinates on a coarse grid (degenerate cases are common) or anywhere.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![(-4i32..=4).prop_map(|i| i as f64 * 0.25), -1.0..1.0f64]
}

fn points() -> impl Strategy<Value = Points> {
    prop::array::uniform4(prop::array::uniform3(coordinate()))
}

fn vf(t0: Points, t1: Points) -> Verdict<f64> {
    ccd::vertex_face(&VertexFace { t0, t1 }, 0.0)
}

fn ee(t0: Points, t1: Points) -> Verdict<f64> {
    ccd::edge_edge(&EdgeEdge { t0, t1 }, 0.0)
}

/// Two verdicts of the same geometry: never one certain of a contact and the other of none; two
/// certain times agree.
fn check_consistent(a: Verdict<f64>, b: Verdict<f64>) {
    match (a, b) {
        (Verdict::Hit { toi: x }, Verdict::Hit { toi: y }) => {
            assert!((x - y).abs() <= TOI_TOLERANCE, "{a:?} {b:?}")
        }
        (Verdict::Hit { .. }, Verdict::Miss) | (Verdict::Miss, Verdict::Hit { .. }) => {
            panic!("{a:?} contradicts {b:?}")
        }
        _ => {}
    }
}

fn widen(verdict: Verdict<f32>) -> Verdict<f64> {
    match verdict {
        Verdict::Miss => Verdict::Miss,
        Verdict::Hit { toi } => Verdict::Hit { toi: f64::from(toi) },
        Verdict::Undecided { toi } => Verdict::Undecided { toi: f64::from(toi) },
    }
}

/// A verdict against the exact answer.
fn check_oracle(verdict: Verdict<f64>, answer: &Contact) {
    match (verdict, answer) {
        (Verdict::Miss, Contact::At(..)) => panic!("missed: {answer:?}"),
        (Verdict::Hit { .. }, Contact::Free) => panic!("{verdict:?}, but there is no contact"),
        (Verdict::Hit { toi }, Contact::At([lo, hi], true)) => {
            assert!(toi <= *hi && toi >= lo - TOI_TOLERANCE, "{verdict:?} {answer:?}")
        }
        // There may be a contact before the certain one.
        (Verdict::Hit { toi } | Verdict::Undecided { toi }, Contact::At([_, hi], _)) => {
            assert!(toi <= *hi, "{verdict:?} {answer:?}")
        }
        _ => {}
    }
}

fn config(cases: u32, seed: u64) -> ProptestConfig {
    let rng_seed = proptest::test_runner::RngSeed::Fixed(seed);
    ProptestConfig { cases, rng_seed, ..ProptestConfig::default() }
}

fn map(x: Points, f: impl Fn([f64; 3]) -> [f64; 3]) -> Points {
    x.map(f)
}

proptest! {
    #![proptest_config(config(4000, 1))]

    #[test]
    fn swapping_edges_and_ends_changes_nothing(t0 in points(), t1 in points()) {
        let want = ee(t0, t1);
        for order in [[2, 3, 0, 1], [1, 0, 2, 3], [0, 1, 3, 2], [3, 2, 1, 0]] {
            check_consistent(want, ee(order.map(|i| t0[i]), order.map(|i| t1[i])));
        }
    }

    #[test]
    fn permuting_the_face_changes_nothing(t0 in points(), t1 in points()) {
        let want = vf(t0, t1);
        for order in [[0, 2, 3, 1], [0, 3, 1, 2], [0, 2, 1, 3], [0, 1, 3, 2], [0, 3, 2, 1]] {
            check_consistent(want, vf(order.map(|i| t0[i]), order.map(|i| t1[i])));
        }
    }

    #[test]
    fn mirroring_and_turning_axes_changes_nothing(t0 in points(), t1 in points()) {
        let mirror = |p: [f64; 3]| [-p[0], p[1], p[2]];
        let half_turn = |p: [f64; 3]| [p[0], -p[1], -p[2]];
        let next_axes = |p: [f64; 3]| [p[1], p[2], p[0]];
        for f in [mirror, half_turn, next_axes] {
            check_consistent(vf(t0, t1), vf(map(t0, f), map(t1, f)));
            check_consistent(ee(t0, t1), ee(map(t0, f), map(t1, f)));
        }
    }

    #[test]
    fn scaling_by_a_power_of_two_changes_no_bit(
        t0 in points(), t1 in points(), exponent in -40i32..40
    ) {
        let f = |p: [f64; 3]| p.map(|c| c * 2f64.powi(exponent));
        prop_assert_eq!(vf(t0, t1), vf(map(t0, f), map(t1, f)));
        prop_assert_eq!(ee(t0, t1), ee(map(t0, f), map(t1, f)));
    }

    #[test]
    fn filters_reject_misses_only(t0 in points(), t1 in points(), distance in 0.0..0.2f64) {
        for d in [0.0, distance] {
            let (face, edges) = (VertexFace { t0, t1 }, EdgeEdge { t0, t1 });
            let rejects = |motion: Motion<f64>| Coplanarity::new(&motion).clearance(d) > 0.0;
            if rejects(Motion::vertex_face(&t0, &t1, 0.0)) {
                prop_assert_eq!(ccd::vertex_face(&face, d), Verdict::Miss);
                check_oracle(Verdict::Miss, &contact(Patch::Triangle, &t0, &t1));
            }
            if rejects(Motion::edge_edge(&t0, &t1, 0.0)) {
                prop_assert_eq!(ccd::edge_edge(&edges, d), Verdict::Miss);
                check_oracle(Verdict::Miss, &contact(Patch::Parallelogram, &t0, &t1));
            }
        }
    }

    #[test]
    fn reversing_time_keeps_the_answer(t0 in points(), t1 in points()) {
        use Verdict::{Hit, Miss};
        let check = |a: Verdict<f64>, b: Verdict<f64>| {
            assert!(!matches!((a, b), (Hit { .. }, Miss) | (Miss, Hit { .. })))
        };
        check(vf(t0, t1), vf(t1, t0));
        check(ee(t0, t1), ee(t1, t0));
    }

    /// In every unit; with one coordinate that is far larger or smaller than the others, so that
    /// the unit is not that of the rest; and where a vertex ends on the face, or an edge on the
    /// edge, up to the rounding to `f32`.
    #[test]
    fn f32_and_f64_agree(
        t0 in points(), t1 in points(), exponent in -30i32..30,
        (vertex, axis, other) in (0usize..8, 0usize..3, -30i32..30),
        (u, v) in (0.1..0.45, 0.1..0.45),
    ) {
        let (mut far, mut on_face, mut on_edge) = ([t0, t1], [t0, t1], [t0, t1]);
        far[vertex / 4][vertex % 4][axis] *= 2f64.powi(other);
        for k in 0..3 {
            let [p, a, b, c] = t1.map(|x| x[k]);
            on_face[1][0][k] = a + u * (b - a) + v * (c - a);
            on_edge[1][1][k] = p + (b + u * (c - b) - p) / (v + 0.5);
        }
        for x in [[t0, t1], far, on_face, on_edge] {
            let [t0, t1] = x.map(|x| x.map(|p| p.map(|c| (c * 2f64.powi(exponent)) as f32)));
            let (face, edges) = (VertexFace { t0, t1 }, EdgeEdge { t0, t1 });
            let single = widen(ccd::vertex_face(&face, 0.0));
            check_consistent(single, ccd::vertex_face(&face.widen(), 0.0));
            let single = widen(ccd::edge_edge(&edges, 0.0));
            check_consistent(single, ccd::edge_edge(&edges.widen(), 0.0));
        }
    }
}

proptest! {
    #![proptest_config(config(200, 2))]

    #[test]
    fn queries_agree_with_exact_arithmetic(t0 in points(), t1 in points()) {
        check_oracle(vf(t0, t1), &contact(Patch::Triangle, &t0, &t1));
        check_oracle(ee(t0, t1), &contact(Patch::Parallelogram, &t0, &t1));
    }
}

#[test]
fn the_comparison_with_exact_arithmetic_can_fail() {
    let (t0, t1) = (
        [[0.25, 1.0, 0.25], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        [[0.25, -1.0, 0.25], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
    );
    let answer = contact(Patch::Triangle, &t0, &t1);
    assert!(matches!(answer, Contact::At(_, true)));
    let fails =
        |v: Verdict<f64>, a: &Contact| std::panic::catch_unwind(|| check_oracle(v, a)).is_err();
    assert!(!fails(vf(t0, t1), &answer));
    assert!(fails(Verdict::Miss, &answer));
    assert!(fails(Verdict::Hit { toi: 0.5 + 1e-9 }, &answer));
    assert!(fails(Verdict::Undecided { toi: 0.5 + 1e-9 }, &answer));
    assert!(fails(Verdict::Hit { toi: 0.49 }, &answer));
    assert!(fails(Verdict::Hit { toi: 0.5 }, &Contact::Free));
    let maybe_later = Contact::At([0.5; 2], false);
    assert!(!fails(Verdict::Hit { toi: 0.49 }, &maybe_later));
    assert!(fails(Verdict::Miss, &maybe_later));
    assert!(fails(Verdict::Hit { toi: 0.5 + 1e-9 }, &maybe_later));
}
