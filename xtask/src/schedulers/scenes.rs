//! Sequences on which schedulers are compared: those of [da Silva 2013], chapter 4, as far as they
//! can be made again, and one that was simulated.

use ccd::scenes::{Sequence, cloth_on_ball, funnel, interpenetrating, n_body};
use ccd::{Bodies, Mesh, Options, PerKind, Pipeline, Session};
use ccd_testkit::data::data_dir;

/// What the dissertation reports of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Published {
    /// Milliseconds a frame by lazy work stealing on a GTS 450 and a GT 520, table 4.1.
    pub lazy: [Option<f64>; 2],
    /// The same by gProximity, table 4.4.
    pub gproximity: [Option<f64>; 2],
    /// Front nodes a frame, table 4.3.
    pub front: f64,
}

/// A scene, its frames, and how many pairs the default finds between two of them.
pub struct Scene {
    pub name: String,
    pub mesh: Mesh,
    pub pipeline: Pipeline,
    bodies: Option<Bodies>,
    pub frames: Vec<Vec<[f64; 3]>>,
    pub counts: Vec<Counts>,
    pub published: Option<Published>,
}

/// What must be the same by whatever scheduler.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Counts {
    pub candidates: PerKind,
    /// Pairs of triangles, if those are paired.
    pub triangles: Option<u64>,
}

impl Counts {
    pub fn of(report: &ccd::Report) -> Self {
        Self { candidates: report.candidates, triangles: report.triangles.map(|t| t.pairs) }
    }
}

/// The seven of the dissertation by pairs of triangles, and two by pairs of features, which is what
/// a session does unless it is told otherwise. `n_frames`: frames of each.
pub fn all(wanted: &dyn Fn(&str) -> bool, n_frames: usize) -> Result<Vec<Scene>, String> {
    type Make = fn() -> Sequence;
    let published = |lazy, gproximity, front| Some(Published { lazy, gproximity, front });
    let both = |a, b| [Some(a), Some(b)];
    let triangles = Pipeline::TRIANGLES;
    // Name, maker, pipeline, whether bodies touch themselves, and the dissertation's figures.
    let rows: [(&str, Make, Pipeline, bool, Option<Published>); 8] = [
        (
            "BART64",
            || interpenetrating(64),
            triangles,
            false,
            published(both(2.6, 1.6), both(3.1, 1.6), 807.996),
        ),
        (
            "BART256",
            || interpenetrating(256),
            triangles,
            false,
            published(both(3.4, 3.5), both(3.6, 3.1), 9.15953e3),
        ),
        (
            "BART1024",
            || interpenetrating(1024),
            triangles,
            false,
            published(both(8.4, 19.7), both(7.5, 14.7), 127.394e3),
        ),
        (
            "BART4096",
            || interpenetrating(4096),
            triangles,
            false,
            published(both(51.3, 169.9), both(47.6, 173.4), 2.15626e6),
        ),
        (
            "funnel",
            || funnel(87),
            triangles,
            true,
            published(both(17.4, 48.2), both(16.3, 49.0), 493.391e3),
        ),
        (
            "cloth on ball",
            || cloth_on_ball(152),
            triangles,
            true,
            published(both(77.3, 225.7), both(68.6, 238.3), 2.48204e6),
        ),
        (
            "N-body",
            || n_body(285, 17),
            triangles,
            false,
            published([None, Some(1172.2)], [None, Some(1269.5)], 18.3137e6),
        ),
        ("funnel, features", || funnel(87), Pipeline::Features, true, None),
    ];
    let mut scenes = Vec::new();
    for (name, make, pipeline, self_contact, published) in rows {
        if !wanted(name) {
            continue;
        }
        let scene = make();
        let frames = (0..n_frames).map(|i| scene.frame(i)).collect();
        let bodies = (!self_contact).then(|| Bodies::new(&scene.body, &[], false));
        scenes.push(Scene::new(name, scene.mesh, pipeline, bodies, frames, published)?);
    }
    if wanted(DEBRIS) {
        match debris(n_frames) {
            Ok(scene) => scenes.push(scene),
            Err(why) => println!("without {DEBRIS}: {why}"),
        }
    }
    Ok(scenes)
}

const DEBRIS: &str = "debris-wall, features";

/// Debris that falls against a wall, from the test data.
fn debris(n_frames: usize) -> Result<Scene, String> {
    let dir = data_dir()?.join("scenes/debris-wall/frames");
    let read = |i: usize| {
        let path = dir.join(format!("{:03}.ply", 40 + i));
        ccd::io::read_frame(&path).map_err(|e| e.to_string())
    };
    let frames = (0..n_frames.min(60)).map(read).collect::<Result<Vec<_>, _>>()?;
    let mesh = frames[0].mesh().map_err(|e| e.to_string())?;
    let frames = frames.into_iter().map(|frame| frame.positions).collect();
    Scene::new(DEBRIS, mesh, Pipeline::Features, None, frames, None)
}

impl Scene {
    fn new(
        name: &str,
        mesh: Mesh,
        pipeline: Pipeline,
        bodies: Option<Bodies>,
        frames: Vec<Vec<[f64; 3]>>,
        published: Option<Published>,
    ) -> Result<Self, String> {
        let (name, counts) = (name.to_owned(), Vec::new());
        let mut scene = Self { name, mesh, pipeline, bodies, frames, counts, published };
        let options = scene.options().with_threads(0);
        let mut session = Session::new(scene.mesh.clone(), options)
            .map_err(|e| format!("{}: {e}", scene.name))?;
        for x in scene.frames.windows(2) {
            let report = session.step(&x[0], &x[1]).map_err(|e| e.to_string())?;
            scene.counts.push(Counts::of(report));
        }
        if scene.counts.windows(2).all(|two| two[0] == two[1]) {
            return Err(format!("{}: all steps have the same pairs", scene.name));
        }
        Ok(scene)
    }

    /// The same by pairs of features.
    pub fn by_features(&self) -> Result<Self, String> {
        let (mesh, frames) = (self.mesh.clone(), self.frames.clone());
        Self::new(&self.name, mesh, Pipeline::Features, self.bodies.clone(), frames, None)
    }

    /// What every session of the scene has.
    pub fn options(&self) -> Options {
        Options::default().with_pipeline(self.pipeline).with_bodies(self.bodies.clone())
    }

    /// A line above a table.
    pub fn title(&self) -> String {
        let counts = &self.counts[self.counts.len() / 2];
        let (what, n) = match counts.triangles {
            Some(n) => ("pairs of triangles", n),
            None => ("candidates", counts.candidates.total()),
        };
        format!("**{}**: {} triangles, {n} {what}", self.name, self.mesh.faces().len())
    }
}
