//! Cases for the comparison of methods: generated boxes, and swept edges of real scenes.

use ccd::method::BroadPhaseMethod;
use ccd::scenes::{debris_boxes, teapot_in_a_stadium_boxes, uniform_boxes};
use ccd::{Aabb, BroadPhase, Pair};
use ccd_core::narrow_phase::intersection::segment_meets_triangle;
use ccd_testkit::brute::swept_boxes;
use ccd_testkit::data::{Scene, data_dir};
use rayon::prelude::*;
use std::path::Path;
use std::process::Command;

/// Boxes, within which pairs are sought or against which, and how many there are.
pub struct Case {
    pub name: String,
    pub boxes: Vec<Aabb<f32>>,
    /// Loose boxes that look for the others.
    pub against: Option<Vec<Aabb<f32>>>,
    pub n_pairs: usize,
}

impl Case {
    fn new(name: &str, boxes: Vec<Aabb<f32>>, against: Option<Vec<Aabb<f32>>>) -> Self {
        let default = BroadPhaseMethod::default();
        let count = || -> Result<usize, ccd::Error> {
            let mut broad = BroadPhase::new(0, default)?;
            Ok(match &against {
                None => broad.self_pairs(&boxes)?.len(),
                Some(other) => broad.pairs(other, &boxes)?.len(),
            })
        };
        let n_pairs = count().expect("valid boxes");
        Self { name: name.into(), boxes, against, n_pairs }
    }

    /// A line above a table.
    pub fn title(&self) -> String {
        let other = self.against.as_ref().map_or(String::new(), |b| format!(" and {}", b.len()));
        format!("**{}**: {}{other} boxes, {} pairs", self.name, self.boxes.len(), self.n_pairs)
    }

    pub fn file_name(&self) -> String {
        self.name.replace([' ', ','], "-")
    }
}

/// All scenes; real ones as far as the data is there.
pub fn all() -> Result<Vec<Case>, String> {
    let mut cases = vec![
        Case::new("debris", debris_boxes(), None),
        Case::new("uniform 100 K", uniform_boxes(100_000), None),
        Case::new("teapot in a stadium", teapot_in_a_stadium_boxes(), None),
    ];
    let dir = data_dir()?;
    for name in ["cloth-funnel", "cloth-ball", "rod-twist"] {
        let [t0, t1] = Scene::named(name).load(&dir);
        let mesh = t0.mesh().map_err(|e| e.to_string())?;
        let [_, edges, _] = swept_boxes(&mesh, &t0.positions, &t1.positions);
        let edges = edges.iter().map(Aabb::round_out).collect();
        cases.push(Case::new(&format!("{name} edges"), edges, None));
    }
    Ok(cases)
}

/// A scene of [Tian and Wan]: a sphere, and a cloth at rest on it that hangs by two corners.
pub struct Draped {
    /// A tree over the boxes of the cloth and queries by those of the sphere, and the reverse.
    pub cases: [Case; 2],
    /// Triangles of both, in the order of their boxes.
    triangles: [Vec<Triangle>; 2],
}

type Triangle = [[f64; 3]; 3];

/// What is added to boxes on every side, in metres: the distance that the cloth of `ccd demo` is
/// kept at.
const REACH: f64 = 0.006;

impl Draped {
    /// How many triangles of one have a point in common with one of the other among the pairs of
    /// boxes: the exact test of every edge of both, on the threads of the current pool.
    pub fn n_meeting(&self, pairs: &[Pair]) -> usize {
        let [ball, cloth] = &self.triangles;
        let edges = |[a, b, c]: Triangle| [[a, b], [b, c], [c, a]];
        let pierces = |s: Triangle, t: Triangle| {
            edges(s).iter().any(|&edge| segment_meets_triangle(edge, t) != Some(false))
        };
        let meets = |pair: &&Pair| {
            let (s, t) = (ball[pair.a as usize], cloth[pair.b as usize]);
            pierces(s, t) || pierces(t, s)
        };
        pairs.par_iter().filter(meets).count()
    }
}

/// The three sizes of the table of [Tian and Wan], each simulated by `ccd demo` until the cloth is
/// nearly at rest, by the program `ccd` beside this one, once.
pub fn cloths_on_spheres(root: &Path) -> Result<Vec<Draped>, String> {
    let sizes = [("small", 24), ("medium", 48), ("large", 64)];
    let draped = |(size, n): (&str, usize)| {
        let folder = root.join("target/cloth").join(size);
        let last = folder.join("frame-00360.ply");
        if !last.exists() {
            let own = std::env::current_exe().map_err(|e| e.to_string())?;
            let ccd = own.with_file_name("ccd");
            let out = folder.display().to_string();
            let words = ["demo", "--size", size, "--frames", "240", "--settle", "120"];
            let mut demo = Command::new(&ccd);
            demo.args(words).args(["--out", &out, "--frames-out", &out]);
            let status = demo.status().map_err(|e| format!("{}: {e}", ccd.display()))?;
            if !last.exists() {
                return Err(format!("ccd demo: {status}, and no {}", last.display()));
            }
        }
        let frame = ccd::io::read_frame(&last).map_err(|e| e.to_string())?;
        let mesh = frame.mesh().map_err(|e| e.to_string())?;
        let (cloth, ball): (Vec<[u32; 3]>, Vec<[u32; 3]>) =
            mesh.faces().iter().partition(|f| (f[0] as usize) < n * n);
        let triangles = [ball, cloth].map(|faces| -> Vec<Triangle> {
            faces.iter().map(|f| f.map(|v| frame.positions[v as usize])).collect()
        });
        let [ball, cloth] = triangles.each_ref().map(|all| -> Vec<Aabb<f32>> {
            let of = |t: &Triangle| {
                let points = t.map(Aabb::of_point);
                points[0].union(&points[1]).union(&points[2]).inflated(REACH).round_out()
            };
            all.iter().map(of).collect()
        });
        let (s, c) = (ball.len(), cloth.len());
        let cases = [
            Case::new(
                &format!("sphere of {s} triangles, tree over the cloth of {c}"),
                cloth.clone(),
                Some(ball.clone()),
            ),
            Case::new(
                &format!("cloth of {c} triangles, tree over the sphere of {s}"),
                ball,
                Some(cloth),
            ),
        ];
        Ok(Draped { cases, triangles })
    };
    sizes.into_iter().map(draped).collect()
}
