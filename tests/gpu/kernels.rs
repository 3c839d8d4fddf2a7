//! Every kernel of the table by itself against a plain twin, on generated scenes and on poison: NaN, denormals, huge numbers, thresholds.

use crate::scenes::check_pairs;
use crate::twin::{Twin, union};
use ccd::gpu::{BroadPhase, Device, Sorter, harness};
use ccd::{Aabb, Pair, Verdict};
use ccd_core::kernel::{Id, blocks, bounds, decide, sort};
use ccd_core::layout::{LIST_HEADER, Leaf, Params, Path};
use ccd_testkit::generate::{Random, Step, crumpled_sheet, triangle_soup, uniform_boxes};
use ccd_testkit::{brute, compare};

pub const TESTS: crate::Tests = &[
    ("sweep", check_sweep),
    ("shorten", check_shorten),
    ("bounds_and_codes", check_bounds),
    ("sort", check_sort),
    ("fit", check_fit),
    ("node_pairs", check_node_pairs),
    ("candidates", check_candidates),
    ("filters", check_filters),
    ("folded_grid", check_folded),
    ("uniform_boxes", check_uniform),
];

fn bytes<T: bytemuck::Pod>(x: &[T]) -> Vec<u8> {
    bytemuck::cast_slice(x).to_vec()
}

fn read<T: bytemuck::Pod>(bytes: &[u8]) -> Vec<T> {
    bytemuck::pod_collect_to_vec(bytes)
}

const POISON: [f32; 14] =
    [0.0, -0.0, 1e-45, -1e-40, f32::MIN_POSITIVE, 1.0, -1.0, 1e30, -1e38, 2.9e38, -2.9e38, 3.4e38, f32::NAN, f32::INFINITY];

/// Paths of a scene, and paths of poison.
fn paths(step: &Step, poison: bool) -> Vec<Path> {
    let four = |p: &[f64; 3]| [p[0] as f32, p[1] as f32, p[2] as f32, 0.0];
    let mut out: Vec<Path> = step.x0.iter().zip(&step.x1).map(|(p, q)| Path { t0: four(p), t1: four(q) }).collect();
    let mut random = Random::new(4);
    let mut pick = || POISON[random.below(POISON.len() as u32) as usize];
    if poison {
        out.iter_mut().step_by(3).for_each(|p| *p = Path { t0: [pick(), pick(), pick(), 0.0], t1: [pick(), pick(), pick(), 0.0] });
    }
    out
}

/// Equal bits, or both NaN, or both so small that a device may flush them.
fn same(a: f32, b: f32) -> bool {
    let small = |x: f32| x.abs() < f32::MIN_POSITIVE;
    a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan() || small(a) && small(b)
}

fn check_boxes(what: &str, want: &[Aabb], got: &[Aabb]) {
    assert_eq!(want.len(), got.len(), "{what}");
    for (i, (w, g)) in want.iter().zip(got).enumerate() {
        let fine = (0..3).all(|k| same(w.min[k], g.min[k]) && same(w.max[k], g.max[k]));
        assert!(fine, "{what} {i}: {w:?} on the CPU, {g:?} on the device");
    }
}

/// A path's box, by hand.
fn swept(p: &Path) -> Aabb {
    let low = |a: f32, b: f32| if a < b { a } else { b };
    let high = |a: f32, b: f32| if a > b { a } else { b };
    let clamp = |x: f32| low(high(x, -2.9e38), 2.9e38);
    Aabb { min: std::array::from_fn(|k| clamp(low(p.t0[k], p.t1[k]))), max: std::array::from_fn(|k| clamp(high(p.t0[k], p.t1[k]))) }
}

fn check_sweep(device: &Device) {
    for poison in [false, true] {
        let step = triangle_soup(500, 0.3, 1);
        let (paths, mesh) = (paths(&step, poison), &step.mesh);
        let count = [mesh.n_vertices() as u32, mesh.edges().len() as u32, mesh.faces().len() as u32];
        let start = [0, count[0], count[0] + count[1], count[0] + count[1] + count[2]];
        let params = Params { count, start, ..Params::default() };
        let mut want: Vec<Aabb> = paths.iter().map(swept).collect();
        let vertices = want.clone();
        let mut buffers = [bytes(&paths), vec![0; start[3] as usize * 24]];
        harness::run(device, Id::SweepVertices, &params, &mut buffers, count[0].div_ceil(256), 65_535).unwrap();
        let mut got: Vec<Aabb> = read(&buffers[1][..want.len() * 24]);
        // Of a number and NaN either may be the smaller: hosts refuse NaN, and a box that has one is of no other vertex.
        for i in (0..paths.len()).filter(|&i| paths[i].t0.iter().chain(&paths[i].t1).any(|x| x.is_nan())) {
            got[i] = want[i];
        }
        check_boxes("vertex", &want, &got);
        if poison {
            continue;
        }
        want.extend(mesh.edges().iter().map(|e| union(e.iter().map(|&v| &vertices[v as usize]))));
        want.extend(mesh.faces().iter().map(|f| union(f.iter().map(|&v| &vertices[v as usize]))));
        let mut edges = [bytes(mesh.edges()), buffers[1].clone()];
        harness::run(device, Id::SweepEdges, &params, &mut edges, count[1].div_ceil(256), 65_535).unwrap();
        let mut faces = [bytes(mesh.faces()), edges[1].clone()];
        harness::run(device, Id::SweepFaces, &params, &mut faces, count[2].div_ceil(256), 65_535).unwrap();
        check_boxes("box", &want, &read(&faces[1]));
        // Grown boxes hold the exact ones with the margin.
        let grown = Params { margin: 0.125, ..params };
        harness::run(device, Id::SweepVertices, &grown, &mut buffers, count[0].div_ceil(256), 65_535).unwrap();
        for (b, v) in read::<Aabb>(&buffers[1][..vertices.len() * 24]).iter().zip(&vertices) {
            assert!(
                (0..3).all(|k| b.min[k] as f64 <= v.min[k] as f64 - 0.125 && b.max[k] as f64 >= v.max[k] as f64 + 0.125),
                "{b:?} {v:?}"
            );
            assert!((0..3).all(|k| b.max[k] - v.max[k] < 0.1251), "{b:?} {v:?}");
        }
    }
}

fn check_shorten(device: &Device) {
    let paths = paths(&triangle_soup(200, 0.3, 2), false);
    let params = Params { count: [paths.len() as u32, 0, 0], ..Params::default() };
    for (key, until) in [(0.25f32.to_bits(), 0.25), (0, 0.0), (decide::NEVER, 1.0), (1.0f32.to_bits(), 1.0)] {
        let mut buffers = [bytes(&paths), bytes(&[key, 0, 0, 0]), vec![0; paths.len() * 32]];
        harness::run(device, Id::Shorten, &params, &mut buffers, params.count[0].div_ceil(256), 65_535).unwrap();
        for (p, got) in paths.iter().zip(read::<Path>(&buffers[2])) {
            for k in 0..3 {
                let want = p.t0[k] as f64 + (p.t1[k] as f64 - p.t0[k] as f64) * until;
                assert!(got.t0[k] == p.t0[k] && (got.t1[k] as f64 - want).abs() <= 4e-7 * 2.0, "{p:?} until {until}: {got:?}");
            }
        }
    }
}

fn twin(n: usize, seed: u32) -> (Twin, Step) {
    let step = crumpled_sheet(n, seed);
    let single = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<[f32; 3]>>();
    let sets = brute::swept_boxes(&step.mesh, &single(&step.x0), &single(&step.x1));
    let mesh = step.mesh.clone();
    let twin = Twin::new([&sets[0], &sets[1], &sets[2]], |set, i| match set {
        0 => [i; 3],
        1 => [mesh.edges()[i as usize][0], mesh.edges()[i as usize][1], mesh.edges()[i as usize][1]],
        _ => mesh.faces()[i as usize],
    });
    (twin, step)
}

fn check_bounds(device: &Device) {
    let (twin, _) = twin(60, 1);
    let n = twin.boxes.len() as u32;
    let params = Params { n, ..twin.params };
    let mut buffers = [bytes(&twin.boxes), vec![0; 32]];
    harness::run(device, Id::SceneBounds, &params, &mut buffers, n.div_ceil(2048), 65_535).unwrap();
    let words: Vec<u32> = read(&buffers[1]);
    let scene = union(twin.boxes.iter());
    check_boxes("scene", &[scene], &[bounds::merged(&words)]);
    let mut buffers = [bytes(&twin.boxes), buffers[1].clone(), vec![0; n as usize * 4], vec![0; n as usize * 4]];
    harness::run(device, Id::Morton, &params, &mut buffers, n.div_ceil(256), 65_535).unwrap();
    let keys: Vec<u32> = read(&buffers[2]);
    // A scale that was rounded otherwise (division is good to 2.5 units) may put a centre into a neighbouring cell.
    let same = keys.iter().zip(&twin.keys).filter(|(a, b)| a == b).count();
    assert!(
        keys.iter().zip(&twin.keys).all(|(a, b)| a >> 30 == b >> 30) && same * 1000 >= keys.len() * 998,
        "{same} of {} keys",
        keys.len()
    );
    assert!(read::<u32>(&buffers[3]).into_iter().eq(0..n));
}

fn check_sort(device: &Device) {
    let mut random = Random::new(3);
    for n in [1u32, 31, 2047, 2048, 2049, 100_003] {
        for few in [false, true] {
            let keys: Vec<u32> = (0..n).map(|_| if few { random.below(3) * 0x0100_0001 } else { random.bits() }).collect();
            let values: Vec<u32> = (0..n).collect();
            let (got_keys, got_values) = Sorter::new(device, n).unwrap().sort(&keys, &values).unwrap();
            let mut want: Vec<(u32, u32)> = keys.iter().copied().zip(values).collect();
            want.sort();
            assert!(want.into_iter().eq(got_keys.into_iter().zip(got_values)), "{n} keys, few different: {few}");
        }
    }
    // The first two kernels by themselves.
    let n = 10_000u32;
    let keys: Vec<u32> = (0..n).map(|_| random.bits()).collect();
    let n_tiles = n.div_ceil(sort::TILE);
    let params = Params { n, n_tiles, shift: 8, ..Params::default() };
    let mut buffers = [bytes(&keys), vec![0; (n_tiles as usize + 1) * 1024]];
    harness::run(device, Id::SortCount, &params, &mut buffers, n_tiles, 65_535).unwrap();
    let mut want = vec![0u32; 256 * (n_tiles as usize + 1)];
    keys.iter().enumerate().for_each(|(i, k)| want[(k >> 8 & 255) as usize * n_tiles as usize + i / sort::TILE as usize] += 1);
    assert_eq!(read::<u32>(&buffers[1]), want);
    let mut table = [buffers[1].clone()];
    harness::run(device, Id::SortScan, &params, &mut table, 256, 65_535).unwrap();
    for d in 0..256 {
        let row = &mut want[d * n_tiles as usize..(d + 1) * n_tiles as usize];
        let total = row.iter_mut().fold(0, |sum, count| {
            let before = sum;
            let next = sum + *count;
            *count = before;
            next
        });
        want[256 * n_tiles as usize + d] = total;
    }
    assert_eq!(read::<u32>(&table[0]), want);
}

fn check_fit(device: &Device) {
    let (twin, step) = twin(40, 2);
    let params = &twin.params;
    let empty = vec![Aabb::EMPTY; twin.nodes.len()];
    let mut buffers = [
        bytes(&twin.boxes),
        bytes(&twin.order),
        bytes(step.mesh.edges()),
        bytes(step.mesh.faces()),
        bytes(&empty),
        vec![0; twin.leaves.len() * 16],
    ];
    harness::run(device, Id::FitLeaves, params, &mut buffers, (params.slots[0][3]).div_ceil(256), 65_535).unwrap();
    let second = params.slots[2][0] as usize;
    check_boxes("node", &twin.nodes[..second], &read::<Aabb>(&buffers[4])[..second]);
    assert!(read::<Leaf>(&buffers[5]) == twin.leaves);
    let mut nodes = [buffers[4].clone()];
    let p = Params { level: 1, ..*params };
    harness::run(device, Id::FitLevel, &p, &mut nodes, (params.slots[1][3] - params.slots[1][0]).div_ceil(256), 65_535).unwrap();
    let third = params.slots[3][0] as usize;
    check_boxes("node", &twin.nodes[..third], &read::<Aabb>(&nodes[0])[..third]);
}

fn list(pairs: &[Pair]) -> Vec<u8> {
    let mut words = vec![pairs.len() as u32, 0, 0, 0];
    words.extend(pairs.iter().flat_map(|p| [p.a, p.b]));
    bytes(&words)
}

fn entries(list: &[u8]) -> Vec<Pair> {
    let words: Vec<u32> = read(list);
    words[LIST_HEADER..LIST_HEADER + 2 * words[0] as usize].chunks_exact(2).map(|p| Pair { a: p[0], b: p[1] }).collect()
}

fn room(n: u32) -> Vec<u8> {
    vec![0; 4 * (LIST_HEADER + 2 * n as usize)]
}

fn check_node_pairs(device: &Device) {
    let (twin, _) = twin(70, 3);
    for kind in [0, 1] {
        let above = twin.node_pairs(2, kind);
        let want = twin.node_pairs(1, kind);
        let p = Params { kind, level: 2, room_in: above.len() as u32, room_out: 50_000, ..twin.params };
        // Few workgroups, so that each takes several rounds; many, so that some have nothing to do.
        for groups in [1, 3, 500] {
            let mut buffers = [bytes(&twin.nodes), list(&above), room(50_000)];
            harness::run(device, Id::NodePairs, &p, &mut buffers, groups, 65_535).unwrap();
            check_pairs("node pairs", want.clone(), entries(&buffers[2]));
        }
        // A list that is too short counts everything and writes nothing beyond its end.
        let short = Params { room_out: 10, ..p };
        let mut buffers = [bytes(&twin.nodes), list(&above), room(20)];
        harness::run(device, Id::NodePairs, &short, &mut buffers, 7, 65_535).unwrap();
        let words: Vec<u32> = read(&buffers[2]);
        assert_eq!(words[0] as usize, want.len());
        assert!(words[LIST_HEADER + 20..].iter().all(|&w| w == 0), "written beyond the room");
    }
}

/// Candidates by testing each feature against each.
fn candidates(twin: &Twin, step: &Step, kind: u32) -> Vec<Pair> {
    let single = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<[f32; 3]>>();
    let [vf, ee] = brute::candidates(&step.mesh, &single(&step.x0), &single(&step.x1));
    assert_eq!(twin.params.count[1] as usize, step.mesh.edges().len());
    if kind == 0 { vf } else { ee }
}

fn check_candidates(device: &Device) {
    let (twin, step) = twin(50, 4);
    for kind in [0, 1] {
        let want = candidates(&twin, &step, kind);
        let blocks = twin.node_pairs(1, kind);
        let p = Params { kind, level: 1, room_in: blocks.len() as u32, room_out: 100_000, ..twin.params };
        let mut buffers = [bytes(&twin.nodes), bytes(&twin.leaves), vec![0; 16], vec![0; 48], list(&blocks), room(100_000)];
        harness::run(device, Id::ListCandidates, &p, &mut buffers, 9, 65_535).unwrap();
        check_pairs("candidates", want, entries(&buffers[5]));
    }
    // So many hits at once that the pool of a workgroup overflows: every box overlaps every other.
    let boxes = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 200];
    let twin = Twin::new([&[], &boxes, &[]], |_, i| [2 * i, 2 * i + 1, 2 * i + 1]);
    let blocks = twin.node_pairs(1, 1);
    let p = Params { kind: 1, level: 1, room_in: blocks.len() as u32, room_out: 20_000, ..twin.params };
    let mut buffers = [bytes(&twin.nodes), bytes(&twin.leaves), vec![0; 16], vec![0; 48], list(&blocks), room(20_000)];
    harness::run(device, Id::ListCandidates, &p, &mut buffers, 2, 65_535).unwrap();
    const { assert!(4 * 1024 > blocks::POOL) };
    check_pairs("boxes on one another", brute::self_pairs(&boxes), entries(&buffers[5]));
}

/// What the filters leave is a part of the candidates, and what they drop certainly does not touch.
fn check_filters(device: &Device) {
    let (twin, step) = twin(40, 5);
    let paths = paths(&step, false);
    for (kind, id) in [(0, Id::FilterVertexFace), (1, Id::FilterEdgeEdge)] {
        let all = candidates(&twin, &step, kind);
        let blocks = twin.node_pairs(1, kind);
        let p = Params { kind, level: 1, room_in: blocks.len() as u32, room_out: 100_000, ..twin.params };
        let mut buffers = [bytes(&twin.nodes), bytes(&twin.leaves), vec![0; 16], vec![0; 48], bytes(&paths), list(&blocks), room(100_000)];
        harness::run(device, id, &p, &mut buffers, 9, 65_535).unwrap();
        let words: Vec<u32> = read(&buffers[6]);
        assert_eq!(words[1] as usize, all.len(), "candidates that were counted");
        let mut left = entries(&buffers[6]);
        left.sort_unstable();
        assert!(left.windows(2).all(|w| w[0] != w[1]) && left.len() < all.len() / 2, "{} of {} are left", left.len(), all.len());
        let mut n_touching = 0;
        for pair in all {
            let touches = verdict(&step, kind, pair, &paths) != Verdict::Miss;
            n_touching += touches as usize;
            assert!(!touches || left.binary_search(&pair).is_ok(), "{pair:?} touches and was dropped");
        }
        assert!(n_touching > 100, "{n_touching} contacts show nothing");
    }
}

fn verdict(step: &Step, kind: u32, pair: Pair, paths: &[Path]) -> Verdict<f64> {
    use ccd_core::kernel::narrow;
    let x = |end: fn(&Path) -> [f32; 4]| {
        paths
            .iter()
            .map(|p| {
                let p = end(p);
                [p[0], p[1], p[2]]
            })
            .collect::<Vec<[f32; 3]>>()
    };
    let (x0, x1) = (x(|p| p.t0), x(|p| p.t1));
    match kind {
        0 => narrow::vertex_face(narrow::vertex_face_ids(pair, step.mesh.faces()), &x0, &x1, 0.0, 0.0),
        _ => narrow::edge_edge(narrow::edge_edge_ids(pair, step.mesh.edges()), &x0, &x1, 0.0, 0.0),
    }
}

/// A grid that is folded into rows gives what one row gives, also where the last row is not full.
fn check_folded(device: &Device) {
    let paths = paths(&triangle_soup(3000, 0.3, 6), false);
    let params = Params { count: [paths.len() as u32, 0, 0], ..Params::default() };
    let want: Vec<Aabb> = paths.iter().map(swept).collect();
    for fold in [1, 7, 16, 65_535] {
        let mut buffers = [bytes(&paths), vec![0; want.len() * 24]];
        harness::run(device, Id::SweepVertices, &params, &mut buffers, params.count[0].div_ceil(256), fold).unwrap();
        check_boxes("vertex", &want, &read(&buffers[1]));
    }
}

fn check_uniform(device: &Device) {
    let boxes = uniform_boxes(100_000);
    let mut broad = BroadPhase::new(device).unwrap();
    let pairs = broad.self_pairs(&boxes).unwrap();
    assert_eq!(pairs.len(), 320);
    let mut cpu = ccd::BroadPhase::new(2, ccd::Method::Blocks).unwrap();
    check_pairs("uniform boxes", cpu.self_pairs(&boxes).unwrap().to_vec(), pairs);
    let (a, b) = (&boxes[..3000], &boxes[3000..9000]);
    let grown = |boxes: &[Aabb]| boxes.iter().map(|b| b.inflated(0.02)).collect::<Vec<_>>();
    check_pairs("two sets", brute::pairs(&grown(a), &grown(b)), broad.pairs(&grown(a), &grown(b)).unwrap());
    // Sets without a pair, with one box, with none; boxes that are points; boxes as large as they may be.
    assert!(broad.self_pairs(&[]).unwrap().is_empty() && broad.self_pairs(&boxes[..1]).unwrap().is_empty());
    assert!(broad.pairs(&[], b).unwrap().is_empty());
    let odd =
        [Aabb { min: [0.0; 3], max: [0.0; 3] }, Aabb { min: [-2.9e38; 3], max: [2.9e38; 3] }, Aabb { min: [1e-40; 3], max: [2e-40; 3] }];
    let found = broad.self_pairs(&odd).unwrap();
    assert!(found.len() >= 2 && found.contains(&Pair { a: 0, b: 1 }) && found.contains(&Pair { a: 1, b: 2 }), "{found:?}");
    assert!(broad.self_pairs(&[Aabb { min: [f32::NAN; 3], max: [1.0; 3] }]).is_err());
    assert!(broad.self_pairs(&[Aabb { min: [1.0; 3], max: [0.0; 3] }]).is_err());
}

/// The comparisons fail when they should.
pub fn check_negative_controls() {
    let a = Aabb { min: [0.0; 3], max: [1.0; 3] };
    let mut b = a;
    b.max[2] = 1.0f32.next_up();
    assert!(!compare::fails(|| check_boxes("control", &[a], &[a])));
    assert!(compare::fails(|| check_boxes("control", &[a], &[b])), "another box passes");
    assert!(compare::fails(|| check_boxes("control", &[a, a], &[a])), "a missing box passes");
    assert!(same(f32::NAN, -f32::NAN) && same(0.0, 1e-40) && !same(0.0, 1e-37) && !same(1.0, f32::NAN));
}
