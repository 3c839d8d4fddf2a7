//! The kernels that make boxes and fit blocks, each by itself against a plain twin: generated
//! scenes, and poison: NaN, denormals, huge numbers, thresholds.

use crate::support::{
    bytes, check_boxes, elements_of, not_run, paths, read, run, same, swept, twin, zeros,
};
use crate::twin::union;
use ccd::Aabb;
use ccd::gpu::bind::{
    CurveKeys, FitBoxes, FitLeaves, FitLevel, HalveRuns, PlaceLeaves, PlaceVertices, SceneBounds,
    Shorten, SweepElements, SweepVertices,
};
use ccd::gpu::{Device, harness};
use ccd_core::backend::broad_phase::candidate;
use ccd_core::backend::broad_phase::morton_key::{self, Curve};
use ccd_core::backend::layout::{Blocks, Dispatch, Frame, Leaf, Params, Path, split};
use ccd_core::narrow_phase::decide;
use ccd_core::narrow_phase::search::Search;
use ccd_testkit::compare;
use ccd_testkit::generate::{Random, triangle_soup};

pub const TESTS: crate::Tests = &[
    ("place", check_place),
    ("sweep", check_sweep),
    ("shorten", check_shorten),
    ("bounds_and_codes", check_bounds),
    ("halves", check_halves),
    ("fit", check_fit),
    ("folded_grid", check_folded),
];

/// Parameters of a kernel that needs to know no more than the frame.
fn plain(frame: Frame) -> Params {
    Params { frame, ..Params::default() }
}

/// What a device with `f64` makes of positions is what the host makes for those without, bit for
/// bit; boxes hold the exact ones.
fn check_place(device: &Device) {
    if !device.info().wide {
        return not_run("the device is used without f64");
    }
    let mut random = Random::new(9);
    let thresholds = [
        0.0,
        -0.0,
        1e-300,
        -1e-40,
        1e-38,
        f32::MIN_POSITIVE as f64,
        1.0 / 3.0,
        -1e30,
        1e90,
        -1e100,
    ];
    let mut position = |i: u32| -> [f64; 3] {
        std::array::from_fn(|_| {
            if i.is_multiple_of(3) {
                thresholds[random.below(10) as usize]
            } else {
                random.unit() * 8.0 - 1.0
            }
        })
    };
    let n = 1000;
    let (x0, x1): (Vec<[f64; 3]>, Vec<[f64; 3]>) =
        (0..n).map(|i| (position(i), position(i))).unzip();
    for (origin, margin, scale) in
        [([0.0; 3], 0.0, 1.0), ([0.7, -1.3, 2e-5], 0.01, 2f64.powi(-300))]
    {
        let frame = Frame {
            count: [n, 0, 0],
            origin: origin.map(split),
            margin_bits: split(margin),
            scale_bits: split(scale),
            ..Frame::default()
        };
        let kernel = PlaceVertices {
            positions: bytes(&[&x0[..], &x1[..]].concat()),
            paths: zeros::<Path>(n as usize),
            keys: zeros::<[[u32; 2]; 6]>(n as usize),
            boxes: zeros::<Aabb>(n as usize),
        };
        let done = run(device, kernel, &plain(frame), n.div_ceil(256));
        let (paths, keys) = (read::<Path>(&done.paths), read::<[[u32; 2]; 6]>(&done.keys));
        let boxes = read::<Aabb>(&done.boxes);
        for i in 0..n as usize {
            for (end, given) in [(paths[i].t0, x0[i]), (paths[i].t1, x1[i])] {
                // What is too large for an `f32` becomes the greatest or infinity: the bound on the
                // error is infinite then.
                let want =
                    |k: usize| (((given[k] - origin[k]) * scale) as f32).clamp(f32::MIN, f32::MAX);
                assert!(
                    (0..3).all(|k| same(end[k].clamp(f32::MIN, f32::MAX), want(k)))
                        && end[3] == 0.0,
                    "{given:?} became {end:?}"
                );
            }
            for k in 0..3 {
                let (low, high) =
                    if x0[i][k] < x1[i][k] { (x0[i][k], x1[i][k]) } else { (x1[i][k], x0[i][k]) };
                let (low, high) = if margin > 0.0 {
                    ((low - margin).next_down(), (high + margin).next_up())
                } else {
                    (low, high)
                };
                assert_eq!(
                    (keys[i][k], keys[i][3 + k]),
                    (candidate::bound_key(low), candidate::bound_key(high)),
                    "keys of {low:e} to {high:e}"
                );
                let clamp = |x: f64| x.clamp(-2.9e38, 2.9e38);
                let (min, max) = (boxes[i].min[k] as f64, boxes[i].max[k] as f64);
                let tight =
                    |x: f64| clamp(x).abs() * f32::EPSILON as f64 + 2.0 * f32::MIN_POSITIVE as f64;
                assert!(
                    min <= low.max(-2.9e38 + 1e32) && min >= clamp(low) - tight(low),
                    "min {min:e} for {low:e}"
                );
                assert!(
                    max >= high.min(2.9e38 - 1e32) && max <= clamp(high) + tight(high),
                    "max {max:e} for {high:e}"
                );
            }
        }
    }
}

fn check_sweep(device: &Device) {
    for poison in [false, true] {
        let step = triangle_soup(500, 0.3, 1);
        let (paths, mesh) = (paths(&step, poison), &step.mesh);
        let count =
            [mesh.n_vertices() as u32, mesh.edges().len() as u32, mesh.faces().len() as u32];
        let start = [0, count[0], count[0] + count[1], count[0] + count[1] + count[2]];
        let frame = Frame { count, start, ..Frame::default() };
        let mut want: Vec<Aabb> = paths.iter().map(swept).collect();
        let vertices = want.clone();
        let kernel =
            SweepVertices { paths: bytes(&paths), boxes: zeros::<Aabb>(start[3] as usize) };
        let done = run(device, kernel.clone(), &plain(frame), count[0].div_ceil(256));
        let mut got: Vec<Aabb> = read(&done.boxes[..want.len() * 24]);
        // Of a number and NaN either may be the smaller: hosts refuse NaN, and a box that has one
        // is of no other vertex.
        for i in
            (0..paths.len()).filter(|&i| paths[i].t0.iter().chain(&paths[i].t1).any(|x| x.is_nan()))
        {
            got[i] = want[i];
        }
        check_boxes("vertex", &want, &got);
        if poison {
            continue;
        }
        want.extend(mesh.edges().iter().map(|e| union(e.iter().map(|&v| &vertices[v as usize]))));
        want.extend(mesh.faces().iter().map(|f| union(f.iter().map(|&v| &vertices[v as usize]))));
        let of_elements = SweepElements { elements: bytes(&elements_of(mesh)), boxes: done.boxes };
        let done = run(device, of_elements, &plain(frame), (count[1] + count[2]).div_ceil(256));
        check_boxes("box", &want, &read(&done.boxes));
        // Grown boxes hold the exact ones with the margin.
        let grown = Frame { margin: 0.125, ..frame };
        let done = run(device, kernel, &plain(grown), count[0].div_ceil(256));
        for (b, v) in read::<Aabb>(&done.boxes[..vertices.len() * 24]).iter().zip(&vertices) {
            assert!(
                (0..3).all(|k| b.min[k] as f64 <= v.min[k] as f64 - 0.125
                    && b.max[k] as f64 >= v.max[k] as f64 + 0.125),
                "{b:?} {v:?}"
            );
            assert!((0..3).all(|k| b.max[k] - v.max[k] < 0.1251), "{b:?} {v:?}");
        }
    }
}

fn check_shorten(device: &Device) {
    let paths = paths(&triangle_soup(200, 0.3, 2), false);
    let n = paths.len() as u32;
    for (key, from, last, until) in [
        (0.25f32.to_bits(), 0.0, 1.0, 0.25),
        (0, 0.0, 1.0, 0.0),
        (decide::NEVER, 0.0, 1.0, 1.0),
        (1.0f32.to_bits(), 0.0, 1.0, 1.0),
        (decide::NEVER, 0.125, 0.75, 0.75),
        (0.5f32.to_bits(), 0.25, 0.75, 0.5),
    ] {
        let window = Search { from, until: last, ..Search::whole(0.0) };
        let frame = Frame { count: [n, 0, 0], ..Frame::default() }.searching(&window);
        // The lesser of the times of both kinds counts.
        let (paths_in, earliest) = (bytes(&paths), bytes(&[key, 0, 0, 0]));
        let kernel = Shorten { paths: paths_in, earliest, shortened: zeros::<Path>(paths.len()) };
        let done = run(device, kernel, &plain(frame), n.div_ceil(256));
        for (p, got) in paths.iter().zip(read::<Path>(&done.shortened)) {
            for k in 0..3 {
                let at = |t: f64| p.t0[k] as f64 + (p.t1[k] as f64 - p.t0[k] as f64) * t;
                let off = |x: f32, t: f64| (x as f64 - at(t)).abs();
                assert!(
                    off(got.t0[k], from) <= if from == 0.0 { 0.0 } else { 4e-7 * 2.0 }
                        && off(got.t1[k], until) <= 4e-7 * 2.0,
                    "{p:?} from {from} until {until}: {got:?}"
                );
            }
        }
    }
}

fn check_bounds(device: &Device) {
    let (twin, _) = twin(60, 1);
    let n = twin.boxes.len() as u32;
    let p = twin.plain(Dispatch { n, ..Dispatch::default() });
    let kernel = SceneBounds { boxes: bytes(&twin.boxes), bounds: vec![0; 32] };
    let SceneBounds { boxes, bounds } = run(device, kernel, &p, n.div_ceil(2048));
    let words: Vec<u32> = read(&bounds);
    let scene = union(twin.boxes.iter());
    check_boxes("scene", &[scene], &[morton_key::merged(&words)]);
    for (flag, curve) in [(0, Curve::Morton), (Frame::FLAG_HILBERT, Curve::Hilbert)] {
        let (boxes, bounds) = (boxes.clone(), bounds.clone());
        let [keys, order] = [(); 2].map(|()| zeros::<u32>(n as usize));
        let mut p = p;
        p.frame.flags |= flag;
        let done = run(device, CurveKeys { boxes, bounds, keys, order }, &p, n.div_ceil(256));
        let keys: Vec<u32> = read(&done.keys);
        let want = twin.keys_along(curve);
        // A scale that was rounded otherwise (division is good to 2.5 units) may put a centre into
        // a neighbouring cell.
        let same = keys.iter().zip(&want).filter(|(a, b)| a == b).count();
        assert!(
            keys.iter().zip(&want).all(|(a, b)| a >> 30 == b >> 30)
                && same * 1000 >= keys.len() * 998,
            "{curve:?}: {same} of {} keys",
            keys.len()
        );
        assert!(read::<u32>(&done.order).into_iter().eq(0..n));
    }
}

/// Each run of 256 boxes is halved down to blocks of 32, at the median of the axis whose halves
/// have the least surface.
fn check_halves(device: &Device) {
    let (twin, _) = twin(60, 3);
    let p = Params { frame: twin.frame, dispatch: Dispatch::default(), args: twin.tree };
    let kernel = HalveRuns { boxes: bytes(&twin.boxes), order: bytes(&twin.order) };
    let order: Vec<u32> = read(&run(device, kernel, &p, twin.tree.slots[0][3].div_ceil(256)).order);
    let surface = |part: &[usize], of_place: &dyn Fn(usize) -> Aabb| {
        let boxes: Vec<Aabb> = part.iter().map(|&i| of_place(i)).collect();
        let b = union(boxes.iter());
        let [x, y, z] = std::array::from_fn(|k| f64::from(b.max[k]) - f64::from(b.min[k]));
        x * y + y * z + z * x
    };
    let mut n_halved = 0;
    for set in 0..3 {
        let of_set = twin.frame.start[set] as usize..twin.frame.start[set + 1] as usize;
        let runs = order[of_set.clone()].chunks(256).zip(twin.order[of_set].chunks(256));
        for (run, before) in runs {
            let place = |i: &u32| before.iter().position(|other| other == i);
            let places: Vec<usize> = run.iter().map(|i| place(i).expect("a box of it")).collect();
            let mut sorted = places.clone();
            sorted.sort();
            assert!(sorted.into_iter().eq(0..run.len()), "a box twice");
            let aabb = |i: usize| twin.boxes[before[i] as usize];
            for half in [128, 64, 32] {
                for part in places.chunks(2 * half).filter(|part| part.len() > half) {
                    let halved = |k: usize| {
                        let mut by_axis = part.to_vec();
                        let centre = |i: usize| aabb(i).min[k] * 0.5 + aabb(i).max[k] * 0.5;
                        by_axis.sort_by_key(|&i| (morton_key::order_key(centre(i)) >> 8, i));
                        by_axis[..half].sort();
                        let (lower, upper) = by_axis.split_at(half);
                        (surface(lower, &aabb) + surface(upper, &aabb), lower.to_vec())
                    };
                    let axes = [halved(0), halved(1), halved(2)];
                    let least = axes.iter().fold(f64::INFINITY, |least, (s, _)| least.min(*s));
                    let mut lower = part[..half].to_vec();
                    lower.sort();
                    // Sums in `f32` may find another of nearly equal ones.
                    assert!(axes.iter().any(|(s, of)| *of == lower && *s <= least * 1.00001));
                    n_halved += 1;
                }
            }
        }
    }
    assert!(n_halved > 20, "{n_halved} parts were halved");
}

fn check_fit(device: &Device) {
    let (twin, step) = twin(40, 2);
    let p = Params { frame: twin.frame, dispatch: Dispatch::default(), args: twin.tree };
    let slots = twin.tree.slots;
    let n = slots[0][3].div_ceil(256);
    let place = PlaceLeaves {
        order: bytes(&twin.order),
        elements: bytes(&elements_of(&step.mesh)),
        leaves: zeros::<Leaf>(twin.leaves.len()),
    };
    let placed = run(device, place, &p, n);
    assert!(read::<Leaf>(&placed.leaves) == twin.leaves);
    let paths = paths(&step, false);
    let fit = |flags: u32, ends: Vec<u8>| {
        let kernel = FitLeaves {
            boxes: bytes(&twin.boxes),
            leaves: placed.leaves.clone(),
            paths: bytes(&paths),
            bodies: zeros::<u32>(1),
            nodes: bytes(&vec![Aabb::EMPTY; twin.nodes.len()]),
            ends,
        };
        let frame = Frame { flags: twin.frame.flags | flags, ..twin.frame };
        run(device, kernel, &Params { frame, ..p }, n)
    };
    let with_ends = twin.clone().with_ends(&paths);
    let none = zeros::<[f32; 4]>(with_ends.ends.len());
    let done = fit(Frame::FLAG_ENDS, none.clone());
    assert!(read::<[f32; 4]>(&done.ends) == with_ends.ends, "boxes of leaves at both ends");
    let of_vertices = fit(0, none.clone());
    assert!(of_vertices.ends == none, "ends where there are none");
    let of_paths = fit(Frame::FLAG_SWEPT, none);
    for nodes in [of_vertices.nodes, of_paths.nodes] {
        check_boxes("node", &read::<Aabb>(&nodes), &read::<Aabb>(&done.nodes));
    }
    let second = slots[2][0] as usize;
    check_boxes("node", &twin.nodes[..second], &read::<Aabb>(&done.nodes)[..second]);
    let of_boxes = FitBoxes {
        boxes: bytes(&twin.boxes),
        order: bytes(&twin.order),
        nodes: bytes(&vec![Aabb::EMPTY; twin.nodes.len()]),
    };
    let of_boxes = run(device, of_boxes, &p, n).nodes;
    check_boxes("node of boxes", &twin.nodes[..second], &read::<Aabb>(&of_boxes)[..second]);
    let p = Params { args: Blocks { level: 1, ..twin.tree }, ..p };
    let done =
        run(device, FitLevel { nodes: done.nodes }, &p, (slots[1][3] - slots[1][0]).div_ceil(256));
    let third = slots[3][0] as usize;
    check_boxes("node", &twin.nodes[..third], &read::<Aabb>(&done.nodes)[..third]);
}

/// A grid that is folded into rows gives what one row gives, also where the last row is not full.
fn check_folded(device: &Device) {
    let paths = paths(&triangle_soup(3000, 0.3, 6), false);
    let n = paths.len() as u32;
    let p = plain(Frame { count: [n, 0, 0], ..Frame::default() });
    let want: Vec<Aabb> = paths.iter().map(swept).collect();
    for fold in [1, 7, 16, 65_535] {
        let mut kernel = SweepVertices { paths: bytes(&paths), boxes: zeros::<Aabb>(want.len()) };
        harness::run(device, &mut kernel, &p, n.div_ceil(256), fold).unwrap();
        check_boxes("vertex", &want, &read(&kernel.boxes));
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
    assert!(
        same(f32::NAN, -f32::NAN) && same(0.0, 1e-40) && !same(0.0, 1e-37) && !same(1.0, f32::NAN)
    );
}
