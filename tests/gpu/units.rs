//! Numbers that a device may flush to zero, in kernels and in sessions. That no unit of coordinates
//! decides anything is in the conformance table.

use crate::queries::decide;
use ccd::gpu::{Device, Session};
use ccd::{Contact, Kind, Mesh, Options, State, Verdict, VertexFace};

/// Tests of sessions.
pub const TESTS: crate::Tests = &[("units_flushed", check_flushed)];

/// A face at rest and a vertex that moves, or does not, in multiples of a unit.
struct Case {
    v: [[f64; 3]; 2],
    face: [[f64; 3]; 3],
    min_distance: f64,
}

/// Whose differences are denormals, or whose coordinates are, or whose distance is.
fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (shift, times) in [(0.0, 1.0), (100.0, 1.0), (0.0, 1024.0), (0.0, 2f64.powi(36))] {
        let at = |p: [f64; 3]| [p[0] + shift, p[1] * times + shift, p[2] * times];
        let v = [at([0.9375, 2.0, 4.0]), at([0.9375, 2.0, -4.0])];
        let face = [[0.0; 3], [4.0, 0.0, 0.0], [1.0, 4.0, 0.0]].map(at);
        cases.push(Case { v, face, min_distance: 0.0 });
    }
    let face = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    cases.push(Case { v: [[1.0; 3]; 2], face, min_distance: 1.0 / 64.0 });
    cases
}

/// What the kernels make of numbers as they are, and what sessions do, in which something else is
/// far away or not: no certain contact is missed or late, and none is made up.
fn check_flushed(device: &Device) {
    for (case, e) in cases().iter().flat_map(|case| [-126, -122].map(|e| (case, e))) {
        let in_unit = |p: [f64; 3]| p.map(|c| c * 2f64.powi(e));
        let end = |i: usize| [case.v[i], case.face[0], case.face[1], case.face[2]].map(in_unit);
        let (t0, t1) = (end(0), end(1));
        let min_distance = case.min_distance * 2f64.powi(e);
        let want = ccd::vertex_face(&VertexFace { t0, t1 }, min_distance);
        let what = format!("2^{e}, {t0:?} to {t1:?}, distance {min_distance:e}: {want:?}");
        let check = |got: Verdict<f64>| match (want, got) {
            (Verdict::Hit { toi }, got) => {
                assert!(got.toi().is_some_and(|t| t <= toi + 1e-6), "{what}, but {got:?}")
            }
            (_, got) => assert!(!matches!(got, Verdict::Hit { .. }), "{what}, but {got:?}"),
        };
        check(decide(device, true, &[(t0, t1)], min_distance)[0]);
        for far in [2f64.powi(e), 1.0] {
            // The vertex is a corner of a face whose other corners are elsewhere.
            let other = [[-8.0 * far, -8.0 * far, 0.0], [-8.0 * far, -9.0 * far, 0.0]];
            let all = |t: [[f64; 3]; 4]| -> Vec<[f32; 3]> {
                t.iter().chain(&other).map(|p| p.map(|c| c as f32)).collect()
            };
            let mesh = Mesh::new(6, &[[1, 2, 3], [0, 4, 5]]).expect("a mesh");
            let options = Options::default().with_min_distance(min_distance).with_threads(1);
            let mut session = Session::new(device, mesh, options).expect("a session");
            let found = &session.step(&all(t0), &all(t1)).expect("a step").contacts;
            let of = |c: &&Contact| (c.kind, c.a, c.b) == (Kind::VertexFace, 0, 0);
            check(match found.iter().find(of) {
                None => Verdict::Miss,
                Some(c) if c.state == State::Hit => Verdict::Hit { toi: c.toi },
                Some(c) => Verdict::Undecided { toi: c.toi },
            });
        }
    }
}
