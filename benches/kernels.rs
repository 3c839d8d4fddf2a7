//! Every stage that the documents describe, under criterion; each benchmark asserts its answer.

use ccd::gpu::{self, Device, DeviceOptions};
use ccd::method::{BroadPhaseMethod, Scheduling, Traversal, TreeOptions};
use ccd::scenes::{Step, crumpled_sheet, interpenetrating, uniform_boxes};
use ccd::{Aabb, BroadPhase, EdgeEdge, Options, Session, Verdict, VertexFace};
use ccd_core::backend::broad_phase::{morton_key, radix_tree};
use ccd_core::math::morton::MortonGrid;
use ccd_core::math::obb::Obb;
use ccd_core::math::vec3::{dot, sub};
use ccd_core::narrow_phase::cascade::apart;
use ccd_core::narrow_phase::coplanarity::Coplanarity;
use ccd_core::narrow_phase::relative_motion::{Motion, Patch};
use ccd_core::narrow_phase::separating_direction::beside;
use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use std::time::Duration;

/// A vertex that goes through a face, the same that stays above it or beside it, and edges that
/// cross.
fn pairs() -> ([VertexFace<f64>; 3], EdgeEdge<f64>) {
    let hit = VertexFace {
        t0: [[0.3, 1.0, 0.3], [0.0, 0.1, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        t1: [[0.2, -1.0, 0.4], [0.1, 0.0, 0.0], [1.0, 0.2, 0.1], [0.0, 0.0, 1.0]],
    };
    let mut miss = hit;
    miss.t1[0][1] = 0.9;
    let mut aside = hit;
    (aside.t0[0], aside.t1[0]) = ([-3.0, 0.1, 0.4], [-3.0, 0.0, 0.4]);
    let edges = EdgeEdge {
        t0: [[-1.0, 1.0, 0.1], [1.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.1, 0.0, 1.0]],
        t1: [[-1.0, -1.0, 0.0], [1.0, -1.1, 0.0], [0.0, 0.1, -1.0], [0.0, 0.0, 1.0]],
    };
    ([hit, miss, aside], edges)
}

/// The filters in `f32`, each by itself and as a cascade, and the decision in `f64`.
fn narrow_phase(c: &mut Criterion) {
    let ([hit, miss, aside], edges) = pairs();
    let points = |q: &VertexFace<f64>| {
        let [t0, t1] = [q.t0, q.t1].map(|x| x.map(|p| p.map(|c| c as f32)));
        Motion::new(Patch::Triangle, &t0, &t1, 0.0)
    };
    let (through, above, beside_it) = (points(&hit), points(&miss), points(&aside));
    let by_plane = |m: &Motion<f32>| Coplanarity::new(m).clearance(0.0) > 0.0;
    let by_direction = |m: &Motion<f32>| beside(m, Patch::Triangle, 0.0) > 0.0;
    let by_all = |m: &Motion<f32>| apart(m, Patch::Triangle, 0.0);
    // What each must reject, and whether it rejects what stays above.
    type Filter<'a> = (&'a str, &'a dyn Fn(&Motion<f32>) -> bool, &'a Motion<f32>, bool);
    let filters: [Filter; 3] = [
        ("Bernstein", &by_plane, &above, true),
        ("direction", &by_direction, &beside_it, false),
        ("cascade", &by_all, &beside_it, true),
    ];
    for (name, filter, apart, rejects) in filters {
        assert!(!filter(&through), "{name} rejects a contact");
        assert!(filter(apart), "{name} keeps what is apart");
        c.bench_function(&format!("filter: {name}"), |b| {
            b.iter(|| assert_eq!(filter(black_box(&above)), rejects))
        });
    }
    for (name, query, d, is_hit) in [
        ("hit", hit, 0.0, true),
        ("miss by filter", miss, 0.0, false),
        ("hit at a distance", hit, 0.01, true),
    ] {
        let want = |v: Verdict<f64>| matches!(v, Verdict::Hit { .. }) == is_hit;
        c.bench_function(&format!("query: vertex-face, {name}"), |b| {
            b.iter(|| assert!(want(ccd::vertex_face(black_box(&query), d))))
        });
    }
    c.bench_function("query: edge-edge, hit", |b| {
        b.iter(|| {
            let verdict = ccd::edge_edge(black_box(&edges), 0.0);
            assert!(matches!(verdict, Verdict::Hit { .. }))
        })
    });
    c.bench_function("oriented box of a moving triangle", |b| {
        let [[v0, rest0 @ ..], [v1, rest1 @ ..]] = [hit.t0, hit.t1];
        let separate = Obb::around(&[v0, v1]).separated(&Obb::of_moving_triangle(&rest0, &rest1));
        assert!(!separate, "boxes of features that touch are apart");
        let want = Obb::of_moving_triangle(&rest0, &rest1);
        for p in rest0.iter().chain(&rest1) {
            let along = |k: usize| dot(want.axes[k], sub(*p, want.centre)).abs();
            assert!((0..3).all(|k| along(k) <= want.half[k]), "{p:?} is not in {want:?}");
        }
        b.iter(|| {
            assert_eq!(Obb::of_moving_triangle(black_box(&rest0), black_box(&rest1)), want);
        })
    });
}

/// Cell numbers of 21 bits, interleaved bit by bit.
fn plain_code(cell: [u32; 3]) -> u64 {
    let bit = |k: usize, i: u32| ((cell[k] >> i & 1) as u64) << (3 * i + 2 - k as u32);
    (0..21).flat_map(|i| [bit(0, i), bit(1, i), bit(2, i)]).sum()
}

/// What all internal nodes of the radix tree over sorted codes hold, from the root down: leaves
/// less one.
fn plain_spans(codes: &[u64]) -> u64 {
    let key = |i: usize| (codes[i] as u128) << 32 | i as u128;
    let (mut sum, mut stack) = (0, vec![(0, codes.len() - 1)]);
    while let Some((first, last)) = stack.pop() {
        if first == last {
            continue;
        }
        sum += (last - first) as u64;
        // The first key with the highest bit that not all have in common.
        let bit = 127 - (key(first) ^ key(last)).leading_zeros();
        let (mut without, mut with) = (first, last);
        while with - without > 1 {
            let middle = without + (with - without) / 2;
            if key(middle) >> bit & 1 == 0 { without = middle } else { with = middle }
        }
        stack.extend([(first, without), (with, last)]);
    }
    sum
}

/// Codes, order and trees over uniform boxes; pairs of each method that `Blocks` differs from.
fn broad_phase(c: &mut Criterion) {
    let boxes = uniform_boxes(100_000);
    let scene = boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
    let grid = MortonGrid::new(&scene, 21);
    let code = |i: usize| morton_key::morton(i, black_box(&boxes), &grid);
    let mut codes: Vec<[u32; 2]> = (0..boxes.len()).map(code).collect();
    let long = |&[low, high]: &[u32; 2]| (high as u64) << 32 | low as u64;
    let plain: Vec<u64> = boxes.iter().map(|b| plain_code(grid.cell(b))).collect();
    assert!(codes.iter().map(long).eq(plain.iter().copied()), "other codes than bit by bit");
    let sum = plain.iter().fold(0, |sum, &code| sum ^ code as u32);
    c.bench_function("Morton codes, 100,000 boxes", |b| {
        b.iter(|| assert_eq!((0..boxes.len()).fold(0, |sum, i| sum ^ code(i)[0]), sum))
    });
    codes.sort_unstable_by_key(|&[low, high]| (high, low));
    let n = codes.len() as u32;
    let below = |codes: &[[u32; 2]]| -> u64 {
        (0..n - 1).map(|i| radix_tree::branch(i, n, codes)).map(|b| (b.last - b.first) as u64).sum()
    };
    let want = plain_spans(&codes.iter().map(long).collect::<Vec<_>>());
    c.bench_function("branches of a radix tree, 100,000 codes", |b| {
        b.iter(|| assert_eq!(below(black_box(&codes)), want))
    });
    for method in ccd::method::every("cpu").filter(|&m| {
        [BroadPhaseMethod::TREE, BroadPhaseMethod::Blocks].contains(&m)
            || !matches!(m, BroadPhaseMethod::Tree(_) | BroadPhaseMethod::BruteForce)
    }) {
        let mut broad = BroadPhase::new(1, method).expect("one thread");
        let pairs = |b: &mut BroadPhase| b.self_pairs(black_box(&boxes)).map(|p| p.len());
        c.bench_function(&format!("pairs by {method}, 100,000 uniform boxes"), |b| {
            b.iter(|| assert_eq!(pairs(&mut broad), Ok(320)))
        });
        if method == BroadPhaseMethod::Blocks {
            // The time that the method itself measures of it.
            c.bench_function("radix sort and blocks, 100,000 boxes", |b| {
                b.iter_custom(|n| {
                    let build = |_| {
                        assert_eq!(pairs(&mut broad), Ok(320));
                        Duration::from_secs_f64(broad.times().build / 1e3)
                    };
                    (0..n).map(build).sum()
                })
            });
        }
    }
}

/// Steps of a session: the default, and each scheduler with a front and without one.
fn steps(c: &mut Criterion) {
    let step = crumpled_sheet(100, 1);
    let options = Options::default().with_threads(1);
    let mut session = Session::new(step.mesh.clone(), options.clone()).expect("valid options");
    let want = session.step(&step.x0, &step.x1).expect("a valid step").contacts.len();
    assert!(want > 1000);
    c.bench_function("step: crumpled sheet of 10,000 vertices", |b| {
        b.iter(|| {
            let report = session.step(black_box(&step.x0), &step.x1);
            assert_eq!(report.map(|r| r.contacts.len()), Ok(want))
        })
    });
    let scene = interpenetrating(1024);
    let (x0, x1) = (scene.frame(3), scene.frame(4));
    let tree = TreeOptions::default().traversal(Traversal::SIMULTANEOUS);
    let want = ccd::step(&scene.mesh, &x0, &x1, &options).expect("a valid step").candidates;
    for scheduling in Scheduling::every("cpu") {
        let options = Options::default().with_threads(2).with_scheduling(scheduling);
        let options = options.with_broad_phase(BroadPhaseMethod::Tree(tree));
        let mut session = Session::new(&scene.mesh, options).expect("valid options");
        c.bench_function(&format!("step: two spheres, {scheduling}"), |b| {
            b.iter(|| {
                let report = session.step(black_box(&x0), &x1).expect("a valid step");
                assert_eq!(report.candidates, want)
            })
        });
    }
}

/// A step and a sort on a device, where there is one.
fn device(c: &mut Criterion) {
    let device = match Device::open(&DeviceOptions::default()) {
        Ok(device) => device,
        Err(why) => return println!("SKIPPED: benchmarks of a GPU: {why}"),
    };
    let Step { mesh, x0, x1 } = crumpled_sheet(100, 1);
    let want = ccd::step(&mesh, &x0, &x1, &Options::default()).expect("a valid step").candidates;
    let mut session = gpu::Session::new(&device, mesh, Options::default()).expect("a session");
    // Kernels are compiled by the first one.
    session.step(&x0, &x1).expect("a valid step");
    c.bench_function("GPU: step, crumpled sheet of 10,000 vertices", |b| {
        b.iter(|| {
            let report = session.step(black_box(&x0), &x1).expect("a valid step");
            assert_eq!(report.candidates, want)
        })
    });
    let values: Vec<u32> = (0..100_000).collect();
    let keys: Vec<u32> = values.iter().map(|&i| ccd::scenes::pcg(i)).collect();
    let mut sorter = gpu::Sorter::new(&device, 100_000).expect("memory");
    let (sorted, order) = sorter.sort(&keys, &values).expect("sorted");
    let mut want = keys.clone();
    want.sort_unstable();
    assert!(sorted == want, "other keys than those of a CPU");
    assert!(order.iter().map(|&i| keys[i as usize]).eq(want), "values without their keys");
    c.bench_function("GPU: radix sort, 100,000 keys", |b| {
        b.iter(|| {
            let (sorted, _) = sorter.sort(black_box(&keys), &values).expect("sorted");
            assert!(sorted.is_sorted())
        })
    });
}

criterion_group!(benches, narrow_phase, broad_phase, steps, device);
criterion_main!(benches);
