//! Pairs of triangles give what pairs of features give, on any mesh: non-manifold, degenerate, with
//! wires and loose vertices; and what they say about their tests adds up.

use super::found::Found;
use ccd::method::{Pipeline, TriangleCounts, TriangleOptions};
use ccd::scenes::Random;
use ccd::{Bodies, Mesh, Options, Session};

/// Positions at both ends of a step.
type Ends = [Vec<[f64; 3]>; 2];

fn run(mesh: &Mesh, x: &Ends, options: Options) -> (Found, Option<TriangleCounts>) {
    let repeats = options.pipeline.repeats_tests();
    let mut session = Session::new(mesh.clone(), options).expect("a session");
    let found = Found::of::<f64>(&mut session, &x[0], &x[1]);
    let report = session.report();
    if let Some(counts) = report.triangles {
        assert!(repeats || report.filtered.total() <= report.candidates.total());
        assert!(report.candidates.total() <= counts.box_tests(), "{counts:?}");
        assert!(counts.represented <= counts.all_tests(), "{counts:?}");
        assert!(counts.adjacent <= counts.pairs);
    }
    (found, report.triangles)
}

fn triangles(orphans: bool, free_regions: bool) -> Pipeline {
    Pipeline::Triangles(TriangleOptions::default().orphans(orphans).free_regions(free_regions))
}

/// All pipelines find the same; returns the number of contacts and what the one with orphans
/// counted.
fn check(mesh: &Mesh, x: &Ends, bodies: Option<&Bodies>, what: &str) -> (usize, TriangleCounts) {
    let (mut n, mut seen) = (0, TriangleCounts::default());
    for min_distance in [0.0, 0.02] {
        let of = |pipeline, threads| {
            Options::default()
                .with_min_distance(min_distance)
                .with_threads(threads)
                .with_bodies(bodies.cloned())
                .with_pipeline(pipeline)
        };
        let (want, none) = run(mesh, x, of(Pipeline::Features, 1));
        assert_eq!(none, None);
        let (plain, plain_counts) = run(mesh, x, of(triangles(false, false), 1));
        let (got, counts) = run(mesh, x, of(triangles(true, false), 2));
        assert!(plain == want, "{what}, distance {min_distance}: {plain:?}\n{want:?}");
        assert!(got == want, "{what}, distance {min_distance}: {got:?}\n{want:?}");
        let (plain, counts) = (plain_counts.expect("counts"), counts.expect("counts"));
        assert_eq!((plain.pairs, plain.adjacent, plain.orphans), (counts.pairs, 0, 0), "{what}");
        // Every test of every pair: more tests, the same pairs and contacts, each once.
        let all = Pipeline::Triangles(TriangleOptions::default().representatives(false));
        let (all, all_counts) = run(mesh, x, of(all, 2));
        let all_counts = all_counts.expect("counts");
        let of_one = |found: &Found| (found.contacts.clone(), found.toi, found.pairs.clone());
        assert!(of_one(&all) == of_one(&want), "{what}, all tests: {all:?}\n{want:?}");
        assert!(all.filtered.total() >= want.filtered.total(), "{what}: {all:?}");
        assert_eq!((all_counts.pairs, all_counts.adjacent), (plain.pairs, 0), "{what}");
        let whole = mesh.faces().len() * 3 == mesh.n_vertices() && mesh.faces().len() > 1;
        assert!(all_counts.represented >= plain.represented, "{what}");
        assert!(!whole || all_counts.represented == all_counts.all_tests(), "{what}");
        let mut free = [0; 2];
        for (orphans, threads) in [(false, 2), (true, 1)] {
            let (culled, counts) = run(mesh, x, of(triangles(orphans, true), threads));
            let counts = counts.expect("counts");
            free[orphans as usize] = counts.free;
            if counts.free == 0 && !orphans {
                assert_eq!(culled.pairs, want.pairs, "{what}");
            }
            assert!(min_distance == 0.0 || counts.free == 0, "{counts:?}");
            assert_eq!((&culled.contacts, culled.toi), (&want.contacts, want.toi), "{what}");
            for (few, all) in culled.pairs.iter().zip(&want.pairs) {
                assert!(few.iter().all(|pair| all.binary_search(pair).is_ok()), "{what}");
            }
        }
        assert!(free[0] >= free[1], "{what}: {free:?}");
        n += want.contacts.len();
        seen = seen.plus(counts);
        seen.free = seen.free - counts.free + free[1];
    }
    (n, seen)
}

#[test]
fn any_mesh_gives_what_features_give() {
    let mut random = Random::new(5);
    let (mut n, mut seen) = (0, TriangleCounts::default());
    for round in 0..80 {
        let n_vertices = 4 + random.below(40);
        let n_faces = random.below(2 * n_vertices);
        let mut corner = || random.below(n_vertices);
        let mut faces: Vec<[u32; 3]> =
            (0..n_faces).map(|_| [corner(), corner(), corner()]).collect();
        // A face twice, one with a corner twice, three at an edge, two with two edges in common.
        faces.extend([[0, 1, 2], [2, 1, 0], [0, 1, 3], [3, 3, 1], [2, 2, 2]]);
        let wires: Vec<[u32; 2]> = (0..6).map(|_| [corner(), corner()]).collect();
        let mesh = Mesh::with_edges(n_vertices as usize, &faces, &wires).expect("a mesh");
        let x0: Vec<_> = (0..n_vertices).map(|_| random.point()).collect();
        let speed = [0.1, 0.5, 2.0][round % 3];
        let x1: Vec<[f64; 3]> = x0
            .iter()
            .map(|p| {
                let q = random.point();
                [0, 1, 2].map(|k| p[k] + speed * (q[k] - 0.5))
            })
            .collect();
        let what = format!("faces {faces:?}, wires {wires:?}");
        let (contacts, counts) = check(&mesh, &[x0, x1], None, &what);
        n += contacts;
        seen = seen.plus(counts);
    }
    println!("{n} contacts, {seen:?}");
    assert!(n > 1000 && seen.adjacent > 1000 && seen.orphans > 1000, "{n}, {seen:?} show nothing");
}

/// A sheet of `n` by `n` vertices, rough, that folds over itself.
fn folded(n: usize, fold: f64) -> (Mesh, Ends) {
    let mut random = Random::new(9);
    let mut x = Vec::new();
    for k in 0..n * n {
        let [i, j] = [k / n, k % n].map(|i| i as f64 / n as f64);
        x.push([i, j, 0.5 / n as f64 * random.unit()]);
    }
    let mut faces = Vec::new();
    for k in 0..((n - 1) * (n - 1)) as u32 {
        let n = n as u32;
        let at = k / (n - 1) * n + k % (n - 1);
        faces.extend([[at, at + 1, at + n], [at + 1, at + n + 1, at + n]]);
    }
    // The right half comes over the left one.
    let moved = |p: &[f64; 3]| {
        let over = (p[0] - 0.5).max(0.0);
        [p[0] - 2.0 * fold * over, p[1] + 0.03 * over, p[2] + over * (1.0 - over) * 0.2]
    };
    let y = x.iter().map(moved).collect();
    (Mesh::new(n * n, &faces).expect("a mesh"), [x, y])
}

#[test]
fn sheets_with_bodies_and_without() {
    let (mesh, x) = folded(14, 1.0);
    let (n, counts) = check(&mesh, &x, None, "a sheet");
    println!("{n} contacts, {counts:?}");
    assert!(n > 100 && counts.orphans > 0, "{n}, {counts:?}");
    // While it comes up a little, it is certain not to touch itself; the parts that go over the
    // others are, each by itself.
    for (fold, least) in [(0.1, 200), (0.5, 100), (0.9, 50)] {
        let (mesh, x) = folded(14, fold);
        let (n, counts) = check(&mesh, &x, None, "a sheet that folds");
        println!("fold {fold}: {n} contacts, {counts:?}");
        assert!(counts.free > least, "{fold}: {counts:?}");
    }
    // Two sheets that go through each other, tested against each other only or also within; one
    // does not move.
    let n_vertices = mesh.n_vertices() as u32;
    let second = mesh.faces().iter().map(|f| f.map(|v| v + n_vertices));
    let faces: Vec<_> = mesh.faces().iter().copied().chain(second).collect();
    let both = Mesh::new(2 * n_vertices as usize, &faces).expect("a mesh");
    let fixed = x[0].iter().map(|p| [p[0] + 0.01, p[2] + 0.3, p[1]]);
    let y = [0, 1].map(|k| x[k].iter().copied().chain(fixed.clone()).collect());
    let body_of: Vec<u32> = (0..2 * n_vertices).map(|v| v / n_vertices).collect();
    for self_contact in [false, true] {
        let bodies = Bodies::new(&body_of)
            .with_fixed(1, true)
            .with_self_contacts(self_contact)
            .with_fixed_motion(true);
        let (some, counts) = check(&both, &y, Some(&bodies), "two sheets");
        assert!(some > 50 && (counts.orphans > 0) == self_contact, "{some}, {counts:?}");
    }
}

/// Where orphan sets would be too long, neighbours are expanded like all others.
#[test]
fn fans_have_no_orphan_sets() {
    let mut random = Random::new(3);
    let n = 260;
    let faces: Vec<[u32; 3]> = (1..=n).map(|i| [0, i, i % n + 1]).collect();
    let mesh = Mesh::new(n as usize + 1, &faces).expect("a mesh");
    let x: Ends = [0, 1].map(|_| {
        let at = |i: u32| [i as f64 / n as f64, 0.1 * random.unit(), 0.1 * random.unit()];
        (0..=n).map(at).collect()
    });
    let (contacts, counts) = check(&mesh, &x, None, "a fan");
    assert!(contacts > 20, "{contacts}");
    assert_eq!((counts.adjacent, counts.orphans), (0, 0));
}

#[test]
fn comparisons_can_fail() {
    let (mesh, x) = folded(14, 1.0);
    let of = |pipeline| Options::default().with_threads(1).with_pipeline(pipeline);
    let (want, _) = run(&mesh, &x, of(Pipeline::Features));
    // A face less.
    let fewer = Mesh::new(mesh.n_vertices(), &mesh.faces()[1..]).expect("a mesh");
    assert_ne!(run(&fewer, &x, of(triangles(true, false))).0, want);
    // A vertex elsewhere.
    let mut y = x.clone();
    y[1][100][2] -= 0.3;
    let (got, _) = run(&mesh, &y, of(triangles(true, false)));
    assert_ne!(got.pairs, want.pairs);
}
