//! Scenes of many frames, after those by which hierarchy traversals are compared: two meshes that
//! pass through each other, a cloth drawn through a funnel, a cloth that falls on a ball, spheres
//! that bounce in a box.
//!
//! ```
//! let scene = ccd::scenes::interpenetrating(64);
//! assert_eq!(scene.mesh.faces().len(), 64);
//! assert_ne!(scene.frame(3), scene.frame(4));
//! ```

use super::{Random, circle, grid, sphere};
use crate::Mesh;

/// A mesh and where its vertices are at each frame; any number of frames.
///
/// ```
/// let scene = ccd::scenes::n_body(8, 12);
/// let mut session = ccd::Session::new(&scene.mesh, ccd::Options::default())?;
/// let (before, after) = (scene.frame(0), scene.frame(1));
/// assert_eq!(session.step(&before, &after)?.mesh().n_vertices(), scene.body.len());
/// # Ok::<(), ccd::Error>(())
/// ```
pub struct Sequence {
    /// Topology.
    pub mesh: Mesh,
    /// The body of each vertex.
    pub body: Vec<u32>,
    at: Box<dyn Fn(f64) -> Vec<[f64; 3]> + Send + Sync>,
}

impl Sequence {
    /// Positions at a frame.
    pub fn frame(&self, i: usize) -> Vec<[f64; 3]> {
        (self.at)(i as f64)
    }

    fn new(
        body: Vec<u32>,
        faces: &[[u32; 3]],
        at: impl Fn(f64) -> Vec<[f64; 3]> + Send + Sync + 'static,
    ) -> Self {
        let mesh = Mesh::new(body.len(), faces).expect("a valid mesh");
        Self { mesh, body, at: Box::new(at) }
    }
}

/// Up and down between 0 and 1, with a period of 2: what stands for a sine here.
fn to_and_fro(x: f64) -> f64 {
    let part = x - 2.0 * (0.5 * x).floor();
    if part < 1.0 { part } else { 2.0 - part }
}

/// The same without corners.
fn swing(x: f64) -> f64 {
    let t = to_and_fro(x);
    t * t * (3.0 - 2.0 * t)
}

/// Two meshes of together `n_triangles`, four times a square, in the same place, so crumpled that
/// most triangles of one meet many of the other; every vertex moves to and fro on a line of its
/// own.
///
/// # Panics
/// If `n_triangles` is not four times a square from 1 on.
pub fn interpenetrating(n_triangles: usize) -> Sequence {
    let k = (1..=n_triangles).find(|k| 4 * k * k >= n_triangles).unwrap_or(0);
    assert!(k > 0 && 4 * k * k == n_triangles, "{n_triangles} is not four times a square");
    let (n, mut faces, mut random) = (k + 1, Vec::new(), Random::new(5));
    grid(&mut faces, n, 0);
    grid(&mut faces, n, (n * n) as u32);
    let mut lines = Vec::new();
    for i in 0..2 * n * n {
        let (u, v) = ((i % n) as f64 / k as f64, (i % (n * n) / n) as f64 / k as f64);
        // The second sheet stands upright in the first.
        let rest = if i < n * n { [u, 0.5, v] } else { [u, v, 0.5] };
        let mut near = || {
            let jitter = random.point();
            std::array::from_fn::<f64, 3, _>(|k| rest[k] + 0.5 * (jitter[k] - 0.5))
        };
        lines.push((near(), near(), random.unit()));
    }
    let body = (0..2 * n * n).map(|i| (i >= n * n) as u32).collect();
    Sequence::new(body, &faces, move |frame| {
        let at = |&(from, to, phase): &([f64; 3], [f64; 3], f64)| {
            let t = swing(0.02 * frame + phase);
            std::array::from_fn(|k| from[k] + t * (to[k] - from[k]))
        };
        lines.iter().map(at).collect()
    })
}

/// A cloth of `2 (n - 1)^2` triangles that is drawn down through a funnel of a quarter as many: the
/// nearer to the spout, the narrower, in folds that touch each other. With `n = 87` it is 18.3 K
/// triangles.
///
/// # Panics
/// If `n` is less than 4.
pub fn funnel(n: usize) -> Sequence {
    let (m, mut faces) = (n / 2, Vec::new());
    grid(&mut faces, n, 0);
    grid(&mut faces, m, (n * n) as u32);
    // Inner radius at a height: a cone down to a spout.
    let radius = |y: f64| 0.12 + 0.9 * (y + 0.2).max(0.0);
    let mut wall = Vec::new();
    for i in 0..m * m {
        let (turn, y) = ((i % m) as f64 / (m - 1) as f64, (i / m) as f64 / (m - 1) as f64);
        let ([x, z], y) = (circle(turn), 1.4 * y - 0.6);
        wall.push([1.02 * radius(y) * x, y, 1.02 * radius(y) * z]);
    }
    let mut random = Random::new(9);
    let jitter: Vec<[f64; 3]> = (0..n * n).map(|_| random.point().map(|c| c - 0.5)).collect();
    let body = (0..n * n + m * m).map(|i| (i >= n * n) as u32).collect();
    Sequence::new(body, &faces, move |frame| {
        let drop = 0.006 * frame;
        let cloth = |i: usize| {
            let at = |k: usize| 2.0 * k as f64 / (n - 1) as f64 - 1.0;
            let (u, v) = (at(i % n), at(i / n));
            let r = (u * u + v * v).sqrt();
            // The middle goes first.
            let y = 0.75 + 0.1 * r - drop * (1.6 - r);
            let fold = 0.08 * drop.min(0.5) * (swing(9.0 * u + y) - swing(7.0 * v - y));
            let shrink = (radius(y) / (r + 0.3)).min(1.0);
            let p = [shrink * u, y + fold, shrink * v];
            std::array::from_fn(|k| p[k] + 0.004 * jitter[i][k])
        };
        (0..n * n).map(cloth).chain(wall.iter().copied()).collect()
    })
}

/// A cloth of `2 (n - 1)^2` triangles that sinks on a ball of as many, which turns no vertex of its
/// own: with `n = 152`, 92 K triangles.
///
/// # Panics
/// If `n` is less than 3.
pub fn cloth_on_ball(n: usize) -> Sequence {
    let mut faces = Vec::new();
    grid(&mut faces, n, 0);
    grid(&mut faces, n, (n * n) as u32);
    let ball: Vec<[f64; 3]> = sphere(n).iter().map(|p| p.map(|c| 0.5 * c)).collect();
    let body = (0..2 * n * n).map(|i| (i >= n * n) as u32).collect();
    Sequence::new(body, &faces, move |frame| {
        let cloth = |i: usize| {
            let at = |k: usize| 2.0 * k as f64 / (n - 1) as f64 - 1.0;
            let (u, v) = (at(i % n), at(i / n));
            let r2 = u * u + v * v;
            let surface = if r2 < 0.2601 { (0.2601 - r2).sqrt() } else { 0.0 };
            let free = 0.6 - 0.008 * frame;
            // Off the ball it hangs in folds.
            let fold = 0.05 * (0.6 - free).clamp(0.0, 1.0) * swing(6.0 * u + 5.0 * v);
            let hem = if r2 < 0.2601 { 0.0 } else { fold };
            [u, free.max(surface) + hem, v]
        };
        (0..n * n).map(cloth).chain(ball.iter().copied()).collect()
    })
}

/// Spheres of `2 (n - 1)^2` triangles each that fly straight through a box and bounce off its
/// walls, and through each other: rigid bodies. With 285 of `n = 17`, 146 K triangles.
///
/// # Panics
/// If `n` is less than 3.
pub fn n_body(n_bodies: usize, n: usize) -> Sequence {
    let (unit, mut faces, mut random) = (sphere(n), Vec::new(), Random::new(11));
    let mut paths = Vec::new();
    for k in 0..n_bodies {
        grid(&mut faces, n, (k * n * n) as u32);
        let speed = random.point().map(|c| 0.02 * (c - 0.5));
        paths.push((random.point(), speed, 0.04 + 0.03 * random.unit()));
    }
    let body = (0..n_bodies * n * n).map(|i| (i / (n * n)) as u32).collect();
    Sequence::new(body, &faces, move |frame| {
        let spheres = |(from, speed, radius): &([f64; 3], [f64; 3], f64)| {
            let centre = |k: usize| to_and_fro(from[k] + 64.0 + speed[k] * frame);
            let middle: [f64; 3] = std::array::from_fn(centre);
            let place = |p: &[f64; 3]| std::array::from_fn(|k| middle[k] + radius * p[k]);
            unit.iter().map(place).collect::<Vec<[f64; 3]>>()
        };
        paths.iter().flat_map(spheres).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sequences_are_as_large_as_they_say_and_move() {
        let sizes = [64, 256, 1024, 4096].map(|n| (interpenetrating(n), n));
        let named =
            [(funnel(87), 18_320), (cloth_on_ball(152), 91_204), (n_body(285, 17), 145_920)];
        for (scene, n) in sizes.into_iter().chain(named) {
            assert_eq!(scene.mesh.faces().len(), n);
            let (first, next) = (scene.frame(0), scene.frame(1));
            assert_eq!([first.len(), next.len()], [scene.mesh.n_vertices(); 2]);
            assert_eq!(scene.body.len(), first.len());
            let step =
                |i: usize| (0..3).map(|k| (first[i][k] - next[i][k]).abs()).fold(0.0, f64::max);
            let most = (0..first.len()).map(step).fold(0.0, f64::max);
            assert!(most > 1e-4 && most < 0.1, "a vertex moves by {most}");
        }
    }
}
