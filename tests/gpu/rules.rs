//! Rules of bodies and worlds on a device: kernels against plain twins, sessions against those of
//! the CPU, whose rules are tested against brute force.

use crate::emulated::methods;
use crate::moving_bodies;
use crate::scenes::{check_candidates, check_pairs, check_reports, check_step};
use crate::support::{bytes, capacity, check_boxes, entries, list, read, run, twin, zeros};
use crate::twin::{code, union};
use ccd::any::{self, Choice};
use ccd::gpu::bind::{NodePairsOfWorlds, WorldBounds, WorldKeys};
use ccd::gpu::{Device, Path, Session};
use ccd::method::Pipeline;
use ccd::scenes::{Step, copies};
use ccd::{Aabb, Bodies, BodyMotion, Error, Groups, Kind, Options};
use ccd_core::backend::broad_phase::morton_key::Curve;
use ccd_core::backend::layout::{Dispatch, Params, Worlds};
use ccd_testkit::compare;
use ccd_testkit::generate::{crumpled_sheet, triangle_soup};

pub const TESTS: crate::Tests = &[
    ("world_kernels", check_kernels),
    ("rules", check_rules),
    ("rules_change", check_changes),
    ("worlds", check_worlds),
    ("dense_exclusions", check_dense_exclusions),
    ("moving_bodies", check_moving_bodies),
    ("little_moves", check_little_moves),
];

/// Steps that are told which bodies move are plain steps.
fn check_moving_bodies(device: &Device) {
    let (mesh, bodies, x) = moving_bodies::scene();
    let narrow: Vec<[f32; 3]> = x.iter().map(|p| p.map(|c| c as f32)).collect();
    let far: Vec<[f64; 3]> = x.iter().map(|p| p.map(|c| c + 1e5 + 0.1)).collect();
    let options = Options::default().with_bodies(bodies);
    let session = || Session::new(device, &mesh, options.clone()).expect("a session");
    moving_bodies::check("f32", 0.0, (&mut session(), &mut session()), &narrow);
    moving_bodies::check("f64", 0.0, (&mut session(), &mut session()), &far);
    if !device.info().integers && device.info().path == Path::Passthrough {
        // Else conservative times differ from those of a CPU by up to the tolerance.
        let choice = Choice::of_device(device, false);
        let mut told =
            any::Session::new(&choice, mesh.clone(), options.clone()).expect("a session");
        let mut plain = any::Session::new(&choice, mesh, options.clone()).expect("a session");
        // The tolerance and the rounding to `f32`.
        moving_bodies::check("either", 1.1e-6, (&mut told, &mut plain), &narrow);
    }
}

/// Where little moves a session of either backend has the CPU take the step, and the GPU where much
/// does or much was found; neither is told what the other one has seen.
fn check_little_moves(device: &Device) {
    let Step { mesh, mut x0, .. } = triangle_soup(400, 0.12, 5);
    x0.iter_mut().for_each(|p| *p = p.map(|c| c as f32 as f64));
    let bodies: Vec<u32> = (0..mesh.n_vertices() as u32).map(|v| v / 30).collect();
    let options = Options::default().with_bodies(Bodies::new(&bodies));
    let choice = Choice::of_device(device, false);
    let mut told = any::Session::new(&choice, mesh.clone(), options.clone()).expect("a session");
    told.set_positions(&x0).expect("positions");
    let mut places = Vec::new();
    for moving in [0..1, 1..3, 0..0, 3..40, 3..40, 1..2, 1..2, 5..6, 5..6] {
        if places.len() == 7 {
            let away: Vec<[f64; 3]> = x0.iter().map(|p| [p[0] + 1.0, p[1], p[2]]).collect();
            let found = told.step(&x0, &away).expect("a step").candidates.total();
            assert!(found > any::FEW_CANDIDATES, "{found}");
        }
        let mut x1 = x0.clone();
        x1[30 * moving.start..30 * moving.end].iter_mut().for_each(|p| p[places.len() % 3] += 0.1);
        let of = |body: usize| [&x0, &x1].map(|x| &x[30 * body..30 * (body + 1)]);
        let motions: Vec<BodyMotion> = moving
            .map(|k| (k as u32, of(k)))
            .map(|(k, [x0, x1])| BodyMotion::new(k, x0, x1))
            .collect();
        let want = ccd::step(&mesh, &x0, &x1, &options).expect("a step");
        let found = told.step_bodies(&motions).expect("a step");
        assert!(found.candidates.total() <= any::FEW_CANDIDATES, "{:?}", found.candidates);
        check_reports(&want, found, false);
        places.push(told.last_place().backend());
        x0 = x1;
    }
    let [gpu, cpu] = ["gpu", "cpu"];
    assert_eq!(places, [gpu, cpu, cpu, gpu, gpu, gpu, cpu, gpu, cpu]);
}

/// All boxes overlap, and each pair is looked for among excluded ones: as many rounds of loops as a
/// filter can need, of which a software device allows 65,535 a thread.
fn check_dense_exclusions(device: &Device) {
    let Step { mesh, mut x0, mut x1 } = triangle_soup(1700, 0.2, 8);
    // Apart from each other, all on one way that is longer than the scene.
    x0.iter_mut().enumerate().for_each(|(v, p)| p[0] += 4.0 * (v / 3) as f64);
    let way = 4.0 * 1700.0;
    x1.clone_from(&x0);
    x1.iter_mut().for_each(|p| *p = p.map(|c| c + way));
    let n_edges = mesh.edges().len() as u32;
    let apart = |by: u32| (0..n_edges - by).map(move |e| [e, e + by]);
    let excluded: Vec<[u32; 2]> = (5..12).flat_map(apart).collect();
    let bodies =
        Bodies::new(&vec![0; mesh.n_vertices()]).with_excluded_features(Kind::EdgeEdge, &excluded);
    let options = Options::default().with_bodies(bodies);
    let want = ccd::step(&mesh, &x0, &x1, &options).unwrap();
    assert!(want.candidates.ee > 10_000_000, "{:?}", want.candidates);
    let mut session = Session::new(device, &mesh, options).unwrap();
    let found = session.step(&x0, &x1).unwrap();
    assert_eq!((found.candidates, found.n_contacts()), (want.candidates, want.n_contacts()));
}

/// Every vertex, edge and face by its place, in worlds.
fn check_kernels(device: &Device) {
    let (twin, _) = twin(60, 1);
    let n = twin.boxes.len() as u32;
    let n_worlds = 11;
    for spread in [7, 500] {
        let world_of = |i: u32| i / spread * 3 % n_worlds;
        let worlds: Vec<u32> = (0..n).map(world_of).collect();
        let p = Params {
            frame: twin.frame,
            dispatch: Dispatch { n, ..Dispatch::default() },
            args: Worlds { bits: 4 },
        };
        let kernel = WorldBounds {
            boxes: bytes(&twin.boxes),
            worlds: bytes(&worlds),
            bounds: zeros::<[u32; 6]>(n_worlds as usize),
        };
        let WorldBounds { boxes, worlds, bounds } = run(device, kernel, &p, n.div_ceil(2048));
        let words: Vec<u32> = read(&bounds);
        let of = |world: u32| {
            union((0..n).filter(|&i| world_of(i) == world).map(|i| &twin.boxes[i as usize]))
        };
        let want: Vec<Aabb> = (0..n_worlds).map(of).collect();
        let got: Vec<Aabb> = (0..n_worlds)
            .map(|w| ccd_core::backend::broad_phase::worlds::bounds(&words, w))
            .collect();
        check_boxes("world", &want, &got);
        let kernel = WorldKeys {
            boxes,
            worlds,
            bounds,
            keys: zeros::<u32>(n as usize),
            order: zeros::<u32>(n as usize),
        };
        let done = run(device, kernel, &p, n.div_ceil(256));
        let keys: Vec<u32> = read(&done.keys);
        let mut same = 0;
        for i in 0..n {
            let world = world_of(i);
            let code = code(&twin.boxes[i as usize], &want[world as usize], Curve::Hilbert) >> 4;
            let key = twin.keys[i as usize] >> 30 << 30 | world << 26 | code;
            assert_eq!(keys[i as usize] >> 26, key >> 26, "set and world of box {i}");
            same += (keys[i as usize] == key) as u32;
        }
        assert!(same * 1000 >= n * 995, "{same} of {n} keys");
        assert!(read::<u32>(&done.order).into_iter().eq(0..n));
    }
    // Leaves in order: worlds of lengths of their own, in each set.
    let world_of = |k: u32| k / 77;
    let mut of_leaves = vec![0u32; twin.tree.slots[0][3] as usize];
    for set in 0..3 {
        for k in 0..twin.frame.count[set] {
            of_leaves[(twin.tree.slots[0][set] + k) as usize] = world_of(k);
        }
    }
    for kind in [0, 1] {
        let above = twin.node_pairs(2, kind);
        let all = twin.node_pairs(1, kind);
        let sets = ccd_core::backend::broad_phase::block_bvh::sets(kind);
        let range = |set: usize, i: u32| {
            let last = (32 * i + 31).min(twin.frame.count[sets[set]] - 1);
            world_of(32 * i)..=world_of(last)
        };
        let mut want = all.clone();
        want.retain(|pair| {
            let (a, b) = (range(0, pair.a), range(1, pair.b));
            a.start() <= b.end() && b.start() <= a.end()
        });
        assert!(want.len() > 50 && want.len() * 2 < all.len(), "{} show nothing", want.len());
        let (nodes, worlds) = (bytes(&twin.nodes), bytes(&of_leaves));
        for groups in [1, 40] {
            let (nodes, worlds) = (nodes.clone(), worlds.clone());
            let kernel =
                NodePairsOfWorlds { nodes, worlds, input: list(&above), output: capacity(50_000) };
            let done = run(device, kernel, &twin.pass(kind, 2, above.len(), 50_000), groups);
            check_pairs("node pairs of worlds", want.clone(), entries(&done.output));
            let found = entries(&done.output);
            assert!(compare::fails(|| check_pairs("control", all.clone(), found)));
        }
    }
}

/// Triangles of nine bodies with rules of all sorts; `which`: of some sorts alone.
fn soup(which: u32) -> (Step, Bodies) {
    let step = triangle_soup(250, 0.2, 5);
    let body: Vec<u32> = (0..step.mesh.n_vertices() as u32).map(|v| v / 3 % 9).collect();
    let mut bodies = Bodies::new(&body).with_fixed_motion(true);
    if which & 1 != 0 {
        bodies = bodies.with_fixed(2, true).with_sleeping(3, true).with_self_contact(4, false);
    }
    if which & 2 != 0 {
        bodies = bodies.with_groups(0, Groups { memberships: 1, filter: 2 });
        bodies = bodies.with_groups(1, Groups { memberships: 3, filter: 1 });
        bodies = bodies.with_excluded_bodies(&[[5, 6], [7, 8]]);
    }
    if which & 4 != 0 {
        let report = ccd::step(&step.mesh, &step.x0, &step.x1, &Options::default()).unwrap();
        for kind in [Kind::VertexFace, Kind::EdgeEdge] {
            let of_kind = report.contacts.iter().filter(|c| c.kind == kind).step_by(2);
            let pairs: Vec<[u32; 2]> = of_kind.map(|c| [c.a, c.b]).collect();
            assert!(pairs.len() > 3);
            bodies = bodies.with_excluded_features(kind, &pairs);
        }
    }
    if which & 8 != 0 {
        bodies = bodies.with_worlds(&[0, 0, 700, 700, 3, 3, 0, 700, 3]);
    }
    (step, bodies)
}

fn check_rules(device: &Device) {
    for which in [1, 2, 4, 8, 15] {
        let (step, bodies) = soup(which);
        let options = Options::default().with_bodies(bodies);
        check_step(device, &step, options.clone());
        check_step(device, &step, options.clone().with_pipeline(Pipeline::TRIANGLES));
        if which == 15 {
            for method in methods(device) {
                let near = options.clone().with_min_distance(0.01).with_broad_phase(method);
                check_step(device, &step, near.clone());
                let mut session = Session::new(device, step.mesh.clone(), near).unwrap();
                check_candidates(&mut session, &step.x0, &step.x1);
            }
        }
        let mut session = Session::new(device, step.mesh.clone(), options).unwrap();
        check_candidates(&mut session, &step.x0, &step.x1);
    }
    // Names of bodies that differ in their highest bit alone.
    let (step, _) = soup(0);
    let name = |v: u32| (v / 3 % 4) | ((v / 3 % 2) << 31);
    let names: Vec<u32> = (0..step.mesh.n_vertices() as u32).map(name).collect();
    check_step(
        device,
        &step,
        Options::default().with_bodies(Bodies::new(&names).with_self_contacts(false)),
    );
}

/// Rules that change between steps give what a new session gives.
fn check_changes(device: &Device) {
    for pipeline in [Pipeline::Features, Pipeline::TRIANGLES] {
        let options = Options::default().with_pipeline(pipeline);
        let (step, _) = soup(0);
        let (x0, x1) = (&step.x0, &step.x1);
        let mut session = Session::new(device, step.mesh.clone(), options.clone()).unwrap();
        let check = |session: &mut Session| {
            let options = session.options().clone();
            let cpu = ccd::step(&step.mesh, x0, x1, &options).unwrap();
            check_reports(&cpu, session.step(x0, x1).unwrap(), false);
            cpu.candidates.total()
        };
        let mut counts = vec![check(&mut session)];
        for which in [15, 1, 8, 2, 8, 4, 0] {
            session.set_bodies(soup(which).1).unwrap();
            counts.push(check(&mut session));
            assert_eq!(check(&mut session), counts[counts.len() - 1]);
        }
        session.set_sleeping(1, true).unwrap();
        session.set_fixed(2, true).unwrap();
        counts.push(check(&mut session));
        session.set_fixed_motion(false).unwrap();
        let refused = session.step(x0, x1).map(|_| ()).unwrap_err();
        let is =
            |e: ccd::gpu::Error, want: Error| matches!(e, ccd::gpu::Error::Input(e) if e == want);
        assert!(is(refused, Error::FixedMoves { vertex: 3 }));
        assert!(is(session.set_sleeping(9, true).unwrap_err(), Error::NoBody { body: 9 }));
        let refused = session.set_filter(|_, _, _| true).unwrap_err();
        assert!(is(refused, Error::Filter { backend: "gpu" }));
        session.set_bodies(None).unwrap();
        assert_eq!(check(&mut session), counts[0]);
        counts.sort_unstable();
        counts.dedup();
        assert!(counts.len() > 6, "{counts:?}: rules that change nothing");
    }
}

/// Copies in one place: each world has, as on the CPU, what it has alone.
fn check_worlds(device: &Device) {
    let one = crumpled_sheet(12, 3);
    let single = ccd::step(&one.mesh, &one.x0, &one.x1, &Options::default()).unwrap();
    for n in [3, 90] {
        let (all, bodies) = copies(&one, n);
        let options = Options::default().with_bodies(bodies);
        let cpu = ccd::step(&all.mesh, &all.x0, &all.x1, &options).unwrap();
        assert_eq!(cpu.contacts.len(), n * single.contacts.len());
        assert_eq!(cpu.candidates.total(), n as u64 * single.candidates.total());
        check_step(device, &all, options);
    }
}
