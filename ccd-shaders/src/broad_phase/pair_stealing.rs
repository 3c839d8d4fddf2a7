//! Workers that descend pairs of nodes of binary trees and steal them from each other; natively
//! alone. As `pair_workers`, with levels 2 to 4 of `ccd_core::scheduling::stealing`: the threads of
//! a workgroup are one worker, of which the first exchanges words of deques, all read and write the
//! pairs of a batch, and each has a hand.
//!
//! A turn: pairs come from the stack and from the tasks; if there is room for a batch beside them,
//! one comes from the worker's own deque; if there are none at all, from a range that it has stolen,
//! before or just now. What was found is put away as by any worker. Then, if the stack has many
//! pairs, a batch of its bottom goes to the deque: these are the oldest, with most below them; what
//! is at the top takes their place. Where the deque is full, they stay.
//!
//! Who ends has an empty stack, deque and hands, or leaves what there is to the next round.

use super::pair_descent::fate;
use super::pair_workers::{
    Child, ENDS, EXPANDED, FROM_STACK, FROM_TASKS, LEAF, NEXT, Round, SPILL_BASE, STOPS, TOP,
    TURNS, WORKS, claim, leave_rest, make_room, make_room_for_rest, plan, put_away, spill, take,
    write_task,
};
use crate::records::ObbWords;
use crate::workgroup::{
    DeviceWords, add, barrier, barrier_of_buffers, get, get_uniform, group, load, lower_shared, set,
};
use ccd_core::broad_phase::block_bvh::sets;
use ccd_core::broad_phase::oriented_nodes::only_reaching;
use ccd_core::broad_phase::pair_descent::{NodePair, children, expand};
use ccd_core::broad_phase::pair_workers::{STACK, THREADS, counts, deques, idle, stolen, thieves};
use ccd_core::broad_phase::stack_traversal::NONE;
use ccd_core::layout::{Node, NodeDescent, Params};
use ccd_core::model::method::Descent;
use ccd_core::scheduling::stealing::{HANDS, Workers};
use spirv_std::glam::UVec3;
use spirv_std::spirv;

/// Words that the threads of a worker share about batches: how many pairs of one were taken, from
/// where, whose deque, which slot; the first hand that holds something; where a batch is pushed to;
/// how often it has looked for work since it had some.
const N_TAKEN: u32 = 0;
const SOURCE: u32 = 1;
const OWNER: u32 = 2;
const SLOT: u32 = 3;
const HAND: u32 = 4;
const TO_PUSH: u32 = 5;
const FRUITLESS: u32 = 6;
/// Three words that the worker counts, as [`stolen`] has them.
const COUNTED: u32 = 8;
const POPPED: u32 = COUNTED;
const STOLEN: u32 = COUNTED + 1;
const FULL: u32 = COUNTED + 2;
type Batch = [u32; 11];

/// No slot.
const NO_SLOT: u32 = u32::MAX;
/// A state of a worker, besides those of `pair_workers`: it looks at other workers.
const SEEKS: u32 = STOPS + 1;

/// The deques, behind all counters.
#[inline(always)]
fn words_of<'a>(control: &'a mut [u32], workers: Workers) -> DeviceWords<'a> {
    DeviceWords::behind(control, deques(workers.n))
}

/// The first thread says which batch was taken; `source`: [`POPPED`] or [`STOLEN`].
#[inline(always)]
fn say(
    batch: &mut Batch,
    workers: Workers,
    words: &DeviceWords,
    source: u32,
    owner: u32,
    slot: u32,
) {
    set(batch, SOURCE, source);
    set(batch, OWNER, owner);
    set(batch, SLOT, slot);
    set(batch, N_TAKEN, workers.deque(owner).items(words, slot));
    set(batch, source, get(batch, source) + 1);
}

/// The first thread takes a batch from the worker's own deque; whether it could.
#[inline(always)]
fn pop(batch: &mut Batch, workers: Workers, me: u32, control: &mut [u32]) -> u32 {
    let words = &words_of(control, workers);
    let mut any = 0;
    if let Some(slot) = workers.deque(me).try_pop(words) {
        say(batch, workers, words, POPPED, me, slot);
        any = 1;
    }
    any
}

/// The first thread takes the next batch of a hand that holds one.
#[inline(always)]
fn take_from_hand(batch: &mut Batch, workers: Workers, me: u32, control: &mut [u32]) {
    let words = &words_of(control, workers);
    let hand = get(batch, HAND);
    if hand < HANDS {
        if workers.holds(words, me, hand) {
            let owner = workers.victim(words, me, hand);
            let slot = workers.next_slot(words, me, hand);
            say(batch, workers, words, STOLEN, owner, slot);
        }
    }
}

/// The first thread says what its worker does in this turn.
#[inline(always)]
fn look(
    own: &NodeDescent,
    round: Round,
    turn: u32,
    shared: &mut [u32; 17],
    batch: &mut Batch,
    control: &mut [u32],
) -> u32 {
    let workers = thieves(own);
    let mut next = plan(own, round, turn, shared, control);
    set(batch, N_TAKEN, 0);
    set(batch, SOURCE, 0);
    set(batch, HAND, HANDS);
    set(batch, TO_PUSH, NO_SLOT);
    let busy = get(shared, FROM_STACK) + get(shared, FROM_TASKS);
    if busy + own.batch <= THREADS {
        if pop(batch, workers, round.me, control) != 0 {
            next = WORKS;
        }
    }
    if next == ENDS {
        let fruitless = get(batch, FRUITLESS);
        // A round without tasks has no work; if all are idle, nobody makes any.
        let patience = if round.tasks == 0 { 0 } else { own.patience };
        let over = fruitless >= patience || load(control, idle(round.number)) == workers.n;
        // A pop fails also if a thief was there, so that the deque is looked at once more.
        if !(over && workers.deque(round.me).is_empty(&words_of(control, workers))) {
            next = SEEKS;
            set(batch, FRUITLESS, fruitless + 1);
            if fruitless == 0 {
                add(control, idle(round.number), 1);
            }
        }
    } else {
        found(round, batch, control);
    }
    next
}

/// The first thread, when the worker has work: it is idle no more.
#[inline(always)]
fn found(round: Round, batch: &mut Batch, control: &mut [u32]) {
    if get(batch, FRUITLESS) > 0 {
        set(batch, FRUITLESS, 0);
        add(control, idle(round.number), u32::MAX);
    }
}

/// Every thread says whether its hand holds something; a number of [`HAND`] is that of the first.
#[inline(always)]
fn look_at_hands(batch: &mut Batch, workers: Workers, me: u32, lane: u32, control: &mut [u32]) {
    if lane < HANDS {
        if workers.holds(&words_of(control, workers), me, lane) {
            lower_shared(batch, HAND, lane);
        }
    }
}

/// Where no hand holds anything: a thread steals a range of one other worker's deque; of tasks, it
/// only looks whether there are some.
#[inline(always)]
fn reach_out(
    own: &NodeDescent,
    batch: &mut Batch,
    victim: u32,
    me: u32,
    lane: u32,
    control: &mut [u32],
) {
    let workers = thieves(own);
    let words = &words_of(control, workers);
    let mut any = 0;
    if victim != me {
        if own.most == 0 {
            any = workers.deque(victim).len(words);
        } else if workers.steal_to_hand(words, me, lane, victim, own.most) {
            any = 1;
        }
    }
    if any > 0 {
        lower_shared(batch, HAND, lane);
    }
}

/// The first thread, when the stack has many pairs: a slot for a batch of its bottom.
#[inline(always)]
fn reserve_slot(
    own: &NodeDescent,
    me: u32,
    shared: &[u32; 17],
    batch: &mut Batch,
    control: &mut [u32],
) {
    if get(shared, TOP) >= own.push {
        let workers = thieves(own);
        match workers.deque(me).reserve(&words_of(control, workers)) {
            Some(slot) => set(batch, TO_PUSH, slot),
            None => set(batch, FULL, get(batch, FULL) + 1),
        }
    }
}

/// Thread `lane` copies a pair of the stack's bottom to the slot and puts one of its top there.
#[inline(always)]
fn copy_batch(
    own: &NodeDescent,
    me: u32,
    lane: u32,
    shared: &[u32; 17],
    batch: &Batch,
    stack: &mut [u32; 2 * STACK as usize],
    control: &mut [u32],
) {
    let (workers, slot) = (thieves(own), get(batch, TO_PUSH));
    let (to, from) = (2 * lane, 2 * (get(shared, TOP) - own.batch + lane));
    let pair = [get(stack, to), get(stack, to + 1)];
    workers.deque(me).write(&words_of(control, workers), slot, lane, pair);
    set(stack, to, get(stack, from));
    set(stack, to + 1, get(stack, from + 1));
}

/// The pair that a thread takes from the batch.
#[inline(always)]
fn read_batch(batch: &Batch, workers: Workers, i: u32, control: &mut [u32]) -> NodePair {
    let words = &words_of(control, workers);
    workers.deque(get(batch, OWNER)).read(words, get(batch, SLOT), i)
}

/// The first thread says that all have read the batch.
#[inline(always)]
fn give_back(batch: &Batch, workers: Workers, control: &mut [u32]) {
    if get(batch, SOURCE) == STOLEN {
        workers.deque(get(batch, OWNER)).give_back(&words_of(control, workers), 1);
    }
}

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
            #[spirv(workgroup)] shared: &mut [u32; 17],
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
                    if own.most == 0 && held == HANDS && lane == get(batch, HAND) {
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
                    let meeting = expand(rule, within, a_nodes, b_nodes, pair);
                    let met = meeting!(within, meeting, internal, first, a_nodes, b_nodes $(, $obb)?);
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
                for i in 0..3 {
                    add(control, stolen(workers.n) + i as usize, get(batch, COUNTED + i));
                }
            }
            barrier();
            leave_rest(&own, round, lane, shared, stack, control, nodes);
        }
    };
}

kernel!(steal_pairs, 3 4 5 6);
kernel!(steal_pairs_oriented, 4 5 6 7, oriented 3);
