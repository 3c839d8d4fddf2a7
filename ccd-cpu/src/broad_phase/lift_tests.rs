//! Fronts that are lifted: what stands in one afterwards is what a step from the roots leaves, and
//! every pair of leaves is below exactly one of its pairs.

use super::block_pairs::BlockSource;
use super::pair_source::{Marks, PairSource, PairsOfNodes};
use super::scheduled::Scheduled;
use super::tree::TreeSource;
use super::*;
use ccd_core::broad_phase::pair_descent::NodePair;
use ccd_core::layout::Pair;
use ccd_core::model::method::{Descent, Traversal, TreeOptions, Volume};
use ccd_core::model::scheduling::{Front, FrontOptions, Shrink};
use std::ops::Range;

/// Boxes that jump about, and draw together in one frame of three: of `n`, at this frame.
fn boxes(n: usize, seed: u32, frame: u32) -> Vec<Aabb<f32>> {
    let unit = |i: u32| {
        let x = i.wrapping_mul(747_796_405).wrapping_add(seed.wrapping_mul(2_891_336_453));
        let x = (x >> ((x >> 28) + 4) ^ x).wrapping_mul(277_803_737);
        ((x >> 22 ^ x) >> 8) as f32 / 16_777_216.0
    };
    let (spread, jump) = match frame {
        0 => (1.0, 0.0),
        _ if frame % 3 == 1 => (0.3, 0.05),
        _ => (1.0, 0.05),
    };
    let of = |i: u32| {
        let at =
            |k: u32| spread * unit(8 * i + k) + jump * unit((1 << 20) + 64 * i + 8 * k + frame % 8);
        let (min, size) = ([at(0), at(1), at(2)], 0.8 * unit(8 * i + 5) / (n as f32).cbrt());
        Aabb { min, max: min.map(|x| x + size) }
    };
    (0..n as u32).map(of).collect()
}

/// A source over one set or two, and what it found last.
struct Search {
    source: Scheduled,
    threads: Threads,
    a: LeafBoxes,
    /// The second set, and which of its boxes are fixed from an id on.
    b: Option<LeafBoxes>,
}

impl Search {
    fn new(method: BroadPhaseMethod, options: FrontOptions, start: &Start) -> Self {
        let source: Box<dyn PairsOfNodes> = match method {
            BroadPhaseMethod::Tree(options) => Box::new(TreeSource::new(options).expect("a tree")),
            _ => Box::new(BlockSource::default()),
        };
        let scheduling = Scheduling::default().front(Front::On(options));
        let mut source = Scheduled::new(source, scheduling).expect("a scheduler");
        let threads = Threads::new(1).expect("a thread");
        let order = source.order();
        let fixed = |i: usize| i >= start.n_moving;
        let mut set = |index: usize, boxes: &[Aabb<f32>]| {
            let mut leaves = LeafBoxes::new(Set { index, searched: true });
            leaves.build(&threads, order, boxes, Marks { fixed: Some(&fixed), ..Marks::default() });
            leaves
        };
        let a = set(0, &start.a);
        let b = start.b.as_ref().map(|b| set(1, b));
        Self { source, threads, a, b }
    }

    /// Pairs of ids, of these boxes.
    fn find(&mut self, a: &[Aabb<f32>], b: Option<&[Aabb<f32>]>) -> Vec<Pair> {
        let Self { source, threads, a: of_a, b: of_b } = self;
        of_a.refit(threads, source.order(), a, false);
        let (mut workers, mut runs) = (Vec::new(), Vec::new());
        if let (Some(of_b), Some(b)) = (&mut *of_b, b) {
            of_b.refit(threads, source.order(), b, false);
            workers.resize_with(1, Lister::default);
            let sink = Listing::<false> {
                a: of_a,
                b: of_b,
                slack: 0.0,
                confirm: None,
                stop: &threads.stop,
            };
            source.find(threads, (of_a, Some(of_b)), 1, &sink, &mut workers);
        } else {
            workers.resize_with(1, Lister::default);
            let sink = Listing::<true> {
                a: of_a,
                b: of_a,
                slack: 0.0,
                confirm: None,
                stop: &threads.stop,
            };
            source.find(threads, (of_a, None), 1, &sink, &mut workers);
        }
        order_runs(&workers, &mut runs);
        let mut pairs = Pairs::new(&runs, &workers).to_vec();
        pairs.sort_unstable_by_key(|p| (p.a, p.b));
        pairs
    }
}

/// Boxes at the build, and how many of them move.
struct Start {
    a: Vec<Aabb<f32>>,
    b: Option<Vec<Aabb<f32>>>,
    n_moving: usize,
}

/// The leaves below the nodes of both sides of a pair.
type Ranges<'r> = &'r dyn Fn(NodePair) -> [Range<usize>; 2];

/// How many pairs of a front every pair of leaves is below: the least and the most, over those of
/// which `counts`.
fn covered(
    front: &[NodePair],
    [n, m]: [usize; 2],
    within: bool,
    ranges: Ranges,
    counts: &dyn Fn(usize, usize) -> bool,
) -> (u8, u8) {
    let mut times = vec![0u8; n * m];
    for &pair in front {
        let [of_a, of_b] = ranges(pair);
        for i in of_a {
            for j in of_b.clone().filter(|&j| !within || i < j) {
                times[i * m + j] += 1;
            }
        }
    }
    let all = (0..n * m).map(|k| (k / m, k % m)).filter(|&(i, j)| !within || i < j);
    all.filter(|&(i, j)| counts(i, j)).fold((u8::MAX, 0), |(least, most), (i, j)| {
        (least.min(times[i * m + j]), most.max(times[i * m + j]))
    })
}

/// Steps over frames with a front that is lifted in every other one. Returns how many pairs were
/// lifted away.
fn check(
    method: BroadPhaseMethod,
    n: usize,
    m: Option<usize>,
    n_moving: usize,
    seed: u32,
) -> usize {
    let frame = |f: u32| {
        let mut all = (boxes(n, seed, f), m.map(|m| boxes(m, seed + 1, f)));
        // What is fixed stays where it was.
        let first = (boxes(n, seed, 0), m.map(|m| boxes(m, seed + 1, 0)));
        (n_moving..n).for_each(|i| all.0[i] = first.0[i]);
        if let (Some(b), Some(first)) = (&mut all.1, &first.1) {
            (n_moving..b.len()).for_each(|i| b[i] = first[i]);
        }
        all
    };
    let (a, b) = frame(0);
    let start = Start { a, b, n_moving };
    // Whatever its length, a front is given up one step after it was made.
    let always = FrontOptions::default().rebuild(1, u32::MAX).shrink(Shrink::Lift);
    let mut lifting = Search::new(method, always, &start);
    let never = FrontOptions::default().growth(u32::MAX);
    let mut deeper = Search::new(method, never, &start);
    let is_blocks = method == BroadPhaseMethod::Blocks;
    let aabb = !matches!(method, BroadPhaseMethod::Tree(t) if t.volume == Volume::Obb);
    let (mut n_lifted, mut n_steps) = (0, 0);
    for f in 0..14 {
        let (a, b) = frame(f);
        let lifts = f > 0 && lifting.source.kept().1;
        deeper.find(&a, b.as_deref());
        let found = lifting.find(&a, b.as_deref());
        let brute = |i: usize, j: usize| match &b {
            Some(b) => a[i].overlaps(&b[j]),
            None => i < j && a[i].overlaps(&a[j]),
        };
        let is_wanted = |i: usize, j: usize| !is_blocks || i < n_moving || j < n_moving;
        let all = (0..n).flat_map(|i| (0..m.unwrap_or(n)).map(move |j| (i, j)));
        let want: Vec<Pair> = all
            .filter(|&(i, j)| is_wanted(i, j) && brute(i, j))
            .map(|(i, j)| Pair { a: i as u32, b: j as u32 })
            .collect();
        assert_eq!(found, want, "{method}, {n}, {m:?}, seed {seed}, frame {f}");
        if !lifts {
            continue;
        }
        n_steps += 1;
        let (after, _) = lifting.source.kept();
        n_lifted += deeper.source.kept().0.len() - after.len();
        // From the roots, once for the room and once for the front.
        let mut fresh = Search::new(method, FrontOptions::default(), &start);
        fresh.find(&a, b.as_deref());
        fresh.find(&a, b.as_deref());
        let (want, _) = fresh.source.kept();
        if aabb {
            assert!(after == want, "{method}, {n}, {m:?}, seed {seed}, frame {f}: other fronts");
        }
        let (orders, within) =
            ([&lifting.a, lifting.b.as_ref().unwrap_or(&lifting.a)], b.is_none());
        let counts = |i: usize, j: usize| {
            let moves = |side: usize, leaf: usize| (orders[side].order()[leaf] as usize) < n_moving;
            !is_blocks || moves(0, i) || moves(1, j)
        };
        let sizes = [n, m.unwrap_or(n)];
        let times = if let BroadPhaseMethod::Tree(options) = method {
            let mut twin = TreeSource::new(options).expect("a tree");
            for (index, boxes) in
                [Some(&start.a), start.b.as_ref()].into_iter().flatten().enumerate()
            {
                let mut leaves = LeafBoxes::new(Set { index, searched: true });
                leaves.build(&lifting.threads, &mut twin, boxes, Marks::default());
            }
            let side = |k: usize, node: u32| {
                let range = twin.tree(if within { 0 } else { k }).range(node);
                range.start as usize..range.end as usize
            };
            covered(&after, sizes, within, &|[i, j]| [side(0, i), side(1, j)], &counts)
        } else {
            let below = |k: usize, level: u32, block: u32| {
                let width = 8usize.pow(level + 1);
                let end = |i: usize| (i * width).min(sizes[k]);
                end(block as usize)..end(block as usize + 1)
            };
            let ranges = |[a, b]: NodePair| {
                let (level, a) = (a >> 28, a & ((1 << 28) - 1));
                [below(0, level, a), below(1, level, b)]
            };
            covered(&after, sizes, within, &ranges, &counts)
        };
        assert_eq!(times, (1, 1), "{method}, {n}, {m:?}, seed {seed}, frame {f}: covered");
    }
    assert!(n_steps > 1, "{method}, {n}, {m:?}: {n_steps} steps lift");
    n_lifted
}

fn tree(traversal: Traversal, volume: Volume) -> BroadPhaseMethod {
    BroadPhaseMethod::Tree(TreeOptions::default().traversal(traversal).volume(volume))
}

#[test]
fn small_trees_are_lifted_to_what_the_roots_give() {
    let cut = |nodes| Traversal::Cut { nodes, descent: Descent::Both };
    for volume in [Volume::Aabb, Volume::Obb] {
        for traversal in [Traversal::SIMULTANEOUS, cut(2), cut(5), cut(20)] {
            let mut n_lifted = 0;
            for n in 2..12 {
                for seed in 0..6 {
                    n_lifted += check(tree(traversal, volume), n, None, n, seed);
                    for m in [1, 2, 5, 30] {
                        n_lifted += check(tree(traversal, volume), n, Some(m), n.max(m), seed);
                    }
                }
            }
            n_lifted += check(tree(traversal, volume), 150, None, 150, 7);
            n_lifted += check(tree(traversal, volume), 150, Some(90), 150, 7);
            // Pairs of all nodes of a cut are never lifted beyond it.
            assert!(n_lifted > 100, "{traversal:?}, {volume:?}: {n_lifted} pairs show nothing");
        }
    }
}

#[test]
fn blocks_are_lifted_to_what_the_roots_give() {
    let mut n_lifted = 0;
    for (n, m) in [(9, None), (3000, None), (700, Some(80)), (80, Some(3000))] {
        for n_moving in [n.max(m.unwrap_or(n)), n / 3] {
            n_lifted += check(BroadPhaseMethod::Blocks, n, m, n_moving, 3);
        }
    }
    assert!(n_lifted > 100, "{n_lifted} pairs show nothing");
}

/// By the larger of two nodes nobody knows what was above a pair: given up, and nothing is lost.
#[test]
fn what_has_no_certain_parents_is_dropped() {
    let method = tree(Traversal::Simultaneous(Descent::Larger), Volume::Aabb);
    let always = FrontOptions::default().rebuild(1, u32::MAX).shrink(Shrink::Lift);
    let start = Start { a: boxes(100, 1, 0), b: None, n_moving: 100 };
    let mut search = Search::new(method, always, &start);
    let mut dropped = 0;
    for f in 1..9 {
        search.find(&boxes(100, 1, f), None);
        let (front, lifts) = search.source.kept();
        assert!(!lifts);
        dropped += (front.is_empty()) as usize;
    }
    assert!(dropped > 2, "{dropped}");
}
