//! Sequences on which schedulers are compared: those of [da Silva 2013], chapter 4, as far as they
//! can be made again, and one that was simulated.

use ccd::method::Pipeline;
use ccd::scenes::{Sequence, cloth_on_ball, funnel, interpenetrating, n_body};
use ccd::{Bodies, Mesh, Options, PerKind, Session};
use ccd_testkit::data::data_dir;

/// Figures of the dissertation for a scene; NaN where it has none.
#[derive(Clone, Copy, Debug)]
pub struct Published {
    /// Milliseconds a frame by lazy work stealing on a GTS 450 and a GT 520, table 4.1.
    pub lazy: [f64; 2],
    /// The same by gProximity, table 4.4.
    pub gproximity: [f64; 2],
    /// Front nodes a frame, table 4.3.
    pub front: f64,
}

/// A scene of the dissertation: its name, its maker, whether bodies touch themselves, and
/// milliseconds by lazy work stealing and by gProximity, then front nodes.
type Row = (&'static str, fn() -> Sequence, bool, [f64; 2], [f64; 2], f64);

const DISSERTATION: [Row; 7] = [
    ("BART64", || interpenetrating(64), false, [2.6, 1.6], [3.1, 1.6], 807.996),
    ("BART256", || interpenetrating(256), false, [3.4, 3.5], [3.6, 3.1], 9.15953e3),
    ("BART1024", || interpenetrating(1024), false, [8.4, 19.7], [7.5, 14.7], 127.394e3),
    ("BART4096", || interpenetrating(4096), false, [51.3, 169.9], [47.6, 173.4], 2.15626e6),
    ("funnel", || funnel(87), true, [17.4, 48.2], [16.3, 49.0], 493.391e3),
    ("cloth on ball", || cloth_on_ball(152), true, [77.3, 225.7], [68.6, 238.3], 2.48204e6),
    ("N-body", || n_body(285, 17), false, [f64::NAN, 1172.2], [f64::NAN, 1269.5], 18.3137e6),
];
const FUNNEL: &str = "funnel, features";
const DEBRIS: &str = "debris-wall, features";

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

/// Numbers of pairs, the same by every scheduler.
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

/// The seven of the dissertation by pairs of triangles, and two by pairs of features, which is the
/// default of a session. `n_frames`: frames of each.
pub fn all(wanted: &dyn Fn(&str) -> bool, n_frames: usize) -> Result<Vec<Scene>, String> {
    let frames = |scene: &Sequence| (0..n_frames).map(|i| scene.frame(i)).collect();
    let mut scenes = Vec::new();
    for (name, make, self_contact, lazy, gproximity, front) in DISSERTATION {
        if wanted(name) {
            let scene = make();
            let bodies =
                (!self_contact).then(|| Bodies::new(&scene.body).with_self_contacts(false));
            let published = Some(Published { lazy, gproximity, front });
            let (frames, pipeline) = (frames(&scene), Pipeline::TRIANGLES);
            scenes.push(Scene::new(name, scene.mesh, pipeline, bodies, frames, published)?);
        }
    }
    if wanted(FUNNEL) {
        let (scene, pipeline) = (funnel(87), Pipeline::Features);
        let frames = frames(&scene);
        scenes.push(Scene::new(FUNNEL, scene.mesh, pipeline, None, frames, None)?);
    }
    if wanted(DEBRIS) {
        match debris(n_frames) {
            Ok(scene) => scenes.push(scene),
            Err(why) => println!("without {DEBRIS}: {why}"),
        }
    }
    Ok(scenes)
}

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

    /// Options of every session of the scene.
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
