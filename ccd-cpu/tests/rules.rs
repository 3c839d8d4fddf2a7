//! Rules of bodies: by every method and pipeline, candidates and contacts are those of a session
//! without rules, less what the rules leave out; rules that change between steps; what is fixed.

use ccd_core::backend::layout::Pair;
use ccd_core::model::bodies::Bodies;
use ccd_core::model::catalogue::every;
use ccd_core::model::contact::{Contact, Kind};
use ccd_core::model::groups::Groups;
use ccd_core::model::mesh::Mesh;
use ccd_core::model::method::{BroadPhaseMethod, Traversal, TreeOptions};
use ccd_core::model::options::Options;
use ccd_core::model::pipeline::{Pipeline, TriangleOptions};
use ccd_core::model::scheduling::{Front, Scheduling};
use ccd_core::{Coordinate, Error};
use ccd_cpu::Session;
use std::cell::Cell;

/// Random numbers, the same on every machine.
struct Random(u32);

impl Random {
    fn below(&mut self, n: u32) -> u32 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        (self.0 >> 8) % n
    }

    fn unit(&mut self) -> f64 {
        self.below(1 << 24) as f64 / 16_777_216.0
    }
}

const N_BODIES: u32 = 9;

/// Strips of two triangles in a cube, each of a body.
struct Scene {
    mesh: Mesh,
    body_of: Vec<u32>,
    x: Vec<[f64; 3]>,
}

impl Scene {
    fn new(n: usize) -> Self {
        let mut random = Random(n as u32);
        let mut x = Vec::new();
        for _ in 0..n {
            let centre = [0; 3].map(|_| random.unit());
            x.extend((0..4).map(|_| centre.map(|c| c + 0.25 * random.unit())));
        }
        let strip = |i: u32| [[4 * i, 4 * i + 1, 4 * i + 2], [4 * i + 1, 4 * i + 3, 4 * i + 2]];
        let faces: Vec<[u32; 3]> = (0..n as u32).flat_map(strip).collect();
        let body_of = (0..4 * n as u32).map(|v| v / 4 % N_BODIES).collect();
        Self { mesh: Mesh::new(4 * n, &faces).expect("a mesh"), body_of, x }
    }

    fn moved(&self, seed: u32, by: f64, bodies: Option<&Bodies>) -> Vec<[f64; 3]> {
        let mut random = Random(seed);
        let stays = |v: usize| bodies.is_some_and(|bodies| bodies.is_fixed(v as u32));
        let go = |(v, p): (usize, &[f64; 3])| {
            let moved = p.map(|c| c + by * (random.unit() - 0.5));
            if stays(v) { *p } else { moved }
        };
        self.x.iter().enumerate().map(go).collect()
    }

    /// Rules of all sorts; `which`: of some sorts alone.
    fn bodies(&self, which: u32) -> Bodies {
        let mut random = Random(which + 77);
        let mut bodies = Bodies::new(&self.body_of, &[], true);
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
        let second = if kind == Kind::VertexFace { 1 } else { 2 };
        bodies.wants(v[0], v[second]) && !bodies.excludes(kind, a, b)
    }
}

/// Candidates of each kind, in order, and contacts.
#[derive(Clone, Debug, PartialEq)]
struct Found {
    pairs: [Vec<Pair>; 2],
    contacts: Vec<Contact>,
    toi: Option<f64>,
}

const KINDS: [Kind; 2] = [Kind::VertexFace, Kind::EdgeEdge];

impl Found {
    fn of<T: Coordinate>(session: &mut Session, x0: &[[f64; 3]], x1: &[[f64; 3]]) -> Self {
        let [x0, x1] =
            [x0, x1].map(|x| x.iter().map(|p| p.map(T::from_f64)).collect::<Vec<[T; 3]>>());
        let listed = session.candidates(&x0, &x1).expect("candidates");
        let mut pairs = [listed.vf.to_vec(), listed.ee.to_vec()];
        pairs.iter_mut().for_each(|pairs| pairs.sort_unstable());
        let toi = session.earliest_toi(&x0, &x1).expect("a step");
        let report = session.step(&x0, &x1).expect("a step");
        let counts = [report.candidates.vf, report.candidates.ee];
        assert_eq!(counts, [pairs[0].len() as u64, pairs[1].len() as u64]);
        assert!(toi <= report.toi && toi.is_some() == report.toi.is_some());
        Self { pairs, contacts: report.contacts.clone(), toi: report.toi }
    }

    /// Without pairs that are not wanted.
    fn less(&self, wants: impl Fn(Kind, u32, u32) -> bool) -> Self {
        let mut out = self.clone();
        for (kind, pairs) in KINDS.into_iter().zip(&mut out.pairs) {
            pairs.retain(|pair| wants(kind, pair.a, pair.b));
        }
        out.contacts.retain(|c| wants(c.kind, c.a, c.b));
        out.toi = out.contacts.iter().map(|c| c.toi).reduce(f64::min);
        out
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
    for which in [1, 2, 4, 6, 8, 9, 15] {
        let bodies = scene.bodies(which);
        let x0 = scene.moved(2, 0.01, Some(&bodies));
        let x1 = scene.moved(3, 0.4, Some(&bodies));
        let x1: Vec<_> =
            (0..x0.len()).map(|v| if bodies.is_fixed(v as u32) { x0[v] } else { x1[v] }).collect();
        let all =
            Found::of::<T>(&mut session(&scene, Options::default().with_threads(1)), &x0, &x1);
        let want = all.less(|kind, a, b| scene.wants(&bodies, kind, a, b));
        let n_pairs: usize = want.pairs.iter().map(Vec::len).sum();
        assert!(n_pairs > 40 && want != all, "{which}: {n_pairs} pairs show nothing");
        n_left += want.contacts.len();
        n_less += all.contacts.len() - want.contacts.len();
        for method in every("cpu") {
            for pipeline in pipelines() {
                let options = Options::default()
                    .with_threads(1 + which as usize % 2)
                    .with_bodies(bodies.clone())
                    .with_broad_phase(method)
                    .with_pipeline(pipeline);
                let got = Found::of::<T>(&mut session(&scene, options), &x0, &x1);
                assert!(got == want, "{n}, rules {which}, {method:?}, {pipeline:?}");
            }
        }
    }
    assert!(n_less > 100 && n_left > 100, "{n_less} contacts left out, {n_left} left");
}

#[test]
fn rules_leave_out_what_they_say() {
    check_rules::<f64>(60);
    check_rules::<f32>(90);
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
        assert!(Found::of::<f64>(&mut session, &x0, &x1) == want, "{pipeline:?}");
        session.remove_filter();
        assert!(Found::of::<f64>(&mut session, &x0, &x1) == all, "{pipeline:?}");
    }
}

/// A session whose rules change is as a new one; also where a front is kept.
#[test]
fn rules_change_between_steps() {
    let scene = Scene::new(120);
    let front = Scheduling::default().front(Front::ON);
    let cut = TreeOptions::default().traversal(Traversal::CUT);
    let cut = BroadPhaseMethod::Tree(cut);
    let some = [
        Options::default(),
        Options::default().with_scheduling(front),
        Options::default().with_broad_phase(cut).with_scheduling(front),
        Options::default().with_pipeline(Pipeline::TRIANGLES),
    ];
    for options in some {
        let options = options.with_threads(1);
        let mut changing = session(&scene, options.clone());
        let check = |changing: &mut Session, seed: u32, what: &str| {
            let bodies = changing.options().bodies.clone();
            let mut fresh = session(&scene, options.clone().with_bodies(bodies.clone()));
            let x0 = scene.moved(seed, 0.02, bodies.as_ref());
            let x1 = scene.moved(seed + 1, 0.2, bodies.as_ref());
            let want = Found::of::<f64>(&mut fresh, &x0, &x1);
            assert!(!want.contacts.is_empty());
            let got = Found::of::<f64>(changing, &x0, &x1);
            assert!(got == want, "{what}, {:?}", options.pipeline);
            want
        };
        let mut seed = 10;
        for which in [0, 1, 3, 9, 15, 8, 2, 1] {
            changing.set_bodies(scene.bodies(which)).expect("bodies");
            for _ in 0..3 {
                seed += 2;
                check(&mut changing, seed, &format!("rules {which}"));
            }
        }
        changing.set_bodies(Bodies::new(&scene.body_of, &[], true)).expect("bodies");
        let all = check(&mut changing, 50, "plain");
        changing.set_sleeping(3, true).expect("body 3");
        changing.set_fixed(5, true).expect("body 5");
        let fewer = check(&mut changing, 50, "3 sleeps, 5 is fixed");
        assert!(all.pairs[1].len() > fewer.pairs[1].len());
        changing.set_sleeping(3, false).expect("body 3");
        changing.set_fixed(5, false).expect("body 5");
        assert!(check(&mut changing, 50, "awake again") == all);
        assert_eq!(changing.set_sleeping(99, true), Err(Error::NoBody { body: 99 }));
        let bad = Bodies::new(&[0, 1], &[], true);
        assert!(matches!(changing.set_bodies(bad), Err(Error::BodyCount { .. })));
        assert!(check(&mut changing, 50, "refused") == all);
        changing.set_bodies(None).expect("no bodies");
        assert_eq!(changing.set_fixed(0, true), Err(Error::NoBody { body: 0 }));
        check(&mut changing, 60, "no bodies");
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
    let bodies = Bodies::new(&body_of, &fixed, true);
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
    let mut random = Random(4);
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
