//! Workers that descend pairs of nodes, of binary trees or of blocks, and fronts at which they
//! begin; see `ccd_core::backend::broad_phase::pair_workers`.
//!
//! A turn of a worker: its first thread decides how many pairs come from the stack and how many
//! from the tasks; a thread, or a team of some, expands one; inner pairs go onto the stack or,
//! where that is full, to the tasks of the next round, pairs of leaves to `pairs`, and what ends to
//! the front, if one is kept.

use super::block_pair_tree::BlockTrees;
use super::places::Sums;
use super::shared::{Shared, Stack};
use super::stolen_batches::Batch;
use super::worker::{PairTree, WORKS, Worker};
use crate::broad_phase::volume::{BinaryTrees, Boxes, Oriented};
use crate::entry::kernel;
use crate::records::{BoxWords, ObbWords};
use crate::workgroup::{barrier, get_uniform, read_pair, set};
use ccd_core::backend::broad_phase::block_workers::packed;
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair};
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::Node;

impl<T: PairTree> Worker<'_, T> {
    /// What the worker does in its round.
    #[inline(always)]
    fn descend(mut self, state: &mut [u32; 1], sums: &mut Sums, stack: &mut Stack) {
        if self.lane == 0 {
            self.clear();
        }
        for turn in 0..self.args.turns {
            if self.lane == 0 {
                set(state, 0, self.plan(turn));
            }
            if get_uniform(state, 0) != WORKS {
                break;
            }
            let pair = self.take(T::index(self.lane), stack);
            let found = self.trees.expand(self.lane, pair, self.shared);
            let to = if self.args.scans == 1 {
                self.claim_by_scan(found, sums)
            } else {
                self.claim(found)
            };
            barrier();
            if self.lane == 0 {
                self.reserve_results();
            }
            barrier();
            T::put_away(&mut self, found, to, stack);
        }
        if self.lane == 0 {
            self.reserve_rest();
        }
        barrier();
        self.leave_rest(stack);
    }

    /// Pair `i` of the `dispatch.n` of the front of the search before.
    #[inline(always)]
    fn of_front(&self, i: u32) -> NodePair {
        let mut pair = NO_PAIR;
        if i < self.trees.dispatch().n {
            let place = 2 * ((1 - self.args.written) * self.args.capacity_front + i) as usize;
            pair = [at(self.front, place), at(self.front, place + 1)];
        }
        pair
    }
}

/// The kernels of a tree of pairs: its views, and the tree made of them.
macro_rules! kernels_of {
    (
        $workers:ident $resume:ident $steal:ident, $params:ident: $args:ident,
        [$($views:tt)*] $trees:expr
    ) => {
        kernel! {
            /// Workgroup `i` is worker `i` of round `dispatch.first`.
            $workers[128](t; $params: $args; state: [u32; 1], shared: Shared, sums: Sums,
                stack: Stack; $($views)*, mut control: [u32], mut nodes: [u32], mut pairs: [u32],
                mut front: [u32]) {
                let worker = Worker::new($trees, t, shared, control, nodes, pairs, front);
                worker.descend(state, sums, stack);
            }
        }

        kernel! {
            /// Thread `i` looks at pair `i` of the `dispatch.n` of the front of the search before.
            $resume[128](t; $params: $args; shared: Shared; $($views)*, mut control: [u32],
                mut nodes: [u32], mut pairs: [u32], mut front: [u32]) {
                let mut worker = Worker::new($trees, t, shared, control, nodes, pairs, front);
                worker.begin(worker.of_front(t.i));
            }
        }

        kernel! {
            /// Workgroup `i` is worker `i` of round `dispatch.first`, and steals.
            $steal[128](t; $params: $args; state: [u32; 1], shared: Shared, batch: Batch,
                stack: Stack; $($views)*, mut control: [u32], mut nodes: [u32], mut pairs: [u32],
                mut front: [u32]) {
                let worker = Worker::new($trees, t, shared, control, nodes, pairs, front);
                worker.steal(state, batch, stack);
            }
        }
    };
}

kernels_of!(
    pair_workers resume_front steal_pairs, params: NodeDescent, [a: [Node], b: [Node]]
    BinaryTrees { params, a, b, volume: Boxes }
);
kernels_of!(
    pair_workers_oriented resume_front_oriented steal_pairs_oriented, params: NodeDescent,
    [a: [Node], b: [Node], oriented: [ObbWords]]
    BinaryTrees { params, a, b, volume: Oriented(oriented) }
);
kernels_of!(
    block_workers resume_block_front steal_block_pairs, params: BlockDescent,
    [boxes: [BoxWords]] BlockTrees { params, boxes }
);

kernel! {
    /// Thread `i` looks at the pair `i` of the `dispatch.n` of level `dispatch.first`, where a
    /// search of pairs of blocks begins without a front.
    first_block_pairs[128](t; params: BlockDescent; shared: Shared; boxes: [BoxWords], first: [u32],
        mut control: [u32], mut nodes: [u32], mut pairs: [u32], mut front: [u32]) {
        let mut pair = NO_PAIR;
        if t.i < params.dispatch.n {
            let listed = read_pair(first, t.i);
            pair = packed(params.dispatch.first, listed.a, listed.b);
        }
        let trees = BlockTrees { params, boxes };
        Worker::new(trees, t, shared, control, nodes, pairs, front).begin(pair);
    }
}
