//! Workers that descend pairs of nodes, of binary trees or of blocks, and fronts at which they
//! begin; see `ccd_core::broad_phase::pair_workers`.
//!
//! A turn of a worker: its first thread says how many pairs come from the stack and how many from
//! the tasks; a thread, or a team of some, expands one; inner pairs go onto the stack or, where
//! that is full, to the tasks of the next round, pairs of leaves to `pairs`, and what ends to the
//! front, if one is kept.

use super::binary_pair_tree::{BinaryTrees, Boxes, Oriented};
use super::block_pair_tree::BlockTrees;
use super::pair_descent::{count_front, reserve};
use super::pair_tree::{INNER, PairTree};
use super::worker::{
    Child, ENDED, ENDED_BASE, EXPANDED, LEAVES, LEAVES_BASE, NEXT, NODES, Round, SPILL_BASE,
    Shared, Stack, TOP, TURNS, WORKS, claim, leave_rest, make_room, make_room_for_rest, plan,
    put_ended, take, write_task,
};
use crate::records::{BoxWords, ObbWords};
use crate::workgroup::{add, barrier, count, get, get_uniform, group, read_pair, set};
use ccd_core::broad_phase::block_workers::packed;
use ccd_core::broad_phase::pair_descent::{NO_PAIR, NodePair};
use ccd_core::broad_phase::pair_workers::{THREADS, counts, listed};
use ccd_core::broad_phase::stack_traversal::NONE;
use ccd_core::kernel::memory::at;
use ccd_core::layout::{BlockDescent, Node, NodeDescent, Params};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

/// What worker `me` does in a round.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
fn descend<T: PairTree>(
    params: &Params<T::Own>,
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
    let own = &T::descent(&params.own);
    let round = Round::new(own, &params.dispatch, me, control);
    if lane == 0 {
        set(shared, TOP, 0);
        set(shared, NEXT, 0);
        set(shared, TURNS, 0);
        set(shared, EXPANDED, 0);
    }
    for turn in 0..own.turns {
        if lane == 0 {
            let next = plan::<T>(own, round, turn, shared, control);
            set(state, 0, next);
        }
        if get_uniform(state, 0) != WORKS {
            break;
        }
        let pair = take(T::index(lane), round.input, shared, stack, nodes);
        let found = T::expand(params, lane, pair, a, b, more, shared);
        let to = T::claim(found, own.room_front, shared);
        barrier();
        if lane == 0 {
            make_room(own, round.number, shared, control, nodes, pairs);
        }
        barrier();
        T::put_away(own, round, found, to, a, b, shared, stack, nodes, pairs, front);
    }
    if lane == 0 {
        make_room_for_rest(own, round, shared, control, nodes);
        add(control, counts(me), get(shared, TURNS));
        add(control, counts(me) + 1, get(shared, EXPANDED));
    }
    barrier();
    leave_rest(own, round, lane, shared, stack, control, nodes);
}

/// A thread looks at a pair at which a search may begin, if it has one: it is a task, or ends here.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "as above")]
fn begin<T: PairTree>(
    params: &Params<T::Own>,
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
    let own = &T::descent(&params.own);
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
    let to = claim(fate, own.room_front, shared);
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
        write_task(own, 0, nodes, get(shared, SPILL_BASE) + to[0], pair);
    } else if fate != 0 {
        let (child, room) = (Child { pair, fate }, params.dispatch.room_out);
        put_ended::<T>(own, room, child, to, a, b, shared, pairs, front);
    }
}

/// Pair `i` of the `dispatch.n` of the front of the search before.
#[inline(always)]
fn of_front<T: PairTree>(params: &Params<T::Own>, i: u32, front: &[u32]) -> NodePair {
    let own = T::descent(&params.own);
    let mut pair = NO_PAIR;
    if i < params.dispatch.n {
        let place = 2 * ((1 - own.written) * own.room_front + i) as usize;
        pair = [at(front, place), at(front, place + 1)];
    }
    pair
}

/// The kernels of a tree of pairs: its nodes, and as what they are passed on. The numbers are
/// bindings.
macro_rules! kernels {
    ($workers:ident, $resume:ident, $tree:ty, $own:ident, ($a:ident $b:ident $more:ident),
        $($view:ident: $record:ty = $binding:tt),*;
        $control:tt $nodes:tt $pairs:tt $front:tt) => {
        /// Workgroup `i` is worker `i` of round `dispatch.first`.
        #[spirv(compute(threads(128)))]
        pub fn $workers(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] state: &mut [u32; 1],
            #[spirv(workgroup)] shared: &mut Shared,
            #[spirv(workgroup)] stack: &mut Stack,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<$own>,
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $binding)] $view: &[$record],)*
            #[spirv(storage_buffer, descriptor_set = 0, binding = $control)] control: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $nodes)] nodes: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $pairs)] pairs: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $front)] front: &mut [u32],
        ) {
            descend::<$tree>(
                params,
                group(id, n),
                lane,
                state,
                shared,
                stack,
                $a,
                $b,
                $more,
                control,
                nodes,
                pairs,
                front,
            );
        }

        /// Thread `i` looks at pair `i` of the `dispatch.n` of the front of the search before.
        #[spirv(compute(threads(128)))]
        pub fn $resume(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] shared: &mut Shared,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<$own>,
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $binding)] $view: &[$record],)*
            #[spirv(storage_buffer, descriptor_set = 0, binding = $control)] control: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $nodes)] nodes: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $pairs)] pairs: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $front)] front: &mut [u32],
        ) {
            let pair = of_front::<$tree>(params, group(id, n) * THREADS + lane, front);
            begin::<$tree>(
                params, pair, lane, shared, $a, $b, $more, control, nodes, pairs, front,
            );
        }
    };
}

kernels!(
    pair_workers, resume_front, BinaryTrees<Boxes>, NodeDescent, (a_nodes b_nodes a_nodes),
    a_nodes: Node = 1, b_nodes: Node = 2;
    3 4 5 6
);
kernels!(
    pair_workers_oriented, resume_front_oriented, BinaryTrees<Oriented>, NodeDescent,
    (a_nodes b_nodes oriented),
    a_nodes: Node = 1, b_nodes: Node = 2, oriented: ObbWords = 3;
    4 5 6 7
);
kernels!(
    block_workers, resume_block_front, BlockTrees, BlockDescent, (boxes boxes boxes),
    boxes: BoxWords = 1;
    2 3 4 5
);

/// Thread `i` looks at pair `i` of the `dispatch.n` of level `dispatch.first`, where a search of
/// pairs of blocks begins without a front.
#[spirv(compute(threads(128)))]
pub fn first_block_pairs(
    #[spirv(workgroup_id)] id: UVec3,
    #[spirv(num_workgroups)] n: UVec3,
    #[spirv(local_invocation_index)] lane: u32,
    #[spirv(workgroup)] shared: &mut Shared,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<BlockDescent>,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] boxes: &[BoxWords],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] first: &[u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] control: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] nodes: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] pairs: &mut [u32],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 6)] front: &mut [u32],
) {
    let i = group(id, n) * THREADS + lane;
    let mut pair = NO_PAIR;
    if i < params.dispatch.n {
        let of = read_pair(first, i);
        pair = packed(params.dispatch.first, of.a, of.b);
    }
    begin::<BlockTrees>(
        params, pair, lane, shared, boxes, boxes, boxes, control, nodes, pairs, front,
    );
}
