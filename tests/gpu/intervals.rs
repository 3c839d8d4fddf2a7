//! The kernels of sort and sweep, of a uniform grid and of brute force, each by itself: surveys,
//! keys, pieces of work, pairs.

use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, check_boxes, entries, list, read, run, zeros};
use crate::twin::{Twin, union};
use ccd::gpu::Device;
use ccd::gpu::bind::{
    IntervalKeys, IntervalPairs, IntervalWork, OrderBoxes, SurveyAxis, SurveySides,
};
use ccd::method::BroadPhaseMethod;
use ccd::{Aabb, Pair};
use ccd_core::backend::broad_phase::key_intervals::{
    self, BRUTE_FORCE, CHUNK, FOUND, GROUP, POOL, SURVEY_WORDS, SWEEP_AND_PRUNE, UNIFORM_GRID,
    asks, rows_a_turn, turns, unpack,
};
use ccd_core::backend::broad_phase::morton_key::{order_key, shared_word};
use ccd_core::backend::broad_phase::sweep_and_prune::Moments;
use ccd_core::backend::broad_phase::uniform_grid::Sizes;
use ccd_core::backend::layout::{Dispatch, Intervals, LIST_HEADER, Params};
use ccd_testkit::brute;
use ccd_testkit::generate::uniform_boxes;

pub const TESTS: crate::Tests = &[
    ("surveys", check_surveys),
    ("intervals", check_intervals),
    ("crowds", check_crowds),
    ("grids_of_many_sizes", check_sizes),
];

const METHODS: [u32; 3] = [BRUTE_FORCE, SWEEP_AND_PRUNE, UNIFORM_GRID];

/// Boxes of which few overlap along one axis.
fn long(n: usize) -> Vec<Aabb> {
    let stretched = |b: &Aabb| Aabb {
        min: [b.min[0], b.min[1], b.min[2] * 5.0],
        max: [b.max[0], b.max[1], b.max[2] * 5.0],
    };
    uniform_boxes(n).iter().map(|b| stretched(&b.inflated(0.03))).collect()
}

fn survey_on_device(device: &Device, method: u32, twin: &Twin) -> Vec<u32> {
    let (n, boxes, survey) =
        (twin.boxes.len() as u32, bytes(&twin.boxes), zeros::<[u32; SURVEY_WORDS]>(1));
    let p = |first| twin.plain(Dispatch { n, first, ..Dispatch::default() });
    let survey = match method {
        SWEEP_AND_PRUNE => run(device, SurveyAxis { boxes, survey }, &p(1), 1).survey,
        UNIFORM_GRID => run(device, SurveySides { boxes, survey }, &p(0), 3).survey,
        _ => survey,
    };
    let mut words: Vec<u32> = read(&survey);
    assert_eq!(words.len(), SURVEY_WORDS);
    let scene = union(twin.boxes.iter());
    (0..6).for_each(|k| words[k] = shared_word(&scene, k));
    words
}

fn check_surveys(device: &Device) {
    for n in [1, 700, 5000] {
        let boxes = long(n);
        let twin = Twin::new([&[], &boxes, &[]], |_, i| [i; 3]);
        let want = Moments::<f64>::of(0, n, &boxes).axes()[0] as u32;
        assert_eq!(survey_on_device(device, SWEEP_AND_PRUNE, &twin)[FOUND], want, "axis of {n}");
        assert!(n == 1 || want == 2, "the longest axis is the third");
        let sides = &survey_on_device(device, UNIFORM_GRID, &twin)[FOUND..FOUND + 3];
        for k in 0..3 {
            let largest = boxes.iter().fold(Sizes::NONE, |all, b| all.merged(&Sizes::of(b)));
            let want = order_key(largest.half[k]);
            assert_eq!(sides[k], want, "largest side of {n} on axis {k}");
        }
    }
}

/// What the kernels need of boxes in order.
struct Sorted {
    twin: Twin,
    survey: Vec<u32>,
    keys: Vec<u32>,
    order: Vec<u32>,
    boxes: Vec<Aabb>,
}

fn params(twin: &Twin, dispatch: Dispatch, method: u32, kind: u32, row: u32) -> Params<Intervals> {
    Params { frame: twin.frame, dispatch, args: Intervals { method, kind, row } }
}

fn sorted(device: &Device, method: u32, sets: [&[Aabb]; 3]) -> Sorted {
    let twin = Twin::new(sets, |_, i| [i; 3]);
    let n = twin.boxes.len();
    let survey = survey_on_device(device, method, &twin);
    let kernel = IntervalKeys {
        boxes: bytes(&twin.boxes),
        survey: bytes(&survey),
        keys: zeros::<u32>(n),
        order: zeros::<u32>(n),
    };
    let p = params(&twin, Dispatch::default(), method, 0, 0);
    let done = run(device, kernel, &p, (n as u32).div_ceil(256));
    let (found, mut order): (Vec<u32>, Vec<u32>) = (read(&done.keys), read(&done.order));
    let start = twin.frame.start;
    let set = |i: usize| (i as u32 >= start[1]) as u32 + (i as u32 >= start[2]) as u32;
    let keys: Vec<u32> =
        (0..n).map(|i| key_intervals::key(method, set(i), &twin.boxes[i], &survey)).collect();
    assert!(order.iter().copied().eq(0..n as u32));
    // Quotients of a device may be off, so that a box is in a neighbouring cell.
    let far = |k: u32| keys[k as usize].abs_diff(found[k as usize]);
    assert!(method == UNIFORM_GRID || found == keys, "keys of method {method}");
    let moved = (0..n as u32).filter(|&k| far(k) != 0).count();
    assert!(moved <= n / 100, "{moved} of {n} boxes are in another cell");
    order.sort_by_key(|&i| found[i as usize]);
    let (boxes, order_bytes) = (bytes(&twin.boxes), bytes(&order));
    let kernel = OrderBoxes { boxes, order: order_bytes, sorted: zeros::<Aabb>(n) };
    let done = run(device, kernel, &twin.plain(Dispatch::default()), (n as u32).div_ceil(256));
    let boxes: Vec<Aabb> = order.iter().map(|&i| twin.boxes[i as usize]).collect();
    check_boxes("sorted box", &boxes, &read(&done.sorted));
    let keys = order.iter().map(|&i| found[i as usize]).collect();
    Sorted { twin, survey, keys, order, boxes }
}

/// The pairs of a kind.
fn found(device: &Device, method: u32, kind: u32, sets: &Sorted) -> Vec<Pair> {
    pairs_of(device, method, kind, sets, &work(device, method, kind, sets))
}

/// Pieces of work, or pairs, at most.
const CAPACITY: u32 = 100_000;

/// The pieces of work of a kind.
fn work(device: &Device, method: u32, kind: u32, sets: &Sorted) -> Vec<Pair> {
    let (capacity_out, mut all) = (CAPACITY, Vec::new());
    for row in (0..turns(method, kind)).map(|turn| turn * rows_a_turn(method)) {
        let asking = sets.twin.frame.count[asks(method, kind, row)[0] as usize];
        let p = |capacity_out| {
            let dispatch = Dispatch { capacity_out, ..Dispatch::default() };
            params(&sets.twin, dispatch, method, kind, row)
        };
        let kernel = |work| IntervalWork {
            sorted: bytes(&sets.boxes),
            keys: bytes(&sets.keys),
            survey: bytes(&sets.survey),
            work,
        };
        let done =
            run(device, kernel(capacity(capacity_out)), &p(capacity_out), asking.div_ceil(GROUP));
        let pieces = entries(&done.work);
        for piece in &pieces {
            let [of_row, tiles, group, first] = unpack([piece.a, piece.b]);
            let rows = row..row + rows_a_turn(method);
            assert!(rows.contains(&of_row) && group < asking.div_ceil(GROUP));
            assert!(first < sets.keys.len() as u32);
            assert!(tiles <= CHUNK / GROUP, "{tiles} groups in a piece");
        }
        let short = run(device, kernel(capacity(3)), &p(1), asking.div_ceil(GROUP));
        let words: Vec<u32> = read(&short.work);
        assert_eq!(words[0] as usize, pieces.len(), "pieces counted beyond the capacity");
        assert!(words[LIST_HEADER + 2..].iter().all(|&w| w == 0), "written beyond the capacity");
        all.extend(pieces);
    }
    all
}

/// The pairs that pieces of work give.
fn pairs_of(device: &Device, method: u32, kind: u32, sets: &Sorted, all: &[Pair]) -> Vec<Pair> {
    let (capacity_out, mut pairs) = (CAPACITY, Vec::new());
    let n = all.len() as u32;
    let work = |first, n, pairs| {
        let dispatch = Dispatch { n, first, capacity_in: all.len() as u32, capacity_out };
        let kernel = IntervalPairs {
            sorted: bytes(&sets.boxes),
            keys: bytes(&sets.keys),
            order: bytes(&sets.order),
            survey: bytes(&sets.survey),
            work: list(all),
            pairs,
        };
        // With five workgroups lavapipe would end loops too early, see `Device::groups`.
        run(device, kernel, &params(&sets.twin, dispatch, method, kind, 0), 50).pairs
    };
    // In two parts, as a dispatch of many pieces is.
    for (first, n) in [(0, n / 3), (n / 3, n)] {
        pairs.extend(entries(&work(first, n, capacity(capacity_out))));
    }
    if !pairs.is_empty() {
        let mut full = capacity(capacity_out);
        full[..4].fill(u8::MAX);
        let counted: Vec<u32> = read(&work(0, n, full));
        assert_eq!(counted[..4], [pairs.len() as u32 - 1, 0, 1, 0], "a count that runs over");
    }
    pairs
}

fn check_intervals(device: &Device) {
    let boxes = long(3000);
    let mut unequal = boxes[..900].to_vec();
    unequal.push(union(boxes.iter()));
    unequal.push(boxes[7]);
    for boxes in [&boxes[..], &boxes[..2], &unequal] {
        let (a, b) = boxes.split_at(boxes.len() / 3);
        for method in METHODS {
            let within = sorted(device, method, [&[], boxes, &[]]);
            let want = brute::self_pairs(boxes);
            check_pairs("within one set", want, found(device, method, 1, &within));
            let between = sorted(device, method, [a, &boxes[..2], b]);
            let want = brute::pairs(a, b);
            check_pairs("between two sets", want, found(device, method, 0, &between));
        }
    }
}

/// So many pairs at once that the pool of a workgroup overflows: every box overlaps every other.
fn check_crowds(device: &Device) {
    let boxes = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 300];
    const { assert!(GROUP * GROUP > POOL) };
    for method in METHODS {
        let within = sorted(device, method, [&[], &boxes, &[]]);
        check_pairs("crowd", brute::self_pairs(&boxes), found(device, method, 1, &within));
    }
}

/// One box as large as the scene among 20,000 small ones, and some of sizes between: the pairs, and
/// how many tiles of boxes are compared with groups.
fn check_sizes(device: &Device) {
    let mut boxes = uniform_boxes(20_000);
    for k in 0..40 {
        let by = 0.3 / (1 << (k % 8)) as f32;
        boxes[500 * k] = boxes[500 * k].inflated(by);
    }
    boxes[777] = union(boxes.iter());
    let (a, b) = boxes.split_at(10_000);
    for (kind, sets, want) in [
        (1, [&[], &boxes[..], &[]], brute::self_pairs(&boxes)),
        (0, [a, &[], b], brute::pairs(a, b)),
    ] {
        let method = UNIFORM_GRID;
        let sorted = sorted(device, method, sets);
        let work = work(device, method, kind, &sorted);
        let tiles: u32 = work.iter().map(|p| unpack([p.a, p.b])[1]).sum();
        let groups = |n: usize| n.div_ceil(GROUP as usize) as u32;
        let all = if kind == 1 {
            groups(boxes.len()) * groups(boxes.len()) / 2
        } else {
            groups(a.len()) * groups(b.len())
        };
        println!("kind {kind}: {tiles} tiles, {all} by brute force");
        assert!(2 * tiles < all, "{tiles} tiles, {all} by brute force");
        assert!(want.len() > 700);
        check_pairs("boxes of many sizes", want, pairs_of(device, method, kind, &sorted, &work));
    }
    let mut grid = ccd::gpu::BroadPhase::new(device, BroadPhaseMethod::UniformGrid).unwrap();
    check_pairs("by the grid", brute::self_pairs(&boxes), grid.self_pairs(&boxes).unwrap());
    // Seven and a half groups of small boxes, a few larger ones in one place, many large ones: a
    // group of three levels, of which that in between is one row.
    let sized = |n: usize, by: f32| uniform_boxes(n).into_iter().map(move |b| b.inflated(by));
    let mut boxes: Vec<Aabb> = sized(960, 0.001).collect();
    let middle = Aabb { min: [0.45; 3], max: [0.55; 3] };
    boxes.extend((0..20).map(|k| middle.inflated(0.001 * k as f32)));
    boxes.extend(sized(400, 0.2));
    let (a, b) = boxes.split_at(970);
    let within = sorted(device, UNIFORM_GRID, [&[], &boxes, &[]]);
    let want = brute::self_pairs(&boxes);
    check_pairs("within a group of levels", want, found(device, UNIFORM_GRID, 1, &within));
    let between = sorted(device, UNIFORM_GRID, [a, &[], b]);
    let want = brute::pairs(a, b);
    check_pairs("between groups of levels", want, found(device, UNIFORM_GRID, 0, &between));
}
