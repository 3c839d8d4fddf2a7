//! Bad input of sessions is refused with what, where and the value; odd but valid input is handled.

use ccd::method::BroadPhaseMethod;
use ccd::{Aabb, BroadPhase, Error, Mesh, Options, Session, Verdict, VertexFace};

const TRIANGLE: [[f64; 3]; 3] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];

fn session(options: Options) -> Result<Session, Error> {
    Session::new(Mesh::new(3, &[[0, 1, 2]])?, options)
}

#[test]
fn coordinates_must_be_finite() {
    let mut session = session(Options::default()).unwrap();
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200] {
        let mut x1 = TRIANGLE;
        x1[2][1] = bad;
        match session.step(&TRIANGLE, &x1) {
            Err(Error::Coordinate { time: 1, vertex: 2, axis: 1, value }) => {
                assert!(value == bad || bad.is_nan())
            }
            other => panic!("{other:?}"),
        }
        assert!(matches!(session.step(&x1, &TRIANGLE), Err(Error::Coordinate { time: 0, .. })));
    }
    let found = session.step(&TRIANGLE, &TRIANGLE).unwrap();
    assert!(found.contacts.is_empty(), "the session goes on after an error");
    let single = TRIANGLE.map(|p| p.map(|c| c as f32));
    let mut bad = single;
    bad[0][2] = f32::NAN;
    let error = session.step(&single, &bad).unwrap_err();
    assert!(matches!(error, Error::Coordinate { time: 1, vertex: 0, axis: 2, .. }), "{error}");
}

#[test]
fn sizes_indices_and_distances_are_checked() {
    let mut good = session(Options::default()).unwrap();
    assert_eq!(
        good.step(&TRIANGLE[..2], &TRIANGLE).unwrap_err(),
        Error::VertexCount { time: 0, expected: 3, found: 2 }
    );
    for value in [-1.0, f64::NAN, f64::INFINITY] {
        let error = session(Options::default().with_min_distance(value)).unwrap_err();
        assert!(matches!(error, Error::MinDistance { .. }), "{error}");
    }
    let error = session(Options::default().with_threads(100_000)).unwrap_err();
    assert_eq!(error, Error::Threads { count: 100_000, limit: 1024 });
    let mut broad = BroadPhase::new(1, BroadPhaseMethod::Blocks).unwrap();
    let bad =
        [Aabb { min: [0.0f32; 3], max: [1.0; 3] }, Aabb { min: [0.0, 2.0, 0.0], max: [1.0; 3] }];
    assert!(matches!(broad.self_pairs(&bad), Err(Error::Box { at: 1, axis: 1, .. })));
}

#[test]
fn empty_meshes_have_no_contacts() {
    for threads in [1, 2] {
        let of = |n| {
            let options = Options::default().with_threads(threads);
            Session::new(Mesh::new(n, &[]).unwrap(), options).unwrap()
        };
        let (mut session, none): (_, [[f64; 3]; 0]) = (of(0), []);
        assert!(session.step(&none, &none).unwrap().contacts.is_empty());
        assert_eq!(session.earliest_toi(&none, &none).unwrap(), None);
        let mut points = of(5);
        // Five particles, each in a place of its own.
        let at = |y: f64| [0.0, 1.0, 2.0, 3.0, 4.0].map(|x| [x, y, 0.0]);
        assert!(points.step(&at(0.0), &at(1.0)).unwrap().contacts.is_empty());
    }
}

#[test]
fn degenerate_features_are_closed_sets() {
    // A vertex that falls onto a face of no area, onto its line, and beside it.
    let needle = |x: f64| VertexFace {
        t0: [[x, 1.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]],
        t1: [[x, -1.0, 0.0], [0.0; 3], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]],
    };
    let toi = ccd::vertex_face(&needle(1.5), 0.0).toi().unwrap();
    assert!(toi <= 0.5 && toi > 0.5 - 1e-6, "{toi}");
    assert_eq!(ccd::vertex_face(&needle(2.5), 0.0), Verdict::Miss);
    // All points in one place.
    let point = VertexFace { t0: [[1.0; 3]; 4], t1: [[1.0; 3]; 4] };
    assert_eq!(ccd::vertex_face(&point, 0.0).toi(), Some(0.0));
    let mesh = Mesh::new(7, &[[0, 1, 1], [2, 2, 2], [4, 5, 6]]).unwrap();
    assert_eq!((mesh.n_degenerate(), mesh.edges().len()), (2, 4));
    let report = ccd::step(&mesh, &[[0.5f64; 3]; 7], &[[0.5; 3]; 7], &Options::default()).unwrap();
    assert_eq!(report.toi, Some(0.0));
}
