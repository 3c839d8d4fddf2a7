//! The kernels of workers and of fronts, each by itself: tasks shared out in every way, stacks,
//! lists and turns of which there are hardly any, fronts of boxes that move.

use crate::descent::Trees;
use crate::scenes::check_pairs;
use crate::support::{bytes, entries, read, room, run, zeros};
use ccd::gpu::bind::{
    PairWorkers, PairWorkersOriented, ResumeFront, ResumeFrontOriented, StealPairs,
    StealPairsOriented,
};
use ccd::gpu::{Device, Path};
use ccd::{Aabb, Pair};
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::broad_phase::oriented_nodes::WORDS;
use ccd_core::broad_phase::pair_descent::{NO_PAIR, NodePair, expand};
use ccd_core::broad_phase::pair_workers::{
    FRONT, LEFT, ROUNDS, STACK, THREADS, counts, listed, stolen, thieves, words_with_deques,
};
use ccd_core::layout::{Dispatch, LIST_HEADER, Node, NodeDescent};
use ccd_core::math::obb::Obb;
use ccd_core::model::method::Descent;
use ccd_testkit::brute;
use ccd_testkit::generate::{Random, uniform_boxes};

pub const TESTS: crate::Tests =
    &[("workers", check_workers), ("workers_without_room", check_room), ("fronts", check_fronts)];

const ROOM: u32 = 6000;
/// Of the number of workers, the power of two.
const WORKERS: u32 = 3;

/// As schedulers tell workers: what there is, and ways of which there is little.
fn rules(device: &Device) -> Vec<(&'static str, NodeDescent)> {
    let (dealt, counted) = (NodeDescent::TASKS_DEALT, NodeDescent::TASKS_COUNTED);
    let usual = NodeDescent {
        tasks: dealt,
        workers: WORKERS,
        piece: 1,
        stack: STACK,
        turns: 4096,
        room_nodes: ROOM,
        ..NodeDescent::default()
    };
    let mut all = vec![
        ("static", usual),
        ("self-scheduling", NodeDescent { tasks: counted, ..usual }),
        ("frontier", NodeDescent { tasks: counted, piece: THREADS, stack: 0, ..usual }),
        ("balanced at 1 %", NodeDescent { idle: 1, ..usual }),
        ("balanced at 100 %", NodeDescent { idle: 100, ..usual }),
        ("static, a turn", NodeDescent { turns: 1, ..usual }),
        ("self-scheduling, a few turns", NodeDescent { tasks: counted, turns: 9, ..usual }),
        ("self-scheduling, a small stack", NodeDescent { tasks: counted, stack: 9, ..usual }),
    ];
    if device.check_native().is_ok() {
        let steals = NodeDescent { tasks: counted, patience: 32, ..usual };
        let steals = NodeDescent { batches: 16, batch: 64, most: 0, push: 128, ..steals };
        let little = NodeDescent { batches: 2, batch: 4, push: 8, ..steals };
        all.extend([
            ("stealing", steals),
            ("lazy stealing", NodeDescent { most: 2, push: 256, ..steals }),
            ("stealing, a turn", NodeDescent { turns: 1, ..little }),
            ("lazy stealing, some turns", NodeDescent { most: 1, turns: 9, ..little }),
            ("stealing, hardly a deque", little),
            ("lazy stealing, hardly a deque", NodeDescent { most: 2, ..little }),
            ("lazy stealing, a small stack", NodeDescent { most: 2, stack: 9, ..little }),
        ]);
    }
    all
}

/// What stands in buffers between dispatches.
struct Search<'a> {
    device: &'a Device,
    trees: &'a Trees,
    /// Boxes of nodes, if trees have oriented ones.
    oriented: Option<Vec<u8>>,
    control: Vec<u8>,
    nodes: Vec<u8>,
    pairs: Vec<u8>,
    front: Vec<u8>,
}

impl<'a> Search<'a> {
    /// From the pairs of two cuts on.
    fn of_cuts(device: &'a Device, trees: &'a Trees, own: NodeDescent) -> Self {
        let front = vec![0xee; 16 * own.room_front.max(1) as usize];
        let done = trees.cut_pairs(device, own, front);
        let mut control = done.control;
        control.resize(4 * words_with_deques(thieves(&own)), 0);
        let (nodes, front) = (done.output, done.front);
        Self { device, trees, oriented: None, control, nodes, pairs: room(ROOM), front }
    }

    fn word(&self, i: usize) -> u32 {
        read::<u32>(&self.control)[i]
    }

    /// Round after round until nothing is left; how many there were.
    fn run(&mut self, own: NodeDescent) -> u32 {
        for round in 0..ROUNDS - 1 {
            if self.word(listed(round)) == 0 {
                assert_eq!(self.word(LEFT), 0);
                return round;
            }
            self.round(own, round);
        }
        panic!("pairs are left after {ROUNDS} rounds: {own:?}");
    }

    fn round(&mut self, own: NodeDescent, round: u32) {
        let dispatch = Dispatch { first: round, room_out: ROOM, ..Dispatch::default() };
        let p = self.trees.params(self.trees.kind, own, dispatch);
        let [a_nodes, b_nodes] = self.trees.nodes.clone();
        let Self { control, nodes, pairs, front, .. } = &*self;
        let (control, nodes) = (control.clone(), nodes.clone());
        let (pairs, front) = (pairs.clone(), front.clone());
        macro_rules! go {
            ($($kernel:tt)*) => {{
                let done = run(self.device, $($kernel)*, &p, 1 << WORKERS);
                (self.control, self.nodes) = (done.control, done.nodes);
                (self.pairs, self.front) = (done.pairs, done.front);
            }};
        }
        match (self.oriented.clone(), own.batches > 0) {
            (None, false) => go!(PairWorkers { a_nodes, b_nodes, control, nodes, pairs, front }),
            (None, true) => go!(StealPairs { a_nodes, b_nodes, control, nodes, pairs, front }),
            (Some(oriented), false) => {
                go!(PairWorkersOriented {
                    a_nodes,
                    b_nodes,
                    oriented,
                    control,
                    nodes,
                    pairs,
                    front
                })
            }
            (Some(oriented), true) => {
                go!(StealPairsOriented { a_nodes, b_nodes, oriented, control, nodes, pairs, front })
            }
        }
    }

    /// The search after this one, of other trees: begins at the front that this one has written.
    fn resumed(&self, trees: &'a Trees, own: NodeDescent) -> Self {
        let n = self.word(FRONT);
        assert!(n <= own.room_front, "{n} pairs of a front");
        let dispatch = Dispatch { n, room_out: ROOM, ..Dispatch::default() };
        let p = trees.params(trees.kind, own, dispatch);
        let [a_nodes, b_nodes] = trees.nodes.clone();
        let (device, control) = (self.device, zeros::<u32>(words_with_deques(thieves(&own))));
        let (nodes, pairs, front) = (room(2 * ROOM), room(ROOM), self.front.clone());
        let groups = n.div_ceil(THREADS);
        match self.oriented.clone() {
            None => {
                let kernel = ResumeFront { a_nodes, b_nodes, control, nodes, pairs, front };
                let done = run(device, kernel, &p, groups);
                let (control, nodes, pairs) = (done.control, done.nodes, done.pairs);
                Self { device, trees, oriented: None, control, nodes, pairs, front: done.front }
            }
            Some(boxes) => {
                let kernel = ResumeFrontOriented {
                    a_nodes,
                    b_nodes,
                    oriented: boxes.clone(),
                    control,
                    nodes,
                    pairs,
                    front,
                };
                let done = run(device, kernel, &p, groups);
                let (control, nodes, pairs) = (done.control, done.nodes, done.pairs);
                let oriented = Some(boxes);
                Self { device, trees, oriented, control, nodes, pairs, front: done.front }
            }
        }
    }

    /// Pairs that workers expanded, all together.
    fn expanded(&self) -> u64 {
        (0..1 << WORKERS).map(|me| self.word(counts(me) + 1) as u64).sum()
    }

    /// Batches that workers popped, and stole; pushes for which a deque had no room.
    fn batches(&self) -> [u32; 3] {
        std::array::from_fn(|i| self.word(stolen(1 << WORKERS) + i))
    }

    /// The front that was written.
    fn written(&self, own: NodeDescent) -> Vec<NodePair> {
        let from = (own.written * own.room_front) as usize;
        let all: Vec<NodePair> = read(&self.front);
        all[from..from + self.word(FRONT) as usize].to_vec()
    }
}

fn boxes(n: usize, by: f32) -> Vec<Aabb> {
    uniform_boxes(n).iter().map(|b| b.inflated(by)).collect()
}

/// Pairs below the tasks of the first round, these included: what workers expand.
fn below(trees: &Trees, rule: Descent, tasks: Vec<Pair>) -> u64 {
    let [a, b]: [Vec<Node>; 2] = trees.nodes.each_ref().map(|nodes| read(nodes));
    let mut stack: Vec<NodePair> = tasks.into_iter().map(|p| [p.a, p.b]).collect();
    let mut n = 0;
    let is_leaf = |[i, j]: NodePair| a[i as usize].is_leaf() && b[j as usize].is_leaf();
    let mut is_task = stack.len();
    while let Some(pair) = stack.pop() {
        // Of leaves, those alone that are tasks.
        n += (!is_leaf(pair) || stack.len() < is_task) as u64;
        is_task = is_task.min(stack.len());
        let children = expand(rule, trees.kind == 1, &a, &b, pair);
        stack.extend(children.into_iter().filter(|&child| child != NO_PAIR));
    }
    n
}

fn rule(larger: u32) -> Descent {
    if larger == 1 { Descent::Larger } else { Descent::Both }
}

/// Every way to share out tasks finds the pairs of brute force, and expands each pair of nodes
/// once.
fn check_workers(device: &Device) {
    let mut batches = [0; 3];
    let some = boxes(350, 0.04);
    let crowd = vec![Aabb { min: [0.0; 3], max: [1.0; 3] }; 40];
    for all in [&some[..], &some[..2], &some[..1], &crowd] {
        let (a, b) = (&some[..150], all);
        let want = [brute::pairs(a, b), brute::self_pairs(all)];
        for (kind, of) in [(0, [a, &[], b]), (1, [&[], all, &[]])] {
            let trees = Trees::new(device, kind, of);
            for (name, own) in rules(device) {
                let larger = (name.len() % 2) as u32;
                let own = NodeDescent { larger, nodes: 5, ..own };
                let mut search = Search::of_cuts(device, &trees, own);
                let mut tasks = search.nodes.clone();
                tasks[..4].copy_from_slice(&search.word(0).to_le_bytes());
                let n = below(&trees, rule(larger), entries(&tasks));
                let n_rounds = search.run(own);
                assert!(read::<u32>(&search.nodes)[0] <= ROOM, "{name}: more tasks than room");
                check_pairs(name, want[kind as usize].clone(), entries(&search.pairs));
                assert_eq!(search.expanded(), n, "{name}: pairs expanded");
                if own.batches > 0 {
                    batches = std::array::from_fn(|i| batches[i] + search.batches()[i]);
                }
                let several = n > 2 * THREADS as u64 && (own.turns == 1 || own.stack < 10);
                assert!(!several || n_rounds > 2, "{name}: {n_rounds} rounds");
                if own.idle == 0 && own.stack == STACK && own.turns > 9 {
                    assert!(n_rounds <= 1, "{name}: {n_rounds} rounds, and all have room");
                }
            }
        }
    }
    let native = device.check_native().is_ok();
    assert!(batches.iter().all(|&n| (n > 0) == native), "popped, stolen, no room: {batches:?}");
}

/// Lists that are too short count what they lack, and nothing is written beyond their ends; what is
/// left after the last round is said.
fn check_room(device: &Device) {
    let all = boxes(500, 0.05);
    let trees = Trees::new(device, 1, [&[], &all, &[]]);
    for (name, own) in rules(device) {
        let short = NodeDescent { nodes: 20, room_nodes: 30, stack: own.stack.min(40), ..own };
        let mut search = Search::of_cuts(device, &trees, short);
        // Words behind both halves of the list.
        let n_words = LIST_HEADER + 4 * 30;
        search.nodes.truncate(4 * n_words);
        search.nodes.extend([0xab; 64]);
        let wanted = search.word(0);
        assert!(wanted > 30, "{name}: {wanted} tasks");
        assert_eq!(read::<u32>(&search.nodes)[0], wanted);
        for round in 0..3 {
            search.round(short, round);
        }
        assert_eq!(search.nodes[4 * n_words..], [0xab; 64], "{name}: written beyond the room");
        assert!(read::<u32>(&search.nodes)[0] >= wanted);
        // One round, which is the last.
        let last = NodeDescent { nodes: 20, turns: 1, last: 1, ..own };
        let mut search = Search::of_cuts(device, &trees, last);
        search.round(last, 0);
        assert!(search.word(listed(1)) > 0, "{name}: nothing is left after a turn");
        assert_eq!(search.word(LEFT), u32::MAX, "{name}");
    }
}

/// Trees of the same shape over boxes that are somewhere else.
fn moved(trees: &Trees, boxes: [&[Aabb]; 2]) -> [Vec<u8>; 2] {
    let one = |side: usize| {
        let mut nodes: Vec<Node> = read(&trees.nodes[side]);
        refit(&mut nodes, boxes[side], 0);
        bytes(&nodes)
    };
    [one(0), one(1)]
}

fn refit(nodes: &mut [Node], boxes: &[Aabb], i: usize) -> Aabb {
    let Node { left, right, .. } = nodes[i];
    let b = if nodes[i].is_leaf() {
        boxes[left as usize]
    } else {
        refit(nodes, boxes, left as usize).union(&refit(nodes, boxes, right as usize))
    };
    (nodes[i].min, nodes[i].max) = (b.min, b.max);
    b
}

/// Each pair of leaves is below exactly one pair of the front, or, within a tree, is a leaf with
/// itself.
fn check_covers(trees: &Trees, front: &[NodePair]) {
    let [a, b]: [Vec<Node>; 2] = trees.nodes.each_ref().map(|nodes| read(nodes));
    fn leaves(nodes: &[Node], i: u32, out: &mut Vec<u32>) {
        let node = nodes[i as usize];
        if node.is_leaf() {
            return out.push(node.left);
        }
        leaves(nodes, node.left, out);
        leaves(nodes, node.right, out);
    }
    let [set_a, set_b] = sets(trees.kind).map(|set| trees.twin.frame.count[set] as usize);
    let mut times = vec![0u32; set_a * set_b];
    for &[i, j] in front {
        let (mut of_a, mut of_b) = (Vec::new(), Vec::new());
        leaves(&a, i, &mut of_a);
        leaves(&b, j, &mut of_b);
        for &x in &of_a {
            for &y in &of_b {
                let (x, y) = if trees.kind == 1 { (x.min(y), x.max(y)) } else { (x, y) };
                times[x as usize * set_b + y as usize] += 1;
            }
        }
    }
    for x in 0..set_a {
        for y in 0..set_b {
            let want = (trees.kind == 0 || x < y) as u32;
            assert_eq!(times[x * set_b + y], want, "leaves {x} and {y}");
        }
    }
}

/// Boxes that move further every frame, and back: on each the pairs are those of brute force, and
/// the front has every pair of leaves below it once.
fn check_fronts(device: &Device) {
    let (first, second) = (boxes(260, 0.03), boxes(200, 0.06));
    let native = device.info().path == Path::Passthrough;
    for (k, (name, own)) in rules(device).into_iter().enumerate() {
        let (kind, larger) = ((k / 2 % 2) as u32, (k % 2) as u32);
        let own = NodeDescent { nodes: 9, larger, room_front: 60_000, ..own };
        let of = |a: &[Aabb], b: &[Aabb]| match kind {
            0 => Trees::new(device, 0, [a, &[], b]),
            _ => Trees::new(device, 1, [&[], a, &[]]),
        };
        for oriented in [false, true] {
            if oriented && (!native || k % 3 != 0) {
                continue;
            }
            let mut trees = vec![of(&first, &second)];
            let mut random = Random::new(k as u32);
            let mut want = vec![0];
            for frame in 0..3 {
                let by = [0.02, 0.3, 0.05][frame];
                let mut shift = |b: &Aabb| {
                    let d = [(); 3].map(|()| (2.0 * random.unit() - 1.0) as f32 * by);
                    let add = |x: [f32; 3]| std::array::from_fn(|k| x[k] + d[k]);
                    Aabb { min: add(b.min), max: add(b.max) }
                };
                let a: Vec<Aabb> = first.iter().map(&mut shift).collect();
                let b: Vec<Aabb> = second.iter().map(&mut shift).collect();
                let sides = if kind == 1 { [&a[..]; 2] } else { [&a[..], &b[..]] };
                let nodes = moved(&trees[0], sides);
                let mut next = of(&first, &second);
                next.nodes = nodes;
                trees.push(next);
            }
            want.clear();
            let mut search = Search::of_cuts(device, &trees[0], own);
            if oriented {
                // Boxes that tell nothing apart: they hold whatever moves.
                let n = trees[0].twin.boxes.len();
                search.oriented = Some(bytes(&everything().repeat(n)));
            }
            search.run(own);
            let mut n_begun = 0;
            for (i, of) in trees.iter().enumerate() {
                let own = NodeDescent { written: i as u32 % 2, ..own };
                if i > 0 {
                    n_begun += search.word(FRONT);
                    search = search.resumed(of, own);
                    search.run(own);
                }
                let found = entries(&search.pairs);
                check_pairs(name, leaf_pairs(of), found.clone());
                check_covers(of, &search.written(own));
                want.push(found.len());
            }
            // The control: frames have other pairs, so that a front that stayed as it was is seen.
            want.dedup();
            assert!(want.len() > 2 && n_begun > 500, "{name}: {want:?}, {n_begun}");
        }
    }
}

fn everything() -> Vec<f32> {
    let b = Obb::everything();
    let [p, q, r] = b.axes;
    let words = [b.centre, p, q, r, b.half].concat();
    [words, vec![0.0; WORDS - 15]].concat()
}

/// All pairs of leaves that overlap, by brute force.
fn leaf_pairs(trees: &Trees) -> Vec<Pair> {
    let [a, b] = trees.nodes.each_ref().map(|nodes| {
        let leaves = read::<Node>(nodes).into_iter().filter(Node::is_leaf);
        let mut leaves: Vec<Node> = leaves.collect();
        leaves.sort_by_key(|leaf| leaf.left);
        leaves.iter().map(Node::aabb).collect::<Vec<Aabb>>()
    });
    if trees.kind == 1 { brute::self_pairs(&a) } else { brute::pairs(&a, &b) }
}
