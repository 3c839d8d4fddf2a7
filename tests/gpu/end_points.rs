//! The kernels of the sweep by end points, each by itself: keys, walks.

use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, entries, read, run, zeros};
use crate::twin::Twin;
use ccd::gpu::Device;
use ccd::gpu::bind::{EndPointKeys, SweepEndPoints};
use ccd::{Aabb, Pair};
use ccd_core::backend::broad_phase::key_intervals::{FOUND, SURVEY_WORDS};
use ccd_core::backend::broad_phase::sweep_by_end_points::{keys, points, range};
use ccd_core::backend::layout::Dispatch;
use ccd_testkit::brute;
use ccd_testkit::generate::uniform_boxes;

pub const TESTS: crate::Tests = &[("end_points", check_end_points)];

/// Pairs that fit in the list of a test.
const CAPACITY: u32 = 100_000;

/// The end points in order, of keys that are those of the CPU.
fn sorted(device: &Device, twin: &Twin, axis: u32) -> Vec<u32> {
    let n = twin.boxes.len();
    let mut survey = vec![0u32; SURVEY_WORDS];
    survey[FOUND] = axis;
    let kernel = EndPointKeys {
        boxes: bytes(&twin.boxes),
        survey: bytes(&survey),
        keys: zeros::<u32>(2 * n),
        points: zeros::<u32>(2 * n),
    };
    let done = run(device, kernel, &twin.plain(Dispatch::default()), (n as u32).div_ceil(256));
    let start = twin.frame.start;
    let set = |i: u32| (i >= start[1]) as u32 + (i >= start[2]) as u32;
    let of_box = |i: u32| keys(set(i), &twin.boxes[i as usize], axis);
    let want: Vec<u32> = (0..n as u32).flat_map(of_box).collect();
    assert!(read::<u32>(&done.keys) == want, "keys of {n} boxes on axis {axis}");
    let mut order: Vec<u32> = (0..n as u32).flat_map(points).collect();
    assert!(read::<u32>(&done.points) == order, "end points of {n} boxes");
    order.sort_by_key(|&point| want[point as usize]);
    order
}

/// What the threads of a kind find, in two parts, as a dispatch of many is; and a count that runs
/// over.
fn found(device: &Device, twin: &Twin, kind: u32, order: &[u32]) -> Vec<Pair> {
    let [first, end] = range(kind, &twin.frame.count);
    let walks = |first: u32, n: u32, pairs: Vec<u8>| {
        let dispatch = Dispatch { n, first, capacity_in: 0, capacity_out: CAPACITY };
        let kernel = SweepEndPoints { boxes: bytes(&twin.boxes), points: bytes(order), pairs };
        run(device, kernel, &twin.plain(dispatch), n.div_ceil(128)).pairs
    };
    let half = (end - first) / 3;
    let mut pairs = Vec::new();
    for (first, n) in [(first, half), (first + half, end - first - half)] {
        pairs.extend(entries(&walks(first, n, capacity(CAPACITY))));
    }
    if !pairs.is_empty() {
        let mut full = capacity(CAPACITY);
        full[..4].fill(u8::MAX);
        let counted: Vec<u32> = read(&walks(first, end - first, full));
        assert_eq!(counted[..4], [pairs.len() as u32 - 1, 0, 1, 0], "a count that runs over");
    }
    pairs
}

fn check_end_points(device: &Device) {
    let boxes: Vec<Aabb> = uniform_boxes(2000).iter().map(|b| b.inflated(0.03)).collect();
    // Boxes on a lattice: many begin where others end.
    let on_lattice = |b: &Aabb| {
        let min = b.min.map(|c| (c * 7.0).floor());
        Aabb { min, max: min.map(|c| c + 1.0) }
    };
    let lattice: Vec<Aabb> = boxes[..500].iter().map(on_lattice).collect();
    let mut unequal = boxes[..700].to_vec();
    unequal.push(Aabb { min: [-9.0; 3], max: [9.0; 3] });
    for (axis, boxes) in [(0, &boxes[..]), (1, &boxes[..2]), (2, &lattice), (1, &unequal)] {
        let (a, b) = boxes.split_at(boxes.len() / 3);
        let within = Twin::new([a, boxes, &[]], |_, i| [i; 3]);
        let order = sorted(device, &within, axis);
        check_pairs("within one set", brute::self_pairs(boxes), found(device, &within, 1, &order));
        let between = Twin::new([a, &boxes[..2], b], |_, i| [i; 3]);
        let order = sorted(device, &between, axis);
        check_pairs("between two sets", brute::pairs(a, b), found(device, &between, 0, &order));
    }
}
