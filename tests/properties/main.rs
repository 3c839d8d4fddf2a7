//! Properties that hold for every input, on random ones; and the exact oracle, brute force and dense sampling as judges.

use ccd::{Aabb, Bodies, BroadPhase, Contact, EdgeEdge, Kind, Mesh, Method, Options, Session, State, TOI_TOLERANCE, Verdict, VertexFace};
use ccd_testkit::brute;
use ccd_testkit::generate::{Random, crumpled_sheet, triangle_soup, uniform_boxes};
use ccd_testkit::oracle::{self, Answer};
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

/// Two verdicts of the same geometry: never one certain of a contact and the other of none; two certain times agree.
fn check_consistent(a: Verdict<f64>, b: Verdict<f64>) {
    match (a, b) {
        (Verdict::Hit { toi: x }, Verdict::Hit { toi: y }) => assert!((x - y).abs() <= TOI_TOLERANCE, "{a:?} {b:?}"),
        (Verdict::Hit { .. }, Verdict::Miss) | (Verdict::Miss, Verdict::Hit { .. }) => panic!("{a:?} contradicts {b:?}"),
        _ => {}
    }
}

fn check_oracle(verdict: Verdict<f64>, answer: &Answer) {
    match (verdict, answer) {
        (Verdict::Miss, Answer::Contact(..)) => panic!("missed: {answer:?}"),
        (Verdict::Hit { .. }, Answer::Free) => panic!("{verdict:?}, but there is no contact"),
        (Verdict::Hit { toi }, Answer::Contact(lo, hi)) => assert!(toi <= *hi && toi >= lo - TOI_TOLERANCE, "{verdict:?} {answer:?}"),
        (Verdict::Undecided { toi }, Answer::Contact(_, hi)) => assert!(toi <= *hi, "{verdict:?} {answer:?}"),
        _ => {}
    }
}

fn map(x: Points, f: impl Fn([f64; 3]) -> [f64; 3]) -> Points {
    x.map(f)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, rng_seed: proptest::test_runner::RngSeed::Fixed(1), ..ProptestConfig::default() })]

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
        for f in [|p: [f64; 3]| [-p[0], p[1], p[2]], |p: [f64; 3]| [p[0], -p[1], -p[2]], |p: [f64; 3]| [p[1], p[2], p[0]]] {
            check_consistent(vf(t0, t1), vf(map(t0, f), map(t1, f)));
            check_consistent(ee(t0, t1), ee(map(t0, f), map(t1, f)));
        }
    }

    #[test]
    fn scaling_by_a_power_of_two_changes_no_bit(t0 in points(), t1 in points(), exponent in -40i32..40) {
        let f = |p: [f64; 3]| p.map(|c| c * 2f64.powi(exponent));
        prop_assert_eq!(vf(t0, t1), vf(map(t0, f), map(t1, f)));
        prop_assert_eq!(ee(t0, t1), ee(map(t0, f), map(t1, f)));
    }

    #[test]
    fn filters_reject_misses_only(t0 in points(), t1 in points(), distance in 0.0..0.2f64) {
        use ccd_core::narrow_phase::coplanarity::{edge_edge_filter, vertex_face_filter};
        for d in [0.0, distance] {
            let (face, edges) = (VertexFace { t0, t1 }, EdgeEdge { t0, t1 });
            if vertex_face_filter(&t0, &t1, d) {
                prop_assert_eq!(ccd::vertex_face(&face, d), Verdict::Miss);
                check_oracle(Verdict::Miss, &oracle::vertex_face(&t0, &t1));
            }
            if edge_edge_filter(&t0, &t1, d) {
                prop_assert_eq!(ccd::edge_edge(&edges, d), Verdict::Miss);
                check_oracle(Verdict::Miss, &oracle::edge_edge(&t0, &t1));
            }
        }
    }

    #[test]
    fn reversing_time_keeps_the_answer(t0 in points(), t1 in points()) {
        let check = |a: Verdict<f64>, b: Verdict<f64>| assert!(!matches!((a, b), (Verdict::Hit { .. }, Verdict::Miss) | (Verdict::Miss, Verdict::Hit { .. })));
        check(vf(t0, t1), vf(t1, t0));
        check(ee(t0, t1), ee(t1, t0));
    }

    #[test]
    fn f32_and_f64_agree(t0 in points(), t1 in points()) {
        let narrow = |x: Points| x.map(|p| p.map(|c| c as f32));
        let q = VertexFace { t0: narrow(t0), t1: narrow(t1) };
        let single = match ccd::vertex_face(&q, 0.0) {
            Verdict::Miss => Verdict::Miss,
            Verdict::Hit { toi } => Verdict::Hit { toi: f64::from(toi) },
            Verdict::Undecided { toi } => Verdict::Undecided { toi: f64::from(toi) },
        };
        check_consistent(single, ccd::vertex_face(&q.widen(), 0.0));
    }

    #[test]
    fn a_minimum_distance_is_kept(t0 in points(), t1 in points(), distance in 0.001..0.5f64) {
        let times: Vec<f64> = (0..=64).map(|i| i as f64 / 64.0).collect();
        let at = |t: f64| -> Points { std::array::from_fn(|i| std::array::from_fn(|k| t0[i][k] + t * (t1[i][k] - t0[i][k]))) };
        let verdict = ccd::vertex_face(&VertexFace { t0, t1 }, distance);
        for &t in &times {
            // Dense samples of the face bound the distance from above.
            let [p, a, b, c] = at(t);
            let mut least = f64::INFINITY;
            for i in 0..=16 {
                for j in 0..=16 - i {
                    let (s, r) = (i as f64 / 16.0, j as f64 / 16.0);
                    let d2: f64 = (0..3).map(|k| (p[k] - a[k] - s * (b[k] - a[k]) - r * (c[k] - a[k])).powi(2)).sum();
                    least = least.min(d2.sqrt());
                }
            }
            if least < distance * (1.0 - 1e-12) {
                prop_assert!(verdict.toi().is_some_and(|toi| toi <= t), "distance {} at {}, but {:?}", least, t, verdict);
            }
        }
        // Contact itself is no later at a distance than at none.
        if let Verdict::Hit { toi } = vf(t0, t1) {
            prop_assert!(verdict.toi().is_some_and(|at_distance| at_distance <= toi + TOI_TOLERANCE));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, rng_seed: proptest::test_runner::RngSeed::Fixed(2), ..ProptestConfig::default() })]

    #[test]
    fn queries_agree_with_exact_arithmetic(t0 in points(), t1 in points()) {
        check_oracle(vf(t0, t1), &oracle::vertex_face(&t0, &t1));
        check_oracle(ee(t0, t1), &oracle::edge_edge(&t0, &t1));
    }
}

#[test]
fn the_comparison_with_exact_arithmetic_can_fail() {
    let (t0, t1) =
        ([[0.25, 1.0, 0.25], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], [[0.25, -1.0, 0.25], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    let answer = oracle::vertex_face(&t0, &t1);
    assert!(matches!(answer, Answer::Contact(..)));
    let fails = |v: Verdict<f64>, a: &Answer| std::panic::catch_unwind(|| check_oracle(v, a)).is_err();
    assert!(!fails(vf(t0, t1), &answer));
    assert!(fails(Verdict::Miss, &answer));
    assert!(fails(Verdict::Hit { toi: 0.5 + 1e-9 }, &answer));
    assert!(fails(Verdict::Undecided { toi: 0.5 + 1e-9 }, &answer));
    assert!(fails(Verdict::Hit { toi: 0.49 }, &answer));
    assert!(fails(Verdict::Hit { toi: 0.5 }, &Answer::Free));
}

/// Every pair of features of a mesh, asked one by one.
fn brute_contacts(mesh: &Mesh, x0: &[[f64; 3]], x1: &[[f64; 3]]) -> Vec<(Kind, u32, u32, bool)> {
    let [vf_pairs, ee_pairs] = brute::candidates(mesh, x0, x1);
    let take = |ids: [u32; 4], x: &[[f64; 3]]| ids.map(|i| x[i as usize]);
    let mut out = Vec::new();
    for p in vf_pairs {
        let [a, b, c] = mesh.faces()[p.b as usize];
        let v = vf(take([p.a, a, b, c], x0), take([p.a, a, b, c], x1));
        if v.toi().is_some() {
            out.push((Kind::VertexFace, p.a, p.b, matches!(v, Verdict::Hit { .. })));
        }
    }
    for p in ee_pairs {
        let ([a, b], [c, d]) = (mesh.edges()[p.a as usize], mesh.edges()[p.b as usize]);
        let v = ee(take([a, b, c, d], x0), take([a, b, c, d], x1));
        if v.toi().is_some() {
            out.push((Kind::EdgeEdge, p.a, p.b, matches!(v, Verdict::Hit { .. })));
        }
    }
    out
}

#[test]
fn steps_equal_brute_force() {
    for seed in 0..6 {
        for step in [crumpled_sheet(24, seed), triangle_soup(300, 0.15, seed)] {
            let report = ccd::step(&step.mesh, &step.x0, &step.x1, &Options { threads: 2, ..Options::default() }).unwrap();
            let certain = |c: &Contact| (c.kind, c.a, c.b, c.state == State::Hit);
            let got: Vec<_> = report.contacts.iter().map(certain).collect();
            let want = brute_contacts(&step.mesh, &step.x0, &step.x1);
            assert!(want.len() > 20, "seed {seed}: only {} contacts", want.len());
            // What the f32 filters reject may be undecided in f64: certain contacts must be equal, the others a subset.
            let hits = |all: &[(Kind, u32, u32, bool)]| all.iter().filter(|c| c.3).copied().collect::<Vec<_>>();
            assert_eq!(hits(&got), hits(&want), "seed {seed}");
            assert!(got.iter().all(|c| want.contains(c)), "seed {seed}");
            let earliest = ccd::earliest_toi(&step.mesh, &step.x0, &step.x1, &Options::default()).unwrap();
            assert_eq!(earliest, report.toi, "seed {seed}");
        }
    }
}

#[test]
fn f32_input_gives_what_its_exact_widening_gives() {
    let step = triangle_soup(400, 0.12, 9);
    let narrow = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>();
    let wide = |x: &[[f32; 3]]| x.iter().map(|p| p.map(f64::from)).collect::<Vec<_>>();
    let (x0, x1) = (narrow(&step.x0), narrow(&step.x1));
    let single = ccd::step(&step.mesh, &x0, &x1, &Options::default()).unwrap();
    let double = ccd::step(&step.mesh, &wide(&x0), &wide(&x1), &Options::default()).unwrap();
    assert_eq!((single.contacts, single.candidates), (double.contacts, double.candidates));
}

#[test]
fn far_from_the_origin_and_at_any_scale() {
    let step = triangle_soup(200, 0.15, 4);
    for scale in [1e-60, 1e-30, 1e-12, 1.0, 1e12, 1e30, 1e60] {
        let scaled = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c * scale)).collect::<Vec<_>>();
        let (x0, x1) = (scaled(&step.x0), scaled(&step.x1));
        let report = ccd::step(&step.mesh, &x0, &x1, &Options::default()).unwrap();
        let hits = report.contacts.iter().filter(|c| c.state == State::Hit).count();
        let want = brute_contacts(&step.mesh, &x0, &x1).iter().filter(|c| c.3).count();
        assert_eq!((hits, hits > 10), (want, true), "scale {scale}");
        if !(1e-30..=1e30).contains(&scale) {
            continue;
        }
        let narrow = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>();
        let single = ccd::step(&step.mesh, &narrow(&x0), &narrow(&x1), &Options::default()).unwrap();
        assert!(single.contacts.len() > 10, "scale {scale} in f32");
    }
    let far = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c + 1e6)).collect::<Vec<_>>();
    let (x0, x1) = (far(&step.x0), far(&step.x1));
    let report = ccd::step(&step.mesh, &x0, &x1, &Options::default()).unwrap();
    let want = brute_contacts(&step.mesh, &x0, &x1);
    let hits = report.contacts.iter().filter(|c| c.state == State::Hit).count();
    assert_eq!(hits, want.iter().filter(|c| c.3).count());
}

#[test]
fn broad_phase_equals_brute_force_on_uniform_and_equal_boxes() {
    let mut random = Random::new(3);
    let mut boxes = uniform_boxes(2000);
    boxes.iter_mut().for_each(|b| b.max = b.max.map(|c| c + 0.05));
    let equal = vec![Aabb { min: [0.5f32; 3], max: [0.5; 3] }; 300];
    let huge: Vec<Aabb<f32>> = (0..200)
        .map(|_| {
            let p = random.point().map(|c| (c as f32 - 0.5) * 1e38);
            Aabb { min: p, max: p.map(|c| c + 2e37) }
        })
        .collect();
    let endless = [Aabb { min: [f32::NEG_INFINITY; 3], max: [f32::INFINITY; 3] }; 3];
    for set in [&boxes[..], &equal[..], &huge[..], &boxes[..1], &endless[..], &[]] {
        for method in [Method::Blocks, Method::Tree] {
            let mut broad = BroadPhase::new(2, method).unwrap();
            let mut got = broad.self_pairs(set).unwrap().to_vec();
            got.sort_unstable();
            assert_eq!(got, brute::self_pairs(set), "{method:?}, {} boxes", set.len());
            let mut got = broad.pairs(set, &boxes[..500]).unwrap().to_vec();
            got.sort_unstable();
            assert_eq!(got, brute::pairs(set, &boxes[..500]), "{method:?}, {} boxes against 500", set.len());
        }
    }
}

#[test]
fn sessions_follow_motion_and_distance() {
    let step = crumpled_sheet(40, 5);
    let mut session = Session::new(step.mesh.clone(), Options { min_distance: 0.004, threads: 2, ..Options::default() }).unwrap();
    let mut x0 = step.x0.clone();
    let mut random = Random::new(8);
    let mut modes = [0, 0];
    for _ in 0..12 {
        let x1: Vec<_> = x0.iter().map(|p| p.map(|c| c + 0.01 * (random.unit() - 0.5))).collect();
        let kept = session.step(&x0, &x1).unwrap().clone();
        let fresh = ccd::step(&step.mesh, &x0, &x1, session.options()).unwrap();
        assert_eq!((&kept.contacts, kept.candidates), (&fresh.contacts, fresh.candidates));
        modes[kept.rebuilt as usize] += 1;
        x0 = x1;
    }
    assert!(modes[0] > 0 && modes[1] > 0, "refits and builds: {modes:?}");
}

#[test]
fn fixed_bodies_do_not_touch_each_other() {
    let step = triangle_soup(200, 0.2, 11);
    let body: Vec<u32> = (0..600).map(|v| v / 3).collect();
    let fixed: Vec<bool> = (0..200).map(|b| b % 2 == 0).collect();
    let options = Options { bodies: Some(Bodies::new(&body, &fixed, true)), ..Options::default() };
    let report = ccd::step(&step.mesh, &step.x0, &step.x1, &options).unwrap();
    let all = ccd::step(&step.mesh, &step.x0, &step.x1, &Options::default()).unwrap();
    let edge_body = |e: u32| body[step.mesh.edges()[e as usize][0] as usize];
    let bodies_of = |c: &Contact| match c.kind {
        Kind::VertexFace => (body[c.a as usize], c.b),
        Kind::EdgeEdge => (edge_body(c.a), edge_body(c.b)),
    };
    let both_fixed = |c: &&Contact| {
        let (a, b) = bodies_of(c);
        fixed[a as usize] && fixed[b as usize]
    };
    let want: Vec<_> = all.contacts.iter().filter(|c| !both_fixed(c)).copied().collect();
    assert_eq!(report.contacts, want);
    assert!(want.len() < all.contacts.len());
}
