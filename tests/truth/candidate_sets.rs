//! Sets of candidates in real scenes: the step sizes of a line search are those of a session.

use ccd::{Kind, Options, Session};
use ccd_testkit::data::Scene;
use std::path::Path;
use std::time::Instant;

/// Each half of the step before, and the answers of a session for the same steps, to the bit where
/// all contacts are certain.
pub fn check(data: &Path, scene: &Scene) {
    let [t0, t1] = scene.load(data);
    let (mesh, x0, x1) = (t0.mesh().unwrap(), &t0.positions, &t1.positions);
    let mut session = Session::new(mesh, Options::default().with_threads(2)).unwrap();
    let mut set = session.candidate_set(x0, x1, 0.0).unwrap();
    if let Some(counts) = scene.candidates {
        let found = [Kind::VertexFace, Kind::EdgeEdge].map(|kind| set.pairs(kind).len() as u64);
        // Rounding is granted, by which boxes overlap that nearly touch.
        for (found, want) in found.into_iter().zip(counts) {
            assert!(found >= want && found <= want + want / 100, "{found} for {want}");
        }
    }
    let mut times = [0.0; 2];
    for halvings in 0..8 {
        let s = 0.5f64.powi(halvings);
        let between = |(p, q): (&[f64; 3], &[f64; 3])| [0, 1, 2].map(|k| p[k] + s * (q[k] - p[k]));
        let end: Vec<[f64; 3]> = x0.iter().zip(x1).map(between).collect();
        let start = Instant::now();
        let want = session.earliest_toi(x0, &end).unwrap();
        times[0] += start.elapsed().as_secs_f64();
        let start = Instant::now();
        let found = set.earliest_toi(x0, &end).unwrap();
        times[1] += start.elapsed().as_secs_f64();
        assert_eq!(found, want, "{s}");
    }
    let [of_session, of_set] = times;
    println!("{}: eight steps, session {of_session:.3} s, set {of_set:.3} s", scene.name);
}
