//! Workers over two binary trees, or one with itself.

use crate::descent::Trees;
use crate::search::{Buffers, CAPACITY, Descends};
use crate::support::{bytes, capacity, read, run, zeros};
use ccd::gpu::Device;
use ccd::gpu::bind::{
    PairWorkers, PairWorkersOriented, ResumeFront, ResumeFrontOriented, StealPairs,
    StealPairsOriented,
};
use ccd::{Aabb, Pair};
use ccd_core::backend::broad_phase::balanced::words_of;
use ccd_core::backend::broad_phase::block_bvh::sets;
use ccd_core::backend::broad_phase::oriented_nodes::WORDS;
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair, expand};
use ccd_core::backend::broad_phase::pair_workers::THREADS;
use ccd_core::backend::layout::{Dispatch, Node, NodeDescent};
use ccd_core::math::obb::Obb;
use ccd_core::model::method::Descent;
use ccd_testkit::brute;
use ccd_testkit::generate::Random;
use std::rc::Rc;

/// Trees, of which one kind of pairs is sought.
pub struct SearchTrees {
    trees: Rc<Trees>,
    /// Nodes, of trees that have moved.
    nodes: [Vec<u8>; 2],
    /// Oriented boxes of nodes, if trees have some.
    oriented: Option<Vec<u8>>,
}

impl SearchTrees {
    pub fn new(device: &Device, kind: u32, sets: [&[Aabb]; 3], oriented: bool) -> Self {
        let trees = Trees::new(device, kind, sets);
        // Boxes that tell nothing apart: they hold whatever moves.
        let oriented = oriented.then(|| bytes(&everything().repeat(trees.twin.boxes.len())));
        Self { nodes: trees.nodes.clone(), trees: Rc::new(trees), oriented }
    }

    fn both(&self) -> [Vec<Node>; 2] {
        self.nodes.each_ref().map(|nodes| read(nodes))
    }
}

fn everything() -> Vec<f32> {
    let b = Obb::everything();
    let [p, q, r] = b.axes;
    let words = [b.centre, p, q, r, b.half].concat();
    [words, vec![0.0; WORDS - 15]].concat()
}

/// Runs a kernel, and returns what it has written.
macro_rules! written {
    ($device:expr, $p:expr, $groups:expr, $($kernel:tt)*) => {{
        let done = run($device, $($kernel)*, $p, $groups);
        let (control, nodes, pairs, front) = (done.control, done.nodes, done.pairs, done.front);
        Buffers { control, nodes, pairs, front }
    }};
}
pub(crate) use written;

impl Descends for SearchTrees {
    fn width(&self) -> u32 {
        THREADS
    }

    /// The pairs of two cuts.
    fn first(&self, device: &Device, args: NodeDescent) -> Buffers {
        let front = vec![0xee; 16 * args.capacity_front.max(1) as usize];
        let done = self.trees.cut_pairs(device, args, front);
        let mut control = done.control;
        control.resize(4 * words_of(&args), 0);
        Buffers { control, nodes: done.output, pairs: capacity(CAPACITY), front: done.front }
    }

    fn resume(
        &self,
        device: &Device,
        args: NodeDescent,
        dispatch: Dispatch,
        front: Vec<u8>,
    ) -> Buffers {
        let control = zeros::<u32>(words_of(&args));
        let (nodes, pairs) = (capacity(2 * CAPACITY), capacity(CAPACITY));
        let (p, [a_nodes, b_nodes]) =
            (self.trees.params(self.trees.kind, args, dispatch), self.nodes.clone());
        let n = dispatch.n.div_ceil(THREADS);
        match self.oriented.clone() {
            None => {
                let kernel = ResumeFront { a_nodes, b_nodes, control, nodes, pairs, front };
                written!(device, &p, n, kernel)
            }
            Some(oriented) => written!(
                device,
                &p,
                n,
                ResumeFrontOriented { a_nodes, b_nodes, oriented, control, nodes, pairs, front }
            ),
        }
    }

    fn round(
        &self,
        device: &Device,
        args: NodeDescent,
        dispatch: Dispatch,
        buffers: Buffers,
    ) -> Buffers {
        let Buffers { control, nodes, pairs, front } = buffers;
        let (p, [a_nodes, b_nodes]) =
            (self.trees.params(self.trees.kind, args, dispatch), self.nodes.clone());
        let n = 1 << args.workers;
        match (self.oriented.clone(), args.batches > 0) {
            (None, false) => {
                let kernel = PairWorkers { a_nodes, b_nodes, control, nodes, pairs, front };
                written!(device, &p, n, kernel)
            }
            (None, true) => {
                let kernel = StealPairs { a_nodes, b_nodes, control, nodes, pairs, front };
                written!(device, &p, n, kernel)
            }
            (Some(oriented), false) => written!(
                device,
                &p,
                n,
                PairWorkersOriented { a_nodes, b_nodes, oriented, control, nodes, pairs, front }
            ),
            (Some(oriented), true) => written!(
                device,
                &p,
                n,
                StealPairsOriented { a_nodes, b_nodes, oriented, control, nodes, pairs, front }
            ),
        }
    }

    /// All pairs of leaves that overlap.
    fn want(&self) -> Vec<Pair> {
        let [a, b] = self.both().map(|nodes| {
            let mut leaves: Vec<Node> = nodes.into_iter().filter(Node::is_leaf).collect();
            leaves.sort_by_key(|leaf| leaf.left);
            leaves.iter().map(Node::aabb).collect::<Vec<Aabb>>()
        });
        if self.trees.kind == 1 { brute::self_pairs(&a) } else { brute::pairs(&a, &b) }
    }

    fn below(&self, args: NodeDescent, tasks: Vec<NodePair>) -> u64 {
        let rule = if args.larger == 1 { Descent::Larger } else { Descent::Both };
        let ([a, b], mut stack) = (self.both(), tasks);
        let is_leaf = |[i, j]: NodePair| a[i as usize].is_leaf() && b[j as usize].is_leaf();
        let (mut n, mut is_task) = (0, stack.len());
        while let Some(pair) = stack.pop() {
            // Of leaves, those alone that are tasks.
            n += (!is_leaf(pair) || stack.len() < is_task) as u64;
            is_task = is_task.min(stack.len());
            let children = expand(rule, self.trees.kind == 1, &a, &b, pair).met;
            stack.extend(children.into_iter().filter(|&child| child != NO_PAIR));
        }
        n
    }

    /// Each pair of leaves, or, within a tree, a leaf with itself.
    fn check_covers(&self, front: &[NodePair]) {
        let [a, b] = self.both();
        fn leaves(nodes: &[Node], i: u32, out: &mut Vec<u32>) {
            let node = nodes[i as usize];
            if node.is_leaf() {
                return out.push(node.left);
            }
            leaves(nodes, node.left, out);
            leaves(nodes, node.right, out);
        }
        let kind = self.trees.kind;
        let [set_a, set_b] = sets(kind).map(|set| self.trees.twin.frame.count[set] as usize);
        let mut times = vec![0u32; set_a * set_b];
        for &[i, j] in front {
            let (mut of_a, mut of_b) = (Vec::new(), Vec::new());
            leaves(&a, i, &mut of_a);
            leaves(&b, j, &mut of_b);
            for &x in &of_a {
                for &y in &of_b {
                    let (x, y) = if kind == 1 { (x.min(y), x.max(y)) } else { (x, y) };
                    times[x as usize * set_b + y as usize] += 1;
                }
            }
        }
        for x in 0..set_a {
            for y in 0..set_b {
                let want = (kind == 0 || x < y) as u32;
                assert_eq!(times[x * set_b + y], want, "leaves {x} and {y}");
            }
        }
    }

    fn moved(&self, random: &mut Random, by: f32) -> Box<dyn Descends> {
        let [a, b] = self.both();
        let mut one = |mut nodes: Vec<Node>| {
            for leaf in nodes.iter_mut().filter(|node| node.is_leaf()) {
                let d = [(); 3].map(|()| (2.0 * random.unit() - 1.0) as f32 * by);
                for k in 0..3 {
                    (leaf.min[k], leaf.max[k]) = (leaf.min[k] + d[k], leaf.max[k] + d[k]);
                }
            }
            refit(&mut nodes, 0);
            bytes(&nodes)
        };
        let first = one(a);
        let second = if self.trees.kind == 1 { first.clone() } else { one(b) };
        let (trees, oriented) = (self.trees.clone(), self.oriented.clone());
        Box::new(Self { trees, nodes: [first, second], oriented })
    }
}

fn refit(nodes: &mut [Node], i: usize) -> Aabb {
    let Node { left, right, .. } = nodes[i];
    if !nodes[i].is_leaf() {
        let b = refit(nodes, left as usize).union(&refit(nodes, right as usize));
        (nodes[i].min, nodes[i].max) = (b.min, b.max);
    }
    nodes[i].aabb()
}
