//! Steps that keep the order of boxes find what single steps find, and sort when they must.

use crate::emulated::is_thin;
use crate::scenes::{check_candidates, check_earliest, check_reports};
use ccd::Options;
use ccd::gpu::{Device, Session};
use ccd::method::{BroadPhaseMethod, Pipeline, Traversal, TreeOptions, TriangleOptions};
use ccd_testkit::generate;

pub const TESTS: crate::Tests = &[
    ("order_is_kept", check_kept),
    ("order_of_small_meshes", check_small),
    ("order_after_changes", check_changes),
];

/// What a step is asked for.
#[derive(Clone, Copy)]
enum Ask {
    Contacts,
    Earliest,
    Candidates,
}

/// Asks for a step, compares it with the CPU's, and says whether boxes were sorted.
fn ask(session: &mut Session, ask: Ask, x0: &[[f64; 3]], x1: &[[f64; 3]]) -> bool {
    let (mesh, options) = (session.mesh().clone(), session.options().clone());
    match ask {
        Ask::Contacts => {
            let want = ccd::step(&mesh, x0, x1, &options).unwrap();
            check_reports(&want, session.step(x0, x1).unwrap(), false);
        }
        Ask::Earliest => {
            let want = ccd::step(&mesh, x0, x1, &options).unwrap().toi;
            check_earliest(session, x0, x1, want);
        }
        Ask::Candidates => check_candidates(session, x0, x1),
    }
    session.report().rebuilt
}

/// Spheres that fly through each other: the order lasts for some steps and is as good as none after
/// many. Every goal, so that each one follows every other.
fn check_kept(device: &Device) {
    let scene = ccd::scenes::n_body(48, 10);
    let mut session = Session::new(device, scene.mesh.clone(), Options::default()).unwrap();
    let asks = [Ask::Contacts, Ask::Earliest, Ask::Candidates, Ask::Earliest, Ask::Contacts];
    let mut sorted = Vec::new();
    // Near one another at first; then far from all that was.
    for (i, at) in [0, 1, 2, 60, 120, 121, 180, 240, 300].into_iter().enumerate() {
        let (x0, x1) = (scene.frame(at), scene.frame(at + 1));
        let first = session.grown();
        sorted.push(ask(&mut session, asks[i % asks.len()], &x0, &x1));
        assert!(session.grown() == first || sorted[i], "an order is kept that is not known whole");
    }
    println!("boxes sorted: {sorted:?}");
    assert!(sorted[0] && sorted.contains(&false), "always sorted: {sorted:?}");
    assert!(sorted[3..].contains(&true), "never sorted again: {sorted:?}");
}

/// Meshes of few boxes, whose pairs are as many in any order, and methods that do not count them,
/// sort after some steps; those without an order that lasts, in every step.
fn check_small(device: &Device) {
    let step = generate::crumpled_sheet(6, 3);
    let tree = |t| BroadPhaseMethod::Tree(TreeOptions::default().traversal(t));
    let methods = [
        (BroadPhaseMethod::Blocks, true),
        (tree(Traversal::Half), true),
        (tree(Traversal::CUT), true),
        (BroadPhaseMethod::SweepAndPrune, false),
    ];
    for (broad_phase, lasts) in methods {
        let all = [Pipeline::default(), Pipeline::Triangles(TriangleOptions::default())];
        // On an emulated GPU both by blocks alone.
        let thin = is_thin(device) && broad_phase != BroadPhaseMethod::Blocks;
        for &pipeline in if thin { &all[..1] } else { &all } {
            let options = Options::default().with_broad_phase(broad_phase).with_pipeline(pipeline);
            let mut session = Session::new(device, step.mesh.clone(), options).unwrap();
            // From a place of their own to a common one.
            let x = |i: usize| -> Vec<[f64; 3]> {
                let t = i as f64 / 64.0;
                let ends = step.x0.iter().zip(&step.x1);
                ends.map(|(p, q)| std::array::from_fn(|k| p[k] + t * (q[k] - p[k]))).collect()
            };
            let frames = if lasts { 35 } else { 3 };
            let sorted: Vec<bool> =
                (0..frames).map(|i| ask(&mut session, Ask::Contacts, &x(i), &x(i + 1))).collect();
            let want: Vec<bool> = (0..frames).map(|i| !lasts || i % 33 == 0).collect();
            // A list that grows sorts as well.
            assert!(session.grown() > 0 || sorted == want, "{broad_phase}: {sorted:?}");
        }
    }
}

/// What may leave nothing of an order is followed by a sort.
fn check_changes(device: &Device) {
    let step = generate::crumpled_sheet(8, 5);
    let (x0, x1) = (&step.x0, &step.x1);
    let mut session = Session::new(device, step.mesh.clone(), Options::default()).unwrap();
    let again = |session: &mut Session| ask(session, Ask::Contacts, x0, x1);
    assert_eq!([again(&mut session), again(&mut session)], [true, false]);
    session.reserve(1 << 12).unwrap();
    assert_eq!([again(&mut session), again(&mut session)], [true, false], "after room was made");
    session.move_to(device).unwrap();
    assert_eq!([again(&mut session), again(&mut session)], [true, false], "on another device");
    let mut encoder = device.wgpu().create_command_encoder(&Default::default());
    session.record(&mut encoder).unwrap();
    drop(encoder);
    assert_eq!([again(&mut session), again(&mut session)], [true, false], "after a recording");
    let bad = vec![[f64::NAN; 3]; x0.len()];
    assert!(session.step(&bad, x1).is_err());
    assert!(!again(&mut session), "no frame ran, and an order is lost");
    session.reserve(0).unwrap();
    let grown = session.grown();
    assert!(again(&mut session) && session.grown() > grown, "lists without room did not grow");
}
