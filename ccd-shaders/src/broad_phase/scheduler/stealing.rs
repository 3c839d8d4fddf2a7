//! Workers that descend pairs of nodes and steal them from each other; natively alone. As
//! `workers`, with levels 2 to 4 of `ccd_core::backend::scheduling::stealing`: the threads of a
//! workgroup are one worker, of which the first exchanges words of deques, all read and write the
//! pairs of a batch, and each has a hand.
//!
//! A turn: pairs come from the stack and from the tasks; if there is room for a batch beside them,
//! one comes from the worker's own deque; if there are none at all, from a range that it has
//! stolen, before or just now. What was found is put away as by any worker. Then, if the stack has
//! many pairs, a batch of its bottom goes to the deque: these are the oldest, with most below them;
//! what is at the top takes their place. Where the deque is full, they stay.
//!
//! Who ends has an empty stack, deque and hands, or leaves what there is to the next round.

use super::pair_tree::PairTree;
use super::shared::{
    EXPANDED, FROM_STACK, FROM_TASKS, NEXT, Round, SPILL_BASE, Shared, Stack, TOP, TURNS,
};
use super::stolen_batches::{
    Batch, FRUITLESS, FULL, HAND, N_TAKEN, NO_SLOT, POPPED, SEEKS, SOURCE, STOLEN, TO_PUSH,
    copy_batch, count_batches, found_work, give_back, look, look_at_hands, pop, reach_out,
    read_batch, reserve_slot, take_from_hand, words_of,
};
use super::worker::{
    ENDS, STOPS, WORKS, leave_rest, reserve_rest, reserve_results, spill, take, write_task,
};
use crate::workgroup::{add, barrier, barrier_of_buffers, get, get_uniform, set};
use ccd_core::backend::broad_phase::pair_workers::{counts, thieves, victim};
use ccd_core::backend::layout::Params;
use ccd_core::backend::scheduling::stealing::{HANDS, Workers};

/// What worker `me` does in a round.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "naga refuses structures that hold views")]
pub(super) fn steal<T: PairTree>(
    params: &Params<T::Args>,
    me: u32,
    lane: u32,
    state: &mut [u32; 1],
    shared: &mut Shared,
    batch: &mut Batch,
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
    let workers = thieves(args);
    let round = Round::new(args, &params.dispatch, me, control);
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
    for turn in 0..args.turns {
        if lane == 0 {
            let next = look::<T>(args, round, turn, shared, batch, control);
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
                let victim = victim(workers.n, me, turn, lane);
                reach_out(args, batch, victim, me, lane, control);
            }
            barrier();
            let takes = Workers::takes_task(lane, get(batch, HAND));
            if args.most == 0 && held == HANDS && takes {
                let victim = victim(workers.n, me, turn, lane);
                workers.steal_to_hand(&words_of(control, workers), me, lane, victim, 1);
            }
            barrier_of_buffers();
            if lane == 0 {
                take_from_hand(batch, workers, me, control);
                if get(batch, N_TAKEN) > 0 {
                    found_work(round, batch, control);
                }
            }
        }
        // What was taken is seen by all threads.
        barrier_of_buffers();
        let i = T::index(lane);
        let mut pair = take(i, round.input, shared, stack, nodes);
        let busy = get(shared, FROM_STACK) + get(shared, FROM_TASKS);
        let n_taken = get(batch, N_TAKEN);
        if i >= busy && i < busy + n_taken {
            pair = read_batch(batch, workers, i - busy, control);
        }
        let found = T::expand(params, lane, pair, a, b, more, shared);
        let to = T::claim(found, args.capacity_front, shared);
        // All have read the batch.
        barrier_of_buffers();
        if lane == 0 {
            reserve_results(args, round.number, shared, control, nodes, pairs);
            set(shared, EXPANDED, get(shared, EXPANDED) + n_taken);
            give_back(batch, workers, control);
            reserve_slot(args, me, shared, batch, control);
        }
        // Also for the slot, which others may just have read.
        barrier_of_buffers();
        T::put_away(args, round, found, to, a, b, shared, stack, nodes, pairs, front);
        barrier();
        let pushes = get(batch, TO_PUSH) != NO_SLOT;
        if pushes && lane < args.batch {
            copy_batch(args, me, lane, shared, batch, stack, control);
        }
        // The batch is there for whoever sees that it is published.
        barrier_of_buffers();
        if pushes && lane == 0 {
            let words = words_of(control, workers);
            workers.deque(me).publish(&words, get(batch, TO_PUSH), args.batch);
            set(shared, TOP, get(shared, TOP) - args.batch);
        }
    }
    // What the worker has in its deque and its hands goes to the next round: nothing, but after too
    // many turns. A pop that fails may have lost a batch to a thief.
    for _ in 0..workers.drain_turns(args.most) {
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
                set(shared, SPILL_BASE, spill(args, round.number, n_taken, control, nodes));
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
            write_task(args, round.output, nodes, get(shared, SPILL_BASE) + lane, pair);
        }
        barrier_of_buffers();
        if lane == 0 {
            give_back(batch, workers, control);
        }
    }
    if lane == 0 {
        reserve_rest(args, round, shared, control, nodes);
        add(control, counts(me), get(shared, TURNS));
        add(control, counts(me) + 1, get(shared, EXPANDED));
        count_batches(batch, workers, control);
    }
    barrier();
    leave_rest(args, round, lane, shared, stack, control, nodes);
}
