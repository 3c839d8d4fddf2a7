//! Workers that descend pairs of nodes of binary trees and steal them from each other; natively
//! alone. As `pair_workers`, with levels 2 to 4 of `ccd_core::scheduling::stealing`: the threads of
//! a workgroup are one worker, of which the first exchanges words of deques, all read and write the
//! pairs of a batch, and each has a hand.
//!
//! A turn: pairs come from the stack and from the tasks; if there is room for a batch beside them,
//! one comes from the worker's own deque; if there are none at all, from a range that it has
//! stolen, before or just now. What was found is put away as by any worker. Then, if the stack has
//! many pairs, a batch of its bottom goes to the deque: these are the oldest, with most below them;
//! what is at the top takes their place. Where the deque is full, they stay.
//!
//! Who ends has an empty stack, deque and hands, or leaves what there is to the next round.

use super::pair_descent::fate;
use super::stolen_batches::{
    FRUITLESS, FULL, HAND, N_TAKEN, NO_SLOT, POPPED, SEEKS, SOURCE, STOLEN, TO_PUSH, copy_batch,
    count_batches, found, give_back, look, look_at_hands, pop, reach_out, read_batch, reserve_slot,
    take_from_hand, words_of,
};
use super::worker::{
    Child, ENDS, EXPANDED, FROM_STACK, FROM_TASKS, LEAF, NEXT, Round, SPILL_BASE, STOPS, TOP,
    TURNS, WORKS, claim, leave_rest, make_room, make_room_for_rest, put_away, spill, take,
    write_task,
};
use crate::records::ObbWords;
use crate::workgroup::{add, barrier, barrier_of_buffers, get, get_uniform, group, set};
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::broad_phase::oriented_nodes::only_reaching;
use ccd_core::broad_phase::pair_descent::{children, expand};
use ccd_core::broad_phase::pair_workers::{counts, thieves};
use ccd_core::broad_phase::stack_traversal::NONE;
use ccd_core::layout::{Node, NodeDescent, Params};
use ccd_core::model::method::Descent;
use ccd_core::scheduling::stealing::HANDS;
use spirv_std::glam::UVec3;
use spirv_std::spirv;

/// Of the children of a pair, those that meet.
macro_rules! meeting {
    ($within:ident, $all:expr, $internal:ident, $first:ident, $a:ident, $b:ident) => {
        $all
    };
    ($within:ident, $all:expr, $internal:ident, $first:ident, $a:ident, $b:ident, $obb:ident) => {
        only_reaching($within, $all, $internal, $first, $a, $b, $obb, $obb)
    };
}

/// The kernel of one volume: `$obb` is there for oriented boxes. The numbers are bindings.
macro_rules! kernel {
    ($steal:ident, $control:tt $nodes:tt $pairs:tt $front:tt $(, $obb:ident $binding:tt)?) => {
        /// Workgroup `i` is worker `i` of round `dispatch.first`.
        #[spirv(compute(threads(128)))]
        pub fn $steal(
            #[spirv(workgroup_id)] id: UVec3,
            #[spirv(num_workgroups)] n: UVec3,
            #[spirv(local_invocation_index)] lane: u32,
            #[spirv(workgroup)] state: &mut [u32; 1],
            #[spirv(workgroup)] shared: &mut [u32; 18],
            #[spirv(workgroup)] batch: &mut [u32; 11],
            #[spirv(workgroup)] stack: &mut [u32; 2048],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 0)] params: &Params<NodeDescent>,
            #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] a_nodes: &[Node],
            #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] b_nodes: &[Node],
            $(#[spirv(storage_buffer, descriptor_set = 0, binding = $binding)] $obb: &[ObbWords],)?
            #[spirv(storage_buffer, descriptor_set = 0, binding = $control)] control: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $nodes)] nodes: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $pairs)] pairs: &mut [u32],
            #[spirv(storage_buffer, descriptor_set = 0, binding = $front)] front: &mut [u32],
        ) {
            let own = params.own;
            let workers = thieves(&own);
            let round = Round::new(params, group(id, n), control);
            let me = round.me;
            let within = own.kind == 1;
            let [set_a, set_b] = sets(own.kind);
            let internal = [params.frame.count[set_a] - 1, params.frame.count[set_b] - 1];
            $(let _ = $obb;
            let first = [params.frame.start[set_a], params.frame.start[set_b]];)?
            let rule = if own.larger != 0 { Descent::Larger } else { Descent::Both };
            if lane == 0 {
                set(shared, TOP, 0);
                set(shared, NEXT, 0);
                set(shared, TURNS, 0);
                set(shared, EXPANDED, 0);
                set(batch, FRUITLESS, 0);
                set(batch, POPPED, 0);
                set(batch, STOLEN, 0);
                set(batch, FULL, 0);
            }
            for turn in 0..own.turns {
                if lane == 0 {
                    let next = look(&own, round, turn, shared, batch, control);
                    set(state, 0, next);
                }
                let next = get_uniform(state, 0);
                if next == ENDS || next == STOPS {
                    break;
                }
                if next == SEEKS {
                    look_at_hands(batch, workers, me, lane, control);
                    barrier();
                    let held = get(batch, HAND);
                    barrier();
                    if held == HANDS && lane < HANDS {
                        let at_random = (me + turn).wrapping_mul(0x9e37_79b9) >> 8;
                        let victim = (me + 1 + at_random + lane) & (workers.n - 1);
                        reach_out(&own, batch, victim, me, lane, control);
                    }
                    barrier();
                    // Where nobody has anything, that is a hand that there is not.
                    let reaches = lane < HANDS && lane == get(batch, HAND);
                    if own.most == 0 && held == HANDS && reaches {
                        let at_random = (me + turn).wrapping_mul(0x9e37_79b9) >> 8;
                        let victim = (me + 1 + at_random + lane) & (workers.n - 1);
                        workers.steal_to_hand(&words_of(control, workers), me, lane, victim, 1);
                    }
                    barrier_of_buffers();
                    if lane == 0 {
                        take_from_hand(batch, workers, me, control);
                        if get(batch, N_TAKEN) > 0 {
                            found(round, batch, control);
                        }
                    }
                }
                // What was taken is seen by all threads.
                barrier_of_buffers();
                let mut pair = take(lane, round.input, shared, stack, nodes);
                let busy = get(shared, FROM_STACK) + get(shared, FROM_TASKS);
                let n_taken = get(batch, N_TAKEN);
                if lane >= busy && lane < busy + n_taken {
                    pair = read_batch(batch, workers, lane - busy, control);
                }
                let (mut p, mut q) = (Child::NONE, Child::NONE);
                let (mut r, mut s) = (Child::NONE, Child::NONE);
                if pair[0] != NONE {
                    let near = expand(rule, within, a_nodes, b_nodes, pair);
                    let (x, y) = (a_nodes, b_nodes);
                    let met = meeting!(within, near, internal, first, x, y $(, $obb)?);
                    let mut all = met;
                    if own.room_front > 0 {
                        all = children(rule, within, a_nodes, b_nodes, pair);
                    }
                    p = Child::new(met[0], all[0], internal);
                    q = Child::new(met[1], all[1], internal);
                    r = Child::new(met[2], all[2], internal);
                    s = Child::new(met[3], all[3], internal);
                    // A pair of the cut may be one of leaves already.
                    if fate(pair, internal) == LEAF {
                        p = Child { pair, fate: LEAF };
                    }
                }
                let room = own.room_front;
                let (to_p, to_q) = (claim(p.fate, room, shared), claim(q.fate, room, shared));
                let (to_r, to_s) = (claim(r.fate, room, shared), claim(s.fate, room, shared));
                // All have read the batch.
                barrier_of_buffers();
                if lane == 0 {
                    make_room(&own, round.number, shared, control, nodes, pairs);
                    set(shared, EXPANDED, get(shared, EXPANDED) + n_taken);
                    give_back(batch, workers, control);
                    reserve_slot(&own, me, shared, batch, control);
                }
                // Also for the slot, which others may just have read.
                barrier_of_buffers();
                let (to, x, y) = (round.output, a_nodes, b_nodes);
                put_away(params, to, p, to_p, shared, stack, x, y, nodes, pairs, front);
                put_away(params, to, q, to_q, shared, stack, x, y, nodes, pairs, front);
                put_away(params, to, r, to_r, shared, stack, x, y, nodes, pairs, front);
                put_away(params, to, s, to_s, shared, stack, x, y, nodes, pairs, front);
                barrier();
                let pushes = get(batch, TO_PUSH) != NO_SLOT;
                if pushes && lane < own.batch {
                    copy_batch(&own, me, lane, shared, batch, stack, control);
                }
                // The batch is there for whoever sees that it is published.
                barrier_of_buffers();
                if pushes && lane == 0 {
                    let words = words_of(control, workers);
                    workers.deque(me).publish(&words, get(batch, TO_PUSH), own.batch);
                    set(shared, TOP, get(shared, TOP) - own.batch);
                }
            }
            // What the worker has in its deque and its hands goes to the next round: nothing, but
            // after too many turns. A pop that fails has lost a batch to a thief.
            for _ in 0..own.batches + HANDS * own.most.max(1) + 1 {
                if lane == 0 {
                    set(batch, N_TAKEN, 0);
                    set(batch, SOURCE, 0);
                    set(batch, HAND, HANDS);
                    pop(batch, workers, me, control);
                }
                barrier();
                look_at_hands(batch, workers, me, lane, control);
                barrier_of_buffers();
                if lane == 0 {
                    if get(batch, N_TAKEN) == 0 {
                        take_from_hand(batch, workers, me, control);
                    }
                    let n_taken = get(batch, N_TAKEN);
                    let mut next = WORKS;
                    if n_taken > 0 {
                        set(shared, SPILL_BASE, spill(&own, round.number, n_taken, control, nodes));
                    } else if workers.deque(me).is_empty(&words_of(control, workers)) {
                        next = ENDS;
                    }
                    set(state, 0, next);
                }
                if get_uniform(state, 0) == ENDS {
                    break;
                }
                barrier_of_buffers();
                if lane < get(batch, N_TAKEN) {
                    let pair = read_batch(batch, workers, lane, control);
                    write_task(&own, round.output, nodes, get(shared, SPILL_BASE) + lane, pair);
                }
                barrier_of_buffers();
                if lane == 0 {
                    give_back(batch, workers, control);
                }
            }
            if lane == 0 {
                make_room_for_rest(&own, round, shared, control, nodes);
                add(control, counts(me), get(shared, TURNS));
                add(control, counts(me) + 1, get(shared, EXPANDED));
                count_batches(batch, workers, control);
            }
            barrier();
            leave_rest(&own, round, lane, shared, stack, control, nodes);
        }
    };
}

kernel!(steal_pairs, 3 4 5 6);
kernel!(steal_pairs_oriented, 4 5 6 7, oriented 3);
