//! Regions that are certified not to touch themselves do not, by exact arithmetic on all pairs of
//! their features; regions that touch are not certified, also where all normals are in a half
//! space.

use crate::common::exact::{Contact, contact};
use crate::common::random::Random;
use ccd_core::backend::triangle_pairs::region_certificate::{Region, View, mean_normal, reach};
use ccd_core::narrow_phase::relative_motion::Patch;
use std::collections::BTreeSet;

type Ends = [Vec<[f64; 3]>; 2];

/// A disc of triangles, and its rim.
struct Disc {
    faces: Vec<[u32; 3]>,
    rim: Vec<u32>,
}

impl Disc {
    /// `n` by `m` squares of two triangles each.
    fn sheet(n: u32, m: u32) -> Self {
        let at = |i: u32, j: u32| i * (m + 1) + j;
        let square = |k: u32| {
            let (i, j) = (k / m, k % m);
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        };
        let rim = (0..n)
            .map(|i| at(i, 0))
            .chain((0..m).map(|j| at(n, j)))
            .chain((0..n).map(|i| at(n - i, m)))
            .chain((0..m).map(|j| at(0, m - j)));
        Self { faces: (0..n * m).flat_map(square).collect(), rim: rim.collect() }
    }

    /// Triangles around vertex 0.
    fn fan(n: u32) -> Self {
        let faces = (1..=n).map(|i| [0, i, i % n + 1]).collect();
        Self { faces, rim: (1..=n).collect() }
    }

    fn is_free(&self, x: &Ends) -> bool {
        let triangles: Vec<u32> = (0..self.faces.len() as u32).collect();
        let mut seen = vec![[[0.0; 2]; 2]; self.rim.len()];
        let region = Region { faces: &self.faces, triangles: &triangles, rim: &self.rim };
        let x = [&x[0][..], &x[1]];
        let mut normal = [0.0; 3];
        for &face in &self.faces {
            let of_face = mean_normal(&x, face);
            normal = [0, 1, 2].map(|k| normal[k] + of_face[k]);
        }
        let origin = x[0][0];
        reach(&x, &self.faces, &triangles, origin)
            .and_then(|reach| View::along(normal, origin, reach))
            .is_some_and(|view| region.free(&x, &view, &mut seen))
    }

    /// A pair of features without a common vertex that exact arithmetic does not find free.
    fn touching(&self, x: &Ends) -> Option<[u32; 4]> {
        let vertices: BTreeSet<u32> = self.faces.iter().flatten().copied().collect();
        let sides = self.faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let edges: BTreeSet<[u32; 2]> = sides.map(|[a, b]| [a.min(b), a.max(b)]).collect();
        let vf = vertices.iter().flat_map(|&v| {
            self.faces.iter().map(move |&[a, b, c]| (Patch::Triangle, 1, [v, a, b, c]))
        });
        let ee = edges.iter().flat_map(|&[a, b]| {
            let later = edges.range([a, b]..);
            later.map(move |&[c, d]| (Patch::Parallelogram, 2, [a, b, c, d]))
        });
        let touches = |&(patch, n, ids): &(Patch, usize, [u32; 4])| {
            if ids[..n].iter().any(|v| ids[n..].contains(v)) || !overlap(x, &ids[..n], &ids[n..]) {
                return false;
            }
            let at = |x: &[[f64; 3]]| ids.map(|v| x[v as usize]);
            contact(patch, &at(&x[0]), &at(&x[1])) != Contact::Free
        };
        vf.chain(ee).find(touches).map(|(_, _, ids)| ids)
    }

    /// Whether all normals at both ends, and halfway, look up.
    fn looks_up(&self, x: &Ends) -> bool {
        [0.0, 0.5, 1.0].iter().all(|t| {
            self.faces.iter().all(|face| {
                let p = face.map(|v| {
                    let (p, q) = (x[0][v as usize], x[1][v as usize]);
                    [0, 1].map(|k| p[k] + t * (q[k] - p[k]))
                });
                let [u, v] = [p[1], p[2]].map(|q| [q[0] - p[0][0], q[1] - p[0][1]]);
                u[0] * v[1] - u[1] * v[0] > 0.0
            })
        })
    }
}

/// Whether swept boxes overlap.
fn overlap(x: &Ends, a: &[u32], b: &[u32]) -> bool {
    (0..3).all(|k| {
        let range = |ids: &[u32]| {
            let all = ids.iter().flat_map(|&v| [x[0][v as usize][k], x[1][v as usize][k]]);
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |[lo, hi], c| [lo.min(c), hi.max(c)])
        };
        let (a, b) = (range(a), range(b));
        a[0] <= b[1] && b[0] <= a[1]
    })
}

/// A point on a curve that begins straight and winds up: a turn of `bend` a unit of length.
fn wound(bend: f64, s: f64) -> [f64; 2] {
    let (mut p, mut d) = ([0.0, 0.0], [1.0, 0.0]);
    let steps = 24;
    for _ in 0..steps {
        let step = s / steps as f64;
        p = [p[0] + step * d[0], p[1] + step * d[1]];
        // A turn by Cayley's formula: the length stays.
        let h = 0.5 * bend * step;
        let (c, t) = ((1.0 - h * h) / (1.0 + h * h), 2.0 * h / (1.0 + h * h));
        d = [c * d[0] - t * d[1], t * d[0] + c * d[1]];
    }
    p
}

#[test]
fn what_is_certified_is_free() {
    let mut random = Random::new(17);
    let mut unit = move || random.unit();
    let disc = Disc::sheet(7, 5);
    let (mut certified, mut touching, mut open) = (0, 0, 0);
    for round in 0..150 {
        // From flat to wound over itself, from smooth to rough, turned any way, near and far.
        let rough = [0.0, 0.05, 0.3][round % 3] * unit();
        let bends = [unit(), unit()].map(|b| 1.6 * b * b);
        let skew = unit() - 0.5;
        let far = if round % 4 == 0 { 1e6 } else { 0.0 };
        let axes = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1]][round % 4];
        let scale = [1.0, 1e-7, 3e8][round / 4 % 3];
        let x: Ends = bends.map(|bend| {
            let mut all = Vec::new();
            for i in 0..8 {
                for j in 0..6 {
                    let [p, q] = wound(bend, i as f64 + 0.3 * skew * j as f64);
                    let flat = [p, j as f64 + skew * p * 0.3, q];
                    let at = [0, 1, 2].map(|k| flat[axes[k]] + rough * (unit() - 0.5));
                    all.push(at.map(|c| scale * c + far));
                }
            }
            all
        });
        let free = disc.is_free(&x);
        let touch = disc.touching(&x);
        assert!(!(free && touch.is_some()), "round {round}: {touch:?} touch in {x:?}");
        certified += free as usize;
        touching += touch.is_some() as usize;
        open += (!free && touch.is_none()) as usize;
    }
    println!("{certified} certified, {touching} touch, {open} do not and are not certified");
    assert!(certified > 20 && touching > 20, "{certified}, {touching} show nothing");
}

/// Random discs that overlap themselves in the plane: fans that wind around once or more.
#[test]
fn fans_are_free_only_if_they_wind_once() {
    let mut random = Random::new(23);
    let mut unit = move || random.unit();
    let mut certified = [0; 2];
    for round in 0..100 {
        let (n, turns) = (5 + round % 7, 1 + round % 2);
        let x: Ends = [0, 1].map(|_| {
            let around = |i: usize| {
                // Around a square, `turns` times.
                let s = (i * turns) as f64 * 4.0 / n as f64 % 4.0;
                let (side, r) = (s as usize, s - s.floor());
                let [p, q] = [[1.0 - 2.0 * r, 1.0], [-1.0, 1.0 - 2.0 * r], [2.0 * r - 1.0, -1.0]]
                    .get(side)
                    .copied()
                    .unwrap_or([1.0, 2.0 * r - 1.0]);
                let size = 1.0 + 0.3 * unit();
                [size * p, size * q, 0.2 * unit()]
            };
            std::iter::once([0.0; 3]).chain((0..n).map(around)).collect()
        });
        let disc = Disc::fan(n as u32);
        let free = disc.is_free(&x);
        certified[turns - 1] += free as usize;
        assert!(!(free && disc.touching(&x).is_some()), "{n} {turns} {x:?}");
    }
    assert!(certified[0] > 20, "{certified:?}");
    assert_eq!(certified[1], 0, "a rim that winds twice crosses itself");
}

/// All normals look up, and yet they touch: only the rim tells.
#[test]
fn a_half_space_of_normals_is_not_enough() {
    // A strip that turns left four times, and goes through its own beginning as it sinks.
    let path = [[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [1.0, 4.0], [1.0, -3.0f64]];
    let corner = [[-1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [1.0, 0.0f64]];
    let strip = |heights: [f64; 5]| -> Vec<[f64; 3]> {
        let along = |i: usize| {
            // Left and right of the path.
            let across = if i == 0 { [0.0, 1.0] } else { corner[i] };
            let at = |side: f64| {
                [0, 1].map(|k| path[i][k] + 0.3 * side * across[k]).into_iter().chain([heights[i]])
            };
            [1.0, -1.0].map(|side| {
                let p: Vec<f64> = at(side).collect();
                [p[0], p[1], p[2]]
            })
        };
        (0..5).flat_map(along).collect()
    };
    let faces: Vec<[u32; 3]> = (0..4u32)
        .flat_map(|i| [[2 * i, 2 * i + 1, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 2]])
        .collect();
    let disc = Disc { faces, rim: vec![1, 3, 5, 7, 9, 8, 6, 4, 2, 0] };
    let rising = strip([0.0, 0.2, 0.4, 0.6, 0.8]);
    let sunk = strip([0.0, 0.2, 0.4, 0.0, -0.8]);
    let x = [rising.clone(), sunk];
    assert!(disc.looks_up(&x) && disc.touching(&x).is_some() && !disc.is_free(&x));
    // It does not touch while it only rises, but this cannot be seen from above.
    let x = [rising.clone(), rising.clone()];
    assert!(disc.looks_up(&x) && disc.touching(&x).is_none() && !disc.is_free(&x));
    // The same strip without its last part does not cross itself.
    let part = Disc { faces: disc.faces[..6].to_vec(), rim: vec![1, 3, 5, 7, 6, 4, 2, 0] };
    assert!(part.is_free(&x) && part.touching(&x).is_none());

    // A figure of eight: two triangles of a bow tie, joined by what looks down.
    let bow = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0f64]];
    let flat: Vec<[f64; 3]> = [0, 2, 1, 3].map(|i: usize| [bow[i][0], bow[i][1], 0.0]).to_vec();
    let tie = Disc { faces: vec![[0, 1, 2], [0, 2, 3]], rim: vec![0, 1, 2, 3] };
    assert!(!tie.is_free(&[flat.clone(), flat]), "a figure of eight");
}

/// A rim that stays where it is does not tell: what is inside turns over, for good or on the way.
#[test]
fn a_simple_rim_is_not_enough() {
    // The middle of a sheet is turned left to right, above it.
    let disc = Disc::sheet(4, 4);
    let fold = |inner: &dyn Fn([f64; 2]) -> [f64; 3]| -> Vec<[f64; 3]> {
        (0..25)
            .map(|v| [(v / 5) as f64, (v % 5) as f64])
            .map(|p| {
                let on_rim = p.iter().any(|&c| c == 0.0 || c == 4.0);
                if on_rim { [p[0], p[1], 0.0] } else { inner(p) }
            })
            .collect()
    };
    let risen = fold(&|p| [p[0], p[1], 1.0]);
    let turned = fold(&|p| [4.0 - p[0], p[1], 1.0]);
    assert!(disc.is_free(&[risen.clone(), risen.clone()]));
    let x = [risen, turned];
    assert!(!disc.is_free(&x) && disc.touching(&x).is_some());

    // A whirl: rings turn the more the nearer they are to the middle, which turns by half and on
    // straight paths becomes a point halfway. At both ends all normals look up.
    let n = 20u32;
    let disc = Disc::sheet(n, n);
    let flat: Vec<[f64; 3]> = (0..(n + 1) * (n + 1))
        .map(|v| [v / (n + 1), v % (n + 1)].map(|i| i as f64 / (0.5 * n as f64) - 1.0))
        .map(|[p, q]| [p, q, 0.0])
        .collect();
    let whirl = |p: &[f64; 3]| {
        let r = (p[0] * p[0] + p[1] * p[1]).sqrt();
        // A quarter of the angle, as Cayley takes it.
        let h = (1.0 - r).max(0.0) * (1.0 - r).max(0.0);
        let (c, s) = ((1.0 - h * h) / (1.0 + h * h), 2.0 * h / (1.0 + h * h));
        let turn = |p: [f64; 2]| [c * p[0] - s * p[1], s * p[0] + c * p[1]];
        let [x, y] = turn(turn([p[0], p[1]]));
        [x, y, 0.0]
    };
    let whirled: Vec<[f64; 3]> = flat.iter().map(whirl).collect();
    assert!(disc.looks_up(&[flat.clone(), flat.clone()]));
    assert!(disc.looks_up(&[whirled.clone(), whirled.clone()]));
    let x = [flat, whirled];
    assert!(!disc.is_free(&x) && disc.touching(&x).is_some());
}

/// Contact is closed, and what is not finite is not certified.
#[test]
fn touching_rims_and_bad_numbers() {
    let disc = Disc::sheet(2, 1);
    let flat: Vec<[f64; 3]> = (0..6).map(|v| [(v / 2) as f64, (v % 2) as f64, 0.0]).collect();
    assert!(disc.is_free(&[flat.clone(), flat.clone()]));
    for bad in [f64::NAN, f64::INFINITY, 1e308] {
        for v in 0..6 {
            let mut y = flat.clone();
            y[v][v % 3] = bad;
            assert!(!disc.is_free(&[flat.clone(), y]), "{bad} at {v}");
        }
    }
    // A square without area at the end, and a fold onto itself.
    let mut y = flat.clone();
    y.iter_mut().for_each(|p| p[1] = 0.0);
    assert!(!disc.is_free(&[flat.clone(), y.clone()]));
    let folded = flat.iter().map(|p| [1.0 - (p[0] - 1.0).abs(), p[1], 0.0]).collect();
    assert!(!disc.is_free(&[flat, folded]));
    // A rim that touches itself in one point at one time: the tips of a horseshoe.
    let shoe = Disc::sheet(5, 1);
    let outer = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [3.0, 2.0], [3.0, 3.0], [0.0, 3.0f64]];
    let ends = |gap: f64| -> Vec<[f64; 3]> {
        let inner =
            [[0.0, 1.5 - gap], [2.0, 1.0], [2.0, 1.25], [2.0, 1.75], [2.0, 2.0], [0.0, 1.5 + gap]];
        (0..12)
            .map(|v| if v % 2 == 0 { outer[v / 2] } else { inner[v / 2] })
            .map(|p| [p[0], p[1], 0.0])
            .collect()
    };
    assert!(shoe.is_free(&[ends(0.4), ends(0.25)]));
    let x = [ends(0.4), ends(0.0)];
    assert!(!shoe.is_free(&x) && shoe.touching(&x).is_some());
}
