//! Binary trees on a device: nodes, queries.

use crate::builders::check_well_formed;
use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, check_boxes, entries, read, run, zeros};
use crate::twin::{Twin, union};
use ccd::gpu::Device;
use ccd::gpu::bind::{BranchBoxes, Branches, FarNodes, NearNodes, TraverseFull, TraverseHalf};
use ccd::{Aabb, Pair};
use ccd_core::backend::layout::{
    Blocks, Branch, Dispatch, LIST_HEADER, Node, Params, Queries, WideNode,
};
use ccd_testkit::brute;
use ccd_testkit::generate::uniform_boxes;

pub const TESTS: crate::Tests = &[("radix_tree", check_radix_tree)];

/// Capacity of lists of pairs.
const CAPACITY: u32 = 200_000;

/// A tree that is well formed, whose boxes are those of the leaves below.
fn check_tree(nodes: &[Node], branches: &[Branch], twin: &Twin, set: usize) {
    let (n_internal, start) = (branches.len(), twin.frame.start[set]);
    let order = &twin.order[start as usize..twin.frame.start[set + 1] as usize];
    check_well_formed("tree", twin, set, &(order.to_vec(), branches.to_vec()));
    for (i, node) in nodes.iter().enumerate() {
        let range = if let Some(branch) = branches.get(i) {
            assert_eq!((node.left, node.right), (branch.left, branch.right), "node {i}");
            branch.first..=branch.last
        } else {
            let leaf = i - n_internal;
            assert!(node.is_leaf() && node.left == order[leaf] - start, "leaf {leaf}");
            leaf as u32..=leaf as u32
        };
        let want = union(range.map(|leaf| twin.node(0, set, leaf)));
        check_boxes("node", &[want], &[node.aabb()]);
    }
}

/// Children split the range of their parent where its keys first differ, boxes are those of the
/// leaves, no leaf comes twice. Equal keys differ by their place.
fn check_wide_tree(nodes: &[WideNode], keys: &[u32], twin: &Twin, set: usize) {
    let n = keys.len();
    assert_eq!(nodes.len(), n - 1);
    let key = |i: u32| (keys[i as usize] as u64) << 32 | i as u64;
    let common = |i: u32, j: u32| (key(i) ^ key(j)).leading_zeros();
    let mut seen = vec![false; n];
    let mut stack = vec![(0, 0, n as u32 - 1)];
    while let Some((node, first, last)) = stack.pop() {
        let record = &nodes[node as usize];
        let split = record.split;
        let shared = common(first, last);
        let apart = common(first, split) > shared && common(split + 1, last) > shared;
        assert!(apart && (first..last).contains(&split), "split {split} of {first} to {last}");
        let smaller = split - first < last - split;
        assert_eq!(record.has(WideNode::LEFT_IS_SMALLER), smaller, "node {node}");
        for (flag, first, last, boxed, child) in [
            (WideNode::LEFT_IS_LEAF, first, split, record.left_box(), split),
            (WideNode::RIGHT_IS_LEAF, split + 1, last, record.right_box(), split + 1),
        ] {
            let want = union((first..=last).map(|leaf| twin.node(0, set, leaf)));
            check_boxes("node", &[want], &[boxed]);
            assert_eq!(record.has(flag), first == last, "leaves {first} to {last}");
            if first == last {
                assert!(!std::mem::replace(&mut seen[first as usize], true), "{first} comes twice");
            } else {
                stack.push((child, first, last));
            }
        }
    }
    assert!(seen.iter().all(|&s| s), "a leaf is missing");
}

/// The kernels of the binary tree, one after the other, on boxes in general position and on boxes
/// of which many have one code.
fn check_radix_tree(device: &Device) {
    let uniform: Vec<Aabb> = uniform_boxes(5000).iter().map(|b| b.inflated(0.01)).collect();
    let equal = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 70];
    let mut mixed = uniform[..400].to_vec();
    mixed.extend(uniform[..400].iter().map(|b| Aabb { min: b.min, max: b.min }));
    mixed.extend(vec![uniform[7]; 90]);
    let loose: Vec<Aabb> = uniform[1000..1300].iter().map(|b| b.inflated(0.02)).collect();
    for boxes in [&uniform[..], &uniform[..2], &equal, &mixed] {
        let twin = Twin::new([&[], boxes, &[]], |_, i| [i; 3]);
        // The highest level that has more than one node, and one above it, must give the same
        // boxes.
        for level in [1, 2] {
            let (nodes, branches) = radix_tree(device, &twin, 1, level);
            check_tree(&read(&nodes), &read(&branches), &twin, 1);
            let nodes = wide_tree(device, &twin, 1, level);
            check_wide_tree(&read(&nodes), &sorted_keys(&twin, 1), &twin, 1);
            check_traversal(device, &twin, boxes, &nodes);
        }
        // As the second set of two, of which the first stays loose.
        let twin = Twin::new([&loose, &[], boxes], |_, i| [i; 3]);
        let (nodes, branches) = radix_tree(device, &twin, 2, 2);
        check_tree(&read(&nodes), &read(&branches), &twin, 2);
        let nodes = wide_tree(device, &twin, 2, 2);
        check_wide_tree(&read(&nodes), &sorted_keys(&twin, 2), &twin, 2);
        let found = traverse_full(device, &twin, 0, &nodes, loose.len() as u32);
        check_pairs("loose boxes", brute::pairs(&loose, boxes), found);
    }
    // A tree of one leaf.
    let twin = Twin::new([&loose, &[], &uniform[1000..1001]], |_, i| [i; 3]);
    let nodes = wide_tree(device, &twin, 2, 1);
    let found = traverse_full(device, &twin, 0, &nodes, loose.len() as u32);
    assert!(!found.is_empty());
    check_pairs("one leaf", brute::pairs(&loose, &uniform[1000..1001]), found);
}

/// Nodes and branches of the binary tree over a set.
pub fn radix_tree(device: &Device, twin: &Twin, set: usize, level: u32) -> (Vec<u8>, Vec<u8>) {
    let n = twin.frame.count[set];
    let groups = n.div_ceil(256);
    let sorted: Vec<u32> = twin.order.iter().map(|&i| twin.keys[i as usize]).collect();
    let args = Blocks { kind: set as u32, level, ..twin.tree };
    let p = Params { frame: twin.frame, dispatch: Dispatch::default(), args };
    let kernel = Branches { keys: bytes(&sorted), branches: zeros::<Branch>(n as usize - 1) };
    let Branches { branches, .. } = run(device, kernel, &p, groups);
    let kernel = BranchBoxes {
        branches: branches.clone(),
        block_nodes: bytes(&twin.nodes),
        order: bytes(&twin.order),
        nodes: zeros::<Node>(2 * n as usize - 1),
    };
    (run(device, kernel, &p, groups).nodes, branches)
}

/// The sorted keys of a set.
fn sorted_keys(twin: &Twin, set: usize) -> Vec<u32> {
    let of_set = twin.frame.start[set] as usize..twin.frame.start[set + 1] as usize;
    twin.order[of_set].iter().map(|&i| twin.keys[i as usize]).collect()
}

/// Nodes of the binary tree over a set, each with the boxes of both children.
pub fn wide_tree(device: &Device, twin: &Twin, set: usize, level: u32) -> Vec<u8> {
    let n = twin.frame.count[set];
    let (_, branches) = radix_tree(device, twin, set, level);
    let args = Blocks { kind: set as u32, level, ..twin.tree };
    let p = Params { frame: twin.frame, dispatch: Dispatch::default(), args };
    let kernel = NearNodes {
        branches: branches.clone(),
        block_nodes: bytes(&twin.nodes),
        // A binding has at least one record.
        nodes: zeros::<WideNode>((n as usize - 1).max(1)),
        far: zeros::<u32>(LIST_HEADER + n as usize),
    };
    let NearNodes { nodes, far, .. } = run(device, kernel, &p, n.div_ceil(256));
    let is_far = |b: &Branch| b.first / 256 != b.last / 256;
    let want = read::<Branch>(&branches).iter().filter(|b| is_far(b)).count();
    assert_eq!(read::<u32>(&far)[0] as usize, want, "far nodes of {n}");
    // One workgroup, so that it takes several rounds.
    let kernel = FarNodes { branches, block_nodes: bytes(&twin.nodes), far, nodes };
    run(device, kernel, &p, 1).nodes
}

/// What `traverse` lists for the queries of a dispatch, in two parts as a dispatch of many is.
pub fn in_two_parts(
    n: u32,
    capacity_out: u32,
    traverse: impl Fn(Dispatch, Vec<u8>) -> Vec<u8>,
) -> Vec<Pair> {
    let of_part = |(first, n)| {
        let dispatch = Dispatch { n, first, capacity_in: 0, capacity_out };
        entries(&traverse(dispatch, capacity(capacity_out)))
    };
    [(0, n / 3), (n / 3, n - n / 3)].into_iter().flat_map(of_part).collect()
}

/// What queries of the first set of a kind find, in the order of input and in that of leaves, which
/// is the same.
fn traverse_full(device: &Device, twin: &Twin, kind: u32, nodes: &[u8], n: u32) -> Vec<Pair> {
    let [mut by_input, mut by_leaves] = [0, 1].map(|sorted| {
        in_two_parts(n, CAPACITY, |dispatch, pairs| {
            let p = Params { frame: twin.frame, dispatch, args: Queries { kind, sorted } };
            let (boxes, order) = (bytes(&twin.boxes), bytes(&twin.order));
            let kernel = TraverseFull { boxes, order, nodes: nodes.to_vec(), pairs };
            run(device, kernel, &p, dispatch.n.div_ceil(128)).pairs
        })
    });
    by_input.sort_unstable();
    by_leaves.sort_unstable();
    assert!(by_input == by_leaves, "another order of queries, other pairs");
    by_leaves
}

/// Overlaps of the boxes of a tree; and a count that runs over.
fn check_traversal(device: &Device, twin: &Twin, boxes: &[Aabb], nodes: &[u8]) {
    let n = boxes.len() as u32;
    let all = brute::self_pairs(boxes);
    let traverse = |dispatch: Dispatch, pairs: Vec<u8>| {
        let (leaves, order) = (bytes(&twin.nodes), bytes(&twin.order));
        let kernel = TraverseHalf { leaves, order, nodes: nodes.to_vec(), pairs };
        let p = Params { frame: twin.frame, dispatch, args: twin.tree };
        run(device, kernel, &p, dispatch.n.div_ceil(128)).pairs
    };
    check_pairs("overlaps by a tree", all.clone(), in_two_parts(n, CAPACITY, traverse));
    let found = traverse_full(device, twin, 1, nodes, n);
    check_pairs("overlaps by queries of all", all.clone(), found);
    let pairs = traverse(Dispatch { n, ..Dispatch::default() }, bytes(&[u32::MAX, 0, 0, 0]));
    let wrapped = !all.is_empty() as u32;
    let want = [(all.len() as u32).wrapping_sub(1), 0, wrapped, 0];
    assert_eq!(read::<u32>(&pairs), want, "a count that runs over");
}
