//! Every kernel of the table by itself against a plain twin, on generated scenes and on poison: NaN, denormals, huge numbers, thresholds.

use crate::scenes::check_pairs;
use crate::twin::{Twin, union};
use ccd::gpu::{BroadPhase, Device, Sorter, harness};
use ccd::{Aabb, Method, Pair, Verdict};
use ccd_core::kernel::{Id, blocks, bounds, decide, sort};
use ccd_core::layout::{Branch, LIST_HEADER, Leaf, Node, Params, Path, Touch, split};
use ccd_testkit::generate::{Random, Step, crumpled_sheet, triangle_soup, uniform_boxes};
use ccd_testkit::{brute, compare};

pub const TESTS: crate::Tests = &[
    ("place", check_place),
    ("sweep", check_sweep),
    ("shorten", check_shorten),
    ("bounds_and_codes", check_bounds),
    ("sort", check_sort),
    ("order_of_contacts", check_order),
    ("fit", check_fit),
    ("radix_tree", check_radix_tree),
    ("node_pairs", check_node_pairs),
    ("counts", check_counts),
    ("candidates", check_candidates),
    ("filters", check_filters),
    ("folded_grid", check_folded),
    ("largest_grid", check_largest_grid),
    ("uniform_boxes_by_blocks", |device| check_uniform(device, Method::Blocks)),
    ("uniform_boxes_by_tree", |device| check_uniform(device, Method::Tree)),
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

/// What a device with `f64` makes of positions is what the host makes for those without, bit for bit; boxes hold the exact ones.
fn check_place(device: &Device) {
    if !device.info().wide {
        return;
    }
    let mut random = Random::new(9);
    let thresholds = [0.0, -0.0, 1e-300, -1e-40, 1e-38, f32::MIN_POSITIVE as f64, 1.0 / 3.0, -1e30, 1e90, -1e100];
    let mut position = |i: u32| -> [f64; 3] {
        std::array::from_fn(|_| if i.is_multiple_of(3) { thresholds[random.below(10) as usize] } else { random.unit() * 8.0 - 1.0 })
    };
    let n = 1000;
    let (x0, x1): (Vec<[f64; 3]>, Vec<[f64; 3]>) = (0..n).map(|i| (position(i), position(i))).unzip();
    for (origin, margin) in [([0.0; 3], 0.0), ([0.7, -1.3, 2e-5], 0.01)] {
        let params = Params { count: [n, 0, 0], origin: origin.map(split), margin_bits: split(margin), ..Params::default() };
        let mut buffers = [bytes(&[&x0[..], &x1[..]].concat()), room(0), room(0), room(0)];
        for (buffer, size) in buffers[1..].iter_mut().zip([32, 48, 24]) {
            buffer.resize(n as usize * size, 0);
        }
        harness::run(device, Id::PlaceVertices, &params, &mut buffers, n.div_ceil(256), 65_535).unwrap();
        let (paths, keys, boxes) = (read::<Path>(&buffers[1]), read::<[[u32; 2]; 6]>(&buffers[2]), read::<Aabb>(&buffers[3]));
        for i in 0..n as usize {
            for (end, given) in [(paths[i].t0, x0[i]), (paths[i].t1, x1[i])] {
                // What is too large for an `f32` becomes the greatest or infinity: the bound on the error is infinite then.
                let want = |k: usize| ((given[k] - origin[k]) as f32).clamp(f32::MIN, f32::MAX);
                assert!((0..3).all(|k| same(end[k].clamp(f32::MIN, f32::MAX), want(k))) && end[3] == 0.0, "{given:?} became {end:?}");
            }
            for k in 0..3 {
                let (low, high) = if x0[i][k] < x1[i][k] { (x0[i][k], x1[i][k]) } else { (x1[i][k], x0[i][k]) };
                let (low, high) = if margin > 0.0 { ((low - margin).next_down(), (high + margin).next_up()) } else { (low, high) };
                assert_eq!((keys[i][k], keys[i][3 + k]), (blocks::bound_key(low), blocks::bound_key(high)), "keys of {low:e} to {high:e}");
                let clamp = |x: f64| x.clamp(-2.9e38, 2.9e38);
                let (min, max) = (boxes[i].min[k] as f64, boxes[i].max[k] as f64);
                let tight = |x: f64| clamp(x).abs() * f32::EPSILON as f64 + 2.0 * f32::MIN_POSITIVE as f64;
                assert!(min <= low.max(-2.9e38 + 1e32) && min >= clamp(low) - tight(low), "min {min:e} for {low:e}");
                assert!(max >= high.min(2.9e38 - 1e32) && max <= clamp(high) + tight(high), "max {max:e} for {high:e}");
            }
        }
    }
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
        // The lesser of the times of both kinds counts.
        let never = bytes(&[decide::NEVER; 4]);
        let mut buffers = [bytes(&paths), bytes(&[key, 0, 0, 0]), never, vec![0; paths.len() * 32]];
        if key == 0 {
            buffers.swap(1, 2);
        }
        harness::run(device, Id::Shorten, &params, &mut buffers, params.count[0].div_ceil(256), 65_535).unwrap();
        for (p, got) in paths.iter().zip(read::<Path>(&buffers[3])) {
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

/// Contacts of a list are sorted by kind, `a`, `b`; what is not a contact stays behind them.
fn check_order(device: &Device) {
    let mut random = Random::new(5);
    let count = [300, 500, 200];
    for (n, room) in [(0, 40), (1, 40), (5000, 6000), (6000, 6000)] {
        let touches: Vec<Touch> = (0..n)
            .map(|i| {
                let kind = random.below(2);
                let (a, b) = (random.below(count[kind as usize]), random.below([200, 500][kind as usize]));
                Touch { kind, state: i % 2, a, b, toi: [i, !i] }
            })
            .collect();
        let mut list = bytes(&[n, 0, 0, 0]);
        list.extend(bytes(&touches));
        // What stands behind the last contact is left from another frame.
        list.resize(16 + room as usize * 24, 0x11);
        let mut want = touches.clone();
        want.sort_by_key(|t| (t.kind, t.a, t.b));
        let mut order: Vec<u32> = Vec::new();
        for level in [0, 1] {
            let params = Params { count, n: room, room_in: room, level, ..Params::default() };
            let mut buffers = [list.clone(), vec![0; room as usize * 4], vec![0; room as usize * 4]];
            if level == 1 {
                buffers[2] = bytes(&order);
            }
            harness::run(device, Id::ContactKeys, &params, &mut buffers, room.div_ceil(256), 65_535).unwrap();
            (_, order) = Sorter::new(device, room).unwrap().sort(&read(&buffers[1]), &read(&buffers[2])).unwrap();
        }
        let params = Params { count, n: room, room_in: room, ..Params::default() };
        let mut buffers = [list, bytes(&order), vec![0; room as usize * 24]];
        harness::run(device, Id::OrderContacts, &params, &mut buffers, room.div_ceil(256), 65_535).unwrap();
        let ordered: Vec<Touch> = read(&buffers[2]);
        assert!(ordered[..n as usize] == want, "{n} contacts");
        assert!(ordered[n as usize..].iter().all(|t| *t == Touch::default()), "written behind the last contact");
    }
}

/// Every leaf is below every node that says so, children split the range of their parent, boxes are those of the leaves, no leaf comes twice.
fn check_tree(nodes: &[Node], branches: &[Branch], twin: &Twin) {
    let n_internal = branches.len() as u32;
    let range = |node: u32| match branches.get(node as usize) {
        Some(branch) => (branch.first, branch.last),
        None => (node - n_internal, node - n_internal),
    };
    let mut seen = vec![false; branches.len() + 1];
    let mut stack = vec![0u32];
    while let Some(node) = stack.pop() {
        let (first, last) = range(node);
        let want = union((first..=last).map(|leaf| twin.node(0, 1, leaf)));
        check_boxes("node", &[want], &[nodes[node as usize].aabb()]);
        match branches.get(node as usize) {
            Some(branch) => {
                let (left, right) = (range(branch.left), range(branch.right));
                assert_eq!((left.0, left.1 + 1, right.1), (first, right.0, last), "children of node {node}");
                assert_eq!((nodes[node as usize].left, nodes[node as usize].right), (branch.left, branch.right));
                stack.extend([branch.left, branch.right]);
            }
            None => {
                assert!(nodes[node as usize].is_leaf() && nodes[node as usize].left == twin.order[first as usize]);
                assert!(!std::mem::replace(&mut seen[first as usize], true), "leaf {first} comes twice");
            }
        }
    }
    assert!(seen.iter().all(|&s| s), "a leaf is missing");
}

/// The kernels of the binary tree, one after the other, on boxes in general position and on boxes of which many have one code.
fn check_radix_tree(device: &Device) {
    let uniform: Vec<Aabb> = uniform_boxes(5000).iter().map(|b| b.inflated(0.01)).collect();
    let equal = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 70];
    let mut mixed = uniform[..400].to_vec();
    mixed.extend(uniform[..400].iter().map(|b| Aabb { min: b.min, max: b.min }));
    mixed.extend(vec![uniform[7]; 90]);
    for boxes in [&uniform[..], &uniform[..2], &equal, &mixed] {
        let twin = Twin::new([&[], boxes, &[]], |_, i| [i; 3]);
        let n = boxes.len() as u32;
        let groups = n.div_ceil(256);
        let mut buffers = [bytes(&twin.keys.iter().map(|_| 0).collect::<Vec<u32>>()), vec![0; (n as usize - 1) * 16]];
        let sorted: Vec<u32> = twin.order.iter().map(|&i| twin.keys[i as usize]).collect();
        buffers[0] = bytes(&sorted);
        harness::run(device, Id::Branches, &twin.params, &mut buffers, groups, 65_535).unwrap();
        let branches = buffers[1].clone();
        // The highest level that has more than one node, and one above it, must give the same boxes.
        for level in [1, 2] {
            let p = Params { level, ..twin.params };
            let mut buffers = [branches.clone(), bytes(&twin.nodes), bytes(&twin.leaves), vec![0; (2 * n as usize - 1) * 32]];
            harness::run(device, Id::BranchBoxes, &p, &mut buffers, groups, 65_535).unwrap();
            let nodes = buffers[3].clone();
            check_tree(&read(&nodes), &read(&branches), &twin);
            let (first, room_out) = (n / 3, 200_000);
            let all = brute::self_pairs(boxes);
            let mut found = Vec::new();
            // In two parts, as a dispatch of many queries is.
            for (first, n) in [(0, first), (first, n - first)] {
                let p = Params { first, n, room_out, ..twin.params };
                let mut buffers = [nodes.clone(), branches.clone(), room(room_out)];
                harness::run(device, Id::TraverseHalf, &p, &mut buffers, n.div_ceil(128), 65_535).unwrap();
                found.extend(entries(&buffers[2]));
            }
            check_pairs("overlaps by a tree", all.clone(), found);
            let p = Params { n, room_out: 0, ..twin.params };
            let mut buffers = [nodes.clone(), branches.clone(), bytes(&[u32::MAX, 0, 0, 0])];
            harness::run(device, Id::TraverseHalf, &p, &mut buffers, n.div_ceil(128), 65_535).unwrap();
            let wrapped = !all.is_empty() as u32;
            assert_eq!(read::<u32>(&buffers[2]), [(all.len() as u32).wrapping_sub(1), 0, wrapped, 0], "a count that runs over");
            let loose: Vec<Aabb> = uniform[1000..1300].iter().map(|b| b.inflated(0.02)).collect();
            let p = Params { n: 300, room_out, ..twin.params };
            let mut buffers = [bytes(&loose), nodes.clone(), branches.clone(), room(room_out)];
            harness::run(device, Id::TraverseAgainst, &p, &mut buffers, 3, 65_535).unwrap();
            check_pairs("loose boxes", brute::pairs(&loose, boxes), entries(&buffers[3]));
        }
    }
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

/// A count that exceeds 32 bits says so: both words of headers, in every kernel that adds to them.
fn check_counts(device: &Device) {
    let boxes: Vec<Aabb> = uniform_boxes(2000).iter().map(|b| b.inflated(0.03)).collect();
    let twin = Twin::new([&[], &boxes, &[]], |_, i| [2 * i, 2 * i + 1, 2 * i + 1]);
    let (above, blocks) = (twin.node_pairs(2, 1), twin.node_pairs(1, 1));
    let n_hits = brute::self_pairs(&boxes).len() as u32;
    let near = |back: u32| bytes(&[0u32.wrapping_sub(back), 0u32.wrapping_sub(back), 0, 0]);
    let p = Params { kind: 1, step: 1, limit: u32::MAX, room_out: 0, ..twin.params };
    for (back, wraps) in [(1, 1), (n_hits, 1), (n_hits + 1, 0)] {
        let list_p = Params { level: 1, room_in: blocks.len() as u32, ..p };
        let mut buffers = [bytes(&twin.nodes), bytes(&twin.leaves), vec![0; 16], vec![0; 48], list(&blocks), near(back)];
        harness::run(device, Id::ListCandidates, &list_p, &mut buffers, 5, 65_535).unwrap();
        let head: Vec<u32> = read(&buffers[5][..16]);
        assert_eq!(head, [n_hits.wrapping_sub(back), n_hits.wrapping_sub(back), wraps, wraps], "candidates");
    }
    let p = Params { level: 2, room_in: above.len() as u32, ..p };
    let mut buffers = [bytes(&twin.nodes), list(&above), near(1)];
    harness::run(device, Id::NodePairs, &p, &mut buffers, 1, 65_535).unwrap();
    assert_eq!(read::<u32>(&buffers[2][..16]), [blocks.len() as u32 - 1, u32::MAX, 1, 0], "pairs of nodes");
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

/// More workgroups than one row of a grid may have, so that it is folded without being asked to: each writes where no other does.
fn check_largest_grid(device: &Device) {
    let n_tiles = 65_536 + 300;
    let keys: Vec<u32> = (0..5000).collect();
    let params = Params { n: keys.len() as u32, n_tiles, ..Params::default() };
    let mut buffers = [bytes(&keys), vec![0xee; (n_tiles as usize + 1) * 1024]];
    harness::run(device, Id::SortCount, &params, &mut buffers, n_tiles, 65_535).unwrap();
    let table: Vec<u32> = read(&buffers[1]);
    for digit in 0..256 {
        let row = &table[digit * n_tiles as usize..(digit + 1) * n_tiles as usize];
        assert_eq!(row[..3].iter().sum::<u32>(), keys.iter().filter(|&&k| k as usize % 256 == digit).count() as u32, "digit {digit}");
        assert!(row[3..].iter().all(|&count| count == 0), "digit {digit}: a workgroup beyond the first row did not write, or elsewhere");
    }
}

fn check_uniform(device: &Device, method: Method) {
    let boxes = uniform_boxes(100_000);
    let mut broad = BroadPhase::new(device, method).unwrap();
    let pairs = broad.self_pairs(&boxes).unwrap();
    assert_eq!(pairs.len(), 320);
    let mut cpu = ccd::BroadPhase::new(2, Method::Blocks).unwrap();
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
