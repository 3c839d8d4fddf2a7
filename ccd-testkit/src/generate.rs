//! Scenes made from a seed: the same numbers on every machine.

use ccd::{Aabb, Mesh};

/// Pseudo-random numbers: the 32-bit PCG output hash of a counter.
#[derive(Clone, Debug)]
pub struct Random(u32);

/// The 32-bit PCG output hash (RXS-M-XS, O'Neill 2014).
pub fn pcg(v: u32) -> u32 {
    let state = v.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
    let word = ((state >> ((state >> 28) + 4)) ^ state).wrapping_mul(277_803_737);
    (word >> 22) ^ word
}

impl Random {
    /// From a seed.
    pub fn new(seed: u32) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9))
    }

    /// 32 random bits.
    pub fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(1);
        pcg(self.0)
    }

    /// A number in `[0, 1)`, a multiple of 2^-24.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 8) as f64 / 16_777_216.0
    }

    /// A point in the unit cube.
    pub fn point(&mut self) -> [f64; 3] {
        [self.unit(), self.unit(), self.unit()]
    }

    /// An integer in `0 .. n`.
    pub fn below(&mut self, n: u32) -> u32 {
        self.bits() % n
    }
}

/// Uniform boxes of the same size in the unit cube, as in the comparisons with other libraries: half width 0.001 for 100,000 boxes and fewer, and
/// `0.002 (100,000 / n)^(1/3)` above.
pub fn uniform_boxes(n: usize) -> Vec<Aabb<f32>> {
    let half = if n <= 100_000 { 0.001 } else { 0.002 * (100_000.0 / n as f64).cbrt() as f32 };
    let unit = |i: u32| (pcg(i) >> 8) as f32 / 16_777_216.0;
    (0..n as u32)
        .map(|i| {
            let centre: [f32; 3] = std::array::from_fn(|k| unit(8 * i + k as u32));
            Aabb { min: centre.map(|c| c - half), max: centre.map(|c| c + half) }
        })
        .collect()
}

/// A mesh with its positions at both ends of a step.
#[derive(Clone, Debug)]
pub struct Step {
    /// Topology.
    pub mesh: Mesh,
    /// Positions at the start.
    pub x0: Vec<[f64; 3]>,
    /// Positions at the end.
    pub x1: Vec<[f64; 3]>,
}

/// A sheet of `n x n` vertices, side 1, crumpled by random displacements: many contacts within one mesh.
pub fn crumpled_sheet(n: usize, seed: u32) -> Step {
    let mut random = Random::new(seed);
    let size = 1.5 / n as f64;
    let mut jitter = |p: [f64; 3]| p.map(|c| c + (random.unit() - 0.5) * size);
    let rest = |i: usize| {
        let (u, v) = ((i % n) as f64 / n as f64, (i / n) as f64 / n as f64);
        [u, 0.1 * (9.0 * u).sin() * (7.0 * v).cos(), v]
    };
    let x0: Vec<_> = (0..n * n).map(|i| jitter(rest(i))).collect();
    let x1 = (0..n * n).map(|i| jitter(rest(i))).collect();
    let mut faces = Vec::new();
    for i in 0..n - 1 {
        for j in 0..n - 1 {
            let a = (i * n + j) as u32;
            let n = n as u32;
            faces.extend([[a, a + 1, a + n], [a + n, a + 1, a + n + 1]]);
        }
    }
    let mesh = Mesh::new(n * n, &faces).expect("a valid sheet");
    Step { mesh, x0, x1 }
}

/// Triangles with nothing in common, each moving on its own.
pub fn triangle_soup(n: usize, size: f64, seed: u32) -> Step {
    let mut random = Random::new(seed);
    let (mut x0, mut x1) = (Vec::new(), Vec::new());
    for _ in 0..n {
        let (from, to) = (random.point(), random.point());
        for _ in 0..3 {
            let corner = random.point();
            x0.push(std::array::from_fn(|k| from[k] + size * corner[k]));
            let corner = random.point();
            x1.push(std::array::from_fn(|k| from[k] + 2.0 * size * (to[k] - 0.5) + size * corner[k]));
        }
    }
    let faces: Vec<[u32; 3]> = (0..n as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Step { mesh: Mesh::new(3 * n, &faces).expect("a valid soup"), x0, x1 }
}
