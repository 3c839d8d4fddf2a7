//! Cases for the comparison of methods: generated boxes, and swept edges of real scenes.

use ccd::scenes::{debris_boxes, grid, sphere, uniform_boxes};
use ccd::{Aabb, BroadPhase, BroadPhaseMethod};
use ccd_testkit::brute::swept_boxes;
use ccd_testkit::data::{Scene, data_dir};

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

/// The cloths and spheres of [Tian and Wan], in the sizes of their table: a square cloth lies on a
/// sphere of radius 1 and hangs down where that is not below it.
pub fn cloths_on_spheres() -> Result<Vec<Case>, String> {
    let triangles = |faces: &[[u32; 3]], x: &[[f64; 3]]| -> Vec<Aabb<f32>> {
        let face = |f: &[u32; 3]| {
            let boxes = f.map(|v| Aabb::of_point(x[v as usize]));
            boxes[0].union(&boxes[1]).union(&boxes[2]).inflated(1e-3).round_out()
        };
        faces.iter().map(face).collect()
    };
    let mut cases = Vec::new();
    for (n_sphere, n_cloth) in [(32, 24), (64, 48), (128, 64)] {
        let (mut of_sphere, mut of_cloth) = (Vec::new(), Vec::new());
        grid(&mut of_sphere, n_sphere, 0);
        grid(&mut of_cloth, n_cloth, 0);
        let at = |k: usize| 3.0 * (k as f64 / (n_cloth - 1) as f64 - 0.5);
        let cloth: Vec<[f64; 3]> = (0..n_cloth * n_cloth)
            .map(|i| {
                let (x, z) = (at(i % n_cloth), at(i / n_cloth));
                let r2 = x * x + z * z;
                let y = if r2 < 1.0 { (1.0 - r2).sqrt() } else { 1.0 - r2.sqrt() };
                [x, y + 1e-3, z]
            })
            .collect();
        let (ball, cloth) =
            (triangles(&of_sphere, &sphere(n_sphere)), triangles(&of_cloth, &cloth));
        let name = format!("sphere of {} triangles, cloth of {}", ball.len(), cloth.len());
        cases.push(Case::new(&name, cloth, Some(ball)));
    }
    Ok(cases)
}
