//! Kernel bodies and pieces of the pipeline under criterion; every benchmark asserts its answer.

use ccd::{Aabb, BroadPhase, BroadPhaseMethod, EdgeEdge, Options, Session, Verdict, VertexFace};
use ccd_core::broad_phase::{morton_key, radix_tree};
use ccd_core::layout::Pair;
use ccd_core::math::morton::MortonGrid;
use ccd_testkit::brute::swept_boxes;
use ccd_testkit::generate::{crumpled_sheet, uniform_boxes};
use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;

fn queries(c: &mut Criterion) {
    let hit = VertexFace {
        t0: [[0.3, 1.0, 0.3], [0.0, 0.1, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        t1: [[0.2, -1.0, 0.4], [0.1, 0.0, 0.0], [1.0, 0.2, 0.1], [0.0, 0.0, 1.0]],
    };
    let mut miss = hit;
    miss.t1[0][1] = 0.9;
    let edges = EdgeEdge {
        t0: [[-1.0, 1.0, 0.1], [1.0, 1.0, 0.0], [0.0, 0.0, -1.0], [0.1, 0.0, 1.0]],
        t1: [[-1.0, -1.0, 0.0], [1.0, -1.1, 0.0], [0.0, 0.1, -1.0], [0.0, 0.0, 1.0]],
    };
    assert!(matches!(ccd::vertex_face(&hit, 0.0), Verdict::Hit { .. }));
    assert_eq!(ccd::vertex_face(&miss, 0.0), Verdict::Miss);
    assert!(matches!(ccd::edge_edge(&edges, 0.0), Verdict::Hit { .. }));
    c.bench_function("query vertex-face, hit", |b| {
        b.iter(|| ccd::vertex_face(black_box(&hit), 0.0))
    });
    c.bench_function("query vertex-face, miss by filter", |b| {
        b.iter(|| ccd::vertex_face(black_box(&miss), 0.0))
    });
    c.bench_function("query vertex-face, at a distance", |b| {
        b.iter(|| ccd::vertex_face(black_box(&hit), 0.01))
    });
    c.bench_function("query edge-edge, hit", |b| b.iter(|| ccd::edge_edge(black_box(&edges), 0.0)));
}

fn boxes(c: &mut Criterion) {
    let boxes = uniform_boxes(100_000);
    let scene = boxes.iter().fold(Aabb::EMPTY, |all, b| all.union(b));
    let grid = MortonGrid::new(&scene, 21);
    let mut codes: Vec<[u32; 2]> =
        (0..boxes.len()).map(|i| morton_key::morton(i, &boxes, &grid)).collect();
    c.bench_function("morton, 100,000 boxes", |b| {
        b.iter(|| {
            (0..boxes.len())
                .fold(0u32, |sum, i| sum ^ morton_key::morton(i, black_box(&boxes), &grid)[0])
        })
    });
    codes.sort_unstable_by_key(|&[low, high]| (high, low));
    c.bench_function("tree branches, 100,000 boxes", |b| {
        b.iter(|| {
            let leaves: u64 = (0..codes.len() as u32 - 1)
                .map(|i| radix_tree::branch(i, codes.len() as u32, black_box(&codes)))
                .map(|n| (n.last - n.first) as u64)
                .sum();
            assert!(leaves > codes.len() as u64);
        })
    });
    for (name, method) in [("blocks", BroadPhaseMethod::Blocks), ("tree", BroadPhaseMethod::TREE)] {
        let mut broad = BroadPhase::new(1, method).expect("one thread");
        c.bench_function(&format!("broad phase by {name}, 100,000 uniform boxes"), |b| {
            b.iter(|| assert_eq!(broad.self_pairs(black_box(&boxes)).map(|p| p.len()), Ok(320)))
        });
    }
}

fn steps(c: &mut Criterion) {
    let step = crumpled_sheet(100, 1);
    let mut session =
        Session::new(step.mesh.clone(), Options::default().with_threads(1)).expect("valid options");
    let want = session.step(&step.x0, &step.x1).expect("a valid step").contacts.len();
    c.bench_function("step, crumpled sheet of 10,000 vertices", |b| {
        b.iter(|| {
            assert_eq!(
                session.step(black_box(&step.x0), &step.x1).map(|r| r.contacts.len()),
                Ok(want)
            )
        })
    });
    let [_, edges, _] = swept_boxes(&step.mesh, &step.x0, &step.x1);
    let mut broad = BroadPhase::new(1, BroadPhaseMethod::Blocks).expect("one thread");
    let want: Vec<Pair> = broad.self_pairs(&edges).expect("valid boxes").to_vec();
    c.bench_function("broad phase in f64, edges of that sheet", |b| {
        b.iter(|| assert_eq!(broad.self_pairs(black_box(&edges)).map(|p| p.len()), Ok(want.len())))
    });
}

criterion_group!(benches, queries, boxes, steps);
criterion_main!(benches);
