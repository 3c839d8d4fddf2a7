//! The simulation of the demo: a mass-spring cloth with a limit on strain [Provot 1995], and
//! contacts resolved so that nothing passes through.
//!
//! A step is first taken freely. Contacts at a small distance then push features apart along the
//! direction in which they are nearest. What would still touch is held back: vertices of such
//! contacts move only to a part of their time of impact, and this is repeated until the step is
//! certified free. A step in which every vertex stands still is free because the one before was,
//! so this ends.

use super::Failure;
use super::backend::{BackendOptions, compilation};
use super::method::MethodOptions;
use ccd::any::{Place, Session};
use ccd::geometry::vec3::{add, dot, lerp, scale, sub};
use ccd::scenes::{grid, sphere};
use ccd::{Bodies, Contact, Mesh, Options};

/// The scenes of [Tian and Wan], by triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Size {
    /// Triangles: sphere 1,922, cloth 1,058
    Small,
    /// Triangles: sphere 7,938, cloth 4,418
    Medium,
    /// Triangles: sphere 32,258, cloth 7,938
    Large,
}

impl Size {
    /// Vertices along a side of the cloth and of the grid that is the sphere.
    fn sides(self) -> [usize; 2] {
        match self {
            Self::Small => [24, 32],
            Self::Medium => [48, 64],
            Self::Large => [64, 128],
        }
    }
}

/// Side of the cloth.
const SIDE: f64 = 2.0;
const RADIUS: f64 = 0.42;
const CENTRE: [f64; 3] = [0.0, -0.75, 0.25];
/// Seconds, metres per second squared, part of the velocity kept each step, the same where the
/// cloth is to come to rest.
const DT: f64 = 1.0 / 480.0;
const GRAVITY: f64 = 9.81;
const DAMPING: f64 = 0.998;
const SETTLING: f64 = 0.9;
/// Springs may be longer than at rest by this part (10 % in [Provot 1995]).
const MAX_STRAIN: f64 = 0.05;
const STRAIN_ROUNDS: usize = 16;
/// Features are pushed apart below this distance, in metres.
pub const PUSH_DISTANCE: f64 = 0.006;
/// Part of the velocity along a surface that contact takes away.
const FRICTION: f64 = 0.15;
/// Rounds of pushing, and rounds of holding back after which a vertex in contact does not move at
/// all.
const PUSH_ROUNDS: usize = 2;
const HOLD_ROUNDS: usize = 6;
/// Rounds after which holding back has failed: more than there are ways to fix one vertex after the
/// other in practice.
const MAX_ROUNDS: usize = 200;

/// The state of the simulation.
pub struct Cloth {
    pub mesh: Mesh,
    pub x: Vec<[f64; 3]>,
    v: Vec<[f64; 3]>,
    springs: Vec<(usize, usize, f64)>,
    /// Vertices along a side of the cloth, whose vertices come first.
    n: usize,
    push: Session,
    hold: Session,
    /// The last step's free motion, and its contacts.
    pub step: [Vec<[f64; 3]>; 2],
    pub contacts: Vec<Contact>,
    /// Milliseconds in the library and number of its calls, since the last reset.
    pub ccd_ms: f64,
    pub n_calls: usize,
}

impl Cloth {
    pub fn new(
        size: Size,
        backend: &BackendOptions,
        method: &MethodOptions,
    ) -> Result<Self, Failure> {
        let [n, n_sphere] = size.sides();
        let mut x = Vec::new();
        let mut faces: Vec<[u32; 3]> = Vec::new();
        for i in 0..n * n {
            let at = |k: usize| SIDE * (k as f64 / (n - 1) as f64 - 0.5);
            // Slightly uneven, so that nothing is exactly coplanar.
            x.push([at(i % n), 1e-4 * ((i * 7919) % 13) as f64, at(i / n)]);
        }
        grid(&mut faces, n, 0);
        let n_faces_cloth = faces.len();
        x.extend(sphere(n_sphere).into_iter().map(|x| add(CENTRE, scale(x, RADIUS))));
        grid(&mut faces, n_sphere, (n * n) as u32);
        let mesh = Mesh::new(x.len(), &faces)?;
        let body: Vec<u32> = (0..x.len()).map(|v| (v >= n * n) as u32).collect();
        let bodies = Bodies::new(&body).with_fixed(1, true);
        let choice = backend.choose(mesh.edges().len())?;
        let options = Options::default().with_bodies(Some(bodies)).with_threads(backend.threads());
        let options = method.set(options)?;
        let session = |min_distance| {
            let options = options.clone().with_min_distance(min_distance);
            Session::new(&choice, mesh.clone(), options)
        };
        let (push, hold) = (session(PUSH_DISTANCE)?, session(0.0)?);
        let springs = springs(&faces[..n_faces_cloth], &x, n);
        let v = vec![[0.0; 3]; n * n];
        Ok(Self {
            step: [x.clone(), x.clone()],
            mesh,
            x,
            v,
            springs,
            n,
            push,
            hold,
            contacts: Vec::new(),
            ccd_ms: 0.0,
            n_calls: 0,
        })
    }

    /// Place of collision detection.
    pub fn place(&self) -> Place {
        self.hold.place()
    }

    /// Compilation of kernels, on a GPU.
    pub fn compilation(&mut self) -> Option<ccd::gpu::Compilation> {
        compilation(&mut self.hold)
    }

    /// Number of vertices of the cloth, which come first.
    pub fn n_cloth(&self) -> usize {
        self.n * self.n
    }

    /// Greatest speed of a vertex, in metres a second.
    pub fn speed(&self) -> f64 {
        self.v.iter().map(|v| dot(*v, *v)).fold(0.0, f64::max).sqrt()
    }

    /// One step of the simulation.
    pub fn step(&mut self, settles: bool) -> Result<(), Failure> {
        let kept = if settles { SETTLING } else { DAMPING };
        let (n, x0) = (self.n, self.x.clone());
        let mut x1 = x0.clone();
        for i in (0..self.n_cloth()).filter(|&i| !pinned(i, n)) {
            self.v[i] = scale(add(self.v[i], [0.0, -GRAVITY * DT, 0.0]), kept);
            x1[i] = add(x0[i], scale(self.v[i], DT));
        }
        self.limit_strain(&mut x1);
        self.contacts.clear();
        for round in 0..PUSH_ROUNDS {
            let report = self.push.step(&x0, &x1)?;
            self.ccd_ms += report.times.total;
            self.n_calls += 1;
            if round == 0 {
                self.contacts.extend_from_slice(&report.contacts);
                self.step = [x0.clone(), x1.clone()];
            }
            if report.contacts.is_empty() {
                break;
            }
            for c in &report.contacts {
                push_apart(c, &self.mesh, n, &x0, &mut x1);
            }
        }
        self.hold_back(&x0, &mut x1)?;
        for i in 0..self.n_cloth() {
            self.v[i] = scale(sub(x1[i], x0[i]), 1.0 / DT);
        }
        self.x = x1;
        Ok(())
    }

    /// Shortens springs that are too long, both ends equally (section 5 of [Provot 1995]).
    fn limit_strain(&self, x: &mut [[f64; 3]]) {
        for _ in 0..STRAIN_ROUNDS {
            for &(a, b, rest) in &self.springs {
                let d = sub(x[b], x[a]);
                let length = dot(d, d).sqrt();
                let most = rest * (1.0 + MAX_STRAIN);
                // Stretching is limited; being shorter than at rest is resisted softly.
                let change =
                    if length > most { length - most } else { 0.05 * (length - rest).min(0.0) };
                if change == 0.0 || length == 0.0 {
                    continue;
                }
                let (free_a, free_b) =
                    (!pinned(a, self.n) as u8 as f64, !pinned(b, self.n) as u8 as f64);
                let step = scale(d, change / length / (free_a + free_b).max(1.0));
                x[a] = add(x[a], scale(step, free_a));
                x[b] = sub(x[b], scale(step, free_b));
            }
        }
    }

    /// Shortens the motion of vertices until the step is certified free.
    fn hold_back(&mut self, x0: &[[f64; 3]], x1: &mut [[f64; 3]]) -> Result<(), Failure> {
        for round in 0..MAX_ROUNDS {
            let report = self.hold.step(x0, &*x1)?;
            self.ccd_ms += report.times.total;
            self.n_calls += 1;
            if report.contacts.is_empty() {
                return Ok(());
            }
            for c in &report.contacts {
                let part = if round < HOLD_ROUNDS { 0.8 * c.toi } else { 0.0 };
                let ids = c.vertices(&self.mesh).map(|v| v as usize);
                for v in ids.into_iter().filter(|&v| v < self.n * self.n) {
                    // The shorter of what it may move now and what this contact allows.
                    x1[v] = lerp(x0[v], x1[v], part.min(1.0));
                }
            }
        }
        Err(Failure(format!("the demo could not resolve its contacts in {MAX_ROUNDS} rounds")))
    }
}

/// Whether a vertex is one of the two corners of a cloth of `n` vertices along a side that are
/// pinned.
fn pinned(v: usize, n: usize) -> bool {
    v == 0 || v == n - 1
}

/// A spring along every side, and one across every two cells against bending.
fn springs(faces: &[[u32; 3]], x: &[[f64; 3]], n: usize) -> Vec<(usize, usize, f64)> {
    let mut pairs: Vec<(usize, usize)> = Vec::new();
    for &[a, b, c] in faces {
        for (p, q) in [(a, b), (b, c), (c, a)] {
            pairs.push((p.min(q) as usize, p.max(q) as usize));
        }
    }
    for i in 0..n * n {
        if i % n + 2 < n {
            pairs.push((i, i + 2));
        }
        if i / n + 2 < n {
            pairs.push((i, i + 2 * n));
        }
    }
    pairs.sort_unstable();
    pairs.dedup();
    let length = |(a, b): (usize, usize)| {
        let d = sub(x[b], x[a]);
        (a, b, dot(d, d).sqrt())
    };
    pairs.into_iter().map(length).collect()
}

/// Moves the ends of the step apart along the normal at the time of impact, of the step as the
/// pushes before have left it.
fn push_apart(c: &Contact, mesh: &Mesh, n: usize, x0: &[[f64; 3]], x1: &mut [[f64; 3]]) {
    let ids = c.vertices(mesh).map(|v| v as usize);
    let (normal, n_first) = (c.geometry(mesh, x0, x1).normal, c.kind.n_first());
    let along = ids.map(|v| dot(normal, x1[v]));
    let first = along[..n_first].iter().copied().fold(f64::INFINITY, f64::min);
    let second = along[n_first..].iter().copied().fold(f64::NEG_INFINITY, f64::max);
    // How far apart they are at the end of the step.
    let end = first - second;
    let lacking = PUSH_DISTANCE - end;
    if lacking <= 0.0 {
        return;
    }
    let movable = |v: usize| v < n * n && !pinned(v, n);
    let sides =
        [ids[..n_first].iter().any(|&v| movable(v)), ids[n_first..].iter().any(|&v| movable(v))];
    // Half a push a side if both can move, and not all at once: several contacts share vertices.
    let share = 0.5 * lacking / (sides[0] as u8 + sides[1] as u8).max(1) as f64;
    for (k, &v) in ids.iter().enumerate().filter(|&(_, &v)| movable(v)) {
        let sign = if k < n_first { 1.0 } else { -1.0 };
        let slide = sub(sub(x1[v], x0[v]), scale(normal, dot(normal, sub(x1[v], x0[v]))));
        x1[v] = add(x1[v], scale(normal, sign * share));
        x1[v] = sub(x1[v], scale(slide, FRICTION / 4.0));
    }
}
