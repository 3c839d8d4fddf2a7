//! The kernels that find pairs, by blocks and by the binary tree, each by itself against brute force; and the broad phase made of them.

use crate::scenes::check_pairs;
use crate::support::{bytes, check_boxes, entries, list, paths, read, room, twin};
use crate::twin::{Twin, union};
use ccd::gpu::{BroadPhase, Device, harness};
use ccd::{Aabb, BroadPhaseMethod, Pair, Verdict};
use ccd_core::broad_phase::block_bvh;
use ccd_core::kernel::Id;
use ccd_core::layout::{Branch, LIST_HEADER, Node, Params, Path};
use ccd_testkit::brute;
use ccd_testkit::generate::{Step, uniform_boxes};

pub const TESTS: crate::Tests = &[
    ("node_pairs", check_node_pairs),
    ("counts", check_counts),
    ("candidates", check_candidates),
    ("filters", check_filters),
    ("radix_tree", check_radix_tree),
    ("uniform_boxes_by_blocks", |device| check_uniform(device, BroadPhaseMethod::Blocks)),
    ("uniform_boxes_by_tree", |device| check_uniform(device, BroadPhaseMethod::Tree)),
];

fn check_node_pairs(device: &Device) {
    let (twin, _) = twin(70, 3);
    for kind in [0, 1] {
        let above = twin.node_pairs(2, kind);
        let want = twin.node_pairs(1, kind);
        let p = Params { kind, level: 2, room_in: above.len() as u32, room_out: 50_000, ..twin.params };
        // Few workgroups, so that each takes several rounds; many, so that some have nothing to do.
        for groups in [1, 3, 500] {
            let mut buffers = [bytes(&twin.nodes), list(&above), room(50_000)];
            harness::run(device, Id::NodePairs, &p, &mut buffers, groups, 65_535).unwrap();
            check_pairs("node pairs", want.clone(), entries(&buffers[2]));
        }
        // A list that is too short counts everything and writes nothing beyond its end.
        let short = Params { room_out: 10, ..p };
        let mut buffers = [bytes(&twin.nodes), list(&above), room(20)];
        harness::run(device, Id::NodePairs, &short, &mut buffers, 7, 65_535).unwrap();
        let words: Vec<u32> = read(&buffers[2]);
        assert_eq!(words[0] as usize, want.len());
        assert!(words[LIST_HEADER + 20..].iter().all(|&w| w == 0), "written beyond the room");
    }
}

/// A count that exceeds 32 bits says so: both words of headers, in every kernel that adds to them.
fn check_counts(device: &Device) {
    let boxes: Vec<Aabb> = uniform_boxes(2000).iter().map(|b| b.inflated(0.03)).collect();
    let twin = Twin::new([&[], &boxes, &[]], |_, i| [2 * i, 2 * i + 1, 2 * i + 1]);
    let (above, blocks) = (twin.node_pairs(2, 1), twin.node_pairs(1, 1));
    let n_hits = brute::self_pairs(&boxes).len() as u32;
    let near = |back: u32| bytes(&[0u32.wrapping_sub(back), 0u32.wrapping_sub(back), 0, 0]);
    let p = Params { kind: 1, step: 1, limit: u32::MAX, room_out: 0, ..twin.params };
    for (back, wraps) in [(1, 1), (n_hits, 1), (n_hits + 1, 0)] {
        let list_p = Params { level: 1, room_in: blocks.len() as u32, ..p };
        let mut buffers = [bytes(&twin.nodes), bytes(&twin.leaves), vec![0; 16], vec![0; 48], list(&blocks), near(back)];
        harness::run(device, Id::ListCandidates, &list_p, &mut buffers, 5, 65_535).unwrap();
        let head: Vec<u32> = read(&buffers[5][..16]);
        assert_eq!(head, [n_hits.wrapping_sub(back), n_hits.wrapping_sub(back), wraps, wraps], "candidates");
    }
    let p = Params { level: 2, room_in: above.len() as u32, ..p };
    let mut buffers = [bytes(&twin.nodes), list(&above), near(1)];
    harness::run(device, Id::NodePairs, &p, &mut buffers, 1, 65_535).unwrap();
    assert_eq!(read::<u32>(&buffers[2][..16]), [blocks.len() as u32 - 1, u32::MAX, 1, 0], "pairs of nodes");
}

/// Candidates by testing each feature against each.
fn candidates(twin: &Twin, step: &Step, kind: u32) -> Vec<Pair> {
    let single = |x: &[[f64; 3]]| x.iter().map(|p| p.map(|c| c as f32)).collect::<Vec<[f32; 3]>>();
    let [vf, ee] = brute::candidates(&step.mesh, &single(&step.x0), &single(&step.x1));
    assert_eq!(twin.params.count[1] as usize, step.mesh.edges().len());
    if kind == 0 { vf } else { ee }
}

fn check_candidates(device: &Device) {
    let (twin, step) = twin(50, 4);
    for kind in [0, 1] {
        let want = candidates(&twin, &step, kind);
        let blocks = twin.node_pairs(1, kind);
        let p = Params { kind, level: 1, room_in: blocks.len() as u32, room_out: 100_000, ..twin.params };
        let mut buffers = [bytes(&twin.nodes), bytes(&twin.leaves), vec![0; 16], vec![0; 48], list(&blocks), room(100_000)];
        harness::run(device, Id::ListCandidates, &p, &mut buffers, 9, 65_535).unwrap();
        check_pairs("candidates", want, entries(&buffers[5]));
    }
    // So many hits at once that the pool of a workgroup overflows: every box overlaps every other.
    let boxes = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 200];
    let twin = Twin::new([&[], &boxes, &[]], |_, i| [2 * i, 2 * i + 1, 2 * i + 1]);
    let blocks = twin.node_pairs(1, 1);
    let p = Params { kind: 1, level: 1, room_in: blocks.len() as u32, room_out: 20_000, ..twin.params };
    let mut buffers = [bytes(&twin.nodes), bytes(&twin.leaves), vec![0; 16], vec![0; 48], list(&blocks), room(20_000)];
    harness::run(device, Id::ListCandidates, &p, &mut buffers, 2, 65_535).unwrap();
    const { assert!(4 * 1024 > block_bvh::POOL) };
    check_pairs("boxes on one another", brute::self_pairs(&boxes), entries(&buffers[5]));
}

/// What the filters leave is a part of the candidates, and what they drop certainly does not touch.
fn check_filters(device: &Device) {
    let (twin, step) = twin(40, 5);
    let paths = paths(&step, false);
    for (kind, id) in [(0, Id::FilterVertexFace), (1, Id::FilterEdgeEdge)] {
        let all = candidates(&twin, &step, kind);
        let blocks = twin.node_pairs(1, kind);
        let p = Params { kind, level: 1, room_in: blocks.len() as u32, room_out: 100_000, ..twin.params };
        let mut buffers = [bytes(&twin.nodes), bytes(&twin.leaves), vec![0; 16], vec![0; 48], bytes(&paths), list(&blocks), room(100_000)];
        harness::run(device, id, &p, &mut buffers, 9, 65_535).unwrap();
        let words: Vec<u32> = read(&buffers[6]);
        assert_eq!(words[1] as usize, all.len(), "candidates that were counted");
        let mut left = entries(&buffers[6]);
        left.sort_unstable();
        assert!(left.windows(2).all(|w| w[0] != w[1]) && left.len() < all.len() / 2, "{} of {} are left", left.len(), all.len());
        let mut n_touching = 0;
        for pair in all {
            let touches = verdict(&step, kind, pair, &paths) != Verdict::Miss;
            n_touching += touches as usize;
            assert!(!touches || left.binary_search(&pair).is_ok(), "{pair:?} touches and was dropped");
        }
        assert!(n_touching > 100, "{n_touching} contacts show nothing");
    }
}

fn verdict(step: &Step, kind: u32, pair: Pair, paths: &[Path]) -> Verdict<f64> {
    use ccd::Kind;
    use ccd_core::narrow_phase::decide;
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
    decide::pair(kind, step.mesh.vertices_of(kind, pair), [&x0, &x1], 0.0)
}

/// Every leaf is below every node that says so, children split the range of their parent, boxes are those of the leaves, no leaf comes twice.
fn check_tree(nodes: &[Node], branches: &[Branch], twin: &Twin) {
    let n_internal = branches.len() as u32;
    let range = |node: u32| match branches.get(node as usize) {
        Some(branch) => (branch.first, branch.last),
        None => (node - n_internal, node - n_internal),
    };
    let mut seen = vec![false; branches.len() + 1];
    let mut stack = vec![0u32];
    while let Some(node) = stack.pop() {
        let (first, last) = range(node);
        let want = union((first..=last).map(|leaf| twin.node(0, 1, leaf)));
        check_boxes("node", &[want], &[nodes[node as usize].aabb()]);
        match branches.get(node as usize) {
            Some(branch) => {
                let (left, right) = (range(branch.left), range(branch.right));
                assert_eq!((left.0, left.1 + 1, right.1), (first, right.0, last), "children of node {node}");
                assert_eq!((nodes[node as usize].left, nodes[node as usize].right), (branch.left, branch.right));
                stack.extend([branch.left, branch.right]);
            }
            None => {
                assert!(nodes[node as usize].is_leaf() && nodes[node as usize].left == twin.order[first as usize]);
                assert!(!std::mem::replace(&mut seen[first as usize], true), "leaf {first} comes twice");
            }
        }
    }
    assert!(seen.iter().all(|&s| s), "a leaf is missing");
}

/// The kernels of the binary tree, one after the other, on boxes in general position and on boxes of which many have one code.
fn check_radix_tree(device: &Device) {
    let uniform: Vec<Aabb> = uniform_boxes(5000).iter().map(|b| b.inflated(0.01)).collect();
    let equal = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 70];
    let mut mixed = uniform[..400].to_vec();
    mixed.extend(uniform[..400].iter().map(|b| Aabb { min: b.min, max: b.min }));
    mixed.extend(vec![uniform[7]; 90]);
    for boxes in [&uniform[..], &uniform[..2], &equal, &mixed] {
        let twin = Twin::new([&[], boxes, &[]], |_, i| [i; 3]);
        let n = boxes.len() as u32;
        let groups = n.div_ceil(256);
        let mut buffers = [bytes(&twin.keys.iter().map(|_| 0).collect::<Vec<u32>>()), vec![0; (n as usize - 1) * 16]];
        let sorted: Vec<u32> = twin.order.iter().map(|&i| twin.keys[i as usize]).collect();
        buffers[0] = bytes(&sorted);
        harness::run(device, Id::Branches, &twin.params, &mut buffers, groups, 65_535).unwrap();
        let branches = buffers[1].clone();
        // The highest level that has more than one node, and one above it, must give the same boxes.
        for level in [1, 2] {
            let p = Params { level, ..twin.params };
            let mut buffers = [branches.clone(), bytes(&twin.nodes), bytes(&twin.leaves), vec![0; (2 * n as usize - 1) * 32]];
            harness::run(device, Id::BranchBoxes, &p, &mut buffers, groups, 65_535).unwrap();
            let nodes = buffers[3].clone();
            check_tree(&read(&nodes), &read(&branches), &twin);
            let (first, room_out) = (n / 3, 200_000);
            let all = brute::self_pairs(boxes);
            let mut found = Vec::new();
            // In two parts, as a dispatch of many queries is.
            for (first, n) in [(0, first), (first, n - first)] {
                let p = Params { first, n, room_out, ..twin.params };
                let mut buffers = [nodes.clone(), branches.clone(), room(room_out)];
                harness::run(device, Id::TraverseHalf, &p, &mut buffers, n.div_ceil(128), 65_535).unwrap();
                found.extend(entries(&buffers[2]));
            }
            check_pairs("overlaps by a tree", all.clone(), found);
            let p = Params { n, room_out: 0, ..twin.params };
            let mut buffers = [nodes.clone(), branches.clone(), bytes(&[u32::MAX, 0, 0, 0])];
            harness::run(device, Id::TraverseHalf, &p, &mut buffers, n.div_ceil(128), 65_535).unwrap();
            let wrapped = !all.is_empty() as u32;
            assert_eq!(read::<u32>(&buffers[2]), [(all.len() as u32).wrapping_sub(1), 0, wrapped, 0], "a count that runs over");
            let loose: Vec<Aabb> = uniform[1000..1300].iter().map(|b| b.inflated(0.02)).collect();
            let p = Params { n: 300, room_out, ..twin.params };
            let mut buffers = [bytes(&loose), nodes.clone(), branches.clone(), room(room_out)];
            harness::run(device, Id::TraverseAgainst, &p, &mut buffers, 3, 65_535).unwrap();
            check_pairs("loose boxes", brute::pairs(&loose, boxes), entries(&buffers[3]));
        }
    }
}

fn check_uniform(device: &Device, method: BroadPhaseMethod) {
    let boxes = uniform_boxes(100_000);
    let mut broad = BroadPhase::new(device, method).unwrap();
    let pairs = broad.self_pairs(&boxes).unwrap();
    assert_eq!(pairs.len(), 320);
    let mut cpu = ccd::BroadPhase::new(2, BroadPhaseMethod::Blocks).unwrap();
    check_pairs("uniform boxes", cpu.self_pairs(&boxes).unwrap().to_vec(), pairs);
    let (a, b) = (&boxes[..3000], &boxes[3000..9000]);
    let grown = |boxes: &[Aabb]| boxes.iter().map(|b| b.inflated(0.02)).collect::<Vec<_>>();
    check_pairs("two sets", brute::pairs(&grown(a), &grown(b)), broad.pairs(&grown(a), &grown(b)).unwrap());
    // Sets without a pair, with one box, with none; boxes that are points; boxes as large as they may be.
    assert!(broad.self_pairs(&[]).unwrap().is_empty() && broad.self_pairs(&boxes[..1]).unwrap().is_empty());
    assert!(broad.pairs(&[], b).unwrap().is_empty());
    let odd =
        [Aabb { min: [0.0; 3], max: [0.0; 3] }, Aabb { min: [-2.9e38; 3], max: [2.9e38; 3] }, Aabb { min: [1e-40; 3], max: [2e-40; 3] }];
    let found = broad.self_pairs(&odd).unwrap();
    assert!(found.len() >= 2 && found.contains(&Pair { a: 0, b: 1 }) && found.contains(&Pair { a: 1, b: 2 }), "{found:?}");
    assert!(broad.self_pairs(&[Aabb { min: [f32::NAN; 3], max: [1.0; 3] }]).is_err());
    assert!(broad.self_pairs(&[Aabb { min: [1.0; 3], max: [0.0; 3] }]).is_err());
}
