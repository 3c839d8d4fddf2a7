//! The kernels that find pairs, each by itself against brute
//! force; and the broad phase made of them.

use crate::emulated::methods;
use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, entries, list, paths, read, run, twin};
use crate::twin::Twin;
use ccd::gpu::bind::{
    FilterPairs, ListCandidates, ListOverlaps, ListOverlapsBySubgroups, ListWanted, NodePairs,
};
use ccd::gpu::{BroadPhase, Device};
use ccd::method::BroadPhaseMethod;
use ccd::{Aabb, Pair, Verdict};
use ccd_core::backend::broad_phase::block_bvh::{self, marked, sets, slot};
use ccd_core::backend::layout::elements::kind_of;
use ccd_core::backend::layout::{Dispatch, Filtering, Frame, LIST_HEADER, Params, Path};
use ccd_testkit::brute;
use ccd_testkit::generate::{Step, uniform_boxes};

pub const TESTS: crate::Tests = &[
    ("node_pairs", check_node_pairs),
    ("overlaps", check_overlaps),
    ("counts", check_counts),
    ("candidates", check_candidates),
    ("filters", check_filters),
    ("odd_boxes", check_odd),
    ("uniform_boxes", check_uniform),
];

fn check_node_pairs(device: &Device) {
    let (twin, _) = twin(70, 3);
    for kind in [0, 1] {
        let above = twin.node_pairs(2, kind);
        let want = twin.node_pairs(1, kind);
        let kernel =
            NodePairs { nodes: bytes(&twin.nodes), input: list(&above), output: capacity(50_000) };
        // Few workgroups, so that each takes several rounds; many, so that some have nothing to do.
        for groups in [1, 3, 500] {
            let done =
                run(device, kernel.clone(), &twin.pass(kind, 2, above.len(), 50_000), groups);
            check_pairs("node pairs", want.clone(), entries(&done.output));
        }
        // Pairs of nodes below which all stands still are left out.
        let is_still = |set: usize, i: u32| !(i + set as u32).is_multiple_of(3);
        let mut nodes = twin.nodes.clone();
        let tree = &twin.tree;
        for set in 0..3 {
            for (i, node) in (0..).zip(&mut nodes[slot(tree, 1, set, 0)..tree.slots[2][0] as usize])
            {
                if (tree.slots[1][set] + i) < tree.slots[1][set + 1] {
                    *node = marked(node, is_still(set, i));
                }
            }
        }
        let mut p = twin.pass(kind, 2, above.len(), 50_000);
        p.frame.flags |= Frame::FLAG_STILL;
        let [a, b] = sets(kind);
        let moves = |pair: &Pair| !(is_still(a, pair.a) && is_still(b, pair.b));
        let moving: Vec<Pair> = want.iter().copied().filter(moves).collect();
        assert!(moving.len() > 10 && moving.len() < want.len());
        let done = run(device, NodePairs { nodes: bytes(&nodes), ..kernel.clone() }, &p, 3);
        check_pairs("node pairs that move", moving, entries(&done.output));
        // A list that is too short counts everything and writes nothing beyond its end.
        let short = NodePairs { output: capacity(20), ..kernel };
        let words: Vec<u32> =
            read(&run(device, short, &twin.pass(kind, 2, above.len(), 10), 7).output);
        assert_eq!(words[0] as usize, want.len());
        assert!(words[LIST_HEADER + 20..].iter().all(|&w| w == 0), "written beyond the capacity");
    }
}

/// Boxes alone, by every kernel that lists those that overlap.
fn check_overlaps(device: &Device) {
    // Besides real ones equal boxes: so many that lists are short, and blocks of 16, 17 and 32.
    let on_each_other = |n: usize| [Aabb { min: [0.0; 3], max: [1.0; 3] }].repeat(n);
    let of_features = twin(70, 3).0;
    let of = |n, m, k| {
        let sets = [n, m, k].map(on_each_other);
        Twin::new([&sets[0], &sets[1], &sets[2]], |_, i| [i; 3])
    };
    for twin in [of_features, of(300, 170, 33), of(1, 16, 1), of(32, 17, 31), of(1, 32, 0)] {
        for kind in [0, 1] {
            let boxes = sets(kind).map(|set| {
                let first = twin.frame.start[set] as usize;
                &twin.boxes[first..first + twin.frame.count[set] as usize]
            });
            let [a, b] = boxes;
            let want = if kind == 0 { brute::pairs(a, b) } else { brute::self_pairs(b) };
            let blocks = twin.node_pairs(1, kind);
            for (groups, room) in [(1, 200_000), (3, 200_000), (500, 10)] {
                let kernel = ListOverlaps {
                    nodes: bytes(&twin.nodes),
                    order: bytes(&twin.order),
                    input: list(&blocks),
                    output: capacity(room.max(20)),
                };
                let p = twin.pass(kind, 1, blocks.len(), room);
                let mut done = vec![run(device, kernel.clone(), &p, groups).output];
                if device.info().subgroups {
                    let ListOverlaps { nodes, order, input, output } = kernel;
                    let kernel = ListOverlapsBySubgroups { nodes, order, input, output };
                    done.push(run(device, kernel, &p, groups).output);
                }
                for output in done {
                    let words: Vec<u32> = read(&output);
                    assert_eq!(words[..4], [want.len() as u32, 0, 0, 0]);
                    if want.len() <= room as usize {
                        check_pairs("overlaps", want.clone(), entries(&output));
                    } else {
                        let behind = &words[LIST_HEADER + 2 * room as usize..];
                        assert!(behind.iter().all(|&w| w == 0), "written beyond the capacity");
                    }
                }
            }
        }
    }
}

/// The kernel that lists candidates.
fn lister(twin: &Twin, blocks: &[Pair], output: Vec<u8>) -> ListCandidates<Vec<u8>> {
    let (nodes, leaves) = (bytes(&twin.nodes), bytes(&twin.leaves));
    ListCandidates {
        nodes,
        leaves,
        ends: if twin.ends.is_empty() { vec![0; 16] } else { bytes(&twin.ends) },
        input: list(blocks),
        output,
    }
}

/// A count that exceeds 32 bits says so: both words of headers, in every kernel that adds to them.
fn check_counts(device: &Device) {
    let boxes: Vec<Aabb> = uniform_boxes(2000).iter().map(|b| b.inflated(0.03)).collect();
    let twin = Twin::new([&[], &boxes, &[]], |_, i| [2 * i, 2 * i + 1, 2 * i + 1]);
    let (above, blocks) = (twin.node_pairs(2, 1), twin.node_pairs(1, 1));
    let n_hits = brute::self_pairs(&boxes).len() as u32;
    let near = |back: u32| bytes(&[0u32.wrapping_sub(back), 0u32.wrapping_sub(back), 0, 0]);
    for (back, wraps) in [(1, 1), (n_hits, 1), (n_hits + 1, 0)] {
        let kernel = lister(&twin, &blocks, near(back));
        let head: Vec<u32> =
            read(&run(device, kernel, &twin.pass(1, 1, blocks.len(), 0), 5).output[..16]);
        assert_eq!(
            head,
            [n_hits.wrapping_sub(back), n_hits.wrapping_sub(back), wraps, wraps],
            "candidates"
        );
    }
    let kernel = NodePairs { nodes: bytes(&twin.nodes), input: list(&above), output: near(1) };
    let done = run(device, kernel, &twin.pass(1, 2, above.len(), 0), 1);
    assert_eq!(
        read::<u32>(&done.output[..16]),
        [blocks.len() as u32 - 1, u32::MAX, 1, 0],
        "pairs of nodes"
    );
}

/// Candidates by testing each feature against each.
pub fn candidates(twin: &Twin, step: &Step, kind: u32) -> Vec<Pair> {
    let single = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<[f32; 3]>>();
    let [vf, ee] = brute::candidates(&step.mesh, &single(&step.x0), &single(&step.x1));
    assert_eq!(twin.frame.count[1] as usize, step.mesh.edges().len());
    if kind == 0 { vf } else { ee }
}

fn check_candidates(device: &Device) {
    let (twin, step) = twin(50, 4);
    for kind in [0, 1] {
        let want = candidates(&twin, &step, kind);
        let blocks = twin.node_pairs(1, kind);
        let kernel = lister(&twin, &blocks, capacity(100_000));
        let pass = twin.pass(kind, 1, blocks.len(), 100_000);
        // With rules, of which there are none, they are the same.
        let ListCandidates { nodes, leaves, ends, input, output } = kernel.clone();
        let (bodies, keys) = (vec![0; 16], vec![0; 48]);
        let by_rules = ListWanted { nodes, leaves, ends, bodies, keys, input, output };
        let by_rules = run(device, by_rules, &pass, 9).output;
        check_pairs("wanted candidates", want.clone(), entries(&by_rules));
        let done = run(device, kernel, &pass, 9);
        check_pairs("candidates", want, entries(&done.output));
    }
    // So many hits at once that the pool of a workgroup overflows: every box overlaps every other.
    let boxes = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 200];
    let twin = Twin::new([&[], &boxes, &[]], |_, i| [2 * i, 2 * i + 1, 2 * i + 1]);
    let blocks = twin.node_pairs(1, 1);
    let kernel = lister(&twin, &blocks, capacity(20_000));
    let done = run(device, kernel, &twin.pass(1, 1, blocks.len(), 20_000), 2);
    const { assert!(4 * 1024 > block_bvh::POOL) };
    check_pairs("boxes on one another", brute::self_pairs(&boxes), entries(&done.output));
}

/// What the filters leave is a part of the candidates, and what they drop certainly does not touch.
fn check_filters(device: &Device) {
    let (twin, step) = twin(40, 5);
    let paths = paths(&step, false);
    for kind in [0, 1] {
        let all = candidates(&twin, &step, kind);
        let blocks = twin.node_pairs(1, kind);
        let (counted, left) = filtered(device, &twin, &paths, kind, &blocks, 9);
        assert_eq!(counted as usize, all.len(), "candidates that were counted");
        assert!(
            left.windows(2).all(|w| w[0] != w[1]) && left.len() < all.len() / 2,
            "{} of {} are left",
            left.len(),
            all.len()
        );
        let mut n_touching = 0;
        for pair in all {
            let touches = verdict(&step, kind, pair, &paths) != Verdict::Miss;
            n_touching += touches as usize;
            assert!(
                !touches || left.binary_search(&pair).is_ok(),
                "{pair:?} touches and was dropped"
            );
        }
        assert!(n_touching > 100, "{n_touching} contacts show nothing");
    }
    // By boxes at both ends what an axis keeps apart is not even listed.
    let at_ends = twin.clone().with_ends(&paths);
    let (mut both, mut left_of_both) = ([Vec::new(), Vec::new()], Vec::new());
    for kind in [0, 1] {
        let blocks = twin.node_pairs(1, kind);
        let left = |twin: &Twin| filtered(device, twin, &paths, kind, &blocks, 9);
        let want = left(&twin);
        assert_eq!(left(&at_ends), want);
        let listed = |twin: &Twin| {
            let kernel = lister(twin, &blocks, capacity(100_000));
            read::<u32>(&run(device, kernel, &twin.pass(kind, 1, blocks.len(), 100_000), 9).output)
        };
        let (all, near) = (listed(&twin), listed(&at_ends));
        assert_eq!([all[0], near[1]], [all[1]; 2]);
        assert!(near[0] < all[0] && near[0] as usize > want.1.len());
        let mut gone = at_ends.clone();
        gone.ends.iter_mut().step_by(2).for_each(|four| *four = [9e9; 4]);
        let other = left(&gone);
        assert!(other.0 > want.0 && other.1.len() < want.1.len(), "ends are not read");
        // A part that wants more than fits says how much; one that does not, nothing.
        let mut p = twin.pass(kind, 1, blocks.len(), 20);
        p.frame.flags |= Frame::FLAG_IN_PARTS;
        let short = run(device, lister(&twin, &blocks, capacity(20)), &p, 9).output;
        assert_eq!(read::<u32>(&short)[..4], [all[0], all[0], all[0], 0]);
        assert!(read::<u32>(&short)[LIST_HEADER + 40..].iter().all(|&w| w == 0));
        // Also where the count itself ran over, whatever it says then.
        let full = bytes(&[u32::MAX, 0, 0, 0]);
        p.dispatch.capacity_out = 0;
        let over = run(device, lister(&twin, &blocks, full), &p, 9).output;
        assert_eq!(read::<u32>(&over)[..4], [all[0] - 1, all[0], u32::MAX, 0]);
        p.dispatch.capacity_out = 100_000;
        let long = run(device, lister(&twin, &blocks, capacity(100_000)), &p, 9).output;
        assert_eq!(read::<u32>(&long)[..4], [all[0], all[0], 0, 0]);
        // Filtered in two parts, into a list that is too short.
        let mut n_left = 0;
        for (first, n) in [(0, 2), (2, u32::MAX - 2)] {
            let dispatch = Dispatch { n, first, capacity_in: 100_000, capacity_out: 20 };
            let lists = of_kind(kind, long.clone());
            let output = survivors(device, &twin, &paths, lists, dispatch, 3);
            assert!(output[LIST_HEADER + 40..].iter().all(|&w| w == 0), "beyond the capacity");
            n_left += output[0] as usize;
        }
        assert_eq!(n_left, want.1.len());
        both[kind as usize] = long;
        left_of_both.push(want.1);
    }
    // Both kinds together, in parts that end within the one and within the other.
    let mut found = [Vec::new(), Vec::new()];
    for (first, n) in [(0, 3), (3, 8), (11, u32::MAX - 11)] {
        let dispatch = Dispatch { n, first, capacity_in: 100_000, capacity_out: 100_000 };
        let output = survivors(device, &twin, &paths, both.clone(), dispatch, 3);
        assert_eq!(output[1] as usize, survivors_of(&output, 1).count());
        for (kind, found) in (0..).zip(&mut found) {
            found.extend(survivors_of(&output, kind));
        }
    }
    found.iter_mut().for_each(|found| found.sort_unstable());
    assert!(found[..] == left_of_both[..], "both kinds together");
}

/// The candidates of pairs of blocks that are counted, and those that the filters leave, sorted.
pub fn filtered(
    device: &Device,
    twin: &Twin,
    paths: &[Path],
    kind: u32,
    blocks: &[Pair],
    groups: u32,
) -> (u32, Vec<Pair>) {
    let kernel = lister(twin, blocks, capacity(100_000));
    let listed = run(device, kernel, &twin.pass(kind, 1, blocks.len(), 100_000), groups).output;
    let counted = read::<u32>(&listed)[1];
    let n = 100_000;
    let dispatch = Dispatch { n, first: 0, capacity_in: n, capacity_out: n };
    let words = survivors(device, twin, paths, of_kind(kind, listed), dispatch, groups);
    let mut left: Vec<Pair> = survivors_of(&words, kind).collect();
    left.sort_unstable();
    assert_eq!(words[..4], [left.len() as u32, kind * left.len() as u32, 0, 0]);
    (counted, left)
}

/// Lists of both kinds, one of which is empty.
fn of_kind(kind: u32, list: Vec<u8>) -> [Vec<u8>; 2] {
    if kind == 0 { [list, capacity(0)] } else { [capacity(0), list] }
}

/// The list that the filters make of candidates of both kinds.
fn survivors(
    device: &Device,
    twin: &Twin,
    paths: &[Path],
    [vf, ee]: [Vec<u8>; 2],
    dispatch: Dispatch,
    groups: u32,
) -> Vec<u32> {
    let (elements, paths) = (bytes(&twin.elements()), bytes(paths));
    let output = capacity(dispatch.capacity_out);
    let kernel = FilterPairs { elements, paths, vf, ee, output };
    let args = Filtering { capacity_ee: dispatch.capacity_in };
    read(&run(device, kernel, &Params { frame: twin.frame, dispatch, args }, groups).output)
}

/// The pairs of a kind of such a list.
fn survivors_of(words: &[u32], kind: u32) -> impl Iterator<Item = Pair> {
    let pairs = entries(&bytes(words)).into_iter().map(kind_of);
    pairs.filter(move |(of, _)| *of == kind).map(|(_, pair)| pair)
}

fn verdict(step: &Step, kind: u32, pair: Pair, paths: &[Path]) -> Verdict<f64> {
    use ccd::Kind;
    use ccd_core::narrow_phase::pair_verdict;
    use ccd_core::narrow_phase::search::Search;
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
    let kind = if kind == 0 { Kind::VertexFace } else { Kind::EdgeEdge };
    let wanted = Search::whole(0.0);
    pair_verdict::pair(kind, step.mesh.vertices_of(kind, pair), [&x0, &x1], &wanted).verdict
}

/// Boxes that are points, and boxes as large as they may be; what are no boxes. All others are in
/// the conformance table.
fn check_odd(device: &Device) {
    let odd = [
        Aabb { min: [0.0; 3], max: [0.0; 3] },
        Aabb { min: [-2.9e38; 3], max: [2.9e38; 3] },
        Aabb { min: [1e-40; 3], max: [2e-40; 3] },
    ];
    for method in methods(device) {
        let mut broad = BroadPhase::new(device, method).unwrap();
        let found = broad.self_pairs(&odd).unwrap();
        let [p, q] = [Pair { a: 0, b: 1 }, Pair { a: 1, b: 2 }];
        assert!(found.contains(&p) && found.contains(&q), "{method}: {found:?}");
        assert!(broad.self_pairs(&[Aabb { min: [f32::NAN; 3], max: [1.0; 3] }]).is_err());
        assert!(broad.self_pairs(&[Aabb { min: [1.0; 3], max: [0.0; 3] }]).is_err());
    }
}

/// More boxes than the conformance table has of this kind, so that trees are higher.
fn check_uniform(device: &Device) {
    let boxes = uniform_boxes(100_000);
    for method in [BroadPhaseMethod::Blocks, BroadPhaseMethod::TREE] {
        let pairs = BroadPhase::new(device, method).unwrap().self_pairs(&boxes).unwrap();
        assert_eq!(pairs.len(), 320, "{method}");
        let mut cpu = ccd::BroadPhase::new(2, method).unwrap();
        check_pairs("uniform boxes", cpu.self_pairs(&boxes).unwrap().to_vec(), pairs);
    }
}
