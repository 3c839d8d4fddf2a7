//! What the first thread of a worker that steals does with batches of pairs, and what all threads
//! do: see `stealing`.
//!
//! The threads say to each other which batch was taken by words of workgroup memory. Between what
//! two functions here do, in the order in which a turn calls them, stands a barrier of buffers.

use super::pair_tree::PairTree;
use super::shared::{FROM_STACK, FROM_TASKS, Round, Shared, Stack, TOP};
use super::worker::{ENDS, STOPS, WORKS, plan};
use crate::workgroup::{DeviceWords, add, get, load, lower_shared, set};
use ccd_core::backend::broad_phase::pair_descent::NodePair;
use ccd_core::backend::broad_phase::pair_workers::{deques, idle, stolen, thieves};
use ccd_core::backend::layout::NodeDescent;
use ccd_core::backend::scheduling::stealing::{HANDS, Workers};

/// Words that the threads of a worker share about batches: how many pairs of one were taken, from
/// where, whose deque, which slot; the first hand that holds something; where a batch is pushed to;
/// how often it has looked for work since it had some.
pub(super) const N_TAKEN: u32 = 0;
pub(super) const SOURCE: u32 = 1;
pub(super) const OWNER: u32 = 2;
pub(super) const SLOT: u32 = 3;
pub(super) const HAND: u32 = 4;
pub(super) const TO_PUSH: u32 = 5;
pub(super) const FRUITLESS: u32 = 6;
/// Three words that the worker counts, as [`stolen`] has them.
pub(super) const COUNTED: u32 = 8;
pub(super) const POPPED: u32 = COUNTED;
pub(super) const STOLEN: u32 = COUNTED + 1;
pub(super) const FULL: u32 = COUNTED + 2;
pub(super) type Batch = [u32; 11];

/// No slot.
pub(super) const NO_SLOT: u32 = u32::MAX;
/// A state of a worker, besides those of `workers`: it looks at other workers.
pub(super) const SEEKS: u32 = STOPS + 1;

/// The deques, behind all counters.
#[inline(always)]
pub(super) fn words_of<'a>(control: &'a mut [u32], workers: Workers) -> DeviceWords<'a> {
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
pub(super) fn pop(batch: &mut Batch, workers: Workers, me: u32, control: &mut [u32]) -> u32 {
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
pub(super) fn take_from_hand(batch: &mut Batch, workers: Workers, me: u32, control: &mut [u32]) {
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
pub(super) fn look<T: PairTree>(
    args: &NodeDescent,
    round: Round,
    turn: u32,
    shared: &mut Shared,
    batch: &mut Batch,
    control: &mut [u32],
) -> u32 {
    let workers = thieves(args);
    let mut next = plan::<T>(args, round, turn, shared, control);
    set(batch, N_TAKEN, 0);
    set(batch, SOURCE, 0);
    set(batch, HAND, HANDS);
    set(batch, TO_PUSH, NO_SLOT);
    let busy = get(shared, FROM_STACK) + get(shared, FROM_TASKS);
    if busy + args.batch <= T::WIDTH {
        if pop(batch, workers, round.me, control) != 0 {
            next = WORKS;
        }
    }
    if next == ENDS {
        let fruitless = get(batch, FRUITLESS);
        // A round without tasks has no work; if all are idle, nobody makes any.
        let patience = if round.tasks == 0 { 0 } else { args.patience };
        let n_idle = load(control, idle(round.number));
        let words = &words_of(control, workers);
        if !workers.retires(words, round.me, fruitless, patience, n_idle) {
            next = SEEKS;
            set(batch, FRUITLESS, fruitless + 1);
            if fruitless == 0 {
                add(control, idle(round.number), 1);
            }
        }
    } else {
        found_work(round, batch, control);
    }
    next
}

/// The first thread, when the worker has work: it is idle no more.
#[inline(always)]
pub(super) fn found_work(round: Round, batch: &mut Batch, control: &mut [u32]) {
    if get(batch, FRUITLESS) > 0 {
        set(batch, FRUITLESS, 0);
        add(control, idle(round.number), u32::MAX);
    }
}

/// Every thread says whether its hand holds something; a number of [`HAND`] is that of the first.
#[inline(always)]
pub(super) fn look_at_hands(
    batch: &mut Batch,
    workers: Workers,
    me: u32,
    lane: u32,
    control: &mut [u32],
) {
    if lane < HANDS {
        if workers.holds(&words_of(control, workers), me, lane) {
            lower_shared(batch, HAND, lane);
        }
    }
}

/// Where no hand holds anything: a thread steals a range of one other worker's deque; of tasks, it
/// only looks whether there are some.
#[inline(always)]
pub(super) fn reach_out(
    args: &NodeDescent,
    batch: &mut Batch,
    victim: u32,
    me: u32,
    lane: u32,
    control: &mut [u32],
) {
    let workers = thieves(args);
    if workers.reach_out(&words_of(control, workers), me, lane, victim, args.most) {
        lower_shared(batch, HAND, lane);
    }
}

/// The first thread, when the stack has many pairs: a slot for a batch of its bottom.
#[inline(always)]
pub(super) fn reserve_slot(
    args: &NodeDescent,
    me: u32,
    shared: &Shared,
    batch: &mut Batch,
    control: &mut [u32],
) {
    if get(shared, TOP) >= args.push {
        let workers = thieves(args);
        match workers.deque(me).reserve(&words_of(control, workers)) {
            Some(slot) => set(batch, TO_PUSH, slot),
            None => set(batch, FULL, get(batch, FULL) + 1),
        }
    }
}

/// Thread `lane` copies a pair of the stack's bottom to the slot and puts one of its top there.
#[inline(always)]
pub(super) fn copy_batch(
    args: &NodeDescent,
    me: u32,
    lane: u32,
    shared: &Shared,
    batch: &Batch,
    stack: &mut Stack,
    control: &mut [u32],
) {
    let (workers, slot) = (thieves(args), get(batch, TO_PUSH));
    let (to, from) = (2 * lane, 2 * (get(shared, TOP) - args.batch + lane));
    let pair = [get(stack, to), get(stack, to + 1)];
    workers.deque(me).write(&words_of(control, workers), slot, lane, pair);
    set(stack, to, get(stack, from));
    set(stack, to + 1, get(stack, from + 1));
}

/// The pair that a thread takes from the batch.
#[inline(always)]
pub(super) fn read_batch(batch: &Batch, workers: Workers, i: u32, control: &mut [u32]) -> NodePair {
    let words = &words_of(control, workers);
    workers.deque(get(batch, OWNER)).read(words, get(batch, SLOT), i)
}

/// The first thread says that all have read the batch.
#[inline(always)]
pub(super) fn give_back(batch: &Batch, workers: Workers, control: &mut [u32]) {
    if get(batch, SOURCE) == STOLEN {
        workers.deque(get(batch, OWNER)).give_back(&words_of(control, workers), 1);
    }
}

/// The first thread adds what its worker counted to what all did.
#[inline(always)]
pub(super) fn count_batches(batch: &Batch, workers: Workers, control: &mut [u32]) {
    for i in 0..3 {
        add(control, stolen(workers.n) + i as usize, get(batch, COUNTED + i));
    }
}
