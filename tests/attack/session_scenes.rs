//! Scenes of sessions, made of a number: small ones, whole, flat, thin, on a grid or far away.

use ccd::Mesh;
use ccd::scenes::{Step, crumpled_sheet, particles_and_rods, triangle_soup};
use ccd_testkit::grazing::random::Random;

pub const N_BODIES: u32 = 9;

pub struct Scene {
    pub step: Step,
    /// Coordinates were multiplied by this.
    pub unit: f64,
    /// Whether it is far from the origin for its size.
    pub is_far: bool,
}

pub fn scene(random: &mut Random) -> Scene {
    let seed = random.below(1 << 20) as u32;
    let n = [2, 6, 6, 12, 12, 24, 24, 36][random.below(8)];
    let size = [0.4, 0.15][random.below(2)];
    let mut step = match random.below(12) {
        0..3 => particles_and_rods(n, seed),
        3..6 => triangle_soup(2 * n, size, seed),
        6..8 => crumpled_sheet(n, seed),
        8..11 => sheets(n.min(12), seed),
        _ => two_particles(),
    };
    let unit = [1.0, 1.0, 1.0, 2f64.powi(-120), 2f64.powi(100), 2f64.powi(20), 1e-3 / 3.0];
    let unit = unit[random.below(unit.len())];
    // Small where all boxes overlap, or ties are many.
    let (scale, offset, grid) = match random.below(12) {
        0 | 1 => ([1.0; 3], [1e3 / 3.0, -77.7, 1e4 / 7.0], 0.0),
        2 if n <= 6 => ([1.0; 3], [1e7 / 3.0, 1e6, 1e7 / 7.0], 0.0),
        3 => ([1.0, 1.0 / 3.0, 1e-7], [0.0; 3], 0.0),
        4 if n <= 6 => ([1.0, 0.0, 1.0], [0.0, 0.3, 0.0], 0.0),
        5 if n <= 12 => ([1.0; 3], [0.0; 3], 8.0),
        _ => ([1.0; 3], [0.0; 3], 0.0),
    };
    for p in step.x0.iter_mut().chain(&mut step.x1) {
        for k in 0..3 {
            let x = if grid > 0.0 { (p[k] * grid).round() / grid } else { p[k] };
            p[k] = (x * scale[k] + offset[k]) * unit;
        }
    }
    Scene { step, unit, is_far: offset[0] > 0.0 }
}

/// Four sheets, side by side and one through the other: bodies of many vertices.
fn sheets(n: usize, seed: u32) -> Step {
    let (mut faces, mut x0, mut x1) = (Vec::new(), Vec::new(), Vec::new());
    for k in 0..4 {
        let sheet = crumpled_sheet(n, seed + k as u32);
        let first = x0.len() as u32;
        faces.extend(sheet.mesh.faces().iter().map(|face| face.map(|v| first + v)));
        let by = [0.9 * (k % 2) as f64, 0.1 * k as f64, 0.0];
        let placed = |p: &[f64; 3]| [p[0] + by[0], p[1] + by[1], p[2] + by[2]];
        x0.extend(sheet.x0.iter().map(placed));
        x1.extend(sheet.x1.iter().map(placed));
    }
    Step { mesh: Mesh::new(x0.len(), &faces).expect("four sheets"), x0, x1 }
}

/// A mesh without edges and faces.
fn two_particles() -> Step {
    let mesh = Mesh::new(2, &[]).expect("no ids");
    Step { mesh, x0: vec![[0.0; 3]; 2], x1: vec![[1.0; 3]; 2] }
}

/// The first vertex of the body of `v`.
fn find(root: &[u32], mut v: u32) -> u32 {
    while root[v as usize] != v {
        v = root[v as usize];
    }
    v
}

/// Body of each vertex; connected elements share one.
pub fn body_of(step: &Step) -> Vec<u32> {
    let mut root: Vec<u32> = (0..step.mesh.n_vertices() as u32).collect();
    for &[a, b] in step.mesh.edges() {
        let (a, b) = (find(&root, a), find(&root, b));
        root[a.max(b) as usize] = a.min(b);
    }
    (0..root.len() as u32).map(|v| find(&root, v) * 7 % N_BODIES).collect()
}
