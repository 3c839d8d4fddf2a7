//! Whole steps and sessions against each other, and endless boxes against brute force.

use ccd::{Aabb, BroadPhase, Options, Session};
use ccd_testkit::brute;
use ccd_testkit::generate::{Random, crumpled_sheet, triangle_soup, uniform_boxes};

#[test]
fn f32_input_gives_what_its_exact_widening_gives() {
    let step = triangle_soup(400, 0.12, 9);
    let wide = |x: &[[f32; 3]]| x.iter().map(|p| p.map(f64::from)).collect::<Vec<_>>();
    let [x0, x1] = step.rounded();
    let single = ccd::step(&step.mesh, &x0, &x1, &Options::default()).unwrap();
    let double = ccd::step(&step.mesh, &wide(&x0), &wide(&x1), &Options::default()).unwrap();
    assert_eq!((single.contacts, single.candidates), (double.contacts, double.candidates));
}

/// Boxes without an end; all others are in the conformance table.
#[test]
fn endless_boxes_overlap_everything() {
    let boxes = uniform_boxes(500);
    let endless = [Aabb { min: [f32::NEG_INFINITY; 3], max: [f32::INFINITY; 3] }; 3];
    for method in ccd::every("cpu") {
        let mut broad = BroadPhase::new(2, method).unwrap();
        assert_eq!(broad.self_pairs(&endless).unwrap().len(), 3, "{method:?}");
        let mut found = broad.pairs(&endless, &boxes).unwrap().to_vec();
        found.sort_unstable();
        assert_eq!(found, brute::pairs(&endless, &boxes), "{method:?}");
    }
}

#[test]
fn sessions_follow_motion_and_distance() {
    let step = crumpled_sheet(40, 5);
    let mut session = Session::new(
        step.mesh.clone(),
        Options::default().with_min_distance(0.004).with_threads(2),
    )
    .unwrap();
    let mut x0 = step.x0.clone();
    let mut random = Random::new(8);
    let mut modes = [0, 0];
    for _ in 0..12 {
        let x1: Vec<_> = x0.iter().map(|p| p.map(|c| c + 0.01 * (random.unit() - 0.5))).collect();
        let kept = session.step(&x0, &x1).unwrap().clone();
        let fresh = ccd::step(&step.mesh, &x0, &x1, session.options()).unwrap();
        assert_eq!((&kept.contacts, kept.candidates), (&fresh.contacts, fresh.candidates));
        modes[kept.rebuilt as usize] += 1;
        x0 = x1;
    }
    assert!(modes[0] > 0 && modes[1] > 0, "refits and builds: {modes:?}");
}
