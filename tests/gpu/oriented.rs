//! Trees of oriented boxes on a device: every node's box is the CPU's, and holds all below it;
//! queries and pairs of nodes find what brute force finds.

use crate::descent::Trees;
use crate::emulated::is_thin;
use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, entries, read, rounds_like_a_cpu, run, zeros};
use crate::trees::{in_two_parts, radix_tree, wide_tree};
use crate::twin::Twin;
use ccd::gpu::Device;
use ccd::gpu::bind::{
    CutPairsOriented, ExpandPairsOriented, OrientFar, OrientNear, TraverseFullOriented,
    TraverseHalfOriented,
};
use ccd::{Aabb, Pair};
use ccd_core::backend::broad_phase::oriented_nodes::{FIRST_ROUND, WORDS, n_rounds};
use ccd_core::backend::broad_phase::pair_workers::words;
use ccd_core::backend::layout::{
    Blocks, Branch, Dispatch, LIST_HEADER, NodeDescent, Params, Queries,
};
use ccd_core::math::obb::Obb;
use ccd_testkit::brute;
use ccd_testkit::generate::{Random, uniform_boxes};

pub const TESTS: crate::Tests =
    &[("oriented_nodes", check_nodes), ("oriented_traversals", check_traversals)];

/// Pairs that lists have room for.
const CAPACITY: u32 = 100_000;

/// Boxes in a sheet across the diagonal of space, each of which overlaps those beside it: flat for
/// oriented boxes, thick for boxes along the axes.
pub fn slanted(n: usize, height: f32) -> Vec<Aabb> {
    let boxed = |i: usize| {
        let (x, y) = ((i % 37) as f32 / 37.0, (i / 37) as f32 / 37.0);
        let min = [x, y, height - x - y];
        Aabb { min, max: min.map(|x| x + 0.03) }
    };
    (0..n).map(boxed).collect()
}

/// A scene with numbers that a device may take as zero, so that more boxes overlap there.
const SUBNORMAL: &str = "subnormal";

/// Boxes of all kinds, and scenes of a few.
fn scenes() -> Vec<(&'static str, Vec<Aabb>)> {
    let mut random = Random::new(5);
    let uniform: Vec<Aabb> = uniform_boxes(900).iter().map(|b| b.inflated(0.01)).collect();
    let points: Vec<Aabb> =
        uniform[..300].iter().map(|b| Aabb { min: b.min, max: b.min }).collect();
    let flatten = |b: &Aabb, axes: usize| {
        let cut = |x: [f32; 3]| std::array::from_fn(|k| if k < axes { x[k] } else { 0.25 });
        Aabb { min: cut(b.min), max: cut(b.max) }
    };
    let scaled = |by: f32| -> Vec<Aabb> {
        let times = |x: [f32; 3]| x.map(|x| (x * by).clamp(-2.9e38, 2.9e38));
        uniform[..300].iter().map(|b| Aabb { min: times(b.min), max: times(b.max) }).collect()
    };
    let nested = |i: usize| {
        let half = 2f32.powi(i as i32 - 80);
        Aabb { min: [-half; 3], max: [half, 0.5 * half, 0.25 * half] }
    };
    let any = |random: &mut Random, sizes: [f32; 4]| {
        let size = sizes[random.below(4) as usize];
        let point = [(); 3].map(|()| (2.0 * random.unit() - 1.0) as f32 * size);
        Aabb { min: point, max: point.map(|x| x + size * 0.25) }
    };
    vec![
        ("uniform", uniform.clone()),
        ("slanted", slanted(800, 0.0)),
        ("one", uniform[..1].to_vec()),
        ("two", uniform[..2].to_vec()),
        ("three", uniform[..3].to_vec()),
        ("points", points),
        ("a plane", uniform[..300].iter().map(|b| flatten(b, 2)).collect()),
        ("a line", uniform[..300].iter().map(|b| flatten(b, 1)).collect()),
        ("equal", vec![uniform[0]; 300]),
        ("nested", (0..160).map(nested).collect()),
        ("huge", scaled(1e38)),
        ("tiny", scaled(1e-34)),
        ("any size", (0..400).map(|_| any(&mut random, [1e-33, 1.0, 1e20, 2e38])).collect()),
        (SUBNORMAL, (0..400).map(|_| any(&mut random, [1e-45, 1e-38, 1e-20, 1.0])).collect()),
    ]
}

/// A tree over set 1 and its oriented boxes.
pub struct Oriented {
    pub twin: Twin,
    branches: Vec<u8>,
    pub boxes: Vec<u8>,
}

fn orient(device: &Device, twin: Twin, set: usize, boxes: Vec<u8>) -> Oriented {
    let (_, branches) = radix_tree(device, &twin, set, 2);
    let n = twin.frame.count[set];
    let args = Blocks { kind: set as u32, level: 2, ..twin.tree };
    let p = Params { frame: twin.frame, dispatch: Dispatch::default(), args };
    let kernel = OrientNear {
        branches: branches.clone(),
        block_nodes: bytes(&twin.nodes),
        oriented: boxes,
        // What is there before has no say.
        stamps: bytes(&vec![1u32; twin.boxes.len()]),
        far: zeros::<u32>(LIST_HEADER + n as usize),
    };
    let OrientNear { oriented, stamps, far, .. } = run(device, kernel, &p, n.div_ceil(256));
    let is_far = |b: &Branch| b.first / 256 != b.last / 256;
    let want = read::<Branch>(&branches).iter().filter(|b| n > 1 && is_far(b)).count();
    assert_eq!(read::<u32>(&far)[0] as usize, want, "nodes across tiles of {n}");
    let block_nodes = bytes(&twin.nodes);
    let mut kernel = OrientFar { branches, block_nodes, far, oriented, stamps };
    let from = twin.frame.start[set] as usize;
    let of_nodes = from..from + n as usize - 1;
    // As high as a tree from 30 bits of code can be.
    let mut left = n_rounds(n, 30 + 32 - n.leading_zeros());
    for first in FIRST_ROUND.. {
        let stamps: Vec<u32> = read(&kernel.stamps);
        let done = stamps[of_nodes.clone()].iter().all(|&stamp| 0 < stamp && stamp < first);
        if done && left == 0 {
            break;
        }
        // Once all are done one more round changes nothing; the others are left out.
        left = if done { 0 } else { left.checked_sub(1).expect("nodes without a box") };
        // One workgroup, so that it takes several parts.
        let dispatch = Dispatch { first, ..p.dispatch };
        let before = kernel.oriented.clone();
        kernel = run(device, kernel, &Params { dispatch, ..p }, 1);
        assert!(!done || kernel.oriented == before, "a round after the last");
    }
    let OrientFar { branches, oriented, .. } = kernel;
    Oriented { twin, branches, boxes: oriented }
}

/// Zeroed oriented boxes of all sets.
fn capacity_for(twin: &Twin) -> Vec<u8> {
    zeros::<[f32; WORDS]>(twin.boxes.len().max(1))
}

impl Oriented {
    pub fn over(device: &Device, boxes: &[Aabb]) -> Self {
        let twin = Twin::new([&[], boxes, &[]], |_, i| [i; 3]);
        let capacity = capacity_for(&twin);
        orient(device, twin, 1, capacity)
    }

    /// The boxes of internal nodes.
    fn nodes(&self) -> Vec<Obb> {
        let words: Vec<[f32; WORDS]> = read(&self.boxes);
        let three = |w: &[f32; WORDS], i: usize| [w[i], w[i + 1], w[i + 2]];
        let n = self.twin.frame.count[1] as usize - 1;
        let of = |w: &[f32; WORDS]| Obb {
            centre: three(w, 0),
            axes: [three(w, 3), three(w, 6), three(w, 9)],
            half: three(w, 12),
        };
        words.iter().take(n).map(of).collect()
    }

    /// The same on the CPU, from the leaves up.
    fn on_cpu(&self) -> Vec<Obb> {
        let branches: Vec<Branch> = read(&self.branches);
        let n = self.twin.frame.count[1] as usize - 1;
        let mut out: Vec<Option<Obb>> = vec![None; n];
        let mut stack: Vec<u32> = if n > 0 { vec![0] } else { Vec::new() };
        while let Some(&node) = stack.last() {
            let b = branches[node as usize];
            let child = |c: u32| match (c as usize).checked_sub(n) {
                Some(leaf) => Some(Obb::of_box(self.twin.node(0, 1, leaf as u32))),
                None => out[c as usize],
            };
            match (child(b.left), child(b.right)) {
                (Some(left), Some(right)) => {
                    out[node as usize] = Some(Obb::around_two(&left, &right));
                    stack.pop();
                }
                (left, right) => {
                    stack.extend(left.is_none().then_some(b.left));
                    stack.extend(right.is_none().then_some(b.right));
                }
            }
        }
        out.into_iter().flatten().collect()
    }
}

/// A corner is in a box, by sums and products in `f64`, whose error is below the last term.
fn holds(b: &Obb, p: [f32; 3]) -> bool {
    (0..3).all(|i| {
        let parts = [0, 1, 2].map(|k| b.axes[i][k] as f64 * (p[k] as f64 - b.centre[k] as f64));
        let size: f64 = parts.iter().map(|x| x.abs()).sum();
        parts.iter().sum::<f64>().abs() <= b.half[i] as f64 + 1e-15 * size
    })
}

/// The greatest difference of a scalar product of axes from that of orthonormal ones.
fn skew(b: &Obb) -> f64 {
    let dot = |i: usize, j: usize| -> f64 {
        (0..3).map(|k| b.axes[i][k] as f64 * b.axes[j][k] as f64).sum()
    };
    (0..9).map(|k| (dot(k / 3, k % 3) - (k / 3 == k % 3) as u8 as f64).abs()).fold(0.0, f64::max)
}

/// Every corner of every leaf is in the box of every node above it, axes are orthonormal as the
/// bounds have it.
fn check_holds(name: &str, nodes: &[Obb], branches: &[Branch], twin: &Twin) -> Result<(), String> {
    for (b, branch) in nodes.iter().zip(branches) {
        let off = skew(b) * 2f64.powi(24);
        if off > ccd_core::math::symmetric_eigen::ORTHONORMAL as f64 {
            return Err(format!("{name}: axes are off by {off} u: {b:?}"));
        }
        for leaf in branch.first..=branch.last {
            let Aabb { min, max } = *twin.node(0, 1, leaf);
            for c in 0..8 {
                let corner = std::array::from_fn(|k| [min[k], max[k]][c >> k & 1]);
                if !holds(b, corner) {
                    return Err(format!("{name}: {corner:?} is not in {b:?}"));
                }
            }
        }
    }
    Ok(())
}

fn same_bits(a: &Obb, b: &Obb) -> bool {
    let words = |b: &Obb| {
        let [p, q, r] = b.axes;
        [b.centre, p, q, r, b.half].concat().iter().map(|x| x.to_bits()).collect::<Vec<_>>()
    };
    words(a) == words(b)
}

fn check_nodes(device: &Device) {
    let mut n_controls = 0;
    for (name, boxes) in scenes() {
        let tree = Oriented::over(device, &boxes);
        let (got, want) = (tree.nodes(), tree.on_cpu());
        assert_eq!(got.len(), boxes.len() - 1, "{name}");
        let branches: Vec<Branch> = read(&tree.branches);
        check_holds(name, &got, &branches, &tree.twin).unwrap();
        check_holds(name, &want, &branches, &tree.twin).unwrap();
        if rounds_like_a_cpu(device) {
            for (i, (g, w)) in got.iter().zip(&want).enumerate() {
                assert!(same_bits(g, w), "{name}, node {i}: {w:?} on the CPU, {g:?} on the device");
            }
        }
        // A box that is a little too small is noticed.
        if let Some(low) = branches.iter().take(got.len()).position(|b| b.last == b.first + 1)
            && got[low].half.iter().all(|h| (1e-30..1e30).contains(h))
        {
            let mut less = got.clone();
            less[low].half = got[low].half.map(|h| h * 0.99);
            assert!(check_holds(name, &less, &branches, &tree.twin).is_err(), "{name}");
            n_controls += 1;
        }
    }
    assert!(n_controls > 3, "{n_controls} controls");
}

/// Queries of the first set of a kind, in either order.
fn traverse_full(
    device: &Device,
    tree: &Oriented,
    kind: u32,
    nodes: &[u8],
    sorted: u32,
    n: u32,
) -> Vec<Pair> {
    in_two_parts(n, CAPACITY, |dispatch, pairs| {
        let p = Params { frame: tree.twin.frame, dispatch, args: Queries { kind, sorted } };
        let (boxes, order) = (bytes(&tree.twin.boxes), bytes(&tree.twin.order));
        let (nodes, oriented) = (nodes.to_vec(), tree.boxes.clone());
        let kernel = TraverseFullOriented { boxes, order, nodes, oriented, pairs };
        run(device, kernel, &p, dispatch.n.div_ceil(128)).pairs
    })
}

fn traverse_half(device: &Device, tree: &Oriented, nodes: &[u8], n: u32) -> Vec<Pair> {
    in_two_parts(n, CAPACITY, |dispatch, pairs| {
        let p = Params { frame: tree.twin.frame, dispatch, args: tree.twin.tree };
        let (leaves, order) = (bytes(&tree.twin.nodes), bytes(&tree.twin.order));
        let (nodes, oriented) = (nodes.to_vec(), tree.boxes.clone());
        let kernel = TraverseHalfOriented { leaves, order, nodes, oriented, pairs };
        run(device, kernel, &p, dispatch.n.div_ceil(128)).pairs
    })
}

/// All pairs below those of two cuts, level by level; how many pairs of nodes there were.
fn descend(device: &Device, trees: &Trees, oriented: &[u8], larger: u32) -> (Vec<Pair>, usize) {
    let [a_nodes, b_nodes] = trees.nodes.clone();
    let (nodes, capacity_in) = (7, CAPACITY);
    let args = NodeDescent { nodes, larger, capacity_nodes: CAPACITY, ..NodeDescent::default() };
    let dispatch = Dispatch { capacity_in, capacity_out: CAPACITY, ..Dispatch::default() };
    let kernel = CutPairsOriented {
        a_nodes: a_nodes.clone(),
        b_nodes: b_nodes.clone(),
        cuts: trees.cuts(device, nodes),
        oriented: oriented.to_vec(),
        control: zeros::<u32>(words(0)),
        output: capacity(CAPACITY),
        front: vec![0; 16],
    };
    let p = trees.params(trees.kind, args, dispatch);
    let done = run(device, kernel, &p, (nodes * nodes).div_ceil(256));
    let mut kernel = ExpandPairsOriented {
        a_nodes,
        b_nodes,
        oriented: oriented.to_vec(),
        input: done.output,
        levels: done.control,
        output: capacity(CAPACITY),
        pairs: capacity(CAPACITY),
    };
    let mut n_pairs = 0;
    for level in 0..255 {
        let n = read::<u32>(&kernel.levels)[level];
        n_pairs += n as usize;
        if n == 0 {
            return (entries(&kernel.pairs), n_pairs);
        }
        let dispatch = Dispatch { first: level as u32, ..dispatch };
        kernel = run(device, kernel, &trees.params(trees.kind, args, dispatch), n.div_ceil(128));
        std::mem::swap(&mut kernel.input, &mut kernel.output);
    }
    panic!("pairs of nodes on every level");
}

fn check_traversals(device: &Device) {
    let loose: Vec<Aabb> = slanted(300, 0.3);
    let exact = rounds_like_a_cpu(device);
    for (name, boxes) in scenes().into_iter().filter(|(name, _)| exact || *name != SUBNORMAL) {
        let (n, all) = (boxes.len() as u32, brute::self_pairs(&boxes));
        let within = Oriented::over(device, &boxes);
        let nodes = wide_tree(device, &within.twin, 1, 2);
        check_pairs(name, all.clone(), traverse_half(device, &within, &nodes, n));
        for sorted in [0, 1] {
            let found = traverse_full(device, &within, 1, &nodes, sorted, n);
            check_pairs(name, all.clone(), found);
        }
        // As the second set of two, whose nodes stand behind the first set's.
        let twin = Twin::new([&loose, &[], &boxes], |_, i| [i; 3]);
        let capacity = capacity_for(&twin);
        let first = orient(device, twin, 0, capacity);
        let second = orient(device, first.twin, 2, first.boxes);
        let nodes = wide_tree(device, &second.twin, 2, 2);
        let between = brute::pairs(&loose, &boxes);
        for sorted in [0, 1] {
            let found = traverse_full(device, &second, 0, &nodes, sorted, loose.len() as u32);
            check_pairs(name, between.clone(), found);
        }
        let one = Trees::new(device, 1, [&[], &boxes, &[]]);
        let two = Trees::new(device, 0, [&loose, &[], &boxes]);
        // By both rules; on an emulated GPU each tree by one.
        for larger in if is_thin(device) { &[0][..] } else { &[0, 1] } {
            let (found, _) = descend(device, &one, &within.boxes, *larger);
            check_pairs(name, all.clone(), found);
            let (found, _) = descend(device, &two, &second.boxes, 1 - larger);
            check_pairs(name, between.clone(), found);
        }
        if name == "slanted" {
            check_that_boxes_count(device, &two, &second, &within);
        }
    }
}

/// Between two sheets that boxes along the axes do not tell apart, boxes of everything find the
/// same by more pairs of nodes. With boxes that are nowhere a query finds nothing, but for leaves
/// that are children of nodes above its own leaf, of which half a traversal asks nothing.
fn check_that_boxes_count(device: &Device, two: &Trees, of_two: &Oriented, within: &Oriented) {
    let all = |b: &Obb, n: usize| {
        let [p, q, r] = b.axes;
        let words: Vec<f32> = [b.centre, p, q, r, b.half].concat();
        bytes(&[words, vec![0.0]].concat().repeat(n))
    };
    let (want, by_oriented) = descend(device, two, &of_two.boxes, 1);
    let everything = all(&Obb::everything(), of_two.twin.boxes.len());
    let (found, by_axes) = descend(device, two, &everything, 1);
    check_pairs("boxes of everything", want, found);
    assert!(3 * by_oriented < by_axes, "{by_oriented} pairs of nodes, {by_axes} without boxes");
    let away = Obb { centre: [9e9; 3], half: [1.0; 3], ..Obb::everything() };
    let nodes = wide_tree(device, &within.twin, 1, 2);
    let n = within.twin.boxes.len();
    let twin = Twin::new([&[], &within.twin.boxes, &[]], |_, i| [i; 3]);
    let nowhere = Oriented { twin, branches: Vec::new(), boxes: all(&away, n) };
    let (boxes, order, mut beside) = (&within.twin.boxes, &within.twin.order, Vec::new());
    let branches = read::<Branch>(&within.branches).into_iter();
    for b in branches.filter(|b| b.right as usize >= n - 1) {
        let pairs = (b.first..b.last).map(|i| [i, b.last].map(|leaf| order[leaf as usize]));
        let met = pairs.filter(|p| boxes[p[0] as usize].overlaps(&boxes[p[1] as usize]));
        beside.extend(met.map(|[i, j]| Pair::ordered(i, j)));
    }
    assert!(3 * beside.len() < brute::self_pairs(boxes).len(), "{} pairs", beside.len());
    check_pairs("nowhere", beside, traverse_half(device, &nowhere, &nodes, n as u32));
    assert_eq!(traverse_full(device, &nowhere, 1, &nodes, 0, n as u32), []);
}
