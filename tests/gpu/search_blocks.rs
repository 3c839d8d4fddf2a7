//! Workers over two block trees, or one with itself.

use crate::search::{Buffers, CAPACITY, Descends};
use crate::search_trees::written;
use crate::support::{bytes, capacity, list, run, zeros};
use crate::twin::Twin;
use ccd::gpu::Device;
use ccd::gpu::bind::{BlockWorkers, FirstBlockPairs, ResumeBlockFront, StealBlockPairs};
use ccd::{Aabb, Pair};
use ccd_core::backend::broad_phase::balanced::words_of;
use ccd_core::backend::broad_phase::block_bvh::{TEAMS, WIDTH, sets};
use ccd_core::backend::broad_phase::block_workers::unpacked;
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::broad_phase::pair_workers::THREADS;
use ccd_core::backend::layout::{BlockDescent, Dispatch, NodeDescent, Params};
use ccd_testkit::generate::Random;

/// Block trees, of which one kind of pairs is sought.
pub struct SearchBlocks {
    twin: Twin,
    kind: u32,
    /// The level where a search begins.
    top: u32,
}

impl SearchBlocks {
    pub fn new(kind: u32, sets: [&[Aabb]; 3], top: u32) -> Self {
        Self { twin: Twin::new(sets, |_, i| [i; 3]), kind, top }
    }

    fn params(&self, args: NodeDescent, dispatch: Dispatch) -> Params<BlockDescent> {
        let slots = self.twin.tree.slots.map(|slots| sets(self.kind).map(|set| slots[set]));
        let of_pairs = NodeDescent { kind: self.kind, ..args };
        Params { frame: self.twin.frame, dispatch, args: BlockDescent { of_pairs, slots } }
    }

    /// All pairs of nodes of a level, within one set each once and with itself.
    fn all(&self, level: u32) -> Vec<Pair> {
        let [n_a, n_b] = sets(self.kind).map(|set| self.twin.n_nodes(level, set));
        let from = |a| if self.kind == 1 { a } else { 0 };
        (0..n_a).flat_map(|a| (from(a)..n_b).map(move |b| Pair { a, b })).collect()
    }
}

impl Descends for SearchBlocks {
    fn width(&self) -> u32 {
        TEAMS
    }

    fn first(&self, device: &Device, args: NodeDescent) -> Buffers {
        let all = self.all(self.top);
        let kernel = FirstBlockPairs {
            boxes: bytes(&self.twin.nodes),
            first: list(&all),
            control: zeros::<u32>(words_of(&args)),
            nodes: capacity(2 * args.capacity_nodes),
            pairs: capacity(CAPACITY),
            front: vec![0xee; 16 * args.capacity_front.max(1) as usize],
        };
        let n = all.len() as u32;
        let dispatch =
            Dispatch { n, first: self.top, capacity_out: CAPACITY, ..Dispatch::default() };
        written!(device, &self.params(args, dispatch), n.div_ceil(THREADS), kernel)
    }

    fn resume(
        &self,
        device: &Device,
        args: NodeDescent,
        dispatch: Dispatch,
        front: Vec<u8>,
    ) -> Buffers {
        let control = zeros::<u32>(words_of(&args));
        let (boxes, nodes, pairs) =
            (bytes(&self.twin.nodes), capacity(2 * CAPACITY), capacity(CAPACITY));
        let kernel = ResumeBlockFront { boxes, control, nodes, pairs, front };
        written!(device, &self.params(args, dispatch), dispatch.n.div_ceil(THREADS), kernel)
    }

    fn round(
        &self,
        device: &Device,
        args: NodeDescent,
        dispatch: Dispatch,
        buffers: Buffers,
    ) -> Buffers {
        let Buffers { control, nodes, pairs, front } = buffers;
        let (p, boxes) = (self.params(args, dispatch), bytes(&self.twin.nodes));
        let n = 1 << args.workers;
        if args.batches > 0 {
            written!(device, &p, n, StealBlockPairs { boxes, control, nodes, pairs, front })
        } else {
            written!(device, &p, n, BlockWorkers { boxes, control, nodes, pairs, front })
        }
    }

    fn want(&self) -> Vec<Pair> {
        self.twin.node_pairs(1, self.kind)
    }

    /// All that overlap, down to the level above that of blocks of boxes.
    fn below(&self, _: NodeDescent, tasks: Vec<NodePair>) -> u64 {
        for &task in &tasks {
            assert_eq!(unpacked(task)[0], self.top);
        }
        (2..=self.top).map(|level| self.twin.node_pairs(level, self.kind).len() as u64).sum()
    }

    fn check_covers(&self, front: &[NodePair]) {
        let [n_a, n_b] = sets(self.kind).map(|set| self.twin.n_nodes(1, set));
        let mut times = vec![0u32; (n_a * n_b) as usize];
        for &pair in front {
            let [level, a, b] = unpacked(pair);
            let below = |i: u32, n: u32| {
                let width = WIDTH.pow(level - 1);
                (i * width).min(n)..((i + 1) * width).min(n)
            };
            let is_one = self.kind == 1 && a == b;
            for x in below(a, n_a) {
                for y in below(b, n_b).filter(|&y| !is_one || x <= y) {
                    times[(x * n_b + y) as usize] += 1;
                }
            }
        }
        for x in 0..n_a {
            for y in 0..n_b {
                let want = (self.kind == 0 || x <= y) as u32;
                assert_eq!(times[(x * n_b + y) as usize], want, "blocks {x} and {y}");
            }
        }
    }

    fn moved(&self, random: &mut Random, by: f32) -> Box<dyn Descends> {
        let twin = self.twin.moved(|b| {
            let d = [(); 3].map(|()| (2.0 * random.unit() - 1.0) as f32 * by);
            let add = |x: [f32; 3]| std::array::from_fn(|k| x[k] + d[k]);
            Aabb { min: add(b.min), max: add(b.max) }
        });
        Box::new(Self { twin, ..*self })
    }
}
