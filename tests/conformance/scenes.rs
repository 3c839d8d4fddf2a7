//! The scenes of the table, and what is right of them.

use ccd::method::BroadPhaseMethod;
use ccd::scenes::{Random, Step, crumpled_sheet, debris_boxes, triangle_soup, uniform_boxes};
use ccd::{Aabb, Contact, Digest, Mode, Options};
use ccd_core::reference;
use ccd_testkit::compare::{agree, recorded_step};
use ccd_testkit::{brute, data};
use std::sync::{Arc, OnceLock};

/// Boxes within which pairs are looked for, and two sets between which they are.
pub struct Boxes {
    pub within: Vec<Aabb<f32>>,
    pub between: [Vec<Aabb<f32>>; 2],
    /// What is right of both.
    pub want: [Digest; 2],
}

/// A step and what is right of it.
pub struct Motion {
    pub step: Step,
    pub want: Want,
}

pub enum Want {
    /// Candidates of brute force, and contacts of the sequential step of the core.
    Reference([Digest; 2], Vec<Contact>),
    /// What is recorded of a real scene, the contacts that one thread of the CPU finds with exact
    /// and with conservative times, and the published answers, where there are any.
    Recorded(String, [Vec<Contact>; 2], Option<[Vec<data::Truth>; 2]>),
}

/// What is loaded once for all rows of a scene.
#[derive(Default)]
pub struct Loaded {
    pub boxes: OnceLock<Boxes>,
    pub motion: OnceLock<Motion>,
}

/// Where a scene comes from.
#[derive(Clone, Copy)]
pub enum Source {
    Boxes(fn() -> Vec<Aabb<f32>>),
    Step(fn() -> Step),
    Real(&'static data::Scene),
}

pub const GENERATED: [(&str, Source); 9] = [
    ("uniform", Source::Boxes(|| uniform_boxes(20_000))),
    ("debris", Source::Boxes(debris_boxes)),
    ("crowded", Source::Boxes(|| inflated(&uniform_boxes(2000), 0.05))),
    ("equal", Source::Boxes(|| vec![Aabb { min: [0.5; 3], max: [0.5; 3] }; 300])),
    ("huge", Source::Boxes(huge)),
    ("one", Source::Boxes(|| uniform_boxes(1))),
    ("none", Source::Boxes(Vec::new)),
    ("sheet", Source::Step(|| crumpled_sheet(24, 1))),
    ("soup", Source::Step(|| triangle_soup(300, 0.15, 2))),
];

fn inflated(boxes: &[Aabb<f32>], by: f32) -> Vec<Aabb<f32>> {
    let grown = |b: &Aabb<f32>| Aabb { min: b.min.map(|c| c - by), max: b.max.map(|c| c + by) };
    boxes.iter().map(grown).collect()
}

/// Boxes whose extent is near the greatest `f32`.
fn huge() -> Vec<Aabb<f32>> {
    let mut random = Random::new(3);
    let mut make = || {
        let p = random.point().map(|c| (c as f32 - 0.5) * 3.4e38);
        Aabb { min: p, max: p.map(|c| c + 4e37) }
    };
    (0..200).map(|_| make()).collect()
}

pub fn load_boxes(source: Source) -> Boxes {
    let (within, between) = match source {
        Source::Boxes(make) => {
            let all = make();
            let (a, b) = all.split_at(all.len() / 3);
            let between = [a.to_vec(), b.to_vec()];
            (all, between)
        }
        Source::Step(make) => {
            let step = make();
            let [x0, x1] = step.rounded();
            let [v, e, f] = brute::swept_boxes(&step.mesh, &x0, &x1);
            (e, [v, f])
        }
        Source::Real(scene) => {
            let step = load_step(scene);
            let boxes = brute::swept_boxes(&step.mesh, &step.x0, &step.x1);
            let [v, e, f] = boxes.map(|set| set.iter().map(|b| b.round_out()).collect());
            (e, [v, f])
        }
    };
    let [a, b] = &between;
    let want = if within.len() <= MAX_BRUTE {
        [brute::self_pairs(&within), brute::pairs(a, b)]
            .map(|pairs| Digest::of(0, pairs.into_iter()))
    } else {
        let mut one = ccd::BroadPhase::new(1, BroadPhaseMethod::Blocks).expect("one thread");
        let within = Digest::of(0, one.self_pairs(&within).expect("valid boxes").iter());
        [within, Digest::of(0, one.pairs(a, b).expect("valid boxes").iter())]
    };
    Boxes { within, between, want }
}

/// So many boxes are still tested each against each: 4e8 tests take half a second.
const MAX_BRUTE: usize = 20_000;

fn load_step(scene: &data::Scene) -> Step {
    let dir = data::data_dir().expect("the row is ignored without the data");
    let [t0, t1] = scene.load(&dir);
    let mesh = t0.mesh().expect("a valid mesh");
    Step { mesh, x0: t0.positions, x1: t1.positions }
}

pub fn load_motion(source: Source) -> Motion {
    match source {
        Source::Real(scene) => {
            let step = load_step(scene);
            let by_mode = [Mode::Exact, Mode::Conservative].map(|mode| {
                let options = Options::default().with_threads(1).with_mode(mode);
                let report = ccd::step(&step.mesh, &step.x0, &step.x1, &options);
                report.expect("a valid step").contacts
            });
            let dir = data::data_dir().expect("the row is ignored without the data");
            let truth = scene.truth.map(|_| ["vf", "ee"].map(|kind| scene.contacts(&dir, kind)));
            let want = Want::Recorded(recorded_step(scene.name), by_mode, truth);
            Motion { step, want }
        }
        Source::Step(make) => {
            let step = make();
            let candidates = brute::candidates(&step.mesh, &step.x0, &step.x1);
            // What backends are compared with, itself compared with every pair asked for.
            let mesh = Arc::new(step.mesh.clone());
            let report =
                reference::step(&mesh, &step.x0, &step.x1, &Options::default()).expect("a step");
            let every = brute::contacts(&step.mesh, &step.x0, &step.x1);
            assert_eq!(agree(&every, &report.contacts), Ok(()));
            let n = candidates.each_ref().map(|pairs| pairs.len() as u64);
            assert_eq!([report.candidates.vf, report.candidates.ee], n);
            let digests = candidates.map(|pairs| Digest::of(0, pairs.into_iter()));
            Motion { step, want: Want::Reference(digests, report.contacts) }
        }
        Source::Boxes(_) => panic!("boxes do not move"),
    }
}
