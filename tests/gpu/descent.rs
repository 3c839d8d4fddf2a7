//! The kernels of simultaneous traversal, each by itself: cuts, their pairs, levels of pairs of
//! nodes.

use crate::scenes::check_pairs;
use crate::support::{bytes, capacity, entries, read, run, zeros};
use crate::trees::radix_tree;
use crate::twin::Twin;
use ccd::gpu::Device;
use ccd::gpu::bind::{CutNodes, CutPairs, ExpandPairs};
use ccd::{Aabb, Pair};
use ccd_core::backend::broad_phase::block_bvh::sets;
use ccd_core::backend::broad_phase::pair_workers::words;
use ccd_core::backend::layout::{Branch, Dispatch, LIST_HEADER, Node, NodeDescent, Params};
use ccd_testkit::brute;
use ccd_testkit::generate::uniform_boxes;

pub const TESTS: crate::Tests = &[("cuts", check_cuts), ("levels_of_pairs", check_levels)];

/// Words that count the pairs of each level.
const LEVELS: usize = 256;
const CAPACITY: u32 = 20_000;
/// Words of the cut of one side.
const CUT: usize = LIST_HEADER + 1024;

/// Binary trees over both sets of a kind.
pub struct Trees {
    pub twin: Twin,
    pub kind: u32,
    pub nodes: [Vec<u8>; 2],
    branches: [Vec<u8>; 2],
}

impl Trees {
    pub fn new(device: &Device, kind: u32, boxes: [&[Aabb]; 3]) -> Self {
        let twin = Twin::new(boxes, |_, i| [i; 3]);
        let [a, b] = sets(kind).map(|set| radix_tree(device, &twin, set, 2));
        Self { twin, kind, nodes: [a.0, b.0], branches: [a.1, b.1] }
    }

    pub fn params(&self, kind: u32, args: NodeDescent, dispatch: Dispatch) -> Params<NodeDescent> {
        Params { frame: self.twin.frame, dispatch, args: NodeDescent { kind, ..args } }
    }

    /// Nodes of the cut through one tree.
    pub fn cut(&self, device: &Device, side: usize, nodes: u32) -> Vec<u32> {
        let args = NodeDescent { nodes, ..NodeDescent::default() };
        let dispatch = Dispatch { first: side as u32, ..Dispatch::default() };
        let p = self.params(sets(self.kind)[side] as u32, args, dispatch);
        let kernel = CutNodes { branches: self.branches[side].clone(), cuts: vec![0; 8 * CUT] };
        let words: Vec<u32> = read(&run(device, kernel, &p, 1).cuts);
        let (cut, other) = (&words[side * CUT..][..CUT], &words[(1 - side) * CUT..][..CUT]);
        assert!(other.iter().all(|&word| word == 0), "the cut of the other side");
        cut[LIST_HEADER..LIST_HEADER + cut[0] as usize].to_vec()
    }

    /// Both cuts as a kernel reads them.
    pub fn cuts(&self, device: &Device, nodes: u32) -> Vec<u8> {
        let mut words = Vec::new();
        for side in [0, 1] {
            let cut = self.cut(device, side, nodes);
            words.extend([vec![cut.len() as u32, 0, 0, 0], cut].concat());
            words.resize((side + 1) * CUT, 0);
        }
        bytes(&words)
    }

    /// The pairs of two cuts: how many were counted, and the list.
    fn of_cuts(&self, device: &Device, nodes: u32, capacity_nodes: u32) -> (u32, Vec<u8>) {
        let args = NodeDescent { nodes, capacity_nodes, ..NodeDescent::default() };
        let done = self.cut_pairs(device, args, vec![0; 16]);
        (read::<u32>(&done.control)[0], done.output)
    }

    /// The pairs of two cuts: those that meet, and those of a front.
    pub fn cut_pairs(
        &self,
        device: &Device,
        args: NodeDescent,
        front: Vec<u8>,
    ) -> CutPairs<Vec<u8>> {
        let [a_nodes, b_nodes] = self.nodes.clone();
        let kernel = CutPairs {
            a_nodes,
            b_nodes,
            cuts: self.cuts(device, args.nodes),
            control: zeros::<u32>(words(0)),
            output: capacity(2 * args.capacity_nodes.max(1)),
            front,
        };
        let p = self.params(self.kind, args, Dispatch::default());
        run(device, kernel, &p, (args.nodes * args.nodes).div_ceil(256))
    }
}

fn boxes(n: usize, by: f32) -> Vec<Aabb> {
    uniform_boxes(n).iter().map(|b| b.inflated(by)).collect()
}

/// Every leaf is below one node of a cut, and cuts are as large as is wanted; their pairs are those
/// that overlap.
fn check_cuts(device: &Device) {
    let few = boxes(900, 0.05);
    let mut equal = vec![few[0]; 40];
    equal.extend(&few[..5]);
    for all in [&few[..], &few[..1], &few[..2], &equal] {
        let trees = Trees::new(device, 0, [all, &[], &few[..300]]);
        let branches: Vec<Branch> = read(&trees.branches[0]);
        let (n, n_internal) = (all.len(), all.len() as u32 - 1);
        for nodes in [1u32, 2, 7, 256, 1024] {
            let cut = trees.cut(device, 0, nodes);
            let mut below = vec![0; n];
            for &node in &cut {
                let (first, last) = branches
                    .get(node as usize)
                    .map_or((node - n_internal, node - n_internal), |b| (b.first, b.last));
                (first..=last).for_each(|leaf| below[leaf as usize] += 1);
            }
            assert!(below.iter().all(|&times| times == 1), "{nodes} nodes over {n}: {cut:?}");
            assert_eq!(cut.len(), n.min(nodes as usize), "{nodes} nodes over {n}");
        }
        let (a, b) = (trees.cut(device, 0, 50), trees.cut(device, 1, 50));
        let [x, y]: [Vec<Node>; 2] = trees.nodes.each_ref().map(|nodes| read(nodes));
        let overlap = |p: &Pair| x[p.a as usize].aabb().overlaps(&y[p.b as usize].aabb());
        let all = a.iter().flat_map(|&a| b.iter().map(move |&b| Pair { a, b }));
        let want: Vec<Pair> = all.filter(overlap).collect();
        let (counted, list) = trees.of_cuts(device, 50, 5000);
        assert_eq!(counted as usize, want.len());
        check_pairs("pairs of cuts", want, entries(&list));
        let (counted, short) = trees.of_cuts(device, 50, 0);
        assert_eq!(
            read::<u32>(&short)[..6],
            [counted, 0, 0, 0, 0, 0],
            "written beyond the capacity"
        );
    }
}

/// Level by level down to all pairs of leaves that overlap, by either rule.
fn check_levels(device: &Device) {
    let some = boxes(700, 0.04);
    let crowd = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 40];
    for all in [&some[..], &some[..2], &some[..1], &crowd] {
        let (a, b) = (&some[..400], all);
        let want = [brute::pairs(a, b), brute::self_pairs(all)];
        for (kind, of) in [(0, [a, &[], b]), (1, [&[], all, &[]])] {
            let trees = Trees::new(device, kind, of);
            for (larger, nodes) in [(0, 1), (1, 20)] {
                let found = descend(device, &trees, larger, nodes);
                check_pairs("by levels", want[kind as usize].clone(), found);
            }
        }
    }
}

fn descend(device: &Device, trees: &Trees, larger: u32, nodes: u32) -> Vec<Pair> {
    let (counted, mut list) = trees.of_cuts(device, nodes, CAPACITY);
    let mut levels = vec![0u32; LEVELS];
    levels[0] = counted;
    let mut pairs = capacity(CAPACITY);
    for level in 0..LEVELS as u32 - 1 {
        if levels[level as usize] == 0 {
            break;
        }
        let [a_nodes, b_nodes] = trees.nodes.clone();
        let kernel = ExpandPairs {
            a_nodes,
            b_nodes,
            input: list.clone(),
            levels: bytes(&levels),
            output: capacity(CAPACITY),
            pairs: pairs.clone(),
        };
        let dispatch =
            Dispatch { n: 0, first: level, capacity_in: CAPACITY, capacity_out: CAPACITY };
        let args =
            NodeDescent { larger, nodes, capacity_nodes: CAPACITY, ..NodeDescent::default() };
        let p = trees.params(trees.kind, args, dispatch);
        let done = run(device, kernel.clone(), &p, 3);
        let want: Vec<u32> = read(&done.levels);
        // On some levels, lists that are too short: everything is counted, nothing is written
        // beyond their ends; a list that was longer before keeps saying so.
        if level % 5 == 2 {
            let (output, pairs_before) = (bytes(&[7u32, 0, 0, 0, 0, 0]), bytes(&[0u32; 6]));
            let short = ExpandPairs { output, pairs: pairs_before, ..kernel };
            let args = NodeDescent { capacity_nodes: 0, ..args };
            let p = trees.params(trees.kind, args, Dispatch { capacity_out: 0, ..dispatch });
            let short = run(device, short, &p, 2);
            assert_eq!(
                want,
                read::<u32>(&short.levels),
                "pairs of nodes counted beyond the capacity"
            );
            let most = want[level as usize + 1].max(7);
            assert_eq!(read::<u32>(&short.output), [most, 0, 0, 0, 0, 0]);
            let n_before = read::<u32>(&pairs)[0];
            let n_found = read::<u32>(&done.pairs)[0] - n_before;
            assert_eq!(read::<u32>(&short.pairs), [n_found, 0, 0, 0, 0, 0]);
        }
        (list, pairs, levels) = (done.output, done.pairs, want);
    }
    entries(&pairs)
}
