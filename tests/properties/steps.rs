//! Whole steps, sessions and the broad phase, against brute force and against each other.

use ccd::{Aabb, Bodies, BroadPhase, Contact, Kind, Options, Session, State};
use ccd_testkit::brute;
use ccd_testkit::compare::agree;
use ccd_testkit::generate::{Random, crumpled_sheet, triangle_soup, uniform_boxes};

/// How many contacts are certain.
fn n_certain(contacts: &[Contact]) -> usize {
    contacts.iter().filter(|c| c.state == State::Hit).count()
}

#[test]
fn steps_equal_brute_force() {
    for seed in 0..6 {
        for step in [crumpled_sheet(24, seed), triangle_soup(300, 0.15, seed)] {
            let report =
                ccd::step(&step.mesh, &step.x0, &step.x1, &Options::default().with_threads(2))
                    .unwrap();
            let want = brute::contacts(&step.mesh, &step.x0, &step.x1);
            assert!(want.len() > 20, "seed {seed}: only {} contacts", want.len());
            // What the f32 filters reject may be undecided in f64: certain contacts must be equal,
            // the others a subset.
            agree(&want, &report.contacts).unwrap_or_else(|e| panic!("seed {seed}: {e}"));
            assert_eq!(n_certain(&report.contacts), n_certain(&want), "seed {seed}");
            let key = |c: &Contact| (c.kind, c.a, c.b, c.state);
            let all: Vec<_> = want.iter().map(key).collect();
            assert!(report.contacts.iter().all(|c| all.contains(&key(c))), "seed {seed}");
            let earliest =
                ccd::earliest_toi(&step.mesh, &step.x0, &step.x1, &Options::default()).unwrap();
            assert_eq!(earliest, report.toi, "seed {seed}");
        }
    }
}

#[test]
fn f32_input_gives_what_its_exact_widening_gives() {
    let step = triangle_soup(400, 0.12, 9);
    let narrow = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>();
    let wide = |x: &[[f32; 3]]| x.iter().map(|p| p.map(f64::from)).collect::<Vec<_>>();
    let (x0, x1) = (narrow(&step.x0), narrow(&step.x1));
    let single = ccd::step(&step.mesh, &x0, &x1, &Options::default()).unwrap();
    let double = ccd::step(&step.mesh, &wide(&x0), &wide(&x1), &Options::default()).unwrap();
    assert_eq!((single.contacts, single.candidates), (double.contacts, double.candidates));
}

#[test]
fn far_from_the_origin_and_at_any_scale() {
    let step = triangle_soup(200, 0.15, 4);
    for scale in [1e-60, 1e-30, 1e-12, 1.0, 1e12, 1e30, 1e60] {
        let scaled = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c * scale)).collect::<Vec<_>>();
        let (x0, x1) = (scaled(&step.x0), scaled(&step.x1));
        let report = ccd::step(&step.mesh, &x0, &x1, &Options::default()).unwrap();
        let hits = n_certain(&report.contacts);
        let want = n_certain(&brute::contacts(&step.mesh, &x0, &x1));
        assert_eq!((hits, hits > 10), (want, true), "scale {scale}");
        if !(1e-30..=1e30).contains(&scale) {
            continue;
        }
        let narrow = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>();
        let single =
            ccd::step(&step.mesh, &narrow(&x0), &narrow(&x1), &Options::default()).unwrap();
        assert!(single.contacts.len() > 10, "scale {scale} in f32");
    }
    let far = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c + 1e6)).collect::<Vec<_>>();
    let (x0, x1) = (far(&step.x0), far(&step.x1));
    let report = ccd::step(&step.mesh, &x0, &x1, &Options::default()).unwrap();
    let want = brute::contacts(&step.mesh, &x0, &x1);
    assert_eq!(n_certain(&report.contacts), n_certain(&want));
}

#[test]
fn broad_phase_equals_brute_force_on_uniform_and_equal_boxes() {
    let mut random = Random::new(3);
    let mut boxes = uniform_boxes(2000);
    boxes.iter_mut().for_each(|b| b.max = b.max.map(|c| c + 0.05));
    let equal = vec![Aabb { min: [0.5f32; 3], max: [0.5; 3] }; 300];
    let huge: Vec<Aabb<f32>> = (0..200)
        .map(|_| {
            let p = random.point().map(|c| (c as f32 - 0.5) * 1e38);
            Aabb { min: p, max: p.map(|c| c + 2e37) }
        })
        .collect();
    let endless = [Aabb { min: [f32::NEG_INFINITY; 3], max: [f32::INFINITY; 3] }; 3];
    for set in [&boxes[..], &equal[..], &huge[..], &boxes[..1], &endless[..], &[]] {
        for method in ccd::every("cpu") {
            let mut broad = BroadPhase::new(2, method).unwrap();
            let mut got = broad.self_pairs(set).unwrap().to_vec();
            got.sort_unstable();
            assert_eq!(got, brute::self_pairs(set), "{method:?}, {} boxes", set.len());
            let mut got = broad.pairs(set, &boxes[..500]).unwrap().to_vec();
            got.sort_unstable();
            assert_eq!(
                got,
                brute::pairs(set, &boxes[..500]),
                "{method:?}, {} boxes against 500",
                set.len()
            );
        }
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

#[test]
fn fixed_bodies_do_not_touch_each_other() {
    let step = triangle_soup(200, 0.2, 11);
    let body: Vec<u32> = (0..600).map(|v| v / 3).collect();
    let fixed: Vec<bool> = (0..200).map(|b| b % 2 == 0).collect();
    let options =
        Options::default().with_bodies(Bodies::new(&body, &fixed, true).with_fixed_motion(true));
    let report = ccd::step(&step.mesh, &step.x0, &step.x1, &options).unwrap();
    let all = ccd::step(&step.mesh, &step.x0, &step.x1, &Options::default()).unwrap();
    let edge_body = |e: u32| body[step.mesh.edges()[e as usize][0] as usize];
    let bodies_of = |c: &Contact| match c.kind {
        Kind::VertexFace => (body[c.a as usize], c.b),
        _ => (edge_body(c.a), edge_body(c.b)),
    };
    let both_fixed = |c: &&Contact| {
        let (a, b) = bodies_of(c);
        fixed[a as usize] && fixed[b as usize]
    };
    let want: Vec<_> = all.contacts.iter().filter(|c| !both_fixed(c)).copied().collect();
    assert_eq!(report.contacts, want);
    assert!(want.len() < all.contacts.len());
}
