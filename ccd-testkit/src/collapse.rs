//! A step with thousands of times the pairs of the one before.

use ccd::Mesh;

/// Triangles in a row, of which the first two overlap, and where all of them end up at one place.
pub fn collapse(n: usize) -> (Mesh, [Vec<[f32; 3]>; 3]) {
    let faces: Vec<[u32; 3]> = (0..n as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.125, 0.0], [0.125, 1.0, 0.25]];
    let at = |spacing: f32, lift: f32| -> Vec<[f32; 3]> {
        let place = |v: usize| {
            let ([x, y, z], i) = (corners[v % 3], v / 3);
            let row = if i < 2 { 0.25 * i as f32 } else { spacing * i as f32 };
            [x + row, y + lift, z - row / 64.0]
        };
        (0..3 * n).map(place).collect()
    };
    (Mesh::new(3 * n, &faces).unwrap(), [at(3.0, 0.0), at(3.0, 0.125), at(0.001, 0.25)])
}
