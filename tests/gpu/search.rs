//! Searches by workers, dispatch after dispatch, of any tree of pairs: what stands in buffers
//! between dispatches, and in which ways pairs are shared out.

use crate::support::{read, run};
use ccd::Pair;
use ccd::gpu::Device;
use ccd::gpu::bind::{BalanceCounts, BalancePairs};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::broad_phase::pair_workers::{
    FRONT, LEFT, ROUNDS, STACK, THREADS, counts, listed, stolen,
};
use ccd_core::backend::layout::{Dispatch, Frame, NodeDescent, Params};
use ccd_testkit::generate::Random;
use std::mem::take;

/// Capacity of the lists of tasks and of results.
pub const CAPACITY: u32 = 12_000;
/// Log2 of the number of workers, if a test says no other.
const WORKERS: u32 = 3;

/// What kernels of workers write.
#[derive(Clone)]
pub struct Buffers {
    pub control: Vec<u8>,
    pub nodes: Vec<u8>,
    pub pairs: Vec<u8>,
    pub front: Vec<u8>,
}

/// A tree of pairs with its kernels.
pub trait Descends {
    /// Pairs that a worker expands in a turn.
    fn width(&self) -> u32;
    /// The first tasks, without a front, for lists of `args.capacity_nodes` and [`CAPACITY`]
    /// entries.
    fn first(&self, device: &Device, args: NodeDescent) -> Buffers;
    /// The tasks with which a search begins at the front that another has left.
    fn resume(
        &self,
        device: &Device,
        args: NodeDescent,
        dispatch: Dispatch,
        front: Vec<u8>,
    ) -> Buffers;
    /// A round of `2^args.workers` workers.
    fn round(
        &self,
        device: &Device,
        args: NodeDescent,
        dispatch: Dispatch,
        buffers: Buffers,
    ) -> Buffers;
    /// What must be found, by brute force.
    fn want(&self) -> Vec<Pair>;
    /// Pairs below these tasks, these included, that workers expand.
    fn below(&self, args: NodeDescent, tasks: Vec<NodePair>) -> u64;
    /// Each pair of leaves is below exactly one pair of a front.
    fn check_covers(&self, front: &[NodePair]);
    /// The same trees over boxes that are somewhere else, at most so far.
    fn moved(&self, random: &mut Random, by: f32) -> Box<dyn Descends>;
}

/// As schedulers tell workers: what there is, and ways of which there is little.
pub fn rules(device: &Device, width: u32) -> Vec<(&'static str, NodeDescent)> {
    let (dealt, counted) = (NodeDescent::TASKS_DEALT, NodeDescent::TASKS_COUNTED);
    let usual = NodeDescent {
        tasks: dealt,
        workers: WORKERS,
        piece: 1,
        stack: STACK,
        turns: 4096,
        capacity_nodes: CAPACITY,
        ..NodeDescent::default()
    };
    let balanced = NodeDescent { tasks: NodeDescent::TASKS_BALANCED, ..usual };
    let mut all = vec![
        ("static", usual),
        ("prefix sums", NodeDescent { scans: 1, ..usual }),
        ("prefix sums, no stack", NodeDescent { scans: 1, stack: 0, ..usual }),
        ("self-scheduling", NodeDescent { tasks: counted, ..usual }),
        ("frontier", NodeDescent { tasks: counted, piece: THREADS, stack: 0, ..usual }),
        ("balanced at 1 %", NodeDescent { idle: 1, ..balanced }),
        ("balanced at 100 %", NodeDescent { idle: 100, ..balanced }),
        ("balanced, a turn", NodeDescent { turns: 1, ..balanced }),
        ("balanced, some turns, a small stack", NodeDescent { turns: 9, stack: 9, ..balanced }),
        ("static, a turn", NodeDescent { turns: 1, ..usual }),
        ("self-scheduling, a few turns", NodeDescent { tasks: counted, turns: 9, ..usual }),
        ("self-scheduling, a small stack", NodeDescent { tasks: counted, stack: 9, ..usual }),
    ];
    if device.check_native().is_ok() {
        let steals = NodeDescent { tasks: counted, patience: 32, batches: 16, ..usual };
        let steals = NodeDescent { batch: width / 2, most: 0, push: width, ..steals };
        let little = NodeDescent { batches: 2, batch: width.min(4), push: 8, ..steals };
        all.extend([
            ("stealing", steals),
            ("lazy stealing", NodeDescent { most: 2, push: 2 * width, ..steals }),
            ("stealing, some turns", NodeDescent { turns: 9, ..little }),
            ("lazy stealing, some turns", NodeDescent { most: 1, turns: 9, ..little }),
            ("stealing, hardly a deque", little),
            ("lazy stealing, hardly a deque", NodeDescent { most: 2, ..little }),
            ("lazy stealing, a small stack", NodeDescent { most: 2, stack: 9, ..little }),
        ]);
    }
    all
}

/// Deals out again what workers have left after a round.
pub fn balance(device: &Device, p: &Params<NodeDescent>, buffers: &mut Buffers) {
    let (control, nodes) = (take(&mut buffers.control), take(&mut buffers.nodes));
    let BalanceCounts { control, nodes } = run(device, BalanceCounts { control, nodes }, p, 1);
    let kernel = BalancePairs { control, nodes };
    let done = run(device, kernel, p, 1 << p.args.workers);
    (buffers.control, buffers.nodes) = (done.control, done.nodes);
}

/// A search that has begun.
pub struct Search<'a> {
    device: &'a Device,
    trees: &'a dyn Descends,
    /// Log2 of the number of workers.
    workers: u32,
    pub buffers: Buffers,
}

impl<'a> Search<'a> {
    /// Without a front.
    pub fn new(device: &'a Device, trees: &'a dyn Descends, args: NodeDescent) -> Self {
        Self { device, trees, workers: args.workers, buffers: trees.first(device, args) }
    }

    /// The search after this one, of other trees: begins at the front that this one has written.
    pub fn resumed(&self, trees: &'a dyn Descends, args: NodeDescent) -> Self {
        let n = self.word(FRONT);
        assert!(n <= args.capacity_front, "{n} pairs of a front");
        let dispatch = Dispatch { n, capacity_out: CAPACITY, ..Dispatch::default() };
        let buffers = trees.resume(self.device, args, dispatch, self.buffers.front.clone());
        Self { device: self.device, trees, workers: args.workers, buffers }
    }

    pub fn word(&self, i: usize) -> u32 {
        read::<u32>(&self.buffers.control[4 * i..][..4])[0]
    }

    /// Round after round until nothing is left; how many there were.
    pub fn run(&mut self, args: NodeDescent) -> u32 {
        for round in 0..ROUNDS - 1 {
            if self.word(listed(round)) == 0 {
                assert_eq!(self.word(LEFT), 0);
                return round;
            }
            self.round(args, round);
        }
        panic!("pairs are left after {ROUNDS} rounds: {args:?}");
    }

    pub fn round(&mut self, args: NodeDescent, round: u32) {
        let dispatch = Dispatch { first: round, capacity_out: CAPACITY, ..Dispatch::default() };
        self.buffers = self.trees.round(self.device, args, dispatch, self.buffers.clone());
        if args.tasks == NodeDescent::TASKS_BALANCED {
            let p = Params { frame: Frame::default(), dispatch, args };
            balance(self.device, &p, &mut self.buffers);
        }
    }

    /// Pairs that workers expanded, all together.
    pub fn expanded(&self) -> u64 {
        (0..1 << self.workers).map(|me| self.word(counts(me) + 1) as u64).sum()
    }

    /// Batches that workers popped, and stole; pushes for which a deque had no room.
    pub fn batches(&self) -> [u32; 3] {
        std::array::from_fn(|i| self.word(stolen(1 << self.workers) + i))
    }

    /// The front that was written.
    pub fn written(&self, args: NodeDescent) -> Vec<NodePair> {
        let from = (args.written * args.capacity_front) as usize;
        let all: Vec<NodePair> = read(&self.buffers.front);
        all[from..from + self.word(FRONT) as usize].to_vec()
    }
}
