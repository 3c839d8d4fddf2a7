//! Sweeps and grids where their rules are at a border: boxes that begin at one place, that touch
//! where cells meet, of no size, all alike, huge; and boxes that a grid refuses.

use super::tests::Searches;
use super::*;
use ccd_core::model::catalogue::every;

/// Methods that sort boxes by place or by cell.
fn methods() -> impl Iterator<Item = BroadPhaseMethod> {
    let own = |method: &BroadPhaseMethod| {
        use BroadPhaseMethod::*;
        matches!(method, SweepAndPrune | SweepInStrips | UniformGrid)
    };
    every("cpu").filter(own)
}

/// Random integers below `n`.
fn random(mut x: u32) -> impl FnMut(u32) -> u32 {
    move |n| {
        x = x.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (x >> 8) % n
    }
}

/// Boxes with corners on a lattice of `n` places a side, up to `most` units long.
fn lattice(count: usize, n: u32, most: u32, seed: u32, at: impl Fn(u32) -> f32) -> Vec<Aabb<f32>> {
    let mut next = random(seed);
    let mut one = || {
        let sides: [_; 3] = std::array::from_fn(|_| (next(n), next(most + 1)));
        Aabb { min: sides.map(|(p, _)| at(p)), max: sides.map(|(p, side)| at(p + side)) }
    };
    (0..count).map(|_| one()).collect()
}

/// Pairs of all these methods are those of brute force; returns how many there are.
fn check(a: &[Aabb<f32>], b: &[Aabb<f32>]) -> usize {
    Searches::by(methods()).check(a, b).into_iter().sum()
}

#[test]
fn boxes_that_begin_at_one_place_or_touch_where_cells_meet() {
    let unit = |i: u32| i as f32;
    for (n, most) in [(2, 1), (4, 1), (6, 2), (9, 4), (24, 3)] {
        let (a, b) = (lattice(150, n, most, n, unit), lattice(90, n, most, 77, unit));
        let found = check(&a, &b);
        assert!(found > 50, "{found} pairs show nothing");
    }
    // All of one size, side by side and half a side apart: borders of cells and of boxes are one.
    for half in [1.0, 0.5] {
        let at = |i: u32| i as f32 * half;
        let cubes = |seed| {
            let boxes = lattice(200, 8, 0, seed, at);
            let cube = |b: &Aabb<f32>| Aabb { min: b.min, max: b.min.map(|c| c + 1.0) };
            boxes.iter().map(cube).collect::<Vec<_>>()
        };
        assert!(check(&cubes(1), &cubes(2)) > 1000);
    }
    // Enough boxes for several strips, most of them in more than one.
    for (seed, most) in [(1, 2), (2, 9)] {
        let (a, b) = (lattice(3000, 40, most, seed, unit), lattice(2500, 40, 3, 9, unit));
        assert!(check(&a, &b) > 1000);
    }
    // Zeros of both signs are one place.
    let zeros = [[-0.0, 0.0], [0.0, 0.0], [-0.0, -0.0], [-1.0, -0.0], [0.0, 1.0]];
    let boxes = zeros.map(|[min, max]| Aabb { min: [min; 3], max: [max; 3] });
    assert_eq!(check(&boxes, &boxes), 10 + 25);
}

#[test]
fn boxes_of_no_size_all_alike_one_and_none() {
    let points = lattice(200, 3, 0, 5, |i| i as f32 - 1.0);
    assert!(check(&points, &points[..50]) > 100);
    let alike = vec![Aabb { min: [0.25; 3], max: [0.5; 3] }; 70];
    assert_eq!(check(&alike, &alike), 70 * 69 / 2 + 70 * 70);
    let point = vec![Aabb::of_point([3.0, -2.0, 1e30]); 70];
    assert_eq!(check(&point, &alike), 70 * 69 / 2);
    assert_eq!(check(&alike[..1], &alike[..1]), 1);
    assert_eq!(check(&[], &[]), 0);
    assert_eq!(check(&[], &points), 0);
    assert!(check(&points, &[]) > 100);
}

#[test]
fn huge_and_tiny_coordinates() {
    for (unit, origin) in [(1e37, -2.9e38), (1e-38, 0.0), (1e-44, 0.0), (0.25, 4e6), (1e25, 1e30)] {
        let at = |i: u32| origin + i as f32 * unit;
        let (a, b) = (lattice(120, 20, 3, 4, at), lattice(60, 20, 3, 8, at));
        assert!(check(&a, &b) > 10, "{unit:e} at {origin:e}");
    }
    // One that holds all others, and one along each axis that is as long as the scene.
    let mut boxes = lattice(100, 40, 1, 6, |i| i as f32);
    boxes.push(Aabb { min: [-3e38; 3], max: [3e38; 3] });
    for k in 0..3 {
        let mut long = Aabb { min: [20.0; 3], max: [21.0; 3] };
        (long.min[k], long.max[k]) = (0.0, 41.0);
        boxes.push(long);
    }
    assert!(check(&boxes, &boxes[50..]) > 200);
}

#[test]
fn a_grid_refuses_unequal_sizes_and_says_why() {
    let mut boxes = lattice(20_000, 400, 1, 1, |i| i as f32);
    let mut broad = BroadPhase::new(2, BroadPhaseMethod::UniformGrid).expect("the grid");
    let n = broad.self_pairs(&boxes).expect("boxes of about one size").len();
    assert!(n > 10 && broad.pairs(&boxes, &boxes).is_ok());
    boxes[7] = Aabb { min: [0.0; 3], max: [300.0; 3] };
    let refused = broad.self_pairs(&boxes).map(|pairs| pairs.len());
    let Err(error @ Error::CrowdedCells { largest, mean, fullest, tests, limit }) = refused else {
        panic!("{refused:?} instead of a refusal")
    };
    assert!((300.0..=300.1).contains(&largest) && mean > 0.5 && mean < 1.0, "{error:?}");
    assert!(fullest > 2000 && fullest <= 20_000 && tests > limit, "{error:?}");
    assert!(error.to_string().contains("use `blocks`"), "{error}");
    // Also as one of two sets, and more boxes than are looked at for the estimate.
    assert!(matches!(broad.pairs(&boxes[..1], &boxes), Err(Error::CrowdedCells { .. })));
    let mut many = lattice(100_000, 2000, 1, 1, |i| i as f32);
    let n = broad.self_pairs(&many).expect("boxes of about one size").len();
    many[9].max = many[9].min.map(|c| c + 1500.0);
    assert!(matches!(broad.self_pairs(&many), Err(Error::CrowdedCells { .. })));
    // What it was before does not matter; every other method takes them.
    many[9].max = many[9].min;
    let again = broad.self_pairs(&many).expect("boxes of about one size").len();
    assert!(again.abs_diff(n) < 10, "{again}, {n}");
    let others = methods().filter(|&method| method != BroadPhaseMethod::UniformGrid);
    for method in others.chain([BroadPhaseMethod::Blocks, BroadPhaseMethod::TREE]) {
        let mut other = BroadPhase::new(2, method).expect("a method that is here");
        assert!(other.self_pairs(&boxes).is_ok(), "{method}");
    }
}
