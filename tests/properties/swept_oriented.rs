//! Oriented boxes of moving features, against what the narrow phase finds: boxes of features that
//! touch are never apart, and many are whose boxes along the axes overlap.

use ccd::{Kind, Mesh, Options, Session};
use ccd_core::math::obb::Obb;
use ccd_testkit::generate::{Step, crumpled_sheet, triangle_soup};

/// The boxes of the two features of a pair over a step.
fn boxes(mesh: &Mesh, step: &Step, kind: Kind, a: u32, b: u32) -> [Obb<f64>; 2] {
    let path = |v: u32| [step.x0[v as usize], step.x1[v as usize]];
    let edge = |e: u32| {
        let [p, q] = mesh.edges()[e as usize].map(path);
        Obb::of_moving_edge(&[p[0], q[0]], &[p[1], q[1]])
    };
    match kind {
        Kind::VertexFace => {
            let [p, q, r] = mesh.faces()[b as usize].map(path);
            let face = Obb::of_moving_triangle(&[p[0], q[0], r[0]], &[p[1], q[1], r[1]]);
            [Obb::around(&path(a)), face]
        }
        _ => [edge(a), edge(b)],
    }
}

fn check_step(step: &Step) -> [usize; 2] {
    let mesh = &step.mesh;
    let mut session = Session::new(mesh.clone(), Options::default()).unwrap();
    let report = session.step(&step.x0, &step.x1).unwrap().clone();
    let mut n_control = 0;
    for c in &report.contacts {
        let [a, b] = boxes(mesh, step, c.kind, c.a, c.b);
        assert!(!a.separated(&b), "{c:?}: {a:?} {b:?}");
        let smaller = |b: Obb<f64>| Obb { half: b.half.map(|h| 0.5 * h), ..b };
        n_control += smaller(a).separated(&smaller(b)) as usize;
    }
    assert!(n_control > 0, "{} contacts", report.contacts.len());
    let listed = session.candidates(&step.x0, &step.x1).unwrap();
    let of_kind = [(Kind::VertexFace, listed.vf), (Kind::EdgeEdge, listed.ee)];
    of_kind.map(|(kind, pairs)| {
        let apart = pairs.iter().filter(|pair| {
            let [a, b] = boxes(mesh, step, kind, pair.a, pair.b);
            a.separated(&b)
        });
        let n = apart.count();
        println!("{kind:?}: {n} of {} candidates told apart", pairs.len());
        assert!(4 * n > pairs.len(), "{kind:?}: {n} of {}", pairs.len());
        n
    })
}

#[test]
fn boxes_of_features_that_touch_are_not_apart() {
    for seed in 0..4 {
        for step in [crumpled_sheet(24, seed), triangle_soup(300, 0.15, seed)] {
            assert!(check_step(&step).iter().all(|&n| n > 0));
        }
    }
}
