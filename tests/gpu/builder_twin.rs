//! What tests of builders share: figures of a tree, and boxes that are hard for some builder.

use crate::twin::{Twin, union};
use ccd::Aabb;
use ccd_core::backend::layout::Branch;
use ccd_core::math::morton::MortonGrid;
use ccd_testkit::generate::uniform_boxes;

/// Numbers of boxes by leaf, and the branches over them.
pub type Built = (Vec<u32>, Vec<Branch>);

/// The boxes of a set in cells of the grid of all.
pub fn in_cells(twin: &Twin, set: usize) -> Vec<Aabb> {
    let grid = MortonGrid::new(&union(twin.boxes.iter()), 10);
    let range = twin.frame.start[set] as usize..twin.frame.start[set + 1] as usize;
    twin.boxes[range].iter().map(|b| grid.in_cells(b)).collect()
}

/// Levels of a tree, and its cost by surfaces, as the CPU's statistics have them.
pub fn figures(twin: &Twin, (order, branches): &Built) -> (usize, f64) {
    let n_internal = branches.len() as u32;
    let surface = |b: Aabb| {
        let [x, y, z] = [0, 1, 2].map(|k| b.max[k] - b.min[k]);
        (x * y + y * z + z * x) as f64
    };
    let of_range = |first: u32, last: u32| {
        let leaves = &order[first as usize..=last as usize];
        surface(union(leaves.iter().map(|&i| &twin.boxes[i as usize])))
    };
    let (mut deepest, mut cost, mut stack) = (0, 0.0, vec![(0u32, 1usize)]);
    while let Some((node, depth)) = stack.pop() {
        deepest = deepest.max(depth);
        if let Some(b) = branches.get(node as usize) {
            cost += of_range(b.first, b.last);
            stack.extend([(b.left, depth + 1), (b.right, depth + 1)]);
        } else {
            cost += of_range(node - n_internal, node - n_internal);
        }
    }
    (deepest, cost / of_range(0, n_internal))
}

/// Sets of boxes that are hard for some builder, of different sizes.
pub fn hard_boxes() -> Vec<(&'static str, Vec<Aabb>)> {
    let uniform = uniform_boxes(1500);
    let nested = |n: i32, by: f32| {
        let sizes = (0..n).map(|i| 1e-3 * by.powi(i));
        sizes.map(|r| Aabb { min: [-r; 3], max: [r; 3] }).collect::<Vec<_>>()
    };
    let mut mixed = uniform[..300].to_vec();
    mixed.extend(vec![uniform[7]; 301]);
    vec![
        ("uniform", uniform.iter().map(|b| b.inflated(0.01)).collect()),
        ("equal", vec![uniform[3]; 777]),
        ("inside of each other", nested(601, 1.01)),
        ("around each other", nested(601, 0.99)),
        ("many equal", mixed),
        ("on a line", (0..515).map(|i| Aabb::of_point([i as f32, 0.0, 0.0])).collect()),
        ("three", uniform[..3].to_vec()),
        ("two", uniform[..2].to_vec()),
        ("as many as a workgroup", uniform[..256].to_vec()),
        ("one more", uniform[..257].to_vec()),
    ]
}

/// Hard boxes as the only set, and as the last of two.
pub fn twins() -> impl Iterator<Item = (String, Twin, usize)> {
    let loose = uniform_boxes(70);
    hard_boxes().into_iter().flat_map(move |(name, boxes)| {
        let alone = Twin::new([&[], &boxes, &[]], |_, i| [i; 3]);
        let last = Twin::new([&loose, &[], &boxes], |_, i| [i; 3]);
        [(name.to_owned(), alone, 1), (format!("{name}, after others"), last, 2)]
    })
}
