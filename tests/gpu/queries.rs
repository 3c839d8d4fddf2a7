//! All published queries through the kernels that decide, against exact answers.

use crate::scenes::{Runnable, Test};
use crate::support::{bytes, capacity, list, run};
use ccd::gpu::Device;
use ccd::gpu::bind::{AdvanceWide, Decide, DecideIntegers, DecideNear, DecideNearWide, DecideWide};
use ccd::io::{Queries, Query, read_queries};
use ccd::{EdgeEdge, Pair, Verdict, VertexFace};
use ccd_core::backend::layout::elements::with_kind;
use ccd_core::backend::layout::{
    Decision, Dispatch, EDGE_EDGE, Frame, IntegerDecision, LIST_HEADER, Params, Path as Paths,
    TOUCH_WORDS, Touch, join, split,
};
use ccd_core::backend::quantization::{Scan, Table};
use ccd_core::narrow_phase::integer_search::Window;
use ccd_core::narrow_phase::search::{Search, TOI_TOLERANCE};
use ccd_testkit::data::QUERY_SETS;
use ccd_testkit::{compare, data};
use std::path::{Path, PathBuf};

/// Four vertices at both ends.
pub type Ends = ([[f64; 3]; 4], [[f64; 3]; 4]);

/// The name and the test of the queries in a folder, which may not be there.
pub fn test_of_data(dir: &Result<PathBuf, String>) -> (String, Runnable) {
    let test =
        dir.clone().map(|dir| -> Test { Box::new(move |device| check_queries(device, &dir)) });
    ("queries".into(), test)
}

/// Queries of each of [`QUERY_SETS`] that integers alone leave open; a device without `f64` goes on
/// in `f32` and leaves at most as many.
const OPEN_BY_INTEGERS: [u64; QUERY_SETS.len()] = [252, 50, 0, 0, 0, 0, 18, 56, 2, 59, 58];

/// All published queries through the kernels that decide, and what they leave open through the CPU.
fn check_queries(device: &Device, dir: &Path) {
    let wide = device.info().wide;
    let (mut n, mut n_hits, mut n_undecided, mut n_open, mut n_misses) = (0, 0, 0, 0, 0);
    // Queries of each set, and those that the device leaves undecided or open.
    let mut sets = [[0u64; 2]; QUERY_SETS.len()];
    for (path, name) in data::query_files(dir) {
        let Queries { queries, .. } = read_queries(&path).unwrap();
        let set = QUERY_SETS.iter().position(|(set, _)| name.starts_with(set));
        let [n_of_set, n_left] = &mut sets[set.unwrap_or_else(|| panic!("{name} is of no set"))];
        let times = data::read_times(&dir.join("toi").join(&name));
        let is_vf = matches!(queries[0], Query::VertexFace(_));
        let ends = |q: &Query| match q {
            Query::VertexFace(q) => (q.t0, q.t1),
            Query::EdgeEdge(q) => (q.t0, q.t1),
        };
        let ends: Vec<Ends> = queries.iter().map(ends).collect();
        for min_distance in [1e-3, 0.1] {
            let got = decide(device, is_vf, &ends, min_distance);
            for (i, (&ends, got)) in ends.iter().zip(got).enumerate() {
                let want = cpu_verdict(is_vf, ends, min_distance);
                check_near(want, got, &format!("{name} query {i}, distance {min_distance}"));
            }
        }
        let verdicts = decide(device, is_vf, &ends, 0.0);
        for (i, (verdict, time)) in verdicts.iter().zip(&times).enumerate() {
            let mut verdict = *verdict;
            *n_of_set += 1;
            *n_left += matches!(verdict, Verdict::Undecided { .. }) as u64;
            if !wide && matches!(verdict, Verdict::Undecided { .. }) {
                n_open += 1;
                verdict = cpu_verdict(is_vf, ends[i], 0.0);
            }
            let (hit, certain) = compare::verdict(verdict, time, &format!("{name} query {i}"));
            n += 1;
            n_hits += hit as usize;
            n_misses += !hit as usize;
            n_undecided += (hit && !certain) as usize;
        }
    }
    println!(
        "{n} queries: {n_hits} hits ({n_undecided} undecided), {n_misses} misses; \
         {n_open} left open without f64"
    );
    assert_eq!(n, 7279);
    // One in a hundred more than a CPU: products may be contracted, and roots be off by some units.
    for (i, [n_of_set, n_left]) in sets.into_iter().enumerate() {
        let (set, [of_cpu, _]) = QUERY_SETS[i];
        let of_host = if wide { of_cpu } else { OPEN_BY_INTEGERS[i] };
        let most = of_host + n_of_set / 100;
        println!("{set}: {n_left} of {n_of_set} left, {most} at most");
        assert!(n_left <= most, "{set}: {n_left} of {n_of_set} left, {most} at most");
    }
}

/// The verdict of the CPU in `f64`.
pub fn cpu_verdict(is_vf: bool, (t0, t1): Ends, min_distance: f64) -> Verdict<f64> {
    if is_vf {
        ccd::vertex_face(&VertexFace { t0, t1 }, min_distance)
    } else {
        ccd::edge_edge(&EdgeEdge { t0, t1 }, min_distance)
    }
}

/// Asserts that a verdict by a minimum distance contradicts none of a CPU in `f64`.
fn check_near(want: Verdict<f64>, got: Verdict<f64>, what: &str) {
    let tolerance = TOI_TOLERANCE * 1.001;
    match (want, got) {
        (Verdict::Hit { .. }, Verdict::Miss) => panic!("{what}: {want:?} is missed"),
        (Verdict::Hit { toi }, Verdict::Undecided { toi: first }) => {
            assert!(first <= toi + tolerance, "{what}: {got:?} is late, {want:?}")
        }
        (Verdict::Hit { toi }, Verdict::Hit { toi: first }) => {
            assert!((first - toi).abs() <= tolerance, "{what}: {got:?} for {want:?}")
        }
        (Verdict::Miss, Verdict::Hit { .. }) => panic!("{what}: {got:?} is none"),
        _ => (),
    }
}

/// Verdicts of the device for queries of four vertices each: vertex `4 i` and face `i`, or edges
/// `2 i` and `2 i + 1`.
pub fn decide(device: &Device, is_vf: bool, ends: &[Ends], min_distance: f64) -> Vec<Verdict<f64>> {
    let n = ends.len();
    let mut verdicts = vec![Verdict::Miss; n];
    let mut scan = Scan::NONE;
    ends.iter().flat_map(|(a, b)| a.iter().chain(b)).for_each(|p| scan.take(*p));
    let (x0, x1): (Vec<[f64; 3]>, Vec<[f64; 3]>) =
        ends.iter().flat_map(|(a, b)| (0..4).map(|k| (a[k], b[k]))).unzip();
    // Exact numbers as they are, also where a session would bring them to another unit: kernels
    // meet every number.
    let table = if scan.exact { Table::AS_GIVEN } else { scan.table(true) };
    let place = |p: [f64; 3]| {
        let p = table.place(p);
        [p[0], p[1], p[2], 0.0]
    };
    let paths: Vec<Paths> =
        x0.iter().zip(&x1).map(|(p, q)| Paths { t0: place(*p), t1: place(*q) }).collect();
    let count = n as u32;
    let (elements, pairs): (Vec<u32>, Vec<Pair>) = if is_vf {
        let faces = (0..count).flat_map(|i| [4 * i + 1, 4 * i + 2, 4 * i + 3]);
        (faces.collect(), (0..count).map(|i| Pair { a: 4 * i, b: i }).collect())
    } else {
        let edges = (0..2 * count).flat_map(|i| [2 * i, 2 * i + 1]);
        let pair = |i| with_kind(EDGE_EDGE, Pair { a: 2 * i, b: 2 * i + 1 });
        (edges.collect(), (0..count).map(pair).collect())
    };
    let exact = if table == Table::AS_GIVEN { Frame::FLAG_EXACT } else { 0 };
    let frame = Frame {
        count: [4 * count, 0, 0],
        flags: Frame::FLAG_KEEP | exact,
        path_error: table.error,
        min_distance: table.distance(min_distance),
        distance_bits: split(min_distance),
        scale_bits: split(table.scale),
        ..Frame::default()
    }
    .searching(&Search::whole(min_distance));
    let dispatch = Dispatch { n: count, first: 0, capacity_in: count, capacity_out: count };
    let (paths, elements, input) = (bytes(&paths), bytes(&elements), list(&pairs));
    let (contacts, earliest) = (vec![0u8; 4 * (LIST_HEADER + TOUCH_WORDS * n)], vec![0xff; 16]);
    let of_pair = |a: u32| if is_vf { a / 4 } else { a / 2 } as usize;
    let (args, left) = (Decision { capacity_left: count }, capacity(count));
    let positions = bytes(&[x0, x1].concat());
    let near = min_distance > 0.0;
    let (p, plain) =
        (Params { frame, dispatch, args }, Params { frame, dispatch, ..Params::default() });
    let contacts = match (device.info().wide, near) {
        (true, true) => {
            let kernel = DecideNearWide { paths, positions, elements, input, contacts, earliest };
            run(device, kernel, &plain, 3).contacts
        }
        (true, false) => {
            let (own, given, words) = (paths.clone(), positions.clone(), elements.clone());
            let kernel = DecideWide { paths, positions, elements, input, contacts, left, earliest };
            let DecideWide { contacts, left, earliest, .. } = run(device, kernel, &p, 3);
            let (paths, positions, elements, input) = (own, given, words, left);
            let kernel = AdvanceWide { paths, positions, elements, input, contacts, earliest };
            run(device, kernel, &plain, 3).contacts
        }
        (false, true) => {
            let kernel = DecideNear { paths, elements, input, contacts, earliest };
            run(device, kernel, &plain, 3).contacts
        }
        (false, false) => {
            let window = Window::of(&Search::whole(0.0)).unwrap();
            let p = Params { frame, dispatch, args: IntegerDecision::new(args, window) };
            let (own, words) = (paths.clone(), elements.clone());
            let kernel =
                DecideIntegers { paths, positions, elements, input, contacts, left, earliest };
            let DecideIntegers { contacts, left, earliest, .. } = run(device, kernel, &p, 3);
            let (paths, elements, input) = (own, words, left);
            let kernel = Decide { paths, elements, input, contacts, earliest };
            run(device, kernel, &plain, 3).contacts
        }
    };
    for touch in touches(&contacts) {
        let toi = join(touch.toi);
        verdicts[of_pair(touch.a)] =
            if touch.state == 0 { Verdict::Hit { toi } } else { Verdict::Undecided { toi } };
    }
    verdicts
}

fn touches(bytes: &[u8]) -> Vec<Touch> {
    let words: Vec<u32> = bytemuck::pod_collect_to_vec(bytes);
    bytemuck::pod_collect_to_vec(&words[LIST_HEADER..LIST_HEADER + TOUCH_WORDS * words[0] as usize])
}
