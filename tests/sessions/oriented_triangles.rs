//! Pairs of triangles that oriented boxes reject are no contacts: candidates and contacts are those
//! of brute force by features, where an error of a box would show: corners that just touch,
//! needles, positions far from the origin that all round the wrong way, distances that are just
//! not kept.

use super::found::Found;
use ccd::Session;
use ccd::method::TriangleOptions;
use ccd::method::{BroadPhaseMethod, Pipeline, TreeOptions, Volume};
use ccd::scenes::Random;
use ccd::{Mesh, Options};

type V = [f64; 3];

fn at(p: V, t: f64, v: V) -> V {
    std::array::from_fn(|k| p[k] + t * v[k])
}

fn unit(random: &mut Random) -> V {
    loop {
        let v: V = std::array::from_fn(|_| 2.0 * random.unit() - 1.0);
        let square: f64 = v.iter().map(|x| x * x).sum();
        if square > 0.01 && square < 1.0 {
            return v.map(|x| x / square.sqrt());
        }
    }
}

fn across(n: V, v: V) -> V {
    [n[1] * v[2] - n[2] * v[1], n[2] * v[0] - n[0] * v[2], n[0] * v[1] - n[1] * v[0]]
}

/// Pairs of triangles side by side, and both ends of their step.
#[derive(Default)]
struct Scene {
    x: [Vec<V>; 2],
    faces: Vec<[u32; 3]>,
    min_distance: f64,
}

impl Scene {
    fn add(&mut self, t0: [V; 3], motion: V) {
        let n = self.x[0].len() as u32;
        self.x[0].extend(t0);
        self.x[1].extend(t0.map(|p| at(p, 1.0, motion)));
        self.faces.push([n, n + 1, n + 2]);
    }

    /// Contacts, and pairs of triangles that were separated.
    fn check<T: ccd::Coordinate>(&self, what: &str) -> (usize, u64) {
        let mesh = Mesh::new(self.x[0].len(), &self.faces).expect("a mesh");
        let run = |method, pipeline| {
            let options = Options::default().with_threads(1).with_min_distance(self.min_distance);
            let options = options.with_broad_phase(method).with_pipeline(pipeline);
            let mut session = Session::new(mesh.clone(), options).expect("a session");
            let found = Found::of::<T>(&mut session, &self.x[0], &self.x[1]);
            (found, session.report().triangles.map_or(0, |counts| counts.separated))
        };
        let (want, _) = run(BroadPhaseMethod::BruteForce, Pipeline::Features);
        let method = BroadPhaseMethod::Tree(TreeOptions::default().volume(Volume::Obb));
        for orphans in [true, false] {
            let options = TriangleOptions::default().orphans(orphans);
            let (found, separated) = run(method, Pipeline::Triangles(options));
            assert_eq!(found.pairs, want.pairs, "{what}");
            assert!(found.contacts == want.contacts, "{what}: {found:?}\n{want:?}");
            assert!(found.filtered.total() <= want.filtered.total(), "{what}");
            if orphans {
                return (want.contacts.len(), separated);
            }
        }
        unreachable!("both were run")
    }
}

/// A needle or a wide triangle that comes down on another with a corner, edge or side, and stops
/// `gap` above it; the two have `size`, and lie at `place`.
fn approach(scene: &mut Scene, random: &mut Random, place: V, size: f64, gap: f64) {
    let n = unit(random);
    let (u, v) = (across(n, unit(random)), across(n, unit(random)));
    let thin = [1.0, 1e-2, 1e-5][random.below(3) as usize];
    let [a, b] = [at(place, -0.3 * size, u), at(at(place, 0.7 * size, u), size * thin, v)];
    let c = at(at(place, 0.6 * size, u), -size * thin, v);
    scene.add([a, b, c], [0.0; 3]);
    let weights = [[1.0, 0.0, 0.0], [0.5, 0.5, 0.0], [0.25, 0.5, 0.25]][random.below(3) as usize];
    let point: V =
        std::array::from_fn(|k| weights[0] * a[k] + weights[1] * b[k] + weights[2] * c[k]);
    let (away, thin) = (0.5 * random.unit() * size, [1.0, 1e-2, 1e-5][random.below(3) as usize]);
    let start = at(point, gap + away, n);
    let tip =
        [start, at(at(start, size, n), size * thin, u), at(at(start, size, n), size * thin, v)];
    scene.add(tip, n.map(|x| -away * x));
}

fn check_family<T: ccd::Coordinate>(offset: f64, size: f64, min_distance: f64, keeps: f64) {
    let mut random = Random::new(7);
    let mut scene = Scene { min_distance, ..Scene::default() };
    for k in 0..200 {
        let place = [offset + 9.0 * size * k as f64, offset, -offset];
        // Half of them in contact, the others as far away again and a little more.
        let gap = if k % 2 == 0 { keeps * min_distance } else { min_distance + 0.05 * size };
        approach(&mut scene, &mut random, place, size, gap);
    }
    let what = format!("offset {offset:e}, size {size:e}, distance {min_distance:e} x {keeps}");
    let (n, separated) = scene.check::<T>(&what);
    assert!(n > 60 && separated > 20, "{what}: {n} contacts, {separated} separated");
}

#[test]
fn what_touches_is_not_rejected() {
    for (offset, size) in [(0.0, 1.0), (1e3, 1.0), (1e6, 1.0), (-3e4, 1e-2), (0.0, 1e-20)] {
        check_family::<f64>(offset, size, 0.0, 0.0);
    }
    check_family::<f32>(0.0, 1.0, 0.0, 0.0);
    check_family::<f32>(1e3, 1.0, 0.0, 0.0);
}

#[test]
fn a_distance_that_is_not_kept_is_not_rejected() {
    for (offset, size, distance) in
        [(0.0, 1.0, 0.1), (0.0, 1.0, 2.0), (1e5, 1.0, 0.01), (0.0, 1e-20, 1e-21)]
    {
        check_family::<f64>(offset, size, distance, 1.0 - 1e-9);
    }
    check_family::<f32>(0.0, 1.0, 0.5, 1.0 - 1e-6);
}

/// Corners in faces whose places in `f32` are off by half a unit in all three coordinates, of the
/// corner to one side and of the face to the other: a gap along the diagonal that is `sqrt(3)` as
/// wide as the error of a coordinate says.
#[test]
fn rounding_that_adds_up_along_a_diagonal_is_not_rejected() {
    // The greatest coordinate is just above a power of two, so that its error is as large as can
    // be; lone vertices keep the origin in the middle.
    let (reach, grid) = (66_000.0, 2f64.powi(-7));
    let mut scene = Scene::default();
    let mut random = Random::new(3);
    for octant in 0..8u32 {
        let sign: V = std::array::from_fn(|k| if octant >> k & 1 == 0 { 1.0 } else { -1.0 });
        for _ in 0..25 {
            let base: V = std::array::from_fn(|_| 65_600.0 + random.below(35_000) as f64 * grid);
            // In units of the grid. Both are symmetric, so that the centres of their boxes are on
            // the grid as well, and lose nothing.
            let place = |steps: V, off: f64| -> V {
                std::array::from_fn(|k| sign[k] * (base[k] + (steps[k] + off) * grid))
            };
            let face = [[-300.0, 300.0, 1.0], [300.0, -300.0, 1.0], [200.0, 200.0, -399.0]];
            scene.add(face.map(|steps| place(steps, 0.499)), [0.0; 3]);
            // It comes down along the diagonal by 100 steps, and a part of one too far.
            let needle = [[50.0, 50.0, -100.0], [450.0, 450.0, 300.0], [250.0, 252.0, 98.0]];
            scene.add(needle.map(|steps| place(steps, 100.501)), sign.map(|s| -100.0 * s * grid));
        }
    }
    for end in &mut scene.x {
        end.extend([[reach; 3], [-reach; 3]]);
    }
    let (n, _) = scene.check::<f64>("diagonals");
    assert!(n >= 200, "{n} contacts");
}
