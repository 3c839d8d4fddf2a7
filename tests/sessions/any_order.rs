//! Everything that may change between steps, in any order, with steps that are refused in between:
//! after each change a session finds what a new one does, and what each pair by itself says.

use ccd::method::{
    BroadPhaseMethod, Front, Pipeline, Scheduler, Scheduling, Traversal, TreeOptions,
    TriangleOptions,
};
use ccd::scenes::{Random, Step, particles_and_rods, triangle_soup};
use ccd::{Bodies, Contact, Error, Groups, Kind, Mesh, Options, Pair, Report, Session, State};
use ccd_core::model::decision::Decider;
use ccd_testkit::brute::feature_pairs;
use ccd_testkit::methods::is_near_default;

/// A scene with a body for every few connected elements, and where bodies are at rest.
struct Scene {
    step: Step,
    body_of: Vec<u32>,
}

impl Scene {
    fn new(step: Step, n_bodies: u32) -> Self {
        // Elements that share a vertex are of one body.
        let mut root: Vec<u32> = (0..step.mesh.n_vertices() as u32).collect();
        for &[a, b] in step.mesh.edges() {
            let (a, b) = (find(&root, a), find(&root, b));
            root[a.max(b) as usize] = a.min(b);
        }
        let n = root.len() as u32;
        let body_of = (0..n).map(|v| find(&root, v) * 7 % n_bodies).collect();
        Self { step, body_of }
    }

    /// Positions at both ends of step `k`, in which bodies that stand still do.
    fn positions(&self, bodies: Option<&Bodies>, k: usize) -> [Vec<[f64; 3]>; 2] {
        let Step { x0, x1, .. } = &self.step;
        let parts = [[0.0, 1.0], [1.0, 0.0], [0.25, 0.5], [0.0, 0.0]][k % 4];
        parts.map(|t| {
            let at = |v: usize| -> [f64; 3] {
                let is_still = bodies.is_some_and(|b| b.is_fixed(v as u32) && !b.fixed_may_move());
                // Where it stands changes now and then.
                let t = if is_still { (k / 8 % 3) as f64 * 0.25 } else { t };
                std::array::from_fn(|i| x0[v][i] + (x1[v][i] - x0[v][i]) * t)
            };
            (0..x0.len()).map(at).collect()
        })
    }
}

/// Contacts of every pair, each asked by itself.
fn every_pair(
    mesh: &Mesh,
    x: [&[[f64; 3]]; 2],
    options: &Options,
    window: [f64; 2],
) -> Vec<Contact> {
    let decider = Decider::new(options, window);
    let (edges, faces) = (mesh.edges(), mesh.faces());
    let wants = |kind: Kind, a: u32, b: u32, v: u32, w: u32| {
        options.bodies.as_ref().is_none_or(|of| of.wants(v, w) && !of.excludes(kind, a, b))
    };
    let mut all = Vec::new();
    for (kind, pair) in feature_pairs(mesh) {
        let ids = mesh.vertices_of(kind, pair);
        if wants(kind, pair.a, pair.b, ids[0], ids[kind.n_first()]) {
            all.extend(decider.contact(mesh, kind, pair, x));
        }
    }
    let alone = mesh.isolated_vertices();
    let of_face = |[a, b]: &[u32; 2]| faces.iter().any(|f| f.contains(a) && f.contains(b));
    let mut thin = |kind: Kind, a: u32, b: u32, w: u32| {
        if wants(kind, a, b, a, w) {
            all.extend(decider.contact(mesh, kind, Pair { a, b }, x));
        }
    };
    for &v in alone {
        for (e, ends) in (0..).zip(edges).filter(|(_, ends)| !of_face(ends)) {
            thin(Kind::VertexEdge, v, e, ends[0]);
        }
    }
    for (i, &v) in alone.iter().enumerate() {
        alone[i + 1..].iter().for_each(|&w| thin(Kind::VertexVertex, v, w, w));
    }
    all.sort_unstable_by_key(|c| (c.kind, c.a, c.b));
    all
}

/// What is found is among what every pair says, the same to the last bit; and of that nothing is
/// missing but what is undecided and has boxes that are apart.
fn check_pairs(what: &str, want: &[Contact], found: &[Contact]) {
    let key = |c: &Contact| (c.kind, c.a, c.b);
    for c in found {
        let at =
            want.binary_search_by_key(&key(c), key).unwrap_or_else(|_| panic!("{what}: {c:?}"));
        assert_eq!(want[at], *c, "{what}");
    }
    for c in want.iter().filter(|c| c.state == State::Hit) {
        assert!(found.binary_search_by_key(&key(c), key).is_ok(), "{what}: missing {c:?}");
    }
}

/// The first vertex of the body of `v`.
fn find(root: &[u32], mut v: u32) -> u32 {
    while root[v as usize] != v {
        v = root[v as usize];
    }
    v
}

fn random_bodies(random: &mut Random, scene: &Scene, n: u32) -> Option<Bodies> {
    if random.below(6) == 0 {
        return None;
    }
    let fixed: Vec<bool> = (0..n).map(|_| random.below(4) == 0).collect();
    let mut bodies = Bodies::new(&scene.body_of)
        .with_fixed_mask(&fixed)
        .with_self_contacts(random.below(2) == 0)
        .with_fixed_motion(random.below(4) == 0);
    let there = |b: u32| scene.body_of.contains(&b);
    for b in (0..n).filter(|&b| there(b)) {
        match random.below(10) {
            0 => bodies = bodies.with_sleeping(b, true),
            1 => bodies = bodies.with_self_contact(b, true),
            2 => bodies = bodies.with_groups(b, Groups { memberships: random.below(4), filter: 3 }),
            3 => bodies = bodies.with_world(b, random.below(3)),
            4 => {
                let other = random.below(n);
                if there(other) {
                    bodies = bodies.with_excluded_bodies(&[[b, other]]);
                }
            }
            _ => {}
        }
    }
    for kind in Kind::ALL {
        let mesh = &scene.step.mesh;
        let (v, e, f) = (mesh.n_vertices(), mesh.edges().len(), mesh.faces().len());
        let [p, q] = match kind {
            Kind::VertexFace => [v, f],
            Kind::EdgeEdge => [e, e],
            Kind::VertexEdge => [v, e],
            Kind::VertexVertex => [v, v],
        };
        if random.below(3) == 0 && p > 0 && q > 0 {
            let pairs: Vec<[u32; 2]> =
                (0..20).map(|_| [random.below(p as u32), random.below(q as u32)]).collect();
            bodies = bodies.with_excluded_features(kind, &pairs);
        }
    }
    Some(bodies)
}

type Numbers = (Option<f64>, [ccd::PerKind; 2], u64, Option<ccd::method::TriangleCounts>);

fn numbers(r: &Report) -> Numbers {
    (r.toi, [r.candidates, r.filtered], r.undecided, r.triangles)
}

/// Methods that differ from the default in one choice, and some with a front.
fn methods() -> Vec<(BroadPhaseMethod, Scheduling)> {
    let alone = ccd::method::every("cpu").filter(|&method| is_near_default(method));
    let cut = BroadPhaseMethod::Tree(TreeOptions::default().traversal(Traversal::CUT));
    let front = Scheduling::default().scheduler(Scheduler::LazyStealing).front(Front::ON);
    let kept = [BroadPhaseMethod::Blocks, cut].map(|method| (method, front));
    alone.map(|method| (method, Scheduling::default())).chain(kept).collect()
}

/// Pipeline, method and scheduling number `k` of all.
fn chosen(options: Options, k: usize) -> Options {
    let free_regions = Pipeline::Triangles(TriangleOptions::default().free_regions(true));
    let pipeline = [Pipeline::Features, Pipeline::TRIANGLES, free_regions][k % 3];
    let methods = methods();
    let (method, scheduling) = methods[k % methods.len()];
    options.with_pipeline(pipeline).with_broad_phase(method).with_scheduling(scheduling)
}

/// One session, which begins by method number `first`; returns how many it went through.
fn check_any_order(seed: u32, first: usize) -> usize {
    let n_bodies = 9;
    let none =
        Step { mesh: Mesh::new(2, &[]).unwrap(), x0: vec![[0.0; 3]; 2], x1: vec![[1.0; 3]; 2] };
    let scenes = [
        Scene::new(particles_and_rods(24, seed), n_bodies),
        Scene::new(triangle_soup(40, 0.4, seed), n_bodies),
        Scene::new(particles_and_rods(12, seed + 1), n_bodies),
        Scene::new(none, n_bodies),
    ];
    let mut random = Random::new(seed);
    let (mut at, mut n_methods) = (0, 1);
    let base = Options::default().with_threads(1 + seed as usize % 2);
    let mut session = Session::new(&scenes[at].step.mesh, chosen(base, first)).unwrap();
    let (mut total, mut refused, mut k) = (0, 0, 0);
    for round in 0..120 {
        let body = random.below(n_bodies);
        let before = session.options().clone();
        let on = random.below(2) == 0;
        match random.below(9) {
            0 => {
                at = random.below(4) as usize;
                let bodies = random_bodies(&mut random, &scenes[at], n_bodies);
                session.set_mesh_and_bodies(&scenes[at].step.mesh, bodies).unwrap();
            }
            1 => {
                let bodies = random_bodies(&mut random, &scenes[at], n_bodies);
                session.set_bodies(bodies).unwrap();
            }
            kind @ 2..4 => {
                let set = if kind == 2 { Session::set_fixed } else { Session::set_sleeping };
                if let Err(why) = set(&mut session, body, on) {
                    assert_eq!(why, Error::NoBody { body });
                    refused += 1;
                }
            }
            4 => session.set_fixed_motion(on).unwrap(),
            5 => {
                let distance = [0.0, 0.01, 1e-9, 0.05][random.below(4) as usize];
                session.set_min_distance(distance).unwrap();
            }
            6 => {
                let tolerance = [1e-6, 1e-3, 1e-12][random.below(3) as usize];
                let options = before.with_leave_contact(on).with_tolerance(tolerance);
                let options = chosen(options.with_threads(1 + round / 3 % 2), first + n_methods);
                session.set_options(options.clone()).unwrap();
                assert_eq!(*session.options(), options);
                n_methods += 1;
            }
            7 => {
                let many = before.clone().with_threads(Options::MAX_THREADS + 1);
                let refused = session.set_options(many);
                assert!(matches!(refused, Err(Error::Threads { .. })), "{refused:?}");
                assert!(session.set_options(before.clone().with_tolerance(0.0)).is_err());
                assert!([-1.0, f64::NAN].iter().all(|&d| session.set_min_distance(d).is_err()));
                // Bodies of this mesh do not fit another; none of both is changed.
                if before.bodies.is_some() {
                    let other = &scenes[(at + 1) % 4].step.mesh;
                    let refused = session.set_mesh(other);
                    assert!(matches!(refused, Err(Error::BodyCount { .. })), "{refused:?}");
                }
            }
            _ => k += random.below(9) as usize,
        }
        let options = session.options().clone();
        let scene = &scenes[at];
        let mesh = &scene.step.mesh;
        let [x0, x1] = scene.positions(options.bodies.as_ref(), k);
        if random.below(4) == 0 {
            // Refused: a coordinate that is none, or what is fixed moves.
            let mut bad = x1.clone();
            bad[random.below(x1.len() as u32) as usize][1] = f64::NAN;
            assert!(session.step(&x0, &bad).is_err());
            let still = options.bodies.as_ref().filter(|of| !of.fixed_may_move());
            let moves = still.and_then(|of| (0..x0.len()).find(|&v| of.is_fixed(v as u32)));
            if let Some(v) = moves {
                bad.clone_from(&x1);
                bad[v][0] += 1.0;
                assert!(session.step(&x0, &bad).is_err());
            }
            assert!(session.step_window(&x0, &x1, [0.75, 0.5]).is_err());
        }
        let mut fresh = Session::new(mesh, options.clone()).unwrap();
        let windows = [[0.0, 1.0], [0.1, 0.7], [0.25, 0.25], [0.5, 1.0], [1.0, 1.0]];
        let window = windows[random.below(5) as usize];
        let what = format!("{seed}, change {round}, {window:?}: {options:?}");
        if random.below(3) == 0 {
            let found = session.earliest_toi(&x0, &x1).unwrap();
            assert_eq!(found, fresh.earliest_toi(&x0, &x1).unwrap(), "{what}");
            let least = fresh.step(&x0, &x1).unwrap().toi;
            assert_eq!(found.is_some(), least.is_some(), "{what}");
            // Contacts that are open may be found in fewer boxes; none is later.
            assert!(found.zip(least).is_none_or(|(found, least)| found >= least), "{what}");
            let [found, want] = [&mut session, &mut fresh].map(|session| {
                let all = session.candidates(&x0, &x1).unwrap();
                let mut pairs =
                    [all.vf.to_vec(), all.ee.to_vec(), all.ve.to_vec(), all.vv.to_vec()];
                pairs.iter_mut().for_each(|pairs| pairs.sort_unstable());
                pairs
            });
            assert!(found == want, "{what}: other candidates");
        }
        let found = session.step_window(&x0, &x1, window).unwrap().clone();
        let want = fresh.step_window(&x0, &x1, window).unwrap();
        assert_eq!(found.contacts, want.contacts, "{what}");
        assert_eq!(numbers(&found), numbers(want), "{what}");
        assert_eq!(found.mesh(), mesh, "{what}");
        check_pairs(&what, &every_pair(mesh, [&x0, &x1], &options, window), &found.contacts);
        total += found.contacts.len();
        // What stands still once more, in `f32` in between.
        if random.below(3) == 0 {
            let narrow =
                [&x0, &x1].map(|x| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<_>>());
            let found = session.step(&narrow[0], &narrow[1]).unwrap().contacts.clone();
            assert_eq!(found, fresh.step(&narrow[0], &narrow[1]).unwrap().contacts, "{what}");
            let [y0, y1] = narrow.map(|x| x.iter().map(|p| p.map(f64::from)).collect::<Vec<_>>());
            let want = every_pair(mesh, [&y0, &y1], &options, [0.0, 1.0]);
            check_pairs(&what, &want, &found);
            let again = session.step_window(&x0, &x1, window).unwrap();
            let want = fresh.step_window(&x0, &x1, window).unwrap();
            assert_eq!(again.contacts, want.contacts, "{what}");
        }
    }
    assert!(total > 100 && refused > 0, "{total} contacts, {refused} refused show little");
    n_methods
}

#[test]
fn changes_in_any_order_leave_nothing_behind() {
    let (mut n, most) = (0, methods().len());
    for seed in 1.. {
        if n >= 2 * most {
            break;
        }
        n += check_any_order(seed, n);
    }
}

/// Scenes in other units and far from the origin, in windows whose ends are no `f32`: what every
/// pair says, although filters calculate in `f32` of rounded positions.
#[test]
fn no_unit_and_no_place_loses_a_contact() {
    let mut total = 0;
    for seed in 0..4u32 {
        for (unit, offset) in [
            (1.0, 0.0),
            (1e-30, 0.0),
            (1.0, 1e8),
            (1e30, 1e31),
            (1e-9, 3.0),
            (1e-300, 0.0),
            (1e60, 0.0),
        ] {
            let step = match seed % 2 {
                0 => particles_and_rods(20, seed + 10),
                _ => triangle_soup(40, 0.4, seed + 10),
            };
            let place = |x: &[[f64; 3]]| -> Vec<[f64; 3]> {
                x.iter().map(|p| p.map(|c| c * unit + offset)).collect()
            };
            let (x0, x1) = (place(&step.x0), place(&step.x1));
            for (window, d) in [
                ([0.0, 1.0], 0.0),
                ([0.1, 0.7], 0.0),
                ([0.3, 0.3], 0.01),
                ([0.1, 1.0], 0.02),
                ([0.0, 1e-40], 0.03),
                ([0.0, 0.9], 1e-320),
            ] {
                for leaves in [false, true] {
                    let options = Options::default()
                        .with_threads(1)
                        .with_min_distance(d * unit)
                        .with_leave_contact(leaves);
                    let mut session = Session::new(&step.mesh, options.clone()).unwrap();
                    let found = session.step_window(&x0, &x1, window).unwrap().contacts.clone();
                    let what = format!("{seed}, {unit:e} at {offset:e}, {window:?} {d} {leaves}");
                    let want = every_pair(&step.mesh, [&x0, &x1], &options, window);
                    check_pairs(&what, &want, &found);
                    total += found.len();
                }
            }
        }
    }
    println!("{total} contacts");
    assert!(total > 2_000, "{total} contacts show little");
}
