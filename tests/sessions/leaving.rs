//! Steps that leave contacts at their start, windows of a step, step sizes and tolerances, over
//! whole meshes.

use ccd::scenes::triangle_soup;
use ccd::{Approach, Error, Mesh, Options, Report, Session, State, scaled_toi};

type Positions = Vec<[f64; 3]>;

/// Pairs of triangles at a gap of 0.01, far from each other, of which the upper one goes: up,
/// down, and up with a corner of the lower one that follows and overtakes it.
fn stacks() -> (Mesh, Positions, Positions) {
    let (mut x0, mut x1) = (Vec::new(), Vec::new());
    for i in 0..3 {
        let place = |p: [f64; 3]| [p[0] + 4.0 * i as f64, p[1], p[2]];
        let up = [1.0, -1.0, 1.0][i];
        // Below, seen from its side: the last corner is far from the other triangle.
        let below = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, 0.0, -1.0]];
        for (k, p) in below.into_iter().enumerate() {
            let follows = if i == 2 && k == 2 { [0.5, 0.0, 6.0] } else { p };
            x0.push(place(p));
            x1.push(place(follows));
        }
        for p in [[0.25, -1.0, 0.01], [0.75, -1.0, 0.01], [0.5, 1.0, 0.01]] {
            x0.push(place(p));
            x1.push(place([p[0], p[1], p[2] + up]));
        }
    }
    let faces: Vec<[u32; 3]> = (0..6u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    (Mesh::new(18, &faces).expect("a valid mesh"), x0, x1)
}

/// The stack that a contact's first feature is of.
fn stack_of(mesh: &Mesh, c: &ccd::Contact) -> u32 {
    match c.kind {
        ccd::Kind::VertexFace => c.a / 6,
        _ => mesh.edges()[c.a as usize][0] / 6,
    }
}

fn session(mesh: &Mesh, options: Options) -> Session {
    Session::new(mesh.clone(), options.with_threads(1)).expect("valid options")
}

#[test]
fn contacts_at_the_start_are_left_where_they_separate() {
    let (mesh, x0, x1) = &stacks();
    let near = Options::default().with_min_distance(0.02);
    let mut stays = session(mesh, near.clone());
    let report = stays.step(x0, x1).unwrap().clone();
    let report = &report;
    let at_start = |report: &Report, stack: u32, approach: Approach| {
        report
            .contacts
            .iter()
            .any(|c| stack_of(mesh, c) == stack && c.toi == 0.0 && c.approach == approach)
    };
    assert!(at_start(report, 0, Approach::Separating), "{:?}", report.contacts);
    assert!(at_start(report, 1, Approach::Approaching), "{:?}", report.contacts);
    assert!(!at_start(report, 1, Approach::Separating), "{:?}", report.contacts);
    assert_eq!(stays.collision_free_step_size(x0, x1).unwrap(), 0.0);

    let mut leaves = session(mesh, near.clone().with_leave_contact(true));
    let report = leaves.step(x0, x1).unwrap();
    let of = |stack: u32| report.contacts.iter().filter(move |c| stack_of(mesh, c) == stack);
    assert_eq!(of(0).count(), 0, "{:?}", report.contacts);
    assert!(of(1).any(|c| c.toi == 0.0 && c.state == State::Hit), "{:?}", report.contacts);
    assert!(of(2).count() > 0 && of(2).all(|c| c.toi > 0.01), "{:?}", report.contacts);

    // Alone, what goes is free, and what is overtaken has a time of impact.
    for (stack, free) in [(0, true), (2, false)] {
        let part = 6 * stack..6 * stack + 6;
        let mesh = Mesh::new(6, &[[0, 1, 2], [3, 4, 5]]).unwrap();
        let (x0, x1) = (&x0[part.clone()], &x1[part]);
        let mut leaves = session(&mesh, near.clone().with_leave_contact(true));
        let size = leaves.collision_free_step_size(x0, x1).unwrap();
        assert_eq!(size == 1.0, free, "{size}");
        assert!(size > 0.01);
        assert_eq!(leaves.earliest_toi(x0, x1).unwrap().unwrap_or(1.0), size);
        assert!(scaled_toi(size, 0.9) < size);
    }
}

/// What a window or a tolerance makes of a query is in the core's tests, that sessions find what
/// queries do in `units.rs` and in `tests/attack`.
#[test]
fn windows_and_tolerances_are_checked() {
    let step = triangle_soup(300, 0.2, 7);
    let mut windowed = session(&step.mesh, Options::default().with_min_distance(0.004));
    let until = windowed.step_until(&step.x0, &step.x1, 0.5).unwrap().contacts.clone();
    let same = &windowed.step_window(&step.x0, &step.x1, [0.0, 0.5]).unwrap().contacts;
    assert!(until == *same && until.len() > 20, "{} contacts", until.len());
    for window in [[-0.1, 1.0], [0.0, 1.1], [0.6, 0.5], [f64::NAN, 1.0], [0.0, f64::NAN]] {
        let error = windowed.step_window(&step.x0, &step.x1, window).unwrap_err();
        assert!(matches!(error, Error::Window { .. }), "{error}");
    }
    for tolerance in [0.0, 1e-13, 1.5, -1.0, f64::NAN] {
        let options = Options::default().with_tolerance(tolerance);
        let error = Session::new(step.mesh.clone(), options).unwrap_err();
        assert!(matches!(error, Error::Tolerance { .. }), "{error}");
    }
}
