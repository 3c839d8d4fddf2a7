//! Kernels that filter and decide, on coordinates that break arithmetic: zeros of both signs,
//! denormals, the smallest normal number, neighbours of 1, numbers whose products leave the range
//! of `f32`. (Hosts refuse NaN and infinity; `kernels.rs` and `scalars.rs` have those.) Against
//! `f64` on the CPU, and exact arithmetic where that is not certain.

use crate::pairs::filtered;
use crate::queries::{Ends, cpu_verdict, decide};
use crate::support::TINY;
use crate::twin::Twin;
use ccd::gpu::Device;
use ccd::{Mesh, TOI_TOLERANCE, Verdict};
use ccd_core::backend::layout::Path;
use ccd_core::narrow_phase::pair_verdict::{edge_edge_ids, vertex_face_ids};
use ccd_core::narrow_phase::relative_motion::Patch;
use ccd_testkit::generate::Random;
use ccd_testkit::grazing::exact::{Contact, contact};
use ccd_testkit::{brute, compare};

pub const TESTS: crate::Tests =
    &[("poisoned_queries", check_queries), ("poisoned_filters", check_filters)];

/// Small and large numbers by themselves: times of both together are finer than those that exact
/// arithmetic tells apart.
const POISON: [[f32; 8]; 2] = [
    [0.0, -0.0, 1e-45, -1e-40, TINY, -1.5 * TINY, 1e-20, 1.0 - f32::EPSILON / 2.0],
    [0.0, 1.0 + f32::EPSILON, 1e12, 1e19, -1e30, 1e30, 2.9e38, -3.4e38],
];

/// A point whose coordinates are poison, so many of a hundred, or some of few ordinary numbers, so
/// that features meet.
fn point(random: &mut Random, poison: u32, family: usize) -> [f32; 3] {
    std::array::from_fn(|_| {
        if random.below(100) < poison {
            POISON[family][random.below(8) as usize]
        } else {
            random.below(9) as f32 * 0.25 - 1.0
        }
    })
}

/// A device may be less certain than the CPU, but not certain of something else.
fn check_verdict(is_vf: bool, ends: Ends, cpu: Verdict<f64>, device: Verdict<f64>) {
    match (cpu, device) {
        (Verdict::Hit { .. }, Verdict::Miss) | (Verdict::Miss, Verdict::Hit { .. }) => {
            panic!("{ends:?}: {cpu:?} on the CPU, {device:?}")
        }
        (Verdict::Hit { toi: want }, Verdict::Hit { toi }) => {
            let near = (toi - want).abs() <= 2.0 * TOI_TOLERANCE;
            assert!(near, "{ends:?}: {cpu:?} on the CPU, {device:?}");
        }
        (Verdict::Undecided { .. }, Verdict::Miss) => {
            let patch = if is_vf { Patch::Triangle } else { Patch::Parallelogram };
            let answer = contact(patch, &ends.0, &ends.1);
            assert!(!matches!(answer, Contact::At(..)), "{ends:?}: missed, {answer:?}");
        }
        _ => {}
    }
}

fn check_queries(device: &Device) {
    for is_vf in [true, false] {
        let mut random = Random::new(31 + is_vf as u32);
        let mut ends = |poison: u32, family| -> Ends {
            let mut four =
                || std::array::from_fn(|_| point(&mut random, poison, family).map(f64::from));
            (four(), four())
        };
        let queries: Vec<Ends> =
            (0..4000).map(|i| ends([0, 5, 20, 60][i % 4], i / 4 % 2)).collect();
        let (mut n_misses, mut n_hits) = (0, 0);
        for (&query, verdict) in queries.iter().zip(decide(device, is_vf, &queries, 0.0)) {
            let cpu = cpu_verdict(is_vf, query, 0.0);
            check_verdict(is_vf, query, cpu, verdict);
            n_misses += (verdict == Verdict::Miss) as usize;
            n_hits += matches!(cpu, Verdict::Hit { .. }) as usize;
        }
        println!("{} queries: {n_misses} misses, {n_hits} certain contacts", queries.len());
        assert!(
            n_misses > 1000 && n_hits > 30,
            "{n_misses} misses, {n_hits} contacts show nothing"
        );
    }
}

fn check_filters(device: &Device) {
    let mut random = Random::new(77);
    let n = 60u32;
    let mut end = |i: u32| point(&mut random, i % 12, i as usize / 3 % 2);
    let mut ends = |i: u32| (end(i), end(i));
    let (x0, x1): (Vec<[f32; 3]>, Vec<[f32; 3]>) = (0..3 * n).map(&mut ends).unzip();
    let faces: Vec<[u32; 3]> = (0..n).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let mesh = Mesh::new(x0.len(), &faces).unwrap();
    // As kernels box them: bounds beyond the greatest become that.
    let sets = brute::swept_boxes(&mesh, &x0, &x1)
        .map(|set| set.iter().map(|b| b.round_out()).collect::<Vec<_>>());
    let twin = Twin::of_mesh(&mesh, &sets);
    let four = |p: [f32; 3]| [p[0], p[1], p[2], 0.0];
    let paths: Vec<Path> =
        x0.iter().zip(&x1).map(|(p, q)| Path { t0: four(*p), t1: four(*q) }).collect();
    let candidates = brute::candidates_among(&mesh, &sets);
    for (kind, all) in (0..).zip(candidates) {
        let blocks = twin.node_pairs(1, kind);
        let (counted, left) = filtered(device, &twin, &paths, kind, &blocks, 3);
        let counted = counted as usize;
        // A device that flushes denormals finds boxes to touch that are apart by less than the
        // smallest normal number.
        let n = all.len();
        assert!((n..=n + n / 10).contains(&counted), "{counted} candidates, {n} by brute force");
        let (mut n_touching, mut n_dropped) = (0, 0);
        for pair in all {
            let ids = if kind == 0 {
                vertex_face_ids(pair, &faces)
            } else {
                edge_edge_ids(pair, mesh.edges())
            };
            let at = |x: &[[f32; 3]]| ids.map(|v| x[v as usize].map(f64::from));
            let query = (at(&x0), at(&x1));
            let cpu = cpu_verdict(kind == 0, query, 0.0);
            n_touching += matches!(cpu, Verdict::Hit { .. }) as usize;
            if left.binary_search(&pair).is_err() {
                n_dropped += 1;
                check_verdict(kind == 0, query, cpu, Verdict::Miss);
            }
        }
        let seen = format!("{counted} candidates, {n_dropped} dropped, {n_touching} contacts");
        println!("kind {kind}: {seen}");
        assert!(n_touching > 20 && n_dropped > 100, "{seen} show nothing");
    }
}

/// The comparison fails when it should.
pub fn check_negative_control() {
    // A vertex that falls through a face, at t = 1/2.
    let face = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let ends = (
        [[0.25, 1.0, 0.25], face[0], face[1], face[2]],
        [[0.25, -1.0, 0.25], face[0], face[1], face[2]],
    );
    let (hit, other) = (Verdict::Hit { toi: 0.5 }, Verdict::Hit { toi: 0.6 });
    let (miss, open) = (Verdict::Miss, Verdict::Undecided { toi: 0.0 });
    let fails = |(cpu, device)| compare::fails(|| check_verdict(true, ends, cpu, device));
    assert!(![(hit, hit), (hit, open), (miss, open), (open, hit)].into_iter().any(fails));
    assert!([(hit, miss), (miss, hit), (hit, other), (open, miss)].into_iter().all(fails));
}
