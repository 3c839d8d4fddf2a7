//! Scenes made from a few numbers, the same bits on every machine: nothing but operations that
//! IEEE 754 rounds in one way, so no sine, no cosine and no cube root of a system's library.
//! Feature `scenes`.
//!
//! ```
//! let step = ccd::scenes::crumpled_sheet(20, 1);
//! let report = ccd::step(&step.mesh, &step.x0, &step.x1, &ccd::Options::default())?;
//! assert!(report.contacts.len() > 20);
//! # Ok::<(), ccd::Error>(())
//! ```

mod random;
mod sequences;

use crate::{Aabb, Bodies, Mesh};
use random::origin;
pub use random::{Random, pcg};
pub use sequences::{Sequence, cloth_on_ball, funnel, interpenetrating, n_body};

/// The hash of `i` as a multiple of 2^-24 in `[0, 1)`, which is an `f32`.
fn unit(i: u32) -> f32 {
    (pcg(i) >> 8) as f32 / 16_777_216.0
}

/// Uniform boxes of the same size in the unit cube, as in the comparisons with other libraries:
/// half width 0.001 for 100,000 boxes and fewer, and `0.002 (100,000 / n)^(1/3)` above.
pub fn uniform_boxes(n: usize) -> Vec<Aabb<f32>> {
    let half = if n <= 100_000 { 0.001 } else { 0.002 * cube_root(100_000.0 / n as f64) as f32 };
    let make = |i: u32| {
        let centre: [f32; 3] = std::array::from_fn(|k| unit(8 * i + k as u32));
        Aabb { min: centre.map(|c| c - half), max: centre.map(|c| c + half) }
    };
    (0..n as u32).map(make).collect()
}

/// Debris that falls from the walls of a corridor, after the scene of [Karras 2012b], which is not
/// published: as many boxes, 12,486, of which about as many pairs overlap, 73,701 (there 73,704).
///
/// Pieces are of any size from an eighth to the whole of the largest, the smaller the more; of any
/// shape up to three to one; denser near the walls and towards the floor.
pub fn debris_boxes() -> Vec<Aabb<f32>> {
    /// Found by bisection, for the number of pairs. The corridor is 1 wide, 1 high and 8 long.
    const LARGEST: f32 = 0.3372;
    let make = |i: u32| {
        let number = |k: u32| unit(origin(7).wrapping_add(16 * i + k));
        // Inward from either wall, up from the floor, along the corridor.
        let inward = 0.5 * number(0) * number(1);
        let x = if number(2) < 0.5 { inward } else { 1.0 - inward };
        let centre = [x, number(3) * number(4), 8.0 * number(5)];
        let size = LARGEST / (1.0 + 7.0 * number(6));
        let half: [f32; 3] =
            std::array::from_fn(|k| size * (1.0 + 2.0 * number(7 + k as u32)) / 6.0);
        Aabb {
            min: std::array::from_fn(|k| centre[k] - half[k]),
            max: std::array::from_fn(|k| centre[k] + half[k]),
        }
    };
    (0..12_486).map(make).collect()
}

/// A teapot in a stadium, of which [Karras 2012a] says that no size of cells fits both: 10,240
/// boxes of seats on 40 tiers around a field, 200 wide, and 16,384 boxes of patches of a teapot in
/// its middle, a ball 0.3 wide. Each seat touches its neighbours, each patch those around it.
pub fn teapot_in_a_stadium_boxes() -> Vec<Aabb<f32>> {
    let (tiers, seats, patches) = (40, 256, 128);
    let around = |centre: [f64; 3], half: [f64; 3]| Aabb {
        min: std::array::from_fn(|k| (centre[k] - half[k]) as f32),
        max: std::array::from_fn(|k| (centre[k] + half[k]) as f32),
    };
    let seat = |i: usize| {
        let (tier, [x, z]) = ((i / seats) as f64, circle((i % seats) as f64 / seats as f64));
        let radius = 60.0 + tier;
        around([radius * x, 0.5 * tier, radius * z], [1.1, 0.2, 1.1])
    };
    let patch = |x: [f64; 3]| around(x.map(|x| 0.15 * x), [0.003; 3]);
    let stadium = (0..tiers * seats).map(seat);
    stadium.chain(sphere(patches).into_iter().map(patch)).collect()
}

/// The cube root of a number in `(0, 1]`, to a unit or two in the last place, by Newton-Raphson
/// from 1: always from above, a third of the way down a round at first, then quadratically.
fn cube_root(x: f64) -> f64 {
    (0..64).fold(1.0, |y, _| y - (y * y * y - x) / (3.0 * y * y))
}

/// A mesh with its positions at both ends of a step.
///
/// ```
/// let step = ccd::scenes::crumpled_sheet(10, 1);
/// let report = ccd::step(&step.mesh, &step.x0, &step.x1, &ccd::Options::default())?;
/// assert!(!report.contacts.is_empty());
/// # Ok::<(), ccd::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Topology.
    pub mesh: Mesh,
    /// Positions at the start.
    pub x0: Vec<[f64; 3]>,
    /// Positions at the end.
    pub x1: Vec<[f64; 3]>,
}

/// Particles among rods and triangles, `n` of each, in the unit cube: every particle flies through
/// a point of a rod of its own at `t = 0.25`, with numbers that are exact in `f32`, or, one in
/// four, through another particle; every second of what it meets moves too.
///
/// # Panics
/// If that are more vertices than a mesh may have.
pub fn particles_and_rods(n: usize, seed: u32) -> Step {
    let mut random = Random::new(seed);
    // Multiples of 2^-10, so that sums and quarters of them are exact.
    let mut point = |size: f64| random.point().map(|x| (x * 1024.0).trunc() / 1024.0 * size);
    let (mut x0, mut x1) = (Vec::new(), Vec::new());
    let mut add = |p: [f64; 3], travel: [f64; 3]| {
        x0.push(p);
        x1.push([p[0] + travel[0], p[1] + travel[1], p[2] + travel[2]]);
        (x0.len() - 1) as u32
    };
    let (mut faces, mut rods) = (Vec::new(), Vec::new());
    for i in 0..n {
        let (corner, travel) = (point(1.0), point(0.25));
        let travel = if i % 2 == 0 { travel } else { [0.0; 3] };
        // Around the point that is met, so that this is exact.
        let side = point(0.25);
        let at = |p: [f64; 3], s: f64, q: [f64; 3]| [0, 1, 2].map(|k| p[k] + s * q[k]);
        if i % 4 == 3 {
            add(corner, travel);
        } else {
            rods.push([add(at(corner, -1.0, side), travel), add(at(corner, 1.0, side), travel)]);
        }
        let flight = point(1.0);
        let met = at(corner, 0.25, travel);
        add(at(met, -0.25, flight), flight);
        let (p, still) = (point(1.0), [0.0; 3]);
        faces.push([(); 3].map(|()| add(at(p, 0.125, point(1.0)), still)));
    }
    let mesh = Mesh::with_edges(x0.len(), &faces, &rods).expect("ids of these vertices");
    Step { mesh, x0, x1 }
}

impl Step {
    /// Both ends rounded to the nearest `f32`.
    pub fn rounded(&self) -> [Vec<[f32; 3]>; 2] {
        [&self.x0, &self.x1].map(|x| x.iter().map(|p| p.map(|c| c as f32)).collect())
    }
}

/// A wavy sheet of `n x n` vertices, side 1, each moved at random by up to three quarters of a
/// cell, and by as much again in the step: many contacts within one mesh.
///
/// # Panics
/// If `n` is less than 2 or greater than 30,000.
pub fn crumpled_sheet(n: usize, seed: u32) -> Step {
    let wave = |x: f64| {
        let part = x - x.floor();
        part * (1.0 - part)
    };
    let size = 1.5 / n as f64;
    let at = |i: usize, end: u32| -> [f64; 3] {
        let (u, v) = ((i % n) as f64 / n as f64, (i / n) as f64 / n as f64);
        let rest = [u, 1.6 * wave(1.5 * u) * wave(1.2 * v), v];
        let first = origin(seed).wrapping_add(8 * i as u32 + 4 * end);
        let jitter = |k: usize| unit(first.wrapping_add(k as u32)) as f64 - 0.5;
        std::array::from_fn(|k| rest[k] + jitter(k) * size)
    };
    let mut faces = Vec::new();
    grid(&mut faces, n, 0);
    let mesh = Mesh::new(n * n, &faces).expect("a valid sheet");
    let [x0, x1] = [0, 1].map(|end| (0..n * n).map(|i| at(i, end)).collect());
    Step { mesh, x0, x1 }
}

/// Triangles with nothing in common in the unit cube, each moving on its own, with corners up to
/// `size` from one of them.
///
/// # Panics
/// If that are more vertices than a mesh may have.
pub fn triangle_soup(n: usize, size: f64, seed: u32) -> Step {
    let mut random = Random::new(seed);
    let (mut x0, mut x1) = (Vec::new(), Vec::new());
    for _ in 0..n {
        let (from, to) = (random.point(), random.point());
        for _ in 0..3 {
            let corner = random.point();
            x0.push(std::array::from_fn(|k| from[k] + size * corner[k]));
            let corner = random.point();
            let at = |k: usize| from[k] + 2.0 * size * (to[k] - 0.5) + size * corner[k];
            x1.push(std::array::from_fn(at));
        }
    }
    let faces: Vec<[u32; 3]> = (0..n as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    Step { mesh: Mesh::new(3 * n, &faces).expect("a valid soup"), x0, x1 }
}

/// So many copies of a step in one place, each a body in a world of its own: what the features of
/// copy `i` are, have ids that follow those of the copies before.
///
/// # Panics
/// If that are more vertices than a mesh may have.
pub fn copies(step: &Step, n: usize) -> (Step, Bodies) {
    let n_vertices = step.mesh.n_vertices();
    let copy = |i: usize| move |f: &[u32; 3]| f.map(|v| v + (i * n_vertices) as u32);
    let faces: Vec<_> = (0..n).flat_map(|i| step.mesh.faces().iter().map(copy(i))).collect();
    let mesh = Mesh::new(n * n_vertices, &faces).expect("a valid mesh");
    let body: Vec<u32> = (0..n * n_vertices).map(|v| (v / n_vertices) as u32).collect();
    let worlds: Vec<u32> = (0..n as u32).collect();
    let bodies = Bodies::new(&body).with_worlds(&worlds);
    (Step { mesh, x0: step.x0.repeat(n), x1: step.x1.repeat(n) }, bodies)
}

/// Two triangles per cell of an `n x n` grid whose vertices begin at `first`.
pub fn grid(faces: &mut Vec<[u32; 3]>, n: usize, first: u32) {
    let n = n as u32;
    for i in 0..(n - 1) * (n - 1) {
        let a = first + i / (n - 1) * n + i % (n - 1);
        faces.extend([[a, a + n, a + 1], [a + 1, a + n, a + n + 1]]);
    }
}

/// Vertices of the unit sphere for a [`grid`] of `n x n`: rows from the pole `y = 1` to the other,
/// the ends of a row in one place.
pub fn sphere(n: usize) -> Vec<[f64; 3]> {
    let at = |i: usize| i as f64 / (n - 1) as f64;
    let point = |i: usize| {
        let ([x, z], [y, r]) = (circle(at(i % n)), circle(0.5 * at(i / n)));
        [r * x, y, r * z]
    };
    (0..n * n).map(point).collect()
}

/// A point on the unit circle after so much of a turn: exact quarters, in between by the rational
/// parametrisation `(1 - t^2, 2 t) / (1 + t^2)`, whose steps shrink to half along each quarter.
fn circle(turn: f64) -> [f64; 2] {
    let quarter = (4.0 * turn).floor();
    let t = 4.0 * turn - quarter;
    let [x, y] = [(1.0 - t * t) / (1.0 + t * t), 2.0 * t / (1.0 + t * t)];
    match quarter as i64 & 3 {
        0 => [x, y],
        1 => [-y, x],
        2 => [-x, -y],
        _ => [y, -x],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A hash of bits, so that a scene that differs anywhere is seen.
    fn hash(words: impl Iterator<Item = u64>) -> u32 {
        words.fold(0, |h, w| pcg(pcg(h ^ w as u32) ^ (w >> 32) as u32))
    }

    fn check_points(x: &[[f64; 3]], want: u32) {
        let found = hash(x.iter().flatten().map(|c| c.to_bits()));
        assert!(found == want, "{found:#x}, elsewhere {want:#x}");
    }

    fn check_boxes(boxes: &[Aabb<f32>], want: u32) {
        let words = boxes.iter().flat_map(|b| b.min.into_iter().chain(b.max));
        let found = hash(words.map(|c| c.to_bits() as u64));
        assert!(found == want, "{} boxes: {found:#x}, elsewhere {want:#x}", boxes.len());
    }

    #[test]
    fn scenes_have_the_same_bits_everywhere() {
        let sheet = crumpled_sheet(40, 3);
        check_points(&sheet.x0, 0x1c26_0cb4);
        check_points(&sheet.x1, 0x7d0f_0fe4);
        check_points(&triangle_soup(100, 0.1, 3).x1, 0x49e7_c5e0);
        check_points(&sphere(32), 0x1847_f18a);
        for (n, want) in [(1000, 0x6f15_8b17), (150_000, 0x1617_7c44)] {
            let boxes = uniform_boxes(n);
            check_boxes(&boxes, want);
        }
        check_boxes(&debris_boxes(), 0x6cab_3532);
        check_boxes(&teapot_in_a_stadium_boxes(), 0x2c5e_15d2);
        // The control: the last bit of one coordinate.
        let mut other = sheet.x0.clone();
        other[700][2] = other[700][2].next_up();
        let bits = |x: &[[f64; 3]]| hash(x.iter().flatten().map(|c| c.to_bits()));
        assert_ne!(bits(&other), bits(&sheet.x0));
    }

    #[test]
    fn spheres_are_round_and_closed() {
        let n = 33;
        let x = sphere(n);
        for p in &x {
            let length = p.iter().map(|c| c * c).sum::<f64>();
            assert!((length - 1.0).abs() < 1e-14, "{p:?}");
        }
        for row in x.chunks(n) {
            assert_eq!(row[0], row[n - 1]);
            assert!(row.windows(2).all(|w| (0..3).all(|k| (w[0][k] - w[1][k]).abs() < 0.26)));
        }
        assert!((x[0][1], x[n * n - 1][1]) == (1.0, -1.0));
    }

    #[test]
    fn cube_roots_cube_to_their_number() {
        for x in [1.0, 0.1, 0.01, 0.001, 0.3, 1e-5] {
            let y = cube_root(x);
            assert!((y * y * y - x).abs() <= 8.0 * f64::EPSILON * x, "{x}: {y}");
        }
    }
}
