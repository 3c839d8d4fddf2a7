//! Triangles first: the kernels that expand pairs of triangles, each by itself, against all pairs
//! of features by brute force; whole steps by every method, against pairs of features on the same
//! device and against triangles on the CPU, number by number.

use crate::emulated::{is_thin, methods};
use crate::scenes::{check_pairs, check_step};
use crate::support::{bytes, capacity, check_boxes, entries, list, read, run, twin, zeros};
use crate::twin::union;
use ccd::gpu::bind::{ExpandTriangles, NearTests, SweepTriangles};
use ccd::gpu::{Candidates, Device, Error, Session};
use ccd::method::{Pipeline, TriangleOptions};
use ccd::{Aabb, Bodies, Mesh, Options, Pair};
use ccd_core::backend::layout::{Dispatch, Expansion, Params, Triangle};
use ccd_core::backend::triangle_pairs::feature_pairs::{COUNT_STRIDE, N_COUNTS};
use ccd_core::backend::triangle_pairs::near_tests;
use ccd_core::backend::triangle_pairs::orphans::OrphanSets;
use ccd_core::backend::triangle_pairs::representatives::Triangles;
use ccd_testkit::generate::{Random, Step, crumpled_sheet};
use ccd_testkit::{brute, compare};

pub const TESTS: crate::Tests = &[
    ("triangle_kernels", check_kernels),
    ("triangles_by_every_method", check_methods),
    ("triangles_of_bodies", check_bodies),
    ("triangles_in_free_regions", check_free_regions),
    ("triangles_in_several_dispatches", check_many),
];

fn triangles(orphans: bool, free_regions: bool) -> Options {
    let triangles = TriangleOptions::default().orphans(orphans).free_regions(free_regions);
    Options::default().with_pipeline(Pipeline::Triangles(triangles))
}

/// Faces with corners near one another or twice, one of them twice, wires, vertices in nothing.
fn odd_mesh(seed: u32) -> Step {
    let mut random = Random::new(seed);
    let n = 90;
    let mut near = |k: u32| k * 3 / 4 + random.below(12);
    let mut faces: Vec<[u32; 3]> = (0..n).map(|k| [near(k), near(k), near(k)]).collect();
    faces.push(faces[7]);
    let wires: Vec<[u32; 2]> = (0..12).map(|k| [near(6 * k), near(6 * k)]).collect();
    let n_vertices = n as usize;
    let mesh = Mesh::with_edges(n_vertices, &faces, &wires).unwrap();
    let mut points = || (0..n_vertices).map(|_| random.point()).collect::<Vec<_>>();
    let (x0, mut x1) = (points(), points());
    for (p, q) in x0.iter().zip(&mut x1) {
        *q = std::array::from_fn(|k| p[k] + 0.4 * (q[k] - 0.5));
    }
    Step { mesh, x0, x1 }
}

/// What an expansion makes, in parts as dispatches of many items are, with these capacities.
struct Made {
    lists: [Vec<u8>; 2],
    counts: [u64; N_COUNTS],
}

fn check_kernels(device: &Device) {
    let (twin, step) = twin(28, 5);
    let triangles = Triangles::new(&step.mesh);
    let n = triangles.len() as u32;
    let records: Vec<Triangle> = (0..n).map(|t| triangles.record(t, 0)).collect();
    // Boxes of triangles.
    let kernel = SweepTriangles {
        triangles: bytes(&records),
        boxes: bytes(&twin.boxes),
        swept: zeros::<Aabb>(n as usize),
    };
    let done = run(device, kernel, &twin.plain(Dispatch { n, ..Dispatch::default() }), 9);
    let swept: Vec<Aabb> = read(&done.swept);
    let of = |t: u32| union(triangles.corners(t).iter().map(|&v| &twin.boxes[v as usize]));
    check_boxes("triangle", &(0..n).map(of).collect::<Vec<_>>(), &swept);
    // Pairs of triangles, with and without those that share a vertex.
    let pairs = brute::self_pairs(&swept);
    let of_set = |k: usize| {
        let [from, to] = [k, k + 1].map(|k| twin.frame.start[k] as usize);
        twin.boxes[from..to].to_vec()
    };
    let want = brute::candidates_among(&step.mesh, &[0, 1, 2].map(of_set));
    let sets = OrphanSets::new(&step.mesh, &triangles).unwrap();
    let near = near_tests::NearTests::new(&sets, &triangles, |_| true).unwrap();
    let expand = |flags, capacities: [u32; 2]| {
        let (n_vf, orphans) = (near.n_vf, near.orphans);
        let args = Expansion { flags, capacity_ee: capacities[1], n_vf, orphans, rules: 0 };
        let (n_pairs, n_near) = (pairs.len() as u32, near.tests.len() as u32);
        let mut made = ExpandTriangles {
            triangles: bytes(&records),
            regions: vec![0; 16],
            boxes: bytes(&twin.boxes),
            input: list(&pairs),
            vf: capacity(capacities[0]),
            ee: capacity(capacities[1]),
            counts: zeros::<u32>(N_COUNTS * COUNT_STRIDE),
        };
        let params = |n, first, capacity_in| {
            let dispatch = Dispatch { n, first, capacity_in, capacity_out: capacities[0] };
            Params { frame: twin.frame, dispatch, args }
        };
        for (first, n) in [(0, n_pairs / 3), (n_pairs / 3, n_pairs)] {
            made = run(device, made, &params(n, first, n_pairs), 3);
        }
        if flags & Expansion::FLAG_ORPHANS != 0 {
            let ExpandTriangles { regions, boxes, vf, ee, counts, .. } = made.clone();
            let (tests, swept) = (bytes(&near.tests), bytes(&swept));
            let mut more = NearTests { tests, regions, swept, boxes, vf, ee, counts };
            for (first, end) in [(0, n_near / 2), (n_near / 2, n_near)] {
                more = run(device, more, &params(end - first, first, n_near), 3);
            }
            (made.vf, made.ee, made.counts) = (more.vf, more.ee, more.counts);
        }
        let words: Vec<u32> = read(&made.counts);
        let counts = std::array::from_fn(|k| words[k * COUNT_STRIDE] as u64);
        Made { lists: [made.vf, made.ee], counts }
    };
    for flags in [0, Expansion::FLAG_ORPHANS] {
        let capacities = [200_000; 2];
        let Made { lists, counts: [n_pairs, adjacent, _, represented, orphans] } =
            expand(flags, capacities);
        assert_eq!(n_pairs, pairs.len() as u64);
        let is_adjacent = |p: &&Pair| triangles.adjacent(p.a, p.b);
        let n_adjacent = pairs.iter().filter(is_adjacent).count() as u64;
        let n_orphans = (near.orphans[1] - near.orphans[0]) as u64;
        let skipped = if flags == 0 { [0, 0] } else { [n_adjacent, n_orphans] };
        assert_eq!([adjacent, orphans], skipped);
        assert!(represented > (want[0].len() + want[1].len()) as u64 && n_orphans > 0);
        for (kind, want) in want.iter().enumerate() {
            let found = entries(&lists[kind]);
            let fails =
                compare::fails(|| check_pairs("control", want[1..].to_vec(), found.clone()));
            check_pairs("expanded triangles", want.clone(), found);
            assert!(fails, "a pair too many passes");
        }
        // Lists that are too short count everything; what is in them is right.
        let short = expand(flags, [30, 50]).lists;
        for (kind, capacity) in [(0, 30), (1, 50)] {
            let words: Vec<u32> = read(&short[kind]);
            assert_eq!(words[0] as usize, want[kind].len());
            let mut listed: Vec<Pair> = bytemuck::pod_collect_to_vec(&short[kind][16..]);
            listed.sort_unstable();
            listed.dedup();
            assert!(listed.len() == capacity && listed.iter().all(|p| want[kind].contains(p)));
        }
    }
}

fn candidates(device: &Device, step: &Step, options: &Options) -> Candidates {
    let mut session = Session::new(device, step.mesh.clone(), options.clone()).unwrap();
    session.candidates(&step.x0, &step.x1).unwrap()
}

/// The candidates of a step, which pairs of features have as well.
fn check_candidates(device: &Device, step: &Step, features: &Options, options: &Options) {
    let (want, found) = (candidates(device, step, features), candidates(device, step, options));
    let name = options.broad_phase;
    check_pairs(&format!("{name} vf"), want.vf, found.vf);
    check_pairs(&format!("{name} ee"), want.ee, found.ee);
}

/// Candidates, counts, contacts and the earliest time by every method; on an emulated GPU with
/// orphans and without them in turn.
fn check_methods(device: &Device) {
    let sheet = crumpled_sheet(16, 3);
    for (k, broad_phase) in methods(device).enumerate() {
        let odd = odd_mesh(3 + k as u32);
        for orphans in [k % 2 == 0, k % 2 == 1].into_iter().take(2 - is_thin(device) as usize) {
            let options = triangles(orphans, false).with_broad_phase(broad_phase);
            check_candidates(device, &odd, &Options::default(), &options);
            check_step(device, &odd, options);
        }
    }
    for orphans in [false, true] {
        let options = triangles(orphans, false);
        check_candidates(device, &sheet, &Options::default(), &options);
        check_step(device, &sheet, options);
    }
}

/// Neighbours of bodies: two sheets, one of which stands still, at a distance. `rules.rs` has
/// bodies without neighbours.
fn check_bodies(device: &Device) {
    let (mut sheet, other) = (crumpled_sheet(12, 3), crumpled_sheet(12, 4));
    let n = sheet.x0.len() as u32;
    let shifted = other.mesh.faces().iter().map(|f| f.map(|v| v + n));
    let faces: Vec<[u32; 3]> = sheet.mesh.faces().iter().copied().chain(shifted).collect();
    sheet.mesh = Mesh::new(2 * n as usize, &faces).unwrap();
    sheet.x0.extend(&other.x0);
    sheet.x1.extend(&other.x0);
    let body: Vec<u32> = (0..2 * n).map(|v| v / n).collect();
    for self_contact in [false, true] {
        let bodies = Some(
            Bodies::new(&body)
                .with_fixed(1, true)
                .with_self_contacts(self_contact)
                .with_fixed_motion(true),
        );
        let features = Options::default().with_bodies(bodies).with_min_distance(0.003);
        for orphans in [false, true] {
            let options = features.clone().with_pipeline(triangles(orphans, true).pipeline);
            check_candidates(device, &sheet, &features, &options);
            check_step(device, &sheet, options);
        }
    }
}

/// Regions are certified from every step's own positions; the contacts are those of features, the
/// candidates are fewer.
fn check_free_regions(device: &Device) {
    // A flat part that moves as one and a crumpled one.
    let mut step = crumpled_sheet(24, 3);
    for (i, (p, q)) in step.x0.iter_mut().zip(&mut step.x1).enumerate() {
        if i % 24 < 14 {
            *p = [(i % 24) as f64 / 24.0, 0.02 * p[1], (i / 24) as f64 / 24.0];
            *q = [p[0], p[1] + 0.05, p[2]];
        }
    }
    let options = triangles(true, true);
    check_step(device, &step, options.clone());
    let mut session = Session::new(device, step.mesh.clone(), options.clone()).unwrap();
    let report = session.step(&step.x0, &step.x1).unwrap().clone();
    assert!(report.triangles.unwrap().free > 100, "{report:?} shows nothing");
    let mut features = Session::new(device, step.mesh.clone(), Options::default()).unwrap();
    let want = features.step(&step.x0, &step.x1).unwrap().contacts.clone();
    assert_eq!(report.contacts, want);
    let want = candidates(device, &step, &Options::default());
    let found = candidates(device, &step, &options);
    let fewer = compare::fails(|| check_pairs("control", want.ee, found.ee));
    assert!(fewer, "no candidate is in a free region");
    // What was free is no more.
    let crumpled = crumpled_sheet(24, 3);
    let report = session.step(&crumpled.x0, &crumpled.x1).unwrap();
    let cpu = ccd::step(&step.mesh, &crumpled.x0, &crumpled.x1, &options).unwrap();
    assert_eq!(report.triangles, cpu.triangles);
    // Paths that an application writes are not seen by the host.
    let mut encoder = device.wgpu().create_command_encoder(&Default::default());
    let refused = session.record(&mut encoder).map(|_| ());
    assert!(matches!(refused, Err(Error::PathsUnseen)), "{refused:?}");
    let near = options.with_min_distance(0.001);
    for options in [triangles(true, false), near] {
        let mut session = Session::new(device, step.mesh.clone(), options).unwrap();
        session.record(&mut encoder).unwrap();
    }
}

/// More pairs of triangles than one dispatch takes: two faces that cross, 760 times each.
fn check_many(device: &Device) {
    let n = 760;
    let faces: Vec<[u32; 3]> = [[[0, 1, 2]; 760], [[3, 4, 5]; 760]].concat();
    let mesh = Mesh::new(6, &faces).unwrap();
    let x0 = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].into_iter();
    let x0: Vec<_> = x0.chain([[0.2, 0.5, 0.2], [0.3, 1.5, 0.2], [0.2, 1.5, 0.3]]).collect();
    let x1 = x0.iter().map(|&[x, y, z]| [x, if y > 0.0 { y - 1.0 } else { y }, z]).collect();
    let step = Step { mesh, x0, x1 };
    let options = triangles(false, false).with_broad_phase(ccd::method::BroadPhaseMethod::TREE);
    let mut session = Session::new(device, step.mesh.clone(), options.clone()).unwrap();
    let counts = session.step(&step.x0, &step.x1).unwrap().triangles.unwrap();
    assert_eq!(counts.pairs, 2 * n * (2 * n - 1) / 2);
    assert!(counts.pairs > 1 << 20);
    // So many neighbours have too many orphans to list: none is skipped.
    let with_sets = options.clone().with_pipeline(Pipeline::TRIANGLES);
    let mut other = Session::new(device, step.mesh.clone(), with_sets).unwrap();
    assert_eq!(other.step(&step.x0, &step.x1).unwrap().triangles, Some(counts));
    check_candidates(device, &step, &Options::default(), &options);
    check_step(device, &step, options);
}
