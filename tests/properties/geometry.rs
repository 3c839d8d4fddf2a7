//! Point, normal and weights of a contact: nearest points by the conditions that only they meet,
//! the rules of the sign, what does not change when features are named otherwise, what is
//! degenerate.

use super::{Points, config, points};
use ccd::{ContactGeometry, EdgeEdge, Kind, TOI_TOLERANCE, Verdict, VertexFace};
use ccd_core::narrow_phase::contact_geometry::contact_geometry;
use proptest::prelude::*;

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn sum(weights: &[f64], x: &[[f64; 3]]) -> [f64; 3] {
    std::array::from_fn(|k| weights.iter().zip(x).map(|(w, p)| w * p[k]).sum())
}

fn of(kind: Kind, t0: &Points, t1: &Points, t: f64) -> ContactGeometry {
    contact_geometry(kind.patch(), t0, t1, t, 0.0)
}

/// Times at which coordinates of a coarse grid are exact, and others.
fn time() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(0.25), Just(0.5), Just(1.0), 0.0..1.0f64]
}

fn kind() -> impl Strategy<Value = Kind> {
    prop_oneof![Just(Kind::VertexFace), Just(Kind::EdgeEdge)]
}

/// `a` less `b`, each weighted: velocity where they meet.
fn velocity(kind: Kind, g: &ContactGeometry, t0: &Points, t1: &Points) -> [f64; 3] {
    let (n, v) = (kind.n_first(), std::array::from_fn::<_, 4, _>(|i| sub(t1[i], t0[i])));
    sub(sum(&g.weights[..n], &v[..n]), sum(&g.weights[n..], &v[n..]))
}

/// What holds at any time for any four points with coordinates up to 1.
fn check(kind: Kind, t0: &Points, t1: &Points, t: f64) {
    let g = of(kind, t0, t1, t);
    let text = || format!("{kind:?} {t0:?} {t1:?} {t:?}: {g:?}");
    let n = kind.n_first();
    let x: Points =
        std::array::from_fn(|i| std::array::from_fn(|k| (1.0 - t) * t0[i][k] + t * t1[i][k]));
    assert!((length(g.normal) - 1.0).abs() < 1e-14, "{}", text());
    for side in [&g.weights[..n], &g.weights[n..]] {
        assert!(side.iter().all(|w| (0.0..=1.0).contains(w)), "{}", text());
        assert!((side.iter().sum::<f64>() - 1.0).abs() < 1e-15, "{}", text());
    }
    // Weights reproduce the points; the point is between them.
    let (on_a, on_b) = (sum(&g.weights[..n], &x[..n]), sum(&g.weights[n..], &x[n..]));
    assert!(length(sub(on_a, g.on_a)) < 2e-15 && length(sub(on_b, g.on_b)) < 2e-15, "{}", text());
    let middle = std::array::from_fn(|k| 0.5 * (on_a[k] + on_b[k]));
    assert!(length(sub(middle, g.point)) < 2e-15, "{}", text());
    let apart = sub(on_a, on_b);
    assert!((length(apart) - g.distance).abs() < 2e-15, "{}", text());
    // Nearest: no corner of either feature is further towards the other. Both features are convex,
    // so only the nearest points have this.
    if g.distance > 0.0 {
        let least = |of: &[[f64; 3]], from: [f64; 3], sign: f64| {
            of.iter().map(|&p| sign * dot(apart, sub(p, from))).fold(f64::INFINITY, f64::min)
        };
        let (a, b) = (least(&x[..n], on_a, 1.0), least(&x[n..], on_b, -1.0));
        assert!(a.min(b) > -1e-14, "not the nearest points: {} {}", a.min(b), text());
    }
    // The sign, and the direction where there is a distance.
    let along = dot(apart, g.normal);
    if g.distance > 1e-10 {
        assert!(along > (1.0 - 1e-9) * g.distance, "{}", text());
    } else if g.distance > 5e-14 {
        assert!(along > 0.0, "{}", text());
    } else if g.distance < 1e-15 {
        let speed = dot(velocity(kind, &g, t0, t1), g.normal);
        assert!(speed < 1e-13, "{speed} {}", text());
    }
    // Inside of both features the normal is perpendicular to both.
    if g.weights[if n == 1 { 1 } else { 0 }..].iter().all(|&w| w > 1e-3 && w < 1.0 - 1e-3) {
        let sides = [sub(x[1], x[0]), sub(x[3], x[2])];
        let sides = if n == 1 { [sub(x[2], x[1]), sides[1]] } else { sides };
        for side in sides {
            let off = dot(g.normal, side).abs() / length(side);
            assert!(off < 1e-9 || length(side) < 1e-6, "{off} {}", text());
        }
    }
}

/// The same point and normal, or the opposite normal if `sign` is negative.
fn check_same(want: &ContactGeometry, got: &ContactGeometry, sign: f64, order: [usize; 4]) {
    let text = || format!("{want:?} {got:?}");
    assert!((want.distance - got.distance).abs() < 1e-14, "{}", text());
    // Which of several nearest points is given depends on rounding.
    if length(sub(want.point, got.point)) < 1e-9 {
        for (i, &from) in order.iter().enumerate() {
            let off = (got.weights[i] - want.weights[from]).abs();
            assert!(off < 1e-6, "{}", text());
        }
    }
    if want.distance > 1e-8 && length(sub(want.point, got.point)) < 1e-9 {
        let normal = got.normal.map(|c| sign * c);
        assert!(length(sub(want.normal, normal)) < 1e-5, "{}", text());
    }
}

/// Points in general position: no degenerate ones.
fn general() -> impl Strategy<Value = Points> {
    prop::array::uniform4(prop::array::uniform3(-1.0..1.0f64))
}

/// At the time of a certain contact features are as near as they may be, and approach unless they
/// were in contact from the start.
fn check_contact(kind: Kind, t0: &Points, t1: &Points, min_distance: f64) {
    let (t0, t1) = (*t0, *t1);
    let verdict = match kind {
        Kind::VertexFace => ccd::vertex_face(&VertexFace { t0, t1 }, min_distance),
        _ => ccd::edge_edge(&EdgeEdge { t0, t1 }, min_distance),
    };
    let Verdict::Hit { toi } = verdict else { return };
    let g = of(kind, &t0, &t1, toi);
    let text = || format!("{kind:?} {t0:?} {t1:?} {toi:?} {min_distance}: {g:?}");
    let fastest = (0..4).map(|i| length(sub(t1[i], t0[i]))).fold(0.0, f64::max);
    let moved = 2.0 * fastest * TOI_TOLERANCE + 1e-12;
    assert!(g.distance <= min_distance + moved, "{}", text());
    if toi > 0.0 {
        assert!(g.distance >= min_distance - 1e-9, "{}", text());
        let speed = dot(velocity(kind, &g, &t0, &t1), g.normal);
        // Nearest points are apart by some rounding, and so is what they move along it.
        assert!(min_distance == 0.0 || speed < 1e-3, "{speed} {}", text());
    }
}

proptest! {
    #![proptest_config(config(20_000, 5))]

    #[test]
    fn at_a_time_of_impact_features_are_near(
        kind in kind(), t0 in points(), t1 in points(), distance in 0.001..0.3f64
    ) {
        check_contact(kind, &t0, &t1, 0.0);
        check_contact(kind, &t0, &t1, distance);
    }

    #[test]
    fn nearest_points_weights_and_normal(
        kind in kind(), t0 in points(), t1 in points(), t in time()
    ) {
        check(kind, &t0, &t1, t);
        // At rest.
        check(kind, &t0, &t0, t);
    }

    #[test]
    fn names_of_vertices_do_not_matter(t0 in general(), t1 in general(), t in time()) {
        let turned = |x: &Points, order: [usize; 4]| order.map(|i| x[i]);
        let want = of(Kind::VertexFace, &t0, &t1, t);
        for order in [[0, 2, 3, 1], [0, 3, 1, 2], [0, 2, 1, 3], [0, 1, 3, 2], [0, 3, 2, 1]] {
            let got = of(Kind::VertexFace, &turned(&t0, order), &turned(&t1, order), t);
            check_same(&want, &got, 1.0, order);
        }
        let want = of(Kind::EdgeEdge, &t0, &t1, t);
        for (order, sign) in
            [([1, 0, 2, 3], 1.0), ([0, 1, 3, 2], 1.0), ([2, 3, 0, 1], -1.0), ([3, 2, 1, 0], -1.0)]
        {
            let got = of(Kind::EdgeEdge, &turned(&t0, order), &turned(&t1, order), t);
            check_same(&want, &got, sign, order);
        }
    }

    #[test]
    fn a_unit_of_length_does_not_matter(
        kind in kind(), t0 in points(), t1 in points(), t in time(), exponent in -900..330i32
    ) {
        let f = |x: &Points| x.map(|p| p.map(|c| c * 2f64.powi(exponent)));
        let (want, got) = (of(kind, &t0, &t1, t), of(kind, &f(&t0), &f(&t1), t));
        prop_assert_eq!((want.weights, want.normal), (got.weights, got.normal));
        prop_assert_eq!(want.point.map(|c| c * 2f64.powi(exponent)), got.point);
        prop_assert_eq!(want.distance * 2f64.powi(exponent), got.distance);
    }
}

/// Features that move by `by` (of `a` alone) in the step: point, normal and weights at time `t`.
fn check_case(
    kind: Kind,
    x: Points,
    by: [f64; 3],
    t: f64,
    (point, normal, weights): ([f64; 3], [f64; 3], [f64; 4]),
) {
    for exponent in [0, 330, -330, -1060] {
        let unit = 2f64.powi(exponent / 2).powi(2);
        let t0 = x.map(|p| p.map(|c| c * unit));
        let mut t1 = t0;
        for p in &mut t1[..kind.n_first()] {
            *p = std::array::from_fn(|k| p[k] + by[k] * unit);
        }
        let g = of(kind, &t0, &t1, t);
        let text = || format!("{kind:?} {x:?} {by:?} in units of 2^{exponent}: {g:?}");
        assert!(length(sub(g.normal, normal)) < 1e-12, "{}", text());
        assert!((0..4).all(|i| (g.weights[i] - weights[i]).abs() < 1e-12), "{}", text());
        // Coordinates below the smallest normal number are rounded.
        let off = sub(g.point, point.map(|c| c * unit)).map(|c| c.abs());
        assert!(off.iter().all(|&c| c <= 1e-12 * unit + 1e-323), "{}", text());
    }
}

#[test]
fn what_is_degenerate_has_the_answer_that_is_stated() {
    use Kind::{EdgeEdge as Ee, VertexFace as Vf};
    let face = |v: [f64; 3]| [v, [0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    let (up, down, still) = ([0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0; 3]);
    let inside = [1.0, 0.5, 0.25, 0.25];
    // On the face: against its velocity, and at rest as the vertices of the face go round.
    check_case(Vf, face([1.0, 1.0, 0.0]), still, 0.5, ([1.0, 1.0, 0.0], up, inside));
    check_case(Vf, face([1.0, 1.0, 1.0]), [0.0, 0.0, -2.0], 0.5, ([1.0, 1.0, 0.0], up, inside));
    check_case(Vf, face([1.0, 1.0, -1.0]), [0.0, 0.0, 2.0], 0.5, ([1.0, 1.0, 0.0], down, inside));
    // In the plane of the face, against its side and its corner from outside; and along it.
    let left = [-1.0, 0.0, 0.0];
    let side = [1.0, 0.5, 0.0, 0.5];
    check_case(Vf, face([-1.0, 2.0, 0.0]), [2.0, 0.0, 0.0], 0.5, ([0.0, 2.0, 0.0], left, side));
    let corner = [1.0, 1.0, 0.0, 0.0];
    check_case(Vf, face([-1.0, 0.0, 0.0]), [2.0, 0.0, 0.0], 0.5, ([0.0; 3], left, corner));
    check_case(Vf, face([0.5, 1.0, 0.0]), [1.0, 0.0, 0.0], 0.5, ([1.0, 1.0, 0.0], up, inside));
    // Beside the face, at a distance.
    let beside = [-1.5, 2.0, 0.0];
    check_case(Vf, face([-3.0, 2.0, 0.0]), still, 1.0, (beside, left, side));
    // A face without an area, that is hit and that is not.
    let line = |v| [v, [0.0; 3], [2.0, 0.0, 0.0], [4.0, 0.0, 0.0]];
    let half = [1.0, 0.5, 0.5, 0.0];
    check_case(Vf, line([1.0, 0.0, 1.0]), [0.0, 0.0, -2.0], 0.5, ([1.0, 0.0, 0.0], up, half));
    // A face that is a point.
    let point = |v| [v, [0.0; 3], [0.0; 3], [0.0; 3]];
    check_case(Vf, point([0.0, 0.0, 2.0]), still, 0.0, (up, up, corner));
    check_case(Vf, point([0.0; 3]), still, 0.0, ([0.0; 3], [1.0, 0.0, 0.0], corner));
    check_case(Vf, point([0.0, 0.0, 1.0]), [0.0, 0.0, -1.0], 1.0, ([0.0; 3], up, corner));

    // Edges that cross.
    let cross = |z: f64| [[-1.0, 0.0, z], [1.0, 0.0, z], [0.0, -1.0, 0.0], [0.0, 3.0, 0.0]];
    let weights = [0.5, 0.5, 0.75, 0.25];
    check_case(Ee, cross(1.0), [0.0, 0.0, -2.0], 0.5, ([0.0; 3], up, weights));
    check_case(Ee, cross(-1.0), [0.0, 0.0, 2.0], 0.5, ([0.0; 3], down, weights));
    check_case(Ee, cross(0.0), still, 0.5, ([0.0; 3], up, weights));
    check_case(Ee, cross(2.0), still, 0.5, ([0.0, 0.0, 1.0], up, weights));
    // Parallel ones: the middle of where they overlap.
    let along = |z: f64| [[0.0, 0.0, z], [4.0, 0.0, z], [6.0, 0.0, 0.0], [2.0, 0.0, 0.0]];
    let middle = [0.25, 0.75, 0.25, 0.75];
    check_case(Ee, along(1.0), [0.0, 0.0, -2.0], 0.5, ([3.0, 0.0, 0.0], up, middle));
    check_case(Ee, along(2.0), still, 0.0, ([3.0, 0.0, 1.0], up, middle));
    // End to end on one line.
    let line = [[0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0], [3.0, 0.0, 0.0]];
    let ends = [0.0, 1.0, 1.0, 0.0];
    check_case(Ee, line, [2.0, 0.0, 0.0], 0.5, ([2.0, 0.0, 0.0], left, ends));
}

/// Whatever is given: a unit normal, weights in the patch.
#[test]
fn no_input_makes_no_normal() {
    let values = [0.0, 1.0, -1.0, 5e-324, 1e-300, 1e100, -1e308, f64::INFINITY, f64::NAN];
    let mut random = ccd_testkit::generate::Random::new(3);
    for i in 0..20_000 {
        let mut pick = || values[random.below(9) as usize];
        let mut four = || std::array::from_fn(|_| std::array::from_fn(|_| pick()));
        let (t0, t1): (Points, Points) = (four(), four());
        let kind = if i % 2 == 0 { Kind::VertexFace } else { Kind::EdgeEdge };
        let g = of(kind, &t0, &t1, pick());
        assert!((length(g.normal) - 1.0).abs() < 1e-12, "{t0:?} {t1:?} {g:?}");
        for side in [&g.weights[..kind.n_first()], &g.weights[kind.n_first()..]] {
            assert!(side.iter().all(|w| (0.0..=1.0).contains(w)), "{t0:?} {t1:?} {g:?}");
            assert!((side.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{t0:?} {t1:?} {g:?}");
        }
    }
}
