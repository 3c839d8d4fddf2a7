//! A session finds the same by every method: candidates, contacts, counts; with bodies and without,
//! frame after frame, on any number of threads.

use ccd_core::backend::layout::Pair;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::catalogue::every;
use ccd_core::model::contact::{Contact, PerKind};
use ccd_core::model::mesh::Mesh;
use ccd_core::model::method::BroadPhaseMethod;
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::{Pipeline, TriangleOptions};
use ccd_cpu::Session;

/// A mesh, its positions frame by frame, and bodies of which some do not move.
struct Scene {
    mesh: Mesh,
    frames: Vec<Vec<[f64; 3]>>,
    bodies: Bodies,
}

/// Random numbers in [0, 1), the same on every machine.
fn random(mut state: u32) -> impl FnMut() -> f64 {
    move || {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (state >> 8) as f64 / 16_777_216.0
    }
}

/// Positions of `n_frames` frames that follow each other: each vertex goes on by up to `speed`,
/// those of fixed bodies do not.
fn frames(
    first: Vec<[f64; 3]>,
    n_frames: usize,
    speed: f64,
    fixed: impl Fn(usize) -> bool,
) -> Vec<Vec<[f64; 3]>> {
    let mut unit = random(3);
    let mut all = vec![first];
    for _ in 1..n_frames {
        let last = &all[all.len() - 1];
        let moved = |(v, p): (usize, &[f64; 3])| {
            if fixed(v) { *p } else { p.map(|c| c + speed * (unit() - 0.5)) }
        };
        let next = last.iter().enumerate().map(moved).collect();
        all.push(next);
    }
    all
}

/// Triangles in a cube, five bodies in turn, of which two do not move.
fn soup(n: usize) -> Scene {
    let mut unit = random(n as u32);
    let mut near = |centre: [f64; 3], size: f64| centre.map(|c| c + size * (unit() - 0.5));
    let mut x = Vec::new();
    for _ in 0..n {
        let centre = near([0.3, -0.7, 11.0], 1.0);
        x.extend([near(centre, 0.25), near(centre, 0.25), near(centre, 0.25)]);
    }
    let faces: Vec<[u32; 3]> = (0..n as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let body_of: Vec<u32> = (0..3 * n as u32).map(|v| v / 3 % 5).collect();
    let fixed = [false, true, false, false, true];
    let bodies = Bodies::new(&body_of, &fixed, true);
    let frames = frames(x, 5, 0.3, |v| fixed[body_of[v] as usize]);
    Scene { mesh: Mesh::new(3 * n, &faces).expect("a mesh"), frames, bodies }
}

/// Three rough sheets of `n` by `n` vertices upon each other, the lowest of which does not move; no
/// sheet is tested against itself.
fn sheets(n: usize) -> Scene {
    let mut unit = random(7);
    let (mut x, mut faces) = (Vec::new(), Vec::new());
    for sheet in 0..3 {
        let first = x.len() as u32;
        for k in 0..n * n {
            let (i, j) = ((k / n) as f64 / n as f64, (k % n) as f64 / n as f64);
            x.push([i + 0.01 * unit(), j + 0.01 * unit(), 0.03 * sheet as f64 + 0.06 * unit()]);
        }
        for k in 0..((n - 1) * (n - 1)) as u32 {
            let at = first + k / (n as u32 - 1) * n as u32 + k % (n as u32 - 1);
            faces.extend([[at, at + 1, at + n as u32], [at + 1, at + n as u32 + 1, at + n as u32]]);
        }
    }
    let body_of: Vec<u32> = (0..x.len()).map(|v| (v / (n * n)) as u32).collect();
    let bodies = Bodies::new(&body_of, &[true], false);
    let frames = frames(x, 4, 0.05, |v| v < n * n);
    let n_vertices = body_of.len();
    Scene { mesh: Mesh::new(n_vertices, &faces).expect("a mesh"), frames, bodies }
}

/// What a session finds in one step.
#[derive(Clone, Debug, PartialEq)]
struct Found {
    vf: Vec<Pair>,
    ee: Vec<Pair>,
    contacts: Vec<Contact>,
    candidates: PerKind,
    filtered: PerKind,
}

fn sorted(mut pairs: Vec<Pair>) -> Vec<Pair> {
    pairs.sort_unstable_by_key(|p| (p.a, p.b));
    pairs
}

/// All steps from frame to frame, by one session.
fn run(scene: &Scene, options: &Options) -> Vec<Found> {
    let mut session = Session::new(scene.mesh.clone(), options.clone()).expect("a session");
    let step = |x: &[Vec<[f64; 3]>]| {
        let listed = session.candidates(&x[0], &x[1]).expect("candidates");
        let (vf, ee) = (sorted(listed.vf.to_vec()), sorted(listed.ee.to_vec()));
        assert!(
            vf.windows(2).all(|p| p[0] != p[1]) && ee.windows(2).all(|p| p[0] != p[1]),
            "a pair twice"
        );
        let report = session.step(&x[0], &x[1]).expect("a step").clone();
        assert_eq!(
            [vf.len() as u64, ee.len() as u64],
            [report.candidates.vf, report.candidates.ee]
        );
        let earliest = session.earliest_toi(&x[0], &x[1]).expect("a step");
        assert!(
            earliest <= report.toi && earliest.is_some() == report.toi.is_some(),
            "{earliest:?}, {:?}",
            report.toi
        );
        Found {
            vf,
            ee,
            contacts: report.contacts,
            candidates: report.candidates,
            filtered: report.filtered,
        }
    };
    scene.frames.windows(2).map(step).collect()
}

/// The methods that the table says are here.
fn methods() -> impl Iterator<Item = BroadPhaseMethod> {
    every("cpu")
}

/// Numbers of threads and pipelines by which a scene is run.
fn ways() -> [(usize, Pipeline); 4] {
    let whole = Pipeline::Triangles(TriangleOptions::default().orphans(false));
    [(1, Pipeline::Features), (2, Pipeline::TRIANGLES), (2, Pipeline::Features), (1, whole)]
}

fn check_methods(name: &str, scene: &Scene) {
    for bodies in [None, Some(scene.bodies.clone())] {
        for min_distance in [0.0, 0.01] {
            let of = |broad_phase, threads, pipeline| {
                Options::default()
                    .with_min_distance(min_distance)
                    .with_threads(threads)
                    .with_bodies(bodies.clone())
                    .with_broad_phase(broad_phase)
                    .with_pipeline(pipeline)
                    .with_scheduling(Default::default())
            };
            let want = run(scene, &of(BroadPhaseMethod::default(), 1, Pipeline::Features));
            let n_contacts: usize = want.iter().map(|found| found.contacts.len()).sum();
            assert!(n_contacts > 10, "{name}: {n_contacts} contacts show nothing");
            for method in methods() {
                for (threads, pipeline) in ways() {
                    let got = run(scene, &of(method, threads, pipeline));
                    let what = format!(
                        "{name}, {method:?}, {pipeline:?}, {threads} threads, \
                         distance {min_distance}, bodies {}",
                        bodies.is_some()
                    );
                    for (i, (got, want)) in got.iter().zip(&want).enumerate() {
                        assert!(
                            got == want,
                            "{what}, step {i}: {:?} of {:?} candidates",
                            got.candidates,
                            want.candidates
                        );
                    }
                }
            }
        }
    }
}

/// Two levels of blocks, and three.
const SOUPS: [usize; 2] = [40, 150];

#[test]
fn every_method_finds_the_same_in_soups() {
    for n in SOUPS {
        check_methods(&format!("soup of {n}"), &soup(n));
    }
}

#[test]
fn every_method_finds_the_same_in_sheets() {
    check_methods("sheets", &sheets(12));
}

#[test]
fn sets_of_no_and_one_feature() {
    let x = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.2, 0.2, 0.5]];
    let mut y = x.clone();
    y[3][2] = -0.5;
    // Faces, further edges, contacts.
    type Case<'a> = (&'a [[u32; 3]], &'a [[u32; 2]], usize);
    let cases: [Case; 4] =
        [(&[], &[], 0), (&[], &[[0, 1]], 0), (&[[0, 1, 2]], &[], 1), (&[[0, 1, 2]], &[[0, 3]], 1)];
    for method in methods() {
        for (faces, edges, want) in cases {
            let mesh = Mesh::with_edges(4, faces, edges).expect("a mesh");
            let options = Options::default().with_threads(1).with_broad_phase(method);
            let mut session = Session::new(mesh, options).expect("a session");
            let n = session.step(&x, &y).expect("a step").contacts.len();
            assert_eq!(n, want, "{method:?}, faces {faces:?}, edges {edges:?}");
        }
        let mut none = Session::new(Mesh::default(), Options::default().with_broad_phase(method))
            .expect("a session");
        assert!(
            none.step(&[[0.0; 3]; 0], &[[0.0; 3]; 0]).expect("a step").contacts.is_empty(),
            "{method:?}"
        );
    }
}

#[test]
fn comparisons_can_fail() {
    let scene = soup(60);
    let of = |method, bodies| {
        Options::default().with_threads(1).with_bodies(bodies).with_broad_phase(method)
    };
    let all = run(&scene, &of(BroadPhaseMethod::TREE, None));
    // Bodies that do not move take pairs away, by every method.
    for method in methods() {
        let fewer = run(&scene, &of(method, Some(scene.bodies.clone())));
        assert!(
            all.iter().zip(&fewer).all(|(a, b)| a.candidates.total() > b.candidates.total()),
            "{method:?}"
        );
    }
    // One vertex elsewhere in one frame.
    let mut other = soup(60);
    other.frames[2][17] = [0.3, -0.7, 11.0];
    let moved = run(&other, &of(BroadPhaseMethod::TREE, None));
    assert!(
        moved[0] == all[0]
            && moved[1] != all[1]
            && moved[1].vf != all[1].vf
            && moved[1].contacts != all[1].contacts
    );
    // The choice is not ignored: methods list candidates in orders of their own.
    let order = |method| {
        let mut session = Session::new(scene.mesh.clone(), of(method, None)).expect("a session");
        session.candidates(&scene.frames[0], &scene.frames[1]).expect("candidates").ee.to_vec()
    };
    assert_ne!(order(BroadPhaseMethod::Blocks), order(BroadPhaseMethod::TREE));
}
