//! Sweeps and grids where their rules are at a border: boxes that begin at one place, that touch
//! where cells meet, of no size, all alike, huge, of all sizes.

use super::tests::Searches;
use super::*;
use ccd_core::model::catalogue::every;

/// Methods that sort boxes by place or by cell.
fn methods() -> impl Iterator<Item = BroadPhaseMethod> {
    let own = |method: &BroadPhaseMethod| {
        use BroadPhaseMethod::*;
        matches!(method, SweepAndPrune | SweepAndTiniestQueue | SweepInStrips | UniformGrid)
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

/// Sizes from a thousandth of the scene to all of it, in one set and between two, against blocks.
#[test]
fn a_grid_takes_unequal_sizes() {
    let mut grid = BroadPhase::new(2, BroadPhaseMethod::UniformGrid).expect("the grid");
    let mut blocks = BroadPhase::new(2, BroadPhaseMethod::Blocks).expect("blocks");
    let mut boxes = lattice(20_000, 400, 1, 1, |i| i as f32);
    for (k, b) in boxes.iter_mut().step_by(7).enumerate() {
        let side = [2.0, 5.0, 33.0][k % 3];
        let axes = [[1.0, 1.0, 1.0], [side, 1.0, 1.0], [1.0, side, side], [side, side, side]];
        b.max = std::array::from_fn(|i| b.min[i] + axes[k % 4][i]);
    }
    boxes[7] = Aabb { min: [0.0; 3], max: [400.0; 3] };
    let sorted = |pairs: Pairs| {
        let mut pairs = pairs.to_vec();
        pairs.sort_unstable();
        pairs
    };
    let want = sorted(blocks.self_pairs(&boxes).expect("pairs"));
    assert!(want.len() > 20_000, "{}", want.len());
    assert_eq!(sorted(grid.self_pairs(&boxes).expect("pairs")), want);
    // A set of large boxes among small ones, and the other way round.
    let (large, small) = (&boxes[..2000], &boxes[1000..]);
    for (a, b) in [(large, small), (small, large), (&boxes[7..8], small), (small, &boxes[7..8])] {
        let want = sorted(blocks.pairs(a, b).expect("pairs"));
        assert!(want.len() > 1000, "{}", want.len());
        assert_eq!(sorted(grid.pairs(a, b).expect("pairs")), want);
    }
}
