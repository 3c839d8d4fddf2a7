//! Every method and pipeline, frame after frame, with rules of bodies and without: candidates and
//! contacts are those of the default, less what the rules leave out; what is fixed.

use super::found::Found;
use ccd::method::{BroadPhaseMethod, Pipeline, TriangleOptions, Volume};
use ccd::scenes::Random;
use ccd::{Bodies, Coordinate, Error, Groups, Kind, Mesh, Options, Pair, Session};
use ccd_testkit::is_whole;
use std::cell::Cell;

const N_BODIES: u32 = 9;

/// Strips of two triangles in a cube, each of a body.
struct Scene {
    mesh: Mesh,
    body_of: Vec<u32>,
    x: Vec<[f64; 3]>,
}

impl Scene {
    fn new(n: usize) -> Self {
        let mut random = Random::new(n as u32);
        let mut x = Vec::new();
        for _ in 0..n {
            let centre = random.point();
            x.extend((0..4).map(|_| centre.map(|c| c + 0.25 * random.unit())));
        }
        let strip = |i: u32| [[4 * i, 4 * i + 1, 4 * i + 2], [4 * i + 1, 4 * i + 3, 4 * i + 2]];
        let faces: Vec<[u32; 3]> = (0..n as u32).flat_map(strip).collect();
        let body_of = (0..4 * n as u32).map(|v| v / 4 % N_BODIES).collect();
        Self { mesh: Mesh::new(4 * n, &faces).expect("a mesh"), body_of, x }
    }

    fn moved(&self, seed: u32, by: f64, bodies: Option<&Bodies>) -> Vec<[f64; 3]> {
        let mut random = Random::new(seed);
        let stays = |v: usize| bodies.is_some_and(|bodies| bodies.is_fixed(v as u32));
        let go = |(v, p): (usize, &[f64; 3])| {
            let moved = p.map(|c| c + by * (random.unit() - 0.5));
            if stays(v) { *p } else { moved }
        };
        self.x.iter().enumerate().map(go).collect()
    }

    /// Rules of all sorts; `which`: of some sorts alone.
    fn bodies(&self, which: u32) -> Bodies {
        let mut random = Random::new(which + 77);
        let mut bodies = Bodies::new(&self.body_of);
        for body in 0..N_BODIES {
            if which & 1 != 0 {
                bodies = bodies.with_self_contact(body, random.below(2) == 0);
                bodies = bodies.with_fixed(body, random.below(4) == 0);
                bodies = bodies.with_sleeping(body, random.below(4) == 0);
            }
            if which & 2 != 0 {
                let [memberships, filter] = [0; 2].map(|_| 1 + random.below(15));
                bodies = bodies.with_groups(body, Groups { memberships, filter });
                bodies = bodies.with_excluded_bodies(&[[body, random.below(N_BODIES)]]);
            }
        }
        if which & 4 != 0 {
            let (n_e, n_f) = (self.mesh.edges().len() as u32, self.mesh.faces().len() as u32);
            let n_v = self.mesh.n_vertices() as u32;
            let mut some = |n: u32, m: u32, part: u32| -> Vec<[u32; 2]> {
                (0..n * m / part).map(|_| [random.below(n), random.below(m)]).collect()
            };
            let (vf, ee) = (some(n_v, n_f, 3), some(n_e, n_e, 6));
            bodies = bodies.with_excluded_features(Kind::VertexFace, &vf);
            bodies = bodies.with_excluded_features(Kind::EdgeEdge, &ee);
        }
        if which & 8 != 0 {
            let worlds: Vec<u32> = (0..N_BODIES).map(|_| random.below(4) * 100).collect();
            bodies = bodies.with_worlds(&worlds);
        }
        bodies
    }

    /// Whether rules want a pair, as they are stated.
    fn wants(&self, bodies: &Bodies, kind: Kind, a: u32, b: u32) -> bool {
        let v = self.mesh.vertices_of(kind, Pair { a, b });
        bodies.wants(v[0], v[kind.n_first()]) && !bodies.excludes(kind, a, b)
    }
}

fn session(scene: &Scene, options: Options) -> Session {
    Session::new(scene.mesh.clone(), options).expect("a session")
}

fn pipelines() -> [Pipeline; 3] {
    let whole = Pipeline::Triangles(TriangleOptions::default().orphans(false));
    [Pipeline::Features, Pipeline::TRIANGLES, whole]
}

fn check_rules<T: Coordinate>(n: usize) {
    let scene = Scene::new(n);
    let (mut n_less, mut n_left) = (0, 0);
    for (turn, which) in [0, 1, 2, 4, 6, 8, 9, 15].into_iter().enumerate() {
        let bodies = (which > 0).then(|| scene.bodies(which));
        let x0 = scene.moved(2, 0.01, bodies.as_ref());
        let mut x1 = scene.moved(3, 0.4, None);
        let is_fixed = |v: usize| bodies.as_ref().is_some_and(|of| of.is_fixed(v as u32));
        (0..x0.len()).filter(|&v| is_fixed(v)).for_each(|v| x1[v] = x0[v]);
        // The way back keeps the order of boxes.
        let run = |options: Options| -> [Found; 2] {
            let mut session = session(&scene, options);
            [[&x0, &x1], [&x1, &x0]].map(|[x0, x1]| Found::of::<T>(&mut session, x0, x1))
        };
        let distance = if which % 2 == 0 { 0.01 } else { 0.0 };
        let base = Options::default().with_min_distance(distance);
        let all = run(base.clone().with_threads(1));
        let wants = |kind, a, b| bodies.as_ref().is_none_or(|of| scene.wants(of, kind, a, b));
        let want = run(base.clone().with_threads(1).with_bodies(bodies.clone()));
        for (all, want) in all.iter().zip(&want) {
            assert!(want.less(|_, _, _| true) == all.less(wants), "{n}, rules {which}");
        }
        let n_pairs: usize = want[0].pairs.iter().map(Vec::len).sum();
        assert!(n_pairs > 40 && (want != all || which == 0), "{which}: {n_pairs} pairs");
        n_left += want[0].contacts.len();
        n_less += all[0].contacts.len() - want[0].contacts.len();
        for (i, method) in ccd::method::every("cpu").enumerate() {
            for (k, pipeline) in pipelines().into_iter().enumerate() {
                // Of three pipelines one, another by other rules: in the end every method by each.
                if !is_whole() && (i + turn + k) % 3 != 0 {
                    continue;
                }
                let options = base.clone().with_threads(1 + (which as usize + k) % 2);
                let options = options.with_bodies(bodies.clone()).with_broad_phase(method);
                let mut got = run(options.with_pipeline(pipeline));
                let is_oriented =
                    matches!(method, BroadPhaseMethod::Tree(tree) if tree.volume == Volume::Obb);
                if is_oriented && pipeline != Pipeline::Features {
                    // Boxes of triangles leave the filters fewer pairs.
                    for (got, want) in got.iter_mut().zip(&want) {
                        assert!(got.filtered.total() <= want.filtered.total(), "{method:?}");
                        got.filtered = want.filtered;
                    }
                }
                assert!(got == want, "{n}, rules {which}, {method:?}, {pipeline:?}");
            }
        }
    }
    assert!(n_less > 100 && n_left > 100, "{n_less} contacts left out, {n_left} left");
}

#[test]
fn every_method_and_pipeline_keeps_the_rules() {
    check_rules::<f64>(45);
    check_rules::<f32>(60);
}

/// The control: methods list candidates in orders of their own.
#[test]
fn the_choice_of_a_method_is_not_ignored() {
    let scene = Scene::new(60);
    let [blocks, tree] = [BroadPhaseMethod::Blocks, BroadPhaseMethod::TREE].map(|method| {
        let mut session = session(&scene, Options::default().with_broad_phase(method));
        session.candidates(&scene.x, &scene.x).expect("candidates").ee.to_vec()
    });
    assert!(blocks != tree && blocks.len() == tree.len());
}

#[test]
fn filters_are_asked_of_overlaps() {
    let scene = Scene::new(60);
    let (x0, x1) = (scene.moved(2, 0.01, None), scene.moved(3, 0.4, None));
    let all = Found::of::<f64>(&mut session(&scene, Options::default()), &x0, &x1);
    let odd = |kind, a: u32, b: u32| (a + b + (kind == Kind::EdgeEdge) as u32).is_multiple_of(3);
    let want = all.less(odd);
    assert!(want.contacts.len() > 20 && want.contacts.len() < all.contacts.len());
    for pipeline in pipelines() {
        let mut session = session(&scene, Options::default().with_pipeline(pipeline));
        let pairs = all.pairs.clone();
        session
            .set_filter(move |kind, a, b| {
                let listed = &pairs[kind as usize];
                assert!(listed.binary_search(&Pair { a, b }).is_ok(), "{a} and {b} do not overlap");
                odd(kind, a, b)
            })
            .expect("a filter");
        let found = Found::of::<f64>(&mut session, &x0, &x1);
        assert!(found.less(|_, _, _| true) == want, "{pipeline:?}");
        session.remove_filter();
        assert!(Found::of::<f64>(&mut session, &x0, &x1) == all, "{pipeline:?}");
    }
}

/// What stands still is noticed to move, in a step and between steps; and boxes that are kept are
/// those that a new session makes.
#[test]
fn what_is_fixed_stands_still_or_is_moved() {
    let scene = Scene::new(300);
    let fixed = [true, false, true, true, true, true, true, false, true];
    // Bodies in one piece each, so that there are parts that stand still.
    let body_of: Vec<u32> = (0..1200).map(|v| v / 4 * N_BODIES / 300).collect();
    let bodies = Bodies::new(&body_of).with_fixed_mask(&fixed);
    let options = Options::default().with_threads(2).with_bodies(bodies.clone());
    let mut kept = session(&scene, options.clone());
    let mut x0 = scene.x.clone();
    let (n_rebuilt, n_contacts) = (Cell::new(0), Cell::new(0));
    let check = |kept: &mut Session, x0: &[[f64; 3]], x1: &[[f64; 3]], what: &str| {
        let mut fresh = session(&scene, kept.options().clone());
        let rebuilt = kept.step(x0, x1).expect("a step").rebuilt;
        n_rebuilt.set(n_rebuilt.get() + rebuilt as u32);
        let (want, got) = (Found::of::<f64>(&mut fresh, x0, x1), Found::of::<f64>(kept, x0, x1));
        assert!(want == got, "{what}, in f64");
        let (want, got) = (Found::of::<f32>(&mut fresh, x0, x1), Found::of::<f32>(kept, x0, x1));
        assert!(want == got, "{what}, in f32");
        n_contacts.set(n_contacts.get() + want.contacts.len());
    };
    let single = |x: Vec<[f64; 3]>| x.iter().map(|p| p.map(|c| c as f32 as f64)).collect();
    let mut random = Random::new(4);
    for step in 0..24 {
        let by = if step % 8 < 4 { 0.02 } else { 0.3 };
        let mut x1: Vec<[f64; 3]> = x0.clone();
        for (v, p) in x1.iter_mut().enumerate().filter(|(v, _)| !bodies.is_fixed(*v as u32)) {
            *p = p.map(|c| (c + by * (random.unit() - 0.5)).clamp(-0.5, 1.5));
            assert!(body_of[v] == 1 || body_of[v] == 7);
        }
        if step >= 12 {
            // Numbers that are exact in f32, whose table has no origin that moves.
            (x0, x1) = (single(x0), single(x1));
        }
        check(&mut kept, &x0, &x1, &format!("step {step}"));
        if step == 5 || step == 17 {
            // One that is fixed is elsewhere in the next step.
            let far = (0..1200).find(|&v| body_of[v] == 4).expect("a vertex");
            x1[far] = x1[far].map(|c| c + 0.125);
        }
        x0 = x1;
    }
    assert!(n_rebuilt.get() > 1, "no build but the first");
    assert!(n_contacts.get() > 1000, "{} contacts show nothing", n_contacts.get());
    let mut x1 = x0.clone();
    x1[700][1] += 1e-9;
    assert!(fixed[body_of[700] as usize]);
    let refused = Err(Error::FixedMoves { vertex: 700 });
    assert_eq!(kept.step(&x0, &x1).map(|_| ()), refused);
    assert_eq!(kept.earliest_toi(&x0, &x1).map(|_| ()), refused);
    check(&mut kept, &x0, &x0.clone(), "after an error");
    kept.set_fixed_motion(true).expect("the same bodies");
    for _ in 0..3 {
        check(&mut kept, &x0, &x1, "driven");
        check(&mut kept, &x1, &x0, "driven back");
        check(&mut kept, &x0, &x0.clone(), "at rest");
    }
    kept.set_fixed_motion(false).expect("the same bodies");
    assert_eq!(kept.step(&x0, &x1).map(|_| ()), refused);
    x1[700][1] = f64::NAN;
    assert!(matches!(kept.step(&x0, &x1), Err(Error::Coordinate { vertex: 700, .. })));
}
