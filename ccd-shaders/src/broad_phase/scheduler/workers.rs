//! Workers that descend pairs of nodes, of binary trees or of blocks, and fronts at which they
//! begin; see `ccd_core::backend::broad_phase::pair_workers`.
//!
//! A turn of a worker: its first thread says how many pairs come from the stack and how many from
//! the tasks; a thread, or a team of some, expands one; inner pairs go onto the stack or, where
//! that is full, to the tasks of the next round, pairs of leaves to `pairs`, and what ends to the
//! front, if one is kept.

use super::binary_pair_tree::BinaryTrees;
use super::block_pair_tree::BlockTrees;
use super::pair_tree::{INNER, PairTree};
use super::shared::{
    ENDED, ENDED_BASE, EXPANDED, LEAVES, LEAVES_BASE, NEXT, NODES, Round, SPILL_BASE, Shared,
    Stack, TOP, TURNS,
};
use super::stealing::steal;
use super::stolen_batches::Batch;
use super::worker::{
    Child, WORKS, claim, leave_rest, plan, put_ended, reserve_rest, reserve_results, take,
    write_task,
};
use crate::broad_phase::pair_descent::{count_front, reserve};
use crate::broad_phase::volume::{Boxes, Oriented};
use crate::entry::kernel;
use crate::records::{BoxWords, ObbWords};
use crate::workgroup::{add, barrier, count, get, get_uniform, read_pair, set};
use ccd_core::backend::broad_phase::block_workers::packed;
use ccd_core::backend::broad_phase::pair_descent::{NO_PAIR, NodePair};
use ccd_core::backend::broad_phase::pair_workers::{counts, listed};
use ccd_core::backend::broad_phase::stack_traversal::NONE;
use ccd_core::backend::kernel::memory::at;
use ccd_core::backend::layout::{Node, Params};

/// What worker `me` does in a round.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
fn descend<T: PairTree>(
    params: &Params<T::Args>,
    me: u32,
    lane: u32,
    state: &mut [u32; 1],
    shared: &mut Shared,
    stack: &mut Stack,
    a: &[T::Node],
    b: &[T::Node],
    more: &[T::More],
    control: &mut [u32],
    nodes: &mut [u32],
    pairs: &mut [u32],
    front: &mut [u32],
) {
    let args = &T::descent(&params.args);
    let round = Round::new(args, &params.dispatch, me, control);
    if lane == 0 {
        set(shared, TOP, 0);
        set(shared, NEXT, 0);
        set(shared, TURNS, 0);
        set(shared, EXPANDED, 0);
    }
    for turn in 0..args.turns {
        if lane == 0 {
            let next = plan::<T>(args, round, turn, shared, control);
            set(state, 0, next);
        }
        if get_uniform(state, 0) != WORKS {
            break;
        }
        let pair = take(T::index(lane), round.input, shared, stack, nodes);
        let found = T::expand(params, lane, pair, a, b, more, shared);
        let to = T::claim(found, args.capacity_front, shared);
        barrier();
        if lane == 0 {
            reserve_results(args, round.number, shared, control, nodes, pairs);
        }
        barrier();
        T::put_away(args, round, found, to, a, b, shared, stack, nodes, pairs, front);
    }
    if lane == 0 {
        reserve_rest(args, round, shared, control, nodes);
        add(control, counts(me), get(shared, TURNS));
        add(control, counts(me) + 1, get(shared, EXPANDED));
    }
    barrier();
    leave_rest(args, round, lane, shared, stack, control, nodes);
}

/// A thread looks at a pair at which a search may begin, if it has one: it is a task, or ends here.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "as above")]
fn begin<T: PairTree>(
    params: &Params<T::Args>,
    pair: NodePair,
    lane: u32,
    shared: &mut Shared,
    a: &[T::Node],
    b: &[T::Node],
    more: &[T::More],
    control: &mut [u32],
    nodes: &mut [u32],
    pairs: &mut [u32],
    front: &mut [u32],
) {
    let args = &T::descent(&params.args);
    if lane == 0 {
        set(shared, NODES, 0);
        set(shared, LEAVES, 0);
        set(shared, ENDED, 0);
    }
    barrier();
    let mut fate = 0;
    if pair[0] != NONE {
        fate = T::fate(params, pair, a, b, more);
    }
    let to = claim(fate, args.capacity_front, shared);
    barrier();
    if lane == 0 {
        let (n_nodes, n_leaves) = (get(shared, NODES), get(shared, LEAVES));
        if n_nodes > 0 {
            set(shared, SPILL_BASE, reserve(control, listed(0), nodes, n_nodes));
        }
        if n_leaves > 0 {
            set(shared, LEAVES_BASE, count(pairs, 0, n_leaves));
        }
        if get(shared, ENDED) > 0 {
            set(shared, ENDED_BASE, count_front(control, get(shared, ENDED)));
        }
    }
    barrier();
    if fate == INNER {
        write_task(args, 0, nodes, get(shared, SPILL_BASE) + to[0], pair);
    } else if fate != 0 {
        let (child, capacity) = (Child { pair, fate }, params.dispatch.capacity_out);
        put_ended::<T>(args, capacity, child, to, a, b, shared, pairs, front);
    }
}

/// Pair `i` of the `dispatch.n` of the front of the search before.
#[inline(always)]
fn of_front<T: PairTree>(params: &Params<T::Args>, i: u32, front: &[u32]) -> NodePair {
    let args = T::descent(&params.args);
    let mut pair = NO_PAIR;
    if i < params.dispatch.n {
        let place = 2 * ((1 - args.written) * args.capacity_front + i) as usize;
        pair = [at(front, place), at(front, place + 1)];
    }
    pair
}

/// The kernels of a tree of pairs: its nodes, and as what they are passed on.
macro_rules! kernels_of {
    (
        $workers:ident $resume:ident $steal:ident, $tree:ty, $args:ident,
        [$($views:tt)*] $a:ident $b:ident $more:ident
    ) => {
        kernel! {
            /// Workgroup `i` is worker `i` of round `dispatch.first`.
            $workers[128](t; params: $args; state: [u32; 1], shared: Shared, stack: Stack;
                $($views)*, mut control: [u32], mut nodes: [u32], mut pairs: [u32],
                mut front: [u32]) {
                descend::<$tree>(
                    params, t.group, t.lane, state, shared, stack, $a, $b, $more, control, nodes,
                    pairs, front,
                );
            }
        }

        kernel! {
            /// Thread `i` looks at pair `i` of the `dispatch.n` of the front of the search before.
            $resume[128](t; params: $args; shared: Shared; $($views)*, mut control: [u32],
                mut nodes: [u32], mut pairs: [u32], mut front: [u32]) {
                let pair = of_front::<$tree>(params, t.i, front);
                begin::<$tree>(
                    params, pair, t.lane, shared, $a, $b, $more, control, nodes, pairs, front,
                );
            }
        }

        kernel! {
            /// Workgroup `i` is worker `i` of round `dispatch.first`, and steals.
            $steal[128](t; params: $args; state: [u32; 1], shared: Shared, batch: Batch,
                stack: Stack; $($views)*, mut control: [u32], mut nodes: [u32], mut pairs: [u32],
                mut front: [u32]) {
                steal::<$tree>(
                    params, t.group, t.lane, state, shared, batch, stack, $a, $b, $more, control,
                    nodes, pairs, front,
                );
            }
        }
    };
}

kernels_of!(
    pair_workers resume_front steal_pairs, BinaryTrees<Boxes>, NodeDescent,
    [a_nodes: [Node], b_nodes: [Node]] a_nodes b_nodes a_nodes
);
kernels_of!(
    pair_workers_oriented resume_front_oriented steal_pairs_oriented, BinaryTrees<Oriented>,
    NodeDescent, [a_nodes: [Node], b_nodes: [Node], oriented: [ObbWords]] a_nodes b_nodes oriented
);
kernels_of!(
    block_workers resume_block_front steal_block_pairs, BlockTrees, BlockDescent,
    [boxes: [BoxWords]] boxes boxes boxes
);

kernel! {
    /// Thread `i` looks at pair `i` of the `dispatch.n` of level `dispatch.first`, where a search
    /// of pairs of blocks begins without a front.
    first_block_pairs[128](t; params: BlockDescent; shared: Shared; boxes: [BoxWords], first: [u32],
        mut control: [u32], mut nodes: [u32], mut pairs: [u32], mut front: [u32]) {
        let i = t.i;
        let mut pair = NO_PAIR;
        if i < params.dispatch.n {
            let of = read_pair(first, i);
            pair = packed(params.dispatch.first, of.a, of.b);
        }
        begin::<BlockTrees>(
            params, pair, t.lane, shared, boxes, boxes, boxes, control, nodes, pairs, front,
        );
    }
}
