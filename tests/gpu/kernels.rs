//! The kernels that make boxes, order them and fit blocks, each by itself against a plain twin: generated scenes, and poison: NaN, denormals, huge numbers, thresholds.

use crate::support::{bytes, check_boxes, paths, read, room, same, swept, twin};
use crate::twin::union;
use ccd::Aabb;
use ccd::gpu::{Device, Sorter, harness};
use ccd_core::broad_phase::{block_bvh, morton_key};
use ccd_core::kernel::{Id, sort};
use ccd_core::layout::{Leaf, Params, Path, Touch, split};
use ccd_core::narrow_phase::decide;
use ccd_testkit::compare;
use ccd_testkit::generate::{Random, triangle_soup};

pub const TESTS: crate::Tests = &[
    ("place", check_place),
    ("sweep", check_sweep),
    ("shorten", check_shorten),
    ("bounds_and_codes", check_bounds),
    ("sort", check_sort),
    ("order_of_contacts", check_order),
    ("fit", check_fit),
    ("folded_grid", check_folded),
    ("largest_grid", check_largest_grid),
];

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
                assert_eq!(
                    (keys[i][k], keys[i][3 + k]),
                    (block_bvh::bound_key(low), block_bvh::bound_key(high)),
                    "keys of {low:e} to {high:e}"
                );
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

fn check_bounds(device: &Device) {
    let (twin, _) = twin(60, 1);
    let n = twin.boxes.len() as u32;
    let params = Params { n, ..twin.params };
    let mut buffers = [bytes(&twin.boxes), vec![0; 32]];
    harness::run(device, Id::SceneBounds, &params, &mut buffers, n.div_ceil(2048), 65_535).unwrap();
    let words: Vec<u32> = read(&buffers[1]);
    let scene = union(twin.boxes.iter());
    check_boxes("scene", &[scene], &[morton_key::merged(&words)]);
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
