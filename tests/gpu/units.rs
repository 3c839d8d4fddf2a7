//! The unit of the coordinates decides nothing on a device either: also where `f32` has no such
//! numbers.

use crate::queries::decide;
use ccd::gpu::{Device, Session};
use ccd::{Contact, Coordinate, Kind, Mesh, Options, State, Verdict, VertexFace};
use ccd_testkit::generate;
use std::collections::BTreeSet;

/// Tests of sessions.
pub const TESTS: crate::Tests = &[("units", check_units), ("units_flushed", check_flushed)];

type Keys = BTreeSet<(Kind, u32, u32)>;

fn keys<'a>(contacts: impl Iterator<Item = &'a Contact>) -> Keys {
    contacts.map(|c| (c.kind, c.a, c.b)).collect()
}

/// A step on the device has the candidates of the CPU, every certain contact of it, and its
/// earliest time.
fn check_scale<T: Coordinate>(device: &Device, scale: f64, min_distance: f64) {
    let step = generate::triangle_soup(150, 0.3, 5);
    let at = |x: &[[f64; 3]]| -> Vec<[T; 3]> {
        x.iter().map(|p| p.map(|c| T::from_f64((c + 0.25) * scale))).collect()
    };
    let (x0, x1) = (at(&step.x0), at(&step.x1));
    let options = Options::default().with_min_distance(min_distance * scale).with_threads(1);
    let mut cpu = ccd::Session::new(step.mesh.clone(), options.clone()).expect("a session");
    let mut gpu = Session::new(device, step.mesh.clone(), options).expect("a session");
    let want = cpu.step(&x0, &x1).expect("a step").clone();
    let got = gpu.step(&x0, &x1).expect("a step").clone();
    let what = format!("scale {scale:e}, distance {min_distance}");
    let sure = |c: &&Contact| c.state == State::Hit;
    let (want_keys, got_keys) =
        (keys(want.contacts.iter().filter(sure)), keys(got.contacts.iter()));
    assert!(want_keys.len() > 100, "{what}: {} contacts show nothing", want_keys.len());
    let missed: Vec<_> = want_keys.difference(&got_keys).collect();
    assert!(missed.is_empty(), "{what}: {} missed, {:?} ..", missed.len(), missed.first());
    let (n, most) = (got_keys.len(), keys(want.contacts.iter()).len() + 2);
    assert!(n <= most, "{what}: {n} contacts");
    let earliest = gpu.earliest_toi(&x0, &x1).expect("a step");
    let (a, b) = (want.toi.expect("a contact"), earliest.expect("a contact"));
    assert!((a - b).abs() < 2e-6, "{what}: earliest {b}, {a} on the CPU");
}

fn check_units(device: &Device) {
    for min_distance in [0.0, 0.01] {
        for e in [-200, -130, -60, 0, 29, 60, 100, 126, 127, 128, 130, 200, 300] {
            check_scale::<f64>(device, 2f64.powi(e), min_distance);
        }
    }
    for e in [-118, -80, -60, 0, 28, 40, 100, 124] {
        check_scale::<f32>(device, 2f64.powi(e), 0.0);
    }
    check_scale::<f32>(device, 2f64.powi(-118), 0.01);
}

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
        if min_distance == 0.0 {
            check(decide(device, true, &[(t0, t1)])[0]);
        }
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
