//! Derivatives against finite differences, values against certified bounds, types against each
//! other.

use super::*;
use crate::narrow_phase::distance::Distance;
use crate::random::Random;

type Evaluate<'a> = &'a dyn Fn(&Points) -> SquaredDistance;

/// Central differences of the value and of the gradient, with a step of 1e-5 of the size: they err
/// by the third derivatives times 1e-10, and by rounding over 1e-5.
fn check_derivatives(x: &Points, size: f64, at: Evaluate) {
    let d = at(x);
    let (gradient, hessian) = (d.gradient(), d.hessian());
    for i in 0..12 {
        let h = 1e-5 * size;
        let moved = |by: f64| {
            let mut x = *x;
            x[i / 3][i % 3] += by;
            at(&x)
        };
        let (up, down) = (moved(h), moved(-h));
        let slope = (up.value() - down.value()) / (2.0 * h);
        assert!((slope - gradient[i]).abs() <= 1e-6 * size, "{i}: {slope} {gradient:?} {x:?}");
        for j in 0..12 {
            let slope = (up.gradient()[j] - down.gradient()[j]) / (2.0 * h);
            let found = hessian[i][j];
            let near = (slope - found).abs() <= 1e-6 * (1.0 + found.abs());
            assert!(near, "{i} {j}: {slope} {found}");
            assert_eq!(found, hessian[j][i]);
        }
    }
}

/// Four points in a cube of that size, with no short edge and no small angle.
fn apart(random: &mut Random, size: f64) -> Points {
    loop {
        let x = [(); 4].map(|()| random.point().map(|c| c * size));
        let edge = |i: usize, j: usize| sub(x[j], x[i]);
        let wide = |a: [f64; 3], b: [f64; 3]| {
            let n = cross(a, b);
            dot(n, n) > 0.04 * size.powi(4)
        };
        if wide(edge(1, 2), edge(1, 3)) && wide(edge(0, 1), edge(2, 3)) {
            return x;
        }
    }
}

#[test]
fn derivatives_are_those_of_differences() {
    let mut random = Random::new(5);
    for round in 0..60 {
        let size = [1.0, 1e-3, 1e6][round % 3];
        let x = apart(&mut random, size);
        for kind in VertexFaceType::ALL {
            check_derivatives(&x, size, &|x| kind.at(x));
        }
        for kind in EdgeEdgeType::ALL {
            check_derivatives(&x, size, &|x| kind.at(x));
        }
    }
}

/// All types occur; the value is between certified bounds; the nearest type is that of the least
/// value among those whose nearest points are within the features.
#[test]
fn types_are_those_of_the_nearest_points() {
    let mut random = Random::new(6);
    let mut seen = [[0; 9]; 2];
    for round in 0..4000 {
        let size = [1.0, 1e-60, 1e90, 1e-3][round % 4];
        let x = [(); 4].map(|()| random.point().map(|c| (c - 0.5) * size));
        let (face, edges) = (VertexFaceType::of(&x), EdgeEdgeType::of(&x));
        seen[0][face as usize] += 1;
        seen[1][edges as usize] += 1;
        for (d, bounds) in
            [(face.at(&x), Distance::vertex_face(x)), (edges.at(&x), Distance::edge_edge(x))]
        {
            // The root, by the greatest of the differences, of a square that may overflow.
            let distance = dot(d.r, d.r).sqrt() / d.unit;
            let slack = 1e-9 * bounds.greatest;
            assert!(distance >= bounds.least - slack && distance <= bounds.greatest + slack);
            assert!(d.weights.iter().all(|w| w.abs() <= 1.0 + 1e-9), "{d:?}");
        }
    }
    assert!(seen[0][..7].iter().chain(&seen[1]).all(|&n| n > 20), "{seen:?}");
}

/// Where edges are parallel or features have no extent, a type without a division by zero is
/// chosen, and the distance is right.
#[test]
fn flat_features_have_types_of_their_ends() {
    let mut random = Random::new(7);
    for round in 0..2000 {
        let [p, q, a, _] = [(); 4].map(|()| random.point());
        let on = |t: f64| add(a, scale(sub(q, p), t));
        let (s, t) = (random.unit() * 4.0 - 2.0, random.unit() * 4.0 - 2.0);
        let x = match round % 5 {
            0 => [p, q, on(s), on(t)],
            1 => [p, q, a, a],
            2 => [p, p, a, q],
            3 => [p, a, a, a],
            _ => [s, t, s + 0.3, t * s].map(on),
        };
        let edges = EdgeEdgeType::of(&x);
        assert_ne!(edges, EdgeEdgeType::AB);
        let line = [p, on(0.0), on(s), on(t)];
        for (d, bounds) in [
            (edges.at(&x), Distance::edge_edge(x)),
            (VertexFaceType::of(&x).at(&x), Distance::vertex_face(x)),
            (VertexFaceType::of(&line).at(&line), Distance::vertex_face(line)),
        ] {
            let distance = d.value().sqrt();
            assert!(distance >= bounds.least - 1e-9 && distance <= bounds.greatest + 1e-9, "{x:?}");
            assert!(d.gradient().iter().chain(d.hessian().as_flattened()).all(|x| x.is_finite()));
        }
    }
}

/// Edges that cross at a distance of 1, at an angle that rounding makes uncertain.
#[test]
fn nearly_parallel_edges_have_their_distance() {
    let mut random = Random::new(8);
    for _ in 0..20_000 {
        let [e, f] = [(); 2].map(|()| random.point().map(|c| c - 0.5));
        let unit = |v: [f64; 3]| scale(v, 1.0 / dot(v, v).sqrt());
        let (e, up) = (unit(e), unit(cross(e, f)));
        let turned = scale(cross(e, up), 10f64.powf(-9.0 - 9.0 * random.unit()));
        let (by, middle) = (add(e, turned), random.point());
        let above = add(middle, up);
        let x = [sub(middle, e), add(middle, e), sub(above, by), add(above, by)];
        let d = EdgeEdgeType::of(&x).at(&x);
        assert!((d.value() - 1.0).abs() < 1e-9, "{} {x:?}", d.value());
    }
}
